//! What is in force at a place, as the words of a program.

use chordal::Control;
use chordal::control::{Action, FeedMode, Modal, SpindleState};
use chordal::machine::AXIS_LETTERS;

use super::words::StateWords;
use crate::convert::codes;
use crate::convert::numbers::{digits, length, plain};
use crate::source::SourceBlocks;

/// Decimals of rotary axes and feeds, and the most of all others.
const MAX_DECIMALS: usize = 6;

/// Places nearer than this are written as they are, mm or degrees.
pub(crate) const EXACT: f64 = 1e-10;

/// Writes what is in force at a place.
#[derive(Clone, Copy)]
pub(crate) struct StateWriter<'w, 'a> {
    pub(crate) source: &'w SourceBlocks<'a>,
    pub(crate) control: &'w Control,
    pub(crate) modal: &'w Modal,
    pub(crate) words: &'w StateWords,
    /// What a place of X is multiplied by in a word.
    pub(crate) x_factor: f64,
}

impl StateWriter<'_, '_> {
    /// The code that does something.
    pub(crate) fn name(&self, action: Action) -> Option<String> {
        codes::name(action, self.control, self.source.style)
    }

    /// Words in one line.
    pub(crate) fn line(&self, words: impl IntoIterator<Item = String>) -> String {
        words.into_iter().collect::<Vec<String>>().join(self.source.style.gap())
    }

    /// The tool change, in the program's own words.
    pub(crate) fn tool(&self) -> Option<String> {
        let words = self.words.tool.clone()?;
        let number = format!("T{}", self.modal.tool);
        Some(if words.contains('T') { words } else { self.line([number, words]) })
    }

    /// The tool that is made ready.
    pub(crate) fn ready_tool(&self) -> Option<String> {
        let ready = self.modal.selected_tool.filter(|ready| *ready != self.modal.tool);
        ready.map(|tool| format!("T{tool}"))
    }

    /// The work offset, where the program has chosen one.
    pub(crate) fn work(&self) -> Option<String> {
        codes::work_offset(self.modal.work, self.control, self.source.style)
            .filter(|_| self.words.work)
    }

    /// The code with H, where a length offset is in force.
    pub(crate) fn length_offset(&self) -> Vec<String> {
        let Some(number) = self.modal.length_offset else { return Vec::new() };
        let written = self.words.h.clone().filter(|word| word[1..].parse() == Ok(number));
        let h = written.unwrap_or_else(|| format!("H{number}"));
        self.words.length.clone().into_iter().chain([h]).collect()
    }

    pub(crate) fn speed(&self) -> Option<String> {
        let is_stated = self.words.speed && self.modal.rpm > 0.0;
        is_stated.then(|| self.rate('S', self.modal.rpm, 3))
    }

    /// The speed, and what starts the spindle.
    pub(crate) fn spindle(&self) -> Vec<String> {
        let start = self.words.spindle.clone();
        let start = start.filter(|_| self.modal.spindle != SpindleState::Off);
        self.speed().into_iter().chain(start).collect()
    }

    /// F as it is in force; nothing where each block says its own.
    pub(crate) fn feed(&self) -> Option<String> {
        let unit = self.modal.units.mm();
        let value = match self.modal.feed_mode {
            FeedMode::PerTime => self.modal.feed? * 60.0 / unit,
            FeedMode::PerRevolution => self.modal.feed? / unit,
            FeedMode::InverseTime => return None,
        };
        Some(format!("F{}", plain(value, MAX_DECIMALS, self.source.style)))
    }

    /// A word of a speed, without a point at its end.
    pub(crate) fn rate(&self, letter: char, value: f64, digits: usize) -> String {
        let text = plain(value, digits, self.source.style);
        format!("{letter}{}", text.trim_end_matches('.'))
    }

    /// The word of an axis, with as many digits as it takes, and by how much it is rounded where it would take too many, mm.
    pub(crate) fn place(&self, axis: usize, value: f64) -> (String, f64) {
        let (units, style) = (self.modal.units, self.source.style);
        let letter = char::from(AXIS_LETTERS.as_bytes()[axis]);
        if axis > 2 {
            return (format!("{letter}{}", plain(value.to_degrees(), MAX_DECIMALS, style)), 0.0);
        }
        let (value, unit) = (if axis == 0 { value * self.x_factor } else { value }, units.mm());
        let off = |count: usize| {
            let power = 10f64.powi(count as i32);
            ((value / unit * power).round() / power * unit - value).abs()
        };
        let least = digits(self.control, units);
        let exact = (least..=MAX_DECIMALS).find(|count| off(*count) < EXACT);
        let rounded_mm = if exact.is_some() { 0.0 } else { off(least) };
        let word = length(value, units, exact.unwrap_or(least), style);
        (format!("{letter}{word}"), rounded_mm)
    }
}
