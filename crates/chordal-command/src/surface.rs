//! Polar and cylindrical interpolation: a rotary axis replaces a linear one, and the program gives two coordinates on a
//! face or around a cylinder as lengths (G12.1, G7.1).

use std::f64::consts::{PI, TAU};

use chordal_machine::AXES;

use crate::axes::Position;
use crate::motion::{ArcShape, Move};

/// Nearer to the pole than this, mm, the direction of a point is rounding and is not used.
const POLE_RADIUS_MM: f64 = 1e-9;

/// Into how many parts of its angle a spiral, or an arc near the pole, is divided to follow its direction from the pole.
const DIRECTION_PARTS: u32 = 256;

/// A surface that turns with a rotary axis. While it is active, positions of moves have on the axis `across` a
/// length on the surface, and that axis itself and the rotary one keep the values they had.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RotarySurface {
    /// Its shape.
    pub shape: SurfaceShape,
    /// Index of the rotary axis.
    pub rotary: usize,
    /// Index of the axis whose coordinate is the length.
    pub across: usize,
    /// The position of the axis `across` itself, which does not move, mm.
    pub across_position: f64,
}

/// The shape of a surface.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum SurfaceShape {
    /// The face: Cartesian coordinates about the rotary axis.
    Face {
        /// Index of the linear axis that moves; its coordinate is the first one on the face.
        along: usize,
        /// Angle of the rotary axis at which the tool is on the first coordinate axis, rad.
        zero: f64,
        /// How far the rotary axis is turned from that angle when the face becomes active, rad.
        turned: f64,
        /// Whether the linear axis is on its negative side.
        negative: bool,
    },
    /// A cylinder: a length around it is the angle of the rotary axis times the radius.
    Cylinder {
        /// Its radius, mm.
        radius_mm: f64,
    },
}

impl RotarySurface {
    /// The first coordinate on a face and the length across.
    fn flat(&self, place: &Position, along: usize) -> [f64; 2] {
        [place[along], place[self.across]]
    }

    /// How far the rotary axis turns on a straight move or an arc, rad.
    pub fn turn(&self, from: &Position, to: &Position, shape: Option<&ArcShape>) -> f64 {
        match self.shape {
            SurfaceShape::Cylinder { radius_mm } => {
                (to[self.across] - from[self.across]) / radius_mm
            }
            SurfaceShape::Face { along, .. } => {
                let (from, to) = (self.flat(from, along), self.flat(to, along));
                match (shape, direction(from), direction(to)) {
                    (Some(shape), ..) => turn_of_arc(from, to, shape),
                    (None, Some(from), Some(to)) => wrapped(to - from),
                    // To the pole and from there nothing turns.
                    (None, ..) => 0.0,
                }
            }
        }
    }

    /// How far the rotary axis has turned after a move, rad, if it had turned `angle` before; at the pole it does not turn.
    fn turned(&self, angle: f64, to: &Position, from: &Position, shape: Option<&ArcShape>) -> f64 {
        let SurfaceShape::Face { along, negative, .. } = self.shape else {
            return self.turn(from, to, shape);
        };
        if shape.is_some() {
            return self.turn(from, to, shape);
        }
        let side = if negative { PI } else { 0.0 };
        match direction(self.flat(to, along)) {
            Some(end) => wrapped(end - side - angle),
            None => 0.0,
        }
    }

    /// A position on the surface as positions of the axes; `angle` is how far the rotary axis is turned from the zero
    /// of a face, rad.
    pub fn on_axes(&self, place: &Position, angle: f64) -> Position {
        let mut axes = *place;
        axes[self.across] = self.across_position;
        match self.shape {
            SurfaceShape::Face { along, zero, negative, .. } => {
                let [x, y] = self.flat(place, along);
                let radius = libm::hypot(x, y);
                axes[along] = if negative { -radius } else { radius };
                axes[self.rotary] = zero + angle;
            }
            SurfaceShape::Cylinder { radius_mm } => {
                axes[self.rotary] = place[self.across] / radius_mm;
            }
        }
        axes
    }

