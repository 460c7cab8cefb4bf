//! A run on stock: what each tool removes, and what it touches.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::OnceLock;

use chordal_command::Origin;
use chordal_diagnostics::Code;
use chordal_stock::columns::{CellCeiling, JobRunner, TileJob};
use chordal_stock::shape::SolidShape;
use chordal_stock::{
    AxialSolid, CheckedStock, ContactDepth, CutterProfile, RevolvedBody, StockCheck, StockError,
    StockTask, TipMove, ToolTurn, TurningTask, Undercut, VolumeInterval,
};

use super::earlier_side::{EarlierSide, InitialStock, below};
use super::fixtures::look_at_fixtures;
use super::gather::{BatchKind, MoveBatch, StockMoves};
use super::pass::{PassContext, StockOptions};
use super::problems::{ContactReport, FixtureClearance, StockProblems};
use super::removal::OtherSide;
use super::report::{StockReport, StockVerdict, ToolRemoved, knows_tips};
use super::setup::{NamedBody, SetupError, SetupFileReader, shift_between};
use super::target::{TARGET_TOLERANCE, TargetPart, TargetReport, look_at_target};
use super::tools::{ShankPiece, ToolBody, tools_of};
use crate::job::Job;
use crate::other_sides::MAX_STOCK_SIDE_RUNS;
use crate::report::Report;

/// Why a run on stock is not possible.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum StockRunError {
    /// No stock is given.
    #[error("there is no stock: give `[stock]` in a setup or machine file")]
    NoStock,
    /// A comment gives the size of the stock, mm, but not where its zero is.
    #[error(
        "there is no stock: a comment of the program says {} × {} × {} mm, and nothing says where its zero is",
        .0[0], .0[1], .0[2]
    )]
    StockNotPlaced([f64; 3]),
    /// The setup cannot be used.
    #[error(transparent)]
    Setup(#[from] SetupError),
    /// The columns of the stock cannot be made.
    #[error(transparent)]
    Stock(#[from] StockError),
    /// The machine is a lathe: its stock is a half section.
    #[error("this machine turns its parts: its stock is a half section, not columns")]
    Turns,
    /// It was interrupted.
    #[error("the run on stock was ended early")]
    Interrupted,
}

impl Job<'_> {
    /// Runs the program on the stock of its machine's setup; `files` reads the meshes that the setup names.
    ///
    /// # Errors
    /// Without stock, with a setup that is incomplete, or a resolution that needs too much memory.
    pub fn stock(
        &self,
        options: &StockOptions,
        files: SetupFileReader<'_>,
    ) -> Result<StockReport, StockRunError> {
        self.stock_by(options, files, &|tiles| tiles.into_iter().map(TileJob::run).collect())
    }

    /// Like [`Job::stock`], with a function that runs the jobs of tiles of columns, in any order and on any threads:
    /// the result is the same to the bit.
    ///
    /// # Errors
    /// As [`Job::stock`].
    pub fn stock_by(
        &self,
        options: &StockOptions,
        files: SetupFileReader<'_>,
        runner: &JobRunner<'_>,
    ) -> Result<StockReport, StockRunError> {
        let mut found = self.stock_of_run(options, files, runner)?;
        cut_other_sides(self, &mut found.report, &mut found.verdict, |job| {
            let side = job.stock_of_run(options, files, runner).ok()?;
            Some((side.report, side.verdict))
        });
        Ok(found)
    }

    /// Cuts the stock with one run.
    fn stock_of_run(
        &self,
        options: &StockOptions,
        files: SetupFileReader<'_>,
        runner: &JobRunner<'_>,
    ) -> Result<StockReport, StockRunError> {
        if self.turns() {
            return Err(StockRunError::Turns);
        }
        let tools = tools_of(self);
        let mut gathered = StockMoves::new(self, &tools, true);
        let report = self.report_watched(&mut gathered);
        let premise = self.stock_premise()?;
        let bodies = SetupBodies::of(self, &premise.body, &gathered, files)?;
        let resolution = options.resolution_mm.unwrap_or_else(|| usual_resolution(&bodies.stock));
        gathered.limit_turning(resolution);
        bodies.look_at_swings(self, &mut gathered);
        // Each orientation of the part has columns of its own.
        let budget = options.budget / gathered.turns.len() as u64;
        let run = |turn: usize| PassContext {
            job: self,
            options: StockOptions { budget, ..*options },
            resolution,
            tools: &tools,
            batches: gathered.batches.iter().filter(|batch| batch.turn == turn).collect(),
            units: gathered.units,
            runner,
        };
        let mut problems = StockProblems::default();
        let (cut, target) = match &gathered.turns[..] {
            [_] => bodies.look(&run(0), &mut problems)?,
            turns => bodies.look_turned(turns, &run, &gathered.batches, &mut problems)?,
        };
        if self.is_interrupted() {
            return Err(StockRunError::Interrupted);
        }
        problems.diagnostics.append(&mut gathered.diagnostics);
        problems.diagnostics.extend(premise.note());
        let removed =
            cut.volumes.map_or_else(|| cut.checked.stock.removed(), |[removed, _]| removed);
        let doubt =
            premise.doubt(removed.most, !gathered.order.is_empty() && !gathered.misses_cuts);
        let is_proved = gathered.is_whole() && problems.undecided == 0 && doubt.is_none();
        problems.diagnostics.extend(doubt);
        let mut found = finish(report, cut, problems, is_proved, &gathered);
        found.target = target;
        Ok(found)
    }
}

