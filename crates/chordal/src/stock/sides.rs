//! Parts that are cut from several sides, with columns for each orientation of the part.
//!
//! What is cut from one side is removed from the columns of that side, and from those of the others as far as it
//! reaches down from their tops, before these are cut the next time. So each of these stocks contains the part that
//! is truly left: a tool that is clear of one of them is clear of the part. A touch is certain where no other side
//! has removed anything near it.

use std::collections::BTreeMap;
use std::rc::Rc;

use chordal_geometry::{Aabb, ParamCurve, Vec3};
use chordal_path::Segment;
use chordal_stock::columns::OTHERS;
use chordal_stock::shape::SolidShape;
use chordal_stock::{ContactDepth, StockError, VolumeInterval};

use super::earlier_side::{EarlierSide, InitialStock, SideTops};
use super::fixtures::look_at_fixtures;
use super::gather::{MoveBatch, StockMoves};
use super::pass::PassContext;
use super::problems::StockProblems;
use super::removal::{OtherSide, SideRemoval};
use super::run::{CutStock, SetupBodies, TaskQuestion};
use super::target::{TargetPart, TargetReport, look_at_target};
use super::turns::{PartOrientation, boxed, swept};
use crate::job::Job;

/// How often the columns of one side are brought up to date with what other sides have removed since. Each time, all
/// earlier cuts from that side are computed again.
const MAX_VISITS: usize = 8;

/// The stock of one orientation after all its cuts.
struct StockSide<'a> {
    turn: PartOrientation,
    questions: Vec<TaskQuestion<'a>>,
    cut: CutStock,
    removed: SideRemoval,
}

/// The state of one orientation while the program changes between them.
struct VisitedSide<'a> {
    turn: PartOrientation,
    shapes: [SolidShape; 2],
    questions: Vec<TaskQuestion<'a>>,
    /// What other sides had removed before its first cut.
    begun: Vec<EarlierSide>,
    /// What they had removed before later tasks, by the numbers of the tasks.
    lowered: Vec<(usize, Vec<EarlierSide>)>,
    /// Its heights after the cuts so far; `None` before its first cut.
    tops: Option<Rc<SideTops>>,
}

/// Consecutive batches of one side.
struct SideVisit {
    side: usize,
    /// Its batches, by their indices among those of the side.
    batches: std::ops::Range<usize>,
    is_last: bool,
    /// True where batches of later visits were merged into it, so that other sides must not use what it removes.
    has_later: bool,
}

/// The visits of a run, in order.
fn visits(batches: &[MoveBatch]) -> Vec<SideVisit> {
    let mut visits: Vec<SideVisit> = Vec::new();
    let mut counts: BTreeMap<usize, [usize; 2]> = BTreeMap::new();
    for batch in batches {
        let [count, visited] = counts.entry(batch.turn).or_default();
        let at = *count;
        *count += 1;
        let goes_on = visits.last().is_some_and(|last| last.side == batch.turn);
        if !goes_on && *visited < MAX_VISITS {
            *visited += 1;
            let batches = at..at + 1;
            visits.push(SideVisit { side: batch.turn, batches, is_last: false, has_later: false });
        } else if let Some(own) = visits.iter_mut().rfind(|visit| visit.side == batch.turn) {
            own.batches.end = at + 1;
            own.has_later |= !goes_on;
        }
    }
    for side in counts.into_keys() {
        let last = visits.iter_mut().rfind(|visit| visit.side == side);
        last.into_iter().for_each(|visit| visit.is_last = true);
    }
    visits
}

