//! Pecking along Z (G74) or X (G75), in one or several plunges.

use chordal_diagnostics::{Code, Diagnostic};

use crate::kernel::Kernel;
use crate::statement::Statement;
use crate::turning::COINCIDENT_MM;

/// Largest number of pecks of one cycle.
const MAX_PECKS: f64 = 100_000.0;

/// The words of a pecking cycle, mm; steps are positive.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct PeckWords {
    /// Pecks along X, not along Z.
    pub along_x: bool,
    /// The end: X (a radius) and Z.
    pub end: [f64; 2],
    /// Depth of a peck; `None` to cut each plunge in one move.
    pub peck: Option<f64>,
    /// Distance between plunges; `None` for a single plunge.
    pub step: Option<f64>,
    /// Relief: how far the tool moves aside at the bottom, from the second plunge on.
    pub aside: f64,
}

impl Kernel<'_> {
    /// Plunges until the end is reached, and returns to the start.
    pub fn peck(&mut self, at: &dyn Statement, words: &PeckWords) {
        let start = self.turned_place();
        let (deep, cross) = if words.along_x { (0, 1) } else { (1, 0) };
        let whole = [words.end[0] - start[0], words.end[1] - start[1]];
        let pecks = words.peck.map_or(1.0, |peck| whole[deep].abs() / peck);
        let plunges = words.step.map_or(1.0, |step| whole[cross].abs() / step + 1.0);
        if pecks * plunges > MAX_PECKS {
            let message = format!(
                "this cycle needs {:.0} pecks; Chordal makes at most {MAX_PECKS:.0}",
                pecks * plunges
            );
            self.report(
                Diagnostic::new(Code::BudgetReached, at.span(), message)
                    .help("are P and Q meant so small? they count least increments"),
            );
            return;
        }
        self.origin.cycle = true;
        if !words.along_x && words.step.is_none() && self.state.known.has(0) {
            self.check_center_speed(at, start[0], false);
        }
        let mut aside = 0.0;
        let mut plunge = 0.0;
        loop {
            let moved = words.step.map_or(0.0, |step| (step * plunge).min(whole[cross].abs()));
            let across = start[cross] + moved * signum(whole[cross]);
            let place =
                |depth: f64, across: f64| if deep == 0 { [depth, across] } else { [across, depth] };
            self.turn_rapid(place(start[deep], across));
            self.plunge(at, words, start[deep], &|depth| place(depth, across));
            if aside != 0.0 {
                let to = across - aside * signum(whole[cross]);
                self.turn_rapid(place(words.end[deep], to));
                self.turn_rapid(place(start[deep], to));
            } else {
                self.turn_rapid(place(start[deep], across));
            }
            aside = words.aside;
            if words.step.is_none() || moved >= whole[cross].abs() - COINCIDENT_MM {
                break;
            }
            plunge += 1.0;
        }
        self.turn_rapid(start);
        self.origin.cycle = false;
    }

    /// One plunge: pecks with a retraction after each, to the end.
    fn plunge(
        &mut self,
        at: &dyn Statement,
        words: &PeckWords,
        from: f64,
        place: &dyn Fn(f64) -> [f64; 2],
    ) {
        let end = words.end[if words.along_x { 0 } else { 1 }];
        let direction = signum(end - from);
        let retract = self.state.turning.peck_retract;
        let Some(peck) = words.peck else { return self.turn_cut(at, place(end)) };
        let mut reached = from;
        loop {
            let next = reached + direction * peck;
            if (end - next) * direction <= COINCIDENT_MM {
                return self.turn_cut(at, place(end));
            }
            self.turn_cut(at, place(next));
            self.turn_rapid(place(next - direction * retract));
            reached = next;
        }
    }
}

fn signum(value: f64) -> f64 {
    if value < 0.0 { -1.0 } else { 1.0 }
}
