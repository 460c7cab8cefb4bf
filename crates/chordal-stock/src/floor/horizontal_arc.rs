//! The lowest point of a cutter over a column along an arc or a helix about a vertical axis.
//!
//! With the radius A of the path, the distance D of the column from the axis of the path and the angle ψ from the
//! point of the path nearest to the column, the distance of the tool axis in plan is ρ² = (A − D)² + 4·A·D·y, y =
//! sin²(ψ/2). On a helix with the rise p per radian the height is p·ψ + h(ρ). Uphill from the nearest point both
//! terms rise. Downhill the least value is at an end, at the boundary of a ring or where p = h′(ρ)·dρ/dψ, which for
//! cones and balls is a quadratic equation in y. Both its roots are tried, since the slope of h(ρ(ψ)) may fall again.

use std::f64::consts::{PI, TAU};

use chordal_geometry::{Arc, Vec3};
use libm::{asin, atan2, sincos};

use super::profile::{LowestOffer, PushedProfile};
use crate::cutter::{Ring, RingElement};

/// An arc or a helix about a vertical axis; its parameter is the angle travelled, from 0 to `sweep`.
#[derive(Clone, Copy, Debug)]
pub(super) struct HorizontalArc {
    center: Vec3,
    /// Unit vector towards the start, in plan.
    u: [f64; 2],
    /// Unit vector normal to it, in the direction of travel.
    v: [f64; 2],
    radius: f64,
    /// Radians, above zero.
    sweep: f64,
    /// Rise per radian travelled, mm.
    rise: f64,
}

/// A column in polar coordinates of the path.
struct ColumnView {
    /// Distance from the axis of the path, mm.
    distance: f64,
    /// The angle travelled to the nearest point, within half a turn of the start.
    nearest: f64,
    /// |A − D|: the least distance of column and path in plan, mm.
    least: f64,
    /// 4·A·D, mm².
    four: f64,
}

impl ColumnView {
    /// sin²(ψ/2) where the tool axis is at a distance; `None` where it never is as near.
    fn half_sine2(&self, distance: f64) -> Option<f64> {
        let square = (distance - self.least) * (distance + self.least);
        if distance < self.least {
            None
        } else if square >= self.four {
            Some(1.0)
        } else {
            Some(square / self.four)
        }
    }

    fn distance_at(&self, half_sine2: f64) -> f64 {
        (self.least * self.least + self.four * half_sine2).sqrt()
    }
}

fn angle(half_sine2: f64) -> f64 {
    2.0 * asin(half_sine2.clamp(0.0, 1.0).sqrt())
}

fn half_sine2(angle: f64) -> f64 {
    let (sine, _) = sincos(0.5 * angle);
    sine * sine
}

impl HorizontalArc {
    /// The path of an arc about an axis along Z.
    pub(super) fn new(arc: &Arc) -> HorizontalArc {
        let up = if arc.w.z < 0.0 { -1.0 } else { 1.0 };
        let turn = up * arc.sweep.signum();
        let u = [arc.u.x, arc.u.y];
        let sweep = arc.sweep.abs();
        HorizontalArc {
            center: arc.center,
            u,
            v: [-turn * u[1], turn * u[0]],
            radius: arc.radius,
            sweep,
            rise: up * arc.rise / sweep,
        }
    }

    pub(super) const fn sweep(&self) -> f64 {
        self.sweep
    }

    pub(super) const fn is_level(&self) -> bool {
        self.rise == 0.0
    }

    fn height_at(&self, angle: f64) -> f64 {
        self.center.z + self.rise * angle
    }

    fn seen_from(&self, place: [f64; 2]) -> ColumnView {
        let [x, y] = [place[0] - self.center.x, place[1] - self.center.y];
        let distance = (x * x + y * y).sqrt();
        let nearest = atan2(x * self.v[0] + y * self.v[1], x * self.u[0] + y * self.u[1]);
        let least = (self.radius - distance).abs();
        ColumnView { distance, nearest, least, four: 4.0 * self.radius * distance }
    }

    /// The first and last whole turn after which a range of angles about the nearest point meets a range of the path.
    fn turns(seen: &ColumnView, reach: f64, [from, to]: [f64; 2]) -> [i64; 2] {
        let first = ((from - seen.nearest - reach) / TAU).ceil();
        let last = ((to - seen.nearest + reach) / TAU).floor();
        [first as i64, last as i64]
    }

    /// Emits the ranges of the angle in which the axis is within a radius of the column, in order.
    pub(super) fn windows(&self, place: [f64; 2], radius: f64, push: &mut dyn FnMut([f64; 2])) {
        let seen = self.seen_from(place);
        if radius >= self.radius + seen.distance {
            push([0.0, self.sweep]);
            return;
        }
        let Some(half_sine2) = seen.half_sine2(radius) else { return };
        let reach = angle(half_sine2);
        let [first, last] = HorizontalArc::turns(&seen, reach, [0.0, self.sweep]);
        for turn in first..=last {
            let middle = seen.nearest + TAU * turn as f64;
            let range = [(middle - reach).max(0.0), (middle + reach).min(self.sweep)];
            if range[0] <= range[1] {
                push(range);
            }
        }
    }

