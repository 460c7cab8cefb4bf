//! Free contours (FK): lines and arcs of which each block gives only some values, solved together in closed form.
//!
//! Every element lies on a carrier, an oriented line or circle. Carriers follow from what is known of them and of their
//! neighbours, the points between elements from their carriers; both are found in turn until nothing more follows.
//! Where two solutions are left, none is taken.

use chordal_geometry::TurnDirection;
use chordal_kernel::frames::sin_cos_degrees;

use super::vectors::{COINCIDENT_POINTS_MM, distance, left_normal, point_ahead, unit_vector};

/// Lines that differ by less are parallel: the sine of their angle.
const PARALLEL_SINE: f64 = 1e-9;

/// What a block says of an element; points on the axes of the plane, mm.
#[derive(Clone, Copy, Default, PartialEq, Debug)]
pub struct FreeElementValues {
    /// The direction of an arc (FC); `None` for a line (FL).
    pub turn: Option<TurnDirection>,
    /// It goes on in the direction of the element before (FLT, FCT).
    pub is_tangent: bool,
    /// The coordinates of its end that are given.
    pub end: [Option<f64>; 2],
    /// The distance of its end from the pole, and its angle there, degrees.
    pub polar: [Option<f64>; 2],
    /// LEN of a line.
    pub length: Option<f64>,
    /// AN of a line: its angle, degrees.
    pub angle_deg: Option<f64>,
    /// The centre of an arc.
    pub center: Option<[f64; 2]>,
    /// The radius of an arc.
    pub radius: Option<f64>,
}

/// An element that is solved.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SolvedFreeElement {
    /// Its end.
    pub end: [f64; 2],
    /// The centre of an arc; `None` for a line.
    pub center: Option<[f64; 2]>,
}

/// Why a free contour is not solved.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FreeContourFault {
    /// This element is the first that the values do not determine, or not alone.
    Undetermined(usize),
    /// The values of this element contradict each other.
    Contradiction(usize),
}

/// An oriented line or circle.
#[derive(Clone, Copy, PartialEq, Debug)]
enum ElementCarrier {
    Line {
        point: [f64; 2],
        direction: [f64; 2],
    },
    /// `signed` is the radius, negative for a clockwise circle: its centre lies so far to the left.
    Circle {
        center: [f64; 2],
        signed: f64,
    },
}

/// A chain of elements while it is solved.
struct FreeChain<'v> {
    values: &'v [FreeElementValues],
    pole: Option<[f64; 2]>,
    /// The direction before the first element.
    entry: Option<[f64; 2]>,
    /// Where the elements begin and end: one more than there are elements.
    points: Vec<Option<[f64; 2]>>,
    carriers: Vec<Option<ElementCarrier>>,
}

/// Solves elements from a start, with the direction in which the element before them ended.
///
/// # Errors
/// See [`FreeContourFault`]; `tolerance_mm` is how far values may be off each other.
pub fn solve_free_contour(
    values: &[FreeElementValues],
    start: [f64; 2],
    entry: Option<[f64; 2]>,
    pole: Option<[f64; 2]>,
    tolerance_mm: f64,
) -> Result<Vec<SolvedFreeElement>, FreeContourFault> {
    let mut points = vec![None; values.len() + 1];
    points[0] = Some(start);
    let mut chain = FreeChain { values, pole, entry, points, carriers: vec![None; values.len()] };
    let mut has_more = true;
    while has_more {
        has_more = false;
        for index in 0..values.len() {
            has_more |= chain.advance(index);
        }
    }
    chain.solved(tolerance_mm)
}

fn minus(one: [f64; 2], other: [f64; 2]) -> [f64; 2] {
    [one[0] - other[0], one[1] - other[1]]
}

fn dot(one: [f64; 2], other: [f64; 2]) -> f64 {
    one[0] * other[0] + one[1] * other[1]
}

fn cross(one: [f64; 2], other: [f64; 2]) -> f64 {
    one[0] * other[1] - one[1] * other[0]
}

fn direction_of_angle(degrees: f64) -> [f64; 2] {
    let (sin, cos) = sin_cos_degrees(degrees);
    [cos, sin]
}

impl ElementCarrier {
    /// The direction of travel at one of its points.
    fn direction_at(&self, point: [f64; 2]) -> Option<[f64; 2]> {
        match *self {
            ElementCarrier::Line { direction, .. } => Some(direction),
            ElementCarrier::Circle { center, signed } => {
                let outward = unit_vector(center, point)?;
                Some(left_normal(outward).map(|value| value * signed.signum()))
            }
        }
    }

