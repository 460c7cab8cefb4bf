//! What a list of moves has to do on which tile.

use chordal_geometry::Vec3;

use super::grid::TILE;
use super::{Contact, Found, Grid, Options};
use crate::Cutter;
use crate::sweep::strip::{Strip, across, strip};
use crate::sweep::{Body, Move, Part, Piece, Splitter, parts};

/// A part of the cutter on a piece of the path.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Step {
    pub piece: u32,
    pub part: u32,
    pub strip: Strip,
    pub action: Action,
}

/// What a step does with the columns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Action {
    /// Lowers them.
    Cut,
    /// Compares them with a body, by its number.
    Compare(u32),
}

/// What moves do.
#[derive(Clone, Copy, Debug, Default)]
pub struct Task<'a> {
    /// The cutter that removes what it sweeps; none for moves that only ask.
    pub cutter: Option<&'a Cutter>,
    /// Bodies that are compared with the stock, each on each piece of the moves before the cutter is.
    pub bodies: &'a [Body],
    /// The moves, in order.
    pub moves: &'a [Move],
    /// The numbers, rising, of the moves whose bodies are compared; of all of them if there are none given.
    pub asked: Option<&'a [u32]>,
    /// The number of the first move, for `asked`.
    pub first: u32,
    /// With bodies and a cutter moves are divided so that the tip rises or falls by no more than this, mm: so
    /// much later than the cutter a body may seem to come, and so deep it may seem to touch what the cutter
    /// takes away on the same move. Nothing is divided if it is not above zero.
    pub drop: f64,
}

/// The moves of a cutter, cut into pieces and told to the tiles that they meet.
#[derive(Clone, Debug)]
pub struct Plan {
    pub(crate) pieces: Vec<Piece>,
    pub(crate) parts: Vec<Part>,
    pub(crate) steps: Vec<Step>,
    /// Tile and number of a step, by tile, then in the order of the program.
    todo: Vec<(u32, u32)>,
    bodies: usize,
    moves: usize,
}

/// Strips are told to tiles with this much more around them, as a share of the tile: above the rounding that
/// the tiles count.
const MARGIN: f64 = 1e-5;

impl Task<'_> {
    /// Whether bodies are compared on a move.
    fn asks(&self, number: u32) -> bool {
        let asked = |asked: &[u32]| asked.binary_search(&(self.first + number)).is_ok();
        !self.bodies.is_empty() && self.asked.is_none_or(asked)
    }
}

impl Plan {
    pub(crate) fn new(grid: &Grid, options: &Options, task: &Task<'_>) -> Plan {
        let mut splitter = Splitter::new(options.chord_share * grid.resolution());
        for (number, path) in task.moves.iter().enumerate() {
            let divided = task.cutter.is_some() && task.asks(number as u32);
            splitter.add(number as u32, path, if divided { task.drop } else { f64::INFINITY });
        }
        let mut pieces = splitter.finish();
        for n in 1..pieces.len() {
            // What is asked about before a piece, the pieces before it must have done themselves.
            if task.asks(pieces[n].number) {
                pieces[n - 1].next = None;
            }
        }
        let mut of = Vec::new();
        let mut all: Vec<Part> = Vec::new();
        for (body, Body { parts }) in task.bodies.iter().enumerate() {
            all.extend(parts);
            of.resize(all.len(), Action::Compare(body as u32));
        }
        all.extend(task.cutter.map_or(Vec::new(), |cutter| parts(&cutter.edges())));
        of.resize(all.len(), Action::Cut);
        let mut plan = Plan {
            pieces,
            parts: all,
            steps: Vec::new(),
            todo: Vec::new(),
            bodies: task.bodies.len(),
            moves: task.moves.len(),
        };
        plan.tell(grid, task, &of);
        plan
    }

    /// For each body and each move how deep it touches, from what the jobs found, in any order.
    pub fn contacts(&self, found: &[Found]) -> Vec<Vec<Contact>> {
        let mut contacts = vec![vec![Contact::NONE; self.moves]; self.bodies];
        for &(body, number, contact) in found.iter().flat_map(|found| &found.contacts) {
            let known = &mut contacts[body as usize][number as usize];
            *known = known.deeper(contact);
        }
        contacts
    }

    /// Finds the tiles of each step.
    fn tell(&mut self, grid: &Grid, task: &Task<'_>, actions: &[Action]) {
        let bounds = grid.bounds();
        let width = grid.resolution() * TILE as f64;
        let counts = grid.tile_counts();
        for (number, piece) in self.pieces.iter().enumerate() {
            let lowest = piece.lowest();
            for (part_number, part) in self.parts.iter().enumerate() {
                if lowest + part.height >= bounds.max.z {
                    continue;
                }
                let action = actions[part_number];
                let compares = action != Action::Cut;
                if compares && !task.asks(piece.number) {
                    continue;
                }
                let strip = strip(&if compares { piece.alone() } else { *piece }, part);
                let step = self.steps.len() as u32;
                let margin = piece.off_in_run + MARGIN * (width + part.reach);
                let before = self.todo.len();
                tiles(&strip, piece, bounds.min, width, margin, counts, |tile| {
                    self.todo.push((tile, step));
                });
                if self.todo.len() > before {
                    let (piece, part) = (number as u32, part_number as u32);
                    self.steps.push(Step { piece, part, strip, action });
                }
            }
        }
        self.todo.sort_by_key(|&(tile, _)| tile);
    }

    /// The number of the move of a step.
    pub(crate) fn number(&self, step: u32) -> u32 {
        self.pieces[self.steps[step as usize].piece as usize].number
    }

    /// The tiles in order, each with its steps.
    pub(crate) fn tiles(&self) -> impl Iterator<Item = (usize, &[(u32, u32)])> {
        self.todo.chunk_by(|a, b| a.0 == b.0).map(|steps| (steps[0].0 as usize, steps))
    }
}

/// The first and the last of a row of tiles between two places; none when the first is larger.
fn between([from, to]: [f64; 2], width: f64, count: u32) -> [i64; 2] {
    let most = f64::from(count);
    [
        (from / width).floor().clamp(0.0, most) as i64,
        (to / width).floor().clamp(-1.0, most - 1.0) as i64,
    ]
}

fn tiles(
    strip: &Strip,
    piece: &Piece,
    origin: Vec3,
    width: f64,
    margin: f64,
    counts: [u32; 2],
    mut found: impl FnMut(u32),
) {
    let [ux, uy] = piece.along;
    let begin = [piece.start.x - origin.x, piece.start.y - origin.y];
    let sideways = ux.abs() * (strip.reach + margin);
    let ends = [uy * (strip.from - margin), uy * (strip.to + margin)];
    let rows =
        [begin[1] + ends[0].min(ends[1]) - sideways, begin[1] + ends[0].max(ends[1]) + sideways];
    let [first, last] = between(rows, width, counts[1]);
    for row in first..=last {
        let band = [row as f64 * width - begin[1], (row + 1) as f64 * width - begin[1]];
        let columns = across(strip, piece.along, band, margin).map(|x| x + begin[0]);
        let [first, last] = between(columns, width, counts[0]);
        for column in first..=last {
            found((row * i64::from(counts[0]) + column) as u32);
        }
    }
}
