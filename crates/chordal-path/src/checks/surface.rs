//! Checks of moves on a surface that turns with a rotary axis: travel, and the speed of the rotary axis.

use chordal_command::{CommandKind, Feed, Move, Origin, RotarySurface, number_text};
use chordal_diagnostics::{Code, Diagnostic};
use chordal_geometry::{Curve, ParamCurve};
use chordal_machine::Axis;

use super::RunChecks;
use crate::builder::duration_s;
use crate::compensation::PathCommand;
use crate::rotary::fastest_turn;
use crate::rotary_extremes::places_on_axes;
use crate::segment::curve_of;

impl RunChecks<'_> {
    /// Follows a command on a surface that turns with a rotary axis: checks the travel of the real axes and the speed of
    /// the rotary one.
    #[cold]
    pub(super) fn on_surface(
        &mut self,
        path: PathCommand<'_>,
        report: &mut impl FnMut(Diagnostic),
    ) {
        let command = path.command;
        self.now.frame.follow(command);
        if let CommandKind::Units(units) = &command.kind {
            self.now.units = *units;
        }
        let (Some(run), Some(motion)) = (self.now.frame.surface, command.kind.motion()) else {
            return;
        };
        self.now.last = None;
        self.end_legs();
        let curve = curve_of(motion, command.kind.shape());
        let surface = run.surface;
        let (places, known) = places_on_axes(&run, motion, command.kind.shape());
        for place in places {
            self.extend(&place, known);
            self.travel(&place, known, command.origin, report);
        }
        if let Some(feed) = command.kind.feed() {
            self.rotary_speed(&surface, feed, motion, &curve, command.origin, report);
        }
    }

    /// Reports a feed for which the rotary axis would have to turn faster than it can.
    fn rotary_speed(
        &mut self,
        surface: &RotarySurface,
        feed: &Feed,
        motion: &Move,
        curve: &Curve,
        origin: Origin,
        report: &mut impl FnMut(Diagnostic),
    ) {
        let limits = self.machine.axes[surface.rotary].as_ref();
        let Some(most) = limits.and_then(|limits| limits.max_velocity) else { return };
        let (length, seconds) = (curve.length(), duration_s(feed, motion, curve));
        if self.now.reported_speed || self.assumed || seconds <= 0.0 || length <= 0.0 {
            return;
        }
        let (turn, radius) = fastest_turn(surface, curve, length / seconds);
        if turn <= most * (1.0 + 1e-9) {
            return;
        }
        self.now.reported_speed = true;
        let letter = Axis::ALL[surface.rotary].letter();
        let per_minute =
            |value: f64| format!("{} deg/min", number_text(value.to_degrees() * 60.0, 0));
        let (turn, most_text) = (per_minute(turn), per_minute(most));
        let place = self.now.units.length_text(radius);
        let allowed = self.now.units.length_text(most * radius * 60.0);
        let message =
            format!("{letter} would turn at {turn} at radius {place}: its largest is {most_text}");
        report(
            Diagnostic::new(Code::RotarySpeed, origin.span, message)
                .label(format!("at most {allowed} a minute at this radius"))
                .help("use a lower F, or keep the tool farther from the centre"),
        );
    }
}
