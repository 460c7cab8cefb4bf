//! How far above the physical limit a program runs.

use chordal::Job;
use chordal::time::{LeastReport, LeastTimes, TimeReport};
use comfy_table::Table;

use super::cells::{MAX_OPERATIONS, fine, lines};
use crate::numbers::short;
use crate::summary::{plain_table, tool_name};

/// Title of the table.
pub const TITLE: &str = "above the physical limit";

/// The whole and each operation: its time, the least times and what it takes beyond the one
/// with jerk.
pub fn table(least: &LeastReport, time: &TimeReport, job: &Job) -> Table {
    let header = ["tool", "lines", "time", "without jerk", "with jerk", "above"];
    let mut table = plain_table(&header, 2);
    if least.operations.len() > 1 {
        let operations = time.operations.iter().zip(&least.operations);
        for (operation, least) in operations.take(MAX_OPERATIONS) {
            table.add_row(row([tool_name(operation.tool, job), lines(operation)], least));
        }
    }
    table.add_row(row(["all".to_string(), String::new()], &least.whole));
    table
}

fn row(head: [String; 2], least: &LeastTimes) -> Vec<String> {
    let known = least.unknown_s <= 0.0;
    let reference = if known { fine(least.reference_s) } else { "unknown".to_string() };
    let times = [fine(least.time_s), fine(least.bound_s), reference, above(least)];
    head.into_iter().chain(times).collect()
}

/// Per cent above the reference; where that is unknown, above the bound, which is no more than
/// an upper limit.
fn above(least: &LeastTimes) -> String {
    let (sign, base) =
        if least.unknown_s > 0.0 { ("< ", least.bound_s) } else { ("", least.reference_s) };
    if base <= 0.0 {
        return "-".to_string();
    }
    format!("{sign}{} %", short((least.time_s / base - 1.0).max(0.0) * 100.0, 1))
}

/// What the columns mean, and what is missing.
pub fn notes(least: &LeastReport) -> Vec<String> {
    let mut notes = vec![
        "without jerk: the least time in which every axis keeps its limits of velocity and acceleration; with \
         jerk: its limit of jerk, too; on the same path, with the same stops"
            .to_string(),
    ];
    let LeastTimes { unknown_s, time_s, .. } = least.whole;
    if unknown_s > 0.0 {
        notes.push(format!(
            "{} of the time ({}) is in runs too long for the limit with jerk: there the part above is \
             compared with the limit without jerk",
            format_args!("{} %", short(unknown_s / time_s * 100.0, 0)),
            fine(unknown_s)
        ));
    }
    notes
}
