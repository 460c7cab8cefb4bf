//! The files in a program's folder: subprograms are found there, as on a control's disk.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use chordal::control::{ConfiguredControl, ProgramName, referenced_programs};
use chordal::diagnostics::FileId;
use chordal::syntax::{Block, BlockReader, Lexicon, decode, find_programs};

use crate::files::FileAccess;
use crate::input::{ProgramInput, may_be_program};
use crate::text::ProgramText;
use crate::variables::FolderVariables;

/// The most subprogram files that are added to a program.
const MAX_FILES: usize = 256;

/// The most folders in the cache. A run over an archive visits one folder after the other.
const MAX_FOLDERS: usize = 64;

/// The most files of a folder whose program heads are read.
const MAX_HEADS: usize = 10_000;

/// The most files of definitions and tables that are read with a program.
const MAX_TABLES: usize = 64;

/// How much of a file is read to find its program head, bytes.
const HEAD: u64 = 4096;

/// A cache of folder listings, so that a folder with many programs is listed once.
#[derive(Default)]
pub struct FolderCache {
    folders: BTreeMap<PathBuf, FolderListing>,
    variables: BTreeMap<PathBuf, FolderVariables>,
}

impl FolderCache {
    /// The texts of the subprograms that a text calls, directly or indirectly, and that are in the same folder. Files
    /// that cannot be read are skipped; the run then reports the subprogram as missing.
    pub fn find(
        &mut self,
        files: &FileAccess,
        path: &Path,
        text: &[u8],
        control: &dyn ConfiguredControl,
    ) -> Vec<ProgramText> {
        let mut found: Vec<ProgramText> = Vec::new();
        let mut pending: BTreeSet<ProgramName> =
            control.called_programs(text).into_iter().collect();
        let has_tables = !control.table_extensions().is_empty();
        if pending.is_empty() && !has_tables {
            return found;
        }
        let keys = |text: &[u8]| -> Vec<u32> {
            control.program_names(text).iter().filter_map(ProgramName::key).collect()
        };
        let mut known: BTreeSet<u32> = keys(text).into_iter().collect();
        let mut visited: BTreeSet<ProgramName> = BTreeSet::new();
        if self.folders.len() > MAX_FOLDERS {
            self.folders.clear();
        }
        let folder =
            self.folders.entry(folder_of(path)).or_insert_with(|| FolderListing::of(files, path));
        while let Some(name) = pending.pop_first() {
            // Found or not, it is not searched again.
            let is_known = name.key().is_some_and(|key| known.contains(&key));
            if !visited.insert(name.clone()) || is_known || found.len() >= MAX_FILES {
                continue;
            }
            let path = match name.key() {
                Some(number) => folder.program(files, number, path),
                None => folder.subroutine(&name.to_string(), control, path),
            };
            let Some(path) = path else { continue };
            let input = ProgramInput { path: Some(path), root: None };
            let Ok(mut text) = ProgramText::read_of(files, &input) else { continue };
            if let Some(number) = name.key() {
                if keys(text.bytes()).is_empty() {
                    text.give_head(number);
                }
                known.extend(keys(text.bytes()));
            }
            pending.extend(control.called_programs(text.bytes()));
            found.push(text);
        }
        for path in folder.tables(control) {
            let input = ProgramInput { path: Some(path), root: None };
            let Ok(text) = ProgramText::read_of(files, &input) else { continue };
            if control.is_table(text.bytes()) {
                found.push(text);
            }
        }
        found
    }

    /// The variables that the control has written into files in the program's folder.
    pub fn variables(&mut self, files: &FileAccess, program: &Path) -> &FolderVariables {
        if self.variables.len() > MAX_FOLDERS {
            self.variables.clear();
        }
        let folder = self.variables.entry(folder_of(program));
        folder.or_insert_with(|| FolderVariables::next_to(files, program))
    }
}

/// Removes files that contain only subprograms which other files of the same folder call: these run where they are
/// called. Run by itself, a subprogram would seem to have no spindle, no feed and no end. Files that the caller named
/// are kept.
pub fn without_called(inputs: Vec<ProgramInput>) -> Vec<ProgramInput> {
    let lexicon = &Lexicon::COMMON;
    let mut called: BTreeMap<PathBuf, BTreeSet<u32>> = BTreeMap::new();
    let mut endless: BTreeMap<usize, Vec<u32>> = BTreeMap::new();
    for (index, input) in inputs.iter().enumerate() {
        let (Some(path), Some(_)) = (&input.path, &input.root) else { continue };
        // A file that cannot be read is reported later, when it is run.
        let Ok(text) = ProgramText::read(input) else { continue };
        let own: Vec<u32> = numbers(text.bytes(), lexicon).collect();
        let calls = called.entry(folder_of(path)).or_default();
        let others = referenced_programs(text.bytes(), lexicon).into_iter();
        calls.extend(others.filter(|number| !own.contains(number)));
        if !own.is_empty() && !has_end(text.bytes(), lexicon) {
            endless.insert(index, own);
        }
    }
    let is_called = |index: &usize, input: &ProgramInput| {
        let folder = input.path.as_deref().map(folder_of);
        match (endless.get(index), folder.and_then(|folder| called.get(&folder))) {
            (Some(own), Some(called)) => own.iter().all(|number| called.contains(number)),
            _ => false,
        }
    };
    inputs
        .iter()
        .enumerate()
        .filter(|(index, input)| !is_called(index, input))
        .map(|(_, input)| input.clone())
        .collect()
}

