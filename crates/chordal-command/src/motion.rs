//! Moves: where they begin and end, their arc, their feed.

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
    /// The axes whose `from` is known relative to the part: not before the program has
    /// placed them, nor after a move in machine coordinates with an unknown work offset.
    pub from_known: AxisMask,
    /// The axes whose `to` is known relative to the part.
    pub to_known: AxisMask,
}

impl Move {
    /// The smallest distance of X from zero, where the move is straight, mm.
    #[inline]
    pub fn least_radius(&self) -> f64 {
        match self.from[0] * self.to[0] <= 0.0 {
            true => 0.0,
            false => self.from[0].abs().min(self.to[0].abs()),
        }
    }

    /// The angle that the rotary axes turn together, rad.
    pub fn turn_rad(&self) -> f64 {
        let [_, _, _, a, b, c] = std::array::from_fn(|axis| self.to[axis] - self.from[axis]);
        (a * a + b * b + c * c).sqrt()
    }

    /// Rotary axes turn and the tool tip stays where it is, so that F per time is an angle per time.
    /// An arc moves the tip even where it ends at its start.
    #[inline]
    pub fn only_turns(&self, shape: Option<&ArcShape>) -> bool {
        shape.is_none() && self.from[..3] == self.to[..3] && self.from != self.to
    }
}

/// What F counts.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum FeedMode {
    /// Length per time (G94), mm/s; where rotary axes move alone ([`Move::only_turns`]) rad/s.
    PerTime,
    /// One over the time of the block (G93), 1/s.
    InverseTime,
    /// Length per revolution of the spindle (G95), mm.
    PerRevolution,
}

/// Along what F is measured.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum FeedAlong {
    /// Along the whole path of X, Y and Z.
    Path,
    /// Along the arc in its plane; a helix is faster by its slope.
    Plane,
    /// Along the vector of all axes that move, the rotary ones counted as lengths.
    AllAxes(RotaryLength),
}

/// The length that the angle of a rotary axis counts for in a feed along all axes.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum RotaryLength {
    /// A degree is one unit of length: 1 mm or 1 in.
    DegreeAsUnit(Units),
    /// The arc on a cylinder about the axis; its diameter for A, B and C, nm.
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

    /// The length of the vector of all axes, mm, of which X, Y and Z make `linear_mm`.
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
    /// In the unit of its mode; NaN before any F.
    pub value: f64,
    /// What it counts.
    pub mode: FeedMode,
    /// Along what it is measured.
    pub along: FeedAlong,
    /// Revolutions of the spindle per second, for [`FeedMode::PerRevolution`].
    pub spindle_rev_per_s: f64,
    /// The cutting speed that the spindle keeps instead (G96).
    pub surface: Option<SurfaceSpeed>,
    /// By how much a thread's lead along its path changes from one revolution to the next (G34), mm; `value` is the mean of the lead.
    pub lead_change: f64,
}

impl Feed {
    /// The largest feed of a move with the spindle at this radius (of either sign, mm), mm/s; in inverse time there is none.
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

/// A cutting speed that the spindle keeps: it turns the faster, the nearer the tool is to the axis.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SurfaceSpeed {
    /// The speed at the tool, mm/s.
    pub mm_per_s: f64,
    /// The spindle turns no faster than this, rev/s; infinite where nothing limits it.
    pub most_rev_per_s: f64,
    /// The program limits the speed; otherwise only the machine does.
    pub is_limited: bool,
}

impl SurfaceSpeed {
    /// The spindle's speed with the tool at this radius (of either sign, mm), rev/s.
    pub fn rev_per_s(&self, radius_mm: f64) -> f64 {
        let free = self.mm_per_s / (2.0 * std::f64::consts::PI * radius_mm.abs());
        free.min(self.most_rev_per_s)
    }
}

/// An arc, a helix, a spiral or a cone: the radius goes linearly with the angle from
/// `radius_from` to `radius_to`, the third axis and rotary axes likewise.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ArcShape {
    /// Plane of the arc.
    pub plane: Plane,
    /// Centre on the two axes of the plane (a, b), mm.
    pub center: [f64; 2],
    /// Directed angle in rad: positive counter-clockwise (a towards b). More than a turn
    /// where the command says so.
    pub sweep: f64,
    /// Distance of the start from the centre, mm.
    pub radius_from: f64,
    /// Distance of the end from the centre, mm.
    pub radius_to: f64,
}

/// How a rapid goes.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum RapidPath {
    /// All axes arrive together.
    Straight,
    /// The same, and no faster than so many mm/s along the path: a G0 that obeys a feed (Marlin).
    AtFeed(f64),
    /// Each axis at its own speed.
    DogLeg,
}
