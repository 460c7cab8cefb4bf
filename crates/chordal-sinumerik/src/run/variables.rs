//! Variables: R parameters, definitions of the program, system variables.

use std::collections::HashMap;

use chordal_diagnostics::TextRange;
use chordal_machine::AXIS_NAMES;

use crate::alarms::NO_ALARM;
use crate::syntax::{Address, ExpressionKind, VariableType};
use crate::values::{EvaluationError, SinumerikValue, VariableSource};

/// Elements of an array at most.
const MAX_ELEMENTS: usize = 100_000;

/// A variable of a program.
#[derive(Clone, Debug)]
pub struct ProgramVariable {
    /// Its type.
    pub kind: VariableType,
    /// The sizes of its dimensions; empty for a single value.
    pub sizes: Vec<usize>,
    /// Its values, the last index running fastest.
    pub values: Vec<SinumerikValue>,
}

impl ProgramVariable {
    /// A variable with the value of its type at the start: zero, FALSE, an empty text.
    ///
    /// # Errors
    /// More elements than the budget allows.
    pub fn new(kind: VariableType, sizes: Vec<usize>) -> Result<ProgramVariable, String> {
        let count = sizes.iter().try_fold(1_usize, |all, size| all.checked_mul(*size));
        let count = count.filter(|count| *count <= MAX_ELEMENTS);
        let count =
            count.ok_or_else(|| format!("the array has more than {MAX_ELEMENTS} elements"))?;
        Ok(ProgramVariable { kind, sizes, values: vec![zero_of(kind); count] })
    }

    /// The place of an element.
    fn place(&self, range: TextRange, indices: &[i64]) -> Result<usize, EvaluationError> {
        let wrong = |alarm, message: String| EvaluationError::new(range, alarm, message);
        if indices.len() != self.sizes.len() {
            let message = format!("{} indices for {} dimensions", indices.len(), self.sizes.len());
            return Err(wrong(17020, message));
        }
        let mut place = 0;
        for (number, (index, size)) in indices.iter().zip(&self.sizes).enumerate() {
            let inside = usize::try_from(*index).ok().filter(|index| index < size);
            let Some(index) = inside else {
                let alarm = if number == 0 { 17020 } else { 17030 };
                return Err(wrong(alarm, format!("the index {index} is not in 0 to {}", size - 1)));
            };
            place = place * size + index;
        }
        Ok(place)
    }
}

/// The first value of a type.
pub fn zero_of(kind: VariableType) -> SinumerikValue {
    match kind {
        VariableType::Integer => SinumerikValue::Integer(0),
        VariableType::Boolean => SinumerikValue::Boolean(false),
        VariableType::Character => SinumerikValue::Character(0),
        VariableType::Text(_) => SinumerikValue::Text("".into()),
        VariableType::Axis => SinumerikValue::Axis(String::new()),
        VariableType::Real | VariableType::Frame => SinumerikValue::Real(0.0),
    }
}

/// All variables that a program may name, without those of the machine.
#[derive(Debug, Default)]
pub struct VariableStore {
    /// How many R parameters there are (MD28050).
    pub r_count: u32,
    /// R parameters by their number; those that nobody wrote are 0.
    r: HashMap<u32, f64>,
    /// R parameters that were read before the program set them, with the place of the read.
    pub unset_reads: Vec<(u32, TextRange)>,
    /// The variables of the running programs, the innermost last.
    pub locals: Vec<HashMap<String, ProgramVariable>>,
    /// What the program has written into system variables such as `$TC_DP6[1,1]`.
    pub system: HashMap<(String, Vec<i64>), SinumerikValue>,
    /// The programmed position of X, Y and Z, for `$P_EP`.
    pub position: [f64; 3],
}

impl VariableStore {
    /// The variable of the running program; `None` if the name is not defined.
    pub fn local(&mut self, name: &str) -> Option<&mut ProgramVariable> {
        self.locals.last_mut()?.get_mut(name)
    }

    /// The number of the R parameter that an address names; `None` for other addresses.
    fn r_number(address: &Address, indices: &[i64]) -> Option<i64> {
        let is_r = address.name == "R";
        let indexed = || indices.first().copied().filter(|_| indices.len() == 1);
        is_r.then(|| address.extension.map(i64::from).or_else(indexed)).flatten()
    }

    /// Writes a variable.
    ///
    /// # Errors
    /// The name is not defined, the index is outside, or the value does not fit the type.
    pub fn write(
        &mut self,
        address: &Address,
        indices: &[i64],
        value: SinumerikValue,
    ) -> Result<(), EvaluationError> {
        let range = address.range;
        if let Some(number) = VariableStore::r_number(address, indices) {
            let number = r_place(number, self.r_count, range)?;
            let real = value.to_real().map_err(|fault| fault.at(range))?;
            self.r.insert(number, real);
            return Ok(());
        }
        if address.name.starts_with('$') {
            self.system.insert((address.name.clone(), indices.to_vec()), value);
            return Ok(());
        }
        let Some(variable) = self.local(&address.name) else {
            return Err(not_defined(address));
        };
        let place = variable.place(range, indices)?;
        let converted = value.converted(variable.kind);
        variable.values[place] = converted.map_err(|fault| fault.at(range))?;
        Ok(())
    }
}

fn r_place(number: i64, count: u32, range: TextRange) -> Result<u32, EvaluationError> {
    let inside = u32::try_from(number).ok().filter(|number| *number < count);
    let message = format!("there is no R{number}: they end with R{}", count.saturating_sub(1));
    inside.ok_or(EvaluationError { range, alarm: 17020, message })
}

impl VariableSource for VariableStore {
    fn read(
        &mut self,
        address: &Address,
        indices: &[i64],
    ) -> Result<SinumerikValue, EvaluationError> {
        let range = address.range;
        if let Some(number) = VariableStore::r_number(address, indices) {
            let number = r_place(number, self.r_count, range)?;
            let value = self.r.get(&number).copied();
            if value.is_none() {
                self.unset_reads.push((number, range));
            }
            return Ok(SinumerikValue::Real(value.unwrap_or(0.0)));
        }
        if address.name == "$P_EP"
            && let Some(axis) = axis_of_index(address)
        {
            return Ok(SinumerikValue::Real(self.position[axis]));
        }
        if address.name.starts_with('$') {
            let known = self.system.get(&(address.name.clone(), indices.to_vec())).cloned();
            let message =
                format!("the value of {} depends on the machine and is not known", address.name);
            return known.ok_or(EvaluationError { range, alarm: NO_ALARM, message });
        }
        if let Some(variable) = self.local(&address.name) {
            let place = variable.place(range, indices)?;
            return Ok(variable.values[place].clone());
        }
        if AXIS_NAMES.contains(&address.name.as_str()) && address.extension.is_none() {
            return Ok(SinumerikValue::Axis(address.name.clone()));
        }
        Err(not_defined(address))
    }

    fn call(
        &mut self,
        _: &str,
        _: &[Option<SinumerikValue>],
    ) -> Option<Result<SinumerikValue, EvaluationError>> {
        None
    }
}

fn not_defined(address: &Address) -> EvaluationError {
    EvaluationError::new(address.range, 12550, format!("the name {} is not defined", address.name))
}

/// The axis that the first index of an address names.
fn axis_of_index(address: &Address) -> Option<usize> {
    match &address.indices.first()?.kind {
        ExpressionKind::Variable(name) => {
            AXIS_NAMES[..3].iter().position(|axis| *axis == name.name)
        }
        _ => None,
    }
}
