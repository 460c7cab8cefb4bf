//! Lines and arcs of a contour.

use std::f64::consts::TAU;

use chordal_geometry::{
    HalfCircleTolerance, Plane, RadiusError, TurnDirection, Vec2, center_from_radius,
};

use super::vectors::{COINCIDENT_POINTS_MM, unit_vector};

/// A line or an arc from where the tool is; programmed coordinates, mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum ContourElement {
    /// A straight line.
    Line {
        /// Its end.
        end: [f64; 3],
    },
    /// An arc or a helix.
    Arc {
        /// Its plane.
        plane: Plane,
        /// Its centre on the axes of the plane.
        center: [f64; 2],
        /// Its angle, rad, positive counter-clockwise; more than a turn for a helix.
        sweep_rad: f64,
        /// Its end.
        end: [f64; 3],
    },
}

impl ContourElement {
    /// Its end.
    pub fn end(&self) -> [f64; 3] {
        match self {
            ContourElement::Line { end } | ContourElement::Arc { end, .. } => *end,
        }
    }

    /// The direction in a plane with which it begins at `start`; `None` if it does not move there.
    pub fn start_direction(&self, start: [f64; 3], plane: Plane) -> Option<Vec2> {
        self.direction_at(start, start, plane)
    }

    /// The direction in a plane with which it ends, when it began at `start`; `None` if it does not move there.
    pub fn end_direction(&self, start: [f64; 3], plane: Plane) -> Option<Vec2> {
        self.direction_at(start, self.end(), plane)
    }

    fn direction_at(&self, start: [f64; 3], at: [f64; 3], plane: Plane) -> Option<Vec2> {
        let (a, b, _) = plane.axes();
        let on_plane = |point: &[f64; 3]| Vec2::new(point[a], point[b]);
        match self {
            ContourElement::Line { end } => unit_vector(on_plane(&start), on_plane(end)),
            ContourElement::Arc { plane: own, center, sweep_rad, .. } => {
                if *own != plane {
                    return None;
                }
                let outward = unit_vector(Vec2::from_array(*center), on_plane(&at))?;
                Some(outward.turned_left() * sweep_rad.signum())
            }
        }
    }
}

/// The angle from start to end about a centre in a direction, rad, signed; a full turn where they are one point.
fn sweep_of(start: Vec2, end: Vec2, center: Vec2, direction: TurnDirection) -> f64 {
    if start.distance(end) <= COINCIDENT_POINTS_MM {
        return direction.sign() * TAU;
    }
    let angle = |point: Vec2| libm::atan2(point.b - center.b, point.a - center.a);
    let turned = (direction.sign() * (angle(end) - angle(start))).rem_euclid(TAU);
    direction.sign() * turned
}

/// By how much the distances of the two ends from a centre differ, mm.
pub fn arc_fault_mm(start: Vec2, end: Vec2, center: Vec2) -> f64 {
    end.distance(center) - start.distance(center)
}

/// The arc about a centre, whose ends may lie at slightly different distances from it: its centre moves by the shortest
/// distance to the bisector of the chord. The result is the centre and the angle, rad.
pub fn arc_about(start: Vec2, end: Vec2, center: Vec2, direction: TurnDirection) -> (Vec2, f64) {
    let mut fitted = center;
    if let Some(along) = unit_vector(start, end)
        && arc_fault_mm(start, end, center) != 0.0
    {
        let middle = start + (end - start) * 0.5;
        fitted = center + along * along.dot(middle - center);
    }
    (fitted, sweep_of(start, end, fitted, direction))
}

/// The arc of a radius, mm, negative for more than half a circle: its centre and its angle, rad.
///
/// # Errors
/// Why there is none.
pub fn arc_by_radius(
    start: Vec2,
    end: Vec2,
    radius: f64,
    direction: TurnDirection,
) -> Result<(Vec2, f64), RadiusError> {
    let [from, to] = [start, end].map(|point| Plane::Xy.point(point, 0.0));
    let tolerance = HalfCircleTolerance { too_short_mm: 0.002, too_long_mm: 0.0 };
    let center = center_from_radius(Plane::Xy, from, to, radius, direction, tolerance)?;
    let center = Vec2::from(center);
    Ok((center, sweep_of(start, end, center, direction)))
}

/// The arc that begins in a direction and ends at a point: its centre and its angle, rad; `None` if the point lies in
/// the direction itself.
pub fn tangent_center(start: Vec2, direction: Vec2, end: Vec2) -> Option<(Vec2, f64)> {
    let normal = direction.turned_left();
    let chord = end - start;
    let across = normal.dot(chord);
    if across.abs() <= COINCIDENT_POINTS_MM {
        return None;
    }
    let radius = chord.dot(chord) / (2.0 * across);
    let center = start + normal * radius;
    let turn = if radius > 0.0 { TurnDirection::Ccw } else { TurnDirection::Cw };
    Some((center, sweep_of(start, end, center, turn)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(found: Vec2, expected: [f64; 2]) {
        assert!(found.distance(Vec2::from_array(expected)) < 1e-4, "{found:?} is not {expected:?}");
    }

    #[test]
    fn arcs_by_radius_go_the_short_or_the_long_side() {
        let [start, end] = [[30.0, 85.0], [70.0, 95.0]].map(Vec2::from_array);
        let (center, sweep) = arc_by_radius(start, end, 30.0, TurnDirection::Cw).expect("an arc");
        near(center, [55.2859, 68.8562]);
        assert!((sweep.to_degrees() + 86.8153).abs() < 1e-4);
        let (center, sweep) = arc_by_radius(start, end, -30.0, TurnDirection::Cw).expect("an arc");
        near(center, [44.7141, 111.1438]);
        assert!((sweep.to_degrees() + 273.1847).abs() < 1e-4);
    }

    #[test]
    fn tangent_arcs_go_on_in_the_direction_before() {
        let (center, sweep) =
            tangent_center(Vec2::new(95.0, 40.0), Vec2::new(0.0, -1.0), Vec2::new(40.0, 5.0))
                .expect("an arc");
        near(center, [56.3636, 40.0]);
        assert!((sweep.to_degrees() + 115.0576).abs() < 1e-4);
        assert!(tangent_center(Vec2::ZERO, Vec2::new(1.0, 0.0), Vec2::new(5.0, 0.0)).is_none());
    }

    #[test]
    fn a_center_that_is_slightly_off_moves_to_the_bisector() {
        let ends = [[10.0, 0.0], [0.0, 10.01]].map(Vec2::from_array);
        let (center, _) = arc_about(ends[0], ends[1], Vec2::ZERO, TurnDirection::Ccw);
        let radii = ends.map(|end| center.distance(end));
        assert!((radii[0] - radii[1]).abs() < 1e-12);
        // It moves by half of the difference at most where the ends lie across, and along the chord.
        assert!((center.length() - 0.00707).abs() < 1e-5, "{center:?}");
    }

    #[test]
    fn half_circles_with_rounded_radii_keep_their_centers() {
        let ends = [[-40.01, 0.0], [40.0, 0.0]].map(Vec2::from_array);
        let (center, sweep) = arc_about(ends[0], ends[1], Vec2::ZERO, TurnDirection::Cw);
        near(center, [-0.005, 0.0]);
        assert!((sweep.to_degrees() + 180.0).abs() < 1e-9);
    }
}
