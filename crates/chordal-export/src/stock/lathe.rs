//! A run on turned stock: words, JSON, the half section as DXF and as a solid.

use std::f64::consts::TAU;
use std::fmt::Write as _;

use chordal::geometry::{Vec2, Vec3};
use chordal::stock::mesh::Mesh;
use chordal::stock::section::{OutlineSegment, Region};
use chordal::stock::{StockVerdict, TurnedMove, TurnedReport, VolumeInterval};
use serde_json::{Map, Value, json};

use super::json::problem;
use super::mesh::{StockMeshError, mesh_file};
use super::text::stock_premise_text;
use super::text::stock_volume;
use crate::format::OutputFormat;
use crate::number::push_finite;
use crate::numbers::duration;

/// Facets of a solid around its axis.
const FACETS: u32 = 180;
/// How far chords of arcs may be off them in a solid, mm.
const CHORD: f64 = 0.005;

/// To a billionth: smaller digits are rounding of sums.
fn rounded(value: f64) -> f64 {
    (value * 1e9).round() / 1e9
}

fn volume_of(amount: VolumeInterval, inch: bool) -> String {
    stock_volume([amount.least, amount.most], inch)
}

fn bounds(amount: VolumeInterval) -> Value {
    json!({ "least": rounded(amount.least), "most": rounded(amount.most) })
}

/// The answer for people, in the units of the program; the problems are printed apart.
pub fn turned_text(found: &TurnedReport) -> String {
    let inch = found.report.summary.inch;
    let length = |mm: f64| {
        if inch { format!("{:.4} in", mm / 25.4) } else { format!("{mm:.3} mm") }
    };
    let mut text = format!("removed     {}\n", volume_of(found.removed_mm3, inch));
    let _ = writeln!(text, "left        {}", volume_of(found.left_mm3, inch));
    for tool in &found.tools {
        let removed = volume_of(tool.removed_mm3, inch);
        let _ = write!(text, "tool {:<6} {removed}", tool.number);
        if tool.deepest.0 > 0.0 {
            let (depth, line) = tool.deepest;
            let _ = write!(text, ", depth of cut up to {} in line {line}", length(depth));
        }
        if let Some(time) = tool.time_s {
            let _ = write!(text, ", {}", duration(time));
        }
        text.push('\n');
    }
    for part in &found.loose {
        let volume_text = volume_of(exactly(part.section.volume()), inch);
        let _ = writeln!(text, "part off    {volume_text}, cut off in line {}", part.line);
    }
    for thread in &found.threads {
        let Some((low, high)) = thread.section.bounds() else { continue };
        let _ = writeln!(
            text,
            "thread      diameter {} to {}, Z {} to {}, until line {}",
            length(2.0 * low.b),
            length(2.0 * high.b),
            length(low.a),
            length(high.a),
            thread.line
        );
    }
    if let Some(target) = &found.target {
        let left_over = volume_of(exactly(target.left_over_mm3), inch);
        let _ = writeln!(
            text,
            "left over   {left_over} outside of the target, at most {} at X{} Z{}",
            length(target.highest_mm),
            length(2.0 * target.at.b),
            length(target.at.a)
        );
        let gone = volume_of(exactly(target.gouged_mm3), inch);
        let _ = writeln!(text, "missing     {gone} of the target");
    }
    text += match found.verdict {
        StockVerdict::Clean => {
            "clean: no rapid, and no shank or holder that is given, touches material; the half section is exact\n"
        }
        StockVerdict::Problems => "problems: see above\n",
        StockVerdict::NotProved => {
            "not proved: no touch was found, and some moves could not be followed, see above\n"
        }
    };
    text += &stock_premise_text(&found.report);
    if !found.threads.is_empty() {
        text += "note: threads are within what is left; volumes count each as between nothing and its whole groove\n";
    }
    text
}

