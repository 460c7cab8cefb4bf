//! The floor that a move leaves: the exact lowest point of a cutter above a column.
//!
//! A column is a vertical line at a place in plan. While the axis of the tool is within the cutter's radius
//! of it, the move removes what is between the lowest place of the cutter there and the end of its edges:
//! a [`RemovedSpan`] for each connected part of the move that is over the column. The lowest point has a closed
//! form on lines for all cutters, on arcs and helices about Z for all but rounds about a circle (bull nose)
//! on helices, on arcs in vertical planes for flats and balls. Everything else is found between two bounds.
//!
//! Nothing is sampled. Closed forms are exact to rounding, where that of the edge of a cutter is like a
//! column that stands aside by as much.

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

/// What a move removes from a column in one connected part of it, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RemovedSpan {
    /// The lowest place.
    pub floor: f64,
    /// The highest place of the edges; infinite where it is not known how far they reach.
    pub top: f64,
}

/// Where along a move the lowest point above a column is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LowestLocation {
    /// At the start: the move before, which ends there, is as low above this column or lower.
    Start,
    /// Between the ends, and lower than at either.
    Between,
    /// At the end: the next move, which begins there, is as low above this column or lower. Also where start
    /// and end are as low.
    End,
}

/// The lowest point above a column along a move, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LowestPoint {
    /// The move is nowhere lower. The same as `upper` where there is a closed form.
    pub lower: f64,
    /// The lowest that was found: the move is as low somewhere.
    pub upper: f64,
    /// Where that is.
    pub at: LowestLocation,
}

/// The upper side of the edges: `height` less the lower side of these rings, upside down.
#[derive(Clone, Debug)]
struct EdgeTop {
    rings: Vec<Ring>,
    height: f64,
    path: TipPath,
    is_convex: bool,
}

/// A cutter on a move, to be asked about many columns.
#[derive(Clone, Debug)]
pub struct CutterSweep<'a> {
    rings: Cow<'a, [Ring]>,
    path: TipPath,
    /// `None` where it is not known how far the edges reach up.
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

    /// The same for a cutter with edges above its widest place.
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

    /// The lowest point above a column, `[x, y]` in mm; `None` where the cutter is never over it.
    #[must_use]
    pub fn lowest(&self, place: [f64; 2]) -> Option<LowestPoint> {
        let low = self.path.lowest(self.profile(), place, self.gap);
        low.filter(|low| low.upper < f64::INFINITY)
    }

    /// Its height, mm: the upper bound where there are two.
    #[must_use]
    pub fn floor(&self, place: [f64; 2]) -> Option<f64> {
        self.lowest(place).map(|lowest| lowest.upper)
    }

    /// The highest point of the edges above a column, mm: that of the lower bound where there are two, as
    /// something as high is removed. `None` where the cutter is never over it, infinite where it is not
    /// known how far its edges reach.
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
            // Else the column is only nearly reached.
            if floor < f64::INFINITY && top > f64::NEG_INFINITY {
                out.push(RemovedSpan { floor, top });
            }
        });
    }
}

/// The lowest point of a cutter above a column (`[x, y]`, mm) along a move, mm; `None` where the cutter is
/// never over it. Where there is no closed form it is no more than `gap` mm above the truth, and never
/// below it. For many columns make a [`CutterSweep`].
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

/// Sorts spans from below, and makes one of those that overlap or touch.
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