    /// Positions of the axes as a position on the surface at the moment it becomes active.
    pub fn on_surface(&self, axes: &Position) -> Position {
        let mut place = *axes;
        match self.shape {
            SurfaceShape::Face { turned: 0.0, .. } => place[self.across] = 0.0,
            SurfaceShape::Face { along, turned, .. } => {
                let (sin, cos) = libm::sincos(turned);
                (place[along], place[self.across]) = (axes[along] * cos, axes[along] * sin);
            }
            SurfaceShape::Cylinder { radius_mm } => {
                place[self.across] = axes[self.rotary] * radius_mm;
            }
        }
        place
    }

    /// Distance from the rotary axis, mm: of a point on the face, or the radius of the cylinder.
    pub fn radius_at(&self, place: [f64; 3]) -> f64 {
        match self.shape {
            SurfaceShape::Face { along, .. } => libm::hypot(place[along], place[self.across]),
            SurfaceShape::Cylinder { radius_mm } => radius_mm,
        }
    }
}

/// An active surface, and how far its rotary axis has turned.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SurfaceRun {
    /// The surface.
    pub surface: RotarySurface,
    /// How far the rotary axis is turned from the zero of a face, rad.
    pub angle: f64,
}

impl SurfaceRun {
    /// A surface that has just become active.
    pub fn new(surface: RotarySurface) -> SurfaceRun {
        let angle = match surface.shape {
            SurfaceShape::Face { turned, .. } => turned,
            SurfaceShape::Cylinder { .. } => 0.0,
        };
        SurfaceRun { surface, angle }
    }

    /// Turns the rotary axis by a move.
    pub fn follow(&mut self, motion: &Move, shape: Option<&ArcShape>) {
        self.angle += self.surface.turned(self.angle, &motion.to, &motion.from, shape);
    }

    /// A position on the surface as positions of the axes.
    pub fn on_axes(&self, place: &Position) -> Position {
        self.surface.on_axes(place, self.angle)
    }
}

/// The direction of a point from the pole, rad; `None` at the pole.
fn direction([x, y]: [f64; 2]) -> Option<f64> {
    (libm::hypot(x, y) > POLE_RADIUS_MM).then(|| libm::atan2(y, x))
}

/// An angle brought into the range from -π to π.
fn wrapped(angle: f64) -> f64 {
    let turned = angle.rem_euclid(TAU);
    if turned > PI { turned - TAU } else { turned }
}

/// How far the direction from the pole turns along an arc or a spiral, rad.
fn turn_of_arc(from: [f64; 2], to: [f64; 2], shape: &ArcShape) -> f64 {
    let center = shape.center;
    let away = libm::hypot(center[0], center[1]);
    let radius = shape.radius_from;
    let is_arc = (shape.radius_from - shape.radius_to).abs() <= 1e-6;
    let is_clear = (away - radius).abs() > 1e-6;
    match (direction(from), direction(to)) {
        (Some(first), Some(last)) if is_arc && is_clear && away > radius => {
            // Seen from the pole the whole circle is within a quarter turn of its centre.
            let middle = libm::atan2(center[1], center[0]);
            wrapped(last - middle) - wrapped(first - middle)
        }
        (Some(first), Some(last)) if is_arc && is_clear => {
            // About a pole inside the circle the direction is never a quarter turn from that from the centre.
            let around = |place: [f64; 2]| libm::atan2(place[1] - center[1], place[0] - center[0]);
            shape.sweep + wrapped(last - around(to)) - wrapped(first - around(from))
        }
        _ => turn_in_parts(from, shape),
    }
}

fn turn_in_parts(from: [f64; 2], shape: &ArcShape) -> f64 {
    let center = shape.center;
    let begin = libm::atan2(from[1] - center[1], from[0] - center[0]);
    let mut before = direction(from);
    let mut total = 0.0;
    for part in 1..=DIRECTION_PARTS {
        let share = f64::from(part) / f64::from(DIRECTION_PARTS);
        let (sin, cos) = libm::sincos(begin + shape.sweep * share);
        let radius = shape.radius_from + (shape.radius_to - shape.radius_from) * share;
        let now = direction([center[0] + radius * cos, center[1] + radius * sin]);
        if let (Some(before), Some(now)) = (before, now) {
            total += wrapped(now - before);
        }
        before = now.or(before);
    }
    total
}

const _: () = assert!(AXES == 6, "three linear axes before three rotary ones");

