//! Where a run goes at one speed, with nothing to solve.
//!
//! Where the largest speed is the same for so long that both its ends are reached from any speed, and this
//! speed asks little of the axes, the profile is even in the middle. Only what lies around such cruises has intervals.

use std::ops::Range;

use chordal_geometry::{AXES, ParamCurve};

use crate::piece::{AxisJet, PathPiece, ahead};
use crate::time_bound::PathRun;

/// Speeds whose squares differ by no larger share are passed at the lowest of them.
const EQUAL_SQUARE_SHARE: f64 = 1e-3;
/// An even speed may use no more of acceleration and jerk on all of a cruise. What is used at most is used at
/// few places, and left for ramps elsewhere: with half of it 329 paths took as long to 1e-6 in all, one of
/// them by 1.3e-4 less, and bends of a feed near its limit were solved where nothing is to be found.
const MAX_CRUISE_USE: f64 = 0.9;
/// A cruise is reached and left within so many times the distance on which the axes stop from it, if they have
/// nothing else to do. On a surface with
/// corners 3 times makes the profile quicker by 1e-5, and 1.2 times slower by 1.4e-4.
const REACH_STOP_DISTANCES: f64 = 2.0;
/// A cruise is at least as long as this share of the distance to it: a shorter one saves too little.
const MIN_CRUISE_SHARE: f64 = 0.5;
/// Pieces with a curve below are looked at where it has turned by so much, rad, and at most so often.
const PROBE_TURN_RAD: f64 = 0.04;
const MAX_PROBES: f64 = 1000.0;

/// A part of a run that is passed at one speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CruisePart {
    /// σ where it begins and ends.
    pub from: f64,
    pub to: f64,
    /// σ̇.
    pub speed: f64,
}

/// What a part of a run allows and asks for at an even speed.
#[derive(Clone, Copy, Debug)]
struct CruiseConditions {
    /// The largest σ̇² by feed and velocities.
    square: f64,
    /// Largest σ̇² and σ̇³ with which bends leave enough of accelerations and jerks.
    by_bend: f64,
    by_third: f64,
    /// The second and the third derivative by time that the axes can do along the path.
    acceleration: f64,
    jerk: f64,
}

impl CruiseConditions {
    fn of(run: &PathRun<'_>, index: usize, per: &[[f64; AXES]; 3]) -> CruiseConditions {
        let [rates, bends, thirds] = largest(&run.pieces()[index]);
        let [by_velocity, by_acceleration, by_jerk] = per;
        let most = |values: &[f64; AXES], per: &[f64; AXES]| {
            values.iter().zip(per).fold(0.0_f64, |most, (value, per)| most.max(value * per))
        };
        let speed = run.feed(index).min(1.0 / most(&rates, by_velocity));
        CruiseConditions {
            square: speed * speed,
            by_bend: MAX_CRUISE_USE / most(&bends, by_acceleration),
            by_third: MAX_CRUISE_USE / most(&thirds, by_jerk),
            acceleration: 1.0 / most(&rates, by_acceleration),
            jerk: 1.0 / most(&rates, by_jerk),
        }
    }

    fn and(self, other: CruiseConditions) -> CruiseConditions {
        CruiseConditions {
            square: self.square.min(other.square),
            by_bend: self.by_bend.min(other.by_bend),
            by_third: self.by_third.min(other.by_third),
            acceleration: self.acceleration.min(other.acceleration),
            jerk: self.jerk.min(other.jerk),
        }
    }

    /// Whether the largest speed asks little of the axes.
    fn is_calm(&self) -> bool {
        self.square <= self.by_bend && self.square * self.square.sqrt() <= self.by_third
    }

    /// The distance on which the axes stop from the largest speed, if they have nothing else to do.
    fn stop_distance(&self) -> f64 {
        let (v, a, j) = (self.square.sqrt(), self.acceleration, self.jerk);
        let stop_s = if v * j > a * a { v / a + a / j } else { 2.0 * (v / j).sqrt() };
        0.5 * v * stop_s
    }

