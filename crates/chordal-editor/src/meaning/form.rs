//! How a code is written: an example that runs on its control, and what each of its words means.

use chordal::control::table::{CodeRow, DataTarget, code_name};
use chordal::control::{
    Action, BackBore, BeforeCode, CallCode, CycleKind, DrillingAxis, LengthCode, ModeCode,
    MotionCode, OnceCode, TapFeed, TurnCycle, TurnPass,
};
use chordal::geometry::Plane;

use crate::meaning::{ControlView, word_meaning};

/// A block with the code as a program would have it, in millimetres, that runs without an error on the
/// control. None for codes that stand alone, and for those that need more than a block.
pub fn example(letter: u8, row: &CodeRow, view: &ControlView) -> Option<String> {
    let code = code_name(letter, row.code);
    let turns = !view.parameters.increments.is_empty();
    // A lathe whose words are those of its mills, but for the plane.
    let in_zx = view.parameters.rules.starts_in == Plane::Zx;
    let drills = row.action.cycle().is_some();
    if in_zx && !turns && drills {
        return None;
    }
    let plain = |action: Action| {
        action.is_plain_motion()
            || action == Action::Once(OnceCode::SetData)
            || action == Action::Once(OnceCode::LocalShift)
    };
    let fits = turns || in_zx && plain(row.action);
    if let Some(words) = of_lathe(row.action).filter(|_| fits) {
        return Some(format!("{code} {words}"));
    }
    let (before, after) = match row.action {
        Action::Motion(motion) => (None, of_motion(motion)?.to_string()),
        Action::Mode(mode) => of_mode(mode).map(|(before, after)| (before, after.to_string()))?,
        Action::Length(LengthCode::Plus | LengthCode::Minus) => (None, "H1 Z30.".into()),
        Action::Cycle(kind) => (None, of_cycle(kind, row, view)),
        Action::Once(once) => (None, of_once(once, view)?),
        Action::Call(call) => (None, of_call(call)?.to_string()),
        Action::Before(BeforeCode::ToolChange) => (Some("T2"), String::new()),
        // The code begins the line.
        Action::Before(BeforeCode::SpindleCw | BeforeCode::SpindleCcw)
            if view.table.command_line.is_some() =>
        {
            (None, "S1000".into())
        }
        Action::Before(BeforeCode::SpindleCw | BeforeCode::SpindleCcw) => {
            (Some("S1000"), String::new())
        }
        Action::Before(BeforeCode::LiveToolCw | BeforeCode::LiveToolCcw) => (None, "P1500".into()),
        Action::Length(_)
        | Action::Before(_)
        | Action::Reading(_)
        | Action::After(_)
        | Action::NoEffect
        | Action::NotSimulated
        | Action::NotFollowed => return None,
    };
    let parts = [before.unwrap_or_default(), code.as_str(), after.as_str()];
    Some(parts.into_iter().filter(|part| !part.is_empty()).collect::<Vec<_>>().join(" "))
}

/// What stands after a code on a lathe, where that is not what a mill has; X is a diameter.
fn of_lathe(action: Action) -> Option<&'static str> {
    const WORDS: [(Action, &str); 9] = [
        (Action::Motion(MotionCode::Rapid), "X66. Z5."),
        (Action::Motion(MotionCode::Linear), "X60. Z-20. F0.2"),
        (Action::Motion(MotionCode::ArcCw), "X76. Z0 R5. F0.2"),
        (Action::Motion(MotionCode::ArcCcw), "X76. Z0 R5. F0.2"),
        (Action::Motion(MotionCode::Thread), "Z-20. F2."),
        (Action::Once(OnceCode::SetData), "L2 P1 X-300. Z-200."),
        (Action::Once(OnceCode::ReturnToReference { second: false }), "U0 W0"),
        (Action::Once(OnceCode::PresetPosition), "S3000"),
        (Action::Once(OnceCode::LocalShift), "X10. Z10."),
    ];
    WORDS.iter().find(|(own, _)| *own == action).map(|(_, words)| *words)
}

