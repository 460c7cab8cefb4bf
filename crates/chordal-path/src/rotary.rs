//! Cuts on a surface that turns with a rotary axis: how near to the axis they come, and how fast it has to turn.

use chordal_command::{AxisMask, Move, Position, RotarySurface, SurfaceRun, SurfaceShape};
use chordal_geometry::{Curve, ParamCurve, Vec3};
use chordal_machine::AXES;

use crate::surface::SurfacePart;

/// Places at which a curve is looked at first.
const PLACES: u32 = 64;

/// A piece turns the axis by no more than this, rad, or is divided.
const EVEN_RAD: f64 = 0.05;

/// A cut that comes nearer to the pole than this goes through it: the rotary axis turns there, at rest, mm.
const POLE_MM: f64 = 1e-6;

/// Where a piece is divided: not in the middle, which is the pole itself for a cut from one side to the other. A piece with the
/// pole inside turns the axis by half a turn; one that ends there would not.
const DIVIDED_AT: f64 = 0.487;

/// So often a cut is divided at most.
const MOST_HALVINGS: u32 = 12;

fn at(point: Vec3) -> Position {
    let mut place = [0.0; AXES];
    place[..3].copy_from_slice(&point.to_array());
    place
}

/// The places of a curve that are nearest to the rotary axis and farthest from it.
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
        // An end is exact where it is the best.
        let middle = (low + high) / 2.0;
        let best = [middle, 0.0, length].into_iter().min_by(|a, b| value(*a).total_cmp(&value(*b)));
        curve.point_at(best.unwrap_or(middle))
    })
}

/// The axes themselves where a move on a surface is nearest to the rotary axis, farthest from it, and ends; and which of them are
/// known. The run of the surface has followed the move.
pub fn places_on_axes(run: &SurfaceRun, motion: &Move, curve: &Curve) -> ([Position; 3], AxisMask) {
    let surface = &run.surface;
    let end = run.on_axes(&motion.to);
    let [nearest, farthest] = nearest_and_farthest(surface, curve);
    let places = [nearest, farthest, curve.end()].map(|place| {
        let mut position = motion.to;
        position[..3].copy_from_slice(&place.to_array());
        let mut axes = run.on_axes(&position);
        axes[surface.rotary] = end[surface.rotary];
        axes
    });
    let (across, rotary) = (AxisMask(1 << surface.across), AxisMask(1 << surface.rotary));
    // The axis across stands, and was judged where it came to stand.
    let is_turned = match surface.shape {
        SurfaceShape::Face { .. } => motion.to_known.has(surface.rotary),
        SurfaceShape::Cylinder { .. } => motion.to_known.has(surface.across),
    };
    let linear = motion.to_known.without(across).without(rotary);
    (places, if is_turned { linear.or(rotary) } else { linear })
}

/// How fast the rotary axis turns at most, rad/s, at this speed along a curve, and the radius at that place, mm.
pub(crate) fn fastest_turn(surface: &RotarySurface, curve: &Curve, speed: f64) -> (f64, f64) {
    let length = curve.length();
    let mut fastest = (0.0, f64::INFINITY);
    let mut look = |s: f64| {
        let (point, way) = (curve.point_at(s).to_array(), curve.tangent_at(s).to_array());
        let radius = surface.radius_at(point);
        let across = match surface.shape {
            SurfaceShape::Face { along, .. } => {
                let arm = point[along] * way[surface.across] - point[surface.across] * way[along];
                if arm.abs() > POLE_MM { arm / radius } else { 0.0 }
            }
            SurfaceShape::Cylinder { .. } => way[surface.across],
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
    // A straight cut is square to its distance where it is nearest, an arc too: all speed turns the axis.
    if let (SurfaceShape::Face { .. }, true) = (surface.shape, radius < fastest.1) {
        let ends = [curve.start(), curve.end()].map(|end| surface.radius_at(end.to_array()));
        if radius < ends[0].min(ends[1]) * (1.0 - 1e-9) && radius > POLE_MM {
            fastest = (speed / radius, radius);
        }
    }
    fastest
}

/// The pieces of a cut on a surface, each as slow as the rotary axis needs at `most` rad/s; `None` where it keeps up.
/// `seconds` is what the feed alone takes.
pub fn rotary_parts(
    surface: &RotarySurface,
    curve: &Curve,
    seconds: f64,
    most: f64,
) -> Option<Vec<SurfacePart>> {
    let length = curve.length();
    let is_number = length > 0.0 && seconds > 0.0 && most > 0.0;
    if !is_number {
        return None;
    }
    let [nearest, _] = nearest_and_farthest(surface, curve);
    let goes_through = surface.radius_at(nearest.to_array()) <= POLE_MM;
    if !goes_through && fastest_turn(surface, curve, length / seconds).0 <= most {
        return None;
    }
    let mut parts = Vec::new();
    let cut = Cut { surface, curve, speed: length / seconds, most };
    cut.divide([0.0, length], 0, &mut parts);
    Some(parts)
}

struct Cut<'a> {
    surface: &'a RotarySurface,
    curve: &'a Curve,
    speed: f64,
    most: f64,
}

impl Cut<'_> {
    fn divide(&self, [from, to]: [f64; 2], depth: u32, parts: &mut Vec<SurfacePart>) {
        let point = |s: f64| at(self.curve.point_at(s));
        let turn = self.surface.turn(&point(from), &point(to), None).abs();
        if turn > EVEN_RAD && depth < MOST_HALVINGS {
            let middle = from + (to - from) * DIVIDED_AT;
            self.divide([from, middle], depth + 1, parts);
            return self.divide([middle, to], depth + 1, parts);
        }
        let seconds = ((to - from) / self.speed).max(turn / self.most);
        parts.push(SurfacePart { from, to, seconds });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use chordal_geometry::Line;

    fn face() -> RotarySurface {
        let shape = SurfaceShape::Face { along: 0, zero: 0.0, negative: false };
        RotarySurface { shape, rotary: 5, across: 1, standing: 0.0 }
    }

    fn line(from: [f64; 2], to: [f64; 2]) -> Curve {
        let point = |[x, y]: [f64; 2]| Vec3::new(x, y, 0.0);
        Curve::Line(Line { start: point(from), end: point(to) })
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
        // 10 mm/s past the pole at 0.1 um. The axis turns faster than 30 degrees a second within 0.0437 mm of the pole, and
        // there by 3.137 rad: 5.991 s, and 3.991 s for the rest.
        let curve = line([20.0, 1e-4], [-20.0, 1e-4]);
        let most = 30.0_f64.to_radians();
        let parts = rotary_parts(&face(), &curve, 4.0, most).expect("too fast");
        let total: f64 = parts.iter().map(|part| part.seconds).sum();
        assert!((total - 9.982).abs() < 0.02, "{total}");
        assert_eq!(parts.last().expect("one").to, 40.0);
        assert!(rotary_parts(&face(), &line([20.0, 0.0], [5.0, 0.0]), 1.0, most).is_none());
        // Through the pole itself: half a turn at rest, six seconds more.
        let through = line([20.0, 0.0], [-20.0, 0.0]);
        let parts = rotary_parts(&face(), &through, 4.0, most).expect("through the pole");
        let total: f64 = parts.iter().map(|part| part.seconds).sum();
        assert!((total - 10.0).abs() < 0.02, "{total}");
        assert_eq!(fastest_turn(&face(), &through, 10.0).0, 0.0);
    }
}
