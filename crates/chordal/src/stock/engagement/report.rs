//! The result of a run with engagement, as plain data.

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
    /// The thickest chip.
    pub peak_mm: BoundedValue,
    /// The mean thickness where the removal rate of the move is highest, by the heights at the middles of columns.
    pub mean_mm: f64,
}

/// Estimated power and torque; the estimate may be off by [`POWER_SHARE`](super::POWER_SHARE).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CuttingLoad {
    /// Power at the spindle, kW.
    pub power_kw: f64,
    /// Torque at the spindle, N·m.
    pub torque_nm: f64,
}

/// The largest values of a move at feed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MoveEngagement {
    /// Its block.
    pub origin: Origin,
    /// The tool.
    pub tool: u32,
    /// Its index among all path segments of the run.
    pub row: u32,
    /// Programmed feed, mm/s; zero where none is known.
    pub feed_mm_per_s: f64,
    /// Spindle speed, rev/min; zero where it is stopped.
    pub rpm: f64,
    /// True where its feed is an F per time of its own block: not of a thread, tapping, cycle or inverse time.
    pub by_time: bool,
    /// True where the tip goes down somewhere on it: a plunge, a ramp, a helix.
    pub falls: bool,
    /// Its length, mm.
    pub length_mm: f64,
    /// Length of path on which the tool may be in material, mm.
    pub engaged_mm: f64,
    /// Radial depth of cut, mm: between the outermost engaged points across the feed.
    pub across_mm: BoundedValue,
    /// Axial depth of cut, mm.
    pub axial_mm: BoundedValue,
    /// Angle of engagement, rad.
    pub angle_rad: BoundedValue,
    /// The thickest chip as a share of the feed per tooth.
    pub facing: BoundedValue,
    /// Chip thickness; `None` without number of teeth, feed or spindle speed.
    pub chip: Option<ChipThickness>,
    /// What it removes, mm³, by the heights at the middles of columns.
    pub removed_mm3: f64,
    /// Largest removal rate, mm³/s, by the heights at the middles of columns.
    pub rate_mm3_per_s: f64,
    /// Upper bound of the removal rate, mm³/s.
    pub most_rate_mm3_per_s: f64,
    /// Power and torque; `None` without a material or a chip.
    pub effort: Option<CuttingLoad>,
    /// The first limit that it breaks; `None` where it keeps all.
    pub problem: Option<Code>,
}

impl MoveEngagement {
    /// Feed per tooth, mm; `None` where feed or spindle speed are not known.
    pub fn feed_per_tooth(&self, teeth: u32) -> Option<f64> {
        let by_tooth = self.feed_mm_per_s * 60.0 / (self.rpm * f64::from(teeth));
        (by_tooth > 0.0 && by_tooth.is_finite()).then_some(by_tooth)
    }

    /// Its time at the programmed feed, s; zero without one.
    pub fn seconds(&self) -> f64 {
        if self.feed_mm_per_s > 0.0 { self.length_mm / self.feed_mm_per_s } else { 0.0 }
    }
}

/// The largest value of a quantity, where it occurs, and its median by time in material.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LoadPeak {
    /// The largest value.
    pub peak: f64,
    /// The line where it occurs.
    pub line: u32,
    /// The median by time.
    pub typical: f64,
}

/// The load on a tool.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ToolEngagement {
    /// Its number.
    pub number: u32,
    /// Number of teeth; `None` where it is not known.
    pub teeth: Option<u32>,
    /// Moves at feed.
    pub moves: u64,
    /// Time in material at the programmed feeds, s.
    pub engaged_s: f64,
    /// What it removes, mm³, by the heights at the middles of columns.
    pub removed_mm3: f64,
    /// Upper bound of the radial depth of cut, mm.
    pub across_mm: LoadPeak,
    /// Upper bound of the axial depth of cut, mm.
    pub axial_mm: LoadPeak,
    /// Upper bound of the chip thickness, mm; `None` where no chip is known.
    pub chip_mm: Option<LoadPeak>,
    /// Upper bound of the chip thickness that it reaches for half a second or longer in total, mm; `None` where no
    /// chip is known.
    pub lasting_chip_mm: Option<f64>,
    /// Removal rate, mm³/s.
    pub rate_mm3_per_s: LoadPeak,
    /// Estimated power, kW; `None` without a material.
    pub power_kw: Option<LoadPeak>,
    /// Estimated torque, N·m; `None` without a material.
    pub torque_nm: Option<LoadPeak>,
}

/// A block that overloads a tool or the spindle, or whose chip is too thin to cut.
#[derive(Clone, Debug, PartialEq)]
pub struct EngagementProblem {
    /// What kind of problem it is.
    pub code: Code,
    /// The file of the block.
    pub file: String,
    /// Its line, from 1.
    pub line: u32,
    /// Number of the tool.
    pub tool: u32,
    /// The chip thickness in mm, or the power in kW with the uncertainty of its estimate: at least and at most.
    pub value: BoundedValue,
    /// The limit, mm or kW.
    pub limit: f64,
}

/// The result of a run with engagement.
#[derive(Debug)]
pub struct EngagementReport {
    /// The side of a column, mm.
    pub resolution_mm: f64,
    /// The material of the stock as the setup writes it; `None` where it gives none.
    pub material_word: Option<String>,
    /// The values of that material.
    pub material: Option<MaterialData>,
    /// Why there are no values for a material that is given.
    pub no_material: Option<NoMaterial>,
    /// The power of the spindle, kW; `None` where it is not given.
    pub spindle_kw: Option<f64>,
    /// Units of the program.
    pub units: Units,
    /// Every move at feed, in the order of the run.
    pub moves: Vec<MoveEngagement>,
    /// The loads by tool, in the order of first cuts.
    pub tools: Vec<ToolEngagement>,
    /// The limits that are broken, in the order of the run.
    pub problems: Vec<EngagementProblem>,
    /// Number of problems that are not in the list.
    pub more_problems: u64,
    /// True where every cut was simulated: each tool has a shape, each position is known.
    pub is_whole: bool,
    /// Numbers of tools with undercuts: their cuts are simulated, but their engagement is not measured.
    pub not_measured: Vec<u32>,
    /// The stock as it is left.
    pub stock: ColumnStock,
    /// The report of the run, with the problems as diagnostics among the others.
    pub report: Report,
}

/// Records one quantity of a tool.
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

/// A chip thickness that lasts this long in total is more than a momentary peak, s: shorter than an operator's
/// reaction.
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
