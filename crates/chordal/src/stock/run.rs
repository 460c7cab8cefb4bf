//! A run on stock: what each tool removes, and what is touched on the way.

use std::borrow::Cow;
use std::collections::BTreeMap;

use chordal_command::Origin;
use chordal_diagnostics::Code;
use chordal_geometry::ParamCurve;
use chordal_stock::columns::{Job as TileJob, Runner};
use chordal_stock::shape::Shape;
use chordal_stock::{Amount, Body, Check, Checked, Cutter, Move, StockError, Task, Undercut};

use super::fixtures::look_at_fixtures;
use super::gather::{Batch, Gathered, Kind};
use super::heights::Heights;
use super::pass::{Run, StockOptions};
use super::problems::{Fixture, Problems};
use super::report::{StockReport, StockVerdict, ToolRemoved};
use super::setup::{Files, Named, SetupError, shift_between};
use super::target::{TARGET_TOLERANCE, Target, look_at_target};
use super::tools::{Piece, ToolBody, tools_of};
use crate::job::Job;
use crate::report::Report;

/// Why there is no run on stock.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum StockRunError {
    /// No stock is given.
    #[error("there is no stock: give `[stock]` in a setup or machine file")]
    NoStock,
    /// The setup cannot be used.
    #[error(transparent)]
    Setup(#[from] SetupError),
    /// There are no columns for the stock.
    #[error(transparent)]
    Stock(#[from] StockError),
    /// It was to end early.
    #[error("the run on stock was ended early")]
    Interrupted,
}

impl Job<'_> {
    /// Runs the program on the stock of its machine's setup; `files` gives the meshes that it names.
    ///
    /// # Errors
    /// Without stock, with a setup that is incomplete, or a resolution that needs too much memory.
    pub fn stock(
        &self,
        options: &StockOptions,
        files: Files<'_>,
    ) -> Result<StockReport, StockRunError> {
        self.stock_by(options, files, &|tiles| tiles.into_iter().map(TileJob::run).collect())
    }

    /// The same with a function that cuts tiles of columns, in any order and on any threads: the answer has the same
    /// bits.
    ///
    /// # Errors
    /// As [`Job::stock`].
    pub fn stock_by(
        &self,
        options: &StockOptions,
        files: Files<'_>,
        runner: &Runner<'_>,
    ) -> Result<StockReport, StockRunError> {
        let tools = tools_of(self);
        let control = self.control();
        let mut gathered =
            Gathered::new(&tools, control.table.work_names, control.parameters.rules.units);
        let report = self.report_watched(&mut gathered);
        let shape_of = |name: &str, body, may_be_open| {
            let named = Named { name, body };
            let shift = shift_between(self.machine(), &named, gathered.work.as_deref())?;
            named.shape(shift, files, may_be_open)
        };
        let setup = &self.machine().setup;
        let body = setup.stock.as_ref().ok_or(StockRunError::NoStock)?;
        let stock = shape_of("stock", body, false)?;
        let mut fixtures = Vec::new();
        for (name, body) in &setup.fixtures {
            let shape = shape_of(&format!("fixtures.{name}"), body, true)?;
            let clearance = body.clearance_mm.unwrap_or(0.0);
            fixtures.push((Fixture { name, clearance }, shape));
        }
        let target = match &setup.target {
            Some(body) => {
                let shape = shape_of("target", body, false)?;
                Some(Target { shape, tolerance: body.tolerance_mm.unwrap_or(TARGET_TOLERANCE) })
            }
            None => None,
        };
        let run = Run {
            job: self,
            options: *options,
            resolution: options.resolution_mm.unwrap_or_else(|| usual_resolution(&stock)),
            tools: &tools,
            batches: &gathered.batches,
            units: gathered.units,
            runner,
        };
        let mut problems = Problems::default();
        let cut = run.cut(&stock, &mut problems)?;
        for (fixture, shape) in &fixtures {
            look_at_fixtures(&run, fixture, shape, &mut problems);
        }
        let target = match &target {
            Some(target) => Some(look_at_target(&run, target, &cut.checked.stock, &mut problems)?),
            None => None,
        };
        if self.is_interrupted() {
            return Err(StockRunError::Interrupted);
        }
        problems.diagnostics.append(&mut gathered.diagnostics);
        let is_proved = gathered.is_whole() && problems.undecided == 0;
        let mut found = finish(report, cut, problems, is_proved, &gathered);
        found.target = target;
        Ok(found)
    }
}

