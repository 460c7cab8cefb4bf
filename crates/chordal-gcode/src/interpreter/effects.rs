//! Effects of a block other than moves and modes, emitted for the comparison of programs: codes that act on something
//! not simulated, values of the control that are written, blocks that a switch may skip.

use std::collections::BTreeMap;
use std::sync::Arc;

use chordal_command::{CommandKind, Effect, WorkName};
use chordal_dialect::macros::VariableRetention;
use chordal_dialect::{Action, AfterCode, BeforeCode, CodeRow};
use chordal_kernel::WrittenOffset;
use chordal_machine::{AXES, AXIS_LETTERS, PerAxis};
use chordal_syntax::{Block, Letters, Word};

use super::Interpreter;
use crate::macros::value::MacroValue;

/// Letters whose value is a length in the block of a code that is not simulated (G22).
const LENGTHS: Letters = Letters::of("XYZUVWIJK");

/// Words that belong to an M code without a row in the table.
const WORDS_OF_OPEN_CODES: Letters = Letters::of("PQR");

/// The values of the control when they were last emitted.
#[derive(Clone, Default, Debug)]
pub(super) struct WrittenState {
    pub(super) variables: BTreeMap<u32, f64>,
    pub(super) references: [PerAxis<Option<f64>>; 2],
}

