//! A changed program as JSON.

use chordal::Job;
use chordal::diagnostics::FileId;
use chordal::stock::ApproachCheck;
use chordal_rewrite::restart::{RestartProgram, RestartRefusal};
use chordal_rewrite::{Change, SplitProgram, TransformRefusal, TransformedProgram};
use serde_json::{Value, json};

use crate::comparison::certificate_value;

/// One JSON object, schema `chordal.transform/1`: what was changed and why, line by line, what is to be
/// known beside it, and the certificate, which is a comparison of the path that is meant (`a`) with the
/// new one (`b`). `written` is the name of the file that was written, if one was.
pub fn transformed_json(
    done: &TransformedProgram,
    jobs: [&Job; 2],
    written: Option<&str>,
) -> String {
    let certificate = &done.certificate;
    let before = jobs[0].sources().get(FileId(0)).map_or(0, |source| source.text().len());
    let document = json!({
        "schema": "chordal.transform/1",
        "verdict": if certificate.holds() { "proved" } else { "not proved" },
        "written": written,
        "bytes": { "before": before, "after": done.text.len() },
        "notes": done.notes,
        "changes": changes(&done.changes),
        "certificate": certificate_value(certificate, jobs),
    });
    crate::pretty_json(document)
}

fn changes(changes: &[Change]) -> Vec<Value> {
    let one = |change: &Change| {
        json!({
            "line": change.line,
            "before": change.before,
            "after": change.after,
            "reason": change.reason,
        })
    };
    changes.iter().map(one).collect()
}

/// A program in parts, in the same schema: `parts` with their lines of the whole, the lines that are put
/// in to begin with. `changed` is what was done before it was split, to the first
/// of the jobs; its certificate is `changed`. `written` are the names of the files.
pub fn split_json(
    done: &SplitProgram,
    changed: Option<&TransformedProgram>,
    jobs: [&Job; 2],
    written: &[String],
) -> String {
    let certificate = &done.certificate;
    let parts = done.parts.iter().enumerate().map(|(index, part)| {
        json!({
            "number": part.number,
            "lines": part.lines,
            "bytes": part.text.len(),
            "begins": match (index, part.at_tool_change) {
                (0, _) => "as the whole",
                (_, true) => "before a tool change",
                (_, false) => "clear",
            },
            "put_in": part.begin,
            "written": written.get(index),
        })
    });
    let of_change = |changed: &TransformedProgram| certificate_value(&changed.certificate, jobs);
    let notes = changed.map(|changed| changed.notes.as_slice()).unwrap_or_default();
    let document = json!({
        "schema": "chordal.transform/1",
        "verdict": if certificate.holds() { "proved" } else { "not proved" },
        "notes": notes.iter().chain(&done.notes).collect::<Vec<&String>>(),
        "changes": changed.map(|changed| changes(&changed.changes)).unwrap_or_default(),
        "parts": parts.collect::<Vec<Value>>(),
        "certificate": certificate_value(certificate, [jobs[1], jobs[1]]),
        "changed": changed.map(of_change),
    });
    crate::pretty_json(document)
}

/// A program that stays as it is, in the same schema.
pub fn refusal_json(refusal: &TransformRefusal, file: &str) -> String {
    let document = json!({
        "schema": "chordal.transform/1",
        "verdict": "refused",
        "file": file,
        "line": refusal.line,
        "text": refusal.text,
        "message": refusal.what,
        "help": refusal.help,
    });
    crate::pretty_json(document)
}

/// A program that begins at a line, or why it cannot: schema `chordal.restart/1`. `written` is the name of
/// the file that was written, if one was.
pub fn restart_json(
    done: Result<&RestartProgram, &RestartRefusal>,
    file: &str,
    written: Option<&str>,
    approach: Option<&ApproachCheck>,
) -> String {
    let course =
        approach.map(|approach| json!({ "moves": approach.moves, "not_proved": approach.unknown }));
    let codes = done.map(|done| done.unrepeated.as_slice()).unwrap_or_default();
    let not_repeated: Vec<Value> =
        codes.iter().map(|code| json!({ "words": code.words, "line": code.line })).collect();
    let document = match done {
        Ok(done) => json!({
            "schema": "chordal.restart/1",
            "verdict": "proved",
            "file": file,
            "line": done.line,
            "put_in": done.head,
            "after_the_end": done.after_the_end,
            "moves": done.moves,
            "goes_to_first_place_itself": done.approaches,
            "from_the_start_of_the_whole": done.from_the_start,
            "not_repeated": not_repeated,
            "way_in": course,
            "written": written,
        }),
        Err(refused) => json!({
            "schema": "chordal.restart/1",
            "verdict": "refused",
            "reason": refused.reason.word(),
            "file": file,
            "line": refused.refusal.line,
            "text": refused.refusal.text,
            "message": refused.refusal.what,
            "help": refused.refusal.help,
        }),
    };
    crate::pretty_json(document)
}
