//! The parts that the zero of program coordinates is made of.

use crate::{AxisMask, Position};

/// Where the zero of program coordinates comes from: the work coordinate system, shifts (G52) and presets (G92).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct WorkZero {
    /// The offsets of the work coordinate system and of all systems together (the external one), without shifts and
    /// presets, mm and rad; zero where they are not known.
    pub system: Position,
    /// The axes for which `system` is known.
    pub system_known: AxisMask,
    /// The presets that are not known: between two zeros with the same ones the distance is that of their offsets.
    pub unknown_presets: UnknownPresets,
}

/// Presets (G92) at positions that are not known in the work coordinate system.
#[derive(Clone, Copy, Default, PartialEq, Debug)]
pub struct UnknownPresets {
    /// The axes on which such a preset is active.
    pub axes: AxisMask,
    /// How many there have been so far, the active one included.
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

    /// Whether the distance from another zero to this one along an axis is known, as the difference of their offsets.
    /// `same_system`: both are zeros of the same work coordinate system.
    pub fn relation_is_known(&self, other: &WorkZero, same_system: bool, axis: usize) -> bool {
        let presets = (self.unknown_presets.axes.has(axis), other.unknown_presets.axes.has(axis));
        let presets_match = match presets {
            (false, false) => true,
            (true, true) => self.unknown_presets.count == other.unknown_presets.count,
            _ => false,
        };
        let known = (self.system_known.has(axis), other.system_known.has(axis));
        // In one system both may be unknown, unless its values were written in between.
        presets_match && (known == (true, true) || same_system && known == (false, false))
    }
}
