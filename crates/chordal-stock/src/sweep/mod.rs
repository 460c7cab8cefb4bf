//! The floor of a straight move of a cutter, computed for four columns at once.
//!
//! A path is divided into straight pieces ([`pieces`]), a cutter into parts whose floor is a convex function of the
//! column's position ([`BodyPart`]). For a piece and a part, [`strip`] says which columns no neighbour takes, and
//! [`lanes`] computes the floor in single precision, with the rounding error counted as a horizontal shift.

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

/// A move of the tool tip with a tag.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TipMove {
    /// The path of the tip, mm.
    pub curve: Curve,
    /// Volumes are counted separately for each tag, such as the number of a tool.
    pub tag: u32,
}
