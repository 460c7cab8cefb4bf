//! Checks a text, and what may be kept from one text to the next.

use std::sync::Arc;

use chordal::{CheckMemory, Report};

use crate::EditorProgram;
use crate::setup::ValidSetup;

/// What the check before remembers, for the next text of the same setup.
#[derive(Debug, Default)]
pub struct PreviousCheck {
    setup: Option<Arc<ValidSetup>>,
    memory: CheckMemory,
}

impl EditorProgram {
    /// Checks the text; of one that was changed since the last check only what the change may
    /// touch is run.
    pub fn check(&self, before: &mut PreviousCheck) -> Report {
        let same = before.setup.as_ref().is_some_and(|setup| Arc::ptr_eq(setup, self.sound()));
        if !same {
            *before =
                PreviousCheck { setup: Some(self.sound().clone()), ..PreviousCheck::default() };
        }
        self.job().check_again(&mut before.memory)
    }
}
