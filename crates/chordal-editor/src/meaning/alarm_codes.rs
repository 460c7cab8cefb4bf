//! Which problems a code can have, by what it does: the alarms that its page names.

use chordal::Code;
use chordal::control::table::ControlTable;
use chordal::control::{
    Action, AfterCode, BeforeCode, CallCode, LengthCode, ModeCode, MotionCode, OnceCode,
    ReadingCode,
};

/// The alarms that the control has for a wrong use of a code.
pub(crate) fn alarms(action: Action, table: &ControlTable) -> Vec<(Code, &'static str)> {
    let mut codes = problems(action);
    codes.sort_by_key(|code| code.id());
    codes.dedup();
    codes.into_iter().filter_map(|code| Some((code, table.alarm(code)?))).collect()
}

/// The problems that a code can have by itself, whichever control.
pub(crate) fn problems(action: Action) -> Vec<Code> {
    match action {
        Action::Motion(code) => of_motion(code),
        Action::Cycle(_) => of_cycle(),
        Action::Once(code) => of_once(code),
        Action::Mode(code) => of_mode(code),
        Action::Call(code) => of_call(code),
        Action::Length(code) => match code {
            LengthCode::Plus | LengthCode::Minus | LengthCode::Add => {
                vec![Code::OffsetNotSet, Code::LengthOffsetOfOtherTool, Code::TipDisplaced]
            }
            LengthCode::FromAxes | LengthCode::Cancel => vec![Code::TipDisplaced],
        },
        Action::Before(code) => of_before(code),
        Action::After(code) => match code {
            AfterCode::RunCycleHere => vec![Code::NoCycle],
            AfterCode::ProgramEnd { .. } => vec![Code::CompensationAtEnd],
            AfterCode::SpindleStop
            | AfterCode::LiveToolStop
            | AfterCode::CoolantOff
            | AfterCode::CoolantThroughToolOff
            | AfterCode::ProgramAgain
            | AfterCode::ProgramStop
            | AfterCode::OptionalStop
            | AfterCode::ShopCode => Vec::new(),
        },
        Action::Reading(ReadingCode::SurfaceSpeed) => vec![Code::SpeedWithoutLimit],
        Action::Reading(_) | Action::NoEffect | Action::NotSimulated | Action::NotFollowed => {
            Vec::new()
        }
    }
}

fn of_motion(code: MotionCode) -> Vec<Code> {
    match code {
        MotionCode::Rapid => vec![Code::NoSuchAxis],
        MotionCode::Linear => vec![
            Code::NoSuchAxis,
            Code::MissingFeed,
            Code::FeedOverLimit,
            Code::CornerNext,
            Code::CornerNextMotion,
            Code::CornerTooLarge,
        ],
        MotionCode::ArcCw | MotionCode::ArcCcw => vec![
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
        ],
        MotionCode::SpiralCw | MotionCode::SpiralCcw => vec![
            Code::CenterOutsidePlane,
            Code::NoCenter,
            Code::MissingFeed,
            Code::SpiralTurns,
            Code::NoSpirals,
            Code::ZeroRadius,
            Code::UnequalScaleArc,
        ],
        MotionCode::Spline(_) | MotionCode::SplineEnd => vec![
            Code::SplineWords,
            Code::SplinePoint,
            Code::SplineWeight,
            Code::SplineOpen,
            Code::SplineTooFew,
            Code::SplinePlane,
            Code::SplineInCompensation,
            Code::SplineOrder,
            Code::MissingFeed,
        ],
        MotionCode::Thread | MotionCode::RigidTap | MotionCode::Turn(_) => {
            vec![Code::CycleWithoutLead, Code::MissingFeed, Code::CycleSpindle]
        }
    }
}

fn of_cycle() -> Vec<Code> {
    vec![
        Code::CycleWithoutR,
        Code::CycleWithoutDepth,
        Code::CycleWithoutPeck,
        Code::CycleWithoutDwell,
        Code::CycleWithoutLead,
        Code::CycleLevels,
        Code::CycleInCompensation,
        Code::CycleZeroRepeats,
        Code::CycleInInverseTime,
        Code::CycleRotaryWord,
        Code::TooManyPecks,
        Code::NoMotionInForce,
        Code::CycleSpindle,
        Code::CycleWithoutShift,
        Code::CycleDepthIncremental,
    ]
}