impl Interpreter<'_> {
    /// Marks the values of the machine file as emitted: they are not effects of the program.
    pub(super) fn with_values_recorded(mut self) -> Self {
        self.kernel.state.offsets.take_written();
        self.mark_values_recorded();
        self
    }

    /// Marks the present values as emitted.
    pub(super) fn mark_values_recorded(&mut self) {
        self.recorded =
            WrittenState { variables: self.macros.kept.clone(), references: self.references };
    }

    fn emit_effect(&mut self, effect: Effect) {
        self.kernel.emit(CommandKind::Effect(Arc::new(effect)));
    }

    /// Emits that the program stops itself.
    pub(super) fn emit_alarm(&mut self, number: f64, text: &str) {
        self.emit_effect(Effect::Alarm { number, text: text.to_string() });
    }

    /// Emits the codes of a block that act on something not simulated, in order.
    pub(super) fn emit_codes(&mut self, block: &Block, codes: &[(&'static CodeRow, usize)]) {
        for (row, at) in codes {
            if acts_outside_commands(row, block) {
                let text = self.code_with_words(block, row, *at);
                self.emit_effect(Effect::Code(text));
            }
        }
    }

    /// Emits a code that the control does not have.
    pub(super) fn emit_unknown_code(&mut self, word: &Word) {
        let text = self.plain_word(word);
        self.emit_effect(Effect::Code(text));
    }

    /// Emits all words of a data line.
    pub(super) fn emit_data(&mut self, block: &Block) {
        let words: Vec<String> = block.words.iter().map(|word| self.plain_word(word)).collect();
        self.emit_effect(Effect::Code(words.join(" ")));
    }

    /// Emits that a switch may skip the block.
    pub(super) fn emit_block_delete(&mut self, block: &Block) {
        let Some(delete) = block.delete else { return };
        let partly = delete.from_word > 0;
        self.emit_effect(Effect::Deletable { switch: delete.switch, partly });
    }

    /// Emits the values of the control that the block has written.
    #[inline]
    pub(super) fn emit_written(&mut self) {
        if self.kernel.state.offsets.has_written() || self.macros.used {
            let written = self.kernel.state.offsets.take_written();
            self.emit_written_offsets(written);
        }
    }

    #[cold]
    fn emit_written_offsets(&mut self, written: Vec<WrittenOffset>) {
        for place in written {
            let values = self.kernel.state.offsets.written_values(&place);
            let name = match place {
                WrittenOffset::Work(key, axis) => {
                    format!("{} {}", self.work_name(&key), axis_letter(axis))
                }
                WrittenOffset::Rotation(key) => format!("{} R", self.work_name(&key)),
                WrittenOffset::Tool(number) => format!("tool {number}"),
            };
            self.emit_effect(Effect::Written { name, values });
        }
        self.emit_references();
        if self.macros.kept != self.recorded.variables {
            let before = std::mem::replace(&mut self.recorded.variables, self.macros.kept.clone());
            for (number, value) in self.recorded.variables.clone() {
                if before.get(&number).is_none_or(|old| old.to_bits() != value.to_bits()) {
                    self.emit_variable(number, Some(value));
                }
            }
            for number in before.into_keys() {
                if !self.recorded.variables.contains_key(&number) {
                    self.emit_variable(number, None);
                }
            }
        }
    }

    /// The name of a work coordinate system, numbered the same for every control.
    fn work_name(&self, key: &str) -> String {
        let naming = self.control.table.work_names;
        let names = (1..=u16::from(u8::MAX)).filter_map(WorkName::of_ordinal);
        let further = (1..=3).map(WorkName::G59).chain((1..=48).map(WorkName::E));
        let name = names.chain(further).find(|name| name.table_key(naming) == key);
        name.map_or_else(|| key.to_string(), |name| format!("work offset {}", name.ordinal()))
    }

    /// Emits the reference points that were stored.
    pub(super) fn emit_references(&mut self) {
        if self.references == self.recorded.references {
            return;
        }
        let before = std::mem::replace(&mut self.recorded.references, self.references);
        for (which, (old, new)) in before.into_iter().zip(self.references).enumerate() {
            for axis in (0..AXES).filter(|axis| old[*axis] != new[*axis]) {
                let name = format!("reference point {} {}", which + 1, axis_letter(axis));
                self.emit_effect(Effect::Written { name, values: vec![new[axis]] });
            }
        }
    }

    fn emit_variable(&mut self, number: u32, value: Option<f64>) {
        self.emit_effect(Effect::Variable { number, value });
    }

    /// Emits the changed variables that keep their value after power-off.
    pub(super) fn emit_retained_variables(&mut self) {
        if !self.macros.used {
            return;
        }
        let ranges = self
            .rules()
            .common
            .iter()
            .filter(|range| range.retention == VariableRetention::OverPowerOff);
        let own = ranges.filter(|range| range.stored == range.first);
        for number in own.flat_map(|range| range.first..=range.last) {
            let initial = self.machine.macros.variables.get(&number).copied();
            let value = match self.macros.store.read(number) {
                Ok(MacroValue::Number(value)) => Some(value),
                Ok(MacroValue::Vacant) => None,
                Ok(MacroValue::Unknown(_)) | Err(_) => continue,
            };
            if value != initial {
                self.emit_variable(number, value);
            }
        }
    }

    /// `M62 P1`: the code and its words with their numbers in the shortest form.
    fn code_with_words(&self, block: &Block, row: &CodeRow, at: usize) -> String {
        let word = &block.words[at];
        let is_open = row.action == Action::After(AfterCode::ShopCode);
        let has = |letter: u8| match is_open {
            true => WORDS_OF_OPEN_CODES.has(letter),
            false => row.words.has(letter),
        };
        let code = match is_open {
            true => self.plain_word(word),
            false => row.name(word.letter),
        };
        let mut words = vec![code];
        let own = block.words.iter().filter(|own| !matches!(own.letter, b'G' | b'M' | b'N'));
        words.extend(own.filter(|own| has(own.letter)).map(|own| self.plain_word(own)));
        words.join(" ")
    }

    fn plain_word(&self, word: &Word) -> String {
        let Some(number) = self.literal(word) else {
            return char::from(word.letter).to_string();
        };
        let unit = if LENGTHS.has(word.letter) { self.unit() } else { 1.0 };
        format!("{}{}", char::from(word.letter), number.to_f64() * unit)
    }
}

fn axis_letter(axis: usize) -> char {
    char::from(AXIS_LETTERS.as_bytes()[axis])
}

/// True for a code whose effect is not in the commands of the run.
fn acts_outside_commands(row: &CodeRow, block: &Block) -> bool {
    match row.action {
        Action::NoEffect | Action::NotSimulated | Action::NotFollowed => true,
        Action::After(code) => code == AfterCode::ShopCode,
        // Without a word the spindle stops at its mark, which a command says.
        Action::Before(code) => {
            code == BeforeCode::SpindleOrient && block.letters().meets(row.words)
        }
        Action::Reading(_)
        | Action::Mode(_)
        | Action::Length(_)
        | Action::Motion(_)
        | Action::Cycle(_)
        | Action::Once(_)
        | Action::Call(_) => false,
    }
}
