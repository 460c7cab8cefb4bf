//! Canned cycles: each hole becomes the moves that the control makes.
//!
//! `levels` reads the words and finds the levels; `firing` decides when a block makes holes
//! and how many; `steps` goes there and cuts; `peck`, `tap` and `bore` are the steps of their
//! families; `pattern` places holes on circles and lines. What a control does otherwise than
//! its neighbours stands in `CycleRules`.

mod bore;
mod firing;
mod levels;
mod modal;
mod pattern;
mod peck;
mod steps;
mod tap;
