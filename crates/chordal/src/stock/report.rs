//! The result of a run on stock, as plain data.

use std::sync::OnceLock;

use chordal_diagnostics::Code;
use chordal_stock::mesh::SolidIntervals;
use chordal_stock::{ColumnStock, VolumeInterval};

use super::problems::StockProblem;
use super::removal::OtherSide;
use super::target::TargetReport;
use crate::report::Report;
use crate::time::ToolTime;

/// Whether the tip of every tool that comes near the part is known.
pub(super) fn knows_tips(report: &Report) -> bool {
    report.diagnostics.iter().all(|found| found.code != Code::TipNotKnown)
}

/// The verdict on a program on its stock.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StockVerdict {
    /// Nothing is touched that must not be, and that is proved.
    Clean,
    /// Something is touched, or the program has errors.
    Problems,
    /// No touch was found, but some cannot be excluded.
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
    /// Removed volume, mm³; material that two tools may have removed counts for the first of them.
    pub removed_mm3: VolumeInterval,
    /// The lowest height of its tip at feed, mm; infinite where it never cuts.
    pub lowest_mm: f64,
    /// True where its holder is given, and so was checked.
    pub has_holder: bool,
    /// Its time with its tool changes, s; `None` until [`StockReport::take_times`].
    pub time_s: Option<f64>,
}

/// The result of a run on stock on a mill.
#[derive(Debug)]
pub struct StockReport {
    /// The side of a column, mm.
    pub resolution_mm: f64,
    /// Number of parts of the stock that were cut again with finer columns, to decide whether the tool touches.
    pub refined: u64,
    /// Removed volume, mm³.
    pub removed_mm3: VolumeInterval,
    /// Volume that is left, mm³.
    pub left_mm3: VolumeInterval,
    /// The verdict.
    pub verdict: StockVerdict,
    /// Every touch, in the order of the run.
    pub problems: Vec<StockProblem>,
    /// Touches that are not in the list because there are too many.
    pub more_problems: u64,
    /// By tool, in the order of their first cut.
    pub tools: Vec<ToolRemoved>,
    /// What is left on the target part; `None` where none is given, or the part is cut in several orientations.
    pub target: Option<TargetReport>,
    /// Number of orientations in which the part is cut, one for each set of angles of its rotary axes. Where there
    /// are several, the columns of `stock` are those of the first, without what is cut from other sides.
    pub sides: usize,
    /// The columns of the other orientations.
    pub(super) others: Vec<OtherSide>,
    /// Computed on first use.
    pub(super) intervals: OnceLock<SolidIntervals>,
    /// The stock as it is left.
    pub stock: ColumnStock,
    /// The report of the run, with the problems as diagnostics among the others.
    pub report: Report,
}

impl StockReport {
    /// Adds the times of the tools from the planner.
    pub fn take_times(&mut self, times: &[ToolTime]) {
        for tool in &mut self.tools {
            let own = times.iter().find(|time| time.number == tool.number);
            tool.time_s = own.map(|time| time.times.total_s());
        }
    }
}
