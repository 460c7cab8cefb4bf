//! The time of a program as JSON.

use chordal::control::{Certainty, Origin, PathMode, SettingField, ShortBlocks};
use chordal::diagnostics::{FileId, Span};
use chordal::motion::{MotionReport, PlannerLevel};
use chordal::time::{
    BlockTime, ChordCost, ChordRemedy, CutEnds, LeastTimes, PlanningChange, TimeAlternative,
    TimeShares, TimeStudy,
};
use chordal::{Job, Report};
use serde_json::{Map, Value, json};

/// One JSON object, schema `chordal.time/1`: times in s, lengths in mm.
pub fn time_json(study: &TimeStudy, report: &Report, job: &Job) -> String {
    let (time, motion) = (&study.timed.time, &study.timed.motion);
    let mut whole = Map::new();
    let mut put = |name: &str, value: Value| {
        whole.insert(name.to_string(), value);
    };
    put("schema", json!("chordal.time/1"));
    put("machine", json!(job.machine().name));
    put("total_s", json!(time.total_s()));
    put("total_s_range", json!(study.range_s));
    put("cutting_s", json!(time.times.cutting_s));
    put("rapid_s", json!(time.times.rapid_s));
    put("other_s", json!(time.times.other_s));
    put("lost_s", json!(time.times.lost_s));
    put("at_feed_s", json!(time.at_feed_s));
    put("level", json!(level_word(study.level)));
    if let Some(least) = &study.least {
        least_values(&least.whole).into_iter().for_each(|(name, value)| put(name, value));
    }
    put("moves", json!(time.moves));
    put("tool_changes", json!(time.tool_changes));
    put("tangent_stops", json!(time.tangent_stops));
    put("cut_ends", cut_ends(&time.cut_ends));
    put("errors", json!(report.counts.errors));
    put("verified", json!(report.verified()));
    let waits = time.waits.iter().map(|(kind, seconds)| (kind.name().to_string(), json!(seconds)));
    put("waits", Value::Object(waits.collect()));
    let tools = time
        .tools
        .iter()
        .map(|tool| with_times(json!({"tool": tool.number, "changes": tool.changes}), &tool.times));
    put("tools", tools.collect());
    let operations = time.operations.iter().enumerate().map(|(index, operation)| {
        let (first, last) = (place(&operation.first, job), place(&operation.last, job));
        let head = json!({"tool": operation.tool, "first": first, "last": last});
        let mut row = with_times(head, &operation.times);
        if let Some(comment) = operation.comment.and_then(|span| comment_text(span, job)) {
            row["comment"] = comment.into();
        }
        if let Some(least) = study.least.as_ref().and_then(|least| least.operations.get(index)) {
            least_values(least).into_iter().for_each(|(name, value)| row[name] = value);
        }
        row
    });
    put("operations", operations.collect());
    put("operations_left_out", json!(time.operations_left_out));
    put("longest_blocks", blocks(&time.longest, job));
    put("costliest_blocks", blocks(&time.costliest, job));
    if !study.what_if.is_empty() {
        put("what_if", study.what_if.iter().map(alternative).collect());
    }
    if !study.chords.is_empty() {
        put("short_lines", study.chords.iter().map(short_lines).collect());
    }
    put("assumed", assumed(motion));
    put("cuts_without_feed", json!(motion.cuts_without_feed));
    put("unknown_moves", json!(motion.unknown_moves));
    put("refused_moves", json!(motion.refused_moves));
    crate::pretty_json(Value::Object(whole))
}

/// A comment without its marks and the blanks around it, on one line.
pub fn comment_text(span: Span, job: &Job) -> Option<String> {
    let text = job.sources().get(span.file)?.text();
    let text = String::from_utf8_lossy(span.range.slice(text));
    let marks: &[char] = &['(', ')', ';', '*', '\'', ' ', '\t'];
    Some(text.trim_matches(marks).chars().filter(|c| !c.is_control()).collect())
}

/// `fast` or `best`.
pub fn level_word(level: PlannerLevel) -> &'static str {
    match level {
        PlannerLevel::Fast => "fast",
        PlannerLevel::Best => "best",
    }
}

fn with_times(mut head: Value, times: &TimeShares) -> Value {
    for (name, seconds) in [
        ("total_s", times.total_s()),
        ("cutting_s", times.cutting_s),
        ("rapid_s", times.rapid_s),
        ("other_s", times.other_s),
        ("lost_s", times.lost_s),
    ] {
        head[name] = json!(seconds);
    }
    head
}

/// How the ends of cuts are passed, with the least and the largest tolerance.
fn cut_ends(ends: &CutEnds) -> Value {
    let mut row = json!({
        "at_rest": ends.at_rest,
        "exact": ends.exact,
        "within": ends.within,
        "joined": ends.joined,
    });
    if let Some((least, most)) = ends.tolerance_mm {
        row["least_tolerance_mm"] = json!(least);
        row["largest_tolerance_mm"] = json!(most);
    }
    row
}

