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
    PostedKind, PostedProgram, ProgramWriter, WriterNote, WriterOptions, WrittenProgram,
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
        for at in 0..program.steps.len() {
            writer.step = at;
            if let Err(reason) = step(&mut writer, program, at) {
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

/// Writes one step, or says why it cannot be written.
fn step(writer: &mut BlockWriter<'_>, program: &PostedProgram, at: usize) -> Result<(), String> {
    match &program.steps[at].kind {
        PostedKind::Hole(hole) => writer.hole(program, at, hole),
        PostedKind::Tap(tap) => writer.tap(tap),
        PostedKind::MachineMove { place, axes } => {
            writer.end_modal_call();
            writer.machine_move(place, *axes);
            Ok(())
        }
        PostedKind::Command(command) => {
            writer.prepare_cycle(program, at);
            writer.command(command)
        }
    }
}
