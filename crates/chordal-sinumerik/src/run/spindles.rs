//! Several spindles of a lathe: the main one turns the part, any other one drives the tool.

use chordal_command::SpindleState;
use chordal_diagnostics::TextRange;
use chordal_kernel::LiveTool;

use super::interpreter::Interpreter;
use super::run_state::MAIN_SPINDLE;
use super::unknown_values::UnknownUse;
use super::words::{BlockWords, SpindleWord};
use crate::syntax::AddressWord;

impl Interpreter<'_> {
    /// `SETMS(2)`: S and M3, M4, M5 are those of this spindle from here on; without a number those of the main one.
    pub(super) fn choose_master_spindle(&mut self, number: Option<f64>) {
        let number = number.map(f64::round).filter(|number| (1.0..=99.0).contains(number));
        self.modes.master_spindle = number.map_or(MAIN_SPINDLE, |number| number as u32);
    }

    /// `S2=900` or `M2=3`: a word of another spindle. A mill has none that is simulated.
    pub(super) fn take_spindle_word(
        &mut self,
        words: &mut BlockWords,
        spindle: u32,
        word: &AddressWord,
        range: TextRange,
    ) {
        if !self.kernel.machine.turns() {
            return;
        }
        let name = &*word.address.name;
        let used_for = UnknownUse::of_address(name);
        let Some(value) = self.word_value(words, name, used_for, &word.value, range) else {
            return;
        };
        let is_speed = name == "S";
        words.spindles.push(SpindleWord { spindle, is_speed, value: value.value });
    }

    /// The words of other spindles that act before the motion.
    pub(super) fn spindles_before(&mut self, words: &BlockWords) {
        for word in &words.spindles {
            match (word.is_speed, word.value.round() as i64) {
                (true, _) => self.set_spindle_speed(word.spindle, word.value),
                (false, 3) => self.turn_spindle(word.spindle, SpindleState::Cw),
                (false, 4) => self.turn_spindle(word.spindle, SpindleState::Ccw),
                (false, _) => {}
            }
        }
    }

    /// The words of other spindles that act after the motion.
    pub(super) fn spindles_after(&mut self, words: &BlockWords) {
        for word in &words.spindles {
            if !word.is_speed && word.value.round() == 5.0 {
                self.turn_spindle(word.spindle, SpindleState::Off);
            }
        }
    }

    /// The speed of a spindle, rev/min.
    pub(super) fn set_spindle_speed(&mut self, spindle: u32, rpm: f64) {
        if !self.is_live(spindle) {
            return self.kernel.set_speed(rpm);
        }
        match self.kernel.state.live {
            Some(live) => self.kernel.set_live_tool(Some(LiveTool { rpm, ..live })),
            None => self.kernel.state.live_rpm = rpm,
        }
    }

    /// Starts or stops a spindle.
    pub(super) fn turn_spindle(&mut self, spindle: u32, turns: SpindleState) {
        if !self.is_live(spindle) {
            return self.kernel.set_spindle(turns);
        }
        let rpm = self.kernel.state.live_rpm;
        let is_on = matches!(turns, SpindleState::Cw | SpindleState::Ccw);
        if is_on || self.kernel.state.live.is_some() {
            self.kernel.set_live_tool(is_on.then_some(LiveTool { turns, rpm }));
        }
    }

    /// Whether a spindle drives the tool of a lathe.
    pub(super) fn is_live(&self, spindle: u32) -> bool {
        spindle != MAIN_SPINDLE && self.kernel.machine.turns()
    }
}
