//! A closed outline of lines and arcs: distance, point-in-outline test, orientation.

use core::f64::consts::TAU;

use chordal_geometry::{Circle2, Line2, Vec2, circle_circle, line_circle, line_line};

/// Points closer than this, mm, are one point.
pub(super) const COINCIDENT_POINT_MM: f64 = 1e-6;

/// A straight or circular part, with its direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OutlineElement {
    /// A line.
    Line {
        /// Its start, mm.
        from: Vec2,
        /// Its end, mm.
        to: Vec2,
    },
    /// An arc of at most one turn.
    Arc {
        /// Its start, mm.
        from: Vec2,
        /// Its end, mm.
        to: Vec2,
        /// Its centre, mm.
        center: Vec2,
        /// Directed angle, rad: positive counter-clockwise.
        sweep: f64,
    },
}

impl OutlineElement {
    /// Its start, mm.
    pub fn from(&self) -> Vec2 {
        match *self {
            OutlineElement::Line { from, .. } | OutlineElement::Arc { from, .. } => from,
        }
    }

    /// Its end, mm.
    pub fn to(&self) -> Vec2 {
        match *self {
            OutlineElement::Line { to, .. } | OutlineElement::Arc { to, .. } => to,
        }
    }

    /// Its radius, mm; zero for a line.
    pub fn radius(&self) -> f64 {
        match *self {
            OutlineElement::Line { .. } => 0.0,
            OutlineElement::Arc { from, center, .. } => from.distance(center),
        }
    }

    /// Its length, mm.
    pub fn length(&self) -> f64 {
        match *self {
            OutlineElement::Line { from, to } => from.distance(to),
            OutlineElement::Arc { sweep, .. } => self.radius() * sweep.abs(),
        }
    }

    /// The point at a fraction of the length.
    pub fn point(&self, t: f64) -> Vec2 {
        match *self {
            _ if t <= 0.0 => self.from(),
            _ if t >= 1.0 => self.to(),
            OutlineElement::Line { from, to } => from + (to - from) * t,
            OutlineElement::Arc { from, center, sweep, .. } => {
                center + turned(from - center, sweep * t)
            }
        }
    }

    /// The part between two fractions.
    pub fn part(&self, t0: f64, t1: f64) -> OutlineElement {
        let (from, to) = (self.point(t0), self.point(t1));
        match *self {
            OutlineElement::Line { .. } => OutlineElement::Line { from, to },
            OutlineElement::Arc { center, sweep, .. } => {
                OutlineElement::Arc { from, to, center, sweep: sweep * (t1 - t0) }
            }
        }
    }

    /// The same element in the opposite direction.
    pub fn reversed(&self) -> OutlineElement {
        match *self {
            OutlineElement::Line { from, to } => OutlineElement::Line { from: to, to: from },
            OutlineElement::Arc { from, to, center, sweep } => {
                OutlineElement::Arc { from: to, to: from, center, sweep: -sweep }
            }
        }
    }

    /// The fraction of the length at a point of its line or circle; `None` when the point is beyond an end by
    /// more than `tolerance`, mm.
    pub fn fraction(&self, p: Vec2, tolerance: f64) -> Option<f64> {
        let length = self.length();
        if length <= 0.0 {
            return None;
        }
        let slack = tolerance / length;
        let t = match *self {
            OutlineElement::Line { from, to } => (p - from).dot(to - from) / (length * length),
            OutlineElement::Arc { from, center, sweep, .. } => {
                let (u, v) = (from - center, p - center);
                let angle = libm::atan2(u.cross(v), u.dot(v)) * sweep.signum();
                let t = angle / sweep.abs();
                // A point just before the start counts as the start, not as nearly a full turn.
                let before = angle < 0.0 && -t > slack;
                if before { (angle + TAU) / sweep.abs() } else { t }
            }
        };
        (t >= -slack && t <= 1.0 + slack).then(|| t.clamp(0.0, 1.0))
    }

    /// Distance to a point, mm.
    pub fn distance(&self, p: Vec2) -> f64 {
        let ends = p.distance(self.from()).min(p.distance(self.to()));
        match *self {
            OutlineElement::Line { from, to } => match self.fraction(p, 0.0) {
                Some(_) => ((to - from).cross(p - from) / self.length()).abs(),
                None => ends,
            },
            OutlineElement::Arc { center, .. } => match self.fraction(p, 0.0) {
                Some(_) => (p.distance(center) - self.radius()).abs().min(ends),
                None => ends,
            },
        }
    }

