//! What a word means in the block of a G or M code: Q of G83 is a peck, Q of G76 a shift.

use chordal::control::table::{ArcTurns, CodeRow, DataTarget, DwellWord};
use chordal::control::{
    Action, BeforeCode, CallCode, LengthCode, ModeCode, MotionCode, OnceCode, PathCode,
    ReadingCode, SurfaceCode,
};
use chordal::control::{ArcCenter, CycleKind, HolePattern, SplineForm, TurnCycle, TurnPass};
use chordal::control::{
    BackBore, CycleRules, DrillingAxis, PeckDwell, ShiftWords, SpiralForm, TapFeed,
};

use chordal::machine::AXIS_LETTERS;

use crate::meaning::ControlView;

/// The meaning of a letter in the block of a code; `None` where it is accepted and does nothing to the path.
pub fn word_meaning(row: &CodeRow, letter: u8, view: &ControlView) -> Option<String> {
    match row.action {
        Action::Once(code) => once(code, letter, view),
        Action::Motion(code) => motion(code, letter, view),
        Action::Mode(code) => mode(code, letter),
        Action::Length(code) => length(code, letter).map(str::to_string),
        Action::Call(code) => called(code, letter, view),
        Action::Before(code) => before(code, letter).map(str::to_string),
        Action::Cycle(kind) => cycle(kind, letter, view),
        Action::Reading(ReadingCode::SurfaceSpeed) if letter == b'D' => {
            Some("limit of the spindle speed, rev/min".into())
        }
        Action::Reading(_)
        | Action::After(_)
        | Action::NoEffect
        | Action::NotSimulated
        | Action::NotFollowed => None,
    }
}

fn motion(code: MotionCode, letter: u8, view: &ControlView) -> Option<String> {
    match code {
        MotionCode::Rapid => None,
        MotionCode::Linear if !view.parameters.corners_of_lines => None,
        MotionCode::Linear => match letter {
            b'I' | b'K' => Some("chamfer between this cut and the next, from the corner".into()),
            b'R' => Some("radius of a rounding between this cut and the next".into()),
            _ => None,
        },
        MotionCode::Thread if view.parameters.thread_lead == b'F' => match letter {
            b'K' => Some("change of the lead in each revolution".into()),
            b'Q' => Some("angle at which the thread starts".into()),
            _ => None,
        },
        MotionCode::ArcCw | MotionCode::ArcCcw => arc(letter, view),
        MotionCode::Thread | MotionCode::RigidTap => match letter {
            b'K' => Some("advance along the path per revolution of the spindle".into()),
            b'I' => Some("how many times as fast the tool comes back; 1 without it".into()),
            _ => None,
        },
        MotionCode::Turn(pass) => turn_pass(pass, letter).map(str::to_string),
        MotionCode::SpiralCw | MotionCode::SpiralCcw => match letter {
            b'P' => Some("whole turns beyond the angle from start to end, 0 to 99".into()),
            b'I' | b'J' | b'K' => center(letter, view),
            _ => None,
        },
        MotionCode::Spline(form) => spline(form, letter).map(str::to_string),
        MotionCode::SplineEnd => None,
    }
}

fn turn_pass(pass: TurnPass, letter: u8) -> Option<&'static str> {
    Some(match (pass, letter) {
        (TurnPass::Facing, b'R' | b'K') => "taper: Z of the start minus Z of the end",
        (_, b'R' | b'I') => "taper on the radius: start minus end",
        (TurnPass::Thread, b'Q') => "angle at which the thread starts",
        _ => return None,
    })
}

