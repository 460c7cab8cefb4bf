//! A linear map of positions with an offset, and its inverse.

use chordal_command::{AxisMask, Position};
use chordal_geometry::Plane;
use chordal_machine::AXES;

/// Number of linear axes; the others are rotary.
const LINEAR: usize = 3;

/// Maps program coordinates to the work coordinate system: X Y Z by a matrix, each rotary axis by a
/// factor, and all by an offset.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FrameMap {
    /// Rows of the matrix of X, Y and Z.
    rows: [[f64; LINEAR]; LINEAR],
    /// Factors of A, B and C.
    factors: [f64; AXES - LINEAR],
    /// Added at the end, mm and rad.
    offset: Position,
}

impl FrameMap {
    /// The map that changes nothing.
    pub const IDENTITY: FrameMap = FrameMap {
        rows: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        factors: [1.0; AXES - LINEAR],
        offset: [0.0; AXES],
    };

    /// Adds an offset, mm and rad.
    pub const fn translation(offset: Position) -> FrameMap {
        FrameMap { offset, ..FrameMap::IDENTITY }
    }

    /// Scales each axis by its own factor about a centre.
    pub fn scaling(center: &Position, factors: &Position) -> FrameMap {
        let mut map = FrameMap::IDENTITY;
        for axis in 0..AXES {
            match axis {
                0..LINEAR => map.rows[axis][axis] = factors[axis],
                _ => map.factors[axis - LINEAR] = factors[axis],
            }
            if factors[axis] != 1.0 {
                map.offset[axis] = center[axis] - factors[axis] * center[axis];
            }
        }
        map
    }

    /// Rotates in a plane about a centre on its two axes, degrees from the first axis to the second.
    pub fn rotation(plane: Plane, center: [f64; 2], degrees: f64) -> FrameMap {
        let (a, b, _) = plane.axes();
        let (sin, cos) = sin_cos_degrees(degrees);
        let mut map = FrameMap::IDENTITY;
        map.rows[a][a] = cos;
        map.rows[a][b] = -sin;
        map.rows[b][a] = sin;
        map.rows[b][b] = cos;
        map.offset[a] = center[0] - (cos * center[0] - sin * center[1]);
        map.offset[b] = center[1] - (sin * center[0] + cos * center[1]);
        map
    }

    /// This map followed by `next`.
    pub fn then(&self, next: &FrameMap) -> FrameMap {
        let mut rows = [[0.0; LINEAR]; LINEAR];
        for (row, of_next) in rows.iter_mut().zip(&next.rows) {
            for (column, value) in row.iter_mut().enumerate() {
                *value = (0..LINEAR).map(|k| of_next[k] * self.rows[k][column]).sum();
            }
        }
        let factors = std::array::from_fn(|axis| self.factors[axis] * next.factors[axis]);
        FrameMap { rows, factors, offset: next.point(&self.offset) }
    }

