//! Subprograms that lie in files beside the program, as on a control's disk.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use chordal::control::referenced_programs;
use chordal::syntax::{Lexicon, decode, find_programs};

use crate::input::{Input, Text, head};

/// Most files that are added to a program.
const MOST_FILES: usize = 256;

/// Most files of a folder whose heads are looked at.
const MOST_HEADS: usize = 10_000;

/// How much of a file is looked at for its head.
const HEAD: u64 = 4096;

/// The files that hold the programs which a text calls, and those which they call, as far as
/// they lie in the same folder. Files that cannot be read are passed over: then the
/// subprogram is missing, and the run says so.
pub fn find(path: &Path, text: &[u8], lexicon: &Lexicon) -> Vec<Text> {
    let mut found: Vec<Text> = Vec::new();
    let mut wanted: BTreeSet<u32> = referenced_programs(text, lexicon).into_iter().collect();
    if wanted.is_empty() {
        return found;
    }
    let mut folder = Folder::new(path, *lexicon);
    let mut known = BTreeSet::new();
    known.extend(numbers(text, lexicon));
    while let Some(number) = wanted.pop_first() {
        if known.contains(&number) || found.len() >= MOST_FILES {
            continue;
        }
        let Some(path) = folder.program(number) else { continue };
        if let Ok(text) = Text::read(&Input { path: Some(path), root: None }) {
            known.extend(numbers(text.bytes(), lexicon));
            wanted.extend(referenced_programs(text.bytes(), lexicon));
            found.push(text);
        }
        // Found or not, it is not looked for again.
        known.insert(number);
    }
    found
}

fn numbers(text: &[u8], lexicon: &Lexicon) -> impl Iterator<Item = u32> {
    find_programs(text, lexicon).into_iter().filter_map(|head| head.number)
}

/// The files of the program's folder by number, listed on the first question.
struct Folder {
    program: PathBuf,
    lexicon: Lexicon,
    files: Option<Vec<PathBuf>>,
    heads: Option<BTreeMap<u32, PathBuf>>,
}

impl Folder {
    fn new(program: &Path, lexicon: Lexicon) -> Folder {
        Folder { program: program.to_path_buf(), lexicon, files: None, heads: None }
    }

    /// The file of a program: by its name, or else by its first head.
    fn program(&mut self, number: u32) -> Option<PathBuf> {
        let by_name =
            self.files().iter().find(|path| number_of_name(path) == Some(number)).cloned();
        if let Some(path) = by_name.filter(|path| self.first_head(path) == Some(number)) {
            return Some(path);
        }
        if self.heads.is_none() {
            let files = self.files().to_vec();
            let mut heads = BTreeMap::new();
            for path in files.into_iter().take(MOST_HEADS) {
                if let Some(number) = self.first_head(&path) {
                    heads.entry(number).or_insert(path);
                }
            }
            self.heads = Some(heads);
        }
        self.heads.as_ref()?.get(&number).cloned()
    }

    fn files(&mut self) -> &[PathBuf] {
        let own = &self.program;
        self.files.get_or_insert_with(|| {
            let folder = match own.parent() {
                Some(parent) if !parent.as_os_str().is_empty() => parent,
                _ => Path::new("."),
            };
            let entries = fs::read_dir(folder).into_iter().flatten().flatten();
            let mut files: Vec<PathBuf> = entries
                .map(|entry| own.with_file_name(entry.file_name()))
                .filter(|path| path.file_name() != own.file_name() && path.is_file())
                .collect();
            files.sort();
            files
        })
    }

    fn first_head(&self, path: &Path) -> Option<u32> {
        let bytes = head(path, HEAD).ok()?;
        let text = decode(&bytes);
        if text.binary {
            return None;
        }
        numbers(&text.text, &self.lexicon).next()
    }
}

/// The program number that a file's name says: `O1000`, `O1000.nc`, `1000.nc`, `o01000.tap`.
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
