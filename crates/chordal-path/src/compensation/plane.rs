//! Blocks in the two coordinates of the compensation plane, and their offset curves.

use chordal_command::{ArcShape, Move};
use chordal_geometry::{
    Circle2, Line2, Meeting, Plane, Vec2, circle_circle, line_circle, line_line,
};
use chordal_machine::PerAxis;

/// A line or an arc in the plane of compensation, mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum CompensationCurve {
    /// A straight line.
    Line {
        /// The start, mm.
        from: Vec2,
        /// The end, mm.
        to: Vec2,
    },
    /// An arc, or a spiral if the radii differ.
    Arc {
        /// The start, mm.
        from: Vec2,
        /// The end, mm.
        to: Vec2,
        /// The centre, mm.
        center: Vec2,
        /// The angle from start to end, rad: positive from the first axis of the plane to the second.
        sweep: f64,
        /// Radius at the start, mm.
        radius_from: f64,
        /// Radius at the end, mm.
        radius_to: f64,
    },
}

/// A length up to this counts as zero, mm: far below any least increment, far above rounding.
pub(super) const NEGLIGIBLE_MM: f64 = 1e-9;

impl CompensationCurve {
    /// The projection of a motion command onto the plane; a line if its arc is in another plane.
    pub(super) fn of(motion: &Move, shape: Option<&ArcShape>, plane: Plane) -> CompensationCurve {
        let (from, to) = (ab(&motion.from, plane), ab(&motion.to, plane));
        match shape {
            Some(shape) if shape.plane == plane => CompensationCurve::Arc {
                from,
                to,
                center: Vec2::new(shape.center[0], shape.center[1]),
                sweep: shape.sweep,
                radius_from: shape.radius_from,
                radius_to: shape.radius_to,
            },
            _ => CompensationCurve::Line { from, to },
        }
    }

    /// The start, mm.
    pub fn from(&self) -> Vec2 {
        match *self {
            CompensationCurve::Line { from, .. } | CompensationCurve::Arc { from, .. } => from,
        }
    }

    /// The end, mm.
    pub fn to(&self) -> Vec2 {
        match *self {
            CompensationCurve::Line { to, .. } | CompensationCurve::Arc { to, .. } => to,
        }
    }

    /// True for an arc.
    pub fn is_arc(&self) -> bool {
        matches!(self, CompensationCurve::Arc { .. })
    }

    /// True if it has a length.
    pub(super) fn moves(&self) -> bool {
        match *self {
            CompensationCurve::Line { from, to } => from.distance(to) > NEGLIGIBLE_MM,
            CompensationCurve::Arc { sweep, radius_from, radius_to, .. } => {
                sweep != 0.0 && radius_from.max(radius_to) > NEGLIGIBLE_MM
            }
        }
    }

    /// Unit tangents at the start and at the end; those of an arc are normal to the radius. `None` without a direction.
    pub(crate) fn tangents(&self) -> Option<(Vec2, Vec2)> {
        match *self {
            CompensationCurve::Line { from, to } => {
                let t = (to - from).normalized()?;
                Some((t, t))
            }
            CompensationCurve::Arc { from, to, center, sweep, .. } => {
                let w = sweep.signum();
                let along = |p: Vec2| Some((p - center).normalized()?.turned_left() * w);
                Some((along(from)?, along(to)?))
            }
        }
    }
}

/// The plane coordinates of a position.
pub(super) fn ab(position: &PerAxis<f64>, plane: Plane) -> Vec2 {
    let (a, b, _) = plane.axes();
    Vec2::new(position[a], position[b])
}

/// The curve of a block and its offset at one of its ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct OffsetEdge {
    pub curve: CompensationCurve,
    /// Unit tangent at the corner.
    pub tangent: Vec2,
    /// Unit normal at the corner, to the tool's side.
    pub normal: Vec2,
    /// +1: the tool is on the left; −1: on the right.
    pub sign: f64,
    /// The offset at the corner, mm.
    pub radius: f64,
}

