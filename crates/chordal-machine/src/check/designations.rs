//! Reads the values of keys for designations.

use super::CheckedValue;
use crate::designation::{
    DesignationError, HolderDesignation, InsertDesignation, InsertLetter, WrittenDesignation,
};
use crate::error::MachineError;
use crate::machine::Machine;
use crate::schema;

impl CheckedValue<'_> {
    /// Stores the letter or the whole designation of an insert.
    pub(super) fn take_insert(&self, machine: &mut Machine) -> Result<(), MachineError> {
        let text = self.text(self.value)?;
        let alone = text.trim();
        let letter =
            InsertLetter::ALL.into_iter().find(|own| own.as_str().eq_ignore_ascii_case(alone));
        let designation = match letter {
            Some(_) => None,
            None if alone.len() == 1 => {
                let letters = InsertLetter::ALL.map(InsertLetter::as_str);
                let help = format!("it is one of {}", crate::suggest::or_list(&letters));
                let message = format!("`{alone}` is not a letter of an insert");
                return Err(self.error(message, Some(help)));
            }
            None => {
                let read = InsertDesignation::parse(&text);
                let value = read.map_err(|error| self.no_designation(&text, "an insert", error))?;
                Some(self.written(text, value))
            }
        };
        let turning = &mut schema::tool(machine, &self.at.keys).turning;
        turning.insert = letter;
        turning.insert_designation = designation;
        Ok(())
    }

    pub(super) fn take_holder(&self, machine: &mut Machine) -> Result<(), MachineError> {
        let text = self.text(self.value)?;
        let read = HolderDesignation::parse(&text);
        let value = read.map_err(|error| self.no_designation(&text, "a holder", error))?;
        let written = self.written(text, value);
        schema::tool(machine, &self.at.keys).turning.holder_designation = Some(written);
        Ok(())
    }

    fn written<T>(&self, text: String, value: T) -> WrittenDesignation<T> {
        let location = Some(self.source.location(self.value.span()));
        WrittenDesignation { text, value, location }
    }

    /// An error with the wrong letters or digits underlined.
    fn no_designation(&self, text: &str, what: &str, error: DesignationError) -> MachineError {
        let span = self.value.span();
        // The text begins one byte later if it is in quotes.
        let quote = usize::from(span.len() == text.len() + 2);
        let DesignationError { message, part, help } = error;
        let within = if part.is_empty() || span.len() > text.len() + 2 {
            span
        } else {
            span.start + quote + part.start..span.start + quote + part.end
        };
        let message = format!("`{text}` is not the designation of {what}: {message}");
        self.source.error(Some(within), message, Some(help))
    }
}
