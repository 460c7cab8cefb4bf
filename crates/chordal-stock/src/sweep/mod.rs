//! The floor below a straight move of a cutter: what it depends on, and its value for four columns at once.
//!
//! A path is cut into straight pieces ([`pieces`]), a cutter into parts whose floor is a convex function of
//! the column ([`BodyPart`]). For a piece and a part, [`strip`] says which columns no neighbour takes, and
//! [`lanes`] gives the floor in single precision, with the rounding counted as a horizontal shift.

mod body;
pub(crate) mod lanes;
mod part;
mod pieces;
pub(crate) mod shape;
pub(crate) mod strip;

use chordal_geometry::Curve;

pub use body::RevolvedBody;
pub(crate) use part::{BodyPart, PartShape, parts};
pub(crate) use pieces::{MoveSplitter, SweepPiece};

/// A move of the tool tip, and whose it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TipMove {
    /// The path of the tip, mm.
    pub curve: Curve,
    /// By this number volumes are told apart: the number of a tool, say.
    pub tag: u32,
}
