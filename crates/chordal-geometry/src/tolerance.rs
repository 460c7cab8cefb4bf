//! Tolerances that several crates share, each with its reason. They are for rounding only: how exact a result must be is
//! always an argument.

/// Places nearer than this are the same place, mm.
///
/// Doubles leave up to a hundredth of it when a centre is computed from a radius or a few rounded words are added, for
/// coordinates of some metres; no control computes as finely.
pub const COINCIDENT_MM: f64 = 1e-9;

/// A value that is above its limit by less than this share of it is at the limit: the last digits of a product.
pub const ROUNDING_SHARE: f64 = 1e-9;
