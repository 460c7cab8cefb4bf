//! What is in force at a place of a run, and how a program that begins there says it again: for parts of a program and for
//! one that begins at a line.

mod open;
mod shift;
mod words;
mod writer;

pub(crate) use self::open::OpenConstructs;
pub(crate) use self::shift::limits_spindle;
pub(crate) use self::words::{StateSlot, StateWords};
pub(crate) use self::writer::{EXACT, StateWriter};
