//! What the cycles do, as steps along the axis of the tool and in its plane. No program and no kernel is needed.

mod drilling;
mod old_cycles;
mod patterns;
mod pockets;
mod signatures;
mod step;
mod threads;
mod values;

pub use drilling::{is_drilling_cycle, parameter_cycle_steps};
pub use old_cycles::{OldCycle, OldCycleData, old_cycle_steps};
pub use patterns::{PatternPoints, pattern_points};
pub use pockets::{is_pocket_cycle, old_pocket_steps, pocket_steps};
pub use signatures::{KlartextCycleSignature, MISSING_DEPTH, cycle_signature, old_cycle_lines};
pub use step::{CycleContext, CycleFeed, KlartextCycleFault, KlartextCycleStep};
pub use threads::{is_thread_cycle, thread_steps};
pub use values::CycleValues;
