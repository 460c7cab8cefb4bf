//! The geometry of a corner between two moves of a plane: a tangent arc, or a straight line that
//! cuts the corner off.

use std::f64::consts::TAU;

type CornerPoint = [f64; 2];

/// A length may exceed its move by this much through rounding, mm.
const ROUNDING_MM: f64 = 1e-6;

/// A smaller angle comes from rounding, rad.
const ROUNDING_RAD: f64 = 1e-9;

/// A move in its plane, mm; an arc has its centre and directed angle (rad).
#[derive(Clone, Copy, Debug)]
pub struct CornerLeg {
    pub from: CornerPoint,
    pub to: CornerPoint,
    pub arc: Option<(CornerPoint, f64)>,
}

/// The piece that replaces the corner, and how much of the moves it removes.
#[derive(Clone, Copy, Debug)]
pub struct CornerFit {
    pub start: CornerPoint,
    pub end: CornerPoint,
    /// Centre and directed angle (rad) of a rounding; `None` for a line.
    pub arc: Option<(CornerPoint, f64)>,
    /// What the first and the second move lose: a length (mm) of a line, an angle (rad) of an arc.
    pub lost: [f64; 2],
}

/// Why no rounding or chamfer fits.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum CornerMisfit {
    /// The second move goes back over the first.
    Reversal,
    /// It is too large; the largest that fits, mm.
    TooLarge(f64),
}

fn minus(a: CornerPoint, b: CornerPoint) -> CornerPoint {
    [a[0] - b[0], a[1] - b[1]]
}

/// The point at a distance from another in a direction.
fn along(a: CornerPoint, direction: CornerPoint, length: f64) -> CornerPoint {
    [a[0] + direction[0] * length, a[1] + direction[1] * length]
}

fn dot(a: CornerPoint, b: CornerPoint) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: CornerPoint, b: CornerPoint) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn norm(a: CornerPoint) -> f64 {
    libm::hypot(a[0], a[1])
}

fn left_of(direction: CornerPoint) -> CornerPoint {
    [-direction[1], direction[0]]
}

/// The angle from one direction to another in a sense (1 counterclockwise, −1 clockwise), in [0, 2π).
fn turn(from: CornerPoint, to: CornerPoint, sense: f64) -> f64 {
    let angle = sense * libm::atan2(cross(from, to), dot(from, to));
    let angle = if angle < 0.0 { angle + TAU } else { angle };
    if angle > TAU - ROUNDING_RAD { 0.0 } else { angle }
}

/// How far the ends of a chamfer of a length are from the corner, mm: half the length over the cosine of half the
/// change of direction.
pub fn leg_of_chamfer(one: &CornerLeg, two: &CornerLeg, length: f64) -> f64 {
    let [from, to] = [one.direction_at(one.to), two.direction_at(two.from)];
    let change = libm::atan2(cross(from, to), dot(from, to));
    length / (2.0 * libm::cos(change / 2.0))
}

impl CornerLeg {
    /// Its length, mm.
    pub fn length(&self) -> f64 {
        match self.arc {
            None => norm(minus(self.to, self.from)),
            Some((center, sweep)) => norm(minus(self.to, center)) * sweep.abs(),
        }
    }

    /// Its unit tangent at one of its points.
    fn direction_at(&self, place: CornerPoint) -> CornerPoint {
        match self.arc {
            None => {
                let path = minus(self.to, self.from);
                let length = norm(path);
                [path[0] / length, path[1] / length]
            }
            Some((center, sweep)) => {
                let spoke = minus(place, center);
                let radius = norm(spoke) * sweep.signum();
                let left = left_of(spoke);
                [left[0] / radius, left[1] / radius]
            }
        }
    }