fn turning(cycle: TurnCycle, letter: u8) -> Option<&'static str> {
    use TurnCycle as T;
    Some(match (cycle, letter) {
        (T::PeckX, b'P') => "depth of a peck, on the radius",
        (T::PeckX, b'Q') => "distance of the plunges along Z",
        (T::PeckZ, b'P') => "distance of the plunges, on the radius",
        (T::PeckZ, b'Q') => "depth of a peck",
        (T::PeckX | T::PeckZ, b'R') => {
            "how far a peck backs off; with X or Z how far the tool goes aside at the bottom"
        }
        (T::Thread, b'P') => {
            "passes, exit and angle in two digits each; with X and Z the height of the thread"
        }
        (T::Thread, b'Q') => "least depth of a pass; with X and Z the depth of the first pass",
        (T::Thread, b'R') => "depth of the finishing pass; with X and Z the taper",
        (T::Thread, b'K') => "height of the thread, in one block",
        (T::Thread, b'D') => "depth of the first pass, in one block",
        (T::Thread, b'A') => "angle of the thread, in one block",
        (T::Thread, b'I') => "taper on the radius, in one block",
        (T::LineThread, letter) => return line_thread(letter),
        (T::FinishSubroutine | T::RoughSubroutine(_) | T::RoughFaceSubroutine(_), letter) => {
            return by_subroutine(letter);
        }
        (_, b'P') => "number of the first block of the contour",
        (_, b'Q') => "number of the last block of the contour",
        (T::Rough, b'U') => {
            "depth of a pass on the radius; with P and Q the finishing allowance on the diameter"
        }
        (T::RoughFace, b'W') => "depth of a pass; with P and Q the finishing allowance along Z",
        (T::Rough | T::RoughFace, b'R') => "how far a pass backs off",
        (T::Rough | T::RoughFace, b'D') => "depth of a pass, in one block",
        (T::Pattern, b'U') => {
            "what is to be removed, on the radius; with P and Q the finishing allowance on the diameter"
        }
        (T::Pattern, b'W') => "what is to be removed along Z; with P and Q the finishing allowance",
        (T::Pattern, b'R') => "number of passes",
        (T::Rough, b'W') => "finishing allowance along Z",
        (T::RoughFace, b'U') => "finishing allowance on the diameter",
        (_, b'F') => "feed of the cycle",
        (_, b'S') => "spindle speed of the cycle",
        _ => return None,
    })
}

fn line_thread(letter: u8) -> Option<&'static str> {
    Some(match letter {
        b'P' => "lead of the thread",
        b'I' => "from the start to the crest; below zero outside, above zero in a bore",
        b'J' => "depth of the first pass",
        b'K' => "height of the thread",
        b'R' => "how the depth of the passes falls: 1 equal steps, 2 equal areas",
        b'Q' => "angle of the infeed, degrees",
        b'H' => "further passes at the whole height",
        b'E' => "length of the tapered ends along Z",
        b'L' => "tapered ends: 0 none, 1 at the start, 2 at the end, 3 both",
        _ => return None,
    })
}

fn by_subroutine(letter: u8) -> Option<&'static str> {
    Some(match letter {
        b'Q' => "number of the subroutine that holds the contour",
        b'D' => "what is left on the contour; of G70 the distance before the first pass",
        b'E' => "distance of the last pass",
        b'P' => "number of passes",
        b'I' => "depth of a pass, on the radius",
        b'R' => "how far a pass backs off",
        _ => return None,
    })
}

fn spline(form: SplineForm, letter: u8) -> Option<&'static str> {
    Some(match (form, letter) {
        (SplineForm::Cubic, b'I') => "X from the start to the first control point",
        (SplineForm::Cubic, b'J') => "Y from the start to the first control point",
        (SplineForm::Cubic, b'P') => "X from the end to the second control point",
        (SplineForm::Cubic, b'Q') => "Y from the end to the second control point",
        (SplineForm::Quadratic, b'I') => "X from the start to the control point",
        (SplineForm::Quadratic, b'J') => "Y from the start to the control point",
        (SplineForm::Points, b'P') => "weight of the control point, above zero",
        (SplineForm::Points, b'L') => "order of the curve (degree + 1); 3 without it",
        _ => return None,
    })
}

