//! Plans which steps of a list of moves are needed on which tile.

use chordal_geometry::{ParamCurve, Transform, Vec3};

use super::grid::TILE;
use super::turning_move::{TurningMove, TurningSolids, TurningTask};
use super::undercut_move::UndercutMove;
use super::{ColumnOptions, ContactDepth, JobResult, StockGrid};
use crate::sweep::strip::{SweepStrip, across, strip};
use crate::sweep::{BodyPart, MoveSplitter, RevolvedBody, SweepPiece, TipMove, parts};
use crate::{CutterProfile, Undercut};

/// A part of the cutter on a piece of the path.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PlanStep {
    pub piece: u32,
    pub part: u32,
    pub strip: SweepStrip,
    pub action: StepAction,
}

/// What a step does to the columns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum StepAction {
    /// Lowers them.
    Cut,
    /// Lowers only their inner heights.
    CutMost,
    /// Compares them with the body with this number.
    Compare(u32),
    /// The same on a move whose cutter may have been there before, so that the lower bound of the contact is not
    /// known.
    CompareMost(u32),
    /// Removes what an undercut sweeps on a whole move; `piece` is then an index of `below`.
    CutBelow,
    /// Compares a whole move of an undercut with the columns.
    CompareBelow(u32),
    /// Compares and removes on a whole move of a tool that turns; `piece` is then an index of `turning`.
    Turning,
}

impl StepAction {
    /// Whether the step is a whole move of an undercut.
    pub fn is_below(self) -> bool {
        matches!(self, StepAction::CutBelow | StepAction::CompareBelow(_))
    }

    /// Whether pieces of the path may leave columns to their neighbours.
    pub fn is_cut(self) -> bool {
        matches!(self, StepAction::Cut | StepAction::CutMost)
    }
}

/// A task: moves with what they cut and compare.
#[derive(Clone, Copy, Debug, Default)]
pub struct StockTask<'a> {
    /// The cutter that removes what it sweeps; `None` for moves that only compare.
    pub cutter: Option<&'a CutterProfile>,
    /// Set for moves of a tool whose direction turns, in place of cutters, undercuts and bodies.
    pub turning: Option<TurningTask<'a>>,
    /// A larger cutter for the upper bound: what it sweeps may be removed.
    pub may: Option<&'a CutterProfile>,
    /// Undercuts that remove what they sweep, each with the height of its lower end above the tip, mm. They are not
    /// combined with a cutter.
    pub undercuts: &'a [(f64, Undercut)],
    /// Bodies that are compared with the stock on each piece of the moves, before the piece is cut.
    pub bodies: &'a [RevolvedBody],
    /// The moves, in order.
    pub moves: &'a [TipMove],
    /// The ascending numbers of the moves on which bodies are compared; `None` for all moves.
    pub numbers: Option<&'a [u32]>,
    /// The number of the first move, for `numbers`.
    pub first: u32,
    /// With bodies and a cutter, moves are divided so that the tip rises or falls by at most this on a piece, mm. A
    /// body may appear to touch what the cutter removes on the same piece, up to this depth. Nothing is divided if it
    /// is not above zero.
    pub drop: f64,
}

/// The pieces of moves, assigned to the tiles that they meet.
#[derive(Clone, Debug)]
pub struct StockPlan {
    pub(crate) pieces: Vec<SweepPiece>,
    pub(crate) parts: Vec<BodyPart>,
    pub(crate) steps: Vec<PlanStep>,
    pub(crate) undercuts: Vec<Undercut>,
    pub(crate) below: Vec<UndercutMove>,
    pub(crate) turning: Vec<TurningMove>,
    pub(crate) solids: TurningSolids,
    /// Tile and number of a step, sorted by tile, then in the order of the program.
    todo: Vec<(u32, u32)>,
    bodies: usize,
    moves: usize,
}

/// Margin around strips when they are assigned to tiles, as a share of the tile: more than the rounding that tiles
/// allow for.
const STRIP_MARGIN_SHARE: f64 = 1e-5;

impl StockTask<'_> {
    /// Whether bodies are compared on a move.
    fn asks(&self, number: u32) -> bool {
        let requested = |numbers: &[u32]| numbers.binary_search(&(self.first + number)).is_ok();
        self.body_count() > 0 && self.numbers.is_none_or(requested)
    }

    /// The number of bodies that are compared.
    pub(crate) fn body_count(&self) -> usize {
        self.turning.map_or(self.bodies.len(), |turning| turning.bodies.len())
    }

    /// The range of heights of the tip in which it may remove something: above it the tool is over the stock, and
    /// below it all of its edges are under the stock.
    fn heights(&self, grid: &StockGrid) -> [f64; 2] {
        let cutters = self.cutter.into_iter().chain(self.may);
        let tops = cutters.map(|cutter| {
            cutter.edges().iter().map(|ring| ring.height_at(ring.to)).fold(0.0, f64::max)
        });
        let bounds = grid.bounds();
        [bounds.min.z - tops.fold(0.0, f64::max), bounds.max.z]
    }
}

