//! The reports, machines and times for the page, as JSON.

use chordal::control::AxisMask;
use chordal::diagnostics::{Applicability, FileId, Fix, Span};
use chordal::geometry::Vec3;
use chordal::machine::{Axis, HolderSegment, RotaryTarget, ToolShape, tool_rotations};
use chordal::stock::StockRunError;
use chordal::time::{TimeReport, TimeShares};
use chordal::tool_comments::known_tools;
use chordal::{Diagnostic, Job, Report, SourceMap};
use chordal_editor::LineColumnIndex;
use chordal_export::{GIVE_OFFSETS, left_out_texts};
use serde_json::{Value, json};

/// The most diagnostics that are sent; further ones are only counted.
const MAX_DIAGNOSTICS: usize = 2_000;

/// The message that there is no stock, with the reason; without one when the machine simply has no stock.
pub fn no_stock(run: u64, failed: &StockRunError) -> Value {
    let help = match failed {
        StockRunError::Setup(setup) => Some(setup.help.clone()),
        StockRunError::NoStock
        | StockRunError::StockNotPlaced(_)
        | StockRunError::Stock(_)
        | StockRunError::Turns
        | StockRunError::Interrupted => None,
    };
    let message = (*failed != StockRunError::NoStock).then(|| failed.to_string());
    json!({ "type": "no_stock", "run": run, "message": message, "help": help })
}

/// The report of a run, without its path.
pub fn report(report: &Report, job: &Job) -> Value {
    let sources = job.sources();
    let mut spots = SourcePlaces { sources, last: None };
    let sent = report.diagnostics.iter().take(MAX_DIAGNOSTICS);
    let dropped: u64 = report.dropped.iter().map(|(_, count)| count).sum();
    let more = report.diagnostics.len().saturating_sub(MAX_DIAGNOSTICS) as u64;
    json!({
        "diagnostics": sent.map(|each| diagnostic(each, &mut spots)).collect::<Vec<_>>(),
        "left_out": dropped + more,
        "errors": report.counts.errors,
        "warnings": report.counts.warnings,
        "notes": report.counts.notes,
        "not_verified_from": report.not_verified_line(sources).map(|(file, line)| json!({
            "file": file,
            "line": line,
            "own": report.not_verified_from.is_some_and(|span| span.file == FileId(0)),
            "path_known": report.is_path_verified(),
        })),
        "never_named": letters(job.not_named_axes().never),
        "named_in_no_cut": letters(job.not_named_axes().in_no_cut),
        "moves_left_out": moves_left_out(report, job),
        "inch": report.summary.inch,
        "own_chords_mm": job.own_chords().map(|(tolerance_mm, _)| tolerance_mm),
        "output": report.output.iter().take(MAX_DIAGNOSTICS).collect::<Vec<_>>(),
        "cut_length_mm": report.summary.feed_length_mm,
        "rapid_length_mm": report.summary.rapid_length_mm,
        "tools": report.summary.tools.iter().map(|tool| json!({
            "number": tool.number,
            "lines": tool.lines,
            "feed_length_mm": tool.feed_length_mm,
            "speeds_rpm": tool.speeds_rpm,
        })).collect::<Vec<_>>(),
        "axes": report.summary.axes.iter().map(|axis| json!({
            "letter": axis.letter.to_string(),
            "range": axis.range,
            "cut_range": axis.cut_range,
        })).collect::<Vec<_>>(),
    })
}

/// Sentences about moves that are not drawn because the zero of their work offset is unknown, and what to do about
/// it; empty when all are drawn.
fn moves_left_out(report: &Report, job: &Job) -> Vec<String> {
    let zeros = &report.summary.unrelated_zeros;
    let mut texts = left_out_texts(zeros, job.profile().work_names);
    if zeros.iter().any(|zero| !zero.is_preset) {
        texts.push(GIVE_OFFSETS.into());
    }
    texts
}

fn letters(axes: AxisMask) -> Vec<String> {
    axes.iter().map(|axis| axis.letter().to_string()).collect()
}

fn diagnostic(diagnostic: &Diagnostic, spots: &mut SourcePlaces<'_, '_>) -> Value {
    let info = diagnostic.code.info();
    let place = spots.place(diagnostic.primary.span);
    let secondary = diagnostic
        .secondary
        .iter()
        .map(|label| json!({ "place": spots.place(label.span), "label": label.text }))
        .collect::<Vec<_>>();
    json!({
        "code": info.id,
        "name": info.name,
        "severity": diagnostic.severity.word(),
        "message": diagnostic.message,
        "place": place,
        "label": diagnostic.primary.text,
        "secondary": secondary,
        "alarm": diagnostic.alarm,
        "notes": diagnostic.notes,
        "help": diagnostic.help,
        "explanation": info.explanation,
        "fix": diagnostic.fix.as_ref().map(|it| fix(it, spots)),
        "other_fixes": diagnostic.other_fixes.iter().map(|it| fix(it, spots)).collect::<Vec<_>>(),
    })
}

