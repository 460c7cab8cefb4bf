//! Canned cycles: reads their words; the kernel makes the holes.

mod firing;
mod levels;
mod modal;
mod pattern;
