//! Regions of the half plane, and what can be asked of them.

use chordal_geometry::Vec2;

use super::arrange::{
    ArrangementInput, ArrangementResult, EdgeArrangement, NEW, NoOthers, RegionRule,
};
use super::edge::{ArcCircle, Box2, RegionEdge, push_arc};
use super::hull::DirectionHull;
use super::loops::{loops, outline};
use super::overlay::{
    AreaAndVolume, OverlayError, OverlayOperands, OverlayScale, OverlayWorkspace, measure,
};
use super::segment::OutlineSegment;

/// Coordinates up to this size (mm) are taken: what turns on a lathe is smaller, and squares of it keep
/// their digits.
const MAX_COORDINATE_MM: f64 = 1e6;
/// Ends of segments this near (mm) are joined: the last digit of a written coordinate.
const JOIN_GAP_MM: f64 = 1e-4;
/// The radii of an arc's two ends may differ by this (mm), as they do in drawings with three digits; the
/// centre then moves to the middle between the ends.
const RADII: f64 = 0.01;
/// Radii that differ by no more (mm) are the same: outlines that came from here.
const EQUAL_RADIUS_MM: f64 = 1e-8;
/// Vertices that outlines leave out lie on their edges to this part of the size.
const ON_EDGE: f64 = 1e-11;
/// Areas below this part of the size squared are none.
const NO_AREA: f64 = 1e-15;

/// What is wrong with an outline.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum RegionError {
    /// A coordinate is not a number, or too large.
    #[error("a coordinate of the outline is {value}; sizes up to 1,000,000 mm can be used")]
    OutOfRange {
        /// The coordinate, mm.
        value: f64,
    },
    /// A dimension is zero, or below it, or less than another one.
    #[error("the {what} must be more than {more_than} mm, it is {value} mm")]
    TooSmall {
        /// What it is.
        what: &'static str,
        /// Its value, mm.
        value: f64,
        /// What it must exceed, mm.
        more_than: f64,
    },
    /// A loop has fewer segments than enclose an area, or encloses none.
    #[error("loop {number} of the outline encloses no area")]
    Empty {
        /// Which loop, from 1.
        number: usize,
    },
    /// A segment does not begin where the one before it ends.
    #[error("loop {number} of the outline is open at z {z} mm, r {r} mm")]
    Open {
        /// Which loop, from 1.
        number: usize,
        /// Where, mm.
        z: f64,
        /// Where, mm.
        r: f64,
    },
    /// A point lies on the other side of the axis.
    #[error("the outline passes the axis at z {z} mm: its radius there is {r} mm")]
    BelowAxis {
        /// Where, mm.
        z: f64,
        /// Where, mm.
        r: f64,
    },
    /// The ends of an arc have different distances from its centre.
    #[error(
        "the ends of the arc at z {z} mm, r {r} mm are {first} and {second} mm from its centre"
    )]
    Radii {
        /// Its start, mm.
        z: f64,
        /// Its start, mm.
        r: f64,
        /// Distance of the start, mm.
        first: f64,
        /// Distance of the end, mm.
        second: f64,
    },
    /// Lines or arcs cross.
    #[error("the outline crosses itself")]
    CrossesItself,
}

/// A region of the half plane (z, r), bounded by lines and arcs: half the section of a turned body.
///
/// A point is a [`Vec2`] whose `a` is z and whose `b` is r, both in mm, r from 0 up.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Region {
    edges: Vec<RegionEdge>,
}

/// What a boolean operation made, and how exact it is.
#[derive(Clone, Debug, PartialEq)]
pub struct CombinedRegion {
    /// The result.
    pub region: Region,
    /// How far its outline may be off the exact one, mm. As a rule 0; 1e-11 of the size where the first
    /// operand has walls or gaps thinner than that, more where the second one had to be shifted to be told
    /// apart from it.
    pub bound: f64,
}

impl Region {
    /// A bar of this radius (mm) from one z to another.
    pub fn bar(radius: f64, from: f64, to: f64) -> Result<Region, RegionError> {
        Region::tube(0.0, radius, from, to)
    }

    /// A tube between two radii (mm) from one z to another; with an inner radius of zero it is a bar.
    pub fn tube(inner: f64, outer: f64, from: f64, to: f64) -> Result<Region, RegionError> {
        for value in [inner, outer, from, to] {
            in_range(value)?;
        }
        if inner < 0.0 {
            return Err(RegionError::BelowAxis { z: from, r: inner });
        }
        if outer <= inner {
            let (what, value) = ("outer radius", outer);
            return Err(RegionError::TooSmall { what, value, more_than: inner });
        }
        let (low, high) = (from.min(to), from.max(to));
        if low == high {
            return Err(RegionError::TooSmall { what: "length", value: 0.0, more_than: 0.0 });
        }
        let corner = |z, r| Vec2::new(z, r);
        let corners =
            [corner(low, inner), corner(high, inner), corner(high, outer), corner(low, outer)];
        let mut edges: Vec<RegionEdge> =
            (0..4).map(|at| RegionEdge::line(corners[at], corners[(at + 1) % 4], 0)).collect();
        number_in_turn(&mut edges, 0);
        Ok(Region { edges })
    }

