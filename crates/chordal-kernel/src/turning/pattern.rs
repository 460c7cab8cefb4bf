//! Pattern repeating (G73): the contour in several passes, each nearer; and the end of a finishing cycle (G70).

use crate::kernel::Kernel;
use crate::statement::Statement;
use crate::turning::profile::ContourProfile;

impl Kernel<'_> {
    /// Cuts the contour in the remembered number of passes, each nearer than the previous one, and returns to the start.
    pub fn turn_pattern(
        &mut self,
        at: &dyn Statement,
        allowance: [f64; 2],
        profile: &ContourProfile,
    ) {
        let start = self.turned_place();
        let memory = self.state.turning;
        let passes = memory.pattern_passes.max(1);
        self.origin.cycle = true;
        for pass in 1..=passes {
            let share = match passes {
                1 => 0.0,
                _ => f64::from(passes - pass) / f64::from(passes - 1),
            };
            let by = [0, 1].map(|axis| allowance[axis] + memory.pattern[axis] * share);
            let moved = |at: [f64; 2]| [at[0] + by[0], at[1] + by[1]];
            self.turn_rapid(moved(start));
            match profile.first_is_rapid {
                true => self.turn_rapid(moved(profile.start)),
                false => self.turn_cut(at, moved(profile.start)),
            }
            let edges = profile.edges.iter().map(|edge| edge.mapped(moved, false));
            self.turn_contour(at, edges);
        }
        self.turn_rapid(start);
        self.origin.cycle = false;
    }

    /// Follows a contour once from a start point beyond it, and returns there.
    pub fn follow_contour(
        &mut self,
        at: &dyn Statement,
        profile: &ContourProfile,
        start: [f64; 2],
    ) {
        self.origin.cycle = true;
        self.turn_rapid(start);
        self.turn_rapid([profile.start[0], start[1]]);
        self.turn_cut(at, profile.start);
        self.turn_contour(at, profile.edges.iter().copied());
        let [_, z] = self.turned_place();
        self.turn_rapid([start[0], z]);
        self.turn_rapid(start);
        self.origin.cycle = false;
    }

    /// Returns to the start after the contour of a finishing cycle.
    pub fn turn_back(&mut self, start: [f64; 2]) {
        self.origin.cycle = true;
        self.turn_rapid(start);
        self.origin.cycle = false;
    }
}
