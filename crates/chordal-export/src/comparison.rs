//! A comparison of two programs as JSON and as words.

use chordal::Job;
use chordal::control::PathMode;
use chordal::diagnostics::{FileId, Span};
use chordal_compare::{BlockLocation, BlockRange, Comparison, Difference, DifferenceValue as Had};
use chordal_rewrite::Certificate;
use chordal_rewrite::convert::{Conversion, PassChange, PassReading, PeckChange, PeckReading};
use serde_json::{Value, json};

use crate::motion::spindle_word;
use crate::numbers::{self, SummaryUnits};

/// One JSON object, schema `chordal.compare/1`: lengths in mm, feeds in mm/min, angles in degrees, the
/// first program as `a`, the second as `b`.
pub fn comparison_json(found: &Comparison, jobs: [&Job; 2], tolerance_mm: f64) -> String {
    crate::pretty_json(comparison(found, jobs, tolerance_mm))
}

/// A conversion as one JSON object, schema `chordal.convert/1`: the changes, what was refused, the
/// comparison as `proof`, and the new program's text.
pub fn conversion_json(found: &Conversion, old: &Job) -> String {
    let new = found.job("converted");
    let proof = found.certificate.as_ref().zip(new.as_ref()).map(|(certificate, new)| {
        let jobs = [old, new];
        let mut proof = certificate_value(certificate, jobs);
        let expected = certificate.expected.iter().map(|one| difference(one, jobs));
        proof["of_the_machines"] = expected.collect();
        proof
    });
    let changes = found.changes.iter().map(|change| {
        json!({
            "line": change.line,
            "before": change.before,
            "after": change.after,
            "reason": change.reason,
        })
    });
    let refusals = found.refusals.iter().map(
        |refusal| json!({"line": refusal.line, "text": refusal.words, "reason": refusal.reason}),
    );
    let document = json!({
        "schema": "chordal.convert/1",
        "from": old.machine().name,
        "to": found.machine.name,
        "holds": found.holds(),
        "refusals": refusals.collect::<Vec<Value>>(),
        "changes": changes.collect::<Vec<Value>>(),
        "pecks": found.pecks.iter().map(peck_change).collect::<Vec<Value>>(),
        "passes": found.passes.iter().map(pass_change).collect::<Vec<Value>>(),
        "proof": proof,
        "text": found.text,
    });
    crate::pretty_json(document)
}

/// A certificate: the comparison, and which ways through the program it covers.
pub(crate) fn certificate_value(certificate: &Certificate, jobs: [&Job; 2]) -> Value {
    let mut proof = comparison(&certificate.comparison, jobs, certificate.tolerance_mm);
    let sides = &certificate.sides;
    proof["covers"] = json!({
        "conditions": sides.conditions,
        "block_delete": sides.block_delete,
        "complete": sides.is_complete,
    });
    proof
}

fn peck_change(change: &PeckChange) -> Value {
    let reading = |reading: &PeckReading| {
        json!({
            "pecks": reading.pecks,
            "largest_step_mm": reading.largest_step_mm,
            "clearance_mm": reading.clearance_mm,
            "clearance_setting": reading.clearance_setting,
            "above_r_mm": reading.above_r_mm,
            "above_r_setting": reading.above_r_setting,
        })
    };
    json!({
        "line": change.lines[0],
        "new_line": change.lines[1],
        "cycle": change.cycle,
        "holes": change.holes,
        "old": reading(&change.readings[0]),
        "new": reading(&change.readings[1]),
    })
}

fn pass_change(change: &PassChange) -> Value {
    let reading = |reading: &PassReading| {
        json!({
            "cuts": reading.cuts,
            "length_mm": reading.length_mm,
            "largest_step_mm": reading.largest_step_mm,
        })
    };
    json!({
        "line": change.lines[0],
        "new_line": change.lines[1],
        "cycle": change.cycle,
        "old": reading(&change.readings[0]),
        "new": reading(&change.readings[1]),
    })
}

pub(crate) fn comparison(found: &Comparison, jobs: [&Job; 2], tolerance_mm: f64) -> Value {
    let sides = |of: &dyn Fn(usize) -> Value| json!({"a": of(0), "b": of(1)});
    let differences = found.differences.iter().map(|one| difference(one, jobs));
    json!({
        "schema": "chordal.compare/1",
        "verdict": found.verdict,
        "tolerance_mm": tolerance_mm,
        "max_distance_mm": found.max_distance_mm,
        "farthest": found.farthest.map(|at| sides(&|side| {
            let mut at = place(&at[side], jobs[side]);
            at["at_mm"] = json!(found.farthest_at_mm.map(|spots| spots[side]));
            at
        })),
        "programs": sides(&|side| json!({
            "file": file(FileId(0), jobs[side]),
            "machine": jobs[side].machine().name,
            "moves": found.moves[side],
            "errors": found.reports[side].counts.errors,
            "not_verified_from": found.reports[side]
                .not_verified_line(jobs[side].sources())
                .map(|(file, line)| json!({ "file": file, "line": line })),
        })),
        "differences": differences.collect::<Vec<Value>>(),
        "dropped": found.dropped,
    })
}

