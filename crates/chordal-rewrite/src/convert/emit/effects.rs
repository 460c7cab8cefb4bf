//! Codes that act on what is not simulated, in blocks that are written from what they do.

use chordal::Effect;

use super::{CommandEmitter, codes};

impl CommandEmitter<'_> {
    /// Writes a code that means the same on both controls. What else a block does without a move is not written, and the
    /// proof tells where it is missing.
    pub(super) fn effect(&mut self, effect: &Effect) {
        let Effect::Code(words) = effect else { return };
        if self.from.is_none_or(|from| codes::is_only_of(words, from, self.to)) {
            return;
        }
        self.flush();
        let words: Vec<String> = words.split(' ').map(str::to_string).collect();
        self.line(&words);
    }
}
