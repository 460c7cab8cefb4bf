//! The built-in machines, from the folders of the controls.

use std::sync::LazyLock;

include!(concat!(env!("OUT_DIR"), "/machines.rs"));

static NAMES: LazyLock<Vec<&'static str>> =
    LazyLock::new(|| FILES.iter().map(|(name, _)| *name).collect());

/// The text of the machine file of a built-in machine; `None` if there is none with this name.
pub fn builtin(name: &str) -> Option<&'static str> {
    FILES.iter().find(|(own, _)| *own == name).map(|(_, text)| *text)
}

/// The names of the built-in machines.
pub fn builtin_names() -> &'static [&'static str] {
    &NAMES
}
