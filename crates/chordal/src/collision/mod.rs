//! Collisions of the bodies of a machine, the setup and the tools, along every move of a program.
//!
//! [`Job::collide`](crate::Job::collide) follows the axes through a run. The verdict is "clean" only where that is proved
//! for every pair of bodies and every move.

mod bodies;
mod doubts;
mod moves;
mod on_part;
mod problems;
mod report;
mod run;

pub use chordal_collision::LinkJoint;
pub use on_part::{MachineOnPart, PartRelativeBody};
pub use report::{CollisionProblem, CollisionReport, CollisionVerdict};
pub use run::{CollisionError, CollisionOptions};
