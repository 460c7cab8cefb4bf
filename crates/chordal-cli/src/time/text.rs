//! The time of a program for people, in 80 columns.

use chordal::control::{PathMode, Units as ProgramUnits};
use chordal::diagnostics::FileId;
use chordal::motion::{LimitedQuantity, MotionReport, PlannerLevel, WaitKind};
use chordal::time::{
    BlockTime, PlanningChange, TimeAlternative, TimeReason, TimeReport, TimeStudy, ToolTime,
};
use chordal::{Job, OtherSides, Report};
use chordal_export::comment_text;
use comfy_table::Table;

use super::cells::{EQUAL_TIME_S, MAX_OPERATIONS, fine, lines};
use super::{chords, corners, least};
use crate::numbers::{counted, short};
use crate::sheet::Sheet;
use crate::summary::{motion_law, plain_table, tool_name};

/// Columns of the text.
const WIDTH: usize = 80;

/// Blocks of the second list, those that lose the most.
const MAX_COSTLIEST: usize = 5;

/// The time of a program.
pub fn text(name: &str, study: &TimeStudy, report: &Report, job: &Job, color: bool) -> String {
    let mut sheet = Sheet::new(name, Some(WIDTH), color);
    let (time, motion) = (&study.timed.time, &study.timed.motion);
    let machine = job.machine();
    sheet.row("machine", &format!("{} ({})", machine.title, machine.name));
    let mut totals = totals(time, motion, study.level);
    if let Some([least, most]) = study.range_s {
        let (least, most) = (fine(least), fine(most));
        totals.push(format!("{least} to {most} with {}", sides_text(&report.other_sides)));
    }
    sheet.rows("time", &totals);
    sheet.table("", &tools(&time.tools, job));
    if time.operations.len() > time.tools.len() {
        let named = time.operations.iter().any(|operation| operation.comment.is_some());
        let title = match named {
            true => "operations, from one comment or tool change to the next",
            false => "operations, from one tool change to the next",
        };
        sheet.table(title, &operations(time, job, named));
        let more = time.operations.len().saturating_sub(MAX_OPERATIONS) as u64;
        if more + time.operations_left_out > 0 {
            let more = counted(more + time.operations_left_out, "operation", "operations");
            sheet.line(&format!("and {more} more"));
        }
    }
    sheet.table("blocks that take the longest", &blocks(&time.longest, |block| block.reason, job));
    let costliest = &time.costliest[..time.costliest.len().min(MAX_COSTLIEST)];
    // In a short program both lists hold the same blocks.
    let longest: Vec<_> = time.longest.iter().map(|block| block.origin.span).collect();
    if costliest.iter().any(|block| !longest.contains(&block.origin.span)) {
        let title = "blocks that lose the most time to acceleration and deceleration";
        sheet.table(title, &blocks(costliest, |block| block.loses, job));
    }
    if let Some(limits) = &study.least {
        sheet.table(least::TITLE, &least::table(limits, time, job));
    }
    sheet.table("what if", &alternatives(&study.what_if, time, report.summary.inch));
    let units = if report.summary.inch { ProgramUnits::Inch } else { ProgramUnits::Millimetre };
    sheet.table(chords::LINES, &chords::lines(&study.chords, job, units));
    sheet.table(chords::REMEDIES, &chords::remedies(&study.chords, job, units));
    let parts = [
        ("limit", study.least.as_ref().map(least::notes).unwrap_or_default()),
        ("corners", corners::notes(time, job, units)),
        ("assumed", notes(time, motion, job)),
    ];
    for (label, notes) in parts.iter().filter(|(_, notes)| !notes.is_empty()) {
        sheet.gap();
        sheet.rows(label, notes);
    }
    sheet.into_text()
}

/// What was run both ways.
fn sides_text(sides: &OtherSides) -> String {
    let count = sides.run.len() as u64;
    let conditions = counted(count, "condition", "conditions");
    match (count, sides.block_delete) {
        (0, _) => "block delete on and off".to_string(),
        (_, false) => format!("both sides of {conditions} that nobody knows"),
        (_, true) => {
            format!("both sides of {conditions} that nobody knows, block delete on and off")
        }
    }
}

