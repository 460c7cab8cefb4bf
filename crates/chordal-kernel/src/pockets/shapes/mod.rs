//! Tool paths that clear pockets. Pure geometry of the plane: no program text, no machine, no
//! modal state. Lengths are millimetres, angles radians.

mod circle;
mod corner;
mod inset;
mod island;
#[cfg(test)]
mod island_tests;
mod outline;
mod raster;
mod rectangle;
#[cfg(test)]
mod tests;
mod train;

pub use circle::{ring_radii, rings};
pub use corner::{chamfered, rounded};
pub use inset::{WalledRegion, borders, inset};
pub use island::{IslandError, IslandPocket, outlines_meet};
pub use outline::{Outline, OutlineElement, OutlineError};
pub use raster::{PocketRegion, RasterAlong};
pub use rectangle::{CORNER_STEP, rectangle};
pub use train::{TrainError, offset_train};

use chordal_geometry::Vec2;

/// One move of a tool centre in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// Straight to a point.
    Line {
        /// Its end, mm.
        to: Vec2,
    },
    /// Round a centre to a point.
    Arc {
        /// Its end, mm.
        to: Vec2,
        /// The centre, mm.
        center: Vec2,
        /// Directed angle, rad: positive counter-clockwise.
        sweep: f64,
    },
}

impl Step {
    /// Its end, mm.
    pub fn to(&self) -> Vec2 {
        match *self {
            Step::Line { to } | Step::Arc { to, .. } => to,
        }
    }

    /// The same move about another origin.
    pub fn shifted(&self, by: Vec2) -> Step {
        match *self {
            Step::Line { to } => Step::Line { to: to + by },
            Step::Arc { to, center, sweep } => {
                Step::Arc { to: to + by, center: center + by, sweep }
            }
        }
    }
}
