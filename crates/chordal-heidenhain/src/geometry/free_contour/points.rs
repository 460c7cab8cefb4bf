//! The points that the end of an element may be.

use chordal_geometry::Vec2;

use super::carrier::ElementCarrier;
use super::chain::{FreeChain, coordinate_of};
use crate::geometry::vectors::{COINCIDENT_POINTS_MM, turned};

/// Lines and circles of which a point lies on one.
pub(super) type LocusChoice = Vec<ElementCarrier>;

/// The line of all points with one coordinate.
pub(super) fn coordinate_line(axis: usize, value: f64) -> ElementCarrier {
    match axis {
        0 => ElementCarrier::Line { point: Vec2::new(value, 0.0), direction: Vec2::new(0.0, 1.0) },
        _ => ElementCarrier::Line { point: Vec2::new(0.0, value), direction: Vec2::new(1.0, 0.0) },
    }
}

/// The points that lie on two of the choices, by the pair that leaves the fewest; `None` where no pair meets.
pub(super) fn points_on(loci: &[LocusChoice]) -> Option<Vec<Vec2>> {
    let mut best: Option<Vec<Vec2>> = None;
    for (at, one) in loci.iter().enumerate() {
        for other in &loci[at + 1..] {
            let Some(found) = points_on_both(one, other) else { continue };
            if best.as_ref().is_none_or(|best| found.len() < best.len()) {
                best = Some(found);
            }
        }
    }
    best
}

fn points_on_both(one: &LocusChoice, other: &LocusChoice) -> Option<Vec<Vec2>> {
    let mut found = Vec::new();
    for own in one {
        for second in other {
            found.extend(own.meeting_points(second)?);
        }
    }
    Some(found)
}

impl FreeChain<'_> {
    /// The points that the end of an element may be; `None` where they are not finitely many.
    pub(super) fn end_candidates(&self, index: usize) -> Option<Vec<Vec2>> {
        if let Some(end) = self.exact_end(index) {
            return Some(vec![end]);
        }
        let mut found = points_on(&self.end_loci(index))?;
        found.retain(|point| self.end_agrees(index, *point));
        Some(found)
    }

    /// The end by values that leave no choice.
    fn exact_end(&self, index: usize) -> Option<Vec2> {
        let values = self.values(index);
        let [x, y] = [0, 1].map(|axis| self.coordinate(values.end[axis], axis));
        if let (Some(x), Some(y)) = (x, y) {
            return Some(Vec2::new(x, y));
        }
        self.polar_point(index, values.polar)
            .or_else(|| self.end_along(index))
            .or_else(|| self.end_in_touch(index))
    }

    /// The point of a polar radius and a polar angle.
    pub(super) fn polar_point(
        &self,
        index: usize,
        [radius, angle]: [Option<super::FreeValue>; 2],
    ) -> Option<Vec2> {
        let (radius, direction) =
            (self.polar_radius(index, radius)?, self.polar_direction(index, angle)?);
        Some(self.pole(index)? + direction * radius)
    }

    /// The end of a known carrier from a known start: LEN of a line, CCA of an arc.
    fn end_along(&self, index: usize) -> Option<Vec2> {
        let (values, start) = (self.values(index), self.points[index]?);
        match self.carriers[index]? {
            ElementCarrier::Line { direction, .. } => Some(start + direction * values.length?),
            ElementCarrier::Circle { center, signed } => {
                let angle = values.center_angle_deg?.to_radians() * signed.signum();
                Some(turned(start, center, angle))
            }
        }
    }

    /// The point in which a known carrier goes over into the next one.
    fn end_in_touch(&self, index: usize) -> Option<Vec2> {
        let next = self.tangent_next(index)?;
        self.carriers[index]?.touch(&self.carriers[next]?)
    }

    /// What the end of an element lies on.
    fn end_loci(&self, index: usize) -> Vec<LocusChoice> {
        let values = self.values(index);
        let next = self.next(index);
        let mut loci: Vec<ElementCarrier> = Vec::new();
        loci.extend(self.carriers[index]);
        loci.extend(next.and_then(|next| self.carriers[next]));
        let circle = |center: Option<Vec2>, radius: Option<f64>| {
            Some(ElementCarrier::Circle { center: center?, signed: radius? })
        };
        loci.extend(circle(self.points[index], values.length));
        if let Some(next) = next {
            loci.extend(circle(self.points[next + 1], self.values(next).length));
        }
        for (axis, value) in values.end.into_iter().enumerate() {
            loci.extend(self.coordinate(value, axis).map(|value| coordinate_line(axis, value)));
        }
        loci.extend(circle(self.pole(index), self.polar_radius(index, values.polar[0])));
        if let (Some(point), Some(direction)) =
            (self.pole(index), self.polar_direction(index, values.polar[1]))
        {
            loci.push(ElementCarrier::Line { point, direction });
        }
        loci.into_iter().map(|locus| vec![locus]).collect()
    }

    /// Whether a point has the values of the end of an element, and lies ahead on lines.
    fn end_agrees(&self, index: usize, point: Vec2) -> bool {
        let values = self.values(index);
        let tolerance = self.request.tolerance_mm;
        let has_coordinates = (0..2).all(|axis| {
            let value = self.coordinate(values.end[axis], axis);
            value.is_none_or(|value| (value - coordinate_of(point, axis)).abs() <= tolerance)
        });
        let is_on = |at: Option<usize>| {
            let carrier = at.and_then(|at| self.carriers[at]);
            carrier.is_none_or(|carrier| carrier.distance_mm(point) <= tolerance)
        };
        let next = self.next(index);
        has_coordinates
            && is_on(Some(index))
            && is_on(next)
            && self.is_ahead(index, self.points[index], Some(point))
            && next.is_none_or(|next| self.is_ahead(next, Some(point), self.points[next + 1]))
            && self.polar_agrees(index, values.polar, point)
            && self.length_agrees(index, point)
    }

    /// Whether a line goes forward from its start to its end, as far as they are known.
    fn is_ahead(&self, index: usize, start: Option<Vec2>, end: Option<Vec2>) -> bool {
        match (self.carriers[index], start, end) {
            (Some(ElementCarrier::Line { direction, .. }), Some(start), Some(end)) => {
                (end - start).dot(direction) > COINCIDENT_POINTS_MM
            }
            _ => true,
        }
    }

    fn polar_agrees(
        &self,
        index: usize,
        polar: [Option<super::FreeValue>; 2],
        point: Vec2,
    ) -> bool {
        let Some(pole) = self.pole(index) else { return true };
        let tolerance = self.request.tolerance_mm;
        let away = point - pole;
        let has_radius = self
            .polar_radius(index, polar[0])
            .is_none_or(|radius| (away.length() - radius).abs() <= tolerance);
        let has_angle = self.polar_direction(index, polar[1]).is_none_or(|direction| {
            direction.cross(away).abs() <= tolerance && direction.dot(away) >= -tolerance
        });
        has_radius && has_angle
    }

    fn length_agrees(&self, index: usize, end: Vec2) -> bool {
        let (Some(start), Some(length)) = (self.points[index], self.values(index).length) else {
            return true;
        };
        (start.distance(end) - length).abs() <= self.request.tolerance_mm
    }
}
