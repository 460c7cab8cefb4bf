//! The intervals of a run: how the axes move with σ at both ends of each, and what that allows.

use chordal_geometry::AXES;

use super::RunEnding;
use crate::cube_root::cbrt;
use crate::piece::AxisJet;
use crate::time_bound::PathRun;

/// An interval takes no longer than this at the largest speed without jerk, s.
const MAX_INTERVAL_S: f64 = 0.004;
/// Nor does it take longer than this share of the time in which jerk alone would make the speed: a ramp needs several
/// intervals.
const RAMP_INTERVAL_SHARE: f64 = 0.35;
/// The shortest interval that is made for that, s: where acceleration is the limit a ramp takes longer.
const MIN_RAMP_INTERVAL_S: f64 = 0.0005;
/// H·√|q'''| on an interval: with it the limits between its ends are met within a thousandth.
const MAX_THIRD_ROOT: f64 = 0.08;
/// An arc turns by no more on an interval, rad.
const MAX_INTERVAL_TURN_RAD: f64 = 0.04;
/// Passes in which intervals that turn out to take too long are cut. The speed is known better after each.
const MAX_CUTTING_PASSES: usize = 12;
/// Parts into which an interval is cut at once, at most.
const MAX_PARTS_PER_CUT: f64 = 8.0;
/// The first interval from rest takes so long at full jerk at most, s, and this share of the time in which jerk
/// alone makes the speed; each of the next ends later by a share.
const MAX_FIRST_INTERVAL_S: f64 = 0.02;
const FIRST_RAMP_SHARE: f64 = 0.3;
const INTERVAL_GROWTH: f64 = 0.15;
const GROWING_INTERVALS: u32 = 16;
/// The least distance between such a cut and the end of a piece, as a share of the interval: on a very short interval next to
/// long ones a change of acceleration would be a jerk far above any limit.
const MIN_CUT_SPACING_SHARE: f64 = 0.2;
/// The largest number of intervals. A run that takes minutes in one window gets longer ones: it loses as much as they are coarse at
/// each change of speed, and no limit. One that has too many even so keeps the profile that it has.
const MAX_GRID_INTERVALS: usize = 20_000;
/// How many times as long its intervals may become.
const MAX_COARSENING: f64 = 1024.0;

/// Shares of the limits that the first profile, without jerk along the path, may use: the solver needs a start inside of all limits.
const BOUND_ACCELERATION_SHARE: f64 = 0.96;
const BOUND_JERK_SHARE: f64 = 0.87;
const BOUND_TURNING_JERK_SHARE: f64 = 0.9;
/// What rounding makes of a product, at most.
const PRODUCT_ROUNDING_SHARE: f64 = 1e-12;

/// A node between two intervals.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct GridNode {
    /// σ from the start of the run.
    pub at: f64,
    /// First and second derivative of each axis, as shares of its acceleration and its jerk:
    /// q'/A, q''/A, q'/J and q''/J.
    pub by_acceleration: [[f64; AXES]; 2],
    pub by_jerk: [[f64; AXES]; 2],
    /// Largest σ̇² by velocities and feeds.
    pub cap: f64,
    /// Share of the acceleration that may be used.
    pub share: f64,
}

/// What lies between two nodes.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct GridInterval {
    /// Extent in σ.
    pub length: f64,
    /// Number of its piece.
    pub piece: u32,
    /// q'''/J at its start and its end.
    pub third: [[f64; AXES]; 2],
    /// Share of the jerk that may be used.
    pub share: f64,
    /// The same before anything was taken back.
    pub most: f64,
}

/// The grid of a run, with one interval of nothing before an end that is passed at speed.
#[derive(Debug, Default)]
pub(super) struct ProfileGrid {
    pub nodes: Vec<GridNode>,
    pub intervals: Vec<GridInterval>,
    /// The axes that move.
    pub axes: Vec<usize>,
    /// Of each axis, jerk by velocity and by acceleration.
    pub of_velocity: [f64; AXES],
    pub of_acceleration: [f64; AXES],
    /// For each interval the largest coefficient without jerk.
    pub bound: Vec<f64>,
    /// Intervals are so many times as long as usual.
    scale: f64,
    /// Where intervals begin, σ, and their pieces.
    cuts: Vec<GridCut>,
    /// Whether an axis moves at one of the nodes.
    moves: [bool; AXES],
    /// Memory of what is cut.
    spare: GridScratch,
}

/// Where an interval begins, σ, and the number of its piece.
pub(super) type GridCut = (f64, u32);

#[derive(Debug, Default)]
struct GridScratch {
    cuts: Vec<GridCut>,
    nodes: Vec<GridNode>,
    intervals: Vec<GridInterval>,
}

