//! The stock of a run: what is lowered when, as columns, then what is touched.

use chordal::Job;
use chordal::stock::mesh::Mesh;
use chordal::stock::{
    ColumnDrop, GapChange, ReplayOptions, ReplaySink, StockBefore, StockOptions, StockReport,
    StockRunError, VolumeInterval,
};
use serde_json::{Value, json};

use crate::answer;
use crate::engagement;
use crate::frame::Frame;
use crate::outbox::Outbox;
use crate::program::Programs;
use crate::run::Ran;
use crate::turned;
use crate::wanted::Wanted;

/// Columns of a stock where the page asks for no other number: as many as a page without a graphics card draws.
pub const USUAL_COLUMNS: u32 = 250_000;
/// The most that the page may ask for.
pub const MOST_COLUMNS: u32 = 1_000_000;
/// The fewest: coarser nothing is seen.
const LEAST_COLUMNS: u32 = 1_000;
/// Drops that are sent at most: a page keeps 19 bytes of each, and as much again of keyframes and of what is free.
const MOST_DROPS: usize = 6_000_000;
/// Where there would be more, columns may seem this share of their side too high for a while; where that is not
/// enough there are fewer columns.
const LAG: f64 = 0.5;
/// Triangles of the part at most, 36 bytes each.
const MOST_TRIANGLES: usize = 400_000;
/// Tops and undersides are joined that differ by no more than this share of a column: the next where it is too much.
const JOINED: [f64; 3] = [0.1, 0.5, 2.0];
/// Drops of a message, about: a page is busy with each without a break.
const BATCH: usize = 65_536;

/// What a stock is made of.
pub struct Cutting<'a> {
    /// The run whose moves cut it.
    pub ran: &'a Ran,
    /// About so many columns.
    pub columns: u32,
    /// The least number of drops that is too many.
    pub most_drops: usize,
}

impl<'a> Cutting<'a> {
    /// The stock of a run with about so many columns.
    pub fn new(ran: &'a Ran, columns: u32) -> Cutting<'a> {
        let columns = columns.clamp(LEAST_COLUMNS, MOST_COLUMNS);
        Cutting { ran, columns, most_drops: MOST_DROPS }
    }

    /// Sends the stock, what is lowered when, and then what is touched.
    pub fn run(&self, programs: &dyn Programs, out: &Outbox, wanted: &Wanted) {
        let job = self.ran.program.job().interrupt(wanted.interrupt());
        let run = self.ran.number;
        if job.turns() {
            return turned::run(&job, run, programs, out);
        }
        let files = |name: &str| programs.named_file(name);
        let failed = match self.replay(&job, &files, out, wanted) {
            Ok(true) => match job.stock(&StockOptions::default(), &files) {
                Ok(found) => {
                    out.json(&told(run, &found, &job));
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

    /// Sends how hard the cuts are. Whatever keeps it from that was said of the stock.
    fn engagement(&self, job: &Job, files: &dyn Fn(&str) -> Result<Vec<u8>, String>, out: &Outbox) {
        if self.ran.rows > engagement::MOST_ROWS {
            return;
        }
        if let Ok(found) = job.engagement(&engagement::options(), files) {
            out.binary(engagement::frame(self.ran.number, &found));
        }
    }

    /// Whether all of it was sent.
    fn replay(
        &self,
        job: &Job,
        files: &dyn Fn(&str) -> Result<Vec<u8>, String>,
        out: &Outbox,
        wanted: &Wanted,
    ) -> Result<bool, StockRunError> {
        let mut options = ReplayOptions { columns: self.columns, lag: 0.0 };
        loop {
            let mut sending = Sending {
                run: self.ran.number,
                out,
                wanted,
                is_coarser: options.columns < self.columns,
                is_late: options.lag > 0.0,
                most: self.most_drops,
                sent: 0,
                lot: Lot::default(),
            };
            if job.replay_stock(&options, files, &mut sending)?.is_some() {
                sending.send(1.0);
                return Ok(wanted.is_wanted());
            }
            if !wanted.is_wanted() || options.columns <= LEAST_COLUMNS {
                return Ok(false);
            }
            if options.lag > 0.0 {
                options.columns = (options.columns / 2).max(LEAST_COLUMNS);
            }
            options.lag = LAG;
        }
    }
}

/// What is left, and what is touched; with the problems of the run, as they are listed together.
fn told(run: u64, found: &StockReport, job: &Job) -> Value {
    let between = |amount: VolumeInterval| json!({ "least": amount.least, "most": amount.most });
    let mut told = answer::report(&found.report, job);
    told["type"] = json!("stock_report");
    told["run"] = json!(run);
    told["verdict"] = json!(found.verdict.as_str());
    told["resolution_mm"] = json!(found.resolution_mm);
    told["removed_mm3"] = between(found.removed_mm3);
    told["left_mm3"] = between(found.left_mm3);
    told
}

/// Sends what is left at the end as triangles: heights alone do not say it.
fn part(run: u64, found: &StockReport, out: &Outbox) {
    let is_too_much = |mesh: &Mesh| mesh.triangles().len() > MOST_TRIANGLES;
    let mesh = JOINED.iter().find_map(|share| {
        let surface = found.surface(share * found.resolution_mm).ok()?;
        (!is_too_much(&surface.mesh)).then_some(surface.mesh)
    });
    let Some(mesh) = mesh else { return };
    let corners = (0..mesh.triangles().len()).flat_map(|at| mesh.corners(at));
    let corners: Vec<f32> = corners.flat_map(|at| at.to_array().map(|mm| mm as f32)).collect();
    let mut frame = Frame::default();
    frame.column("corners", &corners);
    out.binary(frame.finish(json!({ "type": "stock_part", "run": run })));
}

/// Drops on their way.
#[derive(Default)]
struct Lot {
    column: Vec<u32>,
    row: Vec<u32>,
    share: Vec<f32>,
    height: Vec<f32>,
}

struct Sending<'a> {
    run: u64,
    out: &'a Outbox,
    wanted: &'a Wanted,
    /// It was begun with more columns, which had too many drops.
    is_coarser: bool,
    /// Some drops are left out.
    is_late: bool,
    most: usize,
    sent: usize,
    lot: Lot,
}

impl Sending<'_> {
    fn send(&mut self, progress: f64) {
        let Lot { column, row, share, height } = std::mem::take(&mut self.lot);
        let mut frame = Frame::default();
        frame.column("column", &column);
        frame.column("row", &row);
        frame.column("share", &share);
        frame.column("height", &height);
        let header = json!({ "type": "stock_drops", "run": self.run, "progress": progress });
        self.out.binary(frame.finish(header));
    }
}

impl ReplaySink for Sending<'_> {
    fn before(&mut self, stock: &StockBefore) {
        let mut frame = Frame::default();
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
        if self.sent > self.most || !self.wanted.is_wanted() {
            return false;
        }
        for drop in drops {
            self.lot.column.push(drop.column);
            self.lot.row.push(drop.row);
            self.lot.share.push(drop.share);
            self.lot.height.push(drop.height);
            if self.lot.column.len() >= BATCH {
                // What is left of these moves is still to come.
                self.send(progress.min(BEFORE_THE_END));
            }
        }
        true
    }

    fn gaps(&mut self, changes: &[GapChange]) -> bool {
        self.sent += changes.len();
        if self.sent > self.most || !self.wanted.is_wanted() {
            return false;
        }
        for some in changes.chunks(BATCH) {
            let mut frame = Frame::default();
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
const BEFORE_THE_END: f64 = 0.999;
