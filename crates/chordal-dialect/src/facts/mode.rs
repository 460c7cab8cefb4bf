//! What is known of modes.

use chordal_diagnostics::Code;

use super::{BlockSort, CodeFacts, PLAIN, WordMeanings};
use crate::action::{ModeCode, PathCode};
use crate::settings::SettingField;

/// Problems of the start of cutter compensation and of the contour after it.
const COMPENSATION: &[Code] = &[
    Code::CompensationOnArc,
    Code::CompensationWithoutOffset,
    Code::PlaneChangeInCompensation,
    Code::InsideArcTooSmall,
    Code::CompensationInterference,
    Code::NoOffsetIntersection,
    Code::LeadInTooShort,
    Code::SideChangeRefused,
    Code::CompensationPlane,
    Code::CompensationTwice,
    Code::NewOffsetRefused,
    Code::LookAheadLost,
    Code::SpiralInCompensation,
    Code::ShiftInCompensation,
    Code::TooManyIdleBlocks,
    Code::ReferenceInCompensation,
    Code::ToolChangeInCompensation,
    // In the outline of a pocket.
    Code::PocketGeometry,
];

pub(super) fn facts(code: ModeCode) -> CodeFacts {
    match code {
        ModeCode::CompensationLeft | ModeCode::CompensationRight => PLAIN
            .problems(COMPENSATION)
            .settings(&[SettingField::RADIUS_OFFSETS, SettingField::MAX_RADIUS_COMPENSATED])
            .rows(&[
                ("D", "number of the radius offset; D0 is a radius of zero"),
                ("P", "size of the cutter; Chordal does not follow it"),
                ("IJK", "direction of the offset at the end of this block"),
            ])
            .example("G1 {} D1 X20. F200."),
        ModeCode::CompensationLeftByDiameter | ModeCode::CompensationRightByDiameter => {
            PLAIN.problems(COMPENSATION).rows(&[
                ("D", "diameter of the tool; below zero it goes on the other side"),
                ("L", "position of the tip of a turning tool, 0 to 9"),
            ])
        }
        ModeCode::CompensationOff => PLAIN
            .problems(&[Code::CompensationOnArc, Code::SideChangeRefused])
            .rows(&[("IJK", "direction of the next wall, for the end of the last contour block")])
            .example("G1 {} X20. F200."),
        ModeCode::PlaneXy => PLAIN
            .problems(&[Code::PlaneChangeInCompensation, Code::FramePlane])
            .settings(&[SettingField::PLANE_CODES]),
        ModeCode::PlaneZx | ModeCode::PlaneYz => PLAIN
            .problems(&[Code::PlaneChangeInCompensation, Code::FramePlane, Code::CompensationPlane])
            .settings(&[SettingField::PLANE_CODES]),
        ModeCode::WorkOffset(_)
        | ModeCode::WorkOffsetPoint(_)
        | ModeCode::WorkOffsetNumbered(_) => PLAIN.problems(&[Code::ShiftInCompensation]),
        ModeCode::WorkOffsetExtended => PLAIN
            .problems(&[Code::ShiftInCompensation])
            .rows(&[("P", "number of the extended work offset")])
            .example("{} P1"),
        ModeCode::FixtureError => PLAIN
            .problems(&[Code::OffsetNotSet, Code::KinematicsNotKnown])
            .rows(&[("P", "number of the fixture offset; P0 ends it")])
            .example("{} P1"),
        ModeCode::WorkOffsetByOrdinal => PLAIN
            .problems(&[Code::ShiftInCompensation])
            .rows(&[("P", "number of the work offset; P1 is G54")])
            .example("{} P7"),
        ModeCode::RotationOff | ModeCode::ScalingOff => {
            PLAIN.problems(&[Code::FrameInCompensation, Code::OneAxisAfterFrame])
        }
        ModeCode::Polar { .. } => PLAIN.problems(&[Code::FrameInCompensation, Code::PolarWords]),
        ModeCode::CornerArc => {
            PLAIN.problems(&[Code::CornerBlock]).rows(super::once::CORNER_ARC_WORDS)
        }
        ModeCode::ModalSubroutine => PLAIN
            .problems(&[Code::MissingSubprogram])
            .rows(&[("L", "number of the subroutine that runs after each move")])
            .block(BlockSort::Arguments),
        ModeCode::ModalCallOff => PLAIN.problems(&[Code::MissingSubprogram]),
        ModeCode::Path(code) => path(code).left_out(),
        ModeCode::OverridesByP => {
            PLAIN.rows(&[("P", "0 switches the overrides off, everything else on")]).left_out()
        }
        ModeCode::ThreadExit { .. } => {
            PLAIN.settings(&[SettingField::TURNING_THREAD_EXIT]).left_out()
        }
        // The data before the end of its lines was refused.
        ModeCode::Overrides { .. } | ModeCode::DataLinesOff => PLAIN.left_out(),
        ModeCode::StoreReference { .. }
        | ModeCode::ReturnInitial
        | ModeCode::ReturnToR
        | ModeCode::CancelCycle => PLAIN,
    }
}

fn path(code: PathCode) -> CodeFacts {
    match code {
        PathCode::Continuous => PLAIN.rows(&[
            ("P", "largest distance from the programmed path at corners"),
            (
                "Q",
                "the control may join nearly straight lines within this distance; Chordal does not",
            ),
        ]),
        PathCode::LookAhead { letter, on } => PLAIN.words(WordMeanings::LookAhead { letter, on }),
        PathCode::Smoothness => PLAIN.rows(&[
            ("P", "1 rough, 2 medium, 3 finish"),
            ("E", "largest distance from the programmed path at corners"),
        ]),
        PathCode::Exact
        | PathCode::ExactStop
        | PathCode::ExactStopOnce
        | PathCode::HighAccuracy
        | PathCode::Tapping
        | PathCode::CornerOverride => PLAIN,
    }
}