/// What a verdict says, next to a list of problems.
pub fn turned_verdict_text(verdict: StockVerdict) -> &'static str {
    match verdict {
        StockVerdict::Clean => {
            "clean: no rapid, and no shank or holder that is given, touches material; the half section is exact"
        }
        StockVerdict::Problems => "problems: see the list of problems",
        StockVerdict::NotProved => {
            "not proved: no touch was found, and some moves could not be followed"
        }
    }
}

fn exactly(value: f64) -> VolumeInterval {
    VolumeInterval { least: value, most: value }
}

/// The outline of a half section: loops of segments, each with its end, and of an arc centre and sense.
fn loops(region: &Region) -> Value {
    let point = |p: Vec2| json!([rounded(p.a), rounded(p.b)]);
    let segment = |segment: &OutlineSegment| match segment.bend {
        None => json!({ "to": point(segment.end) }),
        Some(bend) => json!({
            "to": point(segment.end),
            "center": point(bend.center),
            "counterclockwise": bend.counterclockwise,
        }),
    };
    let loops = region.shape().into_iter().map(|outline| {
        json!({
            "from": outline.first().map(|first| point(first.start)),
            "segments": outline.iter().map(segment).collect::<Vec<_>>(),
        })
    });
    Value::Array(loops.collect())
}

/// Schema `chordal.stock/1`: lengths in mm, volumes in mm³; places X Y Z with X as a radius, outlines as z and radius,
/// in the frame of the first cut's work offset.
pub fn turned_json(found: &TurnedReport, file: &str) -> String {
    let mut object = Map::new();
    object.insert("schema".into(), json!("chordal.stock/1"));
    object.insert("file".into(), json!(file));
    object.extend(turned_members(found));
    crate::pretty_json(Value::Object(object))
}

/// The members of that object but for its schema and file.
pub(super) fn turned_members(found: &TurnedReport) -> Map<String, Value> {
    let problems: Vec<Value> = found
        .problems
        .iter()
        .map(|found| {
            let at = [found.at.x, found.at.y, found.at.z].map(rounded);
            let more = [("depth_mm", bounds(found.depth_mm)), ("at_mm", json!(at))];
            problem(found.code, (&found.file, found.line), found.tool, more)
        })
        .collect();
    let worst = |(value, line): (f64, u32)| {
        (line > 0).then(|| json!({ "most": rounded(value), "line": line }))
    };
    let tools: Vec<Value> = found
        .tools
        .iter()
        .map(|tool| {
            json!({
                "number": tool.number,
                "moves": tool.moves,
                "removed_mm3": bounds(tool.removed_mm3),
                "time_s": tool.time_s.map(rounded),
                "lowest_mm": rounded(tool.lowest.a),
                "lowest_radius_mm": rounded(tool.lowest.b),
                "depth_of_cut_mm": worst(tool.deepest),
                "chip_area_mm2": worst(tool.largest_chip),
                "power_kw": tool.power.and_then(worst),
            })
        })
        .collect();
    let parts: Vec<Value> = found
        .loose
        .iter()
        .map(|part| {
            json!({
                "line": part.line,
                "tool": part.tool,
                "volume_mm3": rounded(part.section.volume()),
                "section": loops(&part.section),
            })
        })
        .collect();
    let threads: Vec<Value> = found
        .threads
        .iter()
        .map(|thread| {
            json!({
                "line": thread.line,
                "lead_mm": thread.lead_mm.map(rounded),
                "section": loops(&thread.section),
                "grooves": thread.grooves.as_ref().map(loops),
            })
        })
        .collect();
    let target = found.target.map(|target| {
        json!({
            "left_over_mm3": bounds(exactly(target.left_over_mm3)),
            "highest_mm": bounds(exactly(target.highest_mm)),
            "at_mm": [rounded(target.at.b), 0.0, rounded(target.at.a)],
            "missing_mm3": bounds(exactly(target.gouged_mm3)),
        })
    });
    let members = [
        ("exact", json!(true)),
        ("outline_bound_mm", json!(found.bound_mm)),
        ("before_mm3", json!(rounded(found.before_mm3))),
        ("removed_mm3", json!(bounds(found.removed_mm3))),
        ("left_mm3", json!(bounds(found.left_mm3))),
        ("verdict", json!(found.verdict.as_str())),
        ("problems", json!(problems)),
        ("problems_left_out", json!(found.more_problems)),
        ("errors", json!(found.report.counts.errors)),
        ("tools", json!(tools)),
        ("section", json!(loops(&found.section))),
        ("parts", json!(parts)),
        ("threads", json!(threads)),
        ("target", json!(target)),
    ];
    members.into_iter().map(|(name, value)| (name.to_string(), value)).collect()
}

