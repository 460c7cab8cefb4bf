//! The programs of some texts, and what an editor asks about them.

use chordal_diagnostics::{FileId, SourceMap, TextRange};
use chordal_kernel::{
    Checkpoint, CompletedRun, ConfiguredControl, ProgramName, ProgramPlace, ProgramSet, RunOptions,
    RunSink, TextSymbol, TextSymbolKind, Token, WordCompletion,
};
use chordal_machine::Machine;

use super::interpreter::Interpreter;
use super::program_texts::{ProgramText, ProgramTexts};
use crate::cycles::CYCLES;
use crate::settings::SinumerikSettings;
use crate::syntax::{BlockReader, ProgramUnitKind, tokens, with_uniform_spacing};
use crate::vocabulary::{meaning_of, words};

/// The programs of some texts with the machine and its control.
pub struct SinumerikPrograms<'a> {
    texts: ProgramTexts<'a>,
    places: Vec<ProgramPlace>,
}

impl<'a> SinumerikPrograms<'a> {
    /// Finds the programs of the texts.
    pub fn new(
        control: &'a dyn ConfiguredControl,
        settings: SinumerikSettings,
        sources: &'a SourceMap<'a>,
        machine: &'a Machine,
        options: &'a RunOptions,
    ) -> SinumerikPrograms<'a> {
        let texts = ProgramTexts::new(control, settings, sources, machine, options);
        let places = places(&texts.texts);
        SinumerikPrograms { texts, places }
    }
}

/// The programs as places. A run begins with the main programs of the first text.
fn places(texts: &[ProgramText]) -> Vec<ProgramPlace> {
    let own = |text: &&ProgramText| text.file == FileId(0);
    // A text whose units are all subprograms is run with its first one.
    let has_main = texts.iter().filter(own).any(|text| text.unit.kind == ProgramUnitKind::Main);
    let place = |(index, text): (usize, &ProgramText)| ProgramPlace {
        file: text.file,
        name: text.unit.name.as_ref().map(|_| ProgramName::from(text.name.clone())),
        head: text.unit.head,
        range: text.unit.range,
        line: text.unit.first_line,
        is_main: own(&text) && (text.unit.kind == ProgramUnitKind::Main || !has_main && index == 0),
    };
    texts.iter().enumerate().map(place).collect()
}

impl ProgramSet for SinumerikPrograms<'_> {
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
            .then(|| Interpreter::new(&self.texts, program, sink).run())
    }

    fn tokens(&self, part: TextRange) -> Vec<Token> {
        let mut found = tokens(self.texts.text(FileId(0)), part);
        found.retain(|token| token.range.start >= part.start && token.range.start < part.end);
        found
    }

    fn meaning(&self, at: u32) -> Option<(TextRange, String)> {
        let text = self.texts.text(FileId(0));
        let source = self.texts.sources.get(FileId(0))?;
        let line = source.line_start(source.line_of(at));
        let part = TextRange::new(line, at + 1);
        let token = tokens(text, part)
            .into_iter()
            .find(|token| token.range.start <= at && at < token.range.end)?;
        let word = String::from_utf8_lossy(token.range.slice(text)).to_ascii_uppercase();
        Some((token.range, meaning_of(&word)?))
    }

    fn symbols(&self) -> Vec<TextSymbol> {
        let own = self.texts.texts.iter().filter(|text| text.file == FileId(0));
        let mut symbols: Vec<TextSymbol> = own
            .filter(|text| text.unit.name.is_some())
            .map(|text| TextSymbol {
                name: text.name.clone(),
                kind: match text.unit.kind {
                    ProgramUnitKind::Sub => TextSymbolKind::Subprogram,
                    _ => TextSymbolKind::Program,
                },
                range: text.unit.head,
                body: text.unit.range,
            })
            .collect();
        for block in BlockReader::new(self.texts.text(FileId(0))) {
            symbols.extend(block.label.map(|label| TextSymbol {
                name: label.name,
                kind: TextSymbolKind::Label,
                range: label.range,
                body: label.range,
            }));
        }
        symbols
    }

    fn completions(&self, _: u32) -> Vec<WordCompletion> {
        let cycles = CYCLES.iter().map(|cycle| (cycle.name, cycle.title.to_string()));
        let words = words().map(|(word, meaning)| (word, meaning.to_string()));
        let completion =
            |(word, meaning): (&str, String)| WordCompletion { word: word.into(), meaning };
        words.chain(cycles).map(completion).collect()
    }

    fn formatted(&self) -> Option<String> {
        String::from_utf8(with_uniform_spacing(self.texts.text(FileId(0)))).ok()
    }
}