/// Cuts the stock with the runs that take other sides of conditions, and adds what only they touch. `cut` returns
/// `None` where such a run cannot be cut.
pub(super) fn cut_other_sides(
    job: &Job<'_>,
    report: &mut Report,
    verdict: &mut StockVerdict,
    mut cut: impl FnMut(&Job<'_>) -> Option<(Report, StockVerdict)>,
) {
    job.add_other_sides(report, MAX_STOCK_SIDE_RUNS, |side| {
        let Some((found, of_side)) = cut(side) else { return Vec::new() };
        if of_side == StockVerdict::Problems {
            *verdict = of_side;
        }
        found.diagnostics
    });
}

/// The bodies of a setup, in the given orientation of the part.
pub(super) struct SetupBodies<'a> {
    pub stock: SolidShape,
    pub fixtures: Vec<(FixtureClearance<'a>, SolidShape)>,
    /// The target part and its tolerance, mm; `None` where none is given.
    pub target: Option<(SolidShape, f64)>,
}

impl<'a> SetupBodies<'a> {
    fn of(
        job: &'a Job<'_>,
        body: &chordal_machine::Body,
        gathered: &StockMoves<'_>,
        files: SetupFileReader<'_>,
    ) -> Result<SetupBodies<'a>, StockRunError> {
        let shape_of = |name: &str, body, may_be_open| {
            let named = NamedBody { name, body };
            let shift = shift_between(job.machine(), &named, gathered.work.as_deref())?;
            named.shape(shift, files, may_be_open)
        };
        let setup = &job.machine().setup;
        let stock = shape_of("stock", body, false)?;
        let mut fixtures = Vec::new();
        for (name, body) in &setup.fixtures {
            let shape = shape_of(&format!("fixtures.{name}"), body, true)?;
            let clearance = body.clearance_mm.unwrap_or(0.0);
            fixtures.push((FixtureClearance { name, clearance }, shape));
        }
        let target = match &setup.target {
            Some(body) => {
                let shape = shape_of("target", body, false)?;
                Some((shape, body.tolerance_mm.unwrap_or(TARGET_TOLERANCE)))
            }
            None => None,
        };
        Ok(SetupBodies { stock, fixtures, target })
    }

    /// Cuts a part that is not turned, and checks everything that the tool touches.
    fn look(
        &self,
        run: &PassContext<'_>,
        problems: &mut StockProblems,
    ) -> Result<(CutStock, Option<TargetReport>), StockError> {
        let questions = run.all_questions();
        let begun = InitialStock::new([&self.stock, &self.stock], run.resolution, Vec::new());
        let cut = run.cut(&begun, &questions, &[])?;
        for (question, contacts) in questions.iter().zip(&cut.checked.contacts) {
            run.report(question, contacts, &|_, contact| contact, problems);
        }
        for (fixture, shape) in &self.fixtures {
            look_at_fixtures(run, fixture, shape, problems);
        }
        let target = match &self.target {
            Some((shape, tolerance)) => {
                let shapes = [shape.clone(), shape.clone()];
                let target = TargetPart { shapes, tolerance: *tolerance };
                look_at_target(run, &target, Some(&cut.checked.stock), problems)?
            }
            None => None,
        };
        Ok((CutStock { removed_by_tag: cut.checked.stock.removed_by_tag(), ..cut }, target))
    }
}

/// The usual side of a column, mm: a round value that gives at most about a quarter of a million columns.
pub(super) fn usual_resolution(stock: &SolidShape) -> f64 {
    const COLUMNS: f64 = 250_000.0;
    const STEPS: [f64; 7] = [0.05, 0.1, 0.2, 0.25, 0.5, 1.0, 2.0];
    let size = stock.bounds().size();
    let least = (size.x * size.y / COLUMNS).sqrt();
    STEPS.into_iter().find(|step| *step >= least).unwrap_or(least)
}

