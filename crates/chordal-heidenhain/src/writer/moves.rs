//! Moves: lines, arcs, helices, moves to positions of the machine.

use core::f64::consts::TAU;

use chordal_command::{
    ArcShape, AxisMask, CompensationSide, Feed, FeedAlong, FeedMode, Move, Position,
};
use chordal_geometry::Plane;
use chordal_machine::AXES;

use super::blocks::{KlartextBlocks, preset_block};
use super::words::{degrees, feed_unit, signed, signed_length, significant};
use crate::syntax::AXIS_WORDS;

/// The axis of the tool length.
const TOOL_AXIS: usize = 2;

/// Part of a turn that is rounding.
const TURN_ROUNDING: f64 = 1e-9;

/// Digits after the point of IPA, degrees.
const TURN_DIGITS: usize = 7;

impl KlartextBlocks<'_> {
    /// L with FMAX.
    pub fn rapid(&mut self, motion: &Move) -> Result<(), String> {
        self.straight(motion, None)
    }

    /// L with F.
    pub fn cut(&mut self, motion: &Move, feed: &Feed) -> Result<(), String> {
        let length = (0..3).map(|axis| (motion.to[axis] - motion.from[axis]).powi(2)).sum::<f64>();
        let value = match motion.only_turns(None) && feed.mode == FeedMode::PerTime {
            true => feed.value.to_degrees() * 60.0,
            false => self.feed_value(feed, length.sqrt()),
        };
        self.check_rotary_feed(motion, feed)?;
        if feed.mode == FeedMode::InverseTime {
            self.check_known_rise(motion)?;
        }
        self.straight(motion, Some(value))
    }

    fn straight(&mut self, motion: &Move, feed: Option<f64>) -> Result<(), String> {
        let axes = self.axis_words(motion);
        if axes.is_empty() {
            return Ok(());
        }
        self.check_length(motion)?;
        self.prepare_move(feed.is_some())?;
        let mut words = vec!["L".to_string()];
        words.extend(axes);
        match (self.take_side()?, feed) {
            (Some(word), _) => words.push(word.into()),
            (None, None) if self.side.written == CompensationSide::Off => words.push("R0".into()),
            (None, _) => {}
        }
        match feed {
            Some(value) => words.extend(self.feed_word(value)),
            None => words.push("FMAX".into()),
        }
        words.extend(self.take_functions());
        self.push_corner_function(&mut words);
        if std::mem::take(&mut self.calls_cycle) {
            words.push("M99".into());
            self.has_called = true;
        }
        self.is_length_new &= !self.is_moved(motion, TOOL_AXIS);
        self.line(words.join(" "));
        Ok(())
    }

    /// CC and C; a helix of more than a turn with CP.
    pub fn arc(&mut self, motion: &Move, shape: &ArcShape, feed: &Feed) -> Result<(), String> {
        let (a, b, normal) = shape.plane.axes();
        let end = [a, b].map(|axis| self.lengths.rounded(motion.to[axis]));
        let start = [a, b].map(|axis| self.lengths.rounded(motion.from[axis]));
        let is_closed = start == end;
        if is_closed && shape.sweep.abs() < 1.0 {
            // As it is rounded nothing is left of the arc, and the control would make a full circle.
            return self.cut(motion, feed);
        }
        if self.side.desired != self.side.written {
            return Err(
                "tool radius compensation that begins or ends on an arc: the control needs a line"
                    .into(),
            );
        }
        if self.side.written != CompensationSide::Off && shape.plane != Plane::Xy {
            return Err(
                "tool radius compensation in another plane than that of the tool axis Z".into()
            );
        }
        self.check_length(motion)?;
        let is_long = shape.sweep.abs() / TAU > 1.0 + TURN_ROUNDING;
        if is_long || feed.along == FeedAlong::Plane || feed.mode == FeedMode::InverseTime {
            self.check_known_rise(motion)?;
        }
        self.prepare_move(true)?;
        self.set_center([a, b], shape.center);
        let rise =
            self.lengths.rounded(motion.to[normal]) - self.lengths.rounded(motion.from[normal]);
        let mut words = match is_long {
            true => self.polar_words(shape, is_closed, (normal, rise)),
            false => self.end_words(motion, [a, b]),
        };
        words.push(if shape.sweep < 0.0 { "DR-" } else { "DR+" }.into());
        let flat = (shape.radius_from + shape.radius_to) / 2.0 * shape.sweep.abs();
        let scale = self.helix_scale(flat, rise, feed);
        let value = self.feed_value(feed, flat.hypot(rise)) * scale;
        words.extend(self.feed_word(value));
        words.extend(self.take_functions());
        self.push_corner_function(&mut words);
        self.is_length_new &= !self.is_moved(motion, TOOL_AXIS);
        self.line(words.join(" "));
        Ok(())
    }

    /// How far the first move along a new tool goes depends on the length of the tool, and what is written must not.
    fn check_known_rise(&self, motion: &Move) -> Result<(), String> {
        match self.is_length_new && self.is_moved(motion, TOOL_AXIS) {
            true => Err("a helix, or a move in inverse time, directly after a tool change: how far it goes along the tool depends on the length of the tool, so move to a level before it".into()),
            false => Ok(()),
        }
    }

    /// CC, where another one is active. Its two axes choose the plane of the arc.
    fn set_center(&mut self, axes: [usize; 2], center: [f64; 2]) {
        let mut words: Vec<(usize, String)> = axes
            .into_iter()
            .zip(center)
            .map(|(axis, value)| {
                (axis, format!("{}{}", AXIS_WORDS[axis], signed_length(self.lengths, value)))
            })
            .collect();
        words.sort();
        let words: Vec<String> = words.into_iter().map(|(_, word)| word).collect();
        let text = format!("CC {}", words.join(" "));
        if self.center.as_ref() != Some(&text) {
            self.line(text.clone());
            self.center = Some(text);
        }
    }

    /// C with the end of an arc of one turn at most.
    fn end_words(&self, motion: &Move, plane: [usize; 2]) -> Vec<String> {
        let is_written = |axis: &usize| plane.contains(axis) || self.is_moved(motion, *axis);
        let ends = (0..AXES).filter(is_written).map(|axis| self.axis_word(axis, motion.to[axis]));
        std::iter::once("C".to_string()).chain(ends).collect()
    }

    /// CP with the angle of several turns.
    fn polar_words(
        &self,
        shape: &ArcShape,
        is_closed: bool,
        (normal, rise): (usize, f64),
    ) -> Vec<String> {
        let angle = match is_closed {
            true => (shape.sweep / TAU).round() * 360.0,
            false => shape.sweep.to_degrees(),
        };
        let mut words = vec!["CP".to_string(), format!("IPA{}", signed(angle, TURN_DIGITS))];
        if rise != 0.0 {
            words.push(format!("I{}{}", AXIS_WORDS[normal], signed_length(self.lengths, rise)));
        }
        words
    }

    /// A rapid in machine coordinates.
    pub fn machine_move(&mut self, place: &Position, axes: AxisMask) {
        self.write_spindle();
        self.is_length_new |= axes.has(TOOL_AXIS);
        let mut words = vec!["L".to_string()];
        words.extend(axes.iter().map(|axis| self.axis_word(axis as usize, place[axis as usize])));
        self.side.desired = CompensationSide::Off;
        self.side.written = CompensationSide::Off;
        words.extend(["R0", "FMAX"].map(String::from));
        words.extend(self.take_functions());
        words.push("M91".into());
        self.line(words.join(" "));
    }

    fn is_moved(&self, motion: &Move, axis: usize) -> bool {
        motion.from[axis] != motion.to[axis]
    }

    fn axis_words(&self, motion: &Move) -> Vec<String> {
        let moved = (0..AXES).filter(|axis| self.is_moved(motion, *axis));
        moved.map(|axis| self.axis_word(axis, motion.to[axis])).collect()
    }

    fn axis_word(&self, axis: usize, place: f64) -> String {
        let value = if axis < 3 { signed_length(self.lengths, place) } else { degrees(place) };
        format!("{}{value}", AXIS_WORDS[axis])
    }

    /// What a move needs before it.
    ///
    /// # Errors
    /// Why it cannot be active.
    pub fn prepare_move(&mut self, is_cut: bool) -> Result<(), String> {
        self.write_tool_axis();
        if let Some(preset) = self.preset.take() {
            self.line(preset_block(preset));
            self.cycle = None;
        }
        if let Some(tolerance) = self.tolerance.take() {
            let value =
                tolerance.map_or_else(String::new, |mm| format!(" T{}", self.lengths.text(mm)));
            self.line("CYCL DEF 32.0 TOLERANCE");
            self.line(format!("CYCL DEF 32.1{value}"));
        }
        if is_cut && let Some(mode) = self.feed_mode.take() {
            self.feed = None;
            match mode {
                FeedMode::PerRevolution => self.wait("M136"),
                FeedMode::PerTime | FeedMode::InverseTime => self.wait("M137"),
            }
        }
        self.write_spindle();
        Ok(())
    }

    /// R0, RL or RR, where another side is active.
    fn take_side(&mut self) -> Result<Option<&'static str>, String> {
        let before = self.side.written;
        let Some(side) = self.side.take() else { return Ok(None) };
        if before != CompensationSide::Off && side != CompensationSide::Off {
            return Err("tool radius compensation that changes from one side to the other: the control needs a block with R0 between".into());
        }
        Ok(Some(match side {
            CompensationSide::Off => "R0",
            CompensationSide::Left => "RL",
            CompensationSide::Right => "RR",
        }))
    }

    /// M97 at corners of a compensated contour.
    fn push_corner_function(&self, words: &mut Vec<String>) {
        if self.meets_corner && self.side.written != CompensationSide::Off {
            words.push("M97".into());
        }
    }

    /// TOOL CALL makes the length of its tool active: a move along the tool must want it.
    fn check_length(&self, motion: &Move) -> Result<(), String> {
        match self.is_moved(motion, TOOL_AXIS) {
            true => self.check_active_length(),
            false => Ok(()),
        }
    }

    /// The length that the program wants is that of the tool.
    ///
    /// # Errors
    /// Which length the program has instead.
    pub fn check_active_length(&self) -> Result<(), String> {
        let tool = self.tool;
        match self.length {
            Some(number) if number == tool => Ok(()),
            None if tool == 0 => Ok(()),
            Some(number) => Err(format!(
                "a move along the tool with length offset {number} and tool {tool}: TOOL CALL makes the length of its own tool active"
            )),
            None => Err(format!(
                "a move along the tool without a tool length: TOOL CALL {tool} makes the length of the tool active"
            )),
        }
    }

    /// F in its unit, along the path; `length` of the move, mm.
    fn feed_value(&self, feed: &Feed, length: f64) -> f64 {
        match feed.mode {
            FeedMode::PerTime => feed.value / feed_unit(self.lengths.units),
            FeedMode::PerRevolution => feed.value / self.lengths.units.mm(),
            FeedMode::InverseTime => feed.value * length / feed_unit(self.lengths.units),
        }
    }

    /// F of a cycle, in its unit.
    pub fn cycle_feed(&self, value: f64) -> f64 {
        value / feed_unit(self.lengths.units)
    }

    /// What F of a helix is multiplied by: this control measures it along the path.
    fn helix_scale(&self, flat: f64, rise: f64, feed: &Feed) -> f64 {
        let is_flat = feed.along == FeedAlong::Plane && feed.mode != FeedMode::InverseTime;
        if is_flat && flat > 0.0 { flat.hypot(rise) / flat } else { 1.0 }
    }

    /// F along lines on which rotary axes turn too is not known to be the same.
    fn check_rotary_feed(&self, motion: &Move, feed: &Feed) -> Result<(), String> {
        let turns = (3..AXES).any(|axis| self.is_moved(motion, axis));
        match turns && !(motion.only_turns(None) && feed.mode == FeedMode::PerTime) {
            true => Err("a feed along linear and rotary axes together".into()),
            false => Ok(()),
        }
    }

    /// F, where another one is active.
    fn feed_word(&mut self, value: f64) -> Option<String> {
        if !value.is_finite() {
            return None;
        }
        let text = format!("F{}", significant(value));
        let is_same = self.feed.as_ref() == Some(&text);
        (!is_same).then(|| {
            self.feed = Some(text.clone());
            text
        })
    }
}
