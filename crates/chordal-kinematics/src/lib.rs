//! The kinematics of a machine with rotary axes: a chain of at most two rotary axes from the part to the tool, with the
//! linear axes between tables and heads.
//!
//! Lengths are in millimetres, angles in radians. Results are closed forms, and bit-identical on every machine. Signs are
//! those of ISO 841: a positive angle turns the tool relative to the part by the right-hand rule, whether a table or a
//! head does it.
//!
//! ```
//! use chordal_geometry::Vec3;
//! use chordal_kinematics::{KinematicChain, RotaryJoint, RotaryLetter, SolutionRule};
//!
//! // A round table C on a tilting table A.
//! let chain = KinematicChain::new(&[
//!     RotaryJoint::table(RotaryLetter::C, Vec3::new(-300.0, -200.0, 0.0)),
//!     RotaryJoint::table(RotaryLetter::A, Vec3::new(0.0, -200.0, -400.0)),
//! ])?;
//! let solutions = chain.joint_solutions(Vec3::new(0.3, 0.4, 0.75_f64.sqrt()))?;
//! let present = [0.0, 0.0, -40.0_f64.to_radians()];
//! let angles = chain.choose(&solutions, &present, SolutionRule::LEAST_MOVEMENT)?;
//! assert!((angles[0].to_degrees() + 30.0).abs() < 1e-9);
//!
//! let tool = chain.tool_vector(100.0);
//! let gauge_point = chain.gauge_point(Vec3::new(-290.0, -200.0, -360.0), &angles, tool);
//! let tip = chain.pose(gauge_point, &angles, tool).tip;
//! assert!(tip.distance(Vec3::new(-290.0, -200.0, -360.0)) < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | to | see |
//! |---|---|
//! | describe a machine | [`RotaryJoint`], [`KinematicChain`], [`linuxcnc`] |
//! | get the tip and the direction of the tool from the axes | [`KinematicChain::pose`] |
//! | get the axes from them | [`KinematicChain::joint_solutions`], [`KinematicChain::choose`], [`KinematicChain::gauge_point`] |
//! | follow a path with the tip | [`JointPath`], [`TipMotion`] |
//! | bound the positions of the axes on it | [`JointPath::bounds`] |
//! | see how far the tip leaves its line if the axes run straight | [`KinematicChain::straight_deviation`] |
//! | see how far the tool swings aside while the axes turn evenly | [`KinematicChain::swing`] |
//! | turn the tool along a great circle | [`OrientationArc`] |

#![forbid(unsafe_code)]

mod chain;
mod choice;
mod extreme;
mod inverse;
mod jet;
mod joint;
mod joint_path;
pub mod linuxcnc;
mod math;
mod orientation_arc;
mod straight_move;
mod swing;
mod triangle;

pub use chain::{ChainError, KinematicChain, MAX_JOINTS, ToolPose};
pub use choice::{AngleSign, ChoiceError, SolutionRule};
pub use inverse::{AxisPositions, DirectionError, JointSolution, JointSolutions};
pub use jet::{AngleJet, AxisJet, TipJet};
pub use joint::{JointAngles, RolloverRule, RotaryJoint, RotaryLetter, RotaryMount};
pub use joint_path::{JointPath, TipLine, TipMotion};
pub use orientation_arc::{MAX_PARTS, OrientationArc, OrientationError};
