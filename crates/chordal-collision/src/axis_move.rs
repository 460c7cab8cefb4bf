//! A move of the axes of a machine.

use chordal_geometry::{Curve, ParamCurve, PerAxis};

/// A move of all axes: X, Y and Z along a curve, A, B and C evenly with its length. A move whose curve has no length takes
/// its rotary axes from one angle to another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisMove {
    /// The curve of X, Y and Z, machine coordinates, mm.
    pub curve: Curve,
    /// A, B and C at its start, rad.
    pub rotary_from: [f64; 3],
    /// A, B and C at its end, rad.
    pub rotary_to: [f64; 3],
    /// How far X, Y and Z may be from the curve, mm.
    pub deviation_mm: f64,
}

impl AxisMove {
    /// The positions of the axes at a share of the move from 0 to 1, mm and rad.
    #[must_use]
    pub fn at(&self, share: f64) -> PerAxis<f64> {
        let point = self.curve.point_at(share * self.curve.length());
        let [x, y, z] = point.to_array();
        let [a, b, c] = core::array::from_fn(|axis| {
            self.rotary_from[axis] * (1.0 - share) + self.rotary_to[axis] * share
        });
        [x, y, z, a, b, c]
    }

    /// How far each axis moves at most from its position at one share of the move to that at another one up to `by` away,
    /// mm and rad.
    pub(crate) fn travel(&self, by: f64) -> PerAxis<f64> {
        let along = self.curve.length() * by;
        let sides = match &self.curve {
            Curve::Line(line) => {
                let change = (line.end - line.start) * by;
                change.to_array().map(f64::abs)
            }
            curve => curve.bounds().size().to_array().map(|side| side.min(along)),
        };
        core::array::from_fn(|axis| match axis {
            0..3 => sides[axis],
            _ => (self.rotary_to[axis - 3] - self.rotary_from[axis - 3]).abs() * by,
        })
    }
}
