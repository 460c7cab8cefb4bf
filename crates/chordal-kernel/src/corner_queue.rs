//! A move that is held because its end is rounded or chamfered, and what has come after it.

use chordal_command::{CallPath, Command, CommandKind, Origin};
use chordal_diagnostics::Span;
use chordal_geometry::Plane;

use crate::frames::Frames;
use crate::modal::Modal;
use crate::state_items::{StateItem, StateValue};

/// What stands in a corner.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CornerForm {
    /// An arc that touches both moves.
    Rounding,
    /// A straight line.
    Chamfer,
    /// A straight line between the points where a rounding of this radius would touch both moves.
    ChordOfRounding,
}

/// What a block asks for at its end.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ProgrammedCorner {
    /// The word.
    pub word: Span,
    /// How the language calls it: `,R`.
    pub name: &'static str,
    /// What it asks for.
    pub form: CornerForm,
    /// Its radius, or the distance from the corner, mm.
    pub size_mm: f64,
}

/// What comes after the move that is held.
#[derive(Debug)]
#[allow(
    clippy::large_enum_variant,
    reason = "most of what waits is commands: a box would be one for each"
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
    /// Its own block is at work.
    pub is_open: bool,
    pub waiting: Vec<QueuedItem>,
    /// So many of them have been looked at.
    pub judged: usize,
    pub dwells: u32,
}

/// The corners that wait.
#[derive(Default, Debug)]
pub(crate) struct CornerQueue {
    pub request: Option<ProgrammedCorner>,
    pub queued: Option<Box<QueuedMove>>,
}

impl CornerQueue {
    /// Something waits.
    #[inline]
    pub fn wait(&self) -> bool {
        self.queued.is_some() || self.request.is_some()
    }
}