    /// The cruise in the middle of a part of which this is known.
    fn within(&self, part: Range<f64>) -> Option<CruisePart> {
        let reach = REACH_STOP_DISTANCES * self.stop_distance();
        let (from, to) = (part.start + reach, part.end - reach);
        (to - from > MIN_CRUISE_SHARE * reach).then_some(CruisePart {
            from,
            to,
            speed: self.square.sqrt(),
        })
    }
}

/// The cruises of a run, in order.
pub(super) fn find(run: &PathRun<'_>, cruises: &mut Vec<CruisePart>) {
    cruises.clear();
    let limits = run.limits();
    let per = [limits.velocity(), limits.acceleration(), limits.jerk()]
        .map(|limits| limits.map(|limit| 1.0 / limit));
    // Where the part begins that allows one speed, the speed there, and what is known of the part.
    let mut open: Option<(usize, f64, CruiseConditions)> = None;
    for index in 0..run.pieces().len() {
        let here = CruiseConditions::of(run, index, &per);
        if let Some((begin, first, all)) = &mut open {
            if here.is_calm() && (here.square - *first).abs() <= EQUAL_SQUARE_SHARE * *first {
                *all = all.and(here);
                continue;
            }
            cruises.extend(all.within(run.from(*begin)..run.from(index)));
        }
        open = here.is_calm().then_some((index, here.square, here));
    }
    if let Some((begin, _, all)) = open {
        cruises.extend(all.within(run.from(begin)..run.length()));
    }
}

/// The pieces of a run between two places.
pub(super) fn cut(
    run: &PathRun<'_>,
    part: Range<f64>,
    pieces: &mut Vec<PathPiece>,
    speeds: &mut Vec<f64>,
) {
    pieces.clear();
    speeds.clear();
    let first = run.piece_at(part.start);
    for index in first..run.pieces().len() {
        let from = run.from(index);
        if from >= part.end {
            break;
        }
        let piece = &run.pieces()[index];
        let done = (part.start - from).max(0.0);
        let length = piece.length.min(part.end - from) - done;
        if length > 0.0 {
            pieces.push(PathPiece {
                length,
                base: piece.base.map(|(curve, at)| (curve, at + done)),
                start: if done > 0.0 { ahead(&piece.start, done, AXES) } else { piece.start },
                tag: piece.tag,
            });
            speeds.push(run.feed(index));
        }
    }
}