/// Schema `chordal.turning/1`: what every move at feed takes. Lengths in mm, areas in mm², volumes in mm³, mm/min, kW.
pub fn turning_json(found: &TurnedReport, file: &str) -> String {
    let row = |each: &TurnedMove| {
        json!({
            "line": each.origin.line,
            "tool": each.tool,
            "thread": each.is_thread,
            "length_mm": rounded(each.length_mm),
            "engaged_mm": rounded(each.engaged_mm),
            "feed_mm_per_min": rounded(each.feed_mm_per_s * 60.0),
            "spindle_rpm": rounded(each.rpm),
            "depth_mm": rounded(each.depth_mm),
            "area_mm2": rounded(each.area_mm2),
            "removed_mm3": rounded(each.removed_mm3),
            "chip_mm2": each.chip_mm2.map(rounded),
            "chip_mm": each.chip_mm.map(rounded),
            "rate_mm3_per_min": rounded(each.rate_mm3_per_s * 60.0),
            "power_kw": each.power_kw.map(rounded),
        })
    };
    let object = json!({
        "schema": "chordal.turning/1",
        "file": file,
        "power_share": chordal::stock::POWER_SHARE,
        "moves": found.moves.iter().map(row).collect::<Vec<_>>(),
    });
    crate::pretty_json(object)
}

/// How hard each tool works, in the units of the program.
pub fn turning_text(found: &TurnedReport) -> String {
    let inch = found.report.summary.inch;
    let length =
        |mm: f64| if inch { format!("{:.4} in", mm / 25.4) } else { format!("{mm:.3} mm") };
    let area = |mm2: f64| {
        if inch { format!("{:.6} in²", mm2 / 645.16) } else { format!("{mm2:.3} mm²") }
    };
    let mut text = String::new();
    for tool in &found.tools {
        let _ = writeln!(text, "tool {}: {} moves", tool.number, tool.moves);
        let mut row = |name: &str, value: String, line: u32| {
            let _ = writeln!(text, "  {name:<13} {value:<14} line {line}");
        };
        if tool.deepest.1 > 0 {
            row("depth of cut", length(tool.deepest.0), tool.deepest.1);
        }
        if tool.largest_chip.1 > 0 {
            row("chip area", area(tool.largest_chip.0), tool.largest_chip.1);
        }
        if let Some((power, line)) = tool.power {
            row("power ± 30 %", format!("{power:.2} kW"), line);
        }
    }
    if found.tools.iter().all(|tool| tool.power.is_none()) {
        text += "note: no power: `[stock]` has no `material` of the table in docs/engagement.md or of `[materials]`\n";
    }
    text
}

/// The half section of everything that is left as DXF Release 12, mm: lines and arcs, X along the axis, Y the radius.
pub fn section_dxf(found: &TurnedReport) -> Vec<u8> {
    let mut text = b"0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n".to_vec();
    for segment in found.sections().flat_map(Region::shape).flatten() {
        let (name, groups) = entity(&segment);
        text.extend_from_slice(format!("0\n{name}\n8\nPART\n").as_bytes());
        for (code, value) in groups {
            text.extend_from_slice(format!("{code}\n").as_bytes());
            push_finite(&mut text, value);
            text.push(b'\n');
        }
    }
    text.extend_from_slice(b"0\nENDSEC\n0\nEOF\n");
    text
}

