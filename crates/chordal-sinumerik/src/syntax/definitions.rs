//! Definitions: `DEF`, `PROC`, `EXTERN`, `DEFINE`.

use super::ast::{
    DefinedVariable, Expression, ProcedureHead, ProcedureParameter, StatementKind,
    VariableDefinition, VariableType, WordValue,
};
use super::parser::BlockParser;

/// Where the variables of a definition file are valid.
const SCOPES: [&str; 2] = ["NCK", "CHAN"];

/// The properties between the type and the names of a definition file (Job Planning 07/2010, 1.1). Those that have a
/// value are followed by a number.
const PROPERTIES_WITH_VALUE: [&str; 9] =
    ["PHU", "LLI", "ULI", "APR", "APW", "APRP", "APWP", "APRB", "APWB"];

/// The properties without a value.
const PROPERTIES: [&str; 5] = ["SYNR", "SYNW", "SYNRW", "INIPO", "INIRE"];

/// The properties of a procedure that do not change what it does.
const PROCEDURE_PROPERTIES: [&str; 8] =
    ["DISPLOF", "DISPLON", "SBLOF", "SBLON", "ACTBLOCNO", "ICYCOF", "ICYCON", "PREPRO"];

impl BlockParser<'_> {
    /// What follows DEF: a type and its variables.
    pub fn definition(&mut self) -> Option<StatementKind> {
        while self.take_any(&SCOPES) || self.take_any(&PROPERTIES) {}
        let kind = self.required_type()?;
        self.skip_properties()?;
        let mut variables = Vec::new();
        loop {
            variables.push(self.defined_variable()?);
            if !self.scan.take(b',') {
                return Some(StatementKind::Define(VariableDefinition { kind, variables }));
            }
        }
    }

    fn required_type(&mut self) -> Option<VariableType> {
        match self.variable_type() {
            Some(kind) => Some(kind),
            None => self.fail("a type is missing: INT, REAL, BOOL, CHAR, STRING, AXIS or FRAME"),
        }
    }

    fn take_any(&mut self, words: &[&str]) -> bool {
        words.iter().any(|word| self.scan.take_word(word))
    }

    fn skip_properties(&mut self) -> Option<()> {
        loop {
            if self.take_any(&PROPERTIES_WITH_VALUE) {
                self.expression()?;
            } else if !self.take_any(&PROPERTIES) {
                return Some(());
            }
        }
    }

    /// `NAME`, `NAME[2,3]`, `NAME=1`, `NAME[3]=SET(1,2,3)`, `NAME[3]=(1,2,3)`.
    fn defined_variable(&mut self) -> Option<DefinedVariable> {
        let (name, range) = self.required_name("the name of the variable")?;
        let sizes = self.indices()?;
        let initial =
            if self.scan.take_equals() { Some(self.first_value(!sizes.is_empty())?) } else { None };
        Some(DefinedVariable { name, range, sizes, initial })
    }

    /// The first value; that of an array may be a list without SET.
    fn first_value(&mut self, is_array: bool) -> Option<WordValue> {
        if is_array && self.scan.next_byte() == b'(' {
            return self.value_list().map(WordValue::Set);
        }
        self.word_value()
    }

    /// What follows PROC: the name, the parameters and properties.
    pub fn procedure(&mut self) -> Option<StatementKind> {
        let (name, _) = self.required_name("the name of the procedure")?;
        let parameters = self.parameters()?;
        let mut saves = false;
        loop {
            if self.scan.take_word("SAVE") {
                saves = true;
            } else if !self.take_any(&PROCEDURE_PROPERTIES) {
                let head = ProcedureHead { name, parameters, saves };
                return Some(StatementKind::Procedure(head));
            }
        }
    }

    fn parameters(&mut self) -> Option<Vec<ProcedureParameter>> {
        let mut parameters = Vec::new();
        if !self.scan.take(b'(') || self.scan.take(b')') {
            return Some(parameters);
        }
        loop {
            parameters.push(self.parameter()?);
            if self.scan.take(b')') {
                return Some(parameters);
            }
            if !self.scan.take(b',') {
                return self.fail("a comma or a closing parenthesis is missing");
            }
        }
    }

    /// `REAL A`, `INT B=2`, `VAR REAL C`, `VAR REAL D[3]`.
    fn parameter(&mut self) -> Option<ProcedureParameter> {
        let is_reference = self.scan.take_word("VAR");
        let kind = self.required_type()?;
        let (name, _) = self.required_name("the name of the parameter")?;
        self.skip_dimensions()?;
        let default = self.default_value()?;
        Some(ProcedureParameter { kind, name, is_reference, default })
    }

    /// `=2`; `Some(None)` without.
    fn default_value(&mut self) -> Option<Option<Expression>> {
        if !self.scan.take_equals() {
            return Some(None);
        }
        self.expression().map(Some)
    }

    /// `[3]`, `[,]`, `[]`: an array takes the sizes of the argument.
    fn skip_dimensions(&mut self) -> Option<()> {
        if !self.scan.take(b'[') {
            return Some(());
        }
        loop {
            if self.scan.take(b']') {
                return Some(());
            }
            if !self.scan.take(b',') {
                self.expression()?;
            }
        }
    }

    /// What follows EXTERN: a name and types, which the program itself states again.
    pub fn external(&mut self) -> Option<StatementKind> {
        let (name, _) = self.required_name("the name of the program")?;
        let after = self.scan;
        if !self.scan.take(b'(') {
            self.scan = after;
            return Some(StatementKind::External(name));
        }
        match memchr::memchr2(b')', b';', self.scan.rest()) {
            Some(close) if self.scan.peek_after(close) == b')' => {
                self.scan.at += close + 1;
                Some(StatementKind::External(name))
            }
            _ => self.fail("a closing parenthesis is missing"),
        }
    }

    /// What follows DEFINE: `NAME AS text`, up to the comment.
    pub fn macro_definition(&mut self) -> Option<StatementKind> {
        let (name, _) = self.required_name("the name of the macro")?;
        if !self.scan.take_word("AS") {
            return self.fail("AS and the text of the macro are missing");
        }
        self.scan.skip_blanks();
        let start = self.scan.at;
        self.scan.skip_to_comment();
        let mut text = self.scan.range_from(start);
        let blanks = self.scan.slice(text).iter().rev().take_while(|byte| **byte <= b' ').count();
        text.end -= blanks as u32;
        Some(StatementKind::Macro { name, text })
    }
}