fn of_motion(motion: MotionCode) -> Option<&'static str> {
    Some(match motion {
        MotionCode::Rapid => "X10. Y10.",
        MotionCode::Linear => "X10. Y10. F200.",
        MotionCode::ArcCw => "X10. Y10. I10. J0 F200.",
        MotionCode::ArcCcw => "X10. Y10. I0 J10. F200.",
        MotionCode::Thread | MotionCode::RigidTap => "Z-12. K1.",
        MotionCode::Turn(TurnPass::Turning) => "X50. Z-30. F0.25",
        MotionCode::Turn(TurnPass::Facing) => "X20. Z-2. F0.2",
        MotionCode::Turn(TurnPass::Thread) => "X23.2 Z-25. F3.",
        MotionCode::SpiralCw
        | MotionCode::SpiralCcw
        | MotionCode::Spline(_)
        | MotionCode::SplineEnd => return None,
    })
}

/// What stands before and after the code of a mode.
fn of_mode(mode: ModeCode) -> Option<(Option<&'static str>, &'static str)> {
    match mode {
        ModeCode::CompensationLeft | ModeCode::CompensationRight => {
            Some((Some("G1"), "D1 X20. F200."))
        }
        ModeCode::CompensationOff => Some((Some("G1"), "X20. F200.")),
        ModeCode::WorkOffsetExtended => Some((None, "P1")),
        ModeCode::WorkOffsetCounted => Some((None, "P7")),
        ModeCode::PlaneXy
        | ModeCode::PlaneZx
        | ModeCode::PlaneYz
        | ModeCode::CornerArc
        | ModeCode::WorkOffset(_)
        | ModeCode::WorkOffsetPoint(_)
        | ModeCode::StoreReference { .. }
        | ModeCode::CompensationLeftBy
        | ModeCode::CompensationRightBy
        | ModeCode::WorkOffsetNumbered(_)
        | ModeCode::ReturnInitial
        | ModeCode::ReturnToR
        | ModeCode::CancelCycle
        | ModeCode::Path(_)
        | ModeCode::Overrides { .. }
        | ModeCode::OverridesByP
        | ModeCode::RotationOff
        | ModeCode::ScalingOff
        | ModeCode::Polar { .. }
        | ModeCode::ModalSubroutine
        | ModeCode::ModalCallOff
        | ModeCode::ThreadExit { .. }
        | ModeCode::DataLinesOff => None,
    }
}

fn of_call(call: CallCode) -> Option<&'static str> {
    Some(match call {
        CallCode::CallProgram => "P1000",
        CallCode::CallLabel => "P100",
        CallCode::MacroCall => "P1000 A1. B2.",
        CallCode::Return | CallCode::SubroutineEnd | CallCode::ModalMacroCall { .. } => {
            return None;
        }
    })
}

