//! Where the zero of program coordinates comes from.

use crate::{AxisMask, Position};

/// Where the zero of program coordinates comes from: the work coordinate system, shifts (G52) and presets (G92).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct WorkZero {
    /// What the work coordinate system adds with what is added to all of them, without shifts and presets, mm and
    /// rad. Zero where it is not known.
    pub system: Position,
    /// The axes for which that is known.
    pub system_known: AxisMask,
    /// After the same ones two zeros lie to each other as their offsets say.
    pub unknown_presets: UnknownPresets,
}

/// Presets (G92) at a place that nobody knows in the work coordinate system.
#[derive(Clone, Copy, Default, PartialEq, Debug)]
pub struct UnknownPresets {
    /// The axes on which one acts.
    pub axes: AxisMask,
    /// How many there have been, the last one included.
    pub count: u32,
}

impl WorkZero {
    /// The zero of a system without shifts and presets.
    pub const fn of_system(system: Position, system_known: AxisMask) -> WorkZero {
        WorkZero {
            system,
            system_known,
            unknown_presets: UnknownPresets { axes: AxisMask::NONE, count: 0 },
        }
    }

    /// Along this axis the way from another zero to this one is the difference of the offsets; `same_system`: both
    /// are zeros of the same work coordinate system.
    pub fn relation_is_known(&self, other: &WorkZero, same_system: bool, axis: usize) -> bool {
        let presets = (self.unknown_presets.axes.has(axis), other.unknown_presets.axes.has(axis));
        let presets_match = match presets {
            (false, false) => true,
            (true, true) => self.unknown_presets.count == other.unknown_presets.count,
            _ => false,
        };
        let known = (self.system_known.has(axis), other.system_known.has(axis));
        // Of one system neither has a value, or its values are written meanwhile.
        presets_match && (known == (true, true) || same_system && known == (false, false))
    }
}