#[cfg(test)]
mod tests {
    use super::*;
    use crate::axes::AxisMask;
    use chordal_geometry::Plane;

    const FACE: RotarySurface = RotarySurface {
        shape: SurfaceShape::Face { along: 0, zero: 0.0, turned: 0.0, negative: false },
        rotary: 5,
        across: 1,
        across_position: 0.0,
    };

    fn at(x: f64, y: f64) -> Position {
        [x, y, 0.0, 0.0, 0.0, 0.0]
    }

    fn line(from: Position, to: Position) -> Move {
        Move { from, to, from_known: AxisMask::ALL, to_known: AxisMask::ALL }
    }

    fn arc(center: [f64; 2], radius: f64, sweep: f64) -> ArcShape {
        ArcShape { plane: Plane::Xy, center, sweep, radius_from: radius, radius_to: radius }
    }

    fn near(is: f64, meant: f64) {
        assert!((is - meant).abs() < 1e-9, "{is} {meant}");
    }

    #[test]
    fn the_axes_of_places_on_a_face_and_on_a_cylinder() {
        // X as a diameter 40, C 10: diameter 44.7214 and 26.5651 degrees.
        let mut run = SurfaceRun::new(FACE);
        run.follow(&line(at(20.0, 0.0), at(20.0, 10.0)), None);
        let axes = run.on_axes(&at(20.0, 10.0));
        near(2.0 * axes[0], 44.721_359_549_995_796);
        near(axes[5].to_degrees(), 26.565_051_177_077_99);
        // Round the centre it goes on counting.
        run.follow(&line(at(20.0, 10.0), at(-20.0, 10.0)), None);
        run.follow(&line(at(-20.0, 10.0), at(-20.0, -10.0)), None);
        near(run.on_axes(&at(-20.0, -10.0))[5].to_degrees(), 206.565_051_177_077_99);
        let shell = SurfaceShape::Cylinder { radius_mm: 25.0 };
        let shell = RotarySurface { shape: shell, ..FACE };
        near(shell.on_axes(&at(30.0, 60.0), 0.0)[5].to_degrees(), 137.509_870_831_397_6);
    }

    #[test]
    fn the_pole_is_left_in_any_direction() {
        let mut run = SurfaceRun::new(FACE);
        run.follow(&line(at(20.0, 0.0), at(0.0, 0.0)), None);
        near(run.angle, 0.0);
        run.follow(&line(at(0.0, 0.0), at(0.0, 5.0)), None);
        near(run.angle.to_degrees(), 90.0);
    }

    #[test]
    fn arcs_around_the_pole_and_beside_it() {
        // A full circle about the pole, one that has the pole inside, and one beside it.
        near(FACE.turn(&at(10.0, 0.0), &at(10.0, 0.0), Some(&arc([0.0; 2], 10.0, TAU))), TAU);
        near(FACE.turn(&at(13.0, 0.0), &at(13.0, 0.0), Some(&arc([3.0, 0.0], 10.0, -TAU))), -TAU);
        near(FACE.turn(&at(25.0, 0.0), &at(25.0, 0.0), Some(&arc([15.0, 0.0], 10.0, TAU))), 0.0);
        // Half of it, from the near side to the far one.
        let half = FACE.turn(&at(15.0, -10.0), &at(15.0, 10.0), Some(&arc([15.0, 0.0], 10.0, PI)));
        near(half, 2.0 * libm::atan2(10.0, 15.0));
        let beyond = FACE.turn(&at(0.0, 10.0), &at(0.0, -10.0), Some(&arc([0.0; 2], 10.0, -PI)));
        near(beyond, -PI);
    }

    #[test]
    fn a_lathe_that_cuts_at_negative_x_starts_without_a_turn() {
        let shape = SurfaceShape::Face { along: 0, zero: 0.5, turned: 0.0, negative: true };
        let mut run = SurfaceRun::new(RotarySurface { shape, ..FACE });
        assert_eq!(run.on_axes(&at(-20.0, 0.0))[..1], [-20.0]);
        run.follow(&line(at(-20.0, 0.0), at(-20.0, -10.0)), None);
        let axes = run.on_axes(&at(-20.0, -10.0));
        near(axes[0], -500.0_f64.sqrt());
        near(axes[5], 0.5 + libm::atan2(10.0, 20.0));
    }
}
