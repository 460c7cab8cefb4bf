//! Position, velocity, acceleration and jerk of the axes at an instant.

use crate::AxisValues;

/// A setpoint.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MotionSample {
    /// The time from the start, s.
    pub time_s: f64,
    /// mm and rad.
    pub position: AxisValues,
    /// mm/s and rad/s.
    pub velocity: AxisValues,
    /// mm/s² and rad/s².
    pub acceleration: AxisValues,
    /// mm/s³ and rad/s³.
    pub jerk: AxisValues,
    /// The tag of the move or of the wait that is being carried out.
    pub tag: u64,
}

impl MotionSample {
    /// Speed of the tool: along X, Y and Z in mm/s, or of the rotary axes in rad/s where they
    /// alone move.
    pub fn speed(&self) -> f64 {
        let length = |axes: &[f64]| axes.iter().map(|v| v * v).sum::<f64>().sqrt();
        let linear = length(&self.velocity[..3]);
        if linear > 0.0 { linear } else { length(&self.velocity[3..]) }
    }
}

/// Position and derivatives of the axes at an instant without a time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AxisState {
    /// mm and rad.
    pub position: AxisValues,
    /// mm/s and rad/s.
    pub velocity: AxisValues,
    /// mm/s² and rad/s².
    pub acceleration: AxisValues,
    /// mm/s³ and rad/s³.
    pub jerk: AxisValues,
    /// The tag of the move that is being carried out.
    pub tag: u64,
}

impl From<MotionSample> for AxisState {
    #[inline]
    fn from(sample: MotionSample) -> AxisState {
        let MotionSample { position, velocity, acceleration, jerk, tag, .. } = sample;
        AxisState { position, velocity, acceleration, jerk, tag }
    }
}
