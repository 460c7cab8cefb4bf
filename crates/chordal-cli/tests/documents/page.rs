//! The pages: `docs/documents.md`, and one of each document in `docs/documents/`.

use std::fmt::Write;

use crate::rows::{Document, Kind, Row};

/// Every page: where it lies, and its text.
pub fn pages(files: &[(String, Document)]) -> Vec<(String, String)> {
    let mut pages = vec![("docs/documents.md".into(), index(files))];
    for (file, document) in files {
        pages.push((format!("docs/documents/{}.md", stem(file)), of_document(file, document)));
    }
    pages
}

fn stem(file: &str) -> &str {
    file.strip_suffix(".toml").unwrap_or(file)
}

fn index(files: &[(String, Document)]) -> String {
    let mut text = String::from(
        "# What the four documents say, and where it is tested\n\n\
         Chordal carries out what four documents say of interpolation. Each has a page with the list of\n\
         its statements, in words of our own, each with the test that shows it. A test fails on a line\n\
         of a document that is in no row, and on a row that has no test. The lists themselves are in\n\
         [tests/documents](../tests/documents); `DOCUMENTS_PAGE=write cargo test -p chordal-cli --test\n\
         documents` writes these pages.\n\n",
    );
    totals(&mut text, files);
    text
}

fn of_document(file: &str, document: &Document) -> String {
    let Document { name, title, lines, .. } = document;
    let mut text = format!(
        "# {name} {title}\n\n\
         What the {lines} lines of this document say, each row with its test; the other documents are in\n\
         [the list of the four](../documents.md). A *program* is in\n\
         [{file}](../../tests/documents/{file}), with what it must do on its lines.\n\n\
         | lines | | what it says | where it is tested |\n|---|---|---|---|\n"
    );
    for row in document.row.iter().filter(|row| row.kind != Kind::Nothing) {
        let says = row.says.trim().replace('|', "\\|").replace('\n', " ");
        let (lines, kind) = (&row.lines, row.kind.name());
        let _ = writeln!(text, "| {lines} | {kind} | {says} | {} |", tested(row));
    }
    text
}

fn totals(text: &mut String, files: &[(String, Document)]) {
    let kinds = || Kind::ALL.into_iter().filter(|kind| *kind != Kind::Nothing);
    let names: Vec<&str> = kinds().map(Kind::name).collect();
    let _ = writeln!(text, "| document | lines | rows | {} | not carried out |", names.join(" | "));
    let _ = writeln!(text, "|---|---|---|{}---|", "---|".repeat(names.len()));
    for (file, document) in files {
        let rows = || document.row.iter().filter(|row| row.kind != Kind::Nothing);
        let counts: Vec<String> =
            kinds().map(|kind| rows().filter(|row| row.kind == kind).count().to_string()).collect();
        let left_out = rows().filter(|row| row.not_carried_out.is_some()).count();
        let Document { name, title, lines, .. } = document;
        let count = rows().count();
        let _ = writeln!(
            text,
            "| [{name} {title}](documents/{}.md) | {lines} | {count} | {} | {left_out} |",
            stem(file),
            counts.join(" | ")
        );
    }
}

fn tested(row: &Row) -> String {
    let mut places = Vec::new();
    if let Some(command) = &row.command {
        places.push(format!("`{}`", command.replace('|', "\\|")));
    } else if row.program.is_some() {
        places.push("program".into());
    }
    for test in &row.tests {
        let path = test.split_once(": ").map_or(&**test, |(path, _)| path);
        let name = path.rsplit('/').next().unwrap_or(path);
        let place = format!("[{name}](../../{path})");
        if !places.contains(&place) {
            places.push(place);
        }
    }
    if let Some(reason) = &row.not_carried_out {
        places.push(format!("not carried out: {}", reason.trim().replace('|', "\\|")));
    }
    places.join(", ")
}
