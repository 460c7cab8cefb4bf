//! Cycles of one block: to a diameter, along it, away from it, and back to the start.

use crate::kernel::Kernel;
use crate::state::TurnPass;
use crate::statement::Statement;
use crate::turning::COINCIDENT_MM;

impl Kernel<'_> {
    /// Makes one pass with the remembered words, and returns to its start.
    pub fn turn_pass(&mut self, at: &dyn Statement, pass: TurnPass) {
        let [ax, az] = self.turned_place();
        let memory = self.state.turning;
        let ([x, z], taper) = (memory.pass_end, memory.pass_taper);
        self.origin.cycle = true;
        match pass {
            TurnPass::Turning => {
                self.turn_rapid([x + taper, az]);
                self.turn_cut(at, [x, z]);
                self.turn_cut(at, [ax, z]);
            }
            TurnPass::Facing => {
                self.turn_rapid([ax, z + taper]);
                self.turn_cut(at, [x, z]);
                self.turn_cut(at, [x, az]);
            }
            TurnPass::Thread => {
                self.turn_rapid([x + taper, az]);
                self.thread_to(at, [x, z], [ax, az], memory.pass_lead);
                self.turn_rapid([ax, z]);
            }
        }
        self.turn_rapid([ax, az]);
        self.origin.cycle = false;
    }

    /// Cuts a thread to its end, and leaves it at 45 degrees towards the start `from`.
    pub(super) fn thread_to(
        &mut self,
        at: &dyn Statement,
        [x, z]: [f64; 2],
        from: [f64; 2],
        lead: f64,
    ) {
        self.require_spindle(at);
        let leads = match self.state.turning.without_exit {
            true => 0.0,
            false => self.state.turning.thread.exit_leads,
        };
        let full = leads * lead;
        let [start_x, start_z] = self.turned_place();
        let length = (start_z - z).abs();
        let back = if start_z >= z { 1.0 } else { -1.0 };
        let out = if from[0] >= x { 1.0 } else { -1.0 };
        // The exit ends at the diameter of the cycle's start and is not longer than the thread.
        let exit = full.min((from[0] - x).abs()).min(length);
        if exit <= COINCIDENT_MM {
            return self.turn_thread([x, z], lead);
        }
        // It begins at the same point as an exit that is not limited by that diameter.
        let begins = full.min(length);
        let share = if length > 0.0 { begins / length } else { 0.0 };
        let turn = [x + (start_x - x) * share, z + back * begins];
        self.turn_thread(turn, lead);
        self.turn_thread([turn[0] + out * exit, turn[1] - back * exit], lead);
    }
}
