//! Traverses both runs along their alignment and measures the distance and the differences of corresponding steps.

use std::collections::HashSet;
use std::ops::Range;

use chordal::geometry::{Curve, ParamCurve, Placement, Vec3};

use crate::align::{AlignedRegion, StepAlignment};
use crate::bound::{CurveRange, bound};
use crate::category::Category;
use crate::couple::{PathCoupling, couple, most, move_by_move};
use crate::course::{ComparedMove, ComparedRun, RunStep};
use crate::difference::{BlockLocation, Difference, in_order};
use crate::frechet::{MAX_CELLS, frechet};
use crate::steps::{DifferenceCollector, lacking};
use crate::{COINCIDENT_MM, ComparisonOptions};

/// What the traversal has found.
#[derive(Debug, Default)]
pub(crate) struct ComparisonFindings {
    pub(crate) differences: Vec<Difference>,
    pub(crate) max_distance_mm: Option<f64>,
    pub(crate) farthest: Option<[BlockLocation; 2]>,
    pub(crate) farthest_at_mm: Option<[[f64; 3]; 2]>,
}

impl ComparisonFindings {
    fn distance(
        &mut self,
        distance_mm: f64,
        at: [BlockLocation; 2],
        spot: impl FnOnce() -> [Vec3; 2],
    ) {
        if self.max_distance_mm.is_none_or(|most| distance_mm > most || distance_mm.is_nan()) {
            self.max_distance_mm = Some(distance_mm);
            let is_separate = distance_mm > COINCIDENT_MM;
            self.farthest = is_separate.then_some(at);
            self.farthest_at_mm = is_separate.then(|| spot().map(Vec3::to_array));
        }
    }
}

pub(crate) struct AlignmentWalker<'a> {
    courses: [&'a ComparedRun; 2],
    options: &'a ComparisonOptions,
    steps: DifferenceCollector<'a>,
    found: ComparisonFindings,
    /// The current sequence of moves that are too far apart, not yet complete.
    open: Option<Difference>,
    /// Moves that the other run makes at another time, per run.
    at_other_time: [HashSet<usize>; 2],
}

