//! Pockets and fixed routines: checks their words; the kernel computes their paths and emits them as ordinary commands.

mod bore;
mod circular;
mod fixed;
mod general;
mod geometry;
mod no_motion;
