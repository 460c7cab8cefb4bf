//! The planned time as rows.

use chordal::Job;
use chordal::time::{BlockTime, OperationTime, TimedRun};

use super::stops::other_file;
use super::text::{clean, comment};
use crate::data::{CappedRows, Operation, PlannedTime, ReportedBlock, ReportedTool, WaitTime};

/// Operations that are reported.
const MAX_OPERATIONS: usize = 200;

/// The time; operations without a comment of their own have that of their tool. `head` are the
/// comments at the head of the program.
pub fn time(timed: &TimedRun, tools: &[ReportedTool], head: &[String], job: &Job) -> PlannedTime {
    let (time, motion) = (&timed.time, &timed.motion);
    let operations: Vec<Operation> = time
        .operations
        .iter()
        .take(MAX_OPERATIONS)
        .map(|operation| of_operation(operation, tools, head, job))
        .collect();
    let all = time.operations.len() as u64 + time.operations_left_out;
    let assumed = motion.limits.assumed.iter();
    PlannedTime {
        total_s: time.total_s(),
        cutting_s: time.times.cutting_s,
        rapid_s: time.times.rapid_s,
        other_s: time.times.other_s,
        waits: time
            .waits
            .iter()
            .filter(|(_, seconds)| *seconds > 0.0)
            .map(|(kind, seconds)| WaitTime { what: kind.name(), time_s: *seconds })
            .collect(),
        at_feed_s: time.at_feed_s,
        cuts_without_feed: motion.cuts_without_feed,
        assumed: assumed
            .map(|limit| format!("{} of {}", limit.quantity, limit.axis.letter()))
            .collect(),
        operations: CappedRows { left_out: all - operations.len() as u64, rows: operations },
        longest: time.longest.iter().map(|block| of_block(block, job)).collect(),
    }
}

fn of_operation(
    operation: &OperationTime,
    tools: &[ReportedTool],
    head: &[String],
    job: &Job,
) -> Operation {
    // What stands at the head speaks of the program.
    let own = operation.comment.and_then(|span| comment(span, job));
    let own = own.filter(|text| !head.contains(text));
    let of_tool = || {
        let tool = tools.iter().find(|tool| tool.number == operation.tool)?;
        tool.comment.clone().or_else(|| tool.table.clone())
    };
    Operation {
        tool: operation.tool,
        comment: own.or_else(of_tool),
        first_line: operation.first.line,
        last_line: operation.last.line,
        total_s: operation.times.total_s(),
        cutting_s: operation.times.cutting_s,
        rapid_s: operation.times.rapid_s,
        other_s: operation.times.other_s,
    }
}

fn of_block(block: &BlockTime, job: &Job) -> ReportedBlock {
    ReportedBlock {
        line: block.origin.line,
        file: other_file(job, block.origin.span.file),
        text: clean(&job.sources().words(block.origin.span), 80),
        runs: block.runs,
        time_s: block.time_s,
        reason: block.reason.word(),
    }
}
