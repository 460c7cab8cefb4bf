//! Named variables: `#<name>` of the running subroutine, `#<_name>` of the whole run.

use std::collections::BTreeMap;

use super::value::MacroValue;

/// Largest number of named variables, to stop a program that creates names in an endless loop.
const MAX_NAMES: usize = 100_000;

/// Named variables by their [`normal`] names.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct NamedVariables {
    globals: BTreeMap<String, MacroValue>,
    /// The local ones of each active call, the main program first.
    levels: Vec<BTreeMap<String, MacroValue>>,
}

/// A name without blanks, in lower case: LinuxCNC ignores both differences.
pub(crate) fn normal(name: &[u8]) -> String {
    let shown = |byte: &u8| !matches!(byte, b' ' | b'\t');
    let bytes: Vec<u8> = name.iter().filter(|b| shown(b)).map(u8::to_ascii_lowercase).collect();
    String::from_utf8_lossy(&bytes).into_owned()
}

impl NamedVariables {
    /// The value of a name; `None` when it is not set.
    pub fn get(&self, name: &str) -> Option<MacroValue> {
        let names = if name.starts_with('_') { Some(&self.globals) } else { self.levels.last() };
        names?.get(name).copied()
    }

    /// Sets a name; false when there are too many.
    pub fn set(&mut self, name: String, value: MacroValue) -> bool {
        let names = if name.starts_with('_') {
            &mut self.globals
        } else {
            if self.levels.is_empty() {
                self.levels.push(BTreeMap::new());
            }
            let last = self.levels.len() - 1;
            &mut self.levels[last]
        };
        if names.len() >= MAX_NAMES && !names.contains_key(&name) {
            return false;
        }
        names.insert(name, value);
        true
    }

    /// Begins a call.
    pub fn enter(&mut self) {
        if self.levels.is_empty() {
            self.levels.push(BTreeMap::new());
        }
        self.levels.push(BTreeMap::new());
    }

    /// Ends a call.
    pub fn leave(&mut self) {
        if self.levels.len() > 1 {
            self.levels.pop();
        }
    }

    /// The number of active calls.
    pub fn level(&self) -> usize {
        self.levels.len().saturating_sub(1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn locals_belong_to_their_call_and_globals_to_the_run() {
        let mut names = NamedVariables::default();
        names.set(normal(b"Depth Of Cut"), MacroValue::Number(2.0));
        names.set("_all".into(), MacroValue::Number(3.0));
        names.enter();
        assert_eq!(
            (names.get("depthofcut"), names.get("_all")),
            (None, Some(MacroValue::Number(3.0)))
        );
        names.set("depthofcut".into(), MacroValue::Number(5.0));
        names.leave();
        assert_eq!(names.get("depthofcut"), Some(MacroValue::Number(2.0)));
    }
}
