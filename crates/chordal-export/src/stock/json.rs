//! A run on stock as one JSON object.

use chordal::Code;
use chordal::stock::{StockReport, VolumeInterval};
use serde_json::{Map, Value, json};

/// To a millionth: smaller digits are rounding of sums.
pub(super) fn rounded(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}

/// Two bounds.
pub(super) fn between(least: f64, most: f64) -> Value {
    json!({ "least": rounded(least), "most": rounded(most) })
}

fn bounds(amount: VolumeInterval) -> Value {
    between(amount.least, amount.most)
}

/// What a problem of a block is, and where, with what else is known of it.
pub(super) fn problem(
    code: Code,
    (file, line): (&str, u32),
    tool: u32,
    more: [(&str, Value); 2],
) -> Value {
    let info = code.info();
    let place = [
        ("code", json!(info.id)),
        ("name", json!(info.name)),
        ("file", json!(file)),
        ("line", json!(line)),
        ("tool", json!(tool)),
    ];
    let members = place.into_iter().chain(more);
    Value::Object(members.map(|(name, value)| (name.to_string(), value)).collect())
}

/// Schema `chordal.stock/1`: lengths in mm, volumes in mm³, places in the frame of the first cut's work offset.
pub fn stock_json(found: &StockReport, file: &str) -> String {
    let mut object = Map::new();
    object.insert("schema".into(), json!("chordal.stock/1"));
    object.insert("file".into(), json!(file));
    object.extend(stock_members(found));
    crate::pretty_json(Value::Object(object))
}

/// The members of that object but for its schema and file.
pub(crate) fn stock_members(found: &StockReport) -> Map<String, Value> {
    let problems: Vec<Value> = found
        .problems
        .iter()
        .map(|found| {
            let at = [found.at.x, found.at.y, found.at.z].map(rounded);
            let more = [("depth_mm", bounds(found.depth_mm)), ("at_mm", json!(at))];
            problem(found.code, (&found.file, found.line), found.tool, more)
        })
        .collect();
    let tools: Vec<Value> = found
        .tools
        .iter()
        .map(|tool| {
            json!({
                "number": tool.number,
                "moves": tool.moves,
                "removed_mm3": bounds(tool.removed_mm3),
                "time_s": tool.time_s.map(rounded),
                "lowest_mm": tool.lowest_mm.is_finite().then(|| rounded(tool.lowest_mm)),
            })
        })
        .collect();
    let target = found.target.map(|target| {
        json!({
            "left_over_mm3": bounds(target.left_over_mm3),
            "highest_mm": bounds(target.highest_mm),
            "at_mm": ([target.at.x, target.at.y, target.at.z].map(rounded)),
        })
    });
    let members = [
        ("resolution_mm", json!(found.resolution_mm)),
        ("refined", json!(found.refined)),
        ("sides", json!(found.sides)),
        ("removed_mm3", bounds(found.removed_mm3)),
        ("left_mm3", bounds(found.left_mm3)),
        ("verdict", json!(found.verdict.as_str())),
        ("problems", json!(problems)),
        ("problems_left_out", json!(found.more_problems)),
        ("errors", json!(found.report.counts.errors)),
        ("tools", json!(tools)),
        ("target", json!(target)),
    ];
    members.into_iter().map(|(name, value)| (name.to_string(), value)).collect()
}
