//! The mill of `tests/motion/mill.toml`, changed by a test.

use chordal::Machine;

/// A machine file that may say `inherits = "mill.toml"`.
pub fn machine(text: &str) -> Machine {
    let mill = |_: &str| Ok(include_str!("../../../../tests/motion/mill.toml").to_string());
    Machine::from_toml("m.toml", text, &mill).expect("a machine")
}
