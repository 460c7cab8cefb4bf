//! The lines that a control needs before a program can begin at a block.

use std::collections::BTreeMap;

use chordal::Control;
use chordal::control::table::CodeGroup;
use chordal::control::{
    Action, FeedMode, LengthCode, Modal, ModeCode, MotionCode, MotionMode, ReadingCode,
    SpindleState, Units,
};
use chordal::geometry::Plane;
use chordal::machine::AXIS_LETTERS;

use super::watch::StateBefore;
use crate::convert::codes;
use crate::convert::numbers::{digits, length, plain};
use crate::source::SourceBlocks;
use crate::split::state_at::StateSlot;
use crate::split::text::{MAX_DECIMALS, feed_word};

/// Places nearer than this are written as they are, mm or degrees.
const EXACT: f64 = 1e-10;

/// What stands in the way of a head.
#[derive(Debug)]
pub(super) struct HeadError(pub(super) String);

/// Writes the head of one program.
pub(super) struct HeadWriter<'h, 'a> {
    pub(super) source: &'h SourceBlocks<'a>,
    pub(super) control: &'h Control,
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
        lines.extend(self.work());
        // The spindle is not started before the change, but a later M3 may count on its speed.
        lines.extend(self.speed());
        lines.extend(self.before.words.coolant.iter().cloned());
        lines.extend(self.ready());
        lines.extend(feed_word(&self.before.modal, self.source.style));
        lines.extend(self.ending()?);
        Ok(lines)
    }

    /// The lines before a block where the place is not known: the program goes to one before it cuts.
    pub(super) fn before_approach(&self) -> Result<Vec<String>, HeadError> {
        if self.turns() {
            return self.with_station();
        }
        let mut lines = self.modes();
        lines.extend(self.tool());
        lines.extend(self.work());
        lines.extend(self.spindle_line());
        lines.extend(self.before.words.coolant.iter().cloned());
        lines.extend(self.ready());
        lines.extend(feed_word(&self.before.modal, self.source.style));
        lines.extend(self.ending()?);
        Ok(lines)
    }

    /// The lines before a block where the height alone is not known, as after a tool change or G28 Z0: they take the tool
    /// over its place, at the height that the machine has.
    pub(super) fn before_descent(&self) -> Result<Vec<String>, HeadError> {
        let mut lines = self.modes();
        lines.extend(self.tool());
        if self.has_one_command_a_line() {
            lines.extend(self.work());
            lines.extend(self.spindle_line());
        }
        lines.push(self.over()?);
        lines.extend(self.before.words.coolant.iter().cloned());
        lines.extend(self.ready());
        lines.extend(feed_word(&self.before.modal, self.source.style));
        lines.extend(self.ending()?);
        Ok(lines)
    }

    /// The lines before any other block: they take the tool to where it stands.
    pub(super) fn all(&self) -> Result<Vec<String>, HeadError> {
        if self.turns() {
            return self.at_the_part();
        }
        let StateBefore { words: stated, highest, .. } = self.before;
        let mut lines = self.modes();
        lines.extend(self.tool());
        if self.has_one_command_a_line() {
            lines.extend(self.work());
            lines.extend(self.spindle_line());
        }
        lines.extend(self.own_length()?);
        lines.push(self.over()?);
        lines.push(self.down(*highest)?);
        lines.extend(stated.coolant.iter().cloned());
        lines.extend(self.plunge(*highest)?);
        lines.extend(self.ready());
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
        self.control.table.command_line.is_some()
    }

    pub(super) fn name(&self, action: Action) -> Option<String> {
        codes::name(action, self.control, self.source.style)
    }

    pub(super) fn needed(&self, action: Action, what: &str) -> Result<String, HeadError> {
        self.name(action).ok_or_else(|| HeadError(format!("this control has no code for {what}")))
    }

    pub(super) fn gap(&self) -> &'static str {
        if self.source.style.spaced { " " } else { "" }
    }

    /// Units, plane, G90, G40, G49, G80, feed mode and what else lasts, in the words of the program where it
    /// has said them.
    pub(super) fn modes(&self) -> Vec<String> {
        let StateBefore { modal, words: stated, .. } = self.before;
        let mut codes = stated.codes.clone();
        // What was said in a called control's default is said here all the same.
        let plane = match modal.plane {
            Plane::Xy => ModeCode::PlaneXy,
            Plane::Zx => ModeCode::PlaneZx,
            Plane::Yz => ModeCode::PlaneYz,
        };
        let unit = match modal.units {
            Units::Inch => ReadingCode::Inch,
            Units::Millimetre => ReadingCode::Millimetre,
        };
        let feed = match modal.feed_mode {
            FeedMode::PerTime => ReadingCode::FeedPerTime,
            FeedMode::PerRevolution => ReadingCode::FeedPerRevolution,
            FeedMode::InverseTime => ReadingCode::FeedInverseTime,
        };
        let defaults = [
            (StateSlot::Units, Action::Reading(unit)),
            (StateSlot::Plane, Action::Mode(plane)),
            (StateSlot::Compensation, Action::Mode(ModeCode::CompensationOff)),
            (StateSlot::Cycle, Action::Mode(ModeCode::CancelCycle)),
            (StateSlot::FeedMode, Action::Reading(feed)),
        ];
        for (slot, action) in defaults {
            if let (None, Some(code)) = (codes.get(&slot), self.name(action)) {
                codes.insert(slot, code);
            }
        }
        if let Some(code) = self.name(Action::Reading(ReadingCode::Absolute)) {
            codes.insert(StateSlot::Distance, code);
        }
        let mut lines = match self.has_one_command_a_line() {
            true => codes.into_values().collect(),
            false => vec![self.safe_line(codes)],
        };
        lines.extend(stated.lines.values().cloned());
        lines.extend(stated.data.iter().cloned());
        lines.extend(self.before.shift.presets.iter().cloned());
        lines.extend(self.before.shift.lines.iter().cloned());
        lines
    }

    /// The codes in one line, G49 where programmers write it: between G40 and G80.
    fn safe_line(&self, codes: BTreeMap<StateSlot, String>) -> String {
        let mut words = Vec::new();
        for (slot, code) in codes {
            if slot == StateSlot::Cycle && !self.turns() {
                words.extend(self.name(Action::Length(LengthCode::Cancel)));
            }
            words.push(code);
        }
        words.join(self.gap())
    }

    /// The tool change, in the program's own words.
    fn tool(&self) -> Option<String> {
        let StateBefore { modal, words: stated, .. } = self.before;
        let words = stated.tool.as_ref().filter(|_| modal.tool > 0)?;
        let has_number = words.contains('T');
        Some(if has_number {
            words.clone()
        } else {
            format!("T{}{}{words}", modal.tool, self.gap())
        })
    }

    pub(super) fn work(&self) -> Option<String> {
        let StateBefore { modal, words: stated, .. } = self.before;
        codes::work_offset(modal.work, self.control, self.source.style).filter(|_| stated.work)
    }

    /// By rapid over the place, with the spindle on.
    fn over(&self) -> Result<String, HeadError> {
        let modal = &self.before.modal;
        let mut words = vec![self.needed(Action::Motion(MotionCode::Rapid), "a rapid")?];
        let with_others = !self.has_one_command_a_line();
        words.extend(self.work().filter(|_| with_others));
        for axis in [0, 1, 3, 4, 5] {
            if modal.known.has(axis) && (axis < 3 || self.names(axis)) {
                words.push(self.place(axis, modal.position[axis])?);
            }
        }
        if with_others {
            words.extend(self.spindle());
        }
        Ok(words.join(self.gap()))
    }

    fn spindle(&self) -> Vec<String> {
        let StateBefore { modal, words: stated, .. } = self.before;
        let mut words: Vec<String> = self.speed().into_iter().collect();
        if modal.spindle != SpindleState::Off {
            words.extend(stated.spindle.clone());
        }
        words
    }

    /// The spindle in a line of its own; its code first, where S is a word of that.
    fn spindle_line(&self) -> Option<String> {
        let mut words = self.spindle();
        if self.has_one_command_a_line() {
            words.reverse();
        }
        Some(words.join(self.gap())).filter(|words| !words.is_empty())
    }

    fn speed(&self) -> Option<String> {
        let StateBefore { modal, words: stated, .. } = self.before;
        let speed = plain(modal.rpm, 3, self.source.style);
        (stated.speed && modal.rpm > 0.0).then(|| format!("S{}", speed.trim_end_matches('.')))
    }

    /// The tool that is made ready.
    fn ready(&self) -> Option<String> {
        let modal = &self.before.modal;
        let ready = modal.selected_tool.filter(|ready| *ready != modal.tool);
        ready.map(|tool| format!("T{tool}"))
    }

    /// By rapid down to where the program has been clear, with the length offset.
    fn down(&self, highest: f64) -> Result<String, HeadError> {
        let StateBefore { modal, words: stated, .. } = self.before;
        let mut words: Vec<String> = self.rapid_of_line()?.into_iter().collect();
        if let Some(number) = modal.length_offset {
            words.extend(stated.length.clone());
            let written = stated.h.clone().filter(|word| word[1..].parse() == Ok(number));
            words.push(written.unwrap_or_else(|| format!("H{number}")));
        }
        words.push(self.place(2, highest)?);
        Ok(words.join(self.gap()))
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
        Ok(Some(words.join(self.gap())))
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
            return Ok(feed_word(&self.before.modal, self.source.style));
        }
        if modal.feed_mode == FeedMode::InverseTime {
            return Err(HeadError(
                "inverse time feed is on, and the tool is below the clearance".into(),
            ));
        }
        let depth = self.place(2, modal.position[2])?;
        let rapid = self.rapid_of_line()?;
        let Some(feed) = feed_word(&self.before.modal, self.source.style) else {
            let words: Vec<String> = rapid.into_iter().chain([depth]).collect();
            return Ok(Some(words.join(self.gap())));
        };
        let is_per_turn = modal.feed_mode == FeedMode::PerRevolution;
        if is_per_turn && modal.spindle == SpindleState::Off {
            return Err(HeadError(
                "the feed is per revolution, and the spindle stands still".into(),
            ));
        }
        let cut = self.needed(Action::Motion(MotionCode::Linear), "a straight cut")?;
        Ok(Some([cut, depth, feed].join(self.gap())))
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
        let mut rest = self.at..self.source.blocks.len();
        let next = rest.find(|at| {
            self.source.blocks[*at].word(b'D').is_some()
                || self.source.has_action(*at, self.control, starts)
        })?;
        let is_stated = self.source.blocks[next].word(b'D').is_some();
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
        let cycle_lines = cycle.lines(modal, self.control, self.gap()).map_err(HeadError)?;
        let [first, last] = match cycle.by_distance {
            true => [increments, None],
            false => [None, increments],
        };
        lines.extend(first.into_iter().chain(cycle_lines).chain(last));
        Ok(lines)
    }

    fn motion(&self, modal: &Modal) -> Result<Option<String>, HeadError> {
        match modal.motion {
            None => Ok(self.name(Action::Mode(ModeCode::CancelCycle))),
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
        self.control.parameters.rules.feed_mode_code_ends_feed
            && modal.feed_mode != FeedMode::InverseTime
            && feed_word(modal, self.source.style).is_none()
    }

    /// The program has turned a rotary axis, or said that it stands at zero.
    fn names(&self, axis: usize) -> bool {
        let letter = AXIS_LETTERS.as_bytes()[axis];
        let is_stated =
            self.source.blocks[..self.at].iter().any(|block| block.word(letter).is_some());
        is_stated || self.before.modal.position[axis] != 0.0
    }

    /// The block itself says what it does.
    fn says_motion(&self) -> bool {
        let words = &self.source.blocks[self.at].words;
        words.iter().any(|word| {
            let row = self.control.row_of(word);
            row.is_some_and(|row| row.group == CodeGroup::Motion)
        })
    }

    /// The word of an axis, with as many digits as it takes.
    pub(super) fn place(&self, axis: usize, value: f64) -> Result<String, HeadError> {
        let letter = char::from(AXIS_LETTERS.as_bytes()[axis]);
        let (modal, style) = (&self.before.modal, self.source.style);
        if axis > 2 {
            return Ok(format!("{letter}{}", plain(value.to_degrees(), MAX_DECIMALS, style)));
        }
        let value = if axis == 0 { value * self.before.x_factor } else { value };
        let unit = modal.units.mm();
        let off = |count: usize| {
            let power = 10f64.powi(count as i32);
            ((value / unit * power).round() / power * unit - value).abs()
        };
        let least = digits(self.control, modal.units);
        let count = (least..=MAX_DECIMALS).find(|count| off(*count) < EXACT);
        let Some(count) = count else {
            let what = format!("the position in {letter} has more decimals than the control takes");
            return Err(HeadError(what));
        };
        Ok(format!("{letter}{}", length(value, modal.units, count, style)))
    }
}
