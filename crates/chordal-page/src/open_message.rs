//! The first message of a page: an object, which names the bytes of the texts after it.

use serde::Deserialize;

/// The object of that message.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OpenMessage {
    /// The name of the program, for messages and for what lies next to it.
    pub name: String,
    /// There is a program, whose bytes come last; a view that works for another one has none of its own.
    pub program: bool,
    /// What lies next to it: subprograms, machine and setup files, what these name.
    pub files: Vec<FileHeader>,
    /// The machine that it runs on unless the page chooses another one: a name, or the path of a file.
    pub machine: Option<String>,
    /// The program that it is compared with; its bytes come after those of the files.
    pub compared: Option<OtherProgramHeader>,
}

/// Another program, with the same files next to it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct OtherProgramHeader {
    pub name: String,
    pub bytes: usize,
    /// The machine that it runs on; otherwise the one of its folder or its text.
    pub machine: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FileHeader {
    pub path: String,
    pub bytes: usize,
}
