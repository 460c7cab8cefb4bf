//! The words that the folder of a control is written in: one import for each of its files.

pub(crate) use chordal_command::{FeedAlong, RapidPath, WorkNaming};
pub(crate) use chordal_diagnostics::Code;
pub(crate) use chordal_kernel::ToolValue;
pub(crate) use chordal_kernel::rules::*;
pub(crate) use chordal_syntax::{Lexicon, MacroGrammar, ParenthesisComment, Semicolon};

pub(crate) use crate::macros::*;
pub(crate) use crate::parameters::*;
pub(crate) use crate::settings::{
    CORNER_ROUNDING, Certainty, CompensationField as C, CycleField, Field, PathField, Setting,
    setting,
};
pub(crate) use crate::table::*;
