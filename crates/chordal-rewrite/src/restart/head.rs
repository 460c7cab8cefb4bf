//! The lines that a control needs before a program can begin at a block.

use std::collections::BTreeMap;

use chordal::control::table::CodeGroup;
use chordal::control::{
    Action, FeedMode, LengthCode, Modal, ModeCode, MotionCode, MotionMode, ReadingCode,
    SpindleState,
};
use chordal::machine::AXIS_LETTERS;

use super::watch::StateBefore;
use crate::state::{EXACT, StateSlot, StateWriter};

/// What stands in the way of a head.
#[derive(Debug)]
pub(super) struct HeadError(pub(super) String);

/// Writes the head of one program.
pub(super) struct HeadWriter<'h, 'a> {
    pub(super) state: StateWriter<'h, 'a>,
    pub(super) before: &'h StateBefore,
    /// The block that the program begins at.
    pub(super) at: usize,
}

impl HeadWriter<'_, '_> {
    /// The lines before a block that changes the tool: the tool's own words follow.
    pub(super) fn before_change(&self) -> Result<Vec<String>, HeadError> {
        if self.turns() {
            return self.before_station();
        }
        let mut lines = self.modes();
        lines.extend(self.stand()?);
        // The spindle is not started before the change, but a later M3 may count on its speed.
        lines.extend(self.state.speed());
        self.finish(lines)
    }

    /// The lines before a block where the place is not known: the program goes to one before it cuts.
    pub(super) fn before_approach(&self) -> Result<Vec<String>, HeadError> {
        if self.turns() {
            return self.with_station();
        }
        let mut lines = self.modes();
        lines.extend(self.tool());
        lines.extend(self.stand()?);
        lines.extend(self.spindle_line());
        self.finish(lines)
    }

    /// The lines before a block where the height alone is not known, as after a tool change or G28 Z0: they take the tool
    /// over its place, at the height that the machine has.
    pub(super) fn before_descent(&self) -> Result<Vec<String>, HeadError> {
        self.finish(self.over(None)?)
    }

    /// Coolant, the tool made ready and F, then what the block itself counts on.
    pub(super) fn finish(&self, mut lines: Vec<String>) -> Result<Vec<String>, HeadError> {
        lines.extend(self.before.words.coolant.iter().cloned());
        lines.extend(self.state.ready_tool());
        lines.extend(self.state.feed());
        lines.extend(self.ending()?);
        Ok(lines)
    }

    /// The lines before any other block: they take the tool to where it stands.
    pub(super) fn all(&self) -> Result<Vec<String>, HeadError> {
        if self.turns() {
            return self.at_the_part();
        }
        let StateBefore { words: stated, highest, .. } = self.before;
        let mut lines = self.over(self.own_length()?)?;
        let mut down = self.down(*highest)?;
        if self.turns_tool_to_plane() {
            // In one line with the way over the place.
            let over = lines.pop().unwrap_or_default();
            down = self.state.line([over, down]);
        }
        lines.push(down);
        lines.extend(stated.coolant.iter().cloned());
        lines.extend(self.plunge(*highest)?);
        lines.extend(self.state.ready_tool());
        lines.extend(self.ending()?);
        // The way down by feed has said it.
        let [.., before, last] = lines.as_slice() else { return Ok(lines) };
        if before.strip_prefix(last.as_str()).is_some_and(|rest| rest.trim_start().starts_with('Z'))
        {
            lines.pop();
        }
        Ok(lines)
    }

    /// A further code in a line would do nothing.
    fn has_one_command_a_line(&self) -> bool {
        self.state.control.table.command_line.is_some()
    }

    pub(super) fn needed(&self, action: Action, what: &str) -> Result<String, HeadError> {
        let name = self.state.name(action);
        name.ok_or_else(|| HeadError(format!("this control has no code for {what}")))
    }

    /// Units, plane, G90, G40, G49, G80, feed mode and what else lasts, in the words of the program where it
    /// has said them.
    pub(super) fn modes(&self) -> Vec<String> {
        let StateBefore { modal, words: stated, .. } = self.before;
        let mut codes = stated.codes.clone();
        // What was said in a called control's default is said here all the same.
        let defaults = [
            (StateSlot::Units, Action::from(modal.units)),
            (StateSlot::Plane, Action::from(modal.plane)),
            (StateSlot::Compensation, Action::Mode(ModeCode::CompensationOff)),
            (StateSlot::Cycle, Action::Mode(ModeCode::CancelCycle)),
            (StateSlot::FeedMode, Action::from(modal.feed_mode)),
        ];
        for (slot, action) in defaults {
            if let (None, Some(code)) = (codes.get(&slot), self.state.name(action)) {
                codes.insert(slot, code);
            }
        }
        let absolute = self.state.name(Action::Reading(ReadingCode::Absolute));
        codes.extend(absolute.map(|code| (StateSlot::Distance, code)));
        let mut lines = match self.has_one_command_a_line() {
            true => codes.into_values().collect(),
            false => vec![self.safe_line(codes)],
        };
        lines.extend(stated.lines.values().cloned());
        lines.extend(stated.data.iter().cloned());
        lines.extend(self.before.open.shift.presets.iter().cloned());
        lines.extend(self.before.open.shift.lines.iter().cloned());
        lines
    }

