//! Finds the narrowest passage of a contour on the side of the tool.
//!
//! The largest tool that fits between two walls has the diameter of the shortest chord that is normal to both. At an
//! outside corner, every direction between the normals of its two blocks counts as normal.

use core::f64::consts::{PI, TAU};

use chordal_geometry::Vec2;

use super::distance::NearestPair;
use super::material::PartContour;
use super::shape::{GougeCurve, unit, wrapped};
use super::tree::{BoxTree, LEAF};

/// Directions that differ by less are equal, rad.
const EQUAL_DIRECTION_RAD: f64 = 1e-6;

/// A passage: the indices of the two curves, and the chord across.
#[derive(Clone, Copy, Debug)]
pub(super) struct NarrowPassage {
    pub(super) first: usize,
    pub(super) second: usize,
    pub(super) near: NearestPair,
}

/// A range of tangent angles, rad, unwrapped along the chain.
#[derive(Clone, Copy)]
struct TangentFan {
    least: f64,
    most: f64,
}

impl TangentFan {
    const EMPTY: TangentFan = TangentFan { least: f64::INFINITY, most: f64::NEG_INFINITY };

    fn join(self, o: TangentFan) -> TangentFan {
        TangentFan { least: self.least.min(o.least), most: self.most.max(o.most) }
    }

    /// Whether some direction of one is opposite to some direction of the other.
    fn opposes(self, o: TangentFan) -> bool {
        let (low, high) =
            (self.least - o.most - EQUAL_DIRECTION_RAD, self.most - o.least + EQUAL_DIRECTION_RAD);
        low <= high && libm::floor((high - PI) / TAU) * TAU + PI >= low
    }
}

/// The contour with the boxes and the ranges of directions for the search.
pub(super) struct ThroatWalls<'a> {
    material: &'a PartContour,
    tangents: &'a [(f64, f64)],
    side: f64,
    boxes: BoxTree,
    fans: Vec<TangentFan>,
    pub(super) budget: u64,
}

impl<'a> ThroatWalls<'a> {
    pub(super) fn new(
        material: &'a PartContour,
        tangents: &'a [(f64, f64)],
        side: f64,
        budget: u64,
    ) -> Self {
        let boxes = BoxTree::over(material.curves.iter());
        let mut walls = ThroatWalls {
            material,
            tangents,
            side,
            fans: vec![TangentFan::EMPTY; boxes.nodes.len()],
            boxes,
            budget,
        };
        for k in 0..material.curves.len() {
            let leaf = walls.boxes.leaves + k / LEAF;
            walls.fans[leaf] = walls.fans[leaf].join(walls.fan(k));
        }
        for node in (1..walls.boxes.leaves).rev() {
            walls.fans[node] = walls.fans[2 * node].join(walls.fans[2 * node + 1]);
        }
        walls
    }

    /// The directions of a curve and of the corners at its ends.
    fn fan(&self, k: usize) -> TangentFan {
        let (start, end) = self.tangents[k];
        let mut fan = TangentFan { least: start.min(end), most: start.max(end) };
        let (before, after) = (self.before(k).map(|t| start - t), self.after(k).map(|t| end + t));
        for angle in before.into_iter().chain(after) {
            fan = fan.join(TangentFan { least: angle, most: angle });
        }
        fan
    }

    /// The turn from the curve before it into a curve, rad; `None` if there is none.
    fn before(&self, k: usize) -> Option<f64> {
        let last = self.tangents.len() - 1;
        let from = match k {
            0 if self.material.is_closed() => last,
            0 => return None,
            _ if self.material.breaks[k] => return None,
            _ => k - 1,
        };
        Some(wrapped(self.tangents[k].0 - self.tangents[from].1))
    }

    /// The turn from a curve into the one after it, rad; `None` if there is none.
    fn after(&self, k: usize) -> Option<f64> {
        let next = if k + 1 < self.tangents.len() { k + 1 } else { 0 };
        self.before(next)
    }

    /// The narrowest passage with a chord below `limit`, mm.
    pub(super) fn narrowest(&mut self, limit: f64) -> Option<NarrowPassage> {
        let mut limit = limit * limit;
        let mut best = None;
        let mut stack = vec![(1usize, 1usize, 0.0)];
        while let Some((a, b, gap)) = stack.pop() {
            if gap >= limit || !self.fans[a].opposes(self.fans[b]) || self.budget == 0 {
                continue;
            }
            self.budget -= 1;
            if self.boxes.is_leaf(a) && self.boxes.is_leaf(b) {
                self.try_leaves(a, b, &mut limit, &mut best);
                continue;
            }
            let mut pairs = if a == b {
                let (low, high) = (2 * a, 2 * a + 1);
                vec![(low, low), (low, high), (high, high)]
            } else if self.boxes.is_leaf(b)
                || !self.boxes.is_leaf(a)
                    && self.boxes.nodes[a].size() >= self.boxes.nodes[b].size()
            {
                vec![(2 * a, b), (2 * a + 1, b)]
            } else {
                vec![(a, 2 * b), (a, 2 * b + 1)]
            }
            .into_iter()
            .map(|(a, b)| (a, b, self.boxes.nodes[a].gap_square(&self.boxes.nodes[b])))
            .collect::<Vec<_>>();
            pairs.sort_by(|x, y| y.2.total_cmp(&x.2));
            stack.extend(pairs);
        }
        best
    }

