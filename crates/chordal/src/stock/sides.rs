//! Parts that are cut from several sides: columns for each way that the part lies.
//!
//! What is cut from one side is removed from the columns of that side, and from those of the sides of which all cuts
//! come later as far as it reaches down from their tops. So each of these stocks holds the part that is truly left: a
//! tool that is clear of one is clear of it. What touches is sure where no other side has removed anything near.

use std::collections::BTreeMap;

use chordal_geometry::{Aabb, ParamCurve, Vec3};
use chordal_path::Segment;
use chordal_stock::shape::Shape;
use chordal_stock::{Amount, Contact, Stock, StockError};

use super::earlier::{Begun, Earlier, Tops};
use super::fixtures::look_at_fixtures;
use super::gather::{Batch, Gathered};
use super::pass::Run;
use super::problems::Problems;
use super::run::{Asked, Bodies, Cut};
use super::target::{Target, TargetReport, look_at_target};
use super::turns::{Turn, boxed, swept};
use crate::job::Job;

/// Columns along a side of a block of which one height is kept.
const BLOCK: u32 = 16;
/// Heights that differ by less are the same, mm.
const SAME: f64 = 1e-6;

/// The stock of one way that the part lies.
struct Side<'a> {
    turn: Turn,
    asked: Vec<Asked<'a>>,
    cut: Cut,
    floors: Floors,
    tops: Tops,
    /// Its last move, by the place of the batch in the run.
    last: usize,
}

impl Bodies<'_> {
    /// Says of moves on which the part turns whether the tool is clear of it, whatever the angle.
    pub(super) fn look_at_swings(&self, job: &Job<'_>, gathered: &mut Gathered<'_>) {
        let swings: Vec<Segment> = std::mem::take(&mut gathered.swings);
        for segment in &swings {
            if !self.is_clear(job, gathered, segment) {
                gathered.tell_swing(segment);
            }
        }
    }

    fn is_clear(&self, job: &Job<'_>, gathered: &Gathered<'_>, segment: &Segment) -> bool {
        let Some(radius) = gathered.radius(segment.tool) else { return false };
        let rotary = &job.machine().rotary;
        // As it lies before the axis turns: whatever it turns by, the swept place is the same.
        let (from, to) = (segment.rotary_from, segment.rotary_to);
        let before = [0, 1, 2].map(|axis| if from[axis] == to[axis] { from[axis] } else { 0.0 });
        let Ok(turn) = Turn::of(rotary, before) else { return false };
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

    /// Cuts a part that is turned, and looks at all that is touched.
    pub(super) fn look_turned<'a>(
        &self,
        turns: &[Turn],
        run: &dyn Fn(usize) -> Run<'a>,
        batches: &'a [Batch],
        problems: &mut Problems,
    ) -> Result<(Cut, Option<TargetReport>), StockError> {
        let mut sides: Vec<(usize, Side<'a>)> = Vec::new();
        let first = |turn: usize| batches.iter().position(|batch| batch.turn == turn);
        let last = |turn: usize| batches.iter().rposition(|batch| batch.turn == turn);
        let mut order: Vec<usize> = (0..turns.len()).collect();
        order.sort_by_key(|turn| first(*turn));
        for number in order {
            let (run, turn) = (run(number), turns[number]);
            // The first is the part as it was given, even where it is never cut so.
            if run.batches.is_empty() && number > 0 {
                continue;
            }
            let Some([outer, inner]) = turn.shapes(&self.stock) else {
                problems.undecided += 1;
                continue;
            };
            let done = sides.iter().filter(|(_, side)| first(number) > Some(side.last));
            let earlier = done.map(|(_, side)| Earlier {
                tops: &side.tops,
                there: turn.to_program.inverse().then(&side.turn.to_program),
            });
            let begun = Begun::new([&outer, &inner], run.resolution, earlier.collect());
            let asked = run.all_asked();
            let cut = run.cut(&begun, &asked)?;
            let stock = &cut.checked.stock;
            let (floors, tops) = (Floors::of(stock, &begun), Tops::of(stock));
            let last = last(number).unwrap_or(0);
            sides.push((number, Side { turn, asked, cut, floors, tops, last }));
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
                    let target = Target { shapes, tolerance: *tolerance };
                    look_at_target(&run, &target, None, problems)?;
                }
                None => problems.undecided += 1,
            }
        }
        let sides = sides.into_iter().map(|(_, side)| side).collect();
        Ok((together(&self.stock, sides)?, None))
    }

    /// The touches of all sides in the order of the run.
    fn report_turned<'a>(
        &self,
        sides: &[(usize, Side<'a>)],
        run: &dyn Fn(usize) -> Run<'a>,
        batches: &'a [Batch],
        problems: &mut Problems,
    ) {
        let runs: Vec<Run<'a>> = sides.iter().map(|(number, _)| run(*number)).collect();
        // Where each batch of a side is in the run.
        let places: Vec<Vec<usize>> = sides
            .iter()
            .map(|(number, _)| {
                (0..batches.len()).filter(|at| batches[*at].turn == *number).collect()
            })
            .collect();
        let mut order: Vec<(usize, usize, usize)> = Vec::new();
        for (at, (_, side)) in sides.iter().enumerate() {
            let of_side = side.asked.iter().enumerate();
            order.extend(of_side.map(|(index, asked)| (places[at][asked.batch], at, index)));
        }
        order.sort_unstable();
        for (_, at, index) in order {
            let side = &sides[at].1;
            let asked = &side.asked[index];
            let reach = runs[at].tool(asked.tool).map_or(0.0, |tool| tool.radius());
            let sure = |of_move: usize, contact: Contact| {
                if contact.least <= 0.0 {
                    return contact;
                }
                let body = above(&asked.moves[of_move].curve.bounds(), reach, side);
                let others = sides.iter().enumerate().filter(|(other, _)| *other != at);
                let mut others = others.map(|(_, (_, other))| other);
                let is_untouched = others.all(|other| other.is_untouched(&body, &side.turn));
                Contact { least: if is_untouched { contact.least } else { 0.0 }, ..contact }
            };
            let contacts = &side.cut.checked.contacts[index];
            runs[at].report(asked, contacts, &sure, problems);
        }
    }
}

