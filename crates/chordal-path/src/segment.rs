//! A segment of path: an exact curve of the tool tip with its block.

use chordal_command::{ArcShape, AxisMask, CommandKind, Move, Origin, Position, WorkName};
use chordal_geometry::{Curve, Line, Spline, Vec3, spiral_from_center};

/// What a piece of path is.
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

/// Axes of X, Y and Z that a program does not name where it cuts: it is drawn at their zero, and that is said.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct NotNamed {
    /// Those that it never names, as a laser does not name Z.
    pub never: AxisMask,
    /// Those that it names, and that are not known in any cut and move in none.
    pub in_no_cut: AxisMask,
}

impl NotNamed {
    /// None.
    pub const NONE: NotNamed = NotNamed { never: AxisMask::NONE, in_no_cut: AxisMask::NONE };

    /// All of them.
    pub const fn all(self) -> AxisMask {
        self.never.or(self.in_no_cut)
    }

    /// Those of either.
    pub const fn or(self, other: NotNamed) -> NotNamed {
        NotNamed {
            never: self.never.or(other.never),
            in_no_cut: self.in_no_cut.or(other.in_no_cut),
        }
    }
}

/// A zero of program coordinates of which nobody knows how it lies to that of the run: a work offset that is not given,
/// or a preset at an unknown place. What is programmed from there has no place in the frame of the run.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct UnrelatedZero {
    /// Those of X, Y and Z along which it is not known.
    pub axes: AxisMask,
    /// The work coordinate system.
    pub system: WorkName,
    /// That of the first cut.
    pub run_system: WorkName,
    /// The values of the systems are not the reason, but a preset (G92) where the tool was at an unknown place.
    pub is_preset: bool,
}

/// A piece of path: an exact curve of the tool tip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// What it is.
    pub kind: SegmentKind,
    /// The curve in the frame of the run, mm.
    pub curve: Curve,
    /// Its length, mm.
    pub length_mm: f64,
    /// How long it takes without acceleration, s; 0 where no feed is known.
    pub duration_s: f64,
    /// Rotary axes A B C at the start, rad.
    pub rotary_from: [f64; 3],
    /// Rotary axes A B C at the end, rad.
    pub rotary_to: [f64; 3],
    /// The tool in the spindle.
    pub tool: u32,
    /// How fast the spindle turns, 1/min, 0 while it stands; of a laser its power.
    pub rpm: f64,
    /// Both ends are known relative to the part, so that it can be drawn.
    pub known: bool,
    /// The axes that are known relative to the part at the start.
    pub from_known: AxisMask,
    /// Those that are at the end.
    pub to_known: AxisMask,
    /// The tip is at the programmed point, or as far from it as the curve says.
    pub tip_known: bool,
    /// Where its program coordinates lie in the frame of the run is not known.
    pub unrelated_zero: Option<UnrelatedZero>,
    /// Those of X, Y and Z that are taken as zero, because the program does not say them.
    pub not_named: NotNamed,
    /// The block that says so.
    pub origin: Origin,
}

impl Segment {
    /// It can be drawn: both ends have a place in the frame of the run along every axis that the program names.
    pub fn is_drawn(&self) -> bool {
        self.places().iter().all(|axes| axes.or(self.not_named.all()).covers(AxisMask::LINEAR))
    }

    /// Those of X, Y and Z whose place in the frame of the run is known, at the start and at the end.
    pub fn places(&self) -> [AxisMask; 2] {
        let lost = self.unrelated_zero.map_or(AxisMask::NONE, |zero| zero.axes);
        [self.from_known, self.to_known].map(|axes| axes.and(AxisMask::LINEAR).without(lost))
    }
}

/// X, Y and Z of a position.
pub(crate) fn point(position: &Position) -> Vec3 {
    Vec3::new(position[0], position[1], position[2])
}

/// A difference of radii below which an arc is an arc, mm: below what any control
/// computes with, above rounding.
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

/// The exact curves of a motion command in program coordinates, one after the other: one, but for a spline of
/// several polynomial spans. A spline of a higher order than [`SplinePiece`](chordal_geometry::SplinePiece)
/// takes is the line between its ends.
pub fn curves_of(kind: &CommandKind, mut push: impl FnMut(Curve)) {
    let Some(motion) = kind.motion() else { return };
    match kind.spline().map(Spline::pieces) {
        Some(Some(pieces)) => pieces.into_iter().for_each(|piece| push(Curve::Spline(piece))),
        _ => push(curve_of(motion, kind.shape())),
    }
}

/// True when X, Y and Z are known at both ends.
pub(crate) fn is_known(motion: &Move) -> bool {
    motion.from_known.and(motion.to_known).covers(AxisMask::LINEAR)
}
