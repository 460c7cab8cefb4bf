//! Plans one row of moves once, for a profiler that counts instructions:
//!
//! ```text
//! cargo build --release -p chordal-motion --example plan_once
//! valgrind --tool=callgrind target/release/examples/plan_once surface 100000
//! ```
//!
//! With one more word the moves are made and not planned: what that takes is to be taken off.

#![allow(clippy::disallowed_methods, reason = "an example is a shell")]

#[path = "../benches/rows/mod.rs"]
mod rows;

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let (kind, count, plans) = match &words[..] {
        [kind, count] => (kind.as_str(), count.parse().ok(), true),
        [kind, count, _] => (kind.as_str(), count.parse().ok(), false),
        _ => ("", None, false),
    };
    let make = match kind {
        "surface" => rows::surface,
        "spiral" => rows::spiral,
        "wiggle" => rows::wiggle,
        "arcs" => rows::arcs,
        _ => return println!("say surface, spiral, wiggle or arcs, and how many moves"),
    };
    let Some(count) = count else { return println!("the number of moves is missing") };
    let moves = make(count);
    if plans {
        println!("{} moves take {:.9} s", moves.len(), rows::plan(&moves));
    }
}
