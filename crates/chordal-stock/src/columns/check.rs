//! Decides contacts with adaptive resolution: where cells are too coarse, the tile is computed again with halved
//! cells.

use std::collections::{BTreeMap, BTreeSet};

use chordal_geometry::Aabb;

use super::heights::{CellCeiling, CellHollows};
use super::plan::StockTask;
use super::turning_move::TurningTask;
use super::{
    ColumnOptions, ColumnStock, ContactDepth, JobResult, MOVES_PER_PLAN, StockError, TileJob,
    TouchAnswer,
};
use crate::oblique::ToolTurn;
use crate::sweep::TipMove;

/// A sequence of tasks on a fresh stock.
#[derive(Clone, Copy)]
pub struct StockCheck<'a> {
    /// The box of the stock, mm.
    pub bounds: Aabb,
    /// The options of its coarsest columns.
    pub options: ColumnOptions,
    /// The shape of the stock: see [`ColumnStock::shaped`].
    pub heights: &'a dyn Fn([f64; 2], [f64; 2]) -> [f64; 2],
    /// Its hollows below its tops: see [`ColumnStock::hollow`]; `None` without any.
    pub hollows: Option<&'a CellHollows<'a>>,
    /// The tasks, in order.
    pub tasks: &'a [StockTask<'a>],
    /// What else is removed before some tasks, with their numbers: see [`ColumnStock::lower`].
    pub lowered: &'a [(usize, &'a CellCeiling<'a>)],
    /// Depth to which bodies may reach into stock, mm: see [`ContactDepth::touch`].
    pub tolerance: f64,
    /// Least side of a cell, mm.
    pub finest: f64,
}

/// Runs jobs, in any order and on any threads.
pub type JobRunner<'a> = dyn Fn(Vec<TileJob<'_>>) -> Vec<JobResult> + 'a;

/// The result of a check.
#[derive(Clone, Debug)]
pub struct CheckedStock {
    /// The stock at the end, at its coarsest resolution.
    pub stock: ColumnStock,
    /// The contacts by task, body and move. A contact that is undecided for the tolerance is so with the finest
    /// cells, too.
    pub contacts: Vec<Vec<Vec<ContactDepth>>>,
    /// Number of tiles, of any size, that were computed again with finer cells.
    pub refined: usize,
}

/// A question: task, body and move.
type ContactQuestion = (usize, u32, u32);

/// Moves of a task, and how the direction of the tool turns on them.
type TaskMoves<'a> = (&'a [TipMove], &'a [ToolTurn]);

/// The open questions by tile, with the bounds known so far.
type OpenQuestions = BTreeMap<usize, BTreeMap<ContactQuestion, ContactDepth>>;

/// A part of the stock that is computed again: the moves of each task, with their numbers in it.
struct RefinedRegion {
    bounds: Aabb,
    resolution: f64,
    moves: Vec<Vec<TipMove>>,
    /// How the direction of the tool turns on them; empty for tasks without turns.
    turns: Vec<Vec<ToolTurn>>,
    numbers: Vec<Vec<u32>>,
    questions: BTreeSet<ContactQuestion>,
}

