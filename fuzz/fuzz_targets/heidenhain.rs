//! Conversational and DIN/ISO programs of HEIDENHAIN from any bytes: no crash, no hang, no number that is not finite.

#![no_main]

mod support;

use chordal::machine::Machine;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    support::run(Machine::from_builtin("heidenhain-mill").expect("a built-in machine"), bytes);
});
