//! A run of chords as a function of its length: places, means, and beyond its ends.

use crate::AxisValues;

/// No run has more places: an arc of metres within a nanometre would have millions.
const MAX_CHORD_POINTS: usize = 500_000;

/// Straight lines from place to place. σ is the length along them.
#[derive(Clone, Debug, Default)]
pub(crate) struct ChordPath {
    /// The places, one more than chords.
    pub places: Vec<AxisValues>,
    /// σ of each.
    pub at: Vec<f64>,
    /// Only X, Y and Z move.
    pub is_linear: bool,
}

/// A place of the list that was found last, from where the next is sought.
pub type ChordHint = usize;

impl ChordPath {
    /// A run that begins at a place.
    pub fn begin(&mut self, place: AxisValues) {
        self.places.clear();
        self.at.clear();
        self.places.push(place);
        self.at.push(0.0);
        self.is_linear = true;
    }

    /// Goes on to a place that is `length` away; `in_line` with the last chord, which is longer then.
    pub fn push(&mut self, place: AxisValues, length: f64, in_line: bool) {
        let end = self.length() + length;
        if in_line && self.count() > 0 {
            self.places.pop();
            self.at.pop();
        }
        self.add(place, end);
    }

    /// The chords of another run with more places on long ones, where widths are looked for: so far from both
    /// ends of a chord, and each time twice as far. False where that would be too many.
    pub fn divide(&mut self, whole: &ChordPath, spacing: f64) -> bool {
        let Some(first) = whole.places.first() else { return true };
        self.begin(*first);
        let mut offsets = Vec::new();
        for (place, at) in whole.places.windows(2).zip(whole.at.windows(2)) {
            let length = at[1] - at[0];
            offsets.clear();
            let mut offset = spacing;
            while offset < 0.5 * length && offset > 0.0 {
                offsets.push(offset);
                offset *= 2.0;
            }
            let back = offsets.iter().rev().map(|offset| length - offset);
            for offset in offsets.iter().copied().chain(back) {
                let share = offset / length;
                let (from, to) = (&place[0], &place[1]);
                let between =
                    std::array::from_fn(|axis| from[axis] + share * (to[axis] - from[axis]));
                self.add(between, at[0] + offset);
            }
            self.add(place[1], at[1]);
            if self.places.len() > MAX_CHORD_POINTS {
                return false;
            }
        }
        true
    }

    /// The chords of another run with its inner places elsewhere, at the same σ.
    pub(super) fn displace(&mut self, other: &ChordPath, mut place: impl FnMut(f64) -> AxisValues) {
        let Some(first) = other.places.first() else { return };
        self.begin(*first);
        for index in 1..other.count() {
            self.add(place(other.at[index]), other.at[index]);
        }
        self.add(other.places[other.count()], other.length());
    }

    fn add(&mut self, place: AxisValues, at: f64) {
        self.is_linear &= place[3..] == self.places[0][3..];
        self.places.push(place);
        self.at.push(at);
    }

    /// How many chords there are.
    pub fn count(&self) -> usize {
        self.places.len().saturating_sub(1)
    }

    /// σ of its end.
    pub fn length(&self) -> f64 {
        self.at.last().copied().unwrap_or(0.0)
    }

    /// The chord that holds a place.
    #[inline(always)]
    pub(super) fn chord_at(&self, sigma: f64, hint: &mut ChordHint) -> usize {
        // Where all but the last end.
        let ends = &self.at[1..self.count()];
        let mut index = (*hint).min(ends.len());
        while ends.get(index).is_some_and(|end| *end <= sigma) {
            index += 1;
        }
        while index > 0 && ends[index - 1] > sigma {
            index -= 1;
        }
        *hint = index;
        index
    }

    /// The place at σ; beyond an end the chords go on, turned about the end.
    #[inline]
    pub fn place_at(&self, sigma: f64, hint: &mut ChordHint) -> AxisValues {
        self.first_axes_at(sigma, hint)
    }

    /// The first axes of the place at σ.
    #[inline(always)]
    pub(super) fn first_axes_at<const N: usize>(
        &self,
        sigma: f64,
        hint: &mut ChordHint,
    ) -> [f64; N] {
        if sigma < 0.0 || sigma > self.length() {
            return self.beyond(sigma, hint);
        }
        self.between(sigma, hint)
    }

    /// The first axes of a place between the ends.
    #[inline(always)]
    fn between<const N: usize>(&self, inside: f64, hint: &mut ChordHint) -> [f64; N] {
        let chord = self.chord_at(inside, hint);
        self.on(chord, inside)
    }

    /// Beyond an end.
    #[cold]
    fn beyond<const N: usize>(&self, sigma: f64, hint: &mut ChordHint) -> [f64; N] {
        let place: [f64; N] = self.between(self.inside(sigma), hint);
        let about = if sigma < 0.0 { &self.places[0] } else { &self.places[self.count()] };
        std::array::from_fn(|axis: usize| 2.0 * about[axis] - place[axis])
    }

    fn inside(&self, sigma: f64) -> f64 {
        let length = self.length();
        let folded = if sigma < 0.0 {
            -sigma
        } else if sigma > length {
            2.0 * length - sigma
        } else {
            sigma
        };
        folded.clamp(0.0, length)
    }

