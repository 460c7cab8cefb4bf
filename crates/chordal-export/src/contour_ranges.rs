//! The offsets with which contours run, as text and as JSON.

use chordal::control::{CompensationSide, Units};
use chordal::geometry::Plane;
use chordal::path::gouge::LimitReason;
use chordal::{ContourRange, ContourRanges, Job, OffsetLimit};
use serde_json::{Value, json};

/// For people: each contour with what limits it, in the units of the program.
pub fn contour_ranges_text(found: &ContourRanges, job: &Job) -> String {
    let mut text = String::new();
    for (index, range) in found.ranges.iter().enumerate() {
        text += &contour(index + 1, range, job);
    }
    if found.ranges.is_empty() {
        text += "no contour with cutter compensation\n";
    }
    if found.left_out > 0 {
        text += &format!("{} contours were left out: too many or too long\n", found.left_out);
    }
    text
}

fn length(mm: f64, units: Units) -> String {
    units.length_text(rounded_down(mm, units))
}

/// To the digits that are shown: the control takes the offset that is shown.
fn rounded_down(mm: f64, units: Units) -> f64 {
    let (unit, decimals) = match units {
        Units::Inch => (25.4, 4),
        Units::Millimetre => (1.0, 3),
    };
    let step = unit / 10f64.powi(decimals);
    (mm / step + 1e-6).floor() * step
}

fn code(side: CompensationSide) -> &'static str {
    match side {
        CompensationSide::Left => "G41",
        CompensationSide::Right => "G42",
        CompensationSide::Off => "G40",
    }
}

fn plane(plane: Plane) -> &'static str {
    match plane {
        Plane::Xy => "XY",
        Plane::Zx => "ZX",
        Plane::Yz => "YZ",
    }
}

fn lines(limit: &OffsetLimit) -> String {
    let numbers: Vec<String> = limit.blocks.iter().map(|block| block.line.to_string()).collect();
    match numbers.as_slice() {
        [] => String::new(),
        [one] => format!("line {one}"),
        several => format!("lines {}", several.join(", ")),
    }
}

fn reason(limit: &OffsetLimit) -> String {
    let at = lines(limit);
    match limit.reason {
        LimitReason::Unlimited => "no limit".into(),
        LimitReason::InsideArc => format!("{at}: the tool runs inside this arc"),
        LimitReason::ShortBlock => {
            format!("{at}: the offset corners on both sides leave nothing of this block")
        }
        LimitReason::Throat => format!("{at}: these walls face each other at twice this distance"),
        LimitReason::InsideCorner => format!("{at}: no tool reaches this inside corner"),
        LimitReason::LeadArc => {
            format!("{at}: the lead-in or lead-out arc, with the tool inside, shrinks to nothing")
        }
        LimitReason::LeadLength => format!("{at}: the lead-in is not longer than this"),
        LimitReason::LeadIntoWall => {
            format!("{at}: the lead-in starts at this distance from the wall")
        }
    }
}

fn contour(number: usize, range: &ContourRange, job: &Job) -> String {
    let len = |mm: f64| length(mm, range.units);
    let (first, last) = (range.start.line, range.end.line);
    let mut text = format!(
        "contour {number}: lines {first} to {last}, {} in {}",
        code(range.side),
        plane(range.plane)
    );
    if range.runs > 1 {
        text += &format!(", run {} times", range.runs);
    }
    text += "\n";
    let largest = range.largest_mm();
    text += &match largest.is_finite() {
        true => format!(
            "  offsets  radius 0 to {} (tool diameter up to {})\n",
            len(largest),
            range.units.length_text(2.0 * rounded_down(largest, range.units))
        ),
        false => "  offsets  every radius\n".into(),
    };
    text += &match &range.control {
        Some(limit) => {
            let span = limit.alarm.primary.span;
            let line = job.sources().get(span.file).map_or(0, |s| s.line_of(span.range.start));
            let alarm = limit.alarm.alarm.as_deref().unwrap_or(job.profile().title);
            format!(
                "  control  radius up to {}; above that, line {line}: {} ({alarm})\n",
                len(limit.radius_mm),
                limit.alarm.message
            )
        }
        None => format!("  control  {} never alarms\n", job.profile().title),
    };
    for (name, limit) in
        [("gouge  ", &range.no_gouge), ("edges  ", &range.every_edge), ("leads  ", &range.leads)]
    {
        text += &match limit.reason {
            LimitReason::Unlimited => format!("  {name}  no limit\n"),
            _ => format!("  {name}  radius up to {}: {}\n", len(limit.radius_mm), reason(limit)),
        };
    }
    if let Some((block, radius, Some(adjacent))) = range.lead_arc {
        text += &format!(
            "           the lead-in or lead-out arc of line {} has the radius {}; the line to it passes its centre \
             at {}\n",
            block.line,
            range.units.length_text(radius),
            range.units.length_text(adjacent)
        );
    }
    if let (number, Some(radius)) = range.offset {
        let name = number.map_or(String::new(), |number| format!(" {number}"));
        let verdict = if range.fits() { "fits" } else { "does not fit" };
        text += &format!("  table    offset{name} has the radius {}: {verdict}\n", len(radius));
    }
    if !range.complete {
        text += "           the search for narrow places stopped at its limit; there may be narrower ones\n";
    }
    text
}

/// The same as one JSON object, schema `chordal.contour-ranges/1`, in millimetres; no limit is null.
pub fn contour_ranges_json(found: &ContourRanges) -> String {
    let mm = |value: f64| if value.is_finite() { json!(value) } else { Value::Null };
    let limit = |limit: &OffsetLimit| {
        let lines: Vec<u32> = limit.blocks.iter().map(|block| block.line).collect();
        json!({
            "radius": mm(limit.radius_mm),
            "reason": format!("{:?}", limit.reason),
            "lines": lines,
        })
    };
    let contours: Vec<Value> = found
        .ranges
        .iter()
        .map(|range| {
            json!({
                "first_line": range.start.line,
                "last_line": range.end.line,
                "code": code(range.side),
                "plane": plane(range.plane),
                "runs": range.runs,
                "offset": range.offset.0,
                "offset_radius": range.offset.1,
                "smallest": 0.0,
                "largest": mm(range.largest_mm()),
                "fits": range.fits(),
                "control": range.control.as_ref().map(|limit| json!({
                    "radius": limit.radius_mm,
                    "code": limit.alarm.code.info().id,
                    "message": limit.alarm.message,
                    "alarm": limit.alarm.alarm,
                })),
                "no_gouge": limit(&range.no_gouge),
                "every_edge": limit(&range.every_edge),
                "leads": limit(&range.leads),
                "complete": range.complete,
            })
        })
        .collect();
    let whole = json!({
        "schema": "chordal.contour-ranges/1",
        "units": "mm",
        "contours": contours,
        "left_out": found.left_out,
    });
    crate::pretty_json(whole)
}
