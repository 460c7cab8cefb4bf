//! The extreme positions of the real axes in a move on a surface.

use std::f64::consts::TAU;

use chordal_command::{
    ArcShape, AxisMask, Move, Position, RotarySurface, SurfaceRun, SurfaceShape,
};
use chordal_geometry::ParamCurve;
use chordal_machine::AXES;

use crate::segment::curve_of;

/// If the end radii differ by more, a move is a spiral, mm.
const EQUAL_RADIUS_MM: f64 = 1e-6;

/// A centre that is closer to the pole than this has no direction, mm.
const POLE_MM: f64 = 1e-9;

/// The number of intervals into which a spiral is divided.
const PLACES: u32 = 256;

/// The positions of the real axes (mm and rad) at which one of them has an extreme in a move on a surface, and at its
/// end; also which axes are known. `run` has already followed the move.
pub fn places_on_axes(
    run: &SurfaceRun,
    motion: &Move,
    shape: Option<&ArcShape>,
) -> (Vec<Position>, AxisMask) {
    let surface = &run.surface;
    let places = match surface.shape {
        SurfaceShape::Face { along, .. } => on_face(run, motion, shape, along),
        SurfaceShape::Cylinder { .. } => on_cylinder(run, motion, shape),
    };
    let (across, rotary) = (AxisMask(1 << surface.across), AxisMask(1 << surface.rotary));
    // The axis across does not move; its position was checked when it moved there.
    let is_turned = match surface.shape {
        SurfaceShape::Face { .. } => motion.to_known.has(surface.rotary),
        SurfaceShape::Cylinder { .. } => motion.to_known.has(surface.across),
    };
    let linear = motion.to_known.without(across).without(rotary);
    (places, if is_turned { linear.or(rotary) } else { linear })
}

/// The corners of the box around a move on the unrolled cylinder, and its end: the axes move parallel to its sides.
fn on_cylinder(run: &SurfaceRun, motion: &Move, shape: Option<&ArcShape>) -> Vec<Position> {
    let bounds = curve_of(motion, shape).bounds();
    let corner = |place: [f64; 3]| {
        let mut position = motion.to;
        position[..3].copy_from_slice(&place);
        run.on_axes(&position)
    };
    vec![corner(bounds.min.to_array()), corner(bounds.max.to_array()), run.on_axes(&motion.to)]
}

/// A point of a move on a face: the fraction of the move, 0 to 1, and its two coordinates, mm.
struct FacePoint {
    share: f64,
    flat: [f64; 2],
}

fn on_face(
    run: &SurfaceRun,
    motion: &Move,
    shape: Option<&ArcShape>,
    along: usize,
) -> Vec<Position> {
    let surface = &run.surface;
    let flat = |place: &Position| [place[along], place[surface.across]];
    let (from, to) = (flat(&motion.from), flat(&motion.to));
    let whole = surface.turn(&motion.from, &motion.to, shape);
    let angle = |at: &FacePoint| match shape {
        _ if at.share >= 1.0 => run.angle,
        // A line from the pole or to it does not turn the axis.
        None => run.angle - surface.turn(&on(motion, surface, along, at), &motion.to, None),
        Some(_) if at.share <= 0.0 => run.angle - whole,
        Some(shape) => {
            let part = ArcShape {
                sweep: shape.sweep * at.share,
                radius_to: shape.radius_from + (shape.radius_to - shape.radius_from) * at.share,
                ..*shape
            };
            let turned = surface.turn(&motion.from, &on(motion, surface, along, at), Some(&part));
            run.angle - whole + turned
        }
    };
    let mut places = vec![FacePoint { share: 0.0, flat: from }];
    match shape {
        None => places.extend(foot(from, to)),
        Some(shape) if (shape.radius_from - shape.radius_to).abs() <= EQUAL_RADIUS_MM => {
            places.extend(of_arc(from, shape));
        }
        Some(shape) => places.extend(of_spiral(from, shape)),
    }
    places.push(FacePoint { share: 1.0, flat: to });
    let on_axes = |at: &FacePoint| surface.on_axes(&on(motion, surface, along, at), angle(at));
    places.iter().map(on_axes).collect()
}

/// The position of all axes at a point of a move.
fn on(motion: &Move, surface: &RotarySurface, along: usize, at: &FacePoint) -> Position {
    let mut position: Position = std::array::from_fn(|axis: usize| {
        motion.from[axis] + (motion.to[axis] - motion.from[axis]) * at.share
    });
    debug_assert!(position.len() == AXES);
    position[along] = at.flat[0];
    position[surface.across] = at.flat[1];
    position
}

/// The point of a line nearest to the pole, if it is between the ends.
fn foot(from: [f64; 2], to: [f64; 2]) -> Option<FacePoint> {
    let path = [to[0] - from[0], to[1] - from[1]];
    let square = path[0] * path[0] + path[1] * path[1];
    let share = -(from[0] * path[0] + from[1] * path[1]) / square;
    (share > 0.0 && share < 1.0)
        .then(|| FacePoint { share, flat: [from[0] + path[0] * share, from[1] + path[1] * share] })
}