fn totals(time: &TimeReport, motion: &MotionReport, level: PlannerLevel) -> Vec<String> {
    let total = time.total_s();
    if total == 0.0 {
        return vec!["nothing moves".to_string()];
    }
    let tried = match level {
        PlannerLevel::Fast => "",
        PlannerLevel::Best => " (level best)",
    };
    let times = &time.times;
    let mut shares = vec![("cutting", times.cutting_s), ("rapids", times.rapid_s)];
    shares.extend(time.waits.iter().map(|(kind, seconds)| (kind.name(), *seconds)));
    let shares = shares.iter().filter(|(_, seconds)| *seconds > 0.0);
    let parts: Vec<String> =
        shares.map(|(what, seconds)| format!("{what} {}", fine(*seconds))).collect();
    let moving = times.cutting_s + times.rapid_s;
    let mut rows =
        vec![format!("{}, {}{tried}", fine(total), motion_law(motion)), parts.join(", ")];
    if moving > 0.0 {
        rows.push(format!(
            "acceleration and deceleration take {}, {} % of the time of the moves",
            fine(times.lost_s),
            short(times.lost_s / moving * 100.0, 1)
        ));
    }
    rows
}

fn tools(tools: &[ToolTime], job: &Job) -> Table {
    let header = ["tool", "changes", "cutting", "rapids", "other", "all", "lost"];
    let mut table = plain_table(&header, 1);
    for tool in tools {
        let times = &tool.times;
        table.add_row([
            tool_name(tool.number, job),
            tool.changes.to_string(),
            fine(times.cutting_s),
            fine(times.rapid_s),
            fine(times.other_s),
            fine(times.total_s()),
            fine(times.lost_s),
        ]);
    }
    table
}

/// Longest comment in the table of operations, so that it fits.
const COMMENT: usize = 20;

fn operations(time: &TimeReport, job: &Job, named: bool) -> Table {
    let header = ["tool", "lines", "cutting", "rapids", "other", "all", "comment"];
    let mut table = plain_table(&header[..if named { 7 } else { 6 }], 2);
    if let Some(column) = table.column_mut(6) {
        column.set_cell_alignment(comfy_table::CellAlignment::Left);
    }
    for operation in time.operations.iter().take(MAX_OPERATIONS) {
        let times = &operation.times;
        let mut row = vec![
            tool_name(operation.tool, job),
            lines(operation),
            fine(times.cutting_s),
            fine(times.rapid_s),
            fine(times.other_s),
            fine(times.total_s()),
        ];
        if named {
            let comment = operation.comment.and_then(|span| comment_text(span, job));
            row.push(comment.unwrap_or_default().chars().take(COMMENT).collect());
        }
        table.add_row(row);
    }
    table
}

fn blocks(blocks: &[BlockTime], why: fn(&BlockTime) -> TimeReason, job: &Job) -> Table {
    let mut table = plain_table(&["line", "runs", "time", "lost", "why", "block"], 0);
    for index in 4..6 {
        if let Some(column) = table.column_mut(index) {
            column.set_cell_alignment(comfy_table::CellAlignment::Left);
        }
    }
    for block in blocks {
        table.add_row([
            block.origin.line.to_string(),
            block.runs.to_string(),
            fine(block.time_s),
            fine(block.lost_s),
            why(block).word().to_string(),
            block_text(block, job),
        ]);
    }
    table
}

/// Longest text of a block, so that the table fits.
const BLOCK_TEXT: usize = 26;

/// The block as written, with single spaces, and its file where that is not the program's.
fn block_text(block: &BlockTime, job: &Job) -> String {
    let span = block.origin.span;
    let words = job.sources().words(span);
    let mut text: String = words.split_whitespace().collect::<Vec<_>>().join(" ");
    text.retain(|character| !character.is_control());
    if span.file != FileId(0)
        && let Some(source) = job.sources().get(span.file)
    {
        text = format!("{}: {text}", source.name());
    }
    if text.chars().count() > BLOCK_TEXT {
        text = text.chars().take(BLOCK_TEXT - 1).collect();
        text.push('…');
    }
    text
}

