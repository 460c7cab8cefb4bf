//! What is found out about a program before it is run.

use chordal_path::{NotNamed, RunFrame};

/// What is found out about a program before it is run.
#[derive(Clone, Copy, Default, Debug)]
pub(crate) struct RunPremises {
    /// The frame in which the run is drawn and reported; `None` where nothing moves.
    pub run_frame: Option<RunFrame>,
    /// The axes of X, Y and Z that the program does not name; `None` where the program cannot be run twice, because
    /// the caller answers it while it runs.
    pub not_named: Option<NotNamed>,
}