impl SetupBodies<'_> {
    /// Reports moves on which the part turns, unless the tool is clear of it at any angle.
    pub(super) fn look_at_swings(&self, job: &Job<'_>, gathered: &mut StockMoves<'_>) {
        let swings: Vec<Segment> = std::mem::take(&mut gathered.swings);
        for segment in &swings {
            if !self.is_clear(job, gathered, segment) {
                gathered.report_swing(segment);
            }
        }
    }

    fn is_clear(&self, job: &Job<'_>, gathered: &StockMoves<'_>, segment: &Segment) -> bool {
        let Some(radius) = gathered.radius(segment.tool) else { return false };
        let rotary = &job.rotary_axes();
        // The orientation before the axis turns: the swept volume is the same for any angle.
        let (from, to) = (segment.rotary_from, segment.rotary_to);
        let before = [0, 1, 2].map(|axis| if from[axis] == to[axis] { from[axis] } else { 0.0 });
        let Ok(turn) = PartOrientation::of(rotary, before) else { return false };
        let Aabb { min, max } = segment.curve.bounds();
        let bodies = std::iter::once((&self.stock, 0.0))
            .chain(self.fixtures.iter().map(|(fixture, shape)| (shape, fixture.clearance)));
        bodies.into_iter().all(|(shape, clearance)| {
            let Some([outer, _]) = turn.shapes(shape) else { return false };
            let Some(around) = swept(rotary, from, to, &outer.bounds()) else { return false };
            let reach = radius + clearance;
            min.z - clearance >= around.max.z
                || min.x - reach >= around.max.x
                || max.x + reach <= around.min.x
                || min.y - reach >= around.max.y
                || max.y + reach <= around.min.y
        })
    }

    /// Cuts a part that is turned, and checks everything that the tool touches.
    pub(super) fn look_turned<'a>(
        &self,
        turns: &[PartOrientation],
        run: &dyn Fn(usize) -> PassContext<'a>,
        batches: &'a [MoveBatch],
        problems: &mut StockProblems,
    ) -> Result<(CutStock, Option<TargetReport>), StockError> {
        let mut sides: Vec<(usize, StockSide<'a>)> = Vec::new();
        let mut visited: BTreeMap<usize, VisitedSide<'a>> = BTreeMap::new();
        // The first orientation is the part as it was given, even if it is never cut so.
        let mut order = visits(batches);
        if order.iter().all(|visit| visit.side != 0) {
            order.push(SideVisit { side: 0, batches: 0..0, is_last: true, has_later: false });
        }
        for visit in order {
            let (number, turn) = (visit.side, turns[visit.side]);
            let Some(shapes) = turn.shapes(&self.stock) else {
                problems.undecided += u64::from(visit.is_last);
                continue;
            };
            let earlier = earlier_of(&visited, number, &turn);
            let run = run(number);
            let side = visited.entry(number).or_insert_with(|| VisitedSide {
                turn,
                shapes,
                questions: run.all_questions(),
                begun: earlier.clone(),
                lowered: Vec::new(),
                tops: None,
            });
            let task =
                side.questions.iter().position(|question| question.batch >= visit.batches.start);
            if side.tops.is_some() {
                side.lowered.extend(task.map(|task| (task, earlier)));
            }
            let [outer, inner] = &side.shapes;
            let begun = InitialStock::new([outer, inner], run.resolution, side.begun.clone());
            if visit.is_last {
                let cut = run.cut(&begun, &side.questions, &side.lowered)?;
                let removed = SideRemoval::of(&cut.checked.stock, &begun);
                if !visit.has_later {
                    side.tops = Some(Rc::new(SideTops::of(&cut.checked.stock)));
                }
                let questions = std::mem::take(&mut side.questions);
                sides.push((number, StockSide { turn, questions, cut, removed }));
            } else {
                let until =
                    side.questions.iter().filter(|question| question.batch < visit.batches.end);
                let cuts: Vec<TaskQuestion<'_>> = until.map(TaskQuestion::only_cuts).collect();
                let cut = run.cut(&begun, &cuts, &side.lowered)?;
                side.tops = Some(Rc::new(SideTops::of(&cut.checked.stock)));
            }
        }
        sides.sort_by_key(|(number, _)| *number);
        self.report_turned(&sides, run, batches, problems);
        for (number, side) in &sides {
            let run = run(*number);
            for (fixture, shape) in &self.fixtures {
                match side.turn.shapes(shape) {
                    Some([outer, _]) => look_at_fixtures(&run, fixture, &outer, problems),
                    None => problems.undecided += 1,
                }
            }
            let Some((shape, tolerance)) = &self.target else { continue };
            match side.turn.shapes(shape) {
                Some(shapes) => {
                    let target = TargetPart { shapes, tolerance: *tolerance };
                    look_at_target(&run, &target, None, problems)?;
                }
                None => problems.undecided += 1,
            }
        }
        let sides = sides.into_iter().map(|(_, side)| side).collect();
        Ok((together(&self.stock, sides)?, None))
    }

    /// Reports the touches of all sides in the order of the run.
    fn report_turned<'a>(
        &self,
        sides: &[(usize, StockSide<'a>)],
        run: &dyn Fn(usize) -> PassContext<'a>,
        batches: &'a [MoveBatch],
        problems: &mut StockProblems,
    ) {
        let runs: Vec<PassContext<'a>> = sides.iter().map(|(number, _)| run(*number)).collect();
        // The index in the run of each batch of a side.
        let places: Vec<Vec<usize>> = sides
            .iter()
            .map(|(number, _)| {
                (0..batches.len()).filter(|at| batches[*at].turn == *number).collect()
            })
            .collect();
        let mut order: Vec<(usize, usize, usize)> = Vec::new();
        for (at, (_, side)) in sides.iter().enumerate() {
            let of_side = side.questions.iter().enumerate();
            order.extend(of_side.map(|(index, question)| (places[at][question.batch], at, index)));
        }
        order.sort_unstable();
        for (_, at, index) in order {
            let side = &sides[at].1;
            let question = &side.questions[index];
            let tool = runs[at].tool(question.tool);
            let reach = tool.map_or(0.0, |tool| tool.radius());
            // A tool that is not upright may lie anywhere about its tip.
            let length = tool.filter(|_| question.turning.is_some()).map_or(0.0, |tool| tool.top());
            let around = Vec3::new(length, length, length);
            let sure = |of_move: usize, contact: ContactDepth| {
                if contact.least <= 0.0 {
                    return contact;
                }
                let Aabb { min, max } = question.moves[of_move].curve.bounds();
                let path = Aabb { min: min - around, max: max + around };
                let body = above(&path, reach, side);
                let others = sides.iter().enumerate().filter(|(other, _)| *other != at);
                let mut others = others.map(|(_, (_, other))| other);
                let is_untouched = others.all(|other| other.is_untouched(&body, &side.turn));
                ContactDepth { least: if is_untouched { contact.least } else { 0.0 }, ..contact }
            };
            let contacts = &side.cut.checked.contacts[index];
            runs[at].report(question, contacts, &sure, problems);
        }
    }
}

/// What other sides have removed so far, as seen from one side.
fn earlier_of(
    visited: &BTreeMap<usize, VisitedSide<'_>>,
    number: usize,
    turn: &PartOrientation,
) -> Vec<EarlierSide> {
    let others = visited.iter().filter(|(other, _)| **other != number);
    let earlier = others.filter_map(|(_, side)| {
        let there = turn.to_program.inverse().then(&side.turn.to_program);
        Some(EarlierSide { tops: side.tops.clone()?, there })
    });
    earlier.collect()
}

/// The box of all stock that a tool may pass on a move.
fn above(path: &Aabb, reach: f64, side: &StockSide<'_>) -> Aabb {
    let stock = side.cut.checked.stock.grid().bounds();
    let wide = Vec3::new(reach, reach, 0.0);
    let (low, high) = (path.min - wide, path.max + wide);
    Aabb {
        min: Vec3::new(low.x.max(stock.min.x), low.y.max(stock.min.y), low.z.max(stock.min.z)),
        max: Vec3::new(high.x.min(stock.max.x), high.y.min(stock.max.y), stock.max.z),
    }
}

impl StockSide<'_> {
    /// Whether this side has certainly removed nothing from a box, given in the orientation `of`.
    fn is_untouched(&self, body: &Aabb, of: &PartOrientation) -> bool {
        let there = of.to_program.inverse().then(&self.turn.to_program);
        let own = boxed(body, &there);
        self.removed.is_above(&own)
    }
}

