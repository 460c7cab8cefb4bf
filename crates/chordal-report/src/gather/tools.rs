//! Tools, what they do, and the offsets that they need.

use std::collections::BTreeMap;

use chordal::control::{
    Command, CommandKind, CompensationSide, Coolant, Feed, FeedMode, Origin, SpindleState,
};
use chordal::geometry::tolerance::COINCIDENT_MM;
use chordal::machine::{Axis, ToolShape};
use chordal::time::TimeReport;
use chordal::tool_comments::known_tools;
use chordal::{Job, Summary};

use super::text::{CommentFinder, clean};
use crate::data::{CappedRows, FeedRange, Register, ReportedTool};

/// Tools and offsets that are reported; a magazine holds fewer.
const MAX_TOOLS: usize = 200;
/// Numbers of offsets listed with a tool, and of tools listed with an offset.
const MAX_NUMBERS: usize = 12;
/// What one tool does.
#[derive(Debug, Default)]
struct ToolRecord {
    number: u32,
    call: Option<Origin>,
    changes: u64,
    lengths: Vec<u32>,
    radii: Vec<u32>,
    rpm: Option<(f64, f64)>,
    clockwise: bool,
    counterclockwise: bool,
    feeds: FeedRange,
    lowest_z: Option<f64>,
    coolant: Coolant,
}

#[derive(Debug, Default)]
struct RegisterUse {
    tools: Vec<u32>,
    length: bool,
    length_mm: Option<f64>,
    radius: bool,
    radius_mm: Option<f64>,
}

/// Watches tools go by.
#[derive(Debug)]
pub struct ToolWatcher {
    seen: Vec<ToolRecord>,
    /// The tool in the spindle, where it is one of those that are kept.
    at: Option<usize>,
    number: u32,
    /// The same where the path of the tool centre has come to.
    path_at: Option<usize>,
    registers: BTreeMap<u32, RegisterUse>,
    registers_left_out: u64,
    spindle: (SpindleState, f64),
    coolant: Coolant,
    length: Option<u32>,
    radius: Option<u32>,
    /// Something of these changed since the last cut.
    fresh: bool,
}

impl ToolWatcher {
    pub fn new() -> ToolWatcher {
        ToolWatcher {
            seen: vec![ToolRecord::default()],
            at: Some(0),
            number: 0,
            path_at: Some(0),
            registers: BTreeMap::new(),
            registers_left_out: 0,
            spindle: (SpindleState::Off, 0.0),
            coolant: Coolant::default(),
            length: None,
            radius: None,
            fresh: true,
        }
    }

    /// The number of the tool in the spindle.
    pub fn number(&self) -> u32 {
        self.number
    }

    /// Follows a command as programmed.
    pub fn programmed(&mut self, command: &Command) {
        match &command.kind {
            CommandKind::Tool { number } | CommandKind::ToolNumber { number } => {
                self.change(*number, &command.origin);
            }
            CommandKind::Spindle { state, rpm } => self.spindle = (*state, *rpm),
            CommandKind::Coolant(coolant) => self.coolant = *coolant,
            CommandKind::ToolLength { number, length_mm, .. } => {
                self.length = *number;
                if let Some(entry) = number.and_then(|number| self.register(number)) {
                    entry.length = true;
                    entry.length_mm = *length_mm;
                }
            }
            CommandKind::Compensation { side, number, radius_mm, .. } => {
                self.radius = number.filter(|_| *side != CompensationSide::Off);
                if let Some(entry) = self.radius.and_then(|number| self.register(number)) {
                    entry.radius = true;
                    entry.radius_mm = *radius_mm;
                }
            }
            kind => {
                if let Some(feed) = kind.feed() {
                    self.cut(feed, command.kind.only_turns());
                }
                return;
            }
        }
        self.fresh = true;
    }

    fn change(&mut self, number: u32, origin: &Origin) {
        self.number = number;
        self.at = self.place(number);
        if let Some(tool) = self.at.and_then(|at| self.seen.get_mut(at)) {
            tool.call.get_or_insert(*origin);
            tool.changes += 1;
        }
    }

    /// The entry of a tool, made where there is room.
    fn place(&mut self, number: u32) -> Option<usize> {
        let found = self.seen.iter().rposition(|tool| tool.number == number);
        if found.is_none() && self.seen.len() <= MAX_TOOLS {
            self.seen.push(ToolRecord { number, ..ToolRecord::default() });
            return Some(self.seen.len() - 1);
        }
        found
    }

    fn register(&mut self, number: u32) -> Option<&mut RegisterUse> {
        if number == 0 {
            return None;
        }
        if self.registers.len() >= MAX_TOOLS && !self.registers.contains_key(&number) {
            self.registers_left_out += 1;
            return None;
        }
        let tool = self.number;
        let entry = self.registers.entry(number).or_default();
        note(&mut entry.tools, tool);
        Some(entry)
    }

    /// `turns`: rotary axes alone, so that the feed is no length per time.
    fn cut(&mut self, feed: &Feed, turns: bool) {
        let Some(tool) = self.at.and_then(|at| self.seen.get_mut(at)) else { return };
        if std::mem::take(&mut self.fresh) {
            if let Some(number) = self.length {
                note(&mut tool.lengths, number);
            }
            if let Some(number) = self.radius {
                note(&mut tool.radii, number);
            }
            let (state, rpm) = self.spindle;
            tool.clockwise |= state == SpindleState::Cw;
            tool.counterclockwise |= state == SpindleState::Ccw;
            if matches!(state, SpindleState::Cw | SpindleState::Ccw) {
                widen(&mut tool.rpm, rpm);
            }
            tool.coolant.flood |= self.coolant.flood;
            tool.coolant.mist |= self.coolant.mist;
            tool.coolant.through_tool |= self.coolant.through_tool;
        }
        // There is no feed before the first F.
        if feed.value.is_nan() || feed.value <= 0.0 {
            return;
        }
        match feed.mode {
            FeedMode::PerTime if turns => {}
            FeedMode::PerTime => widen(&mut tool.feeds.mm_per_min, 60.0 * feed.value),
            FeedMode::PerRevolution => widen(&mut tool.feeds.mm_per_rev, feed.value),
            FeedMode::InverseTime => tool.feeds.inverse_time = true,
        }
    }

