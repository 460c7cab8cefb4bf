//! The floor that a move leaves: the exact lowest point of a cutter over a column.
//!
//! A column is a vertical line at a point in plan. While the axis of the tool is within the cutter's radius of it,
//! the move removes what is between the lowest point of the cutter there and the upper end of its edges: a
//! [`RemovedSpan`] for each connected part of the move that is over the column. The lowest point has a closed form on
//! lines for all cutters; on arcs and helices about Z for all cutters, except for bull noses (tori) on helices; on
//! arcs in vertical planes for flats and balls. Everything else is found between two bounds.
//!
//! Nothing is sampled. Closed forms are exact up to rounding. At the vertical edge of a cutter, rounding acts like a
//! horizontal shift of the column.

mod bounds;
mod horizontal_arc;
mod path;
mod pieces;
mod profile;
mod straight;
mod upright;

use std::borrow::Cow;

use chordal_geometry::Curve;

use crate::cutter::{CutterProfile, Ring, RingElement, Undercut};
pub use bounds::HeightBounds;

use path::TipPath;
use profile::PushedProfile;

/// What one connected part of a move removes from a column, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RemovedSpan {
    /// Its lower end.
    pub floor: f64,
    /// Its upper end, that of the edges; infinite where it is not known how far they reach.
    pub top: f64,
}

/// Where along a move the lowest point over a column is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LowestLocation {
    /// At the start: the previous move, which ends there, is as low over this column or lower.
    Start,
    /// Between the ends, and lower than at either.
    Between,
    /// At the end: the next move, which begins there, is as low over this column or lower. Also where start and end
    /// are equally low.
    End,
}

/// The lowest point over a column along a move, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LowestPoint {
    /// Lower bound: the move is nowhere lower. Equal to `upper` where there is a closed form.
    pub lower: f64,
    /// Upper bound: the lowest point that was found.
    pub upper: f64,
    /// Where that point is.
    pub at: LowestLocation,
}

/// The upper side of the edges, as a mirror image: its height is `height` minus that of these rings.
#[derive(Clone, Debug)]
struct EdgeTop {
    rings: Vec<Ring>,
    height: f64,
    path: TipPath,
    is_convex: bool,
}

/// A cutter on a move, prepared to be evaluated at many columns.
#[derive(Clone, Debug)]
pub struct CutterSweep<'a> {
    rings: Cow<'a, [Ring]>,
    path: TipPath,
    /// `None` where the length of the edges is not known.
    top: Option<EdgeTop>,
    gap: f64,
    is_convex: bool,
}

impl<'a> CutterSweep<'a> {
    /// A cutter on a move of its tip; where there is no closed form the two bounds are within `gap` mm,
    /// which must be above zero.
    #[must_use]
    pub fn new(cutter: &'a CutterProfile, curve: &Curve, gap: f64) -> CutterSweep<'a> {
        let rings = cutter.edges();
        let to = rings.last().map_or(0.0, |ring| ring.to);
        let top = cutter.flutes().map(|height| {
            let disc = Ring { from: 0.0, to, element: RingElement::Disc { height: 0.0 } };
            EdgeTop { rings: vec![disc], height, path: TipPath::mirrored(curve), is_convex: true }
        });
        let is_convex = cutter.is_convex();
        CutterSweep { rings, path: TipPath::new(curve), top, gap, is_convex }
    }

    /// The same for a cutter with edges above its widest point.
    #[must_use]
    pub fn of_undercut(cutter: &'a Undercut, curve: &Curve, gap: f64) -> CutterSweep<'a> {
        let top = EdgeTop {
            rings: cutter.upper().rings().to_vec(),
            height: cutter.height(),
            path: TipPath::mirrored(curve),
            is_convex: cutter.upper().is_convex(),
        };
        let is_convex = cutter.lower().is_convex();
        let rings = Cow::Borrowed(cutter.lower().rings());
        CutterSweep { rings, path: TipPath::new(curve), top: Some(top), gap, is_convex }
    }

    fn profile(&self) -> PushedProfile<'_> {
        PushedProfile::new(&self.rings)
    }

    /// The lowest point over a column, `[x, y]` in mm; `None` where the cutter is never over it.
    #[must_use]
    pub fn lowest(&self, place: [f64; 2]) -> Option<LowestPoint> {
        let low = self.path.lowest(self.profile(), place, self.gap);
        low.filter(|low| low.upper < f64::INFINITY)
    }

    /// The height of the lowest point, mm: the upper bound where there are two; `None` where the cutter is never over
    /// the column.
    #[must_use]
    pub fn floor(&self, place: [f64; 2]) -> Option<f64> {
        self.lowest(place).map(|lowest| lowest.upper)
    }

    /// The highest point of the edges over a column, mm: the lower of the two bounds, which is certainly removed.
    /// `None` where the cutter is never over the column, infinite where the length of its edges is not known.
    #[must_use]
    pub fn top(&self, place: [f64; 2]) -> Option<f64> {
        let Some(top) = &self.top else { return self.lowest(place).map(|_| f64::INFINITY) };
        let lowest = top.path.lowest(PushedProfile::new(&top.rings), place, self.gap)?;
        (lowest.upper < f64::INFINITY).then_some(top.height - lowest.upper)
    }

    /// Adds what is removed from a column, one span for each connected part of the move that is over it, in
    /// the order of the move. They may overlap: see [`merge`].
    pub fn spans(&self, place: [f64; 2], out: &mut Vec<RemovedSpan>) {
        let lowest = |path: &TipPath, rings: &[Ring], range: [f64; 2]| {
            let low = path.lowest_within(PushedProfile::new(rings), place, range, self.gap);
            low.map_or(f64::INFINITY, |low| low.upper)
        };
        self.path.windows(place, self.profile().radius(), true, &mut |range| {
            let floor = lowest(&self.path, &self.rings, range);
            let top = match &self.top {
                None => f64::INFINITY,
                Some(top) => top.height - lowest(&top.path, &top.rings, range),
            };
            // Otherwise the column is not quite reached.
            if floor < f64::INFINITY && top > f64::NEG_INFINITY {
                out.push(RemovedSpan { floor, top });
            }
        });
    }
}

/// The lowest point of a cutter over a column (`[x, y]`, mm) along a move, mm; `None` where the cutter is never over
/// it. Without a closed form it is at most `gap` mm above the truth, and never below it. For many columns make a
/// [`CutterSweep`].
#[must_use]
pub fn floor(cutter: &CutterProfile, curve: &Curve, place: [f64; 2], gap: f64) -> Option<f64> {
    CutterSweep::new(cutter, curve, gap).floor(place)
}

/// Adds what a cutter removes from a column along a move: see [`CutterSweep::spans`].
pub fn spans(
    cutter: &CutterProfile,
    curve: &Curve,
    place: [f64; 2],
    gap: f64,
    out: &mut Vec<RemovedSpan>,
) {
    CutterSweep::new(cutter, curve, gap).spans(place, out);
}

/// Sorts spans from below, and merges those that overlap or touch.
pub fn merge(spans: &mut Vec<RemovedSpan>) {
    spans.sort_by(|a, b| a.floor.total_cmp(&b.floor));
    spans.dedup_by(|next, last| {
        let touches = next.floor <= last.top;
        if touches {
            last.top = last.top.max(next.top);
        }
        touches
    });
}
