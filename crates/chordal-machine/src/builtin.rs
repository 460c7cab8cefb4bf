//! The machines that come with the program: those in the folders of the controls.

use std::sync::LazyLock;

include!(concat!(env!("OUT_DIR"), "/machines.rs"));

static NAMES: LazyLock<Vec<&'static str>> =
    LazyLock::new(|| FILES.iter().map(|(name, _)| *name).collect());

/// The machine file of a built-in machine.
pub fn builtin(name: &str) -> Option<&'static str> {
    FILES.iter().find(|(own, _)| *own == name).map(|(_, text)| *text)
}

/// The names of the built-in machines.
pub fn builtin_names() -> &'static [&'static str] {
    &NAMES
}
