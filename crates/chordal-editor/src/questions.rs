//! The questions of an editor, answered by the language of the program.

use chordal::control::{Token, WordCompletion};
use chordal::diagnostics::TextRange;

use crate::edit_proof::{FormatEdit, FormatError};
use crate::hover::{Hover, as_markdown};
use crate::outline::{OutlineEntry, outline_of};
use crate::word_address::{
    Completion, CompletionKind, NameOccurrence, NumberingOptions, RenameError, RenamedVariable,
    SymbolName,
};
use crate::{EditorProgram, RunMoves};

impl EditorProgram {
    /// The tokens of the lines from `from` up to, not including, `to`, in the order of the text.
    pub fn tokens(&self, from: u32, to: u32) -> Vec<Token> {
        match self.word_address() {
            Some(text) => text.tokens(from, to),
            None => {
                let [start, end] = [from, to].map(|line| self.source().line_start(line));
                self.job().program_set().tokens(TextRange::new(start, end))
            }
        }
    }

    /// What the word at a byte offset does on this control and, with the moves of a run, how far and how long its line
    /// moved. `None` where neither a word nor a name is.
    pub fn hover(&self, offset: u32, run_moves: Option<&RunMoves>) -> Option<Hover> {
        let (mut hover, line) = match self.word_address() {
            Some(text) => text.hover(offset)?,
            None => {
                let (range, meaning) = self.job().program_set().meaning(offset)?;
                (Hover { range, text: as_markdown(&meaning) }, self.source().line_of(offset))
            }
        };
        let moves = run_moves.and_then(|run| Some((run.line(line)?, run.units())));
        if let Some((moves, units)) = moves {
            hover.text.push_str(&format!("\n\n{}", moves.text(units)));
        }
        Some(hover)
    }

    /// The outline: programs, in them tools, in those operations, and blocks with numbers where
    /// only some have one. In other languages programs, tools, subprograms and labels.
    pub fn outline(&self) -> Vec<OutlineEntry> {
        if let Some(text) = self.word_address() {
            return text.outline();
        }
        outline_of(self.job().program_set().symbols(), self.source())
    }

    /// Completions at a byte, and where the text that they replace begins.
    pub fn completions(&self, offset: u32) -> (u32, Vec<Completion>) {
        if let Some(text) = self.word_address() {
            return text.completions(offset);
        }
        let words = self.job().program_set().completions(offset);
        let completion = |word: WordCompletion| Completion {
            text: word.word,
            detail: word.meaning,
            more: String::new(),
            kind: CompletionKind::Code,
        };
        (offset, words.into_iter().map(completion).collect())
    }

    /// All places of all names, in the order of the text; empty in languages whose names are not followed.
    pub fn occurrences(&self) -> Vec<NameOccurrence> {
        self.word_address().map_or_else(Vec::new, |text| text.occurrences())
    }

    /// The name at a byte of the text.
    pub fn name_at(&self, offset: u32) -> Option<NameOccurrence> {
        self.word_address()?.name_at(offset)
    }

    /// All occurrences of a name.
    pub fn places_of(&self, name: &SymbolName) -> Vec<NameOccurrence> {
        self.word_address().map_or_else(Vec::new, |text| text.places_of(name))
    }

    /// The places to change so that the variable at a byte of the text is called `new`.
    ///
    /// # Errors
    /// No variable there, no name, one that is used, or variables chosen by their value.
    pub fn rename(&self, offset: u32, new: &str) -> Result<RenamedVariable, RenameError> {
        self.word_address().ok_or(RenameError::NoVariable)?.rename(offset, new)
    }

    /// One space between words and none in them, for the lines from `from` up to, not
    /// including, `to`. Comments, macro statements and what cannot be read stay. In other languages the whole text,
    /// where they have a formatter.
    ///
    /// # Errors
    /// The changed text would run differently.
    pub fn spaced(&self, from: u32, to: u32) -> Result<Vec<FormatEdit>, FormatError> {
        if let Some(text) = self.word_address() {
            return text.spaced(from, to);
        }
        let whole = TextRange::new(0, self.text().len() as u32);
        let formatted = self.job().program_set().formatted();
        let changed = formatted.filter(|text| text.as_bytes() != self.text());
        self.proved(changed.map(|text| FormatEdit { range: whole, text }).into_iter().collect())
    }

    /// New block numbers, and jumps that go to them.
    ///
    /// # Errors
    /// Jumps to computed or ambiguous numbers, numbers too large, a text that would run
    /// differently, or a language whose lines are not numbered here.
    pub fn renumbered(&self, numbering: NumberingOptions) -> Result<Vec<FormatEdit>, FormatError> {
        self.word_address().ok_or(FormatError::OtherLanguage)?.renumbered(numbering)
    }
}
