//! A move that waits because its end is rounded or chamfered, and what came after it.

use chordal_command::{CallPath, Command, CommandKind, Origin};
use chordal_diagnostics::Span;
use chordal_geometry::Plane;

use crate::frames::Frames;
use crate::modal::Modal;
use crate::state_items::{StateItem, StateValue};

/// The shape that replaces a corner.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CornerForm {
    /// An arc that touches both moves.
    Rounding,
    /// A straight line whose ends are at the size from the corner.
    Chamfer,
    /// A straight line of this length, with both ends equally far from the corner (Sinumerik CHF).
    ChamferOfLength,
    /// A straight line between the points where a rounding of this radius would touch both moves.
    ChordOfRounding,
}

/// The rounding or chamfer that a block requests at its end.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ProgrammedCorner {
    /// The word.
    pub word: Span,
    /// Its spelling in the language: `,R`.
    pub name: &'static str,
    /// Rounding or chamfer.
    pub form: CornerForm,
    /// The radius of a rounding, or the distance of a chamfer from the corner, mm.
    pub size_mm: f64,
    /// The block of its own in which the corner is programmed; `None` where it is a word of the move before it.
    pub block: Option<Origin>,
    /// The feed of the corner alone, in the unit of the feed mode; `None` for that of the move before it.
    pub feed: Option<f64>,
}

/// What came after the waiting move.
#[derive(Debug)]
#[allow(
    clippy::large_enum_variant,
    reason = "most items are commands: boxing would allocate for each of them"
)]
pub(crate) enum QueuedItem {
    Command(Command),
    BlockDone(Origin, Box<(Modal, Vec<(StateItem, StateValue)>)>),
}

/// A move that waits for the next one.
#[derive(Debug)]
pub(crate) struct QueuedMove {
    pub corner: ProgrammedCorner,
    pub kind: CommandKind,
    pub origin: Origin,
    pub call: CallPath,
    pub block_number: Option<f64>,
    pub plane: Plane,
    pub frames: Frames,
    /// The block of this move is not yet complete.
    pub is_open: bool,
    pub waiting: Vec<QueuedItem>,
    /// How many of `waiting` have been checked.
    pub checked: usize,
    pub dwells: u32,
}

/// The requested corner of the current block, and the move that waits for its corner.
#[derive(Default, Debug)]
pub(crate) struct CornerQueue {
    pub request: Option<ProgrammedCorner>,
    pub queued: Option<Box<QueuedMove>>,
}

impl CornerQueue {
    /// True when a move waits, or the current one will.
    #[inline]
    pub fn wait(&self) -> bool {
        self.queued.is_some() || self.request.is_some()
    }
}