/// A round resolution with about a quarter of a million columns, mm.
pub(super) fn usual_resolution(stock: &Shape) -> f64 {
    const COLUMNS: f64 = 250_000.0;
    const STEPS: [f64; 7] = [0.05, 0.1, 0.2, 0.25, 0.5, 1.0, 2.0];
    let size = stock.bounds().size();
    let least = (size.x * size.y / COLUMNS).sqrt();
    STEPS.into_iter().find(|step| *step >= least).unwrap_or(least)
}

/// Stock that is cut.
struct Cut {
    checked: Checked,
    /// What is removed and left, mm³, of stock that is hollow from below.
    hollow: Option<[Amount; 2]>,
}

/// A task with what its contacts mean.
struct Asked<'a> {
    cutter: Option<&'a Cutter>,
    undercuts: &'a [(f64, Undercut)],
    /// What each body means that touches.
    codes: Vec<Code>,
    bodies: Vec<Body>,
    moves: Cow<'a, [Move]>,
    origins: Cow<'a, [Origin]>,
    tool: u32,
}

impl Run<'_> {
    /// Cuts the stock and looks at what touches it.
    fn cut(&self, stock: &Shape, problems: &mut Problems) -> Result<Cut, StockError> {
        let asked: Vec<Asked<'_>> =
            self.batches.iter().flat_map(|batch| self.asked(batch)).collect();
        let tasks: Vec<Task<'_>> = asked
            .iter()
            .map(|asked| Task {
                cutter: asked.cutter,
                undercuts: asked.undercuts,
                bodies: &asked.bodies,
                moves: &asked.moves,
                drop: self.options.tolerance_mm,
                ..Task::default()
            })
            .collect();
        let shape = Heights::new(stock, self.resolution);
        let heights = |low: [f64; 2], high: [f64; 2]| shape.of(low, high);
        let check = Check {
            bounds: stock.bounds(),
            options: self.columns(),
            heights: &heights,
            tasks: &tasks,
            tolerance: self.options.tolerance_mm,
            finest: self.finest(),
        };
        let checked = check.run_by(&|tiles| self.tiles(tiles))?;
        for (asked, contacts) in asked.iter().zip(&checked.contacts) {
            for (index, origin) in asked.origins.iter().enumerate() {
                let place = self.place(*origin, asked.tool);
                let touches = asked.codes.iter().zip(contacts);
                let touches = touches.map(|(code, of_moves)| (*code, of_moves[index]));
                problems.touches(touches, self.options.tolerance_mm, &place);
            }
        }
        let hollow = shape.volumes(&checked.stock);
        Ok(Cut { checked, hollow })
    }

    /// What is asked on the moves of a batch, in order.
    fn asked<'r>(&'r self, batch: &'r Batch) -> Vec<Asked<'r>> {
        let Some(tool) = self.tool(batch.tool) else { return Vec::new() };
        let own = |code| match &tool.undercuts[..] {
            [] => (code, Body::of_cutter(&tool.cutter)),
            undercuts => (code, Body::of_undercuts(undercuts)),
        };
        let above = bodies_above(tool);
        let cuts = |above: Vec<(Code, Body)>| {
            let (codes, bodies) = above.into_iter().unzip();
            Asked {
                cutter: Some(&tool.cutter).filter(|_| tool.undercuts.is_empty()),
                undercuts: &tool.undercuts,
                codes,
                bodies,
                moves: Cow::Borrowed(&batch.moves),
                origins: Cow::Borrowed(&batch.origins),
                tool: batch.tool,
            }
        };
        match batch.kind {
            Kind::Cut => vec![cuts(above)],
            Kind::Rapid => {
                let own = own(Code::RapidThroughStock);
                vec![watched(batch, std::iter::once(own).chain(above))]
            }
            Kind::Still => {
                let own = own(Code::CutsWithoutSpindle);
                vec![watched(batch, std::iter::once(own)), cuts(above)]
            }
        }
    }
}

