//! The path relative to a part that rotary tables turn: the page draws the part at rest.

use chordal::Segment;
use chordal::geometry::{Curve, ParamCurve, Transform, Vec3};
use chordal::machine::{RotaryAxis, RotaryTarget, part_transform};

/// The largest rotation of the part in one drawn piece of a move, rad (2°).
const STEP_RAD: f64 = std::f64::consts::PI / 90.0;
/// The most pieces of one move.
const MAX_PIECES: u32 = 2_000;
/// The fewest pieces of an arc on a turning part, which is curved both by itself and by the rotation.
const MIN_ARC_PIECES: u32 = 64;

/// The effect of a machine's rotary axes on the path relative to the part.
#[derive(Clone, Copy, Debug)]
pub struct PartKinematics {
    rotary: [RotaryAxis; 3],
}

/// The angles of A, B and C along a move, rad; they change linearly. They are rounded to single precision, as sent to
/// the page.
#[derive(Clone, Copy, Debug)]
pub struct AngleRange {
    from: [f64; 3],
    to: [f64; 3],
}

impl AngleRange {
    /// The angles along a segment.
    pub fn of(segment: &Segment) -> AngleRange {
        let single = |angles: [f64; 3]| angles.map(|angle| f64::from(angle as f32));
        AngleRange { from: single(segment.rotary_from), to: single(segment.rotary_to) }
    }

    fn at(self, share: f64) -> [f64; 3] {
        [0, 1, 2].map(|axis| self.from[axis] + (self.to[axis] - self.from[axis]) * share)
    }

    /// Whether all axes are at zero.
    pub fn is_zero(self) -> bool {
        self.from == [0.0; 3] && self.to == [0.0; 3]
    }
}

impl PartKinematics {
    /// The rotary axes of a machine; `None` when it is unknown what they turn.
    pub fn of(rotary: &[RotaryAxis; 3]) -> Option<PartKinematics> {
        let is_known = rotary.iter().any(|own| own.turns.is_some());
        is_known.then_some(PartKinematics { rotary: *rotary })
    }

    /// The transformation from program coordinates to part coordinates at these angles, rad.
    pub fn at(&self, angles: [f64; 3]) -> Transform {
        part_transform(&self.rotary, angles)
    }

    /// The transformation from program coordinates to part coordinates at a fraction of a move.
    pub fn along(&self, angles: AngleRange, share: f64) -> Transform {
        self.at(angles.at(share))
    }

    /// The number of pieces in which a move is drawn: one when no axis that carries the part turns.
    pub fn pieces(&self, angles: AngleRange) -> u32 {
        let turned = (0..3)
            .filter(|axis| self.rotary[*axis].turns == Some(RotaryTarget::Table))
            .map(|axis| (angles.to[axis] - angles.from[axis]).abs())
            .fold(0.0, f64::max);
        // NaN gives one piece as well.
        let pieces = (turned / STEP_RAD).ceil();
        if pieces > 1.0 { pieces.min(f64::from(MAX_PIECES)) as u32 } else { 1 }
    }

    /// Calls `push` with points of a line or an arc on the turning part, at equal fractions of the move; not at all
    /// when it remains a line or an arc.
    pub fn curve(&self, curve: &Curve, angles: AngleRange, mut push: impl FnMut(Vec3)) {
        let pieces = match (self.pieces(angles), curve) {
            (1, _) | (_, Curve::Spline(_)) => return,
            (pieces, Curve::Line(_)) => pieces,
            (pieces, Curve::Arc(_) | Curve::Spiral(_)) => pieces.max(MIN_ARC_PIECES),
        };
        for step in 0..=pieces {
            let share = f64::from(step) / f64::from(pieces);
            push(self.along(angles, share).apply_point(point_at_share(curve, share)));
        }
    }
}

/// The point at a fraction of a move; for arcs and spirals, a fraction of the angle.
fn point_at_share(curve: &Curve, share: f64) -> Vec3 {
    match curve {
        Curve::Spiral(spiral) if share > 0.0 && share < 1.0 => {
            let radius = spiral.radius_start + (spiral.radius_end - spiral.radius_start) * share;
            let turn = Transform::rotation_about(Vec3::ZERO, spiral.w, spiral.sweep * share);
            let arm = turn.apply_vector(spiral.u * radius);
            spiral.center + arm + spiral.w * (spiral.rise * share)
        }
        _ => curve.point_at(curve.length() * share),
    }
}

#[cfg(test)]
mod tests {
    use chordal::geometry::{Arc, Line};

    use super::*;

    fn table_a() -> PartKinematics {
        let table = RotaryAxis { turns: Some(RotaryTarget::Table), ..RotaryAxis::default() };
        PartKinematics { rotary: [table, RotaryAxis::default(), RotaryAxis::default()] }
    }

    fn turning(from: f64, to: f64) -> AngleRange {
        AngleRange { from: [from, 0.0, 0.0], to: [to, 0.0, 0.0] }
    }

    fn points(curve: &Curve, angles: AngleRange) -> Vec<Vec3> {
        let mut points = Vec::new();
        table_a().curve(curve, angles, |point| points.push(point));
        points
    }

    #[test]
    fn a_move_that_turns_is_a_helix_on_the_part() {
        let line =
            Curve::Line(Line { start: Vec3::new(0.0, 0.0, 10.0), end: Vec3::new(8.0, 0.0, 10.0) });
        let points = points(&line, turning(0.0, std::f64::consts::PI));
        assert_eq!(points.len(), 91);
        for (step, point) in points.iter().enumerate() {
            assert!((point.y.hypot(point.z) - 10.0).abs() < 1e-9, "{point:?}");
            assert!((point.x - 8.0 * step as f64 / 90.0).abs() < 1e-9, "{point:?}");
        }
        assert!((points[45] - Vec3::new(4.0, -10.0, 0.0)).length() < 1e-9);
        assert!((points[90] - Vec3::new(8.0, 0.0, -10.0)).length() < 1e-9);
    }

    #[test]
    fn a_part_that_does_not_turn_bends_nothing() {
        let line = Curve::Line(Line { start: Vec3::ZERO, end: Vec3::X });
        assert_eq!(points(&line, turning(1.0, 1.0)), []);
        assert!(PartKinematics::of(&[RotaryAxis::default(); 3]).is_none());
    }

    #[test]
    fn an_arc_that_turns_has_at_least_64_pieces() {
        let arc = Arc::through(Vec3::X, Vec3::Y, Vec3::X * -1.0).expect("three points of a circle");
        let points = points(&Curve::Arc(arc), turning(0.0, 0.1));
        assert_eq!(points.len(), 65);
        assert!((points[32].length() - 1.0).abs() < 1e-9);
    }
}
