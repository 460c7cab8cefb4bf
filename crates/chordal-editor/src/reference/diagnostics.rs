//! `docs/reference/diagnostics.md`: every problem that Chordal reports.

use chordal::Code;
use chordal::control::CONTROLS;
use chordal::diagnostics::CodeInfo;

use crate::meaning::without_places;
use crate::reference::{HEAD, cell, table_row};

/// The page.
pub(super) fn page() -> String {
    let mut text = format!(
        "# Diagnostics\n\n{HEAD}\n\
         `chordal explain CH401` prints the same for one code. A code never changes its meaning. The severity\n\
         is the usual one; a message may have another one if the control treats the case differently.\n\n\
         | code | name | severity | meaning |\n|---|---|---|---|\n"
    );
    for code in Code::all() {
        let info = code.info();
        let link = format!("[{}](#{})", info.id, anchor(info));
        let severity = info.severity.word().to_string();
        text.push_str(&table_row(&[link, info.name.into(), severity, cell(info.summary)]));
    }
    for code in Code::all() {
        text.push_str(&entry(code));
    }
    text
}

/// The anchor that a heading of the page gets.
pub(super) fn anchor(info: &CodeInfo) -> String {
    format!("{}-{}", info.id.to_lowercase(), info.name)
}

fn entry(code: Code) -> String {
    let info = code.info();
    let mut text = format!("\n## {} {}\n\n", info.id, info.name);
    text.push_str(&format!("**{}: {}.**\n\n", info.severity.word(), info.summary));
    text.push_str(&format!("{}\n", info.explanation.trim()));
    let shown = CONTROLS.iter().filter_map(|table| Some((table, table.alarm(code)?)));
    let mut shown = shown.peekable();
    if shown.peek().is_some() {
        text.push_str("\n| control | shows |\n|---|---|\n");
    }
    for (table, alarm) in shown {
        let link = format!("[{}](controls/{}.md#alarms)", table.title, table.name);
        text.push_str(&table_row(&[link, cell(&without_places(alarm))]));
    }
    text
}
