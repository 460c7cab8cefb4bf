//! The programs of some texts, and what an editor asks about them.

use chordal_diagnostics::{FileId, SourceMap, TextRange};
use chordal_kernel::{
    Checkpoint, CompletedRun, ProgramName, ProgramPlace, ProgramSet, RunOptions, RunSink,
    TextSymbol, Token, WordCompletion,
};
use chordal_machine::Machine;

use super::interpreter::Interpreter;
use crate::control::SinumerikControl;
use crate::cycles::CYCLES;
use crate::syntax::{BlockReader, ProgramUnit, ProgramUnitKind, tokens, units};
use crate::vocabulary::{meaning_of, words};

/// A program and its text.
#[derive(Clone, Debug)]
pub struct ProgramText {
    /// Its file.
    pub file: FileId,
    /// Its head and its range.
    pub unit: ProgramUnit,
    /// Its name in upper case, without `_MPF` or `_SPF`.
    pub name: String,
}

/// The programs of some texts with the machine and its control.
pub struct SinumerikPrograms<'a> {
    pub(super) control: &'a SinumerikControl,
    pub(super) sources: &'a SourceMap<'a>,
    pub(super) machine: &'a Machine,
    pub(super) options: &'a RunOptions,
    pub(super) texts: Vec<ProgramText>,
    places: Vec<ProgramPlace>,
}

impl<'a> SinumerikPrograms<'a> {
    /// Finds the programs of the texts.
    pub fn new(
        control: &'a SinumerikControl,
        sources: &'a SourceMap<'a>,
        machine: &'a Machine,
        options: &'a RunOptions,
    ) -> SinumerikPrograms<'a> {
        let mut texts = Vec::new();
        for (file, source) in sources.iter() {
            for unit in units(source.text()) {
                let name = unit.name.clone().unwrap_or_else(|| file_stem(source.name()));
                texts.push(ProgramText { file, unit, name: bare_name(&name).to_string() });
            }
        }
        let own = |text: &&ProgramText| text.file == FileId(0);
        // A text whose units are all subprograms is run with its first one.
        let has_main = texts.iter().filter(own).any(|text| text.unit.kind == ProgramUnitKind::Main);
        let place = |(index, text): (usize, &ProgramText)| ProgramPlace {
            file: text.file,
            name: text.unit.name.as_ref().map(|_| ProgramName::from(text.name.clone())),
            head: text.unit.head,
            range: text.unit.range,
            line: text.unit.first_line,
            is_main: own(&text)
                && (text.unit.kind == ProgramUnitKind::Main || !has_main && index == 0),
        };
        let places = texts.iter().enumerate().map(place).collect();
        SinumerikPrograms { control, sources, machine, options, texts, places }
    }

    /// The text of a file.
    pub(super) fn text(&self, file: FileId) -> &'a [u8] {
        let sources: &'a SourceMap<'a> = self.sources;
        sources.get(file).map_or(&[], |source| source.text())
    }

    /// A reader of one program.
    pub(super) fn reader(&self, program: usize) -> BlockReader<'a> {
        let text = &self.texts[program];
        let mut reader = BlockReader::new(self.text(text.file));
        reader.seek(text.unit.head.end, text.unit.first_line);
        reader.limit(text.unit.range.end);
        reader
    }

    /// The index of the program with a name, without `_MPF` or `_SPF`, in upper case.
    pub(super) fn find_name(&self, name: &str) -> Option<usize> {
        let name = bare_name(name);
        self.texts.iter().position(|text| text.name.eq_ignore_ascii_case(name))
    }
}

/// A name without folder, `_N_`, `_MPF` and `_SPF`.
pub fn bare_name(name: &str) -> &str {
    let name = name.rsplit(['/', '\\']).next().unwrap_or(name);
    let name = name.strip_prefix("_N_").or_else(|| name.strip_prefix("_n_")).unwrap_or(name);
    let upper = name.to_ascii_uppercase();
    let ends = ["_MPF", "_SPF", ".MPF", ".SPF"].iter().any(|end| upper.ends_with(end));
    if ends { &name[..name.len() - 4] } else { name }
}

/// The name of a file without folder and extension, in upper case.
fn file_stem(file: &str) -> String {
    let file = file.rsplit(['/', '\\']).next().unwrap_or(file);
    file.rsplit_once('.').map_or(file, |(stem, _)| stem).to_ascii_uppercase()
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
        (program < self.texts.len()).then(|| Interpreter::new(self, program, sink).run())
    }

    fn tokens(&self, part: TextRange) -> Vec<Token> {
        let mut found = tokens(self.text(FileId(0)), part);
        found.retain(|token| token.range.start >= part.start && token.range.start < part.end);
        found
    }

    fn meaning(&self, at: u32) -> Option<(TextRange, String)> {
        let text = self.text(FileId(0));
        let source = self.sources.get(FileId(0))?;
        let line = source.line_start(source.line_of(at));
        let part = TextRange::new(line, at + 1);
        let token = tokens(text, part)
            .into_iter()
            .find(|token| token.range.start <= at && at < token.range.end)?;
        let word = String::from_utf8_lossy(token.range.slice(text)).to_ascii_uppercase();
        Some((token.range, meaning_of(&word)?))
    }

    fn symbols(&self) -> Vec<TextSymbol> {
        let own = self.texts.iter().filter(|text| text.file == FileId(0));
        let mut symbols: Vec<TextSymbol> = own
            .filter(|text| text.unit.name.is_some())
            .map(|text| TextSymbol { name: text.name.clone(), range: text.unit.head })
            .collect();
        for block in BlockReader::new(self.text(FileId(0))) {
            symbols.extend(
                block.label.map(|label| TextSymbol { name: label.name, range: label.range }),
            );
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
}
