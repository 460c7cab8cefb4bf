//! Settings of motion that are not limits of one axis.

/// Settings of motion. `None`: not given, and the default is used.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MotionSettings {
    /// The period in which the control sends positions to the axes, s.
    pub servo_period_s: Option<f64>,
    /// The feed override; 1 is the programmed feed.
    pub feed_override: Option<f64>,
    /// The rapid override; 1 is full speed.
    pub rapid_override: Option<f64>,
    /// The largest deviation from the programmed path at a corner, mm, if the path mode lets the control round corners
    /// and has no tolerance.
    pub corner_tolerance_mm: Option<f64>,
    /// The largest deviation from the programmed path in exact path mode, mm, where the path is smooth but its
    /// curvature is not.
    pub exact_path_tolerance_mm: Option<f64>,
    /// The largest deviation at the bends of a dog-leg rapid, and at the corner between two consecutive rapids without
    /// a stop, mm.
    pub rapid_corner_tolerance_mm: Option<f64>,
    /// The largest deviation of a rotary axis at a rounded corner, rad.
    pub rotary_tolerance_rad: Option<f64>,
}

impl MotionSettings {
    /// The servo period, s; 1 ms by default.
    pub fn servo_period_s(&self) -> f64 {
        self.servo_period_s.unwrap_or(0.001)
    }

    /// The feed override; 1 by default.
    pub fn feed_override(&self) -> f64 {
        self.feed_override.unwrap_or(1.0)
    }

    /// The rapid override; 1 by default.
    pub fn rapid_override(&self) -> f64 {
        self.rapid_override.unwrap_or(1.0)
    }

    /// The tolerance of corners for which the control has none, mm; by default 0.05 mm, which is an assumption.
    pub fn corner_tolerance_mm(&self) -> f64 {
        self.corner_tolerance_mm.unwrap_or(0.05)
    }

    /// The tolerance of exact path mode, mm; by default 0: no deviation.
    pub fn exact_path_tolerance_mm(&self) -> f64 {
        self.exact_path_tolerance_mm.unwrap_or(0.0)
    }

    /// The tolerance at bends of rapids, mm; by default 10 mm, which is an assumption.
    pub fn rapid_corner_tolerance_mm(&self) -> f64 {
        self.rapid_corner_tolerance_mm.unwrap_or(10.0)
    }

    /// The tolerance of rotary axes at corners, rad; by default 0.01 degrees, which is an assumption.
    pub fn rotary_tolerance_rad(&self) -> f64 {
        self.rotary_tolerance_rad.unwrap_or(0.01_f64.to_radians())
    }
}
