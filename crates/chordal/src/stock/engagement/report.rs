//! What a run with engagement answers, as plain data.

use std::collections::BTreeMap;

use chordal_command::{Origin, Units};
use chordal_diagnostics::Code;
use chordal_stock::ColumnStock;
use chordal_stock::engagement::BoundedValue;

use super::materials::{MaterialData, NoMaterial};
use super::typical::TimeWeightedValues;
use crate::report::Report;

/// The thickness of chips, mm.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ChipThickness {
    /// The thickest one.
    pub peak_mm: BoundedValue,
    /// The mean at that place of the move where the cut is hardest, by the middle heights of columns.
    pub mean_mm: f64,
}

/// Power and torque, estimated: see [`POWER_SHARE`](super::POWER_SHARE).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CuttingLoad {
    /// kW.
    pub power_kw: f64,
    /// N·m.
    pub torque_nm: f64,
}

/// How hard a move is, at its worst place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MoveEngagement {
    /// Its block.
    pub origin: Origin,
    /// The tool.
    pub tool: u32,
    /// Its number among all pieces of path of the run.
    pub row: u32,
    /// Programmed, mm/s; zero where none is known.
    pub feed_mm_per_s: f64,
    /// Of the spindle, revolutions per minute; zero where it stands.
    pub rpm: f64,
    /// Its F is by time and its own: no thread, tap, cycle or time of a block.
    pub by_time: bool,
    /// The tip goes down somewhere on it: a plunge, a ramp, a helix.
    pub falls: bool,
    /// Its length, mm.
    pub length_mm: f64,
    /// How long the tool may be in material on it, mm.
    pub engaged_mm: f64,
    /// Radial depth of cut, mm: from the first to the last engaged place across the feed.
    pub across_mm: BoundedValue,
    /// Axial depth of cut, mm.
    pub axial_mm: BoundedValue,
    /// Angle of engagement, rad.
    pub angle_rad: BoundedValue,
    /// The thickest chip as a share of the feed of a tooth.
    pub facing: BoundedValue,
    /// The chip; `None` without teeth, feed or spindle speed.
    pub chip: Option<ChipThickness>,
    /// What it removes, mm³, by the middle heights of columns.
    pub removed_mm3: f64,
    /// At its worst place, mm³/s, by the middle heights of columns.
    pub rate_mm3_per_s: f64,
    /// The same at most.
    pub most_rate_mm3_per_s: f64,
    /// `None` without a material or a chip.
    pub effort: Option<CuttingLoad>,
    /// What is too much or too little on it.
    pub problem: Option<Code>,
}

impl MoveEngagement {
    /// Feed of a tooth, mm; `None` where feed or speed are not known.
    pub fn feed_per_tooth(&self, teeth: u32) -> Option<f64> {
        let by_tooth = self.feed_mm_per_s * 60.0 / (self.rpm * f64::from(teeth));
        (by_tooth > 0.0 && by_tooth.is_finite()).then_some(by_tooth)
    }

    /// How long it takes at its feed, s.
    pub fn seconds(&self) -> f64 {
        if self.feed_mm_per_s > 0.0 { self.length_mm / self.feed_mm_per_s } else { 0.0 }
    }
}

/// The most of a number, where it is, and what it is for half of the time in material.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LoadPeak {
    /// The most.
    pub peak: f64,
    /// The line of that.
    pub line: u32,
    /// The median by time.
    pub typical: f64,
}

/// How hard a tool works.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ToolEngagement {
    /// Its number.
    pub number: u32,
    /// Teeth, where they are known.
    pub teeth: Option<u32>,
    /// Moves at feed.
    pub moves: u64,
    /// Time in material at the programmed feeds, s.
    pub engaged_s: f64,
    /// What it removes, mm³, by the middle heights of columns.
    pub removed_mm3: f64,
    /// At most, mm.
    pub across_mm: LoadPeak,
    /// At most, mm.
    pub axial_mm: LoadPeak,
    /// The thickest chip, at most, mm.
    pub chip_mm: Option<LoadPeak>,
    /// The thickest chip that it has for half a second or longer in all, at most, mm.
    pub lasting_chip_mm: Option<f64>,
    /// mm³/s.
    pub rate_mm3_per_s: LoadPeak,
    /// kW.
    pub power_kw: Option<LoadPeak>,
    /// N·m.
    pub torque_nm: Option<LoadPeak>,
}

