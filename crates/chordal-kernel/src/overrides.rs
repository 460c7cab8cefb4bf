//! Which overrides of the control panel act.

use chordal_command::CommandKind;

use crate::kernel::Kernel;

impl Kernel<'_> {
    /// Enables or disables overrides by a code; `None` leaves one as it is.
    pub fn set_overrides(&mut self, feed: Option<bool>, rapid: Option<bool>) {
        let by_code = &mut self.state.overrides.by_code;
        by_code.feed = feed.unwrap_or(by_code.feed);
        by_code.rapid = rapid.unwrap_or(by_code.rapid);
        self.push_overrides();
    }

    /// G63 begins or ends.
    pub fn set_tapping_mode(&mut self, on: bool) {
        self.state.overrides.tapping_mode = on;
        self.push_overrides();
    }

    /// A tapping cycle enters its hole, or has left it.
    pub fn set_in_tap(&mut self, on: bool) {
        self.state.overrides.in_tap = on;
        self.push_overrides();
    }

    fn push_overrides(&mut self) {
        let active = self.state.overrides.in_force();
        if active != self.state.overrides.pushed {
            self.state.overrides.pushed = active;
            self.emit(CommandKind::Overrides(active));
        }
    }
}