fn once(code: OnceCode, letter: u8, view: &ControlView) -> Option<String> {
    let text = match code {
        OnceCode::Dwell => return dwell(letter, view),
        OnceCode::SetData => return set_data(letter, view),
        OnceCode::Pattern(pattern) => return holes(pattern, letter),
        OnceCode::Turning(cycle) => return turning(cycle, letter).map(str::to_string),
        OnceCode::PresetPosition if view.parameters.preset_limits_speed => match letter {
            b'S' => "limit of the spindle speed, rev/min",
            _ => return None,
        },
        OnceCode::ReturnToReference { second } => match letter {
            b'P' if second => "number of the reference point: 2, 3 or 4; without P the second",
            _ => return None,
        },
        OnceCode::CornerArcAlone => return corner_arc(letter).map(str::to_string),
        OnceCode::CircularPocketCw | OnceCode::CircularPocketCcw
            if view.parameters.rules.pocket_is_one_circle =>
        {
            match letter {
                b'I' => "radius of the circle of the tool's centre",
                _ => return None,
            }
        }
        OnceCode::CircularPocketCw | OnceCode::CircularPocketCcw => match letter {
            b'I' => "radius of the first circle; of the finished circle where K is not given",
            b'K' => "radius of the finished circle",
            b'Q' => "step from one circle to the next, with K",
            b'L' => "how often the pocket is cut; in G91 each pass goes down by Z",
            b'D' => "number of the radius offset",
            _ => return None,
        },
        OnceCode::GeneralPocket => match letter {
            b'P' => "number of the subprogram that holds the outline",
            b'R' => "R level: where feeding begins",
            b'Q' => "depth of one level",
            b'I' => "step between rows along X",
            b'J' => "step between rows along Y",
            b'K' => "finish allowance that the last pass cuts",
            b'D' => "number of the radius offset",
            b'S' => "spindle speed",
            _ => return None,
        },
        OnceCode::Rotation if view.parameters.rules.frames.rotation_center_by_ab => match letter {
            b'A' => "centre of the rotation, in X",
            b'B' => "centre of the rotation, in Y",
            b'R' => "angle of the rotation in degrees, counter-clockwise",
            b'I' => "the angle is added to the one in force; Chordal does not follow it",
            _ => return None,
        },
        OnceCode::Rotation => match letter {
            b'R' => "angle of the rotation in degrees, counter-clockwise",
            b'I' | b'J' | b'K' => "axis of the rotation in space; Chordal does not follow it",
            b'X' | b'Y' | b'Z' => "centre of the rotation",
            _ => return None,
        },
        OnceCode::Scaling if view.parameters.rules.frames.factors_by_axes => match letter {
            b'X' | b'Y' | b'Z' => "factor of the words of this axis",
            _ => return None,
        },
        OnceCode::Scaling => match letter {
            b'P' => "scale factor of all axes",
            b'I' => "scale factor of X",
            b'J' => "scale factor of Y",
            b'K' => "scale factor of Z",
            b'X' | b'Y' | b'Z' => "centre of the scaling",
            _ => return None,
        },
        OnceCode::Surface(SurfaceCode::Cylinder) => match letter {
            b'R' => "radius of the cylinder",
            b'Q' => "diameter of the cylinder",
            b'A' | b'B' | b'C' => "rotary axis that becomes a length on the cylinder",
            b'X' | b'Y' | b'Z' => "linear axis that the rotary one takes the place of",
            _ => return None,
        },
        OnceCode::Surface(SurfaceCode::Face | SurfaceCode::FaceOff) => return None,
        OnceCode::Mirror { .. } | OnceCode::MirrorOff => return None,
        OnceCode::Home => match letter {
            b'X' | b'Y' | b'Z' => "axis that goes to its switch; a number with it does nothing",
            b'O' => "only axes that are not homed yet",
            b'R' => "how far Z is raised before",
            _ => return None,
        },
        OnceCode::Engraving => match letter {
            b'P' => "0: the text in the comment; 1: a serial number; 32 to 126: one character",
            b'R' => "level to which the tool returns",
            b'I' => "angle of the text, degrees",
            b'J' => "height of the letters",
            b'E' => "feed of the plunges",
            _ => return None,
        },
        OnceCode::ReturnFromReference
        | OnceCode::MachineCoordinates
        | OnceCode::LocalShift
        | OnceCode::PresetPosition
        | OnceCode::ClearPreset { .. }
        | OnceCode::RestorePreset
        | OnceCode::Probe { .. } => return None,
    };
    Some(text.into())
}

