//! What a run comes to, as members of the JSON object of its program.

use std::collections::BTreeMap;

use chordal::control::EndReason;
use chordal::machine::ToolShape;
use chordal::stock::StockLeft;
use chordal::time::TimedRun;
use chordal::tool_comments::{KnownTool, known_tools};
use chordal::{AxisTravel, Job, ProgramReading, Report, ToolUse};
use serde_json::{Value, json};

use super::json::problems;
use crate::omissions::left_out_texts;
use crate::stock::left_members;

/// A run for the summary.
pub struct SummarizedRun<'a> {
    /// Its summary and its problems.
    pub report: &'a Report,
    /// Its times, where it was planned.
    pub timed: Option<&'a TimedRun>,
    /// What it leaves of a stock, where one is given.
    pub stock: Option<&'a StockLeft>,
}

/// A run with its problems as one JSON object, schema `chordal.summary/1`: the members of
/// [`json`](super::json()), `summary`, and with a stock `stock` as in `chordal.stock/1`. Lengths in mm, angles in
/// degrees, times in s, feeds in mm/min; `time_s` is null where the run was not planned.
pub fn summary_json(
    run: &SummarizedRun<'_>,
    job: &Job,
    file: &str,
    reading: &ProgramReading<'_>,
) -> String {
    let SummarizedRun { report, timed, stock } = *run;
    let mut object = problems("chordal.summary/1", report, job.sources(), file, reading);
    object.insert("summary".into(), summary(report, job, timed));
    if let Some(found) = stock {
        object.insert("stock".into(), Value::Object(left_members(found)));
    }
    crate::pretty_json(Value::Object(object))
}

fn summary(report: &Report, job: &Job, timed: Option<&TimedRun>) -> Value {
    let summary = &report.summary;
    let known = known_tools(job);
    let blocks: u64 = report.outcomes.iter().map(|run| run.blocks).sum();
    let axes = summary.axes.iter().map(axis);
    let tools = summary.tools.iter().map(|used| tool(used, &known));
    let repeats = report.outcomes.iter().any(|run| run.end == EndReason::Repeats);
    json!({
        "units": if summary.inch { "inch" } else { "mm" },
        "blocks": blocks,
        "moves": {
            "lines": summary.lines,
            "arcs": summary.arcs,
            "helices": summary.helices,
            "spirals": summary.spirals,
            "splines": summary.splines,
            "rapids": summary.rapids,
            "dwells": summary.dwells,
        },
        "cut_length_mm": summary.feed_length_mm,
        "rapid_length_mm": summary.rapid_length_mm,
        "time_s": timed.map(|timed| timed.time.total_s()),
        "time_without_acceleration_s": summary.total_time_s(),
        "cuts_without_feed": summary.cuts_without_time,
        "tools": tools.collect::<Vec<_>>(),
        "axes": axes.collect::<Vec<_>>(),
        "moves_left_out": left_out_texts(&summary.unrelated_zeros, job.profile().work_names),
        "repeats": repeats,
        "prints": report.output,
    })
}

fn tool(used: &ToolUse, known: &BTreeMap<u32, KnownTool>) -> Value {
    let own = known.get(&used.number).map(|known| &known.tool);
    let lines: Vec<[u32; 2]> = used.lines.iter().map(|(first, last)| [*first, *last]).collect();
    let feeds = used.feeds_mm_per_s.map(|(low, high)| [low * 60.0, high * 60.0]);
    json!({
        "tool": used.number,
        "shape": own.and_then(|tool| tool.shape).map(ToolShape::as_str),
        "diameter_mm": own.and_then(|tool| tool.diameter_mm),
        "lines": lines,
        "feed_mm_per_min": feeds,
        "speeds_rpm": used.speeds_rpm,
        "cut_length_mm": used.feed_length_mm,
        "cut_time_without_acceleration_s": used.feed_time_s,
        "rapid_time_without_acceleration_s": used.rapid_time_s,
    })
}

fn axis(travel: &AxisTravel) -> Value {
    let rotary = matches!(travel.letter, 'A' | 'B' | 'C');
    let ends = |(low, high): (f64, f64)| {
        if rotary { [low.to_degrees(), high.to_degrees()] } else { [low, high] }
    };
    json!({
        "axis": travel.letter,
        "unit": if rotary { "deg" } else { "mm" },
        "range": ends(travel.range),
        "cut_range": travel.cut_range.map(ends),
    })
}