/// The points of an arc that are nearest to the pole and farthest from it, and where lines from the pole are tangent.
fn of_arc(from: [f64; 2], shape: &ArcShape) -> Vec<FacePoint> {
    let (center, radius) = (shape.center, shape.radius_from);
    let away = libm::hypot(center[0], center[1]);
    if away <= POLE_MM || radius <= 0.0 {
        return Vec::new();
    }
    let begin = libm::atan2(from[1] - center[1], from[0] - center[0]);
    let outward = libm::atan2(center[1], center[0]);
    let mut angles = vec![outward, outward + TAU / 2.0];
    if away > radius {
        let touch = libm::acos(-radius / away);
        angles.extend([outward + touch, outward - touch]);
    }
    let mut places: Vec<FacePoint> = Vec::new();
    for angle in angles {
        let path = if shape.sweep < 0.0 { begin - angle } else { angle - begin };
        let share = path.rem_euclid(TAU) / shape.sweep.abs();
        if share > 0.0 && share < 1.0 {
            let (sin, cos) = libm::sincos(angle);
            places.push(FacePoint {
                share,
                flat: [center[0] + radius * cos, center[1] + radius * sin],
            });
        }
    }
    places
}

fn of_spiral(from: [f64; 2], shape: &ArcShape) -> impl Iterator<Item = FacePoint> {
    let center = shape.center;
    let begin = libm::atan2(from[1] - center[1], from[0] - center[0]);
    let (sweep, first, growth) =
        (shape.sweep, shape.radius_from, shape.radius_to - shape.radius_from);
    (1..PLACES).map(move |place| {
        let share = f64::from(place) / f64::from(PLACES);
        let (sin, cos) = libm::sincos(begin + sweep * share);
        let radius = first + growth * share;
        FacePoint { share, flat: [center[0] + radius * cos, center[1] + radius * sin] }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use chordal_geometry::Plane;

    const FACE: RotarySurface = RotarySurface {
        shape: SurfaceShape::Face { along: 0, zero: 0.0, turned: 0.0, negative: false },
        rotary: 5,
        across: 1,
        across_position: 0.0,
    };

    /// X (a radius) and C in degrees at the extremes of a move on the face.
    fn extremes(from: [f64; 2], to: [f64; 2], arc: Option<([f64; 2], f64)>) -> [[f64; 2]; 2] {
        let at = |[x, y]: [f64; 2]| [x, y, 0.0, 0.0, 0.0, 0.0];
        let shape = arc.map(|(center, sweep)| {
            let radius = libm::hypot(from[0] - center[0], from[1] - center[1]);
            ArcShape { plane: Plane::Xy, center, sweep, radius_from: radius, radius_to: radius }
        });
        let known = AxisMask::ALL;
        let motion = Move { from: at(from), to: at(to), from_known: known, to_known: known };
        let mut run = SurfaceRun::new(FACE);
        run.angle = libm::atan2(from[1], from[0]);
        run.follow(&motion, shape.as_ref());
        let (places, mask) = places_on_axes(&run, &motion, shape.as_ref());
        assert!(mask.has(0) && mask.has(5) && !mask.has(1));
        [0, 5].map(|axis| {
            let values = || places.iter().map(|place| place[axis]);
            let range =
                [values().fold(f64::INFINITY, f64::min), values().fold(-f64::INFINITY, f64::max)];
            if axis == 5 { range.map(f64::to_degrees) } else { range }
        })
    }

    fn near(is: [f64; 2], meant: [f64; 2]) {
        for (is, meant) in is.into_iter().zip(meant) {
            assert!((is - meant).abs() < 1e-9, "{is} {meant}");
        }
    }

    #[test]
    fn a_line_is_nearest_at_its_foot() {
        let [x, c] = extremes([20.0, 10.0], [-20.0, 10.0], None);
        near(x, [10.0, 500.0_f64.sqrt()]);
        near(c, [26.565_051_177_077_99, 153.434_948_822_922_01]);
        // The foot is beyond its end: the ends count.
        let [x, _] = extremes([20.0, 10.0], [5.0, 10.0], None);
        near(x, [125.0_f64.sqrt(), 500.0_f64.sqrt()]);
        // Through the pole.
        let [x, c] = extremes([20.0, 0.0], [-20.0, 0.0], None);
        near(x, [0.0, 20.0]);
        near([c[1] - c[0], 0.0], [180.0, 0.0]);
    }

    #[test]
    fn a_circle_next_to_the_pole_turns_the_axis_out_and_back() {
        // Radius 10 about 15: between 5 and 25 from the pole, and asin(10/15) to both sides.
        let [x, c] = extremes([25.0, 0.0], [25.0, 0.0], Some(([15.0, 0.0], TAU)));
        near(x, [5.0, 25.0]);
        near(c, [-41.810_314_895_778_59, 41.810_314_895_778_59]);
        let [x, c] = extremes([25.0, 0.0], [25.0, 0.0], Some(([15.0, 0.0], -TAU)));
        near(x, [5.0, 25.0]);
        near(c, [-41.810_314_895_778_59, 41.810_314_895_778_59]);
        // The upper half has one of the two.
        let [x, c] = extremes([25.0, 0.0], [5.0, 0.0], Some(([15.0, 0.0], TAU / 2.0)));
        near(x, [5.0, 25.0]);
        near(c, [0.0, 41.810_314_895_778_59]);
    }

    #[test]
    fn a_circle_around_the_pole_turns_the_axis_one_way() {
        let [x, c] = extremes([13.0, 0.0], [13.0, 0.0], Some(([3.0, 0.0], TAU)));
        near(x, [7.0, 13.0]);
        near(c, [0.0, 360.0]);
    }
}