/// Combines what all sides have removed: at least what one of them has, at most the sum.
fn together(stock: &SolidShape, sides: Vec<StockSide<'_>>) -> Result<CutStock, StockError> {
    let count = sides.len();
    let mut removed = VolumeInterval::default();
    let mut left_most = stock.volume();
    let mut by_tag: BTreeMap<u32, VolumeInterval> = BTreeMap::new();
    let mut first: Option<(CutStock, PartOrientation)> = None;
    let mut others = Vec::new();
    let mut refined = 0;
    for StockSide { turn, cut, removed: cells, .. } in sides {
        let own = &cut.checked.stock;
        let [mut gone, left] = [own.removed(), own.left()];
        let by_tag_of_side = own.removed_by_tag();
        if by_tag_of_side.iter().any(|(tag, _)| *tag == OTHERS) {
            // What other sides have removed counts for those.
            let own = by_tag_of_side.iter().filter(|(tag, _)| *tag != OTHERS);
            gone.most = gone.most.min(own.map(|(_, amount)| amount.most).sum());
        }
        removed.least = removed.least.max(gone.least);
        removed.most += gone.most;
        left_most = left_most.min(left.most);
        refined += cut.checked.refined;
        for (tag, amount) in by_tag_of_side.into_iter().filter(|(tag, _)| *tag != OTHERS) {
            let known = by_tag.entry(tag).or_default();
            known.least = known.least.max(amount.least);
            known.most += amount.most;
        }
        match &first {
            None => first = Some((cut, turn)),
            Some((_, first)) => others.push(OtherSide {
                stock: cut.checked.stock,
                removed: cells,
                there: first.to_program.inverse().then(&turn.to_program),
            }),
        }
    }
    // The first side is always the part as it was given.
    let (mut cut, _) = first.ok_or(StockError::Empty)?;
    removed.most = removed.most.min(stock.volume());
    removed.least = removed.least.max(stock.volume() - left_most);
    let left = VolumeInterval { least: (stock.volume() - removed.most).max(0.0), most: left_most };
    cut.volumes = Some([removed, left]);
    cut.checked.refined = refined;
    Ok(CutStock { removed_by_tag: by_tag.into_iter().collect(), sides: count, others, ..cut })
}
