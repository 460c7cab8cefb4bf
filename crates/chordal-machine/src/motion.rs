//! How a machine moves: what is not the limit of one axis.

/// How the machine moves. `None`: the file does not say, and the default holds.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MotionSettings {
    /// The control sends a place to the axes so often, s.
    pub servo_period_s: Option<f64>,
    /// Where the feed override stands; 1 is as programmed.
    pub feed_override: Option<f64>,
    /// Where the rapid override stands; 1 is full speed.
    pub rapid_override: Option<f64>,
    /// How far from the programmed path a corner may be passed where the path mode lets the
    /// control round corners and names no tolerance, mm.
    pub corner_tolerance_mm: Option<f64>,
    /// How far from the programmed path the places may be eased in exact path mode where the
    /// path is smooth and its curvature is not, mm.
    pub exact_path_tolerance_mm: Option<f64>,
    /// How far from the straight line the bends of a dog-leg rapid, and the corner between two
    /// rapids that follow each other without a stop, may be passed, mm.
    pub rapid_corner_tolerance_mm: Option<f64>,
    /// How far from its programmed angle a rotary axis may be at a corner that is rounded, rad.
    pub rotary_tolerance_rad: Option<f64>,
}

impl MotionSettings {
    /// The servo period, s; 1 ms where the file names none.
    pub fn servo_period_s(&self) -> f64 {
        self.servo_period_s.unwrap_or(0.001)
    }

    /// The feed override; 1 where the file names none.
    pub fn feed_override(&self) -> f64 {
        self.feed_override.unwrap_or(1.0)
    }

    /// The rapid override; 1 where the file names none.
    pub fn rapid_override(&self) -> f64 {
        self.rapid_override.unwrap_or(1.0)
    }

    /// The tolerance of corners that the control does not give, mm; 0.05 mm, a choice, where
    /// the file names none.
    pub fn corner_tolerance_mm(&self) -> f64 {
        self.corner_tolerance_mm.unwrap_or(0.05)
    }

    /// The tolerance of exact path mode, mm; 0 where the file names none: nothing is eased.
    pub fn exact_path_tolerance_mm(&self) -> f64 {
        self.exact_path_tolerance_mm.unwrap_or(0.0)
    }

    /// The tolerance of bends of rapids, mm; 10 mm, a choice, where the file names none.
    pub fn rapid_corner_tolerance_mm(&self) -> f64 {
        self.rapid_corner_tolerance_mm.unwrap_or(10.0)
    }

    /// The tolerance of rotary axes at corners, rad; 0.01 degrees, a choice, where the file
    /// names none.
    pub fn rotary_tolerance_rad(&self) -> f64 {
        self.rotary_tolerance_rad.unwrap_or(0.01_f64.to_radians())
    }
}
