//! What `chordal diff` prints.

use chordal_archive::diff::{DiffRow, FileStatus};

use crate::numbers::{counted, duration, grouped};
use crate::summary::plain_table;

/// New problems of a file that are told in a table of Markdown; the others are counted.
const MAX_LISTED_PER_FILE: usize = 5;

/// Most files with new problems that are told one by one in Markdown. A summary of a job holds a
/// megabyte.
const MAX_FILES: usize = 200;

pub fn json(rows: &[DiffRow]) -> String {
    let document = serde_json::json!({ "schema": "chordal.diff/2", "files": rows });
    chordal_export::pretty_json(document)
}

pub fn text(rows: &[DiffRow], all: bool) -> String {
    let mut table = plain_table(&["file", "change", "how", "time", "problems"], 5);
    for row in listed(rows, all) {
        let (time, problems) = (time(row, " -> "), problems(row));
        table.add_row([row.path.as_str(), row.status.word(), &how(row), &time, &problems]);
    }
    let listed = if table.row_count() > 0 { format!("{table}\n\n") } else { String::new() };
    let mut text = format!("{listed}{}\n", counts(rows));
    if let Some(times) = times(rows) {
        text.push_str(&format!("{times}\n"));
    }
    for row in rows {
        for problem in &row.problems {
            let (severity, code) = (&problem.severity, &problem.code);
            let place = format!("{}:{}", row.path, problem.line);
            text.push_str(&format!("new {severity}[{code}] {place}: {}\n", problem.message));
        }
    }
    text
}

/// A table for a pull request: the counts, the files that differ, the new problems.
pub fn markdown(rows: &[DiffRow], all: bool) -> String {
    let mut text = format!("**{}**", counts(rows));
    if let Some(times) = times(rows) {
        text.push_str(&format!("  \n{times}"));
    }
    text.push_str("\n\n");
    let mut table = String::new();
    for row in listed(rows, all).take(MAX_FILES) {
        let cells = [cell(&row.path), row.status.word().into(), cell(&how(row))];
        let more = [time(row, " → "), problems(row)];
        table.push_str(&format!("| {} |\n", [&cells[..], &more[..]].concat().join(" | ")));
    }
    if !table.is_empty() {
        let head = "| file | change | how | time | problems |\n|---|---|---|---|---|\n";
        text.push_str(&format!("{head}{table}\n"));
    }
    let left = listed(rows, all).count().saturating_sub(MAX_FILES) as u64;
    if left > 0 {
        text.push_str(&format!("… and {}.\n\n", counted(left, "more file", "more files")));
    }
    text.push_str(&new_problems(rows));
    text
}

fn new_problems(rows: &[DiffRow]) -> String {
    let mut text = String::new();
    for row in rows.iter().filter(|row| row.new_problems > 0).take(MAX_FILES) {
        for problem in row.problems.iter().take(MAX_LISTED_PER_FILE) {
            let place = cell(&format!("{}:{}", row.path, problem.line));
            let (severity, code) = (&problem.severity, &problem.code);
            text.push_str(&format!("- {place} {severity} {code}: {}\n", cell(&problem.message)));
        }
        let left = row.new_problems - row.problems.len().min(MAX_LISTED_PER_FILE) as u64;
        if left > 0 {
            text.push_str(&format!("- {}: {} more\n", cell(&row.path), grouped(left)));
        }
    }
    if text.is_empty() { text } else { format!("New problems:\n\n{text}") }
}

fn listed(rows: &[DiffRow], all: bool) -> impl Iterator<Item = &DiffRow> {
    rows.iter().filter(move |row| all || row.status != FileStatus::Same)
}

/// `11 files: 1 same, 10 path; 2 new problems in 1 file, 3 gone`.
fn counts(rows: &[DiffRow]) -> String {
    let count = |status: FileStatus| rows.iter().filter(|row| row.status == status).count() as u64;
    let counts = FileStatus::ALL.iter().filter(|status| count(**status) > 0);
    let counts: Vec<String> =
        counts.map(|status| format!("{} {}", count(*status), status.word())).collect();
    let mut text = counted(rows.len() as u64, "file", "files");
    if !counts.is_empty() {
        text.push_str(&format!(": {}", counts.join(", ")));
    }
    let new: u64 = rows.iter().map(|row| row.new_problems).sum();
    let gone: u64 = rows.iter().map(|row| row.gone_problems).sum();
    if new > 0 {
        let files = rows.iter().filter(|row| row.new_problems > 0).count() as u64;
        let new = counted(new, "new problem", "new problems");
        text.push_str(&format!("; {new} in {}", counted(files, "file", "files")));
    }
    if gone > 0 {
        text.push_str(&format!("; {} gone", counted(gone, "problem", "problems")));
    }
    text
}

/// The times of all changed files that have one before and after.
fn times(rows: &[DiffRow]) -> Option<String> {
    let both: Vec<(f64, f64)> = rows.iter().filter_map(|row| row.time_s).collect();
    let before: f64 = both.iter().map(|both| both.0).sum();
    let after: f64 = both.iter().map(|both| both.1).sum();
    (!both.is_empty()).then(|| {
        let files = counted(both.len() as u64, "changed program", "changed programs");
        let [from, to] = [duration(before), duration(after)];
        format!("Time of {files}: {from} before, {to} after{}", percent(before, after))
    })
}

/// ` (-4.6 %)`; nothing where it is less than a twentieth of a percent.
fn percent(before: f64, after: f64) -> String {
    let change = 100.0 * (after - before) / before;
    if change.is_finite() && change.abs() >= 0.05 {
        format!(" ({change:+.1} %)")
    } else {
        String::new()
    }
}

fn time(row: &DiffRow, arrow: &str) -> String {
    row.time_s.map_or_else(String::new, |(before, after)| {
        let [from, to] = [duration(before), duration(after)];
        let change = percent(before, after);
        if from == to && change.is_empty() { from } else { format!("{from}{arrow}{to}{change}") }
    })
}

fn problems(row: &DiffRow) -> String {
    let parts = [(row.new_problems, "new"), (row.gone_problems, "gone")];
    let parts = parts.iter().filter(|(count, _)| *count > 0);
    parts.map(|(count, what)| format!("{} {what}", grouped(*count))).collect::<Vec<_>>().join(", ")
}

/// Text in a table of Markdown: what would end the cell or be taken as a mark is escaped.
fn cell(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '\n' | '\r' => escaped.push(' '),
            '|' | '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '#' | '&' | '~' | '$' => {
                escaped.extend(['\\', letter]);
            }
            other => escaped.push(other),
        }
    }
    escaped
}

fn how(row: &DiffRow) -> String {
    let mut parts = Vec::new();
    if let Some((low, high)) = row.distance_mm {
        parts.push(if high == 0.0 {
            "the same points, divided or ordered differently".to_string()
        } else if low < 0.000_05 {
            format!("at most {:.4} mm apart", high.max(0.0001))
        } else {
            format!("{low:.4} to {high:.4} mm apart")
        });
    }
    if let Some((before, after)) = row.lines {
        parts.push(match before == after {
            true => format!("from line {before}"),
            false => format!("from lines {before} and {after}"),
        });
    }
    if row.status == FileStatus::Path && row.feeds_differ == Some(true) {
        parts.push("other feeds or speeds".into());
    }
    if matches!(row.status, FileStatus::Path | FileStatus::Feeds)
        && row.functions_differ == Some(true)
    {
        parts.push("other functions".into());
    }
    parts.extend(row.message.clone());
    parts.join(", ")
}