/// The limits of a run by which nodes and intervals are made.
struct LimitShares<'a> {
    run: &'a PathRun<'a>,
    acceleration: [f64; AXES],
    jerk: [f64; AXES],
}

impl LimitShares<'_> {
    fn new<'a>(run: &'a PathRun<'a>) -> LimitShares<'a> {
        let limits = run.limits();
        LimitShares { run, acceleration: limits.acceleration(), jerk: limits.jerk() }
    }

    fn of(row: &[f64; AXES], limits: &[f64; AXES]) -> [f64; AXES] {
        let mut shares = [0.0; AXES];
        for axis in 0..AXES {
            // Most axes are at rest, and divisions are slow.
            if row[axis] != 0.0 {
                shares[axis] = row[axis] / limits[axis];
            }
        }
        shares
    }

    /// A node, without what the piece before allows.
    fn node(&self, jet: &AxisJet, at: f64, cap: f64) -> GridNode {
        let by = |limits| [Self::of(&jet[1], limits), Self::of(&jet[2], limits)];
        let (by_acceleration, by_jerk) = (by(&self.acceleration), by(&self.jerk));
        GridNode { at, by_acceleration, by_jerk, cap: cap * cap, share: 1.0 }
    }

    fn interval(&self, at: f64, end: f64, piece: u32, third: [[f64; AXES]; 2]) -> GridInterval {
        let share = self.run.jerk_share(at, end);
        GridInterval { length: end - at, piece, third, share, most: share }
    }

    fn third(&self, jet: &AxisJet) -> [f64; AXES] {
        Self::of(&jet[3], &self.jerk)
    }
}

impl ProfileGrid {
    /// Builds the grid of a run; false when it would be too large.
    pub fn build(&mut self, run: &PathRun<'_>, ends: [RunEnding; 2], scale: f64) -> bool {
        self.scale = scale;
        let mut coarse = 1.0;
        while !self.build_coarse(run, ends, coarse) {
            coarse *= 2.0;
            if coarse > MAX_COARSENING {
                return false;
            }
        }
        self.intervals.len() >= 6
    }

    /// Builds a grid whose intervals take so many times as long as usual; false when it has too many.
    fn build_coarse(&mut self, run: &PathRun<'_>, ends: [RunEnding; 2], coarse: f64) -> bool {
        self.first_cuts(run, ends);
        self.fill(run, ends);
        // A run so short that it has one interval has no profile here, and is not built further.
        if self.intervals.len() < 2 {
            return true;
        }
        for _ in 0..MAX_CUTTING_PASSES {
            self.find_bound(ends);
            if !self.cut_long(run, ends, coarse) {
                return self.intervals.len() <= MAX_GRID_INTERVALS;
            }
            if self.cuts.len() > MAX_GRID_INTERVALS {
                return false;
            }
        }
        // What was cut last has its bound, too.
        self.find_bound(ends);
        self.intervals.len() <= MAX_GRID_INTERVALS
    }

    /// Where the intervals of the grid that was built last begin.
    pub fn cuts(&self) -> &[GridCut] {
        &self.cuts
    }

    /// Builds a grid again that had these intervals.
    pub fn rebuild(&mut self, run: &PathRun<'_>, ends: [RunEnding; 2], cuts: &[GridCut]) {
        self.cuts.clear();
        self.cuts.extend_from_slice(cuts);
        self.fill(run, ends);
        self.find_bound(ends);
    }

