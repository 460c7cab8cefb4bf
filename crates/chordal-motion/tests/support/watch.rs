//! What setpoints ask of the axes.

use chordal_geometry::AXES;
use chordal_motion::{AxisValues, KinematicLimits, ServoSetpoint};

/// What rounding does to coordinates of some hundred mm or rad.
pub const AXIS_ROUNDING: AxisValues = [1e-13; AXES];

/// Largest differences of setpoints by time, over limits.
#[derive(Debug, Default)]
pub struct Watch {
    last: Vec<AxisValues>,
    /// Ratios of velocity, acceleration and jerk of each axis to their limits, by differences.
    pub worst: [AxisValues; 3],
    /// Ratios of the velocity and acceleration that come with the setpoint.
    pub reported: [f64; 2],
}

impl Watch {
    pub fn take(&mut self, point: &ServoSetpoint, period_s: f64, limits: &KinematicLimits) {
        self.last.push(point.position);
        if self.last.len() > 4 {
            self.last.remove(0);
        }
        let back = |axis: usize, count: usize| {
            let at = self.last.len().checked_sub(1 + count)?;
            Some(self.last[at][axis])
        };
        for axis in 0..AXES {
            let Some(limit) = limits.axis(axis) else { continue };
            let [a, b, c, d] = [3, 2, 1, 0].map(|count| back(axis, count));
            let mut take = |row: usize, value: Option<f64>, limit: f64| {
                if let Some(value) = value {
                    let share = value.abs() / period_s.powi(row as i32 + 1) / limit;
                    let worst = &mut self.worst[row][axis];
                    *worst = worst.max(share);
                }
            };
            let (Some(d), Some(c)) = (d, c) else { continue };
            take(0, Some(d - c), limit.velocity);
            take(1, b.map(|b| d - 2.0 * c + b), limit.acceleration);
            take(2, a.zip(b).map(|(a, b)| d - 3.0 * c + 3.0 * b - a), limit.jerk);
            self.reported[0] = self.reported[0].max(point.velocity[axis].abs() / limit.velocity);
            self.reported[1] =
                self.reported[1].max(point.acceleration[axis].abs() / limit.acceleration);
        }
    }

    /// Fails when a limit was broken by more than a relative 1e-6 and what `rounding` of each
    /// coordinate does to its differences: their weights add up to 2, 4 and 8.
    pub fn check(&self, period_s: f64, limits: &KinematicLimits, rounding: &AxisValues) {
        for (axis, rounding) in rounding.iter().enumerate() {
            let Some(limit) = limits.axis(axis) else { continue };
            let limits = [limit.velocity, limit.acceleration, limit.jerk];
            for (row, (worst, limit)) in self.worst.iter().zip(limits).enumerate() {
                let order = row as i32 + 1;
                let slack = rounding * 2.0_f64.powi(order) / period_s.powi(order) / limit;
                assert!(worst[axis] <= 1.0 + 1e-6 + slack, "axis {axis}: {self:?}");
            }
        }
        for reported in self.reported {
            assert!(reported <= 1.0 + 1e-6, "{self:?}");
        }
    }
}
