//! Behaviour, written down as programs: every file under `tests/suite` and `examples` is a
//! test. Expectations are on the lines of the program, see `suite/grammar.rs`. To add a
//! test, add a file.

#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    reason = "a test reads the programs of its folder"
)]

#[path = "suite/check.rs"]
mod check;
#[path = "suite/grammar.rs"]
mod grammar;
#[path = "suite/runner.rs"]
mod runner;
#[path = "suite/self_test.rs"]
mod self_test;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use libtest_mimic::{Arguments, Trial};

fn main() -> ExitCode {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut trials = Vec::new();
    for folder in ["tests/suite", "examples"] {
        let mut files = Vec::new();
        collect(&root.join(folder), &mut files);
        files.sort();
        assert!(!files.is_empty(), "no program under {folder}");
        trials.extend(files.into_iter().map(|file| trial(&root, file)));
    }
    for case in self_test::CASES {
        let run = || self_test::run(case).map_err(Into::into);
        trials.push(Trial::test(format!("the runner: {}", case.0), run));
    }
    libtest_mimic::run(&Arguments::from_args(), trials).exit_code()
}

fn trial(root: &Path, file: PathBuf) -> Trial {
    let name = file.strip_prefix(root).unwrap_or(&file).display().to_string();
    Trial::test(name.clone(), move || {
        let text = fs::read_to_string(&file)?;
        check::check(&name, &text).map_err(Into::into)
    })
}

/// The programs of a folder and of the folders in it.
fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            collect(&path, files);
        } else if path.extension().is_some_and(|ending| ending == "nc" || ending == "ngc") {
            files.push(path);
        }
    }
}
