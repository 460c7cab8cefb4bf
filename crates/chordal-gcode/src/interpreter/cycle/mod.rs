//! Canned cycles: their words are read here, the kernel drills.

mod firing;
mod levels;
mod modal;
mod pattern;
