//! The summary of a run: counts, lengths, travel, tools, times.

use chordal_command::{AxisMask, Command, CommandKind, FeedMode, Move, SurfaceRun, Units};
use chordal_kernel::rules::Rules;
use chordal_machine::{AXES, AXIS_LETTERS, Axis, Machine, PerAxis};
use std::collections::BTreeMap;

use chordal_diagnostics::FileId;
use chordal_geometry::{Aabb, ParamCurve};
use chordal_path::{Segment, SegmentKind, UnrelatedZero, places_on_axes};

/// What one tool does in a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ToolUse {
    /// Its number; 0 before any tool was changed.
    pub number: u32,
    /// Ranges of lines of the main program in which it is in the spindle, in order.
    pub lines: Vec<(u32, u32)>,
    /// Length of its cuts, mm.
    pub feed_length_mm: f64,
    /// Time of its cuts, s.
    pub feed_time_s: f64,
    /// Time of its rapids, s.
    pub rapid_time_s: f64,
    /// Smallest and largest feed per time, mm/s; `None` where it has none.
    pub feeds_mm_per_s: Option<(f64, f64)>,
    /// Spindle speeds, rpm.
    pub speeds_rpm: Vec<f64>,
}

/// Where an axis goes, in the frame of the run. Positions are diameters where the axis is programmed in diameters;
/// distances are those of the slide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisTravel {
    /// Letter of the axis.
    pub letter: char,
    /// Lowest and highest position, mm or rad.
    pub range: (f64, f64),
    /// Lowest and highest position while cutting, mm or rad; `None` where nothing is cut.
    pub cut_range: Option<(f64, f64)>,
    /// The distances of all moves added up, mm or rad.
    pub distance: f64,
}

/// The sums of a run. Times are distance over feed, and over rapid speed for rapids: without acceleration, so the
/// machine will be slower.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Summary {
    /// True where the last block is in inch: the units in which people are shown the numbers.
    pub inch: bool,
    /// Straight cuts.
    pub lines: u64,
    /// Flat arcs.
    pub arcs: u64,
    /// Arcs that move along their axis too.
    pub helices: u64,
    /// Spirals and cones.
    pub spirals: u64,
    /// Splines.
    pub splines: u64,
    /// Rapids.
    pub rapids: u64,
    /// Dwells.
    pub dwells: u64,
    /// Length of all cuts, mm.
    pub feed_length_mm: f64,
    /// Length of all rapids, mm.
    pub rapid_length_mm: f64,
    /// Time of all cuts, s.
    pub feed_time_s: f64,
    /// Time of all rapids, s.
    pub rapid_time_s: f64,
    /// Time of all dwells, s.
    pub dwell_time_s: f64,
    /// Cuts whose time is not known, because they have no feed.
    pub cuts_without_time: u64,
    /// Tools in the order of their first use.
    pub tools: Vec<ToolUse>,
    /// The axes that move.
    pub axes: Vec<AxisTravel>,
    /// Zeros whose relation to the frame of the run is not known: the ranges of the axes leave their moves out.
    pub unrelated_zeros: Vec<UnrelatedZero>,
}

impl Summary {
    /// Time of all cuts, rapids and dwells whose time is known, s.
    pub fn total_time_s(&self) -> f64 {
        self.feed_time_s + self.rapid_time_s + self.dwell_time_s
    }
}

#[derive(Clone, Copy, Debug)]
struct PathExtent {
    low: f64,
    high: f64,
    cut_low: f64,
    cut_high: f64,
    distance: f64,
}

/// Adds up the summary from the commands of a run.
pub(crate) struct SummaryBuilder {
    summary: Summary,
    tools: BTreeMap<u32, ToolUse>,
    order: Vec<u32>,
    tool: u32,
    axes: PerAxis<PathExtent>,
    /// The face or cylinder on which two coordinates are programmed, while there is one.
    surface: Option<SurfaceRun>,
    written: PerAxis<f64>,
    /// The axes that the machine does not have.
    lacking: AxisMask,
}

