//! One slice of a move: which patches of the cutter are in material, between two bounds.

use std::f64::consts::PI;

use chordal_geometry::Vec3;
use libm::asin;

use super::patches::{CutterPatches, PatchBand};
use crate::columns::{HeightWindow, StockLimits};

/// A value between two bounds.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BoundedValue {
    /// Lower bound.
    pub least: f64,
    /// Upper bound.
    pub most: f64,
}

/// The engagement of a cutter on a slice of a move; all values are the largest on the slice.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EngagementSlice {
    /// Distance of the middle of the slice from the start of the move, mm.
    pub at: f64,
    /// Its length, mm.
    pub length: f64,
    /// The thickest chip as a share of the feed per tooth: the largest u·n.
    pub chip: BoundedValue,
    /// The mean chip as a share of the feed per tooth, over the engaged surface by the middle heights of cells.
    pub mean: f64,
    /// Extent of the engaged surface across the feed (radial depth of cut), mm.
    pub across: BoundedValue,
    /// Extent of the engaged surface along the axis (axial depth of cut), mm.
    pub axial: BoundedValue,
    /// Extent of the engaged surface around the axis (angle of engagement), rad.
    pub angle: BoundedValue,
    /// Area of the engaged surface projected along the feed, mm²: the volume removed per length of path.
    pub section: BoundedValue,
    /// The same by the middle heights of cells, mm².
    pub section_middle: f64,
}

/// The position of the cutter on a slice, with error bounds.
#[derive(Clone, Copy, Debug)]
pub(super) struct CutterPose {
    /// Its tip at the middle of the slice, mm.
    pub tip: Vec3,
    /// The direction of the feed.
    pub direction: Vec3,
    /// Half the length of the slice, mm.
    pub half: f64,
    /// The largest turn of the direction in plan from the middle, rad.
    pub turn: f64,
    /// The largest tilt of the direction from the middle, rad.
    pub tilt: f64,
    /// Where u·n is not above this, the piece itself may have removed the material before.
    pub taken: f64,
    /// The deviation of the slice from a straight one, mm.
    pub sag: f64,
    /// Contacts no deeper than this are ignored by the bounds, mm.
    pub graze: f64,
    /// The same for the middle between the bounds, where the deviation of chords cancels.
    pub fine: f64,
}

impl CutterPose {
    /// Lower bound of the height of the tip on the slice, mm.
    pub fn lowest(&self) -> f64 {
        self.tip.z - self.direction.z.abs() * self.half - self.sag
    }

    fn highest(&self) -> f64 {
        self.tip.z + self.direction.z.abs() * self.half + self.sag
    }
}

/// A range that grows; empty at first.
#[derive(Clone, Copy, Debug)]
struct GrowingRange {
    from: f64,
    to: f64,
}

impl GrowingRange {
    const NONE: GrowingRange = GrowingRange { from: f64::INFINITY, to: f64::NEG_INFINITY };

    fn add(&mut self, from: f64, to: f64) {
        self.from = self.from.min(from);
        self.to = self.to.max(to);
    }

    fn length(&self) -> f64 {
        (self.to - self.from).max(0.0)
    }
}

/// One bound of the engagement.
#[derive(Clone, Copy, Debug)]
struct SideEngagement {
    chip: f64,
    across: GrowingRange,
    axial: GrowingRange,
    around: GrowingRange,
    section: f64,
}

impl SideEngagement {
    const NONE: SideEngagement = SideEngagement {
        chip: 0.0,
        across: GrowingRange::NONE,
        axial: GrowingRange::NONE,
        around: GrowingRange::NONE,
        section: 0.0,
    };
}

/// Collects the engagement of all patches.
struct PatchScan<'a> {
    window: &'a HeightWindow,
    place: &'a CutterPose,
    /// The direction of the feed in plan; X where it goes straight down.
    ahead: [f64; 2],
    /// Components of the feed's unit direction in plan and along the axis.
    plan: f64,
    rise: f64,
    flutes: f64,
    most: SideEngagement,
    least: SideEngagement,
    /// The engaged surface by the middle heights, mm², and (`section`) its projection along the feed.
    surface: f64,
    section: f64,
}

/// Below this u·n the surface slides along the material: rounding of directions is far smaller, and a chip of a
/// millionth of the feed is none.
const SLIDES: f64 = 1e-6;

