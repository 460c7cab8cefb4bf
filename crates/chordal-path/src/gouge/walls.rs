//! What of a programmed chain is wall, and what only leads the tool to it and away.
//!
//! 1. Where the chain comes back to a point, the stretch between is closed. It is a wall if the blocks
//!    before and after it lie on the tool's side there: these are leads, and what closes through
//!    a lead is none. A loop that goes straight on beyond an outside corner and comes back for
//!    the next wall is an excursion.
//! 2. A closed wall beyond which another wall of the same kind is cut is a rough pass.
//! 3. A chain that closes nowhere is the wall, less its lead arcs: see [`open_chain`].

use std::collections::BTreeMap;

use chordal_geometry::Vec2;

use super::chain::{ChainWalls, turn};
use super::closing::{ClosingPoint, ClosingSide, MAX_LEAD};
use super::{Contour, ContourBlock, GougeOptions, nested, open_chain};

/// A closed stretch is longer than so many grains.
const MIN_LOOP_GRAINS: f64 = 4.0;

/// Finds the walls.
pub(super) fn of(
    contour: &Contour,
    chain: Vec<ContourBlock>,
    options: &GougeOptions,
) -> ChainWalls {
    let mut loops = ChainLoops::of(chain, contour.side.sign(), options);
    if loops.closed.is_empty() {
        let rest = loops.rest.iter().map(|at| loops.chain[*at]).collect();
        return open_chain::walls(contour, rest, options);
    }
    if let ([only], true) = (&loops.closed[..], loops.rest.is_empty()) {
        // Leads that meet, say in the centre of a bore, close even what is run past its own start.
        let mut blocks: Vec<ContourBlock> = only.iter().map(|at| loops.chain[*at]).collect();
        if open_chain::cut_at_overlap(&mut blocks, options) {
            return ChainWalls { blocks, closed: true, lead_arcs: Vec::new() };
        }
    }
    nested::drop_rough_passes(&mut loops.closed, &loops.chain, contour.side.sign());
    let mut indices: Vec<usize> = loops.closed.into_iter().flatten().collect();
    indices.sort_unstable();
    let blocks = indices.into_iter().map(|at| loops.chain[at]).collect();
    ChainWalls { blocks, closed: true, lead_arcs: Vec::new() }
}

/// What a closed stretch is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum WallVerdict {
    /// A wall, with leads at its closing point.
    Wall,
    /// Neither a wall nor a part of one.
    Nothing,
    /// A stretch of something larger that touches itself here.
    Partial,
}

/// The closed stretches of a chain.
struct ChainLoops {
    chain: Vec<ContourBlock>,
    /// The number of the place where each block begins and where it ends: equal places, equal numbers.
    places: Vec<(usize, usize)>,
    side: f64,
    grain: f64,
    tangent: f64,
    /// Of the whole chain, mm.
    length: f64,
    /// Blocks that lead to a wall or away.
    lead: Vec<bool>,
    /// The walls, each with its blocks.
    closed: Vec<Vec<usize>>,
    /// What belongs to no closed stretch.
    rest: Vec<usize>,
}

impl ChainLoops {
    fn of(chain: Vec<ContourBlock>, side: f64, options: &GougeOptions) -> ChainLoops {
        let mut loops = ChainLoops {
            places: places(&chain, options.vertex),
            lead: vec![false; chain.len()],
            length: chain.iter().map(|block| block.curve.length()).sum(),
            chain,
            side,
            grain: options.vertex,
            tangent: options.tangent,
            closed: Vec::new(),
            rest: Vec::new(),
        };
        loops.unwind();
        loops
    }

    /// Follows the chain. Whenever it comes back to a place, what lies between is taken off.
    fn unwind(&mut self) {
        let mut stack: Vec<usize> = Vec::new();
        let mut depth: Vec<usize> = vec![usize::MAX; 2 * self.chain.len()];
        for at in 0..self.chain.len() {
            let (from, to) = self.places[at];
            depth[from] = stack.len();
            stack.push(at);
            // Of a place that was taken off since, the depth is that of another.
            let Some(&below) = stack.get(depth[to]) else { continue };
            if self.places[below].0 != to {
                continue;
            }
            let body = stack.split_off(depth[to]);
            match self.verdict(&stack, &body, at + 1) {
                WallVerdict::Wall => {
                    self.mark_leads(&stack, &body, at + 1);
                    self.closed.push(body);
                }
                WallVerdict::Nothing => {}
                WallVerdict::Partial => stack.extend(body),
            }
        }
        self.rest = stack;
    }

    /// The blocks that meet a closed stretch at its closing point.
    fn neighbours(&self, stack: &[usize], body: &[usize], next: usize) -> [Option<usize>; 2] {
        let place = self.places[body[0]].0;
        let before = stack.last().copied().filter(|at| self.places[*at].1 == place);
        let after = (next < self.chain.len() && self.places[next].0 == place).then_some(next);
        [before, after]
    }

