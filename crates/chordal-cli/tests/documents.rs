//! What the four documents say, held row by row: every line of a document is in a row, every row has a
//! test, and every test shows it. The rows are `tests/documents/*.toml`; the pages that people read are
//! `docs/documents.md` and those of `docs/documents/`.

#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    reason = "a test reads the rows and runs the command"
)]

#[path = "../../chordal/tests/suite/check.rs"]
mod check;
#[path = "../../chordal/tests/suite/grammar.rs"]
mod grammar;
#[path = "documents/page.rs"]
mod page;
#[path = "documents/rows.rs"]
mod rows;
#[path = "../../chordal/tests/suite/runner.rs"]
mod runner;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::sync::Arc;

use libtest_mimic::{Arguments, Trial};
use rows::{Document, Kind, Row};

fn main() -> ExitCode {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let files = read(&root.join("tests/documents"));
    let mut trials = Vec::new();
    for (path, text) in page::pages(&files) {
        let written = root.join(&path);
        if std::env::var_os("DOCUMENTS_PAGE").is_some_and(|wanted| wanted == "write") {
            let folder = written.parent().unwrap_or(&root);
            fs::create_dir_all(folder).expect("the folder of the pages");
            fs::write(&written, &text).expect("the page is written");
        }
        trials.push(Trial::test(format!("{path} is of these rows"), move || {
            let same = fs::read_to_string(&written).is_ok_and(|page| page == text);
            if same { Ok(()) } else { Err("write it anew: see docs/documents.md".into()) }
        }));
    }
    for (file, document) in files {
        let document = Arc::new(document);
        let whole = Arc::clone(&document);
        trials.push(Trial::test(format!("{file}: every line is in a row"), move || {
            match &rows::uncovered(&whole)[..] {
                [] => Ok(()),
                lines => Err(format!("lines of {} in no row: {lines:?}", whole.name).into()),
            }
        }));
        for index in 0..document.row.len() {
            let (document, root) = (Arc::clone(&document), root.clone());
            let row = &document.row[index];
            let says: String = row.says.trim().chars().take(60).collect();
            let name = format!("{file}: row {} (lines {}): {says}", index + 1, row.lines);
            trials.push(Trial::test(name, move || {
                shown(&root, &document, &document.row[index]).map_err(Into::into)
            }));
        }
    }
    libtest_mimic::run(&Arguments::from_args(), trials).exit_code()
}

fn read(folder: &Path) -> Vec<(String, Document)> {
    let entries = fs::read_dir(folder).expect("the folder of the rows");
    let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "toml"));
    paths.sort();
    assert!(!paths.is_empty(), "no rows");
    let documents = paths.into_iter().map(|path| {
        let file = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let text = fs::read_to_string(&path).expect("the rows of a document");
        let document =
            toml::from_str::<Document>(&text).unwrap_or_else(|error| panic!("{file}: {error}"));
        (file, document)
    });
    documents.collect()
}

/// Says why the row is not shown.
fn shown(root: &Path, document: &Document, row: &Row) -> Result<(), String> {
    let (_, last) = row.range().ok_or_else(|| format!("`{}` are no lines", row.lines))?;
    if last > document.lines {
        return Err(format!("the document has {} lines", document.lines));
    }
    if row.kind == Kind::Nothing {
        return Ok(());
    }
    if row.says.trim().is_empty() {
        return Err("it does not say what the document says".into());
    }
    if let Some(command) = &row.command {
        command_shows(row, document, command)?;
    }
    // With a command, too, what stands on the lines must hold.
    let expects = |program: &&String| row.command.is_none() || program.contains("(=");
    if let Some(program) = row.program.as_ref().filter(expects) {
        check::check("row", &with_machine(program, document))?;
    }
    for test in &row.tests {
        stands(root, test)?;
    }
    let held = row.command.is_some() || row.program.is_some() || !row.tests.is_empty();
    match (&row.not_carried_out, held) {
        (None, false) => Err("no test, and no reason why it is not carried out".into()),
        (Some(reason), _) if reason.trim().is_empty() => Err("an empty reason".into()),
        _ => Ok(()),
    }
}

fn with_machine(program: &str, document: &Document) -> String {
    if program.contains("(machine: ") {
        return program.into();
    }
    format!("(machine: {})\n{program}", document.machine)
}

/// Runs the command line in a folder of its own and looks for what it must print.
fn command_shows(row: &Row, document: &Document, line: &str) -> Result<(), String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    if let Some(program) = &row.program {
        let written = fs::write(folder.path().join("part.nc"), program);
        written.map_err(|error| error.to_string())?;
    }
    let mut words = words_of(line).into_iter();
    if words.next().as_deref() != Some("chordal") {
        return Err(format!("`{line}` of {} does not begin with chordal", document.name));
    }
    let done = Command::new(env!("CARGO_BIN_EXE_chordal"))
        .args(words)
        .current_dir(&folder)
        .env("NO_COLOR", "1")
        .output()
        .map_err(|error| error.to_string())?;
    let (out, err) = (String::from_utf8_lossy(&done.stdout), String::from_utf8_lossy(&done.stderr));
    let said = format!("{out}\n{err}");
    if done.status.code() != Some(row.exit) {
        return Err(format!("{line}: exit {:?}, not {}\n{said}", done.status.code(), row.exit));
    }
    if row.prints.is_empty() {
        return Err(format!("{line}: nothing is expected of it"));
    }
    if let Some(text) = row.lacks.iter().find(|text| said.contains(&***text)) {
        return Err(format!("{line}: `{text}` is printed\n{said}"));
    }
    match row.prints.iter().find(|text| !said.contains(&***text)) {
        None => Ok(()),
        Some(text) => Err(format!("{line}: `{text}` is not printed, but\n{said}")),
    }
}

/// Words of a command line; quotes keep spaces.
fn words_of(line: &str) -> Vec<String> {
    let mut words = Vec::new();
    for (index, part) in line.split('"').enumerate() {
        if index % 2 == 1 {
            words.push(part.to_string());
        } else {
            words.extend(part.split_whitespace().map(String::from));
        }
    }
    words
}

/// A test elsewhere: its file is there, the text stands in it, and of a suite program the line is
/// one that expects something.
fn stands(root: &Path, test: &str) -> Result<(), String> {
    let (path, quote) =
        test.split_once(": ").ok_or_else(|| format!("`{test}` is not `path: text in it`"))?;
    let text = fs::read_to_string(root.join(path)).map_err(|error| format!("{path}: {error}"))?;
    let at = text.find(quote).ok_or_else(|| format!("{path} has no `{quote}`"))?;
    let start = text[..at].rfind('\n').map_or(0, |line_end| line_end + 1);
    let quoted = at + quote.len();
    let end = quoted + text[quoted..].find('\n').unwrap_or(text.len() - quoted);
    if path.ends_with(".nc") && !text[start..end].contains("(=") {
        return Err(format!("{path}: nothing is expected of `{quote}`"));
    }
    Ok(())
}
