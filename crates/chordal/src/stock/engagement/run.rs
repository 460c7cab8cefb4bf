//! A run on stock with the engagement of every move.

use std::collections::BTreeMap;

use chordal_geometry::ParamCurve;
use chordal_machine::{Tool, ToolShape};
use chordal_stock::engagement::{BoundedValue, EngagementMeter, EngagementSlice, MeasureOptions};
use chordal_stock::{ColumnOptions, ColumnStock, TipMove};

use super::super::gather::{BatchKind, MoveBatch, StockMoves};
use super::super::heights::ShapeHeights;
use super::super::pass::StockOptions;
use super::super::run::{StockRunError, usual_resolution};
use super::super::setup::{NamedBody, SetupFileReader, shift_between};
use super::super::tools::tools_of;
use super::limits::EngagementLimits;
use super::materials::{MaterialData, torque};
use super::report::{ChipThickness, CuttingLoad, EngagementReport, MoveEngagement, by_tool};
use crate::job::Job;
use crate::tool_comments::known_tools;

/// The options of a run with engagement.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EngagementOptions {
    /// The options of the columns.
    pub stock: StockOptions,
    /// The thickest chip that any tool may take, mm; `None` takes the limit of each tool.
    pub max_chip_mm: Option<f64>,
}

impl Job<'_> {
    /// Runs the program on the stock of its machine's setup, and measures the load of every cut.
    ///
    /// # Errors
    /// As [`Job::stock`].
    pub fn engagement(
        &self,
        options: &EngagementOptions,
        files: SetupFileReader<'_>,
    ) -> Result<EngagementReport, StockRunError> {
        self.engagement_with(options, files, &mut |_, _| {})
    }

    /// Like [`Job::engagement`]; `see` also gets every slice with the index of its move.
    ///
    /// # Errors
    /// As [`Job::stock`].
    pub fn engagement_with(
        &self,
        options: &EngagementOptions,
        files: SetupFileReader<'_>,
        see: &mut dyn FnMut(usize, &EngagementSlice),
    ) -> Result<EngagementReport, StockRunError> {
        if self.turns() {
            return Err(StockRunError::Turns);
        }
        let bodies = tools_of(self);
        let mut gathered = StockMoves::new(self, &bodies, false);
        let mut report = self.report_watched(&mut gathered);
        let premise = self.stock_premise()?;
        report.add(premise.note());
        let named = NamedBody { name: "stock", body: &premise.body };
        let shift = shift_between(self.machine(), &named, gathered.work.as_deref())?;
        let shape = named.shape(shift, files, false)?;
        let resolution = options.stock.resolution_mm.unwrap_or_else(|| usual_resolution(&shape));
        let heights = ShapeHeights::new(&shape, resolution);
        let mut stock = ColumnStock::shaped(
            shape.bounds(),
            ColumnOptions::new(resolution, options.stock.budget),
            |low, high| heights.of(low, high),
        )?;
        if heights.is_hollow() {
            stock.hollow(&|corners| heights.hollows(corners));
        }
        let tools: BTreeMap<u32, Tool> =
            known_tools(self).into_iter().map(|(number, known)| (number, known.tool)).collect();
        let teeth: BTreeMap<u32, u32> =
            tools.iter().filter_map(|(number, tool)| Some((*number, teeth_of(tool)?))).collect();
        let material_word = premise.body.material.clone();
        let own = &self.machine().setup.materials;
        let (material, no_material) =
            match material_word.as_deref().map(|word| MaterialData::of(word, own)) {
                Some(Ok(material)) => (Some(material), None),
                Some(Err(why)) => (None, Some(why)),
                None => (None, None),
            };
        let measuring = MeasureOptions { spacing: resolution, graze: options.stock.tolerance_mm };
        let mut moves = Vec::new();
        let mut not_measured: Vec<u32> = Vec::new();
        for batch in gathered.batches.iter().filter(|batch| batch.kind != BatchKind::Rapid) {
            let Some(Ok(tool)) = bodies.get(&batch.tool) else { continue };
            // The engagement of undercuts is not measured.
            if !tool.undercuts.is_empty() {
                stock.cut_below(&tool.undercuts, &batch.moves);
                if !not_measured.contains(&batch.tool) {
                    not_measured.push(batch.tool);
                }
                continue;
            }
            let meter = EngagementMeter::new(tool.removes().clone(), resolution, measuring);
            let cut = EngagementBatch {
                batch,
                meter: &meter,
                teeth: teeth.get(&batch.tool).copied(),
                material: material.as_ref(),
            };
            for index in 0..batch.moves.len() {
                if self.is_interrupted() {
                    return Err(StockRunError::Interrupted);
                }
                let number = moves.len();
                let mut see = |slice: &EngagementSlice| see(number, slice);
                moves.push(cut.engagement(&mut stock, index, &mut see));
            }
            if tool.core.is_some() {
                stock.cut_at_most(&tool.cutter, &batch.moves);
            }
        }
        let limits = EngagementLimits {
            tools: &tools,
            max_chip: options.max_chip_mm,
            spindle_kw: self.machine().spindle_power_kw,
            units: gathered.units,
            sources: self.sources(),
        };
        for each in &mut moves {
            each.problem = limits.worst(each);
        }
        let mut found = limits.problems(&moves);
        let (is_whole, units) = (gathered.is_whole() && report.verified(), gathered.units);
        found.diagnostics.append(&mut gathered.diagnostics);
        report.add(found.diagnostics);
        Ok(EngagementReport {
            resolution_mm: resolution,
            material_word,
            material,
            no_material,
            spindle_kw: self.machine().spindle_power_kw,
            units,
            tools: by_tool(&moves, &teeth),
            moves,
            problems: found.list,
            more_problems: found.more,
            is_whole,
            not_measured,
            stock,
            report,
        })
    }
}

