//! Oriented lines and circles: where they meet and touch.

use chordal_geometry::Vec2;

use crate::geometry::vectors::{COINCIDENT_POINTS_MM, unit_vector};

/// Lines that differ by less are parallel: the sine of their angle.
const PARALLEL_SINE: f64 = 1e-9;

/// A line that misses a circle by less touches it: values are written with three decimals, mm.
const NEAR_TOUCH_MM: f64 = 1e-3;

/// An oriented line or circle.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum ElementCarrier {
    Line {
        point: Vec2,
        direction: Vec2,
    },
    /// `signed` is the radius, negative for a clockwise circle: its centre lies so far to the left.
    Circle {
        center: Vec2,
        signed: f64,
    },
}

impl ElementCarrier {
    /// The direction of travel at one of its points.
    pub(super) fn direction_at(&self, point: Vec2) -> Option<Vec2> {
        match *self {
            ElementCarrier::Line { direction, .. } => Some(direction),
            ElementCarrier::Circle { center, signed } => {
                let outward = unit_vector(center, point)?;
                Some(outward.turned_left() * signed.signum())
            }
        }
    }

    /// The point in which one carrier goes over into another one in the same direction.
    pub(super) fn touch(&self, next: &ElementCarrier) -> Option<Vec2> {
        match (*self, *next) {
            (ElementCarrier::Line { direction, .. }, ElementCarrier::Circle { center, signed })
            | (ElementCarrier::Circle { center, signed }, ElementCarrier::Line { direction, .. }) => {
                Some(center - direction.turned_left() * signed)
            }
            (
                ElementCarrier::Circle { center: one, signed: r },
                ElementCarrier::Circle { center: other, signed: s },
            ) => (s != r).then(|| one - (other - one) * (r / (s - r))),
            (ElementCarrier::Line { .. }, ElementCarrier::Line { .. }) => None,
        }
    }

    /// The points in which two carriers meet, of a line and a circle the one further along the line first; `None` where
    /// they meet nowhere because they are parallel or one, so that they say nothing about a point.
    pub(super) fn meeting_points(&self, other: &ElementCarrier) -> Option<Vec<Vec2>> {
        match (*self, *other) {
            (
                ElementCarrier::Line { point, direction },
                ElementCarrier::Line { point: other, direction: along },
            ) => {
                let sine = direction.cross(along);
                if sine.abs() < PARALLEL_SINE {
                    return None;
                }
                Some(vec![point + direction * ((other - point).cross(along) / sine)])
            }
            (
                ElementCarrier::Line { point, direction },
                ElementCarrier::Circle { center, signed },
            )
            | (
                ElementCarrier::Circle { center, signed },
                ElementCarrier::Line { point, direction },
            ) => Some(points_at_distance(point, direction, center, signed.abs())),
            (
                ElementCarrier::Circle { center: one, signed: r },
                ElementCarrier::Circle { center: other, signed: s },
            ) => {
                let across = unit_vector(one, other)?;
                let between_mm = one.distance(other);
                let along = (between_mm * between_mm + r * r - s * s) / (2.0 * between_mm);
                let foot = one + across * along;
                Some(points_at_distance(foot, across.turned_left(), one, r.abs()))
            }
        }
    }

    /// How far a point is from it, mm.
    pub(super) fn distance_mm(&self, from: Vec2) -> f64 {
        match *self {
            ElementCarrier::Line { point, direction } => direction.cross(from - point).abs(),
            ElementCarrier::Circle { center, signed } => {
                (center.distance(from) - signed.abs()).abs()
            }
        }
    }
}

/// The points of a line at a distance from a point, the one further along first.
fn points_at_distance(point: Vec2, direction: Vec2, center: Vec2, radius: f64) -> Vec<Vec2> {
    let foot = point + direction * (center - point).dot(direction);
    let away = center.distance(foot);
    if away > radius + NEAR_TOUCH_MM {
        return Vec::new();
    }
    let half = (radius * radius - away * away).max(0.0).sqrt();
    if half <= COINCIDENT_POINTS_MM {
        return vec![foot];
    }
    vec![foot + direction * half, foot - direction * half]
}

/// The line that leaves one circle and goes over into another, both in their directions; a point is a circle of radius 0.
pub(super) fn common_tangent(from: (Vec2, f64), to: (Vec2, f64)) -> Option<ElementCarrier> {
    let across = unit_vector(from.0, to.0)?;
    let share = (to.1 - from.1) / from.0.distance(to.0);
    let along = 1.0 - share * share;
    if along <= 0.0 {
        return None;
    }
    let normal = across * share + across.turned_left() * along.sqrt();
    let direction = -normal.turned_left();
    Some(ElementCarrier::Line { point: from.0 - normal * from.1, direction })
}
