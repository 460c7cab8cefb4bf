//! A thread in several passes (G76): each cuts the same area, but at least the minimum depth.

use chordal_diagnostics::{Code, Diagnostic};

use crate::kernel::Kernel;
use crate::statement::Statement;
use crate::turning::COINCIDENT_MM;

/// Largest number of passes of one thread.
const MAX_PASSES: usize = 10_000;

/// The words of the second block of a threading cycle, mm; those of the first block are remembered.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ThreadWords {
    /// X at the root of the thread (a radius), and Z at its end.
    pub end: [f64; 2],
    /// Taper: X of the start minus X of the end, on the radius.
    pub taper: f64,
    /// Height of the thread on the radius.
    pub height: f64,
    /// Depth of the first pass on the radius.
    pub first: f64,
    /// Advance per revolution.
    pub lead: f64,
}

impl Kernel<'_> {
    /// Cuts a thread in passes, and returns to the start.
    pub fn thread_passes(&mut self, at: &dyn Statement, words: &ThreadWords) {
        let start = self.turned_place();
        let memory = self.state.turning.thread;
        let Some(depths) = depths(words, memory.least, memory.finish, memory.finish_passes) else {
            self.report(
                Diagnostic::new(
                    Code::BudgetReached,
                    at.span(),
                    format!("this thread needs more than {MAX_PASSES} passes"),
                )
                .help("is the depth of the first pass meant so small? Q counts least increments"),
            );
            return;
        };
        let out = if start[0] >= words.end[0] { 1.0 } else { -1.0 };
        let forth = if words.end[1] <= start[1] { -1.0 } else { 1.0 };
        let slope = libm::tan(memory.angle_deg.to_radians() / 2.0);
        self.origin.cycle = true;
        for depth in depths {
            let x = words.end[0] + out * (words.height - depth);
            let z = start[1] + forth * depth * slope;
            self.turn_rapid([start[0], z]);
            self.turn_rapid([x + words.taper, z]);
            self.thread_to(at, [x, words.end[1]], [start[0], z], words.lead);
            self.turn_rapid([start[0], words.end[1]]);
            self.turn_rapid(start);
        }
        self.origin.cycle = false;
    }
}

/// The depth of every pass on the radius, mm; `None` for more than [`MAX_PASSES`]. Pass n reaches `first`·√n: with
/// the flanks of a thread, equal steps of n are equal areas.
fn depths(words: &ThreadWords, least: f64, finish: f64, finish_passes: u32) -> Option<Vec<f64>> {
    let rough = words.height - finish;
    let mut depths: Vec<f64> = Vec::new();
    let mut depth = 0.0;
    while depth < rough - COINCIDENT_MM {
        let number = depths.len() as f64;
        let by_area = words.first * ((number + 1.0).sqrt() - number.sqrt());
        depth = (depth + by_area.max(least)).min(rough);
        depths.push(depth);
        if depths.len() > MAX_PASSES {
            return None;
        }
    }
    // Without a finishing allowance the last roughing pass already reaches the full height.
    depths.extend((0..finish_passes.min(99)).map(|_| words.height));
    Some(depths)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_1_SQRT_2;

    #[test]
    fn passes_of_equal_area_and_not_below_the_least() {
        // M24 x 3: P021060 Q100 R100, P1812 Q500.
        let words =
            ThreadWords { end: [10.188, -25.0], taper: 0.0, height: 1.812, first: 0.5, lead: 3.0 };
        let depths = depths(&words, 0.1, 0.1, 2).expect("not too many");
        let expected = [
            0.5,
            FRAC_1_SQRT_2,
            0.8660,
            1.0,
            1.1180,
            1.2247,
            1.3247,
            1.4247,
            1.5247,
            1.6247,
            1.712,
            1.812,
            1.812,
        ];
        assert_eq!(depths.len(), expected.len());
        for (depth, expected) in depths.iter().zip(expected) {
            assert!((depth - expected).abs() < 1e-4, "{depth} for {expected}");
        }
    }
}
