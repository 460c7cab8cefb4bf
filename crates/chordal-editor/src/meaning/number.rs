//! What a letter with its number means where the number itself says something: L9601, R0, E1, H0.

use chordal::control::table::{FixedRoutine, LineRepeat, SubroutineForm};
use chordal::geometry::TurnDirection;

use crate::meaning::{ControlView, letter_meanings, sections};

/// Pages of numbers that name a subroutine and a count: the last two digits are the count.
const COUNTS: u32 = 100;

/// The word on each control; `None` where it is no letter with a number, or where the letter means nothing.
pub fn number_text(word: &str, views: &[ControlView]) -> Option<String> {
    let (letter, number) = parts(word)?;
    let name = format!("{}{}", char::from(letter), word.trim()[1..].trim());
    sections(&name, views, |view| {
        let own = own_meaning(letter, number, view);
        let meanings = own.into_iter().chain(letter_meanings(letter, view));
        let meanings: Vec<String> = meanings.collect();
        match meanings.as_slice() {
            [] => None,
            [one] => Some(format!(" {one}\n")),
            more => Some(format!("\n  {}\n", more.join("\n  "))),
        }
    })
}

/// `L9601` → its letter and number. G and M are codes.
fn parts(word: &str) -> Option<(u8, f64)> {
    let word = word.trim();
    let letter = word.bytes().next()?.to_ascii_uppercase();
    let number = word.get(1..)?.trim();
    let is_number = number.bytes().any(|byte| byte.is_ascii_digit())
        && number.bytes().all(|byte| byte.is_ascii_digit() || b"+-.".contains(&byte));
    let is_letter = letter.is_ascii_uppercase() && !b"GM".contains(&letter);
    (is_letter && is_number).then_some(())?;
    Some((letter, number.parse().ok()?))
}

/// What this number says.
fn own_meaning(letter: u8, number: f64, view: &ControlView) -> Option<String> {
    let whole =
        (number >= 0.0 && number.fract() == 0.0 && number < 1e9).then_some(number as u32)?;
    match letter {
        b'L' => repeats_or_calls(whole, view),
        b'R' if view.table.lexicon.registers && whole < 10 => Some(match whole {
            0 => "register R0: with its value (R0+.5) the radius of an arc, the R level of a cycle, the feed of a fixed \
                  routine"
                .into(),
            _ => format!("register R{whole}: R{whole}+1.5 gives it a value, X+R{whole} uses that"),
        }),
        b'E' if view.table.work_names.by_e => Some(match whole {
            0 => "machine coordinates: no work offset is in force".into(),
            _ => format!("work offset {whole} comes into force"),
        }),
        b'H' if whole == 0 => Some(no_length(view)),
        b'H' => Some(format!("length offset {whole}")),
        b'D' if whole == 0 => Some("a radius or diameter of zero".into()),
        b'D' => Some(format!("radius or diameter offset {whole}")),
        b'N' => Some(format!("block number {whole}")),
        b'O' => Some(format!("program {whole}")),
        _ => None,
    }
}

fn no_length(view: &ControlView) -> String {
    let rules = view.parameters.rules.length;
    match rules.zero_is_of_tool {
        true => "the length of the tool in the spindle, with G43".into(),
        false => "no length offset: that in force ends".into(),
    }
}

/// L: the count of its block, or where subroutines are named by it a call.
fn repeats_or_calls(number: u32, view: &ControlView) -> Option<String> {
    let table = view.table;
    if table.subroutines == SubroutineForm::LetterL && number >= COUNTS {
        let (called, count) = (number / COUNTS, number % COUNTS);
        let routine = table.fixed_routines.iter().find(|(own, _)| *own == called);
        if let Some((_, routine)) = routine {
            return Some(format!("fixed routine L{called}: {}", routine_text(*routine, count)));
        }
        return Some(match count {
            0 => format!("begins subroutine {called}, in the section before the main program"),
            1 => format!("calls subroutine {called} once"),
            _ => format!("calls subroutine {called} {count} times"),
        });
    }
    match (table.line_repeat, number) {
        (LineRepeat::None, _) => None,
        (_, 1) => Some("its block runs once".into()),
        (_, count) => {
            Some(format!("its block runs {count} times, where no code of the block takes L"))
        }
    }
}

fn routine_text(routine: FixedRoutine, count: u32) -> String {
    let path = |direction: TurnDirection| match direction {
        TurnDirection::Ccw => "counter-clockwise",
        TurnDirection::Cw => "clockwise",
    };
    let times = match count {
        1 => "once".to_string(),
        count => format!("{count} times"),
    };
    match routine {
        FixedRoutine::Probe => "probing; Chordal does not show it".into(),
        FixedRoutine::Engrave => "engraving; Chordal judges its words and does not show it".into(),
        FixedRoutine::BoltCircle => {
            format!("the cycle in force at {count} places on a circle about the present one")
        }
        FixedRoutine::Bore(direction) => format!("mills a bore, {}, {times}", path(direction)),
        FixedRoutine::Rectangle(direction) => {
            format!("clears a rectangular pocket, {}, {times}", path(direction))
        }
        FixedRoutine::Circle(direction) => {
            format!("clears a circular pocket, {}, {times}", path(direction))
        }
    }
}
