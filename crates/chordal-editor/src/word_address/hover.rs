//! The explanation of a word in its block, and of a name in its program.

use chordal::control::table::{CodeRow, ControlTable, code_number};
use chordal::syntax::{Block, Word, is_program_name};

use super::WordAddressText;
use super::names::{NameRole, SymbolName};
use crate::hover::{Hover, as_markdown};
use crate::meaning::{code_brief, code_name, codes, letter_text, word_meaning};

impl WordAddressText<'_> {
    /// What the word at a byte offset does on this control, and its line. `None` where neither a word nor a name is.
    pub(crate) fn hover(&self, offset: u32) -> Option<(Hover, u32)> {
        let block = self.block_at(offset)?;
        let (range, text) = match word_at(&block, offset) {
            Some(word) => (word.range, self.word_text(word, &block)),
            None => {
                let name = self.name_at(offset)?;
                (name.range, self.name_text(&name.name)?)
            }
        };
        Some((Hover { range, text }, block.line))
    }

    fn word_text(&self, word: &Word, block: &Block) -> String {
        let views = [self.view()];
        let letter = char::from(word.letter);
        let text = match code_of(word) {
            Some(code) => code_brief(word.letter, code, &views[0])
                .map(|text| text + &self.code_word_lines(word, code, block)),
            None => self.meaning_in_block(word, block),
        };
        let text = text
            .or_else(|| letter_text(word.letter, &views))
            .unwrap_or_else(|| format!("{letter} has no meaning on {}.", self.profile().title));
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
