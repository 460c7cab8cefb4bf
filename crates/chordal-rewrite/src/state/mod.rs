//! The state at a position of a run, and the words that restore it: for the parts of a split program and for a restart at a
//! line.

mod open;
mod shift;
mod words;
mod writer;

pub(crate) use self::open::OpenConstructs;
pub(crate) use self::shift::limits_spindle;
pub(crate) use self::words::{StateSlot, StateWords};
pub(crate) use self::writer::{EXACT, StateWriter};
