//! The paths of APPR and DEP, of the centre of the tool.

use chordal_geometry::{TurnDirection, Vec2};

use super::vectors::turned;
use crate::syntax::KlartextApproachForm;

/// What an approach or a departure is made of; the plane of compensation, mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ApproachRequest {
    /// Its form.
    pub form: KlartextApproachForm,
    /// The point of the contour at which it ends or begins.
    pub point: Vec2,
    /// The direction of the contour there.
    pub direction: Vec2,
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
    pub outside: Vec2,
}

/// The arc of an approach or departure.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ApproachArc {
    /// Its centre.
    pub center: Vec2,
    /// Its direction.
    pub direction: TurnDirection,
}

/// An approach or departure: the point between its two parts, and the point of the offset contour.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ApproachPath {
    /// PH, or where the arc or line of a departure ends.
    pub helper: Vec2,
    /// The point of the contour, offset by the radius of the tool.
    pub contact: Vec2,
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
    fn normal(&self) -> Vec2 {
        let left = self.direction.turned_left();
        if self.is_left { left } else { -left }
    }

    fn contact(&self) -> Vec2 {
        self.point + self.normal() * self.tool_radius_mm
    }

    /// The arc that is tangent to the contour at the offset point.
    fn arc(&self) -> Result<ApproachArc, ApproachFault> {
        let radius = self.arc_radius_mm;
        let is_wrong =
            radius == 0.0 || self.form == KlartextApproachForm::LineAndArc && radius < 0.0;
        if is_wrong {
            return Err(ApproachFault::NoRadius);
        }
        let center = self.contact() + self.normal() * radius;
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
    path_of(request, ApproachLeg::Arriving)
}

/// The path of a departure (DEP): that of an approach, the other way round.
///
/// # Errors
/// Why there is none.
pub fn departure_path(request: &ApproachRequest) -> Result<ApproachPath, ApproachFault> {
    path_of(request, ApproachLeg::Leaving)
}

fn path_of(request: &ApproachRequest, leg: ApproachLeg) -> Result<ApproachPath, ApproachFault> {
    let contact = request.contact();
    // Along the contour away from it: back before it, on after it.
    let sign = match leg {
        ApproachLeg::Arriving => -1.0,
        ApproachLeg::Leaving => 1.0,
    };
    let straight = |helper| Ok(ApproachPath { helper, contact, arc: None });
    match request.form {
        KlartextApproachForm::Tangent => {
            straight(contact + request.direction * (sign * request.length_mm))
        }
        KlartextApproachForm::Normal => straight(contact + request.normal() * request.length_mm),
        KlartextApproachForm::Arc => {
            let arc = request.arc()?;
            let angle = sign * arc.direction.sign() * request.center_angle_rad;
            let helper = turned(contact, arc.center, angle);
            Ok(ApproachPath { helper, contact, arc: Some(arc) })
        }
        KlartextApproachForm::LineAndArc => {
            let arc = request.arc()?;
            let helper = tangent_point(request.outside, &arc, request.arc_radius_mm, leg)?;
            Ok(ApproachPath { helper, contact, arc: Some(arc) })
        }
    }
}

/// Whether the straight leg comes before the arc or after it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum ApproachLeg {
    Arriving,
    Leaving,
}

/// The point of the circle at which the line from or to a point outside goes on as the arc.
///
/// With w the direction of the line, the vector from the centre to the point of contact is w turned by a quarter against
/// the direction of the arc; so the vector between the two known points is w times a complex number, which is divided by.
fn tangent_point(
    outside: Vec2,
    arc: &ApproachArc,
    radius: f64,
    leg: ApproachLeg,
) -> Result<Vec2, ApproachFault> {
    let distance_mm = outside.distance(arc.center);
    if distance_mm < radius {
        return Err(ApproachFault::InsideArc(distance_mm, radius));
    }
    let length = (distance_mm * distance_mm - radius * radius).sqrt();
    let across = arc.direction.sign() * radius;
    let (from, to, across) = match leg {
        ApproachLeg::Arriving => (outside, arc.center, across),
        ApproachLeg::Leaving => (arc.center, outside, -across),
    };
    let squared = distance_mm * distance_mm;
    if squared == 0.0 {
        return Err(ApproachFault::NoRadius);
    }
    let between = to - from;
    let line = (between * length - between.turned_left() * across) * (1.0 / squared);
    Ok(match leg {
        ApproachLeg::Arriving => outside + line * length,
        ApproachLeg::Leaving => outside - line * length,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(found: Vec2, expected: [f64; 2]) {
        assert!(found.distance(Vec2::from_array(expected)) < 1e-3, "{found:?} is not {expected:?}");
    }

    const REQUEST: ApproachRequest = ApproachRequest {
        form: KlartextApproachForm::Tangent,
        point: Vec2::new(5.0, 5.0),
        direction: Vec2::new(0.0, 1.0),
        is_left: true,
        tool_radius_mm: 10.0,
        length_mm: 10.0,
        arc_radius_mm: 5.0,
        center_angle_rad: 0.0,
        outside: Vec2::new(-10.0, -10.0),
    };

    #[test]
    fn straight_approaches_lie_along_the_contour_or_perpendicular_to_it() {
        let path = approach_path(&REQUEST).expect("a path");
        near(path.contact, [-5.0, 5.0]);
        near(path.helper, [-5.0, -5.0]);
        let normal = ApproachRequest { form: KlartextApproachForm::Normal, ..REQUEST };
        near(approach_path(&normal).expect("a path").helper, [-15.0, 5.0]);
        let end = ApproachRequest { direction: Vec2::new(-1.0, 0.0), ..REQUEST };
        let path = departure_path(&end).expect("a path");
        near(path.contact, [5.0, -5.0]);
        near(path.helper, [-5.0, -5.0]);
    }

    #[test]
    fn arcs_bulge_to_the_side_of_the_tool_or_to_the_other() {
        let request = ApproachRequest {
            form: KlartextApproachForm::Arc,
            point: Vec2::new(10.0, 20.0),
            direction: Vec2::new(1.0, 0.0),
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
        assert!((request.outside.distance(path.helper) - 14.1421).abs() < 1e-4);
        let end = ApproachRequest {
            direction: Vec2::new(-1.0, 0.0),
            outside: Vec2::new(-20.0, -20.0),
            ..request
        };
        let path = departure_path(&end).expect("a path");
        near(path.arc.expect("an arc").center, [5.0, -10.0]);
        near(path.helper, [2.3133, -5.7832]);
        assert!((end.outside.distance(path.helper) - 26.4575).abs() < 1e-4);
        // On the right of the contour everything is mirrored.
        let right = ApproachRequest { is_left: false, outside: Vec2::new(20.0, -10.0), ..request };
        near(approach_path(&right).expect("a path").helper, [15.286, 3.3333]);
        let inside = ApproachRequest { outside: Vec2::new(-11.0, 6.0), ..request };
        assert!(matches!(approach_path(&inside), Err(ApproachFault::InsideArc(..))));
    }
}
