//! The lowest point of any cutter over a column along any curve, between two proved bounds.
//!
//! A part of the curve stays within a known distance of its chord. So the cutter, pushed outwards by the horizontal
//! part of that distance and lowered by its vertical part, sweeps along the chord at least what it sweeps along the
//! curve: the closed form of the line gives a lower bound. The curve itself, evaluated at the parameter of the lowest
//! point on the chord, gives an upper bound. The part with the lowest bound is divided until the bounds are close
//! enough (branch and bound).

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use chordal_geometry::{Arc, Spiral, SplinePiece, Vec3};
use libm::sincos;

use super::profile::{LowestOffer, PushedProfile};
use super::straight::StraightPath;

/// A part of a curve within this distance of its chord is replaced by the chord, mm: the error is like a column
/// shifted by as much.
const STRAIGHT_MM: f64 = 1e-13;
/// Least length of a part in the parameter: what is left of its curvature is rounding.
const MIN_PARAMETER_SHARE: f64 = 1.0 / (1_u64 << 40) as f64;
/// How much nearer a column may be than the window says, mm.
pub(super) const WIDE: f64 = 5e-10;
/// Most parts. The bounds may then still be apart: along a curve that follows the rim of the cutter, or stays at one
/// height over the column, all parts are equally low.
const MAX_PARTS: usize = 1 << 18;

/// A curve that has no closed form; its parameter runs from 0 to 1.
#[derive(Clone, Copy, Debug)]
#[allow(clippy::large_enum_variant, reason = "one for each move")]
pub(super) enum NumericCurve {
    Winding(NumericWinding),
    Spline(SplinePiece),
}

/// A turn about any axis with a linear change of radius and height.
#[derive(Clone, Copy, Debug)]
pub(super) struct NumericWinding {
    center: Vec3,
    u: Vec3,
    v: Vec3,
    w: Vec3,
    radius: f64,
    /// Change of the radius, mm.
    growth: f64,
    /// Radians.
    sweep: f64,
    /// Change of height along the axis, mm.
    rise: f64,
}

/// The chord of a part, and the largest distance of the part from it, mm.
#[derive(Clone, Copy, Debug)]
struct PartChord {
    start: Vec3,
    end: Vec3,
    /// Distance in plan.
    aside: f64,
    /// Distance along Z.
    above: f64,
}

impl PartChord {
    /// Whether the part between two parameters equals its chord, up to rounding.
    fn is_all(&self, from: f64, to: f64) -> bool {
        self.aside.max(self.above) <= STRAIGHT_MM || to - from <= MIN_PARAMETER_SHARE
    }
}

impl NumericWinding {
    fn point(&self, t: f64) -> Vec3 {
        let (sine, cosine) = sincos(self.sweep * t);
        let out = self.u * cosine + self.v * sine;
        self.center + out * (self.radius + self.growth * t) + self.w * (self.rise * t)
    }

    /// At equal parameters a chord is within |c″|·Δ²/8 of the curve, with c″ = −r·e + 2·r′·e′ per radian.
    fn chord(&self, from: f64, to: f64) -> PartChord {
        let turn = self.sweep * (to - from);
        let largest = (self.radius + self.growth * from).max(self.radius + self.growth * to);
        let spread = 2.0 * self.growth / self.sweep;
        let bend = (largest * largest + spread * spread).sqrt() * turn * turn / 8.0;
        let upright = (1.0 - self.w.z * self.w.z).max(0.0).sqrt();
        PartChord {
            start: self.point(from),
            end: self.point(to),
            aside: bend,
            above: bend * upright,
        }
    }
}