fn corner_arc(letter: u8) -> Option<&'static str> {
    matches!(letter, b'I' | b'J' | b'K').then_some("direction at which the corner arc ends")
}

fn mode(code: ModeCode, letter: u8) -> Option<String> {
    let text = match code {
        ModeCode::Path(code) => return path_mode(code, letter),
        ModeCode::CornerArc => return corner_arc(letter).map(str::to_string),
        ModeCode::CompensationOff => match letter {
            b'I' | b'J' | b'K' => {
                "direction of the next wall, for the end of the last contour block"
            }
            _ => return None,
        },
        ModeCode::CompensationLeft | ModeCode::CompensationRight => match letter {
            b'D' => "number of the radius offset; D0 is a radius of zero",
            b'P' => "size of the cutter; Chordal does not follow it",
            b'I' | b'J' | b'K' => "direction of the offset at the end of this block",
            _ => return None,
        },
        ModeCode::CompensationLeftBy | ModeCode::CompensationRightBy => match letter {
            b'D' => "diameter of the tool; below zero it goes on the other side",
            b'L' => "position of the tip of a turning tool, 0 to 9",
            _ => return None,
        },
        ModeCode::WorkOffsetCounted => match letter {
            b'P' => "number of the work offset; P1 is G54",
            _ => return None,
        },
        ModeCode::WorkOffsetExtended => match letter {
            b'P' => "number of the extended work offset",
            _ => return None,
        },
        ModeCode::ModalSubroutine => match letter {
            b'L' => "number of the subroutine that runs after each move",
            _ => return None,
        },
        ModeCode::OverridesByP => match letter {
            b'P' => "0 switches the overrides off, everything else on",
            _ => return None,
        },
        ModeCode::PlaneXy
        | ModeCode::PlaneZx
        | ModeCode::PlaneYz
        | ModeCode::WorkOffset(_)
        | ModeCode::WorkOffsetPoint(_)
        | ModeCode::WorkOffsetNumbered(_)
        | ModeCode::StoreReference { .. }
        | ModeCode::ReturnInitial
        | ModeCode::ReturnToR
        | ModeCode::CancelCycle
        | ModeCode::Overrides { .. }
        | ModeCode::RotationOff
        | ModeCode::ScalingOff
        | ModeCode::Polar { .. }
        | ModeCode::ModalCallOff
        | ModeCode::ThreadExit { .. }
        | ModeCode::DataLinesOff => return None,
    };
    Some(text.into())
}

fn path_mode(code: PathCode, letter: u8) -> Option<String> {
    let text = match code {
        PathCode::Continuous => match letter {
            b'P' => "largest distance from the programmed path at corners",
            b'Q' => {
                "the control may join nearly straight lines within this distance; Chordal does not"
            }
            _ => return None,
        },
        PathCode::LookAhead { letter: own, on } => {
            let on = on.iter().map(u32::to_string).collect::<Vec<_>>().join(" or ");
            return (own == letter).then(|| format!("{on} switches look-ahead on, 0 off"));
        }
        PathCode::Smoothness => match letter {
            b'P' => "1 rough, 2 medium, 3 finish",
            b'E' => "largest distance from the programmed path at corners",
            _ => return None,
        },
        PathCode::Exact
        | PathCode::ExactStop
        | PathCode::ExactStopOnce
        | PathCode::HighAccuracy
        | PathCode::Tapping
        | PathCode::CornerOverride => return None,
    };
    Some(text.into())
}

fn length(code: LengthCode, letter: u8) -> Option<&'static str> {
    match code {
        LengthCode::Plus | LengthCode::Minus => {
            (letter == b'H').then_some("number of the length offset")
        }
        LengthCode::Add => (letter == b'H').then_some("number of the tool whose offsets are added"),
        LengthCode::FromAxes => AXIS_LETTERS
            .contains(char::from(letter))
            .then_some("offset of the tool along this axis"),
        LengthCode::Cancel => None,
    }
}

