//! Live tools of a turret: by codes of their own with P as the speed (Haas M133), or by M3 with a P that selects them
//! (Fanuc).

use chordal_command::{SpindleState, telling_number};
use chordal_diagnostics::{Code, Diagnostic};
use chordal_kernel::LiveTool;
use chordal_syntax::{Block, Letters};

use super::Interpreter;

impl Interpreter<'_> {
    /// True when P of M3, M4 or M5 selects the live tool instead of the spindle.
    pub(super) fn names_live_tool(&mut self, block: &Block) -> bool {
        let number = self.control.parameters.live_tool_p;
        let word = block.last(b'P').copied().filter(|_| number > 0);
        let p = word.and_then(|word| self.literal(&word));
        p.is_some_and(|value| value.to_f64() == f64::from(number))
    }

    /// Carries out M3 or M4.
    pub(super) fn start_spindle(&mut self, block: &Block, turns: SpindleState) {
        match self.names_live_tool(block) {
            true => {
                let rpm = self.kernel.state.rpm;
                self.kernel.set_live_tool(Some(LiveTool { turns, rpm }));
            }
            false => {
                self.check_second_spindle(block);
                self.kernel.set_spindle(turns);
            }
        }
    }

    /// Starts the live tool with the speed P, without P with S of the block, else with its last speed.
    pub(super) fn start_live_tool(&mut self, block: &Block, at: usize, turns: SpindleState) {
        let p_word = block.last(b'P').copied();
        let rpm = match p_word {
            Some(word) => self.literal(&word).map_or(0.0, |number| number.to_f64()),
            None if block.letters().has(b'S') => self.kernel.state.rpm,
            None => self.kernel.state.live_rpm,
        };
        if p_word.is_none() && rpm <= 0.0 {
            let code = self.code_text(block, at);
            let span = self.span(block.words[at].range);
            let message = format!("{code} without P: the live tool has no speed yet");
            self.kernel.missing_word(span, message, "write P and the revolutions per minute");
        }
        if let Some(max) = self.machine.live_tool_max_rpm
            && rpm > max
        {
            let (rpm, max) = (telling_number(rpm, 0), telling_number(max, 0));
            let span = self.words_span(block, Letters::of("P"));
            let message = format!("P{rpm} is above the {max} rpm of live tools on this machine");
            self.kernel.report(
                Diagnostic::new(Code::SpindleOverLimit, span, message)
                    .help(format!("program P{max} or less")),
            );
        }
        self.kernel.set_live_tool(Some(LiveTool { turns, rpm }));
    }
}