impl StockCheck<'_> {
    /// Runs the tasks, and runs them again with finer cells on tiles with undecided contacts.
    ///
    /// # Errors
    /// As [`ColumnStock::new`].
    pub fn run(&self) -> Result<CheckedStock, StockError> {
        self.run_by(&|jobs| jobs.into_iter().map(TileJob::run).collect())
    }

    /// Like [`StockCheck::run`], with a function that runs jobs in any order and on any threads.
    ///
    /// # Errors
    /// As [`ColumnStock::new`].
    pub fn run_by(&self, runner: &JobRunner<'_>) -> Result<CheckedStock, StockError> {
        let mut stock = self.begin(self.bounds, self.options)?;
        let none = |task: &StockTask<'_>| {
            vec![vec![ContactDepth::NONE; task.moves.len()]; task.body_count()]
        };
        let mut contacts: Vec<Vec<Vec<ContactDepth>>> = self.tasks.iter().map(none).collect();
        let mut open = OpenQuestions::new();
        for (number, task) in self.tasks.iter().enumerate() {
            self.lower(&mut stock, number);
            for (first, task) in chunks(*task) {
                for found in run(&mut stock, &task, runner) {
                    let questions = found
                        .contacts
                        .iter()
                        .map(|&(body, at, contact)| ((number, body, first + at), contact));
                    self.sort(
                        self.options.resolution,
                        found.tile,
                        questions,
                        &mut open,
                        &mut contacts,
                    );
                }
            }
        }
        self.answered(&mut open, &mut contacts);
        let moves: Vec<TaskMoves<'_>> = self
            .tasks
            .iter()
            .map(|task| (task.moves, task.turning.map_or(&[][..], |turning| turning.turns)))
            .collect();
        let parts = self.parts(&stock, &moves, None, open);
        let mut refined = 0;
        for part in parts {
            refined += self.again(part, runner, &mut contacts)?;
        }
        Ok(CheckedStock { stock, contacts, refined })
    }

    /// The fresh stock in a box.
    fn begin(&self, bounds: Aabb, options: ColumnOptions) -> Result<ColumnStock, StockError> {
        let mut stock = ColumnStock::shaped(bounds, options, self.heights)?;
        if let Some(hollows) = self.hollows {
            stock.hollow(hollows);
        }
        Ok(stock)
    }

    /// Removes what else is gone before a task.
    fn lower(&self, stock: &mut ColumnStock, task: usize) {
        for (_, lower) in self.lowered.iter().filter(|(before, _)| *before == task) {
            stock.lower(lower);
        }
    }

    /// Adds contacts that are decided, or as fine as allowed, to the results, and the rest to the tile's open
    /// questions.
    fn sort(
        &self,
        resolution: f64,
        tile: usize,
        found: impl Iterator<Item = (ContactQuestion, ContactDepth)>,
        open: &mut OpenQuestions,
        contacts: &mut [Vec<Vec<ContactDepth>>],
    ) {
        for (question, contact) in found {
            let undecided = matches!(contact.touch(self.tolerance), TouchAnswer::Undecided { .. });
            if undecided && resolution / 2.0 >= self.finest {
                let known =
                    open.entry(tile).or_default().entry(question).or_insert(ContactDepth::NONE);
                *known = known.deeper(contact);
            } else {
                settle(question, contact, contacts);
            }
        }
    }

    /// Closes open questions that another tile has answered: the body certainly touches there.
    fn answered(&self, open: &mut OpenQuestions, contacts: &mut [Vec<Vec<ContactDepth>>]) {
        open.retain(|_, questions| {
            questions.retain(|&question, &mut contact| {
                let (task, body, number) = question;
                let known = contacts[task][body as usize][number as usize];
                let hit = matches!(known.touch(self.tolerance), TouchAnswer::Hit { .. });
                if hit {
                    settle(question, contact, contacts);
                }
                !hit
            });
            !questions.is_empty()
        });
    }

    /// The regions of tiles with open questions, each with the moves that meet it up to its last question.
    fn parts(
        &self,
        stock: &ColumnStock,
        moves: &[TaskMoves<'_>],
        numbers: Option<&[Vec<u32>]>,
        open: OpenQuestions,
    ) -> Vec<RefinedRegion> {
        let tasks = self.tasks.len();
        let mut parts: BTreeMap<usize, RefinedRegion> = BTreeMap::new();
        for (tile, questions) in open {
            let (bounds, resolution) =
                (stock.grid().box_of(tile), stock.options().resolution / 2.0);
            let (moves, numbers) = (vec![Vec::new(); tasks], vec![Vec::new(); tasks]);
            let turns = vec![Vec::new(); tasks];
            let questions = questions.into_keys().collect();
            parts.insert(
                tile,
                RefinedRegion { bounds, resolution, moves, turns, numbers, questions },
            );
        }
        if parts.is_empty() {
            return Vec::new();
        }
        for (number, task) in self.tasks.iter().enumerate() {
            for (first, task) in chunks(with_moves(task, moves[number])) {
                let plan = stock.plan(&task);
                for (tile, todo) in plan.tiles() {
                    let Some(part) = parts.get_mut(&tile) else { continue };
                    if part.questions.last().is_none_or(|last| last.0 < number) {
                        continue;
                    }
                    let met: BTreeSet<u32> =
                        todo.iter().map(|&(_, step)| plan.number(step)).collect();
                    for at in met {
                        let at = first + at;
                        let of_task = numbers.map_or(at, |numbers| numbers[number][at as usize]);
                        let (moves, turns) = moves[number];
                        part.moves[number].push(moves[at as usize]);
                        part.turns[number].extend(turns.get(at as usize));
                        part.numbers[number].push(of_task);
                    }
                }
            }
        }
        parts.into_values().collect()
    }

    /// Runs a region at its resolution, and recursively what stays open. Returns the number of regions.
    fn again(
        &self,
        part: RefinedRegion,
        runner: &JobRunner<'_>,
        contacts: &mut [Vec<Vec<ContactDepth>>],
    ) -> Result<usize, StockError> {
        let options = ColumnOptions {
            resolution: part.resolution,
            middles: false,
            by_tag: false,
            ..self.options
        };
        let mut stock = self.begin(part.bounds, options)?;
        let mut open = OpenQuestions::new();
        for (number, task) in self.tasks.iter().enumerate() {
            self.lower(&mut stock, number);
            let of_task = &part.numbers[number];
            let has_question = |at: &u32| {
                let of_task = of_task[*at as usize];
                part.questions
                    .range((number, 0, 0)..(number + 1, 0, 0))
                    .any(|question| question.2 == of_task)
            };
            let compared: Vec<u32> = (0..of_task.len() as u32).filter(has_question).collect();
            let own = with_moves(task, (&part.moves[number], &part.turns[number]));
            let task = StockTask { numbers: Some(&compared), ..own };
            for (first, task) in chunks(task) {
                for found in run(&mut stock, &task, runner) {
                    let questions = found.contacts.iter().filter_map(|&(body, at, contact)| {
                        let question = (number, body, of_task[(first + at) as usize]);
                        part.questions.contains(&question).then_some((question, contact))
                    });
                    self.sort(part.resolution, found.tile, questions, &mut open, contacts);
                }
            }
        }
        self.answered(&mut open, contacts);
        let all = part.moves.iter().zip(&part.turns);
        let moves: Vec<TaskMoves<'_>> =
            all.map(|(moves, turns)| (moves.as_slice(), turns.as_slice())).collect();
        let mut refined = 1;
        for finer in self.parts(&stock, &moves, Some(&part.numbers), open) {
            refined += self.again(finer, runner, contacts)?;
        }
        Ok(refined)
    }
}

