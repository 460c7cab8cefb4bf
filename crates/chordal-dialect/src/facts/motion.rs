//! What is known of moves.

use chordal_diagnostics::Code;
use chordal_kernel::{SplineForm, TurnPass};

use super::{CodeFacts, PLAIN, WordMeanings};
use crate::action::MotionCode;
use crate::parameters::Parameters;
use crate::settings::SettingField;

/// Problems of a cut that is synchronized with the spindle.
const THREAD: &[Code] = &[Code::CycleWithoutLead, Code::MissingFeed, Code::CycleSpindle];

pub(super) fn facts(code: MotionCode, parameters: &Parameters) -> CodeFacts {
    match code {
        MotionCode::Rapid => PLAIN
            .problems(&[Code::NoSuchAxis])
            .settings(&[SettingField::RAPID])
            .example("{} X10. Y10."),
        MotionCode::Linear => PLAIN
            .problems(&[
                Code::NoSuchAxis,
                Code::MissingFeed,
                Code::FeedOverLimit,
                Code::CornerNext,
                Code::CornerNextMotion,
                Code::CornerTooLarge,
            ])
            .rows(if parameters.corner_words_in_g1 {
                &[
                    ("IK", "chamfer between this cut and the next, from the corner"),
                    ("R", "radius of a rounding between this cut and the next"),
                ]
            } else {
                &[]
            })
            .example("{} X10. Y10. F200."),
        MotionCode::ArcCw => arc().example("{} X10. Y10. I10. J0 F200."),
        MotionCode::ArcCcw => arc().example("{} X10. Y10. I0 J10. F200."),
        MotionCode::SpiralCw | MotionCode::SpiralCcw => PLAIN
            .problems(&[
                Code::CenterOutsidePlane,
                Code::NoCenter,
                Code::MissingFeed,
                Code::SpiralTurns,
                Code::NoSpirals,
                Code::ZeroRadius,
                Code::UnequalScaleArc,
            ])
            .settings(&[SettingField::SPIRAL, SettingField::SPIRAL_END_TOLERANCE])
            .words(WordMeanings::Spiral),
        MotionCode::Thread if parameters.thread_lead == b'F' => PLAIN
            .problems(THREAD)
            .rows(&[
                ("K", "change of the lead in each revolution"),
                ("Q", "angle at which the thread starts"),
            ])
            .example("{} Z-12. K1."),
        MotionCode::Thread | MotionCode::RigidTap => PLAIN
            .problems(THREAD)
            .rows(&[
                ("K", "advance along the path per revolution of the spindle"),
                ("I", "how many times as fast the tool comes back; 1 without it"),
            ])
            .example("{} Z-12. K1."),
        MotionCode::Spline(form) => spline().rows(match form {
            SplineForm::Cubic => &[
                ("I", "X from the start to the first control point"),
                ("J", "Y from the start to the first control point"),
                ("P", "X from the end to the second control point"),
                ("Q", "Y from the end to the second control point"),
            ],
            SplineForm::Quadratic => &[
                ("I", "X from the start to the control point"),
                ("J", "Y from the start to the control point"),
            ],
            SplineForm::Points => &[
                ("P", "weight of the control point, above zero"),
                ("L", "order of the curve (degree + 1); 3 without it"),
            ],
        }),
        MotionCode::SplineEnd => spline(),
        MotionCode::Turn(pass) => turn_pass(pass).problems(THREAD),
    }
}

fn arc() -> CodeFacts {
    PLAIN
        .problems(&[
            Code::RadiusMismatch,
            Code::RadiusTooShort,
            Code::FullCircleByRadius,
            Code::CenterOutsidePlane,
            Code::NoCenter,
            Code::MissingFeed,
            Code::RadiusOverLimit,
            Code::CenterAndRadius,
            Code::SpiralTurns,
            Code::NoSpirals,
            Code::ZeroRadius,
            Code::UnequalScaleArc,
            Code::CompensationOnArc,
        ])
        .settings(&[
            SettingField::ARC_CENTER,
            SettingField::RADIUS_ERROR_TOLERANCE,
            SettingField::ARC_MISMATCH,
            SettingField::SEMICIRCLE_TOLERANCE,
            SettingField::CENTER_AND_RADIUS,
            SettingField::FULL_CIRCLE_BY_RADIUS,
            SettingField::HELIX_FEED,
            SettingField::MAX_RADIUS,
            SettingField::SPIRAL,
        ])
        .words(WordMeanings::Arc)
}

fn spline() -> CodeFacts {
    PLAIN.problems(&[
        Code::SplineWords,
        Code::SplinePoint,
        Code::SplineWeight,
        Code::SplineOpen,
        Code::SplineTooFew,
        Code::SplinePlane,
        Code::SplineInCompensation,
        Code::SplineOrder,
        Code::MissingFeed,
    ])
}

fn turn_pass(pass: TurnPass) -> CodeFacts {
    match pass {
        TurnPass::Turning => PLAIN
            .rows(&[("RI", "taper on the radius: start minus end")])
            .example("{} X50. Z-30. F0.25"),
        TurnPass::Facing => PLAIN
            .rows(&[
                ("RK", "taper: Z of the start minus Z of the end"),
                ("I", "taper on the radius: start minus end"),
            ])
            .example("{} X20. Z-2. F0.2"),
        TurnPass::Thread => PLAIN
            .rows(&[
                ("RI", "taper on the radius: start minus end"),
                ("Q", "angle at which the thread starts"),
            ])
            .settings(&[SettingField::TURNING_THREAD_EXIT])
            .example("{} X23.2 Z-25. F3."),
    }
}
