//! Cuts on a surface that turns with a rotary axis: how close they come to the axis, and how fast it has to turn.

use chordal_command::{Position, RotarySurface, SurfaceShape};
use chordal_geometry::{Curve, ParamCurve, Vec3};
use chordal_machine::AXES;

use crate::surface::SurfacePart;

/// The number of intervals into which a curve is divided for the first samples.
const PLACES: u32 = 64;

/// A piece that turns the axis by more than this is divided, rad.
const MAX_PIECE_TURN_RAD: f64 = 0.05;

/// A cut that comes closer to the pole than this goes through it, mm: the rotary axis turns while the other axes wait.
const POLE_MM: f64 = 1e-6;

/// The fraction at which a piece is divided: not the middle, which would be the pole for a symmetrical cut through it. A
/// piece with the pole inside turns the axis by half a turn; a piece that ends in the pole would not.
const DIVIDED_AT: f64 = 0.487;

/// The smallest number of pieces of an arc, which may turn the axis forward and back again.
const FIRST_PIECES: u32 = 32;

/// The largest number of times a piece is divided again.
const MAX_HALVINGS: u32 = 24;

fn at(point: Vec3) -> Position {
    let mut place = [0.0; AXES];
    place[..3].copy_from_slice(&point.to_array());
    place
}

/// The points of a curve that are nearest to the rotary axis and farthest from it, mm.
pub(crate) fn nearest_and_farthest(surface: &RotarySurface, curve: &Curve) -> [Vec3; 2] {
    let length = curve.length();
    let radius = |s: f64| surface.radius_at(curve.point_at(s).to_array());
    [1.0, -1.0].map(|sign| {
        let value = |s: f64| sign * radius(s);
        let step = length / f64::from(PLACES);
        let best = (0..=PLACES)
            .map(|place| f64::from(place) * step)
            .min_by(|a, b| value(*a).total_cmp(&value(*b)))
            .unwrap_or(0.0);
        let (mut low, mut high) = ((best - step).max(0.0), (best + step).min(length));
        for _ in 0..60 {
            let (first, second) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
            if value(first) <= value(second) {
                high = second;
            } else {
                low = first;
            }
        }
        // If an end is the best point, it is returned exactly.
        let middle = (low + high) / 2.0;
        let best = [middle, 0.0, length].into_iter().min_by(|a, b| value(*a).total_cmp(&value(*b)));
        curve.point_at(best.unwrap_or(middle))
    })
}

/// The largest speed of the rotary axis, rad/s, for a speed along a curve, mm/s, and the radius at that point, mm.
pub(crate) fn fastest_turn(surface: &RotarySurface, curve: &Curve, speed: f64) -> (f64, f64) {
    let length = curve.length();
    let mut fastest = (0.0, f64::INFINITY);
    let mut look = |s: f64| {
        let (point, path) = (curve.point_at(s).to_array(), curve.tangent_at(s).to_array());
        let radius = surface.radius_at(point);
        let across = match surface.shape {
            SurfaceShape::Face { along, .. } => {
                let arm = point[along] * path[surface.across] - point[surface.across] * path[along];
                if arm.abs() > POLE_MM { arm / radius } else { 0.0 }
            }
            SurfaceShape::Cylinder { .. } => path[surface.across],
        };
        let turn = (speed * across / radius).abs();
        if turn > fastest.0 {
            fastest = (turn, radius);
        }
    };
    for place in 0..=PLACES {
        look(length * f64::from(place) / f64::from(PLACES));
    }
    let [nearest, _] = nearest_and_farthest(surface, curve);
    let radius = surface.radius_at(nearest.to_array());
    // At its nearest point a line or an arc is perpendicular to the radius: the whole speed turns the axis.
    if let (SurfaceShape::Face { .. }, true) = (surface.shape, radius < fastest.1) {
        let ends = [curve.start(), curve.end()].map(|end| surface.radius_at(end.to_array()));
        if radius < ends[0].min(ends[1]) * (1.0 - 1e-9) && radius > POLE_MM {
            fastest = (speed / radius, radius);
        }
    }
    fastest
}