/// Where a part was too much work for the reference, there is none, and the share of the time
/// that the part takes is reported.
fn least_values(least: &LeastTimes) -> [(&'static str, Value); 3] {
    let reference = (least.unknown_s <= 0.0).then_some(least.reference_s);
    [
        ("bound_s", json!(least.bound_s)),
        ("reference_s", json!(reference)),
        ("reference_unknown_s", json!(least.unknown_s)),
    ]
}

/// The line; with its file where that is not the program's.
fn place(origin: &Origin, job: &Job) -> Value {
    let name = job.sources().get(origin.span.file).map_or("", |source| source.name());
    match origin.span.file {
        FileId(0) => json!({"line": origin.line}),
        _ => json!({"line": origin.line, "file": name}),
    }
}

fn blocks(blocks: &[BlockTime], job: &Job) -> Value {
    let row = |block: &BlockTime| {
        let mut row = place(&block.origin, job);
        row["text"] = json!(job.sources().words(block.origin.span).trim());
        row["runs"] = json!(block.runs);
        row["time_s"] = json!(block.time_s);
        row["lost_s"] = json!(block.lost_s);
        row["reason"] = json!(block.reason.word());
        if block.lost_s > 0.0 {
            row["loses_by"] = json!(block.loses.word());
        }
        row
    };
    blocks.iter().map(row).collect()
}

fn short_lines(cost: &ChordCost) -> Value {
    let savings = cost.savings.iter().map(|(remedy, saved)| {
        let mut row = match *remedy {
            ChordRemedy::Joined => json!({"with": "joined"}),
            ChordRemedy::Tolerance(mm) => json!({"with": "tolerance", "tolerance_mm": mm}),
            ChordRemedy::Decimals(decimals) => json!({"with": "decimals", "decimals": decimals}),
            ChordRemedy::Finer(mm) => json!({"with": "shorter_lines", "within_mm": mm}),
            ChordRemedy::Arcs { within_mm, pieces } => {
                json!({"with": "arcs", "within_mm": within_mm, "pieces": pieces})
            }
        };
        row["saves_s"] = json!(saved);
        row
    });
    json!({
        "tool": cost.tool,
        "lines": cost.lines,
        "length_mm": cost.length_mm,
        "time_s": cost.time_s,
        "at_feed_s": cost.feed_s,
        "tolerance_mm": cost.tolerance_mm,
        "savings": savings.collect::<Vec<_>>(),
    })
}

fn alternative(alternative: &TimeAlternative) -> Value {
    let mut row = match alternative.change {
        PlanningChange::Feed(part) => json!({"feed_override": part}),
        PlanningChange::Rapid(part) => json!({"rapid_override": part}),
        PlanningChange::Corners(PathMode::ExactStop) => json!({"path_mode": "exact stop"}),
        PlanningChange::Corners(PathMode::ExactPath) => json!({"path_mode": "exact path"}),
        PlanningChange::Corners(PathMode::Continuous { tolerance_mm, .. }) => {
            json!({"path_mode": "continuous", "tolerance_mm": tolerance_mm})
        }
        PlanningChange::Smoothness { level, tolerance_mm } => {
            json!({"smoothness": level, "tolerance_mm": tolerance_mm})
        }
    };
    row["total_s"] = json!(alternative.total_s);
    row
}

/// Limits that the machine file does not give, in mm or degrees and s.
fn assumed(motion: &MotionReport) -> Value {
    let row = |limit: &chordal::motion::AssumedLimit| {
        let rotary = limit.axis.is_rotary();
        let value = if rotary { limit.value.to_degrees() } else { limit.value };
        json!({
            "axis": limit.axis.to_string(),
            "limit": limit.quantity.to_string(),
            "value": value,
            "unit": if rotary { "deg" } else { "mm" },
        })
    };
    motion.limits.assumed.iter().map(row).collect()
}

/// The law of a control without jerk limits, in one sentence.
pub fn junctions_text(job: &Job) -> Option<String> {
    let rules = job.rules().path.junctions?;
    let name = |field| job.own_setting(field).map_or("", |setting| setting.name);
    let title = job.profile().title;
    if let Some(segments) = rules.arc_segments {
        let corners = match rules.speed_steps_mm_s {
            Some([x, y, z]) => format!(
                "at corners X, Y and Z change their speed at once by {x}, {y} and {z} mm/s at most (setting `{}`)",
                name(SettingField::path_speed_step(0))
            ),
            None => format!(
                "a junction deviation of {} mm (setting `{}`)",
                rules.deviation_mm,
                name(SettingField::PATH_JUNCTION_DEVIATION)
            ),
        };
        return Some(format!(
            "times are those of {title}'s own planner: even acceleration, {corners}, arcs as segments of at most {} mm \
             (setting `{}`), {} of them known ahead",
            segments.most_mm,
            name(SettingField::PATH_ARC_SEGMENT_MOST),
            rules.blocks,
        ));
    }
    Some(format!(
        "times are those of {title}'s own planner: even acceleration, no jerk, a junction deviation of {} mm (setting \
         `{}`), arcs as segments within {} mm (setting `{}`), {} of them known ahead",
        rules.deviation_mm,
        name(SettingField::PATH_JUNCTION_DEVIATION),
        rules.arc_tolerance_mm,
        name(SettingField::PATH_ARC_TOLERANCE),
        rules.blocks,
    ))
}

/// How the control takes many short blocks, and how sure that is; `None` where no cut runs into the next.
pub fn short_blocks_text(ends: &CutEnds, job: &Job) -> Option<String> {
    if let Some(text) = junctions_text(job) {
        return Some(text);
    }
    let setting = job.own_setting(SettingField::PATH_SHORT_BLOCKS)?;
    let sure = match setting.certainty {
        Certainty::Documented => "documented",
        Certainty::Inferred => "inferred",
        Certainty::Practice => "known in the trade",
        Certainty::Unknown => "assumed",
    };
    let how = match (ends.joined, ends.within - ends.joined) {
        (0, 0) => return None,
        (0, _) if job.rules().path.short_blocks == ShortBlocks::LookAhead => {
            "each corner is passed by itself: this control joins short blocks only with look-ahead on"
        }
        (0, _) => "each corner is passed by itself: this control joins no short blocks",
        (_, 0) => "many short blocks are joined into one smooth curve",
        _ => "many short blocks are joined into one smooth curve where look-ahead is on",
    };
    Some(format!("{how} ({sure}; setting `{}`)", setting.name))
}
