//! The law of small controls (GRBL): trapezoids of constant acceleration, no jerk, and at each junction of two
//! straight segments the speed that a detour of a given deviation would allow.
//!
//! Arcs are cut into the segments that the control runs, with their ends on the curve. The control knows so many
//! blocks ahead: the one under way ends no faster than the last known one can be stopped at.

use std::collections::VecDeque;

use chordal_geometry::{AXES, ParamCurve, Placement};

use crate::Axes;
use crate::limits::Limits;
use crate::piece::Piece;
use crate::segment::{Corner, Move};
use crate::smooth::span::PathPart;
use crate::trajectory::{Phase, Step, Stretch};

/// The numbers of such a law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JunctionLaw {
    /// How far a detour at a junction would be from it, mm; 0: every segment ends at rest (GRBL `$11`).
    pub deviation_mm: f64,
    /// Blocks that are known, with the one under way.
    pub blocks: usize,
    /// How far the segments of an arc are from it, mm (GRBL `$12`).
    pub arc_tolerance_mm: f64,
    /// Ends of segments lie on whole steps of X, Y and Z, so many a mm (GRBL `$100` to `$102`); 0: anywhere.
    pub steps_per_mm: [f64; 3],
}

/// Segments turn back where the cosine of the turn is less, and go straight on where it is more.
const TURNS_BACK: f64 = -0.999_999;
const STRAIGHT_ON: f64 = 0.999_999;
/// The least speed, mm/s: 1 mm/min.
const LEAST_SPEED: f64 = 1.0 / 60.0;
/// A stretch that reaches so many pieces ends where the speed is even.
const LONG: usize = 8192;
/// Most segments of one move.
const MOST_SEGMENTS: f64 = 1e7;

/// A straight segment that waits for its turn.
#[derive(Clone, Copy, Debug)]
struct Segment {
    from: Axes,
    /// The axes by σ.
    direction: Axes,
    length: f64,
    /// σ per s², the most that all axes hold.
    acceleration: f64,
    speed: f64,
    /// The square of the largest speed at its start, by the junction and both speeds.
    entry: f64,
    tag: u64,
}

/// The planner of the law.
#[derive(Debug)]
pub(crate) struct Junctions<P> {
    law: JunctionLaw,
    waiting: VecDeque<Segment>,
    /// The segment before the next one, where the axes do not rest between the two.
    last: Option<Segment>,
    /// Speed at which the first of those that wait begins.
    speed: f64,
    stretch: Stretch<P>,
    /// σ of the end of the stretch.
    end: f64,
}

impl<P: PathPart> Junctions<P> {
    pub fn new(law: JunctionLaw) -> Junctions<P> {
        Junctions {
            law,
            waiting: VecDeque::new(),
            last: None,
            speed: 0.0,
            stretch: Stretch::default(),
            end: 0.0,
        }
    }

