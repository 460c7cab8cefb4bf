//! The programmable frame: TRANS, ROT, SCALE and MIRROR as one map of points.

use chordal_command::{AxisMask, Position};
use chordal_geometry::Plane;
use chordal_kernel::frames::{FrameMap, InPlane};

/// The programmable frame: where it puts a programmed point in the coordinates of the settable frame (G54).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ProgrammableFrame {
    map: FrameMap,
    inverse: FrameMap,
}

impl ProgrammableFrame {
    /// The frame that changes nothing.
    pub const IDENTITY: ProgrammableFrame =
        ProgrammableFrame { map: FrameMap::IDENTITY, inverse: FrameMap::IDENTITY };

    /// The frame with a map.
    pub fn new(map: FrameMap) -> ProgrammableFrame {
        ProgrammableFrame { map, inverse: map.inverse() }
    }

    /// The position of a programmed position.
    pub fn point(&self, programmed: &Position) -> Position {
        self.map.point(programmed)
    }

    /// The axes that move when these are programmed.
    pub fn reached(&self, axes: AxisMask) -> AxisMask {
        self.map.reached(axes)
    }

    /// The programmed X, Y and Z of a position, mm.
    pub fn programmed(&self, place: &Position) -> [f64; 3] {
        let [x, y, z, ..] = self.inverse.point(place);
        [x, y, z]
    }

    /// What it does to the circles of a plane.
    pub fn in_plane(&self, plane: Plane) -> InPlane {
        self.map.in_plane(plane)
    }
}

/// The shift of a map, mm, if it does nothing else.
pub fn shift_of(map: &FrameMap) -> Option<[f64; 3]> {
    let [x, y, z, ..] = map.point(&[0.0; 6]);
    let only_shift = FrameMap::translation(linear([x, y, z], 0.0));
    (*map == only_shift).then_some([x, y, z])
}

/// X, Y and Z with the same value for each rotary axis.
pub fn linear([x, y, z]: [f64; 3], rotary: f64) -> Position {
    [x, y, z, rotary, rotary, rotary]
}

/// Factors of the axes; −1 mirrors.
pub fn scaled(factors: [f64; 3]) -> FrameMap {
    FrameMap::scaling(&[0.0; 6], &linear(factors, 1.0))
}

/// The rotation of `ROT X Y Z`, degrees: about X first, then Y, then Z, each about the axes before the rotation
/// (MD10600 = 1, Fundamentals 11/2006, 6.5).
pub fn rotated(degrees: [f64; 3]) -> FrameMap {
    let [x, y, z] = [(Plane::Yz, 0), (Plane::Zx, 1), (Plane::Xy, 2)]
        .map(|(plane, axis)| FrameMap::rotation(plane, [0.0; 2], degrees[axis]));
    x.then(&y).then(&z)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(found: [f64; 3], expected: [f64; 3]) {
        let far = (0..3).any(|axis| (found[axis] - expected[axis]).abs() > 5e-5);
        assert!(!far, "{found:?} is not {expected:?}");
    }

    fn point(map: FrameMap, place: [f64; 3]) -> [f64; 3] {
        let [x, y, z, ..] = map.point(&linear(place, 0.0));
        [x, y, z]
    }

    fn turned(plane: Plane, degrees: f64) -> FrameMap {
        FrameMap::rotation(plane, [0.0; 2], degrees)
    }

    #[test]
    fn three_angles_turn_about_the_axes_before_the_rotation() {
        near(point(rotated([30.0, 0.0, 90.0]), [0.0, 10.0, 0.0]), [-8.6603, 0.0, 5.0]);
        near(point(rotated([20.0, 30.0, 40.0]), [10.0, 0.0, 0.0]), [6.6341, 5.5667, -5.0]);
    }

    #[test]
    fn additive_frames_act_in_the_axes_so_far() {
        let shift = |x| FrameMap::translation(linear([x, 0.0, 0.0], 0.0));
        let chain = shift(5.0).then(&turned(Plane::Xy, 90.0)).then(&shift(10.0));
        near(point(chain, [1.0, 0.0, 0.0]), [10.0, 6.0, 0.0]);
        let frame = ProgrammableFrame::new(chain);
        near(frame.programmed(&linear([10.0, 6.0, 0.0], 0.0)), [1.0, 0.0, 0.0]);
    }

    #[test]
    fn circles_stay_circles_where_both_axes_are_scaled_alike() {
        let in_plane = |map: FrameMap| ProgrammableFrame::new(map).in_plane(Plane::Xy);
        let mirrored = in_plane(scaled([-2.0, 2.0, 5.0]));
        assert_eq!(mirrored, InPlane::Similar { factor: 2.0, mirrored: true });
        let is_circle = |map| matches!(in_plane(map), InPlane::Similar { .. });
        assert!(!is_circle(scaled([1.0, 2.0, 1.0])));
        assert!(!is_circle(turned(Plane::Yz, 30.0)));
        assert!(is_circle(turned(Plane::Xy, 30.0)));
        // What cancels leaves the plane where it was, but for rounding.
        assert!(is_circle(turned(Plane::Yz, 33.3).then(&turned(Plane::Yz, -33.3))));
    }
}
