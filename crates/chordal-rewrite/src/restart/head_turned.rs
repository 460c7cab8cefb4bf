//! The head of a program for a lathe.

use chordal::control::{
    Action, BeforeCode, LengthCode, MotionCode, ReadingCode, SpindleState, Units, code_number,
};
use chordal::geometry::tolerance::COINCIDENT_MM;
use chordal::syntax::Block;

use super::head::{HeadError, HeadWriter};
use super::lathe::{has_stations, says_setup};
use crate::convert::station;

impl HeadWriter<'_, '_> {
    pub(super) fn turns(&self) -> bool {
        self.state.control.table.turns()
    }

    /// The lines before a block that takes another station.
    pub(super) fn before_station(&self) -> Result<Vec<String>, HeadError> {
        let mut lines = self.turned_modes();
        // A turret turns while the spindle does.
        lines.extend(
            self.turned_speed(!self.state.control.parameters.rules.spindle_stops_at_tool_change)?,
        );
        self.finish_turned(lines)
    }

    /// The lines before a block where the place is not known.
    pub(super) fn with_station(&self) -> Result<Vec<String>, HeadError> {
        let mut lines = self.turned_modes();
        lines.extend(self.station());
        lines.extend(self.turned_speed(true)?);
        self.finish_turned(lines)
    }

    /// The lines before any other block: the tool goes to its first place of the program by rapid, then along Z and
    /// along X by feed.
    pub(super) fn at_the_part(&self) -> Result<Vec<String>, HeadError> {
        let modal = &self.before.modal;
        let mut lines = self.turned_modes();
        lines.extend(self.station());
        lines.extend(self.turned_speed(true)?);
        let [x, z] = [modal.position[0], modal.position[2]];
        let [from_x, from_z] = self.before.turned.approach.unwrap_or([x, z]);
        let rapid = self.needed(Action::Motion(MotionCode::Rapid), "a rapid")?;
        lines.push(self.state.line([rapid, self.place(0, from_x)?, self.place(2, from_z)?]));
        lines.extend(self.before.words.coolant.iter().cloned());
        let mut moves = Vec::new();
        if (z - from_z).abs() > COINCIDENT_MM {
            moves.push(self.place(2, z)?);
        }
        if (x - from_x).abs() > COINCIDENT_MM {
            moves.push(self.place(0, x)?);
        }
        let feed = self.state.feed();
        match (moves.is_empty(), feed) {
            (true, feed) => lines.extend(feed),
            (false, None) => {
                return Err(HeadError(
                    "the tool is at the part, and the program has no feed yet".into(),
                ));
            }
            (false, Some(feed)) => {
                if modal.spindle == SpindleState::Off && modal.live.is_none() {
                    return Err(HeadError(
                        "the tool is at the part, and the spindle stands still".into(),
                    ));
                }
                let cut = self.needed(Action::Motion(MotionCode::Linear), "a straight cut")?;
                let mut moves = moves.into_iter();
                let first = moves.next().unwrap_or_default();
                lines.push(self.state.line([cut, first, feed]));
                lines.extend(moves);
            }
        }
        lines.extend(self.setups());
        lines.extend(self.ending()?);
        Ok(lines)
    }

    /// Modes, diameters, the work offset, and the first blocks of cycles.
    fn turned_modes(&self) -> Vec<String> {
        let mut lines = self.modes();
        let reading = match self.before.x_factor == 1.0 {
            true => ReadingCode::Radii,
            false => ReadingCode::Diameters,
        };
        lines.extend(self.state.name(Action::Reading(reading)));
        lines.extend(self.state.work());
        lines
    }

    /// The first of two blocks of cycles that come after it and do not say it again.
    fn setups(&self) -> Vec<String> {
        let blocks = &self.state.source.blocks[self.at..];
        let needed = |code: u16| {
            let has = |block: &&Block| {
                block.all(b'G').any(|word| word.number().and_then(code_number) == Some(code))
            };
            let next = blocks.iter().find(has);
            next.is_some_and(|block| !says_setup(block, self.state.control))
        };
        let setups = self.before.turned.setups.iter();
        setups.filter(|(code, _)| needed(**code)).map(|(_, words)| words.clone()).collect()
    }

    /// The station with its offset.
    fn station(&self) -> Option<String> {
        let modal = &self.before.modal;
        if modal.tool == 0 {
            return None;
        }
        if has_stations(self.state.control) {
            let own = self.before.turned.station.clone();
            return own.or_else(|| station(self.state.control, modal.tool, modal.length_offset));
        }
        let name = |action| self.state.name(action);
        let change = name(Action::Before(BeforeCode::ToolChange));
        let mut words = vec![format!("T{}", modal.tool)];
        words.extend(change);
        if let Some(number) = modal.length_offset {
            words.extend(name(Action::Length(LengthCode::Plus)));
            words.extend((number != modal.tool).then(|| format!("H{number}")));
        }
        Some(self.state.line(words))
    }

    /// What limits the spindle, and its cutting speed or revolutions.
    fn turned_speed(&self, starts: bool) -> Result<Vec<String>, HeadError> {
        let modal = &self.before.modal;
        let mut lines: Vec<String> = self.before.turned.limit.clone().into_iter().collect();
        let mut words = Vec::new();
        match modal.surface_speed {
            Some(speed) => {
                let code = Action::Reading(ReadingCode::SurfaceSpeed);
                words.push(self.needed(code, "a cutting speed")?);
                let limit = modal.speed_limit.filter(|limit| limit.is_finite());
                if let Some(limit) =
                    limit.filter(|_| !self.state.control.parameters.preset_limits_speed)
                {
                    words.push(self.state.rate('D', limit, 4));
                }
                let unit = if modal.units == Units::Inch { 304.8 } else { 1000.0 };
                words.push(self.state.rate('S', speed * 60.0 / unit, 4));
            }
            None if modal.rpm > 0.0 => {
                words.extend(self.state.name(Action::Reading(ReadingCode::SpindleRpm)));
                words.push(self.state.rate('S', modal.rpm, 4));
            }
            None => {}
        }
        if starts && modal.spindle != SpindleState::Off {
            words.extend(self.before.words.spindle.clone());
        }
        let live = self.before.words.live.clone().filter(|_| modal.live.is_some());
        // P next to S and M3 names the live tool; a code of its own stands alone.
        match live {
            Some(live) if self.state.control.parameters.live_tool_p > 0 => words.push(live),
            Some(live) => lines.push(live),
            None => {}
        }
        if !words.is_empty() {
            lines.push(self.state.line(words));
        }
        Ok(lines)
    }

    fn finish_turned(&self, mut lines: Vec<String>) -> Result<Vec<String>, HeadError> {
        lines.extend(self.before.words.coolant.iter().cloned());
        lines.extend(self.state.feed());
        lines.extend(self.setups());
        lines.extend(self.ending()?);
        Ok(lines)
    }
}