impl SummaryBuilder {
    pub fn new(rules: &Rules, machine: &Machine) -> SummaryBuilder {
        let empty = PathExtent {
            low: f64::INFINITY,
            high: f64::NEG_INFINITY,
            cut_low: f64::INFINITY,
            cut_high: f64::NEG_INFINITY,
            distance: 0.0,
        };
        let inch = rules.units == Units::Inch;
        SummaryBuilder {
            summary: Summary { inch, ..Summary::default() },
            tools: BTreeMap::new(),
            order: Vec::new(),
            tool: 0,
            axes: [empty; AXES],
            surface: None,
            written: machine.written_factors(),
            lacking: lacking_axes(machine),
        }
    }

    pub fn command(&mut self, command: &Command, segments: &[Segment]) {
        let line = self.main_line(command);
        match &command.kind {
            CommandKind::Units(units) => self.summary.inch = *units == Units::Inch,
            CommandKind::Tool { number } | CommandKind::ToolNumber { number } => {
                self.tool = *number;
            }
            CommandKind::Dwell { seconds, .. } => {
                self.summary.dwells += 1;
                self.summary.dwell_time_s += seconds;
            }
            CommandKind::Spindle { rpm, .. } if *rpm > 0.0 => {
                let tool = self.tool_use(line);
                if !tool.speeds_rpm.contains(rpm) {
                    tool.speeds_rpm.push(*rpm);
                }
            }
            CommandKind::Surface { surface, .. } => self.surface = surface.map(SurfaceRun::new),
            CommandKind::End => self.surface = None,
            CommandKind::Rapid { .. } => self.summary.rapids += 1,
            CommandKind::Line { .. } => self.summary.lines += 1,
            CommandKind::Arc { motion, shape, .. } => {
                let (_, _, normal) = shape.plane.axes();
                if motion.from[normal] == motion.to[normal] {
                    self.summary.arcs += 1;
                } else {
                    self.summary.helices += 1;
                }
            }
            CommandKind::Spiral { .. } => self.summary.spirals += 1,
            CommandKind::Spline { .. } => self.summary.splines += 1,
            _ => {}
        }
        if !segments.is_empty() {
            self.segments(command, segments);
        }
    }

    fn segments(&mut self, command: &Command, segments: &[Segment]) {
        let line = self.main_line(command);
        let per_time = command
            .kind
            .feed()
            .filter(|feed| feed.mode == FeedMode::PerTime && !command.kind.only_turns());
        let speed = per_time.map(|feed| feed.value).filter(|value| *value > 0.0);
        for (index, segment) in segments.iter().enumerate() {
            match (self.surface, command.kind.motion()) {
                // The whole move, of which a rapid has several pieces.
                (Some(run), Some(motion)) if index == 0 => {
                    self.extend_on_axes(run, motion, &command.kind);
                }
                (Some(_), Some(_)) => {}
                _ => self.extend(segment),
            }
            if segment.kind == SegmentKind::Rapid {
                if segment.known {
                    self.summary.rapid_length_mm += segment.length_mm;
                }
                self.summary.rapid_time_s += segment.duration_s;
                self.tool_use(line).rapid_time_s += segment.duration_s;
                continue;
            }
            self.summary.feed_length_mm += segment.length_mm;
            self.summary.feed_time_s += segment.duration_s;
            if segment.duration_s == 0.0 && segment.length_mm > 0.0 {
                self.summary.cuts_without_time += 1;
            }
            let tool = self.tool_use(line);
            tool.feed_length_mm += segment.length_mm;
            tool.feed_time_s += segment.duration_s;
            if let Some(speed) = speed {
                let (low, high) = tool.feeds_mm_per_s.unwrap_or((speed, speed));
                tool.feeds_mm_per_s = Some((low.min(speed), high.max(speed)));
            }
        }
    }

    /// The line of the command in the first text; `None` in a subprogram of another file, whose line numbers would be
    /// confused with those of the first.
    fn main_line(&self, command: &Command) -> Option<u32> {
        let origin = command.origin;
        (origin.span.file == FileId(0)).then_some(origin.line)
    }

