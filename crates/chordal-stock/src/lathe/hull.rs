//! Quick rejection of edges that are not near a swept area, by separating directions.

use chordal_geometry::Vec2;

use super::edge::{Box2, RegionEdge};

/// Most directions: a sweep of a usual insert has no more edges, and for others some of them suffice.
const MAX_DIRECTIONS: usize = 16;
/// Directions for one arc of a convex loop: between them the arc bulges by less than 1 % of its radius.
const OF_ARC: u32 = 6;

/// An outer polygon: directions, and the largest extent of the edges along them.
#[derive(Clone, Debug, Default)]
pub(crate) struct DirectionHull {
    reach: Vec<(Vec2, f64)>,
}

impl DirectionHull {
    /// Computes the hull of edges, with their own outward directions. For a convex loop each edge is extreme in its
    /// own direction.
    pub fn of(&mut self, edges: &[RegionEdge], convex: bool) {
        self.reach.clear();
        if convex {
            edges.iter().for_each(|edge| self.add_convex(edge));
            return;
        }
        let every = edges.len().div_ceil(MAX_DIRECTIONS).max(1);
        for edge in edges.iter().step_by(every) {
            let out = match edge.is_straight() {
                true => -(edge.end - edge.start).turned_left(),
                false => edge.middle() - edge.circle.center,
            };
            let Some(out) = out.normalized() else { continue };
            let ends = edges.iter().map(|edge| edge.reach(out).1);
            self.reach.push((out, ends.fold(f64::NEG_INFINITY, f64::max)));
        }
    }

    fn add_convex(&mut self, edge: &RegionEdge) {
        if edge.is_straight() {
            if let Some(along) = (edge.end - edge.start).normalized() {
                let out = -along.turned_left();
                self.reach.push((out, out.dot(edge.start).max(out.dot(edge.end))));
            }
            return;
        }
        let center = edge.circle.center;
        let (from, to) = (edge.start - center, edge.end - center);
        for at in 0..OF_ARC {
            let share = (f64::from(at) + 0.5) / f64::from(OF_ARC);
            if let Some(out) = (from * (1.0 - share) + to * share).normalized() {
                self.reach.push((out, out.dot(center) + edge.circle.radius));
            }
        }
    }

    /// Whether a box is more than `margin` (mm) outside. `tried` is the direction that is tried first, which
    /// separated the previous box.
    pub fn parts(&self, area: &Box2, margin: f64, tried: &mut usize) -> bool {
        let outside = |(out, reach): &(Vec2, f64)| {
            let nearest = Vec2::new(
                if out.a > 0.0 { area.min.a } else { area.max.a },
                if out.b > 0.0 { area.min.b } else { area.max.b },
            );
            out.dot(nearest) > reach + margin
        };
        if self.reach.get(*tried).is_some_and(outside) {
            return true;
        }
        match self.reach.iter().position(outside) {
            Some(at) => {
                *tried = at;
                true
            }
            None => false,
        }
    }

    /// Whether a point is inside, or at most `margin` (mm) outside.
    pub fn holds(&self, p: Vec2, margin: f64) -> bool {
        self.reach.iter().all(|(out, reach)| out.dot(p) <= reach + margin)
    }
}
