//! By how much the values of a solved element are off.

use std::f64::consts::TAU;

use chordal_geometry::Vec2;

use super::carrier::ElementCarrier;
use super::chain::{FreeChain, coordinate_of};

/// The angle of an arc from start to end in its direction, rad, positive; a full turn where they are one point.
pub(super) fn turn_of(center: Vec2, sign: f64, [start, end]: [Vec2; 2]) -> f64 {
    let angle = |point: Vec2| libm::atan2(point.b - center.b, point.a - center.a);
    let turned = (sign * (angle(end) - angle(start))).rem_euclid(TAU);
    if turned > 0.0 { turned } else { TAU }
}

impl FreeChain<'_> {
    /// By how much the values of an element are off, mm, where it is known.
    pub(super) fn fault_mm(&self, index: usize) -> f64 {
        let known = (self.points[index], self.points[index + 1], self.carriers[index]);
        let (Some(start), Some(end), Some(carrier)) = known else { return 0.0 };
        let ends = [start, end];
        let faults = [
            self.carrier_fault(index, ends, &carrier),
            self.direction_fault(index, ends, &carrier),
            self.end_fault(index, end),
            self.relation_fault(index, &carrier),
        ];
        faults.into_iter().fold(0.0, f64::max)
    }

    /// Ends and auxiliary points off the carrier, a wrong length, radius, centre or angle.
    fn carrier_fault(
        &self,
        index: usize,
        [start, end]: [Vec2; 2],
        carrier: &ElementCarrier,
    ) -> f64 {
        let values = self.values(index);
        let points = [start, end].into_iter().chain(self.auxiliary(index));
        let mut fault = points.map(|point| carrier.distance_mm(point)).fold(0.0, f64::max);
        let mut take = |off: f64| fault = fault.max(off.abs());
        if let Some(length) = values.length {
            take(start.distance(end) - length);
        }
        match *carrier {
            ElementCarrier::Line { direction, .. } => take(direction.dot(end - start).min(0.0)),
            ElementCarrier::Circle { center, signed } => {
                if let Some(radius) = values.radius {
                    take(radius - signed.abs());
                }
                if let Some(degrees) = values.center_angle_deg {
                    let turned = turn_of(center, signed.signum(), [start, end]);
                    take((turned - degrees.to_radians()) * signed);
                }
                for axis in 0..2 {
                    if let Some(value) = self.coordinate(values.center[axis], axis) {
                        take(value - coordinate_of(center, axis));
                    }
                }
                if let Some(point) = self.polar_point(index, values.center_polar) {
                    take(point.distance(center));
                }
            }
        }
        fault
    }

    /// Directions at the start and of AN, as the distance by which they miss the end.
    fn direction_fault(
        &self,
        index: usize,
        [start, end]: [Vec2; 2],
        carrier: &ElementCarrier,
    ) -> f64 {
        let size = start.distance(end);
        let own = [self.entry_direction(index), self.angle_direction(index)];
        let Some(direction) = carrier.direction_at(start) else { return 0.0 };
        let faults = own.into_iter().flatten().map(|known| known.distance(direction) * size);
        faults.fold(0.0, f64::max)
    }

    /// Coordinates of the end.
    fn end_fault(&self, index: usize, end: Vec2) -> f64 {
        let values = self.values(index);
        let mut fault = 0.0_f64;
        for axis in 0..2 {
            if let Some(value) = self.coordinate(values.end[axis], axis) {
                fault = fault.max((value - coordinate_of(end, axis)).abs());
            }
        }
        let Some(pole) = self.pole(index) else { return fault };
        if let Some(radius) = self.polar_radius(index, values.polar[0]) {
            fault = fault.max((pole.distance(end) - radius).abs());
        }
        if let Some(direction) = self.polar_direction(index, values.polar[1]) {
            let away = end - pole;
            fault = fault.max(direction.cross(away).abs()).max(-direction.dot(away));
        }
        fault
    }

    /// The distance point, and the line to which a line is parallel.
    fn relation_fault(&self, index: usize, carrier: &ElementCarrier) -> f64 {
        let values = self.values(index);
        let mut fault = 0.0_f64;
        if let Some((point, distance)) = values.distance_point {
            fault = fault.max((carrier.distance_mm(Vec2::from_array(point)) - distance).abs());
        }
        let other = values.parallel_to.and_then(|own| self.reference_carrier(own));
        if let (
            ElementCarrier::Line { point, direction },
            Some(reference @ ElementCarrier::Line { direction: along, .. }),
        ) = (*carrier, other)
        {
            fault = fault.max(direction.cross(along).abs());
            if let Some(distance) = values.parallel_distance {
                fault = fault.max((reference.distance_mm(point) - distance).abs());
            }
        }
        fault
    }
}
