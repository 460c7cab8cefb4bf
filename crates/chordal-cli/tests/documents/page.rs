//! The page `docs/documents.md`.

use std::fmt::Write;

use crate::rows::{Document, Kind, Row};

/// The page.
pub fn page(files: &[(String, Document)]) -> String {
    let mut text = String::from(
        "# What the four documents say, and where it is tested\n\n\
         Chordal carries out what four documents say of interpolation. This is the list of their\n\
         statements, in words of our own, each with the test that shows it. A test fails on a line of a\n\
         document that is in no row, and on a row that has no test. The list itself is in\n\
         [tests/documents](../tests/documents); `DOCUMENTS_PAGE=write cargo test -p chordal-cli --test\n\
         documents` writes this page.\n\n",
    );
    totals(&mut text, files);
    for (file, document) in files {
        section(&mut text, file, document);
    }
    text
}

fn totals(text: &mut String, files: &[(String, Document)]) {
    let kinds = || Kind::ALL.into_iter().filter(|kind| *kind != Kind::Nothing);
    let names: Vec<&str> = kinds().map(Kind::name).collect();
    let _ = writeln!(text, "| document | lines | rows | {} | not carried out |", names.join(" | "));
    let _ = writeln!(text, "|---|---|---|{}---|", "---|".repeat(names.len()));
    for (_, document) in files {
        let rows = || document.row.iter().filter(|row| row.kind != Kind::Nothing);
        let counts: Vec<String> =
            kinds().map(|kind| rows().filter(|row| row.kind == kind).count().to_string()).collect();
        let left_out = rows().filter(|row| row.not_carried_out.is_some()).count();
        let Document { name, title, lines, .. } = document;
        let count = rows().count();
        let _ = writeln!(
            text,
            "| {name} {title} | {lines} | {count} | {} | {left_out} |",
            counts.join(" | ")
        );
    }
}

fn section(text: &mut String, file: &str, document: &Document) {
    let _ = writeln!(text, "\n## {} {}\n", document.name, document.title);
    text.push_str("| lines | | what it says | where it is tested |\n|---|---|---|---|\n");
    for row in document.row.iter().filter(|row| row.kind != Kind::Nothing) {
        let says = row.says.trim().replace('|', "\\|").replace('\n', " ");
        let (lines, kind) = (&row.lines, row.kind.name());
        let _ = writeln!(text, "| {lines} | {kind} | {says} | {} |", tested(row, file));
    }
}

fn tested(row: &Row, file: &str) -> String {
    let mut places = Vec::new();
    if let Some(command) = &row.command {
        places.push(format!("`{}`", command.replace('|', "\\|")));
    } else if row.program.is_some() {
        places.push(format!("[program](../tests/documents/{file})"));
    }
    for test in &row.tests {
        let path = test.split_once(": ").map_or(&**test, |(path, _)| path);
        let name = path.rsplit('/').next().unwrap_or(path);
        let place = format!("[{name}](../{path})");
        if !places.contains(&place) {
            places.push(place);
        }
    }
    if let Some(reason) = &row.not_carried_out {
        places.push(format!("not carried out: {}", reason.trim().replace('|', "\\|")));
    }
    places.join(", ")
}