/// No smaller than the sizes of the first three derivatives of each axis on a piece.
fn largest(piece: &PathPiece) -> [[f64; AXES]; 3] {
    let mut most = [[0.0_f64; AXES]; 3];
    let mut take = |row: usize, values: &[f64; AXES]| {
        for (most, value) in most[row].iter_mut().zip(values) {
            *most = most.max(value.abs());
        }
    };
    let Some((curve, _)) = &piece.base else {
        let [_, first, second, third] = &piece.start;
        let h = piece.length;
        take(0, first);
        take(1, second);
        take(2, third);
        let last_bend: [f64; AXES] = std::array::from_fn(|axis| second[axis] + h * third[axis]);
        take(1, &last_bend);
        // A parabola lies within the triangle of these.
        let middle: [f64; AXES] = std::array::from_fn(|axis| first[axis] + 0.5 * h * second[axis]);
        take(0, &middle);
        take(0, &std::array::from_fn(|axis| middle[axis] + 0.5 * h * last_bend[axis]));
        return most;
    };
    let turn = piece.length * curve.max_curvature();
    let count = (turn / PROBE_TURN_RAD).ceil().max(1.0);
    if count.is_nan() || count > MAX_PROBES {
        return [[f64::INFINITY; AXES]; 3];
    }
    for probe in 0..=count as u32 {
        let jet: AxisJet = piece.at(piece.length * f64::from(probe) / count);
        for (row, values) in jet[1..].iter().enumerate() {
            take(row, values);
        }
    }
    most
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::limit_use::largest_use;
    use crate::limits::{AxisLimit, KinematicLimits};
    use crate::profile_solver::{ProfileSolver, RunEnding};
    use crate::trajectory::{JerkPhase, PlannedTrajectory};

    const FEED_MM_S: f64 = 50.0;

    fn limits() -> KinematicLimits {
        let axis = Some(AxisLimit { velocity: 400.0, acceleration: 3000.0, jerk: 1e5 });
        KinematicLimits::new([axis, axis, axis, None, None, None]).expect("good limits")
    }

    /// Pieces of half a millimetre along x, with y a wave that bends by a tenth per mm at most.
    fn wave(count: u32) -> Vec<PathPiece> {
        const WAVE_NUMBER: f64 = 0.2;
        const MAX_BEND: f64 = 0.1;
        const PIECE_MM: f64 = 0.5;
        let piece = |index: u32| {
            let x = PIECE_MM * f64::from(index);
            let (sin, cos) = libm::sincos(WAVE_NUMBER * x);
            let next = libm::sin(WAVE_NUMBER * (x + PIECE_MM));
            let y = [
                MAX_BEND * sin / (WAVE_NUMBER * WAVE_NUMBER),
                MAX_BEND * cos / WAVE_NUMBER,
                -MAX_BEND * sin,
                // The second derivative goes on evenly to that of the next piece.
                -MAX_BEND * (next - sin) / PIECE_MM,
            ];
            let mut start = y.map(|y| [0.0, y, 0.0, 0.0, 0.0, 0.0]);
            (start[0][0], start[1][0]) = (x, 1.0);
            PathPiece { length: PIECE_MM, base: None, start, tag: u64::from(index) }
        };
        (0..count).map(piece).collect()
    }

    fn time_s(phases: &[JerkPhase]) -> f64 {
        phases.iter().map(|phase| phase.duration_s).sum()
    }

    /// Place, speed and acceleration go on from phase to phase.
    fn goes_on(phases: &[JerkPhase], length: f64) {
        for pair in phases.windows(2) {
            let end = pair[0].at(pair[0].duration_s);
            assert!((end.sigma - pair[1].from).abs() < 1e-9, "{pair:?}");
            assert!((end.speed - pair[1].speed).abs() < 1e-6, "{pair:?}");
            assert!((end.acceleration - pair[1].acceleration).abs() < 1e-3, "{pair:?}");
        }
        let last = phases[phases.len() - 1];
        assert!((last.at(last.duration_s).sigma - length).abs() < 1e-9);
    }

    #[test]
    fn a_long_cruise_has_few_intervals() {
        let (pieces, limits) = (wave(4000), limits());
        let speeds = vec![FEED_MM_S; pieces.len()];
        let run = PathRun::new(&pieces, &speeds, 0.0, &limits).expect("a run");
        let mut planner = ProfileSolver::default();
        let phases = planner.plan(&run, [RunEnding::Rest; 2], 2e-4).expect("a law");
        assert_eq!(planner.cruises.len(), 1);
        assert!(planner.work.intervals < 100, "{:?}", planner.work);
        goes_on(&phases, run.length());
        // The same with nothing left out.
        let whole = planner.plan_part(&run, [RunEnding::Rest; 2], 2e-4).expect("a law");
        assert!(planner.work.intervals > 8000, "{:?}", planner.work);
        let (with, without) = (time_s(&phases), time_s(&whole.phases));
        assert!(with < without * (1.0 + 1e-9), "{with} {without}");
        assert!(with > without * (1.0 - 1e-3), "{with} {without}");
        let trajectory = PlannedTrajectory { pieces, phases, overlap_s: 0.0 };
        let used = largest_use(&trajectory, &limits, 4);
        assert!(used.time_scale() < 1.0 + 1e-3, "{used:?}");
    }

    #[test]
    fn every_feed_has_its_cruise_and_sharp_bends_have_none() {
        // A bend of 1.15 per mm asks for more than nine tenths of the acceleration.
        let mut pieces = wave(1000);
        let (limits, mut speeds) = (limits(), vec![FEED_MM_S; 1000]);
        speeds[400..600].fill(2.0 * FEED_MM_S);
        pieces[800..805].iter_mut().for_each(|piece| piece.start[2][1] = 1.15);
        let run = PathRun::new(&pieces, &speeds, 0.0, &limits).expect("a run");
        let mut cruises = Vec::new();
        find(&run, &mut cruises);
        let solved: Vec<_> = cruises.iter().map(|c| (c.speed, c.from, c.to)).collect();
        let pieces_of = |at: f64| at / 0.5;
        assert_eq!(solved.len(), 4, "{solved:?}");
        for ((speed, from, to), (expected, range)) in solved.into_iter().zip([
            (FEED_MM_S, 0.0..400.0),
            (2.0 * FEED_MM_S, 400.0..600.0),
            (FEED_MM_S, 600.0..800.0),
            (FEED_MM_S, 805.0..1000.0),
        ]) {
            assert_eq!(speed, expected);
            assert!(pieces_of(from) > range.start && pieces_of(to) < range.end);
            // To rest from the feed with 1e5 mm/s³ and 3000 mm/s² it is 1.2 mm, twice as fast 3.3 mm.
            let reach = if speed < 1.5 * FEED_MM_S { 1.2 } else { 3.3 };
            assert!(pieces_of(from) < range.start + 2.0 * 2.2 * reach, "{from}");
            assert!(pieces_of(to) > range.end - 2.0 * 2.2 * reach, "{to}");
        }
    }

    #[test]
    fn the_path_between_two_cruises_is_the_same_path() {
        let (pieces, limits) = (wave(100), limits());
        let speeds: Vec<f64> = (1..=100).map(f64::from).collect();
        let run = PathRun::new(&pieces, &speeds, 0.0, &limits).expect("a run");
        let (mut part, mut of_part) = (Vec::new(), Vec::new());
        for (from, to) in [(0.0, 50.0), (0.3, 0.4), (12.5, 20.0), (12.7, 31.1)] {
            cut(&run, from..to, &mut part, &mut of_part);
            let length: f64 = part.iter().map(|piece| piece.length).sum();
            assert!((length - (to - from)).abs() < 1e-12);
            assert_eq!(of_part.len(), part.len());
            let mut at = from;
            for (piece, speed) in part.iter().zip(&of_part) {
                let index = run.piece_at(at + 1e-9);
                assert_eq!(*speed, speeds[index]);
                for offset in [0.0, piece.length] {
                    let [there, here] = [run.jet(index, at + offset), piece.at(offset)];
                    for (there, here) in there.iter().flatten().zip(here.iter().flatten()) {
                        assert!((there - here).abs() < 1e-12, "{at} {offset}: {there} {here}");
                    }
                }
                at += piece.length;
            }
        }
    }

    #[test]
    fn a_cruise_that_cannot_be_reached_is_none() {
        let (pieces, limits) = (wave(1000), limits());
        let speeds = vec![FEED_MM_S; pieces.len()];
        let run = PathRun::new(&pieces, &speeds, 0.0, &limits).expect("a run");
        let cruise = |from, to| CruisePart { from, to, speed: FEED_MM_S };
        for (cruises, left) in [
            // Too near to the start, to the end, to each other.
            (vec![cruise(0.5, 400.0), cruise(420.0, 450.0)], vec![cruise(420.0, 450.0)]),
            (vec![cruise(100.0, 400.0), cruise(450.0, 499.5)], vec![cruise(100.0, 400.0)]),
            (vec![cruise(100.0, 400.0), cruise(400.3, 450.0)], vec![]),
        ] {
            let mut planner = ProfileSolver { cruises, ..ProfileSolver::default() };
            let mut parts = Vec::new();
            planner.plan_parts(&run, [RunEnding::Rest; 2], 2e-4, &mut parts).expect("a law");
            assert_eq!(planner.cruises, left);
            goes_on(&planner.join(&mut parts), run.length());
        }
    }
}