    fn try_leaves(
        &mut self,
        a: usize,
        b: usize,
        limit: &mut f64,
        best: &mut Option<NarrowPassage>,
    ) {
        let ((first, end), (other, other_end)) = (self.boxes.range(a), self.boxes.range(b));
        for i in first..end {
            for j in other.max(i + 1)..other_end {
                if self.boxes.elements[i].gap_square(&self.boxes.elements[j]) >= *limit
                    || !self.fan(i).opposes(self.fan(j))
                {
                    continue;
                }
                for near in chords(&self.material.curves[i], &self.material.curves[j]) {
                    if near.square < *limit
                        && near.square > 0.0
                        && self.is_normal_to_both(i, j, &near)
                    {
                        *limit = near.square;
                        *best = Some(NarrowPassage { first: i, second: j, near });
                    }
                }
            }
        }
    }

    /// Whether the chord is normal to both curves and on their tool side.
    fn is_normal_to_both(&self, i: usize, j: usize, near: &NearestPair) -> bool {
        let Some(across) = (near.second - near.first).normalized() else { return false };
        self.is_normal(i, near.first, across) && self.is_normal(j, near.second, -across)
    }

    fn is_normal(&self, k: usize, at: Vec2, direction: Vec2) -> bool {
        let curve = &self.material.curves[k];
        let (start, end) = self.tangents[k];
        let normal = |angle: f64| unit(angle).turned_left() * self.side;
        let along =
            |n: Vec2| n.dot(direction) > 0.0 && n.cross(direction).abs() <= EQUAL_DIRECTION_RAD;
        let grain = 1e-9 * (1.0 + curve.length());
        let joint = if at.distance(curve.from()) <= grain {
            Some((self.before(k), start, -1.0))
        } else if at.distance(curve.to()) <= grain {
            Some((self.after(k), end, 1.0))
        } else {
            None
        };
        if let Some((Some(turn), angle, path)) = joint {
            let inside = turn * self.side;
            if inside > EQUAL_DIRECTION_RAD {
                return false;
            }
            if inside < -EQUAL_DIRECTION_RAD {
                // The direction must be between the normals of both curves, in the order of the turn.
                let (mine, other) = (normal(angle), normal(angle + path * turn));
                let sense = -self.side * path;
                return mine.cross(direction) * sense >= -EQUAL_DIRECTION_RAD
                    && direction.cross(other) * sense >= -EQUAL_DIRECTION_RAD
                    && direction.dot(mine + other) > 0.0;
            }
            return along(normal(angle));
        }
        match *curve {
            GougeCurve::Line { .. } => along(normal(start)),
            GougeCurve::Arc { center, sweep, .. } => match (at - center).normalized() {
                Some(out) => along(out * (-self.side * sweep.signum())),
                None => false,
            },
        }
    }
}

/// The chords between two curves that could be normal to both.
fn chords(first: &GougeCurve, second: &GougeCurve) -> Vec<NearestPair> {
    let between = |p: Vec2, q: Vec2| {
        let d = q - p;
        NearestPair { square: d.dot(d), first: p, second: q }
    };
    let mut all = Vec::with_capacity(9);
    for p in [first.from(), first.to()] {
        all.push(between(p, second.nearest(p)));
    }
    for q in [second.from(), second.to()] {
        all.push(between(first.nearest(q), q));
    }
    match (first, second) {
        (GougeCurve::Line { .. }, GougeCurve::Line { .. }) => {
            // For parallel walls, also a chord in the middle: their ends may be in inside corners.
            let (p, q) = (all[2].first, all[3].first);
            let middle = (p + q) * 0.5;
            all.push(between(middle, second.nearest(middle)));
        }
        (GougeCurve::Line { from, to }, GougeCurve::Arc { center, radius, .. }) => {
            let foot = GougeCurve::line(*from, *to).nearest(*center);
            all.extend(radial(*center, *radius, foot).map(|q| between(foot, q)));
        }
        (GougeCurve::Arc { center, radius, .. }, GougeCurve::Line { from, to }) => {
            let foot = GougeCurve::line(*from, *to).nearest(*center);
            all.extend(radial(*center, *radius, foot).map(|p| between(p, foot)));
        }
        (
            GougeCurve::Arc { center: c, radius: r, .. },
            GougeCurve::Arc { center: e, radius: q, .. },
        ) => {
            for p in radial(*c, *r, *e) {
                all.extend(radial(*e, *q, *c).map(|q| between(p, q)));
            }
        }
    }
    all.retain(|n| is_on(first, n.first) && is_on(second, n.second));
    all
}

/// The points of a circle nearest to and farthest from a point.
fn radial(center: Vec2, radius: f64, p: Vec2) -> impl Iterator<Item = Vec2> {
    let out = (p - center).normalized();
    out.into_iter().flat_map(move |u| [center + u * radius, center - u * radius])
}

fn is_on(curve: &GougeCurve, p: Vec2) -> bool {
    curve.nearest(p).distance(p) <= 1e-9 * (1.0 + curve.length())
}
