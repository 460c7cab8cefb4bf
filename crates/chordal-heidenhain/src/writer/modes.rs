//! Commands that do not move: tools, spindle, coolant, modes, dwells and stops.

use chordal_command::{CommandKind, CompensationSide, Coolant, FeedMode, PathMode, SpindleState};
use chordal_kernel::{CoolantChange, PostedKind, time_number, written_effect};

use super::blocks::KlartextBlocks;
use super::words::significant;

/// The largest line of a preset table.
const MAX_PRESET: u32 = 9999;

impl KlartextBlocks<'_> {
    /// Writes a command that does not move.
    ///
    /// # Errors
    /// Why it has no form on this control.
    pub fn mode(&mut self, command: &CommandKind) -> Result<(), String> {
        match command {
            CommandKind::Dwell { seconds: time, .. } => {
                if *time > 0.0 {
                    self.alone("CYCL DEF 9.0 DWELL TIME");
                    self.line(format!("CYCL DEF 9.1 DWELL {}", time_number(*time)));
                }
                Ok(())
            }
            CommandKind::Tool { number } => {
                self.change_tool(*number);
                Ok(())
            }
            CommandKind::ToolNumber { .. } => {
                Err("a tool that gets another number without a tool change".into())
            }
            CommandKind::ToolSelect { number } => {
                self.prepare_tool(*number);
                Ok(())
            }
            CommandKind::ToolLength { number, is_subtracted, offset, .. } => {
                let is_own = number.is_none() && offset.iter().any(|value| *value != 0.0);
                if *is_subtracted || is_own {
                    return Err(
                        "a tool length that is subtracted, or that the program gives itself".into(),
                    );
                }
                self.is_length_new |= self.length != *number;
                self.length = *number;
                Ok(())
            }
            CommandKind::Compensation { side, number, toward, .. } => {
                self.compensation(*side, *number, toward.is_some())
            }
            CommandKind::Spindle { state, rpm } => self.spindle(*state, *rpm),
            CommandKind::Coolant(coolant) => self.coolant(*coolant),
            CommandKind::Stop { optional } => {
                self.alone(if *optional { "M1" } else { "STOP" });
                Ok(())
            }
            CommandKind::End => {
                self.alone("M30");
                Ok(())
            }
            CommandKind::FeedMode(mode) => {
                // A feed in inverse time is written as the feed of each move.
                self.feed_mode.desired = match mode {
                    FeedMode::PerRevolution => FeedMode::PerRevolution,
                    FeedMode::PerTime | FeedMode::InverseTime => FeedMode::PerTime,
                };
                Ok(())
            }
            CommandKind::PathMode(mode) => {
                self.path_mode(*mode);
                Ok(())
            }
            CommandKind::Overrides(overrides) => {
                if !overrides.feed {
                    self.note("", "the switch for the overrides is the builder's: it is left out");
                }
                Ok(())
            }
            CommandKind::WorkOffset { name, turned, .. } => self.work(name.ordinal(), *turned),
            CommandKind::Effect(effect) => {
                if let Some(note) = written_effect(effect)? {
                    self.note("", note);
                }
                Ok(())
            }
            CommandKind::CornerArc { .. } => Err("a programmed corner arc (G39)".into()),
            CommandKind::CornerMode { opens: true, .. } => Err("an open corner (M98)".into()),
            CommandKind::CornerMode { meets, opens: false } => {
                self.meets_corner = *meets;
                Ok(())
            }
            CommandKind::Probed { .. } => Err("a probing move".into()),
            CommandKind::Surface { .. } => Err("polar or cylindrical interpolation".into()),
            CommandKind::PartFrame { .. } => Err("tool centre point control".into()),
            CommandKind::Output { text } => {
                self.alone(format!("; PRINTED: {}", text.trim()));
                self.note("", "printed text is a comment: FN 16 needs a file of its own");
                Ok(())
            }
            CommandKind::Spline { .. } => {
                Err("splines are not written: write the curve as lines or arcs before".into())
            }
            // Moves are written before. BEGIN PGM has one unit, and each arc its plane; F stands with its cut, messages
            // are comments, and the rest does nothing.
            CommandKind::Rapid { .. }
            | CommandKind::Line { .. }
            | CommandKind::Arc { .. }
            | CommandKind::Spiral { .. }
            | CommandKind::Units(_)
            | CommandKind::Plane(_)
            | CommandKind::FeedRate { .. }
            | CommandKind::Idle
            | CommandKind::Message(_) => Ok(()),
        }
    }

    /// TOOL CALL with the speed of what comes next.
    fn change_tool(&mut self, number: u32) {
        self.is_length_new |= self.tool != number;
        self.tool = number;
        self.has_tool_axis = true;
        let speed = self.next_speed().unwrap_or(self.speed.desired);
        let word = if speed > 0.0 { format!(" S{}", significant(speed)) } else { String::new() };
        if speed > 0.0 {
            self.speed.written = speed;
        }
        // The spindle stops for the change.
        self.spindle.written = SpindleState::Off;
        self.alone(format!("TOOL CALL {number} Z{word}"));
    }

    /// The speed at which the spindle turns before the next tool change.
    fn next_speed(&self) -> Option<f64> {
        let rest = self.program.steps.get(self.step + 1..).unwrap_or_default();
        let is_of_tool =
            |kind: &&PostedKind| !matches!(kind, PostedKind::Command(CommandKind::Tool { .. }));
        let kinds = rest.iter().map(|step| &step.kind).take_while(is_of_tool);
        let speed = |kind: &PostedKind| match kind {
            PostedKind::Command(CommandKind::Spindle { state, rpm }) => {
                matches!(state, SpindleState::Cw | SpindleState::Ccw).then_some(*rpm)
            }
            PostedKind::Tap(tap) => Some(tap.rpm),
            PostedKind::Command(_) | PostedKind::MachineMove { .. } | PostedKind::Hole(_) => None,
        };
        kinds.filter_map(speed).find(|rpm| *rpm > 0.0)
    }

    /// TOOL CALL with the tool axis alone, for a program that moves without a tool.
    pub fn write_tool_axis(&mut self) {
        if self.has_tool_axis {
            return;
        }
        self.has_tool_axis = true;
        let speed = match self.speed.desired > 0.0 {
            true => self.speed.take(),
            false => self.next_speed().inspect(|rpm| self.speed.written = *rpm),
        };
        let word = speed.map_or_else(String::new, |rpm| format!(" S{}", significant(rpm)));
        self.line(format!("TOOL CALL Z{word}"));
    }

    /// A tool that is made ready, unless its change comes at once.
    fn prepare_tool(&mut self, number: u32) {
        if number > 0 && !self.program.changes_tool_next(self.step, number) {
            self.alone(format!("TOOL DEF {number}"));
        }
    }

    fn compensation(
        &mut self,
        side: CompensationSide,
        number: Option<u32>,
        has_direction: bool,
    ) -> Result<(), String> {
        if has_direction {
            return Err("compensation with a programmed direction (I J K)".into());
        }
        if side != CompensationSide::Off {
            let Some(number) = number else {
                return Err("a radius that is no offset of the tool table".into());
            };
            if number != self.tool {
                return Err(format!(
                    "the radius of offset {number} with tool {}: RL and RR use the radius of the tool of TOOL CALL",
                    self.tool
                ));
            }
        }
        self.side.desired = side;
        Ok(())
    }

    fn spindle(&mut self, state: SpindleState, rpm: f64) -> Result<(), String> {
        let turns = matches!(state, SpindleState::Cw | SpindleState::Ccw);
        if turns && rpm <= 0.0 {
            return Err("the spindle turns without a speed: TOOL CALL needs S".into());
        }
        if turns {
            self.speed.desired = rpm;
        }
        self.spindle.desired = state;
        if turns && !self.has_tool_axis {
            // TOOL CALL comes with the tool or with the first move.
            return Ok(());
        }
        self.write_spindle();
        Ok(())
    }

    /// S and the direction of the spindle, where others are active.
    pub fn write_spindle(&mut self) {
        let state = self.spindle.desired;
        let turns = matches!(state, SpindleState::Cw | SpindleState::Ccw);
        if turns && let Some(rpm) = self.speed.take() {
            self.alone(format!("TOOL CALL S{}", significant(rpm)));
            self.has_tool_axis = true;
        }
        let Some(state) = self.spindle.take() else { return };
        match state {
            SpindleState::Off => self.alone("M5"),
            SpindleState::Cw => self.wait("M3"),
            SpindleState::Ccw => self.wait("M4"),
            SpindleState::Oriented => self.alone("M19"),
        }
    }

    fn coolant(&mut self, coolant: Coolant) -> Result<(), String> {
        if coolant.through_tool {
            return Err("coolant through the tool: its M function is the builder's".into());
        }
        let before = std::mem::replace(&mut self.coolant, coolant);
        let change = CoolantChange::between(before, coolant);
        if change.closes {
            self.alone("M9");
        }
        if change.opens_mist {
            self.wait("M7");
        }
        if change.opens_flood {
            self.wait("M8");
        }
        Ok(())
    }

    fn path_mode(&mut self, mode: PathMode) {
        self.tolerance.desired = match mode {
            PathMode::ExactStop | PathMode::ExactPath => None,
            PathMode::Continuous { tolerance_mm, .. } => tolerance_mm.filter(|mm| *mm > 0.0),
        };
    }

    fn work(&mut self, ordinal: u32, turned: f64) -> Result<(), String> {
        if turned != 0.0 {
            return Err("a work coordinate system that is rotated (G10 L2 R)".into());
        }
        if ordinal > MAX_PRESET || ordinal == 0 {
            return Err(format!("work offset {ordinal}: presets are 1 to {MAX_PRESET}"));
        }
        self.preset.desired = ordinal;
        Ok(())
    }
}
