//! What the passes of a run on stock share.

use std::collections::BTreeMap;

use chordal_command::{Origin, Units};
use chordal_stock::ColumnOptions;
use chordal_stock::columns::{JobResult, JobRunner, TileJob as Tile};

use super::gather::MoveBatch;
use super::problems::ContactReport;
use super::tools::{NoBody, ToolBody};
use crate::job::Job;

/// The options of a run on stock.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StockOptions {
    /// The side of a column, mm; `None` derives it from the size of the stock.
    pub resolution_mm: Option<f64>,
    /// Columns that are too coarse to decide whether a tool touches are halved, but not below this side, mm; `None`
    /// is an eighth of the resolution.
    pub finest_mm: Option<f64>,
    /// Touches that are no deeper than this are ignored, mm.
    pub tolerance_mm: f64,
    /// The most memory of the columns, bytes.
    pub budget: u64,
}

impl Default for StockOptions {
    /// Touches from 0.01 mm on, in a gibibyte.
    fn default() -> StockOptions {
        StockOptions { resolution_mm: None, finest_mm: None, tolerance_mm: 0.01, budget: 1 << 30 }
    }
}

/// The context that the passes of a run share.
pub(super) struct PassContext<'a> {
    pub job: &'a Job<'a>,
    pub options: StockOptions,
    pub resolution: f64,
    pub tools: &'a BTreeMap<u32, Result<ToolBody, NoBody>>,
    /// The batches of one orientation of the part.
    pub batches: Vec<&'a MoveBatch>,
    pub units: Units,
    /// Cuts tiles of columns.
    pub runner: &'a JobRunner<'a>,
}

impl<'a> PassContext<'a> {
    /// The options of columns that are cut.
    pub fn columns(&self) -> ColumnOptions {
        let own = ColumnOptions::new(self.resolution, self.options.budget);
        ColumnOptions { by_tag: true, middles: true, ..own }
    }

    pub fn finest(&self) -> f64 {
        self.options.finest_mm.unwrap_or(self.resolution / 8.0)
    }

    /// The body of a tool; there is one for every batch.
    pub fn tool(&self, number: u32) -> Option<&'a ToolBody> {
        self.tools.get(&number)?.as_ref().ok()
    }

    /// Runs the jobs on tiles; none of them once the run is interrupted, whose result is then discarded.
    pub fn tiles(&self, tiles: Vec<Tile<'_>>) -> Vec<JobResult> {
        if self.job.is_interrupted() {
            return Vec::new();
        }
        (self.runner)(tiles)
    }

    pub fn place(&self, origin: Origin, tool: u32) -> ContactReport<'_> {
        let (units, sources) = (self.units, self.job.sources());
        ContactReport { origin, tool, units, sources, is_aside: false, fixture: None }
    }
}
