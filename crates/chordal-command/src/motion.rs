//! Moves: their ends, their arc, their feed.

use chordal_geometry::Plane;

use crate::Units;
use crate::axes::{AxisMask, Position};

/// A move of the tool tip in program coordinates.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Move {
    /// Where it begins.
    pub from: Position,
    /// Where it ends.
    pub to: Position,
    /// The axes whose `from` is known relative to the part. It is not known before the program has
    /// moved them, nor after a move in machine coordinates with an unknown work offset.
    pub from_known: AxisMask,
    /// The axes whose `to` is known relative to the part.
    pub to_known: AxisMask,
}

impl Move {
    /// The smallest distance of X from zero on a straight move, mm.
    #[inline]
    pub fn least_radius(&self) -> f64 {
        match self.from[0] * self.to[0] <= 0.0 {
            true => 0.0,
            false => self.from[0].abs().min(self.to[0].abs()),
        }
    }

    /// The length of the vector of the rotary axes' angles, rad.
    pub fn turn_rad(&self) -> f64 {
        let [_, _, _, a, b, c] = std::array::from_fn(|axis| self.to[axis] - self.from[axis]);
        (a * a + b * b + c * c).sqrt()
    }

    /// Whether only rotary axes move and the tool tip does not, so that F per time is an angle per time.
    /// An arc moves the tip even where it ends at its start.
    #[inline]
    pub fn only_turns(&self, shape: Option<&ArcShape>) -> bool {
        shape.is_none() && self.from[..3] == self.to[..3] && self.from != self.to
    }
}

/// The feed mode: what F means.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum FeedMode {
    /// Length per time (G94), mm/s; where rotary axes move alone ([`Move::only_turns`]) rad/s.
    PerTime,
    /// The inverse of the time of the block (G93), 1/s.
    InverseTime,
    /// Length per revolution of the spindle (G95), mm.
    PerRevolution,
}

/// Along which axes F is measured.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum FeedAlong {
    /// Along the whole path of X, Y and Z.
    Path,
    /// Along the arc in its plane; along its whole path a helix is faster.
    Plane,
    /// Along the vector of all axes that move, the rotary ones counted as lengths.
    AllAxes(RotaryLength),
}

/// The length that the angle of a rotary axis counts for in a feed along all axes.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum RotaryLength {
    /// A degree is one unit of length: 1 mm or 1 in.
    DegreeAsUnit(Units),
    /// The arc length on a cylinder about the axis.
    ArcOnCylinder {
        /// Diameters of the cylinders about A, B and C, nm.
        diameters_nm: [u32; 3],
    },
}

impl RotaryLength {
    /// The length of one radian of a rotary axis (0 for A, 1 for B, 2 for C), mm.
    pub fn mm_per_rad(self, rotary_axis: usize) -> f64 {
        match self {
            RotaryLength::DegreeAsUnit(units) => 1f64.to_degrees() * units.mm(),
            RotaryLength::ArcOnCylinder { diameters_nm } => {
                0.5e-6 * f64::from(diameters_nm[rotary_axis])
            }
        }
    }

    /// The length of the vector of all axes, mm; `linear_mm` is the length of X, Y and Z alone.
    pub fn vector_mm(self, linear_mm: f64, motion: &Move) -> f64 {
        let rotary = (0..3).map(|axis| {
            let angle_rad = motion.to[axis + 3] - motion.from[axis + 3];
            (self.mm_per_rad(axis) * angle_rad).powi(2)
        });
        (linear_mm.powi(2) + rotary.sum::<f64>()).sqrt()
    }
}

/// The feed of a cutting move.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Feed {
    /// F in the unit of its mode; NaN before the first F.
    pub value: f64,
    /// The feed mode.
    pub mode: FeedMode,
    /// Along which axes it is measured.
    pub along: FeedAlong,
    /// The speed of the spindle, rev/s, for [`FeedMode::PerRevolution`].
    pub spindle_rev_per_s: f64,
    /// The constant cutting speed (G96), which replaces that speed; `None` in G97.
    pub surface: Option<SurfaceSpeed>,
    /// The change of a thread's lead in each revolution (G34), mm; `value` is the mean lead.
    pub lead_change: f64,
}

impl Feed {
    /// The feed at this radius (of either sign, mm), mm/s; `None` in inverse time mode.
    pub fn mm_per_s_at(&self, radius_mm: f64) -> Option<f64> {
        match (self.mode, self.surface) {
            (FeedMode::PerTime, _) => Some(self.value),
            (FeedMode::PerRevolution, Some(surface)) => {
                Some(self.value * surface.rev_per_s(radius_mm))
            }
            (FeedMode::PerRevolution, None) => Some(self.value * self.spindle_rev_per_s),
            (FeedMode::InverseTime, _) => None,
        }
    }
}

/// A constant cutting speed: the spindle turns faster the nearer the tool is to the axis.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SurfaceSpeed {
    /// The speed at the tool, mm/s.
    pub mm_per_s: f64,
    /// The largest spindle speed, rev/s; infinite where nothing limits it.
    pub most_rev_per_s: f64,
    /// Whether the program limits the speed, not the machine alone.
    pub is_limited: bool,
}

impl SurfaceSpeed {
    /// The spindle speed with the tool at this radius (of either sign, mm), rev/s.
    pub fn rev_per_s(&self, radius_mm: f64) -> f64 {
        let free = self.mm_per_s / (2.0 * std::f64::consts::PI * radius_mm.abs());
        free.min(self.most_rev_per_s)
    }
}

/// An arc, a helix, a spiral or a cone: the radius changes linearly with the angle from
/// `radius_from` to `radius_to`, and so do the third axis and rotary axes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ArcShape {
    /// Plane of the arc.
    pub plane: Plane,
    /// Centre on the two axes of the plane (a, b), mm.
    pub center: [f64; 2],
    /// The angle from start to end, rad: positive counter-clockwise (a towards b). It may be more than
    /// a full turn.
    pub sweep: f64,
    /// Distance of the start from the centre, mm.
    pub radius_from: f64,
    /// Distance of the end from the centre, mm.
    pub radius_to: f64,
}

/// The path of a rapid.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum RapidPath {
    /// Straight: all axes arrive together.
    Straight,
    /// Straight, and no faster than this along the path, mm/s: a G0 with a feed (Marlin).
    AtFeed(f64),
    /// Each axis at its own speed, so that the path bends.
    DogLeg,
}
