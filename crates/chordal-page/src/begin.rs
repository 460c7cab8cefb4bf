//! What a view begins with: the object of a message, which names the bytes of the texts.

use serde::Deserialize;

/// What a view begins with.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Begin {
    /// The name of the program, for messages and for what lies next to it.
    pub name: String,
    /// There is a program, whose bytes come last; a view that works for another one has none of its own.
    pub program: bool,
    /// What lies next to it: subprograms, machine and setup files, what these name.
    pub files: Vec<File>,
    /// The machine that it runs on unless the page chooses another one: a name, or the path of a file.
    pub machine: Option<String>,
    /// The program that it is compared with; its bytes come after those of the files.
    pub against: Option<Other>,
}

/// Another program, with the same files next to it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Other {
    pub name: String,
    pub bytes: usize,
    /// The machine that it runs on; otherwise the one of its folder or its text.
    pub machine: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct File {
    pub path: String,
    pub bytes: usize,
}
