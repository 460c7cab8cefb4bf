//! What codes do, split by when they act.
//!
//! A block is carried out in one order, whatever the order of its words: modes that change how its
//! numbers are read, then tools, spindle and coolant on, then modes that its motion obeys, then the
//! motion or the one code that takes its axis words, then what ends with it, then calls. Each part
//! is an enum of its own, and each place that acts on it matches it exhaustively: a new code does
//! not compile until every such place answers for it. Where controls differ,
//! [`BlockOrder`](crate::BlockOrder) says how.

use chordal_command::{FeedMode, Units, WorkName};
use chordal_geometry::{Plane, TurnDirection};
use chordal_kernel::rules::{CycleKind, HolePattern, TurnCycle};
use chordal_kernel::{MotionMode, SplineForm, TurnPass};

/// What a code does.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Action {
    /// Changes how the numbers of its own block are read.
    Reading(ReadingCode),
    /// Acts before the motion: tool, spindle and coolant on.
    Before(BeforeCode),
    /// A mode that the motion of its block obeys.
    Mode(ModeCode),
    /// Tool length.
    Length(LengthCode),
    /// Moves.
    Motion(MotionCode),
    /// A canned cycle.
    Cycle(CycleKind),
    /// Takes the axis words of its block for itself.
    Once(OnceCode),
    /// Acts after the motion: stops, ends, spindle and coolant off.
    After(AfterCode),
    /// Calls and returns.
    Call(CallCode),
    /// Carried out without effect on path or time.
    NoEffect,
    /// The control carries it out and Chordal does not; path and place stay what they are.
    NotSimulated,
    /// The same for what changes the path or a place: what comes after it is not known.
    NotFollowed,
}

/// How the numbers of a block are read.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs, reason = "the names are the field's own")]
pub enum ReadingCode {
    Inch,
    Millimetre,
    Absolute,
    Incremental,
    ArcCenterAbsolute,
    ArcCenterIncremental,
    FeedPerTime,
    FeedInverseTime,
    FeedPerRevolution,
    /// S is a cutting speed (G96).
    SurfaceSpeed,
    /// S is a spindle speed (G97).
    SpindleRpm,
    /// X is a diameter (LinuxCNC G7), in this block too.
    Diameters,
    /// X is a radius (LinuxCNC G8).
    Radii,
}

/// What acts before the motion of its block.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs, reason = "the names are the field's own")]
pub enum BeforeCode {
    ToolChange,
    /// The tool in the spindle has the number Q (LinuxCNC M61).
    SetToolNumber,
    SpindleCw,
    SpindleCcw,
    SpindleOrient,
    /// A live tool of the turret turns, P times a minute (Haas M133).
    LiveToolCw,
    LiveToolCcw,
    /// The spindle stops, and is the C axis (Haas M154).
    CAxisOn,
    CoolantMist,
    CoolantFlood,
    CoolantThroughTool,
    /// The modes in force are kept (LinuxCNC M70); to come back at the end of the subprogram (M73).
    SaveModes {
        until_return: bool,
    },
    /// What is kept is forgotten (M71).
    ForgetModes,
    /// What is kept comes into force again (M72).
    RestoreModes,
}

