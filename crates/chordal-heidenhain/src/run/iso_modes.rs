//! What the G codes of a DIN/ISO program leave from block to block.

use chordal_geometry::TurnDirection;

/// What G codes leave from block to block.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct IsoModes {
    /// The code of the motion.
    pub motion: u32,
    /// G91.
    pub is_incremental: bool,
    /// The direction of the last arc, which G05 and G15 keep.
    pub direction: TurnDirection,
}

impl Default for IsoModes {
    fn default() -> IsoModes {
        IsoModes { motion: 1, is_incremental: false, direction: TurnDirection::Ccw }
    }
}
