//! How much of its feed a block may have along its length, and where it is split.

use super::exact::{BlockPoint, ExactPoints};

/// A part is not shorter than this, mm.
const MIN_PART_MM: f64 = 2.0;
/// No part takes less time than this, s: controls read blocks and change feeds, and a few in a row are their limit.
const QUICKEST: f64 = 0.1;
/// What a split must save, s.
const PAYS: f64 = 0.05;
/// What is so near a limit is on it.
const ON_IT: f64 = 1.0 - 1e-9;
/// The most places of a block that are looked at.
const MAX_PLACES: usize = 200;
/// The most bins of a profile.
const MAX_BINS: f64 = 20_000.0;

/// The share of its feed that a block may have, by bins along its length.
#[derive(Clone, Debug)]
pub(super) struct FeedProfile {
    length: f64,
    bins: Vec<f64>,
}

impl FeedProfile {
    /// A block of a length, mm, that has the share `most` wherever nothing lowers it; bins about so long, mm.
    pub fn new(length: f64, bin: f64, most: f64) -> FeedProfile {
        let count = (length / bin).ceil().clamp(1.0, MAX_BINS) as usize;
        FeedProfile { length, bins: vec![most; count] }
    }

    fn bin(&self, at: f64) -> f64 {
        at / self.length * self.bins.len() as f64
    }

    /// The share is no larger than this from one place to another, mm.
    pub fn lower(&mut self, from: f64, to: f64, share: f64) {
        let first = self.bin(from).floor().max(0.0) as usize;
        let end = (self.bin(to).ceil().max(0.0) as usize).min(self.bins.len());
        for bin in self.bins.get_mut(first..end).unwrap_or_default() {
            *bin = bin.min(share);
        }
    }

    /// The least share between two places, as shares of the length.
    fn least(&self, from: f64, to: f64) -> f64 {
        let count = self.bins.len();
        let first = ((from * count as f64).floor() as usize).min(count - 1);
        let end = ((to * count as f64).ceil() as usize).clamp(first + 1, count);
        self.bins[first..end].iter().fold(f64::INFINITY, |least, share| least.min(*share))
    }

    /// Where the share changes, as shares of the length; where there are many, some of them.
    fn changes(&self) -> Vec<f64> {
        let count = self.bins.len();
        let mut places: Vec<f64> = (1..count)
            .filter(|&k| self.bins[k - 1] != self.bins[k])
            .map(|k| k as f64 / count as f64)
            .collect();
        let step = 2.0 / MAX_PLACES as f64;
        if places.len() > MAX_PLACES / 2 {
            let mut last = f64::NEG_INFINITY;
            places.retain(|place| {
                let is_next = place - last >= step;
                if is_next {
                    last = *place;
                }
                is_next
            });
        }
        places
    }

    /// The places where it pays to split the block at its programmed feed, mm/s, in order; `points` are those that may
    /// be places, any where there are none.
    pub fn joints(&self, feed: f64, points: Option<&ExactPoints>) -> Vec<BlockPoint> {
        let places = self.places(feed, points);
        let ends = |k: usize| match k {
            0 => 0.0,
            k if k > places.len() => 1.0,
            k => places[k - 1].share,
        };
        // The least share of each piece between two places.
        let least: Vec<f64> =
            (0..=places.len()).map(|k| self.least(ends(k), ends(k + 1))).collect();
        let count = places.len() + 2;
        // The best time up to each place, and the place before it.
        let mut best = vec![(f64::INFINITY, 0); count];
        best[0].0 = 0.0;
        for from in 0..count - 1 {
            let mut share = f64::INFINITY;
            for to in from + 1..count {
                share = share.min(least[to - 1]);
                let length = (ends(to) - ends(from)) * self.length;
                let seconds = length / (feed * share);
                let is_whole = from == 0 && to == count - 1;
                if !is_whole && (length < MIN_PART_MM * ON_IT || seconds < QUICKEST * ON_IT) {
                    continue;
                }
                let time = best[from].0 + seconds + if from > 0 { PAYS } else { 0.0 };
                if time < best[to].0 {
                    best[to] = (time, from);
                }
            }
        }
        let mut joints = Vec::new();
        let mut at = best[count - 1].1;
        while at > 0 {
            joints.push(places[at - 1]);
            at = best[at].1;
        }
        joints.reverse();
        joints
    }

