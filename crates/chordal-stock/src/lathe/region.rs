//! Regions of the half plane.

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

/// Largest coordinate, mm: parts on a lathe are smaller, and squares of coordinates keep enough digits.
const MAX_COORDINATE_MM: f64 = 1e6;
/// Ends of segments within this distance are joined, mm: the last digit of a written coordinate.
const JOIN_GAP_MM: f64 = 1e-4;
/// The radii of an arc's two ends may differ by this, mm, as they do in drawings with three decimals; the centre is
/// then moved to be equally far from both ends.
const RADII: f64 = 0.01;
/// Radii that differ by no more than this are equal, mm, as in outlines that were made here.
const EQUAL_RADIUS_MM: f64 = 1e-8;
/// Tolerance for vertices that outlines leave out, as a share of the size.
const ON_EDGE: f64 = 1e-11;
/// Areas below this share of the size squared count as zero.
const NO_AREA: f64 = 1e-15;

/// Why an outline does not give a region.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum RegionError {
    /// A coordinate is not finite, or too large.
    #[error("a coordinate of the outline is {value}; sizes up to 1,000,000 mm can be used")]
    OutOfRange {
        /// The coordinate, mm.
        value: f64,
    },
    /// A dimension is not larger than another one, or than zero.
    #[error("the {what} must be more than {more_than} mm, it is {value} mm")]
    TooSmall {
        /// What it is.
        what: &'static str,
        /// Its value, mm.
        value: f64,
        /// What it must exceed, mm.
        more_than: f64,
    },
    /// A loop encloses no area.
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
        /// The z of the gap, mm.
        z: f64,
        /// The radius of the gap, mm.
        r: f64,
    },
    /// A point lies on the other side of the axis.
    #[error("the outline passes the axis at z {z} mm: its radius there is {r} mm")]
    BelowAxis {
        /// The z of that point, mm.
        z: f64,
        /// The radius of that point, mm.
        r: f64,
    },
    /// The ends of an arc have different distances from its centre.
    #[error(
        "the ends of the arc at z {z} mm, r {r} mm are {first} and {second} mm from its centre"
    )]
    Radii {
        /// The z of its start, mm.
        z: f64,
        /// The radius of its start, mm.
        r: f64,
        /// Distance of the start from the centre, mm.
        first: f64,
        /// Distance of the end from the centre, mm.
        second: f64,
    },
    /// Lines or arcs cross.
    #[error("the outline crosses itself")]
    CrossesItself,
}

/// A region of the half plane (z, r), bounded by lines and arcs: the half section of a turned body.
///
/// A point is a [`Vec2`] whose `a` is z and whose `b` is r, both in mm, with r ≥ 0.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Region {
    edges: Vec<RegionEdge>,
}

/// The result of a boolean operation, and its error bound.
#[derive(Clone, Debug, PartialEq)]
pub struct CombinedRegion {
    /// The result.
    pub region: Region,
    /// Bound of the deviation of its outline from the exact one, mm. Usually 0; 1e-11 of the size where the first
    /// operand has walls or gaps thinner than that; more where the second operand had to be shifted to resolve a near
    /// coincidence.
    pub bound: f64,
}

impl Region {
    /// A bar of this radius between two z, mm.
    pub fn bar(radius: f64, from: f64, to: f64) -> Result<Region, RegionError> {
        Region::tube(0.0, radius, from, to)
    }

    /// A tube between two radii and two z, mm; with an inner radius of zero it is a bar.
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

    /// The region within closed loops in either sense. Points inside an odd number of loops belong to it, so holes
    /// are loops within loops.
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

    /// The region with these edges, whose vertices are renumbered.
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

    /// Whether it is empty.
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

    /// The corners of its bounding box: least z and r, largest z and r, mm. `None` for an empty region.
    #[must_use]
    pub fn bounds(&self) -> Option<(Vec2, Vec2)> {
        let bounds = Box2::around(&self.edges);
        (!self.is_empty()).then_some((bounds.min, bounds.max))
    }

    /// The outline, loop by loop, with the region to the left: outer loops counter-clockwise, holes clockwise (z to
    /// the right, r up). Adjoining edges on one line or circle that one move made are one segment.
    #[must_use]
    pub fn outline(&self) -> Vec<Vec<OutlineSegment>> {
        let tolerance = ON_EDGE * Box2::around(&self.edges).size();
        loops(&self.edges).iter().map(|chain| outline(chain, tolerance)).collect()
    }

    /// The outline without regard to the moves that made it: adjoining edges on one line or circle are one segment.
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

    /// The region moved by a vector, mm.
    #[must_use]
    pub fn moved(&self, by: Vec2) -> Region {
        Region { edges: self.edges.iter().map(|edge| edge.moved(by)).collect() }
    }

    /// The points in this region that are not in the other one.
    pub fn difference(&self, other: &Region) -> Result<CombinedRegion, OverlayError> {
        self.combined(other, RegionRule::Difference)
    }

    /// The points in both regions.
    pub fn intersection(&self, other: &Region) -> Result<CombinedRegion, OverlayError> {
        self.combined(other, RegionRule::Intersection)
    }

    /// The points in one or both of the regions.
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
            // A hull without directions rejects nothing.
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
        // The previous segment may have ended elsewhere within the tolerance.
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

/// Adds one segment as edges. The centre of an arc is moved to be equally far from both ends.
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

/// The circle through both ends whose centre is nearest to `nominal`; `None` where it is farther than [`RADII`].
fn centered(start: Vec2, end: Vec2, nominal: Vec2, counterclockwise: bool) -> Option<ArcCircle> {
    let (first, second) = (start.distance(nominal), end.distance(nominal));
    if (first - second).abs() <= EQUAL_RADIUS_MM && first + second > 0.0 {
        // The given centre is kept: for a short arc, the equidistant point may be far away from it.
        return Some(ArcCircle {
            center: nominal,
            radius: 0.5 * (first + second),
            counterclockwise,
        });
    }
    let half = (start + end) * 0.5;
    let center = match (end - start).normalized() {
        Some(along) => nominal + along * (half - nominal).dot(along),
        None => nominal,
    };
    let radius = start.distance(center);
    let near = center.distance(nominal) <= RADII && radius > 0.0;
    near.then_some(ArcCircle { center, radius, counterclockwise })
}

/// The circle of an arc through its two ends, as in [`Region::contour`]; `None` for a line.
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
