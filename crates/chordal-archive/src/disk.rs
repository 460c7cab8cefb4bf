//! Loads the files of an archive from disk.

use std::fs;
use std::path::{Path, PathBuf};

use chordal::control::control_title;
use chordal_load::{
    LoadError, MachineReason, ProgramInput, ProgramText, Request, has_other_ending,
    looks_like_program,
};

use crate::check::{FileLoader, PreparedFile};

/// The largest file, bytes. Files are read into memory and not mapped, so that a file that is shortened meanwhile
/// cannot end the run.
const MAX_FILE_BYTES: u64 = u32::MAX as u64;

/// Loads files from disk, each with its own machine and subprograms.
pub struct DiskFiles {
    loader: chordal_load::Loader,
    /// The folders of the archive: a `chordal.toml` is searched up to there.
    roots: Vec<PathBuf>,
    /// A replacement in reported paths: from, to.
    renamed: Option<(String, String)>,
}

impl DiskFiles {
    /// A loader of the files in these folders. The shop's own codes are not expanded.
    ///
    /// # Errors The machine of the request cannot be used.
    pub fn new(request: Request, roots: &[PathBuf]) -> Result<DiskFiles, LoadError> {
        let loader = chordal_load::Loader::new(Request { shop_codes: None, ..request })?;
        Ok(DiskFiles { loader, roots: roots.to_vec(), renamed: None })
    }

    /// The same loader, reporting paths with `from` replaced by `to`: files that were copied from elsewhere are then
    /// named by their origin.
    pub fn renamed(self, from: String, to: String) -> DiskFiles {
        let renamed = (!from.is_empty()).then_some((from, to));
        DiskFiles { renamed, ..self }
    }

    fn renamed_text(&self, text: String) -> String {
        match &self.renamed {
            Some((from, to)) => text.replace(from, to),
            None => text,
        }
    }

    /// The same loader for another worker.
    pub fn again(&self) -> DiskFiles {
        let (roots, renamed) = (self.roots.clone(), self.renamed.clone());
        DiskFiles { loader: self.loader.again(), roots, renamed }
    }

    fn input(&self, path: &Path) -> ProgramInput {
        let above = self.roots.iter().filter(|root| root.is_dir() && path.starts_with(root));
        let root = above.max_by_key(|root| root.as_os_str().len()).cloned();
        ProgramInput { path: Some(path.to_path_buf()), root }
    }
}

impl FileLoader for DiskFiles {
    fn is_other_by_name(&self, path: &Path) -> bool {
        has_other_ending(path)
    }

    fn read(&mut self, path: &Path) -> Result<Vec<u8>, String> {
        let failure =
            |error| self.renamed_text(LoadError::read(path.to_string_lossy(), &error).to_string());
        let about = fs::metadata(path).map_err(failure)?;
        if !about.is_file() {
            // A pipe may never end.
            return Err("it is a pipe or a device, not a file".into());
        }
        if about.len() > MAX_FILE_BYTES {
            return Err("it is larger than 4 GiB; split the program".into());
        }
        fs::read(path).map_err(failure)
    }

    fn may_be_program(&self, bytes: &[u8]) -> bool {
        looks_like_program(bytes)
    }

    fn prepare(&mut self, path: &Path, bytes: Vec<u8>) -> Result<PreparedFile, String> {
        let input = self.input(path);
        let text = ProgramText::of(&input.name(), bytes).map_err(|failure| failure.to_string())?;
        let loaded = self.loader.load_text(text, &input);
        let loaded = loaded.map_err(|failure| self.renamed_text(failure_line(&failure)))?;
        let title = control_title(loaded.machine().control);
        let chosen = match &loaded.chosen {
            MachineReason::Requested => "given".into(),
            MachineReason::Folder(file) => self.renamed_text(file.to_string_lossy().into_owned()),
            other => other.why(title).unwrap_or_default(),
        };
        let (mut texts, machine, options) = loaded.into_parts();
        for (name, _) in &mut texts {
            *name = self.renamed_text(std::mem::take(name));
        }
        Ok(PreparedFile { texts, machine, chosen, options, meshes: Vec::new() })
    }

    fn named_file(&mut self, name: &str) -> Result<Vec<u8>, String> {
        self.read(Path::new(name))
    }
}

/// An error in one line, with the first problem of a machine.
fn failure_line(failure: &LoadError) -> String {
    match failure {
        LoadError::Machine(errors) => {
            let first = errors.first().map(|error| {
                let line = error.line().map_or_else(String::new, |line| format!(":{line}"));
                format!(": {}{line}: {}", error.file, error.message)
            });
            format!("{failure}{}", first.unwrap_or_default())
        }
        other => other.to_string(),
    }
}
