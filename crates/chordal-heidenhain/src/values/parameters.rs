//! The parameters of a run.

use std::collections::{BTreeMap, BTreeSet};

use crate::syntax::{ParameterBank, ParameterName};

/// The parameters with a value.
#[derive(Clone, Default, PartialEq, Debug)]
pub struct ParameterStore {
    numbers: BTreeMap<ParameterName, f64>,
    /// A parameter that was never set is 0, as on old controls.
    pub unset_is_zero: bool,
    texts: BTreeMap<u32, String>,
    /// Set from something that is not known here.
    unknown: BTreeSet<ParameterName>,
}

impl ParameterStore {
    /// The value of a parameter; `None` if it was never set, or is not known.
    pub fn number(&self, name: ParameterName) -> Option<f64> {
        let is_zero = || self.unset_is_zero && !self.is_unknown(name);
        self.numbers.get(&name).copied().or_else(|| is_zero().then_some(0.0))
    }

    /// Whether a parameter has a value on the control that is not known here: it depends on such a value, keeps what
    /// another program has set (QR), or is set by the control itself.
    pub fn is_unknown(&self, name: ParameterName) -> bool {
        let is_kept = name.bank == ParameterBank::Retained || name.is_of_control();
        self.unknown.contains(&name) || is_kept && !self.numbers.contains_key(&name)
    }

    /// Whether a parameter was set from something that is not known here.
    pub fn was_lost(&self, name: ParameterName) -> bool {
        self.unknown.contains(&name)
    }

    /// Forgets the value of a parameter, which is not known from here on.
    pub fn set_unknown(&mut self, name: ParameterName) {
        self.numbers.remove(&name);
        self.unknown.insert(name);
    }

    /// Sets a Q parameter, or forgets its value.
    pub fn set_shared_if_known(&mut self, number: u32, value: Option<f64>) {
        let name = ParameterName { bank: ParameterBank::Shared, number };
        match value {
            Some(value) => self.set(name, value),
            None => self.set_unknown(name),
        }
    }

    /// Whether a parameter was set.
    pub fn is_set(&self, name: ParameterName) -> bool {
        self.numbers.contains_key(&name)
    }

    /// Sets a parameter.
    pub fn set(&mut self, name: ParameterName, value: f64) {
        self.unknown.remove(&name);
        self.numbers.insert(name, value);
    }

    /// Sets a Q parameter.
    pub fn set_shared(&mut self, number: u32, value: f64) {
        self.set(ParameterName { bank: ParameterBank::Shared, number }, value);
    }

    /// The text of a QS parameter; `None` if it was never set.
    pub fn text(&self, number: u32) -> Option<&str> {
        self.texts.get(&number).map(String::as_str)
    }

    /// Sets a QS parameter.
    pub fn set_text(&mut self, number: u32, text: String) {
        self.texts.insert(number, text);
    }

    /// Takes the local parameters (QL) out: a called program has its own.
    pub fn take_locals(&mut self) -> BTreeMap<ParameterName, f64> {
        let is_local = |name: &ParameterName| name.bank == ParameterBank::Local;
        let locals = self.numbers.iter().filter(|(name, _)| is_local(name));
        let locals = locals.map(|(name, value)| (*name, *value)).collect();
        self.numbers.retain(|name, _| !is_local(name));
        locals
    }

    /// Puts the local parameters of the calling program back.
    pub fn restore_locals(&mut self, locals: BTreeMap<ParameterName, f64>) {
        self.take_locals();
        self.numbers.extend(locals);
    }
}
