//! What a firmware remembers from block to block, in single precision.

/// The motion in force.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum FirmwareMotion {
    Rapid,
    Linear,
    Arc,
    /// With its code, ten times the number.
    Probe(u16),
    None,
}

/// Its modes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Modes {
    pub motion: FirmwareMotion,
    /// F is 1 divided by the minutes of the block.
    pub inverse: bool,
    pub inch: bool,
    pub incremental: bool,
    /// 0 for G17, 1 for G18, 2 for G19.
    pub plane: usize,
    /// Which work offset, from 0.
    pub system: usize,
}

impl Modes {
    /// The axes of the plane.
    pub fn plane_axes(&self) -> [usize; 2] {
        [[0, 1], [2, 0], [1, 2]][self.plane.min(2)]
    }
}

/// Everything that its verdicts depend on; mm, mm/min.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Memory {
    pub modes: Modes,
    /// 0 for none.
    pub feed: f32,
    /// Machine coordinates.
    pub position: [f32; 3],
    /// The work offsets.
    pub systems: Vec<[f32; 3]>,
    /// G92.
    pub preset: [f32; 3],
    /// The tool length along Z.
    pub length: f32,
    /// The places of G28 and G30.
    pub stored: [[f32; 3]; 2],
}

impl Memory {
    /// At power-on.
    pub fn new(position: [f32; 3], systems: Vec<[f32; 3]>) -> Memory {
        let modes = Modes {
            motion: FirmwareMotion::Rapid,
            inverse: false,
            inch: false,
            incremental: false,
            plane: 0,
            system: 0,
        };
        let (preset, stored) = ([0.0; 3], [[0.0; 3]; 2]);
        Memory { modes, feed: 0.0, position, systems, preset, length: 0.0, stored }
    }

    /// The work offset in force.
    pub fn system(&self) -> [f32; 3] {
        self.systems.get(self.modes.system).copied().unwrap_or_default()
    }

    /// The tool length, of Z alone.
    pub fn length_of(&self, axis: usize) -> f32 {
        if axis == 2 { self.length } else { 0.0 }
    }

    /// M2 and M30 set modes back.
    pub fn end_program(&mut self) {
        let modes = &mut self.modes;
        (modes.motion, modes.plane, modes.system) = (FirmwareMotion::Linear, 0, 0);
        (modes.incremental, modes.inverse) = (false, false);
    }
}
