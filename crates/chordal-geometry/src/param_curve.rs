//! The trait of all curves.

use crate::{Aabb, ChordError, Chords, Placement, Transform, Vec3};

/// The point of a curve nearest to a given one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// Arc length from the curve's start to the point, mm.
    pub s: f64,
    /// The point on the curve, mm.
    pub point: Vec3,
    /// The distance between the two points, mm.
    pub distance: f64,
}

/// A curve, evaluated at its arc length `s` (mm) from the start.
///
/// `s` outside `0..=length()` means the nearer end. The two ends are returned exactly as the curve was made. A NaN in a
/// curve or an argument gives NaN in the result, never a panic.
pub trait ParamCurve: Sized {
    /// The start of the curve, mm.
    fn start(&self) -> Vec3;

    /// The end of the curve, mm.
    fn end(&self) -> Vec3;

    /// Length of the curve, mm.
    fn length(&self) -> f64;

    /// The point at `s` mm from the start, mm.
    fn point_at(&self, s: f64) -> Vec3;

    /// Unit tangent at `s` mm from the start; zero if the curve has no length.
    fn tangent_at(&self, s: f64) -> Vec3;

    /// Curvature vector d²p/ds² at `s` mm from the start, 1/mm: towards the centre of the osculating circle, with the
    /// inverse of its radius as length.
    fn curvature_at(&self, s: f64) -> Vec3;

    /// Derivative d³p/ds³ of the curvature vector at `s` mm from the start, 1/mm².
    fn curvature_derivative_at(&self, s: f64) -> Vec3;

    /// The point at `s` mm from the start, mm, and its first three derivatives with respect to `s`.
    fn jet_at(&self, s: f64) -> [Vec3; 4] {
        [
            self.point_at(s),
            self.tangent_at(s),
            self.curvature_at(s),
            self.curvature_derivative_at(s),
        ]
    }

    /// The smallest box around the curve, mm, from its exact extremes.
    fn bounds(&self) -> Aabb;

    /// The same curve in the opposite direction.
    #[must_use]
    fn reversed(&self) -> Self;

    /// The part before `s` mm from the start and the part after it. The end of the first equals the start of the second.
    #[must_use]
    fn split_at(&self, s: f64) -> (Self, Self);

    /// The part from `s0` to `s1` mm from the start; in the opposite direction if `s1 < s0`.
    #[must_use]
    fn subsegment(&self, s0: f64, s1: f64) -> Self;

    /// The curve after a transformation.
    #[must_use]
    fn transformed(&self, transform: &Transform) -> Self;

    /// The point nearest to `p` (mm) on the whole curve; if all points of an arc are equally near, the first.
    fn nearest(&self, p: Vec3) -> Nearest;

    /// Largest curvature anywhere on the curve, 1/mm.
    fn max_curvature(&self) -> f64;

    /// An iterator over the corners of a polyline that stays within `tolerance` mm of the curve, including both ends. The
    /// corners are not stored. See [`Chords`].
    ///
    /// # Errors
    /// If the tolerance is not above zero, the curve is not finite, or more than [`crate::MAX_CHORDS`] chords would be
    /// needed.
    fn chords(&self, tolerance: f64, placement: Placement) -> Result<Chords, ChordError>;

    /// The number of chords that [`ParamCurve::chords`] makes: one less than its points.
    ///
    /// # Errors
    /// As [`ParamCurve::chords`].
    fn chord_count(&self, tolerance: f64, placement: Placement) -> Result<u64, ChordError> {
        Ok(self.chords(tolerance, placement)?.chord_count())
    }
}