    /// The exact places around each change and around what is as far from it, or from an end, as a part must be long;
    /// in order.
    fn places(&self, feed: f64, points: Option<&ExactPoints>) -> Vec<BlockPoint> {
        let around = |share: f64| match points {
            _ if share <= 0.0 || share >= 1.0 => [None; 2],
            Some(points) => points.around(share),
            None => [Some(BlockPoint { share, at: [0; 3] }), None],
        };
        let changes = self.changes();
        if changes.is_empty() {
            return Vec::new();
        }
        let short = MIN_PART_MM / self.length;
        let end = |share: f64| (QUICKEST * feed * share / self.length).max(short);
        let ends = [end(self.bins[0]), 1.0 - end(self.bins[self.bins.len() - 1])];
        let near = changes.into_iter().flat_map(|at| [at - short, at, at + short]);
        let mut places: Vec<BlockPoint> = near.chain(ends).flat_map(around).flatten().collect();
        places.sort_by(|a, b| a.share.total_cmp(&b.share));
        places.dedup_by(|a, b| a.share == b.share);
        places
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shares(joints: &[BlockPoint]) -> Vec<f64> {
        joints.iter().map(|joint| joint.share).collect()
    }

    #[test]
    fn a_block_is_split_where_its_share_changes() {
        // 100 mm, the last 20 into a corner.
        let mut profile = FeedProfile::new(100.0, 0.5, 2.0);
        profile.lower(80.0, 100.0, 1.0);
        assert_eq!(shares(&profile.joints(10.0, None)), [0.8]);
        // By thirds, the nearest before it; there is none at the ends.
        let thirds = ExactPoints::Line { from: [0; 3], step: [1, 0, 0], count: 3 };
        assert_eq!(shares(&profile.joints(10.0, Some(&thirds))), [2.0 / 3.0]);
        let none = ExactPoints::Line { from: [0; 3], step: [1, 0, 0], count: 1 };
        assert!(profile.joints(10.0, Some(&none)).is_empty());
    }

    #[test]
    fn what_saves_nothing_and_what_is_short_stays_whole() {
        let whole = FeedProfile::new(100.0, 0.5, 1.5);
        assert!(whole.joints(10.0, None).is_empty());
        // 1 mm of 100 in material: a part is 2 mm long.
        let mut profile = FeedProfile::new(100.0, 0.5, 1.0);
        profile.lower(99.0, 100.0, 0.1);
        assert_eq!(shares(&profile.joints(10.0, None)), [0.98]);
        // Where that takes less than a tenth of a second, a part is longer: 0.1 s at 50 mm/s.
        assert_eq!(shares(&profile.joints(500.0, None)), [0.95]);
        // Not long enough for two parts, and not slow enough to pay.
        let mut profile = FeedProfile::new(3.9, 0.1, 1.0);
        profile.lower(3.0, 3.9, 0.5);
        assert!(profile.joints(1.0, None).is_empty());
        let mut profile = FeedProfile::new(100.0, 0.5, 1.0);
        profile.lower(98.0, 100.0, 0.9);
        assert!(profile.joints(400.0, None).is_empty());
    }

    #[test]
    fn many_changes_are_looked_at_in_steps() {
        let mut profile = FeedProfile::new(1000.0, 0.05, 4.0);
        for k in 0..2000 {
            let at = 0.5 * f64::from(k);
            profile.lower(at, at + 0.5, 1.0 + 0.001 * f64::from(k));
        }
        let joints = profile.joints(10.0, None);
        assert!(joints.len() > 5 && joints.len() < 101, "{}", joints.len());
        assert!(joints.windows(2).all(|pair| pair[0].share < pair[1].share));
    }
}
