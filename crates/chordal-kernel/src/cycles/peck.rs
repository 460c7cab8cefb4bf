//! G73 and G83: down in steps.

use chordal_diagnostics::{Code, Diagnostic};

use super::hole::{HoleWords, LEVEL_EPSILON_MM};
use crate::kernel::Kernel;
use crate::rules::PeckDwell;
use crate::statement::Statement;

/// Most pecks of one hole: more is a slip in Q.
pub(super) const MAX_PECKS: u32 = 10_000;

/// Pecks of a hole that are not counted against the budget.
pub(super) const FREE_PECKS: u32 = 100;

/// How deep the pecks of a hole go.
#[derive(Clone, Copy)]
enum PeckSteps {
    /// Q, every time.
    Even(f64),
    /// I, then less by J each time, never less than K.
    Decreasing { first: f64, less: f64, least: f64 },
}

impl PeckSteps {
    fn depth(self, peck: u32) -> f64 {
        match self {
            PeckSteps::Even(q) => q,
            PeckSteps::Decreasing { first, less, least } => {
                (first - f64::from(peck - 1) * less).max(least)
            }
        }
    }

    /// Depth below R after some pecks.
    fn total(self, before: f64, peck: u32) -> f64 {
        match self {
            // A product, so that a thousand steps are as exact as one.
            PeckSteps::Even(q) => f64::from(peck) * q,
            PeckSteps::Decreasing { .. } => before + self.depth(peck),
        }
    }
}

impl Kernel<'_> {
    /// Pecks down to the depth: with a return to R after each (G83), or a lift (G73).
    pub fn pecks(&mut self, at: &dyn Statement, hole: &HoleWords, full: bool) {
        let rules = self.rules.cycles.peck;
        let parameters = &self.rules;
        let lift = if full { parameters.peck_clearance_mm } else { parameters.chip_break_mm };
        // Scaling acts on the levels of a cycle, not on its steps.
        let lift = self.unscaled(hole.axis, hole.words.lift.unwrap_or(lift));
        let dwell_each = rules.dwell == PeckDwell::EachPeck && !full;
        let steps = self.peck_steps(hole);
        let return_after = hole.words.vector[2]
            .map(|k| self.unscaled(hole.axis, k.abs()))
            .filter(|k| !full && rules.return_after_k && *k > 0.0 && steps_are_even(steps));
        let above = if full || rules.chip_break_above_r { rules.return_above_r_mm } else { 0.0 };
        let above = self.unscaled(hole.axis, above);
        let (mut total, mut returned_at) = (0.0, 0.0);
        for peck in 1..=MAX_PECKS {
            total = steps.total(total, peck);
            let depth = hole.r - total;
            if depth <= hole.z + LEVEL_EPSILON_MM {
                break;
            }
            if steps.depth(peck) <= 0.0 || peck == MAX_PECKS {
                self.report_too_many_pecks(at, hole);
                break;
            }
            // So many pecks count as blocks, lest a repeated slip in Q goes on for hours.
            if peck > FREE_PECKS && !self.count_repeated() {
                break;
            }
            self.feed_to(at, hole, depth);
            if dwell_each {
                self.wait(hole.words.dwell_s);
            }
            self.wait(Some(rules.dwell_each_s));
            let due = return_after.is_some_and(|k| total - returned_at >= k - LEVEL_EPSILON_MM);
            if full || due {
                returned_at = total;
                let to_clear = full && rules.returns_to_clear;
                self.level(hole, if to_clear { hole.clear } else { hole.r + above });
            }
            if !(full && rules.feeds_down) {
                self.level(hole, (depth + lift).min(hole.r));
            }
        }
        self.feed_to(at, hole, hole.z);
        if dwell_each || rules.dwell == PeckDwell::Bottom {
            self.wait(hole.words.dwell_s);
        }
        self.wait(Some(rules.dwell_each_s));
    }

    fn peck_steps(&self, hole: &HoleWords) -> PeckSteps {
        let [first, less, least] =
            hole.words.vector.map(|word| word.map(|step| self.unscaled(hole.axis, step.abs())));
        let decreasing = self.rules.cycles.peck.decreasing;
        match (first, hole.words.q) {
            (Some(first), _) if decreasing && first > 0.0 => {
                let least = least.unwrap_or(0.0);
                PeckSteps::Decreasing { first, less: less.unwrap_or(0.0), least }
            }
            (_, q) => PeckSteps::Even(self.unscaled(hole.axis, q.unwrap_or(0.0).abs())),
        }
    }

    fn report_too_many_pecks(&mut self, at: &dyn Statement, hole: &HoleWords) {
        let depth = self.length_text(hole.r - hole.z);
        let span = at.span();
        self.report(
            Diagnostic::new(
                Code::TooManyPecks,
                span,
                format!("{MAX_PECKS} pecks do not reach a depth of {depth}"),
            )
            .label("the rest is drilled in one go")
            .help("check Q (or I, J, K): is the decimal point right?"),
        );
    }
}

fn steps_are_even(steps: PeckSteps) -> bool {
    matches!(steps, PeckSteps::Even(_))
}
