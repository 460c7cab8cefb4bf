//! The velocity profile along a path: jerk-limited changes of speed between places that are passed at
//! even speed.
//!
//! A path is a sequence of intervals, each with its own limits of speed, acceleration and jerk. Where the fastest profile
//! touches a limit of speed it has no acceleration, so it is made of ramps from touch to touch.
//! Two passes find the touches: the highest speed at each boundary of intervals that can be reached
//! from the touch before it, and backwards from the touch after it. The ramps go over any number
//! of intervals: a boundary as such costs nothing, and cutting a line changes no time.

mod ramp;

pub use ramp::{AccelJerk, SpeedDependentLimits, least};
use ramp::{RampAim, peak};

use crate::trajectory::JerkPhase;

/// The limits of the velocity profile on a piece of path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LimitInterval {
    /// Extent in σ.
    pub length: f64,
    /// Largest σ per s.
    pub speed: f64,
    /// Largest σ per s² and σ per s³.
    pub ability: SpeedDependentLimits,
    /// Over how many pieces of path it goes.
    pub pieces: u32,
    /// The axes come to rest where it ends.
    pub ends_at_rest: bool,
}

/// A place passed at even speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpeedNode {
    /// The boundary: before the interval of this number.
    pub node: usize,
    /// σ from the start of the intervals.
    pub at: f64,
    /// σ per s.
    pub speed: f64,
    /// The ramps from here to the next speed node have not been looked at.
    fresh: bool,
    /// Number of those ramps, where they have been found.
    ramps: usize,
}

impl SpeedNode {
    fn new(node: usize, at: f64, speed: f64) -> SpeedNode {
        SpeedNode { node, at, speed, fresh: true, ramps: usize::MAX }
    }
}

/// Solves for the speed nodes of a look-ahead window. Keeps its memory from one window to the next.
#[derive(Debug, Default)]
pub struct RampSolver {
    /// σ at each boundary, one more than intervals.
    at: Vec<f64>,
    /// Largest speed at each boundary.
    most: Vec<f64>,
    forward: Vec<f64>,
    backward: Vec<f64>,
    /// Boundaries from which a ramp begins in one of the passes.
    starts: Vec<u8>,
    speed_nodes: Vec<SpeedNode>,
    spare: Vec<SpeedNode>,
    /// Ramps between speed nodes, as far as they were looked at.
    ramps: Vec<SpeedRamps>,
}

const FORWARD_BIT: u8 = 1;
const BACKWARD_BIT: u8 = 2;

/// Speeds that differ by less, as a share, are alike but for rounding.
const EQUAL_SPEED_SHARE: f64 = 1e-9;

/// Rounds of adding speed nodes before every boundary becomes one.
const MAX_SPLIT_PASSES: usize = 24;

impl RampSolver {
    /// Finds the speed nodes of the fastest profile from the speed `from` to the speed `to`, both even.
    pub fn solve(&mut self, intervals: &[LimitInterval], from: f64, to: f64) {
        self.boundaries(intervals, from, to);
        self.pass_forward(intervals);
        self.pass_backward(intervals);
        self.choose();
        self.ramps.clear();
        for round in 0..MAX_SPLIT_PASSES {
            self.level(intervals);
            if !self.split(intervals, round + 1 == MAX_SPLIT_PASSES) {
                break;
            }
        }
        self.level(intervals);
    }

    /// Adds the phases between two boundaries, which are speed nodes, with σ counted from the start of
    /// the intervals. Says which speed node is the first.
    pub fn phases(
        &self,
        intervals: &[LimitInterval],
        begin: usize,
        end: usize,
        out: &mut Vec<JerkPhase>,
    ) -> Option<SpeedNode> {
        let first = self.speed_nodes.partition_point(|speed_node| speed_node.node < begin);
        for pair in self.speed_nodes[first..].windows(2).take_while(|pair| pair[1].node <= end) {
            let known = if pair[0].fresh { None } else { self.ramps.get(pair[0].ramps) };
            phases(intervals, known, &pair[0], &pair[1], out);
        }
        self.speed_nodes.get(first).copied()
    }

    /// The last speed node that intervals to come, in place of the end of the window, cannot change: one
    /// where the profile touches a limit of speed whatever comes after.
    pub fn last_certain(&self) -> Option<SpeedNode> {
        let last = self.most.len() - 1;
        let touches = |node: usize| {
            self.backward[node] >= self.most[node] && self.forward[node] >= self.most[node]
        };
        let free = (0..last).rev().find(|node| self.backward[*node] >= self.most[*node])?;
        let certain = |speed_node: &&SpeedNode| {
            let node = speed_node.node;
            node <= free && touches(node) && speed_node.speed >= self.most[node]
        };
        self.speed_nodes.iter().rev().find(certain).copied()
    }

