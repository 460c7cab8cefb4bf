//! Collects the moves of a run in batches of one tool and kind, and what must not touch on them.

mod turning;

use std::collections::{BTreeMap, BTreeSet};

use chordal_command::{AxisMask, CommandKind, FeedMode, Origin, SpindleState, Units, WorkNaming};
use chordal_diagnostics::{Code, Diagnostic};
use chordal_geometry::{Curve, Line, ParamCurve, Vec3};
use chordal_machine::{RotaryAxis, RotaryTarget, TcpFrame};
use chordal_path::{PathCommand, Segment, SegmentKind, depth_mm};
use chordal_stock::{TipMove, ToolTurn};

use super::passed_heights::{VisitedPlaces, is_upright};
use super::problems::{assumed_dimensions, not_cut};
use super::tools::{NoBody, ToolBody};
use super::turns::{self, PartOrientation};
use crate::job::Job;
use crate::report::RunWatch;
use turning::TurnedEnd;

/// Most orientations of the part in a run: each has columns of its own.
const MAX_TURNS: usize = 64;
/// The height above its end at which a rapid down from an unknown height is taken to begin, mm.
const ABOVE_MM: f64 = 1000.0;
/// Most moves of a run on which the part turns that are checked.
const MAX_SWINGS: usize = 100_000;

/// Why a move in another work offset is not cut.
pub(super) const FRAME_NOT_KNOWN: &str =
    "how its work offset lies to that of the first cut is not known";
/// Why a move with the length offset of another tool is not cut.
pub(super) const TIP_NOT_KNOWN: &str =
    "where its tip is is not known: the length offset in force is not that of the tool";

/// The kind of the moves of a batch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum BatchKind {
    /// At rapid speed: nothing may be cut.
    Rapid,
    /// The same with the spindle oriented: a boring bar that has moved aside in its hole.
    Aside,
    /// At feed with the spindle turning.
    Cut,
    /// At feed with the spindle stopped.
    Still,
}

impl BatchKind {
    pub fn is_rapid(self) -> bool {
        matches!(self, BatchKind::Rapid | BatchKind::Aside)
    }
}

/// Consecutive moves of one kind and tool in one orientation of the part.
#[derive(Debug)]
pub(super) struct MoveBatch {
    pub tool: u32,
    pub kind: BatchKind,
    /// The orientation of the part, as index in [`StockMoves::turns`].
    pub turn: usize,
    pub moves: Vec<TipMove>,
    /// How the direction of the tool turns on each move; empty where it is upright on all of them.
    pub tool_turns: Vec<ToolTurn>,
    /// For moves that must touch nothing, the part of each that no cut of the tool has passed before; `None` where
    /// nothing of it remains. Empty for cuts.
    pub checked: Vec<Option<TipMove>>,
    pub origins: Vec<Origin>,
    /// Feed and spindle speed of each move.
    pub rates: Vec<ProgrammedRate>,
    /// The index of each move among all path segments of the run.
    pub rows: Vec<u32>,
}

/// The programmed feed and speed of a move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ProgrammedRate {
    /// Feed along the path, mm/s; zero where none is known.
    pub feed: f64,
    /// Spindle speed, rev/min; zero where it is stopped.
    pub rpm: f64,
    /// True where its feed is an F per time of its own block: not of a thread, tapping, cycle or inverse time.
    pub by_time: bool,
}

/// What is known about a rapid whose start or end is not known.
enum PartlyKnown {
    /// It is taken to be above the part.
    Clear,
    /// It begins below the clearance plane and does not go straight up.
    AtDepth,
    /// Its end is known; this is the move down to it.
    End(Line),
}

