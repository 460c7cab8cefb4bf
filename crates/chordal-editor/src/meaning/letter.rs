//! What an address letter means on a control, gathered from its table.

use chordal::control::table::{ArcTurns, CodeRow, LineRepeat, SubroutineForm, code_name};
use chordal::control::{Action, SettingField, dwell_text};

use crate::meaning::code::codes;
use crate::meaning::word::word_meaning;
use crate::meaning::{ControlView, own_value, sections, settings, some};

/// The letter on each control; `None` when it has a meaning nowhere.
pub fn letter_text(letter: u8, views: &[ControlView]) -> Option<String> {
    sections(&char::from(letter).to_string(), views, |view| {
        let mut meanings = letter_meanings(letter, view);
        if views.len() == 1 {
            meanings.extend(with_codes(letter, view));
        }
        meanings.extend(takers(letter, view));
        match meanings.as_slice() {
            [] => None,
            [one] => Some(format!(" {one}\n")),
            more => Some(format!("\n  {}\n", more.join("\n  "))),
        }
    })
}

/// What a letter means by itself on a control, whichever code stands in its block.
pub fn letter_meanings(letter: u8, view: &ControlView) -> Vec<String> {
    let ControlView { table, parameters } = view;
    let name = char::from(letter);
    let mut meanings: Vec<String> = Vec::new();
    let mut add = |text: &str| meanings.push(text.to_string());
    match letter {
        b'G' => add("chooses a preparatory code: `chordal explain G2` explains one"),
        b'M' => add("chooses a miscellaneous code: `chordal explain M3` explains one"),
        b'N' => add("the number of a block, for jumps and for the reader"),
        b'O' => add("the number of a program, at its head"),
        b'F' => add("feed"),
        b'S' => add("spindle speed"),
        b'T' => add("tool"),
        b'D' => add("number of the radius or diameter offset"),
        b'H' if parameters.length_by_h_alone => {
            add("number of the length offset; H alone makes it active");
        }
        b'H' => add("number of the length offset, with G43 or G44"),
        b'E' if table.work_names.by_e => add("chooses the work offset: E1, E2, …"),
        b'X' | b'Y' | b'Z' if table.axis_letters.contains(name) => {
            add("an axis: the end position, or the distance in incremental mode");
        }
        b'A' | b'B' | b'C' if table.axis_letters.contains(name) => {
            add("a rotary axis, in degrees");
        }
        b'I' | b'J' | b'K' => {
            for setting in settings(table, &[SettingField::ARC_CENTER]) {
                let value = own_value(setting, parameters);
                add(&format!("centre of an arc, along {}: {value}", axis_of(letter)));
            }
        }
        b'R' => {
            add("radius of an arc; negative for more than half a turn");
            if table.lexicon.registers {
                add("a register: R0+1.5 gives register R0 a value, X+R0 uses it");
            }
            if table.lexicon.registers {
                add("the R level of cycles is register R0");
            }
        }
        _ => {}
    }
    for word in table.dwell_words(parameters).filter(|word| word.letter == letter) {
        add(&format!("time of a dwell: {}", dwell_text(word)));
    }
    if letter == b'L' {
        match table.line_repeat {
            LineRepeat::None => {}
            LineRepeat::MainProgram => add("repeats its block, in the main program only"),
            LineRepeat::Anywhere => add("repeats its block"),
        }
        if table.subroutines == SubroutineForm::LetterL {
            add("alone: L100 begins subroutine 1, L203 calls subroutine 2 three times");
        }
    }
    if letter == parameters.rules.cycles.repeat_letter && letter != b'L' {
        add("repeats a cycle");
    }
    if letter == b'P' {
        match table.arc_turns {
            ArcTurns::None => {}
            ArcTurns::Extra => add("with an arc: additional full turns"),
            ArcTurns::BeyondAngle => {
                add("with an arc: additional full turns; all turns of a full circle");
            }
            ArcTurns::Total => add("with an arc: all turns, the arc itself counted as one"),
        }
        if parameters.packed_calls {
            add("with a call: repeats and program number together; P51000 is 5 times O1000");
        }
    }
    if table.call_start_label == Some(letter) {
        add("with M98: the N number at which the subprogram begins");
    }
    meanings
}

/// What the letter means next to the codes that take it, those that say the same together.
fn with_codes(letter: u8, view: &ControlView) -> Vec<String> {
    let mut meanings: Vec<(String, Vec<String>)> = Vec::new();
    for (code, row) in rows_with(letter, view) {
        let Some(meaning) = word_meaning(row, letter, view) else { continue };
        let name = code_name(code, row.code);
        match meanings.iter_mut().find(|(other, _)| *other == meaning) {
            Some((_, names)) => names.push(name),
            None => meanings.push((meaning, vec![name])),
        }
    }
    meanings
        .into_iter()
        .map(|(meaning, names)| format!("with {}: {meaning}", some(&names)))
        .collect()
}

/// The rows of codes that take the letter.
fn rows_with(letter: u8, view: &ControlView) -> impl Iterator<Item = (u8, &'static CodeRow)> {
    let table = view.table;
    [b'G', b'M']
        .into_iter()
        .flat_map(move |code| codes(table, code).iter().map(move |row| (code, row)))
        .filter(move |(_, row)| row.words.has(letter))
        .filter(|(_, row)| !row.action.is_left_out() || row.action == Action::NoEffect)
}

/// The codes that take the letter.
fn takers(letter: u8, view: &ControlView) -> Option<String> {
    let takers: Vec<String> =
        rows_with(letter, view).map(|(code, row)| code_name(code, row.code)).collect();
    (!takers.is_empty()).then(|| format!("taken by {}", some(&takers)))
}

fn axis_of(letter: u8) -> char {
    match letter {
        b'I' => 'X',
        b'J' => 'Y',
        _ => 'Z',
    }
}
