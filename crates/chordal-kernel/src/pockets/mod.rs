//! Pockets and routines: the tool follows a path that `shapes` has computed.

mod circles;
mod region;
pub mod shapes;

use chordal_command::{ArcShape, AxisMask, CommandKind, Feed, FeedAlong, FeedMode, Position};
use chordal_diagnostics::{Code, Diagnostic, Span};
use chordal_geometry::{Plane, Vec2};

pub use circles::CirclesWords;
pub use region::{RegionWords, rings_to_depth};
use shapes::Step;

use crate::kernel::Kernel;

/// Largest number of rings or rows of one pocket; more comes from a mistake in the stepover.
pub const MAX_RINGS: u32 = 10_000;

impl Kernel<'_> {
    /// Moves along a path in XY at the present height. `named` are the axes whose position the program
    /// itself gives.
    pub fn follow(&mut self, steps: &[Step], feed: Feed, named: AxisMask) {
        let cycle = std::mem::replace(&mut self.origin.cycle, true);
        for step in steps {
            let to = step.to();
            let from = Vec2::new(self.state.position[0], self.state.position[1]);
            let mut target = self.state.position;
            target[0] = to.a;
            target[1] = to.b;
            let motion = self.moved_to(target, named);
            self.emit(match *step {
                Step::Line { .. } => CommandKind::Line { motion, feed },
                Step::Arc { center, sweep, .. } => {
                    let shape = ArcShape {
                        plane: Plane::Xy,
                        center: [center.a, center.b],
                        sweep,
                        radius_from: from.distance(center),
                        radius_to: to.distance(center),
                    };
                    CommandKind::Arc { motion, shape, feed }
                }
            });
        }
        self.origin.cycle = cycle;
    }

    /// Makes a straight cut of a built-in routine.
    pub fn routine_line(&mut self, target: Position, named: AxisMask, feed: Feed) {
        let cycle = std::mem::replace(&mut self.origin.cycle, true);
        let motion = self.moved_to(target, named);
        self.emit(CommandKind::Line { motion, feed });
        self.origin.cycle = cycle;
    }

    /// Makes a rapid of a built-in routine, unless the position is already reached.
    pub fn routine_rapid(&mut self, target: Position, named: AxisMask) {
        if target == self.state.position && self.state.known.covers(named) {
            return;
        }
        let cycle = std::mem::replace(&mut self.origin.cycle, true);
        self.rapid(target, named);
        self.origin.cycle = cycle;
    }

    /// A feed per time of a built-in routine itself, mm/s.
    pub fn routine_feed(&self, value: f64) -> Feed {
        Feed {
            value,
            mode: FeedMode::PerTime,
            along: FeedAlong::Path,
            spindle_rev_per_s: self.state.rpm / 60.0,
            lead_change: 0.0,
            surface: None,
        }
    }

    /// Reports once a run that the path of a built-in routine is assumed, and which path.
    pub fn note_assumed_path(&mut self, span: Span, name: &str, choice: &str, text: String) {
        if self.reported.assumed_paths.iter().any(|known| known == name) {
            return;
        }
        self.reported.assumed_paths.push(name.to_string());
        self.report(
            Diagnostic::new(
                Code::PocketPathAssumed,
                span,
                format!("the manuals do not give the exact path of {name}: {choice}"),
            )
            .label(text)
            .help("size, depth, start and end are those of the control; the order of the passes may differ"),
        );
    }

    /// Reports more than [`MAX_RINGS`] rings, rows or levels.
    pub fn report_too_many_passes(&mut self, span: Span, what: &str) {
        self.report(
            Diagnostic::new(
                Code::BudgetReached,
                span,
                format!("this pocket would take more than {MAX_RINGS} {what}"),
            )
            .label("not carried out")
            .help("check the step: a decimal point, a unit"),
        );
    }
}