impl<'a> AlignmentWalker<'a> {
    pub(crate) fn new(
        a: &'a ComparedRun,
        b: &'a ComparedRun,
        options: &'a ComparisonOptions,
    ) -> AlignmentWalker<'a> {
        let steps = DifferenceCollector::new([a, b], options);
        let found = ComparisonFindings::default();
        let outside = Default::default();
        AlignmentWalker {
            courses: [a, b],
            options,
            steps,
            found,
            open: None,
            at_other_time: outside,
        }
    }

    /// Traverses all regions.
    pub(crate) fn along(&mut self, alignment: &StepAlignment) {
        for moved in &alignment.moved {
            self.moved(moved);
        }
        for region in &alignment.regions {
            match region {
                AlignedRegion::Matched(a, b) => {
                    for (a, b) in a.clone().zip(b.clone()) {
                        self.matched(a, b);
                    }
                }
                AlignedRegion::Rapid(a, b) => self.rapid([a.clone(), b.clone()]),
                AlignedRegion::Gap(a, b) => self.gap([a.clone(), b.clone()]),
            }
        }
    }

    /// Compares moves that both runs make at different times, and reports them as a difference of order.
    fn moved(&mut self, moves: &[Vec<usize>; 2]) {
        let nowhere = [0..0, 0..0];
        let steps = moves.each_ref().map(Vec::as_slice);
        self.found.differences.push(lacking(self.courses, &nowhere, steps, Category::Order));
        for (a, b) in moves[0].iter().zip(&moves[1]) {
            self.matched(*a, *b);
        }
        self.close();
        for (outside, moves) in self.at_other_time.iter_mut().zip(moves) {
            outside.extend(moves);
        }
    }

    /// Completes the traversal; returns the findings in order.
    pub(crate) fn finish(mut self) -> ComparisonFindings {
        self.close();
        self.found.differences.append(&mut self.steps.finish());
        in_order(&mut self.found.differences);
        self.found
    }

    fn matched(&mut self, a: usize, b: usize) {
        let [course_a, course_b] = self.courses;
        match (&course_a.steps[a], &course_b.steps[b]) {
            (RunStep::Move(one), RunStep::Move(other)) => {
                if one.known && other.known {
                    let whole =
                        |moved: &'a ComparedMove| CurveRange::whole(&moved.curve, moved.length_mm);
                    let separate_mm = bound(whole(one), whole(other), self.precision());
                    self.pair(&PathCoupling::whole([a, b], separate_mm));
                } else {
                    self.steps.moves(one, other);
                }
            }
            (RunStep::Event { .. }, RunStep::Event { .. }) => self.steps.events([a, b]),
            _ => {}
        }
    }

    /// Compares a rapid of both runs. Between the same end points, a different dog-leg is not a difference of path.
    fn rapid(&mut self, ranges: [Range<usize>; 2]) {
        let moves = [0, 1].map(|side: usize| {
            let course = self.courses[side];
            ranges[side].clone().filter_map(|at| course.moved(at)).collect::<Vec<&ComparedMove>>()
        });
        let [(Some(a), Some(a_end)), (Some(b), Some(b_end))] =
            moves.each_ref().map(|moves| (moves.first(), moves.last()))
        else {
            return;
        };
        let curves = moves
            .each_ref()
            .map(|moves| moves.iter().map(|moved| &moved.curve).collect::<Vec<&Curve>>());
        let starts = [a.curve.start(), b.curve.start()];
        let mut couples =
            couple(&curves[0], &curves[1], starts, self.precision(), self.options.tolerance_mm);
        let ends = (a_end.curve.end() - b_end.curve.end()).length();
        let between = (starts[0] - starts[1]).length().max(ends);
        if most(&couples) > self.threshold() && between <= self.threshold() {
            self.steps.moves(a, b);
            self.steps.bend(a, b);
            let spots = [starts, [a_end.curve.end(), b_end.curve.end()]];
            let at = [a, b].map(|moved| BlockLocation::from(&moved.origin));
            self.found.distance(between, at, || widest(spots, between));
            return;
        }
        for couple in &mut couples {
            couple.moves = [0, 1].map(|side| ranges[side].start + couple.moves[side]);
            self.pair(couple);
        }
    }

    /// The precision of bounds, mm: at most a hundredth of the tolerance.
    fn precision(&self) -> f64 {
        let tolerance = self.options.tolerance_mm;
        if tolerance > 0.0 {
            self.options.precision_mm.min(tolerance / 100.0)
        } else {
            self.options.precision_mm
        }
    }

    /// Compares two moves, or parts of them, that are traversed together.
    fn pair(&mut self, couple: &PathCoupling) {
        let [a, b] = couple.moves;
        let (Some(one), Some(other)) = (self.courses[0].moved(a), self.courses[1].moved(b)) else {
            return;
        };
        // When one move ends slightly before the other, its next move is paired with the short rest of the other,
        // whose state must not be compared with it.
        let walked = |moved: &ComparedMove, [from, to]: [f64; 2]| moved.length_mm * (to - from);
        let is_whole = couple.is_whole();
        let [of_one, of_other] = couple.parts;
        if is_whole || walked(one, of_one).max(walked(other, of_other)) > self.threshold() {
            self.steps.moves(one, other);
        }
        self.steps.rotary([one, other], couple.parts);
        let at = [BlockLocation::from(&one.origin), BlockLocation::from(&other.origin)];
        let spot = || widest(spots([one, other], couple.parts), couple.max_distance_mm);
        self.found.distance(couple.max_distance_mm, at, spot);
        // NaN counts as too far.
        if couple.max_distance_mm <= self.threshold() {
            self.close();
            return;
        }
        let shift = couple.is_whole().then(|| shift(&one.curve, &other.curve)).flatten();
        self.extend(at, couple.max_distance_mm, spot, shift);
    }

    /// Starts or extends the current sequence of moves that are too far apart.
    fn extend(
        &mut self,
        at: [BlockLocation; 2],
        distance_mm: f64,
        spot: impl FnOnce() -> [Vec3; 2],
        shift: Option<[f64; 3]>,
    ) {
        match &mut self.open {
            Some(open) => {
                open.extend(at);
                if open.distance_mm.is_some_and(|most| distance_mm > most) {
                    open.distance_mm = Some(distance_mm);
                    open.at_mm = Some(spot().map(Vec3::to_array));
                }
                let is_same = open.shift_mm.zip(shift).is_some_and(|(a, b)| is_near(a, b));
                open.shift_mm = open.shift_mm.filter(|_| is_same);
            }
            None => {
                let path = Difference::at(Category::Path, at, None);
                let (distance_mm, at_mm) = (Some(distance_mm), Some(spot().map(Vec3::to_array)));
                self.open = Some(Difference { distance_mm, at_mm, shift_mm: shift, ..path });
            }
        }
    }

    fn close(&mut self) {
        self.found.differences.extend(self.open.take());
    }

    fn gap(&mut self, ranges: [Range<usize>; 2]) {
        let moves = |side: usize, known: bool| -> Vec<usize> {
            let is_meant = |at: &usize| {
                let moved = self.courses[side].moved(*at);
                moved.is_some_and(|moved| moved.known == known)
                    && !self.at_other_time[side].contains(at)
            };
            ranges[side].clone().filter(is_meant).collect()
        };
        let (known, unknown) =
            ([0, 1].map(|side| moves(side, true)), [0, 1].map(|side| moves(side, false)));
        self.steps.gap_events(&ranges);
        for (one, other) in unknown[0].iter().zip(&unknown[1]) {
            let moved = |side: usize, at: &usize| self.courses[side].moved(*at);
            if let (Some(one), Some(other)) = (moved(0, one), moved(1, other)) {
                self.steps.moves(one, other);
            }
        }
        if unknown[0].len() != unknown[1].len() {
            let common = unknown[0].len().min(unknown[1].len());
            let rest = [0, 1].map(|side| &unknown[side][common..]);
            self.found.differences.push(lacking(self.courses, &ranges, rest, Category::Unknown));
        }
        if known.iter().any(|moves| !moves.is_empty()) {
            self.paths(&ranges, &known);
        }
    }

    /// Traverses the moves of a gap together.
    fn paths(&mut self, ranges: &[Range<usize>; 2], moves: &[Vec<usize>; 2]) {
        let curves = [0, 1].map(|side| {
            let moved = moves[side].iter().filter_map(|at| self.courses[side].moved(*at));
            moved.map(|moved| &moved.curve).collect::<Vec<&Curve>>()
        });
        if curves[0].is_empty() || curves[1].is_empty() {
            self.only_one(ranges, moves, &curves);
            return;
        }
        let mut couples = self.couples(&curves);
        for couple in &mut couples {
            couple.moves = [0, 1].map(|side| moves[side][couple.moves[side]]);
            self.pair(couple);
        }
        self.close();
    }

    /// Pairs moves one by one, as a person compares two programs, unless another traversal shows that the paths are
    /// much closer (by more than a factor of 2).
    fn couples(&self, curves: &[Vec<&Curve>; 2]) -> Vec<PathCoupling> {
        let [a, b] = curves;
        let by_moves = move_by_move(a, b, self.precision());
        let threshold = self.threshold();
        if let Some(by_moves) = &by_moves
            && most(by_moves) <= threshold
        {
            return by_moves.clone();
        }
        let rest = [a[0].start(), b[0].start()];
        let mut couples = couple(a, b, rest, self.precision(), self.options.tolerance_mm);
        self.tighten(curves, &mut couples);
        let least = most(&couples);
        by_moves
            .filter(|by_moves| least > threshold && most(by_moves) <= 2.0 * least)
            .unwrap_or(couples)
    }

    /// A larger distance is a difference, mm.
    fn threshold(&self) -> f64 {
        self.options.tolerance_mm.max(COINCIDENT_MM)
    }

    /// Lowers the bounds of a traversal that is too far apart to the Fréchet distance of chords along the curves.
    fn tighten(&self, curves: &[Vec<&Curve>; 2], couples: &mut [PathCoupling]) {
        let most = most(couples);
        let precision = self.precision();
        if most <= self.threshold() || !most.is_finite() {
            return;
        }
        let is_index_wise = curves[0].len() == 1 && curves[1].len() == 1;
        if is_index_wise || curves[0].len() * curves[1].len() > MAX_CELLS {
            return;
        }
        let chains = curves.each_ref().map(|curves| chain(curves, precision));
        let [Some(a), Some(b)] = &chains else { return };
        if a.len() * b.len() > MAX_CELLS {
            return;
        }
        let best = frechet(a, b, most, precision) + 2.0 * precision;
        for couple in couples {
            couple.max_distance_mm = couple.max_distance_mm.min(best);
        }
    }

    /// Compares moves that only one run has with the position of the other run meanwhile.
    fn only_one(
        &mut self,
        ranges: &[Range<usize>; 2],
        moves: &[Vec<usize>; 2],
        curves: &[Vec<&Curve>; 2],
    ) {
        let mut missing = lacking(
            self.courses,
            ranges,
            [0, 1].map(|side| moves[side].as_slice()),
            Category::Path,
        );
        let waits = usize::from(!curves[0].is_empty());
        if let Some(stands) = self.rest(waits, &ranges[waits]) {
            let couples = couple(&curves[0], &curves[1], [stands; 2], self.precision(), 0.0);
            let most = most(&couples);
            missing.distance_mm = Some(most);
            let spot = || {
                let made = curves[1 - waits].iter().map(|curve| curve.end());
                let spots = made.map(|end| if waits == 1 { [end, stands] } else { [stands, end] });
                widest(spots, most)
            };
            missing.at_mm = Some(spot().map(Vec3::to_array));
            if let [Some(a), Some(b)] = missing.blocks {
                self.found.distance(most, [a.first, b.first], spot);
            }
            if most <= self.threshold() {
                return;
            }
        }
        self.found.differences.push(missing);
    }

    /// The position of a path before a range of steps, or else at its first known move after it; `None` when there is
    /// neither.
    fn rest(&self, side: usize, range: &Range<usize>) -> Option<Vec3> {
        let course = self.courses[side];
        let known = |at: usize| course.moved(at).filter(|moved| moved.known);
        let before = (0..range.start).rev().find_map(known).map(|moved| moved.curve.end());
        before.or_else(|| {
            let following = (range.end..course.steps.len()).find_map(known);
            following.map(|moved| moved.curve.start())
        })
    }
}