/// Collects the moves of a run.
pub(super) struct StockMoves<'a> {
    tools: &'a BTreeMap<u32, Result<ToolBody, NoBody>>,
    rotary: [RotaryAxis; 3],
    /// True where a part is simulated in any orientation, not only in the given one.
    follows_turns: bool,
    pub batches: Vec<MoveBatch>,
    /// The orientations of the part in the run; the first is the given one.
    pub turns: Vec<PartOrientation>,
    /// Moves on which the part turns.
    pub swings: Vec<Segment>,
    /// True where moves were left out because the part is turned, or turns, on them.
    pub leaves_out_turned: bool,
    visited: VisitedPlaces,
    /// The frame of the part is one in which the control holds the tip while rotary axes turn.
    follows_tip: bool,
    /// The frame of the tip is the part as it lies where its control begins.
    is_frame_at_activation: bool,
    /// The frame of the part lies on it as with the tables at other angles than zero.
    is_frame_turned: bool,
    /// Where the last cut has ended that was not upright.
    turned_end: Option<TurnedEnd>,
    /// The tools that have cut while their direction changed.
    turning_tools: BTreeSet<u32>,
    row: u32,
    /// The work offset of the first cut, which is the frame of the run.
    pub work: Option<String>,
    work_now: Option<String>,
    naming: WorkNaming,
    has_cut: bool,
    pub units: Units,
    spindle_turns: bool,
    is_oriented: bool,
    rpm: f64,
    /// Polar or cylindrical interpolation is active.
    on_surface: bool,
    /// The current move has a feed per time.
    by_time: bool,
    /// The clearance plane: a rapid below it is at depth, mm.
    depth_mm: f64,
    /// The tool has moved in Z since it was changed.
    has_moved_in_z: bool,
    /// The height of the tip in the frame of the run; `None` where it is not known.
    height_mm: Option<f64>,
    /// True where some cuts are in no batch.
    pub misses_cuts: bool,
    /// The problems that were reported already, by tool.
    reported: Vec<(Code, u32)>,
    pub diagnostics: Vec<Diagnostic>,
    /// By tool: the number of moves at feed, and the lowest height of the tip on them, mm.
    pub counts: BTreeMap<u32, (u64, f64)>,
    pub order: Vec<u32>,
}

