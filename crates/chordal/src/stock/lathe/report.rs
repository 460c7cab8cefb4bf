//! The result of a run on turned stock, as plain data.

use chordal_command::Origin;
use chordal_diagnostics::Code;
use chordal_geometry::Vec2;
use chordal_stock::VolumeInterval;
use chordal_stock::lathe::{OutlineSegment, Region};

use super::super::problems::StockProblem;
use super::super::report::StockVerdict;
use super::replay::TurnedReplay;
use crate::report::Report;
use crate::time::ToolTime;

/// What a tool has removed.
#[derive(Clone, Debug, PartialEq)]
pub struct TurnedToolRemoved {
    /// Its number.
    pub number: u32,
    /// Moves at feed that were cut from the stock.
    pub moves: u64,
    /// Removed volume, mm³: exact except for threads.
    pub removed_mm3: VolumeInterval,
    /// The least radius and Z of its programmed point at feed, mm.
    pub lowest: Vec2,
    /// The greatest depth of cut, mm, and its line.
    pub deepest: (f64, u32),
    /// The largest chip area, mm², and its line.
    pub largest_chip: (f64, u32),
    /// The highest power, kW, and its line; `None` without a material. An estimate.
    pub power: Option<(f64, u32)>,
    /// Its time with its tool changes, s; `None` until [`TurnedReport::take_times`].
    pub time_s: Option<f64>,
}

/// A move at feed, and what it removes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TurnedMove {
    /// Its block.
    pub origin: Origin,
    /// The index of its path segment among all of the run.
    pub row: u32,
    /// Number of the tool.
    pub tool: u32,
    /// True for a thread, whose volume is an upper bound.
    pub is_thread: bool,
    /// Programmed feed, mm/s; zero where none is known.
    pub feed_mm_per_s: f64,
    /// Spindle speed, rev/min: the mean for a feed per revolution, otherwise that in the middle of the move.
    pub rpm: f64,
    /// Its length, mm.
    pub length_mm: f64,
    /// Extent of the removed material along the feed, mm.
    pub engaged_mm: f64,
    /// Depth of cut: extent of the removed material across the feed, mm.
    pub depth_mm: f64,
    /// Area removed from the half section, mm².
    pub area_mm2: f64,
    /// Removed volume, mm³.
    pub removed_mm3: f64,
    /// Mean chip area, mm²: mean depth times feed per revolution. `None` without a feed or spindle speed, and for
    /// threads.
    pub chip_mm2: Option<f64>,
    /// Chip thickness, mm: feed per revolution times the sine of the approach angle. `None` as for `chip_mm2`.
    pub chip_mm: Option<f64>,
    /// Removal rate, mm³/s; zero for threads.
    pub rate_mm3_per_s: f64,
    /// Estimated power, kW; `None` without a material.
    pub power_kw: Option<f64>,
    /// The limit that it exceeds: the chip thickness of the tool or the power of the spindle (the latter where both
    /// are); `None` where it keeps both.
    pub overload: Option<Code>,
}

/// A part that was cut off.
#[derive(Clone, Debug, PartialEq)]
pub struct CutOffPart {
    /// Its half section.
    pub section: Region,
    /// The line that cut it off.
    pub line: u32,
    /// The number of the tool that cut it off.
    pub tool: u32,
}

/// A thread. It is not cut from the stock that is left; its grooves give an upper bound of what it removes.
#[derive(Clone, Debug, PartialEq)]
pub struct TurnedThread {
    /// The section that its passes touch anywhere around the part.
    pub section: Region,
    /// The grooves in the plane of the spindle's index; `None` where the revolutions of a pass are not known.
    pub grooves: Option<Region>,
    /// Its lead along the path, mm; `None` where it is not known or changes.
    pub lead_mm: Option<f64>,
    /// The line of its last pass.
    pub line: u32,
    /// The index of the path segment of its first pass.
    pub row: u32,
}

/// What is left on the target part, and what is missing from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TurnedTarget {
    /// Volume of material outside the part, mm³.
    pub left_over_mm3: f64,
    /// Largest distance of that material from the part, mm.
    pub highest_mm: f64,
    /// The place of that distance: z and radius, mm.
    pub at: Vec2,
    /// Volume that is missing from the part, mm³.
    pub gouged_mm3: f64,
}

/// The move that made a line or an arc of a section.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SegmentOrigin {
    /// Number of its tool.
    pub tool: u32,
    /// Its line.
    pub line: u32,
}

/// The result of a run on turned stock.
#[derive(Debug)]
pub struct TurnedReport {
    /// Volume before the first cut, mm³.
    pub before_mm3: f64,
    /// Removed volume, mm³: exact except for threads.
    pub removed_mm3: VolumeInterval,
    /// Volume that is left, mm³, with parts that were cut off.
    pub left_mm3: VolumeInterval,
    /// Bound of the outline's deviation from the exact one, mm: usually 0.
    pub bound_mm: f64,
    /// The verdict.
    pub verdict: StockVerdict,
    /// Every problem, in the order of the run.
    pub problems: Vec<StockProblem>,
    /// Problems that are not in the list because there are too many.
    pub more_problems: u64,
    /// The results by tool, in the order of first cuts.
    pub tools: Vec<TurnedToolRemoved>,
    /// Every move at feed.
    pub moves: Vec<TurnedMove>,
    /// The stock before the first cut.
    pub before: Region,
    /// What is left in the chuck.
    pub section: Region,
    /// The parts that were cut off, in order.
    pub loose: Vec<CutOffPart>,
    /// Threads, which the section does not show.
    pub threads: Vec<TurnedThread>,
    /// The target part; `None` where none is given.
    pub target_section: Option<Region>,
    /// What is left on the target part; `None` where none is given.
    pub target: Option<TurnedTarget>,
    /// Every move that was simulated, rapids included; its index is the tag of the segments it made, less one.
    pub makers: Vec<SegmentOrigin>,
    /// The sections after every pass; `None` where they were not requested.
    pub replay: Option<TurnedReplay>,
    /// The report of the run, with the problems as diagnostics among the others.
    pub report: Report,
}

impl TurnedReport {
    /// Adds the times of the tools from the planner.
    pub fn take_times(&mut self, times: &[ToolTime]) {
        for tool in &mut self.tools {
            let own = times.iter().find(|time| time.number == tool.number);
            tool.time_s = own.map(|time| time.times.total_s());
        }
    }

    /// The move that made a line or an arc of a section; `None` for those of the stock before the first cut.
    pub fn made_by(&self, segment: &OutlineSegment) -> Option<SegmentOrigin> {
        self.makers.get((segment.tag as usize).checked_sub(1)?).copied()
    }

    /// All sections that are left: what is in the chuck, and the parts that were cut off.
    pub fn sections(&self) -> impl Iterator<Item = &Region> {
        std::iter::once(&self.section).chain(self.loose.iter().map(|part| &part.section))
    }

    /// The same with the grooves of threads in the plane of the spindle's index, for pictures.
    pub fn threaded_sections(&self) -> Vec<Region> {
        let grooves = || self.threads.iter().filter_map(|thread| thread.grooves.as_ref());
        let cut = |section: &Region| {
            grooves().fold(section.clone(), |left, grooves| match left.difference(grooves) {
                Ok(cut) => cut.region,
                Err(_) => left,
            })
        };
        self.sections().map(cut).collect()
    }
}
