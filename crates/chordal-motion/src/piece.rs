//! A piece of the smoothed path: a polynomial for each axis, added to an arc if there is one.

use chordal_geometry::{AXES, Curve, ParamCurve, Vec3};

use crate::AxisValues;

/// For the cubic term of a Taylor series: multiplying takes a fraction of the time of dividing.
pub(crate) const SIXTH: f64 = 1.0 / 6.0;

/// The axes and their first three derivatives by σ.
pub type AxisJet = [AxisValues; 4];

/// A smooth piece of path: a cubic polynomial in σ for each axis, to which an arc or a
/// spiral of the program is added.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathPiece {
    /// Its length in σ.
    pub length: f64,
    /// The curve to which the polynomials of X, Y and Z are added, and the distance from its start at which the piece
    /// begins, mm; `None` where the polynomials are the whole path.
    pub base: Option<(Curve, f64)>,
    /// The polynomials: by axis, the values and first three derivatives at the start.
    pub start: AxisJet,
    /// The tag of its move.
    pub tag: u64,
}

impl PathPiece {
    /// Whether it is a straight line with all axes linear in σ.
    pub fn is_straight(&self) -> bool {
        self.base.is_none() && is_even(&self.start)
    }

    /// The axes and their derivatives at `sigma` from the piece's start.
    #[inline]
    pub fn at(&self, sigma: f64) -> AxisJet {
        let mut jet = ahead(&self.start, sigma, 6);
        if let Some((curve, from)) = &self.base {
            add_curve(&mut jet, curve.jet_at(from + sigma));
        }
        jet
    }
}

/// Adds the position and derivatives of the base curve to X, Y and Z.
#[inline]
pub(crate) fn add_curve(jet: &mut AxisJet, curve: [Vec3; 4]) {
    for (row, vector) in jet.iter_mut().zip(curve) {
        for (value, part) in row.iter_mut().zip(vector.to_array()) {
            *value += part;
        }
    }
}

/// A jet of cubic polynomials, moved ahead by `distance`; axes from `count` on are left as they are.
#[inline]
pub(crate) fn ahead(jet: &AxisJet, distance: f64, count: usize) -> AxisJet {
    let mut next = *jet;
    go_ahead(&mut next, distance, count);
    next
}

/// Moves a jet of cubic polynomials ahead by `distance`, except for axes from `count` on.
#[inline]
pub(crate) fn go_ahead(jet: &mut AxisJet, distance: f64, count: usize) {
    let [x, d1, d2, d3] = jet;
    for axis in 0..count.min(AXES) {
        let [first, second, third] = [d1[axis], d2[axis], d3[axis]];
        x[axis] += distance * (first + distance * (second / 2.0 + distance * (third * SIXTH)));
        d1[axis] = first + distance * (second + distance * (third / 2.0));
        d2[axis] = second + distance * third;
    }
}

/// Whether all polynomials are linear.
#[inline]
pub(crate) fn is_even(start: &AxisJet) -> bool {
    all_zero(&start[2]) && all_zero(&start[3])
}

/// Whether all polynomials are constant.
#[inline]
pub(crate) fn is_still(start: &AxisJet) -> bool {
    is_even(start) && all_zero(&start[1])
}

/// Without branches: it is called for many setpoints.
#[inline]
fn all_zero(values: &AxisValues) -> bool {
    let bits = values.iter().fold(0, |bits, value| bits | value.to_bits());
    // But for the sign of zero.
    bits << 1 == 0
}
