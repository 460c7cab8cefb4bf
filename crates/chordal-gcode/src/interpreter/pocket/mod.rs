//! Pockets and fixed routines: their words are judged here, their paths come from
//! `crate::pocket`, and go out as ordinary commands.

mod bore;
mod circular;
mod fixed;
mod general;
mod geometry;
mod no_motion;
