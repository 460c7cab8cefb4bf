//! Canonical commands: what a block makes the machine do, in one form for all controls.

use std::sync::Arc;

use chordal_diagnostics::TextRange;
use chordal_geometry::{Plane, Spline};

use crate::axes::{AxisMask, Position};
use crate::effect::Effect;
use crate::mode::{CompensationSide, Coolant, Overrides, PathMode, SpindleState};
use crate::motion::{ArcShape, Feed, FeedMode, Move, RapidPath};
use crate::origin::Origin;
use crate::part_frame::PartFrame;
use crate::surface::RotarySurface;
use crate::units::Units;
use crate::work_name::WorkName;
use crate::work_zero::WorkZero;

/// What a command does.
#[derive(Clone, Debug, PartialEq)]
pub enum CommandKind {
    /// A move at rapid speed.
    Rapid {
        /// Start and end.
        motion: Move,
        /// Straight, or each axis at its own speed.
        path: RapidPath,
    },
    /// A straight cut.
    Line {
        /// Start and end.
        motion: Move,
        /// The feed.
        feed: Feed,
    },
    /// An arc or a helix.
    Arc {
        /// Start and end.
        motion: Move,
        /// Centre, direction and radii.
        shape: ArcShape,
        /// The feed.
        feed: Feed,
    },
    /// A spiral or a cone that the program asked for.
    Spiral {
        /// Start and end.
        motion: Move,
        /// Centre, direction and radii.
        shape: ArcShape,
        /// The feed.
        feed: Feed,
    },
    /// A spline.
    Spline {
        /// Start and end of the curve.
        motion: Move,
        /// The curve of X, Y and Z in program coordinates, mm.
        curve: Arc<Spline>,
        /// The feed.
        feed: Feed,
    },
    /// The machine waits.
    Dwell {
        /// How long, s.
        seconds: f64,
        /// What it waits for, if that is a custom code of the machine file; otherwise `None`.
        label: Option<Arc<str>>,
    },
    /// A tool is put into the spindle.
    Tool {
        /// The number of the tool.
        number: u32,
    },
    /// The tool in the spindle gets another number; the machine does nothing.
    ToolNumber {
        /// The number of the tool.
        number: u32,
    },
    /// A tool is brought into position for the next tool change.
    ToolSelect {
        /// The number of the tool.
        number: u32,
    },
    /// A tool length offset becomes active, or is cancelled.
    ToolLength {
        /// Number of the offset; `None` when lengths are cancelled.
        number: Option<u32>,
        /// What is added to Z, mm; `None` when the table has no value.
        length_mm: Option<f64>,
        /// The offset is subtracted (G44).
        is_subtracted: bool,
        /// What is added on every axis, the length with it, mm and rad; zero where the table has no value.
        offset: Position,
        /// The axes for which the offset from program to machine coordinates is known now.
        known: AxisMask,
    },
    /// Cutter compensation is switched on or off.
    Compensation {
        /// The side.
        side: CompensationSide,
        /// Number of the offset; `None` where the block has none.
        number: Option<u32>,
        /// Radius of the offset, mm; negative for the other side, `None` where the table has no value.
        radius_mm: Option<f64>,
        /// The vector on the axes of the plane that I, J and K give in the block of G40, G41 or G42, mm; `None` where
        /// they are not written.
        toward: Option<[f64; 2]>,
        /// The vector from the centre of the tool to the programmed point on the axes of the plane, in tool radii: for a
        /// turning tool the imaginary tip, for a mill zero.
        tip: [f64; 2],
    },
    /// The outside corner at the end of this block's move is rounded, or that of the move before if this block has none
    /// (G39).
    CornerArc {
        /// Direction of the next block on the axes of the plane; `None` where the block does not give it.
        toward: Option<[f64; 2]>,
    },
    /// From here on the outside corners of compensation end where the offset paths meet, or they are arcs.
    CornerMode {
        /// They meet as far as the control lets them.
        meets: bool,
        /// Inside corners are open: the tool goes past the corner to the end of its element, and from there to the start
        /// of the next (HEIDENHAIN M98).
        opens: bool,
    },
    /// A block without motion, emitted while compensation is on: controls limit how many may follow each other.
    Idle,
    /// The spindle starts, stops or changes its speed.
    Spindle {
        /// What it does.
        state: SpindleState,
        /// Its speed, rev/min.
        rpm: f64,
    },
    /// Coolant valves change.
    Coolant(Coolant),
    /// The program waits for the operator.
    Stop {
        /// Whether the program waits only when the optional stop switch is on.
        optional: bool,
    },
    /// The program ends.
    End,
    /// Units change.
    Units(Units),
    /// The plane changes.
    Plane(Plane),
    /// The feed mode changes.
    FeedMode(FeedMode),
    /// F changes.
    FeedRate {
        /// The feed in the unit of the mode: mm/s, 1/s or mm per revolution.
        value: f64,
        /// The feed mode.
        mode: FeedMode,
    },
    /// The path mode changes.
    PathMode(PathMode),
    /// Overrides are enabled or disabled (M48, M49, tapping).
    Overrides(Overrides),
    /// The offset from program to machine coordinates changes.
    WorkOffset {
        /// Name of the active work coordinate system (`G54`, `E1`).
        name: WorkName,
        /// What is added to program coordinates to get machine coordinates, without tool
        /// length, mm and rad.
        offset: Position,
        /// Which part of it comes from the work coordinate system, and which from shifts and presets.
        zero: WorkZero,
        /// The rotation of the work coordinate system about its zero (G10 L2 R), degrees. Positions of moves have it
        /// applied already.
        turned: f64,
        /// The axes for which the offset to machine coordinates, tool length included, is known.
        known: AxisMask,
        /// The tool tip in the new program coordinates.
        position: Position,
    },
    /// From here on two coordinates are those of a surface that turns with a rotary axis (G12.1, G7.1), or those of the
    /// axes again.
    Surface {
        /// The surface; `None` where it ends.
        surface: Option<RotarySurface>,
        /// The tool tip in the new coordinates.
        position: Position,
    },
    /// From here on coordinates are those of the tip in a frame that is fixed to the part (G43.4, G234, TRAORI; G68.2), or
    /// those of the axes again.
    PartFrame {
        /// The frame; `None` where it ends.
        frame: Option<Arc<PartFrame>>,
        /// The tool tip in the new coordinates.
        position: Position,
    },
    /// The probe or skip move before this command has ended.
    Probed {
        /// Whether the probe touched something.
        hit: bool,
    },
    /// Text for the operator.
    Message(TextRange),
    /// A line that the program prints (DPRNT), with its values.
    Output {
        /// The text of the line without a line end.
        text: String,
    },
    /// Another effect without motion.
    Effect(Arc<Effect>),
}

/// A command and the block that it comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct Command {
    /// What is done.
    pub kind: CommandKind,
    /// The block that it comes from.
    pub origin: Origin,
}

impl CommandKind {
    /// The move; `None` if the command is none.
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

    /// Whether the path ignores it: it only matters when two programs are compared.
    #[inline]
    pub fn is_effect(&self) -> bool {
        matches!(self, CommandKind::Effect(_))
    }

    /// The feed; `None` if the command is no cut.
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

    /// Whether rotary axes alone move: see [`Move::only_turns`].
    #[inline]
    pub fn only_turns(&self) -> bool {
        self.motion().is_some_and(|motion| motion.only_turns(self.shape()))
    }

    /// The spline; `None` if the command is none.
    #[inline]
    pub fn spline(&self) -> Option<&Spline> {
        match self {
            CommandKind::Spline { curve, .. } => Some(curve),
            _ => None,
        }
    }

    /// The arc; `None` if the command is none.
    #[inline]
    pub fn shape(&self) -> Option<&ArcShape> {
        match self {
            CommandKind::Arc { shape, .. } | CommandKind::Spiral { shape, .. } => Some(shape),
            _ => None,
        }
    }
}
