//! A segment of the path: an exact curve of the tool tip with its block.

use chordal_command::{ArcShape, AxisMask, CommandKind, Move, Origin, Position, WorkName};
use chordal_geometry::{Curve, Line, Spline, Vec3, spiral_from_center};

/// The kind of a segment.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum SegmentKind {
    /// A rapid.
    Rapid,
    /// A straight cut.
    Line,
    /// An arc or a helix.
    Arc,
    /// A spiral or a cone.
    Spiral,
    /// A polynomial span of a spline.
    Spline,
}

/// Those of the axes X, Y and Z that a program does not name where it cuts. The path is drawn at their zero, which is
/// reported.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct NotNamed {
    /// The axes that it never names, as a laser program does not name Z.
    pub never: AxisMask,
    /// The axes that it names, but which are not known in any cut and do not move in any.
    pub in_no_cut: AxisMask,
}

impl NotNamed {
    /// No axes.
    pub const NONE: NotNamed = NotNamed { never: AxisMask::NONE, in_no_cut: AxisMask::NONE };

    /// The axes of both kinds.
    pub const fn all(self) -> AxisMask {
        self.never.or(self.in_no_cut)
    }

    /// The axes in either of the two values.
    pub const fn or(self, other: NotNamed) -> NotNamed {
        NotNamed {
            never: self.never.or(other.never),
            in_no_cut: self.in_no_cut.or(other.in_no_cut),
        }
    }
}

/// A zero of program coordinates whose position relative to the frame of the run is not known: because of a work offset
/// that is not given, or a preset (G92) at an unknown position. Coordinates from this zero cannot be converted to the
/// frame of the run.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct UnrelatedZero {
    /// Those of X, Y and Z along which the position is not known.
    pub axes: AxisMask,
    /// The work coordinate system of this zero.
    pub system: WorkName,
    /// The work coordinate system of the first cut.
    pub run_system: WorkName,
    /// The reason is a preset (G92) while the tool was at an unknown position, not the values of the systems.
    pub is_preset: bool,
}

/// A segment of the path: an exact curve of the tool tip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// Its kind.
    pub kind: SegmentKind,
    /// The curve in the frame of the run, mm.
    pub curve: Curve,
    /// Its length, mm.
    pub length_mm: f64,
    /// How long it takes without acceleration, s; 0 if no feed is known.
    pub duration_s: f64,
    /// Rotary axes A B C at the start, rad.
    pub rotary_from: [f64; 3],
    /// Rotary axes A B C at the end, rad.
    pub rotary_to: [f64; 3],
    /// The tool in the spindle.
    pub tool: u32,
    /// The spindle speed, 1/min, 0 while it does not turn; for a laser, its power.
    pub rpm: f64,
    /// X, Y and Z are known relative to the part at both ends.
    pub known: bool,
    /// The axes that are known relative to the part at the start.
    pub from_known: AxisMask,
    /// The axes that are known relative to the part at the end.
    pub to_known: AxisMask,
    /// The position of the tip is known: at the programmed point, or away from it by the shift that the curve includes.
    pub tip_known: bool,
    /// Set if the relation of its program coordinates to the frame of the run is not known.
    pub unrelated_zero: Option<UnrelatedZero>,
    /// Those of X, Y and Z that are drawn at zero because the program does not name them.
    pub not_named: NotNamed,
    /// The curve is that of the tip on the part (tool centre point control); otherwise that of the tip on the machine.
    pub on_part: bool,
    /// The position of its block in the program.
    pub origin: Origin,
}

impl Segment {
    /// Whether it can be drawn: both ends have a known position in the frame of the run along every axis that the program
    /// names.
    pub fn is_drawn(&self) -> bool {
        self.places().iter().all(|axes| axes.or(self.not_named.all()).covers(AxisMask::LINEAR))
    }

    /// Those of X, Y and Z whose position in the frame of the run is known, at the start and at the end.
    pub fn places(&self) -> [AxisMask; 2] {
        let lost = self.unrelated_zero.map_or(AxisMask::NONE, |zero| zero.axes);
        [self.from_known, self.to_known].map(|axes| axes.and(AxisMask::LINEAR).without(lost))
    }
}

/// X, Y and Z of a position, mm.
pub(crate) fn point(position: &Position) -> Vec3 {
    Vec3::new(position[0], position[1], position[2])
}

/// If the end radii differ by more, an arc is a spiral, mm: below the resolution of any control, above rounding.
const EQUAL_RADIUS_MM: f64 = 1e-9;

/// The exact curve of a motion command in program coordinates.
#[inline]
pub fn curve_of(motion: &Move, shape: Option<&ArcShape>) -> Curve {
    let (from, to) = (point(&motion.from), point(&motion.to));
    match shape {
        None => Curve::Line(Line { start: from, end: to }),
        Some(shape) => {
            let center = (shape.center[0], shape.center[1]);
            spiral_from_center(shape.plane, from, to, center, shape.sweep, EQUAL_RADIUS_MM).curve
        }
    }
}

/// Passes the exact curves of a motion command in program coordinates to `push`: one curve, except for a spline of
/// several polynomial spans. A spline whose order is too high for [`SplinePiece`](chordal_geometry::SplinePiece) becomes
/// the line between its ends.
pub fn curves_of(kind: &CommandKind, mut push: impl FnMut(Curve)) {
    let Some(motion) = kind.motion() else { return };
    match kind.spline().map(Spline::pieces) {
        Some(Some(pieces)) => pieces.into_iter().for_each(|piece| push(Curve::Spline(piece))),
        _ => push(curve_of(motion, kind.shape())),
    }
}

/// True if X, Y and Z are known at both ends.
pub(crate) fn is_known(motion: &Move) -> bool {
    motion.from_known.and(motion.to_known).covers(AxisMask::LINEAR)
}