/// The number of teeth around a tool; `None` where it has no feed per tooth: the teeth of a thread mill are along its
/// axis, and a tap advances by its pitch.
fn teeth_of(tool: &Tool) -> Option<u32> {
    match tool.shape? {
        ToolShape::Tap | ToolShape::ThreadMill | ToolShape::Insert | ToolShape::Groove => None,
        _ => tool.teeth,
    }
}

/// A batch of moves with what is needed to measure them.
struct EngagementBatch<'a> {
    batch: &'a MoveBatch,
    meter: &'a EngagementMeter,
    teeth: Option<u32>,
    material: Option<&'a MaterialData>,
}

impl EngagementBatch<'_> {
    fn engagement(
        &self,
        stock: &mut ColumnStock,
        index: usize,
        see: &mut dyn FnMut(&EngagementSlice),
    ) -> MoveEngagement {
        let path: &TipMove = &self.batch.moves[index];
        let mut worst = WorstSlice::new(self.batch, index, path);
        let feed_per_tooth = self.teeth.and_then(|teeth| worst.total.feed_per_tooth(teeth));
        let removed = stock.cut_measuring(self.meter, path, &mut |slice| {
            worst.slice(slice, feed_per_tooth, self.material);
            see(slice);
        });
        worst.total.removed_mm3 = removed.middle.max(0.0);
        worst.finish(feed_per_tooth)
    }
}

/// Heights that differ by less than this are equal, mm: rounding.
const LEVEL: f64 = 1e-9;

/// The largest value of each quantity on a move.
struct WorstSlice {
    total: MoveEngagement,
    mean: f64,
}

impl WorstSlice {
    fn new(batch: &MoveBatch, index: usize, path: &TipMove) -> WorstSlice {
        let none = BoundedValue::default();
        let rate = batch.rates[index];
        WorstSlice {
            total: MoveEngagement {
                origin: batch.origins[index],
                tool: batch.tool,
                row: batch.rows[index],
                feed_mm_per_s: rate.feed,
                rpm: rate.rpm,
                by_time: rate.by_time,
                falls: path.curve.bounds().min.z < path.curve.start().z - LEVEL,
                length_mm: path.curve.length(),
                engaged_mm: 0.0,
                across_mm: none,
                axial_mm: none,
                angle_rad: none,
                facing: none,
                chip: None,
                removed_mm3: 0.0,
                rate_mm3_per_s: 0.0,
                most_rate_mm3_per_s: 0.0,
                effort: None,
                problem: None,
            },
            mean: 0.0,
        }
    }

    fn slice(
        &mut self,
        slice: &EngagementSlice,
        feed_per_tooth: Option<f64>,
        material: Option<&MaterialData>,
    ) {
        let total = &mut self.total;
        let feed = total.feed_mm_per_s;
        total.engaged_mm += slice.length;
        for (known, new) in [
            (&mut total.across_mm, slice.across),
            (&mut total.axial_mm, slice.axial),
            (&mut total.angle_rad, slice.angle),
            (&mut total.facing, slice.chip),
        ] {
            known.least = known.least.max(new.least);
            known.most = known.most.max(new.most);
        }
        let rate = slice.section_middle * feed;
        total.most_rate_mm3_per_s = total.most_rate_mm3_per_s.max(slice.section.most * feed);
        if rate >= total.rate_mm3_per_s {
            (total.rate_mm3_per_s, self.mean) = (rate, slice.mean);
        }
        let (Some(feed_per_tooth), Some(material)) = (feed_per_tooth, material) else { return };
        let power_kw = material.power(rate, slice.mean * feed_per_tooth);
        let known = total.effort.get_or_insert_default();
        if power_kw > known.power_kw {
            *known = CuttingLoad { power_kw, torque_nm: torque(power_kw, total.rpm) };
        }
    }

    fn finish(mut self, feed_per_tooth: Option<f64>) -> MoveEngagement {
        let facing = self.total.facing;
        if facing.most > 0.0 {
            self.total.chip = feed_per_tooth.map(|feed| ChipThickness {
                peak_mm: BoundedValue { least: facing.least * feed, most: facing.most * feed },
                mean_mm: self.mean * feed,
            });
        }
        self.total
    }
}
