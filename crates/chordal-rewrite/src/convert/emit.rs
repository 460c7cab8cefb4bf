//! Blocks written from what they do, where the new control has no form for how they were written.

use chordal::control::PathCode;
use chordal::control::{
    Action, AfterCode, BeforeCode, LengthCode, ModeCode, MotionCode, OnceCode, ReadingCode,
};
use chordal::control::{
    ArcShape, CompensationSide, Control, Coolant, Feed, FeedMode, Move, Overrides, PathMode,
    SpindleState, Units, WorkName,
};
use chordal::geometry::Plane;
use chordal::machine::{AXES, AXIS_LETTERS};
use chordal::{Command, CommandKind};

use super::ConvertRefusal;
use super::arcs;
use super::codes;
use super::context::ConvertContext;
use super::feed::feed_word;
use super::numbers;
use super::spiral;
use super::tap::{self, TappedThread};
use super::thread;
use super::trace::ActiveModes;
use super::turning;
use crate::source::WordStyle;

mod effects;
mod holes;
mod lathe;
mod whole_runs;

pub(super) use self::holes::WrittenCycle;
pub(super) use self::whole_runs::WRITTEN_STYLE;

use self::lathe::{LatheModes, reads_distances};

/// Writes commands as blocks in absolute coordinates.
#[derive(Clone)]
pub(crate) struct CommandEmitter<'a> {
    /// The old control; `None` where its language is another one.
    pub(super) from: Option<&'a Control>,
    to: &'a Control,
    style: WordStyle,
    tolerance_mm: f64,
    units: Units,
    digits: Option<usize>,
    /// What the new control has active, where it is known.
    motion: Option<Action>,
    incremental: Option<bool>,
    plane: Plane,
    feed: Option<String>,
    /// Words that go into the next block that moves.
    pending: Vec<String>,
    pub lines: Vec<String>,
    /// Text that was printed is a remark now.
    pub printed: bool,
    /// Blocks that keep their words because they could not be written out.
    pub unwritten: Vec<ConvertRefusal>,
    /// What a place of X is multiplied by in a word.
    x_factor: f64,
    lathe: LatheModes,
}

/// Why commands cannot be written.
pub(crate) type EmitRefusal = String;