    /// Its parallel at a distance to the left; `None` when an arc has no radius left. `place` is one of its points.
    fn parallel_at(&self, place: CornerPoint, distance: f64) -> Option<OffsetShape> {
        match self.arc {
            None => {
                let direction = self.direction_at(place);
                let start = along(place, left_of(direction), distance);
                Some(OffsetShape::Line { start, direction })
            }
            Some((center, sweep)) => {
                let radius = norm(minus(place, center)) - sweep.signum() * distance;
                (radius > 0.0).then_some(OffsetShape::Circle { center, radius })
            }
        }
    }

    /// Where a circle about `center` touches the move, and how far that is from the corner: before it
    /// on the first move, after it on the second.
    fn touch(
        &self,
        center: CornerPoint,
        distance: f64,
        corner: CornerPoint,
        is_first: bool,
    ) -> TouchPoint {
        let sign = if is_first { -1.0 } else { 1.0 };
        match self.arc {
            None => {
                let direction = self.direction_at(corner);
                let place = along(center, left_of(direction), -distance);
                let lost = sign * dot(minus(place, corner), direction);
                TouchPoint { place, lost, length: lost }
            }
            Some((middle, sweep)) => {
                let radius = norm(minus(corner, middle));
                let spoke = minus(center, middle);
                let place = along(middle, spoke, radius / norm(spoke));
                let from = minus(corner, middle);
                let lost = turn(from, spoke, sign * sweep.signum());
                TouchPoint { place, lost, length: lost * radius }
            }
        }
    }
}

#[derive(Clone, Copy)]
struct TouchPoint {
    place: CornerPoint,
    lost: f64,
    length: f64,
}

#[derive(Clone, Copy)]
enum OffsetShape {
    Line { start: CornerPoint, direction: CornerPoint },
    Circle { center: CornerPoint, radius: f64 },
}

/// The intersections of two parallels.
fn meetings(first: OffsetShape, second: OffsetShape) -> [Option<CornerPoint>; 2] {
    match (first, second) {
        (
            OffsetShape::Line { start, direction },
            OffsetShape::Line { start: other, direction: other_direction },
        ) => {
            let across = cross(direction, other_direction);
            let length = cross(minus(other, start), other_direction) / across;
            [length.is_finite().then(|| along(start, direction, length)), None]
        }
        (OffsetShape::Line { start, direction }, OffsetShape::Circle { center, radius })
        | (OffsetShape::Circle { center, radius }, OffsetShape::Line { start, direction }) => {
            let middle = dot(minus(center, start), direction);
            let foot = along(start, direction, middle);
            let half = radius * radius - dot(minus(foot, center), minus(foot, center));
            if half < 0.0 {
                return [None; 2];
            }
            let half = half.sqrt();
            [Some(along(foot, direction, half)), Some(along(foot, direction, -half))]
        }
        (
            OffsetShape::Circle { center, radius },
            OffsetShape::Circle { center: other, radius: other_radius },
        ) => {
            let path = minus(other, center);
            let separate = norm(path);
            if separate == 0.0 {
                return [None; 2];
            }
            let direction = [path[0] / separate, path[1] / separate];
            let to_chord = (separate * separate + radius * radius - other_radius * other_radius)
                / (2.0 * separate);
            let half = radius * radius - to_chord * to_chord;
            if half < 0.0 {
                return [None; 2];
            }
            let foot = along(center, direction, to_chord);
            let half = half.sqrt();
            let left = left_of(direction);
            [Some(along(foot, left, half)), Some(along(foot, left, -half))]
        }
    }
}

/// The directed angle between two moves, rad.
fn angle_between(first: &CornerLeg, second: &CornerLeg) -> f64 {
    let (into, out) = (first.direction_at(first.to), second.direction_at(second.from));
    libm::atan2(cross(into, out), dot(into, out))
}

