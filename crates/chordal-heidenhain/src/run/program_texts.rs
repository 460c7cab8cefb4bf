//! The texts of a job, each of which is a program.

use chordal_diagnostics::{FileId, SourceMap, TextRange};
use chordal_kernel::{ConfiguredControl, RunOptions};
use chordal_machine::Machine;

use crate::datum_table::DatumTable;
use crate::settings::HeidenhainSettings;
use crate::syntax::{
    KlartextLines, KlartextReader, KlartextStatement, LineReader, block_of_lines,
    contains_ignoring_case,
};

/// The line BEGIN PGM of a program.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct KlartextHead {
    /// The name.
    pub name: String,
    /// Its text.
    pub range: TextRange,
    /// Lengths are inches.
    pub is_inch: bool,
    /// The line, from 1.
    pub line: u32,
}

/// A program and its text.
#[derive(Clone, Debug)]
pub struct KlartextText {
    /// Its file.
    pub file: FileId,
    /// BEGIN PGM; `None` without it.
    pub head: Option<KlartextHead>,
    /// The name of its file without folder and extension, in upper case.
    pub stem: String,
}

/// The programs of some texts with the machine and its control.
pub struct KlartextTexts<'a> {
    /// The control.
    pub control: &'a dyn ConfiguredControl,
    /// Its settings.
    pub settings: HeidenhainSettings,
    /// The texts.
    pub sources: &'a SourceMap<'a>,
    /// The machine.
    pub machine: &'a Machine,
    /// The options of the run.
    pub options: &'a RunOptions,
    /// The programs.
    pub texts: Vec<KlartextText>,
    /// The datum tables by the names of their files without folder and extension, in upper case.
    pub datum_tables: Vec<(String, DatumTable)>,
}

impl<'a> KlartextTexts<'a> {
    /// Finds the programs of the texts.
    pub fn new(
        control: &'a dyn ConfiguredControl,
        settings: HeidenhainSettings,
        sources: &'a SourceMap<'a>,
        machine: &'a Machine,
        options: &'a RunOptions,
    ) -> KlartextTexts<'a> {
        let text = |(file, source): (FileId, &chordal_diagnostics::Source<'_>)| KlartextText {
            file,
            head: program_head(source.text()),
            stem: file_stem(source.name()),
        };
        // Tables are read with the machine; they are no programs.
        let is_program = |(file, source): &(FileId, &chordal_diagnostics::Source<'_>)| {
            *file == FileId(0) || !control.is_table(source.text())
        };
        let texts = sources.iter().filter(is_program).map(text).collect();
        let table = |(_, source): (FileId, &chordal_diagnostics::Source<'_>)| {
            Some((file_stem(source.name()), DatumTable::read(source.text())?))
        };
        let datum_tables = sources.iter().skip(1).filter_map(table).collect();
        KlartextTexts { control, settings, sources, machine, options, texts, datum_tables }
    }

    /// The datum table with a name, with or without folder and extension.
    pub fn datum_table(&self, name: &str) -> Option<&(String, DatumTable)> {
        let stem = file_stem(name);
        self.datum_tables.iter().find(|(own, _)| *own == stem)
    }

    /// The text of a file.
    pub fn text(&self, file: FileId) -> &'a [u8] {
        let sources: &'a SourceMap<'a> = self.sources;
        sources.get(file).map_or(&[], |source| source.text())
    }

    /// A reader of one program.
    pub fn reader(&self, program: usize) -> KlartextReader<'a> {
        KlartextReader::new(self.text(self.texts[program].file))
    }

    /// The index of the program that a call names, with or without folder and extension.
    pub fn find_name(&self, name: &str) -> Option<usize> {
        let stem = file_stem(name);
        self.texts.iter().position(|text| text.stem == stem)
    }
}

/// The name of a file without folder and extension, in upper case.
pub fn file_stem(file: &str) -> String {
    let file = file.rsplit(['/', '\\', ':']).next().unwrap_or(file);
    file.rsplit_once('.').map_or(file, |(stem, _)| stem).trim().to_ascii_uppercase()
}

/// Whether the words of a block contain a word, in upper case.
fn contains_word(text: &[u8], lines: &KlartextLines, word: &[u8]) -> bool {
    lines.parts.iter().any(|part| contains_ignoring_case(part.slice(text), word))
}

/// The blocks of a text that contain a word, read.
pub fn blocks_with<'t>(
    text: &'t [u8],
    word: &'t [u8],
) -> impl Iterator<Item = crate::syntax::KlartextBlock> + 't {
    let mut lines = LineReader::new(text);
    let blocks = std::iter::from_fn(move || {
        lines.pass_blocks_without(word);
        lines.next()
    });
    blocks
        .filter(move |lines| contains_word(text, lines, word))
        .map(move |lines| block_of_lines(text, &lines))
}

/// The word of the lines that begin, end or call programs; in DIN/ISO programs it is a percent sign.
pub fn program_word<'w>(text: &[u8], word: &'w [u8]) -> &'w [u8] {
    if LineReader::new(text).is_iso() { b"%" } else { word }
}

/// BEGIN PGM of a text; `None` without it.
pub fn program_head(text: &[u8]) -> Option<KlartextHead> {
    blocks_with(text, program_word(text, b"BEGIN")).find_map(|block| match block.statement {
        KlartextStatement::Begin { name, is_inch } => {
            let shown = String::from_utf8_lossy(name.slice(text)).into_owned();
            Some(KlartextHead { name: shown, range: name, is_inch, line: block.line })
        }
        _ => None,
    })
}

/// The names of the programs that a text calls, without folder and extension.
pub fn called_program_names(text: &[u8]) -> Vec<String> {
    let mut names: Vec<String> = blocks_with(text, program_word(text, b"PGM"))
        .filter_map(|block| match block.statement {
            KlartextStatement::CallProgram(name) => Some(called_name(text, name)),
            KlartextStatement::CycleLine { number: 12, line: 1, rest, .. } => {
                Some(called_name(text, rest))
            }
            _ => None,
        })
        .map(|name| file_stem(&name))
        .collect();
    names.sort();
    names.dedup();
    names
}

/// The name of a called program as written, without quotes and the word before it.
pub fn called_name(text: &[u8], range: TextRange) -> String {
    let name = String::from_utf8_lossy(range.slice(text)).into_owned();
    let name = name.trim();
    let name = match name.get(..4) {
        Some(word) if word.eq_ignore_ascii_case("PGM ") => name[4..].trim(),
        _ => name,
    };
    name.trim_matches('"').to_string()
}
