//! A piece of the smoothed path: a polynomial on every axis, with an arc under it or not.

use chordal_geometry::{Curve, ParamCurve};

use crate::Axes;

/// Multiplying takes a fraction of the time of dividing.
pub(crate) const SIXTH: f64 = 1.0 / 6.0;

/// The axes and their first three derivatives by σ.
pub type Jet = [Axes; 4];

/// A piece of path without kinks: a polynomial of the third degree in σ on every axis, and an
/// arc or a spiral below it where the program has one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// Its extent in σ.
    pub length: f64,
    /// What lies below X, Y and Z, and how far from its start the piece begins.
    pub base: Option<(Curve, f64)>,
    /// By axis: the values of the polynomial and its first three derivatives at the start.
    pub start: Jet,
    /// The tag of its move.
    pub tag: u64,
}

impl Piece {
    /// Whether it is a straight line, evenly travelled.
    pub fn is_straight(&self) -> bool {
        self.base.is_none() && self.is_even()
    }

    /// Whether its polynomials are of the first degree.
    #[inline]
    pub(crate) fn is_even(&self) -> bool {
        all_zero(&self.start[2]) && all_zero(&self.start[3])
    }

    /// Whether its polynomials are constant.
    #[inline]
    pub(crate) fn is_still(&self) -> bool {
        self.is_even() && all_zero(&self.start[1])
    }

    /// The axes and their derivatives at `sigma` from the piece's start.
    #[inline]
    pub fn at(&self, sigma: f64) -> Jet {
        let mut jet = ahead(&self.start, sigma, 6);
        if let Some((curve, from)) = &self.base {
            for (row, vector) in jet.iter_mut().zip(curve.jet_at(from + sigma)) {
                for (value, part) in row.iter_mut().zip(vector.to_array()) {
                    *value += part;
                }
            }
        }
        jet
    }
}

/// A jet of polynomials of the third degree, further on; axes from `count` on stay as they are.
#[inline]
pub(crate) fn ahead(jet: &Jet, way: f64, count: usize) -> Jet {
    let [x, d1, d2, d3] = jet;
    let mut next = *jet;
    for axis in 0..count {
        next[0][axis] =
            x[axis] + way * (d1[axis] + way * (d2[axis] / 2.0 + way * (d3[axis] * SIXTH)));
        next[1][axis] = d1[axis] + way * (d2[axis] + way * (d3[axis] / 2.0));
        next[2][axis] = d2[axis] + way * d3[axis];
    }
    next
}

/// Without branches: it is asked at many a setpoint.
#[inline]
fn all_zero(values: &Axes) -> bool {
    let bits = values.iter().fold(0, |bits, value| bits | value.to_bits());
    // But for the sign of zero.
    bits << 1 == 0
}
