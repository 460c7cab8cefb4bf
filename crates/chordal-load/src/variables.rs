//! Reads macro variables from files that a control has written next to a program: MACRO.TXT of a Fanuc, COMMON.VAR of
//! a Mitsubishi, the .var files of Haas and LinuxCNC.

use std::path::{Path, PathBuf};

use chordal::control::ControlTable;
use chordal::control::macros::{MacroForm, SystemVariable};
use chordal::machine::{VariableDump, read_variable_dump};
use chordal::{Code, Diagnostic, Machine, Span};

use crate::files::FileAccess;
use crate::ledger;

/// A larger file is not taken for a variable file, bytes.
const MAX_VARIABLE_FILE_BYTES: u64 = 8 << 20;

/// The most bad lines of a file that are reported.
const MAX_LISTED_LINES: usize = 5;

/// The variable files of a folder in order of precedence: the first file that contains a variable determines it.
#[derive(Default)]
pub struct FolderVariables(Vec<(PathBuf, VariableDump)>);

impl FolderVariables {
    /// Reads the variable files next to a program. Files that are unreadable or contain something else are ignored.
    pub(crate) fn next_to(files: &FileAccess, program: &Path) -> FolderVariables {
        let mut found: Vec<(u8, PathBuf)> = files
            .next_to(program)
            .into_iter()
            .filter_map(|path| Some((order_of(&path)?, path)))
            .collect();
        found.sort();
        let read = found.into_iter().filter_map(|(_, path)| {
            let bytes = files.head(&path, MAX_VARIABLE_FILE_BYTES + 1).ok()?;
            let dump = (bytes.len() as u64 <= MAX_VARIABLE_FILE_BYTES)
                .then(|| read_variable_dump(&bytes))??;
            if matches!(files, FileAccess::Disk) {
                ledger::note_input(&path);
            }
            Some((path, dump))
        });
        FolderVariables(read.collect())
    }

    /// Adds the variables that the machine does not have yet; returns warnings about lines that cannot be read.
    pub(crate) fn give(
        &self,
        machine: &mut Machine,
        table: &ControlTable,
        text: &[u8],
    ) -> Vec<Diagnostic> {
        let mut warnings = Vec::new();
        if table.macros.form == MacroForm::None || memchr::memchr(b'#', text).is_none() {
            return warnings;
        }
        for (path, dump) in &self.0 {
            for (&number, &value) in &dump.values {
                let macros = &mut machine.macros;
                let is_set =
                    macros.variables.contains_key(&number) || macros.vacant.contains(&number);
                if is_set || !is_programs(table, number) {
                    continue;
                }
                match value {
                    Some(value) => {
                        macros.variables.insert(number, value);
                    }
                    None => {
                        macros.vacant.insert(number);
                    }
                }
            }
            let file = path.file_name().unwrap_or_default().to_string_lossy();
            for bad in dump.bad_lines.iter().take(MAX_LISTED_LINES) {
                let (line, text) = (bad.line, &bad.text);
                let message = format!("{file}:{line}: `{text}` is no value of a variable");
                warnings.push(
                    Diagnostic::new(Code::VariableFile, Span::default(), message)
                        .label("a file of variables next to this program")
                        .help("correct the line, or take the file out of the folder"),
                );
            }
        }
        warnings
    }
}

/// The precedence of a variable file by its name, the lowest first; `None` for other files.
fn order_of(path: &Path) -> Option<u8> {
    let name = path.file_name()?.to_str()?.to_ascii_lowercase();
    match name.as_str() {
        "macro.txt" => Some(0),
        "common.var" => Some(1),
        name if name.ends_with(".var") => Some(2),
        _ => None,
    }
}

/// Whether the variable is a common variable, or a system variable that only the machine knows. Offsets and positions
/// come from other files.
fn is_programs(table: &ControlTable, number: u32) -> bool {
    let macros = table.macros;
    macros.common_range(number).is_some()
        || macros.system_at(number).is_some_and(|(what, _)| {
            matches!(
                what,
                SystemVariable::Input
                    | SystemVariable::Timer
                    | SystemVariable::Setting
                    | SystemVariable::NotSimulated
                    | SystemVariable::Output
            )
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_files() {
        for (name, order) in [
            ("MACRO.TXT", Some(0)),
            ("macro.txt", Some(0)),
            ("Common.Var", Some(1)),
            ("linuxcnc.var", Some(2)),
            ("mill.VAR", Some(2)),
            ("var", None),
            ("MACRO.NC", None),
        ] {
            assert_eq!(order_of(Path::new(name)), order, "{name}");
        }
    }
}
