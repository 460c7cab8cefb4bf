//! The stock of a run: when each column of it is lowered, then the collisions.

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

/// The default number of columns of a stock: as many as a page can draw without a graphics card.
pub const DEFAULT_COLUMNS: u32 = 250_000;
/// The most columns that the page may request.
pub const MAX_COLUMNS: u32 = 1_000_000;
/// The fewest columns: with fewer, nothing would be recognizable.
const MIN_COLUMNS: u32 = 1_000;
/// The most drops that are sent: a page stores 19 bytes for each, and as much again for keyframes and spare capacity.
const MAX_DROPS: usize = 6_000_000;
/// When there would be more drops, columns may temporarily be too high by this fraction of their side; when that is
/// not enough, the number of columns is reduced.
const LAG_SHARE: f64 = 0.5;
/// The most triangles of the part, 36 bytes each.
const MAX_TRIANGLES: usize = 400_000;
/// Tops and undersides that differ by at most this fraction of a column are joined. The next value is tried when the
/// mesh has too many triangles.
const JOIN_SHARES: [f64; 3] = [0.1, 0.5, 2.0];
/// The approximate number of drops in a message, limited because a page processes each message without interruption.
const BATCH_DROPS: usize = 65_536;

/// The task of cutting the stock with a run.
pub struct StockCutting<'a> {
    /// The run whose moves cut it.
    pub finished: &'a FinishedRun,
    /// The approximate number of columns.
    pub columns: u32,
    /// The most drops.
    pub most_drops: usize,
}

impl<'a> StockCutting<'a> {
    /// Cuts the stock of a run with about this number of columns.
    pub fn new(finished: &'a FinishedRun, columns: u32) -> StockCutting<'a> {
        let columns = columns.clamp(MIN_COLUMNS, MAX_COLUMNS);
        StockCutting { finished, columns, most_drops: MAX_DROPS }
    }

    /// Sends the stock, the drops of its columns, and then the collisions.
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

    /// Sends the cutting loads. An error here was already reported for the stock.
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

    /// Sends the stock and its drops; `false` when the run was canceled or there were too many drops.
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

/// The remaining stock and the collisions, together with the problems of the run, because the page lists all in one
/// list.
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

/// Sends the finished part as triangles, because heights alone cannot describe its undersides.
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

/// Drops that are not sent yet, as columns.
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
    /// An earlier attempt with more columns had too many drops.
    is_coarser: bool,
    /// Some drops are sent late (see [`LAG_SHARE`]).
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
        // The triangles of all fixtures are concatenated, because they are drawn together.
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
                // More drops of these moves follow, so the progress is not complete.
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
            // The floor and the top of each gap, column by column.
            let gaps = some.iter().flat_map(|change| change.gaps.iter().flatten());
            frame.column("gaps", &gaps.copied().collect::<Vec<f32>>());
            self.out.binary(frame.finish(json!({ "type": "stock_gaps", "run": self.run })));
        }
        true
    }
}

/// The largest progress of an incomplete replay.
const INCOMPLETE_PROGRESS: f64 = 0.999;
