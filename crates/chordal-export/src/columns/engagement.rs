//! Engagement of moves of a mill, as columns.

use chordal::control::Origin;
use chordal::stock::MoveEngagement;

use super::moves::{CuttingMoveData, NumberSpec, number};

/// Name and version of the columns of engagement.
pub const ENGAGEMENT_COLUMNS: &str = "chordal.engagement-columns/1";

/// Every number of a move.
const NUMBERS: [NumberSpec<MoveEngagement>; 19] = [
    number("length_mm", "mm", "length of the move", |each| Some(each.length_mm)),
    number("engaged_mm", "mm", "how long the tool may be in material", |each| {
        Some(each.engaged_mm)
    }),
    number("feed_mm_per_min", "mm/min", "the programmed feed, if it is known", |each| {
        (each.feed_mm_per_s > 0.0).then_some(each.feed_mm_per_s * 60.0)
    }),
    number("spindle_rpm", "rpm", "speed of the spindle", |each| Some(each.rpm)),
    number("radial_depth_least_mm", "mm", "radial depth of cut, at least", |each| {
        Some(each.across_mm.least)
    }),
    number("radial_depth_most_mm", "mm", "radial depth of cut, at most", |each| {
        Some(each.across_mm.most)
    }),
    number("axial_depth_least_mm", "mm", "axial depth of cut, at least", |each| {
        Some(each.axial_mm.least)
    }),
    number("axial_depth_most_mm", "mm", "axial depth of cut, at most", |each| {
        Some(each.axial_mm.most)
    }),
    number("angle_least_deg", "deg", "angle of engagement, at least", |each| {
        Some(each.angle_rad.least.to_degrees())
    }),
    number("angle_most_deg", "deg", "angle of engagement, at most", |each| {
        Some(each.angle_rad.most.to_degrees())
    }),
    number("facing_most", "", "the thickest chip by the feed of a tooth, at most", |each| {
        Some(each.facing.most)
    }),
    number("chip_least_mm", "mm", "the thickest chip, at least", |each| {
        Some(each.chip?.peak_mm.least)
    }),
    number("chip_most_mm", "mm", "the thickest chip, at most", |each| {
        Some(each.chip?.peak_mm.most)
    }),
    number("chip_mean_mm", "mm", "the mean chip where most is removed", |each| {
        Some(each.chip?.mean_mm)
    }),
    number("removed_mm3", "mm³", "removed, by the middle of the bounds", |each| {
        Some(each.removed_mm3)
    }),
    number("rate_mm3_per_min", "mm³/min", "largest removal rate, by the middle", |each| {
        Some(each.rate_mm3_per_s * 60.0)
    }),
    number("rate_most_mm3_per_min", "mm³/min", "largest removal rate, at most", |each| {
        Some(each.most_rate_mm3_per_s * 60.0)
    }),
    number("power_kw", "kW", "power, an estimate to 30 %", |each| Some(each.effort?.power_kw)),
    number("torque_nm", "N·m", "torque, an estimate to 30 %", |each| Some(each.effort?.torque_nm)),
];

impl CuttingMoveData for MoveEngagement {
    const COLUMNS: &'static str = ENGAGEMENT_COLUMNS;
    const NUMBERS: &'static [NumberSpec<MoveEngagement>] = &NUMBERS;

    fn origin(&self) -> Origin {
        self.origin
    }

    fn tool(&self) -> u32 {
        self.tool
    }
}