fn before(code: BeforeCode, letter: u8) -> Option<&'static str> {
    match code {
        BeforeCode::SpindleOrient => matches!(letter, b'R' | b'P')
            .then_some("angle, in degrees; it does not change the path"),
        BeforeCode::SetToolNumber => {
            (letter == b'Q').then_some("number of the tool in the spindle")
        }
        BeforeCode::LiveToolCw | BeforeCode::LiveToolCcw => {
            (letter == b'P').then_some("speed of the live tool, revolutions per minute")
        }
        BeforeCode::ToolChange
        | BeforeCode::SpindleCw
        | BeforeCode::SpindleCcw
        | BeforeCode::CAxisOn
        | BeforeCode::CoolantMist
        | BeforeCode::CoolantFlood
        | BeforeCode::CoolantThroughTool
        | BeforeCode::SaveModes { .. }
        | BeforeCode::ForgetModes
        | BeforeCode::RestoreModes => None,
    }
}

fn called(code: CallCode, letter: u8, view: &ControlView) -> Option<String> {
    let text = match code {
        CallCode::CallProgram => return call(letter, view),
        CallCode::CallLabel => match letter {
            b'P' => "N number at which the call begins",
            b'L' => "how often it runs",
            _ => return None,
        },
        CallCode::Return => match letter {
            b'P' => "N number in the calling program where it continues",
            _ => return None,
        },
        CallCode::MacroCall | CallCode::ModalMacroCall { .. } => match letter {
            b'P' => "number of the macro program",
            b'L' => "how often it runs",
            _ => "argument: a local variable of the macro",
        },
        CallCode::SubroutineEnd => return None,
    };
    Some(text.into())
}

/// `P1 is 0.001 s, P1. is 1 s`.
pub fn dwell_text(word: DwellWord) -> String {
    let (letter, whole, point) = (char::from(word.letter), word.integer_s, word.point_s);
    if !word.takes_point {
        format!("{letter}1 is {whole} s; a point is an alarm")
    } else if whole == point {
        format!("{letter}1 is {whole} s, with a point or without")
    } else {
        format!("{letter}1 is {whole} s, {letter}1. is {point} s")
    }
}

fn dwell(letter: u8, view: &ControlView) -> Option<String> {
    let word = view.table.dwell_words(&view.parameters).find(|word| word.letter == letter)?;
    Some(format!("time: {}", dwell_text(word)))
}

/// I, J and K: centre of an arc along X, Y or Z.
fn center(letter: u8, view: &ControlView) -> Option<String> {
    let axis = match letter {
        b'I' => 'X',
        b'J' => 'Y',
        _ => 'Z',
    };
    Some(match view.parameters.rules.arc.arc_center {
        ArcCenter::FromStart => format!("from the start of the arc to its centre, along {axis}"),
        ArcCenter::Absolute => format!("{axis} of the centre"),
        ArcCenter::FromCenter => format!("from the centre to the start of the arc, along {axis}"),
    })
}

fn arc(letter: u8, view: &ControlView) -> Option<String> {
    let form = view.parameters.rules.arc.spiral;
    let text = match (letter, form) {
        (b'I' | b'J' | b'K', SpiralForm::IncrementHeightCount) => {
            return center(letter, view).map(|center| {
                format!("{center}; of the axis that is not in the plane the rise of a spiral in one turn")
            });
        }
        (b'I' | b'J' | b'K', _) => return center(letter, view),
        (b'R', _) => "radius; negative for an arc of more than half a turn",
        (b'P', _) => match view.table.arc_turns {
            ArcTurns::None => return None,
            ArcTurns::Extra => "full turns in addition to the arc's own",
            ArcTurns::BeyondAngle => {
                "full turns in addition to the angle from start to end; all turns of a full circle"
            }
            ArcTurns::Total => "all turns, the arc's own counted as one",
        },
        (b'Q', SpiralForm::IncrementCount) => {
            "spiral: change of the radius in one turn, with its sign"
        }
        (b'Q', SpiralForm::IncrementHeightCount) => "spiral: change of the radius in one turn",
        (b'L', SpiralForm::IncrementCount | SpiralForm::IncrementHeightCount) => {
            "spiral: number of turns, a part of a turn counted as one"
        }
        (b'Q' | b'L', SpiralForm::Pitches | SpiralForm::None) => return None,
        _ => return None,
    };
    Some(text.into())
}