    fn lies(&self, body: &[usize], [before, after]: [Option<usize>; 2]) -> [ClosingSide; 2] {
        let closing = ClosingPoint {
            first: &self.chain[body[0]].curve,
            last: &self.chain[body[body.len() - 1]].curve,
            side: self.side,
            grain: self.grain,
        };
        [
            before.map_or(ClosingSide::Along, |at| closing.lies(&self.chain[at].curve.reversed())),
            after.map_or(ClosingSide::Along, |at| closing.lies(&self.chain[at].curve)),
        ]
    }

    fn verdict(&self, stack: &[usize], body: &[usize], next: usize) -> WallVerdict {
        if body.iter().any(|at| self.lead[*at]) {
            return WallVerdict::Nothing;
        }
        // A block as short as the grain ends where it begins, and closes nothing.
        if self.length_of(body) <= MIN_LOOP_GRAINS * self.grain {
            return WallVerdict::Partial;
        }
        let neighbours = self.neighbours(stack, body, next);
        if !self.lies(body, neighbours).contains(&ClosingSide::FarSide) {
            return WallVerdict::Wall;
        }
        if let [Some(before), Some(after)] = neighbours
            && self.is_excursion(before, body, after)
        {
            return WallVerdict::Nothing;
        }
        // Leads of few blocks are leads even where they cross the wall; that is reported then.
        let again = self.run_again(body, next);
        let after = self.chain.len() - next - again;
        let short = stack.len() <= MAX_LEAD && after <= MAX_LEAD + again.min(1);
        if short { WallVerdict::Wall } else { WallVerdict::Partial }
    }

    /// So many of the next blocks are those of a closed stretch once more.
    fn run_again(&self, body: &[usize], next: usize) -> usize {
        let same = |(at, first): &(usize, &usize)| self.places[*at] == self.places[**first];
        (next..self.chain.len()).zip(body).take_while(same).count()
    }

    /// Whether a loop goes straight on beyond an outside corner and comes back straight into the
    /// next wall. A pocket that is entered and left through its corner looks the same, but is more of the
    /// chain than its leads, and these may be arcs with the tool inside.
    fn is_excursion(&self, before: usize, body: &[usize], after: usize) -> bool {
        let curve = |at: usize| &self.chain[at].curve;
        let (first, last) = (curve(body[0]), curve(body[body.len() - 1]));
        let straight_on = turn(curve(before), curve(after)) * self.side < -self.tangent
            && turn(curve(before), first).abs() <= self.tangent
            && turn(last, curve(after)).abs() <= self.tangent;
        let is_lead = |at: usize| open_chain::is_lead_arc(curve(at), self.side);
        straight_on
            && !(is_lead(before) && is_lead(after))
            && 2.0 * self.length_of(body) <= self.length
    }

    fn length_of(&self, body: &[usize]) -> f64 {
        body.iter().map(|at| self.chain[*at].curve.length()).sum()
    }

    fn mark_leads(&mut self, stack: &[usize], body: &[usize], next: usize) {
        let neighbours = self.neighbours(stack, body, next);
        let lies = self.lies(body, neighbours);
        for (neighbour, lies) in neighbours.into_iter().zip(lies) {
            if let (Some(at), ClosingSide::ToolSide | ClosingSide::FarSide) = (neighbour, lies) {
                self.lead[at] = true;
            }
        }
    }
}

/// Width of a cell of places, in grains. So wide that most places lie farther than a grain from
/// the cell's edges, and few lie in one.
const CELL: f64 = 64.0;

/// Numbers the places where blocks begin and end: those nearer than the grain are one.
fn places(chain: &[ContourBlock], grain: f64) -> Vec<(usize, usize)> {
    let mut known: BTreeMap<(i64, i64), Vec<(Vec2, usize)>> = BTreeMap::new();
    let mut count = 0;
    // The cell of a coordinate, and the next one where its edge is within a grain.
    let cells = |x: f64| {
        let at = x / (CELL * grain);
        let cell = libm::floor(at) as i64;
        let inside = at - cell as f64;
        let adjacent = match inside * CELL {
            near_low if near_low <= 1.0 => Some(cell - 1),
            near_high if near_high >= CELL - 1.0 => Some(cell + 1),
            _ => None,
        };
        (cell, adjacent)
    };
    let mut number = |p: Vec2| {
        let ((a, adjacent_a), (b, adjacent_b)) = (cells(p.a), cells(p.b));
        let around = [
            Some((a, b)),
            adjacent_a.map(|adjacent| (adjacent, b)),
            adjacent_b.map(|adjacent| (a, adjacent)),
            adjacent_a.zip(adjacent_b),
        ];
        for cell in around.into_iter().flatten() {
            let near = known.get(&cell).and_then(|all| {
                all.iter().find(|(other, _)| other.distance(p) <= grain).map(|found| found.1)
            });
            if let Some(found) = near {
                return found;
            }
        }
        known.entry((a, b)).or_default().push((p, count));
        count += 1;
        count - 1
    };
    // Most blocks begin exactly where the one before them ends: that place has its number.
    let mut last: Option<(Vec2, usize)> = None;
    chain
        .iter()
        .map(|block| {
            let (from, to) = (block.curve.from(), block.curve.to());
            let from = last.filter(|(p, _)| *p == from).map_or_else(|| number(from), |p| p.1);
            let number_of_end = number(to);
            last = Some((to, number_of_end));
            (from, number_of_end)
        })
        .collect()
}