    /// The integral of the places between two on the chords, the first one's chord known.
    fn integral<const N: usize>(&self, first: usize, from: f64, to: f64) -> [f64; N] {
        let mut sum = [0.0; N];
        let (mut index, mut at, mut before) = (first, from, self.on::<N>(first, from));
        loop {
            let is_last = index + 1 == self.count() || self.at[index + 1] >= to;
            let (until, after) = if is_last {
                (to, self.on(index, to))
            } else {
                (self.at[index + 1], std::array::from_fn(|axis| self.places[index + 1][axis]))
            };
            let half = 0.5 * (until - at);
            for axis in 0..N {
                sum[axis] += half * (before[axis] + after[axis]);
            }
            if is_last {
                return sum;
            }
            (index, at, before) = (index + 1, until, after);
        }
    }

    /// The place at σ on a chord.
    #[inline(always)]
    fn on<const N: usize>(&self, chord: usize, sigma: f64) -> [f64; N] {
        let share = (sigma - self.at[chord]) / (self.at[chord + 1] - self.at[chord]);
        let (from, to) = (&self.places[chord], &self.places[chord + 1]);
        let mut place = [0.0; N];
        for axis in 0..N {
            place[axis] = from[axis] + share * (to[axis] - from[axis]);
        }
        place
    }

    /// The mean of the places within `half` of σ, as exact as the places are: chord by chord, since a difference of
    /// integrals from the start would have the rounding of all that lies before.
    pub(super) fn mean(&self, sigma: f64, half: f64, hint: &mut ChordHint) -> AxisValues {
        if !self.is_linear {
            return self.first_axes_of_mean(sigma, half, hint);
        }
        // The others stay.
        let mut mean = self.places[0];
        let moving: [f64; 3] = self.first_axes_of_mean(sigma, half, hint);
        mean[..3].copy_from_slice(&moving);
        mean
    }

    fn first_axes_of_mean<const N: usize>(
        &self,
        sigma: f64,
        half: f64,
        hint: &mut ChordHint,
    ) -> [f64; N] {
        let length = self.length();
        let (from, to) = (sigma - half, sigma + half);
        // What lies beyond an end is, with its mirror image, the place of the end.
        let before = |sigma: f64| (-sigma).max(0.0);
        let after = |sigma: f64| (sigma - length).max(0.0);
        let beyond = [before(from) - before(to), after(to) - after(from)];
        let (from, to) = (self.inside(from), self.inside(to));
        let sign = if from <= to { 1.0 } else { -1.0 };
        let (low, high) = (from.min(to), from.max(to));
        let first = self.chord_at(low, hint);
        let inner: [f64; N] = self.integral(first, low, high);
        let share = 1.0 / (2.0 * (beyond[0] + beyond[1]) + (to - from));
        let (begin, end) = (&self.places[0], &self.places[self.count()]);
        let mut mean = [0.0; N];
        for axis in 0..N {
            let outer = 2.0 * (beyond[0] * begin[axis] + beyond[1] * end[axis]);
            mean[axis] = (outer + sign * inner[axis]) * share;
        }
        mean
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ten metres of chords of many lengths, far from zero, in one line.
    fn line() -> ChordPath {
        let mut chords = ChordPath::default();
        let place = |at: f64| [500.0 + 0.6 * at, -900.0 - 0.8 * at, 700.0, 0.0, 0.0, 0.0];
        chords.begin(place(0.0));
        let mut at = 0.0;
        for index in 0..3000 {
            let length = [0.013, 0.1, 10.0, 3.0][index % 4];
            at += length;
            chords.push(place(at), length, false);
        }
        chords
    }

    #[test]
    fn a_mean_is_as_exact_as_places_however_far_from_the_start() {
        let chords = line();
        let length = chords.length();
        let mut hint = 0;
        for step in 0..20_000 {
            // Also about both ends, where a mean is the place of the line that goes on.
            let sigma = (length + 2.0) * f64::from(step) / 20_000.0 - 1.0;
            let half = [0.01, 0.3, 40.0][step as usize % 3];
            let mean = chords.mean(sigma, half, &mut hint);
            let expected = [500.0 + 0.6 * sigma, -900.0 - 0.8 * sigma, 700.0];
            for axis in 0..3 {
                let off = (mean[axis] - expected[axis]).abs();
                // A few units in the last place of the coordinates, which are below 1e4.
                assert!(off < 1e-11, "{half} about {sigma}: {off:e} off");
            }
        }
    }

    #[test]
    fn the_mean_about_an_end_is_the_end() {
        let chords = line();
        let mut hint = 0;
        for half in [0.01, 1.0, 30.0] {
            assert_eq!(chords.mean(0.0, half, &mut hint), chords.places[0]);
            let end = chords.mean(chords.length(), half, &mut hint);
            for (mean, end) in end.iter().zip(&chords.places[chords.count()]) {
                assert!((mean - end).abs() <= 4.0 * f64::EPSILON * end.abs(), "{mean}, not {end}");
            }
        }
    }

    #[test]
    fn places_on_long_chords_end_at_a_budget() {
        let (whole, mut divided) = (line(), ChordPath::default());
        assert!(divided.divide(&whole, 0.01));
        let most: f64 = divided.at.windows(2).map(|at| at[1] - at[0]).fold(0.0, f64::max);
        assert!(divided.length() == whole.length() && most <= 5.0, "{most}");
        assert!(!divided.divide(&whole, 1e-30));
        assert!(divided.places.len() < MAX_CHORD_POINTS + 300);
    }
}
