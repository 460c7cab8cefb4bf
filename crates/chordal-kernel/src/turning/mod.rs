//! Turning cycles, each as the moves that the control makes.
//!
//! Lengths are millimetres, X is a radius. `profile` is the contour that a cycle cuts; `rough` and `descent` cut down to
//! it in levels, `pattern` repeats it (G73), `offset` computes its allowance; `passes` are the cycles of one block;
//! `peck`, `thread` and `line_thread` are grooving and threading cycles.

mod descent;
mod line_thread;
mod offset;
mod passes;
mod pattern;
mod peck;
mod profile;
mod rough;
mod thread;

use chordal_command::{AxisMask, Position};
use chordal_geometry::tolerance::COINCIDENT_MM;
use chordal_machine::Axis;

use crate::kernel::Kernel;
use crate::statement::Statement;

pub use descent::{DescentFault, DescentWords};
pub use line_thread::LineThreadWords;
pub use peck::PeckWords;
pub use profile::{ContourEdge, ContourProfile};
pub use rough::RoughWords;
pub use thread::ThreadWords;

const X: usize = Axis::X as usize;
const Z: usize = Axis::Z as usize;
const XZ: AxisMask = AxisMask(1 << X | 1 << Z);

impl Kernel<'_> {
    /// X (a radius) and Z of the tool, mm.
    fn turned_place(&self) -> [f64; 2] {
        [self.state.position[X], self.state.position[Z]]
    }

    fn place_at(&self, [x, z]: [f64; 2]) -> Position {
        let mut target = self.state.position;
        (target[X], target[Z]) = (x, z);
        target
    }

    /// A rapid of X and Z, unless the position is already reached.
    fn turn_rapid(&mut self, to: [f64; 2]) {
        let target = self.place_at(to);
        if target != self.state.position {
            self.rapid(target, XZ);
            self.follow_diameter();
        }
    }

    /// A cut of X and Z, unless the position is already reached.
    fn turn_cut(&mut self, at: &dyn Statement, to: [f64; 2]) {
        let target = self.place_at(to);
        if target != self.state.position {
            self.line(at, target, XZ);
        }
    }

    /// Cuts a thread in one pass: `lead_mm` is its mean lead, and the change per revolution, mm.
    pub fn turned_thread(&mut self, at: &dyn Statement, target: Position, lead_mm: [f64; 2]) {
        self.require_spindle(at);
        self.turn_changing_thread([target[X], target[Z]], lead_mm);
    }

    /// A synchronized cut, unless the position is already reached.
    fn turn_thread(&mut self, to: [f64; 2], lead_mm: f64) {
        self.turn_changing_thread(to, [lead_mm, 0.0]);
    }

    fn turn_changing_thread(&mut self, to: [f64; 2], lead_mm: [f64; 2]) {
        let target = self.place_at(to);
        let [x, z] = self.turned_place();
        // The lead is measured along the axis that moves more, F along the path.
        let (dx, dz) = ((to[0] - x).abs(), (to[1] - z).abs());
        let longer = dx.max(dz);
        if longer > 0.0 {
            let along_path = libm::hypot(dx, dz) / longer;
            self.changing_thread(target, XZ, lead_mm.map(|mm| mm * along_path));
        }
    }
}
