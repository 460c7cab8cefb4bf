//! What the axes do at an instant.

use crate::Axes;

/// A setpoint.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample {
    /// From the start, s.
    pub time_s: f64,
    /// mm and rad.
    pub position: Axes,
    /// mm/s and rad/s.
    pub velocity: Axes,
    /// mm/s² and rad/s².
    pub acceleration: Axes,
    /// mm/s³ and rad/s³.
    pub jerk: Axes,
    /// The tag of the move or of the wait that is under way.
    pub tag: u64,
}

impl Sample {
    /// Speed of the tool: along X, Y and Z in mm/s, or of the rotary axes in rad/s where they
    /// alone move.
    pub fn speed(&self) -> f64 {
        let length = |axes: &[f64]| axes.iter().map(|v| v * v).sum::<f64>().sqrt();
        let linear = length(&self.velocity[..3]);
        if linear > 0.0 { linear } else { length(&self.velocity[3..]) }
    }
}

/// Where the axes are and how they move.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct State {
    /// mm and rad.
    pub position: Axes,
    /// mm/s and rad/s.
    pub velocity: Axes,
    /// mm/s² and rad/s².
    pub acceleration: Axes,
    /// mm/s³ and rad/s³.
    pub jerk: Axes,
    /// The tag of the move that is under way.
    pub tag: u64,
}

impl From<Sample> for State {
    #[inline]
    fn from(sample: Sample) -> State {
        let Sample { position, velocity, acceleration, jerk, tag, .. } = sample;
        State { position, velocity, acceleration, jerk, tag }
    }
}