/// The angle of a corner, rad; `None` when it is at most `straight`, so that there is no corner.
fn corner_angle(
    first: &CornerLeg,
    second: &CornerLeg,
    straight: f64,
) -> Result<Option<f64>, CornerMisfit> {
    let angle = angle_between(first, second);
    if angle.abs() > TAU / 2.0 - ROUNDING_RAD {
        return Err(CornerMisfit::Reversal);
    }
    Ok((angle.abs() > straight.max(ROUNDING_RAD)).then_some(angle))
}

/// The arc of a radius that touches both moves; `None` when there is no corner.
pub fn rounding(
    first: &CornerLeg,
    second: &CornerLeg,
    radius: f64,
    straight: f64,
) -> Result<Option<CornerFit>, CornerMisfit> {
    let Some(angle) = corner_angle(first, second, straight)? else { return Ok(None) };
    if let Some(fit) = tangent_arc(first, second, radius, angle.signum()) {
        return Ok(Some(fit));
    }
    // Bisection for the largest radius that fits; 60 halvings exhaust the precision of a double.
    let (mut fits, mut large) = (0.0, radius);
    for _ in 0..60 {
        let middle = 0.5 * (fits + large);
        match tangent_arc(first, second, middle, angle.signum()) {
            Some(_) => fits = middle,
            None => large = middle,
        }
    }
    Err(CornerMisfit::TooLarge(fits))
}

fn tangent_arc(
    first: &CornerLeg,
    second: &CornerLeg,
    radius: f64,
    sense: f64,
) -> Option<CornerFit> {
    let distance = sense * radius;
    let (into, out) =
        (first.parallel_at(first.to, distance)?, second.parallel_at(second.from, distance)?);
    let mut best: Option<(f64, CornerFit)> = None;
    for center in meetings(into, out).into_iter().flatten() {
        let mut begin = first.touch(center, distance, first.to, true);
        let mut end = second.touch(center, distance, second.from, false);
        let mut fits = true;
        for (touch, leg, far) in [(&mut begin, first, first.from), (&mut end, second, second.to)] {
            let length = leg.length();
            fits &= touch.length > 0.0 && touch.length <= length + ROUNDING_MM;
            if touch.length > length - ROUNDING_MM {
                touch.place = far;
            }
        }
        let lost = begin.length + end.length;
        if fits && best.is_none_or(|(least, _)| lost < least) {
            let sweep = turn(minus(begin.place, center), minus(end.place, center), sense);
            let fit = CornerFit {
                start: begin.place,
                end: end.place,
                arc: Some((center, sense * sweep)),
                lost: [begin.lost, end.lost],
            };
            best = Some((lost, fit));
        }
    }
    best.map(|(_, fit)| fit)
}