fn spline_chord(spline: &SplinePiece, from: f64, to: f64) -> PartChord {
    let mut points = [([0.0; 3], 0.0); SplinePiece::MAX_ORDER];
    let order = spline.order();
    let origin = spline.points()[0];
    for ((own, point), weight) in points.iter_mut().zip(spline.points()).zip(spline.weights()) {
        *own = (((*point - origin) * *weight).to_array(), *weight);
    }
    let points = &mut points[..order];
    // The part before `to`, and of that the part after `from`.
    halve(points, to, true);
    halve(points, from / to.max(f64::MIN_POSITIVE), false);
    // Relative to the start of the curve, so that a small curve far from zero loses no digits.
    let place = |&([x, y, z], weight): &([f64; 3], f64)| Vec3::new(x, y, z) / weight;
    let (start, end) = (place(&points[0]), place(&points[order - 1]));
    // The curve is a weighted mean of its control points, so it is no farther from the chord than the farthest of
    // them.
    let along = end - start;
    let square = along.length_squared();
    let (mut aside, mut above) = (0.0_f64, 0.0_f64);
    for point in &points[1..order - 1] {
        let off = place(point) - start;
        let share = if square > 0.0 { (off.dot(along) / square).clamp(0.0, 1.0) } else { 0.0 };
        let off = off - along * share;
        aside = aside.max((off.x * off.x + off.y * off.y).sqrt());
        above = above.max(off.z.abs());
    }
    PartChord { start: start + origin, end: end + origin, aside, above }
}

/// The control points of the part before or after a parameter, by de Casteljau's algorithm.
fn halve(points: &mut [([f64; 3], f64)], t: f64, before: bool) {
    let mean = |a: f64, b: f64| a * (1.0 - t) + b * t;
    let count = points.len();
    for step in 1..count {
        let mut set = |at: usize, (a, b): (usize, usize)| {
            let (one, other) = (points[a], points[b]);
            let place = std::array::from_fn(|axis| mean(one.0[axis], other.0[axis]));
            points[at] = (place, mean(one.1, other.1));
        };
        if before {
            (step..count).rev().for_each(|at| set(at, (at - 1, at)));
        } else {
            (0..count - step).for_each(|at| set(at, (at, at + 1)));
        }
    }
}

/// A part of the curve that may hold the lowest point.
#[derive(Clone, Copy, Debug)]
struct ParameterPart {
    least: f64,
    from: f64,
    to: f64,
}

impl Ord for ParameterPart {
    /// The part with the lowest bound is the greatest, so that the heap returns it first; among equal ones the first
    /// on the curve.
    fn cmp(&self, other: &ParameterPart) -> Ordering {
        other.least.total_cmp(&self.least).then(other.from.total_cmp(&self.from))
    }
}

