//! What a program of a lathe needs besides: threads, stations, the speed of its spindle.

use chordal::control::{Action, Control, MotionCode, Move, ReadingCode, SpindleState, ToolWord};

use super::{CommandEmitter, EmitRefusal};
use crate::convert::codes;
use crate::convert::numbers;
use crate::convert::tap::TappedThread;
use crate::convert::thread;
use crate::convert::trace::ActiveModes;

/// What a program of a lathe has active besides.
#[derive(Clone, Copy)]
pub(super) struct LatheModes {
    /// The program is for a lathe.
    pub(super) is_one: bool,
    pub(super) tool: u32,
    pub(super) spindle: SpindleState,
    /// What turns is a live tool.
    pub(super) is_live: bool,
    /// The spindle keeps a cutting speed: its revolutions follow by themselves.
    pub(super) keeps_surface_speed: bool,
}

impl LatheModes {
    /// Those of a program that is for no lathe.
    pub(super) fn of_mill() -> LatheModes {
        LatheModes {
            is_one: false,
            tool: 0,
            spindle: SpindleState::Off,
            is_live: false,
            keeps_surface_speed: false,
        }
    }

    pub(super) fn of(is_one: bool, before: &ActiveModes) -> LatheModes {
        LatheModes {
            is_one,
            tool: before.tool,
            spindle: before.spindle,
            is_live: before.live.is_some(),
            keeps_surface_speed: before.surface_speed.is_some(),
        }
    }
}

impl CommandEmitter<'_> {
    /// What holds for the spindle in a block.
    pub fn enter(&mut self, before: &ActiveModes, after: &ActiveModes, is_live: bool) {
        self.lathe.is_live = is_live || before.live.is_some() || after.live.is_some();
        self.lathe.spindle = before.spindle;
        self.lathe.tool = before.tool;
        self.lathe.keeps_surface_speed = after.surface_speed.is_some();
    }

    pub(super) fn has_stations(&self) -> bool {
        matches!(self.to.parameters.tool_word, ToolWord::StationAndOffset { .. })
    }

    /// A cut in step with the spindle.
    pub(super) fn thread(&mut self, motion: &Move, lead_mm: f64) -> Result<(), EmitRefusal> {
        let axes = self.axes(motion)?;
        if axes.is_empty() {
            return Ok(());
        }
        let mut words = self.head(Action::Motion(MotionCode::Thread))?;
        words.extend(axes);
        let digits = numbers::digits(self.to, self.units) + 2;
        if self.to.parameters.thread_lead == b'F' {
            let lead = thread::along_the_longer_axis(motion, lead_mm);
            let text = numbers::length(lead, self.units, digits, self.style);
            words.push(format!("F{text}"));
            self.feed = Some(text);
        } else {
            words.push(format!("K{}", numbers::length(lead_mm, self.units, digits, self.style)));
        }
        self.line(&words);
        Ok(())
    }

    /// A tap as a cut in step with the spindle, there and back, where the control has it; false where it has not.
    pub(super) fn tap_in_step(&mut self, tap: &TappedThread) -> Result<bool, EmitRefusal> {
        let action = Action::Motion(MotionCode::RigidTap);
        let Some((bottom, lead)) = tap.in_step().filter(|_| self.code(action).is_some()) else {
            return Ok(false);
        };
        let mut line = self.head(action)?;
        let digits = numbers::digits(self.to, self.units) + 2;
        line.push(format!("Z{}", self.place(2, bottom)));
        line.push(format!("K{}", numbers::length(lead, self.units, digits, self.style)));
        self.line(&line);
        Ok(true)
    }
}

/// The control has G90 and G91, or their like.
pub(super) fn reads_distances(control: &Control) -> bool {
    codes::row(Action::Reading(ReadingCode::Incremental), control).is_some()
}
