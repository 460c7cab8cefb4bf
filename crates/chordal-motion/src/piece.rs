use chordal_geometry::{Curve, ParamCurve, Tracer};

use crate::Axes;

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
        self.base.is_none() && self.start[2] == [0.0; 6] && self.start[3] == [0.0; 6]
    }

    /// The axes and their derivatives at `sigma` from the piece's start.
    #[inline]
    pub fn at(&self, sigma: f64) -> Jet {
        let [x, d1, d2, d3] = &self.start;
        let mut jet = [[0.0; 6]; 4];
        for axis in 0..6 {
            let second = d2[axis] + sigma * d3[axis];
            jet[0][axis] =
                x[axis] + sigma * (d1[axis] + sigma * (d2[axis] / 2.0 + sigma * (d3[axis] / 6.0)));
            jet[1][axis] = d1[axis] + sigma * (d2[axis] + sigma * (d3[axis] / 2.0));
            jet[2][axis] = second;
            jet[3][axis] = d3[axis];
        }
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

/// What is worth knowing of a piece before it is asked at many places.
#[derive(Clone, Copy, Debug)]
#[allow(clippy::large_enum_variant, reason = "one for a cursor, which allocates nothing")]
pub(crate) enum Shape {
    /// Every axis moves evenly with σ.
    Even,
    /// Likewise, above a curve from a place on.
    Over { base: Tracer, from: f64 },
    /// Anything else.
    Bent,
}

impl Shape {
    /// The shape of a piece.
    pub fn of(piece: &Piece) -> Shape {
        if piece.start[2..].iter().flatten().any(|value| *value != 0.0) {
            return Shape::Bent;
        }
        match &piece.base {
            Some((curve, from)) => Shape::Over { base: Tracer::new(curve), from: *from },
            None => Shape::Even,
        }
    }
}