    /// The point in which one carrier goes over into another one in the same direction.
    fn touch(&self, next: &ElementCarrier) -> Option<[f64; 2]> {
        match (*self, *next) {
            (ElementCarrier::Line { direction, .. }, ElementCarrier::Circle { center, signed })
            | (ElementCarrier::Circle { center, signed }, ElementCarrier::Line { direction, .. }) => {
                Some(point_ahead(center, left_normal(direction), -signed))
            }
            (
                ElementCarrier::Circle { center: one, signed: r },
                ElementCarrier::Circle { center: other, signed: s },
            ) => {
                let normal = minus(other, one).map(|value| value / (s - r));
                (s != r).then(|| point_ahead(one, normal, -r))
            }
            (ElementCarrier::Line { .. }, ElementCarrier::Line { .. }) => None,
        }
    }

    /// The points in which two carriers meet.
    fn meeting_points(&self, other: &ElementCarrier) -> Vec<[f64; 2]> {
        match (*self, *other) {
            (
                ElementCarrier::Line { point, direction },
                ElementCarrier::Line { point: other, direction: along },
            ) => {
                let sine = cross(direction, along);
                if sine.abs() < PARALLEL_SINE {
                    return Vec::new();
                }
                vec![point_ahead(point, direction, cross(minus(other, point), along) / sine)]
            }
            (
                ElementCarrier::Line { point, direction },
                ElementCarrier::Circle { center, signed },
            )
            | (
                ElementCarrier::Circle { center, signed },
                ElementCarrier::Line { point, direction },
            ) => points_at_distance(point, direction, center, signed.abs()),
            (
                ElementCarrier::Circle { center: one, signed: r },
                ElementCarrier::Circle { center: other, signed: s },
            ) => {
                let Some(across) = unit_vector(one, other) else { return Vec::new() };
                let center_distance = distance(one, other);
                let along =
                    (center_distance * center_distance + r * r - s * s) / (2.0 * center_distance);
                points_at_distance(
                    point_ahead(one, across, along),
                    left_normal(across),
                    one,
                    r.abs(),
                )
            }
        }
    }
}

/// The points of a line at a distance from a point.
fn points_at_distance(
    point: [f64; 2],
    direction: [f64; 2],
    center: [f64; 2],
    radius: f64,
) -> Vec<[f64; 2]> {
    let along = dot(minus(center, point), direction);
    let foot = point_ahead(point, direction, along);
    let square = radius * radius - dot(minus(center, foot), minus(center, foot));
    if square < -COINCIDENT_POINTS_MM * radius {
        return Vec::new();
    }
    let half = square.max(0.0).sqrt();
    if half <= COINCIDENT_POINTS_MM {
        return vec![foot];
    }
    vec![point_ahead(foot, direction, -half), point_ahead(foot, direction, half)]
}

/// The line that leaves one circle and goes over into another, both in their directions; a point is a circle of radius 0.
fn common_tangent(from: ([f64; 2], f64), to: ([f64; 2], f64)) -> Option<ElementCarrier> {
    let across = unit_vector(from.0, to.0)?;
    let share = (to.1 - from.1) / distance(from.0, to.0);
    let along = 1.0 - share * share;
    if along <= 0.0 {
        return None;
    }
    let side = left_normal(across);
    let normal = [0, 1].map(|axis| share * across[axis] + along.sqrt() * side[axis]);
    let direction = [normal[1], -normal[0]];
    Some(ElementCarrier::Line { point: point_ahead(from.0, normal, -from.1), direction })
}

