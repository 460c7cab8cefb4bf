//! What the cycles do, as steps along the axis of the tool and in its plane. No program and no kernel is needed.

mod contours;
mod defined_patterns;
mod drilling;
mod faces;
mod input_ranges;
mod levels;
mod old_cycles;
mod outline;
mod patterns;
mod pockets;
mod signatures;
mod single_lip;
mod slots;
mod step;
mod studs;
mod threads;
mod values;

pub use contours::{
    TrainSide, contour_train_steps, rough_out_steps, side_finishing_steps, unreached_wall,
};
pub use defined_patterns::DefinedPattern;
pub use drilling::parameter_cycle_steps;
pub use input_ranges::refused_range;
pub use old_cycles::{OldCycle, OldCycleData, old_cycle_lines, old_cycle_steps};
pub use patterns::{PatternPoints, pattern_points};
pub use pockets::old_pocket_steps;
pub use signatures::{KlartextCycleRunner, MISSING_DEPTH, cycle_signature};
pub use slots::old_slot_steps;
pub use step::{CycleContext, CycleFeed, KlartextCycleFault, KlartextCycleStep};
pub use values::CycleValues;
