//! What macro statements remember at a checkpoint.

use chordal_command::Position;
use std::collections::{BTreeMap, BTreeSet};

use chordal_diagnostics::{Code, FileId, TextShift};
use chordal_syntax::BlockPosition as TextPosition;

use super::MacroState;
use super::lines::MacroLineState;
use super::probe::ProbeResults;
use super::unknown::UnknownValues;
use crate::macros::names::NamedVariables;
use crate::macros::value::MacroValue;
use crate::macros::variables::VariableStore;

/// With more reported problems, copying a checkpoint costs more than it saves.
const MAX_REPORTED_PROBLEMS: usize = 1000;

/// The part of [`MacroState`] that is stored; what was found in the text is found again.
#[derive(Clone, Debug, PartialEq)]
pub(in super::super) struct MacroMemory {
    store: VariableStore,
    kept: BTreeMap<u32, f64>,
    reported: BTreeSet<(FileId, u32, Code)>,
    used: bool,
    last_words: [Option<f64>; 26],
    skip: Position,
    port_open: bool,
    printed: usize,
    names: NamedVariables,
    returned: (MacroValue, bool),
    called: BTreeMap<(usize, u32), TextPosition>,
    lines: MacroLineState,
    probe: ProbeResults,
    unknown: UnknownValues,
}

impl MacroState<'_> {
    /// The number of modal calls that are not cancelled.
    pub fn modal_calls(&self) -> usize {
        self.modal.len()
    }

    /// True when no loop, modal call, START or printed line is open.
    pub fn is_settled(&self) -> bool {
        self.loops.is_empty()
            && self.modal.is_empty()
            && self.active == 0
            && self.in_alias == 0
            && self.owords.is_settled()
            && self.lines.is_settled()
            && self.reported.len() <= MAX_REPORTED_PROBLEMS
    }

    pub fn memory(&self) -> MacroMemory {
        MacroMemory {
            store: self.store.clone(),
            kept: self.kept.clone(),
            reported: self.reported.clone(),
            used: self.used,
            last_words: self.last_words,
            skip: self.skip,
            port_open: self.port_open,
            printed: self.printed,
            names: self.names.clone(),
            returned: (self.owords.value, self.owords.value_returned),
            called: self.owords.called.clone(),
            lines: self.lines.lasting(),
            probe: self.probe,
            unknown: self.unknown.clone(),
        }
    }

    pub fn recall(&mut self, memory: MacroMemory) {
        self.store = memory.store;
        self.kept = memory.kept;
        self.reported = memory.reported;
        self.used = memory.used;
        self.last_words = memory.last_words;
        self.skip = memory.skip;
        self.port_open = memory.port_open;
        self.printed = memory.printed;
        self.names = memory.names;
        (self.owords.value, self.owords.value_returned) = memory.returned;
        self.owords.called = memory.called;
        self.lines = memory.lines;
        self.probe = memory.probe;
        self.unknown = memory.unknown;
    }
}

impl MacroMemory {
    /// Moves its positions to those of a text that was changed elsewhere; `None` when one of them was deleted.
    pub fn shift(&mut self, shift: &TextShift) -> Option<()> {
        let reported = std::mem::take(&mut self.reported);
        for (file, at, code) in reported {
            let at = if file == FileId(0) { shift.offset(at)? } else { at };
            self.reported.insert((file, at, code));
        }
        self.unknown.shift(shift)?;
        for place in self.called.values_mut() {
            (place.offset, place.line) = shift.place(place.offset, place.line)?;
        }
        Some(())
    }
}
