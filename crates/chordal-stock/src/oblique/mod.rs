//! Tools whose axis is not along Z, and turns while they move.
//!
//! A tool is a union of convex [`ConvexElement`]s of revolution. Within a piece of a move the reference point of an
//! element runs nearly straight and the axis hardly turns: its sweep is that of the element in its middle direction
//! along a straight line, up to a deviation that is bounded in closed form ([`SweptElement`]). So the element shrunk by
//! the deviation certainly stays inside of the true sweep, and the element grown by it contains it. Both are
//! convex, and what a vertical line has in common with them follows from quadratic equations ([`chord`]).

mod chord;
mod element;
mod solid;
mod swept;
mod turn;

pub(crate) use element::ConvexElement;
pub use solid::AxialSolid;
pub(crate) use swept::{ElementMotion, SweptElement};
pub use turn::{AxisTurn, ToolTurn};
