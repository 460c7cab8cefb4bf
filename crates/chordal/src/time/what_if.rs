//! Plans the same program with other overrides and path modes.

use crate::job::Job;
use crate::motion::{LimitError, MotionOptions};
use chordal_command::PathMode;

/// A change of what the program or the machine sets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlanningChange {
    /// The feed override as a factor; 1 is as programmed.
    Feed(f64),
    /// The rapid override as a factor; 1 is full speed.
    Rapid(f64),
    /// The path mode of every cut.
    Corners(PathMode),
    /// A smoothness level of the control for every cut: corners are rounded within a distance.
    Smoothness {
        /// 1 rough, 2 medium, 3 finish.
        level: u8,
        /// The distance, mm.
        tolerance_mm: f64,
    },
}

/// The time of the program with a change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimeAlternative {
    /// The change.
    pub change: PlanningChange,
    /// Time of the whole program, s.
    pub total_s: f64,
}

/// Changes that are tried: positions of an override switch, and tolerances that are usual for finishing, general work
/// and roughing.
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
    /// The changes that have an effect on the control: the usual ones, and its smoothness levels where it has any.
    pub fn changes(&self) -> Vec<PlanningChange> {
        let rules = &self.rules().path;
        let has_levels = rules.level_parts.iter().any(|part| *part != rules.level_parts[0]);
        let levels = (1..=3).filter(|_| has_levels).filter_map(|level| {
            let tolerance_mm = rules.of_level(level)?;
            Some(PlanningChange::Smoothness { level, tolerance_mm })
        });
        // Where the control uses junction deviation, a corner tolerance has no effect.
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