impl OffsetEdge {
    /// An end of a curve, with the unit tangent there.
    pub fn along(curve: CompensationCurve, tangent: Vec2, sign: f64, radius: f64) -> OffsetEdge {
        OffsetEdge { curve, tangent, normal: tangent.turned_left() * sign, sign, radius }
    }

    /// The start of a curve; `None` if it has no direction there.
    pub fn start(curve: CompensationCurve, sign: f64, radius: f64) -> Option<OffsetEdge> {
        let (tangent, _) = curve.tangents()?;
        Some(OffsetEdge::along(curve, tangent, sign, radius))
    }

    /// Radius of the offset arc, mm: negative if the offset is larger than an inside radius. Infinite for a line.
    pub fn offset_radius(&self, radius: f64) -> f64 {
        match self.curve {
            CompensationCurve::Arc { sweep, .. } => {
                radius - self.sign * sweep.signum() * self.radius
            }
            CompensationCurve::Line { .. } => f64::INFINITY,
        }
    }
}

/// The intersection of the offsets of two blocks that is nearest to their corner; `end` is the end of the first block,
/// `start` the start of the second. `None` if they do not intersect within `tolerance`, mm.
pub(super) fn meeting(
    corner: Vec2,
    end: &OffsetEdge,
    start: &OffsetEdge,
    tolerance: f64,
) -> Option<Vec2> {
    let circle = |edge: &OffsetEdge, at_end: bool| match edge.curve {
        CompensationCurve::Arc { center, radius_from, radius_to, .. } => {
            let radius = if at_end { radius_to } else { radius_from };
            Some(Circle2 { center: center - corner, radius: edge.offset_radius(radius).abs() })
        }
        CompensationCurve::Line { .. } => None,
    };
    let line = |edge: &OffsetEdge, at: Vec2| Line2 {
        point: at - corner + edge.normal * edge.radius,
        direction: edge.tangent,
    };
    let first = line(end, end.curve.to());
    let second = line(start, start.curve.from());
    let found = match (circle(end, true), circle(start, false)) {
        (None, None) => line_line(first, second, 1e-9).map(|crossing| crossing.point),
        (None, Some(circle)) => nearest(line_circle(first, circle, tolerance)),
        (Some(circle), None) => nearest(line_circle(second, circle, tolerance)),
        (Some(first), Some(second)) => nearest(circle_circle(first, second, tolerance)),
    };
    found.map(|point| corner + point).filter(|p| p.a.is_finite() && p.b.is_finite())
}

fn nearest(meeting: Meeting) -> Option<Vec2> {
    meeting.nearest_to(Vec2::ZERO)
}

/// The offset curve of a block between two points of the tool centre; an arc keeps its number of turns.
pub(super) fn offset_between(
    curve: &CompensationCurve,
    sign: f64,
    radii: (f64, f64),
    from: Vec2,
    to: Vec2,
) -> CompensationCurve {
    let CompensationCurve::Arc { from: start, to: end, center, sweep, radius_from, radius_to } =
        *curve
    else {
        return CompensationCurve::Line { from, to };
    };
    let toward = sign * sweep.signum();
    let (rho_from, rho_to) = (radius_from - toward * radii.0, radius_to - toward * radii.1);
    // With a negative radius the offset point lies opposite to the programmed one.
    let arm = |p: Vec2, rho: f64| if rho < 0.0 { center - p } else { p - center };
    let turned = |programmed: Vec2, point: Vec2, rho: f64| {
        if rho.abs() <= NEGLIGIBLE_MM { 0.0 } else { angle(programmed - center, arm(point, rho)) }
    };
    let swept = sweep - turned(start, from, rho_from) + turned(end, to, rho_to);
    CompensationCurve::Arc {
        from,
        to,
        center,
        sweep: swept,
        radius_from: from.distance(center),
        radius_to: to.distance(center),
    }
}

/// Signed angle from one vector to another, rad, −π to π.
pub(super) fn angle(from: Vec2, to: Vec2) -> f64 {
    libm::atan2(from.cross(to), from.dot(to))
}
