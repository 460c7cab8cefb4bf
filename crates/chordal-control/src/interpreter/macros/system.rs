//! System variables.

use chordal_diagnostics::{Code, TextRange};

use super::super::Interpreter;
use crate::command::Sink;
use crate::macros::evaluate::Fault;
use crate::macros::value::Value;

pub(super) fn no_variable(number: f64, range: TextRange) -> Fault {
    Fault::new(
        Code::BadVariable,
        range,
        format!("there is no variable #{number} on this control"),
        "take a local variable (1 to 33) or a common one",
    )
}

pub(super) fn read_only(number: u32, range: TextRange) -> Fault {
    Fault::new(
        Code::ReadOnlyVariable,
        range,
        format!("#{number} can be read, but not written"),
        "put the value into another variable",
    )
}

impl<S: Sink> Interpreter<'_, S> {
    pub(super) fn read_system(&mut self, number: u32, range: TextRange) -> Result<Value, Fault> {
        Err(no_variable(f64::from(number), range))
    }

    pub(super) fn write_system(
        &mut self,
        number: u32,
        value: Value,
        range: TextRange,
    ) -> Result<(), Fault> {
        let _ = value;
        Err(no_variable(f64::from(number), range))
    }
}
