//! Interpreting any bytes on any machine: no crash, no hang, no number that is not finite.

#![no_main]

mod support;

use chordal::machine::{Machine, builtin_names};
use libfuzzer_sys::fuzz_target;
use std::sync::OnceLock;

/// Every built-in machine, first as it is, then with offsets known, so that machine
/// coordinates and travel come into play. Reading them once leaves the time for programs.
fn machines() -> &'static [Machine] {
    static MACHINES: OnceLock<Vec<Machine>> = OnceLock::new();
    MACHINES.get_or_init(|| {
        let plain = builtin_names()
            .iter()
            .map(|name| Machine::from_builtin(name).expect("a built-in machine"));
        let plain: Vec<Machine> = plain.collect();
        let with_offsets = plain.clone().into_iter().map(|mut machine| {
            let assignments =
                ["work_offsets.G54.X=1 in", "work_offsets.E1.Z=-3 in", "tools.1.length=2 in"];
            for assignment in assignments {
                machine.set(assignment).expect("a good assignment");
            }
            machine
        });
        plain.iter().cloned().chain(with_offsets).collect()
    })
}

fuzz_target!(|bytes: &[u8]| {
    let Some((choice, text)) = bytes.split_first() else { return };
    let machine = machines()[*choice as usize % machines().len()].clone();
    support::run(machine, text);
});