    /// The points that two elements have in common, within a tolerance beyond their ends, mm.
    pub fn crossings(&self, other: &OutlineElement, tolerance: f64) -> Vec<Vec2> {
        let line = |from: Vec2, to: Vec2| Line2 { point: from, direction: to - from };
        let circle =
            |element: &OutlineElement, center: Vec2| Circle2 { center, radius: element.radius() };
        let points: Vec<Vec2> = match (*self, *other) {
            (OutlineElement::Line { from, to }, OutlineElement::Line { from: a, to: b }) => {
                line_line(line(from, to), line(a, b), 1e-12).map(|c| c.point).into_iter().collect()
            }
            (OutlineElement::Line { from, to }, OutlineElement::Arc { center, .. }) => {
                line_circle(line(from, to), circle(other, center), tolerance).points().collect()
            }
            (OutlineElement::Arc { center, .. }, OutlineElement::Line { from, to }) => {
                line_circle(line(from, to), circle(self, center), tolerance).points().collect()
            }
            (OutlineElement::Arc { center, .. }, OutlineElement::Arc { center: second, .. }) => {
                circle_circle(circle(self, center), circle(other, second), tolerance)
                    .points()
                    .collect()
            }
        };
        let on_both = |p: &Vec2| {
            self.fraction(*p, tolerance).is_some() && other.fraction(*p, tolerance).is_some()
        };
        points.into_iter().filter(on_both).collect()
    }

    /// The direction at a fraction of its length; `None` without a length.
    pub fn direction(&self, t: f64) -> Option<Vec2> {
        match *self {
            OutlineElement::Line { from, to } => (to - from).normalized(),
            OutlineElement::Arc { center, sweep, .. } => {
                let outward = (self.point(t) - center).normalized()?;
                Some(outward.turned_left() * sweep.signum())
            }
        }
    }

    /// The parallel element on the left, to the right for a negative distance, mm; `None` for an arc that vanishes.
    pub fn moved_left(&self, distance: f64) -> Option<OutlineElement> {
        match *self {
            OutlineElement::Line { from, to } => {
                let by = (to - from).normalized()?.turned_left() * distance;
                Some(OutlineElement::Line { from: from + by, to: to + by })
            }
            OutlineElement::Arc { from, to, center, sweep } => {
                let radius = self.radius();
                let moved = radius - distance * sweep.signum();
                // An arc without a radius is a point, which no loop contains as an arc.
                if moved <= COINCIDENT_POINT_MM {
                    return None;
                }
                let scale = moved / radius;
                Some(OutlineElement::Arc {
                    from: center + (from - center) * scale,
                    to: center + (to - center) * scale,
                    center,
                    sweep,
                })
            }
        }
    }

    /// Its ends, and the points of an arc that lie farthest along the axes.
    pub fn extremes(&self) -> Vec<Vec2> {
        let mut points = vec![self.from(), self.to()];
        if let OutlineElement::Arc { center, .. } = *self {
            let radius = self.radius();
            let along = [(radius, 0.0), (0.0, radius), (-radius, 0.0), (0.0, -radius)];
            points.extend(
                along
                    .into_iter()
                    .map(|(a, b)| center + Vec2::new(a, b))
                    .filter(|p| self.fraction(*p, 0.0).is_some()),
            );
        }
        points
    }

    /// Appends the ends of chords that deviate by at most `tolerance` mm.
    fn chords(&self, tolerance: f64, into: &mut Vec<Vec2>) {
        let count = match *self {
            OutlineElement::Line { .. } => 1.0,
            OutlineElement::Arc { sweep, .. } => {
                let cosine = (1.0 - tolerance / self.radius()).clamp(-1.0, 1.0);
                (sweep.abs() / (2.0 * libm::acos(cosine)).max(1e-3)).ceil().clamp(2.0, 10_000.0)
            }
        };
        for index in 1..=count as u32 {
            into.push(self.point(f64::from(index) / count));
        }
    }
}

fn turned(v: Vec2, angle: f64) -> Vec2 {
    let (sin, cos) = libm::sincos(angle);
    Vec2::new(v.a * cos - v.b * sin, v.a * sin + v.b * cos)
}

/// Why a chain of elements is not an outline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OutlineError {
    /// End and start differ; the gap, mm.
    Open(f64),
    /// It crosses, touches or reverses onto itself at a point.
    CrossesItself(Vec2),
    /// It encloses no area.
    Empty,
}

/// A simple closed outline, counter-clockwise.
#[derive(Clone, Debug)]
pub struct Outline {
    elements: Vec<OutlineElement>,
    /// Chords within 0.001 mm, for the inside test.
    polygon: Vec<Vec2>,
    clockwise: bool,
}

impl Outline {
    /// Checks that the elements close (within `tolerance`, mm) and do not cross.
    pub fn new(elements: Vec<OutlineElement>, tolerance: f64) -> Result<Outline, OutlineError> {
        let mut elements: Vec<OutlineElement> = elements.iter().filter_map(through_ends).collect();
        let (Some(first), Some(last)) = (elements.first().copied(), elements.last().copied())
        else {
            return Err(OutlineError::Empty);
        };
        let gap = last.to().distance(first.from());
        if gap > tolerance {
            return Err(OutlineError::Open(gap));
        }
        if gap > 0.0 {
            elements.push(OutlineElement::Line { from: last.to(), to: first.from() });
            elements.retain(|element| element.length() > COINCIDENT_POINT_MM);
            close(&mut elements);
        }
        if let Some(point) = self_crossing(&elements) {
            return Err(OutlineError::CrossesItself(point));
        }
        let area = area(&elements);
        if area.abs() <= COINCIDENT_POINT_MM {
            return Err(OutlineError::Empty);
        }
        let clockwise = area < 0.0;
        if clockwise {
            elements = elements.iter().rev().map(OutlineElement::reversed).collect();
        }
        let polygon = polygon(&elements);
        Ok(Outline { elements, polygon, clockwise })
    }