/// Modes that the motion of a block obeys.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs, reason = "the names are the field's own")]
pub enum ModeCode {
    PlaneXy,
    PlaneZx,
    PlaneYz,
    CompensationOff,
    CompensationLeft,
    CompensationRight,
    /// An arc round an outside corner (G39), with a move.
    CornerArc,
    /// G54 to G59.
    WorkOffset(u16),
    /// The error of a clamped part, which turns with the tables, by P (Fanuc G54.2).
    FixtureError,
    /// G59.1 to G59.3.
    WorkOffsetPoint(u16),
    /// The extended work offset P (G54.1, Haas G154).
    WorkOffsetExtended,
    /// G59, or with P the work offset of this ordinal: P1 is G54 (Mach3).
    WorkOffsetByOrdinal,
    /// The present machine position becomes reference point 1 (G28.1) or 2 (G30.1).
    StoreReference {
        second: bool,
    },
    /// G41 with the tool's diameter in D (LinuxCNC G41.1).
    CompensationLeftByDiameter,
    CompensationRightByDiameter,
    /// An extended work offset by a code of its own (Haas G110 is G154 P1).
    WorkOffsetNumbered(u16),
    ReturnInitial,
    ReturnToR,
    CancelCycle,
    /// How corners are passed.
    Path(PathCode),
    /// The panel's feed override acts or not (M48, M49), and with it that of rapids.
    Overrides {
        on: bool,
        rapid: bool,
    },
    /// The same for feed and rapids by P: off with 0 (LinuxCNC M50).
    OverridesByP,
    /// The rotation ends.
    RotationOff,
    /// The scaling ends.
    ScalingOff,
    /// End points are a radius and an angle, or coordinates again.
    Polar {
        on: bool,
    },
    /// Fadal G66: calls a subroutine after every move.
    ModalSubroutine,
    ModalCallOff,
    /// Threads of cycles end with their exit at 45 degrees, or without (Haas M23, M24).
    ThreadExit {
        on: bool,
    },
    /// G11: the lines after this block are blocks again, no data.
    DataLinesOff,
}

/// How corners are passed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs, reason = "the names are the field's own")]
pub enum PathCode {
    Exact,
    ExactStop,
    /// A stop at the end of this block.
    ExactStopOnce,
    Continuous,
    /// Corners rounded within the distance of high-accuracy control (Mitsubishi G61.1).
    HighAccuracy,
    /// Corners as in `Continuous`, and slower in inside corners of a compensated contour (G62).
    CornerOverride,
    /// Corners as in `Continuous`, and the feed override has no effect (G63).
    Tapping,
    /// Look-ahead control: on with these values of the letter, off with 0.
    LookAhead {
        letter: u8,
        on: &'static [u32],
    },
    /// How far corners are rounded, by level P or distance E (Haas G187).
    Smoothness,
}

/// Tool length.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LengthCode {
    /// G43.
    Plus,
    /// G44.
    Minus,
    /// G49.
    Cancel,
    /// The axis words are the tool's offsets (LinuxCNC G43.1).
    FromAxes,
    /// The offsets of another tool are added (LinuxCNC G43.2).
    Add,
    /// The length acts along the tool, and coordinates are those of its tip on the part (G43.4, Haas G234).
    ToolCenter,
    /// The same, and I, J and K are the direction of the tool (G43.5).
    ToolCenterByVector,
    /// The length acts along the tool as the heads A and B stand (Haas G143).
    AlongTool,
}

/// Moves.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs, reason = "the names are the field's own")]
pub enum MotionCode {
    Rapid,
    Linear,
    ArcCw,
    ArcCcw,
    SpiralCw,
    SpiralCcw,
    /// A straight cut in step with the spindle: K is its advance per revolution.
    Thread,
    /// The same, back again with the spindle reversed.
    RigidTap,
    /// A spline, or a control point of one.
    Spline(SplineForm),
    /// A spline of the control points since G5.2 (G5.3).
    SplineEnd,
    /// A pass of a lathe and back to its start.
    Turn(TurnPass),
}

