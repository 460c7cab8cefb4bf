//! How a code is written: an example that runs on its control, and what each of its words means.

use chordal::control::table::{CodeRow, DataTarget, code_name};
use chordal::control::{
    Action, BackBore, CycleFamily, CycleKind, DrillingAxis, MotionCode, OnceCode, TapFeed,
    WordMeanings,
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
    if let Some(kind) = row.action.cycle() {
        return Some(format!("{code} {}", of_cycle(kind, row, view)));
    }
    let facts = row.action.facts(view.table, &view.parameters);
    let form = match facts.words {
        WordMeanings::Dwell => of_dwell(view)?,
        WordMeanings::Data => of_data(view)?,
        _ => facts.example.to_string(),
    };
    (!form.is_empty()).then(|| form.replace("{}", &code))
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

fn of_dwell(view: &ControlView) -> Option<String> {
    let word = view.table.dwell_words(&view.parameters).next()?;
    let (letter, point) = (char::from(word.letter), word.takes_point);
    let second = 1.0 / word.unit_s(point);
    Some(format!("{{}} {letter}{second}{}", if point { "." } else { "" }))
}

fn of_data(view: &ControlView) -> Option<String> {
    let work = |target: &DataTarget| *target == DataTarget::WorkOffset;
    let (number, _) = view.table.set_data.iter().find(|(_, target)| work(target))?;
    Some(format!("{{}} L{number} P1 X-300. Y-200. Z0"))
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
    let upward = kind.family() == CycleFamily::BackBore && cycles.bore.back == BackBore::UpAndDown;
    for (needed, letter, word) in [
        (kind.is_peck(), 'Q', " Q5."),
        (kind.dwells() && !kind.is_tap(), 'P', " P500"),
        (kind.steps_aside(), 'Q', " Q0.5"),
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
