//! Roundings and chamfers between two elements of an outline.

use core::f64::consts::TAU;

use chordal_geometry::{Circle2, Line2, Vec2, circle_circle, line_circle, line_line};

use super::outline::{COINCIDENT_POINT_MM, OutlineElement};

/// Two elements whose directions differ by less than this, as the sine of the angle, have no corner.
const TANGENT: f64 = 1e-9;

/// The line or circle of an element, without ends.
enum Endless {
    Line(Line2),
    Circle(Circle2),
}

fn endless(element: &OutlineElement) -> Endless {
    match *element {
        OutlineElement::Line { from, to } => {
            Endless::Line(Line2 { point: from, direction: to - from })
        }
        OutlineElement::Arc { center, .. } => {
            Endless::Circle(Circle2 { center, radius: element.radius() })
        }
    }
}

fn meetings(first: &Endless, second: &Endless) -> Vec<Vec2> {
    match (first, second) {
        (Endless::Line(a), Endless::Line(b)) => {
            line_line(*a, *b, 1e-12).map(|found| found.point).into_iter().collect()
        }
        (Endless::Line(line), Endless::Circle(circle))
        | (Endless::Circle(circle), Endless::Line(line)) => {
            line_circle(*line, *circle, COINCIDENT_POINT_MM).points().collect()
        }
        (Endless::Circle(a), Endless::Circle(b)) => {
            circle_circle(*a, *b, COINCIDENT_POINT_MM).points().collect()
        }
    }
}

/// The fraction of an element where a circle about a point touches it.
fn foot(element: &OutlineElement, center: Vec2) -> Option<f64> {
    element.fraction(center, COINCIDENT_POINT_MM)
}

/// Two elements that meet, with a rounding of a radius (mm) between them; `None` where it does not fit or where there is
/// no corner.
pub fn rounded(
    first: &OutlineElement,
    second: &OutlineElement,
    radius: f64,
) -> Option<[OutlineElement; 3]> {
    let corner = first.to();
    let turn = first.direction(1.0)?.cross(second.direction(0.0)?);
    if turn.abs() < TANGENT {
        return None;
    }
    let side = turn.signum() * radius;
    let [a, b] = [first.moved_left(side)?, second.moved_left(side)?];
    let centers = meetings(&endless(&a), &endless(&b)).into_iter();
    let fits = centers.filter_map(|center| {
        let (t, s) = (foot(first, center)?, foot(second, center)?);
        let [p, q] = [first.point(t), second.point(s)];
        let touches = |point: Vec2| (point.distance(center) - radius).abs() < 1e-6;
        (touches(p) && touches(q)).then_some((center, t, s))
    });
    let nearest = |found: &(Vec2, f64, f64)| found.0.distance(corner);
    let (center, t, s) = fits.min_by(|a, b| nearest(a).total_cmp(&nearest(b)))?;
    let (from, to) = (first.point(t), second.point(s));
    let (u, v) = (from - center, to - center);
    let angle = libm::atan2(u.cross(v), u.dot(v));
    let sweep = if angle * side < 0.0 { angle + TAU * side.signum() } else { angle };
    let arc = OutlineElement::Arc { from, to, center, sweep };
    Some([first.part(0.0, t), arc, second.part(s, 1.0)])
}

/// Two lines that meet, with a chamfer that takes a length (mm) of each; `None` where it does not fit.
pub fn chamfered(
    first: &OutlineElement,
    second: &OutlineElement,
    leg: f64,
) -> Option<[OutlineElement; 3]> {
    let are_lines = [first, second].iter().all(|own| matches!(own, OutlineElement::Line { .. }));
    let fits = leg < first.length() && leg < second.length();
    if !are_lines || !fits {
        return None;
    }
    let (t, s) = (1.0 - leg / first.length(), leg / second.length());
    let across = OutlineElement::Line { from: first.point(t), to: second.point(s) };
    Some([first.part(0.0, t), across, second.part(s, 1.0)])
}
