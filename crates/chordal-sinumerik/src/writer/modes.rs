//! Commands that do not move: tools, spindle, coolant, modes, dwells and stops.

use chordal_command::{
    CommandKind, CompensationSide, Coolant, FeedMode, PathMode, SpindleState, Units,
};
use chordal_geometry::Plane;
use chordal_kernel::{CoolantChange, time_number, written_effect};

use super::block_writer::{
    BlockWriter, WordGroup, feed_mode_code, plane_code, units_code, work_code,
};
use super::words::significant;

/// The largest number of a settable frame: G599.
const MAX_WORK: u32 = 99;

impl BlockWriter<'_> {
    /// Writes a command.
    ///
    /// # Errors
    /// Why it has no form on this control.
    pub fn command(&mut self, command: &CommandKind) -> Result<(), String> {
        match command {
            CommandKind::Rapid { motion, .. } => self.rapid(motion),
            CommandKind::Line { motion, feed } => self.cut(motion, feed),
            CommandKind::Arc { motion, shape, feed }
            | CommandKind::Spiral { motion, shape, feed } => self.arc(motion, shape, feed),
            CommandKind::Spline { .. } => {
                Err("splines are not written: write the curve as lines or arcs before".into())
            }
            CommandKind::Dwell { seconds: time, .. } => {
                if *time > 0.0 {
                    self.alone(format!("G4 F{}", time_number(*time)));
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
                self.length(*number, *is_subtracted, is_own)
            }
            CommandKind::Compensation { side, number, toward, .. } => {
                self.compensation(*side, *number, toward.is_some())
            }
            CommandKind::Spindle { state, rpm } => {
                self.spindle(*state, *rpm);
                Ok(())
            }
            CommandKind::Coolant(coolant) => self.coolant(*coolant),
            CommandKind::Stop { optional } => {
                self.alone(if *optional { "M1" } else { "M0" });
                Ok(())
            }
            CommandKind::End => {
                self.end_modal_call();
                self.alone("M30");
                Ok(())
            }
            CommandKind::Units(units) => {
                self.units(*units);
                Ok(())
            }
            CommandKind::Plane(plane) => {
                self.plane(*plane);
                Ok(())
            }
            CommandKind::FeedMode(mode) => {
                self.feed_mode(*mode);
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
                self.alone(if *meets { "G451" } else { "G450" });
                Ok(())
            }
            CommandKind::Probed { .. } => Err("a probing move".into()),
            CommandKind::Surface { .. } => Err("polar or cylindrical interpolation".into()),
            CommandKind::PartFrame { .. } => Err("tool centre point control".into()),
            CommandKind::Output { text } => {
                self.alone(format!("; PRINTED: {}", text.trim()));
                self.note(
                    "",
                    "printed text is a comment: this control has no statement for it here",
                );
                Ok(())
            }
            // F stands with its cut, messages are comments, and the rest does nothing.
            CommandKind::FeedRate { .. } | CommandKind::Idle | CommandKind::Message(_) => Ok(()),
        }
    }

    fn change_tool(&mut self, number: u32) {
        self.tool = number;
        // M6 makes the first edge active (MD20270 = 1).
        self.edge.is_on = number > 0;
        self.edge.is_due = self.edge.desired.is_some();
        self.alone(match self.settings.tool_change_by_m6 {
            true => format!("T{number} M6"),
            false => format!("T{number}"),
        });
    }

    /// A tool that is brought into position, unless its change comes at once.
    fn prepare_tool(&mut self, number: u32) {
        let is_next = self.program.changes_tool_next(self.step, number);
        if self.settings.tool_change_by_m6 && !is_next {
            self.alone(format!("T{number}"));
        }
    }

    fn length(
        &mut self,
        number: Option<u32>,
        is_subtracted: bool,
        is_own: bool,
    ) -> Result<(), String> {
        if is_subtracted {
            return Err("a tool length that is subtracted (G44)".into());
        }
        if is_own {
            return Err("a tool length that the program gives itself (G43.1)".into());
        }
        self.edge.desired = number;
        self.edge.is_due = true;
        Ok(())
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
        self.side = side;
        let code = match side {
            CompensationSide::Off => {
                self.wait(WordGroup::Side, "G40");
                return Ok(());
            }
            CompensationSide::Left => "G41",
            CompensationSide::Right => "G42",
        };
        let Some(number) = number else {
            return Err("a radius that is no offset of the tool table".into());
        };
        if number != self.tool {
            return Err(format!(
                "the radius of offset {number} with tool {}: an edge belongs to its tool",
                self.tool
            ));
        }
        if !self.edge.is_on {
            self.edge.is_on = true;
            self.edge.is_due = false;
            self.wait(WordGroup::Edge, "D1");
        }
        self.wait(WordGroup::Side, code);
        self.wait(WordGroup::Corner, "G450");
        Ok(())
    }

    fn spindle(&mut self, state: SpindleState, rpm: f64) {
        let rpm = if matches!(state, SpindleState::Cw | SpindleState::Ccw) { rpm } else { 0.0 };
        if self.spindle == (state, rpm) {
            return;
        }
        self.spindle = (state, rpm);
        let speed = significant(rpm);
        self.alone(match state {
            SpindleState::Off => "M5".to_string(),
            SpindleState::Cw => format!("S{speed} M3"),
            SpindleState::Ccw => format!("S{speed} M4"),
            SpindleState::Oriented => "M19".to_string(),
        });
    }

    fn coolant(&mut self, coolant: Coolant) -> Result<(), String> {
        if coolant.through_tool {
            return Err("coolant through the tool: its code is the builder's".into());
        }
        let before = std::mem::replace(&mut self.coolant, coolant);
        let change = CoolantChange::between(before, coolant);
        if change.closes {
            self.alone("M9");
        }
        if change.opens_mist {
            self.alone("M7");
        }
        if change.opens_flood {
            self.alone("M8");
        }
        Ok(())
    }

    fn units(&mut self, units: Units) {
        if self.lengths.units != units {
            self.lengths.units = units;
            self.feed = None;
            self.end_modal_call();
            self.alone(units_code(units));
        }
    }

    fn plane(&mut self, plane: Plane) {
        if self.plane == plane {
            return;
        }
        self.plane = plane;
        self.end_modal_call();
        let code = plane_code(plane);
        self.wait(WordGroup::Plane, code);
        if plane != Plane::Xy && self.edge.is_on {
            self.note(
                code,
                "the length of the tool stays along Z where SD42940 (TOOL_LENGTH_CONST) is 17: look at the machine",
            );
        }
    }

    fn feed_mode(&mut self, mode: FeedMode) {
        if self.feed_mode != mode {
            self.feed_mode = mode;
            self.feed = None;
            self.wait(WordGroup::FeedMode, feed_mode_code(mode));
        }
    }

    fn path_mode(&mut self, mode: PathMode) {
        if self.path_mode.replace(mode) == Some(mode) {
            return;
        }
        match mode {
            PathMode::ExactStop => self.wait(WordGroup::PathMode, "G60"),
            // The control has no exact path without a stop: G64 leaves the path as it is programmed.
            PathMode::ExactPath | PathMode::Continuous { tolerance_mm: None, .. } => {
                self.wait(WordGroup::PathMode, "G64");
            }
            PathMode::Continuous { tolerance_mm: Some(tolerance), .. } => {
                let distance = self.lengths.text(tolerance);
                self.wait(WordGroup::PathMode, format!("G641 ADIS={distance}"));
            }
        }
    }

    fn work(&mut self, ordinal: u32, turned: f64) -> Result<(), String> {
        if turned != 0.0 {
            return Err("a work coordinate system that is rotated (G10 L2 R)".into());
        }
        if ordinal > MAX_WORK {
            return Err(format!("work offset {ordinal}: the control has {MAX_WORK}"));
        }
        if self.work != ordinal {
            self.work = ordinal;
            self.wait(WordGroup::Work, work_code(ordinal));
        }
        Ok(())
    }

    /// The edge for a move along the tool's axis; `None` where it is active.
    ///
    /// # Errors
    /// Why the length is none of this control.
    pub fn set_edge(&mut self) -> Result<Option<&'static str>, String> {
        let word = match self.edge.desired {
            Some(number) if number != self.tool => {
                return Err(format!(
                    "length offset {number} with tool {}: an edge belongs to its tool",
                    self.tool
                ));
            }
            Some(_) if !self.edge.is_on || self.edge.is_due => Some("D1"),
            None if self.edge.is_on && self.side != CompensationSide::Off => {
                return Err("the radius of a tool without its length: D gives both".into());
            }
            None if self.edge.is_on => Some("D0"),
            Some(_) | None => None,
        };
        self.edge.is_on = self.edge.desired.is_some();
        self.edge.is_due = false;
        Ok(word)
    }
}