fn call(letter: u8, view: &ControlView) -> Option<String> {
    let text = match letter {
        b'P' if view.parameters.packed_calls => {
            "program number; with more than four digits the repeats come first: P51000 runs O1000 five times"
        }
        b'P' => "program number",
        b'L' => "how often it runs",
        b'Q' if view.parameters.calls_counted_by_q => "the same, where there is no L",
        _ if view.table.call_start_label == Some(letter) => {
            "N number at which the subprogram begins"
        }
        _ => return None,
    };
    Some(text.into())
}

fn set_data(letter: u8, view: &ControlView) -> Option<String> {
    let targets = view.table.set_data;
    let writes = |desired: DataTarget| targets.iter().any(|(_, target)| *target == desired);
    let name = char::from(letter);
    let text = match letter {
        b'L' => "number of what is written",
        b'P' => "number of the work offset or of the tool",
        b'R' if writes(DataTarget::ToolTable) => "radius of the tool",
        b'R' => "value of the tool offset or of the register",
        b'X' | b'Y' | b'Z' | b'A' | b'B' | b'C' if view.table.axis_letters.contains(name) => {
            "value of the work offset along this axis"
        }
        _ => return None,
    };
    Some(text.into())
}

fn holes(pattern: HolePattern, letter: u8) -> Option<String> {
    let text = match (pattern, letter) {
        (HolePattern::Circle | HolePattern::Arc, b'I') => "radius of the circle",
        (HolePattern::Circle | HolePattern::Arc, b'J') => {
            "angle of the first hole, from X+ counter-clockwise"
        }
        (HolePattern::Arc, b'K') => "angle from one hole to the next",
        (HolePattern::Line, b'I') => "distance from one hole to the next",
        (HolePattern::Line, b'J') => "angle of the line, from X+ counter-clockwise",
        (_, b'L') => "number of holes",
        _ => return None,
    };
    Some(text.into())
}

fn cycle(kind: CycleKind, letter: u8, view: &ControlView) -> Option<String> {
    let rules = &view.parameters.rules.cycles;
    let text = match letter {
        b'R' if view.table.lexicon.registers => "R level, written R0+…: where feeding begins",
        b'R' if rules.r_from_initial => "distance from where the tool is to where feeding begins",
        b'R' if rules.axis == DrillingAxis::OfCode => "R level: where feeding begins",
        b'R' => "R level: where feeding begins, and to where G99 returns",
        _ if letter == rules.repeat_letter => "number of holes; in G91 each is one step further",
        b'E' if throws_chips(kind) => {
            "speed at which the spindle throws off the chips after the hole"
        }
        b'P' => return time(kind, rules),
        b'Q' => return q(kind, rules),
        b'I' | b'J' | b'K' => return vector(kind, letter, rules),
        _ => return None,
    };
    Some(text.into())
}

/// The cycles after which a Haas turns the spindle for the chips.
const fn throws_chips(kind: CycleKind) -> bool {
    matches!(kind, CycleKind::Drill | CycleKind::DrillDwell | CycleKind::Peck | CycleKind::Tap)
}

