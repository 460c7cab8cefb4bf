//! A run of chords as a function of its length: places, integrals, and beyond its ends.

use chordal_geometry::AXES;

use crate::Axes;

/// Straight lines from place to place. σ is the length along them.
#[derive(Clone, Debug, Default)]
pub(crate) struct Chords {
    /// The places, one more than chords.
    pub places: Vec<Axes>,
    /// σ of each.
    pub at: Vec<f64>,
    /// The integral of the places by σ, from the start to each.
    pub integral: Vec<Axes>,
}

/// A place of the list that was found last, from where the next is sought.
pub type Hint = usize;

impl Chords {
    /// A run that begins at a place.
    pub fn begin(&mut self, place: Axes) {
        self.places.clear();
        self.at.clear();
        self.integral.clear();
        self.places.push(place);
        self.at.push(0.0);
        self.integral.push([0.0; AXES]);
    }

    /// Goes on to a place that is `length` away; `in_line` with the last chord, which is longer then.
    pub fn push(&mut self, place: Axes, length: f64, in_line: bool) {
        let end = self.length() + length;
        if in_line && self.count() > 0 {
            self.places.pop();
            self.at.pop();
            self.integral.pop();
        }
        self.add(place, end);
    }

    /// The chords of another run with more places on long ones, where widths are looked for: so far from both
    /// ends of a chord, and each time twice as far.
    pub fn divide(&mut self, whole: &Chords, apart: f64) {
        let Some(first) = whole.places.first() else { return };
        self.begin(*first);
        let mut ways = Vec::new();
        for (place, at) in whole.places.windows(2).zip(whole.at.windows(2)) {
            let length = at[1] - at[0];
            ways.clear();
            let mut way = apart;
            while way < 0.5 * length && way > 0.0 {
                ways.push(way);
                way *= 2.0;
            }
            let back = ways.iter().rev().map(|way| length - way);
            for way in ways.iter().copied().chain(back) {
                let share = way / length;
                let (from, to) = (&place[0], &place[1]);
                let between =
                    std::array::from_fn(|axis| from[axis] + share * (to[axis] - from[axis]));
                self.add(between, at[0] + way);
            }
            self.add(place[1], at[1]);
        }
    }

    /// The chords of another run with its inner places elsewhere, at the same σ.
    pub(super) fn displace(&mut self, other: &Chords, mut place: impl FnMut(f64) -> Axes) {
        let Some(first) = other.places.first() else { return };
        self.begin(*first);
        for index in 1..other.count() {
            self.add(place(other.at[index]), other.at[index]);
        }
        self.add(other.places[other.count()], other.length());
    }

    fn add(&mut self, place: Axes, at: f64) {
        let last = self.places.len() - 1;
        let (from, sum) = (self.places[last], self.integral[last]);
        let half = 0.5 * (at - self.at[last]);
        self.integral
            .push(std::array::from_fn(|axis| sum[axis] + half * (from[axis] + place[axis])));
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
    #[inline]
    pub(super) fn chord_at(&self, sigma: f64, hint: &mut Hint) -> usize {
        let last = self.count() - 1;
        let mut index = (*hint).min(last);
        while index > 0 && self.at[index] > sigma {
            index -= 1;
        }
        while index < last && self.at[index + 1] <= sigma {
            index += 1;
        }
        *hint = index;
        index
    }

    /// The place at σ; beyond an end the chords go on, turned about the end.
    #[inline]
    pub fn place_at(&self, sigma: f64, hint: &mut Hint) -> Axes {
        let length = self.length();
        let inside = self.inside(sigma);
        let index = self.chord_at(inside, hint);
        let share = (inside - self.at[index]) / (self.at[index + 1] - self.at[index]);
        let (from, to) = (&self.places[index], &self.places[index + 1]);
        let place: Axes = std::array::from_fn(|axis| from[axis] + share * (to[axis] - from[axis]));
        let about = if sigma < 0.0 {
            &self.places[0]
        } else if sigma > length {
            &self.places[self.count()]
        } else {
            return place;
        };
        std::array::from_fn(|axis| 2.0 * about[axis] - place[axis])
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

    /// The integral of the places from the start to σ.
    #[inline]
    fn integral_to(&self, sigma: f64, hint: &mut Hint) -> Axes {
        let length = self.length();
        let inside = self.inside(sigma);
        let index = self.chord_at(inside, hint);
        let (along, span) = (inside - self.at[index], self.at[index + 1] - self.at[index]);
        let (from, to) = (&self.places[index], &self.places[index + 1]);
        let sum = &self.integral[index];
        let half = 0.5 * along * along / span;
        let part: Axes = std::array::from_fn(|axis| {
            sum[axis] + from[axis] * along + (to[axis] - from[axis]) * half
        });
        if sigma < 0.0 {
            let about = &self.places[0];
            std::array::from_fn(|axis| 2.0 * about[axis] * sigma + part[axis])
        } else if sigma > length {
            let about = &self.places[self.count()];
            std::array::from_fn(|axis| 2.0 * about[axis] * (sigma - length) + part[axis])
        } else {
            part
        }
    }

    /// The mean of the places within `half` of σ.
    #[inline]
    pub(super) fn mean(&self, sigma: f64, half: f64, hint: &mut Hint) -> Axes {
        let before = self.integral_to(sigma - half, hint);
        let after = self.integral_to(sigma + half, hint);
        let share = 0.5 / half;
        std::array::from_fn(|axis| (after[axis] - before[axis]) * share)
    }
}
