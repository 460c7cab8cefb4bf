//! Meanings of words that depend on the rules and the table of a control.

use chordal_kernel::rules::{ArcCenter, SpiralForm};

use super::{WordMeanings, cycle, turn_facts};
use crate::parameters::Parameters;
use crate::table::{ArcTurns, ControlTable, DataTarget, DwellWord};

/// What a letter means; `None` where it has no effect on the path, or where no meaning is on record.
pub(super) fn meaning(
    words: WordMeanings,
    letter: u8,
    table: &ControlTable,
    parameters: &Parameters,
) -> Option<String> {
    let row_meaning = |rows: &[(&str, &'static str)]| {
        let has = |letters: &str| letters.is_empty() || letters.contains(char::from(letter));
        rows.iter().find(|(letters, _)| has(letters)).map(|(_, meaning)| *meaning)
    };
    let text = match words {
        WordMeanings::Rows(rows) => row_meaning(rows)?,
        WordMeanings::Turning(cycle) => turn_facts(cycle).meaning(letter)?,
        WordMeanings::Cycle(kind) => return cycle::meaning(kind, letter, table, parameters),
        WordMeanings::Data => data_meaning(letter, table)?,
        WordMeanings::Call => call_meaning(letter, table, parameters)?,
        WordMeanings::Arc => return arc_meaning(letter, table, parameters),
        WordMeanings::Spiral => match letter {
            b'P' => "whole turns beyond the angle from start to end, 0 to 99",
            b'I' | b'J' | b'K' => return Some(center_meaning(letter, parameters)),
            _ => return None,
        },
        WordMeanings::Dwell => {
            let word = table.dwell_words(parameters).find(|word| word.letter == letter)?;
            return Some(format!("time: {}", dwell_text(word)));
        }
        WordMeanings::LookAhead { letter: code_letter, on } => {
            let values = on.iter().map(u32::to_string).collect::<Vec<_>>().join(" or ");
            return (code_letter == letter)
                .then(|| format!("{values} switches look-ahead on, 0 off"));
        }
    };
    Some(text.into())
}

/// How long a dwell is with and without a decimal point: `P1 is 0.001 s, P1. is 1 s`.
pub fn dwell_text(word: DwellWord) -> String {
    let DwellWord { integer_s, point_s, takes_point, .. } = word;
    let letter = char::from(word.letter);
    if !takes_point {
        format!("{letter}1 is {integer_s} s; a point is an alarm")
    } else if integer_s == point_s {
        format!("{letter}1 is {integer_s} s, with a point or without")
    } else {
        format!("{letter}1 is {integer_s} s, {letter}1. is {point_s} s")
    }
}

/// I, J and K: centre of an arc along X, Y or Z.
fn center_meaning(letter: u8, parameters: &Parameters) -> String {
    let axis = match letter {
        b'I' => 'X',
        b'J' => 'Y',
        _ => 'Z',
    };
    match parameters.rules.arc.arc_center {
        ArcCenter::FromStart => format!("from the start of the arc to its centre, along {axis}"),
        ArcCenter::Absolute => format!("{axis} of the centre"),
        ArcCenter::FromCenter => format!("from the centre to the start of the arc, along {axis}"),
    }
}

fn arc_meaning(letter: u8, table: &ControlTable, parameters: &Parameters) -> Option<String> {
    let text = match (letter, parameters.rules.arc.spiral) {
        (b'I' | b'J' | b'K', SpiralForm::IncrementHeightCount) => {
            let center = center_meaning(letter, parameters);
            return Some(format!(
                "{center}; of the axis that is not in the plane the rise of a spiral in one turn"
            ));
        }
        (b'I' | b'J' | b'K', _) => return Some(center_meaning(letter, parameters)),
        (b'R', _) => "radius; negative for an arc of more than half a turn",
        (b'P', _) => match table.arc_turns {
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
        _ => return None,
    };
    Some(text.into())
}

fn call_meaning(letter: u8, table: &ControlTable, parameters: &Parameters) -> Option<&'static str> {
    Some(match letter {
        b'P' if parameters.packed_calls => {
            "program number; with more than four digits the repeats come first: P51000 runs O1000 five times"
        }
        b'P' => "program number",
        b'L' => "how often it runs",
        b'Q' if parameters.calls_counted_by_q => "the same, where there is no L",
        _ if table.call_start_label == Some(letter) => "N number at which the subprogram begins",
        _ => return None,
    })
}

fn data_meaning(letter: u8, table: &ControlTable) -> Option<&'static str> {
    let writes_tools = table.set_data.iter().any(|(_, target)| *target == DataTarget::ToolTable);
    Some(match letter {
        b'L' => "number of what is written",
        b'P' => "number of the work offset or of the tool",
        b'R' if writes_tools => "radius of the tool",
        b'R' => "value of the tool offset or of the register",
        b'X' | b'Y' | b'Z' | b'A' | b'B' | b'C'
            if table.axis_letters.contains(char::from(letter)) =>
        {
            "value of the work offset along this axis"
        }
        _ => return None,
    })
}