    /// Follows a command of the tool centre; `lowest_z` is that of its cut, program coordinates.
    pub fn path(&mut self, command: &Command, lowest_z: Option<f64>) {
        if let CommandKind::Tool { number } | CommandKind::ToolNumber { number } = command.kind {
            self.path_at = self.seen.iter().rposition(|tool| tool.number == number);
        }
        let tool = self.path_at.and_then(|at| self.seen.get_mut(at));
        if let (Some(tool), Some(z)) = (tool, lowest_z) {
            tool.lowest_z = Some(tool.lowest_z.map_or(z, |lowest| lowest.min(z)));
        }
    }

    /// The tools with what else is known of them.
    pub fn tools(
        &self,
        job: &Job,
        comments: &CommentFinder,
        summary: &Summary,
        time: Option<&TimeReport>,
    ) -> CappedRows<ReportedTool> {
        let known = known_tools(job);
        let of_tool = |seen: &ToolRecord| {
            let uses = summary.tools.iter().find(|tool| tool.number == seen.number);
            let cut_mm = uses.map_or(0.0, |tool| tool.feed_length_mm);
            // Nothing in the spindle, and nothing cut with it: the way to the first tool.
            if seen.number == 0 && cut_mm == 0.0 {
                return None;
            }
            let time = time.and_then(|time| time.tools.iter().find(|t| t.number == seen.number));
            let known = known.get(&seen.number);
            let table = job.machine().tools.get(&seen.number);
            let words = table.and_then(|tool| tool.label());
            let coolant = seen.coolant;
            let valves = [
                (coolant.flood, "flood"),
                (coolant.mist, "mist"),
                (coolant.through_tool, "through tool"),
            ];
            Some(ReportedTool {
                number: seen.number,
                comment: seen.call.and_then(|call| comments.of_tool(seen.number, &call)),
                table: words.map(|words| clean(words, 80)),
                line: seen.call.map(|call| call.line),
                changes: seen.changes,
                length_offsets: seen.lengths.clone(),
                radius_offsets: seen.radii.clone(),
                diameter_mm: known.and_then(|known| known.tool.diameter_mm),
                nose_radius_mm: known.and_then(|known| known.tool.nose_radius_mm),
                tip: known.and_then(|known| known.tool.tip),
                shape: known.and_then(|known| known.tool.shape).map(ToolShape::as_str),
                by_comment: known.is_some_and(|known| known.comment.is_some()),
                rpm: seen.rpm,
                clockwise: seen.clockwise,
                counterclockwise: seen.counterclockwise,
                feeds: seen.feeds,
                lowest_z_mm: seen.lowest_z,
                cut_mm,
                coolant: valves.into_iter().filter(|valve| valve.0).map(|valve| valve.1).collect(),
                time_s: time.map(|time| time.times.total_s()),
            })
        };
        let rows: Vec<ReportedTool> = self.seen.iter().filter_map(of_tool).collect();
        let kept = |number: u32| self.seen.iter().any(|seen| seen.number == number);
        let left_out = summary.tools.iter().filter(|tool| !kept(tool.number)).count() as u64;
        CappedRows { rows, left_out }
    }

    /// The tool offsets that the program uses, with the machine's values.
    pub fn registers(&self, job: &Job) -> CappedRows<Register> {
        let of_register = |(number, uses): (&u32, &RegisterUse)| {
            let machine = job.machine();
            let table = machine.tools.get(number);
            let of_axis = |axis: Axis| table.and_then(|tool| tool.offset_of(axis as usize));
            let length_mm = of_axis(Axis::Z);
            let x_mm = of_axis(Axis::X).map(|mm| mm * machine.written_factor(Axis::X as usize));
            let radius_mm = table.and_then(chordal::machine::Tool::radius_mm);
            // Of an insert it is the nose.
            let has_nose = table.is_some_and(|tool| tool.diameter_mm.is_none());
            let other = |used: Option<f64>, own: Option<f64>| match (used, own) {
                (Some(used), Some(own)) => (used.abs() - own.abs()).abs() > COINCIDENT_MM,
                (used, _) => used.is_some(),
            };
            Register {
                number: *number,
                tools: uses.tools.iter().copied().filter(|tool| *tool > 0).collect(),
                uses_length: uses.length,
                length_mm,
                x_mm: x_mm.filter(|_| machine.turns()),
                uses_radius: uses.radius,
                diameter_mm: radius_mm.filter(|_| !has_nose).map(|radius| 2.0 * radius),
                nose_radius_mm: radius_mm.filter(|_| has_nose),
                tip: table.and_then(|tool| tool.tip),
                by_program: uses.length && other(uses.length_mm, length_mm)
                    || uses.radius && other(uses.radius_mm, radius_mm),
            }
        };
        let rows = self.registers.iter().map(of_register).collect();
        CappedRows { rows, left_out: self.registers_left_out }
    }
}

fn note(numbers: &mut Vec<u32>, number: u32) {
    if numbers.len() < MAX_NUMBERS && !numbers.contains(&number) {
        numbers.push(number);
    }
}

fn widen(range: &mut Option<(f64, f64)>, value: f64) {
    let (low, high) = range.unwrap_or((value, value));
    *range = Some((low.min(value), high.max(value)));
}