    fn boundaries(&mut self, intervals: &[LimitInterval], from: f64, to: f64) {
        let count = intervals.len() + 1;
        self.at.clear();
        self.most.clear();
        let mut at = 0.0;
        let mut before = f64::INFINITY;
        for interval in intervals {
            self.at.push(at);
            self.most.push(interval.speed.min(before));
            at += interval.length;
            before = if interval.ends_at_rest { 0.0 } else { interval.speed };
        }
        self.at.push(at);
        self.most.push(before);
        self.most[0] = self.most[0].min(from);
        self.most[count - 1] = self.most[count - 1].min(to);
        self.starts.clear();
        self.starts.resize(count, 0);
    }

    fn pass_forward(&mut self, intervals: &[LimitInterval]) {
        let count = self.most.len();
        self.forward.clear();
        self.forward.resize(count, 0.0);
        self.forward[0] = self.most[0];
        self.starts[0] |= FORWARD_BIT;
        let (mut source, mut ability) = (0, SpeedDependentLimits::FREE);
        for node in 1..count {
            let interval = &intervals[node - 1];
            ability = ability.and(interval.ability);
            let (before, most) = (self.forward[node - 1], self.most[node]);
            let long = source + 1 < node;
            let mut reached = most;
            if most > before || long {
                reached = ability.climb(self.forward[source], self.at[node] - self.at[source]);
            }
            if long {
                // Also where the profile has to be slower at this boundary: it may rise and fall
                // within the interval, and then has more of its ability for itself.
                let fresh = interval.ability.climb(before, interval.length);
                if fresh > reached * (1.0 + 1e-12) {
                    (source, ability, reached) = (node - 1, interval.ability, fresh);
                    self.starts[source] |= FORWARD_BIT;
                }
            }
            self.forward[node] = reached.min(most);
            if reached >= most {
                (source, ability) = (node, SpeedDependentLimits::FREE);
                self.starts[node] |= FORWARD_BIT;
            }
        }
    }

    fn pass_backward(&mut self, intervals: &[LimitInterval]) {
        let count = self.most.len();
        self.backward.clear();
        self.backward.resize(count, 0.0);
        self.backward[count - 1] = self.most[count - 1];
        self.starts[count - 1] |= BACKWARD_BIT;
        let (mut source, mut ability) = (count - 1, SpeedDependentLimits::FREE);
        for node in (0..count - 1).rev() {
            let interval = &intervals[node];
            ability = ability.and(interval.ability);
            let (after, most) = (self.backward[node + 1], self.most[node]);
            let long = source > node + 1;
            let mut reached = most;
            if most > after || long {
                reached = ability.climb(self.backward[source], self.at[source] - self.at[node]);
            }
            if long {
                let fresh = interval.ability.climb(after, interval.length);
                if fresh > reached * (1.0 + 1e-12) {
                    (source, ability, reached) = (node + 1, interval.ability, fresh);
                    self.starts[source] |= BACKWARD_BIT;
                }
            }
            self.backward[node] = reached.min(most);
            if reached >= most {
                (source, ability) = (node, SpeedDependentLimits::FREE);
                self.starts[node] |= BACKWARD_BIT;
            }
        }
    }

    /// The boundaries from which a ramp really begins or at which one really ends.
    fn choose(&mut self) {
        self.speed_nodes.clear();
        let last = self.most.len() - 1;
        for node in 0..=last {
            let (forward, backward) = (self.forward[node], self.backward[node]);
            let begins = self.starts[node] & FORWARD_BIT != 0 && forward <= backward;
            let ends = self.starts[node] & BACKWARD_BIT != 0 && backward <= forward;
            if node == 0 || node == last || begins || ends {
                let speed = forward.min(backward);
                self.speed_nodes.push(SpeedNode::new(node, self.at[node], speed));
            }
        }
    }

    /// Lowers speed nodes that cannot be reached from their neighbours.
    fn level(&mut self, intervals: &[LimitInterval]) {
        for index in 1..self.speed_nodes.len() {
            let (a, b) = (self.speed_nodes[index - 1], self.speed_nodes[index]);
            if b.speed > a.speed && (a.fresh || b.fresh) {
                let ability = ability_of(&intervals[a.node..b.node]);
                let reached = ability.climb(a.speed, b.at - a.at);
                if reached < b.speed {
                    self.speed_nodes[index].speed = reached;
                    self.speed_nodes[index].fresh = true;
                    self.speed_nodes[index - 1].fresh = true;
                }
            }
        }
        for index in (1..self.speed_nodes.len()).rev() {
            let (a, b) = (self.speed_nodes[index - 1], self.speed_nodes[index]);
            if a.speed > b.speed && (a.fresh || b.fresh) {
                let ability = ability_of(&intervals[a.node..b.node]);
                let reached = ability.climb(b.speed, b.at - a.at);
                if reached < a.speed {
                    self.speed_nodes[index - 1].speed = reached;
                    self.speed_nodes[index - 1].fresh = true;
                    if index >= 2 {
                        self.speed_nodes[index - 2].fresh = true;
                    }
                }
            }
        }
    }

