//! What a text needs to run, and what may be kept from one text to the next.

use std::sync::Arc;

use chordal::control::{Control, RunOptions};
use chordal::{CheckMemory, Machine, Report};

use crate::Program;

/// What a text needs to run.
#[derive(Clone, Debug)]
pub struct Setup {
    /// The machine.
    pub machine: Machine,
    /// Why this one, in a line, where the user did not say it.
    pub why: Option<String>,
    /// Budgets.
    pub options: RunOptions,
    /// The one program of the text to run, where only one is wanted.
    pub program: Option<u32>,
    /// Texts in which subprograms may be, by name.
    pub beside: Vec<(String, Vec<u8>)>,
}

impl Setup {
    /// A machine, and nothing else.
    pub fn of(machine: Machine) -> Setup {
        let options = RunOptions::default();
        Setup { machine, why: None, options, program: None, beside: Vec::new() }
    }
}

/// A setup whose machine has only settings that its control knows.
#[derive(Debug)]
pub(crate) struct Sound {
    pub setup: Setup,
    pub control: Control,
}

/// What the check before remembers, for the next text of the same setup.
#[derive(Debug, Default)]
pub struct Checked {
    setup: Option<Arc<Sound>>,
    memory: CheckMemory,
}

impl Program {
    /// Checks the text; of one that was changed since the last check only what the change may
    /// touch is run.
    pub fn check(&self, before: &mut Checked) -> Report {
        let same = before.setup.as_ref().is_some_and(|setup| Arc::ptr_eq(setup, self.sound()));
        if !same {
            *before = Checked { setup: Some(self.sound().clone()), ..Checked::default() };
        }
        self.job().check_again(&mut before.memory)
    }
}