/// The limits of a rotary axis.
#[derive(Clone, Copy, Debug)]
pub struct RotaryLimits {
    /// The largest speed, rad/s.
    pub velocity: f64,
    /// The largest acceleration, rad/s².
    pub acceleration: f64,
}

/// Divides a cut on a surface into pieces that are as slow as the rotary axis needs; `None` if the axis can follow the
/// feed. `seconds` is the time of the cut at the feed. The axis may already turn at the start and still at the end.
pub fn rotary_parts(
    surface: &RotarySurface,
    curve: &Curve,
    seconds: f64,
    limits: RotaryLimits,
) -> Option<Vec<SurfacePart>> {
    let length = curve.length();
    let is_number =
        length > 0.0 && seconds > 0.0 && limits.velocity > 0.0 && limits.acceleration > 0.0;
    if !is_number {
        return None;
    }
    let cut = SurfaceCut { surface, curve };
    let mut pieces = Vec::new();
    let first = if matches!(curve, Curve::Line(_)) { 1 } else { FIRST_PIECES };
    for piece in 0..first {
        let at = |piece: u32| length * f64::from(piece) / f64::from(first);
        cut.divide([at(piece), at(piece + 1)], 0, &mut pieces);
    }
    let speed = length / seconds;
    for piece in &mut pieces {
        piece.seconds = piece.at_feed(speed, limits);
    }
    // Limits the change of speed from piece to piece by the acceleration of the axis, forward and then backward in time.
    for at in 1..pieces.len() {
        let before = pieces[at - 1];
        pieces[at].follow(&before, limits.acceleration);
    }
    for at in (1..pieces.len()).rev() {
        let after = pieces[at];
        pieces[at - 1].follow(&after, limits.acceleration);
    }
    let is_slower = |piece: &RotaryPiece| piece.seconds > piece.length() / speed * (1.0 + 1e-9);
    let parts = pieces.iter().map(|piece| SurfacePart {
        from: piece.from,
        to: piece.to,
        seconds: piece.seconds,
    });
    pieces.iter().any(is_slower).then(|| parts.collect())
}

/// A piece of a cut on which the axis turns at a constant speed.
#[derive(Clone, Copy, Debug)]
struct RotaryPiece {
    from: f64,
    to: f64,
    /// The angle by which the axis turns on it, rad.
    turn: f64,
    /// The pole is on it: the axis turns there while the other axes wait.
    has_pole: bool,
    seconds: f64,
}

impl RotaryPiece {
    fn length(&self) -> f64 {
        self.to - self.from
    }

    /// The speed of the axis, rad/s; at the pole it starts and stops.
    fn rate(&self) -> f64 {
        if self.has_pole { 0.0 } else { self.turn / self.seconds }
    }

    /// The time of the piece, s: at the feed, or longer if the axis needs more.
    fn at_feed(&self, speed: f64, limits: RotaryLimits) -> f64 {
        let (turn, by_feed) = (self.turn.abs(), self.length() / speed);
        let RotaryLimits { velocity, acceleration } = limits;
        if !self.has_pole {
            return by_feed.max(turn / velocity);
        }
        let ramps = velocity / acceleration;
        let by_turn = if turn > velocity * ramps {
            turn / velocity + ramps
        } else {
            2.0 * (turn / acceleration).sqrt()
        };
        by_feed.max(by_turn)
    }

    /// Makes the piece slower if the axis cannot reach its speed from that of a neighbour: the speed changes between the
    /// midpoints of the two pieces.
    fn follow(&mut self, other: &RotaryPiece, acceleration: f64) {
        let (rate, from) = (self.rate(), other.rate());
        if self.has_pole || rate.abs() <= from.abs() {
            return;
        }
        let half = if other.has_pole { 0.0 } else { other.seconds / 2.0 };
        if (rate - from).abs() <= acceleration * (half + self.seconds / 2.0) {
            return;
        }
        // Solves |turn| / t - from = a (half + t / 2) for its time t; `from` is positive in the direction of the turn.
        let from = from * self.turn.signum();
        let reached = from + acceleration * half;
        let root = (reached * reached + 2.0 * acceleration * self.turn.abs()).sqrt();
        let slower = (root - reached) / acceleration;
        self.seconds = self.seconds.max(slower);
    }
}

