//! Classifies a curve by the closed form that it has, if any.

use chordal_geometry::{Arc, Curve, ParamCurve, Spiral, Transform, Vec3};

use super::horizontal_arc::HorizontalArc;
use super::pieces::NumericCurve;
use super::profile::{LowestOffer, PushedProfile};
use super::straight::StraightPath;
use super::upright::VerticalArc;
use super::{LowestLocation, LowestPoint};

/// Largest length (mm) and angle. Beyond it, and for NaN, nothing is removed.
const MAX_LENGTH_MM: f64 = 1e12;
/// An axis counts as vertical where its tilt moves the path by no more than this, mm: rounding.
const UPRIGHT: f64 = 1e-12;
/// Heights within this are equal, mm: rounding.
const EQUAL_HEIGHT_MM: f64 = 1e-12;

/// A path of the tip with the method for its kind.
#[derive(Clone, Copy, Debug)]
pub(super) struct TipPath {
    /// The ends as the curve gives them: those of an arc may be slightly off its circle.
    start: Vec3,
    end: Vec3,
    kind: TipPathKind,
}

#[derive(Clone, Copy, Debug)]
#[allow(clippy::large_enum_variant, reason = "one for each move")]
enum TipPathKind {
    /// A curve without finite coordinates, which removes nothing.
    Nowhere,
    Straight(StraightPath),
    Around(HorizontalArc, NumericCurve),
    Upright(VerticalArc, NumericCurve),
    Pieces(NumericCurve),
}

impl TipPath {
    pub(super) fn new(curve: &Curve) -> TipPath {
        let (start, end) = (curve.start(), curve.end());
        let straight = TipPathKind::Straight(StraightPath::new(start, end));
        let kind = match curve {
            _ if !is_possible(curve) => TipPathKind::Nowhere,
            Curve::Line(_) => straight,
            Curve::Arc(arc) => of_arc(arc).unwrap_or(straight),
            Curve::Spiral(spiral) => of_spiral(spiral).unwrap_or(straight),
            Curve::Spline(spline) if spline.order() <= 2 => straight,
            Curve::Spline(spline) => TipPathKind::Pieces(NumericCurve::Spline(*spline)),
        };
        TipPath { start, end, kind }
    }

    /// The path of the mirror image of the curve in Z; its parameter is the same.
    pub(super) fn mirrored(curve: &Curve) -> TipPath {
        TipPath::new(&curve.transformed(&Transform::mirror(Vec3::Z, Vec3::ZERO)))
    }

    /// The whole range of the parameter.
    pub(super) const fn whole(&self) -> [f64; 2] {
        match &self.kind {
            TipPathKind::Nowhere | TipPathKind::Straight(_) | TipPathKind::Pieces(_) => [0.0, 1.0],
            TipPathKind::Around(around, _) => [0.0, around.sweep()],
            TipPathKind::Upright(upright, _) => [0.0, upright.sweep()],
        }
    }

    /// Emits the ranges of the parameter in which the axis is within a radius of the column, in order. What cannot be
    /// decided counts as within only where `is_outer`.
    pub(super) fn windows(
        &self,
        place: [f64; 2],
        radius: f64,
        is_outer: bool,
        push: &mut dyn FnMut([f64; 2]),
    ) {
        if !place.iter().all(|x| is_length(*x)) {
            return;
        }
        match &self.kind {
            TipPathKind::Nowhere => {}
            TipPathKind::Straight(line) => {
                if let Some(range) = line.window(place, radius) {
                    push(range);
                }
            }
            TipPathKind::Around(around, _) => around.windows(place, radius, push),
            TipPathKind::Upright(upright, _) => upright.windows(place, radius, push),
            TipPathKind::Pieces(pieces) => pieces.windows(place, radius, is_outer, push),
        }
    }

    /// The lowest point over a column along the whole path. Where it cannot be decided whether the column is reached,
    /// there is a lower bound, and the upper bound is infinite.
    pub(super) fn lowest(
        &self,
        profile: PushedProfile,
        place: [f64; 2],
        gap: f64,
    ) -> Option<LowestPoint> {
        let whole = self.whole();
        let upright = match &self.kind {
            TipPathKind::Upright(upright, _) if VerticalArc::is_closed_for(profile) => upright,
            _ => return self.lowest_within(profile, place, whole, gap),
        };
        let mut low = LowestOffer::NONE;
        upright.windows(place, profile.radius(), &mut |range| {
            if let Some(found) = upright.lowest(profile, place, range) {
                low.offer(found.height, found.at);
            }
        });
        self.with_ends(profile, place, whole, exact(low.found()))
    }

    /// The lowest point over a column within a range from [`TipPath::windows`].
    pub(super) fn lowest_within(
        &self,
        profile: PushedProfile,
        place: [f64; 2],
        range: [f64; 2],
        gap: f64,
    ) -> Option<LowestPoint> {
        if !place.iter().all(|x| is_length(*x)) {
            return None;
        }
        let found = match &self.kind {
            TipPathKind::Nowhere => return None,
            TipPathKind::Straight(line) => exact(line.lowest(profile, place)),
            TipPathKind::Around(around, _) if around.is_closed_for(profile) => {
                exact(around.lowest(profile, place, range))
            }
            TipPathKind::Upright(upright, _) if VerticalArc::is_closed_for(profile) => {
                exact(upright.lowest(profile, place, range))
            }
            TipPathKind::Around(_, pieces)
            | TipPathKind::Upright(_, pieces)
            | TipPathKind::Pieces(pieces) => {
                // Their parameter runs from 0 to 1.
                let [_, end] = self.whole();
                pieces.lowest(profile, place, range.map(|at| at / end), gap)
            }
        };
        self.with_ends(profile, place, range, found)
    }

