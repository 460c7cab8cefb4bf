//! Points of a line or an arc that its numbers say exactly: whole increments of the text.

use std::collections::HashMap;

/// A point on a block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct BlockPoint {
    /// Where it is, as a share of the block's length.
    pub share: f64,
    /// Its coordinates in increments.
    pub at: [i64; 3],
}

/// All points of a block that are exact, its ends left out.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum ExactPoints {
    /// A line: its start, one step, and how many steps it has.
    Line { from: [i64; 3], step: [i64; 3], count: i64 },
    /// An arc: its points in order.
    Arc(Vec<BlockPoint>),
}

/// Larger coordinates have no exact points, in increments: their products stay below 2^53.
const MAX_COORDINATE_INCREMENTS: f64 = 4e7;
/// Larger circles are not searched, in increments: a metre in thousandths of a millimetre.
const MAX_RADIUS_INCREMENTS: i64 = 1_000_000;
/// A number that is so near an increment is on it, in increments: what is left of a sum of doubles.
const ON_INCREMENT: f64 = 1e-5;

/// A length as increments, where it is a whole number of them.
pub(super) fn whole(length: f64, increment: f64) -> Option<i64> {
    let count = length / increment;
    let near = count.round();
    ((count - near).abs() < ON_INCREMENT && near.abs() < MAX_COORDINATE_INCREMENTS)
        .then_some(near as i64)
}

impl ExactPoints {
    /// Those of a line.
    pub fn of_line(from: [i64; 3], to: [i64; 3]) -> ExactPoints {
        let path = [0, 1, 2].map(|axis| to[axis] - from[axis]);
        let count = path.iter().fold(0, |count, length| common(count, length.abs()));
        let step = path.map(|length| if count > 0 { length / count } else { 0 });
        ExactPoints::Line { from, step, count }
    }

    /// The nearest point at or before a share of the length, and the nearest at or after it.
    pub fn around(&self, share: f64) -> [Option<BlockPoint>; 2] {
        match self {
            ExactPoints::Line { from, step, count } => {
                // What is on a point but for rounding is on it.
                let steps = share * *count as f64;
                let on = Some(steps.round()).filter(|on| (steps - on).abs() < ON_INCREMENT);
                [on.unwrap_or(steps.floor()), on.unwrap_or(steps.ceil())].map(|steps| {
                    let steps = steps as i64;
                    let at = [0, 1, 2].map(|axis| from[axis] + step[axis] * steps);
                    let share = steps as f64 / *count as f64;
                    (steps > 0 && steps < *count).then_some(BlockPoint { share, at })
                })
            }
            ExactPoints::Arc(points) => {
                let after = points.partition_point(|point| point.share < share);
                let before = points.partition_point(|point| point.share <= share);
                [before.checked_sub(1).map(|at| points[at]), points.get(after).copied()]
            }
        }
    }
}

/// The greatest common divisor.
fn common(mut a: i64, mut b: i64) -> i64 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

/// An arc without rise, in increments: the axes of its plane and where its centre is on them.
#[derive(Clone, Copy, Debug)]
pub(super) struct ExactArc {
    pub axes: [usize; 2],
    pub center: [i64; 2],
    pub from: [i64; 3],
    pub to: [i64; 3],
    /// Directed, rad: from the first axis to the second.
    pub sweep: f64,
}

/// Circles whose points are known, by the square of their radius.
#[derive(Debug, Default)]
pub(super) struct CirclePoints(HashMap<i64, Vec<[i64; 2]>>);

