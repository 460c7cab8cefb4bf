//! Finds which blocks of a programmed chain are walls, and which only lead the tool to a wall and away from it.
//!
//! 1. Where the chain returns to a point, the range between is closed. It is a wall if the blocks before and after it
//!    are on the side of the tool there: then these are leads. A range that contains a lead is no wall. A loop that
//!    continues straight beyond an outside corner and returns for the next wall is an excursion, and no wall.
//! 2. A closed wall that another wall of the same kind cuts away is a roughing pass.
//! 3. A chain without a closed range is the wall, without its lead arcs: see [`open_chain`].

use std::collections::BTreeMap;

use chordal_geometry::Vec2;

use super::chain::{ChainWalls, turn};
use super::closing::{ClosingPoint, ClosingSide, MAX_LEAD};
use super::{Contour, ContourBlock, GougeOptions, nested, open_chain};

/// A closed range is longer than this many vertex tolerances.
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
        // Leads that meet, for example in the centre of a bore, close even a chain that continues past its own start.
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

/// What a closed range is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum WallVerdict {
    /// A wall, whose neighbours at its closing point are leads.
    Wall,
    /// Neither a wall nor a part of one.
    Nothing,
    /// A part of something larger that touches itself here.
    Partial,
}

/// The closed ranges of a chain.
struct ChainLoops {
    chain: Vec<ContourBlock>,
    /// The numbers of the points where each block begins and ends: equal points have equal numbers.
    places: Vec<(usize, usize)>,
    side: f64,
    grain: f64,
    tangent: f64,
    /// The length of the whole chain, mm.
    length: f64,
    /// True for blocks that lead to a wall or away from it.
    lead: Vec<bool>,
    /// The walls, each with its blocks.
    closed: Vec<Vec<usize>>,
    /// The blocks that belong to no closed range.
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

    /// Follows the chain. Whenever it returns to a point, the closed range is classified and taken off.
    fn unwind(&mut self) {
        let mut stack: Vec<usize> = Vec::new();
        let mut depth: Vec<usize> = vec![usize::MAX; 2 * self.chain.len()];
        for at in 0..self.chain.len() {
            let (from, to) = self.places[at];
            depth[from] = stack.len();
            stack.push(at);
            // If the point was taken off in the meantime, its depth may belong to another point.
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

    /// The blocks that meet a closed range at its closing point.
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
        // A block as short as the tolerance ends where it begins, but is not closed.
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
        // If there are only few blocks outside of it, these are leads, even if they cross the wall, which is reported.
        let again = self.run_again(body, next);
        let after = self.chain.len() - next - again;
        let short = stack.len() <= MAX_LEAD && after <= MAX_LEAD + again.min(1);
        if short { WallVerdict::Wall } else { WallVerdict::Partial }
    }

    /// How many of the next blocks repeat a closed range.
    fn run_again(&self, body: &[usize], next: usize) -> usize {
        let same = |(at, first): &(usize, &usize)| self.places[*at] == self.places[**first];
        (next..self.chain.len()).zip(body).take_while(same).count()
    }

    /// Whether a loop continues straight beyond an outside corner and returns straight into the next wall. A pocket
    /// that is entered and left through its corner looks the same, but is longer than the rest of the chain, or its
    /// leads are arcs with the tool inside.
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

/// Width of a cell, in vertex tolerances: so wide that most points are farther than the tolerance from its edges, and so
/// narrow that few points are in one cell.
const CELL: f64 = 64.0;

/// Numbers the points where blocks begin and end. Points nearer than `grain`, mm, have one number.
fn places(chain: &[ContourBlock], grain: f64) -> Vec<(usize, usize)> {
    let mut known: BTreeMap<(i64, i64), Vec<(Vec2, usize)>> = BTreeMap::new();
    let mut count = 0;
    // The cell of a coordinate, and the next one if its edge is within the tolerance.
    let cells = |x: f64| {
        let at = x / (CELL * grain);
        let cell = libm::floor(at) as i64;
        let inside = at - cell as f64;
        let adjacent = match inside * CELL {
            near_low if near_low <= 1.0 => Some(cell.saturating_sub(1)),
            near_high if near_high >= CELL - 1.0 => Some(cell.saturating_add(1)),
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
    // Most blocks begin exactly where the one before them ends: that point already has a number.
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
