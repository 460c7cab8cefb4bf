//! What a firmware remembers from block to block, in single precision.

use chordal_syntax::Letters;

/// The motion in force.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum FirmwareMotion {
    Rapid,
    Linear,
    Arc,
    /// With its code, ten times the number.
    Probe(u16),
    /// A spline by one block, the same.
    Spline(u16),
    /// A canned cycle.
    Cycle,
    None,
}

/// Its modes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct FirmwareModes {
    pub motion: FirmwareMotion,
    /// F is 1 divided by the minutes of the block.
    pub inverse: bool,
    pub inch: bool,
    pub incremental: bool,
    /// 0 for G17, 1 for G18, 2 for G19.
    pub plane: usize,
    /// Which work offset, from 0.
    pub system: usize,
    /// Cycles return to R, not to the level before them.
    pub return_to_r: bool,
}

impl FirmwareModes {
    /// The axes of the plane.
    pub fn plane_axes(&self) -> [usize; 2] {
        [[0, 1], [2, 0], [1, 2]][self.plane.min(2)]
    }
}

/// What a canned cycle remembers: levels along its axis, mm, and the letters that it has had.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct HoleMemory {
    pub initial: f32,
    pub r: f32,
    pub z: f32,
    pub letters: Letters,
}

impl HoleMemory {
    pub fn moved(self, by: f32) -> HoleMemory {
        HoleMemory { initial: self.initial + by, r: self.r + by, z: self.z + by, ..self }
    }
}

/// Everything that its verdicts depend on; mm, mm/min.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct FirmwareMemory {
    pub modes: FirmwareModes,
    /// 0 for none.
    pub feed: f32,
    /// Machine coordinates.
    pub position: [f32; 3],
    /// The work offsets.
    pub systems: Vec<[f32; 3]>,
    /// G92, and what is kept of it where it is switched off.
    pub preset: [f32; 3],
    pub kept_preset: [f32; 3],
    /// The tool length.
    pub length: [f32; 3],
    /// The places of G28 and G30.
    pub stored: [[f32; 3]; 2],
    /// The cycle that is active.
    pub hole: Option<HoleMemory>,
    /// Modes and feed that M70 keeps.
    pub kept: Option<(FirmwareModes, f32)>,
}

impl FirmwareMemory {
    /// At power-on.
    pub fn new(position: [f32; 3], systems: Vec<[f32; 3]>) -> FirmwareMemory {
        let modes = FirmwareModes {
            motion: FirmwareMotion::Rapid,
            inverse: false,
            inch: false,
            incremental: false,
            plane: 0,
            system: 0,
            return_to_r: false,
        };
        FirmwareMemory {
            modes,
            feed: 0.0,
            position,
            systems,
            preset: [0.0; 3],
            kept_preset: [0.0; 3],
            length: [0.0; 3],
            stored: [[0.0; 3]; 2],
            hole: None,
            kept: None,
        }
    }

    /// The work offset in force.
    pub fn system(&self) -> [f32; 3] {
        self.systems.get(self.modes.system).copied().unwrap_or_default()
    }

    /// The machine coordinate of an absolute word.
    pub fn machine(&self, axis: usize, value: f32) -> f32 {
        value + (self.system()[axis] + self.preset[axis]) + self.length[axis]
    }

    /// M2 and M30 set modes back.
    pub fn end_program(&mut self) {
        let modes = &mut self.modes;
        (modes.motion, modes.plane, modes.system) = (FirmwareMotion::Linear, 0, 0);
        (modes.incremental, modes.inverse, modes.return_to_r) = (false, false, false);
        self.hole = None;
    }
}
