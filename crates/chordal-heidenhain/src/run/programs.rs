//! The programs of some texts, and what an editor asks about them.

use chordal_diagnostics::{FileId, SourceMap, TextRange};
use chordal_kernel::{
    Checkpoint, CompletedRun, ConfiguredControl, ProgramName, ProgramPlace, ProgramSet,
    RestartFault, RestartedText, RunOptions, RunSink, TextSymbol, Token, TokenClass,
    WordCompletion,
};
use chordal_machine::Machine;

use super::interpreter::KlartextInterpreter;
use super::program_texts::KlartextTexts;
use super::restart::restarted_text;
use crate::editing::{completions, meaning_at, text_symbols};
use crate::settings::HeidenhainSettings;
use crate::syntax::{KlartextToken, KlartextTokenKind, LineReader, scan_tokens};

/// The programs of some texts with the machine and its control.
pub struct KlartextPrograms<'a> {
    texts: KlartextTexts<'a>,
    places: Vec<ProgramPlace>,
}

impl<'a> KlartextPrograms<'a> {
    /// Finds the programs of the texts.
    pub fn new(
        control: &'a dyn ConfiguredControl,
        settings: HeidenhainSettings,
        sources: &'a SourceMap<'a>,
        machine: &'a Machine,
        options: &'a RunOptions,
    ) -> KlartextPrograms<'a> {
        let texts = KlartextTexts::new(control, settings, sources, machine, options);
        let places = texts.texts.iter().map(|text| ProgramPlace {
            file: text.file,
            name: Some(ProgramName::from(
                text.head.as_ref().map_or(text.stem.clone(), |head| head.name.clone()),
            )),
            head: text.head.as_ref().map_or(TextRange::default(), |head| head.range),
            range: TextRange::new(0, texts.text(text.file).len() as u32),
            line: 1,
            is_main: text.file == FileId(0),
        });
        let places = places.collect();
        KlartextPrograms { texts, places }
    }
}

/// The tokens of a block: its number and its skip sign are marks where they stand in front, and a heading is a comment.
fn block_tokens(tokens: &[KlartextToken], is_iso: bool) -> Vec<Token> {
    let is_sign = |token: &KlartextToken, sign| token.kind == KlartextTokenKind::Sign(sign);
    let front = tokens
        .iter()
        .position(|token| {
            !(is_sign(token, b'/') || !is_iso && matches!(token.kind, KlartextTokenKind::Number(_)))
        })
        .unwrap_or(tokens.len());
    let (front, words) = tokens.split_at(front);
    let token = |range, class| Token { range, class };
    let mut found: Vec<Token> =
        front.iter().map(|own| token(own.range, TokenClass::Mark)).collect();
    match words {
        [first, .., last] if !is_iso && is_sign(first, b'*') => {
            found.push(token(first.range.cover(last.range), TokenClass::Comment));
        }
        words => found.extend(words.iter().map(|own| token(own.range, class_of(own)))),
    }
    found
}

/// The class of a token, for colours.
fn class_of(token: &KlartextToken) -> TokenClass {
    let KlartextTokenKind::Word(word) = &token.kind else {
        return match token.kind {
            KlartextTokenKind::Text(_) => TokenClass::Text,
            _ => TokenClass::Number,
        };
    };
    let bare = word.strip_prefix('I').filter(|bare| !bare.is_empty()).unwrap_or(word);
    match bare {
        "X" | "Y" | "Z" | "A" | "B" | "C" | "U" | "V" | "W" | "PR" | "PA" => TokenClass::Axis,
        "F" | "FMAX" | "FAUTO" | "FU" | "FZ" | "S" => TokenClass::Speed,
        "TOOL" => TokenClass::Tool,
        "LBL" => TokenClass::Label,
        "BEGIN" | "END" | "PGM" => TokenClass::Program,
        "M" => TokenClass::MCode,
        "Q" | "QL" | "QR" | "QS" => TokenClass::Variable,
        _ => TokenClass::Keyword,
    }
}

impl ProgramSet for KlartextPrograms<'_> {
    fn programs(&self) -> &[ProgramPlace] {
        &self.places
    }

    fn run(
        &self,
        program: usize,
        _: Option<&Checkpoint>,
        sink: &mut dyn RunSink,
    ) -> Option<CompletedRun> {
        // No checkpoints are given, so that every run begins at the start.
        (program < self.texts.texts.len())
            .then(|| KlartextInterpreter::new(&self.texts, program, sink).run())
    }

    fn restarted(&self, program: usize, line: u32) -> Option<Result<RestartedText, RestartFault>> {
        (program < self.texts.texts.len()).then(|| restarted_text(&self.texts, program, line))
    }

    fn tokens(&self, part: TextRange) -> Vec<Token> {
        let text = self.texts.text(FileId(0));
        let mut found = Vec::new();
        for block in LineReader::new(text) {
            if block.range.start >= part.end {
                break;
            }
            if block.range.end < part.start {
                continue;
            }
            let mut tokens = Vec::new();
            block.parts.iter().for_each(|part| scan_tokens(text, *part, &mut tokens));
            found.extend(block_tokens(&tokens, block.is_iso));
            let comment = |range: &TextRange| Token { range: *range, class: TokenClass::Comment };
            found.extend(block.comments.iter().map(comment));
        }
        found.sort_by_key(|token| token.range.start);
        found.retain(|token| token.range.start >= part.start && token.range.start < part.end);
        found
    }

    fn meaning(&self, at: u32) -> Option<(TextRange, String)> {
        meaning_at(self.texts.text(FileId(0)), at)
    }

    fn symbols(&self) -> Vec<TextSymbol> {
        text_symbols(self.texts.text(FileId(0)))
    }

    fn completions(&self, _: u32) -> Vec<WordCompletion> {
        completions()
    }

    fn formatted(&self) -> Option<String> {
        // The control writes programs in its own form; nothing is changed.
        String::from_utf8(self.texts.text(FileId(0)).to_vec()).ok()
    }
}
