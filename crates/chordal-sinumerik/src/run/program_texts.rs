//! The texts of a job, and the programs in them.

use chordal_diagnostics::{FileId, SourceMap, TextRange};
use chordal_kernel::{ConfiguredControl, RunOptions};
use chordal_machine::Machine;

use crate::settings::SinumerikSettings;
use crate::syntax::{
    BlockReader, ProcedureHead, ProgramUnit, ProgramUnitKind, StatementKind, is_table_text, units,
};

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
pub struct ProgramTexts<'a> {
    pub control: &'a dyn ConfiguredControl,
    pub settings: SinumerikSettings,
    pub sources: &'a SourceMap<'a>,
    pub machine: &'a Machine,
    pub options: &'a RunOptions,
    pub texts: Vec<ProgramText>,
}

impl<'a> ProgramTexts<'a> {
    /// Finds the programs of the texts.
    pub fn new(
        control: &'a dyn ConfiguredControl,
        settings: SinumerikSettings,
        sources: &'a SourceMap<'a>,
        machine: &'a Machine,
        options: &'a RunOptions,
    ) -> ProgramTexts<'a> {
        let mut texts = Vec::new();
        for (file, source) in sources.iter() {
            let is_table = file != FileId(0) && is_table_text(source.text());
            for mut unit in units(source.text()) {
                if is_table {
                    unit.kind = ProgramUnitKind::Table;
                } else if unit.kind == ProgramUnitKind::Unknown && is_subprogram(source.name()) {
                    unit.kind = ProgramUnitKind::Sub;
                }
                let name = unit.name.clone().unwrap_or_else(|| file_stem(source.name()));
                texts.push(ProgramText { file, unit, name: bare_name(&name).to_string() });
            }
        }
        ProgramTexts { control, settings, sources, machine, options, texts }
    }

    /// The text of a file.
    pub fn text(&self, file: FileId) -> &'a [u8] {
        let sources: &'a SourceMap<'a> = self.sources;
        sources.get(file).map_or(&[], |source| source.text())
    }

    /// A reader of one program.
    pub fn reader(&self, program: usize) -> BlockReader<'a> {
        let text = &self.texts[program];
        let mut reader = BlockReader::new(self.text(text.file));
        reader.seek(text.unit.head.end, text.unit.first_line);
        reader.limit(text.unit.range.end);
        reader
    }

    /// The index of the program with a name, without `_MPF` or `_SPF`, in upper case.
    pub fn find_name(&self, name: &str) -> Option<usize> {
        let name = bare_name(name);
        self.texts.iter().position(|text| {
            text.unit.kind != ProgramUnitKind::Table && text.name.eq_ignore_ascii_case(name)
        })
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

/// Whether a file is one of subprograms by its extension.
fn is_subprogram(file: &str) -> bool {
    file.rsplit_once('.').is_some_and(|(_, end)| end.eq_ignore_ascii_case("spf"))
}

/// The name of a file without folder and extension, in upper case.
fn file_stem(file: &str) -> String {
    let file = file.rsplit(['/', '\\']).next().unwrap_or(file);
    file.rsplit_once('.').map_or(file, |(stem, _)| stem).to_ascii_uppercase()
}

/// The head of a program with parameters and its text; `None` without `PROC`.
pub fn procedure_of(reader: &mut BlockReader<'_>) -> Option<(TextRange, ProcedureHead)> {
    let block = reader.find(|block| !block.statements.is_empty())?;
    let first = block.statements.into_iter().next()?;
    match first.kind {
        StatementKind::Procedure(head) => Some((first.range, head)),
        _ => None,
    }
}