/// Stock after its cuts.
pub(super) struct CutStock {
    pub checked: CheckedStock,
    /// The volumes removed and left, mm³; `None` where the columns of the one orientation give them.
    pub volumes: Option<[VolumeInterval; 2]>,
    /// The volume that each tool has removed, mm³.
    pub removed_by_tag: Vec<(u32, VolumeInterval)>,
    /// Number of orientations in which the part is cut; the columns are those of the first.
    pub sides: usize,
    /// The other orientations.
    pub others: Vec<OtherSide>,
}

/// A task of the column engine with the meaning of its contacts.
pub(super) struct TaskQuestion<'a> {
    cutter: Option<&'a CutterProfile>,
    may: Option<&'a CutterProfile>,
    undercuts: &'a [(f64, Undercut)],
    /// The problem that each body makes when it touches.
    codes: Vec<Code>,
    bodies: Vec<RevolvedBody>,
    /// Set where the tool is not upright, in place of the cutters and bodies.
    pub turning: Option<TurningQuestion<'a>>,
    pub moves: Cow<'a, [TipMove]>,
    origins: Cow<'a, [Origin]>,
    pub tool: u32,
    /// Index of the batch in its pass.
    pub batch: usize,
}

/// The bodies of a tool that is not upright, and how it turns.
#[derive(Clone)]
pub(super) struct TurningQuestion<'a> {
    turns: Cow<'a, [ToolTurn]>,
    removes: Option<AxialSolid>,
    may: Option<AxialSolid>,
    bodies: Vec<AxialSolid>,
}

impl TurningQuestion<'_> {
    fn task(&self) -> TurningTask<'_> {
        TurningTask {
            turns: &self.turns,
            removes: self.removes.as_ref(),
            may: self.may.as_ref(),
            bodies: &self.bodies,
        }
    }
}

impl TaskQuestion<'_> {
    /// The same cuts without checks.
    pub fn only_cuts(&self) -> TaskQuestion<'_> {
        TaskQuestion {
            codes: Vec::new(),
            bodies: Vec::new(),
            turning: self.turning.as_ref().map(|turning| TurningQuestion {
                turns: Cow::Borrowed(&turning.turns),
                removes: turning.removes.clone(),
                may: turning.may.clone(),
                bodies: Vec::new(),
            }),
            moves: Cow::Borrowed(&self.moves),
            origins: Cow::Borrowed(&self.origins),
            ..*self
        }
    }
}

