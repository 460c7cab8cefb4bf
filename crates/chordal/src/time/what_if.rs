//! The same program with other overrides and path modes.

use crate::job::Job;
use crate::motion::{LimitError, MotionOptions};
use chordal_command::PathMode;

/// What is other than in the program and on the machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlanningChange {
    /// The feed override; 1 is as programmed.
    Feed(f64),
    /// The rapid override; 1 is full speed.
    Rapid(f64),
    /// The path mode of every cut.
    Corners(PathMode),
    /// A level of smoothness of the control, which rounds corners within a distance, for every
    /// cut.
    Smoothness {
        /// 1 rough, 2 medium, 3 finish.
        level: u8,
        /// The distance, mm.
        tolerance_mm: f64,
    },
}

/// The time that a change would make.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeAlternative {
    /// The change.
    pub change: PlanningChange,
    /// All of the program, s.
    pub total_s: f64,
}

/// Changes that are tried: the marks of an override switch, and the tolerances that are
/// usual for finishing, general work and roughing.
const CHANGES: [PlanningChange; 11] = [
    PlanningChange::Feed(0.5),
    PlanningChange::Feed(0.8),
    PlanningChange::Feed(1.0),
    PlanningChange::Feed(1.2),
    PlanningChange::Feed(1.5),
    PlanningChange::Rapid(0.25),
    PlanningChange::Rapid(0.5),
    PlanningChange::Corners(PathMode::ExactStop),
    PlanningChange::Corners(PathMode::Continuous { tolerance_mm: Some(0.01), joined: false }),
    PlanningChange::Corners(PathMode::Continuous { tolerance_mm: Some(0.05), joined: false }),
    PlanningChange::Corners(PathMode::Continuous { tolerance_mm: Some(0.1), joined: false }),
];

impl Job<'_> {
    /// The changes that make sense on the control: the usual ones, and its levels of
    /// smoothness where it has any.
    pub fn changes(&self) -> Vec<PlanningChange> {
        let rules = &self.control().parameters.rules.path;
        let has_levels = rules.level_parts.iter().any(|part| *part != rules.level_parts[0]);
        let levels = (1..=3).filter(|_| has_levels).filter_map(|level| {
            let tolerance_mm = rules.of_level(level)?;
            Some(PlanningChange::Smoothness { level, tolerance_mm })
        });
        // Where corners are passed by junction deviation, no distance from them changes anything.
        let acts = |change: &PlanningChange| {
            let by_distance =
                matches!(change, PlanningChange::Corners(PathMode::Continuous { .. }));
            rules.junctions.is_none() || !by_distance
        };
        CHANGES.into_iter().chain(levels).filter(acts).collect()
    }

    /// Plans the program again for each change.
    ///
    /// # Errors
    /// A limit of an axis that is not a positive number.
    pub fn what_if(
        &self,
        options: &MotionOptions,
        changes: &[PlanningChange],
    ) -> Result<Vec<TimeAlternative>, LimitError> {
        changes
            .iter()
            .map(|change| {
                let mut changed = *options;
                match *change {
                    PlanningChange::Feed(part) => changed.feed_override = Some(part),
                    PlanningChange::Rapid(part) => changed.rapid_override = Some(part),
                    PlanningChange::Corners(mode) => changed.path_mode = Some(mode),
                    PlanningChange::Smoothness { tolerance_mm, .. } => {
                        let tolerance_mm = Some(tolerance_mm);
                        changed.path_mode =
                            Some(PathMode::Continuous { tolerance_mm, joined: false });
                    }
                }
                let total_s = self.time(&changed)?.time.total_s();
                Ok(TimeAlternative { change: *change, total_s })
            })
            .collect()
    }
}
