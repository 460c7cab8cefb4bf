//! The limits of a machine's axes, with typical values for what its file does not give.

use chordal_machine::{AXES, Axis, AxisLimits, Machine};
use chordal_motion::{
    ArcSegmentLengths, AxisLimit, JunctionRule, KinematicLimits, LimitError, LimitedQuantity,
};

use crate::languages::configured_control;

/// A limit that the machine file does not give.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AssumedLimit {
    /// The axis.
    pub axis: Axis,
    /// Which of its limits.
    pub quantity: LimitedQuantity,
    /// The typical value that was taken, in mm or rad and s.
    pub value: f64,
}

/// The limits of a machine's axes for the planner.
#[derive(Clone, Debug, PartialEq)]
pub struct MachineLimits {
    /// Limits of cuts.
    pub cut: KinematicLimits,
    /// Limits of rapids.
    pub rapid: KinematicLimits,
    /// Limits that the machine file does not give.
    pub assumed: Vec<AssumedLimit>,
    /// The rule of a control that plans trapezoidal speed profiles with junction deviation; `None` for all others.
    pub junctions: Option<JunctionRule>,
}

/// Typical of a machining centre of middle size: 24 m/min, 3 m/s², 100 m/s³.
const TYPICAL_LINEAR: AxisLimit =
    AxisLimit { velocity: 400.0, acceleration: 3000.0, jerk: 100_000.0 };

/// Typical of a rotary table of middle size, in degrees: 100 deg/s, 500 deg/s², 10000 deg/s³.
const TYPICAL_ROTARY_DEG: AxisLimit =
    AxisLimit { velocity: 100.0, acceleration: 500.0, jerk: 10_000.0 };

impl MachineLimits {
    /// The limits of a machine; typical ones where its file gives none.
    ///
    /// # Errors
    /// The first limit that is not a positive number.
    pub fn of(machine: &Machine) -> Result<MachineLimits, LimitError> {
        let mut assumed = Vec::new();
        let mut cut = [None; AXES];
        let mut rapid = [None; AXES];
        let control = configured_control(machine).map(|(control, _)| control);
        let rules = control.as_ref().map(|control| control.rules().path);
        let junctions = rules.and_then(|rules| rules.junctions).map(|rules| JunctionRule {
            deviation_mm: rules.deviation_mm,
            blocks: rules.blocks as usize,
            arc_tolerance_mm: rules.arc_tolerance_mm,
            arc_segments: rules.arc_segments.map(|segments| ArcSegmentLengths {
                least_mm: segments.least_mm,
                most_mm: segments.most_mm,
                of_circle: f64::from(segments.of_circle),
            }),
            speed_steps_mm_s: rules.speed_steps_mm_s,
            steps_per_mm: rules.steps_per_mm,
            limited_jerk: rules.limited_jerk,
        });
        for axis in Axis::ALL {
            let Some(own) = machine.axis(axis) else { continue };
            let limit = of_axis(axis, own, &mut assumed);
            cut[axis as usize] = Some(limit);
            rapid[axis as usize] = Some(AxisLimit {
                acceleration: own.rapid_acceleration.unwrap_or(limit.acceleration),
                jerk: own.rapid_jerk.unwrap_or(limit.jerk),
                ..limit
            });
        }
        // On a lathe without a Y axis, the coordinate across a face or along the circumference of a cylinder is made
        // by the C axis. It is planned with the limits of X; of C only the speed limit counts.
        let (x, y) = (Axis::X as usize, Axis::Y as usize);
        if machine.turns() && cut[y].is_none() && machine.axis(Axis::C).is_some() {
            (cut[y], rapid[y]) = (cut[x], rapid[x]);
        }
        let (cut, rapid) = (KinematicLimits::new(cut)?, KinematicLimits::new(rapid)?);
        Ok(MachineLimits { cut, rapid, assumed, junctions })
    }
}

fn of_axis(axis: Axis, own: &AxisLimits, assumed: &mut Vec<AssumedLimit>) -> AxisLimit {
    let typical = match axis.is_rotary() {
        false => TYPICAL_LINEAR,
        true => AxisLimit {
            velocity: TYPICAL_ROTARY_DEG.velocity.to_radians(),
            acceleration: TYPICAL_ROTARY_DEG.acceleration.to_radians(),
            jerk: TYPICAL_ROTARY_DEG.jerk.to_radians(),
        },
    };
    let mut take = |quantity, own: Option<f64>, value| {
        own.unwrap_or_else(|| {
            assumed.push(AssumedLimit { axis, quantity, value });
            value
        })
    };
    AxisLimit {
        velocity: take(LimitedQuantity::Velocity, own.max_velocity, typical.velocity),
        acceleration: take(
            LimitedQuantity::Acceleration,
            own.max_acceleration,
            typical.acceleration,
        ),
        jerk: take(LimitedQuantity::Jerk, own.max_jerk, typical.jerk),
    }
}