    /// The inverse map; no factor may be zero.
    pub fn inverse(&self) -> FrameMap {
        let m = &self.rows;
        // The cofactors, column by column.
        let cofactor = |row: usize, column: usize| {
            let (r1, r2) = ((row + 1) % LINEAR, (row + 2) % LINEAR);
            let (c1, c2) = ((column + 1) % LINEAR, (column + 2) % LINEAR);
            m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1]
        };
        let determinant = self.determinant();
        let mut inverse = FrameMap {
            rows: std::array::from_fn(|row| {
                std::array::from_fn(|column| cofactor(column, row) / determinant)
            }),
            factors: self.factors.map(|factor| 1.0 / factor),
            offset: [0.0; AXES],
        };
        let moved = inverse.point(&self.offset);
        inverse.offset = moved.map(|value| 0.0 - value);
        inverse
    }

    fn determinant(&self) -> f64 {
        let m = &self.rows;
        m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
            - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
            + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
    }

    /// Maps a point.
    pub fn point(&self, place: &Position) -> Position {
        std::array::from_fn(|axis| self.turned(place, axis) + self.offset[axis])
    }

    /// Maps a difference of two points: without the offset.
    pub fn vector(&self, difference: &Position) -> Position {
        std::array::from_fn(|axis| self.turned(difference, axis))
    }

    fn turned(&self, place: &Position, axis: usize) -> f64 {
        let Some(rotary) = axis.checked_sub(LINEAR) else {
            // A sum over zeros would lose the sign of a zero and let a NaN of another axis in.
            let row = self.rows[axis];
            let used = (0..LINEAR).filter(|&column| row[column] != 0.0);
            return used
                .map(|column| row[column] * place[column])
                .fold(0.0, |sum, term| sum + term);
        };
        self.factors[rotary] * place[axis]
    }

    /// The axes of the result that depend on any of these.
    pub fn reached(&self, axes: AxisMask) -> AxisMask {
        let mut reached = axes.without(AxisMask::LINEAR);
        for (axis, row) in self.rows.iter().enumerate() {
            if (0..LINEAR).any(|column| row[column] != 0.0 && axes.has(column)) {
                reached.insert(axis);
            }
        }
        reached
    }

    /// The axes of the result that are known when these axes are.
    pub fn known(&self, axes: AxisMask) -> AxisMask {
        AxisMask::ALL.without(self.reached(AxisMask::ALL.without(axes)))
    }

    /// What it does to the circles of a plane.
    pub fn in_plane(&self, plane: Plane) -> InPlane {
        let (a, b, normal) = plane.axes();
        let m = &self.rows;
        let (first, second) = ([m[a][a], m[b][a]], [m[a][b], m[b][b]]);
        let lengths = [first, second].map(|[x, y]| (x * x + y * y).sqrt());
        let largest = lengths[0].max(lengths[1]);
        // Rotations about several axes that cancel each other leave the rounding of their sines.
        let near = 1e-12 * largest;
        let tilts = [(a, normal), (b, normal), (normal, a), (normal, b)];
        if tilts.iter().any(|&(row, column)| m[row][column].abs() > near) {
            return InPlane::Tilted;
        }
        let square = (first[0] * second[0] + first[1] * second[1]).abs() <= near * largest;
        let mirrored = first[0] * second[1] - first[1] * second[0] < 0.0;
        if square && (lengths[0] - lengths[1]).abs() <= near {
            InPlane::Similar { factor: lengths[0], mirrored }
        } else {
            InPlane::Unequal { largest, mirrored }
        }
    }

    /// Factor by which a length along an axis is multiplied.
    pub fn factor_along(&self, axis: usize) -> f64 {
        match axis.checked_sub(LINEAR) {
            Some(rotary) => self.factors[rotary].abs(),
            None => (0..LINEAR).map(|row| self.rows[row][axis].powi(2)).sum::<f64>().sqrt(),
        }
    }
}

/// What a map does to the circles of a plane.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum InPlane {
    /// Circles remain circles.
    Similar {
        /// Ratio of lengths.
        factor: f64,
        /// Left and right are exchanged.
        mirrored: bool,
    },
    /// Circles become ellipses.
    Unequal {
        /// The larger of the two factors.
        largest: f64,
        /// Left and right are exchanged.
        mirrored: bool,
    },
    /// The plane is no longer a plane of two axes.
    Tilted,
}

impl InPlane {
    /// Left and right are exchanged.
    pub const fn is_mirrored(self) -> bool {
        match self {
            InPlane::Similar { mirrored, .. } | InPlane::Unequal { mirrored, .. } => mirrored,
            InPlane::Tilted => false,
        }
    }
}

/// Sine and cosine, exact for whole quarter turns.
pub fn sin_cos_degrees(degrees: f64) -> (f64, f64) {
    let turned = degrees.rem_euclid(360.0);
    match turned {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        _ => libm::sincos(turned.to_radians()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_map_and_its_inverse() {
        let turn = FrameMap::rotation(Plane::Xy, [10.0, 5.0], 30.0);
        let scale =
            FrameMap::scaling(&[1.0, 2.0, 3.0, 0.0, 0.0, 0.5], &[2.0, -3.0, 0.5, 1.0, 1.0, 4.0]);
        let both = scale.then(&turn);
        let place = [7.0, -8.0, 9.0, 0.1, 0.2, 0.3];
        let back = both.inverse().point(&both.point(&place));
        for axis in 0..AXES {
            assert!((back[axis] - place[axis]).abs() < 1e-12, "{back:?}");
        }
        assert_eq!(scale.in_plane(Plane::Xy), InPlane::Unequal { largest: 3.0, mirrored: true });
        assert_eq!(turn.in_plane(Plane::Zx), InPlane::Tilted);
    }

    #[test]
    fn what_is_known_through_a_turn() {
        let turn = FrameMap::rotation(Plane::Xy, [0.0, 0.0], 30.0);
        let (x, z) = (AxisMask(1), AxisMask(4));
        assert_eq!(turn.reached(x), AxisMask(3));
        assert_eq!(turn.known(x.or(z)), z);
        assert_eq!(FrameMap::rotation(Plane::Xy, [0.0, 0.0], 90.0).known(x), AxisMask(2));
    }
}