fn folder_of(path: &Path) -> PathBuf {
    path.parent().map(Path::to_path_buf).unwrap_or_default()
}

/// Whether some block has M2 or M30. Subprograms are short, so a text longer than 1 MiB counts as a main program.
fn has_end(text: &[u8], lexicon: &Lexicon) -> bool {
    const LONG_FILE_BYTES: usize = 1 << 20;
    if text.len() > LONG_FILE_BYTES {
        return true;
    }
    let mut reader = BlockReader::new(text, FileId(0), *lexicon);
    let mut block = Block::new();
    while reader.read(&mut block) {
        let ends = block.all(b'M').filter_map(|word| word.number()?.to_integer());
        if ends.into_iter().any(|code| code == 2 || code == 30) {
            return true;
        }
    }
    false
}

fn numbers(text: &[u8], lexicon: &Lexicon) -> impl Iterator<Item = u32> {
    find_programs(text, lexicon).into_iter().filter_map(|head| head.number)
}

/// The files of a folder by the program number or the name in their file names. Their program heads are read
/// only when a file name was not enough.
struct FolderListing {
    files: Vec<PathBuf>,
    numbers: BTreeMap<u32, Vec<PathBuf>>,
    names: BTreeMap<String, Vec<PathBuf>>,
    heads: Option<BTreeMap<u32, Vec<PathBuf>>>,
}

impl FolderListing {
    /// Lists the folder of a program. The paths have the same form as the program's path.
    fn of(files: &FileAccess, program: &Path) -> FolderListing {
        let files = files.next_to(program);
        let mut numbers: BTreeMap<u32, Vec<PathBuf>> = BTreeMap::new();
        let mut names: BTreeMap<String, Vec<PathBuf>> = BTreeMap::new();
        for path in &files {
            if let Some(number) = number_of_name(path) {
                numbers.entry(number).or_default().push(path.clone());
            }
            if let Some(name) = path.file_stem().and_then(|stem| stem.to_str()) {
                names.entry(name.to_ascii_lowercase()).or_default().push(path.clone());
            }
        }
        FolderListing { files, numbers, names, heads: None }
    }

    /// The file of a program with a name (`O<name> call`).
    fn subroutine(
        &self,
        name: &str,
        control: &dyn ConfiguredControl,
        caller: &Path,
    ) -> Option<PathBuf> {
        let named = self.names.get(&name.to_ascii_lowercase())?;
        let extensions = control.subprogram_extensions();
        let is_subprogram = |path: &&PathBuf| has_extension(path, extensions);
        named.iter().filter(is_subprogram).find(|path| *path != caller).cloned()
    }

    /// The files that may have definitions and tables of a control.
    fn tables(&self, control: &dyn ConfiguredControl) -> Vec<PathBuf> {
        let extensions = control.table_extensions();
        let tables = self.files.iter().filter(|path| has_extension(path, extensions));
        tables.take(MAX_TABLES).cloned().collect()
    }

    /// The file of a program number, other than the caller's file. Preferred is a file with this number in its name
    /// and in its first program head, then one with this number in its head, then one with this number in its name
    /// and no head.
    fn program(&mut self, disk: &FileAccess, number: u32, caller: &Path) -> Option<PathBuf> {
        let named =
            || self.numbers.get(&number).into_iter().flatten().filter(|path| *path != caller);
        if let Some(path) = named().find(|path| first_head(disk, path) == Some(number)) {
            return Some(path.clone());
        }
        let files = &self.files;
        let heads = self.heads.get_or_insert_with(|| {
            let mut heads: BTreeMap<u32, Vec<PathBuf>> = BTreeMap::new();
            for path in files.iter().take(MAX_HEADS) {
                if let Some(number) = first_head(disk, path) {
                    heads.entry(number).or_default().push(path.clone());
                }
            }
            heads
        });
        let by_head =
            heads.get(&number).and_then(|paths| paths.iter().find(|path| *path != caller));
        by_head
            .or_else(|| {
                let mut named = named();
                named.find(|path| first_head(disk, path).is_none() && may_be_program(disk, path))
            })
            .cloned()
    }
}

fn has_extension(path: &Path, extensions: &[&str]) -> bool {
    let own = path.extension().map(|text| text.to_string_lossy().to_ascii_lowercase());
    own.is_some_and(|own| extensions.contains(&own.as_str()))
}

fn first_head(files: &FileAccess, path: &Path) -> Option<u32> {
    let bytes = files.head(path, HEAD).ok()?;
    let text = decode(&bytes);
    if text.binary { None } else { numbers(&text.text, &Lexicon::COMMON).next() }
}

/// The program number in a file's name, such as `O1000`, `O1000.nc`, `1000.nc` or `o01000.tap`.
fn number_of_name(path: &Path) -> Option<u32> {
    let name = path.file_name()?.to_str()?;
    let stem = name.split_once('.').map_or(name, |(stem, _)| stem);
    stem.strip_prefix(['O', 'o', ':']).unwrap_or(stem).parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_are_numbers() {
        for name in ["O1000", "O1000.nc", "1000.nc", "o01000.tap", "1000", "O1000.nc.txt"] {
            assert_eq!(number_of_name(Path::new(name)), Some(1000), "{name}");
        }
        for name in ["part.nc", "O1000-old.nc", "x1000.nc", ".nc", "", "O.nc", "O99999999999"] {
            assert_eq!(number_of_name(Path::new(name)), None, "{name}");
        }
    }
}
