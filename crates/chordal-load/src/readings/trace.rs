//! Records the motions of a text on one control, block by block, so that controls can be compared.

use std::f64::consts::{FRAC_PI_2, TAU};

use chordal::RunOptions;
use chordal::control::{ArcShape, AxisMask, CallPath, FeedMode, Move, Position};
use chordal::diagnostics::FileId;
use chordal::{
    Code, Command, Diagnostic, Job, Machine, RunSink, Severity, Sink, Source, SourceMap,
};

use super::excerpt::TrialExcerpt;

/// The limit on repeated blocks in each of these runs.
const REPEATED_BLOCKS_LIMIT: u64 = 2_000;

/// The motion of one block.
#[derive(Clone, Debug)]
pub struct BlockMotion {
    /// The location of the block: its file, and the offsets of its first byte and its end.
    pub file: FileId,
    pub range: (u32, u32),
    call: CallPath,
    /// At least one of its moves has a feed.
    pub cuts: bool,
    /// Its end position, mm and rad; `known` has the axes whose position relative to the part is known.
    pub end: Position,
    pub known: AxisMask,
    /// The bounding box of its cuts, mm; empty (`low` above `high`) without a cut.
    pub low: [f64; 3],
    pub high: [f64; 3],
    /// Its feed, mm/s or mm per revolution depending on the feed mode; `None` when it has none.
    pub feed: Option<f64>,
}

impl BlockMotion {
    /// A block without motion at no location.
    pub fn nowhere() -> BlockMotion {
        BlockMotion {
            file: FileId(0),
            range: (0, 0),
            call: CallPath::default(),
            cuts: false,
            end: Position::default(),
            known: AxisMask::NONE,
            low: EMPTY_BOX.0,
            high: EMPTY_BOX.1,
            feed: None,
        }
    }
}

/// The motions of a text on one control.
#[derive(Clone, Debug, Default)]
pub struct MotionTrace {
    pub blocks: Vec<BlockMotion>,
    /// The number of errors that are evidence against the control; missing files do not count.
    pub errors: u64,
    /// The offset from which on parts of the text are left out. Arcs after it may have a wrong start point, so errors
    /// about their radius do not count.
    gaps_from: u32,
    /// How many numbers the control reads in least increments although they may be meant in whole units.
    pub least_increment_numbers: u64,
    /// The largest cutting feeds, mm/s and mm per revolution; zero without any.
    pub largest_feed_mm_per_s: f64,
    pub largest_feed_mm_per_rev: f64,
}

impl MotionTrace {
    /// Runs the excerpt of a text on a machine.
    pub fn of(machine: Machine, excerpt: &TrialExcerpt) -> MotionTrace {
        let gaps_from = excerpt.beginning_bytes() as u32;
        let mut trace = MotionTrace { gaps_from, ..MotionTrace::default() };
        let mut sources = SourceMap::new();
        sources.add(Source::new("", &excerpt.text[..]));
        let options = RunOptions {
            max_repeated_blocks: REPEATED_BLOCKS_LIMIT,
            assumed_machine: true,
            ..RunOptions::default()
        };
        match Job::new(sources, machine) {
            Ok(job) => drop(job.options(options).run(&mut trace)),
            Err(_) => trace.errors = u64::MAX,
        }
        trace
    }

    /// The bounding box of all cuts, mm: the lowest and the highest X, Y and Z; `None` without a cut.
    pub fn cut_box(&self) -> Option<([f64; 3], [f64; 3])> {
        let cuts = self.blocks.iter().filter(|block| block.cuts);
        let (low, high) = cuts.fold(EMPTY_BOX, |(mut low, mut high), block| {
            for axis in 0..3 {
                low[axis] = low[axis].min(block.low[axis]);
                high[axis] = high[axis].max(block.high[axis]);
            }
            (low, high)
        });
        (0..3).any(|axis| low[axis] <= high[axis]).then_some((low, high))
    }

    fn motion(&mut self, command: &Command, motion: &Move) {
        let origin = &command.origin;
        let shape = command.kind.shape();
        let cuts = command.kind.feed().is_some();
        let known = motion.to_known;
        if known == AxisMask::NONE || (shape.is_none() && motion.from == motion.to) {
            return;
        }
        let range = (origin.span.range.start, origin.span.range.end);
        let open = self.blocks.last().is_some_and(|last| {
            last.range == range && last.call == origin.call && last.file == origin.span.file
        });
        if !open {
            self.blocks.push(BlockMotion {
                file: origin.span.file,
                range,
                call: origin.call,
                ..BlockMotion::nowhere()
            });
        }
        let Some(block) = self.blocks.last_mut() else { return };
        (block.end, block.known) = (motion.to, known);
        if !cuts {
            return;
        }
        block.cuts = true;
        let mut reach = |place: &Position, known: AxisMask| {
            for axis in (0..3).filter(|axis| known.has(*axis)) {
                block.low[axis] = block.low[axis].min(place[axis]);
                block.high[axis] = block.high[axis].max(place[axis]);
            }
        };
        reach(&motion.from, motion.from_known);
        reach(&motion.to, known);
        if let Some(shape) = shape {
            extremes(shape, motion, |place| reach(place, known));
        }
        if let Some(feed) = command.kind.feed().filter(|feed| feed.value.is_finite()) {
            block.feed = Some(feed.value);
            match feed.mode {
                FeedMode::PerTime => {
                    self.largest_feed_mm_per_s = self.largest_feed_mm_per_s.max(feed.value);
                }
                FeedMode::PerRevolution if feed.lead_change == 0.0 => {
                    self.largest_feed_mm_per_rev = self.largest_feed_mm_per_rev.max(feed.value);
                }
                FeedMode::PerRevolution | FeedMode::InverseTime => {}
            }
        }
    }
}

const EMPTY_BOX: ([f64; 3], [f64; 3]) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);

/// Calls `reach` with the extreme points of an arc along the axes of its plane.
fn extremes(shape: &ArcShape, motion: &Move, mut reach: impl FnMut(&Position)) {
    let (a, b, _) = shape.plane.axes();
    let start = (motion.from[b] - shape.center[1]).atan2(motion.from[a] - shape.center[0]);
    let end = start + shape.sweep;
    let (first, last) = (start.min(end), start.max(end));
    let quarters = ((last - first).min(TAU) / FRAC_PI_2) as i64 + 1;
    let from = (first / FRAC_PI_2).ceil() as i64;
    for quarter in from..=from + quarters {
        let angle = quarter as f64 * FRAC_PI_2;
        if angle > last {
            break;
        }
        let along = if shape.sweep == 0.0 { 0.0 } else { (angle - start) / shape.sweep };
        let radius = shape.radius_from + along * (shape.radius_to - shape.radius_from);
        let mut place = motion.to;
        place[a] = shape.center[0] + radius * angle.cos();
        place[b] = shape.center[1] + radius * angle.sin();
        reach(&place);
    }
}

impl Sink for MotionTrace {
    fn command(&mut self, command: &Command) {
        if let Some(motion) = command.kind.motion() {
            self.motion(command, motion);
        }
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic) {
        match diagnostic.code {
            Code::MissingSubprogram | Code::BudgetReached => {}
            Code::RadiusMismatch | Code::RadiusTooShort | Code::FullCircleByRadius
                if diagnostic.primary.span.range.start >= self.gaps_from => {}
            Code::MissingDecimalPoint => self.least_increment_numbers += 1,
            _ => self.errors += u64::from(diagnostic.severity == Severity::Error),
        }
    }
}

impl RunSink for MotionTrace {}
