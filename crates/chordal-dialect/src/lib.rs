//! The controls as data: one folder each, listed in [`CONTROLS`].
//!
//! [`ControlTable`] says what a control has: its codes and the words they take, its rules, settings, macro
//! language, alarms and the signs by which its programs are recognized. [`Control`] is a table as one machine uses
//! it, with the settings of the machine file applied.
//!
//! ```
//! use chordal_dialect::{Action, Control, MotionCode};
//! use chordal_machine::Machine;
//!
//! let machine = Machine::from_builtin("haas-vf2").unwrap();
//! let (control, wrong_settings) = Control::of(&machine).unwrap();
//! assert!(wrong_settings.is_empty());
// Codes are in tenths: 20 is G2.
//! let row = control.g_code(20).unwrap();
//! assert_eq!(row.action, Action::Motion(MotionCode::ArcCw));
//! ```

#![forbid(unsafe_code)]

mod action;
mod block_order;
mod command_line;
mod control;
mod controls;
pub mod dump;
mod facts;
pub mod firmware;
mod lathe_signs;
pub mod macros;
pub mod not_read;
mod parameters;
mod post;
pub mod recognition;
mod scale;
mod settings;
mod spatial;
mod surface;
pub mod table;
mod tilted_plane;
mod vocabulary;
mod word_rules;

pub use action::{
    Action, AfterCode, BeforeCode, CallCode, CallTarget, LengthCode, ModeCode, MotionCode,
    OnceCode, PathCode, ReadingCode, SurfaceCode, TiltedPlaneCode,
};
pub use block_order::{BlockOrder, BlockStep};
pub use command_line::CommandLine;
pub use control::{Control, FIRST_ALIAS_SUBPROGRAM};
pub use controls::{ALL as CONTROLS, table};
pub use facts::{
    BlockSort, CodeFacts, CycleWordRole, TurnFacts, WordMeanings, cycle_word_role, dwell_text,
    turn_facts,
};
pub use parameters::*;
pub use post::PostTemplate;
pub use scale::LiteralScale;
pub use settings::{COMMON as COMMON_SETTINGS, Certainty, Setting, SettingField};
pub use spatial::SpatialRules;
pub use surface::{SurfaceRules, SurfaceWord};
pub use table::{CodeGroup, CodeRow, ControlTable, DataTarget, code_name, code_number};
pub use tilted_plane::TiltedPlaneRules;
pub use word_rules::{WordRule, WordTest};
