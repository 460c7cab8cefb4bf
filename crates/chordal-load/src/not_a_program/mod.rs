//! Recognizes files that are not NC programs, whatever their names: data, pictures, source code, tables, prose.
//!
//! There are two tables: [`bytes`] recognizes files by their first bytes, [`lines`] by their first lines. The tests
//! of lines are strict, because refusing a program is worse than running a text that is not one.

mod bytes;
mod lines;
mod prose;
mod sample;

use std::borrow::Cow;

use chordal::control::{EvidenceStrength, recognize};

use crate::error::LoadError;
use sample::TextSample;

/// A kind of file that is not a program.
#[derive(Debug)]
pub(crate) struct FileKind {
    /// Its description in messages, such as `a NetCDF data file`.
    what: &'static str,
    /// What the user can do instead; `None`: [`USUAL_HELP`].
    help: Option<&'static str>,
    /// Nothing else begins like this, so the file is refused even when the machine is named.
    certain: bool,
}

/// The help text for most kinds.
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

/// The kind of a file by its beginning; `None` when it may be a program.
fn kind_of(text: &[u8]) -> Option<&'static FileKind> {
    bytes::kind_of(text).or_else(|| lines::kind_of(&TextSample::new(text)))
}

/// Whether the file is of a kind that is not a program, or prose.
pub(crate) fn is_other_file(text: &[u8]) -> bool {
    kind_of(text).is_some() || is_letter(text)
}

/// Whether the text is prose: it has no block and is in no known NC language.
fn is_letter(text: &[u8]) -> bool {
    // A semicolon in a sentence looks like a comment, so weak evidence does not suffice.
    let is_known = || {
        let found = recognize(text);
        found.chosen().not_read || found.strength() == EvidenceStrength::Sure
    };
    prose::is_prose(&TextSample::new(text)) && !is_known()
}

/// Refuses files that are certainly not programs.
pub(crate) fn refuse_certain(name: &str, text: &[u8]) -> Result<(), LoadError> {
    match kind_of(text) {
        Some(kind) if kind.certain => Err(refusal(name, kind)),
        _ => Ok(()),
    }
}

/// Refuses files that probably are not programs; used when nobody named the machine.
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
