//! Part programs of Sinumerik from any bytes, on its mill and its lathe: no crash, no hang, no number that is not finite.

#![no_main]

mod support;

use chordal::machine::Machine;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let Some((choice, text)) = bytes.split_first() else { return };
    let name = if choice % 2 == 0 { "sinumerik-mill" } else { "sinumerik-lathe" };
    support::run(Machine::from_builtin(name).expect("a built-in machine"), text);
});
