//! Finds the deepest gouge by branch and bound over the trees of the path and of the contour.

use core::f64::consts::FRAC_PI_2;

use super::chain::turn;
use super::distance::{NearestPair, nearest};
use super::material::PartContour;
use super::outside::outside;
use super::shape::GougeCurve;
use super::tree::{BlockHull, BoxTree, TreeBox, TurnTree, hulls, unwrapped_tangents};
use super::{CenterMove, Contour};

/// If the tangents of a part of the contour span no more than this angle, its offset path cannot come closer to it than
/// the radius.
///
/// Proof: for a path p at distance r from its contour c, and u after s, (p(u) − c(s))·t(u) is the integral of
/// (1 − κr) t(v)·t(u) dv. It is not negative as long as no block is reversed and the tangents span at most a right angle,
/// so the distance never falls below r.
const CONE: f64 = FRAC_PI_2 + 1e-9;

/// A pair of curves of path and contour that are closer than allowed.
#[derive(Clone, Copy, Debug)]
pub(super) struct GougeHit {
    pub(super) of_path: usize,
    pub(super) of_contour: usize,
    pub(super) near: NearestPair,
}

/// A gouge that is already reported: the ranges of path and contour that belong to it, as first and last index.
#[derive(Clone, Copy, Debug)]
pub(super) struct GougeCluster {
    path: (usize, usize),
    contour: (usize, usize),
}

impl GougeCluster {
    /// The ranges of `reach` mm on both sides of the hit, on the path and on the contour.
    pub(super) fn around(
        hit: &GougeHit,
        path: &[CenterMove],
        contour: &[GougeCurve],
        reach: f64,
    ) -> GougeCluster {
        let path_length = |k: usize| path.get(k).map(|m| m.curve.length());
        let contour_length = |k: usize| contour.get(k).map(GougeCurve::length);
        GougeCluster {
            path: indices_within(hit.of_path, reach, path_length),
            contour: indices_within(hit.of_contour, reach, contour_length),
        }
    }

    /// Whether a pair of ranges overlaps this one.
    fn meets(&self, path: (usize, usize), contour: (usize, usize)) -> bool {
        let meet = |part: (usize, usize), all: (usize, usize)| part.0 <= all.1 && part.1 >= all.0;
        meet(path, self.path) && meet(contour, self.contour)
    }

    fn holds(&self, path: (usize, usize), contour: (usize, usize)) -> bool {
        let inside = |part: (usize, usize), all: (usize, usize)| part.0 >= all.0 && part.1 <= all.1;
        inside(path, self.path) && inside(contour, self.contour)
    }
}

fn indices_within(at: usize, reach: f64, length: impl Fn(usize) -> Option<f64>) -> (usize, usize) {
    let (mut first, mut last) = (at, at);
    let mut course = 0.0;
    while first > 0 && course < reach {
        first -= 1;
        course += length(first).unwrap_or(0.0);
    }
    course = 0.0;
    while course < reach
        && let Some(step) = length(last + 1)
    {
        last += 1;
        course += step;
    }
    (first, last)
}

/// Which hit a search looks for.
#[derive(Clone, Copy, Debug)]
pub(super) enum SearchAim {
    /// The smallest distance, also within the parts of the contour that [`CONE`] excludes.
    Clearance,
    /// The deepest gouge.
    Deepest,
    /// Any gouge.
    Any,
    /// The deepest gouge in a cluster.
    DeepestIn(GougeCluster),
    /// The deepest gouge in a cluster that is made by a block of the part, not by a lead.
    DeepestOfPart(GougeCluster),
    /// The deepest gouge in a cluster that is made by a lead and is farther from the open ends than the tool diameter:
    /// nearer ones belong to the gouge at the end.
    DeepestOffEnds(GougeCluster),
}

/// The trees over a contour and a path.
pub(super) struct GougeSearch<'a> {
    material: &'a PartContour,
    path: &'a [CenterMove],
    boxes: BoxTree,
    path_boxes: BoxTree,
    hulls: Vec<BlockHull>,
    turns: TurnTree,
    /// The radius of the tool, mm.
    radius: f64,
    /// How many pairs of nodes or curves may still be compared.
    pub(super) budget: u64,
}

impl<'a> GougeSearch<'a> {
    pub(super) fn new(
        contour: &Contour,
        material: &'a PartContour,
        path: &'a [CenterMove],
        slack: f64,
        budget: u64,
    ) -> Self {
        let mut broken = vec![true; material.curves.len()];
        let of_moves = offsets(contour, material, path, slack, &mut broken);
        for (flag, gap) in broken.iter_mut().zip(&material.breaks) {
            *flag |= gap;
        }
        let tangents = unwrapped_tangents(material.curves.iter());
        GougeSearch {
            material,
            path,
            boxes: BoxTree::over(material.curves.iter()),
            path_boxes: BoxTree::over(path.iter().map(|m| &m.curve)),
            hulls: hulls(&of_moves),
            turns: TurnTree::over(&tangents, &broken),
            radius: contour.radius,
            budget,
        }
    }

