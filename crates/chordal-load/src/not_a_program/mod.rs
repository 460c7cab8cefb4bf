//! Files that are no NC programs, whatever their names say: data, pictures, sources, tables, letters.
//!
//! What a file is stands in two tables: [`bytes`] by its first bytes, [`lines`] by its first lines. The tests of lines
//! are strict: a program that is taken for something else is worse than a letter that is run.

mod bytes;
mod lines;
mod prose;
mod sample;

use std::borrow::Cow;

use chordal::control::{EvidenceStrength, recognize};

use crate::error::LoadError;
use sample::TextSample;

/// A kind of file that is no program.
#[derive(Debug)]
pub(crate) struct FileKind {
    /// What it is, for people: `a NetCDF data file`.
    what: &'static str,
    /// What to do with it instead.
    help: Option<&'static str>,
    /// Nothing else begins like this: it is said even where the machine is named.
    certain: bool,
}

/// What helps with most of them.
const USUAL_HELP: &str = "give the program's text file";

impl FileKind {
    const fn new(what: &'static str) -> FileKind {
        FileKind { what, help: None, certain: false }
    }

    const fn certain(self) -> FileKind {
        FileKind { certain: true, ..self }
    }

    const fn help(self, help: &'static str) -> FileKind {
        FileKind { help: Some(help), ..self }
    }
}

/// The kind of a file by its beginning.
fn kind_of(text: &[u8]) -> Option<&'static FileKind> {
    bytes::kind_of(text).or_else(|| lines::kind_of(&TextSample::new(text)))
}

/// The file is of a kind that is no program, or a letter.
pub(crate) fn is_other_file(text: &[u8]) -> bool {
    kind_of(text).is_some() || is_letter(text)
}

/// Text without a block, in no language that is known.
fn is_letter(text: &[u8]) -> bool {
    // A semicolon in a sentence looks like a comment: that alone makes no program.
    let is_known = || {
        let found = recognize(text);
        found.chosen().not_read || found.strength() == EvidenceStrength::Sure
    };
    prose::is_prose(&TextSample::new(text)) && !is_known()
}

/// Refuses what is no program for certain.
pub(crate) fn refuse_certain(name: &str, text: &[u8]) -> Result<(), LoadError> {
    match kind_of(text) {
        Some(kind) if kind.certain => Err(refusal(name, kind)),
        _ => Ok(()),
    }
}

/// Refuses what looks like something else than a program, where nobody named the machine.
pub(crate) fn refuse_likely(name: &str, text: &[u8]) -> Result<(), LoadError> {
    if let Some(kind) = kind_of(text) {
        return Err(refusal(name, kind));
    }
    if is_letter(text) {
        let message =
            format!("{name}: this is not an NC program: no line of it looks like a block");
        return Err(LoadError::wrong(message, "to run it anyway, name the machine with --machine"));
    }
    Ok(())
}

fn refusal(name: &str, kind: &FileKind) -> LoadError {
    let help: Cow<'static, str> = match kind.help {
        Some(help) => help.into(),
        None if kind.certain => USUAL_HELP.into(),
        None => format!("{USUAL_HELP}; if it is one, name the machine with --machine").into(),
    };
    LoadError::wrong(format!("{name}: this is {}, not an NC program", kind.what), help)
}