impl<'a> StockMoves<'a> {
    pub fn new(
        job: &'a Job<'_>,
        tools: &'a BTreeMap<u32, Result<ToolBody, NoBody>>,
        follows_turns: bool,
    ) -> StockMoves<'a> {
        let (naming, units) = (job.profile().work_names, job.rules().units);
        StockMoves {
            tools,
            rotary: job.rotary_axes(),
            follows_turns,
            batches: Vec::new(),
            turns: vec![PartOrientation::NONE],
            swings: Vec::new(),
            leaves_out_turned: false,
            visited: VisitedPlaces::default(),
            follows_tip: false,
            is_frame_at_activation: job.machine().tcp_frame == TcpFrame::Activation
                || job.rules().frames.tip_frame_stays,
            is_frame_turned: false,
            turned_end: None,
            turning_tools: BTreeSet::new(),
            row: 0,
            work: None,
            work_now: None,
            naming,
            has_cut: false,
            units,
            spindle_turns: false,
            is_oriented: false,
            rpm: 0.0,
            on_surface: false,
            by_time: false,
            depth_mm: depth_mm(job.machine()),
            has_moved_in_z: false,
            height_mm: None,
            misses_cuts: false,
            reported: Vec::new(),
            diagnostics: Vec::new(),
            counts: BTreeMap::new(),
            order: Vec::new(),
        }
    }

    /// The largest radius of a tool with its shank and holder, mm.
    pub fn radius(&self, tool: u32) -> Option<f64> {
        Some(self.tools.get(&tool)?.as_ref().ok()?.radius())
    }

    /// Whether a holder is given for the tool, and so was checked.
    pub fn has_holder(&self, tool: u32) -> bool {
        let body = self.tools.get(&tool).and_then(|body| body.as_ref().ok());
        body.is_some_and(|body| !body.holder.is_empty())
    }

    /// Number of path segments of the run so far.
    pub fn rows(&self) -> u32 {
        self.row
    }

    /// Reports a move on which the part turns and may touch the tool.
    pub fn report_swing(&mut self, segment: &Segment) {
        let why = "the part turns on it, and the tool is not clear of all that it may pass";
        self.report_once(Code::StockNotFollowed, segment, why);
    }

    /// Whether every move that may cut is in a batch.
    pub fn is_whole(&self) -> bool {
        self.reported.is_empty()
    }

    /// The index of the orientation at some angles; an error where it is not simulated.
    fn turn(&mut self, angles: [f64; 3]) -> Result<usize, String> {
        if let Some(known) = self.turns.iter().position(|turn| turn.is_at(angles)) {
            return Ok(known);
        }
        let turn = PartOrientation::of(&self.rotary, angles)?;
        if !self.follows_turns {
            self.leaves_out_turned = true;
            return Err(format!("the part is turned to {}", turn.name()));
        }
        if self.turns.len() >= MAX_TURNS {
            return Err(format!("more than {MAX_TURNS} angles of rotary axes are not followed"));
        }
        self.turns.push(turn);
        Ok(self.turns.len() - 1)
    }

    fn segment(&mut self, segment: &Segment, kind: BatchKind) {
        let reason = match self.tools.get(&segment.tool) {
            Some(Ok(_)) => None,
            Some(Err(reason)) => Some(reason.why()),
            None => Some(NoBody::Unknown.why()),
        };
        if let Some(why) = reason {
            if !kind.is_rapid() {
                self.report_once(Code::ToolWithoutShape, segment, &why);
            }
            return;
        }
        if self.on_surface {
            let why = "polar or cylindrical interpolation is active";
            return self.report_once(Code::StockNotFollowed, segment, why);
        }
        if segment.on_part {
            return self.segment_on_part(segment, kind);
        }
        self.segment_on_machine(segment, kind);
    }

    /// Takes a move in a frame of the part. While the rotary axes stand, it is turned with the part to where the tool is
    /// upright; with a head it is cut as it leans.
    fn segment_on_part(&mut self, segment: &Segment, kind: BatchKind) {
        if self.is_frame_turned {
            let why = "its coordinates are those of the part at other angles than zero";
            return self.report_once(Code::StockNotFollowed, segment, why);
        }
        let stands = turns::are_same(segment.rotary_from, segment.rotary_to);
        let is_side = || self.turns.iter().any(|turn| turn.is_at(segment.rotary_from));
        let is_on_head = self
            .rotary
            .iter()
            .zip(segment.rotary_from)
            .any(|(axis, angle)| axis.turns == Some(RotaryTarget::Head) && angle != 0.0);
        let goes_on = || self.turning_tools.contains(&segment.tool) && !is_side();
        if !stands || is_on_head || goes_on() {
            return self.segment_turning(segment, kind);
        }
        match self.turn(segment.rotary_from) {
            Ok(index) => {
                let curve = segment.curve.transformed(&self.turns[index].to_program);
                self.segment_on_machine(&Segment { curve, ..*segment }, kind);
            }
            Err(why) => self.report_once(Code::StockNotFollowed, segment, &why),
        }
    }

    fn segment_on_machine(&mut self, segment: &Segment, kind: BatchKind) {
        if segment.unrelated_zero.is_some() {
            return self.frame_not_known(segment, kind);
        }
        if !segment.known {
            if !kind.is_rapid() {
                let why = "where the tool is relative to the part is not known";
                return self.report_once(Code::StockNotFollowed, segment, why);
            }
            match self.rapid_of(segment) {
                PartlyKnown::Clear => return,
                PartlyKnown::AtDepth => {
                    let why =
                        "it leaves a place below the clearance plane for one that is not known";
                    return self.report_once(Code::StockNotFollowed, segment, why);
                }
                PartlyKnown::End(line) => {
                    let known = Segment { curve: Curve::Line(line), known: true, ..*segment };
                    return self.segment_from(&known, kind);
                }
            }
        }
        self.segment_from(segment, kind);
    }

    /// Takes a move in a work offset whose distance from that of the first cut is not known. A rapid whose height is
    /// not known in its own work offset either comes before the first approach, or is a reference return: it is taken
    /// to be above the part, unless the tool was left below the clearance plane.
    fn frame_not_known(&mut self, segment: &Segment, kind: BatchKind) {
        let is_upright = is_upright(segment.curve.start(), segment.curve.end());
        let is_left_low = self.height_mm.is_some_and(|z| z < self.depth_mm);
        if !kind.is_rapid() || segment.to_known.has(2) || is_left_low && !is_upright {
            self.report_once(Code::StockNotFollowed, segment, FRAME_NOT_KNOWN);
        }
    }

    fn follow_height(&mut self, segment: &Segment) {
        let [start, end] = [segment.curve.start().z, segment.curve.end().z];
        if segment.unrelated_zero.is_none() && segment.to_known.has(2) {
            self.height_mm = Some(end);
        } else if segment.to_known.has(2) || start != end {
            self.height_mm = None;
        }
    }

    /// Finds out what is known about a rapid whose start or end is not known.
    fn rapid_of(&self, segment: &Segment) -> PartlyKnown {
        let [start, end] = [segment.curve.start(), segment.curve.end()];
        let is_upright = is_upright(start, end);
        if segment.to_known.covers(AxisMask::LINEAR) {
            // A rapid straight down begins above the part; of any other only the end is used.
            let is_down = segment.from_known.covers(AxisMask::XY) && is_upright;
            let above = Vec3::new(end.x, end.y, end.z + if is_down { ABOVE_MM } else { 0.0 });
            return PartlyKnown::End(Line { start: above, end });
        }
        let is_retract = segment.to_known.covers(AxisMask::XY) && is_upright;
        // The height of the tip may be known even where a shift has made the coordinate unknown.
        let height_mm = if segment.from_known.has(2) { Some(start.z) } else { self.height_mm };
        let is_low = height_mm.is_some_and(|z| z < self.depth_mm);
        match is_low && !is_retract {
            true => PartlyKnown::AtDepth,
            // Nothing is known before the first position that the program names, nor after a reference return: the
            // tool is taken to be above the part.
            false => PartlyKnown::Clear,
        }
    }

    /// Takes a move between known positions.
    fn segment_from(&mut self, segment: &Segment, kind: BatchKind) {
        if !segment.tip_known {
            return self.tip_not_known(segment, kind);
        }
        let has_swung = !turns::are_same(segment.rotary_from, segment.rotary_to);
        if has_swung && self.follows_turns {
            if self.swings.len() < MAX_SWINGS {
                self.swings.push(*segment);
            } else {
                self.report_swing(segment);
            }
            return;
        }
        let turn = match self.turn(segment.rotary_from) {
            Ok(_) if has_swung => {
                self.leaves_out_turned = true;
                Err("rotary axes turn on it".to_string())
            }
            found => found,
        };
        let turn = match turn {
            Ok(turn) => turn,
            Err(why) => return self.report_once(Code::StockNotFollowed, segment, &why),
        };
        if let Some(end) = self.turned_end.take() {
            let place = self.turns[turn].to_program.apply_point(end.tip);
            let start = segment.curve.start();
            let own = TurnedEnd { tip: place, ..end };
            if own.is_start_of(segment.tool, segment.rotary_from, start) {
                // The cut has ended here, with the tool in this direction.
                let point = Curve::Line(Line { start, end: start });
                self.visited.cut(segment.tool, turn, &point);
            }
        }
        self.put(segment, kind, turn, None, false);
        self.turned_end = None;
    }

    /// Adds a move to the batches of a side. `tool_turn` is set where the tool is not upright on that; `is_free` where
    /// it is known to touch nothing.
    fn put(
        &mut self,
        segment: &Segment,
        kind: BatchKind,
        turn: usize,
        tool_turn: Option<ToolTurn>,
        is_free: bool,
    ) {
        if !kind.is_rapid() {
            let count = self.counts.entry(segment.tool).or_insert((0, f64::INFINITY));
            count.0 += 1;
            count.1 = count.1.min(segment.curve.bounds().min.z);
            if !self.order.contains(&segment.tool) {
                self.order.push(segment.tool);
                if let Some(Ok(body)) = self.tools.get(&segment.tool) {
                    self.diagnostics.extend(assumed_dimensions(
                        body,
                        &segment.origin,
                        segment.tool,
                    ));
                }
            }
        }
        let follows = |batch: &MoveBatch| {
            (batch.tool, batch.kind, batch.turn) == (segment.tool, kind, turn)
                && batch.tool_turns.is_empty() == tool_turn.is_none()
        };
        if !self.batches.last().is_some_and(follows) {
            let (moves, tool_turns, checked, origins, rates, rows) = Default::default();
            self.batches.push(MoveBatch {
                tool: segment.tool,
                kind,
                turn,
                moves,
                tool_turns,
                checked,
                origins,
                rates,
                rows,
            });
        }
        let Segment { length_mm, duration_s, origin, .. } = *segment;
        let rate = ProgrammedRate {
            feed: if duration_s > 0.0 { length_mm / duration_s } else { 0.0 },
            rpm: if self.spindle_turns { self.rpm } else { 0.0 },
            by_time: self.by_time && !origin.cycle,
        };
        let path = TipMove { curve: segment.curve, tag: segment.tool };
        let checked = match (kind, tool_turn) {
            (BatchKind::Cut, Some(_)) => None,
            (_, Some(_)) => Some(Some(path).filter(|_| !is_free)),
            (_, None) => self.checked_part(&path, kind, turn),
        };
        if let Some(batch) = self.batches.last_mut() {
            batch.moves.push(path);
            batch.tool_turns.extend(tool_turn);
            batch.checked.extend(checked);
            batch.origins.push(segment.origin);
            batch.rates.push(rate);
            batch.rows.push(self.row);
        }
    }

    /// For a move that must touch nothing, the part that must be checked (an inner `None` where there is none); an
    /// outer `None` for cuts, whose path is recorded.
    fn checked_part(
        &mut self,
        path: &TipMove,
        kind: BatchKind,
        turn: usize,
    ) -> Option<Option<TipMove>> {
        match (kind, &path.curve, self.tools.get(&path.tag)) {
            (BatchKind::Cut, ..) => {
                self.visited.cut(path.tag, turn, &path.curve);
                None
            }
            (_, Curve::Line(line), Some(Ok(body))) => {
                let rest = self.visited.rapid(path.tag, turn, body, line);
                // A boring bar that moves aside in its hole is taken to be narrow enough, since its cycle demands the
                // move.
                let steps_aside =
                    kind == BatchKind::Aside && self.visited.has(path.tag, turn, line.start);
                Some(rest.of(path).filter(|_| !steps_aside))
            }
            _ => Some(Some(*path)),
        }
    }

    /// Takes a move with the length offset of another tool. A tool change leaves the tool clear of the part, so
    /// nothing is reported until it moves in Z.
    fn tip_not_known(&mut self, segment: &Segment, kind: BatchKind) {
        let is_level = segment.curve.start().z == segment.curve.end().z;
        if kind.is_rapid() && is_level && !self.has_moved_in_z {
            return;
        }
        self.has_moved_in_z = true;
        self.report_once(Code::StockNotFollowed, segment, TIP_NOT_KNOWN);
    }

    /// Reports once per tool why its moves remove nothing.
    fn report_once(&mut self, code: Code, segment: &Segment, why: &str) {
        self.misses_cuts |= segment.kind != SegmentKind::Rapid;
        if self.reported.contains(&(code, segment.tool)) {
            return;
        }
        self.reported.push((code, segment.tool));
        self.diagnostics.push(not_cut(code, &segment.origin, segment.tool, why));
    }
}

