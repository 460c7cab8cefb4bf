//! Canonical commands: what a block means, with the control's own peculiarities resolved.

use std::sync::Arc;

use chordal_diagnostics::TextRange;
use chordal_geometry::{Plane, Spline};

use crate::axes::{AxisMask, Position};
use crate::effect::Effect;
use crate::mode::{CompensationSide, Coolant, Overrides, PathMode, SpindleState};
use crate::motion::{ArcShape, Feed, FeedMode, Move, RapidPath};
use crate::origin::Origin;
use crate::surface::RotarySurface;
use crate::units::Units;
use crate::work_name::WorkName;
use crate::work_zero::WorkZero;

/// What a command does.
#[derive(Clone, Debug, PartialEq)]
pub enum CommandKind {
    /// A move at rapid speed.
    Rapid {
        /// From where to where.
        motion: Move,
        /// Straight, or each axis at its own speed.
        path: RapidPath,
    },
    /// A straight cut.
    Line {
        /// From where to where.
        motion: Move,
        /// At what feed.
        feed: Feed,
    },
    /// An arc or a helix.
    Arc {
        /// From where to where.
        motion: Move,
        /// Centre, direction and radii.
        shape: ArcShape,
        /// At what feed.
        feed: Feed,
    },
    /// A spiral or a cone that the program asked for.
    Spiral {
        /// From where to where.
        motion: Move,
        /// Centre, direction and radii.
        shape: ArcShape,
        /// At what feed.
        feed: Feed,
    },
    /// A spline.
    Spline {
        /// From where to where: the ends of the curve.
        motion: Move,
        /// The curve of X, Y and Z in program coordinates, mm.
        curve: Arc<Spline>,
        /// At what feed.
        feed: Feed,
    },
    /// Waiting.
    Dwell {
        /// For how long.
        seconds: f64,
        /// For what, where it is a code of the shop's own.
        label: Option<Arc<str>>,
    },
    /// A tool goes into the spindle.
    Tool {
        /// Its number.
        number: u32,
    },
    /// The tool in the spindle has this number from here on; nothing is changed at the machine.
    ToolNumber {
        /// Its number.
        number: u32,
    },
    /// A tool is made ready.
    ToolSelect {
        /// Its number.
        number: u32,
    },
    /// A tool length offset comes into force.
    ToolLength {
        /// Number of the offset; `None` when lengths are cancelled.
        number: Option<u32>,
        /// What is added to Z, mm; `None` when the table has no value.
        length_mm: Option<f64>,
        /// The offset is subtracted (G44).
        is_subtracted: bool,
        /// What is added on every axis, the length with it, mm and rad; zero where the table has no value.
        offset: Position,
        /// The axes whose way from program to machine coordinates is known now.
        known: AxisMask,
    },
    /// Compensation goes on or off.
    Compensation {
        /// The side.
        side: CompensationSide,
        /// Number of the offset.
        number: Option<u32>,
        /// Radius of the offset, mm, where the table has one; negative for the other side.
        radius_mm: Option<f64>,
        /// Direction on the axes of the plane that I J K give beside G40, G41 or G42, mm.
        toward: Option<[f64; 2]>,
        /// The programmed point as seen from the centre of the tool, on the axes of the plane and in radii: the
        /// imaginary tip of a turning tool. Zero for a mill.
        tip: [f64; 2],
    },
    /// The outside corner at the end of this block's move, or without one of the block
    /// before, is rounded (G39).
    CornerArc {
        /// Direction of the next block on the axes of the plane, where the block gives it.
        toward: Option<[f64; 2]>,
    },
    /// A block that moves nothing, told while compensation is on: controls count them.
    Idle,
    /// The spindle.
    Spindle {
        /// What it does.
        state: SpindleState,
        /// Its speed.
        rpm: f64,
    },
    /// Coolant valves change.
    Coolant(Coolant),
    /// The program waits for the operator.
    Stop {
        /// Only when the optional stop switch is on.
        optional: bool,
    },
    /// The program ends.
    End,
    /// Units change.
    Units(Units),
    /// The plane changes.
    Plane(Plane),
    /// What F counts changes.
    FeedMode(FeedMode),
    /// F changes: value in the unit of the mode.
    FeedRate {
        /// mm/s, 1/s or mm per revolution.
        value: f64,
        /// What it counts.
        mode: FeedMode,
    },
    /// How corners are passed.
    PathMode(PathMode),
    /// The overrides that act change (M48, M49, tapping).
    Overrides(Overrides),
    /// The program coordinates move against the machine.
    WorkOffset {
        /// Name of the active work coordinate system (`G54`, `E1`).
        name: WorkName,
        /// What is added to program coordinates to get machine coordinates, without tool
        /// length, mm and rad.
        offset: Position,
        /// What of it the work coordinate system gives, and what shifts and presets.
        zero: WorkZero,
        /// How far the work coordinate system is turned about its zero (G10 L2 R), degrees: moves are those after it.
        turned: f64,
        /// The axes whose way to machine coordinates, tool length included, is known.
        known: AxisMask,
        /// The tool tip in the new program coordinates.
        position: Position,
    },
    /// Two coordinates lie on a surface that turns with a rotary axis from here on (G12.1, G7.1), or no longer.
    Surface {
        /// The surface; `None` where it ends.
        surface: Option<RotarySurface>,
        /// The tool tip in the coordinates that moves have now.
        position: Position,
    },
    /// The move before was a probe or skip move, and has ended.
    Probed {
        /// Something was touched.
        hit: bool,
    },
    /// Text for the operator.
    Message(TextRange),
    /// A line that the program prints (DPRNT), its values put in.
    Output {
        /// The line without its end.
        text: String,
    },
    /// Something else that moves nothing.
    Effect(Arc<Effect>),
}

/// A command and the block it comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct Command {
    /// What is done.
    pub kind: CommandKind,
    /// Which block says so.
    pub origin: Origin,
}

impl CommandKind {
    /// The move, where the command is one.
    #[inline]
    pub fn motion(&self) -> Option<&Move> {
        match self {
            CommandKind::Rapid { motion, .. }
            | CommandKind::Line { motion, .. }
            | CommandKind::Arc { motion, .. }
            | CommandKind::Spiral { motion, .. }
            | CommandKind::Spline { motion, .. } => Some(motion),
            _ => None,
        }
    }

    /// It moves nothing, and no rule of the path knows it: it is for who compares two programs.
    #[inline]
    pub fn is_effect(&self) -> bool {
        matches!(self, CommandKind::Effect(_))
    }

    /// The feed, where the command cuts.
    #[inline]
    pub fn feed(&self) -> Option<&Feed> {
        match self {
            CommandKind::Line { feed, .. }
            | CommandKind::Arc { feed, .. }
            | CommandKind::Spiral { feed, .. }
            | CommandKind::Spline { feed, .. } => Some(feed),
            _ => None,
        }
    }

    /// See [`Move::only_turns`].
    #[inline]
    pub fn only_turns(&self) -> bool {
        self.motion().is_some_and(|motion| motion.only_turns(self.shape()))
    }

    /// The spline, where the command is one.
    #[inline]
    pub fn spline(&self) -> Option<&Spline> {
        match self {
            CommandKind::Spline { curve, .. } => Some(curve),
            _ => None,
        }
    }

    /// The arc, where the command is one.
    #[inline]
    pub fn shape(&self) -> Option<&ArcShape> {
        match self {
            CommandKind::Arc { shape, .. } | CommandKind::Spiral { shape, .. } => Some(shape),
            _ => None,
        }
    }
}