    /// Where pieces begin, and near rests as far as jerk takes the axes in even steps of time.
    fn first_cuts(&mut self, run: &PathRun<'_>, ends: [RunEnding; 2]) {
        self.cuts.clear();
        let length = run.length();
        for (index, piece) in run.pieces().iter().enumerate() {
            if piece.length > 0.0 {
                self.cuts.push((run.from(index), index as u32));
            }
        }
        let last = run.pieces().len() - 1;
        for (side, end) in ends.into_iter().enumerate() {
            if end != RunEnding::Rest {
                continue;
            }
            let index = if side == 0 { 0 } else { last };
            let jet = run.jet(index, if side == 0 { 0.0 } else { length });
            let jerk = (0..AXES).fold(f64::INFINITY, |jerk, axis| {
                let rate = jet[1][axis].abs();
                if rate > 0.0 { jerk.min(run.limits().jerk()[axis] / rate) } else { jerk }
            });
            if !jerk.is_finite() {
                continue;
            }
            let reserve = &run.ends()[side];
            let jerk = jerk * reserve.share;
            let by_speed = FIRST_RAMP_SHARE * (2.0 * run.speed_cap(index, &jet) / jerk).sqrt();
            let mut before = 0.0;
            let mut t = MAX_FIRST_INTERVAL_S.min(by_speed).min(0.3 * cbrt(length / jerk));
            let growth = 1.0 + INTERVAL_GROWTH * self.scale;
            if reserve.distance > 0.0 {
                // One of the intervals ends where more may be used.
                let until = cbrt(6.0 * reserve.distance / jerk);
                let mut last = until;
                while last > t {
                    last /= growth;
                }
                t = last;
            }
            for _ in 0..(f64::from(GROWING_INTERVALS) / self.scale) as u32 {
                let distance = jerk * t * t * t / 6.0;
                if distance > 0.25 * length {
                    break;
                }
                let at = if side == 0 { distance } else { length - distance };
                let piece = run.piece_at(at);
                let (begins, ends) =
                    (run.from(piece), run.from(piece) + run.pieces()[piece].length);
                if (at - begins).min(ends - at) > MIN_CUT_SPACING_SHARE * (distance - before) {
                    self.cuts.push((at, piece as u32));
                }
                before = distance;
                t *= growth;
            }
        }
        self.tidy(length);
    }

    /// In order, none twice.
    fn tidy(&mut self, length: f64) {
        self.cuts.sort_by(|a, b| a.0.total_cmp(&b.0));
        let near = 1e-12 * length;
        self.cuts.dedup_by(|next, before| {
            let same = next.0 - before.0 <= near;
            if same {
                before.1 = before.1.max(next.1);
            }
            same
        });
        self.cuts.retain(|(at, _)| *at < length - near);
    }

    /// The nodes and intervals between the cuts.
    fn fill(&mut self, run: &PathRun<'_>, ends: [RunEnding; 2]) {
        let shares = LimitShares::new(run);
        let velocity = run.limits().velocity();
        self.of_velocity = std::array::from_fn(|axis| shares.jerk[axis] / velocity[axis]);
        self.of_acceleration =
            std::array::from_fn(|axis| shares.jerk[axis] / shares.acceleration[axis]);
        self.nodes.clear();
        self.intervals.clear();
        self.moves = [false; AXES];
        let length = run.length();
        // The end of the interval before: its piece, how the axes move there, and the largest speed.
        let mut last: Option<(u32, AxisJet, f64)> = None;
        for (index, &(at, piece)) in self.cuts.iter().enumerate() {
            let end = self.cuts.get(index + 1).map_or(length, |next| next.0);
            let before = last.map_or(f64::INFINITY, |last| last.2);
            let (first, cap) = match last {
                Some((same, jet, cap)) if same == piece => (jet, cap),
                _ => {
                    let jet = run.jet(piece as usize, at);
                    (jet, run.speed_cap(piece as usize, &jet))
                }
            };
            let second = run.jet(piece as usize, end);
            let third = [&first, &second].map(|jet| shares.third(jet));
            self.nodes.push(shares.node(&first, at, cap.min(before)));
            self.intervals.push(shares.interval(at, end, piece, third));
            last = Some((piece, second, run.speed_cap(piece as usize, &second)));
        }
        if let Some((_, jet, cap)) = last {
            self.nodes.push(shares.node(&jet, length, cap));
        }
        self.nodes.iter().for_each(|node| see_moves(&mut self.moves, node));
        self.add_nothing(ends);
        self.list_axes();
    }

    fn list_axes(&mut self) {
        self.axes.clear();
        self.axes.extend((0..AXES).filter(|axis| self.moves[*axis]));
    }

    /// An interval of nothing before an end that is passed at speed, so that the profile is even there.
    fn add_nothing(&mut self, ends: [RunEnding; 2]) {
        if let (RunEnding::Even(_), Some(first)) = (ends[0], self.intervals.first().copied()) {
            let node = GridNode { at: -first.length, ..self.nodes[0] };
            self.nodes.insert(0, node);
            self.intervals.insert(0, GridInterval { third: [[0.0; AXES]; 2], ..first });
        }
        if let (RunEnding::Even(_), Some(last)) = (ends[1], self.intervals.last().copied()) {
            let end = self.nodes[self.nodes.len() - 1];
            self.nodes.push(GridNode { at: end.at + last.length, ..end });
            self.intervals.push(GridInterval { third: [[0.0; AXES]; 2], ..last });
        }
    }