impl FreeChain<'_> {
    /// Finds what follows about an element; whether it is something new.
    fn advance(&mut self, index: usize) -> bool {
        let mut found = false;
        if self.points[index + 1].is_none() {
            self.points[index + 1] = self.end_of(index);
            found |= self.points[index + 1].is_some();
        }
        if self.carriers[index].is_none() {
            self.carriers[index] = match self.values[index].turn {
                None => self.line(index),
                Some(turn) => self.circle(index, turn.sign()),
            };
            found |= self.carriers[index].is_some();
        }
        found
    }

    /// The direction in which an element begins, if the one before it gives it.
    fn entry_direction(&self, index: usize) -> Option<[f64; 2]> {
        if !self.values[index].is_tangent {
            return None;
        }
        match index.checked_sub(1) {
            None => self.entry,
            Some(before) => match self.carriers[before]? {
                line @ ElementCarrier::Line { .. } => line.direction_at([0.0; 2]),
                circle => circle.direction_at(self.points[index]?),
            },
        }
    }

    /// The circle before an element into which it goes on, or its known start as a circle of radius 0.
    fn tangent_start(&self, index: usize) -> Option<([f64; 2], f64)> {
        if let Some(point) = self.points[index] {
            return Some((point, 0.0));
        }
        match self.carriers[index.checked_sub(1)?]? {
            ElementCarrier::Circle { center, signed } if self.values[index].is_tangent => {
                Some((center, signed))
            }
            _ => None,
        }
    }

    /// The same at the end.
    fn tangent_end(&self, index: usize) -> Option<([f64; 2], f64)> {
        if let Some(point) = self.points[index + 1] {
            return Some((point, 0.0));
        }
        match (*self.carriers.get(index + 1)?)? {
            ElementCarrier::Circle { center, signed } if self.values[index + 1].is_tangent => {
                Some((center, signed))
            }
            _ => None,
        }
    }

    fn line(&self, index: usize) -> Option<ElementCarrier> {
        let values = &self.values[index];
        let direction = values.angle_deg.map(direction_of_angle);
        if let Some(direction) = direction.or_else(|| self.entry_direction(index)) {
            let point = self.points[index].or(self.points[index + 1]).or_else(|| {
                let touched = self.tangent_start(index).or_else(|| self.tangent_end(index))?;
                Some(point_ahead(touched.0, left_normal(direction), -touched.1))
            })?;
            return Some(ElementCarrier::Line { point, direction });
        }
        common_tangent(self.tangent_start(index)?, self.tangent_end(index)?)
    }

    fn circle(&self, index: usize, sign: f64) -> Option<ElementCarrier> {
        let values = &self.values[index];
        if let Some(center) = values.center {
            let to_line = || {
                let before = index.checked_sub(1).and_then(|before| self.carriers[before]);
                let after = self.carriers.get(index + 1).copied().flatten();
                let next_is_tangent =
                    self.values.get(index + 1).is_some_and(|next| next.is_tangent);
                let lines =
                    [before.filter(|_| values.is_tangent), after.filter(|_| next_is_tangent)];
                lines.into_iter().flatten().find_map(|carrier| match carrier {
                    ElementCarrier::Line { point, direction } => {
                        Some(dot(left_normal(direction), minus(center, point)).abs())
                    }
                    ElementCarrier::Circle { .. } => None,
                })
            };
            let ends = [self.points[index], self.points[index + 1]];
            let radius = values
                .radius
                .or_else(|| ends.into_iter().flatten().next().map(|end| distance(center, end)))
                .or_else(to_line)?;
            return Some(ElementCarrier::Circle { center, signed: sign * radius });
        }
        let of = |center: [f64; 2], radius: f64| ElementCarrier::Circle {
            center,
            signed: sign * radius,
        };
        let (start, end) = (self.points[index], self.points[index + 1]);
        if let (Some(start), Some(direction)) = (start, self.entry_direction(index)) {
            if let Some(radius) = values.radius {
                return Some(of(point_ahead(start, left_normal(direction), sign * radius), radius));
            }
            let chord = minus(end?, start);
            let height = dot(chord, left_normal(direction));
            let signed = dot(chord, chord) / (2.0 * height);
            // On its own side only.
            return (signed * sign > 0.0 && signed.is_finite())
                .then(|| of(point_ahead(start, left_normal(direction), signed), signed.abs()));
        }
        self.rounding(index, sign).map(|center| of(center, values.radius.unwrap_or(0.0)))
    }

    /// The centre of an arc of a known radius that goes over into lines on both sides.
    fn rounding(&self, index: usize, sign: f64) -> Option<[f64; 2]> {
        let signed = sign * self.values[index].radius?;
        let is_rounding = self.values[index].is_tangent && self.values.get(index + 1)?.is_tangent;
        let before = self.carriers[index.checked_sub(1)?]?;
        let after = self.carriers[index + 1]?;
        let shifted = |carrier| match carrier {
            ElementCarrier::Line { point, direction } => {
                let point = point_ahead(point, left_normal(direction), signed);
                Some(ElementCarrier::Line { point, direction })
            }
            ElementCarrier::Circle { .. } => None,
        };
        let found = shifted(before)?.meeting_points(&shifted(after)?);
        found.first().copied().filter(|_| is_rounding)
    }

    /// The end of an element, if it follows from its values, its carrier and the next one.
    fn end_of(&self, index: usize) -> Option<[f64; 2]> {
        let values = &self.values[index];
        if let [Some(x), Some(y)] = values.end {
            return Some([x, y]);
        }
        if let (Some(pole), [Some(radius), Some(angle)]) = (self.pole, values.polar) {
            return Some(point_ahead(pole, direction_of_angle(angle), radius));
        }
        let carrier = self.carriers[index]?;
        if let (ElementCarrier::Line { direction, .. }, Some(length), Some(start)) =
            (carrier, values.length, self.points[index])
        {
            return Some(point_ahead(start, direction, length));
        }
        let sources = [
            self.meeting_next(index, &carrier),
            self.at_coordinate(index, &carrier),
            self.at_polar(index, &carrier),
        ];
        sources.into_iter().find_map(|mut candidates| {
            candidates.retain(|point| self.agrees(index, *point));
            match candidates.as_slice() {
                [point] => Some(*point),
                _ => None,
            }
        })
    }

    /// Where the carrier of an element meets the next one.
    fn meeting_next(&self, index: usize, carrier: &ElementCarrier) -> Vec<[f64; 2]> {
        let Some(next) = self.carriers.get(index + 1).copied().flatten() else {
            return Vec::new();
        };
        match self.values[index + 1].is_tangent {
            true => carrier.touch(&next).into_iter().collect(),
            false => carrier.meeting_points(&next),
        }
    }

    /// Where it has the coordinate that is given of the end.
    fn at_coordinate(&self, index: usize, carrier: &ElementCarrier) -> Vec<[f64; 2]> {
        let end = self.values[index].end;
        let Some(axis) = end.iter().position(Option::is_some) else { return Vec::new() };
        let (mut point, mut direction) = ([0.0; 2], [1.0; 2]);
        (point[axis], direction[axis]) = (end[axis].unwrap_or(0.0), 0.0);
        carrier.meeting_points(&ElementCarrier::Line { point, direction })
    }

    /// Where it has the distance from the pole, or the angle there, that is given of the end.
    fn at_polar(&self, index: usize, carrier: &ElementCarrier) -> Vec<[f64; 2]> {
        let Some(pole) = self.pole else { return Vec::new() };
        match self.values[index].polar {
            [Some(radius), _] => {
                carrier.meeting_points(&ElementCarrier::Circle { center: pole, signed: radius })
            }
            [_, Some(angle)] => {
                let direction = direction_of_angle(angle);
                let mut found =
                    carrier.meeting_points(&ElementCarrier::Line { point: pole, direction });
                found.retain(|point| dot(minus(*point, pole), direction) > 0.0);
                found
            }
            _ => Vec::new(),
        }
    }

    /// Whether a point has the coordinates that are given of the end, and lies ahead on a line.
    fn agrees(&self, index: usize, point: [f64; 2]) -> bool {
        const NEAR_MM: f64 = 1e-3;
        let values = &self.values[index];
        let has_end = (0..2)
            .all(|axis| values.end[axis].is_none_or(|value| (value - point[axis]).abs() < NEAR_MM));
        let is_ahead = match (self.carriers[index], self.points[index]) {
            (Some(ElementCarrier::Line { direction, .. }), Some(start)) => {
                dot(minus(point, start), direction) > -NEAR_MM
            }
            _ => true,
        };
        has_end && is_ahead
    }

    /// The elements, where all are known and agree.
    fn solved(&self, tolerance_mm: f64) -> Result<Vec<SolvedFreeElement>, FreeContourFault> {
        let mut solved = Vec::new();
        for (index, values) in self.values.iter().enumerate() {
            let known = (self.points[index], self.points[index + 1], self.carriers[index]);
            let (Some(start), Some(end), Some(carrier)) = known else {
                return Err(FreeContourFault::Undetermined(index));
            };
            let center = match carrier {
                ElementCarrier::Line { .. } => None,
                ElementCarrier::Circle { center, .. } => Some(center),
            };
            if self.fault_mm(index, values, [start, end]) > tolerance_mm {
                return Err(FreeContourFault::Contradiction(index));
            }
            solved.push(SolvedFreeElement { end, center });
        }
        Ok(solved)
    }

    /// By how much the values of a solved element are off, mm.
    fn fault_mm(&self, index: usize, values: &FreeElementValues, ends: [[f64; 2]; 2]) -> f64 {
        let [start, end] = ends;
        let mut fault = 0.0_f64;
        let mut take = |off: f64| fault = fault.max(off.abs());
        match self.carriers[index] {
            Some(ElementCarrier::Line { point, direction }) => {
                ends.into_iter().for_each(|end| take(cross(minus(end, point), direction)));
                take(dot(minus(end, start), direction).min(0.0));
                if let Some(length) = values.length {
                    take(distance(start, end) - length);
                }
            }
            Some(ElementCarrier::Circle { center, signed }) => {
                ends.into_iter().for_each(|end| take(distance(end, center) - signed.abs()));
                if let Some(radius) = values.radius {
                    take(radius - signed.abs());
                }
            }
            None => {}
        }
        let size = distance(start, end);
        if let (Some(entry), Some(carrier)) = (self.entry_direction(index), self.carriers[index])
            && let Some(direction) = carrier.direction_at(start)
        {
            take(distance(entry, direction) * size);
        }
        for (axis, value) in values.end.iter().enumerate() {
            if let Some(value) = value {
                take(value - end[axis]);
            }
        }
        fault
    }
}