impl StockPlan {
    pub(crate) fn new(
        grid: &StockGrid,
        options: &ColumnOptions,
        task: &StockTask<'_>,
    ) -> StockPlan {
        if let Some(turning) = &task.turning {
            return StockPlan::of_turning(grid, task, turning);
        }
        let mut splitter = MoveSplitter::new(options.chord_share * grid.resolution());
        let heights = task.heights(grid);
        for (number, path) in task.moves.iter().enumerate() {
            let divided = task.cutter.is_some() && task.asks(number as u32);
            splitter.add(
                number as u32,
                path,
                if divided { task.drop } else { f64::INFINITY },
                heights,
            );
        }
        let mut pieces = splitter.finish();
        for n in 1..pieces.len() {
            // Before a piece with a comparison, the piece before it must not leave columns to it.
            if task.asks(pieces[n].number) {
                pieces[n - 1].next = None;
            }
        }
        let mut of = Vec::new();
        let mut all: Vec<BodyPart> = Vec::new();
        for (body, RevolvedBody { parts, .. }) in task.bodies.iter().enumerate() {
            all.extend(parts);
            of.resize(all.len(), StepAction::Compare(body as u32));
        }
        all.extend(task.cutter.map_or(Vec::new(), |cutter| parts(&cutter.edges())));
        of.resize(all.len(), StepAction::Cut);
        all.extend(task.may.map_or(Vec::new(), |cutter| parts(&cutter.edges())));
        of.resize(all.len(), StepAction::CutMost);
        let of_bodies = task.bodies.iter().flat_map(|body| &body.undercuts);
        let undercuts = task.undercuts.iter().chain(of_bodies);
        let mut plan = StockPlan {
            pieces,
            parts: all,
            steps: Vec::new(),
            undercuts: undercuts.map(|(_, undercut)| undercut.clone()).collect(),
            below: Vec::new(),
            turning: Vec::new(),
            solids: TurningSolids::default(),
            todo: Vec::new(),
            bodies: task.bodies.len(),
            moves: task.moves.len(),
        };
        plan.assign_steps(grid, task, &of);
        plan
    }

    /// The plan of moves of a tool that turns.
    fn of_turning(grid: &StockGrid, task: &StockTask<'_>, turning: &TurningTask<'_>) -> StockPlan {
        let mut plan = StockPlan {
            pieces: Vec::new(),
            parts: Vec::new(),
            steps: Vec::new(),
            undercuts: Vec::new(),
            below: Vec::new(),
            turning: Vec::new(),
            solids: TurningSolids::of(turning, task.drop),
            todo: Vec::new(),
            bodies: turning.bodies.len(),
            moves: task.moves.len(),
        };
        for (number, (path, turn)) in task.moves.iter().zip(turning.turns).enumerate() {
            let number = number as u32;
            let (curve, tag, asks) = (path.curve, path.tag, task.asks(number));
            let own = TurningMove { curve, turn: *turn, number, tag, asks };
            let step = plan.steps.len() as u32;
            let tiles = plan.solids.tiles(grid, &own);
            plan.todo.extend(tiles.into_iter().map(|tile| (tile, step)));
            let (strip, action) = (SweepStrip::default(), StepAction::Turning);
            plan.steps.push(PlanStep { piece: step, part: 0, strip, action });
            plan.turning.push(own);
        }
        plan.todo.sort_by_key(|&(tile, _)| tile);
        plan
    }

    /// For each body and each move the depth of the contact, from the results of the jobs in any order.
    pub fn contacts(&self, found: &[JobResult]) -> Vec<Vec<ContactDepth>> {
        let mut contacts = vec![vec![ContactDepth::NONE; self.moves]; self.bodies];
        for &(body, number, contact) in found.iter().flat_map(|found| &found.contacts) {
            let known = &mut contacts[body as usize][number as usize];
            *known = known.deeper(contact);
        }
        contacts
    }