/// Nine pairs of points that are passed at the same time when two moves, or parts of them, are traversed at constant
/// speed.
fn spots(moves: [&ComparedMove; 2], parts: [[f64; 2]; 2]) -> impl Iterator<Item = [Vec3; 2]> {
    (0..=8).map(move |eighth| {
        let share = f64::from(eighth) / 8.0;
        [0, 1].map(|side: usize| {
            let [from, to] = parts[side];
            let moved = moves[side];
            moved.curve.point_at(moved.length_mm * (from + (to - from) * share))
        })
    })
}

/// The pair of points with the largest distance up to `most_mm`; when all are further apart (a better traversal
/// passes them at other times), the closest pair.
fn widest(spots: impl IntoIterator<Item = [Vec3; 2]>, most_mm: f64) -> [Vec3; 2] {
    let key = |[a, b]: &[Vec3; 2]| {
        let separate = (*a - *b).length();
        if separate <= most_mm + COINCIDENT_MM { separate } else { -separate }
    };
    let wider = |a: &[Vec3; 2], b: &[Vec3; 2]| key(a).total_cmp(&key(b));
    spots.into_iter().max_by(wider).unwrap_or([Vec3::ZERO; 2])
}

/// The translation from one curve to the other, mm; `None` when they differ in more than a translation.
fn shift(a: &Curve, b: &Curve) -> Option<[f64; 3]> {
    let at_start = (b.start() - a.start()).to_array();
    let at_end = (b.end() - a.end()).to_array();
    let is_alike = std::mem::discriminant(a) == std::mem::discriminant(b)
        && (a.length() - b.length()).abs() <= COINCIDENT_MM;
    (is_alike && is_near(at_start, at_end)).then_some(at_start)
}

fn is_near(a: [f64; 3], b: [f64; 3]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= COINCIDENT_MM)
}

/// The vertices of chords within a precision, mm; `None` when there would be more than [`MAX_CELLS`].
fn chain(curves: &[&Curve], precision_mm: f64) -> Option<Vec<Vec3>> {
    let mut points: Vec<Vec3> = Vec::new();
    for curve in curves {
        let chords = curve.chords(precision_mm, Placement::Inscribed).ok()?;
        if points.len() as u64 + chords.chord_count() > MAX_CELLS as u64 {
            return None;
        }
        points.extend(chords);
    }
    points.dedup();
    Some(points)
}