    /// Takes a move that was checked, and emits what is certain.
    pub fn push(&mut self, motion: &Move, limits: &Limits, take: &mut impl FnMut(Step<'_, P>)) {
        let count = self.segments_of(motion);
        let length = motion.length() / count;
        let mut from = motion.from();
        let mut number = 1.0;
        while number <= count {
            let to = if number < count { motion.at(number / count) } else { motion.to() };
            self.add(from, to, length, motion, limits);
            while self.waiting.len() >= self.law.blocks.max(1) {
                self.run_first(take);
            }
            from = to;
            number += 1.0;
        }
        if motion.corner == Corner::Stop {
            self.rest(take);
        }
    }

    /// Everything that waits, to rest.
    pub fn rest(&mut self, take: &mut impl FnMut(Step<'_, P>)) {
        while !self.waiting.is_empty() {
            self.run_first(take);
        }
        self.emit(take);
        (self.last, self.speed) = (None, 0.0);
    }

    /// How many segments a move is cut into: vertices lie on the curve.
    fn segments_of(&self, motion: &Move) -> f64 {
        let chords = motion.curve.chord_count(self.law.arc_tolerance_mm, Placement::RoundedDown);
        chords.map_or(1.0, |count| (count as f64).min(MOST_SEGMENTS))
    }

    fn add(&mut self, from: Axes, to: Axes, length: f64, motion: &Move, limits: &Limits) {
        let [from, to] = [from, to].map(|place| self.on_steps(place));
        let away: Axes = std::array::from_fn(|axis| to[axis] - from[axis]);
        let linear = chord(&away[..3]);
        let length = if linear > 0.0 { linear } else { chord(&away[3..]).min(length) };
        // Less than a step is no motion.
        if length <= 0.0 {
            return;
        }
        let direction = away.map(|away| away / length);
        let speed = motion.speed.min(least(&limits.velocity(), &direction)).max(LEAST_SPEED);
        let acceleration = least(&limits.acceleration(), &direction);
        let mut next =
            Segment { from, direction, length, acceleration, speed, entry: 0.0, tag: motion.tag };
        if let Some(last) = &self.last {
            next.entry = self.junction(last, &next, limits);
        }
        self.last = Some(next);
        self.waiting.push_back(next);
    }

    /// The nearest place that motors can stand at.
    fn on_steps(&self, mut place: Axes) -> Axes {
        for (value, steps) in place.iter_mut().zip(self.law.steps_per_mm) {
            if steps > 0.0 {
                *value = (*value * steps).round() / steps;
            }
        }
        place
    }

    /// The square of the speed at the junction of two segments.
    fn junction(&self, before: &Segment, after: &Segment, limits: &Limits) -> f64 {
        let speed = before.speed.min(after.speed);
        let cosine: f64 = (0..AXES).map(|k| before.direction[k] * after.direction[k]).sum();
        if cosine > STRAIGHT_ON {
            return speed * speed;
        }
        if cosine < TURNS_BACK {
            return 0.0;
        }
        // The half of the angle between the two, and the direction in which the axes are accelerated there.
        let sine = ((1.0 + cosine) / 2.0).sqrt();
        let turn: Axes = std::array::from_fn(|k| after.direction[k] - before.direction[k]);
        let size = chord(&turn);
        let acceleration = least(&limits.acceleration(), &turn.map(|turn| turn / size));
        (acceleration * self.law.deviation_mm * sine / (1.0 - sine)).min(speed * speed)
    }

    /// The first segment as it runs with what is known: to the speed from which the last one can be stopped.
    fn run_first(&mut self, take: &mut impl FnMut(Step<'_, P>)) {
        let Some(first) = self.waiting.pop_front() else { return };
        let mut exit = 0.0;
        for segment in self.waiting.iter().rev() {
            exit = segment.entry.min(exit + 2.0 * segment.acceleration * segment.length);
        }
        let entry = self.speed * self.speed;
        let exit = exit.min(entry + 2.0 * first.acceleration * first.length);
        self.phases(&first, exit.sqrt());
        let mut start = [[0.0; AXES]; 4];
        (start[0], start[1]) = (first.from, first.direction);
        let piece = Piece { length: first.length, base: None, start, tag: first.tag };
        self.stretch.pieces.push(P::of(&piece));
        self.speed = exit.sqrt();
        let is_even = self.stretch.phases.last().is_some_and(|phase| phase.acceleration == 0.0);
        if self.stretch.pieces.len() >= LONG && is_even {
            self.emit(take);
        }
    }

    /// Faster, evenly, slower: as much of each as the segment has room for.
    fn phases(&mut self, segment: &Segment, exit: f64) {
        let Segment { length, acceleration, speed, .. } = *segment;
        let entry = self.speed;
        let top_square = (entry * entry + exit * exit) / 2.0 + acceleration * length;
        let top = top_square.sqrt().min(speed).max(entry.max(exit));
        let ramp = |from: f64, to: f64| (from * from - to * to).abs() / (2.0 * acceleration);
        let even = (length - ramp(entry, top) - ramp(top, exit)).max(0.0);
        self.phase((top - entry) / acceleration, entry, acceleration);
        self.phase(if top > 0.0 { even / top } else { 0.0 }, top, 0.0);
        self.phase((top - exit) / acceleration, top, -acceleration);
    }

    fn phase(&mut self, duration_s: f64, speed: f64, acceleration: f64) {
        if duration_s > 0.0 {
            let phase = Phase { duration_s, from: self.end, speed, acceleration, jerk: 0.0 };
            self.end += duration_s * (speed + duration_s * acceleration / 2.0);
            self.stretch.phases.push(phase);
        }
    }

    fn emit(&mut self, take: &mut impl FnMut(Step<'_, P>)) {
        if !self.stretch.pieces.is_empty() {
            take(Step::Stretch(&self.stretch));
        }
        self.stretch.pieces.clear();
        self.stretch.phases.clear();
        self.end = 0.0;
    }
}

fn chord(away: &[f64]) -> f64 {
    away.iter().map(|away| away * away).sum::<f64>().sqrt()
}

/// How much of limits by axis there is in a direction.
fn least(limits: &Axes, direction: &Axes) -> f64 {
    let moving = limits.iter().zip(direction).filter(|(_, share)| **share != 0.0);
    moving.fold(f64::INFINITY, |least, (limit, share)| least.min(limit / share.abs()))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use chordal_geometry::{Arc, Curve, Line, Plane, Vec3};

    use super::*;
    use crate::limits::AxisLimit;
    use crate::planner::{Level, Planner, PlannerOptions};
    use crate::segment::MoveKind;

    const LOOK_AHEAD: usize = 15;

    fn law(deviation_mm: f64, blocks: usize) -> JunctionLaw {
        JunctionLaw { deviation_mm, blocks, arc_tolerance_mm: 0.002, steps_per_mm: [0.0; 3] }
    }

    /// All axes alike: mm/min and mm/s².
    fn limits(velocity: f64, acceleration: f64) -> Limits {
        let axis = Some(AxisLimit { velocity: velocity / 60.0, acceleration, jerk: 1e9 });
        Limits::new([axis, axis, axis, None, None, None]).expect("positive limits")
    }

    fn cut(curve: Curve, feed: f64) -> Move {
        let corner = Corner::Within { linear_mm: 0.01, rotary_rad: 0.0 };
        let (rotary_from, rotary_to) = ([0.0; 3], [0.0; 3]);
        let speed = feed / 60.0;
        Move { curve, rotary_from, rotary_to, speed, corner, kind: MoveKind::Cut, tag: 1 }
    }

    /// Lines from place to place, mm, at a feed, mm/min.
    fn lines(places: &[[f64; 2]], feed: f64) -> Vec<Move> {
        let at = |[x, y]: [f64; 2]| Vec3::new(x, y, 0.0);
        let each = places
            .windows(2)
            .map(|pair| cut(Curve::Line(Line { start: at(pair[0]), end: at(pair[1]) }), feed));
        each.collect()
    }

    /// Equal lines along X.
    fn row(count: usize, length: f64, feed: f64) -> Vec<Move> {
        let places: Vec<[f64; 2]> = (0..=count).map(|k| [k as f64 * length, 0.0]).collect();
        lines(&places, feed)
    }

    fn circle(radius: f64, angle: f64) -> Vec<Move> {
        vec![cut(Arc::new(Plane::Xy.frame(), radius, angle, 0.0).into(), 3000.0)]
    }

    /// The stretches from rest to rest.
    fn planned(moves: &[Move], limits: Limits, law: JunctionLaw) -> Vec<Stretch> {
        let options = PlannerOptions { junctions: Some(law), ..PlannerOptions::new(Level::Fast) };
        let mut planner = Planner::new(limits, options);
        let mut stretches = Vec::new();
        let mut take = |step: Step<'_>| {
            if let Step::Stretch(stretch) = step {
                stretches.push(stretch.clone());
            }
        };
        for motion in moves {
            planner.push(motion, &mut take).expect("a move");
        }
        planner.finish(&mut take);
        stretches
    }

    fn time_s(moves: &[Move], limits: Limits, law: JunctionLaw) -> f64 {
        planned(moves, limits, law).iter().map(Stretch::duration_s).sum()
    }

    #[track_caller]
    fn takes(moves: &[Move], limits: Limits, law: JunctionLaw, expected_s: f64) {
        let found = time_s(moves, limits, law);
        let off = (found / expected_s - 1.0).abs();
        assert!(off < 1e-3, "{found} s for {expected_s} s: {off:.1e}");
    }

    /// Times that GRBL's own planner gave, on steps of 1/40 mm.
    #[test]
    fn times_are_those_of_the_firmware() {
        let router = limits(5000.0, 400.0);
        let steps_per_mm = [40.0; 3];
        let own = JunctionLaw { steps_per_mm, ..law(0.02, LOOK_AHEAD) };
        let far = JunctionLaw { blocks: 100, ..own };
        takes(&row(1, 100.0, 3000.0), router, own, 2.125);
        takes(&lines(&[[0.0, 0.0], [300.0, 100.0]], f64::INFINITY), router, own, 3.8083);
        let square = [[0.0, 0.0], [50.0, 0.0], [50.0, 50.0], [0.0, 50.0], [0.0, 0.0]];
        takes(&lines(&square, 3000.0), router, own, 4.4257);
        takes(&circle(20.0, TAU), router, own, 2.6386);
        takes(&circle(20.0, TAU), router, far, 2.6386);
        takes(&circle(2.0, TAU), router, own, 0.3815);
        takes(&circle(2.0, TAU), router, far, 0.3789);
        takes(&row(100, 1.0, 3000.0), router, own, 2.125);
        takes(&row(1000, 0.1, 3000.0), router, own, 3.0463);
        takes(&row(1000, 0.1, 1000.0), router, own, 6.0417);
        takes(&row(1000, 0.1, 3000.0), router, far, 2.125);
        // The standard build.
        let small = limits(500.0, 10.0);
        let own = JunctionLaw { steps_per_mm: [250.0; 3], ..law(0.01, LOOK_AHEAD) };
        takes(&row(1, 100.0, 3000.0), small, own, 12.8333);
        takes(&lines(&square, 3000.0), small, own, 26.995);
        takes(&circle(20.0, TAU), small, own, 14.4318);
    }

    /// Two lines of 20 mm with a corner: entry and exit by hand.
    #[test]
    fn a_corner_is_passed_at_the_speed_of_its_detour() {
        let router = limits(60_000.0, 400.0);
        for degrees in [1.0_f64, 30.0, 90.0, 150.0, 179.0] {
            let (sine, cosine) = degrees.to_radians().sin_cos();
            let bend = [[0.0, 0.0], [20.0, 0.0], [20.0 + 20.0 * cosine, 20.0 * sine]];
            let half = (degrees.to_radians() / 2.0).cos();
            // The axes along the turn: the one that changes more has all of its acceleration.
            let turn = [cosine - 1.0, sine];
            let size = turn[0].hypot(turn[1]);
            let most = (size / turn[0].abs()).min(size / turn[1].abs());
            let junction = (400.0 * most * 0.02 * half / (1.0 - half)).sqrt();
            // On one line speed would reach that of half the way, and on the second its own acceleration counts.
            let second = 400.0 * (1.0 / cosine.abs()).min(1.0 / sine.abs());
            let at_corner =
                junction.min((2.0 * 400.0 * 20.0_f64).sqrt()).min(second.sqrt() * 40.0_f64.sqrt());
            let leg = |acceleration: f64| {
                let top = (at_corner * at_corner / 2.0 + acceleration * 20.0).sqrt();
                (top + (top - at_corner)) / acceleration
            };
            let expected = leg(400.0) + leg(second);
            let found = time_s(&lines(&bend, f64::INFINITY), router, law(0.02, LOOK_AHEAD));
            assert!((found - expected).abs() < 1e-9, "{degrees}: {found} for {expected}");
        }
    }

    /// No axis is faster or accelerated more than it can; speeds meet at every phase, and the way is whole.
    #[test]
    fn limits_hold_and_speeds_meet() {
        let axes = [(3000.0, 200.0), (5000.0, 400.0), (600.0, 50.0)].map(|(v, acceleration)| {
            Some(AxisLimit { velocity: v / 60.0, acceleration, jerk: 1e9 })
        });
        let limits = Limits::new([axes[0], axes[1], axes[2], None, None, None]).expect("limits");
        let mut seed = 1_u64;
        let mut random = || {
            seed ^= seed << 13;
            seed ^= seed >> 7;
            seed ^= seed << 17;
            (seed >> 11) as f64 / (1_u64 << 53) as f64
        };
        for round in 0..100 {
            let mut at = Vec3::new(0.0, 0.0, 0.0);
            let mut moves = Vec::new();
            for _ in 0..60 {
                let size = 10f64.powf(-2.0 + 3.0 * random());
                let mut away = || size * (random() - 0.5);
                let end = Vec3::new(at.x + away(), at.y + away(), at.z + away());
                let feed = [300.0, 2000.0, f64::INFINITY][(random() * 3.0) as usize];
                moves.push(cut(Curve::Line(Line { start: at, end }), feed));
                at = end;
            }
            let own = law(0.01, [1, 15, 100][round % 3]);
            for stretch in planned(&moves, limits, own) {
                let (mut speed, mut from, mut piece, mut begin) = (0.0, 0.0, 0, 0.0);
                for phase in &stretch.phases {
                    assert!((phase.speed - speed).abs() < 1e-9 && (phase.from - from).abs() < 1e-9);
                    let end = phase.at(phase.duration_s);
                    (speed, from) = (end.speed, end.sigma);
                    let middle = phase.at(phase.duration_s / 2.0).sigma;
                    while begin + stretch.pieces[piece].length < middle {
                        begin += stretch.pieces[piece].length;
                        piece += 1;
                    }
                    for (axis, limit) in axes.iter().enumerate() {
                        let share = stretch.pieces[piece].start[1][axis].abs();
                        let limit = limit.expect("an axis");
                        assert!(share * phase.speed.max(speed) <= limit.velocity * (1.0 + 1e-12));
                        let used = share * phase.acceleration.abs();
                        assert!(used <= limit.acceleration * (1.0 + 1e-12), "{used}");
                    }
                }
                assert!(speed.abs() < 1e-9);
                let length: f64 = stretch.pieces.iter().map(|piece| piece.length).sum();
                assert!((from - length).abs() < 1e-9 * length.max(1.0), "{from} of {length}");
            }
        }
    }

    #[test]
    fn a_line_cut_in_two_takes_as_long() {
        let router = limits(5000.0, 400.0);
        let whole = time_s(&row(4, 25.0, 3000.0), router, law(0.02, 100));
        let halves = time_s(&row(8, 12.5, 3000.0), router, law(0.02, 100));
        assert!((whole - halves).abs() < 1e-9, "{whole} and {halves}");
    }

    #[test]
    fn without_deviation_every_segment_ends_at_rest() {
        let router = limits(5000.0, 400.0);
        let square = [[0.0, 0.0], [50.0, 0.0], [50.0, 50.0]];
        let one = time_s(&row(1, 50.0, 3000.0), router, law(0.0, LOOK_AHEAD));
        let two = time_s(&lines(&square, 3000.0), router, law(0.0, LOOK_AHEAD));
        assert!((two - 2.0 * one).abs() < 1e-9);
    }

    #[test]
    fn segments_of_an_arc_are_those_of_the_firmware() {
        let law = law(0.01, LOOK_AHEAD);
        let planner: Junctions<Piece> = Junctions::new(law);
        // Radius 1, half and full turn, radius 10 and half of 1,000.
        for (radius, angle, count) in [(1.0, PI, 24.0), (1.0, TAU, 49.0), (1000.0, PI, 785.0)] {
            let arc = cut(Arc::new(Plane::Xy.frame(), radius, angle, 0.0).into(), 100.0);
            assert_eq!(planner.segments_of(&arc), count);
        }
    }
}