    /// A hit with a distance below `limit`, mm, that is in none of the clusters.
    pub(super) fn nearest(
        &mut self,
        limit: f64,
        clusters: &[GougeCluster],
        aim: SearchAim,
    ) -> Option<GougeHit> {
        if limit <= 0.0 || self.path.is_empty() || self.material.curves.is_empty() {
            return None;
        }
        let mut limit = limit * limit;
        let mut best = None;
        let mut stack = vec![(1, 1, self.path_boxes.nodes[1].gap_square(&self.boxes.nodes[1]))];
        while let Some((of_path, of_contour, gap)) = stack.pop() {
            if gap >= limit || self.spent(1) || self.is_settled(of_path, of_contour, clusters, aim)
            {
                continue;
            }
            if self.path_boxes.is_leaf(of_path) && self.boxes.is_leaf(of_contour) {
                self.try_leaves((of_path, of_contour), clusters, aim, &mut limit, &mut best);
                if best.is_some() && matches!(aim, SearchAim::Any) {
                    break;
                }
            } else {
                self.split(of_path, of_contour, limit, &mut stack);
            }
        }
        best
    }

    fn spent(&mut self, steps: u64) -> bool {
        self.budget = self.budget.saturating_sub(steps);
        self.budget == 0
    }

    /// Whether a pair of nodes needs no search, whatever its distance.
    fn is_settled(
        &self,
        of_path: usize,
        of_contour: usize,
        clusters: &[GougeCluster],
        aim: SearchAim,
    ) -> bool {
        let (first, end) = self.boxes.range(of_contour);
        let (path_first, path_end) = self.path_boxes.range(of_path);
        if first == end || path_first == path_end {
            return true;
        }
        let (path_span, span) = ((path_first, path_end - 1), (first, end - 1));
        if let SearchAim::DeepestIn(section)
        | SearchAim::DeepestOfPart(section)
        | SearchAim::DeepestOffEnds(section) = aim
            && !section.meets(path_span, span)
        {
            return true;
        }
        let hull = self.hulls[of_path];
        if !hull.foreign && !matches!(aim, SearchAim::Clearance) {
            let low = (hull.first as usize).min(first);
            let high = (hull.last as usize).max(end - 1);
            if self.turns.is_within(low, high, CONE) {
                return true;
            }
        }
        clusters.iter().any(|c| c.holds(path_span, span))
    }

    /// Replaces the larger of two nodes by its halves, with the nearer one on top of the stack.
    fn split(
        &self,
        of_path: usize,
        of_contour: usize,
        limit: f64,
        stack: &mut Vec<(usize, usize, f64)>,
    ) {
        let (path, contour) = (&self.path_boxes, &self.boxes);
        let path_first = contour.is_leaf(of_contour)
            || !path.is_leaf(of_path)
                && path.nodes[of_path].size() >= contour.nodes[of_contour].size();
        let pair = |half: usize| {
            let (p, c) = if path_first {
                (2 * of_path + half, of_contour)
            } else {
                (of_path, 2 * of_contour + half)
            };
            (p, c, path.nodes[p].gap_square(&contour.nodes[c]))
        };
        let (mut far, mut near) = (pair(0), pair(1));
        if far.2 < near.2 {
            core::mem::swap(&mut far, &mut near);
        }
        for half in [far, near] {
            if half.2 < limit {
                stack.push(half);
            }
        }
    }

    fn try_leaves(
        &mut self,
        (of_path, of_contour): (usize, usize),
        clusters: &[GougeCluster],
        aim: SearchAim,
        limit: &mut f64,
        best: &mut Option<GougeHit>,
    ) {
        let (path_first, path_end) = self.path_boxes.range(of_path);
        let (first, end) = self.boxes.range(of_contour);
        let whole = self.boxes.nodes[of_contour];
        for p in path_first..path_end {
            let bounds = self.path_boxes.elements[p];
            let curve = &self.path[p].curve;
            if bounds.gap_square(&whole) >= *limit || is_beyond(curve, &whole, *limit) {
                continue;
            }
            let of_part = || self.material.has(self.path[p].tag);
            let spares_ends = matches!(aim, SearchAim::DeepestOffEnds(_));
            if matches!(aim, SearchAim::DeepestOfPart(_)) && !of_part() || spares_ends && of_part()
            {
                continue;
            }
            for c in first..end {
                if bounds.gap_square(&self.boxes.elements[c]) >= *limit
                    || is_beyond(curve, &self.boxes.elements[c], *limit)
                    || clusters.iter().any(|k| k.holds((p, p), (c, c)))
                {
                    continue;
                }
                self.budget = self.budget.saturating_sub(1);
                let wall = &self.material.curves[c];
                let near = match spares_ends {
                    false => Some(nearest(curve, wall)),
                    true => self.nearest_off_ends(curve, wall),
                };
                if let Some(near) = near
                    && near.square < *limit
                {
                    *limit = near.square;
                    *best = Some(GougeHit { of_path: p, of_contour: c, near });
                }
            }
        }
    }
}

