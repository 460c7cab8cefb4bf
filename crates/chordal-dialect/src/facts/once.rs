//! What is known of codes that take the axis words of their block for themselves.

use chordal_diagnostics::Code;
use chordal_kernel::rules::HolePattern;

use super::{BlockSort, CodeFacts, PLAIN, WordMeanings, turn_facts};
use crate::action::{OnceCode, SurfaceCode, TiltedPlaneCode};
use crate::parameters::Parameters;

/// The words of a corner arc, in a block of its own or with a move.
pub(super) const CORNER_ARC_WORDS: &[(&str, &str)] =
    &[("IJK", "direction at which the corner arc ends")];

/// Problems of a rotation, a scaling or a mirror image.
const FRAMES: &[Code] = &[
    Code::FrameValue,
    Code::UnequalScaleArc,
    Code::FramePlane,
    Code::FrameWithReference,
    Code::FrameInCompensation,
    Code::ScalingOption,
    Code::RotationOption,
    Code::SpatialRotation,
    Code::OneAxisAfterFrame,
    Code::ScaledOverflow,
    Code::FrameInCycle,
];

/// Problems of a move to or from a reference point.
const REFERENCES: &[Code] = &[Code::ReferenceInCompensation, Code::FrameWithReference];

/// Problems of a shift of the coordinates.
const SHIFTS: &[Code] = &[Code::ShiftInCompensation];

pub(super) fn facts(code: OnceCode, parameters: &Parameters) -> CodeFacts {
    match code {
        OnceCode::Dwell => PLAIN.words(WordMeanings::Dwell).block(BlockSort::Dwell),
        OnceCode::SetData => {
            PLAIN.problems(SHIFTS).words(WordMeanings::Data).block(BlockSort::Data)
        }
        OnceCode::ReturnToReference { second: false } => {
            PLAIN.problems(REFERENCES).example("{} Z30.")
        }
        OnceCode::ReturnToReference { second: true } => PLAIN
            .problems(REFERENCES)
            .rows(&[("P", "number of the reference point: 2, 3 or 4; without P the second")]),
        OnceCode::ReturnFromReference => PLAIN.problems(REFERENCES),
        OnceCode::Home => PLAIN
            .problems(REFERENCES)
            .rows(&[
                ("XYZ", "axis that goes to its switch; a number with it does nothing"),
                ("O", "only axes that are not homed yet"),
                ("R", "how far Z is raised before"),
            ])
            .example("{} X Y"),
        OnceCode::MachineCoordinates => {
            PLAIN.problems(&[Code::NoMotionInForce]).example("{} Z0").block(BlockSort::Machine)
        }
        OnceCode::LocalShift => {
            PLAIN.problems(SHIFTS).example("{} X10. Y10.").block(BlockSort::Local)
        }
        OnceCode::PresetPosition => {
            PLAIN.problems(SHIFTS).example("{} X0").rows(if parameters.preset_limits_speed {
                &[("S", "limit of the spindle speed, rev/min")]
            } else {
                &[]
            })
        }
        OnceCode::ClearPreset { .. } | OnceCode::RestorePreset => PLAIN.problems(SHIFTS),
        OnceCode::Rotation => rotation(parameters).problems(FRAMES),
        OnceCode::Scaling => {
            PLAIN.problems(FRAMES).rows(if parameters.rules.frames.factors_by_axes {
                &[("XYZ", "factor of the words of this axis")]
            } else {
                &[
                    ("P", "scale factor of all axes"),
                    ("I", "scale factor of X"),
                    ("J", "scale factor of Y"),
                    ("K", "scale factor of Z"),
                    ("XYZ", "centre of the scaling"),
                ]
            })
        }
        OnceCode::Mirror { .. } => PLAIN.problems(FRAMES).example("{} X0"),
        OnceCode::MirrorOff => {
            PLAIN.problems(&[Code::FrameInCompensation, Code::OneAxisAfterFrame])
        }
        OnceCode::CircularPocketCw | OnceCode::CircularPocketCcw => {
            pocket(circular_pocket(parameters))
        }
        OnceCode::GeneralPocket => pocket(PLAIN.rows(&[
            ("P", "number of the subprogram that holds the outline"),
            ("R", "R level: where feeding begins"),
            ("Q", "depth of one level"),
            ("I", "step between rows along X"),
            ("J", "step between rows along Y"),
            ("K", "finish allowance that the last pass cuts"),
            ("D", "number of the radius offset"),
            ("S", "spindle speed"),
        ])),
        OnceCode::Engraving => PLAIN.rows(&[
            ("P", "0: the text in the comment; 1: a serial number; 32 to 126: one character"),
            ("R", "level to which the tool returns"),
            ("I", "angle of the text, degrees"),
            ("J", "height of the letters"),
            ("E", "feed of the plunges"),
        ]),
        OnceCode::Pattern(pattern) => PLAIN
            .problems(&[Code::PatternWords, Code::NoCycle])
            .rows(holes(pattern))
            .block(BlockSort::Pattern),
        OnceCode::Probe { .. } => {
            PLAIN.problems(&[Code::MissingFeed, Code::ProbeWithoutHit, Code::BadProbeMove])
        }
        OnceCode::CornerArcBlock => PLAIN.problems(&[Code::CornerBlock]).rows(CORNER_ARC_WORDS),
        OnceCode::Turning(cycle) => {
            let turning = turn_facts(cycle);
            PLAIN
                .problems(&[
                    Code::MissingLabel,
                    Code::MissingSubprogram,
                    Code::CycleWithoutLead,
                    Code::CycleInCompensation,
                    Code::CycleSpindle,
                ])
                .settings(turning.settings)
                .words(WordMeanings::Turning(cycle))
                .example(turning.example)
        }
        OnceCode::Surface(code) => PLAIN
            .problems(&[Code::SurfaceCode, Code::SurfaceMode, Code::RotarySpeed])
            .rows(surface(code)),
        OnceCode::TiltedPlane(code) => {
            PLAIN.problems(&[Code::TiltedPlane, Code::KinematicsNotKnown]).rows(tilted_plane(code))
        }
    }
}