    fn tool_use(&mut self, line: Option<u32>) -> &mut ToolUse {
        let number = self.tool;
        let changed = self.order.last() != Some(&number);
        if changed {
            self.order.push(number);
        }
        let tool =
            self.tools.entry(number).or_insert_with(|| ToolUse { number, ..ToolUse::default() });
        let Some(line) = line else { return tool };
        match tool.lines.last_mut() {
            // A subprogram may come before its caller in the text: the range holds both.
            Some((first, last)) if !changed => {
                *first = (*first).min(line);
                *last = (*last).max(line);
            }
            _ => tool.lines.push((line, line)),
        }
        tool
    }

    fn extend(&mut self, segment: &Segment) {
        let cuts = segment.kind != SegmentKind::Rapid;
        if let Some(zero) = segment.unrelated_zero
            && !self.summary.unrelated_zeros.contains(&zero)
        {
            self.summary.unrelated_zeros.push(zero);
        }
        let [from, to] = segment.places();
        let known = from.and(to);
        if known != AxisMask::NONE {
            let bounds: Aabb = segment.curve.bounds();
            let (start, end) = (segment.curve.start(), segment.curve.end());
            let (min, max) = (bounds.min.to_array(), bounds.max.to_array());
            let (start, end) = (start.to_array(), end.to_array());
            for axis in (0..3).filter(|axis| known.has(*axis)) {
                self.axes[axis].take(min[axis], max[axis], cuts);
                let path = match segment.kind {
                    SegmentKind::Rapid | SegmentKind::Line => (end[axis] - start[axis]).abs(),
                    _ => (max[axis] - min[axis]).abs(),
                };
                self.axes[axis].distance += path;
            }
        }
        for axis in 0..3 {
            let (from, to) = (segment.rotary_from[axis], segment.rotary_to[axis]);
            if from != to {
                self.axes[axis + 3].take(from.min(to), from.max(to), cuts);
                self.axes[axis + 3].distance += (to - from).abs();
            }
        }
    }

    /// A move on a surface, by the axes themselves.
    fn extend_on_axes(&mut self, mut run: SurfaceRun, motion: &Move, kind: &CommandKind) {
        let start = run.on_axes(&motion.from);
        run.follow(motion, kind.shape());
        self.surface = Some(run);
        let (places, known) = places_on_axes(&run, motion, kind.shape());
        let end = run.on_axes(&motion.to);
        let cuts = kind.feed().is_some();
        for axis in (0..AXES).filter(|axis| known.has(*axis)) {
            let path = (end[axis] - start[axis]).abs();
            // A rotary axis is listed when it turns, even if it comes back to where it began.
            let stands = |place: &chordal_command::Position| place[axis] == start[axis];
            if axis >= 3 && places.iter().all(stands) {
                continue;
            }
            for place in places.iter().chain([&start]) {
                self.axes[axis].take(place[axis], place[axis], cuts);
            }
            self.axes[axis].distance += path;
        }
    }

    pub fn finish(self) -> Summary {
        let mut summary = self.summary;
        let mut tools = self.tools;
        for number in self.order {
            summary.tools.extend(tools.remove(&number));
        }
        for (axis, letter) in AXIS_LETTERS.chars().enumerate() {
            let extent = self.axes[axis];
            // An axis that the machine does not have is always at zero.
            let is_there = !self.lacking.has(axis) || extent.low < extent.high;
            if is_there && extent.low <= extent.high {
                let factor = self.written[axis];
                let cut = (extent.cut_low * factor, extent.cut_high * factor);
                summary.axes.push(AxisTravel {
                    letter,
                    range: (extent.low * factor, extent.high * factor),
                    cut_range: (cut.0 <= cut.1).then_some(cut),
                    distance: extent.distance,
                });
            }
        }
        summary
    }
}

fn lacking_axes(machine: &Machine) -> AxisMask {
    let mut axes = AxisMask::NONE;
    let lacking = Axis::ALL.into_iter().filter(|axis| machine.lacks(*axis));
    lacking.for_each(|axis| axes.insert(axis as usize));
    axes
}

impl PathExtent {
    fn take(&mut self, low: f64, high: f64, cuts: bool) {
        self.low = self.low.min(low);
        self.high = self.high.max(high);
        if cuts {
            self.cut_low = self.cut_low.min(low);
            self.cut_high = self.cut_high.max(high);
        }
    }
}
