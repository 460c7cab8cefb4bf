//! Splines: a cut along an exact curve.

use std::sync::Arc;

use chordal_command::{AxisMask, CommandKind, Position};
use chordal_geometry::{Spline, Vec3};

use crate::kernel::Kernel;
use crate::statement::Statement;

impl Kernel<'_> {
    /// X, Y and Z of the present position, program coordinates, mm.
    pub fn point(&self) -> Vec3 {
        let [x, y, z, ..] = self.state.position;
        Vec3::new(x, y, z)
    }

    /// Cuts along a spline from the present position; `named` are the axes whose end the program gives.
    pub fn spline(&mut self, at: &dyn Statement, curve: Spline, named: AxisMask) {
        let mut target: Position = self.state.position;
        target[..3].copy_from_slice(&curve.end().to_array());
        let motion = self.moved_to(target, named);
        let feed = self.feed_for(at, &motion, None);
        self.emit(CommandKind::Spline { motion, curve: Arc::new(curve), feed });
    }
}