/// The moves of a batch that only ask. Straight up nothing is touched that was not touched where the move begins.
fn watched<'r>(batch: &Batch, bodies: impl Iterator<Item = (Code, Body)>) -> Asked<'r> {
    let lifts = |path: &Move| {
        let (from, to) = (path.curve.start(), path.curve.end());
        from.x == to.x && from.y == to.y && to.z >= from.z
    };
    let kept = batch.moves.iter().zip(&batch.origins).filter(|(path, _)| !lifts(path));
    let (moves, origins): (Vec<Move>, Vec<Origin>) =
        kept.map(|(path, from)| (*path, *from)).unzip();
    let (codes, bodies) = bodies.unzip();
    let (moves, origins) = (Cow::Owned(moves), Cow::Owned(origins));
    Asked { cutter: None, undercuts: &[], codes, bodies, moves, origins, tool: batch.tool }
}

/// What is above the edges of a tool and must not touch.
fn bodies_above(tool: &ToolBody) -> Vec<(Code, Body)> {
    let stack = |pieces: &[Piece]| {
        let from = pieces.first()?.from;
        let segments: Vec<[f64; 3]> =
            pieces.iter().map(|piece| [piece.height, piece.lower, piece.upper]).collect();
        Some(Body::stack(from, &segments))
    };
    let is_below = !tool.undercuts.is_empty();
    // The neck above an undercut is its shank, and never as wide.
    let flutes = Body::above_flutes(&tool.cutter).filter(|_| !is_below);
    let flutes = flutes.map(|body| (Code::DeeperThanFlutes, body));
    // A shank no wider than the cutter touches only what is deeper than the edges.
    let wide = |piece: &Piece| piece.lower.max(piece.upper) > 2.0 * tool.cutter.radius();
    let shank = stack(&tool.shank).filter(|_| is_below || tool.shank.iter().any(wide));
    let shank = shank.map(|body| (Code::ShankInStock, body));
    let holder = stack(&tool.holder).map(|body| (Code::HolderInStock, body));
    holder.into_iter().chain(shank).chain(flutes).collect()
}

fn finish(
    mut report: Report,
    cut: Cut,
    problems: Problems,
    is_proved: bool,
    gathered: &Gathered<'_>,
) -> StockReport {
    let has_problems = problems.hits > 0 || report.counts.errors > 0;
    let is_proved = is_proved && report.verified();
    report.add(problems.diagnostics);
    let Cut { checked: Checked { stock, refined, .. }, hollow } = cut;
    let [removed_mm3, left_mm3] = hollow.unwrap_or_else(|| [stock.removed(), stock.left()]);
    let by_tag: BTreeMap<u32, Amount> = stock.removed_by_tag().into_iter().collect();
    let tools = gathered.order.iter().map(|number| {
        let (moves, lowest_mm) = gathered.counts[number];
        let mut removed_mm3 = by_tag.get(number).copied().unwrap_or_default();
        if hollow.is_some() {
            // The columns count what is hollow as removed.
            removed_mm3.least = 0.0;
        }
        ToolRemoved { number: *number, moves, removed_mm3, lowest_mm, time_s: None }
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
        is_hollow: hollow.is_some(),
        stock,
        report,
    }
}