fn of_once(once: OnceCode, view: &ControlView) -> Option<String> {
    Some(match once {
        OnceCode::Dwell => {
            let word = view.table.dwell_words(&view.parameters).next()?;
            let (letter, point) = (char::from(word.letter), word.takes_point);
            let second = 1.0 / word.unit_s(point);
            format!("{letter}{second}{}", if point { "." } else { "" })
        }
        OnceCode::SetData => {
            let work = |target: &DataTarget| *target == DataTarget::WorkOffset;
            let (number, _) = view.table.set_data.iter().find(|(_, target)| work(target))?;
            format!("L{number} P1 X-300. Y-200. Z0")
        }
        OnceCode::Turning(TurnCycle::PeckZ) => "Z-40. Q12000 F0.15".into(),
        OnceCode::Turning(TurnCycle::PeckX) => "X40. Z-30. P3000 Q2500 F0.1".into(),
        OnceCode::Turning(TurnCycle::Thread) => "X20.376 Z-25. P1812 Q500 F3.".into(),
        OnceCode::Turning(TurnCycle::LineThread) => "P1.5 Z-20. I-1. J0.2 K0.92".into(),
        // The contour stands in blocks of its own.
        OnceCode::Turning(_) => return None,
        OnceCode::Rotation if view.parameters.rules.frames.rotation_center_by_ab => {
            "A0 B0 R30.".into()
        }
        OnceCode::Rotation => "X0 Y0 R30.".into(),
        OnceCode::ReturnToReference { second: false } => "Z30.".into(),
        OnceCode::Home => "X Y".into(),
        OnceCode::MachineCoordinates => "Z0".into(),
        OnceCode::LocalShift => "X10. Y10.".into(),
        OnceCode::PresetPosition | OnceCode::Mirror { .. } => "X0".into(),
        OnceCode::CircularPocketCw | OnceCode::CircularPocketCcw
            if view.parameters.rules.pocket_is_one_circle =>
        {
            "I12. F200.".into()
        }
        OnceCode::CircularPocketCw | OnceCode::CircularPocketCcw => "I12. D1 F200.".into(),
        OnceCode::ReturnToReference { second: true }
        | OnceCode::ReturnFromReference
        | OnceCode::ClearPreset { .. }
        | OnceCode::RestorePreset
        | OnceCode::Scaling
        | OnceCode::MirrorOff
        | OnceCode::GeneralPocket
        | OnceCode::Engraving
        | OnceCode::Pattern(_)
        | OnceCode::Probe { .. }
        | OnceCode::Surface(_)
        | OnceCode::CornerArcAlone => return None,
    })
}

fn of_cycle(kind: CycleKind, row: &CodeRow, view: &ControlView) -> String {
    let cycles = view.parameters.rules.cycles;
    let level = if view.table.lexicon.registers { "R0+2." } else { "R2." };
    let radial = view.table.radial_cycles.contains(&row.code);
    let mut words = match (cycles.axis, radial, cycles.r_from_initial) {
        (DrillingAxis::OfCode, false, true) => "Z-12. R-2.".to_string(),
        (DrillingAxis::OfCode, false, false) => "Z-12. R2.".to_string(),
        (DrillingAxis::OfCode, true, true) => "X20. R-2.".to_string(),
        (DrillingAxis::OfCode, true, false) if !row.words.has(b'R') => "X20.".to_string(),
        (DrillingAxis::OfCode, true, false) => "X20. R32.".to_string(),
        (DrillingAxis::AlwaysZ | DrillingAxis::PlaneNormal, _, _) => {
            format!("X10. Y10. Z-12. {level}")
        }
    };
    let upward = kind == CycleKind::BackBore && cycles.bore.back == BackBore::UpAndDown;
    for (needed, letter, word) in [
        (kind.is_peck(), 'Q', " Q5."),
        (kind.dwells() && !kind.is_tap(), 'P', " P500"),
        (kind == CycleKind::FineBore || kind == CycleKind::BackBore, 'Q', " Q0.5"),
        (upward, 'K', " K-8."),
    ] {
        if needed && row.words.iter().any(|taken| taken == letter) {
            words.push_str(word);
        }
    }
    // A thread of 1 mm at 500 rpm, where the cycle taps.
    words.push_str(match cycles.tap.feed {
        _ if !kind.is_tap() => " F200.",
        TapFeed::Programmed => " F500.",
        TapFeed::Lead => " F1.",
        TapFeed::SpeedWithLeadQ => " F500. Q1.",
    });
    words
}

/// What the words of a code mean, those that mean the same together: `Q` `depth of each peck`.
pub fn word_rows(row: &CodeRow, view: &ControlView) -> Vec<(String, String)> {
    let mut rows: Vec<(String, String)> = Vec::new();
    let mut idle = String::new();
    for letter in row.words.iter() {
        match word_meaning(row, letter as u8, view) {
            None => idle.extend([letter, ' ']),
            Some(meaning) => match rows.iter_mut().find(|(_, other)| *other == meaning) {
                Some((letters, _)) => letters.extend([' ', letter]),
                None => rows.push((letter.to_string(), meaning)),
            },
        }
    }
    if !idle.is_empty() {
        rows.push((idle.trim_end().into(), "accepted, without effect by default".into()));
    }
    rows
}
