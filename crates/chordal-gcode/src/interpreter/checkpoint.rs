//! What the interpreter remembers at a checkpoint, and how a run resumes from one.

use std::any::Any;
use std::collections::BTreeMap;

use chordal_command::{CallPath, CompensationSide};
use chordal_diagnostics::{FileId, TextRange, TextShift};
use chordal_dialect::LiteralScale;
use chordal_kernel::{Checkpoint, CheckpointMemory, KernelMemory};
use chordal_machine::PerAxis;
use chordal_syntax::{BlockPosition as TextPosition, Decimal};

use super::context::KeptModes;
use super::macros::MacroMemory;
use super::spatial::SpatialState;
use super::spline::SplineMemory;
use super::{Interpreter, ReportedOnce};
use crate::firmware::FirmwareChecker;

/// With more call paths, copying a checkpoint costs more than it saves.
const MAX_CALL_PATHS: usize = 1000;

/// Everything that the rest of the run depends on.
#[derive(Clone, Debug, PartialEq)]
struct BlockMemory {
    kernel: KernelMemory,
    scale: LiteralScale,
    per_word: PerAxis<f64>,
    registers: [Option<Decimal>; 10],
    subroutines: BTreeMap<u32, TextPosition>,
    missing: Vec<u32>,
    data_lines: bool,
    sequence: Option<Decimal>,
    reported: ReportedOnce,
    lost_jump: bool,
    units_programmed: bool,
    begun_by_percent: bool,
    feed_number: Option<(f64, f64)>,
    carried_out: bool,
    kept_modes: Vec<KeptModes>,
    references: [PerAxis<Option<f64>>; 2],
    macros: MacroMemory,
    spatial: SpatialState,
    spline: SplineMemory,
    judge: Option<FirmwareChecker>,
}

impl CheckpointMemory for BlockMemory {
    fn is_like(&self, other: &dyn CheckpointMemory) -> bool {
        let Some(other) = other.as_any().downcast_ref::<BlockMemory>() else { return false };
        self.kernel.is_at(&other.kernel) && self == other
    }

    fn shift(&mut self, shift: &TextShift) -> Option<()> {
        self.kernel.shift(shift)?;
        for head in self.subroutines.values_mut() {
            (head.offset, head.line) = shift.place(head.offset, head.line)?;
        }
        self.macros.shift(shift)
    }

    fn copy(&self) -> Box<dyn CheckpointMemory> {
        Box::new(self.clone())
    }

    fn as_any(&self) -> &dyn Any {
        self
    }
}

impl Interpreter<'_> {
    /// True when nothing is open that a checkpoint does not contain: calls, loops, backward jumps, cutter compensation,
    /// texts of custom codes.
    pub(super) fn is_settled(&self) -> bool {
        self.blocks > 0
            && self.frames.is_empty()
            && self.kernel.call == CallPath::default()
            && self.jumps.is_empty()
            && self.repeat_until == 0
            && self.kernel.state.side == CompensationSide::Off
            && self.stopped.is_none()
            && !self.in_remark
            && !self.kernel.waits_at_corner()
            && self.open_line.is_none()
            && self.open_plane.is_none()
            && self.kernel.calls.count() <= MAX_CALL_PATHS
            && self.options.shop_codes.is_none()
            && !self.machine.answers_with_blocks()
            && self.macros.is_settled()
            && self.kernel.sink.is_settled()
    }

    pub(super) fn checkpoint(&self) -> Checkpoint {
        let place = self.reader.position();
        let memory = BlockMemory {
            kernel: self.kernel.memory(),
            scale: self.scale,
            per_word: self.per_word,
            registers: self.registers,
            subroutines: self.subroutines.clone(),
            missing: self.missing.clone(),
            data_lines: self.data_lines,
            sequence: self.sequence,
            // The collector of the problems keeps the first one only, so the rest of the run does not depend on it.
            reported: ReportedOnce { excess_decimals: false, ..self.reported.clone() },
            lost_jump: self.lost_jump,
            units_programmed: self.units_programmed,
            begun_by_percent: self.begun_by_percent,
            feed_number: self.feed_number,
            carried_out: self.carried_out,
            kept_modes: self.kept_modes.clone(),
            references: self.references,
            macros: self.macros.memory(),
            spatial: self.spatial,
            spline: self.spline.clone(),
            judge: self.judge.clone(),
        };
        Checkpoint::new(place.offset, place.line, self.blocks, Box::new(memory))
    }

    /// Resumes from a checkpoint of this language.
    pub(super) fn take_up(&mut self, checkpoint: &Checkpoint) {
        let Some(memory) = checkpoint.memory::<BlockMemory>().cloned() else { return };
        let (offset, line) = (checkpoint.offset(), checkpoint.line());
        self.reader.seek(TextPosition { offset, line });
        self.blocks = checkpoint.blocks();
        self.kernel.recall(memory.kernel);
        self.scale = memory.scale;
        self.per_word = memory.per_word;
        self.registers = memory.registers;
        self.subroutines = memory.subroutines;
        self.missing = memory.missing;
        self.data_lines = memory.data_lines;
        self.sequence = memory.sequence;
        self.reported = memory.reported;
        self.lost_jump = memory.lost_jump;
        self.units_programmed = memory.units_programmed;
        self.begun_by_percent = memory.begun_by_percent;
        self.feed_number = memory.feed_number;
        self.carried_out = memory.carried_out;
        self.kept_modes = memory.kept_modes;
        self.references = memory.references;
        self.macros.recall(memory.macros);
        self.spatial = memory.spatial;
        self.spline = memory.spline;
        self.judge = memory.judge;
        self.mark_values_recorded();
    }

    /// Records that a program was read or searched for a label.
    pub(super) fn look_at(&self, program: usize) {
        let program = self.program_at(program);
        if program.file == FileId(0) {
            self.look_at_range(TextRange::new(program.head.start.offset, program.head.end));
        }
    }

    /// Records that the run depends on the whole text.
    pub(super) fn look_at_all(&self) {
        self.look_at_range(TextRange::new(0, u32::MAX));
    }

    /// Records that a part of the first text was read.
    pub(super) fn look_at_range(&self, range: TextRange) {
        let before = self.text_read_outside.get();
        self.text_read_outside
            .set(Some(before.map_or(range, |range_read| range_read.cover(range))));
    }
}
