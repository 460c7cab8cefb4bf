//! Writes part programs from what a program does.
//!
//! `block_writer` keeps what is active and puts words into blocks, `moves` writes moves, `modes` everything else, `holes`
//! drilling cycles.

mod block_writer;
mod holes;
mod modes;
mod moves;
mod words;

use chordal_kernel::{
    PostedKind, PostedProgram, PostedStep, ProgramWriter, WriterNote, WriterOptions, WrittenProgram,
};

use self::block_writer::BlockWriter;
use crate::settings::SinumerikSettings;

/// Writes part programs for a control with the settings of a machine.
#[derive(Debug)]
pub struct PartProgramWriter {
    settings: SinumerikSettings,
}

impl PartProgramWriter {
    /// A writer for these settings.
    pub fn new(settings: SinumerikSettings) -> PartProgramWriter {
        PartProgramWriter { settings }
    }
}

impl ProgramWriter for PartProgramWriter {
    fn write(&self, program: &PostedProgram, options: &WriterOptions) -> WrittenProgram {
        let mut writer = BlockWriter::new(self.settings, program, options);
        writer.begin();
        for (at, step) in program.steps.iter().enumerate() {
            writer.step = at;
            if let Err(reason) = writer.write_step(step) {
                let words = String::new();
                writer.written.refusals.push(WriterNote { step: at, words, reason });
            }
        }
        writer.finish();
        writer.written
    }

    fn comment(&self, text: &str) -> String {
        format!("; {text}")
    }
}

impl BlockWriter<'_> {
    /// Writes the step at hand, or says why it cannot be written.
    fn write_step(&mut self, step: &PostedStep) -> Result<(), String> {
        match &step.kind {
            PostedKind::Hole(hole) => self.hole(hole),
            PostedKind::Tap(tap) => self.tap(tap),
            PostedKind::MachineMove { place, axes } => {
                self.end_modal_call();
                self.machine_move(place, *axes);
                Ok(())
            }
            PostedKind::Command(command) => {
                self.prepare_cycle(command);
                self.command(command)
            }
        }
    }
}