fn time(kind: CycleKind, rules: &CycleRules) -> Option<String> {
    let text = match kind {
        CycleKind::ChipBreak if rules.peck.p_is_lift => "lift after each peck",
        CycleKind::Peck if rules.peck.p_is_clearance => "clearance above the last peck",
        CycleKind::ChipBreak | CycleKind::Peck => match rules.peck.dwell {
            PeckDwell::None => return None,
            PeckDwell::EachPeck if kind == CycleKind::ChipBreak => {
                "dwell at the bottom of each peck"
            }
            PeckDwell::EachPeck => return None,
            PeckDwell::Bottom => "dwell at the bottom of the hole",
        },
        CycleKind::Drill | CycleKind::BoreFeedOut | CycleKind::BoreInOut => return None,
        _ => "dwell at the bottom of the hole",
    };
    let unit = |seconds: f64| if seconds == 1.0 { "1 s" } else { "0.001 s" };
    let (whole, point) = (rules.dwell_integer_s, rules.dwell_point_s);
    Some(match text.starts_with("dwell") {
        false => text.into(),
        true if whole == point => format!("{text}; P1 is {}", unit(whole)),
        true => format!("{text}; P1 is {}, P1. is {}", unit(whole), unit(point)),
    })
}

fn q(kind: CycleKind, rules: &CycleRules) -> Option<String> {
    let text = match kind {
        CycleKind::ChipBreak | CycleKind::Peck => "depth of each peck",
        _ if kind.is_tap() && rules.tap.feed == TapFeed::SpeedWithLeadQ => "lead of the thread",
        _ if kind.is_tap() && rules.tap.pecks_by_q => "depth of each peck of the tap",
        CycleKind::FineBore => match rules.bore.shift {
            ShiftWords::Vector => return None,
            _ => "how far the tool steps away from the wall before it goes out",
        },
        CycleKind::BackBore if rules.bore.back != BackBore::UpAndDown => match rules.bore.shift {
            ShiftWords::Vector => return None,
            _ => "how far the tool steps aside on its way past the bore",
        },
        _ => return None,
    };
    Some(text.into())
}

fn vector(kind: CycleKind, letter: u8, rules: &CycleRules) -> Option<String> {
    let pecks = kind.is_peck() && rules.peck.decreasing;
    let shifts = matches!(kind, CycleKind::FineBore | CycleKind::BackBore)
        && rules.bore.shift != ShiftWords::Q;
    let text = match letter {
        b'I' if pecks => "depth of the first peck, in place of Q",
        b'J' if pecks => "reduction of each further peck",
        b'K' if kind == CycleKind::ChipBreak && rules.peck.return_after_k => {
            "with I: smallest peck; with Q: depth after which the tool returns to R"
        }
        b'K' if pecks => "smallest peck",
        b'J' if kind.is_tap() && rules.tap.out_factor_by_j => {
            "speed of the way out, as a multiple of the way in"
        }
        b'K' if kind == CycleKind::BackBore && rules.bore.back == BackBore::UpAndDown => {
            "top of the bore"
        }
        b'I' | b'J' if kind == CycleKind::BackBore && rules.bore.back == BackBore::UpAndDown => {
            "how far the tool steps aside on its way past the bore"
        }
        b'I' | b'J' | b'K' if shifts => "how far the tool steps away from the wall, as a vector",
        _ => return None,
    };
    Some(text.into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::meaning::codes;

    /// What a letter means with a G code (ten times its number) on a control.
    fn says(control: &str, code: u16, letter: u8) -> Option<String> {
        let view = ControlView::all().into_iter().find(|view| view.table.name == control).unwrap();
        let row = codes(view.table, b'G').iter().find(|row| row.code == code).unwrap();
        word_meaning(row, letter, &view)
    }

    #[test]
    fn one_letter_means_what_its_code_makes_of_it() {
        let text = |control, code, letter| says(control, code, letter).unwrap();
        assert_eq!(text("haas", 830, b'Q'), "depth of each peck");
        assert!(text("haas", 830, b'I').contains("first peck"));
        assert!(text("fanuc", 760, b'Q').contains("away from the wall"));
        assert!(text("fadal", 840, b'Q').contains("lead"));
        assert!(text("fanuc", 830, b'K').contains("number of holes"));
        assert!(text("linuxcnc", 870, b'K').contains("top of the bore"));
        assert!(text("linuxcnc", 820, b'P').contains("P1 is 1 s"));
        assert_eq!(says("fanuc", 830, b'L'), None);
        assert_eq!(says("haas", 760, b'E'), None);
    }
}