    /// Whether [`HorizontalArc::lowest`] has a closed form for a cutter: not for a torus on a helix.
    pub(super) fn is_closed_for(&self, profile: PushedProfile) -> bool {
        let bull = |ring: &Ring| matches!(ring.element, RingElement::Torus { middle, .. } if middle != 0.0);
        self.is_level() || !profile.rings().any(|ring| bull(&ring))
    }

    /// The lowest point over a column within a range of the angle.
    pub(super) fn lowest(
        &self,
        profile: PushedProfile,
        place: [f64; 2],
        [from, to]: [f64; 2],
    ) -> Option<LowestOffer> {
        let seen = self.seen_from(place);
        let mut low = LowestOffer::NONE;
        // A column on the axis is equally near to all points of the path.
        if self.is_level() || seen.four <= f64::MIN_POSITIVE {
            self.offer_level(&seen, profile, [from, to], &mut low);
            return low.found();
        }
        let [first, last] = HorizontalArc::turns(&seen, PI, [from, to]);
        // Every further turn is the same, but higher. So only the lowest turn counts and, since the range may hold
        // only a part of it, the next one.
        let turns =
            if self.rise > 0.0 { first..=last.min(first + 1) } else { first.max(last - 1)..=last };
        for turn in turns {
            let middle = seen.nearest + TAU * turn as f64;
            let range = [(from - middle).max(-PI), (to - middle).min(PI)];
            if range[0] <= range[1] {
                for ring in profile.rings() {
                    self.offer_ring(&seen, &ring, middle, range, &mut low);
                }
            }
        }
        low.found()
    }

    /// Where height or distance do not depend on ψ: the candidates are the nearest point and the ends.
    fn offer_level(
        &self,
        seen: &ColumnView,
        profile: PushedProfile,
        [from, to]: [f64; 2],
        low: &mut LowestOffer,
    ) {
        let mut offer = |angle: f64, at: f64| {
            let distance = seen.distance_at(half_sine2(angle - seen.nearest));
            low.offer(self.height_at(at) + profile.height_at(distance), at);
        };
        offer(from, from);
        offer(to, to);
        let [first, last] = HorizontalArc::turns(seen, 0.0, [from, to]);
        if first <= last {
            offer(seen.nearest, seen.nearest + TAU * first as f64);
        }
    }

    /// The lowest point of one ring in one turn; `range` is that of ψ, `middle` the angle at ψ = 0.
    fn offer_ring(
        &self,
        seen: &ColumnView,
        ring: &Ring,
        middle: f64,
        range: [f64; 2],
        low: &mut LowestOffer,
    ) {
        let Some(outer) = seen.half_sine2(ring.to) else { return };
        // The ring begins farther from the axis than the path ever is.
        if ring.from > seen.least && (ring.from * ring.from) > seen.least * seen.least + seen.four {
            return;
        }
        let inner = seen.half_sine2(ring.from).unwrap_or(0.0);
        let (inner, outer) = (angle(inner), angle(outer));
        let steep = self.rise.abs();
        // x grows downhill.
        let downhill = -self.rise.signum();
        let (begin, end) =
            if downhill > 0.0 { (range[0], range[1]) } else { (-range[1], -range[0]) };
        let mut offer = |x: f64| {
            let distance = seen.distance_at(half_sine2(x)).clamp(ring.from, ring.to);
            let at = middle + downhill * x;
            low.offer(self.height_at(at) + ring.height_at(distance), at);
        };
        // Uphill, both the path and the cutter rise with the distance.
        let (from, to) = (begin.max(-outer), end.min(-inner));
        if from <= to {
            offer(to);
        }
        let (from, to) = (begin.max(inner), end.min(outer));
        if from > to {
            return;
        }
        offer(from);
        offer(to);
        for y in stationary(ring.element, seen, steep) {
            if (0.0..=1.0).contains(&y) {
                let x = angle(y);
                if from < x && x < to {
                    offer(x);
                }
            }
        }
    }
}

/// The values of sin²(ψ/2) where the height of an element is stationary on a helix with this rise per radian.
fn stationary(element: RingElement, seen: &ColumnView, rise: f64) -> [f64; 2] {
    let product = 0.25 * seen.four;
    match element {
        RingElement::Disc { .. } => [f64::NAN; 2],
        // k²A²D²·sin²ψ = p²ρ²
        RingElement::Cone { slope, .. } => {
            let share = rise / (slope * product);
            let flat = rise / slope;
            let least = seen.least * share;
            roots(1.0 - flat * share, 0.25 * least * least)
        }
        // A²D²·sin²ψ = p²(c² − ρ²)
        RingElement::Torus { round, .. } => {
            let share = rise / product;
            let left = (round - seen.least) * (round + seen.least);
            roots(1.0 + rise * share, 0.25 * share * share * left)
        }
    }
}

/// The roots of y² − sum·y + product, without cancellation; a double root where the discriminant is negative by
/// rounding.
fn roots(sum: f64, product: f64) -> [f64; 2] {
    let large = 0.5 * (sum + (sum * sum - 4.0 * product).max(0.0).sqrt());
    [large, product / large]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_of_both_sizes() {
        let [large, small] = roots(1.0, 1e-20);
        assert_eq!(large, 1.0);
        assert!((small - 1e-20).abs() < 1e-35);
    }
}
