//! What every curve can answer.

use crate::{Aabb, ChordError, Chords, Placement, Transform, Vec3};

/// The point of a curve nearest to a given one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// Arc length from the curve's start to the point, mm.
    pub s: f64,
    /// The point on the curve, mm.
    pub point: Vec3,
    /// Its distance from the given point, mm.
    pub distance: f64,
}

/// A curve, asked by its arc length `s` (mm) from the start.
///
/// `s` outside `0..=length()` means the nearer end. The two ends are answered exactly as they were
/// given. A NaN in a curve or a question gives NaN in the answer, never a panic.
pub trait ParamCurve: Sized {
    /// Where the curve begins, mm.
    fn start(&self) -> Vec3;

    /// Where the curve ends, mm.
    fn end(&self) -> Vec3;

    /// Length of the curve, mm.
    fn length(&self) -> f64;

    /// The point at `s` mm from the start, mm.
    fn point_at(&self, s: f64) -> Vec3;

    /// Unit vector of travel at `s` mm from the start; zero when the curve has no length.
    fn tangent_at(&self, s: f64) -> Vec3;

    /// Curvature vector d²p/ds² at `s` mm from the start, 1/mm: towards the centre of the
    /// osculating circle, as long as the inverse of its radius.
    fn curvature_at(&self, s: f64) -> Vec3;

    /// Derivative d³p/ds³ of the curvature vector at `s` mm from the start, 1/mm².
    fn curvature_derivative_at(&self, s: f64) -> Vec3;

    /// The point at `s` mm from the start and its first three derivatives by `s`.
    fn jet_at(&self, s: f64) -> [Vec3; 4] {
        [
            self.point_at(s),
            self.tangent_at(s),
            self.curvature_at(s),
            self.curvature_derivative_at(s),
        ]
    }

    /// The smallest box around the curve, mm: exact extremes, not those of samples or of a hull.
    fn bounds(&self) -> Aabb;

    /// The same points from the end to the start.
    #[must_use]
    fn reversed(&self) -> Self;

    /// The part before `s` mm from the start and the part after it. The inner ends are equal.
    #[must_use]
    fn split_at(&self, s: f64) -> (Self, Self);

    /// The part from `s0` to `s1` mm from the start; travelled backwards when `s1 < s0`.
    #[must_use]
    fn subsegment(&self, s0: f64, s1: f64) -> Self;

    /// The curve moved, turned, mirrored or scaled.
    #[must_use]
    fn transformed(&self, transform: &Transform) -> Self;

    /// The point nearest to `p` (mm): the global one, and the first of equal ones on a circle.
    fn nearest(&self, p: Vec3) -> Nearest;

    /// Largest curvature anywhere on the curve, 1/mm.
    fn max_curvature(&self) -> f64;

    /// The corners of a polyline that stays within `tolerance` mm of the curve, the curve's own
    /// ends included, one after the other without storing them. See [`Chords`].
    ///
    /// # Errors
    /// When the tolerance is not above zero, or the curve is not finite, or more than
    /// [`crate::MAX_CHORDS`] chords would be needed.
    fn chords(&self, tolerance: f64, placement: Placement) -> Result<Chords, ChordError>;

    /// How many chords [`ParamCurve::chords`] makes: one fewer than its points.
    ///
    /// # Errors
    /// As [`ParamCurve::chords`].
    fn chord_count(&self, tolerance: f64, placement: Placement) -> Result<u64, ChordError> {
        Ok(self.chords(tolerance, placement)?.chord_count())
    }
}