fn of_once(code: OnceCode) -> Vec<Code> {
    match code {
        OnceCode::Probe { .. } => {
            vec![Code::MissingFeed, Code::ProbeWithoutHit, Code::BadProbeMove]
        }
        OnceCode::Rotation | OnceCode::Scaling | OnceCode::Mirror { .. } => vec![
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
        ],
        OnceCode::MirrorOff => vec![Code::FrameInCompensation, Code::OneAxisAfterFrame],
        OnceCode::ReturnToReference { .. } | OnceCode::ReturnFromReference | OnceCode::Home => {
            vec![Code::ReferenceInCompensation, Code::FrameWithReference]
        }
        OnceCode::LocalShift
        | OnceCode::PresetPosition
        | OnceCode::ClearPreset { .. }
        | OnceCode::RestorePreset
        | OnceCode::SetData => vec![Code::ShiftInCompensation],
        OnceCode::CircularPocketCw | OnceCode::CircularPocketCcw | OnceCode::GeneralPocket => vec![
            Code::ImproperFixedRoutine,
            Code::PocketTooSmall,
            Code::PocketWithoutDiameter,
            Code::PocketWithoutGeometry,
            Code::PocketGeometry,
            Code::PocketRefused,
            Code::PocketUnreached,
        ],
        OnceCode::Pattern(_) => vec![Code::PatternWords, Code::NoCycle],
        OnceCode::Surface(_) => vec![Code::SurfaceCode, Code::SurfaceMode, Code::RotarySpeed],
        OnceCode::Turning(_) => vec![
            Code::MissingLabel,
            Code::MissingSubprogram,
            Code::CycleWithoutLead,
            Code::CycleInCompensation,
            Code::CycleSpindle,
        ],
        OnceCode::CornerArcAlone => vec![Code::CornerBlock],
        OnceCode::MachineCoordinates => vec![Code::NoMotionInForce],
        OnceCode::Dwell | OnceCode::Engraving => Vec::new(),
    }
}

fn of_mode(code: ModeCode) -> Vec<Code> {
    match code {
        ModeCode::CompensationLeft
        | ModeCode::CompensationRight
        | ModeCode::CompensationLeftBy
        | ModeCode::CompensationRightBy => vec![
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
        ],
        ModeCode::CompensationOff => vec![Code::CompensationOnArc],
        ModeCode::PlaneXy | ModeCode::PlaneZx | ModeCode::PlaneYz => {
            vec![Code::PlaneChangeInCompensation, Code::FramePlane]
        }
        ModeCode::WorkOffset(_)
        | ModeCode::WorkOffsetPoint(_)
        | ModeCode::WorkOffsetExtended
        | ModeCode::WorkOffsetCounted
        | ModeCode::WorkOffsetNumbered(_) => vec![Code::ShiftInCompensation],
        ModeCode::RotationOff | ModeCode::ScalingOff => {
            vec![Code::FrameInCompensation, Code::OneAxisAfterFrame]
        }
        ModeCode::Polar { .. } => vec![Code::FrameInCompensation, Code::PolarWords],
        ModeCode::CornerArc => vec![Code::CornerBlock],
        ModeCode::ModalSubroutine | ModeCode::ModalCallOff => vec![Code::MissingSubprogram],
        ModeCode::StoreReference { .. }
        | ModeCode::ReturnInitial
        | ModeCode::ReturnToR
        | ModeCode::CancelCycle
        | ModeCode::Path(_)
        | ModeCode::Overrides { .. }
        | ModeCode::OverridesByP
        | ModeCode::ThreadExit { .. }
        | ModeCode::DataLinesOff => Vec::new(),
    }
}

fn of_call(code: CallCode) -> Vec<Code> {
    match code {
        CallCode::CallProgram | CallCode::CallLabel => {
            vec![Code::MissingSubprogram, Code::MissingLabel, Code::NestingTooDeep]
        }
        CallCode::MacroCall | CallCode::ModalMacroCall { .. } => vec![
            Code::MissingSubprogram,
            Code::NestingTooDeep,
            Code::MacroNesting,
            Code::BadArgument,
        ],
        CallCode::Return | CallCode::SubroutineEnd => {
            vec![Code::MissingLabel, Code::ReturnWithoutCall]
        }
    }
}

fn of_before(code: BeforeCode) -> Vec<Code> {
    match code {
        BeforeCode::ToolChange | BeforeCode::SetToolNumber => vec![Code::ToolChangeInCompensation],
        BeforeCode::RestoreModes | BeforeCode::ForgetModes => vec![Code::NoKeptModes],
        BeforeCode::SpindleCw
        | BeforeCode::SpindleCcw
        | BeforeCode::SpindleOrient
        | BeforeCode::LiveToolCw
        | BeforeCode::LiveToolCcw
        | BeforeCode::CAxisOn
        | BeforeCode::CoolantMist
        | BeforeCode::CoolantFlood
        | BeforeCode::CoolantThroughTool
        | BeforeCode::SaveModes { .. } => Vec::new(),
    }
}