fn difference(one: &Difference, jobs: [&Job; 2]) -> Value {
    let side = |side: usize| {
        let mut row = match &one.blocks[side] {
            Some(at) => blocks(at, jobs[side]),
            None => json!({}),
        };
        row["steps"] = json!(one.steps[side]);
        if let Some(values) = &one.values {
            row["value"] = value(&values[side]);
        }
        if let Some(spots) = &one.at_mm {
            row["at_mm"] = json!(spots[side]);
        }
        row
    };
    let mut row = json!({"category": one.category, "times": one.times, "a": side(0), "b": side(1)});
    if let Some(distance) = one.distance_mm {
        row["distance_mm"] = json!(distance);
    }
    if let Some(shift) = one.shift_mm {
        row["shift_mm"] = json!(shift);
    }
    row
}

fn blocks(at: &BlockRange, job: &Job) -> Value {
    let (from, to) = at.lines();
    in_file(json!({"lines": [from, to]}), at.first.span, job)
}

fn place(at: &BlockLocation, job: &Job) -> Value {
    in_file(json!({"line": at.line}), at.span, job)
}

/// With the words of a block, and its file where that is not the program's.
fn in_file(mut row: Value, span: Span, job: &Job) -> Value {
    row["text"] = json!(job.sources().words(span).trim());
    if span.file != FileId(0) {
        row["file"] = json!(file(span.file, job));
    }
    row
}

fn file<'a>(file: FileId, job: &'a Job) -> &'a str {
    job.sources().get(file).map_or("", |source| source.name())
}

fn value(had: &Had) -> Value {
    match had {
        Had::Nothing => Value::Null,
        Had::Number(number) => json!(number),
        Had::Feed(mm_per_s) => json!({"mm_per_min": mm_per_s * 60.0}),
        Had::Turn(per_s) => json!({"per_min": per_s * 60.0}),
        Had::FeedPerRevolution(mm) => json!({"mm_per_rev": mm}),
        Had::Spindle(state, rpm) => json!({"state": spindle_word(*state), "rpm": rpm}),
        Had::Seconds(seconds) => json!({"s": seconds}),
        Had::Rotary(axes) => json!({"deg": axes.map(f64::to_degrees)}),
        Had::PathMode(PathMode::Continuous { tolerance_mm, .. }) => {
            json!({"mode": "continuous", "tolerance_mm": tolerance_mm})
        }
        Had::PathMode(mode) => json!({"mode": path_mode(*mode)}),
        other => json!(value_text(other, SummaryUnits::Millimetre)),
    }
}

fn path_mode(mode: PathMode) -> &'static str {
    match mode {
        PathMode::ExactPath => "exact path",
        PathMode::ExactStop => "exact stop",
        PathMode::Continuous { .. } => "continuous",
    }
}

/// What one of the two has, in words and in the units of the program.
pub fn value_text(had: &Had, units: SummaryUnits) -> String {
    let (unit, mm) = (units.length_unit(), units.length_mm());
    let short = |value: f64| numbers::short(value, 4);
    match had {
        Had::Nothing => "none".into(),
        Had::Number(number) => number.to_string(),
        Had::Feed(mm_per_s) => format!("{} {unit}/min", short(mm_per_s * 60.0 / mm)),
        Had::Turn(per_s) => format!("{} moves/min", short(per_s * 60.0)),
        Had::FeedPerRevolution(feed) => format!("{} {unit}/rev", short(feed / mm)),
        Had::Spindle(state, rpm) if *rpm > 0.0 => {
            format!("{} at {} rev/min", spindle_word(*state), short(*rpm))
        }
        Had::Spindle(state, _) => spindle_word(*state).into(),
        Had::Coolant(coolant) => {
            let valves = [
                (coolant.mist, "mist"),
                (coolant.flood, "flood"),
                (coolant.through_tool, "through the tool"),
            ];
            let open: Vec<&str> =
                valves.into_iter().filter(|valve| valve.0).map(|valve| valve.1).collect();
            if open.is_empty() { "off".into() } else { open.join(" and ") }
        }
        Had::PathMode(PathMode::Continuous { tolerance_mm: Some(tolerance), .. }) => {
            format!("continuous within {} {unit}", short(tolerance / mm))
        }
        Had::PathMode(mode) => path_mode(*mode).into(),
        Had::Overrides(overrides) => match (overrides.feed, overrides.rapid) {
            (true, true) => "both act".into(),
            (true, false) => "of the feed alone".into(),
            (false, true) => "of rapids alone".into(),
            (false, false) => "none acts".into(),
        },
        Had::Seconds(seconds) => format!("{} s", short(*seconds)),
        Had::Rotary(axes) => {
            let names = ["A", "B", "C"];
            let axes = names
                .iter()
                .zip(axes)
                .map(|(name, rad)| format!("{name}{}", short(rad.to_degrees())));
            axes.collect::<Vec<String>>().join(" ")
        }
        Had::Text(text) => text.clone(),
    }
}
