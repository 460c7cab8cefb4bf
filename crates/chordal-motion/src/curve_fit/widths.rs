//! How wide the curve may be smoothed at each place of the chords.
//!
//! A width is looked for among levels that grow by the root of two: the second difference over one of them
//! and over one two levels further are also the fourth. Between two levels it is interpolated. From place
//! to place the level changes little, so that two or three of them are looked at.

use chordal_geometry::AXES;

use super::chords::{ChordHint, ChordPath};
use super::{SmoothingKernel, ToleranceMeasure};

/// The largest change of a width by σ: knots at distances that change faster would make a curve with waves.
const MAX_WIDTH_SLOPE: f64 = 0.2;
/// Largest width, in tolerances: that of the last level.
const MAX_WIDTH_TOLERANCES: f64 = 1024.0;
/// Levels of widths: from the least to the widest, and three above, over which fourth differences reach.
const LEVEL_COUNT: usize = 24;
const LAST_LEVEL: usize = 20;
/// Levels from a width to twice that.
const LEVELS_PER_DOUBLING: usize = 2;
/// Time between two knots where the axes are at their limits, s.
const KNOT_INTERVAL_S: f64 = 0.004;
/// Widths are narrowed to no less than this share of the tolerance.
const MIN_WIDTH_SHARE: f64 = 0.2;
/// Variance of the plain kernel: that of a box of this half width and of the spline.
const KERNEL_VARIANCE: f64 = 0.416_67;

/// Widths at the places of the chords.
#[derive(Debug, Default)]
pub(super) struct SmoothingWidths {
    /// As the tolerance allows.
    pub reach: Vec<f64>,
    /// As time needs them: the distance of knots.
    pub by_time: Vec<f64>,
    /// Shares that the certificate requested.
    pub shares: Vec<f64>,
    /// Distance of knots.
    pub knots: Vec<f64>,
    /// Width of the box.
    pub boxes: Vec<f64>,
    levels: Vec<u8>,
}

impl SmoothingWidths {
    /// Finds the widths at every place, with what the axes can do: the largest over which the second difference
    /// (kernel plain) or the fourth (kernel sharp) is no more than so many tolerances.
    pub fn find(
        &mut self,
        chords: &ChordPath,
        measure: &ToleranceMeasure,
        kernel: SmoothingKernel,
        most: f64,
    ) {
        if chords.is_linear {
            self.find_of::<3>(chords, measure, kernel, most);
        } else {
            self.find_of::<AXES>(chords, measure, kernel, most);
        }
    }

    /// The same where no axes but the first ones move.
    fn find_of<const N: usize>(
        &mut self,
        chords: &ChordPath,
        measure: &ToleranceMeasure,
        kernel: SmoothingKernel,
        most: f64,
    ) {
        let count = chords.count() + 1;
        self.shares.clear();
        self.shares.resize(count, 1.0);
        for list in [&mut self.reach, &mut self.by_time] {
            list.clear();
            list.resize(count, 0.0);
        }
        self.levels.clear();
        self.levels.resize(count, 0);
        // Beyond the ends the chords are known as far as they are long.
        let widest = (MAX_WIDTH_TOLERANCES * measure.least).min(0.25 * chords.length());
        let mut around = WidthProbe::<N>::new(chords, measure, kernel, most);
        let top = (0..=LAST_LEVEL).rev().find(|level| around.radii[*level] <= widest).unwrap_or(0);
        let mut level = top;
        for index in 0..count {
            around.go_to(index);
            level = around.widest_level(level, 0);
            while level < top && around.fits(level + 1) {
                level += 1;
            }
            self.enter(&mut around, level, widest);
        }
        // Back again, so that a width does not depend on where the path begins: where none of the levels
        // between is allowed, one that comes from a wider one is another.
        for index in (0..count).rev() {
            let known = usize::from(self.levels[index]);
            if level <= known {
                level = known;
                continue;
            }
            around.go_to(index);
            level = around.widest_level(level, known);
            if level > known {
                self.enter(&mut around, level, widest);
            }
        }
        graded(&mut self.by_time, &chords.at);
    }

    fn enter<const N: usize>(&mut self, around: &mut WidthProbe<'_, N>, level: usize, widest: f64) {
        let index = around.index;
        self.levels[index] = level as u8;
        self.reach[index] = around.width(level).min(widest);
        self.by_time[index] = KNOT_INTERVAL_S * around.fastest(level);
    }

    /// Takes shares off.
    pub fn narrow(&mut self, falls: &[f64]) {
        self.shares.iter_mut().zip(falls).for_each(|(share, fall)| *share *= fall);
    }

    /// The distances of knots and the boxes, with the shares as they are. No width is larger than so many of
    /// those that time needs.
    pub fn settle(
        &mut self,
        chords: &ChordPath,
        measure: &ToleranceMeasure,
        kernel: SmoothingKernel,
        times: f64,
    ) {
        let least = measure.least;
        self.knots.clear();
        for index in 0..self.reach.len() {
            let by_time = (times * self.by_time[index]).max(least);
            let width = self.reach[index].min(by_time) * self.shares[index];
            // No wider than was found, where the run itself is short.
            self.knots.push(width.max(MIN_WIDTH_SHARE * least).min(self.reach[index]));
        }
        graded(&mut self.knots, &chords.at);
        self.boxes.clear();
        match kernel {
            SmoothingKernel::Plain => {
                for (knot, by_time) in self.knots.iter_mut().zip(&self.by_time) {
                    let reach = *knot;
                    *knot = reach.min(by_time.max(least));
                    let square = 12.0 * (KERNEL_VARIANCE * reach * reach - *knot * *knot / 3.0);
                    self.boxes.push(square.max(0.0).sqrt());
                }
            }
            SmoothingKernel::Sharp => self.boxes.extend_from_slice(&self.knots),
        }
    }
}

