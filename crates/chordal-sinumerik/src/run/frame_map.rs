//! The programmable frame: TRANS, ROT, SCALE and MIRROR as one map of points.

/// Where the programmable frame puts a programmed point in the coordinates of the settable frame (G54): a matrix and
/// a shift, mm. Only X, Y and Z are mapped.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FrameMap {
    matrix: [[f64; 3]; 3],
    shift: [f64; 3],
}

impl FrameMap {
    /// The frame that changes nothing.
    pub const IDENTITY: FrameMap =
        FrameMap { matrix: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], shift: [0.0; 3] };

    /// A shift, mm.
    pub fn shifted(by: [f64; 3]) -> FrameMap {
        FrameMap { shift: by, ..FrameMap::IDENTITY }
    }

    /// Factors of the axes; −1 mirrors.
    pub fn scaled(by: [f64; 3]) -> FrameMap {
        let mut map = FrameMap::IDENTITY;
        (0..3).for_each(|axis| map.matrix[axis][axis] = by[axis]);
        map
    }

    /// A rotation about one axis (0 for X), degrees, counterclockwise seen from its positive end.
    pub fn turned(axis: usize, degrees: f64) -> FrameMap {
        let (sin, cos) = sin_cos(degrees);
        let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut map = FrameMap::IDENTITY;
        map.matrix[a][a] = cos;
        map.matrix[b][b] = cos;
        map.matrix[a][b] = -sin;
        map.matrix[b][a] = sin;
        map
    }

    /// The rotation of `ROT X Y Z`: about X first, then Y, then Z, each about the axes before the rotation
    /// (MD10600 = 1, Fundamentals 11/2006, 6.5).
    pub fn rotated(degrees: [f64; 3]) -> FrameMap {
        let [x, y, z] = [0, 1, 2].map(|axis| FrameMap::turned(axis, degrees[axis]));
        z.then_inner(&y).then_inner(&x)
    }

    /// This frame with another one inside it, whose points this one maps: the A forms (ATRANS, AROT …).
    pub fn then_inner(&self, inner: &FrameMap) -> FrameMap {
        let mut matrix = [[0.0; 3]; 3];
        for (row, out) in matrix.iter_mut().enumerate() {
            for (column, cell) in out.iter_mut().enumerate() {
                *cell = (0..3).map(|k| self.matrix[row][k] * inner.matrix[k][column]).sum();
            }
        }
        FrameMap { matrix, shift: self.point(inner.shift) }
    }

    /// Where a programmed point is.
    pub fn point(&self, point: [f64; 3]) -> [f64; 3] {
        let turned = self.vector(point);
        std::array::from_fn(|axis| turned[axis] + self.shift[axis])
    }

    /// A direction or a distance in the outer coordinates.
    pub fn vector(&self, vector: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|row| (0..3).map(|k| self.matrix[row][k] * vector[k]).sum())
    }

    /// The programmed coordinates of a point.
    pub fn inverse_point(&self, point: [f64; 3]) -> [f64; 3] {
        let inner: [f64; 3] = std::array::from_fn(|axis| point[axis] - self.shift[axis]);
        if self.is_diagonal() {
            return std::array::from_fn(|axis| inner[axis] / self.matrix[axis][axis]);
        }
        let m = &self.matrix;
        let minor = |r: usize, c: usize| {
            let ([r0, r1], [c0, c1]) = ([(r + 1) % 3, (r + 2) % 3], [(c + 1) % 3, (c + 2) % 3]);
            m[r0][c0] * m[r1][c1] - m[r0][c1] * m[r1][c0]
        };
        let determinant: f64 = (0..3).map(|c| m[0][c] * minor(0, c)).sum();
        std::array::from_fn(|row| {
            (0..3).map(|k| minor(k, row) * inner[k]).sum::<f64>() / determinant
        })
    }

    /// True if each axis depends on itself alone, so that an axis that is not programmed does not move.
    pub fn is_diagonal(&self) -> bool {
        (0..3).all(|row| (0..3).all(|column| row == column || self.matrix[row][column] == 0.0))
    }

    /// How a circle of the plane with these axes is mapped; `None` if it is no circle of the same plane any more.
    pub fn circle_in_plane(&self, a: usize, b: usize, normal: usize) -> Option<CircleMap> {
        let m = &self.matrix;
        let leaves_plane = [m[normal][a], m[normal][b], m[a][normal], m[b][normal]];
        let [first, second] = [[m[a][a], m[b][a]], [m[a][b], m[b][b]]];
        let [one, other] = [first, second].map(|v| v[0].hypot(v[1]));
        let dot = first[0] * second[0] + first[1] * second[1];
        // Rounding of sines and cosines is below this.
        const EQUAL: f64 = 1e-9;
        let is_similar = (one - other).abs() <= EQUAL * one && dot.abs() <= EQUAL * one * other;
        if leaves_plane.iter().any(|value| value.abs() > EQUAL) || !is_similar {
            return None;
        }
        let determinant = first[0] * second[1] - first[1] * second[0];
        Some(CircleMap { factor: one, is_mirrored: determinant < 0.0 })
    }
}

/// How a frame maps circles of a plane.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CircleMap {
    /// The factor of radii.
    pub factor: f64,
    /// Clockwise becomes counterclockwise.
    pub is_mirrored: bool,
}

/// Sine and cosine of an angle in degrees, exact for quarter turns.
pub fn sin_cos(degrees: f64) -> (f64, f64) {
    match degrees.rem_euclid(360.0) {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        other => libm::sincos(other.to_radians()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(found: [f64; 3], expected: [f64; 3]) {
        let far = (0..3).any(|axis| (found[axis] - expected[axis]).abs() > 5e-5);
        assert!(!far, "{found:?} is not {expected:?}");
    }

    #[test]
    fn three_angles_turn_about_the_axes_before_the_rotation() {
        near(FrameMap::rotated([30.0, 0.0, 90.0]).point([0.0, 10.0, 0.0]), [-8.6603, 0.0, 5.0]);
        near(FrameMap::rotated([20.0, 30.0, 40.0]).point([10.0, 0.0, 0.0]), [6.6341, 5.5667, -5.0]);
    }

    #[test]
    fn additive_frames_act_in_the_axes_so_far() {
        let chain = FrameMap::shifted([10.0, 0.0, 0.0])
            .then_inner(&FrameMap::turned(2, 90.0))
            .then_inner(&FrameMap::shifted([5.0, 0.0, 0.0]));
        near(chain.point([1.0, 0.0, 0.0]), [10.0, 6.0, 0.0]);
        near(chain.inverse_point([10.0, 6.0, 0.0]), [1.0, 0.0, 0.0]);
    }

    #[test]
    fn circles_stay_circles_where_both_axes_are_scaled_alike() {
        let mirrored =
            FrameMap::scaled([-2.0, 2.0, 5.0]).circle_in_plane(0, 1, 2).expect("a circle");
        assert_eq!((mirrored.factor, mirrored.is_mirrored), (2.0, true));
        assert_eq!(FrameMap::scaled([1.0, 2.0, 1.0]).circle_in_plane(0, 1, 2), None);
        assert_eq!(FrameMap::turned(0, 30.0).circle_in_plane(0, 1, 2), None);
        assert!(FrameMap::turned(2, 30.0).circle_in_plane(0, 1, 2).is_some());
    }
}
