//! The kinds of differences, and how each is planted into a text.

use chordal_compare::Category::{self, *};

use super::program::Dice;

/// A kind of difference.
pub struct Kind {
    pub name: &'static str,
    /// The items of the list that it is about.
    pub categories: &'static [Category],
    how: How,
}

enum How {
    /// A word of a letter beside all that a block must hold gets another number.
    Number(char, &'static [&'static str]),
    /// A part of a block becomes another one.
    Replace(&'static str, &'static str),
    /// A block that is this, or begins with it, is left out.
    Remove(&'static str),
    /// A block is put in after one that begins with this.
    Insert(&'static str, &'static str),
    /// A block that is this changes its place with the move after it.
    Later(&'static str),
    /// Two moves change places.
    Swap,
}

const fn kind(name: &'static str, categories: &'static [Category], how: How) -> Kind {
    Kind { name, categories, how }
}

pub const KINDS: &[Kind] = &[
    kind("X of a move", &[Path], How::Number('X', &["G1 X"])),
    kind("Y of a move", &[Path], How::Number('Y', &["G1 X"])),
    kind("Z of a move", &[Path], How::Number('Z', &["G1 Z"])),
    kind("R of an arc", &[Path], How::Number('R', &["G2 "])),
    kind("direction of an arc", &[Path], How::Replace("G2 ", "G3 ")),
    kind("a cut in place of a rapid", &[Rapid], How::Replace("G0 X", "G1 X")),
    kind("a rapid in place of a cut", &[Rapid], How::Replace("G1 X", "G0 X")),
    kind("a move left out", &[Path], How::Remove("G1 X")),
    kind("a move put in", &[Path], How::Insert("G1 X", "G1 X95.5 Y99.")),
    kind("two moves in another order", &[Order, Path], How::Swap),
    kind("F", &[Feed], How::Number('F', &["G1 X"])),
    kind("S", &[Spindle], How::Number('S', &["M3"])),
    kind("direction of the spindle", &[Spindle], How::Replace("M3", "M4")),
    kind("the spindle not started", &[Spindle], How::Replace(" M3", "")),
    kind("T of a change", &[Tool], How::Number('T', &["M6"])),
    kind("a tool made ready", &[ReadyTool], How::Replace("\nT2\n", "\nT7\n")),
    kind("H", &[LengthOffset], How::Number('H', &["G43"])),
    kind("no length", &[LengthOffset], How::Replace("G43 H1 ", "")),
    kind("D", &[RadiusOffset], How::Number('D', &["G41"])),
    kind("side of compensation", &[Path], How::Replace("G41", "G42")),
    kind("work offset", &[WorkOffset], How::Replace("\nG55", "\nG56")),
    kind("value of a work offset", &[Written], How::Number('X', &["G10 L2 "])),
    kind("a work offset not written", &[Written], How::Remove("G10 L2 ")),
    kind("value of a tool", &[Written], How::Number('R', &["G10 L1"])),
    kind("a tool not written", &[Written], How::Remove("G10 L1")),
    kind("a work offset by its variable", &[Written], How::Number('=', &["#5242"])),
    kind("coolant", &[Coolant], How::Replace("\nM8\n", "\nM7\n")),
    kind("coolant not started", &[Coolant], How::Remove("M8")),
    kind("path mode", &[PathMode], How::Replace("\nG61\n", "\nG64\n")),
    kind("overrides", &[Overrides], How::Replace("\nM49\n", "\nM48\n")),
    kind("time of a dwell", &[Dwell, Time], How::Number('P', &["G4"])),
    kind("no dwell", &[Dwell, Time], How::Remove("G4")),
    kind("optional stop", &[Stop], How::Replace("\nM0\n", "\nM1\n")),
    kind("no stop", &[Stop], How::Remove("M0")),
    kind("another code", &[Code], How::Replace("\nM10\n", "\nM11\n")),
    kind("no code", &[Code], How::Remove("M10")),
    kind("word of a code", &[Code], How::Number('P', &["M62"])),
    kind("value of an output", &[Code], How::Number('Q', &["M68"])),
    kind("a code later", &[Code], How::Later("M10")),
    // No program has it, so a conversion that leaves out codes cannot have left out this one.
    kind("a code put in", &[Code], How::Insert("G1 X", "M22")),
    kind("a message", &[Message], How::Replace("TURN IT", "MEASURE IT")),
    kind("no alarm", &[NotRun, Value, Alarm], How::Replace("#3000=1(NO CLAMP)", "")),
    kind("an alarm", &[NotRun, Alarm], How::Replace("#3000=1(NO CLAMP)", "#3000=2(NO CLAMP)")),
    kind("a block that may be left out", &[BlockDelete], How::Replace("\nG1 X", "\n/G1 X")),
    kind("a block that may not be left out", &[BlockDelete], How::Replace("\n/", "\n")),
    kind("a variable read", &[Value], How::Replace("X#500", "X#501")),
    kind("an input read", &[Value], How::Replace("#1000", "#1001")),
    kind("a branch by an input", &[Value], How::Remove("IF[#1000EQ1]")),
    kind("an output", &[Variable], How::Number('=', &["#1100"])),
    kind("a variable that is kept", &[Variable], How::Number('=', &["#501"])),
    kind("a printed line put in", &[Output], How::Insert("#501", "POPEN\nDPRNT[DONE]\nPCLOS")),
];

/// The text with a difference of the kind; nothing where it has no place for it.
pub fn plant(kind: &Kind, text: &str, dice: &mut Dice) -> Option<String> {
    let lines: Vec<&str> = text.lines().collect();
    let mut pick = |is_one: &dyn Fn(usize) -> bool| -> Option<usize> {
        let found: Vec<usize> = (0..lines.len()).filter(|at| is_one(*at)).collect();
        (!found.is_empty()).then(|| found[dice.below(found.len())])
    };
    match kind.how {
        How::Number(letter, marks) => {
            let has = |at: usize| {
                marks.iter().all(|mark| lines[at].contains(mark))
                    && number_of(lines[at], letter).is_some()
            };
            let at = pick(&has)?;
            let (from, to) = number_of(lines[at], letter)?;
            let number: f64 = lines[at][from..to].parse().ok()?;
            // The radius of a flat arc moves it by little, less than what a conversion may round; rates are rounded.
            let by = match letter {
                'R' => -0.9 * number,
                'F' | 'S' => 0.2 * number,
                _ if lines[at][from..to].contains('.') => 1.5,
                _ => 1.0,
            };
            let has_point = lines[at][from..to].contains('.');
            let other = if has_point {
                format!("{}", number + by)
            } else {
                format!("{}", (number + by) as i64)
            };
            let line = format!("{}{other}{}", &lines[at][..from], &lines[at][to..]);
            Some(with(&lines, at, &[&line]))
        }
        How::Replace(old, new) => {
            let places: Vec<usize> = text.match_indices(old).map(|(at, _)| at).collect();
            let at = *places.get(dice.below(places.len()))?;
            Some(format!("{}{new}{}", &text[..at], &text[at + old.len()..]))
        }
        How::Remove(mark) => {
            let at = pick(&|at| {
                lines[at] == mark
                    || (mark.len() > 2 && lines[at].starts_with(mark))
                    || lines[at].starts_with(&format!("{mark} "))
            })?;
            Some(with(&lines, at, &[]))
        }
        How::Insert(mark, line) => {
            let at = pick(&|at| lines[at].starts_with(mark))?;
            Some(with(&lines, at, &[lines[at], line]))
        }
        How::Later(mark) => {
            let at = pick(&|at| {
                lines[at] == mark && lines.get(at + 1).is_some_and(|next| next.starts_with("G1 X"))
            })?;
            let both = [lines[at + 1], lines[at]];
            Some(with(&[&lines[..at], &lines[at + 1..]].concat(), at, &both))
        }
        How::Swap => {
            let at = pick(&|at| {
                lines[at].starts_with("X")
                    && lines.get(at + 1).is_some_and(|next| next.starts_with("G1 X"))
            })?;
            let (first, second) = (lines[at], lines[at + 1].trim_start_matches("G1 "));
            let both = [second, first];
            Some(with(&[&lines[..at], &lines[at + 1..]].concat(), at, &both))
        }
    }
}

/// Where the number of a letter stands in a line.
fn number_of(line: &str, letter: char) -> Option<(usize, usize)> {
    let code = line.split('(').next().unwrap_or("");
    let from = code.find(letter)? + 1;
    let rest = &code[from..];
    let end =
        rest.find(|c: char| !(c.is_ascii_digit() || c == '.' || c == '-')).unwrap_or(rest.len());
    (end > 0).then_some((from, from + end))
}

/// The lines with others in the place of one.
fn with(lines: &[&str], at: usize, new: &[&str]) -> String {
    let all = [&lines[..at], new, &lines[at + 1..]].concat();
    all.join("\n") + "\n"
}