    /// Cuts the intervals that take too long; false when there are none.
    fn cut_long(&mut self, run: &PathRun<'_>, ends: [RunEnding; 2], coarse: f64) -> bool {
        let begin = usize::from(ends[0] != RunEnding::Rest);
        let least_jerk = run.limits().jerk().into_iter().fold(f64::INFINITY, f64::min);
        let jerk = run.limits().jerk();
        let of = |row: &[f64; AXES]| {
            (0..AXES).fold(0.0_f64, |most, axis| most.max((row[axis] * jerk[axis]).abs()))
        };
        let count = self.cuts.len();
        let shares = LimitShares::new(run);
        let GridScratch { cuts, nodes, intervals } = &mut self.spare;
        cuts.clear();
        nodes.clear();
        intervals.clear();
        for index in 0..count {
            let node = self.nodes[begin + index];
            let interval = self.intervals[begin + index];
            let (at, piece) = self.cuts[index];
            // Next to a rest the intervals are as first cut.
            let at_rest = (index == 0 && ends[0] == RunEnding::Rest)
                || (index + 1 == count && ends[1] == RunEnding::Rest);
            let speed = self.bound[begin + index].sqrt();
            let of_ramp = RAMP_INTERVAL_SHARE * (speed / least_jerk).sqrt();
            let long_s = coarse * self.scale * of_ramp.clamp(MIN_RAMP_INTERVAL_S, MAX_INTERVAL_S);
            let mut parts =
                if at_rest || speed <= 0.0 { 1.0 } else { interval.length / (speed * long_s) };
            let third = interval.third.iter().map(of).fold(0.0, f64::max);
            parts = parts.max(interval.length * third.sqrt() / MAX_THIRD_ROOT);
            if run.pieces()[piece as usize].base.is_some() {
                let bend = of(&node.by_jerk[1]);
                parts = parts.max(interval.length * bend / MAX_INTERVAL_TURN_RAD);
            }
            let parts = (parts - 1e-9).ceil().clamp(1.0, MAX_PARTS_PER_CUT) as u32;
            cuts.push((at, piece));
            nodes.push(node);
            if parts == 1 {
                intervals.push(interval);
                continue;
            }
            let end = self.cuts.get(index + 1).map_or(run.length(), |next| next.0);
            let (mut from, mut third) = (at, interval.third[0]);
            for part in 1..parts {
                let share = f64::from(part) / f64::from(parts);
                let until = at + interval.length * share;
                let jet = run.jet(piece as usize, until);
                let next = shares.third(&jet);
                intervals.push(shares.interval(from, until, piece, [third, next]));
                cuts.push((until, piece));
                nodes.push(shares.node(&jet, until, run.speed_cap(piece as usize, &jet)));
                see_moves(&mut self.moves, &nodes[nodes.len() - 1]);
                (from, third) = (until, next);
            }
            intervals.push(shares.interval(from, end, piece, [third, interval.third[1]]));
        }
        if cuts.len() == count {
            return false;
        }
        nodes.push(self.nodes[begin + count]);
        std::mem::swap(&mut self.cuts, cuts);
        std::mem::swap(&mut self.nodes, nodes);
        std::mem::swap(&mut self.intervals, intervals);
        self.add_nothing(ends);
        self.list_axes();
        true
    }

    /// The largest coefficients without jerk along the path: two passes.
    fn find_bound(&mut self, ends: [RunEnding; 2]) {
        let count = self.intervals.len();
        self.bound.clear();
        let mut before = self.cap(0);
        for index in 0..count {
            let after = self.cap(index + 1);
            self.bound.push(before.min(after));
            before = after;
        }
        let last = count - 1;
        for (side, (at, next)) in [(0, 1), (last, last - 1)].into_iter().enumerate() {
            match ends[side] {
                RunEnding::Even(speed) => self.bound[at] = speed * speed,
                RunEnding::Rest => {
                    let factor = rest_factor(&self.intervals[at], &self.intervals[next]);
                    let (own, other) = (self.intervals[at].length, self.intervals[next].length);
                    let most = self.rest_cap(at, side) * (own + other);
                    self.bound[next] = self.bound[next].min(most / (factor * other + own));
                    self.bound[at] = factor * self.bound[next];
                }
            }
        }
        for node in (1..count).rev() {
            self.bound[node - 1] = self.most_next_to(node, true);
        }
        for node in 1..count {
            self.bound[node] = self.most_next_to(node, false);
        }
    }

