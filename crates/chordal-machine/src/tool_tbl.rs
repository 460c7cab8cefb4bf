//! The tool table of LinuxCNC.

use std::collections::BTreeMap;

use crate::axis::Axis;
use crate::error::{ErrorSource, MachineError};
use crate::quantity::length_of_bare;
use crate::tool::Tool;

/// The file name in errors.
const NAME: &str = "tool.tbl";

/// Reads `tool.tbl` of LinuxCNC: a tool per line, words in any order, a comment after `;` (`T1 P1 X0 Z+0.511 D+0.125
/// ;1/8 end mill`). X Y Z A B C are the offsets, with Z as the length of a mill; D is the diameter, or twice the nose
/// radius, Q the tip direction. The pocket, I, J, U, V and W are checked and ignored. Every bad line is reported.
pub fn read_tool_tbl(
    text: &str,
    millimetres: bool,
) -> Result<BTreeMap<u32, Tool>, Vec<MachineError>> {
    let source = ErrorSource::new(NAME, text);
    let mut tools = BTreeMap::new();
    let mut errors = Vec::new();
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        read_line(line, at, millimetres, &source, &mut tools, &mut errors);
        at += line.len();
    }
    if errors.is_empty() { Ok(tools) } else { Err(errors) }
}

fn read_line(
    line: &str,
    at: usize,
    millimetres: bool,
    source: &ErrorSource,
    tools: &mut BTreeMap<u32, Tool>,
    errors: &mut Vec<MachineError>,
) {
    let (words, comment) = line.split_once(';').unwrap_or((line, ""));
    let comment = comment.trim();
    let mut tool =
        Tool { comment: (!comment.is_empty()).then(|| comment.to_string()), ..Tool::default() };
    let mut number = None;
    let before = errors.len();
    let mut seen = String::new();
    for (from, word) in split_words(words) {
        let span = at + from..at + from + word.len();
        let mut chars = word.chars();
        let letter = chars.next().map_or(' ', |c| c.to_ascii_uppercase());
        let value = chars.as_str();
        if seen.contains(letter) {
            let message = format!("`{letter}` appears twice in this line");
            errors.push(source.error(Some(span), message, None));
            continue;
        }
        seen.push(letter);
        match letter {
            'T' | 'P' | 'Q' => match value.parse::<u32>() {
                Ok(whole) if letter == 'T' => number = Some((whole, span)),
                // 0 is the default, which the line of a mill may have.
                Ok(tip @ 1..=9) if letter == 'Q' => tool.tip = Some(tip),
                Ok(_) => {}
                // The files of LinuxCNC have `P-1` for a tool in no pocket.
                Err(_) if letter == 'P' && value.parse::<i32>().is_ok() => {}
                Err(_) => {
                    let message = format!("`{letter}` needs a whole number, not `{value}`");
                    errors.push(source.error(Some(span), message, None));
                }
            },
            'D' | 'Z' | 'X' | 'Y' | 'A' | 'B' | 'C' | 'U' | 'V' | 'W' | 'I' | 'J' => {
                match length_of_bare(value, millimetres) {
                    Some(mm) if letter == 'D' => tool.diameter_mm = Some(mm),
                    Some(mm) => set_offset(&mut tool, letter, mm, value),
                    None => {
                        let message = format!("`{letter}` needs a number, not `{value}`");
                        errors.push(source.error(Some(span), message, None));
                    }
                }
            }
            _ => {
                let message = format!("`{word}` is not a word of a tool table");
                let help = "the words are T, P, D, X Y Z A B C U V W, I, J and Q; a comment starts with `;`";
                errors.push(source.error(Some(span), message, Some(help.to_string())));
            }
        }
    }
    if errors.len() > before || seen.is_empty() {
        return;
    }
    match number {
        None => {
            let start = words.len() - words.trim_start().len();
            let span = at + start..at + words.trim_end().len();
            let help = "start the line with the tool's number, such as `T1`".to_string();
            errors.push(source.error(Some(span), "this line names no tool", Some(help)));
        }
        Some((number, span)) if tools.contains_key(&number) => {
            let message = format!("tool {number} is already in the table");
            errors.push(source.error(Some(span), message, None));
        }
        Some((number, _)) => {
            tools.insert(number, tool);
        }
    }
}

/// Sets an offset; `mm` is a length in mm. Offsets of rotary axes are always in degrees in LinuxCNC.
fn set_offset(tool: &mut Tool, letter: char, mm: f64, number: &str) {
    let axis = u8::try_from(letter).ok().and_then(Axis::from_letter);
    let Some(axis) = axis else { return };
    let degrees = || number.parse::<f64>().ok().map(f64::to_radians);
    tool.offset[axis as usize] = if axis.is_rotary() { degrees() } else { Some(mm) };
}

/// The words between white space, each with its position.
fn split_words(text: &str) -> impl Iterator<Item = (usize, &str)> {
    text.split_whitespace().map(move |word| (word.as_ptr() as usize - text.as_ptr() as usize, word))
}