    /// The codes in one line, G49 where programmers write it: between G40 and G80.
    fn safe_line(&self, codes: BTreeMap<StateSlot, String>) -> String {
        let mut words = Vec::new();
        for (slot, code) in codes {
            if slot == StateSlot::Cycle && !self.turns() {
                words.extend(self.state.name(Action::Length(LengthCode::Cancel)));
            }
            words.push(code);
        }
        self.state.line(words)
    }

    /// The tool change, where a tool is in the spindle.
    pub(super) fn tool(&self) -> Option<String> {
        self.state.tool().filter(|_| self.before.modal.tool > 0)
    }

    /// Modes and tool, `then` a line, and by rapid over the place with the spindle on.
    fn over(&self, then: Option<String>) -> Result<Vec<String>, HeadError> {
        let (state, modal) = (&self.state, &self.before.modal);
        let mut lines = self.modes();
        lines.extend(self.tool());
        let is_separate = self.has_one_command_a_line();
        if is_separate {
            lines.extend(state.work());
            lines.extend(self.spindle_line());
        }
        lines.extend(self.plane()?);
        lines.extend(then);
        let mut words = vec![self.needed(Action::Motion(MotionCode::Rapid), "a rapid")?];
        let is_tilted = !self.before.part_frame.plane.is_empty();
        words.extend(state.work().filter(|_| !is_separate && !is_tilted));
        // The rotary axes have turned to a tilted plane.
        let axes: &[usize] = if is_tilted { &[0, 1] } else { &[0, 1, 3, 4, 5] };
        for axis in axes.iter().copied() {
            if modal.known.has(axis) && (axis < 3 || self.names(axis)) {
                words.push(self.place(axis, modal.position[axis])?);
            }
        }
        if !is_separate {
            words.extend(state.spindle());
        }
        lines.push(state.line(words));
        Ok(lines)
    }

    /// The spindle in a line of its own; its code first, where S is a word of that.
    fn spindle_line(&self) -> Option<String> {
        let mut words = self.state.spindle();
        if self.has_one_command_a_line() {
            words.reverse();
        }
        Some(self.state.line(words)).filter(|words| !words.is_empty())
    }

    /// By rapid down to where the program has been clear, with the length offset.
    fn down(&self, highest: f64) -> Result<String, HeadError> {
        let mut words: Vec<String> = self.rapid_of_line()?.into_iter().collect();
        words.extend(self.state.length_offset());
        // In a tilted plane it may be where the axes stood: what the word takes is near enough.
        words.push(self.state.place(2, highest).0);
        Ok(self.state.line(words))
    }

    /// The length that the program gives itself (G43.1), in a line of its own: its axis words are the offsets.
    fn own_length(&self) -> Result<Option<String>, HeadError> {
        let Some(values) = self.before.modal.own_length else { return Ok(None) };
        let code = self.needed(Action::Length(LengthCode::FromAxes), "a length of its own")?;
        let mut words = vec![code];
        for (axis, value) in values.iter().enumerate().filter(|(_, value)| **value != 0.0) {
            words.push(self.place(axis, *value)?);
        }
        if words.len() == 1 {
            words.push(self.place(2, 0.0)?);
        }
        Ok(Some(self.state.line(words)))
    }

    /// The code of a rapid, where each line needs its own.
    fn rapid_of_line(&self) -> Result<Option<String>, HeadError> {
        let rapid = || self.needed(Action::Motion(MotionCode::Rapid), "a rapid");
        self.has_one_command_a_line().then(rapid).transpose()
    }

