//! Definitions and tables of the control that stand next to the program: user data, tool data, offsets, R parameters.

use super::interpreter::Interpreter;
use super::run_state::RunningProgram;
use super::variables::ProgramVariable;
use crate::syntax::{ProgramBlock, ProgramUnitKind, StatementKind, VariableDefinition};

impl Interpreter<'_> {
    /// Takes the tables over, before the program begins.
    pub(super) fn read_tables(&mut self) {
        let programs = self.programs;
        for (index, text) in programs.texts.iter().enumerate() {
            if text.unit.kind != ProgramUnitKind::Table {
                continue;
            }
            let call = self.running().call;
            self.stack.push(RunningProgram::new(index, programs.reader(index), call));
            while let Some(block) = self.running().reader.next() {
                self.table_block(&block);
            }
            self.stack.pop();
        }
        self.has_tool_tables = !self.listed_edges.is_empty();
    }

    fn table_block(&mut self, block: &ProgramBlock) {
        for statement in &block.statements {
            match &statement.kind {
                StatementKind::Define(definition) => self.define_user_data(definition),
                StatementKind::Macro { name, text } => self.define_macro(name, *text),
                StatementKind::Word(word)
                    if word.address.name.starts_with('$') || word.address.name == "R" =>
                {
                    self.assign(&word.address, &word.value);
                }
                _ => {}
            }
        }
    }

    /// `DEF NCK REAL NAME`: without a value in the file nobody knows what the control holds.
    fn define_user_data(&mut self, definition: &VariableDefinition) {
        for defined in &definition.variables {
            let made = self.sizes(&defined.sizes).and_then(|sizes| {
                ProgramVariable::unknown(definition.kind, sizes, &defined.name).ok()
            });
            let Some(mut variable) = made else { continue };
            if let Some(initial) = &defined.initial {
                self.fill(&mut variable, initial);
            }
            self.variables.user_data.insert(defined.name.clone(), variable);
        }
    }
}
