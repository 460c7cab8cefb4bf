//! What a program leaves of its stock, on a mill or on a lathe.

use chordal_stock::VolumeInterval;
use chordal_stock::columns::JobRunner;

use super::lathe::{TurnedOptions, TurnedReport};
use super::pass::StockOptions;
use super::report::{StockReport, StockVerdict};
use super::run::StockRunError;
use super::setup::SetupFileReader;
use crate::job::Job;
use crate::report::Report;
use crate::time::ToolTime;

/// The result of a run on stock.
#[derive(Debug)]
pub enum StockLeft {
    /// On a mill: between bounds.
    Columns(Box<StockReport>),
    /// On a lathe: exact.
    Section(Box<TurnedReport>),
}

/// What a tool removes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolRemoves {
    /// Its number.
    pub number: u32,
    /// Removed volume, mm³.
    pub removed_mm3: VolumeInterval,
    /// The lowest height of its tip at feed, mm (on a lathe its least Z); `None` where it never cuts.
    pub lowest_mm: Option<f64>,
}

impl Job<'_> {
    /// Runs the program on the stock of its machine's setup: as [`Job::stock_by`], or on a lathe as
    /// [`Job::turned_stock`].
    ///
    /// # Errors As those of the two.
    pub fn stock_left(
        &self,
        options: &StockOptions,
        files: SetupFileReader<'_>,
        runner: &JobRunner<'_>,
    ) -> Result<StockLeft, StockRunError> {
        if self.turns() {
            let options = TurnedOptions { tolerance_mm: options.tolerance_mm, replay: false };
            return Ok(StockLeft::Section(Box::new(self.turned_stock(&options, files)?)));
        }
        Ok(StockLeft::Columns(Box::new(self.stock_by(options, files, runner)?)))
    }
}

impl StockLeft {
    /// The report of the run, with the problems of the stock among the others.
    pub fn report(&self) -> &Report {
        match self {
            StockLeft::Columns(found) => &found.report,
            StockLeft::Section(found) => &found.report,
        }
    }

    /// The verdict.
    pub fn verdict(&self) -> StockVerdict {
        match self {
            StockLeft::Columns(found) => found.verdict,
            StockLeft::Section(found) => found.verdict,
        }
    }

    /// Whether it is proved that nothing is touched that must not be.
    pub fn is_clean(&self) -> bool {
        self.verdict() == StockVerdict::Clean
    }

    /// How many problems there are.
    pub fn problems(&self) -> u64 {
        match self {
            StockLeft::Columns(found) => found.problems.len() as u64 + found.more_problems,
            StockLeft::Section(found) => found.problems.len() as u64 + found.more_problems,
        }
    }

    /// The volumes that are removed and that are left, mm³.
    pub fn volumes_mm3(&self) -> [VolumeInterval; 2] {
        match self {
            StockLeft::Columns(found) => [found.removed_mm3, found.left_mm3],
            StockLeft::Section(found) => [found.removed_mm3, found.left_mm3],
        }
    }

    /// The side of a column, mm; `None` where the stock is exact.
    pub fn resolution_mm(&self) -> Option<f64> {
        match self {
            StockLeft::Columns(found) => Some(found.resolution_mm),
            StockLeft::Section(_) => None,
        }
    }

    /// The results by tool, in the order of first cuts.
    pub fn tools(&self) -> Vec<ToolRemoves> {
        match self {
            StockLeft::Columns(found) => {
                let of = |tool: &super::ToolRemoved| ToolRemoves {
                    number: tool.number,
                    removed_mm3: tool.removed_mm3,
                    lowest_mm: tool.lowest_mm.is_finite().then_some(tool.lowest_mm),
                };
                found.tools.iter().map(of).collect()
            }
            StockLeft::Section(found) => {
                let of = |tool: &super::TurnedToolRemoved| ToolRemoves {
                    number: tool.number,
                    removed_mm3: tool.removed_mm3,
                    lowest_mm: tool.lowest.a.is_finite().then_some(tool.lowest.a),
                };
                found.tools.iter().map(of).collect()
            }
        }
    }

    /// Adds the times of the tools from the planner.
    pub fn take_times(&mut self, times: &[ToolTime]) {
        match self {
            StockLeft::Columns(found) => found.take_times(times),
            StockLeft::Section(found) => found.take_times(times),
        }
    }
}