impl GougeSearch<'_> {
    /// The nearest points of a curve of the path and the part of a wall that is farther from the open ends than the tool
    /// diameter.
    fn nearest_off_ends(&self, curve: &GougeCurve, wall: &GougeCurve) -> Option<NearestPair> {
        let parts = outside(wall, &self.material.open_ends, 2.0 * self.radius);
        parts.iter().map(|part| nearest(curve, part)).min_by(|a, b| a.square.total_cmp(&b.square))
    }
}

/// Whether the circle around a box is farther from a curve than the square root of `limit`. For a slanting curve this is
/// more exact than a comparison of boxes.
fn is_beyond(curve: &GougeCurve, bounds: &TreeBox, limit: f64) -> bool {
    let center = (bounds.min + bounds.max) * 0.5;
    let distance = match *curve {
        GougeCurve::Line { .. } => curve.nearest(center).distance(center),
        GougeCurve::Arc { center: about, radius, .. } => (center.distance(about) - radius).abs(),
    };
    let gap = distance - 0.5 * bounds.min.distance(bounds.max);
    // Rounding must not hide a hit.
    gap > 0.0 && gap * gap * (1.0 - 1e-12) >= limit
}

/// Finds the blocks that each move of the path follows. Clears `broken` for the blocks that have a move which is their
/// exact offset, in the same direction, and no other moves.
fn offsets(
    contour: &Contour,
    material: &PartContour,
    path: &[CenterMove],
    slack: f64,
    broken: &mut [bool],
) -> Vec<BlockHull> {
    const FOREIGN: BlockHull = BlockHull { first: u32::MAX, last: 0, foreign: true };
    let signed = contour.side.sign() * contour.radius;
    let mut spoilt = Vec::new();
    let mut guess = 0;
    let hulls = path
        .iter()
        .map(|step| {
            let Some(at) = material.place(step.tag, &mut guess) else { return FOREIGN };
            if is_offset(&step.curve, &material.curves[at], signed, slack) {
                broken[at] = false;
                BlockHull { first: at as u32, last: at as u32, foreign: false }
            } else if let Some(hull) = around_corner(&step.curve, material, at, signed, slack) {
                hull
            } else {
                spoilt.push(at);
                FOREIGN
            }
        })
        .collect();
    for at in spoilt {
        broken[at] = true;
    }
    hulls
}

/// Whether a move is the offset of a block by `signed` to its left, mm, in the same direction.
fn is_offset(step: &GougeCurve, block: &GougeCurve, signed: f64, slack: f64) -> bool {
    match (step, block) {
        (GougeCurve::Line { from, to }, GougeCurve::Line { from: start, to: end }) => {
            let Some(along) = (*end - *start).normalized() else { return false };
            let adjacent =
                |p: chordal_geometry::Vec2| (along.cross(p - *start) - signed).abs() <= slack;
            (*to - *from).dot(along) > 0.0 && adjacent(*from) && adjacent(*to)
        }
        (
            GougeCurve::Arc { center, radius, sweep, .. },
            GougeCurve::Arc { center: about, radius: of_block, sweep: turned, .. },
        ) => {
            let adjacent = of_block - signed * turned.signum();
            center.distance(*about) <= slack
                && (radius - adjacent).abs() <= slack
                && sweep * turned > 0.0
                && sweep.abs() <= turned.abs() + 1e-6
        }
        _ => false,
    }
}

/// The blocks at the outside corner at the end of block `at`, if the move links their offsets and comes nowhere closer
/// to the corner than the radius. An inside corner has no links: the offsets intersect there, or they are not trimmed.
fn around_corner(
    step: &GougeCurve,
    material: &PartContour,
    at: usize,
    signed: f64,
    slack: f64,
) -> Option<BlockHull> {
    let last = material.curves.len() - 1;
    let next = if at < last { at + 1 } else { 0 };
    if next == 0 && !material.is_closed() {
        return None;
    }
    let (before, after) = (&material.curves[at], &material.curves[next]);
    let (corner, radius) = (before.to(), signed.abs());
    let links = match *step {
        // The farthest vertex of a linear corner is √2 radii from it.
        GougeCurve::Line { from, to } => {
            let farthest = 1.5 * radius;
            from.distance(corner) <= farthest
                && to.distance(corner) <= farthest
                && step.nearest(corner).distance(corner) >= radius - slack
        }
        GougeCurve::Arc { center, radius: about, .. } => {
            center.distance(corner) <= slack && (about - radius).abs() <= slack
        }
    };
    (links && turn(before, after) * signed <= 0.0).then_some(BlockHull {
        first: at as u32,
        last: (at + 1).min(last) as u32,
        foreign: false,
    })
}
