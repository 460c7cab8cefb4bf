//! The stock of a run: what is lowered when, as columns, then what is touched.

use chordal::Job;
use chordal::stock::mesh::Mesh;
use chordal::stock::{
    ColumnDrop, GapChange, ReplayOptions, ReplaySink, StockBefore, StockOptions, StockReport,
    StockRunError, VolumeInterval,
};
use serde_json::{Value, json};

use crate::answer;
use crate::cancel_token::CancelToken;
use crate::engagement;
use crate::frame::ColumnFrame;
use crate::outbox::PageOutbox;
use crate::program::ProgramSource;
use crate::run::FinishedRun;
use crate::turned_stock;

/// Columns of a stock where the page asks for no other number: as many as a page without a graphics card draws.
pub const DEFAULT_COLUMNS: u32 = 250_000;
/// The most that the page may ask for.
pub const MAX_COLUMNS: u32 = 1_000_000;
/// The fewest: coarser nothing is seen.
const MIN_COLUMNS: u32 = 1_000;
/// Drops that are sent at most: a page keeps 19 bytes of each, and as much again of keyframes and of what is free.
const MAX_DROPS: usize = 6_000_000;
/// Where there would be more, columns may seem this share of their side too high for a while; where that is not
/// enough there are fewer columns.
const LAG_SHARE: f64 = 0.5;
/// Triangles of the part at most, 36 bytes each.
const MAX_TRIANGLES: usize = 400_000;
/// Tops and undersides are joined that differ by no more than this share of a column: the next where it is too much.
const JOIN_SHARES: [f64; 3] = [0.1, 0.5, 2.0];
/// Drops of a message, about: a page is busy with each without a break.
const BATCH_DROPS: usize = 65_536;

/// What a stock is made of.
pub struct StockCutting<'a> {
    /// The run whose moves cut it.
    pub finished: &'a FinishedRun,
    /// About so many columns.
    pub columns: u32,
    /// The least number of drops that is too many.
    pub most_drops: usize,
}

impl<'a> StockCutting<'a> {
    /// The stock of a run with about so many columns.
    pub fn new(finished: &'a FinishedRun, columns: u32) -> StockCutting<'a> {
        let columns = columns.clamp(MIN_COLUMNS, MAX_COLUMNS);
        StockCutting { finished, columns, most_drops: MAX_DROPS }
    }

    /// Sends the stock, what is lowered when, and then what is touched.
    pub fn run(&self, programs: &dyn ProgramSource, out: &PageOutbox, cancel: &CancelToken) {
        let job = self.finished.program.job().interrupt(cancel.interrupt());
        let run = self.finished.number;
        if job.turns() {
            return turned_stock::run(&job, run, programs, out);
        }
        let files = |name: &str| programs.named_file(name);
        let failed = match self.replay(&job, &files, out, cancel) {
            Ok(true) => match job.stock(&StockOptions::default(), &files) {
                Ok(found) => {
                    out.json(&report_json(run, &found, &job));
                    if found.has_undersides() {
                        part(run, &found, out);
                    }
                    return self.engagement(&job, &files, out);
                }
                Err(StockRunError::Interrupted) => return,
                Err(error) => error,
            },
            Ok(false) => return,
            Err(error) => error,
        };
        out.json(&answer::no_stock(run, &failed));
    }

    /// Sends the cutting loads. An error here was reported for the stock already.
    fn engagement(
        &self,
        job: &Job,
        files: &dyn Fn(&str) -> Result<Vec<u8>, String>,
        out: &PageOutbox,
    ) {
        if self.finished.rows > engagement::MAX_ROWS {
            return;
        }
        if let Ok(found) = job.engagement(&engagement::options(), files) {
            out.binary(engagement::frame(self.finished.number, &found));
        }
    }

    /// Sends the stock and its drops; false if the run was canceled or there were too many drops.
    fn replay(
        &self,
        job: &Job,
        files: &dyn Fn(&str) -> Result<Vec<u8>, String>,
        out: &PageOutbox,
        cancel: &CancelToken,
    ) -> Result<bool, StockRunError> {
        let mut options = ReplayOptions { columns: self.columns, lag: 0.0 };
        loop {
            let mut sending = StockSender {
                run: self.finished.number,
                out,
                cancel,
                is_coarser: options.columns < self.columns,
                is_late: options.lag > 0.0,
                most: self.most_drops,
                sent: 0,
                lot: DropBatch::default(),
            };
            if job.replay_stock(&options, files, &mut sending)?.is_some() {
                sending.send(1.0);
                return Ok(cancel.is_current());
            }
            if !cancel.is_current() || options.columns <= MIN_COLUMNS {
                return Ok(false);
            }
            if options.lag > 0.0 {
                options.columns = (options.columns / 2).max(MIN_COLUMNS);
            }
            options.lag = LAG_SHARE;
        }
    }
}

/// What is left, and what is touched; with the problems of the run, as they are listed together.
fn report_json(run: u64, found: &StockReport, job: &Job) -> Value {
    let between = |amount: VolumeInterval| json!({ "least": amount.least, "most": amount.most });
    let mut message = answer::report(&found.report, job);
    message["type"] = json!("stock_report");
    message["run"] = json!(run);
    message["verdict"] = json!(found.verdict.as_str());
    message["resolution_mm"] = json!(found.resolution_mm);
    message["removed_mm3"] = between(found.removed_mm3);
    message["left_mm3"] = between(found.left_mm3);
    message
}

/// Sends what is left at the end as triangles: heights alone do not say it.
fn part(run: u64, found: &StockReport, out: &PageOutbox) {
    let is_too_much = |mesh: &Mesh| mesh.triangles().len() > MAX_TRIANGLES;
    let mesh = JOIN_SHARES.iter().find_map(|share| {
        let surface = found.surface(share * found.resolution_mm).ok()?;
        (!is_too_much(&surface.mesh)).then_some(surface.mesh)
    });
    let Some(mesh) = mesh else { return };
    let corners = (0..mesh.triangles().len()).flat_map(|at| mesh.corners(at));
    let corners: Vec<f32> = corners.flat_map(|at| at.to_array().map(|mm| mm as f32)).collect();
    let mut frame = ColumnFrame::default();
    frame.column("corners", &corners);
    out.binary(frame.finish(json!({ "type": "stock_part", "run": run })));
}

/// Columns of drops that are not sent yet.
#[derive(Default)]
struct DropBatch {
    column: Vec<u32>,
    row: Vec<u32>,
    share: Vec<f32>,
    height: Vec<f32>,
}

struct StockSender<'a> {
    run: u64,
    out: &'a PageOutbox,
    cancel: &'a CancelToken,
    /// It was begun with more columns, which had too many drops.
    is_coarser: bool,
    /// Some drops are sent late: `LAG_SHARE`.
    is_late: bool,
    most: usize,
    sent: usize,
    lot: DropBatch,
}