struct SurfaceCut<'a> {
    surface: &'a RotarySurface,
    curve: &'a Curve,
}

impl SurfaceCut<'_> {
    fn divide(&self, [from, to]: [f64; 2], depth: u32, pieces: &mut Vec<RotaryPiece>) {
        let point = |s: f64| at(self.curve.point_at(s));
        let turn = self.surface.turn(&point(from), &point(to), None);
        let is_even = turn.abs() <= MAX_PIECE_TURN_RAD;
        if !is_even && depth < MAX_HALVINGS {
            let middle = from + (to - from) * DIVIDED_AT;
            self.divide([from, middle], depth + 1, pieces);
            return self.divide([middle, to], depth + 1, pieces);
        }
        let is_face = matches!(self.surface.shape, SurfaceShape::Face { .. });
        let has_pole = !is_even && is_face;
        pieces.push(RotaryPiece { from, to, turn, has_pole, seconds: 0.0 });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use chordal_geometry::Line;

    fn face() -> RotarySurface {
        let shape = SurfaceShape::Face { along: 0, zero: 0.0, turned: 0.0, negative: false };
        RotarySurface { shape, rotary: 5, across: 1, across_position: 0.0 }
    }

    fn line(from: [f64; 2], to: [f64; 2]) -> Curve {
        let point = |[x, y]: [f64; 2]| Vec3::new(x, y, 0.0);
        Curve::Line(Line { start: point(from), end: point(to) })
    }

    /// So fast, at once.
    fn limits(velocity: f64) -> RotaryLimits {
        RotaryLimits { velocity, acceleration: f64::INFINITY }
    }

    #[test]
    fn the_axis_turns_fastest_where_a_line_is_nearest() {
        // 1000 mm/min past the pole at 10 mm: 5729.6 degrees a minute.
        let curve = line([20.0, 10.0], [-20.0, 10.0]);
        let (turn, radius) = fastest_turn(&face(), &curve, 1000.0 / 60.0);
        assert!((turn.to_degrees() * 60.0 - 5_729.577_951_308_232).abs() < 1e-6, "{turn}");
        assert!((radius - 10.0).abs() < 1e-9);
        let [near, far] = nearest_and_farthest(&face(), &curve);
        assert!((near - Vec3::new(0.0, 10.0, 0.0)).length() < 1e-6, "{near:?}");
        assert!((face().radius_at(far.to_array()) - 500.0_f64.sqrt()).abs() < 1e-9);
    }

    #[test]
    fn a_slow_axis_makes_the_cut_as_long_as_its_turn() {
        // 10 mm/s past the pole at 0.1 um. The axis turns faster than 30 degrees a second within 0.0437 mm of the pole,
        // and there by 3.137 rad: 5.991 s, and 3.991 s for the rest.
        let curve = line([20.0, 1e-4], [-20.0, 1e-4]);
        let most = 30.0_f64.to_radians();
        let parts = rotary_parts(&face(), &curve, 4.0, limits(most)).expect("too fast");
        let total: f64 = parts.iter().map(|part| part.seconds).sum();
        assert!((total - 9.982).abs() < 0.02, "{total}");
        assert_eq!(parts.last().expect("one").to, 40.0);
        assert!(rotary_parts(&face(), &line([20.0, 0.0], [5.0, 0.0]), 1.0, limits(most)).is_none());
        // Through the pole itself: half a turn at rest, six seconds more.
        let through = line([20.0, 0.0], [-20.0, 0.0]);
        let parts = rotary_parts(&face(), &through, 4.0, limits(most)).expect("through the pole");
        let total: f64 = parts.iter().map(|part| part.seconds).sum();
        assert!((total - 10.0).abs() < 0.02, "{total}");
        assert_eq!(fastest_turn(&face(), &through, 10.0).0, 0.0);
    }

    #[test]
    fn a_circle_next_to_the_pole_is_as_slow_as_its_fastest_turn() {
        // At 5 mm from the pole a feed of 60 mm/s turns the axis at 12 rad/s.
        let frame = chordal_geometry::Frame {
            origin: Vec3::new(15.0, 0.0, 0.0),
            ..chordal_geometry::Frame::IDENTITY
        };
        let circle =
            Curve::Arc(chordal_geometry::Arc::new(frame, 10.0, std::f64::consts::TAU, 0.0));
        let seconds = circle.length() / 60.0;
        assert!(rotary_parts(&face(), &circle, seconds, limits(12.1)).is_none());
        let parts = rotary_parts(&face(), &circle, seconds, limits(6.0)).expect("too fast");
        let total: f64 = parts.iter().map(|part| part.seconds).sum();
        assert!(total > seconds * 1.05 && total < seconds * 2.0, "{total} {seconds}");
    }

    /// The quickest way past the pole by dense steps: w = v c(s) and dw/dt within the acceleration, forward and backward.
    fn dense(distance: f64, half: f64, feed: f64, limits: RotaryLimits) -> f64 {
        let count = 200_000;
        let step = 2.0 * half / f64::from(count);
        let per_mm = |s: f64| distance / (s * s + distance * distance);
        let place = |index: i32| -half + step * (f64::from(index) + 0.5);
        let mut rates: Vec<f64> =
            (0..count).map(|index| (feed * per_mm(place(index))).min(limits.velocity)).collect();
        let climb = |rates: &mut Vec<f64>, index: usize, before: usize| {
            // w dw = a dtheta.
            let turn = step * per_mm(place(index as i32));
            let most = (rates[before] * rates[before] + 2.0 * limits.acceleration * turn).sqrt();
            rates[index] = rates[index].min(most);
        };
        for index in 1..rates.len() {
            climb(&mut rates, index, index - 1);
        }
        for index in (0..rates.len() - 1).rev() {
            climb(&mut rates, index, index + 1);
        }
        (0..count).map(|index| step * per_mm(place(index)) / rates[index as usize]).sum()
    }

    #[test]
    fn the_axis_needs_time_to_come_to_its_speed() {
        for (distance, feed, velocity, acceleration) in [
            (0.5, 20.0, 30.0, 70.0),
            (0.5, 20.0, 1e9, 70.0),
            (2.0, 60.0, 31.4, 70.0),
            (0.05, 10.0, 20.0, 40.0),
            (5.0, 150.0, 31.4, 30.0),
        ] {
            let limits = RotaryLimits { velocity, acceleration };
            let curve = line([20.0, distance], [-20.0, distance]);
            let parts = rotary_parts(&face(), &curve, 40.0 / feed, limits).expect("too fast");
            let total: f64 = parts.iter().map(|part| part.seconds).sum();
            let meant = dense(distance, 20.0, feed, limits);
            assert!((total / meant - 1.0).abs() < 0.02, "{total} {meant}");
            // Its rate changes within the limit, from the middle of a piece to that of the next.
            let turn = |part: &SurfacePart| {
                let point = |s: f64| at(curve.point_at(s));
                face().turn(&point(part.from), &point(part.to), None)
            };
            for pair in parts.windows(2) {
                let rates = [0, 1].map(|index| turn(&pair[index]) / pair[index].seconds);
                let seconds = (pair[0].seconds + pair[1].seconds) / 2.0;
                let change = (rates[1] - rates[0]).abs() / seconds;
                assert!(change <= acceleration * (1.0 + 1e-6), "{change}");
            }
        }
        // Slow enough it keeps up: 0.65 v²/d² is the most that its rate changes.
        let slow = RotaryLimits { velocity: 1e9, acceleration: 0.66 * 100.0 };
        assert!(rotary_parts(&face(), &line([20.0, 1.0], [-20.0, 1.0]), 4.0, slow).is_none());
        // Through the pole: half a turn from rest to rest.
        let limits = RotaryLimits { velocity: 1e9, acceleration: 10.0 };
        let parts = rotary_parts(&face(), &line([20.0, 0.0], [-20.0, 0.0]), 4.0, limits);
        let total: f64 = parts.expect("through the pole").iter().map(|part| part.seconds).sum();
        let meant = 4.0 + 2.0 * (std::f64::consts::PI / 10.0).sqrt();
        assert!((total - meant).abs() < 0.01, "{total} {meant}");
    }
}
