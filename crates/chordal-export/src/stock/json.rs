//! A run on stock as one JSON object.

use chordal::stock::{Amount, StockReport};
use serde_json::{Value, json};

/// To a millionth: smaller digits are rounding of sums.
fn rounded(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}

fn bounds(amount: Amount) -> Value {
    json!({ "least": rounded(amount.least), "most": rounded(amount.most) })
}

/// Schema `chordal.stock/1`: lengths in mm, volumes in mm³, places in the frame of the first cut's work offset.
pub fn stock_json(found: &StockReport, file: &str) -> String {
    let problems: Vec<Value> = found
        .problems
        .iter()
        .map(|problem| {
            let info = problem.code.info();
            json!({
                "code": info.id,
                "name": info.name,
                "file": problem.file,
                "line": problem.line,
                "tool": problem.tool,
                "depth_mm": bounds(problem.depth_mm),
                "at_mm": ([problem.at.x, problem.at.y, problem.at.z].map(rounded)),
            })
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
    let object = json!({
        "schema": "chordal.stock/1",
        "file": file,
        "resolution_mm": found.resolution_mm,
        "refined": found.refined,
        "removed_mm3": bounds(found.removed_mm3),
        "left_mm3": bounds(found.left_mm3),
        "verdict": found.verdict.as_str(),
        "problems": problems,
        "problems_left_out": found.more_problems,
        "errors": found.report.counts.errors,
        "tools": tools,
        "target": target,
    });
    format!("{object:#}\n")
}
