//! The explanation of a word in its block, and of a name in its program.

use chordal::Diagnostic;
use chordal::control::FeedMode;
use chordal::control::table::{CodeRow, ControlTable, code_number};
use chordal::control::{Modal, SpindleState, Units, number_text};
use chordal::diagnostics::TextRange;
use chordal::machine::AXIS_NAMES;
use chordal::syntax::{Block, Word, is_program_name};

use crate::meaning::{code_brief, code_name, codes, letter_text, word_meaning};
use crate::names::{NameRole, SymbolName};
use crate::{EditorProgram, RunMoves};

/// The index of the first rotary axis: A, B and C come after X, Y and Z.
const FIRST_ROTARY_AXIS: usize = 3;

/// The text shown when the pointer rests on a word or a name.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Hover {
    /// The bytes of the text that it explains.
    pub range: TextRange,
    /// The explanation as Markdown.
    pub text: String,
}

impl EditorProgram {
    /// What the word at a byte offset does on this control and, with the moves of a run, how far and how long its line
    /// moved. `None` where neither a word nor a name is.
    pub fn hover(&self, offset: u32, run_moves: Option<&RunMoves>) -> Option<Hover> {
        let block = self.block_at(offset)?;
        let word = word_at(&block, offset);
        let (range, mut text) = match word {
            Some(word) => (word.range, self.word_text(word, &block)),
            None => {
                let name = self.name_at(offset)?;
                (name.range, self.name_text(&name.name)?)
            }
        };
        let moves = run_moves.and_then(|run| Some((run.line(block.line)?, run.units())));
        if let Some((moves, units)) = moves {
            let pieces = if moves.pieces > 1 {
                format!(" in {} pieces", moves.pieces)
            } else {
                String::new()
            };
            let length = units.length_text(moves.length_mm);
            let seconds = number_text(moves.seconds, 2);
            text.push_str(&format!("\n\nThis line moves {length}{pieces}, {seconds} s."));
        }
        Some(Hover { range, text })
    }

    fn word_text(&self, word: &Word, block: &Block) -> String {
        let views = [self.view()];
        let letter = char::from(word.letter);
        let text = match code_of(word) {
            Some(code) => code_brief(word.letter, code, &views[0])
                .map(|text| text + &self.code_word_lines(word, code, block)),
            None => self.meaning_in_block(word, block),
        };
        let text = text.or_else(|| letter_text(word.letter, &views)).unwrap_or_else(|| {
            format!("{letter} has no meaning on {}.", self.control().table.title)
        });
        as_markdown(&text)
    }

    /// A line for each word that a code of the block takes: the source text of the word and its meaning.
    fn code_word_lines(&self, code_word: &Word, code: u16, block: &Block) -> String {
        let view = self.view();
        let Some(row) = row_of(view.table, code_word.letter, code) else { return String::new() };
        let lines = block.words.iter().filter_map(|word| {
            let is_accepted = row.words.has(word.letter) && word.letter != code_word.letter;
            let meaning = is_accepted.then(|| word_meaning(row, word.letter, &view)).flatten()?;
            Some(format!("  {:10}{meaning}\n", self.source_text(word)))
        });
        lines.collect()
    }

    /// What a word means to a code of its block: `Q5. in G83: depth of each peck`.
    fn meaning_in_block(&self, word: &Word, block: &Block) -> Option<String> {
        let view = self.view();
        let lines = block.words.iter().filter_map(|code_word| {
            let row = row_of(view.table, code_word.letter, code_of(code_word)?)?;
            let meaning = row.words.has(word.letter).then(|| word_meaning(row, word.letter, &view));
            let name = code_name(code_word.letter, row.code);
            Some(format!("{} in {name}: {}\n", self.source_text(word), meaning.flatten()?))
        });
        let text: String = lines.collect();
        (!text.is_empty()).then_some(text)
    }

    /// The source text of a word, trimmed.
    fn source_text(&self, word: &Word) -> String {
        String::from_utf8_lossy(word.range.slice(self.text())).trim().to_string()
    }

    fn name_text(&self, name: &SymbolName) -> Option<String> {
        let places = self.places_of(name);
        let definition_lines: Vec<u32> = places
            .iter()
            .filter(|place| place.role == NameRole::Definition)
            .map(|place| self.source().line_of(place.range.start))
            .collect();
        let (what, verb) = match name {
            SymbolName::Program(number) if is_program_name(*number) => {
                let place = places.first()?;
                let name = place.range.slice(self.source().text());
                (format!("Program {}", String::from_utf8_lossy(name)), "begins")
            }
            SymbolName::Program(number) => (format!("Program O{number}"), "begins"),
            SymbolName::Subroutine(label) => (format!("Subroutine o{label}"), "is made"),
            SymbolName::Label { number, .. } => (format!("Block N{number}"), "stands"),
            SymbolName::LineLabel(label) => (format!("Label :{label}"), "stands"),
            SymbolName::Variable { name, .. } => (format!("Variable `{name}`"), "gets a value"),
        };
        let lines = line_list(&definition_lines);
        let uses = places.len() - definition_lines.len();
        Some(match definition_lines.len() {
            0 => format!("{what}: not set in this text; used {uses} times."),
            _ => format!("{what} {verb} on {lines}; used {uses} times."),
        })
    }