    /// Any outline: closed loops in either sense. What lies within an odd number of them belongs to the
    /// region, so holes are loops within loops.
    pub fn contour(loops: &[Vec<OutlineSegment>]) -> Result<Region, RegionError> {
        let mut edges = Vec::new();
        for (at, segments) in loops.iter().enumerate() {
            closed_loop(&mut edges, segments, at + 1)?;
        }
        for edge in &edges {
            let bounds = edge.bounds();
            if bounds.min.b < -JOIN_GAP_MM {
                return Err(RegionError::BelowAxis { z: bounds.min.a, r: bounds.min.b });
            }
        }
        let bounds = Box2::around(&edges);
        let mut arrangement = EdgeArrangement::default();
        let OverlayScale { tolerance, margin, .. } = OverlayScale::new(bounds.size(), 0.0);
        let hull = &DirectionHull::default();
        let input = ArrangementInput {
            first: &[],
            others: &NoOthers,
            second: &edges,
            simple: false,
            hull,
            margin,
            tolerance,
        };
        arrangement.lay(&input);
        if arrangement.own_crossings > 0 || !arrangement.closes(RegionRule::Odd) {
            return Err(RegionError::CrossesItself);
        }
        let mut outcome = ArrangementResult::default();
        arrangement.outcome(&input, RegionRule::Odd, &mut outcome);
        Ok(Region::of(outcome.came))
    }

    /// From edges with vertices of any numbers.
    pub(crate) fn of(mut edges: Vec<RegionEdge>) -> Region {
        let mut vertices: Vec<u64> = edges.iter().flat_map(|edge| edge.ends).collect();
        vertices.sort_unstable();
        vertices.dedup();
        for edge in &mut edges {
            edge.ends = edge.ends.map(|end| vertices.partition_point(|known| *known < end) as u64);
        }
        Region { edges }
    }

    pub(crate) fn edges(&self) -> &[RegionEdge] {
        &self.edges
    }

    /// Whether nothing is left of it.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.edges.is_empty()
    }

    /// The area of the half section, mm².
    #[must_use]
    pub fn area(&self) -> f64 {
        self.amounts().area
    }

    /// The volume of the body, mm³: −π∮r²dz, exact for lines and arcs.
    #[must_use]
    pub fn volume(&self) -> f64 {
        self.amounts().volume
    }

    pub(crate) fn amounts(&self) -> AreaAndVolume {
        let Some((low, high)) = self.bounds() else { return AreaAndVolume::default() };
        measure(&self.edges, (low + high) * 0.5)
    }

    /// The corners of the box around it: least z and r, largest z and r, mm. `None` of nothing.
    #[must_use]
    pub fn bounds(&self) -> Option<(Vec2, Vec2)> {
        let bounds = Box2::around(&self.edges);
        (!self.is_empty()).then_some((bounds.min, bounds.max))
    }

    /// The outline, loop by loop, with the region to the left of travel: outer loops counter-clockwise,
    /// holes clockwise (z to the right, r up). Neighbours on one line or circle that one move made are one
    /// segment.
    #[must_use]
    pub fn outline(&self) -> Vec<Vec<OutlineSegment>> {
        let tolerance = ON_EDGE * Box2::around(&self.edges).size();
        loops(&self.edges).iter().map(|chain| outline(chain, tolerance)).collect()
    }

    /// The outline without regard to who made it: neighbours on one line or circle are one segment.
    #[must_use]
    pub fn shape(&self) -> Vec<Vec<OutlineSegment>> {
        let tolerance = ON_EDGE * Box2::around(&self.edges).size();
        let plain = |edge: &RegionEdge| RegionEdge { tag: 0, ..*edge };
        let chains = loops(&self.edges);
        chains
            .iter()
            .map(|chain| chain.iter().map(plain).collect::<Vec<_>>())
            .map(|chain| outline(&chain, tolerance))
            .collect()
    }

    /// The same at another place.
    #[must_use]
    pub fn moved(&self, by: Vec2) -> Region {
        Region { edges: self.edges.iter().map(|edge| edge.moved(by)).collect() }
    }

    /// What is in this region and not in the other one.
    pub fn difference(&self, other: &Region) -> Result<CombinedRegion, OverlayError> {
        self.combined(other, RegionRule::Difference)
    }

    /// What is in both.
    pub fn intersection(&self, other: &Region) -> Result<CombinedRegion, OverlayError> {
        self.combined(other, RegionRule::Intersection)
    }

    /// What is in one of them or in both.
    pub fn union(&self, other: &Region) -> Result<CombinedRegion, OverlayError> {
        self.combined(other, RegionRule::Union)
    }

    fn combined(&self, other: &Region, rule: RegionRule) -> Result<CombinedRegion, OverlayError> {
        let bounds = Box2::around(&self.edges).with(&Box2::around(&other.edges));
        let operands = OverlayOperands {
            first: &self.edges,
            others: &NoOthers,
            second: &other.edges,
            simple: false,
            bounds,
            // Without directions everything is near.
            hull: &DirectionHull::default(),
            scale: OverlayScale::new(bounds.size(), self.area()),
        };
        let mut overlay = OverlayWorkspace::default();
        overlay.lay(&operands).or_else(|_| overlay.lay_shifted(&operands))?;
        let mut outcome = ArrangementResult::default();
        overlay.outcome(&operands, rule, &mut outcome);
        let mut gone = vec![false; self.edges.len()];
        outcome.gone.iter().for_each(|at| gone[*at as usize] = true);
        let stay = self.edges.iter().zip(gone).filter(|(_, gone)| !gone).map(|(edge, _)| *edge);
        let region = Region::of(stay.chain(outcome.came).collect());
        Ok(CombinedRegion { region, bound: overlay.off })
    }
}

