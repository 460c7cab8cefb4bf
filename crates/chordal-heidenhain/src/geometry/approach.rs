//! The paths of APPR and DEP, of the centre of the tool.

use chordal_geometry::TurnDirection;

use super::vectors::{distance, left_normal, point_ahead, turned_about};
use crate::syntax::KlartextApproachForm;

/// What an approach or a departure is made of; the plane of compensation, mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ApproachRequest {
    /// Its form.
    pub form: KlartextApproachForm,
    /// The point of the contour at which it ends or begins.
    pub point: [f64; 2],
    /// The direction of the contour there.
    pub direction: [f64; 2],
    /// The tool is to the left of the contour.
    pub is_left: bool,
    /// The radius of the tool.
    pub tool_radius_mm: f64,
    /// LEN.
    pub length_mm: f64,
    /// R of the arc; with CT negative where it bulges to the other side.
    pub arc_radius_mm: f64,
    /// CCA, rad.
    pub center_angle_rad: f64,
    /// Where the tool is before the approach, or goes to after the departure (LCT).
    pub outside: [f64; 2],
}

/// The arc of an approach or departure.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ApproachArc {
    /// Its centre.
    pub center: [f64; 2],
    /// Its direction.
    pub direction: TurnDirection,
}

/// An approach or departure: the point between its two parts, and the point of the offset contour.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ApproachPath {
    /// PH, or where the arc or line of a departure ends.
    pub helper: [f64; 2],
    /// The point of the contour, offset by the radius of the tool.
    pub contact: [f64; 2],
    /// The arc between them; `None` for a straight line.
    pub arc: Option<ApproachArc>,
}

/// Why there is no such path.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum ApproachFault {
    /// The point outside lies in the circle of the arc: its distance from the centre, and the radius, mm.
    InsideArc(f64, f64),
    /// The radius of the arc is zero or, with LCT, negative.
    NoRadius,
}

impl ApproachRequest {
    /// From the contour to the centre of the tool.
    fn normal(&self) -> [f64; 2] {
        let left = left_normal(self.direction);
        if self.is_left { left } else { left.map(|value| -value) }
    }

    fn contact(&self) -> [f64; 2] {
        point_ahead(self.point, self.normal(), self.tool_radius_mm)
    }

    /// The arc that is tangent to the contour at the offset point.
    fn arc(&self) -> Result<ApproachArc, ApproachFault> {
        let radius = self.arc_radius_mm;
        let is_wrong =
            radius == 0.0 || self.form == KlartextApproachForm::LineAndArc && radius < 0.0;
        if is_wrong {
            return Err(ApproachFault::NoRadius);
        }
        let center = point_ahead(self.contact(), self.normal(), radius);
        let is_ccw = self.is_left == (radius > 0.0);
        let direction = if is_ccw { TurnDirection::Ccw } else { TurnDirection::Cw };
        Ok(ApproachArc { center, direction })
    }
}

/// The path of an approach (APPR).
///
/// # Errors
/// Why there is none.
pub fn approach_path(request: &ApproachRequest) -> Result<ApproachPath, ApproachFault> {
    let contact = request.contact();
    let straight = |helper| Ok(ApproachPath { helper, contact, arc: None });
    match request.form {
        KlartextApproachForm::Tangent => {
            straight(point_ahead(contact, request.direction, -request.length_mm))
        }
        KlartextApproachForm::Normal => {
            straight(point_ahead(contact, request.normal(), request.length_mm))
        }
        KlartextApproachForm::Arc => {
            let arc = request.arc()?;
            let angle = -arc.direction.sign() * request.center_angle_rad;
            let helper = turned_about(contact, arc.center, angle);
            Ok(ApproachPath { helper, contact, arc: Some(arc) })
        }
        KlartextApproachForm::LineAndArc => {
            let arc = request.arc()?;
            let helper =
                tangent_point(request.outside, &arc, request.arc_radius_mm, Leg::Arriving)?;
            Ok(ApproachPath { helper, contact, arc: Some(arc) })
        }
    }
}

/// The path of a departure (DEP).
///
/// # Errors
/// Why there is none.
pub fn departure_path(request: &ApproachRequest) -> Result<ApproachPath, ApproachFault> {
    let contact = request.contact();
    let straight = |helper| Ok(ApproachPath { helper, contact, arc: None });
    match request.form {
        KlartextApproachForm::Tangent => {
            straight(point_ahead(contact, request.direction, request.length_mm))
        }
        KlartextApproachForm::Normal => {
            straight(point_ahead(contact, request.normal(), request.length_mm))
        }
        KlartextApproachForm::Arc => {
            let arc = request.arc()?;
            let angle = arc.direction.sign() * request.center_angle_rad;
            let helper = turned_about(contact, arc.center, angle);
            Ok(ApproachPath { helper, contact, arc: Some(arc) })
        }
        KlartextApproachForm::LineAndArc => {
            let arc = request.arc()?;
            let helper = tangent_point(request.outside, &arc, request.arc_radius_mm, Leg::Leaving)?;
            Ok(ApproachPath { helper, contact, arc: Some(arc) })
        }
    }
}

