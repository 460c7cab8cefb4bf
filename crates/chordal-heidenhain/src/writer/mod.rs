//! Writes conversational programs from what a program does.
//!
//! `blocks` keeps what is active and puts words into blocks, `moves` writes moves, `modes` everything else, `holes` cycles.

mod blocks;
mod holes;
mod modes;
mod moves;
mod words;

use chordal_command::CommandKind;
use chordal_kernel::{
    PostedKind, PostedProgram, PostedStep, ProgramWriter, WriterNote, WriterOptions, WrittenProgram,
};

use self::blocks::KlartextBlocks;
use crate::settings::HeidenhainSettings;

/// Writes conversational programs for a control with the settings of a machine.
#[derive(Debug)]
pub struct KlartextWriter {
    settings: HeidenhainSettings,
}

impl KlartextWriter {
    /// A writer for these settings.
    pub fn new(settings: HeidenhainSettings) -> KlartextWriter {
        KlartextWriter { settings }
    }
}

impl ProgramWriter for KlartextWriter {
    fn write(&self, program: &PostedProgram, options: &WriterOptions) -> WrittenProgram {
        let mut blocks = KlartextBlocks::new(self.settings, program, options);
        blocks.begin();
        for (at, step) in program.steps.iter().enumerate() {
            blocks.step = at;
            if let Err(reason) = blocks.write_step(step) {
                let words = String::new();
                blocks.written.refusals.push(WriterNote { step: at, words, reason });
            }
        }
        blocks.finish();
        blocks.written
    }

    fn comment(&self, text: &str) -> String {
        format!("; {text}")
    }

    /// The control numbers every block anew, comments as well.
    fn block_start(&self, _: Option<u32>, block: usize) -> String {
        format!("{block} ")
    }
}

impl KlartextBlocks<'_> {
    /// Writes the step at hand, or says why it cannot be written.
    fn write_step(&mut self, step: &PostedStep) -> Result<(), String> {
        match &step.kind {
            PostedKind::Hole(hole) => self.hole(hole),
            PostedKind::Tap(tap) => self.tap(tap),
            PostedKind::MachineMove { place, axes } => {
                self.machine_move(place, *axes);
                Ok(())
            }
            PostedKind::Command(command) => {
                self.prepare_cycle(command);
                self.command(command)
            }
        }
    }

    /// The command of a step.
    fn command(&mut self, command: &CommandKind) -> Result<(), String> {
        if let CommandKind::Rapid { motion, .. } = command {
            return self.rapid(motion);
        }
        if let CommandKind::Line { motion, feed } = command {
            return self.cut(motion, feed);
        }
        if let CommandKind::Arc { motion, shape, feed }
        | CommandKind::Spiral { motion, shape, feed } = command
        {
            return self.arc(motion, shape, feed);
        }
        self.mode(command)
    }
}
