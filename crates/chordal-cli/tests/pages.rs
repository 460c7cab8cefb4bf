//! The pages of `docs/`: those that are written from tables say what the tables say, those that show
//! commands show what the commands print, and no link leads nowhere.
//!
//! `DOCUMENTS_PAGE=write cargo test -p chordal-cli --test pages` writes tables and outputs anew.

#![cfg(unix)]
#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    reason = "a test reads the pages and runs the command"
)]

#[path = "pages/links.rs"]
mod links;
#[path = "pages/walk.rs"]
mod walk;

use std::fs;
use std::path::{Path, PathBuf};

use chordal::Machine;
use chordal::machine::ControlName;
use chordal_editor::reference;

/// Pages whose commands are run.
const WALKS: &[&str] = &[
    "docs/from-fadal-to-haas.md",
    "docs/grbl.md",
    "docs/getting-started/heidenhain.md",
    "docs/getting-started/lathe.md",
    "docs/getting-started/machinist.md",
    "docs/getting-started/post-developer.md",
    "docs/getting-started/siemens.md",
    "docs/optimize.md",
    "docs/transform.md",
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn writes() -> bool {
    std::env::var_os("DOCUMENTS_PAGE").is_some_and(|wanted| wanted == "write")
}

/// Holds a page against what it must be, or writes it.
fn hold(path: &str, text: &str) {
    if writes() {
        let path = root().join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
        return;
    }
    let written = fs::read_to_string(root().join(path)).unwrap_or_default();
    let differs = written.lines().zip(text.lines()).position(|(one, other)| one != other);
    let line = differs.unwrap_or(written.lines().count().min(text.lines().count())) + 1;
    let lines = (written.lines().nth(line - 1), text.lines().nth(line - 1));
    assert!(
        written == text,
        "{path} is out of date from line {line} on: {lines:#?}\n\
         DOCUMENTS_PAGE=write cargo test -p chordal-cli --test pages"
    );
}

#[test]
fn generated_pages_say_what_the_tables_say() {
    for (path, text) in reference::pages() {
        hold(&path, &text);
    }
}

#[test]
fn the_type_of_controls_in_python_has_them_all() {
    let name = |control: &ControlName| format!("        \"{control}\",\n");
    let names: String = ControlName::ALL.iter().map(name).collect();
    hold(
        "python/chordal/_control.py",
        &format!(
            "\"\"\"The names of the controls. Generated: see CONTRIBUTING.md, Change a page.\"\"\"\n\n\
             from typing import TYPE_CHECKING, Literal\n\n\
             if TYPE_CHECKING:\n    \
             #: The controls that can run a program.\n    \
             _ControlName = Literal[\n{names}    ]\n"
        ),
    );
}

#[test]
fn the_codes_that_are_not_carried_out_are_listed() {
    let (path, begin, end) =
        ("docs/not-supported.md", "<!-- begin: codes -->\n", "<!-- end: codes -->\n");
    let page = read(path);
    let (head, rest) = page.split_once(begin).expect("where the codes begin");
    let (_, tail) = rest.split_once(end).expect("where the codes end");
    hold(path, &format!("{head}{begin}\n{}\n{end}{tail}", reference::codes_not_carried_out()));
}

#[test]
fn pages_with_commands_show_what_they_print() {
    for path in WALKS {
        hold(path, &walk::walked(path, &read(path)));
    }
}

#[test]
fn every_example_of_a_machine_file_is_read_and_every_key_has_one() {
    let page = read("docs/machine-files.md");
    let mut given = Vec::new();
    for example in page.split("```toml\n").skip(1) {
        let example = example.split("```").next().unwrap();
        let whole = match example.contains("inherits") {
            true => example.to_string(),
            // Keys outside of tables come first.
            false => format!("inherits = 'fanuc-30i'\n{example}"),
        };
        // Both forms of a probe's target are shown: they are two files.
        for part in whole.split("# or planes\n") {
            let part = if part.contains("inherits") {
                part.into()
            } else {
                format!("control = 'fanuc'\n{part}")
            };
            if let Err(errors) = Machine::from_toml("page.toml", &part, &|name| Err(name.into())) {
                panic!("{part}\n{errors:?}");
            }
            paths_of(String::new(), &part.parse().expect("TOML"), &mut given);
        }
    }
    for key in chordal::machine::schema_keys() {
        let names: Vec<&str> = key.path.split('.').collect();
        // Stock, fixtures and target have the same keys: an example of one shows all.
        let of_body = match names[..] {
            ["stock" | "target", ..] => Some(1),
            ["fixtures", ..] => Some(2),
            _ => None,
        };
        let shown = given.iter().any(|path| {
            let is_own = path.len() == names.len()
                && path.iter().zip(&names).all(|(own, name)| own == name || name.starts_with('<'));
            let is_like = of_body.is_some_and(|from| {
                let own = match path[0].as_str() {
                    "stock" | "target" => 1,
                    "fixtures" => 2,
                    _ => return false,
                };
                path.len() > own
                    && path.len() - own == names.len().saturating_sub(from)
                    && path[own..]
                        .iter()
                        .zip(&names[from..])
                        .all(|(own, name)| own == name || name.starts_with('<'))
            });
            is_own || is_like
        });
        assert!(shown, "no example shows `{}`", key.path);
    }
}

/// The names of all keys and tables, one after another.
fn paths_of(before: String, table: &toml::Table, found: &mut Vec<Vec<String>>) {
    for (name, value) in table {
        let path = format!("{before}{name}\0");
        found.push(path.split_terminator('\0').map(String::from).collect());
        if let toml::Value::Table(inner) = value {
            paths_of(path, inner, found);
        }
    }
}

/// The first thing that a reader sees is a message that the command prints.
#[test]
fn the_message_of_the_readme_is_one() {
    let page = read("README.md");
    let shown = page.split("```text\n").nth(1).and_then(|rest| rest.split("```").next()).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let program = "M6 T1\nG0 G90 S900 M3 E1 X0 Y0\nH1 Z.1 M8\nG18\nG1 X-3.4585 Z-1.168 F10.\n\
                   X-2.9928 Z-.952 I-.48 K.8314 G2\nM2\n";
    fs::write(folder.path().join("profile.nc"), program).unwrap();
    let command = ["check", "profile.nc", "--machine", "fadal-4020"];
    let done = std::process::Command::new(env!("CARGO_BIN_EXE_chordal"))
        .args(command)
        .current_dir(&folder)
        .env("NO_COLOR", "1")
        .output()
        .unwrap();
    let printed = String::from_utf8(done.stdout).unwrap();
    let start = printed.find("error[").expect("an error");
    let message = printed[start..].split("\n\n").next().unwrap();
    hold("README.md", &page.replacen(shown, &format!("{message}\n"), 1));
}

#[test]
fn no_link_leads_nowhere() {
    // The other tests are writing the pages.
    if writes() {
        return;
    }
    let lost = links::lost(&root());
    assert!(lost.is_empty(), "{lost:#?}");
}
