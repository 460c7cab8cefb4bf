//! A run of a job, block by block.

use chordal::control::{Action, AfterBlock, CallPath, Control, Modal, Origin, ReadingCode};
use chordal::{Command, Diagnostic, Job, Outcome, RunSink, Sink};

use crate::source::SourceBlocks;
use crate::word_address::BlockControl;

/// A block that has just been executed.
pub(crate) struct WalkedBlock<'v> {
    /// The block and the calls through which it was reached.
    pub origin: &'v Origin,
    /// Its commands and its diagnostics.
    pub output: &'v BlockOutput,
    /// The number of blocks executed before it.
    pub ran: u64,
    /// The state after it, computed on request.
    pub after: &'v AfterBlock<'v>,
}

/// The output of a run between the ends of two blocks.
#[derive(Debug, Default)]
pub(crate) struct BlockOutput {
    pub commands: Vec<Command>,
    pub diagnostics: Vec<Diagnostic>,
}

impl WalkedBlock<'_> {
    /// The modal state after it.
    pub fn modal(&self) -> Modal {
        (self.after.modal)()
    }

    /// Whether it is a block of the main program, reached through no call.
    pub fn is_main(&self) -> bool {
        self.origin.call == CallPath::default()
    }
}

/// Runs a job and calls `visit` after each block. Returns the outcome of each program and the output after the last block.
/// Only the output of one block is in memory.
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

/// The factor from a position along X to the number of its word at the beginning of a run: 2 where words are diameters.
pub(crate) fn first_x_factor(job: &Job) -> f64 {
    match job.control().parameters.starts_with_radii {
        true => 1.0,
        false => job.machine().written_factor(0),
    }
}

/// The factor from a block on, with the factor `before` it.
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