impl StockSender<'_> {
    fn send(&mut self, progress: f64) {
        let DropBatch { column, row, share, height } = std::mem::take(&mut self.lot);
        let mut frame = ColumnFrame::default();
        frame.column("column", &column);
        frame.column("row", &row);
        frame.column("share", &share);
        frame.column("height", &height);
        let header = json!({ "type": "stock_drops", "run": self.run, "progress": progress });
        self.out.binary(frame.finish(header));
    }
}

impl ReplaySink for StockSender<'_> {
    fn before(&mut self, stock: &StockBefore) {
        let mut frame = ColumnFrame::default();
        frame.column("heights", &stock.heights);
        let mut header = json!({
            "type": "stock",
            "run": self.run,
            "low": stock.low,
            "high": stock.high,
            "resolution_mm": stock.resolution_mm,
            "cells": stock.columns,
            "coarser": self.is_coarser,
            "late": self.is_late,
            "undercuts": stock.missing.undercuts,
            "turned": stock.missing.turned,
        });
        let names = stock.fixtures.iter().map(|fixture| fixture.name.as_str());
        header["fixtures"] = names.collect();
        // One after the other: the picture is of all of them.
        let corners: Vec<f32> =
            stock.fixtures.iter().flat_map(|fixture| fixture.corners.iter().copied()).collect();
        frame.column("fixtures", &corners);
        if let Some((heights, tolerance_mm)) = &stock.target {
            frame.column("target", heights);
            header["tolerance_mm"] = json!(tolerance_mm);
        }
        self.out.binary(frame.finish(header));
    }

    fn lowered(&mut self, drops: &[ColumnDrop], progress: f64) -> bool {
        self.sent += drops.len();
        if self.sent > self.most || !self.cancel.is_current() {
            return false;
        }
        for drop in drops {
            self.lot.column.push(drop.column);
            self.lot.row.push(drop.row);
            self.lot.share.push(drop.share);
            self.lot.height.push(drop.height);
            if self.lot.column.len() >= BATCH_DROPS {
                // What is left of these moves is still to come.
                self.send(progress.min(INCOMPLETE_PROGRESS));
            }
        }
        true
    }

    fn gaps(&mut self, changes: &[GapChange]) -> bool {
        self.sent += changes.len();
        if self.sent > self.most || !self.cancel.is_current() {
            return false;
        }
        for some in changes.chunks(BATCH_DROPS) {
            let mut frame = ColumnFrame::default();
            let of = |number: fn(&GapChange) -> u32| some.iter().map(number).collect::<Vec<u32>>();
            frame.column("column", &of(|change| change.column));
            frame.column("row", &of(|change| change.row));
            frame.column("count", &of(|change| change.gaps.len() as u32));
            let share: Vec<f32> = some.iter().map(|change| change.share).collect();
            frame.column("share", &share);
            // Floor and top of each gap, of one column after the other.
            let gaps = some.iter().flat_map(|change| change.gaps.iter().flatten());
            frame.column("gaps", &gaps.copied().collect::<Vec<f32>>());
            self.out.binary(frame.finish(json!({ "type": "stock_gaps", "run": self.run })));
        }
        true
    }
}

/// The progress of what is not complete.
const INCOMPLETE_PROGRESS: f64 = 0.999;
