//! Names that a statement requires: labels, variables, programs.

use chordal_diagnostics::TextRange;

use super::ast::{Address, VariableType};
use super::parser::BlockParser;

impl BlockParser<'_> {
    /// A name with all of its digits, in upper case, and its range: `L10`, `MY_VAR`.
    pub fn required_name(&mut self, what: &str) -> Option<(String, TextRange)> {
        self.scan.skip_blanks();
        match self.scan.read_whole_name() {
            Some(range) => Some((self.scan.upper(range), range)),
            None => self.fail(format!("{what} is missing")),
        }
    }

    /// A variable or an address with its extension and indices.
    pub fn required_address(&mut self) -> Option<Address> {
        self.scan.skip_blanks();
        match self.scan.read_name() {
            Some(range) => self.address(range),
            None => self.fail("the variable is missing"),
        }
    }

    /// The extension and the indices after a name.
    pub fn address(&mut self, name: TextRange) -> Option<Address> {
        let is_letter = name.len() == 1;
        let has_extension = is_letter && self.scan.peek().is_ascii_digit();
        let extension = if has_extension { Some(self.extension()?) } else { None };
        let indices = self.indices()?;
        let range = self.scan.range_from(name.start as usize);
        Some(Address { range, name: self.scan.address_name(name), extension, indices })
    }

    fn extension(&mut self) -> Option<u32> {
        match self.scan.read_digits() {
            Some(number) => Some(number),
            None => self.fail("the number of the address is too large"),
        }
    }

    /// A type; `None` without a fault when the next name is none.
    pub fn variable_type(&mut self) -> Option<VariableType> {
        self.scan.skip_blanks();
        let begin = self.scan;
        let range = self.scan.read_whole_name()?;
        Some(match self.scan.upper(range).as_str() {
            "INT" => VariableType::Integer,
            "REAL" => VariableType::Real,
            "BOOL" => VariableType::Boolean,
            "CHAR" => VariableType::Character,
            "AXIS" => VariableType::Axis,
            "FRAME" => VariableType::Frame,
            "STRING" => VariableType::Text(self.text_length()?),
            _ => {
                self.scan = begin;
                return None;
            }
        })
    }

    /// `[32]` of a STRING.
    fn text_length(&mut self) -> Option<u32> {
        if !self.scan.take(b'[') {
            return self.fail("the length of the STRING is missing");
        }
        self.scan.skip_blanks();
        let length = self.scan.read_digits();
        match length {
            Some(length) if self.scan.take(b']') => Some(length),
            _ => self.fail("the length of a STRING is a whole number in brackets"),
        }
    }
}