/// Below this component in plan the feed is straight up or down.
const UPRIGHT: f64 = 1e-9;

/// Finds which patches of a cutter are in material; `None` where none may be.
pub(super) fn look(
    patches: &CutterPatches,
    window: &HeightWindow,
    place: &CutterPose,
    at: f64,
) -> Option<EngagementSlice> {
    let direction = place.direction;
    let plan = libm::hypot(direction.x, direction.y);
    let ahead = if plan > UPRIGHT { [direction.x / plan, direction.y / plan] } else { [1.0, 0.0] };
    let mut look = PatchScan {
        window,
        place,
        ahead,
        plan: if plan > UPRIGHT { plan } else { 0.0 },
        rise: direction.z,
        flutes: patches.flutes,
        most: SideEngagement::NONE,
        least: SideEngagement::NONE,
        surface: 0.0,
        section: 0.0,
    };
    for band in &patches.end {
        look.band(band, &patches.around_end);
    }
    look.band(&patches.side, &patches.around_side);
    let widest = 2.0 * patches.side.radii[1];
    look.slice(at, widest)
}

impl PatchScan<'_> {
    fn slice(&self, at: f64, widest: f64) -> Option<EngagementSlice> {
        let (most, least) = (&self.most, &self.least);
        if most.chip <= 0.0 && self.section <= 0.0 {
            return None;
        }
        let between = |least: f64, most: f64| BoundedValue { least: least.min(most), most };
        Some(EngagementSlice {
            at,
            length: 2.0 * self.place.half,
            chip: between(least.chip, most.chip.min(1.0)),
            mean: if self.surface > 0.0 { self.section / self.surface } else { 0.0 },
            across: between(least.across.length(), most.across.length().min(widest)),
            axial: between(least.axial.length(), most.axial.length()),
            angle: between(least.around.length(), most.around.length().min(2.0 * PI)),
            section: between(least.section, most.section.max(self.section)),
            section_middle: self.section,
        })
    }

    /// Examines the patches of a ring.
    fn band(&mut self, band: &PatchBand, around: &[[f64; 2]]) {
        let place = self.place;
        let low = place.lowest() + band.heights[0];
        if self.window.highest() <= low + place.fine {
            return;
        }
        let step = 2.0 * PI / around.len() as f64;
        let (half_sine, half_cosine) = libm::sincos(0.5 * step);
        for (number, &[sine, cosine]) in around.iter().enumerate() {
            // The directions of both ends of the patch, relative to the feed.
            let turned =
                |by: f64| [sine * half_cosine + by * cosine, cosine * half_cosine - by * sine];
            let ends = [turned(-half_sine), turned(half_sine)];
            let angles = [number as f64 * step - PI, (number + 1) as f64 * step - PI];
            self.patch(band, [sine, cosine], ends, angles, [half_sine, half_cosine]);
        }
    }

    /// u·n of a normal with this sine and cosine of the angle from −Z, at an angle with the cosine `around` from the
    /// feed in plan.
    fn facing(&self, [sine, cosine]: [f64; 2], around: f64) -> f64 {
        self.plan * sine * around - self.rise * cosine
    }

    fn patch(
        &mut self,
        band: &PatchBand,
        [sine, cosine]: [f64; 2],
        ends: [[f64; 2]; 2],
        angles: [f64; 2],
        [half_sine, half_cosine]: [f64; 2],
    ) {
        let place = self.place;
        let cosines = ends.map(|end| end[1]);
        // Patch borders are along the feed and across it, so the cosine has its extremes at the ends of a patch.
        let nearest = cosines[0].max(cosines[1]);
        let farthest = cosines[0].min(cosines[1]);
        let over = |around: f64, pick: fn(f64, f64) -> f64| {
            let [a, b] = band.normals.map(|normal| self.facing(normal, around));
            pick(a, b)
        };
        let [sines, uprights] = [0, 1].map(|k| band.normals[0][k].max(band.normals[1][k]));
        let turned = place.turn * sines + place.tilt * uprights;
        let high = (over(nearest, f64::max) + band.bow + turned).min(1.0);
        let low = over(farthest, f64::min) - turned;
        if high <= SLIDES {
            return;
        }
        let radius = 0.5 * (band.radii[0] + band.radii[1]);
        let [ahead, left] = [self.ahead, [-self.ahead[1], self.ahead[0]]];
        let outward = [0, 1].map(|axis| ahead[axis] * cosine + left[axis] * sine);
        let middle = [place.tip.x + radius * outward[0], place.tip.y + radius * outward[1]];
        let along = 0.5 * (band.radii[1] - band.radii[0]) + band.radii[1] * (1.0 - half_cosine);
        let aside = band.radii[1] * half_sine;
        let moved = place.half * self.plan;
        let reach = [0, 1].map(|axis| {
            outward[axis].abs() * along
                + outward[1 - axis].abs() * aside
                + ahead[axis].abs() * moved
                + place.sag
        });
        let top = place.highest() + self.flutes;
        let heights = [place.lowest() + band.heights[0], place.highest() + band.heights[1]];
        let section_value = [heights[0], if band.is_side { top } else { heights[1] }];
        let StockLimits { maybe, surely } = self.window.ends(middle, reach, section_value);
        let bottom = heights[0].max(maybe[0]);
        let highest = maybe[1].min(top);
        let lowest = surely[1].min(place.lowest() + self.flutes);
        let width = band.radii[1] * (angles[1] - angles[0]);
        self.middle(band, [sine, cosine], middle, width);
        if highest <= bottom + place.graze {
            return;
        }
        let sides = [0, 1].map(|k| {
            let [sine, _] = ends[k];
            [band.radii[0] * sine, band.radii[1] * sine]
        });
        let from = sides.iter().flatten().copied().fold(f64::INFINITY, f64::min);
        let to = sides.iter().flatten().copied().fold(f64::NEG_INFINITY, f64::max);
        let length = |top: f64, bottom: f64| {
            if band.is_side { (top - bottom).max(0.0) } else { band.length }
        };
        let most = &mut self.most;
        most.chip = most.chip.max(high);
        most.across.add(from, to);
        most.axial.add(bottom, highest);
        most.around.add(angles[0], angles[1]);
        most.section += width * length(highest, bottom) * high;
        // The whole band of a ring must be in stock; of the side, the part above a hollow.
        let floor = if band.is_side { heights[1].max(surely[0]) } else { heights[1] };
        let is_hollow = !band.is_side && surely[0] > heights[0];
        if low <= place.taken || low <= SLIDES || is_hollow || lowest <= floor + place.graze {
            return;
        }
        let least = &mut self.least;
        least.chip = least.chip.max(low);
        least.across.add(from, to);
        least.axial.add(floor, lowest);
        least.around.add(angles[0], angles[1]);
        let narrow = band.radii[0] * (angles[1] - angles[0]);
        least.section += narrow * length(lowest, floor) * low;
    }

    /// Adds a patch by the middle height of the cell at its middle.
    fn middle(&mut self, band: &PatchBand, [_, cosine]: [f64; 2], middle: [f64; 2], width: f64) {
        let [a, b] = band.normals.map(|normal| self.facing(normal, cosine));
        let facing = 0.5 * (a + b);
        let [bottom, above] = band.heights.map(|height| self.place.tip.z + height);
        let top = self.window.middle(middle).min(self.place.tip.z + self.flutes);
        if facing <= 0.0 || top <= bottom + self.place.fine {
            return;
        }
        // The top of the stock may cross the patch.
        let share = if above > bottom { ((top - bottom) / (above - bottom)).min(1.0) } else { 1.0 };
        let radius = 0.5 * (band.radii[0] + band.radii[1]);
        let width = width * if band.radii[1] > 0.0 { radius / band.radii[1] } else { 0.0 };
        let section_value = [bottom, if band.is_side { top } else { above.min(top) }];
        let there = 1.0 - self.window.missing(middle, section_value);
        let area = width * there * if band.is_side { top - bottom } else { share * band.length };
        self.surface += area;
        self.section += area * facing;
    }
}

/// The angle of engagement of a radial depth of cut, rad, from where the chip is zero to where it ends. `across` and
/// `diameter` are in mm.
pub fn engagement_angle(across: f64, diameter: f64) -> f64 {
    let share = (across / diameter).clamp(0.0, 1.0);
    // Equal to acos(1 − 2x), without loss of accuracy near zero.
    2.0 * asin(share.sqrt())
}
