//! Plans one row of moves once, for a profiler that counts instructions:
//!
//! ```text
//! cargo build --release -p chordal-motion --example plan_once
//! valgrind --tool=callgrind target/release/examples/plan_once surface 100000
//! ```
//!
//! With the word `corners` no moves are joined as curves. With the word `make` the moves are made and not
//! planned: what that takes is to be taken off.

#![allow(clippy::disallowed_methods, reason = "an example is a shell")]

#[path = "../benches/rows/mod.rs"]
mod rows;

use std::time::Instant;

const KINDS: &str = "surface, spiral, wiggle, arcs, ellipse or harmonics";

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let (kind, count, how) = match words[..] {
        [kind, count] => (kind, count.parse().ok(), "curves"),
        [kind, count, how] => (kind, count.parse().ok(), how),
        _ => ("", None, ""),
    };
    let moves_of = match kind {
        "surface" => rows::surface,
        "spiral" => rows::spiral,
        "wiggle" => rows::wiggle,
        "arcs" => rows::arcs,
        "ellipse" => rows::ellipse,
        "harmonics" => rows::harmonics,
        _ => return println!("say {KINDS}, and how many moves"),
    };
    let Some(count) = count else { return println!("the number of moves is missing") };
    let moves = moves_of(count);
    if how != "make" {
        let start = Instant::now();
        let time_s = rows::plan(&moves, how != "corners");
        let millions = count as f64 / start.elapsed().as_secs_f64() / 1e6;
        println!("{count} moves take {time_s:.9} s, planned at {millions:.3} M/s");
    }
}