/// All that a tool passes on a move and that may be stock.
fn above(path: &Aabb, reach: f64, side: &Side<'_>) -> Aabb {
    let stock = side.cut.checked.stock.grid().bounds();
    let wide = Vec3::new(reach, reach, 0.0);
    let (low, high) = (path.min - wide, path.max + wide);
    Aabb {
        min: Vec3::new(low.x.max(stock.min.x), low.y.max(stock.min.y), low.z.max(stock.min.z)),
        max: Vec3::new(high.x.min(stock.max.x), high.y.min(stock.max.y), stock.max.z),
    }
}

impl Side<'_> {
    /// Whether nothing of a box, which lies as another side has it, may be removed from this side.
    fn is_untouched(&self, body: &Aabb, of: &Turn) -> bool {
        let there = of.to_program.inverse().then(&self.turn.to_program);
        let own = boxed(body, &there);
        self.floors.is_below(&own)
    }
}

/// How deep a side is cut, by blocks of columns.
struct Floors {
    low: [f64; 2],
    side: f64,
    blocks: [usize; 2],
    /// Nothing below is removed; infinite where nothing is removed at all.
    heights: Vec<f64>,
}

impl Floors {
    fn of(stock: &Stock, begun: &Begun<'_>) -> Floors {
        let grid = stock.grid();
        let [columns, rows] = grid.cells();
        let blocks = [columns, rows].map(|count| count.div_ceil(BLOCK) as usize);
        let mut heights = vec![f64::INFINITY; blocks[0] * blocks[1]];
        let pairs = stock.height_pairs();
        for row in 0..rows {
            for column in 0..columns {
                let left = pairs[row as usize * columns as usize + column as usize].inner;
                let [low, high] = grid.corners(column, row);
                let gap = stock.has_gaps().then(|| stock.gaps_at(column, row));
                let gap = gap.iter().flat_map(|[_, maybe]| maybe.iter());
                let lowest = gap.map(|gap| gap.floor).fold(left, f64::min);
                if lowest < begun.of(low, high)[1] - SAME {
                    let block = (row / BLOCK) as usize * blocks[0] + (column / BLOCK) as usize;
                    heights[block] = heights[block].min(lowest);
                }
            }
        }
        let min = grid.bounds().min;
        let side = f64::from(BLOCK) * grid.resolution();
        Floors { low: [min.x, min.y], side, blocks, heights }
    }

    /// Whether all of a box is under what is removed.
    fn is_below(&self, body: &Aabb) -> bool {
        let range = |axis: usize, from: f64, to: f64| {
            let at = |place: f64| ((place - self.low[axis]) / self.side).floor();
            let last = self.blocks[axis] as f64 - 1.0;
            (at(from - SAME).clamp(0.0, last) as usize)..=(at(to + SAME).clamp(0.0, last) as usize)
        };
        range(1, body.min.y, body.max.y).all(|row| {
            range(0, body.min.x, body.max.x)
                .all(|column| body.max.z <= self.heights[row * self.blocks[0] + column] - SAME)
        })
    }
}

/// What all sides have removed: at least what one of them has, at most the sum.
fn together(stock: &Shape, sides: Vec<Side<'_>>) -> Result<Cut, StockError> {
    let count = sides.len();
    let mut removed = Amount::default();
    let mut left_most = stock.volume();
    let mut is_hollow = false;
    let mut by_tag: BTreeMap<u32, Amount> = BTreeMap::new();
    let mut first: Option<Cut> = None;
    let mut refined = 0;
    for Side { cut, .. } in sides {
        let own = &cut.checked.stock;
        let [gone, left] = cut.volumes.unwrap_or_else(|| [own.removed(), own.left()]);
        removed.least = removed.least.max(gone.least);
        removed.most += gone.most;
        left_most = left_most.min(left.most);
        is_hollow |= cut.is_hollow;
        refined += cut.checked.refined;
        for (tag, amount) in own.removed_by_tag() {
            let known = by_tag.entry(tag).or_default();
            known.least = known.least.max(amount.least);
            known.most += amount.most;
        }
        first.get_or_insert(cut);
    }
    // The part as it was given is the first side, always.
    let mut cut = first.ok_or(StockError::Empty)?;
    removed.most = removed.most.min(stock.volume());
    removed.least = removed.least.max(stock.volume() - left_most);
    let left = Amount { least: (stock.volume() - removed.most).max(0.0), most: left_most };
    cut.volumes = Some([removed, left]);
    cut.checked.refined = refined;
    Ok(Cut { is_hollow, removed_by_tag: by_tag.into_iter().collect(), sides: count, ..cut })
}
