use chordal_syntax::Block;

use crate::command::Sink;
use crate::interpreter::Interpreter;

impl<S: Sink> Interpreter<'_, S> {
    pub(in crate::interpreter) fn general_pocket(&mut self, block: &Block, at: usize) {
        let row = self.control.g_code(1500);
        if let Some(row) = row {
            let word = block.words[at];
            self.not_simulated(&word, row);
        }
    }
}
