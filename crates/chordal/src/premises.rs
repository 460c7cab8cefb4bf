//! What is known before the run.

use chordal_path::{NotNamed, RunFrame};

/// What is known before the run.
#[derive(Clone, Copy, Default, Debug)]
pub(crate) struct RunPremises {
    /// The frame of the run; `None` where nothing moves.
    pub run_frame: Option<RunFrame>,
    /// Those of X, Y and Z that the program does not name; `None` where the program cannot be run twice, because it
    /// asks somebody on the way.
    pub not_named: Option<NotNamed>,
}
