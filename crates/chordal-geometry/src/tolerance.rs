//! Tolerances that several crates share, each with its reason. They only allow for rounding; the accuracy of a result is
//! always an argument.

/// Points nearer than this are the same point, mm.
///
/// If a centre is computed from a radius or a few rounded words are added, the rounding error of doubles is up to a
/// hundredth of this for coordinates of some metres. It is below the resolution of every control.
pub const COINCIDENT_MM: f64 = 1e-9;

/// A value that exceeds its limit by less than this fraction of it is at the limit: the difference is rounding of a
/// product.
pub const ROUNDING_SHARE: f64 = 1e-9;