fn rotation(parameters: &Parameters) -> CodeFacts {
    match parameters.rules.frames.rotation_center_by_ab {
        true => PLAIN
            .rows(&[
                ("A", "centre of the rotation, in X"),
                ("B", "centre of the rotation, in Y"),
                ("R", "angle of the rotation in degrees, counter-clockwise"),
                ("I", "the angle is added to the one in force; Chordal does not follow it"),
            ])
            .example("{} A0 B0 R30."),
        false => PLAIN
            .rows(&[
                ("R", "angle of the rotation in degrees, counter-clockwise"),
                ("IJK", "axis of the rotation in space; Chordal does not follow it"),
                ("XYZ", "centre of the rotation"),
            ])
            .example("{} X0 Y0 R30."),
    }
}

fn pocket(facts: CodeFacts) -> CodeFacts {
    facts.block(BlockSort::Pocket).problems(&[
        Code::ImproperFixedRoutine,
        Code::PocketTooSmall,
        Code::PocketWithoutDiameter,
        Code::PocketWithoutGeometry,
        Code::PocketGeometry,
        Code::PocketRefused,
        Code::PocketUnreached,
    ])
}

fn circular_pocket(parameters: &Parameters) -> CodeFacts {
    match parameters.rules.pocket_is_one_circle {
        true => PLAIN
            .rows(&[("I", "radius of the circle of the tool's centre")])
            .example("{} I12. F200."),
        false => PLAIN
            .rows(&[
                ("I", "radius of the first circle; of the finished circle where K is not given"),
                ("K", "radius of the finished circle"),
                ("Q", "step from one circle to the next, with K"),
                ("L", "how often the pocket is cut; in G91 each pass goes down by Z"),
                ("D", "number of the radius offset"),
            ])
            .example("{} I12. D1 F200."),
    }
}

fn holes(pattern: HolePattern) -> &'static [(&'static str, &'static str)] {
    match pattern {
        // A circle has no K.
        HolePattern::Circle | HolePattern::Arc => &[
            ("I", "radius of the circle"),
            ("J", "angle of the first hole, from X+ counter-clockwise"),
            ("K", "angle from one hole to the next"),
            ("L", "number of holes"),
        ],
        HolePattern::Line => &[
            ("I", "distance from one hole to the next"),
            ("J", "angle of the line, from X+ counter-clockwise"),
            ("L", "number of holes"),
        ],
    }
}

fn tilted_plane(code: TiltedPlaneCode) -> &'static [(&'static str, &'static str)] {
    match code {
        TiltedPlaneCode::Define { .. } => &[
            ("X, Y, Z", "origin of the plane, or a point of it"),
            (
                "I, J, K",
                "angles, degrees: about Z, the new X, and the new Z; with P1 about X, Y and Z; with P3 a vector",
            ),
            (
                "P",
                "0 or none: Euler angles; 1: roll, pitch and yaw; 2: three points; 3: two vectors; 4: angles of two projections",
            ),
            (
                "Q",
                "with P1 the order of the axes: 123, 321, …; with P2 and P3 which point or vector",
            ),
            ("R", "with P2 Q0 the angle about the normal, degrees"),
        ],
        TiltedPlaneCode::DefineByTool => &[
            ("X, Y, Z", "origin of the plane; without them the tip of the tool"),
            ("R", "angle about the tool, degrees"),
        ],
        TiltedPlaneCode::DefineByAxes => &[
            ("X, Y, Z", "origin of the plane in the work coordinate system"),
            ("I, J, K", "angles about X, Y and Z, degrees"),
            ("Q", "the order of the axes: 123, 321, …"),
        ],
        TiltedPlaneCode::Turn { .. } => &[(
            "P",
            "sign of the axis nearer to the tool: 1 positive, 2 negative; 0 or none: the nearest",
        )],
        TiltedPlaneCode::Off | TiltedPlaneCode::OriginOnTable { .. } => &[],
    }
}

fn surface(code: SurfaceCode) -> &'static [(&'static str, &'static str)] {
    match code {
        SurfaceCode::Cylinder => &[
            ("R", "radius of the cylinder"),
            ("Q", "diameter of the cylinder"),
            ("ABC", "rotary axis that becomes a length on the cylinder"),
            ("XYZ", "linear axis that the rotary one takes the place of"),
        ],
        SurfaceCode::Face | SurfaceCode::FaceOff => &[],
    }
}
