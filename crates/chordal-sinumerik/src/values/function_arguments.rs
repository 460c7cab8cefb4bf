//! The arguments of a function.

use super::value::{SinumerikValue, ValueFault};

/// The alarm of a wrong number of arguments or a missing one.
const ARGUMENT_ALARM: u32 = 14020;

/// The arguments of a function.
pub(super) struct FunctionArguments<'a> {
    /// The name in upper case.
    pub name: &'a str,
    pub values: &'a [Option<SinumerikValue>],
}

impl FunctionArguments<'_> {
    /// An error unless there are `least` to `greatest` arguments.
    pub fn expect_count(&self, least: usize, greatest: usize) -> Result<(), ValueFault> {
        let count = self.values.len();
        if (least..=greatest).contains(&count) {
            return Ok(());
        }
        let message = format!("{} does not take {count} arguments", self.name);
        Err(ValueFault { alarm: ARGUMENT_ALARM, message })
    }

    /// The argument at an index from 0; an error when it is missing.
    pub fn value(&self, index: usize) -> Result<&SinumerikValue, ValueFault> {
        self.values.get(index).and_then(Option::as_ref).ok_or_else(|| ValueFault {
            alarm: ARGUMENT_ALARM,
            message: format!("argument {} of {} is missing", index + 1, self.name),
        })
    }

    /// The argument at an index from 0, `None` when it is missing.
    pub fn optional(&self, index: usize) -> Option<&SinumerikValue> {
        self.values.get(index).and_then(Option::as_ref)
    }

    pub fn real(&self, index: usize) -> Result<f64, ValueFault> {
        self.value(index)?.to_real()
    }

    pub fn only_real(&self) -> Result<f64, ValueFault> {
        self.expect_count(1, 1)?;
        self.real(0)
    }
}
