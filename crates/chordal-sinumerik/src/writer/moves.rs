//! Moves: lines, arcs, helices, moves to positions of the machine.

use core::f64::consts::TAU;

use chordal_command::{ArcShape, AxisMask, Feed, FeedAlong, FeedMode, Move, Position};
use chordal_machine::{AXES, AXIS_NAMES};

use super::block_writer::{BlockWriter, WrittenMotion};
use super::words::{degrees, significant};
use crate::run::CENTER_NAMES;

/// The axis of the tool length.
const TOOL_AXIS: usize = 2;

/// The largest TURN.
const MAX_TURNS: f64 = 999.0;

/// Part of a turn that is rounding.
const TURN_ROUNDING: f64 = 1e-9;

impl BlockWriter<'_> {
    /// G0.
    pub fn rapid(&mut self, motion: &Move) -> Result<(), String> {
        self.straight(motion, WrittenMotion::Rapid, None)
    }

    /// G1.
    pub fn cut(&mut self, motion: &Move, feed: &Feed) -> Result<(), String> {
        let value = match motion.only_turns(None) && feed.mode == FeedMode::PerTime {
            true => feed.value.to_degrees() * 60.0,
            false => self.feed_value(feed),
        };
        self.straight(motion, WrittenMotion::Linear, Some((feed.mode, value)))
    }

    fn straight(
        &mut self,
        motion: &Move,
        code: WrittenMotion,
        feed: Option<(FeedMode, f64)>,
    ) -> Result<(), String> {
        let axes = self.axis_words(motion);
        if axes.is_empty() {
            return Ok(());
        }
        self.check_rotary_feed(motion, feed)?;
        let edge = self.edge_of(motion)?;
        let [mut words, last] = self.take_pending();
        if self.motion != Some(code) {
            words.push(motion_code(code).to_string());
            self.motion = Some(code);
        }
        words.extend(axes);
        if let Some((mode, value)) = feed {
            words.extend(self.feed_word(mode, value));
        }
        words.extend(last);
        words.extend(edge.map(String::from));
        self.line(words.join(" "));
        Ok(())
    }

    /// G2 and G3 with an incremental centre; a helix of more than a turn with TURN.
    pub fn arc(&mut self, motion: &Move, shape: &ArcShape, feed: &Feed) -> Result<(), String> {
        let (a, b, _) = shape.plane.axes();
        let end = [a, b].map(|axis| self.lengths.rounded(motion.to[axis]));
        let start = [a, b].map(|axis| self.lengths.rounded(motion.from[axis]));
        let is_closed = start == end;
        if is_closed && shape.sweep.abs() < 1.0 {
            // As it is rounded nothing is left of the arc, and the control would make a full circle.
            return self.cut(motion, feed);
        }
        let whole = (shape.sweep.abs() / TAU - TURN_ROUNDING).floor().max(0.0);
        let turns = if is_closed { (shape.sweep.abs() / TAU).round() - 1.0 } else { whole };
        if turns > MAX_TURNS {
            return Err(format!("an arc of {turns} turns: TURN is {MAX_TURNS} at most"));
        }
        let edge = self.edge_of(motion)?;
        let [mut words, last] = self.take_pending();
        words.push(if shape.sweep < 0.0 { "G2" } else { "G3" }.to_string());
        words.extend(self.axis_words(motion));
        for (axis, center) in [a, b].into_iter().zip(shape.center) {
            let from = self.lengths.rounded(motion.from[axis]);
            words.push(format!("{}{}", CENTER_NAMES[axis], self.lengths.text(center - from)));
        }
        if turns > 0.0 {
            words.push(format!("TURN={turns}"));
        }
        let value = self.feed_value(feed) * self.helix_scale(motion, shape, feed);
        words.extend(self.feed_word(feed.mode, value));
        words.extend(last);
        words.extend(edge.map(String::from));
        self.motion = None;
        self.line(words.join(" "));
        Ok(())
    }

    /// A rapid in machine coordinates, without the length of the tool.
    pub fn machine_move(&mut self, place: &Position, axes: AxisMask) {
        self.flush();
        let words: Vec<String> =
            axes.iter().map(|axis| self.axis_word(axis as usize, place[axis as usize])).collect();
        self.motion = Some(WrittenMotion::Rapid);
        self.edge.is_on = false;
        self.edge.is_due = self.edge.desired.is_some();
        self.line(format!("SUPA G0 {} D0", words.join(" ")));
    }

    fn axis_words(&self, motion: &Move) -> Vec<String> {
        let moved = (0..AXES).filter(|axis| motion.from[*axis] != motion.to[*axis]);
        moved.map(|axis| self.axis_word(axis, motion.to[axis])).collect()
    }

    fn axis_word(&self, axis: usize, place: f64) -> String {
        let value = if axis < 3 { self.lengths.text(place) } else { degrees(place) };
        format!("{}{value}", AXIS_NAMES[axis])
    }

    /// The edge, where a move needs it.
    fn edge_of(&mut self, motion: &Move) -> Result<Option<&'static str>, String> {
        match motion.from[TOOL_AXIS] != motion.to[TOOL_AXIS] {
            true => self.set_edge(),
            false => Ok(None),
        }
    }

    /// F in program units, along the path.
    fn feed_value(&self, feed: &Feed) -> f64 {
        let unit = self.lengths.units.mm();
        match feed.mode {
            FeedMode::PerTime => feed.value * 60.0 / unit,
            FeedMode::PerRevolution => feed.value / unit,
            FeedMode::InverseTime => feed.value * 60.0,
        }
    }

    /// What F of a helix is multiplied by: this control measures it along the path.
    fn helix_scale(&self, motion: &Move, shape: &ArcShape, feed: &Feed) -> f64 {
        let (_, _, normal) = shape.plane.axes();
        let flat = (shape.radius_from + shape.radius_to) / 2.0 * shape.sweep.abs();
        let is_flat = feed.along == FeedAlong::Plane && feed.mode != FeedMode::InverseTime;
        match is_flat && flat > 0.0 {
            true => flat.hypot(motion.to[normal] - motion.from[normal]) / flat,
            false => 1.0,
        }
    }

    /// F along lines on which rotary axes turn too is not known to be the same.
    fn check_rotary_feed(
        &self,
        motion: &Move,
        feed: Option<(FeedMode, f64)>,
    ) -> Result<(), String> {
        let turns = (3..AXES).any(|axis| motion.from[axis] != motion.to[axis]);
        let is_per_length =
            feed.is_some_and(|(mode, _)| mode != FeedMode::InverseTime) && !motion.only_turns(None);
        match turns && is_per_length {
            true => Err("a feed along linear and rotary axes together: use G93".into()),
            false => Ok(()),
        }
    }

    /// F, where another one is active.
    pub fn feed_word(&mut self, mode: FeedMode, value: f64) -> Option<String> {
        if !value.is_finite() {
            return None;
        }
        let text = format!("F{}", significant(value));
        let is_same = self.feed.as_ref() == Some(&text) && mode != FeedMode::InverseTime;
        (!is_same).then(|| {
            self.feed = Some(text.clone());
            text
        })
    }

    /// F of a cycle, where another one is active.
    pub fn cycle_feed(&mut self, feed: &Feed) -> Option<String> {
        let value = self.feed_value(feed);
        self.feed_word(feed.mode, value)
    }

    /// F of a cut, as an argument of a cycle.
    pub fn feed_argument(&self, feed: &Feed, value: f64) -> f64 {
        self.feed_value(&Feed { value, ..*feed })
    }
}

fn motion_code(motion: WrittenMotion) -> &'static str {
    match motion {
        WrittenMotion::Rapid => "G0",
        WrittenMotion::Linear => "G1",
    }
}
