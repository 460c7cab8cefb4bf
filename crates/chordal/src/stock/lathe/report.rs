//! What a run on turned stock answers, as plain data.

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
    /// mm³; one number but for threads.
    pub removed_mm3: VolumeInterval,
    /// The least radius and Z of its programmed point at feed, mm.
    pub lowest: Vec2,
    /// The greatest depth of cut, mm, and its line.
    pub deepest: (f64, u32),
    /// The largest chip area, mm², and its line.
    pub largest_chip: (f64, u32),
    /// The highest power, kW, and its line; `None` without a material. An estimate.
    pub power: Option<(f64, u32)>,
    /// Its time with changes, s, where the run was planned.
    pub time_s: Option<f64>,
}

/// A move at feed, and what it takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TurnedMove {
    /// Its block.
    pub origin: Origin,
    /// Its piece of path, by its number among all of the run.
    pub row: u32,
    /// The tool.
    pub tool: u32,
    /// A thread: what it takes is at most this.
    pub is_thread: bool,
    /// Programmed, mm/s; zero where none is known.
    pub feed_mm_per_s: f64,
    /// Revolutions by minute: of a feed per revolution the mean, else in the middle of the move.
    pub rpm: f64,
    /// Its length, mm.
    pub length_mm: f64,
    /// How far what goes extends along the feed, mm.
    pub engaged_mm: f64,
    /// The depth of cut: how far it extends across the feed, mm.
    pub depth_mm: f64,
    /// What goes of the half section, mm².
    pub area_mm2: f64,
    /// What goes of the body, mm³.
    pub removed_mm3: f64,
    /// The mean area of the chip, mm²: mean depth by feed of a revolution. `None` without a feed.
    pub chip_mm2: Option<f64>,
    /// The thickness of the chip, mm: feed of a revolution by the sine of the approach angle.
    pub chip_mm: Option<f64>,
    /// mm³/s.
    pub rate_mm3_per_s: f64,
    /// kW, an estimate; `None` without a material.
    pub power_kw: Option<f64>,
    /// A chip above the limit of the tool, or more power than the spindle has; the worse of the two.
    pub overload: Option<Code>,
}

/// A part that was cut off.
#[derive(Clone, Debug, PartialEq)]
pub struct CutOffPart {
    /// Its half section.
    pub section: Region,
    /// The line that cut it off.
    pub line: u32,
    /// The tool that did so.
    pub tool: u32,
}

/// A thread: it lies within the stock that is left, and takes at most what its grooves are all along.
#[derive(Clone, Debug, PartialEq)]
pub struct TurnedThread {
    /// Where its grooves are, all round.
    pub section: Region,
    /// The grooves themselves, in the plane where the spindle's index is; `None` where the revolutions of a pass are not known.
    pub grooves: Option<Region>,
    /// What it advances in one revolution, mm.
    pub lead_mm: Option<f64>,
    /// The line of its last pass.
    pub line: u32,
    /// The piece of path of its first pass.
    pub row: u32,
}

/// What is left on a part, and what is missing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TurnedTarget {
    /// Material outside of the part, mm³.
    pub left_over_mm3: f64,
    /// The largest distance of it from the part, mm.
    pub highest_mm: f64,
    /// Where that is: z and radius, mm.
    pub at: Vec2,
    /// What of the part is gone, mm³.
    pub gouged_mm3: f64,
}

/// The move that made a line or an arc of a section.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SegmentOrigin {
    /// Its tool.
    pub tool: u32,
    /// Its line.
    pub line: u32,
}

/// The answers of a run on turned stock.
#[derive(Debug)]
pub struct TurnedReport {
    /// Before the first cut, mm³.
    pub before_mm3: f64,
    /// What is removed, mm³: one number but for threads.
    pub removed_mm3: VolumeInterval,
    /// What is left, parted parts with it, mm³.
    pub left_mm3: VolumeInterval,
    /// How far the outline may be off the exact one, mm: 0 as a rule.
    pub bound_mm: f64,
    /// What can be said.
    pub verdict: StockVerdict,
    /// Every problem, in the order of the run.
    pub problems: Vec<StockProblem>,
    /// Problems that are not in the list, for there are too many.
    pub more_problems: u64,
    /// By tool, in the order of their first cut.
    pub tools: Vec<TurnedToolRemoved>,
    /// Every move at feed.
    pub moves: Vec<TurnedMove>,
    /// The stock before the first cut.
    pub before: Region,
    /// What is left in the chuck.
    pub section: Region,
    /// What was cut off, in that order.
    pub loose: Vec<CutOffPart>,
    /// Threads, which the section does not show.
    pub threads: Vec<TurnedThread>,
    /// The part as it should be, where one is given.
    pub target_section: Option<Region>,
    /// What is left on the part, where one is given.
    pub target: Option<TurnedTarget>,
    /// Every move that was followed, rapids too, by the tag of what it made, less one.
    pub makers: Vec<SegmentOrigin>,
    /// What a picture that goes forward and backward needs, where it was asked for.
    pub replay: Option<TurnedReplay>,
    /// The run, with the problems as diagnostics among the others.
    pub report: Report,
}

impl TurnedReport {
    /// Takes the times of the tools, as the planner has them.
    pub fn take_times(&mut self, times: &[ToolTime]) {
        for tool in &mut self.tools {
            let own = times.iter().find(|time| time.number == tool.number);
            tool.time_s = own.map(|time| time.times.total_s());
        }
    }

    /// The move that made a line or an arc of a section; `None` of the stock's own.
    pub fn made_by(&self, segment: &OutlineSegment) -> Option<SegmentOrigin> {
        self.makers.get((segment.tag as usize).checked_sub(1)?).copied()
    }

    /// Everything that is left: what is in the chuck, and what was cut off.
    pub fn sections(&self) -> impl Iterator<Item = &Region> {
        std::iter::once(&self.section).chain(self.loose.iter().map(|part| &part.section))
    }

    /// The same with the grooves of threads, in the plane where the spindle's index is: for pictures.
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
