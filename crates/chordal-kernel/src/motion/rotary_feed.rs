//! F of straight cuts with rotary axes.

use chordal_command::{FeedAlong, FeedMode, Move, RotaryLength};
use chordal_diagnostics::{Code, Diagnostic};

use crate::kernel::Kernel;
use crate::statement::Statement;

/// A 4th or a 5th axis.
const ORDINALS: [&str; 2] = ["4th", "5th"];

impl Kernel<'_> {
    /// The feed of a straight cut with rotary axes, from the active one (mm/s, or rad/s when only they move), and
    /// the path along which it is measured.
    #[cold]
    pub(super) fn rotary_feed(
        &mut self,
        at: &dyn Statement,
        motion: &Move,
        value: f64,
    ) -> (f64, FeedAlong) {
        let is_per_time = self.state.feed_mode == FeedMode::PerTime;
        let turns_alone = motion.only_turns(None);
        let rotary = match self.rules.rotary_feed.length_of(motion, self.state.units) {
            Ok(Some(rotary)) => rotary,
            Ok(None) => return (value, FeedAlong::Path),
            Err(ordinal) => {
                if self.state.feed_mode != FeedMode::InverseTime {
                    self.report_rotary_diameter(at, ordinal);
                }
                return (value, FeedAlong::Path);
            }
        };
        match (rotary, is_per_time && turns_alone) {
            // Degrees per minute under both rules.
            (RotaryLength::DegreeAsUnit(_), true) => (value, FeedAlong::Path),
            (RotaryLength::ArcOnCylinder { .. }, true) => {
                let feed = self.state.feed.unwrap_or(f64::NAN);
                let per_rad = rotary.vector_mm(0.0, motion) / motion.turn_rad();
                (feed / per_rad, FeedAlong::Path)
            }
            (_, false) => (value, FeedAlong::AllAxes(rotary)),
        }
    }

    /// Reports that F depends on a diameter in the control's settings that the machine file does not give.
    fn report_rotary_diameter(&mut self, at: &dyn Statement, ordinal: usize) {
        if std::mem::replace(&mut self.reported.rotary_diameter, true) {
            return;
        }
        let axis = ORDINALS[ordinal];
        self.report(
            Diagnostic::new(
                Code::UnknownTime,
                at.span(),
                format!(
                    "how fast F turns the {axis} axis depends on its diameter in the control's settings, which is not given"
                ),
            )
            .label("counted in degrees per minute, and beside X, Y and Z not at all")
            .help(format!(
                "give it: --set 'settings.\"{}\"=\"50 mm\"'",
                self.rules.rotary_feed.diameter_names[ordinal]
            )),
        );
    }
}
