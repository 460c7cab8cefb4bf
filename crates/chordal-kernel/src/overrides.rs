//! Which overrides of the panel act.

use chordal_command::CommandKind;

use crate::kernel::Kernel;

impl Kernel<'_> {
    /// A code that lets overrides act or not; `None` leaves one as it is.
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

    /// A tapping cycle goes into its hole, or has come out of it.
    pub fn set_in_tap(&mut self, on: bool) {
        self.state.overrides.in_tap = on;
        self.push_overrides();
    }

    fn push_overrides(&mut self) {
        let in_force = self.state.overrides.in_force();
        if in_force != self.state.overrides.pushed {
            self.state.overrides.pushed = in_force;
            self.emit(CommandKind::Overrides(in_force));
        }
    }
}
