//! Places between two blocks at which a run may be left off and taken up again, so that a text
//! that changed somewhere needs not be run whole.

use std::collections::BTreeMap;

use chordal_diagnostics::{FileId, Shift, TextRange};
use chordal_machine::PerAxis;
use chordal_syntax::{Decimal, Position as TextPosition};

use super::macros::MacroMemory;
use super::{Interpreter, Told};
use crate::command::{CallPath, CallPaths, Origin, Side};
use crate::state::State;

/// With more chains of calls a rest would cost more than it saves.
const MOST_CALL_PATHS: usize = 1000;

/// A place between two blocks of the main program, and all that the control remembers there.
#[derive(Clone, Debug)]
pub struct Rest {
    place: TextPosition,
    blocks: u64,
    memory: Memory,
}

/// What decides about all that follows.
#[derive(Clone, Debug)]
struct Memory {
    state: State,
    origin: Origin,
    paths: CallPaths,
    subroutines: BTreeMap<u32, TextPosition>,
    missing: Vec<u32>,
    repeated_blocks: u64,
    sequence: Option<Decimal>,
    told: Told,
    preset_kept: PerAxis<f64>,
    lost_jump: bool,
    carried_out: bool,
    macros: MacroMemory,
}

impl Rest {
    /// The byte at which the next block begins.
    pub fn offset(&self) -> u32 {
        self.place.offset
    }

    /// Blocks carried out since the run began.
    pub fn blocks(&self) -> u64 {
        self.blocks
    }

    /// True when what follows is the same behind both, to the bit: what is shown of a number
    /// reads back as that number and no other, and −0 is shown as −0.
    pub fn leads_on_like(&self, other: &Rest) -> bool {
        let (one, two) = (&self.memory, &other.memory);
        self.place == other.place
            && one.state.position == two.state.position
            && format!("{one:?}") == format!("{two:?}")
    }

    /// Counts other blocks before it.
    pub fn count_blocks(&mut self, blocks: u64) {
        self.blocks = blocks;
    }

    /// Makes it one of a text that has changed elsewhere; `None` where it remembers words that went.
    pub fn shift(&mut self, shift: &Shift) -> Option<()> {
        self.place = place(self.place, shift)?;
        let memory = &mut self.memory;
        memory.origin = memory.origin.shifted(shift)?;
        memory.paths.shift(shift)?;
        if let Some(word) = &mut memory.state.feed_over {
            *word = shift.span(*word)?;
        }
        for head in memory.subroutines.values_mut() {
            *head = place(*head, shift)?;
        }
        memory.macros.shift(shift)
    }
}

fn place(at: TextPosition, shift: &Shift) -> Option<TextPosition> {
    let (offset, line) = shift.place(at.offset, at.line)?;
    Some(TextPosition { offset, line })
}

impl Interpreter<'_> {
    /// Whether nothing is open that a rest does not hold: calls, loops, jumps back, cutter
    /// compensation, texts of the shop.
    pub(super) fn is_settled(&self) -> bool {
        self.blocks > 0
            && self.frames.is_empty()
            && self.path == CallPath::default()
            && self.jumps.is_empty()
            && self.repeat_until == 0
            && self.state.side == Side::Off
            && self.stopped.is_none()
            && !self.in_remark
            && self.paths.count() <= MOST_CALL_PATHS
            && self.options.shop_codes.is_none()
            && self.macros.is_settled()
            && self.sink.is_settled()
    }

    pub(super) fn rest(&self) -> Rest {
        Rest {
            place: self.reader.position(),
            blocks: self.blocks,
            memory: Memory {
                state: self.state.clone(),
                origin: self.origin,
                paths: self.paths.clone(),
                subroutines: self.subroutines.clone(),
                missing: self.missing.clone(),
                repeated_blocks: self.repeated_blocks,
                sequence: self.sequence,
                // Whoever collects keeps the first of them, so that it does not decide about what follows.
                told: Told { excess_decimals: false, ..self.told.clone() },
                preset_kept: self.preset_kept,
                lost_jump: self.lost_jump,
                carried_out: self.carried_out,
                macros: self.macros.memory(),
            },
        }
    }

    /// Goes on from a rest.
    pub(super) fn take_up(&mut self, rest: &Rest) {
        let memory = rest.memory.clone();
        self.reader.seek(rest.place);
        self.blocks = rest.blocks;
        self.state = memory.state;
        self.origin = memory.origin;
        self.paths = memory.paths;
        self.subroutines = memory.subroutines;
        self.missing = memory.missing;
        self.repeated_blocks = memory.repeated_blocks;
        self.sequence = memory.sequence;
        self.told = memory.told;
        self.preset_kept = memory.preset_kept;
        self.lost_jump = memory.lost_jump;
        self.carried_out = memory.carried_out;
        self.macros.recall(memory.macros);
    }

    /// Notes that a program was read, searched, or asked for a place in it.
    pub(super) fn look_at(&self, program: usize) {
        let program = self.program_at(program);
        if program.file == FileId(0) {
            self.look_at_range(TextRange::new(program.head.start.offset, program.head.end));
        }
    }

    /// Notes that something depends on the text as a whole.
    pub(super) fn look_at_all(&self) {
        self.look_at_range(TextRange::new(0, u32::MAX));
    }

    /// Notes that a part of the first text was read; its main program stands in it.
    pub(super) fn look_at_range(&self, range: TextRange) {
        let looked = self.looked.get();
        self.looked.set(Some(looked.map_or(range, |looked| looked.cover(range))));
    }
}
