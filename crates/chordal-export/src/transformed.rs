//! A changed program as JSON.

use chordal::Job;
use chordal::diagnostics::FileId;
use chordal_rewrite::{Refusal, Transformed};
use serde_json::{Value, json};

use crate::comparison::comparison;

/// One JSON object, schema `chordal.transform/1`: what was changed and why, line by line, what is to be
/// known beside it, and the certificate, which is a comparison of the path that is meant (`a`) with the
/// new one (`b`). `written` is the name of the file that was written, if one was.
pub fn transformed_json(done: &Transformed, jobs: [&Job; 2], written: Option<&str>) -> String {
    let certificate = &done.certificate;
    let changes = done.changes.iter().map(|change| {
        json!({
            "line": change.line,
            "before": change.before,
            "after": change.after,
            "reason": change.reason,
        })
    });
    let before = jobs[0].sources().get(FileId(0)).map_or(0, |source| source.text().len());
    let document = json!({
        "schema": "chordal.transform/1",
        "verdict": if certificate.holds() { "proved" } else { "not proved" },
        "written": written,
        "bytes": { "before": before, "after": done.text.len() },
        "notes": done.notes,
        "changes": changes.collect::<Vec<Value>>(),
        "certificate": comparison(&certificate.comparison, jobs, certificate.tolerance_mm),
    });
    format!("{document:#}\n")
}

/// A program that stays as it is, in the same schema.
pub fn refusal_json(refusal: &Refusal, file: &str) -> String {
    let document = json!({
        "schema": "chordal.transform/1",
        "verdict": "refused",
        "file": file,
        "line": refusal.line,
        "text": refusal.text,
        "message": refusal.what,
        "help": refusal.help,
    });
    format!("{document:#}\n")
}
