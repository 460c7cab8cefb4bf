//! Problems as a Code Quality report of GitLab.

use std::collections::BTreeMap;

use chordal::{Diagnostic, Report, Severity, SourceMap};
use serde_json::{Value, json};

use super::github::{file_of, message};
use super::place::place;
use crate::digest::sha256_hex;

/// A Code Quality report of any number of programs: GitLab shows the problems of a merge request
/// next to the lines.
#[derive(Debug, Default)]
pub struct GitlabReport {
    problems: Vec<Value>,
}

impl GitlabReport {
    /// An empty report.
    pub fn new() -> GitlabReport {
        GitlabReport::default()
    }

    /// Adds the problems of a program.
    pub fn add(&mut self, report: &Report, sources: &SourceMap) {
        let mut same: BTreeMap<String, u32> = BTreeMap::new();
        for diagnostic in &report.diagnostics {
            let name = file_of(diagnostic, sources);
            let block = sources.words(diagnostic.primary.span);
            // Lines move when blocks are inserted above; the words and the sentence stay.
            let about =
                format!("{}\n{name}\n{}\n{block}", diagnostic.code.id(), diagnostic.message);
            let again = same.entry(about.clone()).or_default();
            *again += 1;
            let print = sha256_hex(format!("{about}\n{again}").as_bytes());
            self.problems.push(problem(diagnostic, name, &print, sources));
        }
    }

    /// The report as text.
    pub fn finish(self) -> String {
        format!("{:#}\n", Value::from(self.problems))
    }
}

fn problem(diagnostic: &Diagnostic, name: &str, print: &str, sources: &SourceMap) -> Value {
    let severity = match diagnostic.severity {
        Severity::Error => "critical",
        Severity::Warning => "minor",
        Severity::Note => "info",
    };
    let place = place(diagnostic.primary.span, sources);
    let line = place.map_or(1, |place| place.start.line);
    json!({
        "description": message(diagnostic),
        "check_name": format!("{} {}", diagnostic.code.id(), diagnostic.code.info().name),
        "fingerprint": print,
        "severity": severity,
        "location": { "path": name, "lines": { "begin": line } },
    })
}
