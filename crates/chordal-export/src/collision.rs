//! A check for collisions in words and as one JSON object.

use chordal::collision::{CollisionProblem, CollisionReport, CollisionVerdict};
use serde_json::{Map, Value, json};

use crate::numbers::{counted, grouped};

/// The answer for people, in the units of the program; the problems are printed apart.
pub fn collision_text(found: &CollisionReport) -> String {
    let inch = found.report.summary.inch;
    let tolerance = match inch {
        true => format!("{:.4} in", found.tolerance_mm / 25.4),
        false => format!("{:.3} mm", found.tolerance_mm),
    };
    let mut text = format!("bodies      {}\n", found.bodies.len());
    text += &format!("pairs       {}\n", found.pairs);
    text += &format!("moves       {}\n", grouped(found.moves));
    text += &format!("positions   {}\n", grouped(found.positions));
    text += &format!("tolerance   {tolerance}\n");
    text += match found.verdict {
        CollisionVerdict::Clean => {
            "clean: no two of these bodies touch on any move; proved for all positions between the looked at ones"
        }
        CollisionVerdict::Problems => "problems: see above",
        CollisionVerdict::NotProved => "not proved: see above",
    };
    text.push('\n');
    if !found.without_holder.is_empty() {
        let numbers: Vec<String> = found.without_holder.iter().map(u32::to_string).collect();
        let tools = if numbers.len() == 1 { "tool" } else { "tools" };
        text += &format!(
            "no holder is given of {tools} {}, so none was compared\n",
            numbers.join(", ")
        );
    }
    if found.more_problems > 0 {
        let more = counted(found.more_problems, "more problem is", "more problems are");
        text += &format!("{more} not listed\n");
    }
    text
}

/// To a millionth: smaller digits are rounding.
fn rounded(value: f64) -> f64 {
    (value * 1e6).round() / 1e6 + 0.0
}

/// Schema `chordal.collide/1`: lengths in mm, angles in degrees, machine coordinates.
pub fn collision_json(found: &CollisionReport, file: &str) -> String {
    let problem = |problem: &CollisionProblem| {
        let info = problem.code.info();
        let axes = ["X", "Y", "Z", "A", "B", "C"].into_iter().zip(problem.axes).enumerate();
        let axes: Map<String, Value> = axes
            .filter_map(|(index, (letter, value))| {
                let value = value?;
                let value = if index < 3 { value } else { value.to_degrees() };
                Some((letter.to_string(), json!(rounded(value))))
            })
            .collect();
        json!({
            "code": info.id,
            "name": info.name,
            "file": problem.file,
            "line": problem.line,
            "bodies": problem.bodies,
            "depth_mm": rounded(problem.depth_mm),
            "distance_mm": rounded(problem.distance_mm),
            "axes": axes,
        })
    };
    let problems: Vec<Value> = found.problems.iter().map(problem).collect();
    crate::pretty_json(json!({
        "schema": "chordal.collide/1",
        "file": file,
        "tolerance_mm": found.tolerance_mm,
        "bodies": found.bodies,
        "without_holder": found.without_holder,
        "pairs": found.pairs,
        "moves": found.moves,
        "positions": found.positions,
        "verdict": found.verdict.as_str(),
        "problems": problems,
        "problems_left_out": found.more_problems,
        "errors": found.report.counts.errors,
    }))
}
