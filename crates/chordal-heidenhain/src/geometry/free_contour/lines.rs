//! The lines that an element may lie on.

use chordal_geometry::Vec2;

use super::carrier::{ElementCarrier, common_tangent};
use super::chain::FreeChain;

/// Where along a line it touches something.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum TouchPlace {
    Start,
    End,
    Anywhere,
}

/// Circles of which a line touches one; a point is a circle of radius 0. The radius is positive where the centre is on
/// the left of the line.
struct LineTouch {
    circles: Vec<(Vec2, f64)>,
    place: TouchPlace,
}

impl FreeChain<'_> {
    /// The lines that an element may lie on; `None` where they are not finitely many.
    pub(super) fn line_candidates(&self, index: usize) -> Option<Vec<ElementCarrier>> {
        let touches = self.line_touches(index);
        let mut found = match self.line_directions(index) {
            Some(directions) => self.lines_in_directions(index, &directions, &touches)?,
            None => lines_between(touches.first()?, touches.get(1)?),
        };
        found.retain(|line| self.line_agrees(index, line, &touches));
        Some(found)
    }

    /// What a line touches: known points first, then circles, the distance point last.
    fn line_touches(&self, index: usize) -> Vec<LineTouch> {
        let mut found = Vec::new();
        let mut add = |circles: Vec<(Vec2, f64)>, place| found.push(LineTouch { circles, place });
        let point = |point: Vec2| vec![(point, 0.0)];
        if let Some(start) = self.points[index] {
            add(point(start), TouchPlace::Start);
        }
        if let Some(end) = self.points[index + 1] {
            add(point(end), TouchPlace::End);
        }
        self.auxiliary(index).for_each(|own| add(point(own), TouchPlace::Anywhere));
        let circle = |at: Option<usize>| match self.carriers[at?]? {
            ElementCarrier::Circle { center, signed } => Some(vec![(center, signed)]),
            ElementCarrier::Line { .. } => None,
        };
        if let Some(circles) = circle(self.tangent_previous(index)) {
            add(circles, TouchPlace::Start);
        }
        if let Some(circles) = circle(self.tangent_next(index)) {
            add(circles, TouchPlace::End);
        }
        if let Some((own, distance)) = self.values(index).distance_point {
            let own = Vec2::from_array(own);
            let sides = if distance == 0.0 { vec![0.0] } else { vec![distance, -distance] };
            let circles = sides.into_iter().map(|signed| (own, signed)).collect();
            add(circles, TouchPlace::Anywhere);
        }
        found
    }

    /// The directions that a line may have, if its angle or a neighbour gives them.
    fn line_directions(&self, index: usize) -> Option<Vec<Vec2>> {
        let own = self
            .angle_direction(index)
            .or_else(|| self.entry_direction(index))
            .or_else(|| self.exit_direction(index));
        if let Some(direction) = own {
            return Some(vec![direction]);
        }
        match self.reference_carrier(self.values(index).parallel_to?)? {
            ElementCarrier::Line { direction, .. } => Some(vec![direction, -direction]),
            ElementCarrier::Circle { .. } => None,
        }
    }

    /// The lines of known directions: through what they touch, or at their distance from a parallel one.
    fn lines_in_directions(
        &self,
        index: usize,
        directions: &[Vec2],
        touches: &[LineTouch],
    ) -> Option<Vec<ElementCarrier>> {
        let mut found = Vec::new();
        if let Some(touch) = touches.iter().min_by_key(|touch| touch.circles.len()) {
            for (center, signed) in &touch.circles {
                found.extend(directions.iter().map(|direction| ElementCarrier::Line {
                    point: *center - direction.turned_left() * *signed,
                    direction: *direction,
                }));
            }
            return Some(found);
        }
        let values = self.values(index);
        let reference = self.reference_carrier(values.parallel_to?)?;
        let (ElementCarrier::Line { point, direction: along }, Some(distance)) =
            (reference, values.parallel_distance)
        else {
            return None;
        };
        for side in [distance, -distance] {
            let point = point + along.turned_left() * side;
            found.extend(
                directions
                    .iter()
                    .map(|direction| ElementCarrier::Line { point, direction: *direction }),
            );
        }
        Some(found)
    }

    /// Whether a line touches all that it must, forward from its start to its end, in the directions that are known.
    fn line_agrees(&self, index: usize, line: &ElementCarrier, touches: &[LineTouch]) -> bool {
        let ElementCarrier::Line { point, direction } = *line else { return false };
        let tolerance = self.request.tolerance_mm;
        let normal = direction.turned_left();
        let touches_all = touches.iter().all(|touch| {
            let off = |(center, signed): &(Vec2, f64)| normal.dot(*center - point) - signed;
            touch.circles.iter().any(|circle| off(circle).abs() <= tolerance)
        });
        let is_forward = match (self.points[index], self.points[index + 1]) {
            (Some(start), Some(end)) => (end - start).dot(direction) > -tolerance,
            _ => true,
        };
        let known = [self.entry_direction(index), self.exit_direction(index)];
        let goes_on = known.into_iter().flatten().all(|own| own.dot(direction) > 0.0);
        touches_all && is_forward && goes_on
    }
}

/// The lines that touch one of each; both orders where they are not known.
fn lines_between(one: &LineTouch, other: &LineTouch) -> Vec<ElementCarrier> {
    let is_forward = one.place == TouchPlace::Start && other.place != TouchPlace::Anywhere
        || other.place == TouchPlace::End && one.place != TouchPlace::Anywhere;
    let is_backward = one.place == TouchPlace::End && other.place == TouchPlace::Start;
    let mut found = Vec::new();
    for from in &one.circles {
        for to in &other.circles {
            if !is_backward {
                found.extend(common_tangent(*from, *to));
            }
            if !is_forward {
                found.extend(common_tangent(*to, *from));
            }
        }
    }
    found
}
