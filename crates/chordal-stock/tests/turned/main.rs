//! Turned stock: worked cases, closed forms, a second method, odd input.
//!
//! More: `CHORDAL_ROUNDS=100000 cargo test --release -p chordal-stock --test turned`.

#![allow(clippy::disallowed_methods, reason = "how many random passes is asked of the environment")]

mod closed_forms;
mod nasty;
mod properties;
mod raster;
mod shop;
mod tools;
mod worked;