    /// Finds the ramps from a speed node to the next, and where they would be too fast.
    fn look(
        &mut self,
        intervals: &[LimitInterval],
        speed_node: &mut SpeedNode,
        next: &SpeedNode,
    ) -> Option<usize> {
        speed_node.ramps = usize::MAX;
        let intervals = &intervals[speed_node.node..next.node];
        if intervals.len() < 2 {
            return None;
        }
        let ramps = SpeedRamps::over(intervals, speed_node, next)?;
        speed_node.ramps = self.ramps.len();
        self.ramps.push(ramps);
        too_fast(intervals, &ramps, speed_node, next)
    }

    /// Puts speed nodes where a ramp would be too fast for an interval that it goes over. Says whether
    /// there were any.
    fn split(&mut self, intervals: &[LimitInterval], everywhere: bool) -> bool {
        std::mem::swap(&mut self.speed_nodes, &mut self.spare);
        self.speed_nodes.clear();
        let mut any = false;
        for index in 0..self.spare.len() {
            let mut speed_node = self.spare[index];
            let Some(next) = self.spare.get(index + 1).copied() else {
                self.speed_nodes.push(speed_node);
                break;
            };
            let is_known = !speed_node.fresh;
            speed_node.fresh = false;
            let too_fast =
                if is_known { None } else { self.look(intervals, &mut speed_node, &next) };
            let Some(cut) = too_fast else {
                self.speed_nodes.push(speed_node);
                continue;
            };
            any = true;
            speed_node.fresh = true;
            self.speed_nodes.push(speed_node);
            let node = speed_node.node + cut;
            let cuts = if everywhere { speed_node.node + 1..next.node } else { node..node + 1 };
            for node in cuts {
                let speed = self.forward[node].min(self.backward[node]);
                self.speed_nodes.push(SpeedNode::new(node, self.at[node], speed));
            }
        }
        any
    }
}

/// What holds over all the intervals.
fn ability_of(intervals: &[LimitInterval]) -> SpeedDependentLimits {
    intervals.iter().fold(SpeedDependentLimits::FREE, |all, interval| all.and(interval.ability))
}

/// The ramps between two speed nodes: up, along at even speed, down.
#[derive(Clone, Copy, Debug)]
struct SpeedRamps {
    top: f64,
    up: SpeedDependentLimits,
    down: SpeedDependentLimits,
    aim: RampAim,
    up_distance: f64,
    down_distance: f64,
    /// How long it all takes, s.
    time_s: f64,
}

impl SpeedRamps {
    fn new(
        speeds: (f64, f64),
        length: f64,
        fastest: f64,
        up: SpeedDependentLimits,
        down: SpeedDependentLimits,
    ) -> Option<SpeedRamps> {
        let (top, aim) = peak(speeds, length, fastest, &up, &down)?;
        let (up_distance, up_s) = up.extent(speeds.0, top, aim);
        let (down_distance, down_s) = down.extent(top, speeds.1, aim);
        let even_s =
            if top > 0.0 { (length - up_distance - down_distance).max(0.0) / top } else { 0.0 };
        let time_s = up_s + even_s + down_s;
        Some(SpeedRamps { top, up, down, aim, up_distance, down_distance, time_s })
    }

    /// The ramps over some intervals. Each obeys the intervals that it goes over, and no others.
    fn over(intervals: &[LimitInterval], from: &SpeedNode, to: &SpeedNode) -> Option<SpeedRamps> {
        let fastest = intervals.iter().map(|interval| interval.speed).fold(0.0, f64::max);
        let (speeds, length) = ((from.speed, to.speed), to.at - from.at);
        let all = ability_of(intervals);
        let careful = SpeedRamps::new(speeds, length, fastest, all, all)?;
        if intervals.len() < 2 {
            return Some(careful);
        }
        let slack = 1e-12 * length;
        let (mut end, mut first) = (0.0, 0);
        for (index, interval) in intervals.iter().enumerate() {
            end += interval.length;
            first = index;
            if end >= careful.up_distance - slack {
                break;
            }
        }
        let (mut begin, mut last) = (length, intervals.len() - 1);
        for (index, interval) in intervals.iter().enumerate().rev() {
            begin -= interval.length;
            last = index;
            if begin <= length - careful.down_distance + slack {
                break;
            }
        }
        let (up, down) = (ability_of(&intervals[..=first]), ability_of(&intervals[last..]));
        let fits = |ramps: &SpeedRamps| {
            (ramps.up == all || ramps.up_distance <= end + slack)
                && (ramps.down == all || ramps.down_distance <= length - begin + slack)
        };
        let with = |up: SpeedDependentLimits, down: SpeedDependentLimits| {
            let other = up != all || down != all;
            other.then(|| SpeedRamps::new(speeds, length, fastest, up, down)).flatten().filter(fits)
        };
        let quicker = |best: SpeedRamps, other: SpeedRamps| {
            if other.time_s < best.time_s { other } else { best }
        };
        // Where both ramps may be bold, one alone gains no more.
        let bold = with(up, down)
            .or_else(|| with(up, all).into_iter().chain(with(all, down)).reduce(quicker));
        Some(bold.into_iter().fold(careful, quicker))
    }
}