impl CirclePoints {
    /// The points of an arc; `None` where one of its ends is not exactly on its circle.
    pub fn points(&mut self, arc: &ExactArc) -> Option<ExactPoints> {
        let spoke = |at: [i64; 3]| [0, 1].map(|k| at[arc.axes[k]] - arc.center[k]);
        let [first, last] = [spoke(arc.from), spoke(arc.to)];
        let square = |[a, b]: [i64; 2]| a * a + b * b;
        let radius = square(first);
        if radius == 0
            || radius != square(last)
            || radius > MAX_RADIUS_INCREMENTS * MAX_RADIUS_INCREMENTS
        {
            return None;
        }
        let turn = 2.0 * std::f64::consts::PI;
        let sweep = arc.sweep.abs();
        if sweep > turn + 1e-6 {
            return None;
        }
        let angle = |[a, b]: [i64; 2]| {
            // From the first spoke in the direction of the arc.
            let cross = (first[0] * b - first[1] * a) as f64 * arc.sweep.signum();
            let dot = (first[0] * a + first[1] * b) as f64;
            let angle = libm::atan2(cross, dot);
            if angle < 0.0 { angle + turn } else { angle }
        };
        let all = self.0.entry(radius).or_insert_with(|| on_circle(radius));
        let mut points: Vec<BlockPoint> = all
            .iter()
            .filter(|point| **point != first && **point != last)
            .map(|point| {
                let mut at = arc.from;
                for k in 0..2 {
                    at[arc.axes[k]] = arc.center[k] + point[k];
                }
                BlockPoint { share: angle(*point) / sweep, at }
            })
            .filter(|point| point.share > 0.0 && point.share < 1.0)
            .collect();
        points.sort_by(|a, b| a.share.total_cmp(&b.share));
        Some(ExactPoints::Arc(points))
    }
}

/// All whole points on the circle about zero, by the square of its radius.
fn on_circle(square: i64) -> Vec<[i64; 2]> {
    let mut points = Vec::new();
    let mut a = 0;
    while a * a <= square {
        let rest = square - a * a;
        let b = (rest as f64).sqrt().round() as i64;
        if b * b == rest {
            for (a, b) in [(a, b), (-a, b), (a, -b), (-a, -b)] {
                points.push([a, b]);
            }
        }
        a += 1;
    }
    points.sort_unstable();
    points.dedup();
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_have_the_points_of_their_common_divisor() {
        // 118 mm by 10 mm in thousandths: 2000 steps of (59, 5).
        let line = ExactPoints::of_line([-8000, -4000, 0], [110_000, 6000, 0]);
        let [before, after] = line.around(0.30001).map(Option::unwrap);
        assert_eq!(before.at, [-8000 + 600 * 59, -4000 + 600 * 5, 0]);
        assert_eq!(after.at, [-8000 + 601 * 59, -4000 + 601 * 5, 0]);
        assert_eq!(line.around(0.5).map(|point| point.unwrap().share), [0.5, 0.5]);
        // A prime and its neighbour have none.
        let line = ExactPoints::of_line([0, 0, 0], [7919, 7920, 0]);
        assert_eq!(line.around(0.5), [None, None]);
        assert_eq!(ExactPoints::of_line([5; 3], [5; 3]).around(0.5), [None, None]);
    }

    #[test]
    fn circles_have_their_whole_points() {
        // 3² + 4² = 5²; 5000 = 2³·5⁴ has 4·(2·4 + 1).
        assert_eq!(on_circle(25).len(), 12);
        assert_eq!(on_circle(5000 * 5000).len(), 36);
        let mut circles = CirclePoints::default();
        let mut half = ExactArc {
            axes: [0, 1],
            center: [0, 0],
            from: [5, 0, 7],
            to: [-5, 0, 7],
            sweep: std::f64::consts::PI,
        };
        let Some(ExactPoints::Arc(points)) = circles.points(&half) else { panic!("an arc") };
        let at: Vec<[i64; 3]> = points.iter().map(|point| point.at).collect();
        assert_eq!(at, [[4, 3, 7], [3, 4, 7], [0, 5, 7], [-3, 4, 7], [-4, 3, 7]]);
        // Clockwise it is the other half.
        half.sweep = -half.sweep;
        let Some(ExactPoints::Arc(points)) = circles.points(&half) else { panic!("an arc") };
        assert_eq!(points[0].at, [4, -3, 7]);
        // An end that is not on the circle.
        half.to = [-5, 1, 7];
        assert_eq!(circles.points(&half), None);
    }

    #[test]
    fn only_whole_increments_are_whole() {
        assert_eq!(whole(25.4, 0.001), Some(25_400));
        assert_eq!(whole(-0.1 - 0.2, 0.001), Some(-300));
        assert_eq!(whole(1.00005, 0.001), None);
        assert_eq!(whole(f64::NAN, 0.001), None);
        assert_eq!(whole(1e9, 0.001), None);
    }
}