    /// Finds the tiles of each step. With undercuts, a body above their edges meets what they leave. On the way down
    /// they have passed where it touches, so it is compared after them; on the way up they have not been there yet,
    /// so it is compared before. On a move that does both, only the upper bound of the contact is known.
    fn assign_steps(&mut self, grid: &StockGrid, task: &StockTask<'_>, actions: &[StepAction]) {
        let pieces = core::mem::take(&mut self.pieces);
        let mut first = 0;
        for of_move in pieces.chunk_by(|a, b| a.number == b.number) {
            let number = of_move[0].number;
            let path = &task.moves[number as usize];
            let [rises, falls] = match task.undercuts {
                [] => [true, false],
                _ => UndercutMove::rises_and_falls(&path.curve),
            };
            let asks = task.asks(number);
            let compare = |plan: &mut StockPlan, only_most: bool| {
                for (n, piece) in of_move.iter().enumerate() {
                    for (part, action) in actions.iter().enumerate() {
                        let action = match *action {
                            StepAction::Compare(_) if !asks => continue,
                            StepAction::Compare(body) if only_most => StepAction::CompareMost(body),
                            action => action,
                        };
                        plan.assign_piece(grid, [first + n, part], piece, action);
                    }
                }
            };
            if rises {
                compare(self, falls);
            }
            self.assign_undercuts(grid, task, number, path, asks);
            if falls || !rises {
                compare(self, false);
            }
            first += of_move.len();
        }
        self.pieces = pieces;
        self.todo.sort_by_key(|&(tile, _)| tile);
    }

    fn assign_piece(
        &mut self,
        grid: &StockGrid,
        [at, part_at]: [usize; 2],
        piece: &SweepPiece,
        action: StepAction,
    ) {
        let bounds = grid.bounds();
        let width = grid.resolution() * TILE as f64;
        let part = &self.parts[part_at];
        if piece.lowest() + part.height >= bounds.max.z {
            return;
        }
        let strip = strip(&if action.is_cut() { *piece } else { piece.alone() }, part);
        let step = self.steps.len() as u32;
        let margin = piece.off_in_run + STRIP_MARGIN_SHARE * (width + part.reach);
        let before = self.todo.len();
        tiles(&strip, piece, bounds.min, width, margin, grid.tile_counts(), |tile| {
            self.todo.push((tile, step));
        });
        if self.todo.len() > before {
            self.steps.push(PlanStep { piece: at as u32, part: part_at as u32, strip, action });
        }
    }

    /// Adds the steps of the undercuts of a move, and of those of the bodies that are compared.
    fn assign_undercuts(
        &mut self,
        grid: &StockGrid,
        task: &StockTask<'_>,
        number: u32,
        path: &TipMove,
        asks: bool,
    ) {
        let own = task.undercuts.iter().map(|(lift, _)| (StepAction::CutBelow, *lift));
        let of_bodies =
            task.bodies.iter().enumerate().flat_map(|(body, RevolvedBody { undercuts, .. })| {
                let action = StepAction::CompareBelow(body as u32);
                undercuts.iter().map(move |(lift, _)| (action, *lift))
            });
        let bounds = grid.bounds();
        let width = grid.resolution() * TILE as f64;
        for (cutter, (action, lift)) in own.chain(of_bodies).enumerate() {
            let up = Transform::translation(Vec3::Z * lift);
            let curve = path.curve.transformed(&up);
            if action != StepAction::CutBelow && !asks || curve.bounds().min.z >= bounds.max.z {
                continue;
            }
            let below = UndercutMove { cutter: cutter as u32, curve, number, tag: path.tag };
            // The margin of a cell makes sure that a cell that is met only by rounding counts.
            let radius = self.undercuts[cutter].radius() + grid.resolution();
            let origin = [bounds.min.x, bounds.min.y];
            let counts = grid.tile_counts();
            let [across, up] = below.range(radius, origin, width, counts);
            let step = self.steps.len() as u32;
            for row in up[0]..=up[1] {
                for column in across[0]..=across[1] {
                    self.todo.push(((row * i64::from(counts[0]) + column) as u32, step));
                }
            }
            let piece = self.below.len() as u32;
            self.steps.push(PlanStep { piece, part: 0, strip: SweepStrip::default(), action });
            self.below.push(below);
        }
    }

    /// The number of a step's move.
    pub(crate) fn number(&self, step: u32) -> u32 {
        let PlanStep { piece, action, .. } = self.steps[step as usize];
        if action == StepAction::Turning {
            self.turning[piece as usize].number
        } else if action.is_below() {
            self.below[piece as usize].number
        } else {
            self.pieces[piece as usize].number
        }
    }

    /// The tiles in order, each with its steps.
    pub(crate) fn tiles(&self) -> impl Iterator<Item = (usize, &[(u32, u32)])> {
        self.todo.chunk_by(|a, b| a.0 == b.0).map(|steps| (steps[0].0 as usize, steps))
    }
}

/// The first and the last tile of a row between two coordinates; none where the first is larger.
fn between([from, to]: [f64; 2], width: f64, count: u32) -> [i64; 2] {
    let most = f64::from(count);
    [
        (from / width).floor().clamp(0.0, most) as i64,
        (to / width).floor().clamp(-1.0, most - 1.0) as i64,
    ]
}

fn tiles(
    strip: &SweepStrip,
    piece: &SweepPiece,
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