/// A block that is too much for a tool or the spindle, or too little to cut.
#[derive(Clone, Debug, PartialEq)]
pub struct EngagementProblem {
    /// What it is.
    pub code: Code,
    /// The file of the block.
    pub file: String,
    /// Its line, from 1.
    pub line: u32,
    /// The tool.
    pub tool: u32,
    /// The chip in mm, at least and at most; or the power in kW, with the share that its estimate may be off.
    pub value: BoundedValue,
    /// What is allowed: mm, or kW.
    pub limit: f64,
}

/// The answers of a run with engagement.
#[derive(Debug)]
pub struct EngagementReport {
    /// The side of a column, mm.
    pub resolution_mm: f64,
    /// What the setup says of the stock's material.
    pub material_word: Option<String>,
    /// The material of that word.
    pub material: Option<MaterialData>,
    /// Why there is none.
    pub no_material: Option<NoMaterial>,
    /// The power of the spindle, kW, where it is given.
    pub spindle_kw: Option<f64>,
    /// Units of the program.
    pub units: Units,
    /// Every move at feed, in the order of the run.
    pub moves: Vec<MoveEngagement>,
    /// By tool, in the order of their first cut.
    pub tools: Vec<ToolEngagement>,
    /// What is too much or too little, in the order of the run.
    pub problems: Vec<EngagementProblem>,
    /// Problems that are not in the list.
    pub more_problems: u64,
    /// Every cut was made: each tool has a shape, each place is known.
    pub is_whole: bool,
    /// Tools with undercuts: they cut, and what they engage is not measured.
    pub not_measured: Vec<u32>,
    /// The stock as it is left.
    pub stock: ColumnStock,
    /// The run, with the problems as diagnostics among the others.
    pub report: Report,
}

/// A number of a tool, gathered.
#[derive(Debug, Default)]
struct PeakRecorder {
    peak: f64,
    line: u32,
    typical: TimeWeightedValues,
}

impl PeakRecorder {
    fn add(&mut self, value: f64, seconds: f64, line: u32) {
        if value > self.peak {
            (self.peak, self.line) = (value, line);
        }
        self.typical.add(value, seconds);
    }

    fn peak(&self) -> LoadPeak {
        let typical = self.typical.median().unwrap_or(self.peak);
        LoadPeak { peak: self.peak, line: self.line, typical }
    }

    fn some(&self) -> Option<LoadPeak> {
        (self.peak > 0.0).then(|| self.peak())
    }
}

/// A chip that holds for so long in all is none of the exceptions, s: shorter than anybody reacts.
const LASTING: f64 = 0.5;

/// Adds up moves by tool.
pub(super) fn by_tool(moves: &[MoveEngagement], teeth: &BTreeMap<u32, u32>) -> Vec<ToolEngagement> {
    let mut order: Vec<u32> = Vec::new();
    let mut sums: BTreeMap<u32, (ToolEngagement, [PeakRecorder; 6])> = BTreeMap::new();
    for each in moves {
        if !order.contains(&each.tool) {
            order.push(each.tool);
        }
        let (sum, gathered) = sums.entry(each.tool).or_default();
        sum.moves += 1;
        sum.removed_mm3 += each.removed_mm3;
        let share = if each.length_mm > 0.0 { each.engaged_mm / each.length_mm } else { 0.0 };
        let seconds = each.seconds() * share.min(1.0);
        sum.engaged_s += seconds;
        let effort = each.effort.unwrap_or_default();
        let numbers = [
            each.across_mm.most,
            each.axial_mm.most,
            each.chip.map_or(0.0, |chip| chip.peak_mm.most),
            each.rate_mm3_per_s,
            effort.power_kw,
            effort.torque_nm,
        ];
        for (gathering, number) in gathered.iter_mut().zip(numbers) {
            gathering.add(number, seconds, each.origin.line);
        }
    }
    let finish = |number: u32| {
        let (sum, gathered) = sums.remove(&number)?;
        let [across, axial, chip, rate, power, torque] = gathered;
        Some(ToolEngagement {
            number,
            teeth: teeth.get(&number).copied(),
            across_mm: across.peak(),
            axial_mm: axial.peak(),
            lasting_chip_mm: chip.typical.lasting(LASTING),
            chip_mm: chip.some(),
            rate_mm3_per_s: rate.peak(),
            power_kw: power.some(),
            torque_nm: torque.some(),
            ..sum
        })
    };
    order.into_iter().filter_map(finish).collect()
}
