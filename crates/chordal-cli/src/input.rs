//! Finding program files and reading them, mapped where they are large.

use std::borrow::Cow;
use std::fs::{self, File};
use std::io::{self, Read};
use std::ops::Deref;
use std::path::{Path, PathBuf};

use chordal::syntax::decode;
use memmap2::Mmap;

use crate::failure::Failure;

/// Files below this size are read: a mapping costs more than copying them.
const MAP_FROM: u64 = 1 << 20;

/// Places in a text are 32-bit numbers.
const LARGEST: u64 = u32::MAX as u64;

/// How much of a file in a folder is looked at to decide whether it is a program.
const SAMPLE: u64 = 16 * 1024;

/// Endings of files that lie next to programs and are none, whatever they hold.
const NOT_PROGRAMS: &[&str] = &[
    "toml", "md", "svg", "png", "jpg", "jpeg", "gif", "bmp", "dxf", "dwg", "step", "stp", "stl",
    "pdf", "html", "htm", "css", "xml", "csv", "json", "jsonl", "sarif", "canon", "parquet",
    "arrow", "yaml", "yml", "ini", "hal", "tbl", "var", "log", "py", "rs", "js", "ts", "sh", "bat",
    "ps1", "zip", "gz", "7z", "exe", "dll", "lock",
];

/// A program to run, as the command line names it.
#[derive(Clone, Debug)]
pub struct Input {
    /// The file; `None` for standard input.
    pub path: Option<PathBuf>,
    /// The folder of the command line that it was found in: `chordal.toml` counts up to there.
    pub root: Option<PathBuf>,
}

impl Input {
    /// The name for people.
    pub fn name(&self) -> Cow<'_, str> {
        self.path.as_ref().map_or(Cow::Borrowed("<stdin>"), |path| path.to_string_lossy())
    }

    /// Path below the folder of the command line, or the file's name: what output in a folder
    /// is named after.
    pub fn below_root(&self) -> PathBuf {
        let Some(path) = &self.path else { return PathBuf::from("stdin") };
        let below = self.root.as_ref().and_then(|root| path.strip_prefix(root).ok());
        below
            .map(Path::to_path_buf)
            .or_else(|| path.file_name().map(PathBuf::from))
            .unwrap_or_default()
    }
}

/// The programs that the arguments name. A folder stands for all programs below it; what
/// cannot be read is reported with the rest.
pub fn find(arguments: &[PathBuf]) -> (Vec<Input>, Vec<Failure>) {
    let mut inputs = Vec::new();
    let mut failures = Vec::new();
    for argument in arguments {
        if argument.as_os_str() == "-" {
            inputs.push(Input { path: None, root: None });
        } else if argument.is_dir() {
            let before = inputs.len() + failures.len();
            search(argument, argument, &mut inputs, &mut failures);
            if inputs.len() + failures.len() == before {
                failures.push(Failure::wrong(
                    format!("there is no program in {}", argument.display()),
                    "name the file itself to run it anyway",
                ));
            }
        } else {
            inputs.push(Input { path: Some(argument.clone()), root: None });
        }
    }
    (inputs, failures)
}

/// All programs of a folder, by name. Links to folders are not followed, so there are no
/// circles.
fn search(folder: &Path, root: &Path, inputs: &mut Vec<Input>, failures: &mut Vec<Failure>) {
    let entries = fs::read_dir(folder).and_then(Iterator::collect::<io::Result<Vec<_>>>);
    let mut entries = match entries {
        Ok(entries) => entries,
        Err(error) => {
            failures.push(Failure::read(folder.to_string_lossy(), &error));
            return;
        }
    };
    entries.sort_by_key(fs::DirEntry::file_name);
    for entry in entries {
        let path = entry.path();
        let hidden = entry.file_name().to_string_lossy().starts_with('.');
        let Ok(kind) = entry.file_type() else { continue };
        if hidden {
            continue;
        } else if kind.is_dir() {
            search(&path, root, inputs, failures);
        } else if path.is_file() && !has_other_ending(&path) {
            match head(&path, SAMPLE) {
                Ok(sample) if looks_like_program(&sample) => {
                    inputs.push(Input { path: Some(path), root: Some(root.to_path_buf()) });
                }
                Ok(_) => {}
                Err(error) => failures.push(Failure::read(path.to_string_lossy(), &error)),
            }
        }
    }
}

