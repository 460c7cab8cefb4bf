//! Where the time goes.

use chordal_export::numbers::{counted, duration, fixed, grouped};
use maud::{Markup, html};

use super::{left_out, scrolling, tool_name};
use crate::data::{Document, Operation, PlannedTime, ReportedBlock};

/// Operations on the page.
const MAX_OPERATIONS: usize = 60;

pub fn times(document: &Document) -> Markup {
    html! {
        section aria-labelledby="times" {
            h2 #times { "Cycle time" }
            @match &document.time {
                None => p { "Not planned: the limits of the machine cannot be used. `chordal time` says which." },
                Some(time) if time.total_s <= 0.0 => p { "Nothing takes time." },
                Some(time) => {
                    (shares(time))
                    (operations(time))
                    @if !time.longest.is_empty() { (longest(time)) }
                }
            }
        }
    }
}

fn shares(time: &PlannedTime) -> Markup {
    let parts = [
        ("cutting", "Cutting", time.cutting_s),
        ("rapid", "Rapids", time.rapid_s),
        ("other", "Other", time.other_s),
    ];
    let waits: Vec<String> =
        time.waits.iter().map(|wait| format!("{} {}", wait.what, duration(wait.time_s))).collect();
    html! {
        div.keep {
            div.bar aria-hidden="true" {
                @for (class, _, seconds) in parts {
                    i class=(class) style={ "width:" (fixed(100.0 * seconds / time.total_s, 2)) "%" } {}
                }
            }
            p {
                strong { (duration(time.total_s)) } ": "
                @for (index, (class, name, seconds)) in parts.iter().enumerate() {
                    @if index > 0 { ", " }
                    span class={ "key " (class) } aria-hidden="true" {}
                    (name.to_lowercase()) " " (duration(*seconds))
                }
                @if !waits.is_empty() { " (" (waits.join(", ")) ")" }
                "."
            }
            p.faint {
                "The moves without acceleration and deceleration:  " (duration(time.at_feed_s)) "."
                @if time.cuts_without_feed > 0 {
                    " " (counted(time.cuts_without_feed, "cut", "cuts")) " without a feed not counted."
                }
                @if !time.assumed.is_empty() {
                    " The machine file does not give " (time.assumed.join(", ")) "; typical values were taken."
                }
                " Waiting for the operator is not counted."
            }
        }
    }
}

fn operations(time: &PlannedTime) -> Markup {
    html! {
        (scrolling("Times by operation", time.operations.rows.len(), html! { table {
            caption { "By operation" }
            thead {
                tr {
                    th scope="col" { "Tool" }
                    th scope="col" { "Operation" }
                    th scope="col" { "Lines" }
                    th.n scope="col" { "Cutting" }
                    th.n scope="col" { "Rapids" }
                    th.n scope="col" { "Other" }
                    th.n scope="col" { "Time" }
                    th.n scope="col" { "Share" }
                }
            }
            tbody {
                @for each in time.operations.rows.iter().take(MAX_OPERATIONS) { (operation(each, time.total_s)) }
            }
        } }))
        (left_out(&time.operations, MAX_OPERATIONS, "operations"))
    }
}

fn operation(operation: &Operation, total_s: f64) -> Markup {
    let Operation { first_line: first, last_line: last, .. } = operation;
    let share = 100.0 * operation.total_s / total_s;
    html! {
        tr {
            th scope="row" { (tool_name(operation.tool)) }
            td.words { (operation.comment.as_deref().unwrap_or("–")) }
            td { (first) @if last != first { "–" (last) } }
            td.n { (duration(operation.cutting_s)) }
            td.n { (duration(operation.rapid_s)) }
            td.n { (duration(operation.other_s)) }
            td.n { (duration(operation.total_s)) }
            td.n { (fixed(share, 0)) " %" }
        }
    }
}

fn longest(time: &PlannedTime) -> Markup {
    html! {
        div.keep {
            h3 { "The blocks that take the most time" }
            (scrolling("The longest blocks", time.longest.len(), html! { table {
                thead {
                    tr {
                        th scope="col" { "Line" }
                        th scope="col" { "Block" }
                        th.n scope="col" { "Runs" }
                        th.n scope="col" { "Time" }
                        th scope="col" { "Why" }
                    }
                }
                tbody { @for block in &time.longest { (row(block)) } }
            } }))
        }
    }
}

fn row(block: &ReportedBlock) -> Markup {
    html! {
        tr {
            th scope="row" {
                (block.line) @if let Some(file) = &block.file { " of " (file) }
            }
            td.words { code { (block.text) } }
            td.n { (grouped(block.runs)) }
            td.n { (duration(block.time_s)) }
            td { (block.reason) }
        }
    }
}