/// Whether the straight leg comes before the arc or after it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Leg {
    Arriving,
    Leaving,
}

/// The point of the circle at which the line from or to a point outside goes on as the arc.
///
/// With w the direction of the line, the vector from the centre to the point of contact is w turned by a quarter against
/// the direction of the arc; so the vector between the two known points is w times a complex number, which is divided by.
fn tangent_point(
    outside: [f64; 2],
    arc: &ApproachArc,
    radius: f64,
    leg: Leg,
) -> Result<[f64; 2], ApproachFault> {
    let distance_mm = distance(outside, arc.center);
    if distance_mm < radius {
        return Err(ApproachFault::InsideArc(distance_mm, radius));
    }
    let length = (distance_mm * distance_mm - radius * radius).sqrt();
    let across = arc.direction.sign() * radius;
    let (from, to, across) = match leg {
        Leg::Arriving => (outside, arc.center, across),
        Leg::Leaving => (arc.center, outside, -across),
    };
    let [x, y] = [to[0] - from[0], to[1] - from[1]];
    let squared = distance_mm * distance_mm;
    if squared == 0.0 {
        return Err(ApproachFault::NoRadius);
    }
    let line = [(x * length + y * across) / squared, (y * length - x * across) / squared];
    Ok(match leg {
        Leg::Arriving => point_ahead(outside, line, length),
        Leg::Leaving => point_ahead(outside, line, -length),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(found: [f64; 2], expected: [f64; 2]) {
        assert!(distance(found, expected) < 1e-3, "{found:?} is not {expected:?}");
    }

    const REQUEST: ApproachRequest = ApproachRequest {
        form: KlartextApproachForm::Tangent,
        point: [5.0, 5.0],
        direction: [0.0, 1.0],
        is_left: true,
        tool_radius_mm: 10.0,
        length_mm: 10.0,
        arc_radius_mm: 5.0,
        center_angle_rad: 0.0,
        outside: [-10.0, -10.0],
    };

    #[test]
    fn straight_approaches_lie_along_the_contour_or_perpendicular_to_it() {
        let path = approach_path(&REQUEST).expect("a path");
        near(path.contact, [-5.0, 5.0]);
        near(path.helper, [-5.0, -5.0]);
        let normal = ApproachRequest { form: KlartextApproachForm::Normal, ..REQUEST };
        near(approach_path(&normal).expect("a path").helper, [-15.0, 5.0]);
        let end = ApproachRequest { direction: [-1.0, 0.0], ..REQUEST };
        let path = departure_path(&end).expect("a path");
        near(path.contact, [5.0, -5.0]);
        near(path.helper, [-5.0, -5.0]);
    }

    #[test]
    fn arcs_bulge_to_the_side_of_the_tool_or_to_the_other() {
        let request = ApproachRequest {
            form: KlartextApproachForm::Arc,
            point: [10.0, 20.0],
            direction: [1.0, 0.0],
            tool_radius_mm: 5.0,
            arc_radius_mm: 8.0,
            center_angle_rad: 90_f64.to_radians(),
            ..REQUEST
        };
        let path = approach_path(&request).expect("a path");
        near(path.contact, [10.0, 25.0]);
        near(path.arc.expect("an arc").center, [10.0, 33.0]);
        near(path.helper, [2.0, 33.0]);
        let half = ApproachRequest { center_angle_rad: 180_f64.to_radians(), ..request };
        near(approach_path(&half).expect("a path").helper, [10.0, 41.0]);
        let other = ApproachRequest { arc_radius_mm: -8.0, ..request };
        near(approach_path(&other).expect("a path").helper, [2.0, 17.0]);
    }

    #[test]
    fn lines_and_arcs_are_tangent_to_each_other() {
        let request = ApproachRequest { form: KlartextApproachForm::LineAndArc, ..REQUEST };
        let path = approach_path(&request).expect("a path");
        near(path.arc.expect("an arc").center, [-10.0, 5.0]);
        near(path.helper, [-5.286, 3.3333]);
        assert!((distance(request.outside, path.helper) - 14.1421).abs() < 1e-4);
        let end = ApproachRequest { direction: [-1.0, 0.0], outside: [-20.0, -20.0], ..request };
        let path = departure_path(&end).expect("a path");
        near(path.arc.expect("an arc").center, [5.0, -10.0]);
        near(path.helper, [2.3133, -5.7832]);
        assert!((distance(end.outside, path.helper) - 26.4575).abs() < 1e-4);
        // On the right of the contour everything is mirrored.
        let right = ApproachRequest { is_left: false, outside: [20.0, -10.0], ..request };
        near(approach_path(&right).expect("a path").helper, [15.286, 3.3333]);
        let inside = ApproachRequest { outside: [-11.0, 6.0], ..request };
        assert!(matches!(approach_path(&inside), Err(ApproachFault::InsideArc(..))));
    }
}
