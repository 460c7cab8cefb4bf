//! Finds what the nose leaves on the programmed contour, or cuts below it, without nose radius compensation.
//!
//! Each segment of the outline is tagged with the move that made it. The segment is parallel to its move, and the
//! distance between them is the error.

use chordal_diagnostics::Code;
use chordal_geometry::Vec2;
use chordal_stock::lathe::{OutlineSegment, Region};

use super::gather::{TurnMove, TurnedMoveKind};
use super::problems::{MessageDetail, ProblemLocation, TurnedProblems};
use super::tools::{LatheTool, TurningToolKind};

/// Parts of the outline shorter than this are rounding, mm.
const MIN_OUTLINE_MM: f64 = 0.01;
/// Tolerance for the sine between parallel lines, and for the difference between radii and the nose radius (mm).
const PARALLEL_TOLERANCE: f64 = 1e-6;

/// Compares an outline with the moves that made it, and reports deviations.
pub(super) fn look_at_surface<'t>(
    region: &Region,
    moves: &[TurnMove],
    tool_of: impl Fn(u32) -> Option<&'t LatheTool>,
    tolerance: f64,
    found: &mut TurnedProblems<'_>,
) {
    let mut misses: Vec<(usize, f64, Vec2)> = Vec::new();
    for segment in region.outline().iter().flatten() {
        let Some(number) = (segment.tag as usize).checked_sub(1) else { continue };
        let Some(move_) = moves.get(number) else { continue };
        if move_.kind != TurnedMoveKind::Cut || move_.is_compensated {
            continue;
        }
        let Some(TurningToolKind::Insert { nose, centered: false, .. }) =
            tool_of(move_.tool).map(|tool| tool.kind)
        else {
            continue;
        };
        if segment.start.distance(segment.end) < MIN_OUTLINE_MM {
            continue;
        }
        if let Some((off, place)) = miss(segment, &move_.path, nose)
            && off.abs() > tolerance
        {
            misses.push((number, off, place));
        }
    }
    // In the order of the run, the largest error of each move first.
    misses.sort_by(|x, y| {
        (x.0, -x.1.abs()).partial_cmp(&(y.0, -y.1.abs())).unwrap_or(core::cmp::Ordering::Equal)
    });
    for (number, off, place) in misses {
        let move_ = &moves[number];
        let code = if off > 0.0 { Code::NoseLeaves } else { Code::NoseGouge };
        let at = ProblemLocation { origin: move_.origin, tool: move_.tool, place };
        found.push(code, off.abs(), &at, MessageDetail::Nothing);
    }
}

/// How far a segment of the outline is outside of the move that made it, mm (negative: inside), and where; `None`
/// where the two are not parallel.
fn miss(segment: &OutlineSegment, path: &OutlineSegment, nose: f64) -> Option<(f64, Vec2)> {
    match (segment.bend, path.bend) {
        (None, None) => {
            let along = (segment.end - segment.start).normalized()?;
            let course = (path.end - path.start).normalized()?;
            if along.cross(course).abs() > PARALLEL_TOLERANCE {
                return None;
            }
            // The material is to the left of its outline.
            let off = (segment.start - path.start).dot(-along.turned_left());
            (off.abs() <= 2.0 * nose).then_some((off, (segment.start + segment.end) * 0.5))
        }
        (Some(bend), Some(arc)) => {
            let by_nose = ((bend.radius - arc.radius).abs() - nose).abs()
                <= PARALLEL_TOLERANCE.max(1e-6 * bend.radius);
            if !by_nose {
                return None;
            }
            let outward = if bend.counterclockwise { 1.0 } else { -1.0 };
            let off = |p: Vec2| outward * (p.distance(arc.center) - arc.radius);
            let shift = bend.center - arc.center;
            let extremes = shift
                .normalized()
                .into_iter()
                .flat_map(|to| [bend.center + to * bend.radius, bend.center - to * bend.radius]);
            let on_arc = extremes.filter(|p| is_on(segment, *p));
            let places = [segment.start, segment.end].into_iter().chain(on_arc);
            let worst =
                places.map(|p| (off(p), p)).max_by(|x, y| x.0.abs().total_cmp(&y.0.abs()))?;
            (worst.0.abs() <= 2.0 * nose).then_some(worst)
        }
        _ => None,
    }
}

/// Whether a point of a circle lies on its arc.
fn is_on(arc: &OutlineSegment, p: Vec2) -> bool {
    let Some(bend) = arc.bend else { return false };
    let part = OutlineSegment::arc(arc.start, p, bend.center, bend.counterclockwise);
    part.sweep().abs() <= arc.sweep().abs()
}
