//! A run as tasks: the moves of one tool after the other, and what must not touch on them.

use std::collections::BTreeMap;

use chordal_command::{CommandKind, FeedMode, Origin, SpindleState, Units, WorkNaming};
use chordal_diagnostics::{Code, Diagnostic};
use chordal_geometry::ParamCurve;
use chordal_path::{PathCommand, Segment};
use chordal_stock::Move;

use super::tools::{NoBody, ToolBody};
use crate::report::Watch;

/// Angles of rotary axes that differ by less are the same, rad.
const SAME_ANGLE: f64 = 1e-9;

/// What moves are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// At rapid speed: nothing may be cut.
    Rapid,
    /// At feed.
    Cut,
    /// At feed with the spindle stopped.
    Still,
}

/// Moves of one kind and tool, one after the other.
#[derive(Debug)]
pub(super) struct Batch {
    pub tool: u32,
    pub kind: Kind,
    pub moves: Vec<Move>,
    pub origins: Vec<Origin>,
    /// How fast each move goes.
    pub rates: Vec<Rate>,
}

/// How fast a move is programmed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rate {
    /// Along the path, mm/s; zero where no feed is known.
    pub feed: f64,
    /// Revolutions of the spindle by minute; zero where it stands.
    pub rpm: f64,
    /// Its feed is an F by time of a block of its own: no thread, tap, cycle or time of a block.
    pub by_time: bool,
}

/// Gathers what a run moves.
pub(super) struct Gathered<'a> {
    tools: &'a BTreeMap<u32, Result<ToolBody, NoBody>>,
    pub batches: Vec<Batch>,
    /// The work offset of the first cut, which is the frame of the run.
    pub work: Option<String>,
    work_now: Option<String>,
    naming: WorkNaming,
    has_cut: bool,
    pub units: Units,
    spindle_turns: bool,
    rpm: f64,
    /// The move under way has a feed by time.
    by_time: bool,
    rotary: Option<[f64; 3]>,
    /// What was told of a tool, once.
    told: Vec<(Code, u32)>,
    pub diagnostics: Vec<Diagnostic>,
    /// Moves at feed and the lowest place of the tip, mm, by tool; and the order of the tools.
    pub counts: BTreeMap<u32, (u64, f64)>,
    pub order: Vec<u32>,
}

impl<'a> Gathered<'a> {
    pub fn new(
        tools: &'a BTreeMap<u32, Result<ToolBody, NoBody>>,
        naming: WorkNaming,
        units: Units,
    ) -> Gathered<'a> {
        Gathered {
            tools,
            batches: Vec::new(),
            work: None,
            work_now: None,
            naming,
            has_cut: false,
            units,
            spindle_turns: false,
            rpm: 0.0,
            by_time: false,
            rotary: None,
            told: Vec::new(),
            diagnostics: Vec::new(),
            counts: BTreeMap::new(),
            order: Vec::new(),
        }
    }

    /// Whether every move that may cut is in a batch.
    pub fn is_whole(&self) -> bool {
        self.told.is_empty()
    }

    fn segment(&mut self, segment: &Segment, kind: Kind) {
        let reason = match self.tools.get(&segment.tool) {
            Some(Ok(_)) => None,
            Some(Err(reason)) => Some(reason.why()),
            None => Some(NoBody::Unknown.why()),
        };
        if let Some(why) = reason {
            if kind != Kind::Rapid {
                self.tell(Code::ToolWithoutShape, segment, &why);
            }
            return;
        }
        let angles = *self.rotary.get_or_insert(segment.rotary_from);
        let same = |a: &[f64; 3]| a.iter().zip(&angles).all(|(a, b)| (a - b).abs() < SAME_ANGLE);
        if !same(&segment.rotary_from) || !same(&segment.rotary_to) {
            let why = "rotary axes turn, and turned parts are not cut yet";
            return self.tell(Code::StockNotFollowed, segment, why);
        }
        if !segment.known {
            // Before the first place that the program names nothing is known: the tool is far away.
            if kind != Kind::Rapid {
                let why = "where the tool is relative to the part is not known";
                self.tell(Code::StockNotFollowed, segment, why);
            }
            return;
        }
        if kind != Kind::Rapid {
            let count = self.counts.entry(segment.tool).or_insert((0, f64::INFINITY));
            count.0 += 1;
            count.1 = count.1.min(segment.curve.bounds().min.z);
            if !self.order.contains(&segment.tool) {
                self.order.push(segment.tool);
            }
        }
        let follows = |batch: &Batch| batch.tool == segment.tool && batch.kind == kind;
        if !self.batches.last().is_some_and(follows) {
            let (moves, origins, rates) = (Vec::new(), Vec::new(), Vec::new());
            self.batches.push(Batch { tool: segment.tool, kind, moves, origins, rates });
        }
        let Segment { length_mm, duration_s, origin, .. } = *segment;
        let rate = Rate {
            feed: if duration_s > 0.0 { length_mm / duration_s } else { 0.0 },
            rpm: if self.spindle_turns { self.rpm } else { 0.0 },
            by_time: self.by_time && !origin.cycle,
        };
        if let Some(batch) = self.batches.last_mut() {
            batch.moves.push(Move { curve: segment.curve, tag: segment.tool });
            batch.origins.push(segment.origin);
            batch.rates.push(rate);
        }
    }

    /// Says once of a tool why its moves remove nothing.
    fn tell(&mut self, code: Code, segment: &Segment, why: &str) {
        if self.told.contains(&(code, segment.tool)) {
            return;
        }
        self.told.push((code, segment.tool));
        let tool = segment.tool;
        let (message, help) = if code == Code::ToolWithoutShape {
            (
                format!("what tool {tool} removes is not known: {why}"),
                "give its shape with all dimensions in the setup or machine file",
            )
        } else {
            (
                format!("this move of tool {tool} is not cut from the stock: {why}"),
                "nothing after it is proved",
            )
        };
        let diagnostic = Diagnostic::new(code, segment.origin.span, message);
        self.diagnostics.push(diagnostic.help(help));
    }
}

impl Watch for Gathered<'_> {
    fn path(&mut self, path: PathCommand<'_>, segments: &[Segment]) {
        let kind = &path.command.kind;
        match kind {
            CommandKind::Spindle { state, rpm } => {
                self.spindle_turns = matches!(state, SpindleState::Cw | SpindleState::Ccw);
                self.rpm = *rpm;
            }
            CommandKind::Units(units) => self.units = *units,
            CommandKind::WorkOffset { name, .. } => {
                self.work_now = Some(name.table_key(self.naming));
            }
            _ if !self.has_cut && kind.feed().is_some() => {
                self.has_cut = true;
                self.work = self.work_now.clone();
            }
            _ => {}
        }
        self.by_time =
            kind.feed().is_some_and(|feed| feed.mode == FeedMode::PerTime) && !kind.only_turns();
        let kind = match kind.feed() {
            None => Kind::Rapid,
            Some(_) if self.spindle_turns => Kind::Cut,
            Some(_) => Kind::Still,
        };
        for segment in segments {
            self.segment(segment, kind);
        }
    }
}
