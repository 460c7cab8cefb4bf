//! Cuts in which the tool turns in the plane of its two directions (Sinumerik ORIVECT).

use chordal_command::{AxisMask, FeedMode, Position};
use chordal_kinematics::OrientationArc;

use crate::kernel::Kernel;
use crate::statement::Statement;

/// How far the tool may be from the plane between two positions of the rotary axes, degrees: at 100 mm from the tip less
/// than a hundredth of a millimetre.
const LARGEST_AWAY_DEG: f64 = 0.005;

impl Kernel<'_> {
    /// A straight move of the tip in which the tool turns in the plane of its two directions: moves with even angles, so short
    /// that the tool stays next to the plane. Where the machine cannot turn it so, and in inverse time, it is one move with even
    /// angles. Returns how far the tool is from the plane then, rad.
    pub fn straight_in_plane(
        &mut self,
        at: &dyn Statement,
        target: Position,
        named: AxisMask,
    ) -> f64 {
        let Some(parts) = self.turn_in_plane(&target) else {
            let [_, _, _, angles @ ..] = target;
            let away = self.swing_of_tool(&angles).unwrap_or(0.0);
            self.straight(at, target, named);
            return away;
        };
        let (from, count) = (self.state.position, parts.len());
        let linear = named.and(AxisMask::LINEAR);
        for (index, part) in (1..).zip(parts) {
            let share = index as f64 / count as f64;
            let place = std::array::from_fn(|axis| match axis {
                0..3 if index < count && linear.has(axis) => {
                    from[axis] + (target[axis] - from[axis]) * share
                }
                0..3 => target[axis],
                _ => part[axis - 3],
            });
            self.straight(at, place, named);
        }
        0.0
    }

    /// The program positions of A, B and C at the ends of the parts of such a move, rad.
    fn turn_in_plane(&self, target: &Position) -> Option<Vec<[f64; 3]>> {
        let state = &self.state;
        // In inverse time F is the time of the whole block.
        if state.feed_mode == FeedMode::InverseTime {
            return None;
        }
        let chain = state.part_frame.as_ref().filter(|frame| frame.follows_tip)?.chain?;
        let known = state.frames.map().known(state.known);
        if !known.covers(AxisMask::of_chain(&chain)) {
            return None;
        }
        let offsets = state.program_offsets();
        let [start, end] = [&state.position, target].map(|place| offsets.angles(place));
        let [first, last] = [&start, &end].map(|angles| chain.direction(angles));
        let arc = OrientationArc::new(&chain, first, last, &start).ok()?;
        let parts = arc.parts(&start, LARGEST_AWAY_DEG.to_radians())?;
        let is_within = |angles: &[f64; 3]| {
            chain.joints().iter().all(|joint| {
                let angle = angles[joint.letter.index()];
                joint.travel.is_none_or(|(low, high)| (low..=high).contains(&angle))
            })
        };
        if !parts.iter().all(is_within) {
            return None;
        }
        let turning = AxisMask::of_chain(&chain);
        let program = |angles: [f64; 3]| {
            std::array::from_fn(|axis| match turning.has(axis + 3) {
                true => angles[axis] - offsets.work[axis + 3] - offsets.tool[axis + 3],
                false => target[axis + 3],
            })
        };
        Some(parts.into_iter().map(program).collect())
    }
}
