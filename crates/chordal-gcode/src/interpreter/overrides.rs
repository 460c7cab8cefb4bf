//! Which overrides of the panel act: M48, M49, M50.

use chordal_dialect::Action;
use chordal_syntax::Block;

use super::Interpreter;

impl Interpreter<'_> {
    /// A code that lets overrides act or not.
    pub(super) fn take_overrides(&mut self, block: &Block, action: Action) {
        let (feed, rapid) = match action {
            Action::Overrides { on, rapid: true } => (on, Some(on)),
            Action::Overrides { on, rapid: false } => (on, None),
            Action::OverridesByP => {
                let on = !block.letters().has(b'P') || self.count_of(block, b'P') != Some(0);
                (on, Some(on))
            }
            _ => return,
        };
        self.kernel.set_overrides(Some(feed), rapid);
    }
}
