//! The lowest point of a cutter over a column along a straight move, in closed form.
//!
//! The tip is at `start + t·(end − start)`. The distance ρ in plan between column and axis is given by ρ² = e² + w²,
//! where e is the distance of the column from the line of the move in plan and w that along it. Each ring of the
//! cutter is over the column while w is in one of two intervals, one on either side of the column. On each of them
//! the height m·w + h(ρ) is convex (m: rise per length in plan), so its least value is at the unconstrained minimum,
//! clamped to the interval.

use chordal_geometry::Vec3;

use super::profile::{LowestOffer, PushedProfile};
use crate::cutter::{Ring, RingElement};

/// A straight move; a plunge where its length in plan is zero.
#[derive(Clone, Copy, Debug)]
pub(super) struct StraightPath {
    start: Vec3,
    end: Vec3,
    /// Length in plan, mm.
    length: f64,
    /// Unit vector of the direction in plan.
    direction: [f64; 2],
}

impl StraightPath {
    pub(super) fn new(start: Vec3, end: Vec3) -> StraightPath {
        let along = [end.x - start.x, end.y - start.y];
        let length = (along[0] * along[0] + along[1] * along[1]).sqrt();
        let direction = if length > 0.0 { along.map(|x| x / length) } else { [1.0, 0.0] };
        StraightPath { start, end, length, direction }
    }

    /// The distance along the move to the foot of a column, and that of the column from the move, mm.
    fn seen_from(&self, place: [f64; 2]) -> (f64, f64) {
        let [ux, uy] = self.direction;
        let [x, y] = [place[0] - self.start.x, place[1] - self.start.y];
        (x * ux + y * uy, (x * uy - y * ux).abs())
    }

    fn height_at(&self, t: f64) -> f64 {
        // Exact at both ends.
        self.start.z * (1.0 - t) + self.end.z * t
    }

    /// The fractions of the move between which the axis is within a radius of the column; `None` where it never is.
    pub(super) fn window(&self, place: [f64; 2], radius: f64) -> Option<[f64; 2]> {
        let (foot, aside) = self.seen_from(place);
        if self.length <= 0.0 {
            let distance = (foot * foot + aside * aside).sqrt();
            return (distance <= radius).then_some([0.0, 1.0]);
        }
        let half = chord(radius, aside)?;
        let from = ((foot - half) / self.length).max(0.0);
        let to = ((foot + half) / self.length).min(1.0);
        (from <= to).then_some([from, to])
    }

    /// The lowest point over a column, at a fraction of the move; `None` where the cutter is never over the column.
    pub(super) fn lowest(&self, profile: PushedProfile, place: [f64; 2]) -> Option<LowestOffer> {
        let (foot, aside) = self.seen_from(place);
        let mut low = LowestOffer::NONE;
        if self.length <= 0.0 {
            let height = profile.height_at((foot * foot + aside * aside).sqrt());
            low.offer(self.start.z + height, 0.0);
            low.offer(self.end.z + height, 1.0);
            return low.found();
        }
        let slope = (self.end.z - self.start.z) / self.length;
        let (first, last) = (-foot, self.length - foot);
        for ring in profile.rings() {
            let Some(outer) = chord(ring.to, aside) else { continue };
            let inner = chord(ring.from, aside).unwrap_or(0.0);
            let free = free_minimiser(&ring, aside, slope);
            let parts = if inner > 0.0 {
                [Some([-outer, -inner]), Some([inner, outer])]
            } else {
                [Some([-outer, outer]), None]
            };
            for [from, to] in parts.into_iter().flatten() {
                let (from, to) = (from.max(first), to.min(last));
                if from > to {
                    continue;
                }
                let w = free.clamp(from, to);
                let t = if w <= first {
                    0.0
                } else if w >= last {
                    1.0
                } else {
                    ((foot + w) / self.length).clamp(0.0, 1.0)
                };
                let distance = (aside * aside + w * w).sqrt().clamp(ring.from, ring.to);
                low.offer(self.height_at(t) + ring.height_at(distance), t);
            }
        }
        low.found()
    }
}

/// Half the chord that a circle about the column cuts from a line at the distance `aside`; `None` where they do not
/// meet.
pub(super) fn chord(radius: f64, aside: f64) -> Option<f64> {
    (aside <= radius).then(|| ((radius - aside) * (radius + aside)).sqrt())
}

/// Where slope·w + h(√(aside² + w²)) of an element is least, if the element were unbounded.
fn free_minimiser(ring: &Ring, aside: f64, slope: f64) -> f64 {
    if slope == 0.0 {
        return 0.0;
    }
    let downhill = -slope.signum();
    let steep = slope.abs();
    match ring.element {
        RingElement::Disc { .. } => downhill * f64::INFINITY,
        RingElement::Cone { slope: rise, .. } => {
            let square = (rise - steep) * (rise + steep);
            if rise > steep && square > 0.0 {
                downhill * (steep * aside / square.sqrt())
            } else {
                downhill * f64::INFINITY
            }
        }
        RingElement::Torus { round, middle: 0.0, .. } => {
            let q = chord(round, aside).unwrap_or(0.0);
            downhill * (steep * q / (1.0 + steep * steep).sqrt())
        }
        RingElement::Torus { round, middle, .. } => {
            downhill * offset_on_torus(round, middle, aside, steep)
        }
    }
}

/// The distance |w| from the foot of the column to the axis where a torus of minor radius c and major radius f is
/// lowest on a slope m > 0. With y = |w|/ρ the contact is at the distance ρ = f + c·m/√(m² + y²), and ρ²(1 − y²) =
/// e². The left side falls from (f + c)² to 0 for y from 0 to 1, so Newton's method with bracketing finds the root.
fn offset_on_torus(round: f64, middle: f64, aside: f64, slope: f64) -> f64 {
    // Newton's method takes three or four steps, at most eight in 20,000 cases; bisection alone reaches neighbouring
    // doubles in about 60.
    const MAX_STEPS: u32 = 100;
    // A Newton step squares the error, and an error in the place of a minimum is squared once more in the height.
    const NEWTON_TOLERANCE: f64 = 1e-10;
    let distance = |y: f64| middle + round * slope / (slope * slope + y * y).sqrt();
    let value = |y: f64| {
        let square = slope * slope + y * y;
        let far = middle + round * slope / square.sqrt();
        let left = (1.0 - y) * (1.0 + y);
        let change = -round * slope * y / (square * square.sqrt());
        (far * far * left - aside * aside, 2.0 * far * (change * left - far * y))
    };
    // Where a torus was pulled inwards past the axis, its major radius is negative: the search ends where ρ is 0.
    let reach = if middle < 0.0 {
        let share = round / middle;
        (slope * slope * (share * share - 1.0)).max(0.0).sqrt().min(1.0)
    } else {
        1.0
    };
    let (mut low, mut high) = (0.0_f64, reach);
    // Start at the contact of a ball of the whole radius.
    let share = (aside / (middle + round)).min(1.0);
    let sine2 = ((slope * slope + share * share) / (1.0 + slope * slope)).min(1.0);
    let mut y = (slope * (1.0 - sine2).sqrt() / sine2.sqrt()).clamp(low, high);
    for _ in 0..MAX_STEPS {
        let (off, change) = value(y);
        if off == 0.0 {
            break;
        }
        if off > 0.0 {
            low = y;
        } else {
            high = y;
        }
        let newton = y - off / change;
        if (newton - y).abs() <= NEWTON_TOLERANCE * y {
            y = newton.clamp(0.0, reach);
            break;
        }
        y = if low < newton && newton < high { newton } else { 0.5 * (low + high) };
    }
    distance(y) * y
}