impl<'a> PassContext<'a> {
    /// The tasks of all batches.
    pub fn all_questions(&self) -> Vec<TaskQuestion<'a>> {
        let batches = self.batches.iter().enumerate();
        batches.flat_map(|(number, batch)| self.batch_questions(number, batch)).collect()
    }

    /// Cuts a stock, and finds what touches it; `lowered` lists what other orientations remove before tasks, by their
    /// numbers.
    pub fn cut(
        &self,
        begun: &InitialStock<'_>,
        questions: &[TaskQuestion<'_>],
        lowered: &[(usize, Vec<EarlierSide>)],
    ) -> Result<CutStock, StockError> {
        let tasks: Vec<StockTask<'_>> = questions
            .iter()
            .map(|question| StockTask {
                cutter: question.cutter,
                may: question.may,
                undercuts: question.undercuts,
                bodies: &question.bodies,
                turning: question.turning.as_ref().map(TurningQuestion::task),
                moves: &question.moves,
                drop: self.options.tolerance_mm,
                ..StockTask::default()
            })
            .collect();
        let heights = |low: [f64; 2], high: [f64; 2]| begun.of(low, high);
        let hollows = |corners: [[f64; 2]; 2]| begun.shape.hollows(corners);
        let bounds = begun.shape.bounds();
        let lower = |earlier: &[EarlierSide], corners: [[f64; 2]; 2], top: f64| {
            below(earlier, corners, top, bounds.min.z)
        };
        let by_task: Vec<(usize, Box<CellCeiling<'_>>)> = lowered
            .iter()
            .map(|(task, earlier)| -> (usize, Box<CellCeiling<'_>>) {
                (*task, Box::new(move |corners, top| lower(earlier, corners, top)))
            })
            .collect();
        let lowered: Vec<(usize, &CellCeiling<'_>)> =
            by_task.iter().map(|(task, lower)| (*task, &**lower)).collect();
        let check = StockCheck {
            bounds,
            options: self.columns(),
            heights: &heights,
            hollows: begun.shape.is_hollow().then_some(&hollows),
            tasks: &tasks,
            lowered: &lowered,
            tolerance: self.options.tolerance_mm,
            finest: self.finest(),
        };
        let checked = check.run_by(&|tiles| self.tiles(tiles))?;
        let (removed_by_tag, others) = (Vec::new(), Vec::new());
        Ok(CutStock { checked, volumes: None, removed_by_tag, sides: 1, others })
    }

    /// Reports the contacts of a task; `sure` corrects the certain depth of a contact, by the index of its move.
    pub fn report(
        &self,
        question: &TaskQuestion<'_>,
        contacts: &[Vec<ContactDepth>],
        sure: &dyn Fn(usize, ContactDepth) -> ContactDepth,
        problems: &mut StockProblems,
    ) {
        for (index, origin) in question.origins.iter().enumerate() {
            let is_aside = self.batches[question.batch].kind == BatchKind::Aside;
            let place = ContactReport { is_aside, ..self.place(*origin, question.tool) };
            let touches = question.codes.iter().zip(contacts);
            let touches = touches.map(|(code, of_moves)| (*code, sure(index, of_moves[index])));
            problems.touches(touches, self.options.tolerance_mm, &place);
        }
    }

    /// The tasks of a batch, in order.
    fn batch_questions(&self, number: usize, batch: &'a MoveBatch) -> Vec<TaskQuestion<'a>> {
        let Some(tool) = self.tool(batch.tool) else { return Vec::new() };
        if !batch.tool_turns.is_empty() {
            return turning_questions(number, batch, tool);
        }
        let own = |code| match &tool.undercuts[..] {
            [] => (code, RevolvedBody::of_cutter(&tool.cutter)),
            undercuts => (code, RevolvedBody::of_undercuts(undercuts)),
        };
        let above = bodies_above(tool);
        let cuts = |above: Vec<(Code, RevolvedBody)>| {
            let (codes, bodies) = above.into_iter().unzip();
            TaskQuestion {
                cutter: Some(tool.removes()).filter(|_| tool.undercuts.is_empty()),
                may: tool.core.as_ref().map(|_| &tool.cutter),
                undercuts: &tool.undercuts,
                codes,
                bodies,
                turning: None,
                moves: Cow::Borrowed(&batch.moves),
                origins: Cow::Borrowed(&batch.origins),
                tool: batch.tool,
                batch: number,
            }
        };
        match batch.kind {
            BatchKind::Cut => vec![cuts(above)],
            BatchKind::Rapid | BatchKind::Aside => {
                let own = own(Code::RapidThroughStock);
                vec![watched(number, batch, std::iter::once(own).chain(above))]
            }
            BatchKind::Still => {
                let own = own(Code::CutsWithoutSpindle);
                vec![watched(number, batch, std::iter::once(own)), cuts(above)]
            }
        }
    }
}

/// The tasks of a batch on which the tool is not upright.
fn turning_questions<'a>(
    number: usize,
    batch: &'a MoveBatch,
    tool: &ToolBody,
) -> Vec<TaskQuestion<'a>> {
    let question = |codes, moves, origins, turning| TaskQuestion {
        cutter: None,
        may: None,
        undercuts: &[],
        codes,
        bodies: Vec::new(),
        turning: Some(turning),
        moves,
        origins,
        tool: batch.tool,
        batch: number,
    };
    let watched = |bodies: Vec<(Code, AxialSolid)>| {
        let checked = batch.checked.iter().zip(&batch.origins).zip(&batch.tool_turns);
        let checked: Vec<(TipMove, Origin, ToolTurn)> =
            checked.filter_map(|((path, origin), turn)| Some(((*path)?, *origin, *turn))).collect();
        let (codes, bodies) = bodies.into_iter().unzip();
        let turns = checked.iter().map(|(_, _, turn)| *turn).collect();
        let turning = TurningQuestion { turns, removes: None, may: None, bodies };
        let moves = checked.iter().map(|(path, _, _)| *path).collect();
        let origins = checked.iter().map(|(_, origin, _)| *origin).collect();
        question(codes, moves, origins, turning)
    };
    let cuts = |bodies: Vec<(Code, AxialSolid)>| {
        let (codes, bodies) = bodies.into_iter().unzip();
        let [removes, may] = tool.solids();
        let turns = Cow::Borrowed(&batch.tool_turns[..]);
        let turning = TurningQuestion { turns, removes, may, bodies };
        let (moves, origins) = (Cow::Borrowed(&batch.moves[..]), Cow::Borrowed(&batch.origins[..]));
        question(codes, moves, origins, turning)
    };
    let above = tool.solids_above();
    let own = |code| vec![(code, tool.edges_solid())];
    match batch.kind {
        BatchKind::Cut => vec![cuts(above)],
        BatchKind::Rapid | BatchKind::Aside => {
            let mut all = own(Code::RapidThroughStock);
            all.extend(above);
            vec![watched(all)]
        }
        BatchKind::Still => vec![watched(own(Code::CutsWithoutSpindle)), cuts(above)],
    }
}

/// The task of a batch whose moves must touch nothing.
fn watched<'r>(
    number: usize,
    batch: &MoveBatch,
    bodies: impl Iterator<Item = (Code, RevolvedBody)>,
) -> TaskQuestion<'r> {
    let checked = batch.checked.iter().zip(&batch.origins);
    let (moves, origins): (Vec<TipMove>, Vec<Origin>) =
        checked.filter_map(|(path, from)| Some(((*path)?, *from))).unzip();
    let (codes, bodies) = bodies.unzip();
    let (moves, origins) = (Cow::Owned(moves), Cow::Owned(origins));
    let tool = batch.tool;
    TaskQuestion {
        cutter: None,
        may: None,
        undercuts: &[],
        codes,
        bodies,
        turning: None,
        moves,
        origins,
        tool,
        batch: number,
    }
}

