//! The slices of long moves, kept until it is known which blocks are split.

use chordal::stock::{
    BoundedValue, ChipThickness, CuttingLoad, EngagementSlice, MaterialData, MoveEngagement,
};

/// More slices are not kept: 100 MB.
const MAX_SLICES: usize = 4_000_000;

/// One slice of a move.
#[derive(Clone, Copy, Debug)]
struct MoveSlice {
    number: u32,
    at: f32,
    length: f32,
    chip: f32,
    mean: f32,
    section: f32,
}

/// The slices of all moves in order.
#[derive(Debug, Default)]
pub(super) struct MoveSlices(Vec<MoveSlice>);

impl MoveSlices {
    /// Keeps a slice of the move of a number.
    pub fn add(&mut self, number: usize, slice: &EngagementSlice) {
        if self.0.len() < MAX_SLICES {
            self.0.push(MoveSlice {
                number: number as u32,
                at: slice.at as f32,
                length: slice.length as f32,
                chip: slice.chip.most as f32,
                mean: slice.mean as f32,
                section: slice.section_middle as f32,
            });
        }
    }

    /// All slices of the move of a number are here.
    pub fn has(&self, number: usize) -> bool {
        let last = self.0.last().filter(|_| self.0.len() >= MAX_SLICES);
        last.is_none_or(|last| (number as u32) < last.number)
    }

    /// The slices of a move, each with where it begins and ends, mm, and the move as it is there.
    pub fn of<'a>(
        &'a self,
        number: usize,
        each: &'a MoveEngagement,
        feed_per_tooth: f64,
        material: Option<&'a MaterialData>,
    ) -> impl Iterator<Item = ([f64; 2], MoveEngagement)> + 'a {
        let number = number as u32;
        let first = self.0.partition_point(|kept| kept.number < number);
        let own = self.0[first..].iter().take_while(move |kept| kept.number == number);
        own.map(move |kept| {
            let [at, half] = [f64::from(kept.at), 0.5 * f64::from(kept.length)];
            let most = f64::from(kept.chip) * feed_per_tooth;
            let mean_mm = f64::from(kept.mean) * feed_per_tooth;
            let chip = ChipThickness { peak_mm: BoundedValue { least: 0.0, most }, mean_mm };
            let rate = f64::from(kept.section) * each.feed_mm_per_s;
            let effort = material.map(|material| CuttingLoad {
                power_kw: material.power(rate, mean_mm),
                torque_nm: 0.0,
            });
            let there = MoveEngagement { chip: Some(chip), effort, ..*each };
            ([at - half, at + half], there)
        })
    }
}
