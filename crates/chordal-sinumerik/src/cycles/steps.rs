//! What a drilling cycle does, step by step.

use super::CycleSettings;

/// What a drilling cycle takes from the program around it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct HoleContext {
    /// The coordinate of the drilling axis before the cycle, in units of the program.
    pub current_level: f64,
    /// The spindle before the cycle: 3 (M3), 4 (M4) or 5 (stopped).
    pub spindle_direction: u8,
    /// Millimetres of a unit of length of the program: 1, or 25.4 for inches.
    pub unit_mm: f64,
    /// What the sources leave open.
    pub settings: CycleSettings,
}

impl Default for HoleContext {
    /// At level 0 with the spindle on M3, in millimetres.
    fn default() -> HoleContext {
        HoleContext {
            current_level: 0.0,
            spindle_direction: 3,
            unit_mm: 1.0,
            settings: CycleSettings::default(),
        }
    }
}

/// A step of a hole. Levels are absolute coordinates of the drilling axis in the workpiece, in units of the program.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum HoleStep {
    /// Rapid to a level.
    Rapid(f64),
    /// At the feed of the program times a factor.
    Feed {
        /// The level.
        to: f64,
        /// 1, or FRF of CYCLE83.
        factor: f64,
    },
    /// At a feed that is an argument of the cycle.
    FeedAt {
        /// The level.
        to: f64,
        /// In units of the program: per minute or per revolution, as F.
        feed: f64,
    },
    /// Dwell in seconds.
    Dwell {
        /// More than 0.
        seconds: f64,
    },
    /// Dwell in revolutions of the spindle.
    DwellRevolutions {
        /// More than 0.
        revolutions: f64,
    },
    /// M5.
    SpindleStop,
    /// The other direction of rotation.
    SpindleReverse,
    /// M3, M4 or M5, by the number.
    SpindleRestore(u8),
    /// SPOS: the spindle stops at an angle.
    Orient {
        /// POSS; `None` when it is left out.
        degrees: Option<f64>,
    },
    /// Rapid by increments in the plane and along the drilling axis, in units of the program.
    RapidInPlane {
        /// Along the first axis of the plane.
        a: f64,
        /// Along the second axis of the plane.
        b: f64,
        /// Along the drilling axis.
        normal: f64,
    },
    /// M0.
    Stop,
    /// Into the thread, coupled to the spindle.
    TapIn {
        /// The level.
        to: f64,
        /// The lead in millimetres a revolution, negative for a left-hand thread.
        pitch_mm: f64,
        /// SST in revolutions a minute; `None` for the speed of the program.
        spindle_rpm: Option<f64>,
    },
    /// Out of the thread, coupled to the spindle, which turns the other direction.
    TapOut {
        /// The level.
        to: f64,
        /// The lead in millimetres a revolution, negative for a left-hand thread.
        pitch_mm: f64,
        /// SST1, or SST when that is 0, in revolutions a minute; `None` for the speed of the program.
        spindle_rpm: Option<f64>,
    },
}

/// The steps of a hole so far, and the level at which they end.
pub(super) struct StepList {
    pub(super) steps: Vec<HoleStep>,
    level: f64,
}

impl StepList {
    pub(super) fn new(level: f64) -> StepList {
        StepList { steps: Vec::new(), level }
    }

    /// Rapid to a level; no step when the tool is there.
    pub(super) fn rapid(&mut self, to: f64) {
        if to != self.level {
            self.steps.push(HoleStep::Rapid(to));
            self.level = to;
        }
    }

    pub(super) fn feed(&mut self, to: f64, factor: f64) {
        self.level = to;
        self.steps.push(HoleStep::Feed { to, factor });
    }

    pub(super) fn feed_at(&mut self, to: f64, feed: f64) {
        self.level = to;
        self.steps.push(HoleStep::FeedAt { to, feed });
    }

    pub(super) fn tap_in(&mut self, to: f64, pitch_mm: f64, spindle_rpm: Option<f64>) {
        self.level = to;
        self.steps.push(HoleStep::TapIn { to, pitch_mm, spindle_rpm });
    }

    pub(super) fn tap_out(&mut self, to: f64, pitch_mm: f64, spindle_rpm: Option<f64>) {
        self.level = to;
        self.steps.push(HoleStep::TapOut { to, pitch_mm, spindle_rpm });
    }

    /// Rapid by increments; no step when they are all 0.
    pub(super) fn rapid_by(&mut self, [a, b, normal]: [f64; 3]) {
        if [a, b, normal] != [0.0; 3] {
            self.level += normal;
            self.steps.push(HoleStep::RapidInPlane { a, b, normal });
        }
    }

    /// A dwell as G4: seconds when positive, revolutions when negative, none when 0.
    pub(super) fn dwell(&mut self, amount: f64) {
        if amount > 0.0 {
            self.steps.push(HoleStep::Dwell { seconds: amount });
        } else if amount < 0.0 {
            self.steps.push(HoleStep::DwellRevolutions { revolutions: -amount });
        }
    }

    pub(super) fn push(&mut self, step: HoleStep) {
        self.steps.push(step);
    }
}
