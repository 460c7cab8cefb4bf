//! Full circles that shrink to almost nothing because start and end differ by an increment.

use chordal_command::telling_number;
use chordal_diagnostics::{Code, Diagnostic};
use chordal_geometry::ArcSweep;

use crate::kernel::Kernel;
use crate::statement::Statement;

/// A shorter arc may be meant as a full circle, rad.
const VANISHING_SWEEP_RAD: f64 = 0.01;

/// Start and end may differ by this many least increments through rounding: half of one for each of two words,
/// and half for a sum.
const VANISHING_INCREMENTS: f64 = 1.5;

impl Kernel<'_> {
    /// Reports, once a run, a very short arc whose end misses the start by an increment.
    #[inline]
    pub(super) fn check_vanishing_circle(&mut self, at: &dyn Statement, fit: &ArcSweep) {
        let is_short = fit.sweep.abs() < VANISHING_SWEEP_RAD;
        if is_short && !self.reported.vanishing_circle {
            self.report_vanishing_circle(at, fit);
        }
    }

    #[cold]
    fn report_vanishing_circle(&mut self, at: &dyn Statement, fit: &ArcSweep) {
        let missed_mm = fit.sweep.abs() * fit.radius_start;
        if missed_mm > VANISHING_INCREMENTS * self.rules.least_increment(self.state.units) {
            return;
        }
        self.reported.vanishing_circle = true;
        let (angle, missed) = (fit.sweep.abs().to_degrees(), self.length_text(missed_mm));
        let message = format!(
            "this arc turns {}°: its end misses the start by {missed}",
            telling_number(angle, 4)
        );
        self.report(
            Diagnostic::new(Code::VanishingCircle, at.span(), message)
                .help("for a full circle, write the start as the end"),
        );
    }
}
