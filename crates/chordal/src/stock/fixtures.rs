//! Fixtures: checks without columns whether a tool with its shank and holder keeps clear of them.

use chordal_diagnostics::Code;
use chordal_geometry::{Aabb, ParamCurve};
use chordal_stock::shape::{BodyBound, Frustum, PassageAnswer, RoundBody, SolidShape, TipMotion};
use chordal_stock::{TipMove, VolumeInterval};

use super::pass::PassContext;
use super::problems::{FixtureClearance, StockProblems};
use super::tools::ToolBody;

/// Rounded parts of a tool are approximated from outside by cones within this, mm.
const ROUND: f64 = 1e-3;
/// Most steps along one move.
const STEPS: usize = 100_000;
/// Most parts of one move on which the tool turns.
const TURNING_STEPS: usize = 2_000;

/// Checks every move of every tool against a fixture.
pub(super) fn look_at_fixtures(
    run: &PassContext<'_>,
    fixture: &FixtureClearance<'_>,
    shape: &SolidShape,
    problems: &mut StockProblems,
) {
    let bounds = shape.bounds();
    let clearance = fixture.clearance;
    for batch in &run.batches {
        let Some(tool) = run.tool(batch.tool) else { continue };
        let Some(body) = whole(tool) else { continue };
        let reach = tool.radius() + clearance + run.options.tolerance_mm;
        for (number, (path, origin)) in batch.moves.iter().zip(&batch.origins).enumerate() {
            let turn = batch.tool_turns.get(number);
            if turn.is_none() && is_far(path, &bounds, reach, tool.top()) {
                continue;
            }
            let length = path.curve.length();
            let tip = |share: f64| path.curve.point_at(share * length);
            let tolerance = run.options.tolerance_mm;
            let passage = match turn {
                Some(turn) => shape.turning_passage(
                    &body,
                    &path.curve,
                    turn,
                    [clearance, tolerance],
                    TURNING_STEPS,
                ),
                None => {
                    let path = TipMotion { tip: &tip, speed: length };
                    shape.passage(&body, &path, clearance, tolerance, STEPS)
                }
            };
            let (code, share, distance) = match passage {
                PassageAnswer::Clean { .. } => continue,
                PassageAnswer::Hit { fraction, distance } => (Code::FixtureHit, fraction, distance),
                PassageAnswer::Undecided { fraction, distance } => {
                    (Code::NotProved, fraction, distance)
                }
            };
            let missing = VolumeInterval {
                least: (clearance - distance.upper).max(0.0),
                most: (clearance - distance.lower).max(0.0),
            };
            let place = run.place(*origin, batch.tool);
            problems.fixture(code, fixture, missing, tip(share), &place);
        }
    }
}

/// Whether a move is farther than `reach` from the box of a fixture.
fn is_far(path: &TipMove, fixture: &Aabb, reach: f64, top: f64) -> bool {
    let bounds = path.curve.bounds();
    let separate =
        |low: f64, high: f64, from: f64, to: f64| low > to + reach || high < from - reach;
    separate(bounds.min.x, bounds.max.x, fixture.min.x, fixture.max.x)
        || separate(bounds.min.y, bounds.max.y, fixture.min.y, fixture.max.y)
        || separate(bounds.min.z, bounds.max.z + top, fixture.min.z, fixture.max.z)
}

/// Cutter, shank and holder as one body; `None` where the cutter has no such body.
fn whole(tool: &ToolBody) -> Option<RoundBody> {
    let edges = tool.cutter.flutes().unwrap_or_else(|| tool.top()).max(tool.cutter.side() + ROUND);
    let cutter = RoundBody::of_cutter(&tool.cutter, edges, ROUND, BodyBound::Outer).ok()?;
    let frustums: Vec<Frustum> = tool
        .shank
        .iter()
        .chain(&tool.holder)
        .filter(|piece| piece.height > 0.0)
        .map(|piece| Frustum {
            from: piece.from,
            to: piece.from + piece.height,
            lower: piece.lower / 2.0,
            upper: piece.upper / 2.0,
        })
        .collect();
    match RoundBody::new(frustums) {
        Ok(above) => Some(cutter.and(&above)),
        Err(_) => Some(cutter),
    }
}

#[cfg(test)]
mod tests {
    use chordal_geometry::{Curve, Line, Vec3};

    use super::*;

    #[test]
    fn far_moves_are_passed_over() {
        let line = |z: f64| TipMove {
            curve: Curve::Line(Line {
                start: Vec3::new(0.0, 0.0, z),
                end: Vec3::new(10.0, 0.0, z),
            }),
            tag: 1,
        };
        let fixture = Aabb { min: Vec3::new(20.0, -5.0, -5.0), max: Vec3::new(30.0, 5.0, 5.0) };
        assert!(is_far(&line(0.0), &fixture, 9.0, 50.0));
        assert!(!is_far(&line(0.0), &fixture, 11.0, 50.0));
        // The holder reaches down to it from above.
        assert!(is_far(&line(20.0), &fixture, 11.0, 50.0));
        assert!(!is_far(&line(-50.0), &fixture, 11.0, 50.0));
    }
}
