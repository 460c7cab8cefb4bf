//! Patterns of holes: cycles 220 and 221.

use chordal_kernel::frames::sin_cos_degrees;

use super::step::KlartextCycleFault;
use super::values::CycleValues;

/// More points than this are a mistake in the data.
const MAX_POINTS: f64 = 100_000.0;

/// The points of a pattern.
#[derive(Clone, PartialEq, Debug)]
pub struct PatternPoints {
    /// Programmed coordinates of the plane, mm, in the order in which they are visited.
    pub points: Vec<[f64; 2]>,
    /// Between them the tool goes on the second clearance; otherwise on the first.
    pub is_high: bool,
}

/// The points of cycle 220 or 221.
///
/// # Errors
/// A number of points that is not possible.
pub fn pattern_points(
    number: u32,
    values: &CycleValues,
) -> Result<PatternPoints, KlartextCycleFault> {
    let points = match number {
        220 => circle(values)?,
        _ => grid(values)?,
    };
    // Without Q301 it goes high.
    let is_high = !values.has(301) || values.number(301) != 0.0;
    Ok(PatternPoints { points, is_high })
}

fn count(values: &CycleValues, number: u32) -> Result<u32, KlartextCycleFault> {
    let value = values.number(number).round();
    if (1.0..=MAX_POINTS).contains(&value) {
        return Ok(value as u32);
    }
    let message = format!("Q{number} is {value}: it is the number of points");
    Err(KlartextCycleFault::BadValue(message))
}

fn circle(values: &CycleValues) -> Result<Vec<[f64; 2]>, KlartextCycleFault> {
    let count = count(values, 241)?;
    let center = [values.length(216), values.length(217)];
    let radius = values.length(244) / 2.0;
    let (first, last) = (values.number(245), values.number(246));
    let step = match values.number(247) {
        // The points share the circle, or the arc with one at each end.
        0.0 => {
            let angle = last - first;
            let is_circle = angle != 0.0 && angle.rem_euclid(360.0) == 0.0;
            let parts = if is_circle { count } else { count.saturating_sub(1).max(1) };
            angle / f64::from(parts)
        }
        step => step,
    };
    let point = |index: u32| {
        let (sin, cos) = sin_cos_degrees(first + step * f64::from(index));
        [center[0] + radius * cos, center[1] + radius * sin]
    };
    Ok((0..count).map(point).collect())
}

/// Lines that are gone through to and fro, turned about the first point.
fn grid(values: &CycleValues) -> Result<Vec<[f64; 2]>, KlartextCycleFault> {
    let (columns, lines) = (count(values, 242)?, count(values, 243)?);
    if f64::from(columns) * f64::from(lines) > MAX_POINTS {
        let message = format!("{columns} columns of {lines} lines are too many points");
        return Err(KlartextCycleFault::BadValue(message));
    }
    let start = [values.length(225), values.length(226)];
    let spacing = [values.length(237), values.length(238)];
    let (sin, cos) = sin_cos_degrees(values.number(224));
    let point = |column: u32, line: u32| {
        let [x, y] = [f64::from(column) * spacing[0], f64::from(line) * spacing[1]];
        [start[0] + x * cos - y * sin, start[1] + x * sin + y * cos]
    };
    let mut points = Vec::new();
    for line in 0..lines {
        for index in 0..columns {
            let column = if line % 2 == 0 { index } else { columns - 1 - index };
            points.push(point(column, line));
        }
    }
    Ok(points)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;

    fn points(number: u32, numbers: &[(u32, f64)]) -> Vec<[f64; 2]> {
        let numbers: BTreeMap<u32, f64> = numbers.iter().copied().collect();
        let values = CycleValues::new(numbers, BTreeMap::new(), 1.0, 1.0 / 60.0);
        let found = pattern_points(number, &values).expect("points").points;
        found.iter().map(|point| point.map(|value| (value * 1e4).round() / 1e4)).collect()
    }

    #[test]
    fn points_share_a_circle_or_an_arc() {
        let data = [(216, 50.0), (217, 50.0), (244, 80.0), (246, 360.0), (241, 8.0)];
        let found = points(220, &data);
        assert_eq!(found[..3], [[90.0, 50.0], [78.2843, 78.2843], [50.0, 90.0]]);
        let arc = [(244, 40.0), (245, 90.0), (246, 270.0), (241, 5.0)];
        assert_eq!(points(220, &arc).last(), Some(&[0.0, -20.0]));
    }

    #[test]
    fn grids_are_gone_through_to_and_fro() {
        let data = [(225, 10.0), (226, 5.0), (237, 10.0), (238, 5.0), (242, 2.0), (243, 3.0)];
        let found = points(221, &data);
        assert_eq!(found[..4], [[10.0, 5.0], [20.0, 5.0], [20.0, 10.0], [10.0, 10.0]]);
        let mut turned = data.to_vec();
        turned.push((224, 30.0));
        assert_eq!(points(221, &turned).last(), Some(&[13.6603, 18.6603]));
    }
}
