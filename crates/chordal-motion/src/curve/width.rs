//! How wide the curve may be smoothed at each place of the chords.

use super::chords::{Chords, Hint};
use super::{Kernel, Measure};
use crate::Axes;

/// A width grows and falls with σ by no more than this.
const SLOPE: f64 = 0.2;
/// Largest second difference over the width, in tolerances (kernel plain).
const SECOND: f64 = 3.0;
/// Largest fourth difference (kernel sharp).
const FOURTH: f64 = 8.0;
/// Largest width, in tolerances.
const WIDEST: f64 = 1000.0;
/// Time between two knots where the axes are at their limits, s.
const KNOT_S: f64 = 0.004;
/// Largest width of the plain kernel, in such times.
const TIMES: f64 = 1.5;
/// No share makes a width smaller than this part of the least.
const FLOOR: f64 = 0.2;
/// Variance of the plain kernel: that of a box of this half width and of the spline.
const VARIANCE: f64 = 0.416_67;

/// Widths at the places of the chords.
#[derive(Debug, Default)]
pub(super) struct Widths {
    /// As the tolerance allows.
    pub reach: Vec<f64>,
    /// As time asks for.
    pub by_time: Vec<f64>,
    /// Shares that the certificate asked for.
    pub shares: Vec<f64>,
    /// Distance of knots.
    pub knots: Vec<f64>,
    /// Width of the box.
    pub boxes: Vec<f64>,
}

impl Widths {
    /// Finds the widths at every place, with what the axes can do.
    pub fn find(&mut self, chords: &Chords, measure: &Measure, kernel: Kernel) {
        let count = chords.count() + 1;
        self.reach.clear();
        self.by_time.clear();
        self.shares.clear();
        self.shares.resize(count, 1.0);
        self.reach.resize(count, 0.0);
        // There and back, so that a width does not depend on where the path begins.
        self.march(chords, measure, kernel, 0..count);
        self.march(chords, measure, kernel, (0..count).rev());
        let mut hints = [0; 2];
        for (index, &width) in self.reach.iter().enumerate() {
            let [a, b] = &mut hints;
            let difference = difference(chords, index, width, [a, b]);
            let bend = difference.map(|part| part / (width * width));
            self.by_time.push(KNOT_S * measure.fastest(&bend));
        }
        graded(&mut self.by_time, &chords.at);
    }

    /// Widths that the tolerance allows, one place after the other: the larger of those that are
    /// known and those found from the place before.
    fn march(
        &mut self,
        chords: &Chords,
        measure: &Measure,
        kernel: Kernel,
        places: impl Iterator<Item = usize>,
    ) {
        let least = measure.least;
        // Beyond the ends the chords are known as far as they are long.
        let widest = (WIDEST * least).min(0.25 * chords.length());
        let mut hints = [0; 6];
        let mut width = widest;
        let mut last: Option<f64> = None;
        for index in places {
            let at = chords.at[index];
            let way = last.map_or(0.0, |last| (at - last).abs());
            width = (width + SLOPE * way).min(widest);
            for _ in 0..60 {
                let share = match kernel {
                    Kernel::Plain => self.second(chords, measure, index, width, &mut hints).sqrt(),
                    Kernel::Sharp => {
                        self.fourth(chords, measure, index, width, &mut hints).sqrt().sqrt()
                    }
                };
                if share <= 1.0 || width <= least {
                    break;
                }
                width = (width * (1.0 / share).clamp(0.5, 0.93)).max(least).min(widest);
            }
            self.reach[index] = self.reach[index].max(width);
            last = Some(at);
        }
    }

    /// The second difference over a width and over half of it, in those that are allowed.
    fn second(
        &self,
        chords: &Chords,
        measure: &Measure,
        index: usize,
        width: f64,
        hints: &mut [usize; 6],
    ) -> f64 {
        let [a, b, c, d, ..] = hints;
        let mut most = 0.0_f64;
        for (step, hints) in [(width, [a, b]), (0.5 * width, [c, d])] {
            let difference = difference(chords, index, step, hints);
            most = most.max(measure.of(&difference) / SECOND);
            if most > 1.0 {
                break;
            }
        }
        most
    }

    fn fourth(
        &self,
        chords: &Chords,
        measure: &Measure,
        index: usize,
        width: f64,
        hints: &mut [usize; 6],
    ) -> f64 {
        let (at, here) = (chords.at[index], &chords.places[index]);
        let mut most = 0.0_f64;
        for step in [width, 0.5 * width] {
            let slots: [usize; 4] = if step == width { [0, 1, 2, 3] } else { [2, 3, 4, 5] };
            let ways = [-2.0 * step, 2.0 * step, -step, step];
            let [far, beyond, before, after] =
                std::array::from_fn(|k| chords.place_at(at + ways[k], &mut hints[slots[k]]));
            let bend = std::array::from_fn(|axis| {
                far[axis] + beyond[axis] - 4.0 * (before[axis] + after[axis]) + 6.0 * here[axis]
            });
            most = most.max(measure.of(&bend) / FOURTH);
            if most > 1.0 {
                break;
            }
        }
        most
    }

    /// Whether the tolerance, not time, sets the width on most of the run.
    pub fn are_tight(&self, chords: &Chords) -> bool {
        let mut tight = 0.0;
        for index in 1..chords.count() + 1 {
            if self.reach[index] < self.by_time[index] {
                tight += chords.at[index] - chords.at[index - 1];
            }
        }
        tight > 0.5 * chords.length()
    }

    /// The distances of knots and the boxes, with the shares as they are.
    pub fn settle(&mut self, chords: &Chords, measure: &Measure, kernel: Kernel) {
        let least = measure.least;
        let times = if kernel == Kernel::Plain { TIMES } else { 1.0 };
        self.knots.clear();
        for index in 0..self.reach.len() {
            let by_time = (times * self.by_time[index]).max(least);
            let width = self.reach[index].min(by_time) * self.shares[index];
            // No wider than was found, where the run itself is short.
            self.knots.push(width.max(FLOOR * least).min(self.reach[index]));
        }
        graded(&mut self.knots, &chords.at);
        self.boxes.clear();
        for (knot, by_time) in self.knots.iter_mut().zip(&self.by_time) {
            let reach = *knot;
            *knot = reach.min(by_time.max(least));
            self.boxes.push(match kernel {
                Kernel::Plain => {
                    (12.0 * (VARIANCE * reach * reach - *knot * *knot / 3.0)).max(0.0).sqrt()
                }
                Kernel::Sharp => *knot,
            });
        }
    }
}

/// The second difference of the places around one of them.
fn difference(chords: &Chords, index: usize, way: f64, hints: [&mut Hint; 2]) -> Axes {
    let (at, here) = (chords.at[index], &chords.places[index]);
    let [before, after] = hints;
    let (before, after) = (chords.place_at(at - way, before), chords.place_at(at + way, after));
    std::array::from_fn(|axis| before[axis] - 2.0 * here[axis] + after[axis])
}

/// Two passes: no value falls or grows faster than the slope.
fn graded(values: &mut [f64], at: &[f64]) {
    for index in 1..values.len() {
        values[index] = values[index].min(values[index - 1] + SLOPE * (at[index] - at[index - 1]));
    }
    for index in (0..values.len() - 1).rev() {
        values[index] = values[index].min(values[index + 1] + SLOPE * (at[index + 1] - at[index]));
    }
}
