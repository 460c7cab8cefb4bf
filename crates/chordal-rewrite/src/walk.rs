//! A run of a job, block by block.

use chordal::control::{Action, AfterBlock, CallPath, Control, Modal, Origin, ReadingCode};
use chordal::{Command, Diagnostic, Job, Outcome, RunSink, Sink};

use crate::source::SourceBlocks;

/// A block that has been carried out.
pub(crate) struct WalkedBlock<'v> {
    pub origin: &'v Origin,
    /// What it has done, and what was reported in it.
    pub output: &'v BlockOutput,
    /// How many blocks were carried out before it.
    pub ran: u64,
    pub after: &'v AfterBlock<'v>,
}

/// What a run gives between the ends of two blocks.
#[derive(Debug, Default)]
pub(crate) struct BlockOutput {
    pub commands: Vec<Command>,
    pub diagnostics: Vec<Diagnostic>,
}

impl WalkedBlock<'_> {
    /// What is in force after it.
    pub fn modal(&self) -> Modal {
        (self.after.modal)()
    }

    /// No call has led to it.
    pub fn is_main(&self) -> bool {
        self.origin.call == CallPath::default()
    }
}

/// Runs a job and calls `visit` after each block; gives what comes after the last block, too. Memory is that of one block.
pub(crate) fn walk(job: &Job, mut visit: impl FnMut(&WalkedBlock)) -> (Vec<Outcome>, BlockOutput) {
    let mut walker = BlockWalker { visit: &mut visit, ran: 0, output: BlockOutput::default() };
    let outcomes = job.run(&mut walker);
    (outcomes, walker.output)
}

struct BlockWalker<'w> {
    visit: &'w mut dyn FnMut(&WalkedBlock),
    ran: u64,
    output: BlockOutput,
}

impl Sink for BlockWalker<'_> {
    fn command(&mut self, command: &Command) {
        self.output.commands.push(command.clone());
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic) {
        self.output.diagnostics.push(diagnostic);
    }
}

impl RunSink for BlockWalker<'_> {
    fn wants_blocks(&self) -> bool {
        true
    }

    fn block_done(&mut self, origin: &Origin, after: &AfterBlock) {
        (self.visit)(&WalkedBlock { origin, output: &self.output, ran: self.ran, after });
        self.output.commands.clear();
        self.output.diagnostics.clear();
        self.ran += 1;
    }
}

/// What a place of X is multiplied by in words at the beginning of a run: 2 where they are diameters.
pub(crate) fn first_x_factor(job: &Job) -> f64 {
    match job.control().parameters.starts_with_radii {
        true => 1.0,
        false => job.machine().written_factor(0),
    }
}

/// The same from a block on.
pub(crate) fn x_factor_after(
    source: &SourceBlocks,
    control: &Control,
    at: usize,
    before: f64,
) -> f64 {
    let has = |code| source.has_action(at, control, |own| own == Action::Reading(code));
    if has(ReadingCode::Diameters) {
        2.0
    } else if has(ReadingCode::Radii) {
        1.0
    } else {
        before
    }
}
