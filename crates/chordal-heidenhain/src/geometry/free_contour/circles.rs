//! The circles that an element may lie on.

use chordal_geometry::Vec2;

use super::carrier::ElementCarrier;
use super::chain::FreeChain;
use super::points::{LocusChoice, coordinate_line, points_on};

impl FreeChain<'_> {
    /// The circles in a direction that an element may lie on; `None` where they are not finitely many.
    pub(super) fn circle_candidates(&self, index: usize, sign: f64) -> Option<Vec<ElementCarrier>> {
        let centers = match self.exact_center(index) {
            Some(center) => vec![center],
            None => points_on(&self.center_loci(index, sign))?,
        };
        let mut found = Vec::new();
        for center in centers {
            for radius in self.radii_about(index, sign, center)? {
                found.push(ElementCarrier::Circle { center, signed: sign * radius });
            }
        }
        found.retain(|circle| self.circle_agrees(index, circle));
        Some(found)
    }

    fn exact_center(&self, index: usize) -> Option<Vec2> {
        let values = self.values(index);
        let [x, y] = [0, 1].map(|axis| self.coordinate(values.center[axis], axis));
        match (x, y) {
            (Some(x), Some(y)) => Some(Vec2::new(x, y)),
            _ => self.polar_point(index, values.center_polar),
        }
    }

    /// What the centre lies on.
    fn center_loci(&self, index: usize, sign: f64) -> Vec<LocusChoice> {
        let mut loci = self.center_words(index);
        loci.extend(self.center_normals(index).into_iter().map(|locus| vec![locus]));
        match self.values(index).radius {
            Some(radius) => loci.extend(self.centers_at_radius(index, sign, radius)),
            None => loci.extend(self.centers_at_equal_distance(index)),
        }
        loci
    }

    /// What words of the centre say.
    fn center_words(&self, index: usize) -> Vec<LocusChoice> {
        let values = self.values(index);
        let mut loci: Vec<ElementCarrier> = Vec::new();
        for (axis, value) in values.center.into_iter().enumerate() {
            loci.extend(self.coordinate(value, axis).map(|value| coordinate_line(axis, value)));
        }
        let pole = self.pole(index);
        if let (Some(center), Some(signed)) =
            (pole, self.polar_radius(index, values.center_polar[0]))
        {
            loci.push(ElementCarrier::Circle { center, signed });
        }
        if let (Some(point), Some(direction)) =
            (pole, self.polar_direction(index, values.center_polar[1]))
        {
            loci.push(ElementCarrier::Line { point, direction });
        }
        loci.into_iter().map(|locus| vec![locus]).collect()
    }

    /// The normals at ends whose direction is known.
    fn center_normals(&self, index: usize) -> Vec<ElementCarrier> {
        let ends = [
            (self.points[index], self.entry_direction(index)),
            (self.points[index + 1], self.exit_direction(index)),
        ];
        let normals = ends.into_iter().filter_map(|(point, direction)| {
            Some(ElementCarrier::Line { point: point?, direction: direction?.turned_left() })
        });
        normals.collect()
    }

    /// Where the centre is by a known radius: about known points, and at the distance from what the arc touches.
    fn centers_at_radius(&self, index: usize, sign: f64, radius: f64) -> Vec<LocusChoice> {
        let about = |center: Vec2, signed: f64| ElementCarrier::Circle { center, signed };
        let points = self.known_points(index).into_iter();
        let mut loci: Vec<LocusChoice> = points.map(|point| vec![about(point, radius)]).collect();
        for neighbour in self.tangent_neighbours(index) {
            loci.push(vec![match neighbour {
                ElementCarrier::Line { point, direction } => {
                    let point = point + direction.turned_left() * (sign * radius);
                    ElementCarrier::Line { point, direction }
                }
                ElementCarrier::Circle { center, signed } => {
                    about(center, (signed - sign * radius).abs())
                }
            }]);
        }
        if let Some((point, distance)) = self.values(index).distance_point {
            let inner = (radius - distance).abs();
            loci.push(
                [radius + distance, inner].map(|own| about(Vec2::from_array(point), own)).to_vec(),
            );
        }
        loci
    }

    /// Where the centre is without a radius: as far from one known point as from another, from one line as from another.
    fn centers_at_equal_distance(&self, index: usize) -> Vec<LocusChoice> {
        let points = self.known_points(index);
        let mut loci: Vec<LocusChoice> = Vec::new();
        for pair in points.windows(2) {
            let chord = pair[1] - pair[0];
            let Some(direction) = chord.turned_left().normalized() else { continue };
            loci.push(vec![ElementCarrier::Line { point: pair[0] + chord * 0.5, direction }]);
        }
        let lines = self.tangent_neighbours(index).into_iter().filter_map(|own| match own {
            ElementCarrier::Line { point, direction } => Some((point, direction.turned_left())),
            ElementCarrier::Circle { .. } => None,
        });
        if let [(one, normal), (other, second)] = lines.collect::<Vec<_>>()[..] {
            // All points whose signed distances from both lines are equal.
            let across = normal - second;
            let height = one.dot(normal) - other.dot(second);
            if let Some(unit) = across.normalized() {
                let point = unit * (height / across.length());
                loci.push(vec![ElementCarrier::Line { point, direction: unit.turned_left() }]);
            }
        }
        loci
    }

    /// The carriers of the neighbours that an arc goes over into.
    fn tangent_neighbours(&self, index: usize) -> Vec<ElementCarrier> {
        let neighbours = [self.tangent_previous(index), self.tangent_next(index)];
        neighbours.into_iter().flatten().filter_map(|own| self.carriers[own]).collect()
    }

    /// The radii that an arc about a centre may have; `None` where nothing says it.
    fn radii_about(&self, index: usize, sign: f64, center: Vec2) -> Option<Vec<f64>> {
        let values = self.values(index);
        if let Some(radius) = values.radius {
            return Some(vec![radius]);
        }
        if let Some(point) = self.known_points(index).first() {
            return Some(vec![center.distance(*point)]);
        }
        let neighbours = self.tangent_neighbours(index);
        let found = match neighbours.first().copied() {
            Some(ElementCarrier::Line { point, direction }) => {
                vec![sign * direction.turned_left().dot(center - point)]
            }
            Some(ElementCarrier::Circle { center: other, signed }) => {
                let away = center.distance(other);
                vec![sign * (signed - away), sign * (signed + away)]
            }
            None => {
                let (point, distance) = values.distance_point?;
                let away = center.distance(Vec2::from_array(point));
                vec![away + distance, away - distance]
            }
        };
        Some(found.into_iter().filter(|radius| *radius > 0.0).collect())
    }

    /// Whether a circle passes through the known points of an element and goes on in the directions that are known.
    fn circle_agrees(&self, index: usize, circle: &ElementCarrier) -> bool {
        let ElementCarrier::Circle { center, signed } = *circle else { return false };
        let tolerance = self.request.tolerance_mm;
        let has_points =
            self.known_points(index).iter().all(|point| circle.distance_mm(*point) <= tolerance);
        let ends = [
            (self.points[index], self.entry_direction(index)),
            (self.points[index + 1], self.exit_direction(index)),
        ];
        let goes_on = ends.into_iter().all(|(point, direction)| {
            let own = point.and_then(|point| circle.direction_at(point));
            own.zip(direction).is_none_or(|(own, direction)| own.dot(direction) > 0.0)
        });
        let touches = self.tangent_neighbours(index).into_iter().all(|neighbour| {
            let off = match neighbour {
                ElementCarrier::Line { point, direction } => {
                    direction.turned_left().dot(center - point) - signed
                }
                ElementCarrier::Circle { center: other, signed: its } => {
                    center.distance(other) - (its - signed).abs()
                }
            };
            off.abs() <= tolerance
        });
        has_points && goes_on && touches
    }
}
