//! Which overrides of the panel act: M48, M49, M50, G63, tapping cycles.

use chordal_syntax::Block;

use super::Interpreter;
use crate::command::{CommandKind, Overrides};
use crate::table::Action;

impl Interpreter<'_> {
    /// A code that lets overrides act or not.
    pub(super) fn take_overrides(&mut self, block: &Block, action: Action) {
        let by_code = &mut self.state.overrides.by_code;
        match action {
            Action::Overrides { on, rapid: true } => *by_code = Overrides { feed: on, rapid: on },
            Action::Overrides { on, rapid: false } => by_code.feed = on,
            Action::OverridesByP => {
                let on = !block.letters().has(b'P') || self.count_of(block, b'P') != Some(0);
                self.state.overrides.by_code = Overrides { feed: on, rapid: on };
            }
            _ => return,
        }
        self.tell_overrides();
    }

    /// G63 begins or ends.
    pub(super) fn set_tapping_mode(&mut self, on: bool) {
        self.state.overrides.tapping_mode = on;
        self.tell_overrides();
    }

    /// A tapping cycle goes into its hole, or has come out of it.
    pub(super) fn set_in_tap(&mut self, on: bool) {
        self.state.overrides.in_tap = on;
        self.tell_overrides();
    }

    fn tell_overrides(&mut self) {
        let in_force = self.state.overrides.in_force();
        if in_force != self.state.overrides.told {
            self.state.overrides.told = in_force;
            self.emit(CommandKind::Overrides(in_force));
        }
    }
}