    /// An outline of a loop that is known to be closed, simple and counter-clockwise.
    pub(super) fn of_loop(elements: Vec<OutlineElement>) -> Outline {
        let polygon = polygon(&elements);
        Outline { elements, polygon, clockwise: false }
    }

    /// The elements in order, counter-clockwise.
    pub fn elements(&self) -> &[OutlineElement] {
        &self.elements
    }

    /// True when the elements passed to [`Outline::new`] were clockwise.
    pub fn was_clockwise(&self) -> bool {
        self.clockwise
    }

    /// The middle of each element.
    pub fn middles(&self) -> impl Iterator<Item = Vec2> + '_ {
        self.elements.iter().map(|element| element.point(0.5))
    }

    /// Distance of a point from the outline, mm.
    pub fn distance(&self, p: Vec2) -> f64 {
        self.elements.iter().map(|element| element.distance(p)).fold(f64::INFINITY, f64::min)
    }

    /// True for a point inside; exact only for points further from the outline than its chords (0.001 mm).
    pub fn contains(&self, p: Vec2) -> bool {
        let corners = &self.polygon;
        let mut inside = false;
        for (index, b) in corners.iter().enumerate() {
            let a = corners[(index + corners.len() - 1) % corners.len()];
            let crosses = (a.b > p.b) != (b.b > p.b);
            if crosses && p.a < a.a + (b.a - a.a) * ((p.b - a.b) / (b.b - a.b)) {
                inside = !inside;
            }
        }
        inside
    }
}

/// The element with the centre of an arc adjusted to pass exactly through both ends; `None` without a length.
fn through_ends(element: &OutlineElement) -> Option<OutlineElement> {
    let adjusted = match *element {
        OutlineElement::Line { .. } => *element,
        OutlineElement::Arc { from, to, center, sweep } => {
            let chord = to - from;
            match chord.normalized().filter(|_| chord.length() > COINCIDENT_POINT_MM) {
                None => *element,
                Some(along) => {
                    let middle = from + chord * 0.5;
                    let left = along.turned_left();
                    let center = middle + left * left.dot(center - middle);
                    let (u, v) = (from - center, to - center);
                    let angle = libm::atan2(u.cross(v), u.dot(v));
                    let turned =
                        if angle * sweep < 0.0 { angle + TAU * sweep.signum() } else { angle };
                    OutlineElement::Arc { from, to, center, sweep: turned }
                }
            }
        }
    };
    (adjusted.length() > COINCIDENT_POINT_MM).then_some(adjusted)
}

/// Makes each end bitwise equal to the next start.
fn close(elements: &mut [OutlineElement]) {
    let count = elements.len();
    for index in 0..count {
        let next = elements[(index + 1) % count].from();
        match &mut elements[index] {
            OutlineElement::Line { to, .. } | OutlineElement::Arc { to, .. } => *to = next,
        }
    }
}

/// A point where the chain meets itself, other than the joints of neighbours; `None` when there is none.
fn self_crossing(elements: &[OutlineElement]) -> Option<Vec2> {
    let count = elements.len();
    for (i, first) in elements.iter().enumerate() {
        for (j, second) in elements.iter().enumerate().skip(i + 1) {
            for point in first.crossings(second, COINCIDENT_POINT_MM) {
                let joint = |a: &OutlineElement, b: &OutlineElement| {
                    a.to().distance(point) < 1e-3 && b.from().distance(point) < 1e-3
                };
                let after = j == i + 1 && joint(first, second);
                let before = (j + 1) % count == i && joint(second, first);
                if !after && !before {
                    return Some(point);
                }
            }
            if let (OutlineElement::Line { from, to }, OutlineElement::Line { to: end, .. }) =
                (first, second)
                && j == i + 1
            {
                let (u, v) = (*to - *from, *end - *to);
                if u.dot(v) < 0.0 && u.cross(v).abs() <= 1e-9 * u.length() * v.length() {
                    return Some(*to);
                }
            }
        }
    }
    None
}

/// Directed area, mm²: positive counter-clockwise.
fn area(elements: &[OutlineElement]) -> f64 {
    let mut twice = 0.0;
    for element in elements {
        twice += element.from().cross(element.to());
        if let OutlineElement::Arc { sweep, .. } = *element {
            let radius = element.radius();
            twice += radius * radius * (sweep - libm::sin(sweep));
        }
    }
    0.5 * twice
}

fn polygon(elements: &[OutlineElement]) -> Vec<Vec2> {
    let mut corners = Vec::new();
    for element in elements {
        element.chords(1e-3, &mut corners);
    }
    corners
}