/// What takes the axis words of its block for itself.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs, reason = "the names are the field's own")]
pub enum OnceCode {
    Dwell,
    SetData,
    /// Over a point to reference point 1 (G28) or the one that P names (G30).
    ReturnToReference {
        second: bool,
    },
    ReturnFromReference,
    /// The axes that are named go to their switches, by any number or none; all where none is named (Marlin).
    Home,
    MachineCoordinates,
    LocalShift,
    PresetPosition,
    ClearPreset {
        keep: bool,
    },
    RestorePreset,
    /// The coordinates are rotated in the plane.
    Rotation,
    /// The coordinates are scaled.
    Scaling,
    /// Axes are mirrored: at the coordinate that their word gives, or at zero.
    Mirror {
        at_zero: bool,
    },
    /// The mirror of the named axes ends, or that of all.
    MirrorOff,
    /// A round pocket by one block, clockwise.
    CircularPocketCw,
    CircularPocketCcw,
    /// A pocket of any outline by one block.
    GeneralPocket,
    /// Engraves the text of a comment, or a number (Haas G47).
    Engraving,
    /// Holes of the cycle in force on a circle, an arc or a line.
    Pattern(HolePattern),
    /// A move that ends where a probe touches; `must_hit`: without a touch it is an alarm.
    Probe {
        must_hit: bool,
    },
    /// An arc round an outside corner (G39), in a block of its own.
    CornerArcBlock,
    /// A cycle of a lathe.
    Turning(TurnCycle),
    /// The coordinates lie on a surface that turns with a rotary axis, or no longer.
    Surface(SurfaceCode),
    /// The coordinates lie in a tilted plane, or no longer; or the tool turns to it.
    TiltedPlane(TiltedPlaneCode),
}

/// Tilted planes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TiltedPlaneCode {
    /// By an origin and angles: Euler angles where P does not choose another way (G68.2), in the work coordinate system or
    /// in the plane that is in force (G68.4).
    Define {
        /// The words are coordinates of the plane that is in force.
        in_active: bool,
    },
    /// By an origin and angles about the axes in the order of Q (Haas G268).
    DefineByAxes,
    /// Upright under the tool as the rotary axes stand (G68.3).
    DefineByTool,
    /// No longer (Haas G269).
    Off,
    /// The origin of the work coordinates rides on the tables, and their axes stay those of the machine (Haas G254), or no
    /// longer (G255).
    OriginOnTable {
        /// It begins.
        on: bool,
    },
    /// The rotary axes turn so that the tool stands upright on it: they alone (G53.1, Haas G253), or with the tip held (G53.6).
    Turn {
        /// The tip stays where it is.
        holds_tip: bool,
    },
}

/// Polar and cylindrical interpolation.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SurfaceCode {
    /// On the face of the part (G12.1, Haas G112).
    Face,
    /// No longer (G13.1, Haas G113).
    FaceOff,
    /// On the shell of a cylinder; with the radius 0, or without words, no longer (G7.1, Haas G107).
    Cylinder,
}

/// What acts after the motion of its block.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs, reason = "the names are the field's own")]
pub enum AfterCode {
    SpindleStop,
    /// The live tool stops (Haas M135).
    LiveToolStop,
    CoolantOff,
    CoolantThroughToolOff,
    ProgramStop,
    OptionalStop,
    ProgramEnd {
        rewind: bool,
    },
    /// The program starts again from its first line (Mach3 M47).
    ProgramAgain,
    /// A custom M code, which the table does not have.
    ShopCode,
    RunCycleHere,
}

/// Calls and returns.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs, reason = "the names are the field's own")]
pub enum CallCode {
    CallProgram,
    CallLabel,
    Return,
    SubroutineEnd,
    /// G65: calls a program with its words as arguments.
    MacroCall,
    /// G66: the same after every move; G66.1: for every block.
    ModalMacroCall {
        every_block: bool,
    },
}

impl ModeCode {
    /// Whether the feed override acts, where the code says so for good.
    pub const fn overrides(self) -> Option<bool> {
        if let ModeCode::Overrides { on, .. } = self { Some(on) } else { None }
    }

    /// G41 for G42 and the other way round.
    pub fn other_side(self) -> Option<ModeCode> {
        if self == ModeCode::CompensationLeftByDiameter {
            return Some(ModeCode::CompensationRightByDiameter);
        }
        if self == ModeCode::CompensationRightByDiameter {
            return Some(ModeCode::CompensationLeftByDiameter);
        }
        if self == ModeCode::CompensationLeft {
            return Some(ModeCode::CompensationRight);
        }
        (self == ModeCode::CompensationRight).then_some(ModeCode::CompensationLeft)
    }