    /// By feed to the place itself; by rapid only where the program has no feed yet.
    fn plunge(&self, highest: f64) -> Result<Option<String>, HeadError> {
        let modal = &self.before.modal;
        if highest - modal.position[2] < EXACT {
            return Ok(self.state.feed());
        }
        if modal.feed_mode == FeedMode::InverseTime {
            return Err(HeadError(
                "inverse time feed is on, and the tool is below the clearance".into(),
            ));
        }
        let depth = self.place(2, modal.position[2])?;
        let rapid = self.rapid_of_line()?;
        let Some(feed) = self.state.feed() else {
            let words: Vec<String> = rapid.into_iter().chain([depth]).collect();
            return Ok(Some(self.state.line(words)));
        };
        let is_per_turn = modal.feed_mode == FeedMode::PerRevolution;
        if is_per_turn && modal.spindle == SpindleState::Off {
            return Err(HeadError(
                "the feed is per revolution, and the spindle stands still".into(),
            ));
        }
        let cut = self.needed(Action::Motion(MotionCode::Linear), "a straight cut")?;
        Ok(Some(self.state.line([cut, depth, feed])))
    }

    /// The radius offset, where compensation will use the one that was said before.
    fn radius(&self) -> Option<String> {
        if self.turns() {
            return None;
        }
        let number = self.before.modal.radius_offset?;
        let starts = |action| {
            matches!(action, Action::Mode(ModeCode::CompensationLeft | ModeCode::CompensationRight))
        };
        let mut rest = self.at..self.state.source.blocks.len();
        let next = rest.find(|at| {
            self.state.source.blocks[*at].word(b'D').is_some()
                || self.state.source.has_action(*at, self.state.control, starts)
        })?;
        let is_stated = self.state.source.blocks[next].word(b'D').is_some();
        (!is_stated).then(|| format!("D{number}"))
    }

    /// G91 and the motion code, so that words without a code mean the same.
    pub(super) fn ending(&self) -> Result<Vec<String>, HeadError> {
        let StateBefore { modal, cycle, .. } = self.before;
        let mut lines: Vec<String> = self.radius().into_iter().collect();
        let increments = match modal.incremental {
            true => Some(self.needed(Action::Reading(ReadingCode::Incremental), "increments")?),
            false => None,
        };
        if modal.cycle.is_none() {
            lines.extend(increments);
            lines.extend(self.motion(modal)?);
            return Ok(lines);
        }
        let cycle_lines = cycle
            .lines(modal, self.state.control, self.state.source.style.gap())
            .map_err(HeadError)?;
        let [first, last] = match cycle.by_distance {
            true => [increments, None],
            false => [None, increments],
        };
        lines.extend(first.into_iter().chain(cycle_lines).chain(last));
        Ok(lines)
    }

    fn motion(&self, modal: &Modal) -> Result<Option<String>, HeadError> {
        match modal.motion {
            None => Ok(self.state.name(Action::Mode(ModeCode::CancelCycle))),
            // RS274/NGC refuses G1 before any F, alone too.
            Some(MotionMode::Linear | MotionMode::Arc(_)) if self.lacks_feed(modal) => {
                match self.says_motion() {
                    true => Ok(None),
                    false => Err(HeadError(
                        "G1 is in force and no feed: the control takes no G1 in a head then".into(),
                    )),
                }
            }
            // A control that only arms the direction of an arc goes on with G1 after it.
            Some(mode @ (MotionMode::Rapid | MotionMode::Linear)) => {
                self.needed(mode.into(), "the motion in force").map(Some)
            }
            Some(_) if self.says_motion() => Ok(None),
            Some(mode @ MotionMode::Arc(_)) => {
                self.needed(mode.into(), "the motion in force").map(Some)
            }
            Some(MotionMode::Turn(_) | MotionMode::Thread) if self.turns() => Ok(None),
            Some(_) => Err(HeadError("a motion is in force that a head cannot begin".into())),
        }
    }

    fn lacks_feed(&self, modal: &Modal) -> bool {
        self.state.control.parameters.rules.feed_mode_code_ends_feed
            && modal.feed_mode != FeedMode::InverseTime
            && self.state.feed().is_none()
    }

    /// The program has turned a rotary axis, or said that it stands at zero.
    pub(super) fn names(&self, axis: usize) -> bool {
        let letter = AXIS_LETTERS.as_bytes()[axis];
        let is_stated =
            self.state.source.blocks[..self.at].iter().any(|block| block.word(letter).is_some());
        is_stated || self.before.modal.position[axis] != 0.0
    }

    /// The block itself says what it does.
    fn says_motion(&self) -> bool {
        let words = &self.state.source.blocks[self.at].words;
        words.iter().any(|word| {
            let row = self.state.control.row_of(word);
            row.is_some_and(|row| row.group == CodeGroup::Motion)
        })
    }

    /// The word of an axis; its digits must be all that it takes.
    pub(super) fn place(&self, axis: usize, value: f64) -> Result<String, HeadError> {
        match self.state.place(axis, value) {
            (word, 0.0) => Ok(word),
            (word, _) => {
                let letter = &word[..1];
                let what =
                    format!("the position in {letter} has more decimals than the control takes");
                Err(HeadError(what))
            }
        }
    }
}