/// The bodies above the edges of a tool, which must not touch.
fn bodies_above(tool: &ToolBody) -> Vec<(Code, RevolvedBody)> {
    let stack = |pieces: &[ShankPiece]| {
        let from = pieces.first()?.from;
        let segments: Vec<[f64; 3]> =
            pieces.iter().map(|piece| [piece.height, piece.lower, piece.upper]).collect();
        Some(RevolvedBody::stack(from, &segments))
    };
    let is_below = !tool.undercuts.is_empty();
    // The neck above an undercut is its shank, and always narrower.
    let flutes = RevolvedBody::above_flutes(&tool.cutter).filter(|_| !is_below);
    let flutes = flutes.map(|body| (Code::DeeperThanFlutes, body));
    // A shank no wider than the cutter touches only where the cut is deeper than the edges are long.
    let wide = |piece: &ShankPiece| piece.lower.max(piece.upper) > 2.0 * tool.cutter.radius();
    let shank = stack(&tool.shank).filter(|_| is_below || tool.shank.iter().any(wide));
    let shank = shank.map(|body| (Code::ShankInStock, body));
    let holder = stack(&tool.holder).map(|body| (Code::HolderInStock, body));
    holder.into_iter().chain(shank).chain(flutes).collect()
}

fn finish(
    mut report: Report,
    cut: CutStock,
    problems: StockProblems,
    is_proved: bool,
    gathered: &StockMoves<'_>,
) -> StockReport {
    // A spindle that was started without a speed does not turn either; the checks of the run report it.
    let is_still = report.diagnostics.iter().any(|found| found.code == Code::SpindleStopped);
    let has_problems = problems.hits > 0 || report.counts.errors > 0 || is_still;
    let is_proved = is_proved && report.is_path_verified() && knows_tips(&report);
    report.add(problems.diagnostics);
    let CutStock { checked: CheckedStock { stock, refined, .. }, volumes, others, .. } = cut;
    let [mut removed_mm3, mut left_mm3] =
        volumes.unwrap_or_else(|| [stock.removed(), stock.left()]);
    if gathered.misses_cuts {
        // Nobody knows what the cuts remove that are not simulated.
        (removed_mm3.most, left_mm3.least) = (removed_mm3.least + left_mm3.most, 0.0);
    }
    let by_tag: BTreeMap<u32, VolumeInterval> = cut.removed_by_tag.into_iter().collect();
    let tools = gathered.order.iter().map(|number| {
        let (moves, lowest_mm) = gathered.counts[number];
        let removed_mm3 = by_tag.get(number).copied().unwrap_or_default();
        let has_holder = gathered.has_holder(*number);
        ToolRemoved { number: *number, moves, removed_mm3, lowest_mm, has_holder, time_s: None }
    });
    StockReport {
        resolution_mm: stock.grid().resolution(),
        refined: refined as u64,
        removed_mm3,
        left_mm3,
        verdict: match (has_problems, is_proved) {
            (true, _) => StockVerdict::Problems,
            (false, true) => StockVerdict::Clean,
            (false, false) => StockVerdict::NotProved,
        },
        problems: problems.list,
        more_problems: problems.more,
        tools: tools.collect(),
        target: None,
        sides: cut.sides,
        others,
        intervals: OnceLock::new(),
        stock,
        report,
    }
}
