//! Programs written anew: for another control, or changed in place.
//!
//! The old text is run, the new one is written from what it does and from how it is written, and
//! both are compared with each other move by move. What comes out is the text, a list of
//! [`Change`]s with their reasons, and a [`Certificate`] of how far the two are apart.

#![forbid(unsafe_code)]

mod change;
pub mod convert;
mod proof;
mod source;
mod split;
mod transform;

pub use change::Change;
pub use proof::{Certificate, prove, prove_contour, prove_mapped};
pub use split::{By, Part, Split, split};
pub use transform::{ArcForm, Refusal, Step, Transformed, transform};