    /// The largest distance of the given ends from the curve, mm.
    pub(super) fn off(&self) -> f64 {
        match &self.kind {
            TipPathKind::Nowhere | TipPathKind::Straight(_) => 0.0,
            TipPathKind::Around(_, pieces)
            | TipPathKind::Upright(_, pieces)
            | TipPathKind::Pieces(pieces) => {
                let [start, end] = [0.0, 1.0].map(|t| pieces.point(t));
                start.distance(self.start).max(end.distance(self.end))
            }
        }
    }

    /// The largest coordinate or dimension of the path, mm: rounding errors are a share of it.
    pub(super) fn size(&self) -> f64 {
        let ends = [self.start, self.end].into_iter().flat_map(Vec3::to_array);
        let size = ends.fold(0.0_f64, |size, x| size.max(x.abs()));
        match &self.kind {
            TipPathKind::Nowhere | TipPathKind::Straight(_) => size,
            TipPathKind::Around(_, pieces)
            | TipPathKind::Upright(_, pieces)
            | TipPathKind::Pieces(pieces) => size.max(pieces.size()),
        }
    }

    pub(super) const fn is_straight(&self) -> bool {
        matches!(self.kind, TipPathKind::Straight(_))
    }

    /// Completes a result with the given ends, and finds where the lowest point is.
    fn with_ends(
        &self,
        profile: PushedProfile,
        place: [f64; 2],
        range: [f64; 2],
        found: Option<(f64, LowestOffer)>,
    ) -> Option<LowestPoint> {
        let whole = self.whole();
        let height = |end: Vec3, is_within: bool| {
            let (x, y) = (end.x - place[0], end.y - place[1]);
            let height = end.z + profile.height_at((x * x + y * y).sqrt());
            if is_within { height } else { f64::INFINITY }
        };
        let start = height(self.start, range[0] <= whole[0]);
        let end = height(self.end, range[1] >= whole[1]);
        let (lower, upper) =
            found.map_or((f64::INFINITY, f64::INFINITY), |(lower, low)| (lower, low.height));
        let (lower, upper) = (lower.min(start).min(end), upper.min(start).min(end));
        if lower == f64::INFINITY {
            return None;
        }
        let at = if end <= upper + EQUAL_HEIGHT_MM {
            LowestLocation::End
        } else if start <= upper + EQUAL_HEIGHT_MM {
            LowestLocation::Start
        } else {
            LowestLocation::Between
        };
        Some(LowestPoint { lower, upper, at })
    }
}

fn is_length(x: f64) -> bool {
    x.abs() <= MAX_LENGTH_MM
}

fn is_point(p: Vec3) -> bool {
    [p.x, p.y, p.z].into_iter().all(is_length)
}

/// Whether the numbers of a curve are finite, and so small that their squares are finite, too.
fn is_possible(curve: &Curve) -> bool {
    let ends = is_point(curve.start()) && is_point(curve.end());
    ends && match curve {
        Curve::Line(_) => true,
        Curve::Arc(arc) => {
            is_point(arc.center) && [arc.radius, arc.sweep, arc.rise].into_iter().all(is_length)
        }
        Curve::Spiral(spiral) => {
            let numbers = [spiral.radius_start, spiral.radius_end, spiral.sweep, spiral.rise];
            is_point(spiral.center) && numbers.into_iter().all(is_length)
        }
        Curve::Spline(spline) => spline.points().iter().all(|point| is_point(*point)),
    }
}

/// The result of a closed form: lower bound and point are equal.
fn exact(low: Option<LowestOffer>) -> Option<(f64, LowestOffer)> {
    low.map(|low| (low.height, low))
}

/// `None` for an arc that is a straight line.
fn of_arc(arc: &Arc) -> Option<TipPathKind> {
    if arc.sweep == 0.0 || arc.radius == 0.0 {
        return None;
    }
    let pieces = NumericCurve::of_arc(arc);
    let lean = arc.radius + arc.rise.abs();
    let level = (arc.w.x * arc.w.x + arc.w.y * arc.w.y).sqrt();
    if level * lean <= UPRIGHT {
        return Some(TipPathKind::Around(HorizontalArc::new(arc), pieces));
    }
    let upright = arc.rise == 0.0 && arc.w.z.abs() * lean <= UPRIGHT;
    match VerticalArc::new(arc).filter(|_| upright) {
        Some(upright) => Some(TipPathKind::Upright(upright, pieces)),
        None => Some(TipPathKind::Pieces(pieces)),
    }
}

/// `None` for a spiral that is a straight line.
fn of_spiral(spiral: &Spiral) -> Option<TipPathKind> {
    if spiral.sweep == 0.0 {
        return None;
    }
    if spiral.radius_start == spiral.radius_end {
        let Spiral { center, u, w, radius_start: radius, sweep, rise, start, end, .. } = *spiral;
        return of_arc(&Arc { center, u, w, radius, sweep, rise, start, end });
    }
    Some(TipPathKind::Pieces(NumericCurve::of_spiral(spiral)))
}