    /// The largest σ̇² where an interval next to a rest ends, by the jerk on it.
    pub fn rest_cap(&self, interval: usize, side: usize) -> f64 {
        let h = self.intervals[interval].length;
        let (end, sign) = if side == 0 { (1, 1.0) } else { (0, -1.0) };
        let [first, second] = &self.nodes[interval + end].by_jerk;
        let most = self.axes.iter().fold(0.0_f64, |most, &axis| {
            let along = first[axis] * 2.0 / 9.0 / (h * h);
            let with =
                along + sign * second[axis] * 2.0 / h + self.intervals[interval].third[end][axis];
            most.max(with.abs()).max((along + self.intervals[interval].third[end][axis]).abs())
        });
        let speed = cbrt(self.intervals[interval].share / most);
        speed * speed
    }

    /// The largest σ̇² at a node whatever the change of speed.
    fn cap(&self, index: usize) -> f64 {
        let node = &self.nodes[index];
        let mut cap = node.cap;
        let [first, second] = &node.by_acceleration;
        for (place, &one) in self.axes.iter().enumerate() {
            // Two axes leave a change of speed for both only up to here.
            let (p, x) = (first[one].abs(), second[one] * first[one].signum());
            for &other in &self.axes[place + 1..] {
                let (q, y) = (first[other].abs(), second[other] * first[other].signum());
                let sum = (x * q - y * p).abs();
                if sum * cap > BOUND_ACCELERATION_SHARE * (p + q) {
                    cap = BOUND_ACCELERATION_SHARE * (p + q) / sum;
                }
            }
            if p < 1e-12 && second[one] != 0.0 {
                cap = cap.min(BOUND_ACCELERATION_SHARE / second[one].abs());
            }
        }
        let before = index.checked_sub(1).and_then(|interval| self.intervals.get(interval));
        let thirds = [
            before.map(|interval| &interval.third[1]),
            self.intervals.get(index).map(|c| &c.third[0]),
        ];
        for third in thirds.into_iter().flatten() {
            let third = self.axes.iter().fold(0.0_f64, |most, axis| most.max(third[*axis].abs()));
            // A root of the third degree takes long, and most are not needed.
            if third * cap * cap.sqrt() > BOUND_JERK_SHARE * (1.0 - PRODUCT_ROUNDING_SHARE) {
                let speed = cbrt(BOUND_JERK_SHARE / third);
                cap = cap.min(speed * speed);
            }
        }
        cap
    }

    /// The largest coefficient before or after a node with the one that is known on its other side.
    fn most_next_to(&self, node: usize, before: bool) -> f64 {
        let (left, right) = (&self.intervals[node - 1], &self.intervals[node]);
        let sum = left.length + right.length;
        // Of b at the node, the share of the unknown and of the known one.
        let (own, other) = if before { (right, left) } else { (left, right) };
        let (own, other) = (own.length / sum, other.length / sum);
        let sign = if before { -1.0 } else { 1.0 };
        let [open, known] = if before {
            [self.bound[node - 1], self.bound[node]]
        } else {
            [self.bound[node], self.bound[node - 1]]
        };
        let mut most = open;
        let mut hold = |slope: f64, level: f64, limit: f64| {
            // Most limits leave it as it is, and divisions are slow.
            let least = limit * (1.0 - PRODUCT_ROUNDING_SHARE);
            if slope > 1e-15 {
                if slope * open + level > least {
                    most = most.min((limit - level) / slope);
                }
            } else if slope < -1e-15 && slope * open + level < -least {
                most = most.min((-limit - level) / slope);
            }
        };
        let point = &self.nodes[node];
        let speed = (self.bound[node - 1].max(self.bound[node])).max(1e-12).sqrt();
        for &axis in &self.axes {
            let (q1, q2) = (point.by_acceleration[0][axis], point.by_acceleration[1][axis]);
            let slope = sign * q1 / sum + q2 * own;
            let level = (-sign * q1 / sum + q2 * other) * known;
            hold(slope, level, BOUND_ACCELERATION_SHARE);
            let bend = 3.0 * point.by_jerk[1][axis];
            if bend != 0.0 {
                for third in [left.third[1][axis], right.third[0][axis]] {
                    let slope = sign * bend / sum + third * own;
                    let level = (-sign * bend / sum + third * other) * known;
                    hold(slope, level, BOUND_TURNING_JERK_SHARE / speed);
                }
            }
        }
        most.max(0.0)
    }
}

/// Which axes move at a node as well.
fn see_moves(moves: &mut [bool; AXES], node: &GridNode) {
    let [first, second] = &node.by_acceleration;
    for axis in 0..AXES {
        moves[axis] |= first[axis] != 0.0 || second[axis] != 0.0;
    }
}

/// The coefficient of an interval next to a rest as a share of the next one: the jerk is even on it.
pub(super) fn rest_factor(at_rest: &GridInterval, next: &GridInterval) -> f64 {
    1.0 / (3.0 + 2.0 * next.length / at_rest.length)
}
