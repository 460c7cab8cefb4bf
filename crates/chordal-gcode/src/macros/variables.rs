//! Local and common variables.

use super::value::{MacroValue, UnknownCause};
use chordal_dialect::macros::{MacroRules, UnsetValue, VariableRange};

/// Largest number of local variables of a level.
const LOCALS: usize = 64;

/// The variables of a run, except system variables.
#[derive(Clone, Debug)]
pub(crate) struct VariableStore {
    /// The locals of each macro level; index 0 is not used.
    levels: Vec<[MacroValue; LOCALS]>,
    locals: u32,
    /// The values of each range of the table, allocated when first written; `None` for the unknown value from before the
    /// program.
    common: Vec<Vec<Option<MacroValue>>>,
    ranges: &'static [VariableRange],
    unset: MacroValue,
}

impl PartialEq for VariableStore {
    fn eq(&self, other: &VariableStore) -> bool {
        let same = |a: &[MacroValue], b: &[MacroValue]| {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.is_same(*b))
        };
        let same_common = |a: &[Option<MacroValue>], b: &[Option<MacroValue>]| {
            let is_same = |(a, b): (&Option<MacroValue>, &Option<MacroValue>)| match (a, b) {
                (Some(a), Some(b)) => a.is_same(*b),
                (a, b) => a.is_none() && b.is_none(),
            };
            a.len() == b.len() && a.iter().zip(b).all(is_same)
        };
        self.levels.len() == other.levels.len()
            && self.levels.iter().zip(&other.levels).all(|(a, b)| same(a, b))
            && self.common.len() == other.common.len()
            && self.common.iter().zip(&other.common).all(|(a, b)| same_common(a, b))
    }
}

/// The number is not a local or common variable.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct NotHere;

impl VariableStore {
    pub fn new(rules: &MacroRules) -> VariableStore {
        let unset = match rules.unset {
            UnsetValue::Null => MacroValue::Vacant,
            UnsetValue::Zero => MacroValue::Number(0.0),
        };
        VariableStore {
            levels: Vec::new(),
            locals: rules.locals.min(LOCALS as u32 - 1),
            common: Vec::new(),
            ranges: rules.common,
            unset,
        }
    }

    /// The level of macro calls, 0 in the main program.
    pub fn level(&self) -> u32 {
        self.levels.len().saturating_sub(1) as u32
    }

    /// Begins a macro call: a new level with its arguments.
    pub fn enter(&mut self, arguments: &[(u32, MacroValue)]) {
        if self.levels.is_empty() {
            self.levels.push([self.unset; LOCALS]);
        }
        self.levels.push([self.unset; LOCALS]);
        for &(number, value) in arguments {
            self.set_local(number, value);
        }
    }

    /// Ends a macro call.
    pub fn leave(&mut self) {
        if self.levels.len() > 1 {
            self.levels.pop();
        }
    }

    /// All local variables of the current level.
    pub fn locals(&mut self) -> &mut [MacroValue] {
        if self.levels.is_empty() {
            self.levels.push([self.unset; LOCALS]);
        }
        let last = self.levels.len() - 1;
        &mut self.levels[last]
    }

    fn set_local(&mut self, number: u32, value: MacroValue) {
        if let Some(place) = self.locals().get_mut(number as usize) {
            *place = value;
        }
    }

    /// The value of a local or common variable. A common one keeps the value of an earlier program, some even after
    /// power-off: it is unknown until this program writes it.
    pub fn read(&self, number: u32) -> Result<MacroValue, NotHere> {
        if number == 0 {
            return Ok(self.unset);
        }
        if number <= self.locals {
            return Ok(self.levels.last().map_or(self.unset, |level| level[number as usize]));
        }
        let (range, at) = self.place(number)?;
        let written = self.common.get(range).and_then(|values| values.get(at)).copied().flatten();
        Ok(written.unwrap_or(MacroValue::Unknown(UnknownCause::Variable(number))))
    }

    /// Writes a local or common variable.
    pub fn write(&mut self, number: u32, value: MacroValue) -> Result<(), NotHere> {
        let value = if value == MacroValue::Vacant { self.unset } else { value };
        if (1..=self.locals).contains(&number) {
            self.set_local(number, value);
            return Ok(());
        }
        let (range, at) = self.place(number)?;
        if self.common.is_empty() {
            self.common = vec![Vec::new(); self.ranges.len()];
        }
        let size = (self.ranges[range].last - self.ranges[range].first + 1) as usize;
        let values = &mut self.common[range];
        if values.is_empty() {
            *values = vec![None; size];
        }
        values[at] = Some(value);
        Ok(())
    }

    /// The range and the index in it of a common variable; second numbers of a variable are resolved.
    fn place(&self, number: u32) -> Result<(usize, usize), NotHere> {
        let range = self.find(number)?;
        let row = self.ranges[range];
        if row.stored == row.first {
            return Ok((range, (number - row.first) as usize));
        }
        let stored = number - row.first + row.stored;
        let range = self.find(stored)?;
        Ok((range, (stored - self.ranges[range].first) as usize))
    }

    fn find(&self, number: u32) -> Result<usize, NotHere> {
        let index = self.ranges.partition_point(|range| range.last < number);
        match self.ranges.get(index) {
            Some(range) if range.first <= number => Ok(index),
            _ => Err(NotHere),
        }
    }
}
