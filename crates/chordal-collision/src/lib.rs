//! Which bodies of a machine touch while its axes move, so that nothing is missed between two looked at positions.
//!
//! [`MachineLinks`] is the machine as a tree: the base, what each axis moves, the part, the tool. [`LinkedSolid`]s are convex
//! bodies on it. [`PairCheck`] follows two of them along an [`AxisMove`]: in the middle of an interval it takes their
//! distance, and bounds how far any of their points moves within the interval. Where the distance is larger nothing
//! touches there; otherwise the interval is halved.
//!
//! With a tolerance `t`, bodies that touch somewhere on the move are always reported, and bodies that stay `t` apart never.
//! What the budget of distances does not decide is reported as undecided.
//!
//! Lengths are millimetres, angles radians. Results are bit-identical on every machine. The crate knows no program, no
//! control and no file.
//!
//! ```
//! use chordal_collision::{AxisMove, LinkedSolid, MachineLinks, PairAnswer, PairCheck};
//! use chordal_geometry::{ConvexSolid, Curve, Line, Vec3};
//! use chordal_kinematics::{KinematicChain, RotaryMount};
//!
//! // A spindle that moves along X, and a plate of 0.1 mm on the base in its way.
//! let links = MachineLinks::new(&KinematicChain::CARTESIAN, [RotaryMount::Head; 3], [0, 1, 2]);
//! let spindle = ConvexSolid::cuboid(Vec3::new(-5.0, -5.0, 0.0), Vec3::new(5.0, 5.0, 50.0))?;
//! let plate = ConvexSolid::cuboid(Vec3::new(80.0, -50.0, -50.0), Vec3::new(80.1, 50.0, 50.0))?;
//! let bodies = [
//!     LinkedSolid::new(links.tool(), spindle),
//!     LinkedSolid::new(links.base(), plate),
//! ];
//! let across = Line { start: Vec3::ZERO, end: Vec3::X * 200.0 };
//! let path = AxisMove { curve: Curve::Line(across), rotary_from: [0.0; 3], rotary_to: [0.0; 3], deviation_mm: 0.0 };
//! let mut budget = 10_000;
//! let answer = PairCheck::new(&links, &bodies[0], &bodies[1]).along(&path, 0.01, &mut budget);
//! assert!(matches!(answer, PairAnswer::Contact { .. }));
//! # Ok::<(), chordal_geometry::SolidError>(())
//! ```

#![forbid(unsafe_code)]

mod axis_move;
mod links;
mod pair;

pub use axis_move::AxisMove;
pub use links::{LinkJoint, MachineLinks};
pub use pair::{LinkedSolid, PairAnswer, PairCheck, PairOverlap};
