//! A profile of b = σ̇² over the path.

/// Intervals may take this much more than what was aimed at, in parts of it.
const INTERVAL_TIME_SLACK: f64 = 0.5;

/// How fast a run is travelled, as b = σ̇² by place.
///
/// Between nodes b is a parabola with the slopes 2·`acceleration` at its ends; next to rest the
/// jerk is even instead.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ReferenceProfile {
    /// How long it takes, s.
    pub time_s: f64,
    /// How much shorter the last iteration made it, s.
    pub change_s: f64,
    /// The time between nodes that was aimed at, s: features that are passed in much less are
    /// seen only roughly.
    pub step_s: f64,
    /// Places, σ from the start.
    pub sigma: Vec<f64>,
    /// σ̇² there.
    pub square: Vec<f64>,
    /// σ̈ there; at rest zero.
    pub acceleration: Vec<f64>,
}

impl ReferenceProfile {
    /// Time over interval `index`, s.
    pub(crate) fn interval_time(&self, index: usize) -> f64 {
        let distance = self.sigma[index + 1] - self.sigma[index];
        let (b0, b1) = (self.square[index], self.square[index + 1]);
        if b0 <= 0.0 || b1 <= 0.0 {
            return 3.0 * distance / (b0 + b1).sqrt();
        }
        // b by the mean slope and half the step of the slopes, so that both ends are met.
        let bend = 0.5 * (self.acceleration[index + 1] - self.acceleration[index]) * distance;
        // Gauss's rule with five nodes.
        const GAUSS_NODES: [(f64, f64); 5] = [
            (0.0, 0.568_888_888_888_888_9),
            (0.538_469_310_105_683, 0.478_628_670_499_366_5),
            (-0.538_469_310_105_683, 0.478_628_670_499_366_5),
            (0.906_179_845_938_664, 0.236_926_885_056_189_1),
            (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
        ];
        let least = 0.1 * b0.min(b1);
        GAUSS_NODES
            .iter()
            .map(|(node, weight)| {
                let share = 0.5 * (1.0 + node);
                let b = b0 + share * (b1 - b0) - 2.0 * bend * share * (1.0 - share);
                0.5 * weight * distance / b.max(least).sqrt()
            })
            .sum()
    }

    /// The times at the nodes, s.
    pub(crate) fn clock(&self) -> Vec<f64> {
        let mut now = 0.0;
        let mut clock = vec![0.0];
        for index in 0..self.sigma.len().saturating_sub(1) {
            now += self.interval_time(index);
            clock.push(now);
        }
        clock
    }

    /// Cuts intervals that turned out to take much longer than was aimed at; whether there were any.
    pub(crate) fn refine(&mut self, most: usize) -> bool {
        let last = self.sigma.len() - 1;
        let parts: Vec<usize> = (0..last)
            .map(|interval| {
                (self.interval_time(interval) / self.step_s - INTERVAL_TIME_SLACK)
                    .ceil()
                    .clamp(1.0, 64.0) as usize
            })
            .collect();
        let nodes: usize = parts.iter().sum::<usize>() + 1;
        if nodes == last + 1 || nodes > most {
            return false;
        }
        let mut finer = ReferenceProfile {
            step_s: self.step_s,
            time_s: self.time_s,
            ..ReferenceProfile::default()
        };
        for (interval, count) in parts.into_iter().enumerate() {
            for part in 0..count {
                let (sigma, square, acceleration) =
                    self.within(interval, part as f64 / count as f64);
                finer.sigma.push(sigma);
                finer.square.push(square);
                finer.acceleration.push(acceleration);
            }
        }
        finer.sigma.push(self.sigma[last]);
        finer.square.push(self.square[last]);
        finer.acceleration.push(self.acceleration[last]);
        *self = finer;
        true
    }

    /// σ, b and σ̈ at a share of the time of an interval, roughly.
    fn within(&self, interval: usize, share: f64) -> (f64, f64, f64) {
        let (s0, s1) = (self.sigma[interval], self.sigma[interval + 1]);
        let (b0, b1) = (self.square[interval], self.square[interval + 1]);
        let (a0, a1) = (self.acceleration[interval], self.acceleration[interval + 1]);
        let left = 1.0 - share;
        if share > 0.0 && b0 <= 0.0 {
            return (s0 + (s1 - s0) * share.powi(3), b1 * share.powi(4), a1 * share);
        }
        if share > 0.0 && b1 <= 0.0 {
            return (s1 - (s1 - s0) * left.powi(3), b0 * left.powi(4), a0 * left);
        }
        let bend = (a1 - a0) * (s1 - s0);
        let square = b0 * left + b1 * share - bend * share * left;
        (s0 + (s1 - s0) * share, square.max(0.1 * b0.min(b1)), a0 * left + a1 * share)
    }
}
