//! Reads program texts; large files are memory-mapped.

use std::borrow::Cow;
use std::fs::File;
use std::io::{self, Read};
use std::ops::Deref;
use std::path::Path;

use chordal::syntax::decode;
use memmap2::Mmap;

use crate::disk::{self, MAX_FILE_BYTES, too_large};
use crate::error::LoadError;
use crate::files::{FileAccess, found};
use crate::input::ProgramInput;

/// Smaller files are copied into memory, bytes: mapping them would cost more.
const MAP_FROM: u64 = 1 << 20;

/// The bytes of a file, in memory or mapped.
enum TextBytes {
    Owned(Vec<u8>),
    Mapped(Mmap),
}

impl Deref for TextBytes {
    type Target = [u8];

    fn deref(&self) -> &[u8] {
        match self {
            TextBytes::Owned(bytes) => bytes,
            TextBytes::Mapped(map) => map,
        }
    }
}

/// A program text, decoded for the reader, with its name.
pub struct ProgramText {
    name: String,
    bytes: TextBytes,
    /// Where the text begins in `bytes`: after a byte order mark.
    start: usize,
}

impl ProgramText {
    /// Reads the text of an input from the disk or from standard input.
    ///
    /// # Errors The file cannot be read or is larger than 4 GiB.
    pub fn read(input: &ProgramInput) -> Result<ProgramText, LoadError> {
        ProgramText::read_of(&FileAccess::Disk, input)
    }

    /// [`ProgramText::read`] with another file access.
    pub(crate) fn read_of(
        files: &FileAccess,
        input: &ProgramInput,
    ) -> Result<ProgramText, LoadError> {
        let name = input.name().into_owned();
        let bytes = match (&input.path, files) {
            (Some(path), FileAccess::Disk) => open(path),
            (Some(path), FileAccess::InMemory(files)) => {
                found(files, path).map(|bytes| TextBytes::Owned(bytes.to_vec()))
            }
            (None, _) => disk::stream(io::stdin().lock()).map(TextBytes::Owned),
        };
        let bytes = bytes.map_err(|error| LoadError::read(&*name, &error))?;
        ProgramText::new(name, bytes)
    }

    /// A text that is already in memory.
    ///
    /// # Errors The text is larger than 4 GiB.
    pub fn of(name: &str, bytes: Vec<u8>) -> Result<ProgramText, LoadError> {
        ProgramText::new(name.to_string(), TextBytes::Owned(bytes))
    }

    /// The name that messages show.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The text, without a byte order mark.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes[self.start..]
    }

    /// Its name and its text.
    pub(crate) fn into_parts(self) -> (String, Vec<u8>) {
        let mut bytes = match self.bytes {
            TextBytes::Owned(bytes) => bytes,
            TextBytes::Mapped(map) => map.to_vec(),
        };
        bytes.drain(..self.start);
        (self.name, bytes)
    }

    /// Adds a program head with the number from its file name to a program without one. The head is put before the
    /// words of the first line after `%`, so that line numbers do not change.
    pub(crate) fn give_head(&mut self, number: u32) {
        let text = self.bytes();
        let lines = text.split_inclusive(|byte| matches!(byte, b'\n' | b'\r'));
        let is_idle = |line: &&[u8]| {
            let first = line.iter().find(|byte| !byte.is_ascii_whitespace() && **byte != 0);
            first.is_none_or(|byte| *byte == b'%')
        };
        let at: usize = lines.take_while(is_idle).map(<[u8]>::len).sum();
        let mut headed = text[..at].to_vec();
        headed.extend_from_slice(format!("O{number} ").as_bytes());
        headed.extend_from_slice(&text[at..]);
        self.bytes = TextBytes::Owned(headed);
        self.start = 0;
    }

    fn new(name: String, bytes: TextBytes) -> Result<ProgramText, LoadError> {
        let text = match decode(&bytes).text {
            Cow::Borrowed(text) => {
                let start = bytes.len() - text.len();
                ProgramText { name, start, bytes }
            }
            Cow::Owned(text) => ProgramText { name, start: 0, bytes: TextBytes::Owned(text) },
        };
        if text.bytes().len() as u64 > MAX_FILE_BYTES {
            return Err(LoadError::Read { file: text.name, reason: too_large().to_string() });
        }
        Ok(text)
    }
}

fn open(path: &Path) -> io::Result<TextBytes> {
    let (mut file, about) = disk::open(path)?;
    if !about.is_file() {
        return disk::stream(file).map(TextBytes::Owned);
    }
    if about.len() >= MAP_FROM {
        return map(&file).map(TextBytes::Mapped);
    }
    let mut bytes = Vec::new();
    file.read_to_end(&mut bytes)?;
    Ok(TextBytes::Owned(bytes))
}

/// Maps a file, so that a large file is not copied before its first block is read.
#[allow(
    unsafe_code,
    reason = "the one unsafe call: a map is only sound while nobody shortens or changes the file; \
              no program can promise that, and every tool that maps its input takes the same risk \
              (the process ends with a bus error; nothing is written)"
)]
fn map(file: &File) -> io::Result<Mmap> {
    // SAFETY: the map is only read, as bytes without any assumed form, and the file is not
    // written by this process.
    unsafe { Mmap::map(file) }
}