/// The boundary, counted from the first of the intervals, at which the ramps between two speed nodes
/// must have a speed node of their own, because they are faster than an interval allows.
fn too_fast(
    intervals: &[LimitInterval],
    ramps: &SpeedRamps,
    from: &SpeedNode,
    to: &SpeedNode,
) -> Option<usize> {
    let length = to.at - from.at;
    let SpeedRamps { top, aim, .. } = *ramps;
    let mut worst: Option<(f64, f64, usize)> = None;
    let mut begin = 0.0;
    for (index, interval) in intervals.iter().enumerate() {
        let end = begin + interval.length;
        if interval.speed < top * (1.0 - 1e-12) {
            // The profile is below the interval's speed in a part at its start and a part at its end.
            let until = |ability: &SpeedDependentLimits, rest: f64| {
                if rest >= interval.speed {
                    0.0
                } else {
                    ability.distance_until(rest, top, interval.speed, aim)
                }
            };
            let rises = until(&ramps.up, from.speed);
            let falls = length - until(&ramps.down, to.speed);
            let slack = 1e-12 * length;
            // Of like ones the outermost, so that the way back is planned alike.
            let out = (begin + end - length).abs();
            let lower = worst.is_none_or(|(speed, far, _)| {
                interval.speed < speed * (1.0 - EQUAL_SPEED_SHARE)
                    || (interval.speed <= speed * (1.0 + EQUAL_SPEED_SHARE) && out > far)
            });
            let inside = end > rises + slack && begin < falls - slack;
            if inside && lower {
                // On the way up the limit ends with the interval, on the way down it begins with it.
                let up = begin + end < rises + falls;
                let cut = if (up && index + 1 < intervals.len()) || index == 0 {
                    index + 1
                } else {
                    index
                };
                worst = Some((interval.speed, out, cut));
            }
        }
        begin = end;
    }
    worst.map(|(_, _, cut)| cut)
}

/// The phases from one speed node to the next, with σ counted from the start of the intervals; `known`
/// are the ramps between them, where they have been found.
fn phases(
    intervals: &[LimitInterval],
    known: Option<&SpeedRamps>,
    from: &SpeedNode,
    to: &SpeedNode,
    out: &mut Vec<JerkPhase>,
) {
    let intervals = &intervals[from.node..to.node];
    let length = to.at - from.at;
    let slowest = || intervals.iter().map(|interval| interval.speed).fold(f64::INFINITY, f64::min);
    if from.speed == to.speed && from.speed >= slowest() {
        return even(from.at, from.speed, length, out);
    }
    let ramps_between = known.copied().or_else(|| SpeedRamps::over(intervals, from, to));
    let ramps = ramps_between.unwrap_or_else(|| {
        // The speed nodes are as far apart as the change of speed, but for rounding.
        let (up, top) = (ability_of(intervals), from.speed.max(to.speed));
        let aim = RampAim::Short;
        let (up_distance, down_distance) =
            (up.distance(from.speed, top, aim), up.distance(top, to.speed, aim));
        SpeedRamps { top, up, down: up, aim, up_distance, down_distance, time_s: 0.0 }
    });
    let SpeedRamps { top, up, down, aim, up_distance, down_distance, .. } = ramps;
    up.phases(from.at, (from.speed, top), aim, |phase| out.push(phase));
    even(from.at + up_distance, top, length - up_distance - down_distance, out);
    down.phases(to.at - down_distance, (top, to.speed), aim, |phase| out.push(phase));
}

/// Travels at even speed, in one phase with what was even before.
fn even(at: f64, speed: f64, length: f64, out: &mut Vec<JerkPhase>) {
    if length <= 0.0 || speed <= 0.0 {
        return;
    }
    let duration_s = length / speed;
    if let Some(last) = out.last_mut()
        && last.jerk == 0.0
        && last.acceleration == 0.0
        && last.speed == speed
    {
        last.duration_s += duration_s;
        return;
    }
    out.push(JerkPhase { duration_s, from: at, speed, acceleration: 0.0, jerk: 0.0 });
}
