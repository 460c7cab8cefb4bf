//! How wide the curve may be smoothed at each place of the chords.

use super::chords::Chords;
use super::{Kernel, Measure};

/// A width grows and falls with σ by no more than this.
const SLOPE: f64 = 0.2;
/// Largest second difference over the width, in tolerances (kernel plain).
const SECOND: f64 = 3.0;
/// Largest fourth difference (kernel sharp).
const FOURTH: f64 = 8.0;
/// Largest width, mm or rad.
const WIDEST: f64 = 10.0;
/// Time between two knots where the axes are at their limits, s.
const KNOT_S: f64 = 0.004;
/// Largest width of the plain kernel, in such times.
const TIMES: f64 = 1.5;
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
        let least = measure.least;
        let mut hints = [0; 6];
        let mut width = WIDEST;
        for index in 0..count {
            let at = chords.at[index];
            if index > 0 {
                width = (width + SLOPE * (at - chords.at[index - 1])).min(WIDEST);
            }
            for _ in 0..60 {
                let (share, power) = match kernel {
                    Kernel::Plain => (self.second(chords, measure, index, width, &mut hints), 0.5),
                    Kernel::Sharp => (self.fourth(chords, measure, index, width, &mut hints), 0.25),
                };
                if share <= 1.0 || width <= least {
                    break;
                }
                let factor =
                    if power == 0.5 { 1.0 / share.sqrt() } else { 1.0 / share.sqrt().sqrt() };
                width = (width * factor.clamp(0.5, 0.93)).max(least);
            }
            self.reach.push(width);
            let before = chords.place_at(at - width, &mut hints[0]);
            let after = chords.place_at(at + width, &mut hints[1]);
            let here = &chords.places[index];
            let bend = std::array::from_fn(|axis| {
                (before[axis] - 2.0 * here[axis] + after[axis]) / (width * width)
            });
            self.by_time.push(KNOT_S * measure.fastest(&bend));
        }
        graded(&mut self.by_time, &chords.at);
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
        let (at, here) = (chords.at[index], &chords.places[index]);
        let mut most = 0.0_f64;
        for (step, slot) in [(width, 0), (0.5 * width, 2)] {
            let before = chords.place_at(at - step, &mut hints[slot]);
            let after = chords.place_at(at + step, &mut hints[slot + 1]);
            let bend = std::array::from_fn(|axis| before[axis] - 2.0 * here[axis] + after[axis]);
            most = most.max(measure.of(&bend) / SECOND);
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
        self.knots.clear();
        self.knots.extend(
            self.reach
                .iter()
                .zip(&self.shares)
                .map(|(reach, share)| (reach * share).max(0.2 * least)),
        );
        graded(&mut self.knots, &chords.at);
        self.boxes.clear();
        for (knot, by_time) in self.knots.iter_mut().zip(&self.by_time) {
            let most = match kernel {
                Kernel::Plain => TIMES * by_time,
                Kernel::Sharp => *by_time,
            };
            let reach = knot.min(most.max(least));
            let apart = reach.min(by_time.max(least));
            *knot = apart;
            self.boxes.push(match kernel {
                Kernel::Plain => {
                    (12.0 * (VARIANCE * reach * reach - apart * apart / 3.0)).max(0.0).sqrt()
                }
                Kernel::Sharp => apart,
            });
        }
    }
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
