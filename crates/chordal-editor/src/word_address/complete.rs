//! What may stand next.

use chordal::control::number_text;
use chordal::control::table::code_name;
use chordal::control::{Action, CallTarget};
use chordal::syntax::Block;

use super::WordAddressText;
use super::names::SymbolName;
use crate::meaning::{code_text, codes, letter_text};

/// What a completion is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CompletionKind {
    /// A G or M code.
    Code,
    /// An address letter.
    Letter,
    /// A variable.
    Variable,
    /// A program or a label.
    Place,
    /// A tool.
    Tool,
}

/// Something that may stand at a place.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Completion {
    /// What is written.
    pub text: String,
    /// What it means in one line.
    pub detail: String,
    /// More, as text; may be empty.
    pub more: String,
    /// What it is.
    pub kind: CompletionKind,
}

impl WordAddressText<'_> {
    /// Completions at a byte, and where the text that they replace begins.
    pub(crate) fn completions(&self, offset: u32) -> (u32, Vec<Completion>) {
        let text = &self.text()[..(offset as usize).min(self.text().len())];
        let digits = |byte: &u8| byte.is_ascii_digit() || *byte == b'.';
        let number = text.iter().rev().take_while(|byte| digits(byte)).count();
        let at = text.len() - number;
        let line = self.source().line_of(offset);
        let head = at.checked_sub(1).map(|at| text[at].to_ascii_uppercase());
        let start = at.saturating_sub(1) as u32;
        match head {
            Some(letter @ (b'G' | b'M')) => (start, self.codes(letter)),
            Some(b'T') => (start, self.tools()),
            Some(b'P') => (start, self.places(line)),
            Some(b'#') => (start, self.variables()),
            _ if number == 0 => (offset, self.letters(line, offset)),
            _ => (offset, Vec::new()),
        }
    }

    fn codes(&self, letter: u8) -> Vec<Completion> {
        let views = [self.view()];
        let rows = codes(self.control().table, letter).iter();
        rows.map(|row| Completion {
            text: code_name(letter, row.code),
            detail: row.title.to_string(),
            more: code_text(letter, row.code, &views).unwrap_or_default(),
            kind: CompletionKind::Code,
        })
        .collect()
    }

    fn tools(&self) -> Vec<Completion> {
        let tools = self.machine().tools.iter();
        tools
            .map(|(number, tool)| Completion {
                text: format!("T{number}"),
                detail: [
                    tool.diameter_mm.map(|mm| format!("⌀ {} mm", number_text(mm, 3))),
                    tool.shape.map(|shape| shape.as_str().to_string()),
                    tool.description.clone(),
                    tool.comment.clone(),
                ]
                .into_iter()
                .flatten()
                .collect::<Vec<_>>()
                .join(", "),
                more: String::new(),
                kind: CompletionKind::Tool,
            })
            .collect()
    }

    /// Programs or block numbers, as the code of the line calls the one or the other.
    fn places(&self, line: u32) -> Vec<Completion> {
        let mut calls = None;
        self.blocks(line, line + 1, |block| {
            let rows = block.words.iter().filter_map(|word| self.control().row_of(word));
            for row in rows {
                if let Action::Call(code) = row.action {
                    calls = code.called().map(|called| called == CallTarget::Program).or(calls);
                }
            }
        });
        let Some(programs) = calls else { return Vec::new() };
        let mut found: Vec<Completion> = Vec::new();
        for place in self.occurrences() {
            let (number, what) = match place.name {
                SymbolName::Program(number) if programs => (i64::from(number), "program"),
                SymbolName::Label { number, .. } if !programs => (number, "block"),
                _ => continue,
            };
            let line = self.source().line_of(place.range.start);
            let text = format!("P{number}");
            if found.iter().all(|other| other.text != text) {
                let detail = format!("{what} on line {line}");
                let (more, kind) = (String::new(), CompletionKind::Place);
                found.push(Completion { text, detail, more, kind });
            }
            if found.len() >= MAX_COMPLETIONS {
                break;
            }
        }
        found
    }

    fn variables(&self) -> Vec<Completion> {
        let mut found: Vec<Completion> = Vec::new();
        for place in self.occurrences() {
            let SymbolName::Variable { name, .. } = place.name else { continue };
            if found.iter().all(|other| other.text != name) && found.len() < MAX_COMPLETIONS {
                let line = self.source().line_of(place.range.start);
                let detail = format!("first on line {line}");
                let (more, kind) = (String::new(), CompletionKind::Variable);
                found.push(Completion { text: name, detail, more, kind });
            }
        }
        found
    }

    /// Letters that the codes of the line take first, then all others that mean something.
    fn letters(&self, line: u32, offset: u32) -> Vec<Completion> {
        let mut here: Option<Block> = None;
        self.blocks(line, line + 1, |block| here = Some(block.clone()));
        let commented = here.as_ref().is_some_and(|block| {
            block.comments.iter().any(|range| range.start < offset && offset <= range.end)
        });
        if commented {
            return Vec::new();
        }
        let rows: Vec<_> = here
            .iter()
            .flat_map(|block| &block.words)
            .filter_map(|word| self.control().row_of(word))
            .collect();
        let views = [self.view()];
        let taken = |letter: u8| rows.iter().any(|row| row.words.has(letter));
        let mut letters: Vec<u8> = (b'A'..=b'Z').collect();
        letters.sort_by_key(|letter| !taken(*letter));
        letters
            .into_iter()
            .filter_map(|letter| {
                let more = letter_text(letter, &views)?;
                let by = rows.iter().find(|row| row.words.has(letter));
                let detail = match by {
                    Some(row) => format!("taken by {}", row.title),
                    None => first_meaning(&more),
                };
                let text = char::from(letter).to_string();
                Some(Completion { text, detail, more, kind: CompletionKind::Letter })
            })
            .collect()
    }
}

/// More would not be read.
const MAX_COMPLETIONS: usize = 500;

/// The first line of meaning after the title.
fn first_meaning(text: &str) -> String {
    let following = text.split_once(':').map_or(text, |(_, rest)| rest);
    following.lines().map(str::trim).find(|line| !line.is_empty()).unwrap_or("").to_string()
}
