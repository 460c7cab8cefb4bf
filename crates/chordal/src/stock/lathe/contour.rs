//! Follows the contour of consecutive moves at feed, and finds where a flank of the insert cuts into it.
//!
//! A move that goes down more steeply than the clearance angle of the insert behind its nose cuts with the trailing
//! flank, into the surface of the moves before.

use chordal_geometry::Vec2;
use chordal_stock::lathe::{OutlineSegment, Region};

use super::gather::{TurnMove, TurnedMoveKind};
use super::tools::LatheTool;

/// Most walls that are kept: a flank is not longer than a few moves.
const WALLS: usize = 24;
/// Ends within this distance are one point, mm.
const COINCIDENT_MM: f64 = 1e-6;
/// Where the cosine between the normal of travel and the tool body is below this, the part is on neither side.
const PARALLEL: f64 = 0.05;
/// A flank cuts only where the cosine between its normal and the travel is above this.
const LEADS: f64 = 1e-3;

/// Consecutive moves at feed of one tool, with the part on one side of travel.
#[derive(Debug, Default)]
pub(super) struct FeedChain {
    walls: Vec<OutlineSegment>,
    /// True where the part is to the left of travel.
    left: bool,
    end: Vec2,
    tool: u32,
}

impl FeedChain {
    /// Ends the chain, at a rapid or another tool.
    pub fn clear(&mut self) {
        self.walls.clear();
    }

    /// Whether the trailing flank cuts on this move, which is to be added afterwards.
    pub fn flank_leads(&mut self, tool: &LatheTool, move_: &TurnMove) -> bool {
        let Some(along) = self.side(tool, move_) else { return false };
        let Some(before) = self.walls.last().map(end_tangent) else { return false };
        let Some(normals) = tool.flank_normals() else { return false };
        let following =
            normals.into_iter().max_by(|a, b| (-*a).dot(before).total_cmp(&(-*b).dot(before)));
        following.is_some_and(|normal| normal.dot(along) > LEADS)
    }

    /// Finds out on which side the part is, and begins a new chain where the move does not join on. Returns the
    /// direction of travel, or `None` where it has no side.
    fn side(&mut self, tool: &LatheTool, move_: &TurnMove) -> Option<Vec2> {
        let path = &move_.path;
        let goes_on = self.tool == move_.tool && self.end.distance(path.start) <= COINCIDENT_MM;
        if move_.kind != TurnedMoveKind::Cut || !goes_on {
            self.walls.clear();
        }
        (self.tool, self.end) = (move_.tool, path.end);
        let along = (path.end - path.start).normalized()?;
        let to_body = along.turned_left().dot(tool.body);
        if to_body.abs() < PARALLEL {
            self.walls.clear();
            return None;
        }
        let left = to_body < 0.0;
        if left != self.left {
            // On the way down into a pocket the part stays on its side; an infeed before a pass is not a wall.
            let is_down = along.b * tool.body.b < 0.0;
            if !is_down || self.walls.is_empty() {
                self.walls.clear();
                self.left = left;
            }
        }
        Some(along)
    }

    /// Adds the programmed contour of a move.
    pub fn add(&mut self, move_: &TurnMove) {
        if move_.kind != TurnedMoveKind::Cut {
            return;
        }
        if self.walls.len() == WALLS {
            self.walls.remove(0);
        }
        self.walls.push(move_.contour.unwrap_or(move_.path));
    }

    /// How deep removed material reaches into the walls of earlier moves, mm, and where; `None` where it does not
    /// meet them.
    pub fn gouge(&self, removed: &Region, reach: f64) -> Option<(f64, Vec2)> {
        let mut deepest: Option<(f64, Vec2)> = None;
        for wall in &self.walls {
            let Some((low, high)) = removed.bounds() else { break };
            let Some(inside) = part_side_of(wall, self.left, 2.0 * reach) else { continue };
            let Some(bounds) = inside.bounds() else { continue };
            if low.a > bounds.1.a
                || high.a < bounds.0.a
                || low.b > bounds.1.b
                || high.b < bounds.0.b
            {
                continue;
            }
            let Ok(common) = removed.intersection(&inside) else { continue };
            for corner in common.region.shape().iter().flatten().map(|segment| segment.start) {
                let depth = depth_in(wall, self.left, corner);
                if deepest.is_none_or(|(known, _)| depth > known) {
                    deepest = Some((depth, corner));
                }
            }
        }
        deepest
    }
}

/// The direction at the end of a segment.
fn end_tangent(segment: &OutlineSegment) -> Vec2 {
    let along = match segment.bend {
        None => segment.end - segment.start,
        Some(bend) => {
            let left = (segment.end - bend.center).turned_left();
            if bend.counterclockwise { left } else { -left }
        }
    };
    along.normalized().unwrap_or(Vec2::new(1.0, 0.0))
}

/// The distance of a point from a wall, mm, positive on the side of the part.
fn depth_in(wall: &OutlineSegment, left: bool, point: Vec2) -> f64 {
    let to_left = match wall.bend {
        None => {
            let along = (wall.end - wall.start).normalized().unwrap_or(Vec2::new(1.0, 0.0));
            (point - wall.start).dot(along.turned_left())
        }
        Some(bend) => {
            let inward = bend.radius - point.distance(bend.center);
            if bend.counterclockwise { inward } else { -inward }
        }
    };
    if left { to_left } else { -to_left }
}

/// The region within `reach` (mm) of a wall on the side of the part, normal to it.
fn part_side_of(wall: &OutlineSegment, left: bool, reach: f64) -> Option<Region> {
    let side = if left { 1.0 } else { -1.0 };
    let outline = match wall.bend {
        None => {
            let normal = (wall.end - wall.start).normalized()?.turned_left() * side;
            // The region must not cross the axis.
            let room = wall.start.b.min(wall.end.b);
            let reach = if normal.b < 0.0 { reach.min(room / -normal.b) } else { reach };
            let (far_end, far_start) = (wall.end + normal * reach, wall.start + normal * reach);
            vec![
                OutlineSegment::line(wall.start, wall.end),
                OutlineSegment::line(wall.end, far_end),
                OutlineSegment::line(far_end, far_start),
                OutlineSegment::line(far_start, wall.start),
            ]
        }
        Some(bend) => {
            let inward = bend.counterclockwise == left;
            let radius = if inward { (bend.radius - reach).max(0.0) } else { bend.radius + reach };
            let at = |p: Vec2| bend.center + (p - bend.center) * (radius / bend.radius);
            let (far_end, far_start) = (at(wall.end), at(wall.start));
            let mut outline = vec![*wall];
            if radius > 0.0 {
                outline.push(OutlineSegment::line(wall.end, far_end));
                outline.push(OutlineSegment::arc(
                    far_end,
                    far_start,
                    bend.center,
                    !bend.counterclockwise,
                ));
                outline.push(OutlineSegment::line(far_start, wall.start));
            } else {
                outline.push(OutlineSegment::line(wall.end, bend.center));
                outline.push(OutlineSegment::line(bend.center, wall.start));
            }
            outline
        }
    };
    Region::contour(&[outline]).ok()
}
