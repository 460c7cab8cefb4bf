//! What a control makes of a block: one table per control, modal state, calls and cycles;
//! the result is a stream of canonical [`Command`]s.
//!
//! A control is data: [`table::ControlTable`] lists its codes, habits, settings and alarms,
//! and the interpreter asks the table. See `controls/` for the five tables.

#![forbid(unsafe_code)]

mod choices;
mod command;
mod compensation;
mod compensation_settings;
mod control;
mod controls;
mod cycle_rules;
mod interpreter;
mod library;
pub mod macros;
mod modal;
mod offsets;
mod parameters;
mod path_modes;
mod pocket;
mod recognize;
mod settings;
mod shop;
mod state;
mod subs;
pub mod table;

pub use command::*;
pub use compensation::*;
pub use compensation_settings::CompensationField;
pub use control::Control;
pub use controls::{ALL as CONTROLS, table};
pub use cycle_rules::*;
pub use interpreter::{
    EndReason, Interrupt, Outcome, Rest, RunOptions, initial_offset, initial_work_offset, run,
    run_from, subroutine_head,
};
pub use library::{Library, Program, referenced_programs};
pub use modal::Modal;
pub use parameters::*;
pub use path_modes::{PathField, PathRules, StartMode};
pub use recognize::{Recognition, recognize};
pub use settings::{
    COMMON as COMMON_SETTINGS, Certainty, Field, Setting, SettingError, value_text,
};
pub use shop::{ShopAnswer, ShopCall, ShopCode, ShopCodes, ShopRecord};
pub use subs::called_subs;
