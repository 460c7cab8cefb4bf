//! The list of what the documents say: `tests/documents/*.toml`.

use serde::Deserialize;

/// One document.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Document {
    /// Its short name, the first column of the page: `000`.
    pub name: String,
    /// What it is.
    pub title: String,
    /// How many lines it has.
    pub lines: u32,
    /// The machine for programs that name none.
    pub machine: String,
    /// What it says, in its order.
    pub row: Vec<Row>,
}

/// What a row is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// A sentence.
    Statement,
    /// A program or a part of one, as printed.
    Program,
    /// A number of a table, a figure or a sum.
    Value,
    /// A formula.
    Formula,
    /// A printed error.
    Error,
    /// What a reader would try next.
    Variation,
    /// Lines without a statement: titles, contents, page numbers.
    Nothing,
}

impl Kind {
    pub const ALL: [Kind; 7] = [
        Kind::Statement,
        Kind::Program,
        Kind::Value,
        Kind::Formula,
        Kind::Error,
        Kind::Variation,
        Kind::Nothing,
    ];

    pub fn name(self) -> &'static str {
        match self {
            Kind::Statement => "statement",
            Kind::Program => "program",
            Kind::Value => "value",
            Kind::Formula => "formula",
            Kind::Error => "error",
            Kind::Variation => "variation",
            Kind::Nothing => "nothing",
        }
    }
}

/// One statement, and the test that shows it.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Row {
    /// The lines of the document: `12` or `12-14`.
    pub lines: String,
    pub kind: Kind,
    /// What stands there, in words of our own.
    pub says: String,
    /// A program with its expectations on the lines, as those of `tests/suite`. With
    /// `command` it is also the file `part.nc` of the command's folder, and may expect nothing.
    pub program: Option<String>,
    /// A command line, and what it must print.
    pub command: Option<String>,
    #[serde(default)]
    pub prints: Vec<String>,
    /// What the command must not print.
    #[serde(default)]
    pub lacks: Vec<String>,
    /// The exit code of the command.
    #[serde(default)]
    pub exit: i32,
    /// Tests elsewhere: `path: text that stands in it`.
    #[serde(default)]
    pub tests: Vec<String>,
    /// Why it is not carried out.
    pub not_carried_out: Option<String>,
}

impl Row {
    /// First and last line.
    pub fn range(&self) -> Option<(u32, u32)> {
        let (first, last) = self.lines.split_once('-').unwrap_or((&self.lines, &self.lines));
        let (first, last) = (first.trim().parse().ok()?, last.trim().parse().ok()?);
        (1 <= first && first <= last).then_some((first, last))
    }
}

/// Lines of a document in no row.
pub fn uncovered(document: &Document) -> Vec<u32> {
    let mut open: Vec<bool> = vec![true; document.lines as usize + 1];
    for (first, last) in document.row.iter().filter_map(Row::range) {
        for line in first..=last.min(document.lines) {
            open[line as usize] = false;
        }
    }
    (1..=document.lines).filter(|line| open[*line as usize]).collect()
}
