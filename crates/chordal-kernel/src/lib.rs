//! What any numerical control does, and no text: state, offsets, motion, cycles, pockets.
//!
//! A language reads a program and gives values with their [`Statement`]; the [`Kernel`] moves the
//! machine and pushes commands and problems into a sink. [`rules`] are plain data: how one control
//! does a thing otherwise than the next.

#![forbid(unsafe_code)]

mod checkpoint;
mod coordinates;
mod cycles;
mod kernel;
mod language;
mod modal;
mod modes;
mod motion;
pub mod offsets;
mod overrides;
mod path_mode;
mod pockets;
pub mod rules;
mod sink;
pub mod state;
mod statement;

pub use checkpoint::{Checkpoint, Memory};
pub use coordinates::ToolValue;
pub use cycles::Hole;
pub use kernel::{Alarms, Kernel, KernelMemory, Reported};
pub use language::{Class, EndReason, Language, Outcome, ProgramPlace, Ran, Token};
pub use modal::{Modal, MotionMode};
pub use motion::{ArcWords, SpiralWords, is_over};
pub use offsets::{LengthOffset, Offsets};
pub use path_mode::PathState;
pub use pockets::{CirclesWords, MAX_RINGS, RegionWords, rings_to_depth, shapes};
pub use sink::RunSink;
pub use state::{CycleState, Motion, OverrideState, State};
pub use statement::{Statement, What};
