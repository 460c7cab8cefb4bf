//! The turn of a work coordinate system (G10 L2 R): canonical places are those before it.

use std::f64::consts::TAU;

use chordal::control::{ArcShape, Position};
use chordal::geometry::{Plane, Spline, Transform, Vec3};

/// Control points nearer than this to a plane lie in it, mm.
const PLANAR_MM: f64 = 1e-9;

/// The turn about the zero of the work coordinate system, and what presets and shifts put between that and the zero of
/// the program.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct CoordinateRotation {
    /// Counter-clockwise, degrees.
    pub(super) degrees: f64,
    /// The sum of G92 and G52, mm and rad.
    pub(super) preset: Position,
}

impl CoordinateRotation {
    fn acts(&self) -> bool {
        self.degrees % 360.0 != 0.0
    }

    /// The place that the turn takes to a place of commands.
    pub(super) fn before(&self, place: &Position) -> Position {
        let mut found = *place;
        if self.acts() {
            let point = self.point_before(Vec3::new(place[0], place[1], place[2]));
            (found[0], found[1]) = (point.x, point.y);
        }
        found
    }

    pub(super) fn point_before(&self, place: Vec3) -> Vec3 {
        if !self.acts() {
            return place;
        }
        let [g, h, ..] = self.preset;
        let back =
            Transform::rotation_about(Vec3::new(-g, -h, 0.0), Vec3::Z, -self.degrees.to_radians());
        back.apply_point(place)
    }

    /// The arc that the turn takes to an arc of commands, which ends at `to`.
    pub(super) fn arc_before(&self, to: &Position, shape: &ArcShape) -> ArcShape {
        if !self.acts() {
            return *shape;
        }
        let (first, second, _) = shape.plane.axes();
        let mut center = *to;
        (center[first], center[second]) = (shape.center[0], shape.center[1]);
        let center = self.before(&center);
        // An upright plane is one of the axes' after half a turn alone, seen from the other side.
        let sweep = if shape.plane == Plane::Xy { shape.sweep } else { -shape.sweep };
        ArcShape { center: [center[first], center[second]], sweep, ..*shape }
    }

    /// The arc of G18 or G19 whose turned image a spline is; where it ends.
    pub(super) fn upright_arc(&self, curve: &Spline) -> Option<(Vec3, ArcShape)> {
        if !self.acts() || curve.order() != 3 || curve.points().len().is_multiple_of(2) {
            return None;
        }
        let points: Vec<Vec3> = curve.points().iter().map(|at| self.point_before(*at)).collect();
        let plane = upright_plane(&points)?;
        let (weight, pieces) = (*curve.weights().get(1)?, points.len() / 2);
        let is_arc = |(at, found): (usize, &f64)| {
            (found - if at % 2 == 0 { 1.0 } else { weight }).abs() < 1e-9
        };
        if weight >= 1.0 || !curve.weights().iter().enumerate().all(is_arc) {
            return None;
        }
        let (first, second, _) = plane.axes();
        let place = |at: usize| {
            let axes = points[at].to_array();
            [axes[first], axes[second]]
        };
        let (from, corner, to) = (place(0), place(1), place(2));
        // Where the tangents meet is 1/w radii from the centre, and the middle of the chord w.
        let square = weight * weight;
        let center = [0, 1].map(|axis| {
            let middle = (from[axis] + to[axis]) / 2.0;
            (middle - square * corner[axis]) / (1.0 - square)
        });
        let path = |place: [f64; 2]| [place[0] - center[0], place[1] - center[1]];
        let (u, v) = (path(from), path(corner));
        let cross = u[0] * v[1] - u[1] * v[0];
        let sweep = pieces as f64 * 2.0 * weight.acos() * cross.signum();
        let radius = (u[0] * u[0] + u[1] * u[1]).sqrt();
        let shape = ArcShape { plane, center, sweep, radius_from: radius, radius_to: radius };
        (sweep.abs() < 1000.0 * TAU).then(|| (points[points.len() - 1], shape))
    }
}

/// The upright plane that points lie in; nothing where they are level.
fn upright_plane(points: &[Vec3]) -> Option<Plane> {
    let first = points.first()?;
    let is_flat =
        |of: fn(&Vec3) -> f64| points.iter().all(|at| (of(at) - of(first)).abs() < PLANAR_MM);
    match (is_flat(|at| at.x), is_flat(|at| at.y), is_flat(|at| at.z)) {
        (_, _, true) => None,
        (_, true, _) => Some(Plane::Zx),
        (true, ..) => Some(Plane::Yz),
        _ => None,
    }
}
