//! Whether a solution has the values of a contour, by its points alone.

use chordal_geometry::TurnDirection;
use chordal_heidenhain::geometry::{FreeReference, FreeValue, SolvedFreeElement};

use super::made_contour::{MadeContour, POLE, ahead, distance};

/// By how much two contours differ, mm.
pub fn difference(found: &[SolvedFreeElement], expected: &[SolvedFreeElement]) -> f64 {
    if found.len() != expected.len() {
        return f64::INFINITY;
    }
    let pairs = found.iter().zip(expected).map(|(found, expected)| {
        let centers = match (found.center, expected.center) {
            (Some(one), Some(other)) => distance(one, other),
            (None, None) => 0.0,
            _ => f64::INFINITY,
        };
        distance(found.end, expected.end).max(centers)
    });
    pairs.fold(0.0, f64::max)
}

/// By how much the values of a contour are not those of a solution, mm: by its points alone.
pub fn fault_of(contour: &MadeContour, solution: &[SolvedFreeElement]) -> f64 {
    let mut fault = 0.0_f64;
    let mut take = |off: f64| fault = fault.max(off.abs());
    let mut start = contour.start;
    let mut last_deg = contour.entry_deg;
    let mut ends_deg: Vec<f64> = Vec::new();
    for (values, own) in contour.values.iter().zip(solution) {
        let angle_between = |one: [f64; 2], other: [f64; 2]| {
            (other[1] - one[1]).atan2(other[0] - one[0]).to_degrees()
        };
        let size = distance(start, own.end);
        let sign = values.turn.map_or(0.0, TurnDirection::sign);
        let (first_deg, end_deg) = match own.center {
            None => [angle_between(start, own.end); 2].into(),
            Some(center) => {
                [start, own.end].map(|end| angle_between(center, end) + sign * 90.0).into()
            }
        };
        let off_line = |degrees: f64| {
            size * (degrees - first_deg)
                .to_radians()
                .sin()
                .abs()
                .max(if (degrees - first_deg).to_radians().cos() < 0.0 { 1.0 } else { 0.0 })
        };
        let base = |value: FreeValue| match value.from {
            None => 0.0,
            Some(FreeReference::Own(at)) => ends_deg[at],
            Some(_) => contour.entry_deg,
        };
        let point = |value: FreeValue| match value.from {
            None => [0.0; 2],
            Some(FreeReference::Own(at)) => solution[at].end,
            Some(_) => contour.start,
        };
        if values.is_tangent {
            take(off_line(last_deg));
        }
        if let Some(angle) = values.angle {
            take(off_line(angle.value + base(angle)));
        }
        for axis in 0..2 {
            if let Some(value) = values.end[axis] {
                take(value.value + point(value)[axis] - own.end[axis]);
            }
            if let (Some(value), Some(center)) = (values.center[axis], own.center) {
                take(value.value + point(value)[axis] - center[axis]);
            }
        }
        if let [Some(radius), Some(angle)] = values.polar {
            take(distance(ahead(POLE, angle.value, radius.value), own.end));
        }
        if let Some(length) = values.length {
            take(length - size);
        }
        let radius = own.center.map(|center| distance(center, own.end));
        let off_element = |point: [f64; 2]| match own.center {
            Some(center) => (distance(center, point) - radius.unwrap_or(0.0)).abs(),
            None => {
                let away = (angle_between(start, point) - first_deg).to_radians().sin();
                (distance(start, point) * away).abs()
            }
        };
        take(off_element(start));
        values.auxiliary.into_iter().flatten().for_each(|point| take(off_element(point)));
        if let Some((point, off)) = values.distance_point {
            take(off_element(point) - off);
        }
        if let (Some(known), Some(radius)) = (values.radius, radius) {
            take(known - radius);
        }
        if let (Some(degrees), Some(radius)) = (values.center_angle_deg, radius) {
            let turned = (sign * (end_deg - first_deg)).rem_euclid(360.0);
            take((turned - degrees).to_radians() * radius);
        }
        if let Some(FreeReference::Own(at)) = values.parallel_to {
            take((first_deg - ends_deg[at]).to_radians().sin() * size);
        }
        (start, last_deg) = (own.end, end_deg);
        ends_deg.push(end_deg);
    }
    fault
}
