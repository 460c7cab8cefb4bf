//! A file under a passing name.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::{NamedTempFile, TempPath};

use crate::leftover;
use crate::place::{folder_of, is_regular, place_of};

/// A file under a passing name in the same folder, so that renaming it puts the whole content in place at once.
/// Dropped unfinished, it is gone.
#[derive(Debug)]
pub struct FileDraft {
    out: BufWriter<File>,
    /// Its passing name and its place; nothing where it is written through.
    name: Option<TemporaryName>,
}

/// The passing name of a draft.
#[derive(Debug)]
struct TemporaryName {
    /// Taken when the draft is put in its place.
    path: Option<TempPath>,
    place: PathBuf,
}

impl Drop for TemporaryName {
    fn drop(&mut self) {
        if let Some(path) = self.path.take() {
            let name = path.to_path_buf();
            drop(path);
            leftover::forget(&name);
        }
    }
}

impl FileDraft {
    /// Begins a file, with the folders that it lies in. What is no regular file is opened and written through.
    ///
    /// # Errors
    /// A place where nothing can be written: a folder, a file that may not be changed.
    pub fn open(path: &Path) -> io::Result<FileDraft> {
        let buffered = |file| BufWriter::with_capacity(1 << 16, file);
        if !is_regular(path) {
            let file = OpenOptions::new().write(true).open(path)?;
            return Ok(FileDraft { out: buffered(file), name: None });
        }
        let place = place_of(path)?;
        let before = fs::metadata(&place).ok();
        if before.is_some() {
            // A file that may not be written is not replaced by another one either.
            OpenOptions::new().write(true).open(&place)?;
        }
        let folder = folder_of(&place);
        fs::create_dir_all(folder)?;
        let (file, path) = leftover::made(|| {
            let draft = named_in(folder)?;
            if let Some(before) = &before {
                keep(draft.as_file(), before)?;
            }
            let (file, path) = draft.into_parts();
            Ok((path.to_path_buf(), (file, path)))
        })?;
        Ok(FileDraft { out: buffered(file), name: Some(TemporaryName { path: Some(path), place }) })
    }

    /// Puts it in its place.
    ///
    /// # Errors
    /// What could not be written or renamed: the file is then as before.
    pub fn put(self) -> io::Result<()> {
        let FileDraft { mut out, name } = self;
        out.flush()?;
        let Some(mut name) = name else { return Ok(()) };
        let Some(path) = name.path.take() else { return Ok(()) };
        let passing = path.to_path_buf();
        let put = path.persist(&name.place);
        leftover::forget(&passing);
        put.map_err(|error| error.error)
    }

    /// The file, for what must know more of it than its bytes.
    pub fn file(&self) -> &File {
        self.out.get_ref()
    }
}

impl Write for FileDraft {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.out.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

/// A new file, with the mode of any new file and not the private one of temporary files.
fn named_in(folder: &Path) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".chordal-");
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder)
}

/// Gives a draft the owner and the mode of the file whose place it takes.
fn keep(draft: &File, before: &fs::Metadata) -> io::Result<()> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::{MetadataExt, fchown};
        let about = draft.metadata()?;
        if (about.uid(), about.gid()) != (before.uid(), before.gid()) {
            // Only who may give files away can: for others it is theirs, as any file they write.
            let _ = fchown(draft, Some(before.uid()), Some(before.gid()));
        }
    }
    draft.set_permissions(before.permissions())
}

/// Writes a file whole or not at all, with the folders that it lies in.
///
/// # Errors
/// Those of the file system; the file is then as before.
pub fn write_whole(path: &Path, content: &[u8]) -> io::Result<()> {
    let mut draft = FileDraft::open(path)?;
    draft.write_all(content)?;
    draft.put()
}
