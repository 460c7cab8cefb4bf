//! The steps of cycles.

use chordal_command::SpindleState;

/// A feed of a step.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum CycleFeed {
    /// A speed, mm/s.
    Speed(f64),
    /// As fast as the machine goes.
    Rapid,
    /// That of the program (an old cycle without F).
    Active,
}

/// A step of a cycle. Levels are programmed coordinates of the tool axis, offsets lie in the plane from where the cycle
/// was called; mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum KlartextCycleStep {
    /// To a level by a rapid.
    Rapid(f64),
    /// To a level at a feed.
    Feed {
        /// The level.
        to: f64,
        /// The feed.
        feed: CycleFeed,
    },
    /// To a point of the plane, on a level.
    Across {
        /// From where the cycle was called.
        offset: [f64; 2],
        /// The feed.
        feed: CycleFeed,
    },
    /// An arc in the plane, on a level.
    Arc {
        /// Its centre, from where the cycle was called.
        center: [f64; 2],
        /// Its end, from there as well.
        end: [f64; 2],
        /// Its angle, rad, positive counter-clockwise.
        sweep_rad: f64,
        /// The feed.
        feed: CycleFeed,
    },
    /// To a point of the plane and a level together.
    Ramp {
        /// From where the cycle was called.
        offset: [f64; 2],
        /// The level.
        to: f64,
        /// The feed.
        feed: CycleFeed,
    },
    /// An arc in the plane that ends on another level.
    ArcRamp {
        /// Its centre, from where the cycle was called.
        center: [f64; 2],
        /// Its end, from there as well.
        end: [f64; 2],
        /// Its angle, rad, positive counter-clockwise.
        sweep_rad: f64,
        /// The level.
        to: f64,
        /// The feed.
        feed: CycleFeed,
    },
    /// A helix about where the cycle was called.
    Helix {
        /// Its angle, rad, positive counter-clockwise.
        sweep_rad: f64,
        /// Its end level.
        to: f64,
        /// The feed.
        feed: CycleFeed,
    },
    /// A wait, s.
    Dwell(f64),
    /// The spindle stops at an angle.
    Orient,
    /// The spindle turns again as before the cycle.
    SpindleOn,
    /// The spindle turns the other way than before the cycle.
    Reverse,
    /// The spindle turns in a direction, and at a speed.
    Turn {
        /// The direction.
        state: SpindleState,
        /// The speed, rev/min; `None` for that of before.
        rpm: Option<f64>,
    },
    /// The coolant by an M function.
    Coolant(u32),
}

impl KlartextCycleStep {
    /// To a level, by a rapid or at a feed.
    pub fn moved(to: f64, feed: CycleFeed) -> KlartextCycleStep {
        match feed {
            CycleFeed::Rapid => KlartextCycleStep::Rapid(to),
            feed => KlartextCycleStep::Feed { to, feed },
        }
    }
}

/// What a cycle finds when it is called; lengths in mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CycleContext {
    /// The programmed coordinate of the tool axis.
    pub level: f64,
    /// The programmed coordinates of the plane.
    pub position: [f64; 2],
    /// The radius of the tool; `None` where it is not known.
    pub tool_radius: Option<f64>,
    /// The angle of its tip from side to side, rad; `None` where it is not known.
    pub point_angle: Option<f64>,
    /// The speed of the spindle, rev/min.
    pub rpm: f64,
    /// The spindle turns counter-clockwise.
    pub turns_left: bool,
    /// How far above the last depth the rapid of cycle 200 ends; `None` for the set-up clearance.
    pub peck_stop: Option<f64>,
    /// A positive depth is an error.
    pub refuses_positive_depth: bool,
}

impl CycleContext {
    /// The radius of the tool, without which a cycle is not carried out.
    ///
    /// # Errors
    /// Where it is not known.
    pub fn needed_tool_radius(&self, cycle: u32) -> Result<f64, KlartextCycleFault> {
        self.tool_radius.ok_or(KlartextCycleFault::MissingRadius(cycle))
    }

    /// A point of the plane as an offset from where the tool is, mm.
    pub fn offset_to(&self, [a, b]: [f64; 2]) -> [f64; 2] {
        [a - self.position[0], b - self.position[1]]
    }

    /// Whether the tool goes round clockwise in a pocket or a bore: up-cut (Q351 is -1) with a spindle that turns
    /// clockwise, or climb with the other.
    pub fn turns_clockwise_inside(&self, climb: f64) -> bool {
        (climb < 0.0) != self.turns_left
    }
}

/// Why a cycle is not run.
#[derive(Clone, PartialEq, Debug)]
pub enum KlartextCycleFault {
    /// Data are missing, by the names of their words.
    Incomplete(String),
    /// A value that does not fit, in words.
    BadValue(String),
    /// The tool does not fit, in words.
    ToolTooLarge(String),
    /// The cycle is not carried out here, in words.
    NotFollowed(String),
    /// The radius of the tool is not known, which this cycle needs.
    MissingRadius(u32),
}
