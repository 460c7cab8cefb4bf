//! The arguments of a call, and what is wrong with them.

use super::cycle_parameters::CycleSignature;
use super::signatures::cycle_signature;
use crate::alarms::NO_ALARM;

/// Too many arguments in a call.
const TOO_MANY_ARGUMENTS: u32 = 12_340;

/// The largest magnitude of an argument. It is more than any INT of the control, and sums of a few such numbers stay
/// exact enough to be compared.
const MAX_MAGNITUDE: f64 = 1e10;

/// The arguments of a call in the order in which they are written. Arguments that are no numbers (strings) are missing.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct CycleArguments {
    values: Vec<Option<f64>>,
}

impl CycleArguments {
    /// From values in order; `None` for an argument that is left out.
    pub fn new(values: &[Option<f64>]) -> CycleArguments {
        CycleArguments { values: values.to_vec() }
    }

    /// The argument at an index from 0. `None` when it is left out.
    pub fn get(&self, index: usize) -> Option<f64> {
        self.values.get(index).copied().flatten()
    }

    /// The number of arguments up to the last one that is present.
    pub fn count(&self) -> usize {
        self.values.iter().rposition(Option::is_some).map_or(0, |last| last + 1)
    }
}

/// Why a cycle cannot run.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct CycleFault {
    /// The number of the control's alarm; [`NO_ALARM`] when the control may well accept the call.
    pub alarm: u32,
    /// What is wrong, with the number of the alarm.
    pub message: String,
    /// The index of the parameter at fault, from 0. `None` when it is not one parameter.
    pub parameter: Option<usize>,
}

/// A call: arguments together with the names of their parameters.
#[derive(Clone, Copy)]
pub(super) struct CycleCall<'a> {
    pub(super) signature: &'static CycleSignature,
    arguments: &'a CycleArguments,
}

impl<'a> CycleCall<'a> {
    /// The call of a cycle that is carried out.
    ///
    /// # Errors
    /// The cycle is unknown or not carried out, there are too many arguments, or one of them is no usable number.
    pub(super) fn new(
        name: &str,
        arguments: &'a CycleArguments,
    ) -> Result<CycleCall<'a>, CycleFault> {
        let Some(signature) = cycle_signature(name).filter(|cycle| cycle.is_carried_out) else {
            return Err(CycleFault {
                alarm: NO_ALARM,
                message: format!("{name} is not carried out"),
                parameter: None,
            });
        };
        let call = CycleCall { signature, arguments };
        let (count, most) = (arguments.count(), signature.parameters.len());
        if count > most {
            let text = format!("{} has {most} parameters and is called with {count}", call.name());
            return Err(call.fault(TOO_MANY_ARGUMENTS, None, &text));
        }
        for (parameter, index) in signature.parameters.iter().zip(0..) {
            let is_usable = |value: f64| value.is_finite() && value.abs() <= MAX_MAGNITUDE;
            if !arguments.get(index).is_none_or(is_usable) {
                let text = format!("{} of {} is out of range", parameter.name, call.name());
                return Err(call.fault(NO_ALARM, Some(parameter.name), &text));
            }
        }
        Ok(call)
    }

    pub(super) fn name(&self) -> &'static str {
        self.signature.name
    }

    /// The index of a parameter. `None` when the cycle has none of this name.
    fn index(&self, parameter: &str) -> Option<usize> {
        self.signature.parameters.iter().position(|entry| entry.name == parameter)
    }

    /// The argument of a parameter. `None` when it is left out or the cycle has no such parameter.
    pub(super) fn argument(&self, parameter: &str) -> Option<f64> {
        self.index(parameter).and_then(|index| self.arguments.get(index))
    }

    /// The argument of a parameter, 0 when it is left out: the control initializes by-value parameters with 0.
    pub(super) fn number(&self, parameter: &str) -> f64 {
        self.argument(parameter).unwrap_or(0.0)
    }

    /// The magnitude of an argument that is written without a sign (the cycle files take ABS).
    pub(super) fn magnitude(&self, parameter: &str) -> f64 {
        self.number(parameter).abs()
    }

    /// An argument of type INT: rounded.
    pub(super) fn integer(&self, parameter: &str) -> i64 {
        self.number(parameter).round() as i64
    }

    pub(super) fn fault(&self, alarm: u32, parameter: Option<&str>, text: &str) -> CycleFault {
        let message = match alarm {
            NO_ALARM => text.to_string(),
            _ => format!("alarm {alarm}: {text}"),
        };
        CycleFault { alarm, message, parameter: parameter.and_then(|name| self.index(name)) }
    }
}