/// Neither its name nor its content speak against a program.
pub fn may_be_program(path: &Path) -> bool {
    !has_other_ending(path) && head(path, SAMPLE).is_ok_and(|sample| looks_like_program(&sample))
}

/// The ending of its name says that a file is no program.
pub fn has_other_ending(path: &Path) -> bool {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    ending.is_some_and(|ending| NOT_PROGRAMS.contains(&ending.as_str()))
}

/// The first bytes of a file.
pub fn head(path: &Path, size: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(path)?.take(size).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Some line starts as a block does: a letter with a number, a program head, a percent sign.
/// Only asked of files that nobody named.
pub fn looks_like_program(sample: &[u8]) -> bool {
    let decoded = decode(sample);
    !decoded.binary
        && decoded.text.split(|byte| matches!(byte, b'\n' | b'\r')).any(|line| {
            let mut bytes = line.iter().filter(|byte| !matches!(byte, b' ' | b'\t' | 0));
            match (bytes.next(), bytes.next()) {
                (Some(b'%'), _) => true,
                (Some(b'/' | b'#'), Some(next)) => next.is_ascii_alphanumeric(),
                (Some(first), Some(next)) => {
                    (first.is_ascii_alphabetic() || *first == b':')
                        && (next.is_ascii_digit() || matches!(next, b'.' | b'-' | b'+'))
                }
                _ => false,
            }
        })
}

/// A text in memory or mapped.
enum Bytes {
    Owned(Vec<u8>),
    Mapped(Mmap),
}

impl Deref for Bytes {
    type Target = [u8];

    fn deref(&self) -> &[u8] {
        match self {
            Bytes::Owned(bytes) => bytes,
            Bytes::Mapped(map) => map,
        }
    }
}

/// A program text as the reader takes it, and its name.
pub struct Text {
    name: String,
    bytes: Bytes,
    /// Where the text begins: after a byte order mark.
    start: usize,
}

impl Text {
    /// Reads the text of an input.
    pub fn read(input: &Input) -> Result<Text, Failure> {
        let name = input.name().into_owned();
        let bytes = match &input.path {
            Some(path) => open(path),
            None => read_all(io::stdin().lock()),
        };
        let bytes = bytes.map_err(|error| Failure::read(&*name, &error))?;
        Text::new(name, bytes)
    }

    /// A text that is in memory already.
    pub fn of(name: &str, bytes: Vec<u8>) -> Result<Text, Failure> {
        Text::new(name.to_string(), Bytes::Owned(bytes))
    }

    /// The name for people.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The text.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes[self.start..]
    }

    /// Its name and its text.
    pub fn into_parts(self) -> (String, Vec<u8>) {
        let mut bytes = match self.bytes {
            Bytes::Owned(bytes) => bytes,
            Bytes::Mapped(map) => map.to_vec(),
        };
        bytes.drain(..self.start);
        (self.name, bytes)
    }

    /// Gives a program without a head the number that its file's name says. The head comes
    /// before the words of the first line after `%`, so that lines keep their numbers.
    pub fn give_head(&mut self, number: u32) {
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
        self.bytes = Bytes::Owned(headed);
        self.start = 0;
    }

    fn new(name: String, bytes: Bytes) -> Result<Text, Failure> {
        let text = match decode(&bytes).text {
            Cow::Borrowed(text) => {
                let start = bytes.len() - text.len();
                Text { name, start, bytes }
            }
            Cow::Owned(text) => Text { name, start: 0, bytes: Bytes::Owned(text) },
        };
        if text.bytes().len() as u64 > LARGEST {
            return Err(Failure::Read { file: text.name, reason: too_large().to_string() });
        }
        Ok(text)
    }
}

fn open(path: &Path) -> io::Result<Bytes> {
    let mut file = File::open(path)?;
    let about = file.metadata()?;
    if about.is_file() && about.len() > LARGEST {
        return Err(too_large());
    }
    if about.is_file() && about.len() >= MAP_FROM {
        return map(&file).map(Bytes::Mapped);
    }
    read_all(&mut file)
}

/// Pipes and devices say no size: they are read up to the limit.
fn read_all(reader: impl Read) -> io::Result<Bytes> {
    let mut bytes = Vec::new();
    reader.take(LARGEST + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > LARGEST { Err(too_large()) } else { Ok(Bytes::Owned(bytes)) }
}

fn too_large() -> io::Error {
    io::Error::other("it is larger than 4 GiB; split the program")
}

/// Maps a file, so that a gigabyte is not copied before its first block is read.
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
