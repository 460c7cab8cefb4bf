//! Runs the command in a folder of its own.

#![allow(
    dead_code,
    clippy::disallowed_methods,
    clippy::disallowed_types,
    reason = "the tests of a shell have its files and processes; each uses a part of this"
)]

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

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

/// The same with an arc whose radii differ.
pub const BROKEN: &str = "\
O11 (BROKEN ARC)
G20 G17 G40 G90
G0 X0 Y0 Z.1
S900 M3
G1 Z-.1 F5.
G2 X1. Y1. I.4 J0
G0 Z.1 M5
M30
";

/// What a call of the command left.
pub struct Done {
    pub code: i32,
    pub out: String,
    pub err: String,
}

/// A folder of files that goes when the test ends.
pub struct Folder(tempfile::TempDir);

impl Folder {
    pub fn new() -> Folder {
        Folder(tempfile::tempdir().expect("a folder for the test"))
    }

    /// A folder with one clean program, `part.nc`.
    pub fn with_part() -> Folder {
        let folder = Folder::new();
        folder.write("part.nc", CLEAN);
        folder
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

    pub fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap()
    }

    pub fn bytes(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap()
    }

    /// Names of everything in the folder, in order.
    pub fn names(&self) -> Vec<String> {
        let mut names = Vec::new();
        list(self.0.path(), self.0.path(), &mut names);
        names.sort();
        names
    }

    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_chordal"));
        command.current_dir(self.0.path()).args(arguments);
        command.env_remove("NO_COLOR").env_remove("CLICOLOR_FORCE").stdin(Stdio::null());
        command
    }

    /// Runs the command here.
    pub fn run(&self, arguments: &[&str]) -> Done {
        let output = self.command(arguments).output().unwrap();
        Done {
            code: output.status.code().expect("an exit code, not a signal"),
            out: String::from_utf8(output.stdout).unwrap(),
            err: String::from_utf8(output.stderr).unwrap(),
        }
    }

    /// Runs the command here with something on standard input.
    pub fn run_with(&self, arguments: &[&str], input: &[u8]) -> Done {
        let mut child = self
            .command(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        child.stdin.take().unwrap().write_all(input).unwrap();
        let output = child.wait_with_output().unwrap();
        Done {
            code: output.status.code().expect("an exit code, not a signal"),
            out: String::from_utf8(output.stdout).unwrap(),
            err: String::from_utf8(output.stderr).unwrap(),
        }
    }
}

fn list(folder: &Path, root: &Path, names: &mut Vec<String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            list(&path, root, names);
        } else {
            names.push(path.strip_prefix(root).unwrap().to_string_lossy().replace('\\', "/"));
        }
    }
}

impl Done {
    /// Checks the exit code, with everything that was said if it is another.
    #[track_caller]
    pub fn ends(self, code: i32) -> Done {
        assert_eq!(self.code, code, "\n--- out\n{}\n--- err\n{}", self.out, self.err);
        self
    }

    /// Checks that the output holds these texts, in this order.
    #[track_caller]
    pub fn says(self, texts: &[&str]) -> Done {
        holds_in_order(&self.out, texts);
        self
    }

    /// The same of standard error.
    #[track_caller]
    pub fn complains(self, texts: &[&str]) -> Done {
        holds_in_order(&self.err, texts);
        self
    }
}

#[track_caller]
fn holds_in_order(whole: &str, texts: &[&str]) {
    let mut rest = whole;
    for text in texts {
        match rest.find(text) {
            Some(at) => rest = &rest[at + text.len()..],
            None => panic!("`{text}` is not in (or not in this order)\n{whole}"),
        }
    }
}
