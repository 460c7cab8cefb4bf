//! What a text needs to run.

use std::sync::Arc;

use chordal::control::ConfiguredControl;
use chordal::{Machine, ReadingChoices, RunOptions};

/// What a text needs to run.
#[derive(Clone, Debug)]
pub struct EditorSetup {
    /// The machine.
    pub machine: Machine,
    /// Why this one, in a line, where the user did not say it.
    pub why: Option<String>,
    /// As what else the text may be read, where it does not name its control and its units for certain.
    pub readings: Option<ReadingChoices>,
    /// Budgets.
    pub options: RunOptions,
    /// The one program of the text to run, where only one is wanted.
    pub program: Option<u32>,
    /// Texts in which subprograms may be, by name.
    pub subprogram_texts: Vec<(String, Vec<u8>)>,
}

impl EditorSetup {
    /// A machine, and nothing else.
    pub fn of(machine: Machine) -> EditorSetup {
        let options = RunOptions::default();
        EditorSetup {
            machine,
            why: None,
            readings: None,
            options,
            program: None,
            subprogram_texts: Vec::new(),
        }
    }
}

/// A setup whose machine has only settings that its control knows.
#[derive(Debug)]
pub(crate) struct ValidSetup {
    pub setup: EditorSetup,
    pub control: Arc<dyn ConfiguredControl>,
}