    /// G18 or G19.
    pub const fn is_other_plane(self) -> bool {
        matches!(self, ModeCode::PlaneZx | ModeCode::PlaneYz)
    }

    /// The work offset that the code names by itself; `None` where P names it, and where it chooses none.
    pub const fn work_name(self) -> Option<WorkName> {
        if let ModeCode::WorkOffset(number) = self {
            return Some(WorkName::G(number));
        }
        if let ModeCode::WorkOffsetPoint(number) = self {
            return Some(WorkName::G59(number));
        }
        if let ModeCode::WorkOffsetNumbered(number) = self {
            return Some(WorkName::Extended(number));
        }
        None
    }

    /// Chooses a work offset.
    pub const fn is_work_offset(self) -> bool {
        matches!(
            self,
            ModeCode::WorkOffset(_)
                | ModeCode::WorkOffsetPoint(_)
                | ModeCode::WorkOffsetExtended
                | ModeCode::WorkOffsetByOrdinal
                | ModeCode::WorkOffsetNumbered(_)
        )
    }
}

impl OnceCode {
    /// Works with machine places or work coordinates, which frames of the program do not move.
    pub const fn works_with_places(self) -> bool {
        matches!(
            self,
            OnceCode::ReturnToReference { .. }
                | OnceCode::ReturnFromReference
                | OnceCode::Home
                | OnceCode::MachineCoordinates
                | OnceCode::LocalShift
                | OnceCode::PresetPosition
        )
    }

    /// A pocket by one block.
    pub const fn is_pocket(self) -> bool {
        matches!(
            self,
            OnceCode::CircularPocketCw | OnceCode::CircularPocketCcw | OnceCode::GeneralPocket
        )
    }
}

/// What P of a call names.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CallTarget {
    /// A program.
    Program,
    /// A block number.
    Label,
}

impl CallCode {
    /// What P names; `None` where the code takes none.
    pub const fn called(self) -> Option<CallTarget> {
        match self {
            CallCode::CallProgram | CallCode::MacroCall | CallCode::ModalMacroCall { .. } => {
                Some(CallTarget::Program)
            }
            CallCode::CallLabel | CallCode::Return => Some(CallTarget::Label),
            CallCode::SubroutineEnd => None,
        }
    }
}

impl MotionCode {
    /// An arc or a spiral.
    pub const fn is_curve(self) -> bool {
        match self {
            MotionCode::Rapid | MotionCode::Linear => false,
            MotionCode::ArcCw | MotionCode::ArcCcw => true,
            MotionCode::SpiralCw | MotionCode::SpiralCcw => true,
            MotionCode::Thread | MotionCode::RigidTap => false,
            MotionCode::Spline(_) | MotionCode::SplineEnd => true,
            MotionCode::Turn(_) => false,
        }
    }
}

impl Action {
    /// The control carries it out and Chordal does not.
    pub const fn is_left_out(self) -> bool {
        matches!(self, Action::NotSimulated | Action::NotFollowed)
    }

    /// The motion of its block still takes place after it.
    pub const fn leaves_axes(self, dwell_with_motion: bool) -> bool {
        matches!(self, Action::Once(OnceCode::ClearPreset { .. } | OnceCode::RestorePreset))
            || dwell_with_motion && matches!(self, Action::Once(OnceCode::Dwell))
    }

    /// The motion, where the code is one.
    pub const fn motion(self) -> Option<MotionCode> {
        if let Action::Motion(code) = self { Some(code) } else { None }
    }

    /// The canned cycle, where the code is one.
    pub const fn cycle(self) -> Option<CycleKind> {
        if let Action::Cycle(kind) = self { Some(kind) } else { None }
    }

    /// The mode, where the code is one.
    pub const fn mode(self) -> Option<ModeCode> {
        if let Action::Mode(code) = self { Some(code) } else { None }
    }

