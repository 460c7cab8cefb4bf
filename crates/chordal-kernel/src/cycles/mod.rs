//! Canned cycles: the hole that the words make, the way there, the cut and the way out.

mod bore;
mod hole;
mod pattern;
mod peck;
mod steps;
mod tap;

pub use hole::HoleWords;