fn fix(fix: &Fix, spots: &mut SourcePlaces<'_, '_>) -> Value {
    json!({
        "title": fix.title,
        "replacement": fix.replacement,
        "place": spots.place(fix.span),
        "safe": fix.applicability == Applicability::Safe,
    })
}

/// Converts the locations of problems, which are mostly in order, to lines and columns.
struct SourcePlaces<'s, 't> {
    sources: &'s SourceMap<'t>,
    last: Option<(FileId, LineColumnIndex<'s, 't>)>,
}

impl SourcePlaces<'_, '_> {
    /// The file, the lines (from 1) and the columns (from 0, in UTF-16 code units); null for the program as a whole.
    fn place(&mut self, span: Span) -> Value {
        let source = self.sources.get(span.file).filter(|_| span != Span::default());
        let Some(source) = source else { return Value::Null };
        let places = match &mut self.last {
            Some((file, places)) if *file == span.file => places,
            last => &mut last.insert((span.file, LineColumnIndex::of(source))).1,
        };
        let (line, column) = places.at(span.range.start);
        let (end_line, end_column) = places.at(span.range.end.max(span.range.start));
        json!({
            "file": source.name(),
            "own": span.file == FileId(0),
            "line": line,
            "column": column,
            "end_line": end_line,
            "end_column": end_column,
        })
    }
}

/// The properties of the machine that the page draws or shows.
pub fn machine(job: &Job) -> Value {
    let machine = job.machine();
    let travel =
        [Axis::X, Axis::Y, Axis::Z].map(|axis| machine.axis(axis).and_then(|limits| limits.travel));
    let rotary = [Axis::A, Axis::B, Axis::C].into_iter().zip(&machine.rotary).map(|(axis, own)| {
        json!({
            "letter": axis.letter().to_string(),
            "turns": own.turns.map(RotaryTarget::as_str),
        })
    });
    let rotary: Vec<_> = rotary.collect();
    let rotations = tool_rotations(&machine.rotary);
    let rotations: Vec<_> = rotations
        .iter()
        .map(|rotation| json!({ "axis": rotation.axis, "about": point(rotation.about) }))
        .collect();
    // Includes tools that only comments of the program describe.
    let known = known_tools(job);
    let tools = known.iter().map(|(number, known)| {
        let tool = &known.tool;
        json!({
            "number": number,
            "diameter_mm": tool.diameter_mm,
            "length_mm": tool.length_mm(),
            "corner_radius_mm": tool.corner_radius_mm,
            "shape": tool.shape.map(ToolShape::as_str),
            "point_angle_rad": tool.point_angle_rad,
            "tip_diameter_mm": tool.tip_diameter_mm,
            "nose_radius_mm": tool.nose_radius_mm,
            "width_mm": tool.turning.width_mm,
            "flute_length_mm": tool.flute_length_mm,
            "profile_mm": tool.profile,
            "shank_diameter_mm": tool.shank_diameter_mm,
            "shank_mm": tool.shank.iter().map(solid).collect::<Vec<_>>(),
            "holder_mm": tool.holder.iter().map(solid).collect::<Vec<_>>(),
            "kind": tool.description.as_deref().or(tool.shape.map(ToolShape::as_str)),
            "comment": tool.comment,
        })
    });
    let turns = machine.turns();
    let has = [Axis::X, Axis::Y, Axis::Z].map(|axis| !machine.lacks(axis));
    let factors = [0, 1, 2].map(|axis| machine.written_factor(axis));
    json!({
        // +X is drawn upwards for a rear turret and downwards for a front turret.
        "turret": turns.then(|| machine.turret.as_str()),
        // Axes programmed as diameters are shown as diameters.
        "factors": factors,
        "has": has,
        "name": machine.name,
        "title": machine.title,
        "control": job.profile().title,
        "travel": travel,
        "rotary": rotary,
        "tool_rotations": rotations,
        "tools": tools.collect::<Vec<_>>(),
    })
}

/// The height, the lower and the upper diameter, mm.
fn solid(solid: &HolderSegment) -> [f64; 3] {
    [solid.height_mm, solid.lower_mm, solid.upper_mm]
}

/// The times of the run, its tools and its longest blocks, s.
pub fn times(time: &TimeReport) -> Value {
    let of = |times: &TimeShares| {
        json!({
            "cutting_s": times.cutting_s,
            "rapid_s": times.rapid_s,
            "other_s": times.other_s,
            "total_s": times.total_s(),
        })
    };
    json!({
        "all": of(&time.times),
        "tools": time.tools.iter().map(|tool| json!({
            "number": tool.number,
            "changes": tool.changes,
            "times": of(&tool.times),
        })).collect::<Vec<_>>(),
        "waits": time.waits.iter().map(|(kind, seconds)| json!([kind.name(), seconds]))
            .collect::<Vec<_>>(),
        "longest": time.longest.iter().map(|block| json!({
            "line": block.origin.line,
            "runs": block.runs,
            "time_s": block.time_s,
            "reason": block.reason.word(),
        })).collect::<Vec<_>>(),
    })
}

pub fn point(at: Vec3) -> Value {
    json!([at.x, at.y, at.z])
}