/// The line that cuts off the same length of both moves; `None` when there is no corner.
pub fn chamfer(
    first: &CornerLeg,
    second: &CornerLeg,
    length: f64,
    straight: f64,
) -> Result<Option<CornerFit>, CornerMisfit> {
    if corner_angle(first, second, straight)?.is_none() {
        return Ok(None);
    }
    let room = [first.length(), second.length()];
    if length > room[0].min(room[1]) + ROUNDING_MM {
        return Err(CornerMisfit::TooLarge(room[0].min(room[1])));
    }
    let place = |leg: &CornerLeg, corner: CornerPoint, far: CornerPoint, sign: f64, room: f64| {
        if length > room - ROUNDING_MM {
            return far;
        }
        along(corner, leg.direction_at(corner), sign * length)
    };
    let start = place(first, first.to, first.from, -1.0, room[0]);
    let end = place(second, second.from, second.to, 1.0, room[1]);
    Ok(Some(CornerFit { start, end, arc: None, lost: [length; 2] }))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2};

    use super::*;

    fn line(from: CornerPoint, to: CornerPoint) -> CornerLeg {
        CornerLeg { from, to, arc: None }
    }

    fn near(a: CornerPoint, b: CornerPoint) {
        assert!(norm(minus(a, b)) < 1e-9, "{a:?} {b:?}");
    }

    #[test]
    fn a_square_corner() {
        let legs = [line([0.0, 0.0], [10.0, 0.0]), line([10.0, 0.0], [10.0, 20.0])];
        let fit = rounding(&legs[0], &legs[1], 2.0, 0.0).unwrap().unwrap();
        near(fit.start, [8.0, 0.0]);
        near(fit.end, [10.0, 2.0]);
        let (center, sweep) = fit.arc.unwrap();
        near(center, [8.0, 2.0]);
        assert!((sweep - FRAC_PI_2).abs() < 1e-12);
        let Err(CornerMisfit::TooLarge(room)) = rounding(&legs[0], &legs[1], 11.0, 0.0) else {
            panic!()
        };
        assert!((room - 10.0).abs() < 1e-5);
        let fit = chamfer(&legs[0], &legs[1], 3.0, 0.0).unwrap().unwrap();
        near(fit.start, [7.0, 0.0]);
        near(fit.end, [10.0, 3.0]);
        assert_eq!(
            chamfer(&legs[0], &legs[1], 12.0, 0.0).unwrap_err(),
            CornerMisfit::TooLarge(10.0)
        );
    }

    #[test]
    fn back_and_straight_on() {
        let legs = [line([0.0, 0.0], [10.0, 0.0]), line([10.0, 0.0], [0.0, 0.0])];
        assert_eq!(rounding(&legs[0], &legs[1], 2.0, 0.0).unwrap_err(), CornerMisfit::Reversal);
        let on = line([10.0, 0.0], [20.0, 0.1]);
        assert!(rounding(&legs[0], &on, 2.0, 1f64.to_radians()).unwrap().is_none());
    }

    /// A line along X meets the left half of a circle of radius 5 about (10, 5) from below.
    #[test]
    fn a_line_and_an_arc() {
        let first = line([0.0, 5.0], [5.0, 5.0]);
        // Clockwise from (5, 5) over the top to (15, 5).
        let second =
            CornerLeg { from: [5.0, 5.0], to: [15.0, 5.0], arc: Some(([10.0, 5.0], -TAU / 2.0)) };
        // The rounding lies to the left of the line and outside the circle: its centre is 1 above
        // the line and 6 from (10, 5): x = 10 - √35.
        let fit = rounding(&first, &second, 1.0, 0.0).unwrap().unwrap();
        let (center, sweep) = fit.arc.unwrap();
        near(center, [10.0 - 35f64.sqrt(), 6.0]);
        near(fit.start, [10.0 - 35f64.sqrt(), 5.0]);
        near(fit.end, [10.0 - 35f64.sqrt() * 5.0 / 6.0, 5.0 + 5.0 / 6.0]);
        assert!(sweep > 0.0 && sweep < FRAC_PI_2);
    }

    /// Two quarters to the left about (25, 20) and (35, 30): the rounding is 11 from both centres.
    #[test]
    fn two_arcs() {
        let quarter = TAU / 4.0;
        let first =
            CornerLeg { from: [25.0, 10.0], to: [35.0, 20.0], arc: Some(([25.0, 20.0], quarter)) };
        let second =
            CornerLeg { from: [35.0, 20.0], to: [45.0, 30.0], arc: Some(([35.0, 30.0], quarter)) };
        let fit = rounding(&first, &second, 1.0, 0.0).unwrap().unwrap();
        let (center, sweep) = fit.arc.unwrap();
        let beside = 71f64.sqrt() * FRAC_1_SQRT_2;
        near(center, [30.0 + beside, 25.0 - beside]);
        near(fit.start, [25.0 + (5.0 + beside) / 1.1, 20.0 + (5.0 - beside) / 1.1]);
        near(fit.end, [35.0 + (beside - 5.0) / 1.1, 30.0 - (5.0 + beside) / 1.1]);
        assert!(sweep < 0.0 && fit.lost[0] > 0.0 && fit.lost[1] > 0.0);
    }
}
