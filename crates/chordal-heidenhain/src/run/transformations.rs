//! Datum shift, mirror image, rotation and scaling, in the order in which they were programmed.

use chordal_command::Position;
use chordal_geometry::{Plane, Transform, Vec3};
use chordal_kernel::frames::FrameMap;

/// A transformation.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Transformation {
    /// Cycle 7: the new datum, mm.
    Shift([f64; 3]),
    /// Cycle 8: the mirrored axes.
    Mirror([bool; 3]),
    /// Cycle 10: an angle in the plane, degrees.
    Rotation(Plane, f64),
    /// Cycle 11: a factor of all axes.
    Scale(f64),
    /// Cycle 26: a factor of each axis, and the point that does not move, mm.
    AxisScale([f64; 3], [f64; 3]),
}

impl Transformation {
    fn is_kind_of(&self, other: &Transformation) -> bool {
        std::mem::discriminant(self) == std::mem::discriminant(other)
    }

    /// Whether it changes nothing.
    fn is_identity(&self) -> bool {
        match self {
            Transformation::Shift(by) => *by == [0.0; 3],
            Transformation::Mirror(axes) => *axes == [false; 3],
            Transformation::Rotation(_, degrees) => *degrees == 0.0,
            Transformation::Scale(factor) => *factor == 1.0,
            Transformation::AxisScale(factors, _) => *factors == [1.0; 3],
        }
    }

    fn map(&self) -> FrameMap {
        match self {
            Transformation::Shift(by) => FrameMap::translation(linear(*by, 0.0)),
            Transformation::Mirror(axes) => {
                let factors = axes.map(|is_mirrored| if is_mirrored { -1.0 } else { 1.0 });
                FrameMap::scaling(&[0.0; 6], &linear(factors, 1.0))
            }
            Transformation::Rotation(plane, degrees) => {
                FrameMap::rotation(*plane, [0.0; 2], *degrees)
            }
            Transformation::Scale(factor) => {
                FrameMap::scaling(&[0.0; 6], &linear([*factor; 3], 1.0))
            }
            Transformation::AxisScale(factors, center) => {
                FrameMap::scaling(&linear(*center, 0.0), &linear(*factors, 1.0))
            }
        }
    }
}

/// X, Y and Z with the same value for each rotary axis.
fn linear([x, y, z]: [f64; 3], rotary: f64) -> Position {
    [x, y, z, rotary, rotary, rotary]
}

/// The active transformations; each later one acts in the coordinates that those before it make.
#[derive(Clone, Default, PartialEq, Debug)]
pub struct CoordinateChain(Vec<Transformation>);

impl CoordinateChain {
    /// The active transformation of the kind of another; `None` without one.
    pub fn of_kind(&self, other: &Transformation) -> Option<&Transformation> {
        self.0.iter().find(|own| own.is_kind_of(other))
    }

    /// The active transformations in the order in which they act.
    pub fn list(&self) -> &[Transformation] {
        &self.0
    }

    /// The datum shift, mm.
    pub fn shift(&self) -> [f64; 3] {
        match self.of_kind(&Transformation::Shift([0.0; 3])) {
            Some(Transformation::Shift(by)) => *by,
            _ => [0.0; 3],
        }
    }

    /// The rotation, degrees.
    pub fn rotation_deg(&self) -> f64 {
        match self.of_kind(&Transformation::Rotation(Plane::Xy, 0.0)) {
            Some(Transformation::Rotation(_, degrees)) => *degrees,
            _ => 0.0,
        }
    }

    /// The factors of the axes and the point that does not move, mm.
    pub fn axis_scale(&self) -> ([f64; 3], [f64; 3]) {
        match self.of_kind(&Transformation::AxisScale([1.0; 3], [0.0; 3])) {
            Some(Transformation::AxisScale(factors, center)) => (*factors, *center),
            _ => ([1.0; 3], [0.0; 3]),
        }
    }

    /// Sets a transformation: an active one of its kind gets the new values and keeps its place, a new one comes after
    /// all others; one that changes nothing is taken out.
    pub fn set(&mut self, new: Transformation) {
        if new.is_identity() {
            return self.0.retain(|own| !own.is_kind_of(&new));
        }
        match self.0.iter_mut().find(|own| own.is_kind_of(&new)) {
            Some(own) => *own = new,
            None => self.0.push(new),
        }
    }

    /// What they do together as a motion of the part; `None` where it is mirrored or scaled.
    pub fn rigid_map(&self) -> Option<Transform> {
        let mut map = Transform::identity();
        for next in self.0.iter().rev() {
            map = map.then(&match next {
                Transformation::Shift([x, y, z]) => Transform::translation(Vec3::new(*x, *y, *z)),
                Transformation::Rotation(plane, degrees) => {
                    Transform::rotation_about(Vec3::ZERO, plane.normal(), degrees.to_radians())
                }
                Transformation::Mirror(_)
                | Transformation::Scale(_)
                | Transformation::AxisScale(..) => return None,
            });
        }
        Some(map)
    }

    /// Takes the datum shift out.
    pub fn clear_shift(&mut self) {
        self.set(Transformation::Shift([0.0; 3]));
    }

    /// What they do together.
    pub fn map(&self) -> FrameMap {
        self.0.iter().rev().fold(FrameMap::IDENTITY, |map, next| map.then(&next.map()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(chain: &CoordinateChain, x: f64, y: f64) -> [f64; 2] {
        let place = chain.map().point(&[x, y, 0.0, 0.0, 0.0, 0.0]);
        [place[0], place[1]]
    }

    fn near(found: [f64; 2], expected: [f64; 2]) {
        let far = (0..2).any(|axis| (found[axis] - expected[axis]).abs() > 5e-5);
        assert!(!far, "{found:?} is not {expected:?}");
    }

    #[test]
    fn later_transformations_act_inside() {
        let shift = Transformation::Shift([20.0, 5.0, 0.0]);
        let turn = Transformation::Rotation(Plane::Xy, 30.0);
        let mut chain = CoordinateChain::default();
        chain.set(shift);
        chain.set(turn);
        near(point(&chain, 10.0, 0.0), [28.6603, 10.0]);
        chain.set(Transformation::Scale(0.5));
        near(point(&chain, 10.0, 0.0), [24.3301, 7.5]);
        let mut other = CoordinateChain::default();
        other.set(turn);
        other.set(shift);
        near(point(&other, 10.0, 0.0), [23.4808, 19.3301]);
    }

    #[test]
    fn values_that_change_nothing_end_a_transformation() {
        let mut chain = CoordinateChain::default();
        chain.set(Transformation::Mirror([true, false, false]));
        near(point(&chain, 10.0, 5.0), [-10.0, 5.0]);
        chain.set(Transformation::Mirror([false; 3]));
        assert_eq!(chain, CoordinateChain::default());
        assert_eq!(chain.map(), FrameMap::IDENTITY);
    }
}
