//! Named variables: `#<name>` of the running subroutine, `#<_name>` of the whole run.

use std::collections::BTreeMap;

use super::value::MacroValue;

/// The largest number of named variables of one scope, to stop a program that creates names in an endless loop.
const MAX_NAMES: usize = 100_000;

/// Named variables by their [`normalized`] names.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct NamedVariables {
    globals: BTreeMap<String, MacroValue>,
    /// The local ones of each active call, the main program first.
    locals: Vec<BTreeMap<String, MacroValue>>,
}

/// A name without blanks, in lower case: LinuxCNC ignores both differences.
pub(crate) fn normalized(name: &[u8]) -> String {
    let is_blank = |byte: &u8| matches!(byte, b' ' | b'\t');
    let bytes: Vec<u8> =
        name.iter().filter(|byte| !is_blank(byte)).map(u8::to_ascii_lowercase).collect();
    String::from_utf8_lossy(&bytes).into_owned()
}

impl NamedVariables {
    /// The value of a name; `None` when it is not set.
    pub fn get(&self, name: &str) -> Option<MacroValue> {
        let scope = if name.starts_with('_') { Some(&self.globals) } else { self.locals.last() };
        scope?.get(name).copied()
    }

    /// Sets a variable; false when its scope has no room for another one.
    pub fn set(&mut self, name: String, value: MacroValue) -> bool {
        let scope = if name.starts_with('_') {
            &mut self.globals
        } else {
            if self.locals.is_empty() {
                self.locals.push(BTreeMap::new());
            }
            let last = self.locals.len() - 1;
            &mut self.locals[last]
        };
        if scope.len() >= MAX_NAMES && !scope.contains_key(&name) {
            return false;
        }
        scope.insert(name, value);
        true
    }

    /// Opens the scope of a call.
    pub fn enter(&mut self) {
        if self.locals.is_empty() {
            self.locals.push(BTreeMap::new());
        }
        self.locals.push(BTreeMap::new());
    }

    /// Drops the scope of the innermost call.
    pub fn leave(&mut self) {
        if self.locals.len() > 1 {
            self.locals.pop();
        }
    }

    /// The call depth: 0 in the main program.
    pub fn depth(&self) -> usize {
        self.locals.len().saturating_sub(1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn locals_belong_to_their_call_and_globals_to_the_run() {
        let mut names = NamedVariables::default();
        names.set(normalized(b"Depth Of Cut"), MacroValue::Number(2.0));
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
