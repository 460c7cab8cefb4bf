//! Variables: R parameters, definitions of the program, system variables.

use std::collections::HashMap;

use chordal_diagnostics::TextRange;

use crate::syntax::{Address, VariableType};
use crate::values::{EvaluationError, SinumerikValue, ValueFault};

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
    /// A size of 0, or more elements than the budget allows.
    pub fn new(kind: VariableType, sizes: Vec<usize>) -> Result<ProgramVariable, ValueFault> {
        if sizes.contains(&0) {
            let message = "the size of an array must be 1 or more".to_string();
            return Err(ValueFault { alarm: 12430, message });
        }
        let count = sizes.iter().try_fold(1_usize, |all, size| all.checked_mul(*size));
        let count = count.filter(|count| *count <= MAX_ELEMENTS);
        let count = count.ok_or_else(|| ValueFault {
            alarm: 12080,
            message: format!("the array has more than {MAX_ELEMENTS} elements"),
        })?;
        Ok(ProgramVariable { kind, sizes, values: vec![zero_of(kind); count] })
    }

    /// A variable with a value that nobody gave.
    ///
    /// # Errors
    /// A size of 0, or more elements than the budget allows.
    pub fn unknown(
        kind: VariableType,
        sizes: Vec<usize>,
        name: &str,
    ) -> Result<ProgramVariable, ValueFault> {
        let mut variable = ProgramVariable::new(kind, sizes)?;
        variable.values.fill(SinumerikValue::Unknown(name.into()));
        Ok(variable)
    }

    /// The value of an element.
    ///
    /// # Errors
    /// The indices are not those of an element.
    pub fn value(
        &self,
        range: TextRange,
        indices: &[i64],
    ) -> Result<SinumerikValue, EvaluationError> {
        Ok(self.values[self.place(range, indices)?].clone())
    }

    /// The place of an element.
    ///
    /// # Errors
    /// The indices are not those of an element.
    pub fn place(&self, range: TextRange, indices: &[i64]) -> Result<usize, EvaluationError> {
        let wrong = |alarm, message: String| EvaluationError::new(range, alarm, message);
        if indices.len() != self.sizes.len() {
            let message = format!("{} indices for {} dimensions", indices.len(), self.sizes.len());
            return Err(wrong(12400, message));
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
    r: HashMap<u32, SinumerikValue>,
    /// R parameters that were read before the program set them, with the place of the read.
    pub unset_reads: Vec<(u32, TextRange)>,
    /// The variables of the running programs, the innermost last.
    pub locals: Vec<HashMap<String, ProgramVariable>>,
    /// What the program has written into system variables such as `$AC_MARKER[1]`, by name and indices.
    system: HashMap<(String, Vec<String>), SinumerikValue>,
    /// User data of the control by name (GUD): those of definition files, and names that the program writes and
    /// nothing defines.
    pub user_data: HashMap<String, ProgramVariable>,
    /// Names that nothing defines, with the place where each was used.
    pub undefined: Vec<(String, TextRange)>,
}

impl VariableStore {
    /// The variable of the running program, or the user data of a name; `None` if the name is not defined.
    pub fn named(&mut self, name: &str) -> Option<&mut ProgramVariable> {
        match self.locals.last_mut()?.get_mut(name) {
            Some(own) => Some(own),
            None => self.user_data.get_mut(name),
        }
    }

    /// Reads an R parameter; one that nobody wrote is 0, and is noted.
    ///
    /// # Errors
    /// There is no R parameter of this number.
    pub fn read_r(
        &mut self,
        number: i64,
        range: TextRange,
    ) -> Result<SinumerikValue, EvaluationError> {
        let number = r_place(number, self.r_count, range)?;
        let value = self.r.get(&number).cloned();
        if value.is_none() {
            self.unset_reads.push((number, range));
        }
        Ok(value.unwrap_or(SinumerikValue::Real(0.0)))
    }

    /// The value that the program has written into a system variable; `None` without one.
    pub fn written_system_value(&self, name: &str, key: &[String]) -> Option<SinumerikValue> {
        self.system.get(&(name.to_string(), key.to_vec())).cloned()
    }

    /// Writes an R parameter.
    ///
    /// # Errors
    /// There is none of this number, or the value is no number.
    pub fn write_r(
        &mut self,
        number: i64,
        range: TextRange,
        value: SinumerikValue,
    ) -> Result<(), EvaluationError> {
        let number = r_place(number, self.r_count, range)?;
        let converted = value.converted(VariableType::Real).map_err(|fault| fault.at(range))?;
        self.r.insert(number, converted);
        Ok(())
    }

    /// Remembers what the program writes into a system variable.
    pub fn write_system_value(&mut self, name: &str, key: Vec<String>, value: SinumerikValue) {
        if self.system.len() < MAX_ELEMENTS {
            self.system.insert((name.to_string(), key), value);
        }
    }

    /// Writes a variable of the program or a user datum. A name that nothing defines becomes one, and is noted.
    ///
    /// # Errors
    /// The index is outside, or the value does not fit the type.
    pub fn write_named(
        &mut self,
        address: &Address,
        indices: &[i64],
        value: SinumerikValue,
    ) -> Result<(), EvaluationError> {
        let range = address.range;
        if self.named(&address.name).is_none() {
            self.undefined.push((address.name.to_string(), range));
            if indices.is_empty() {
                let variable = ProgramVariable {
                    kind: VariableType::Real,
                    sizes: Vec::new(),
                    values: vec![value],
                };
                self.user_data.insert(address.name.to_string(), variable);
            }
            return Ok(());
        }
        let Some(variable) = self.named(&address.name) else { return Ok(()) };
        let place = variable.place(range, indices)?;
        let converted = value.converted(variable.kind);
        variable.values[place] = converted.map_err(|fault| fault.at(range))?;
        Ok(())
    }

    /// A variable one of whose elements gets a value at an index that nobody knows: none of them is known any more.
    pub fn lose(&mut self, name: &str, cause: &SinumerikValue) {
        if let Some(variable) = self.named(name) {
            variable.values.fill(cause.clone());
        }
    }
}

/// The number of the R parameter that an address names; `None` for other addresses.
pub fn r_number(address: &Address, indices: &[i64]) -> Option<i64> {
    let is_r = address.name == "R";
    let indexed = || indices.first().copied().filter(|_| indices.len() == 1);
    is_r.then(|| address.extension.map(i64::from).or_else(indexed)).flatten()
}

fn r_place(number: i64, count: u32, range: TextRange) -> Result<u32, EvaluationError> {
    let inside = u32::try_from(number).ok().filter(|number| *number < count);
    let message = format!("there is no R{number}: they end with R{}", count.saturating_sub(1));
    inside.ok_or(EvaluationError { range, alarm: 17020, message })
}
