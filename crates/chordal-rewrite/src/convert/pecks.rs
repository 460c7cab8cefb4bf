//! Cycles that stay although the new control makes their pecks in other steps: where they are, and what
//! differs, measured on both runs.

use std::collections::BTreeSet;

use chordal::control::{Action, COMMON_SETTINGS, Control, CycleKind, SettingField};
use chordal_compare::HolePecks;

use super::codes;
use super::context::ConvertContext;
use super::layout::TextLayout;
use super::plan::ConvertPlan;
use crate::Certificate;

/// A block whose holes are drilled in other steps.
#[derive(Clone, Debug, PartialEq)]
pub struct PeckChange {
    /// Its line in the old and in the new text, from 1.
    pub lines: [u32; 2],
    /// The cycle, by its code on the old control.
    pub cycle: String,
    /// How many holes.
    pub holes: u64,
    /// What the old control does, and what the new one does.
    pub readings: [PeckReading; 2],
}

/// The pecks of a hole, as they were run.
#[derive(Clone, Debug, PartialEq)]
pub struct PeckReading {
    /// How many.
    pub pecks: usize,
    /// The deepest, mm.
    pub largest_step_mm: f64,
    /// How far above the last depth the rapid back stops, mm; nothing for a hole in one cut.
    pub clearance_mm: Option<f64>,
    /// The setting of the control that this is, where a word or the R level does not say otherwise.
    pub clearance_setting: Option<&'static str>,
    /// How far above R the tool goes between pecks, mm: less than nothing where it stays below R.
    pub above_r_mm: Option<f64>,
    /// The setting that lifts it above R.
    pub above_r_setting: Option<&'static str>,
}

/// Measured and set values closer than this, mm, are the same.
const EQUAL_PECK_MM: f64 = 1e-6;

impl PeckReading {
    fn of(pecks: &HolePecks, kind: CycleKind, control: &Control) -> PeckReading {
        let rules = &control.parameters.rules;
        let (field, set_mm) = match kind == CycleKind::ChipBreak {
            true => (SettingField::CHIP_BREAK, rules.chip_break_mm),
            false => (SettingField::PECK_CLEARANCE, rules.peck_clearance_mm),
        };
        let name = |fields: &[SettingField]| {
            let own = control.table.settings.iter().chain(COMMON_SETTINGS);
            own.into_iter().find(|one| fields.contains(&one.field)).map(|one| one.name)
        };
        let clearance_mm = pecks.clearance_mm();
        let is_set = clearance_mm.is_some_and(|mm| (mm - set_mm).abs() <= EQUAL_PECK_MM);
        let above_r_mm = pecks.above_r_mm();
        let is_above = above_r_mm.is_some_and(|mm| mm > EQUAL_PECK_MM);
        PeckReading {
            pecks: pecks.depths_mm.len(),
            largest_step_mm: pecks.largest_step_mm(),
            clearance_mm,
            clearance_setting: name(&[field, SettingField::CYCLE_LIFTS]).filter(|_| is_set),
            above_r_mm,
            above_r_setting: name(&[SettingField::CYCLE_RETURN_ABOVE_R]).filter(|_| is_above),
        }
    }

    fn is_near(&self, other: &PeckReading) -> bool {
        let near = |one: Option<f64>, other: Option<f64>| match (one, other) {
            (Some(one), Some(other)) => (one - other).abs() <= EQUAL_PECK_MM,
            (one, other) => one == other,
        };
        self.pecks == other.pecks
            && near(Some(self.largest_step_mm), Some(other.largest_step_mm))
            && near(self.clearance_mm, other.clearance_mm)
            && near(self.above_r_mm, other.above_r_mm)
            && self.clearance_setting == other.clearance_setting
    }
}

/// The lines of both texts whose cycles may drill in other steps: kept blocks with pecks.
pub(crate) fn lines(
    context: &ConvertContext,
    plan: &ConvertPlan,
    layout: &TextLayout,
) -> [BTreeSet<u32>; 2] {
    let is_free = |at: usize| plan.is_kept(at) && peck_of(context, at).is_some();
    let blocks: BTreeSet<usize> =
        (0..context.source.blocks.len()).filter(|at| is_free(*at)).collect();
    let old = blocks.iter().map(|at| context.source.blocks[*at].line).collect();
    let new = (1..).zip(&layout.from).filter(|(_, at)| at.is_some_and(|at| blocks.contains(&at)));
    [old, new.map(|(line, _)| line).collect()]
}

/// The cycle with pecks that a block drills by.
fn peck_of(context: &ConvertContext, at: usize) -> Option<CycleKind> {
    let run = context.run(at).filter(|run| context.in_cycle(run))?;
    match run.after.motion {
        Some(Action::Cycle(kind)) => Some(kind).filter(|kind| kind.is_peck()),
        _ => None,
    }
}

/// What the comparison has found, block by block.
pub(crate) fn changes(context: &ConvertContext, certificate: &Certificate) -> Vec<PeckChange> {
    let mut changes: Vec<PeckChange> = Vec::new();
    for pair in &certificate.comparison.pecks {
        let lines = pair.each_ref().map(|pecks| pecks.place.line);
        // A line may hold other blocks, too.
        let mut blocks = context.source.blocks_on(lines[0], lines[0]);
        let Some(kind) = blocks.find_map(|at| peck_of(context, at)) else { continue };
        let [from, to] = context.controls();
        let readings = [PeckReading::of(&pair[0], kind, from), PeckReading::of(&pair[1], kind, to)];
        let same = |change: &&mut PeckChange| {
            let both = change.readings.iter().zip(&readings);
            change.lines == lines && both.into_iter().all(|(one, other)| one.is_near(other))
        };
        if let Some(known) = changes.iter_mut().rev().take(MAX_BACK).find(same) {
            known.holes += 1;
            continue;
        }
        let cycle = codes::name(Action::Cycle(kind), from, context.style()).unwrap_or_default();
        changes.push(PeckChange { lines, cycle, holes: 1, readings });
    }
    changes
}

/// Blocks back that a loop drills again.
const MAX_BACK: usize = 100;
