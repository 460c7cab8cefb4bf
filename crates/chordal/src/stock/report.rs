//! What a run on stock answers, as plain data.

use std::sync::OnceLock;

use chordal_diagnostics::Code;
use chordal_stock::mesh::SolidIntervals;
use chordal_stock::{ColumnStock, VolumeInterval};

use super::problems::StockProblem;
use super::removal::OtherSide;
use super::target::TargetReport;
use crate::report::Report;
use crate::time::ToolTime;

/// The tip of every tool that comes near the part is known.
pub(super) fn knows_tips(report: &Report) -> bool {
    report.diagnostics.iter().all(|found| found.code != Code::TipNotKnown)
}

/// What can be said of a program on its stock.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StockVerdict {
    /// Nothing is touched that must not be, and that is proved.
    Clean,
    /// Something is touched, or the program has errors.
    Problems,
    /// No touch was found, and some cannot be excluded.
    NotProved,
}

impl StockVerdict {
    /// Its word in tables and JSON.
    pub const fn as_str(self) -> &'static str {
        match self {
            StockVerdict::Clean => "clean",
            StockVerdict::Problems => "problems",
            StockVerdict::NotProved => "not-proved",
        }
    }
}

/// What a tool has removed.
#[derive(Clone, Debug, PartialEq)]
pub struct ToolRemoved {
    /// Its number.
    pub number: u32,
    /// Moves at feed that were cut from the stock.
    pub moves: u64,
    /// mm³; the places that two tools may have removed are counted for the first of them.
    pub removed_mm3: VolumeInterval,
    /// The lowest place of its tip at feed, mm; infinite without one.
    pub lowest_mm: f64,
    /// Its holder is given, and was looked at.
    pub has_holder: bool,
    /// Its time with changes, s, where the run was planned: see [`StockReport::take_times`].
    pub time_s: Option<f64>,
}

/// The answers of a run on stock.
#[derive(Debug)]
pub struct StockReport {
    /// The side of a column, mm.
    pub resolution_mm: f64,
    /// Parts of the stock that were cut again with finer columns, to decide what touches.
    pub refined: u64,
    /// What is removed, mm³.
    pub removed_mm3: VolumeInterval,
    /// What is left, mm³.
    pub left_mm3: VolumeInterval,
    /// What can be said.
    pub verdict: StockVerdict,
    /// Every touch, in the order of the run.
    pub problems: Vec<StockProblem>,
    /// Touches that are not in the list, for there are too many.
    pub more_problems: u64,
    /// By tool, in the order of their first cut.
    pub tools: Vec<ToolRemoved>,
    /// What is left on the part, where one is given.
    pub target: Option<TargetReport>,
    /// Ways that the part lies on the cuts, one for each angle of its rotary axes. Of several the columns of
    /// `stock` are those of the first, without what is cut from other sides.
    pub sides: usize,
    /// The columns of the others.
    pub(super) others: Vec<OtherSide>,
    /// Found once they are asked for.
    pub(super) intervals: OnceLock<SolidIntervals>,
    /// The stock as it is left.
    pub stock: ColumnStock,
    /// The run, with the problems as diagnostics among the others.
    pub report: Report,
}

impl StockReport {
    /// Takes the times of the tools, as the planner has them.
    pub fn take_times(&mut self, times: &[ToolTime]) {
        for tool in &mut self.tools {
            let own = times.iter().find(|time| time.number == tool.number);
            tool.time_s = own.map(|time| time.times.total_s());
        }
    }
}
