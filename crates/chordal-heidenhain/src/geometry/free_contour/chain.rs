//! A contour while it is solved, and the values of its words as far as what they refer to is known.

use chordal_geometry::Vec2;
use chordal_kernel::frames::sin_cos_degrees;

use super::carrier::ElementCarrier;
use super::{FreeContourRequest, FreeElementValues, FreeReference, FreeValue, KnownElement};
use crate::geometry::vectors::unit_vector;

/// What is known of a contour; elements from `limit` on are not looked at yet.
#[derive(Clone, Debug)]
pub(super) struct FreeChain<'v> {
    pub(super) request: &'v FreeContourRequest<'v>,
    pub(super) limit: usize,
    /// Where the elements begin and end: one more than there are elements.
    pub(super) points: Vec<Option<Vec2>>,
    pub(super) carriers: Vec<Option<ElementCarrier>>,
}

/// The coordinate of a point on the first or second axis.
pub(super) fn coordinate_of(point: Vec2, axis: usize) -> f64 {
    if axis == 0 { point.a } else { point.b }
}

pub(super) fn direction_of_angle(degrees: f64) -> Vec2 {
    let (sin, cos) = sin_cos_degrees(degrees);
    Vec2::new(cos, sin)
}

fn angle_of(direction: Vec2) -> f64 {
    libm::atan2(direction.b, direction.a).to_degrees()
}

impl KnownElement {
    fn carrier(&self) -> Option<ElementCarrier> {
        let [start, end] = [Vec2::from_array(self.start), Vec2::from_array(self.end)];
        Some(match self.arc {
            Some((center, turn)) => {
                let center = Vec2::from_array(center);
                ElementCarrier::Circle { center, signed: turn.sign() * center.distance(end) }
            }
            None => ElementCarrier::Line { point: start, direction: unit_vector(start, end)? },
        })
    }
}

impl<'v> FreeChain<'v> {
    pub(super) fn new(request: &'v FreeContourRequest<'v>) -> FreeChain<'v> {
        let count = request.elements.len();
        let mut points = vec![None; count + 1];
        points[0] = Some(Vec2::from_array(request.start));
        FreeChain { request, limit: 0, points, carriers: vec![None; count] }
    }

    pub(super) fn values(&self, index: usize) -> &'v FreeElementValues {
        &self.request.elements[index]
    }

    /// The element after another one, if it is looked at.
    pub(super) fn next(&self, index: usize) -> Option<usize> {
        Some(index + 1).filter(|next| *next < self.limit)
    }

    /// The next element, if it goes on in the direction of this one.
    pub(super) fn tangent_next(&self, index: usize) -> Option<usize> {
        self.next(index).filter(|next| self.values(*next).is_tangent)
    }

    /// The element before, if this one goes on in its direction.
    pub(super) fn tangent_previous(&self, index: usize) -> Option<usize> {
        index.checked_sub(1).filter(|_| self.values(index).is_tangent)
    }

    pub(super) fn pole(&self, index: usize) -> Option<Vec2> {
        self.values(index).pole.map(Vec2::from_array)
    }

    /// The point that a relative coordinate is counted from.
    fn reference_point(&self, reference: FreeReference) -> Option<Vec2> {
        match reference {
            FreeReference::Start => self.points[0],
            FreeReference::Before(index) => {
                Some(Vec2::from_array(self.request.before.get(index)?.end))
            }
            FreeReference::Own(index) => *self.points.get(index + 1)?,
        }
    }

    pub(super) fn reference_carrier(&self, reference: FreeReference) -> Option<ElementCarrier> {
        match reference {
            FreeReference::Start => None,
            FreeReference::Before(index) => self.request.before.get(index)?.carrier(),
            FreeReference::Own(index) => *self.carriers.get(index)?,
        }
    }

    /// The direction that a relative angle is counted from: that of a line, or in which an arc ends.
    fn reference_direction(&self, reference: FreeReference) -> Option<Vec2> {
        match self.reference_carrier(reference) {
            None if reference == FreeReference::Start => self.request.entry.map(Vec2::from_array),
            None => None,
            Some(ElementCarrier::Line { direction, .. }) => Some(direction),
            Some(circle) => circle.direction_at(self.reference_point(reference)?),
        }
    }

    /// A coordinate on an axis.
    pub(super) fn coordinate(&self, value: Option<FreeValue>, axis: usize) -> Option<f64> {
        let FreeValue { value, from } = value?;
        match from {
            None => Some(value),
            Some(reference) => Some(coordinate_of(self.reference_point(reference)?, axis) + value),
        }
    }

    /// A distance of an element from its pole.
    pub(super) fn polar_radius(&self, index: usize, value: Option<FreeValue>) -> Option<f64> {
        let FreeValue { value, from } = value?;
        match from {
            None => Some(value),
            Some(reference) => {
                Some(self.pole(index)?.distance(self.reference_point(reference)?) + value)
            }
        }
    }

    /// The direction of a polar angle.
    pub(super) fn polar_direction(&self, index: usize, value: Option<FreeValue>) -> Option<Vec2> {
        let FreeValue { value, from } = value?;
        let base = match from {
            None => 0.0,
            Some(reference) => angle_of(self.reference_point(reference)? - self.pole(index)?),
        };
        Some(direction_of_angle(base + value))
    }

    /// The direction of AN.
    pub(super) fn angle_direction(&self, index: usize) -> Option<Vec2> {
        let FreeValue { value, from } = self.values(index).angle?;
        let base = match from {
            None => 0.0,
            Some(reference) => angle_of(self.reference_direction(reference)?),
        };
        Some(direction_of_angle(base + value))
    }

    /// The direction in which an element begins, if AN of an arc or the element before it gives it.
    pub(super) fn entry_direction(&self, index: usize) -> Option<Vec2> {
        let values = self.values(index);
        if !values.is_tangent {
            return self.angle_direction(index).filter(|_| values.turn.is_some());
        }
        match index.checked_sub(1) {
            None => self.request.entry.map(Vec2::from_array),
            Some(before) => match self.carriers[before]? {
                ElementCarrier::Line { direction, .. } => Some(direction),
                circle => circle.direction_at(self.points[index]?),
            },
        }
    }

    /// The direction in which an element ends, if the one after it gives it.
    pub(super) fn exit_direction(&self, index: usize) -> Option<Vec2> {
        let next = self.tangent_next(index)?;
        match self.carriers[next]? {
            ElementCarrier::Line { direction, .. } => Some(direction),
            circle => circle.direction_at(self.points[next]?),
        }
    }

    /// The auxiliary points of an element.
    pub(super) fn auxiliary(&self, index: usize) -> impl Iterator<Item = Vec2> + use<'v> {
        self.values(index).auxiliary.into_iter().flatten().map(Vec2::from_array)
    }

    /// The known points of an element: its ends and its auxiliary points.
    pub(super) fn known_points(&self, index: usize) -> Vec<Vec2> {
        let ends = [self.points[index], self.points[index + 1]];
        ends.into_iter().flatten().chain(self.auxiliary(index)).collect()
    }
}