impl<'a> CommandEmitter<'a> {
    pub fn new(
        context: &ConvertContext<'a>,
        tolerance_mm: f64,
        digits: Option<usize>,
        before: &ActiveModes,
    ) -> CommandEmitter<'a> {
        let (to, style) = (context.to, context.style());
        CommandEmitter {
            from: Some(context.from),
            to,
            style,
            tolerance_mm,
            units: before.units,
            digits,
            motion: None,
            incremental: Some(before.incremental && reads_distances(to)),
            plane: before.plane,
            feed: None,
            pending: Vec::new(),
            lines: Vec::new(),
            printed: false,
            unwritten: Vec::new(),
            x_factor: if context.same_control() { before.per_x.recip() } else { context.x_factor },
            lathe: LatheModes::of(context.turns(), before),
        }
    }

    /// Writes the commands of a block.
    pub fn block(&mut self, commands: &[Command]) -> Result<(), EmitRefusal> {
        let mut at = 0;
        while let Some(command) = commands.get(at) {
            if self.lathe.is_one
                && let Some((motion, lead)) = thread::first(&commands[at..])
            {
                self.thread(motion, lead)?;
                at += thread::COMMANDS;
                continue;
            }
            let tap = tap::length(&commands[at..]);
            if tap > 0 {
                self.tap(&TappedThread::of(&commands[at..at + tap])?)?;
                at += tap;
            } else {
                self.command(&command.kind)?;
                at += 1;
            }
        }
        self.flush();
        Ok(())
    }

    /// A line as it is; what is active after it is not known.
    pub fn foreign(&mut self, lines: impl IntoIterator<Item = String>, after: &ActiveModes) {
        self.flush();
        self.lines.extend(lines);
        self.motion = None;
        self.feed = None;
        self.incremental = Some(after.incremental && reads_distances(self.to));
        self.plane = after.plane;
        self.units = after.units;
    }

    /// Puts in force what the old control has active here.
    pub fn restore(&mut self, modes: &ActiveModes) {
        let mut words = Vec::new();
        if self.plane != modes.plane {
            words.extend(self.code(Action::from(modes.plane)));
            self.plane = modes.plane;
        }
        if self.incremental != Some(modes.incremental) && reads_distances(self.to) {
            words.extend(self.code(Action::of_distance(modes.incremental)));
            self.incremental = Some(modes.incremental);
        }
        if let Some(action) = modes.motion
            && self.motion.is_some()
            && self.motion != Some(action)
            && matches!(
                action,
                Action::Motion(MotionCode::Rapid) | Action::Motion(MotionCode::Linear)
            )
        {
            words.extend(self.code(action));
            self.motion = Some(action);
        }
        self.pending.extend(words);
        self.restore_feed(modes);
        self.flush();
    }

    /// F, where what was written holds another one.
    fn restore_feed(&mut self, modes: &ActiveModes) {
        let Some(value) = modes.feed.filter(|_| self.feed.is_some()) else { return };
        let per_unit = match modes.feed_mode {
            FeedMode::PerTime => 60.0,
            FeedMode::PerRevolution => 1.0,
            FeedMode::InverseTime => return,
        };
        let mut words = Vec::new();
        self.feed_value(&mut words, value * per_unit / self.units.mm());
        self.pending.extend(words);
    }

    /// Lines that do nothing.
    pub fn remarks(&mut self, lines: Vec<String>) {
        self.lines.extend(lines);
    }

    /// Writes what is held for the next block.
    pub fn finish(&mut self) {
        self.flush();
    }

    fn flush(&mut self) {
        if self.pending.is_empty() {
            return;
        }
        let words = std::mem::take(&mut self.pending);
        self.line(&words);
    }

    fn line(&mut self, words: &[String]) {
        self.lines.push(words.join(self.style.gap()));
    }

    fn code(&self, action: Action) -> Option<String> {
        codes::name(action, self.to, self.style)
    }

    fn due(&self, action: Action) -> Result<String, EmitRefusal> {
        self.code(action).ok_or_else(|| {
            format!("{} has no code for it ({})", self.to.table.title, codes::what(action))
        })
    }

    fn command(&mut self, kind: &CommandKind) -> Result<(), EmitRefusal> {
        match kind {
            CommandKind::Rapid { motion, .. } => self.rapid(motion)?,
            CommandKind::Line { motion, feed } => self.cut(motion, feed)?,
            CommandKind::Arc { motion, shape, feed }
            | CommandKind::Spiral { motion, shape, feed } => self.arc(motion, shape, feed)?,
            CommandKind::Spline { .. } => {
                return Err(format!(
                    "{} has no splines: write the curve as lines or arcs before the conversion",
                    self.to.table.title
                ));
            }
            CommandKind::Dwell { seconds, .. } => {
                self.flush();
                let word = numbers::dwell_word(*seconds, self.to);
                let code = self.due(Action::Once(OnceCode::Dwell))?;
                self.line(&[code, word.unwrap_or_default()]);
            }
            CommandKind::Tool { number } if self.has_stations() => {
                self.flush();
                self.lathe.tool = *number;
            }
            CommandKind::ToolLength { number, .. } if self.has_stations() => {
                self.flush();
                self.lines.extend(turning::station(self.to, self.lathe.tool, *number));
            }
            CommandKind::Tool { number } => {
                self.flush();
                let code = self.due(Action::Before(BeforeCode::ToolChange))?;
                self.line(&[format!("T{number}"), code]);
            }
            CommandKind::ToolNumber { number } => {
                self.flush();
                let code = self.due(Action::Before(BeforeCode::SetToolNumber))?;
                self.line(&[code, format!("Q{number}")]);
            }
            CommandKind::ToolSelect { .. } | CommandKind::Idle | CommandKind::Message(_) => {}
            CommandKind::ToolLength { .. } if !codes::has_lengths(self.to) => {}
            CommandKind::ToolLength { number: None, .. } => {
                let code = self.due(Action::Length(LengthCode::Cancel))?;
                self.pending.push(code);
            }
            CommandKind::ToolLength { number: Some(number), .. } => {
                let code = self.due(Action::Length(LengthCode::Plus))?;
                self.pending.extend([code, format!("H{number}")]);
            }
            CommandKind::Compensation { side, number, toward, .. } => {
                if toward.is_some() {
                    return Err("compensation with a programmed direction (I J K)".into());
                }
                self.compensation(*side, *number)?;
            }
            CommandKind::Spindle { state, rpm } => self.spindle(*state, *rpm)?,
            CommandKind::Coolant(coolant) => self.coolant(*coolant)?,
            CommandKind::Stop { optional } => {
                self.flush();
                let action = if *optional {
                    Action::After(AfterCode::OptionalStop)
                } else {
                    Action::After(AfterCode::ProgramStop)
                };
                let code = self.due(action)?;
                self.line(&[code]);
            }
            CommandKind::End => {
                self.flush();
                let code = self.due(Action::After(AfterCode::ProgramEnd { rewind: true }))?;
                self.line(&[code]);
            }
            CommandKind::Units(units) => {
                let code = self.due(Action::from(*units))?;
                self.pending.push(code);
                self.units = *units;
                self.feed = None;
            }
            CommandKind::Plane(plane) => {
                if self.plane != *plane {
                    let code = self.due(Action::from(*plane))?;
                    self.pending.push(code);
                    self.plane = *plane;
                }
            }
            CommandKind::FeedMode(mode) => {
                let code = self.due(Action::from(*mode))?;
                self.pending.push(code);
                self.feed = None;
            }
            // F is written with the cut that it holds for.
            CommandKind::FeedRate { .. } => {}
            CommandKind::PathMode(mode) => self.path_mode(*mode),
            CommandKind::Overrides(overrides) => self.overrides(*overrides)?,
            CommandKind::WorkOffset { name, .. } => self.work_offset(*name)?,
            CommandKind::CornerArc { .. } => return Err("a programmed corner arc".into()),
            CommandKind::CornerMode { .. } => {
                return Err("a choice of the form of outside corners".into());
            }
            CommandKind::Probed { .. } => return Err("a probing move".into()),
            CommandKind::Surface { .. } => {
                return Err("polar or cylindrical interpolation".into());
            }
            CommandKind::PartFrame { .. } => return Err("tool centre point control".into()),
            CommandKind::Output { text } => {
                self.flush();
                let text = text.replace('(', "[").replace(')', "]");
                self.lines.push(format!("(PRINTED: {})", text.trim()));
                self.printed = true;
            }
            CommandKind::Effect(effect) => self.effect(effect),
        }
        Ok(())
    }

    fn length(&self, mm: f64) -> String {
        let digits = self.digits.unwrap_or_else(|| numbers::digits(self.to, self.units));
        numbers::length(mm, self.units, digits, self.style)
    }

    /// A place of an axis as the control reads it: X may be a diameter.
    fn place(&self, axis: usize, mm: f64) -> String {
        self.length(if axis == 0 { mm * self.x_factor } else { mm })
    }

    /// The axis words of a move; an end that is not known relative to the part cannot be written.
    fn axes(&self, motion: &Move) -> Result<Vec<String>, EmitRefusal> {
        let mut words = Vec::new();
        for axis in 0..AXES {
            let (from, to) = (motion.from[axis], motion.to[axis]);
            let is_new = motion.to_known.has(axis) && !motion.from_known.has(axis);
            if from == to && !is_new {
                continue;
            }
            if !motion.to_known.has(axis) {
                return Err("a position that is not known relative to the part".into());
            }
            let letter = AXIS_LETTERS.as_bytes()[axis] as char;
            let value = if axis < 3 {
                self.place(axis, to)
            } else {
                numbers::plain(to.to_degrees(), 3, self.style)
            };
            words.push(format!("{letter}{value}"));
        }
        Ok(words)
    }

    /// Begins a block that moves: distance mode and motion code where they are needed.
    fn head(&mut self, action: Action) -> Result<Vec<String>, EmitRefusal> {
        let mut words = Vec::new();
        if self.incremental != Some(false) {
            words.push(self.due(Action::Reading(ReadingCode::Absolute))?);
            self.incremental = Some(false);
        }
        words.append(&mut self.pending);
        let is_arc = matches!(
            action,
            Action::Motion(MotionCode::ArcCw) | Action::Motion(MotionCode::ArcCcw)
        );
        if self.motion != Some(action) || is_arc {
            words.push(self.due(action)?);
        }
        self.motion = Some(action);
        Ok(words)
    }

    fn rapid(&mut self, motion: &Move) -> Result<(), EmitRefusal> {
        let axes = self.axes(motion)?;
        if axes.is_empty() {
            return Ok(());
        }
        let mut words = self.head(Action::Motion(MotionCode::Rapid))?;
        words.extend(axes);
        self.line(&words);
        Ok(())
    }

    fn cut(&mut self, motion: &Move, feed: &Feed) -> Result<(), EmitRefusal> {
        let axes = self.axes(motion)?;
        if axes.is_empty() {
            return Ok(());
        }
        let mut words = self.head(Action::Motion(MotionCode::Linear))?;
        words.extend(axes);
        let value = feed_word(motion, None, feed, self.to, self.units);
        self.feed(&mut words, feed, value);
        self.line(&words);
        Ok(())
    }

    fn arc(&mut self, motion: &Move, shape: &ArcShape, feed: &Feed) -> Result<(), EmitRefusal> {
        if shape.plane != self.plane {
            return Err("an arc outside the active plane".into());
        }
        let most = self.to.parameters.rules.arc.radius_error_tolerance_mm.min(self.tolerance_mm);
        for piece in spiral::as_arcs(motion, shape, most, self.tolerance_mm) {
            self.one_arc(&piece.motion, &piece.shape, feed)?;
        }
        Ok(())
    }

    /// An arc of at most a turn.
    fn one_arc(&mut self, motion: &Move, shape: &ArcShape, feed: &Feed) -> Result<(), EmitRefusal> {
        let action = if shape.sweep < 0.0 {
            Action::Motion(MotionCode::ArcCw)
        } else {
            Action::Motion(MotionCode::ArcCcw)
        };
        let mut words = self.axes(motion)?;
        let (a, b, _) = shape.plane.axes();
        // Where an axis of the plane stays, the end may be left out; both left out is a full circle.
        let turn = std::f64::consts::TAU;
        let is_full = (shape.sweep.abs() - turn).abs() < 1e-9;
        let in_plane =
            |word: &String| [a, b].iter().any(|axis| word.starts_with(LINEAR_AXES[*axis]));
        let must_name = arcs::needs_axes(self.to);
        if (!is_full || must_name) && !words.iter().any(in_plane) {
            words.push(format!("{}{}", LINEAR_AXES[a], self.place(a, motion.to[a])));
        }
        let absolute =
            self.to.parameters.rules.arc.arc_center == chordal::control::ArcCenter::Absolute;
        let back =
            self.to.parameters.rules.arc.arc_center == chordal::control::ArcCenter::FromCenter;
        let mut centers = Vec::new();
        for (axis, center) in [a, b].into_iter().zip(shape.center) {
            let path = center - motion.from[axis];
            let value = if absolute {
                center
            } else if back {
                -path
            } else {
                path
            };
            if value.abs() > 1e-7 || absolute {
                centers.push(format!("{}{}", CENTERS[axis], self.length(value)));
            }
        }
        centers.sort();
        if centers.is_empty() {
            centers.push(format!("{}0.", CENTERS[a]));
        }
        words.extend(centers);
        let mut line = self.head(action)?;
        line.extend(words);
        let value = feed_word(motion, Some(shape), feed, self.to, self.units);
        self.feed(&mut line, feed, value);
        self.line(&line);
        Ok(())
    }

    /// A tap at the level where the tool stands, and the end of the cycle.
    fn tap(&mut self, tap: &TappedThread) -> Result<(), EmitRefusal> {
        if self.lathe.is_one && self.plane != Plane::Xy && self.tap_in_step(tap)? {
            return Ok(());
        }
        if self.plane != Plane::Xy {
            return Err("a tap outside the XY plane".into());
        }
        self.flush();
        let words = tap.words(self.to, self.units, self.style, |mm| self.length(mm));
        let words = words.ok_or("a tap without a spindle speed, on which its feed depends")?;
        let mut line = self.head(tap.action())?;
        line.extend(words);
        self.line(&line);
        let end = self.due(Action::Mode(ModeCode::CancelCycle))?;
        self.line(&[end]);
        self.motion = None;
        // What F is now depends on the control.
        self.feed = Some(String::new());
        Ok(())
    }

    /// F of this value, where it is not in force.
    fn feed(&mut self, words: &mut Vec<String>, feed: &Feed, value: f64) {
        if feed.mode == FeedMode::InverseTime && value.is_finite() {
            // Each block needs its own.
            self.feed = None;
        }
        self.feed_value(words, value);
    }

    fn feed_value(&mut self, words: &mut Vec<String>, value: f64) {
        if !value.is_finite() {
            return;
        }
        let text = numbers::feed(value, self.style);
        if self.feed.as_ref() != Some(&text) {
            words.push(format!("F{text}"));
            self.feed = Some(text);
        }
    }

    fn compensation(
        &mut self,
        side: CompensationSide,
        number: Option<u32>,
    ) -> Result<(), EmitRefusal> {
        let action = match side {
            CompensationSide::Off => Action::Mode(ModeCode::CompensationOff),
            CompensationSide::Left => Action::Mode(ModeCode::CompensationLeft),
            CompensationSide::Right => Action::Mode(ModeCode::CompensationRight),
        };
        let code = self.due(action)?;
        self.pending.push(code);
        if side != CompensationSide::Off && !self.lathe.is_one {
            self.pending.extend(number.map(|number| format!("D{number}")));
        }
        Ok(())
    }

    fn spindle(&mut self, state: SpindleState, rpm: f64) -> Result<(), EmitRefusal> {
        if self.lathe.is_live {
            return Err("a live tool is started or stopped in it".into());
        }
        let is_same = std::mem::replace(&mut self.lathe.spindle, state) == state;
        let follows = self.lathe.is_one && self.lathe.keeps_surface_speed;
        if follows && is_same {
            return Ok(());
        }
        self.flush();
        let action = match state {
            SpindleState::Off => Action::After(AfterCode::SpindleStop),
            SpindleState::Cw => Action::Before(BeforeCode::SpindleCw),
            SpindleState::Ccw => Action::Before(BeforeCode::SpindleCcw),
            SpindleState::Oriented => Action::Before(BeforeCode::SpindleOrient),
        };
        let code = self.due(action)?;
        let turns = matches!(state, SpindleState::Cw | SpindleState::Ccw);
        let mut words = Vec::new();
        if turns && !follows {
            words.push(format!("S{rpm}"));
        }
        words.push(code);
        self.line(&words);
        Ok(())
    }

    fn coolant(&mut self, coolant: Coolant) -> Result<(), EmitRefusal> {
        let mut words = Vec::new();
        if coolant.mist {
            words.push(self.due(Action::Before(BeforeCode::CoolantMist))?);
        }
        if coolant.flood {
            words.push(self.due(Action::Before(BeforeCode::CoolantFlood))?);
        }
        if coolant.through_tool {
            words.push(self.due(Action::Before(BeforeCode::CoolantThroughTool))?);
        }
        if words.is_empty() {
            words.push(self.due(Action::After(AfterCode::CoolantOff))?);
        }
        self.flush();
        // Some controls take one code of coolant in a block.
        for word in words {
            self.line(&[word]);
        }
        Ok(())
    }

    /// Where the control has no code for it, it has no other way of passing corners either.
    fn path_mode(&mut self, mode: PathMode) {
        let action = match mode {
            PathMode::ExactPath => Action::Mode(ModeCode::Path(PathCode::Exact)),
            PathMode::ExactStop => Action::Mode(ModeCode::Path(PathCode::ExactStop)),
            PathMode::Continuous { .. } => Action::Mode(ModeCode::Path(PathCode::Continuous)),
        };
        self.pending.extend(self.code(action));
    }

    fn overrides(&mut self, overrides: Overrides) -> Result<(), EmitRefusal> {
        let code = codes::overrides(overrides.feed, self.to, self.style);
        let code = code.ok_or("a code for the overrides is missing")?;
        self.pending.push(code);
        Ok(())
    }

    fn work_offset(&mut self, name: WorkName) -> Result<(), EmitRefusal> {
        let words = codes::work_offset(name, self.to, self.style);
        let words = words.ok_or("a work offset that the control does not have")?;
        self.pending.push(words);
        Ok(())
    }
}

const LINEAR_AXES: [char; 3] = ['X', 'Y', 'Z'];
const CENTERS: [char; 3] = ['I', 'J', 'K'];