/// The name of an entity and its numbers.
fn entity(segment: &OutlineSegment) -> (&'static str, Vec<(u32, f64)>) {
    let Some(bend) = segment.bend else {
        let (start, end) = (segment.start, segment.end);
        return ("LINE", vec![(10, start.a), (20, start.b), (11, end.a), (21, end.b)]);
    };
    let mut groups = vec![(10, bend.center.a), (20, bend.center.b), (40, bend.radius)];
    if segment.sweep().abs() >= TAU {
        return ("CIRCLE", groups);
    }
    let angle = |p: Vec2| {
        let to = p - bend.center;
        to.b.atan2(to.a).to_degrees().rem_euclid(360.0)
    };
    let ends = [angle(segment.start), angle(segment.end)];
    // Entities turn counter-clockwise.
    let [from, to] = if bend.counterclockwise { ends } else { [ends[1], ends[0]] };
    groups.extend([(50, from), (51, to)]);
    ("ARC", groups)
}

/// What is left as a solid of flat facets: everything that turns, about Z.
///
/// # Errors
/// When it has more triangles than the format can number.
pub fn turned_mesh(
    found: &TurnedReport,
    format: OutputFormat,
    name: &str,
) -> Result<Vec<u8>, StockMeshError> {
    mesh_file(&solid(found), format, name)
}

fn solid(found: &TurnedReport) -> Mesh {
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for outline in found.sections().flat_map(Region::shape) {
        let corners = chords(&outline);
        let firsts: Vec<(u32, u32)> =
            corners.iter().map(|corner| ring(*corner, &mut vertices)).collect();
        for (at, (first, count)) in firsts.iter().enumerate() {
            let (next, next_count) = firsts[(at + 1) % firsts.len()];
            for facet in 0..FACETS {
                let after = (facet + 1) % FACETS;
                let [a, b] = [facet, after].map(|f| first + f % count);
                let [c, d] = [facet, after].map(|f| next + f % next_count);
                // The region is to the left of its outline, the outside to the right.
                if *count > 1 {
                    triangles.push([a, c, b]);
                }
                if next_count > 1 {
                    triangles.push([b, c, d]);
                }
            }
        }
    }
    // Every number is one of a vertex.
    Mesh::new(vertices, triangles).unwrap_or_default()
}

/// The places of a corner all round: one on the axis.
fn ring(corner: Vec2, vertices: &mut Vec<Vec3>) -> (u32, u32) {
    let first = vertices.len() as u32;
    if corner.b <= 1e-12 {
        vertices.push(Vec3::new(0.0, 0.0, corner.a));
        return (first, 1);
    }
    for facet in 0..FACETS {
        let (sine, cosine) = (TAU * f64::from(facet) / f64::from(FACETS)).sin_cos();
        vertices.push(Vec3::new(corner.b * cosine, corner.b * sine, corner.a));
    }
    (first, FACETS)
}

/// Corners of an outline with chords instead of arcs; what lies on the axis has none between its ends.
fn chords(outline: &[OutlineSegment]) -> Vec<Vec2> {
    let mut corners = Vec::new();
    for segment in outline {
        corners.push(segment.start);
        let Some(bend) = segment.bend else { continue };
        let sweep = segment.sweep();
        let step = 2.0 * (1.0 - (CHORD / bend.radius).min(1.0)).acos();
        let count = (sweep.abs() / step.max(1e-3)).ceil().clamp(1.0, 500.0) as u32;
        for part in 1..count {
            let (sine, cosine) = (sweep * f64::from(part) / f64::from(count)).sin_cos();
            let to = segment.start - bend.center;
            corners.push(bend.center + to * cosine + to.turned_left() * sine);
        }
    }
    corners
}
