//! A folder of files to load from.

#![allow(
    dead_code,
    clippy::disallowed_methods,
    reason = "the tests of a shell have its files; each uses a part of this"
)]

use std::fs;
use std::path::PathBuf;

use chordal_load::{LoadError, Loaded, Request, RequestedMachine, file};

/// A program without a problem on a Haas.
pub const CLEAN: &str = "\
O10 (SQUARE)
G20 G17 G40 G90
G0 X0 Y0
S900 M3
G0 Z.1
G1 Z-.1 F5.
X1. F10.
Y1.
G3 X0 Y1. I-.5 J0
G1 Y0
G0 Z.1 M5
M30
";

/// A folder of files that goes when the test ends.
pub struct Folder(tempfile::TempDir);

impl Folder {
    pub fn new() -> Folder {
        Folder(tempfile::tempdir().expect("a folder for the test"))
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) -> &Folder {
        let path = self.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, content).unwrap();
        self
    }

    /// Loads a file of the folder on a Haas.
    pub fn load(&self, name: &str) -> Loaded {
        file(&self.path(name), &on("haas-vf2")).expect("a program that loads")
    }

    /// Loads a file of the folder.
    pub fn load_with(&self, name: &str, request: &Request) -> Result<Loaded, LoadError> {
        file(&self.path(name), request)
    }
}

/// A request for a machine by its name.
pub fn on(machine: &str) -> Request {
    Request { machine: Some(RequestedMachine::Name(machine.into())), ..Request::default() }
}
