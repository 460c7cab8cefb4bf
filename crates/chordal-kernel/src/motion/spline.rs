//! Splines: a cut along an exact curve.

use std::sync::Arc;

use chordal_command::{AxisMask, CommandKind, Position};
use chordal_geometry::{Spline, Vec3};

use crate::kernel::Kernel;
use crate::statement::Statement;

impl Kernel<'_> {
    /// Where X, Y and Z stand, in program coordinates.
    pub fn point(&self) -> Vec3 {
        let [x, y, z, ..] = self.state.position;
        Vec3::new(x, y, z)
    }

    /// A cut along a spline from where the tool stands; `named` are the axes that the program places.
    pub fn spline(&mut self, at: &dyn Statement, curve: Spline, named: AxisMask) {
        let mut target: Position = self.state.position;
        target[..3].copy_from_slice(&curve.end().to_array());
        let motion = self.moved_to(target, named);
        let feed = self.feed_for(at, &motion, None);
        self.emit(CommandKind::Spline { motion, curve: Arc::new(curve), feed });
    }
}
