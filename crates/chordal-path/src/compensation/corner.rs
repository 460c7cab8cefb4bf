//! The path of the tool centre at a corner of the contour.

use std::f64::consts::TAU;

use chordal_geometry::Vec2;

use super::plane::{CompensationCurve, NEGLIGIBLE_MM, OffsetEdge, meeting};

/// The path of the tool centre at a corner: points joined by straight links, or an arc between two points.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct CornerPath {
    points: [Vec2; 4],
    count: usize,
    /// If the first and the last point are joined by an arc: its centre, mm, and its sweep, rad.
    pub arc: Option<(Vec2, f64)>,
    /// The offset curves do not intersect.
    pub missed: bool,
    /// It is an inside corner: the offset blocks are shorter.
    pub inside: bool,
    /// It is an open inside corner: the contour ends there, and another begins.
    pub open: bool,
}

impl CornerPath {
    pub fn at(point: Vec2) -> CornerPath {
        let mut corner = CornerPath::default();
        corner.push(point);
        corner
    }

    pub fn of(points: &[Vec2]) -> CornerPath {
        let mut corner = CornerPath::default();
        points.iter().for_each(|point| corner.push(*point));
        corner
    }

    fn push(&mut self, point: Vec2) {
        let again = self.count > 0 && self.points[self.count - 1].distance(point) <= NEGLIGIBLE_MM;
        if !again && self.count < self.points.len() {
            self.points[self.count] = point;
            self.count += 1;
        }
    }

    pub fn points(&self) -> &[Vec2] {
        &self.points[..self.count]
    }

    /// Where the offset block before the corner ends.
    pub fn first(&self) -> Vec2 {
        self.points[0]
    }

    /// Where the offset block after the corner begins.
    pub fn last(&self) -> Vec2 {
        self.points[self.count.max(1) - 1]
    }

    /// Removes the last point; does nothing and returns false if it is the only one.
    pub fn drop_last(&mut self) -> bool {
        let may = self.count > 1;
        self.count -= usize::from(may);
        may
    }

    /// Removes the first point; does nothing and returns false if it is the only one.
    pub fn drop_first(&mut self) -> bool {
        let may = self.count > 1;
        if may {
            self.points.rotate_left(1);
            self.count -= 1;
        }
        may
    }

    /// Removes the later of two points that are at most `limit` apart along both axes, mm.
    pub fn drop_short_links(&mut self, limit: f64) {
        let mut kept = 1;
        for index in 1..self.count {
            let between = self.points[index] - self.points[kept - 1];
            if between.a.abs() > limit || between.b.abs() > limit {
                self.points[kept] = self.points[index];
                kept += 1;
            }
        }
        self.count = kept.min(self.count);
    }
}

/// An angle of the program is a little more or less than what it is meant to be.
const ANGLE_ROUNDING_RAD: f64 = 1e-9;

/// The rules of the control that a corner needs.
#[derive(Clone, Copy, Debug)]
pub(super) struct CornerRuleSet {
    pub tangent_mm: f64,
    /// Sine of the largest turn that is treated as tangent.
    pub tangent_sine: f64,
    pub round: bool,
    /// The largest change of direction at which an outside corner ends where the offset paths meet, rad; `None` where
    /// the control has no such choice.
    pub meets_rad: Option<f64>,
    /// An inside corner is open: the tool goes to the end of its element, and from there to the start of the next.
    pub opens: bool,
    /// A path that reverses into or out of an arc, with the tool outside of it, has an inside corner there.
    pub cusps_meet: bool,
}

/// The corner between two blocks of the contour with the tool on the same side.
pub(super) fn corner(
    at: Vec2,
    end: &OffsetEdge,
    start: &OffsetEdge,
    rules: &CornerRuleSet,
) -> CornerPath {
    let r = end.radius;
    let (n1, n2, t1, t2) = (end.normal, start.normal, end.tangent, start.tangent);
    let turn = t1.cross(t2);
    let ahead = t1.dot(t2);
    if ahead > 0.0 && rules.tangent_sine > 0.0 && turn.abs() < rules.tangent_sine {
        return CornerPath::at(at + n1 * r);
    }
    if ahead > 0.0
        && (n1 - n2).length() * r <= rules.tangent_mm
        && let Some(middle) = (n1 + n2).normalized()
    {
        return CornerPath::at(at + middle * r);
    }
    // An exact reversal is the sharpest outside corner; with `cusps_meet`, so is one that turns slightly further.
    let largest = if rules.cusps_meet { rules.tangent_sine.max(1e-9) } else { 1e-9 };
    let reversal = ahead < 0.0 && turn.abs() < largest;
    // The arc that follows decides; if a line follows, the arc that ends there.
    let decides = if start.curve.is_arc() { start } else { end };
    let cusp = rules.cusps_meet
        && ahead < 0.0
        && turn.abs() < rules.tangent_sine
        && matches!(decides.curve, CompensationCurve::Arc { sweep, .. } if decides.sign * sweep < 0.0);
    let inside = end.sign * turn > 0.0 && !reversal || cusp;
    if inside && rules.opens {
        return CornerPath { open: true, ..CornerPath::of(&[at + n1 * r, at + n2 * r]) };
    }
    if inside {
        let mut corner = match meeting(at, end, start, rules.tangent_mm) {
            Some(point) => CornerPath::at(point),
            None => CornerPath { missed: true, ..CornerPath::of(&[at + n1 * r, at + n2 * r]) },
        };
        corner.inside = true;
        return corner;
    }
    let change_rad = libm::atan2(turn.abs(), ahead);
    if rules.meets_rad.is_some_and(|most| change_rad <= most + ANGLE_ROUNDING_RAD)
        && let Some(point) = meeting(at, end, start, rules.tangent_mm)
    {
        return CornerPath::at(point);
    }
    if rules.round {
        let mut corner = CornerPath::of(&[at + n1 * r, at + n2 * r]);
        let least = super::plane::angle(n1, n2).abs();
        let swept = if end.sign * turn > 1e-9 { TAU - least } else { least } * -end.sign;
        corner.arc = (corner.count > 1).then_some((at, swept));
        return corner;
    }
    outside(at, end, start, ahead)
}

/// An outside corner with straight links; arcs are extended by their tangents.
pub(super) fn outside(at: Vec2, end: &OffsetEdge, start: &OffsetEdge, ahead: f64) -> CornerPath {
    let r = end.radius;
    let (n1, n2, t1, t2) = (end.normal, start.normal, end.tangent, start.tangent);
    let mut corner = CornerPath::default();
    if end.curve.is_arc() {
        corner.push(at + n1 * r);
    }
    if ahead >= 0.0 {
        corner.push(at + (n1 + n2) * (r / (1.0 + n1.dot(n2))));
    } else {
        corner.push(at + (n1 + t1) * r);
        corner.push(at + (n2 - t2) * r);
    }
    if start.curve.is_arc() {
        corner.push(at + n2 * r);
    }
    corner
}

/// A corner with G39: an outside corner gets an arc about the programmed point.
pub(super) fn rounded(
    at: Vec2,
    end: &OffsetEdge,
    start: &OffsetEdge,
    rules: &CornerRuleSet,
) -> CornerPath {
    corner(at, end, start, &CornerRuleSet { round: true, meets_rad: None, ..*rules })
}