impl PartialOrd for ParameterPart {
    fn partial_cmp(&self, other: &ParameterPart) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for ParameterPart {
    fn eq(&self, other: &ParameterPart) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for ParameterPart {}

impl NumericCurve {
    pub(super) fn of_arc(arc: &Arc) -> NumericCurve {
        let (radius, sweep, rise) = (arc.radius, arc.sweep, arc.rise);
        let v = arc.w.cross(arc.u);
        let (center, u, w) = (arc.center, arc.u, arc.w);
        NumericCurve::Winding(NumericWinding { center, u, v, w, radius, growth: 0.0, sweep, rise })
    }

    pub(super) fn of_spiral(spiral: &Spiral) -> NumericCurve {
        let (radius, sweep, rise) = (spiral.radius_start, spiral.sweep, spiral.rise);
        let v = spiral.w.cross(spiral.u);
        let growth = spiral.radius_end - spiral.radius_start;
        let (center, u, w) = (spiral.center, spiral.u, spiral.w);
        NumericCurve::Winding(NumericWinding { center, u, v, w, radius, growth, sweep, rise })
    }

    /// The largest coordinate or dimension of the curve, mm.
    pub(super) fn size(&self) -> f64 {
        let largest =
            |p: &Vec3| p.to_array().into_iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        match self {
            NumericCurve::Winding(winding) => {
                largest(&winding.center)
                    + winding.radius
                    + winding.growth.abs()
                    + winding.rise.abs()
            }
            NumericCurve::Spline(spline) => spline.points().iter().map(largest).fold(0.0, f64::max),
        }
    }

    pub(super) fn point(&self, t: f64) -> Vec3 {
        match self {
            NumericCurve::Winding(winding) => winding.point(t),
            NumericCurve::Spline(spline) => spline.jet_at_parameter(t)[0],
        }
    }

    fn chord(&self, from: f64, to: f64) -> PartChord {
        match self {
            NumericCurve::Winding(winding) => winding.chord(from, to),
            NumericCurve::Spline(spline) => spline_chord(spline, from, to),
        }
    }

    /// The lowest point over a column within a range of the parameter: a lower bound, and the lowest point found, at
    /// most `gap` mm above it (more only after [`MAX_PARTS`]; infinite where nothing was found until then). `None`
    /// where the cutter is nowhere over the column.
    pub(super) fn lowest(
        &self,
        profile: PushedProfile,
        place: [f64; 2],
        [from, to]: [f64; 2],
        gap: f64,
    ) -> Option<(f64, LowestOffer)> {
        let mut low = LowestOffer::NONE;
        let mut open = BinaryHeap::new();
        open.push(ParameterPart { least: f64::NEG_INFINITY, from, to });
        let mut count = 0;
        let mut least = f64::INFINITY;
        while let Some(part) = open.pop() {
            if part.least >= low.height - gap || count >= MAX_PARTS {
                least = part.least;
                break;
            }
            let middle = 0.5 * (part.from + part.to);
            for [from, to] in [[part.from, middle], [middle, part.to]] {
                count += 1;
                if let Some(least) = self.part(profile, place, [from, to], &mut low) {
                    let least = least.max(part.least);
                    if least < low.height {
                        open.push(ParameterPart { least, from, to });
                    }
                }
            }
        }
        let least = least.min(low.height);
        (least < f64::INFINITY).then_some((least, low))
    }

    /// Examines a part: offers the points it finds, and returns a lower bound of what else may be there.
    fn part(
        &self,
        profile: PushedProfile,
        place: [f64; 2],
        [from, to]: [f64; 2],
        low: &mut LowestOffer,
    ) -> Option<f64> {
        let chord = self.chord(from, to);
        let line = StraightPath::new(chord.start, chord.end);
        if chord.is_all(from, to) {
            let found = line.lowest(profile, place)?;
            low.offer(found.height, from + (to - from) * found.at);
            return None;
        }
        let found = line.lowest(profile.pushed(chord.aside), place)?;
        let mut offer = |point: Vec3, t: f64| {
            let (x, y) = (point.x - place[0], point.y - place[1]);
            low.offer(point.z + profile.height_at((x * x + y * y).sqrt()), t);
        };
        offer(chord.start, from);
        offer(chord.end, to);
        if 0.0 < found.at && found.at < 1.0 {
            let t = from + (to - from) * found.at;
            offer(self.point(t), t);
        }
        Some(found.height - chord.above)
    }

    /// Emits the ranges of the parameter in which the axis is within a radius of the column, in order; they may be
    /// too wide by [`WIDE`]. A part that cannot be decided (after [`MAX_PARTS`], along the rim) counts as within only
    /// where `is_outer`.
    pub(super) fn windows(
        &self,
        place: [f64; 2],
        radius: f64,
        is_outer: bool,
        push: &mut dyn FnMut([f64; 2]),
    ) {
        let mut open = vec![[0.0, 1.0]];
        let mut last: Option<[f64; 2]> = None;
        let mut count = 0;
        while let Some([from, to]) = open.pop() {
            count += 1;
            let chord = self.chord(from, to);
            let line = StraightPath::new(chord.start, chord.end);
            let Some(range) = line.window(place, radius + chord.aside) else { continue };
            let beyond = |end: Vec3| {
                let (x, y) = (end.x - place[0], end.y - place[1]);
                (x * x + y * y).sqrt() + chord.aside > radius
            };
            let is_inside = !beyond(chord.start) && !beyond(chord.end);
            let is_narrow = chord.aside <= WIDE || to - from <= MIN_PARAMETER_SHARE;
            let is_enough = count >= MAX_PARTS;
            if !(is_inside || is_narrow || is_enough) {
                let middle = 0.5 * (from + to);
                open.push([middle, to]);
                open.push([from, middle]);
                continue;
            }
            if !(is_inside || is_narrow || is_outer) {
                continue;
            }
            // Exact at the end of a chord that is entirely within, so that adjoining parts meet.
            let at = |t: f64| if t >= 1.0 { to } else { from + (to - from) * t };
            let range = range.map(at);
            match &mut last {
                Some(last) if last[1] >= range[0] => last[1] = range[1],
                _ => {
                    if let Some(done) = last.replace(range) {
                        push(done);
                    }
                }
            }
        }
        if let Some(done) = last {
            push(done);
        }
    }
}