/// What lies around one of the places, over all levels of width; of the first axes.
struct WidthProbe<'a, const N: usize> {
    chords: &'a ChordPath,
    measure: &'a ToleranceMeasure,
    kernel: SmoothingKernel,
    /// Largest difference, in tolerances.
    most: f64,
    radii: [f64; LEVEL_COUNT],
    /// Where the places before and after were found last.
    hints: [[ChordHint; 2]; LEVEL_COUNT],
    index: usize,
    /// The second differences, and what of them is known: a bit a level.
    seconds: [[f64; N]; LEVEL_COUNT],
    has_second: u32,
    /// How much of what is allowed a level takes.
    uses: [f64; LEVEL_COUNT],
    has_use: u32,
}

impl<'a, const N: usize> WidthProbe<'a, N> {
    fn new(
        chords: &'a ChordPath,
        measure: &'a ToleranceMeasure,
        kernel: SmoothingKernel,
        most: f64,
    ) -> Self {
        let mut radii = [measure.least, std::f64::consts::SQRT_2 * measure.least]
            .into_iter()
            .cycle()
            .zip((0..LEVEL_COUNT).map(|level| (1_u32 << (level / LEVELS_PER_DOUBLING)) as f64))
            .map(|(least, times)| least * times);
        WidthProbe {
            chords,
            measure,
            kernel,
            most,
            radii: std::array::from_fn(|_| radii.next().unwrap_or(0.0)),
            hints: [[0; 2]; LEVEL_COUNT],
            index: 0,
            seconds: [[0.0; N]; LEVEL_COUNT],
            has_second: 0,
            uses: [0.0; LEVEL_COUNT],
            has_use: 0,
        }
    }

    fn go_to(&mut self, index: usize) {
        (self.index, self.has_second, self.has_use) = (index, 0, 0);
    }

    /// The second difference of the places.
    #[inline(always)]
    fn second(&mut self, level: usize) -> &[f64; N] {
        if self.has_second & (1 << level) == 0 {
            self.find_second(level);
        }
        &self.seconds[level]
    }

    fn find_second(&mut self, level: usize) {
        self.has_second |= 1 << level;
        let (at, radius) = (self.chords.at[self.index], self.radii[level]);
        let here = &self.chords.places[self.index];
        let [before, after] = &mut self.hints[level];
        let before: [f64; N] = self.chords.first_axes_at(at - radius, before);
        let after: [f64; N] = self.chords.first_axes_at(at + radius, after);
        let second = &mut self.seconds[level];
        for axis in 0..N {
            second[axis] = before[axis] - 2.0 * here[axis] + after[axis];
        }
    }

    /// The share of the largest difference, in the power in which it grows with the square of the width.
    #[inline(always)]
    fn used(&mut self, level: usize) -> f64 {
        let bit = 1 << level;
        if self.has_use & bit == 0 {
            self.has_use |= bit;
            let near = *self.second(level);
            self.uses[level] = match self.kernel {
                SmoothingKernel::Plain => self.measure.of_first(&near) / self.most,
                SmoothingKernel::Sharp => {
                    let far = self.second(level + LEVELS_PER_DOUBLING);
                    let mut fourth = [0.0; N];
                    for axis in 0..N {
                        fourth[axis] = far[axis] - 4.0 * near[axis];
                    }
                    (self.measure.of_first(&fourth) / self.most).sqrt()
                }
            };
        }
        self.uses[level]
    }

    /// Whether a width and half of it are allowed.
    fn fits(&mut self, level: usize) -> bool {
        self.used(level) <= 1.0
            && (level < LEVELS_PER_DOUBLING || self.used(level - LEVELS_PER_DOUBLING) <= 1.0)
    }

    /// The first level that fits, from one downwards; the least fits in any case.
    fn widest_level(&mut self, from: usize, least: usize) -> usize {
        (least + 1..=from).rev().find(|level| self.fits(*level)).unwrap_or(least)
    }

    /// The width that is allowed from a level on.
    fn width(&mut self, level: usize) -> f64 {
        let [own, next] = [level, level + 1].map(|level| self.used(level));
        let [least, most] = [self.radii[level], self.radii[level + 1]];
        if own >= 1.0 {
            return least;
        }
        if next <= 1.0 {
            // Half of the next one is not allowed, or it is the last.
            return if level >= LAST_LEVEL { most } else { least };
        }
        least + (most - least) * (1.0 - own) / (next - own)
    }

    /// The largest speed around the bend over a level, σ per s.
    fn fastest(&mut self, level: usize) -> f64 {
        let square = self.radii[level] * self.radii[level];
        let second = self.second(level);
        let mut bend = [0.0; AXES];
        for axis in 0..N {
            bend[axis] = second[axis] / square;
        }
        self.measure.fastest(&bend)
    }
}

/// Two passes: no value falls or grows faster than the slope.
fn graded(values: &mut [f64], at: &[f64]) {
    for index in 1..values.len() {
        values[index] =
            values[index].min(values[index - 1] + MAX_WIDTH_SLOPE * (at[index] - at[index - 1]));
    }
    for index in (0..values.len() - 1).rev() {
        values[index] =
            values[index].min(values[index + 1] + MAX_WIDTH_SLOPE * (at[index + 1] - at[index]));
    }
}
