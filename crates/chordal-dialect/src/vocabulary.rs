//! The words that the folder of a control is written in: one import for each of its files.

pub(crate) use chordal_command::{FeedAlong, RapidPath, WorkNaming};
pub(crate) use chordal_diagnostics::Code;
pub(crate) use chordal_geometry::{Plane, TurnDirection};
pub(crate) use chordal_kernel::ToolValue;
pub(crate) use chordal_kernel::rules::*;
pub(crate) use chordal_syntax::{
    BracketStyle, Function, Lexicon, MacroGrammar, Operator, OperatorRow, ParenthesisComment,
    Semicolon, operator,
};

pub(crate) use crate::block_order::{BUILDER_STEPS, BlockOrder, GRBL_STEPS, RS274_STEPS};
pub(crate) use crate::command_line::CommandLine;
pub(crate) use crate::firmware::{
    BlockRules, BuildOption, DumpMeaning, DumpRow, Firmware, FirmwareError, LineRules, RefusalRow,
    SlashMeaning,
};
pub(crate) use crate::macros::*;
pub(crate) use crate::parameters::*;
pub(crate) use crate::recognition::*;
pub(crate) use crate::settings::{
    CORNER_ROUNDING, Certainty, Setting, SettingField, setting, short_blocks,
};
pub(crate) use crate::spatial::SpatialRules;
pub(crate) use crate::surface::{SurfaceRules, SurfaceWord};
pub(crate) use crate::table::*;
pub(crate) use crate::tilted_plane::TiltedPlaneRules;
pub(crate) use crate::word_rules::{WordRule, WordTest};

/// The words that tables of codes are written in.
pub(crate) mod codes {
    pub(crate) use chordal_kernel::SplineForm;
    pub(crate) use chordal_kernel::rules::{CycleKind, HolePattern};

    pub(crate) use crate::action::Action::{self, *};
    pub(crate) use crate::action::AfterCode::*;
    pub(crate) use crate::action::BeforeCode::*;
    pub(crate) use crate::action::CallCode::*;
    pub(crate) use crate::action::LengthCode::*;
    pub(crate) use crate::action::ModeCode::*;
    pub(crate) use crate::action::MotionCode::*;
    pub(crate) use crate::action::OnceCode::*;
    pub(crate) use crate::action::PathCode;
    pub(crate) use crate::action::ReadingCode::*;
    pub(crate) use crate::action::{SurfaceCode, TiltedPlaneCode};
    pub(crate) use crate::table::{ANY_WORDS, CodeGroup, CodeRow, row};
}