/// Other overrides where they change anything, and other path modes in any case.
fn alternatives(alternatives: &[TimeAlternative], time: &TimeReport, inch: bool) -> Table {
    let mut table = plain_table(&["", "time", "difference"], 1);
    let units = if inch { ProgramUnits::Inch } else { ProgramUnits::Millimetre };
    for TimeAlternative { change, total_s } in alternatives {
        let difference = total_s - time.total_s();
        let same = difference.abs() < EQUAL_TIME_S;
        if same && matches!(change, PlanningChange::Feed(_) | PlanningChange::Rapid(_)) {
            continue;
        }
        let what = match change {
            PlanningChange::Feed(part) => format!("feed override {} %", short(part * 100.0, 0)),
            PlanningChange::Rapid(part) => format!("rapid override {} %", short(part * 100.0, 0)),
            PlanningChange::Corners(PathMode::ExactStop) => {
                "exact stop at every corner".to_string()
            }
            PlanningChange::Corners(PathMode::ExactPath) => "exact path".to_string(),
            PlanningChange::Corners(PathMode::Continuous { tolerance_mm: None, .. }) => {
                "corners as the machine file allows them".to_string()
            }
            PlanningChange::Corners(PathMode::Continuous {
                tolerance_mm: Some(tolerance), ..
            }) => {
                format!("corners within {}", units.length_text(*tolerance))
            }
            PlanningChange::Smoothness { level, tolerance_mm } => {
                let word = ["rough", "medium", "finish"][usize::from(*level).clamp(1, 3) - 1];
                format!("smoothness P{level} ({word}), {}", units.length_text(*tolerance_mm))
            }
        };
        let sign = if difference < 0.0 { "-" } else { "+" };
        let changes =
            if same { "-".to_string() } else { format!("{sign}{}", fine(difference.abs())) };
        table.add_row([what, fine(*total_s), changes]);
    }
    table
}

/// `the machine file gives no max_jerk of X Y Z: 100000 mm/s³ is taken`.
fn assumed(quantity: LimitedQuantity, motion: &MotionReport) -> Option<String> {
    let (key, unit) = match quantity {
        LimitedQuantity::Velocity => ("max_velocity", "s"),
        LimitedQuantity::Acceleration => ("max_acceleration", "s²"),
        LimitedQuantity::Jerk => ("max_jerk", "s³"),
    };
    let of_kind = |rotary: bool| {
        let limits = motion.limits.assumed.iter();
        let mut limits = limits
            .filter(move |limit| limit.quantity == quantity && limit.axis.is_rotary() == rotary)
            .peekable();
        let first = limits.peek()?.value;
        let value = if rotary {
            format!("{} deg/{unit}", short(first.to_degrees(), 0))
        } else {
            format!("{} mm/{unit}", short(first, 0))
        };
        Some((limits.map(|limit| limit.axis.to_string()).collect::<Vec<_>>(), value))
    };
    let kinds: Vec<_> = [false, true].into_iter().filter_map(of_kind).collect();
    let axes: Vec<String> = kinds.iter().flat_map(|(axes, _)| axes.clone()).collect();
    let values: Vec<&str> = kinds.iter().map(|(_, value)| value.as_str()).collect();
    (!axes.is_empty()).then(|| {
        format!(
            "the machine file gives no {key} for {}: {}, typical of such axes, are used",
            axes.join(" "),
            values.join(" and ")
        )
    })
}

/// What the time rests on, in addition to the program.
fn notes(time: &TimeReport, motion: &MotionReport, job: &Job) -> Vec<String> {
    let machine = job.machine();
    let mut notes: Vec<String> = machine.notes.clone();
    for quantity in
        [LimitedQuantity::Velocity, LimitedQuantity::Acceleration, LimitedQuantity::Jerk]
    {
        notes.extend(assumed(quantity, motion));
    }
    for (what, part) in
        [("feed", machine.motion.feed_override()), ("rapid", machine.motion.rapid_override())]
    {
        if part != 1.0 {
            notes.push(format!("the {what} override is {} %", short(part * 100.0, 1)));
        }
    }
    if time.tool_changes > 0 && machine.times.tool_change_s.is_none() {
        notes.push("the machine file gives no time for a tool change (times.tool_change)".into());
    }
    if motion.cuts_without_feed > 0 {
        let cuts = counted(motion.cuts_without_feed, "cut", "cuts");
        notes.push(format!("{cuts} without a feed not counted"));
    }
    if motion.unknown_moves > 0 {
        notes.push(format!(
            "{} between positions that are not all known: work offsets or tool lengths that are \
             not given count as zero",
            counted(motion.unknown_moves, "move", "moves")
        ));
    }
    if let Some(first) = motion.refused.first() {
        notes.push(format!(
            "{} could not be planned; line {}: {}",
            counted(motion.refused_moves, "move", "moves"),
            first.source.origin.line,
            first.error
        ));
    }
    if time.waits.iter().any(|(kind, _)| *kind == WaitKind::Stop) {
        notes.push("the operator's time at program stops is not counted".into());
    }
    notes
}
