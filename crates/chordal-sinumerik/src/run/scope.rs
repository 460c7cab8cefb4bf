//! What an expression may read: the variables of the program, user data, and values of the control.

use chordal_machine::AXIS_NAMES;

use super::system_variables::{SystemState, index_keys, system_value};
use super::variables::{VariableStore, r_number};
use crate::syntax::Address;
use crate::values::{EvaluationError, SinumerikValue, VariableSource};

/// Functions whose value depends on the control: the tool management, files, the axes of the channel.
const FUNCTIONS_OF_CONTROL: &[&str] = &[
    "GETT",
    "GETACTT",
    "GETACTTD",
    "GETSELT",
    "GETEXET",
    "GETTENV",
    "GETDNO",
    "NEWT",
    "DELT",
    "FINDT",
    "ISAXIS",
    "ISFILE",
    "ISVAR",
    "READ",
    "AXTOSPI",
    "SPI",
    "MODAXVAL",
    "POSA",
    "CALCPOSI",
    "CALCDAT",
    "INTERSEC",
    "TANG",
    "GETTCOR",
    "TOOLENV",
    "MEAFRAME",
    "INVFRAME",
    "ADDFRAME",
    "CTRANS",
    "CFINE",
    "CROT",
    "CROTS",
    "CRPL",
    "CSCALE",
    "CMIRROR",
    "SETTCOR",
    "CHKDNO",
    "VALIDD",
    "SELT",
    "MATCHT",
    "STRINGIS",
    "GETVARTYP",
    "GETVARLIM",
    "GETVARDFT",
    "CONTDCON",
    "CONTPRON",
    "SPRINT",
    "CHKDM",
    "ORISOLH",
    "SUMTOTAL",
    "AXCTSWE",
    "CTAB",
    "CTABINV",
];

/// What the expressions of a block read.
pub struct ValueScope<'s> {
    /// The variables.
    pub variables: &'s mut VariableStore,
    /// What the control knows about its own state.
    pub system: SystemState<'s>,
}

impl VariableSource for ValueScope<'_> {
    fn read(
        &mut self,
        address: &Address,
        indices: &[i64],
    ) -> Result<SinumerikValue, EvaluationError> {
        let (range, name) = (address.range, &*address.name);
        if let Some(number) = r_number(address, indices) {
            return self.variables.read_r(number, range);
        }
        if name.starts_with('$') {
            let keys = index_keys(address, indices);
            let written = self.variables.written_system_value(name, &keys);
            let known = written.or_else(|| system_value(&self.system, name, &keys));
            return Ok(
                known.unwrap_or_else(|| SinumerikValue::Unknown(address_text(name, &keys).into()))
            );
        }
        if let Some(variable) = self.variables.named(name) {
            return variable.value(range, indices);
        }
        if AXIS_NAMES.contains(&name) || address.extension.is_some() {
            return Ok(SinumerikValue::Axis(axis_text(address)));
        }
        self.variables.undefined.push((address.name.to_string(), range));
        Ok(SinumerikValue::Unknown(name.into()))
    }

    fn call(
        &mut self,
        name: &str,
        arguments: &[Option<SinumerikValue>],
    ) -> Option<Result<SinumerikValue, EvaluationError>> {
        let first = arguments.first().and_then(Option::as_ref);
        match (name, first) {
            ("AXNAME", Some(SinumerikValue::Text(text))) => {
                Some(Ok(SinumerikValue::Axis(text.to_ascii_uppercase())))
            }
            ("AXSTRING", Some(SinumerikValue::Axis(axis))) => Some(Ok(SinumerikValue::text(axis))),
            _ if FUNCTIONS_OF_CONTROL.contains(&name) => {
                Some(Ok(SinumerikValue::Unknown(name.into())))
            }
            _ => None,
        }
    }
}

/// The name of an axis as a value: `X` for `X` and `X1`.
fn axis_text(address: &Address) -> String {
    match address.extension {
        Some(number) if number != 1 => format!("{}{number}", address.name),
        _ => address.name.to_string(),
    }
}

/// A system variable as the program writes it.
fn address_text(name: &str, keys: &[String]) -> String {
    if keys.is_empty() { name.to_string() } else { format!("{name}[{}]", keys.join(",")) }
}
