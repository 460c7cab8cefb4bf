//! Pulls setpoints of one kind of program as a servo does, for a profiler that counts instructions, or by the
//! clock:
//!
//! ```text
//! cargo build --release -p chordal-motion --example pull_once
//! valgrind --tool=callgrind --toggle-collect='*pull_once::take*' target/release/examples/pull_once dense
//! target/release/examples/pull_once all 200
//! ```
//!
//! With a number it pulls a thousand so many times and tells the quickest.

#![allow(clippy::disallowed_methods, reason = "an example is a shell")]

#[path = "../benches/programs/mod.rs"]
mod programs;
#[path = "../tests/support/mod.rs"]
mod support;

use std::time::Duration;

use programs::{PROGRAMS, Source};

/// Setpoints of a round.
const COUNT: u64 = 1000;

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let filter = words.first().map_or("all", String::as_str);
    let rounds: u32 = words.get(1).and_then(|word| word.parse().ok()).unwrap_or(20);
    for (name, program) in PROGRAMS {
        if filter != "all" && filter != name {
            continue;
        }
        let mut source = Source::new(program);
        let quickest = (0..rounds).map(|_| source.pull(COUNT, |_, _| {})).min();
        let nanoseconds = quickest.unwrap_or(Duration::ZERO).as_secs_f64() * 1e9 / COUNT as f64;
        println!("{name}: {nanoseconds:.0} ns a setpoint in the quickest of {rounds} rounds");
    }
}
