//! Lines and arcs of a contour.

use std::f64::consts::TAU;

use chordal_geometry::{
    HalfCircleTolerance, Plane, RadiusError, TurnDirection, Vec2, center_from_radius,
};

use super::vectors::{COINCIDENT_POINTS_MM, distance, left_normal, unit_vector};

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
    pub fn start_direction(&self, start: [f64; 3], plane: Plane) -> Option<[f64; 2]> {
        self.direction_at(start, start, plane)
    }

    /// The direction in a plane with which it ends, when it began at `start`; `None` if it does not move there.
    pub fn end_direction(&self, start: [f64; 3], plane: Plane) -> Option<[f64; 2]> {
        self.direction_at(start, self.end(), plane)
    }

    fn direction_at(&self, start: [f64; 3], at: [f64; 3], plane: Plane) -> Option<[f64; 2]> {
        let (a, b, _) = plane.axes();
        match self {
            ContourElement::Line { end } => unit_vector([start[a], start[b]], [end[a], end[b]]),
            ContourElement::Arc { plane: own, center, sweep_rad, .. } => {
                if *own != plane {
                    return None;
                }
                let outward = unit_vector(*center, [at[a], at[b]])?;
                let [along, across] = left_normal(outward);
                let sign = sweep_rad.signum();
                Some([sign * along, sign * across])
            }
        }
    }
}

/// The angle from start to end about a centre in a direction, rad, signed; a full turn where they are one point.
fn sweep_of(start: [f64; 2], end: [f64; 2], center: [f64; 2], direction: TurnDirection) -> f64 {
    if distance(start, end) <= COINCIDENT_POINTS_MM {
        return direction.sign() * TAU;
    }
    let angle = |point: [f64; 2]| libm::atan2(point[1] - center[1], point[0] - center[0]);
    let turned = (direction.sign() * (angle(end) - angle(start))).rem_euclid(TAU);
    direction.sign() * turned
}

/// By how much the distances of the two ends from a centre differ, mm.
pub fn arc_fault_mm(start: [f64; 2], end: [f64; 2], center: [f64; 2]) -> f64 {
    distance(end, center) - distance(start, center)
}

/// The arc about a centre, whose ends may lie at slightly different distances from it: its centre moves by the shortest
/// distance to the bisector of the chord. The result is the centre and the angle, rad.
pub fn arc_about(
    start: [f64; 2],
    end: [f64; 2],
    center: [f64; 2],
    direction: TurnDirection,
) -> ([f64; 2], f64) {
    let chord = [end[0] - start[0], end[1] - start[1]];
    let length = libm::hypot(chord[0], chord[1]);
    let mut fitted = center;
    if length > COINCIDENT_POINTS_MM && arc_fault_mm(start, end, center) != 0.0 {
        let along = [chord[0] / length, chord[1] / length];
        let off = [0, 1].map(|axis| start[axis] + chord[axis] / 2.0 - center[axis]);
        let by = off[0] * along[0] + off[1] * along[1];
        fitted = [0, 1].map(|axis| center[axis] + along[axis] * by);
    }
    (fitted, sweep_of(start, end, fitted, direction))
}

/// The arc of a radius, mm, negative for more than half a circle: its centre and its angle, rad.
///
/// # Errors
/// Why there is none.
pub fn arc_by_radius(
    start: [f64; 2],
    end: [f64; 2],
    radius: f64,
    direction: TurnDirection,
) -> Result<([f64; 2], f64), RadiusError> {
    let [from, to] = [start, end].map(|[a, b]| Plane::Xy.point(Vec2::new(a, b), 0.0));
    let tolerance = HalfCircleTolerance { too_short_mm: 0.002, too_long_mm: 0.0 };
    let (x, y) = center_from_radius(Plane::Xy, from, to, radius, direction, tolerance)?;
    Ok(([x, y], sweep_of(start, end, [x, y], direction)))
}

/// The arc that begins in a direction and ends at a point: its centre and its angle, rad; `None` if the point lies in
/// the direction itself.
pub fn tangent_center(
    start: [f64; 2],
    direction: [f64; 2],
    end: [f64; 2],
) -> Option<([f64; 2], f64)> {
    let normal = left_normal(direction);
    let chord = [end[0] - start[0], end[1] - start[1]];
    let across = normal[0] * chord[0] + normal[1] * chord[1];
    if across.abs() <= COINCIDENT_POINTS_MM {
        return None;
    }
    let radius = (chord[0] * chord[0] + chord[1] * chord[1]) / (2.0 * across);
    let center = [0, 1].map(|axis| start[axis] + normal[axis] * radius);
    let turn = if radius > 0.0 { TurnDirection::Ccw } else { TurnDirection::Cw };
    Some((center, sweep_of(start, end, center, turn)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(found: [f64; 2], expected: [f64; 2]) {
        assert!(distance(found, expected) < 1e-4, "{found:?} is not {expected:?}");
    }

    #[test]
    fn arcs_by_radius_go_the_short_or_the_long_side() {
        let [start, end] = [[30.0, 85.0], [70.0, 95.0]];
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
            tangent_center([95.0, 40.0], [0.0, -1.0], [40.0, 5.0]).expect("an arc");
        near(center, [56.3636, 40.0]);
        assert!((sweep.to_degrees() + 115.0576).abs() < 1e-4);
        assert!(tangent_center([0.0; 2], [1.0, 0.0], [5.0, 0.0]).is_none());
    }

    #[test]
    fn a_center_that_is_slightly_off_moves_to_the_bisector() {
        let (center, _) = arc_about([10.0, 0.0], [0.0, 10.01], [0.0; 2], TurnDirection::Ccw);
        let radii = [[10.0, 0.0], [0.0, 10.01]].map(|end| distance(center, end));
        assert!((radii[0] - radii[1]).abs() < 1e-12);
        // It moves by half of the difference at most where the ends lie across, and along the chord.
        assert!((distance(center, [0.0; 2]) - 0.00707).abs() < 1e-5, "{center:?}");
    }

    #[test]
    fn half_circles_with_rounded_radii_keep_their_centers() {
        let (center, sweep) = arc_about([-40.01, 0.0], [40.0, 0.0], [0.0; 2], TurnDirection::Cw);
        near(center, [-0.005, 0.0]);
        assert!((sweep.to_degrees() + 180.0).abs() < 1e-9);
    }
}
