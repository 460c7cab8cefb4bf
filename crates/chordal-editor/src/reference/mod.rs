//! The reference pages of `docs/`, written from the tables that the program itself goes by.
//!
//! A page is its path below the folder of the project and its text in Markdown. A test of `chordal-cli`
//! holds the files against these texts and writes them anew.

mod control;
mod diagnostics;
mod language;
mod machine_files;
mod unsupported_codes;

use chordal::control::{CONTROLS, control_profile, vocabulary_groups};
use chordal::machine::ControlName;

/// A page: its path below the root of the project, and its text.
pub type ReferencePage = (String, String);

/// All pages that are written from tables.
pub fn pages() -> Vec<ReferencePage> {
    let mut pages = vec![
        ("docs/machine-files.md".to_string(), machine_files::page()),
        ("docs/reference/diagnostics.md".to_string(), diagnostics::page()),
        ("docs/reference/controls.md".to_string(), index_of_controls()),
    ];
    for table in CONTROLS {
        pages.push((format!("docs/reference/controls/{}.md", table.name), control::page(table)));
    }
    for control in ControlName::ALL {
        let groups = vocabulary_groups(*control);
        if let (Some(profile), false) = (control_profile(*control), groups.is_empty()) {
            let path = format!("docs/reference/controls/{}.md", profile.name);
            pages.push((path, language::page(&profile, &groups)));
        }
    }
    pages
}

/// Every control with its name in machine files, a built-in machine and its page.
fn index_of_controls() -> String {
    let head = "| control | its name in machine files | the machine where only the control is known |\n|---|---|---|\n";
    let mut text = format!(
        "# Controls\n\n{HEAD}\nEach page has the codes, settings and alarms of a control.\n\n{head}"
    );
    for table in CONTROLS {
        let page = format!("[{}](controls/{}.md)", table.title, table.name);
        let names = [table.name, table.default_machine].map(|name| format!("`{name}`"));
        text += &table_row(&[&[page][..], &names].concat());
    }
    for control in ControlName::ALL {
        if let (Some(profile), false) =
            (control_profile(*control), vocabulary_groups(*control).is_empty())
        {
            let page = format!("[{}](controls/{}.md)", profile.title, profile.name);
            let names = [profile.name, profile.default_machine].map(|name| format!("`{name}`"));
            text += &table_row(&[&[page][..], &names].concat());
        }
    }
    text
}

pub use unsupported_codes::codes_not_carried_out;

/// What a generated page says under its title.
const HEAD: &str = "This page is generated from the tables in Chordal; a test compares the two.\n";

/// A text in a cell of a table: one line, no bar.
fn cell(text: &str) -> String {
    let line: Vec<&str> = text.split_whitespace().collect();
    line.join(" ").replace('|', "\\|")
}

/// A row of a table.
fn table_row(cells: &[String]) -> String {
    format!("| {} |\n", cells.join(" | "))
}