    /// G91 or G90, where the code is one of them.
    pub fn incremental(self) -> Option<bool> {
        let is_incremental = self == Action::Reading(ReadingCode::Incremental);
        (is_incremental || self == Action::Reading(ReadingCode::Absolute)).then_some(is_incremental)
    }

    /// G91 or G90.
    pub const fn of_distance(incremental: bool) -> Action {
        Action::Reading(if incremental { ReadingCode::Incremental } else { ReadingCode::Absolute })
    }

    /// The cycle of a lathe, where the code is one.
    pub const fn turning_cycle(self) -> Option<TurnCycle> {
        if let Action::Once(OnceCode::Turning(cycle)) = self { Some(cycle) } else { None }
    }

    /// What the code takes the axis words for.
    pub const fn once(self) -> Option<OnceCode> {
        if let Action::Once(code) = self { Some(code) } else { None }
    }

    /// The units, where the code chooses them.
    pub fn units(self) -> Option<Units> {
        if self == Action::Reading(ReadingCode::Inch) {
            return Some(Units::Inch);
        }
        (self == Action::Reading(ReadingCode::Millimetre)).then_some(Units::Millimetre)
    }

    /// A motion code that every control has: G0 to G3.
    pub const fn is_plain_motion(self) -> bool {
        let Action::Motion(motion) = self else { return false };
        match motion {
            MotionCode::Rapid | MotionCode::Linear | MotionCode::ArcCw | MotionCode::ArcCcw => true,
            MotionCode::SpiralCw | MotionCode::SpiralCcw => false,
            MotionCode::Thread | MotionCode::RigidTap => false,
            MotionCode::Spline(_) | MotionCode::SplineEnd | MotionCode::Turn(_) => false,
        }
    }
}

impl From<Units> for Action {
    fn from(units: Units) -> Action {
        Action::Reading(match units {
            Units::Inch => ReadingCode::Inch,
            Units::Millimetre => ReadingCode::Millimetre,
        })
    }
}

impl From<Plane> for Action {
    fn from(plane: Plane) -> Action {
        Action::Mode(match plane {
            Plane::Xy => ModeCode::PlaneXy,
            Plane::Zx => ModeCode::PlaneZx,
            Plane::Yz => ModeCode::PlaneYz,
        })
    }
}

impl From<FeedMode> for Action {
    fn from(mode: FeedMode) -> Action {
        Action::Reading(match mode {
            FeedMode::PerTime => ReadingCode::FeedPerTime,
            FeedMode::InverseTime => ReadingCode::FeedInverseTime,
            FeedMode::PerRevolution => ReadingCode::FeedPerRevolution,
        })
    }
}

impl From<MotionMode> for Action {
    /// What the code of a motion in force does.
    fn from(motion: MotionMode) -> Action {
        let code = match motion {
            MotionMode::Rapid => MotionCode::Rapid,
            MotionMode::Linear => MotionCode::Linear,
            MotionMode::Arc(TurnDirection::Cw) => MotionCode::ArcCw,
            MotionMode::Arc(TurnDirection::Ccw) => MotionCode::ArcCcw,
            MotionMode::Spiral(TurnDirection::Cw) => MotionCode::SpiralCw,
            MotionMode::Spiral(TurnDirection::Ccw) => MotionCode::SpiralCcw,
            MotionMode::Thread => MotionCode::Thread,
            MotionMode::RigidTap => MotionCode::RigidTap,
            MotionMode::Spline(form) => MotionCode::Spline(form),
            MotionMode::Turn(pass) => MotionCode::Turn(pass),
            MotionMode::Probe { must_hit } => return Action::Once(OnceCode::Probe { must_hit }),
            MotionMode::ThreadPasses => {
                return Action::Once(OnceCode::Turning(TurnCycle::LineThread));
            }
            MotionMode::Cycle(kind) => return Action::Cycle(kind),
        };
        Action::Motion(code)
    }
}
