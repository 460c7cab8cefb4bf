//! The way of a cut over the map: where the surface bends under it, and into how many pieces it is cut.

use std::f64::consts::FRAC_PI_2;

use chordal::geometry::fractions_at_angle;

use super::grid::HeightMap;

/// More places than these in one move are not looked at.
const MAX_NODES: usize = 200_000;
/// What the surface may rise off the straight between two neighbouring places, as a part of the tolerance.
const NODE_TOLERANCE_SHARE: f64 = 0.125;

/// The way of a move in X and Y, from fraction 0 to 1, mm and rad.
#[derive(Clone, Copy, Debug)]
pub(super) enum PlanePath {
    Line { from: [f64; 2], to: [f64; 2] },
    Arc { center: [f64; 2], radius: f64, start: f64, sweep: f64 },
}

/// The move is longer than can be looked at.
#[derive(Debug)]
pub(super) struct TooLong;

impl PlanePath {
    pub(super) fn at(&self, fraction: f64) -> [f64; 2] {
        match *self {
            PlanePath::Line { from, to } => {
                [0, 1].map(|axis| from[axis] * (1.0 - fraction) + to[axis] * fraction)
            }
            PlanePath::Arc { center, radius, start, sweep } => {
                let (sin, cos) = libm::sincos(start + sweep * fraction);
                [center[0] + radius * cos, center[1] + radius * sin]
            }
        }
    }

    /// Its ends, and the places where it is farthest along X and Y.
    pub(super) fn extremes(&self) -> Vec<[f64; 2]> {
        let mut places = vec![self.at(0.0), self.at(1.0)];
        if let PlanePath::Arc { start, sweep, .. } = *self {
            for quarter in 0..4 {
                let angle = FRAC_PI_2 * f64::from(quarter);
                let mut passes = fractions_at_angle(start, sweep, angle);
                places.extend(passes.next().map(|fraction| self.at(fraction)));
            }
        }
        places
    }

    /// Two corners of the rectangle that holds it.
    pub(super) fn bounds(&self) -> [[f64; 2]; 2] {
        let places = self.extremes();
        [f64::min as fn(f64, f64) -> f64, f64::max].map(|end| {
            [0, 1].map(|axis| places.iter().map(|at| at[axis]).reduce(end).unwrap_or(0.0))
        })
    }

    /// The fractions that end the pieces: over each the surface with the move's own rise is straight within a
    /// tolerance, mm. The last is 1.
    pub(super) fn pieces(&self, map: &HeightMap, tolerance: f64) -> Result<Vec<f64>, TooLong> {
        let nodes = self.nodes(map, tolerance * NODE_TOLERANCE_SHARE)?;
        let allowed = tolerance * (1.0 - NODE_TOLERANCE_SHARE);
        let heights: Vec<f64> = nodes.iter().map(|t| map.height(self.at(*t))).collect();
        let mut ends = Vec::new();
        let mut from = 0;
        while from + 1 < nodes.len() {
            let mut best = from + 1;
            // The slopes at which a straight from here passes all places so far within the tolerance.
            let mut slopes = [f64::NEG_INFINITY, f64::INFINITY];
            for to in from + 1..nodes.len() {
                let path = nodes[to] - nodes[from];
                let slope = |height: f64| (height - heights[from]) / path;
                if (slopes[0]..=slopes[1]).contains(&slope(heights[to])) {
                    best = to;
                }
                slopes[0] = slopes[0].max(slope(heights[to] - allowed));
                slopes[1] = slopes[1].min(slope(heights[to] + allowed));
                if slopes[0] > slopes[1] {
                    break;
                }
            }
            ends.push(nodes[best]);
            from = best;
        }
        Ok(ends)
    }

    /// Places so near to each other that the surface between two is straight within `left` mm.
    pub(super) fn nodes(&self, map: &HeightMap, left: f64) -> Result<Vec<f64>, TooLong> {
        let mut cuts = self.cuts(map);
        cuts.extend([0.0, 1.0]);
        cuts.sort_unstable_by(f64::total_cmp);
        cuts.dedup();
        let mut nodes = vec![0.0];
        for pair in cuts.windows(2) {
            let length = pair[1] - pair[0];
            let bend = self.bend(map, 0.5 * (pair[0] + pair[1]));
            // A function whose second derivative is at most M leaves its chord by M l²/8 at most.
            let count = libm::ceil((bend * length * length / (8.0 * left)).sqrt()).max(1.0);
            if count > MAX_NODES as f64 || nodes.len() + count as usize > MAX_NODES {
                return Err(TooLong);
            }
            let steps = count as usize;
            nodes.extend((1..steps).map(|k| pair[0] + length * k as f64 / count));
            nodes.push(pair[1]);
        }
        Ok(nodes)
    }

    /// The largest second derivative of the height by the fraction, within the cell of a place.
    fn bend(&self, map: &HeightMap, fraction: f64) -> f64 {
        let at = self.at(fraction);
        let local = map.about(at);
        match *self {
            PlanePath::Line { from, to } => {
                2.0 * (local.twist * (to[0] - from[0]) * (to[1] - from[1])).abs()
            }
            PlanePath::Arc { center, radius, sweep, .. } => {
                // With the centre as origin h = A + B u + C v + D u v, u = r cos, v = r sin: its second
                // derivative is −B u − C v − 4 D u v.
                let slopes = [
                    local.slope[0] + local.twist * (center[1] - at[1]),
                    local.slope[1] + local.twist * (center[0] - at[0]),
                ];
                let most =
                    radius * slopes[0].hypot(slopes[1]) + 2.0 * local.twist.abs() * radius * radius;
                most * sweep * sweep
            }
        }
    }

    /// The fractions at which the way crosses a line of the grid.
    fn cuts(&self, map: &HeightMap) -> Vec<f64> {
        let mut cuts = Vec::new();
        for axis in 0..2 {
            match *self {
                PlanePath::Line { from, to } => {
                    let (a, b) = (from[axis], to[axis]);
                    let edges = map.edges(axis, a.min(b), a.max(b));
                    cuts.extend(edges.iter().map(|edge| (edge - a) / (b - a)));
                }
                PlanePath::Arc { center, radius, start, sweep } => {
                    let edges = map.edges(axis, center[axis] - radius, center[axis] + radius);
                    for edge in edges {
                        let half = libm::acos(((edge - center[axis]) / radius).clamp(-1.0, 1.0));
                        let middle = if axis == 0 { 0.0 } else { FRAC_PI_2 };
                        for angle in [middle - half, middle + half] {
                            cuts.extend(fractions_at_angle(start, sweep, angle));
                        }
                    }
                }
            }
        }
        cuts.retain(|cut| *cut > 1e-9 && *cut < 1.0 - 1e-9);
        cuts
    }
}
