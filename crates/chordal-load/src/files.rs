//! Access to files: on the disk, or in memory.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use crate::disk;

/// Where programs, machine files and subprograms are searched.
#[derive(Clone, Debug, Default)]
pub enum FileAccess {
    /// On the disk.
    #[default]
    Disk,
    /// Only in this map from path to content: for a caller without a disk.
    InMemory(Arc<BTreeMap<PathBuf, Vec<u8>>>),
}

impl FileAccess {
    /// Files in memory by their paths.
    pub fn in_memory(files: impl IntoIterator<Item = (PathBuf, Vec<u8>)>) -> FileAccess {
        let files = files.into_iter().map(|(path, bytes)| (plain(&path), bytes));
        FileAccess::InMemory(Arc::new(files.collect()))
    }

    /// Reads a whole file.
    ///
    /// # Errors The file does not exist or cannot be read.
    pub fn bytes(&self, path: &Path) -> io::Result<Vec<u8>> {
        match self {
            FileAccess::Disk => disk::bytes(path),
            FileAccess::InMemory(files) => found(files, path).map(<[u8]>::to_vec),
        }
    }

    /// Whether there is a file of this path.
    pub(crate) fn is_file(&self, path: &Path) -> bool {
        match self {
            FileAccess::Disk => path.is_file(),
            FileAccess::InMemory(files) => files.contains_key(&plain(path)),
        }
    }

    /// The first bytes of a file.
    pub(crate) fn head(&self, path: &Path, size: u64) -> io::Result<Vec<u8>> {
        let mut bytes = Vec::new();
        match self {
            FileAccess::Disk => File::open(path)?.take(size).read_to_end(&mut bytes)?,
            FileAccess::InMemory(files) => {
                found(files, path)?.take(size).read_to_end(&mut bytes)?
            }
        };
        Ok(bytes)
    }

    /// Reads a text file without the byte order mark that some editors write.
    ///
    /// # Errors The file does not exist, cannot be read or is not UTF-8.
    pub fn text(&self, path: &Path) -> io::Result<String> {
        let text = String::from_utf8(self.bytes(path)?).map_err(|_| not_utf8())?;
        Ok(text.strip_prefix('\u{feff}').map(str::to_string).unwrap_or(text))
    }

    /// The files in the folder of a program, including the program itself, with paths of the same form, sorted.
    pub(crate) fn next_to(&self, program: &Path) -> Vec<PathBuf> {
        let mut files: Vec<PathBuf> = match self {
            FileAccess::Disk => {
                let folder = match program.parent() {
                    Some(parent) if !parent.as_os_str().is_empty() => parent,
                    _ => Path::new("."),
                };
                let entries = fs::read_dir(folder).into_iter().flatten().flatten();
                let paths = entries.map(|entry| program.with_file_name(entry.file_name()));
                paths.filter(|path| path.is_file()).collect()
            }
            FileAccess::InMemory(files) => {
                let program = plain(program);
                let own = files.keys().filter(|path| path.parent() == program.parent());
                own.cloned().collect()
            }
        };
        files.sort();
        files
    }
}

/// The bytes of a file in memory.
pub(crate) fn found<'f>(
    files: &'f BTreeMap<PathBuf, Vec<u8>>,
    path: &Path,
) -> io::Result<&'f [u8]> {
    let bytes = files.get(&plain(path)).map(Vec::as_slice);
    bytes.ok_or_else(|| io::Error::new(io::ErrorKind::NotFound, "it is not among the given files"))
}

/// The error that `std::fs::read_to_string` returns.
fn not_utf8() -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, "stream did not contain valid UTF-8")
}

/// A path with its `.` and `..` components resolved, as far as possible without the disk.
fn plain(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir if plain.file_name().is_some() => {
                plain.pop();
            }
            other => plain.push(other),
        }
    }
    plain
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn given_files_are_found_by_every_form_of_their_path() {
        let files = FileAccess::in_memory([
            ("shop/./mill.toml".into(), b"\xEF\xBB\xBFa".to_vec()),
            ("shop/x/../O2.nc".into(), b"O2".to_vec()),
            ("O1.nc".into(), b"O1".to_vec()),
        ]);
        assert!(files.is_file(Path::new("./shop/x/../mill.toml")));
        assert!(!files.is_file(Path::new("mill.toml")));
        assert_eq!(files.text(Path::new("shop/mill.toml")).unwrap(), "a");
        assert_eq!(files.head(Path::new("shop/O2.nc"), 1).unwrap(), b"O");
        assert_eq!(files.next_to(Path::new("./part.nc")), [PathBuf::from("O1.nc")]);
        let next_to = files.next_to(Path::new("shop/part.nc"));
        assert_eq!(next_to, [PathBuf::from("shop/O2.nc"), PathBuf::from("shop/mill.toml")]);
        let error = files.text(Path::new("/etc/hostname")).unwrap_err();
        assert_eq!(error.to_string(), "it is not among the given files");
    }
}