fn settle(
    (task, body, number): ContactQuestion,
    contact: ContactDepth,
    contacts: &mut [Vec<Vec<ContactDepth>>],
) {
    let known = &mut contacts[task][body as usize][number as usize];
    *known = known.deeper(contact);
}

fn run(stock: &mut ColumnStock, task: &StockTask<'_>, runner: &JobRunner<'_>) -> Vec<JobResult> {
    let plan = stock.plan(task);
    runner(stock.jobs(&plan))
}

/// A task in parts of as many moves as are planned at once, each with the number of its first move.
pub(crate) fn chunks(task: StockTask<'_>) -> impl Iterator<Item = (u32, StockTask<'_>)> {
    let some = task.moves.chunks(MOVES_PER_PLAN).enumerate();
    some.map(move |(n, moves)| {
        let at = n * MOVES_PER_PLAN;
        let first = at as u32;
        let turns = task.turning.map_or(&[][..], |turning| turning.turns);
        let turns = turns.get(at..at + moves.len()).unwrap_or_default();
        (first, StockTask { first, ..with_moves(&task, (moves, turns)) })
    })
}

/// The same task with other moves.
fn with_moves<'a>(task: &StockTask<'a>, (moves, turns): TaskMoves<'a>) -> StockTask<'a> {
    let turning = task.turning.map(|turning| TurningTask { turns, ..turning });
    StockTask { moves, turning, ..*task }
}
