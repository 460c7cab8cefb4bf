//! `DEFINE NAME AS text`: names that stand for a text.

use chordal_diagnostics::{Span, TextRange};

use super::interpreter::Interpreter;
use super::variables::ProgramVariable;
use crate::syntax::{
    BlockStatement, ProgramBlock, StatementKind, VariableType, constant_of, statements_of,
};
use crate::values::evaluate;

/// Macros in the text of macros at most.
const MAX_DEPTH: u32 = 8;

impl Interpreter<'_> {
    /// `DEFINE NAME AS text`. A text that is a value can be read like a variable.
    pub(super) fn define_macro(&mut self, name: &str, text: TextRange) {
        let place = Span { file: self.file(), range: text };
        self.macros.insert(name.to_string(), place);
        let Some(constant) = constant_of(self.text(), text) else { return };
        if let Ok(value) = evaluate(&constant, &mut self.scope()) {
            let variable = ProgramVariable {
                kind: VariableType::Real,
                sizes: Vec::new(),
                values: vec![value],
            };
            self.variables.user_data.insert(name.to_string(), variable);
        }
    }

    /// A block with the texts of its macros in place of their names.
    pub(super) fn expanded(&mut self, mut block: ProgramBlock) -> ProgramBlock {
        self.macro_use = None;
        for _ in 0..MAX_DEPTH {
            let is_macro = |statement: &BlockStatement| match &statement.kind {
                StatementKind::Name(name) => self.macros.contains_key(name),
                _ => false,
            };
            let Some(at) = block.statements.iter().position(is_macro) else { return block };
            let StatementKind::Name(name) = &block.statements[at].kind else { return block };
            let (place, range) = (self.macros[name], block.statements[at].range);
            let statements = statements_of(self.programs.text(place.file), place.range);
            if place.file != self.file() {
                // Its text is no part of this file: problems are told where it is used.
                self.macro_use = Some(range);
            }
            block.statements.splice(at..=at, statements);
        }
        block
    }
}