impl RunWatch for StockMoves<'_> {
    fn path(&mut self, path: PathCommand<'_>, segments: &[Segment]) {
        let kind = &path.command.kind;
        match kind {
            CommandKind::Spindle { state, rpm } => {
                self.spindle_turns = matches!(state, SpindleState::Cw | SpindleState::Ccw);
                self.is_oriented = *state == SpindleState::Oriented;
                self.rpm = *rpm;
            }
            CommandKind::Tool { .. } => self.has_moved_in_z = false,
            CommandKind::Units(units) => self.units = *units,
            CommandKind::Surface { surface, .. } => self.on_surface = surface.is_some(),
            CommandKind::PartFrame { frame, .. } => {
                self.follows_tip = frame.as_ref().is_some_and(|frame| frame.follows_tip);
                self.is_frame_turned = self.is_frame_at_activation
                    && frame.as_ref().is_some_and(|frame| frame.frame_angles != [0.0; 3]);
            }
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
            None if self.is_oriented && path.command.origin.cycle => BatchKind::Aside,
            None => BatchKind::Rapid,
            Some(_) if self.spindle_turns => BatchKind::Cut,
            Some(_) => BatchKind::Still,
        };
        for segment in segments {
            self.segment(segment, kind);
            self.follow_height(segment);
            self.row = self.row.saturating_add(1);
        }
    }
}