/// Numbers the vertices of one loop.
fn number_in_turn(edges: &mut [RegionEdge], first: u64) {
    let count = edges.len() as u64;
    for (at, edge) in (0..).zip(edges.iter_mut()) {
        edge.ends = [first + at, first + (at + 1) % count];
    }
}

pub(crate) fn in_range(value: f64) -> Result<(), RegionError> {
    if value.abs() <= MAX_COORDINATE_MM { Ok(()) } else { Err(RegionError::OutOfRange { value }) }
}

/// The edges of a loop of segments.
fn closed_loop(
    edges: &mut Vec<RegionEdge>,
    segments: &[OutlineSegment],
    number: usize,
) -> Result<(), RegionError> {
    let first = edges.len();
    let Some(last) = segments.last() else { return Err(RegionError::Empty { number }) };
    let mut from = last.end;
    in_range(from.a)?;
    in_range(from.b)?;
    for (at, segment) in segments.iter().enumerate() {
        for value in [segment.start.a, segment.start.b, segment.end.a, segment.end.b] {
            in_range(value)?;
        }
        if from.distance(segment.start) > JOIN_GAP_MM {
            return Err(RegionError::Open { number, z: from.a, r: from.b });
        }
        // The one before may have ended elsewhere within the gap.
        let start = if at == 0 { from } else { edges.last().map_or(from, |edge| edge.end) };
        push_segment(edges, &OutlineSegment { start, ..*segment })?;
        from = segment.end;
    }
    let area: f64 = edges[first..].iter().map(|edge| edge.area(from)).sum();
    let size = Box2::around(&edges[first..]).size();
    if area.abs() <= NO_AREA * size * size {
        return Err(RegionError::Empty { number });
    }
    number_in_turn(&mut edges[first..], NEW | first as u64);
    Ok(())
}

/// One segment as edges. The centre of an arc is moved to the middle between its ends.
fn push_segment(edges: &mut Vec<RegionEdge>, segment: &OutlineSegment) -> Result<(), RegionError> {
    let OutlineSegment { start, end, tag, .. } = *segment;
    match circle_of(segment)? {
        None if start == end => {}
        None => edges.push(RegionEdge::line(start, end, tag)),
        Some(circle) => {
            let arc = OutlineSegment::arc(start, end, circle.center, circle.counterclockwise);
            push_arc(edges, (start, end), circle, arc.sweep().abs(), tag);
        }
    }
    Ok(())
}

/// The circle through both ends whose centre is nearest to the one given; `None` where that is not near.
fn centered(start: Vec2, end: Vec2, provided: Vec2, counterclockwise: bool) -> Option<ArcCircle> {
    let (first, second) = (start.distance(provided), end.distance(provided));
    if (first - second).abs() <= EQUAL_RADIUS_MM && first + second > 0.0 {
        // Of a short arc the middle between the ends may be far away.
        return Some(ArcCircle {
            center: provided,
            radius: 0.5 * (first + second),
            counterclockwise,
        });
    }
    let half = (start + end) * 0.5;
    let center = match (end - start).normalized() {
        Some(along) => provided + along * (half - provided).dot(along),
        None => provided,
    };
    let radius = start.distance(center);
    let near = center.distance(provided) <= RADII && radius > 0.0;
    near.then_some(ArcCircle { center, radius, counterclockwise })
}

/// The circle of an arc between its two ends, as [`Region::contour`] takes it.
pub(crate) fn circle_of(segment: &OutlineSegment) -> Result<Option<ArcCircle>, RegionError> {
    let OutlineSegment { start, end, bend, .. } = *segment;
    let Some(bend) = bend else { return Ok(None) };
    in_range(bend.center.a)?;
    in_range(bend.center.b)?;
    let (first, second) = (start.distance(bend.center), end.distance(bend.center));
    match centered(start, end, bend.center, bend.counterclockwise) {
        Some(circle) => Ok(Some(circle)),
        None => Err(RegionError::Radii { z: start.a, r: start.b, first, second }),
    }
}