    /// The state after a line as a control's screen shows it, in the program's units.
    pub fn modal_text(&self, modal: &Modal) -> String {
        let mut lines = vec![modal.codes.join(" ")];
        let coordinate_text = |axis: usize| {
            let letter = AXIS_NAMES[axis];
            if !modal.known.has(axis) {
                return format!("{letter}?");
            }
            let value = modal.position[axis];
            let shown = match (axis, modal.units) {
                (FIRST_ROTARY_AXIS.., _) => number_text(value.to_degrees(), 3),
                (_, Units::Inch) => number_text(value / modal.units.mm(), 4),
                (_, Units::Millimetre) => number_text(value, 3),
            };
            format!("{letter}{shown}")
        };
        let axes = self.machine().axes.iter().enumerate().filter(|(_, axis)| axis.is_some());
        let coordinates: Vec<String> = axes.map(|(axis, _)| coordinate_text(axis)).collect();
        lines.push(format!("{} in {}", coordinates.join(" "), modal.work_name));
        let mut details = Vec::new();
        details.extend(modal.feed.map(|feed| feed_text(feed, modal)));
        if let Some(live) = modal.live {
            let direction =
                if live.turns == SpindleState::Ccw { "counter-clockwise" } else { "clockwise" };
            details.push(format!("live tool {} rpm {direction}", number_text(live.rpm, 1)));
        }
        match modal.spindle {
            SpindleState::Off => {}
            SpindleState::Cw => details.push(format!("S{} clockwise", number_text(modal.rpm, 1))),
            SpindleState::Ccw => {
                details.push(format!("S{} counter-clockwise", number_text(modal.rpm, 1)));
            }
            SpindleState::Oriented => details.push("spindle oriented".into()),
        }
        if modal.tool > 0 {
            details.push(format!("T{}", modal.tool));
        }
        details.extend(modal.length_offset.map(|number| format!("H{number}")));
        details.extend(modal.radius_offset.map(|number| format!("D{number}")));
        if !details.is_empty() {
            lines.push(details.join(", "));
        }
        lines.join("\n")
    }
}

/// The text of a feed, which is in mm/s, in 1/s (inverse time: one divided by the time of the move) or in mm per
/// revolution, by the feed mode.
fn feed_text(feed: f64, modal: &Modal) -> String {
    match (modal.feed_mode, modal.units) {
        (FeedMode::PerTime, Units::Inch) => {
            format!("F {} in/min", number_text(feed / modal.units.mm() * 60.0, 2))
        }
        (FeedMode::PerTime, Units::Millimetre) => {
            format!("F {} mm/min", number_text(feed * 60.0, 1))
        }
        (FeedMode::InverseTime, _) => format!("F {} 1/min", number_text(feed * 60.0, 3)),
        (FeedMode::PerRevolution, Units::Inch) => {
            format!("F {} in/rev", number_text(feed / modal.units.mm(), 4))
        }
        (FeedMode::PerRevolution, Units::Millimetre) => {
            format!("F {} mm/rev", number_text(feed, 3))
        }
    }
}

/// The code of a G or M word, ten times its number: 434 for `G43.4`. `None` for other words.
fn code_of(word: &Word) -> Option<u16> {
    word.number().and_then(code_number).filter(|_| matches!(word.letter, b'G' | b'M'))
}

fn row_of(table: &ControlTable, letter: u8, code: u16) -> Option<&'static CodeRow> {
    codes(table, letter).iter().find(|row| row.code == code)
}

/// `line 3`, `lines 3, 5 and 9`; beyond eight lines the first eight and the count.
fn line_list(lines: &[u32]) -> String {
    const MAX_HOVER_LINES: usize = 8;
    let shown: Vec<String> = lines.iter().take(MAX_HOVER_LINES).map(u32::to_string).collect();
    match shown.as_slice() {
        [] => String::new(),
        [one] => format!("line {one}"),
        [first @ .., last] if lines.len() <= MAX_HOVER_LINES => {
            format!("lines {} and {last}", first.join(", "))
        }
        first => format!("lines {} … ({} in all)", first.join(", "), lines.len()),
    }
}

/// The word at a byte offset; where one word ends and the next begins, the next.
pub(crate) fn word_at(block: &Block, offset: u32) -> Option<&Word> {
    let touches = |word: &&Word| word.range.start <= offset && offset <= word.range.end;
    block.words.iter().filter(touches).max_by_key(|word| word.range.start)
}

/// Markdown of an explanation: the first line bold, the rest as a code block, so that its columns line up.
fn as_markdown(text: &str) -> String {
    let text = text.trim_end();
    match text.split_once('\n') {
        None => format!("**{text}**"),
        Some((first, rest)) if rest.trim().is_empty() => format!("**{first}**"),
        Some((first, rest)) => format!("**{}**\n```text\n{rest}\n```", first.trim_end()),
    }
}

/// A diagnostic as markdown: message, alarm, notes and help.
pub fn diagnostic_markdown(diagnostic: &Diagnostic) -> String {
    let info = diagnostic.code.info();
    let mut text = format!("**{}** ({} {})", diagnostic.message, info.id, info.name);
    if let Some(alarm) = &diagnostic.alarm {
        text.push_str(&format!("\n\nThe control shows: {alarm}"));
    }
    for note in &diagnostic.notes {
        text.push_str(&format!("\n\n{note}"));
    }
    if let Some(help) = &diagnostic.help {
        text.push_str(&format!("\n\nHelp: {help}"));
    }
    text
}
