//! Collects the moves of a lathe run in the half plane.

use std::collections::BTreeMap;

use chordal_command::{
    Command, CommandKind, CompensationSide, Feed, FeedMode, Origin, SpindleState, Units, WorkNaming,
};
use chordal_diagnostics::{Code, Diagnostic};
use chordal_geometry::{Curve, Vec2};
use chordal_path::{PathCommand, Segment as PathSegment};
use chordal_stock::lathe::OutlineSegment;

use super::super::gather::{FRAME_NOT_KNOWN, TIP_NOT_KNOWN};
use super::super::problems::{assumed_point_angle, not_cut};
use super::report::SegmentOrigin;
use super::tools::{LatheTool, NoOutline, TurningToolKind};
use crate::report::RunWatch;

/// Angles (rad) and positions (mm) that differ by less than this are equal.
const EQUAL_POSITION: f64 = 1e-9;
/// A drill farther from the axis than this is not on it, mm.
const ON_AXIS: f64 = 1e-4;

/// The kind of a move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum TurnedMoveKind {
    /// At rapid speed: nothing may be cut.
    Rapid,
    /// At feed with the spindle turning.
    Cut,
    /// At feed with the spindle stopped.
    Still,
    /// A thread: what it removes is not the same all round.
    Thread,
}

/// A move in the half plane.
#[derive(Clone, Copy, Debug)]
pub(super) struct TurnMove {
    /// The path of the programmed point.
    pub path: OutlineSegment,
    pub kind: TurnedMoveKind,
    pub tool: u32,
    /// The index of its path segment among all of the run.
    pub row: u32,
    pub origin: Origin,
    /// Feed along the path, mm/s; zero where none is known.
    pub feed: f64,
    /// Spindle speed, rev/s: the mean for a feed per revolution, otherwise that in the middle of the move.
    pub rev_per_s: f64,
    /// The change of a thread's lead along the path per revolution, mm.
    pub lead_change: f64,
    /// Nose radius compensation is on.
    pub is_compensated: bool,
    /// The programmed contour of a compensated move; `None` where it is not known.
    pub contour: Option<OutlineSegment>,
}

impl TurnMove {
    pub fn maker(&self) -> SegmentOrigin {
        SegmentOrigin { tool: self.tool, line: self.origin.line }
    }
}

/// Collects the moves of a run.
pub(super) struct TurnedMoves<'a> {
    tools: &'a BTreeMap<u32, Result<LatheTool, NoOutline>>,
    pub moves: Vec<TurnMove>,
    /// Number of path segments so far.
    row: u32,
    /// The work offset of the first cut, which is the frame of the run.
    pub work: Option<String>,
    work_now: Option<String>,
    naming: WorkNaming,
    has_cut: bool,
    pub units: Units,
    spindle_turns: bool,
    rpm: f64,
    threading: bool,
    rotary: Option<[f64; 3]>,
    /// Polar or cylindrical interpolation is active.
    on_surface: bool,
    /// Programmed moves that are still in the look-ahead of compensation.
    programmed: Vec<(Origin, OutlineSegment)>,
    /// Drills whose assumed point angle has been reported.
    assumed: Vec<u32>,
    reported: Vec<(Code, u32)>,
    pub diagnostics: Vec<Diagnostic>,
}

impl<'a> TurnedMoves<'a> {
    pub fn new(
        tools: &'a BTreeMap<u32, Result<LatheTool, NoOutline>>,
        naming: WorkNaming,
        units: Units,
    ) -> TurnedMoves<'a> {
        TurnedMoves {
            tools,
            moves: Vec::new(),
            row: 0,
            work: None,
            work_now: None,
            naming,
            has_cut: false,
            units,
            spindle_turns: false,
            rpm: 0.0,
            threading: false,
            rotary: None,
            on_surface: false,
            programmed: Vec::new(),
            assumed: Vec::new(),
            reported: Vec::new(),
            diagnostics: Vec::new(),
        }
    }

    /// Whether every move that may cut is among the moves.
    pub fn is_whole(&self) -> bool {
        self.reported.is_empty()
    }

    fn segment(&mut self, path: &PathCommand<'_>, segment: &PathSegment, kind: TurnedMoveKind) {
        let row = self.row;
        self.row = self.row.saturating_add(1);
        let tool = match self.tools.get(&segment.tool) {
            Some(Ok(tool)) => tool,
            Some(Err(why)) => return self.no_tool(segment, kind, &why.0.clone()),
            None => return self.no_tool(segment, kind, "its shape is not known"),
        };
        if self.on_surface {
            if kind != TurnedMoveKind::Rapid {
                let why =
                    "it mills a face or a cylinder: polar or cylindrical interpolation is active";
                self.report_once(Code::StockNotFollowed, segment, why);
            }
            return;
        }
        let angles = *self.rotary.get_or_insert(segment.rotary_from);
        let same =
            |a: &[f64; 3]| a.iter().zip(&angles).all(|(a, b)| (a - b).abs() < EQUAL_POSITION);
        if !same(&segment.rotary_from) || !same(&segment.rotary_to) {
            self.rotary = Some(segment.rotary_to);
            if kind == TurnedMoveKind::Rapid {
                return;
            }
            return self.report_once(
                Code::StockNotFollowed,
                segment,
                "a rotary axis moves with it",
            );
        }
        let unknown = match (segment.known, segment.unrelated_zero.is_none(), segment.tip_known) {
            (true, true, true) => None,
            (true, true, false) => Some(TIP_NOT_KNOWN),
            (true, false, _) => Some(FRAME_NOT_KNOWN),
            (false, ..) => Some("where the tool is relative to the part is not known"),
        };
        if let Some(why) = unknown {
            if kind != TurnedMoveKind::Rapid {
                self.report_once(Code::StockNotFollowed, segment, why);
            }
            return;
        }
        let Some(curve) = flat(&segment.curve) else {
            if kind != TurnedMoveKind::Rapid {
                let why = "it is not a line or an arc in the plane of Z and X at Y0";
                self.report_once(Code::StockNotFollowed, segment, why);
            }
            return;
        };
        let cuts = kind != TurnedMoveKind::Rapid;
        let is_off = |p: Vec2| p.b.abs() > ON_AXIS;
        if cuts && tool.kind == TurningToolKind::Drill && (is_off(curve.start) || is_off(curve.end))
        {
            let why = "a drill that is not on the axis does not turn the part";
            return self.report_once(Code::StockNotFollowed, segment, why);
        }
        if tool.has_assumed_point_angle && cuts && !self.assumed.contains(&segment.tool) {
            self.assumed.push(segment.tool);
            self.diagnostics.push(assumed_point_angle(&segment.origin, segment.tool));
        }
        let is_compensated = path.side != CompensationSide::Off;
        let contour = (cuts && is_compensated && !path.inserted)
            .then(|| self.contour_of(path.command))
            .flatten();
        let feed = path.command.kind.feed();
        let middle = 0.5 * (curve.start.b + curve.end.b);
        let is_thread = kind == TurnedMoveKind::Cut && (self.threading || tool.threads);
        let mean_feed =
            if segment.duration_s > 0.0 { segment.length_mm / segment.duration_s } else { 0.0 };
        self.moves.push(TurnMove {
            path: curve,
            kind: if is_thread { TurnedMoveKind::Thread } else { kind },
            tool: segment.tool,
            row,
            origin: segment.origin,
            feed: mean_feed,
            rev_per_s: feed.map_or(0.0, |feed| self.revolutions(feed, mean_feed, middle)),
            lead_change: feed.map_or(0.0, |feed| feed.lead_change),
            is_compensated,
            contour,
        });
    }

    fn revolutions(&self, feed: &Feed, mean_feed: f64, radius: f64) -> f64 {
        if !self.spindle_turns {
            return 0.0;
        }
        if feed.mode == FeedMode::PerRevolution && feed.value > 0.0 {
            return mean_feed / feed.value;
        }
        match feed.surface {
            Some(surface) => surface.rev_per_s(radius),
            None => self.rpm / 60.0,
        }
    }

    /// The programmed move of a compensated move; `None` where it is not known.
    fn contour_of(&mut self, command: &Command) -> Option<OutlineSegment> {
        let at = self.programmed.iter().position(|(origin, _)| *origin == command.origin)?;
        let found = self.programmed[at].1;
        // Compensation has passed it and those before it.
        self.programmed.drain(..=at);
        Some(found)
    }

    fn no_tool(&mut self, segment: &PathSegment, kind: TurnedMoveKind, why: &str) {
        if kind != TurnedMoveKind::Rapid {
            self.report_once(Code::ToolWithoutShape, segment, why);
        }
    }

    /// Reports once per tool why its moves remove nothing.
    fn report_once(&mut self, code: Code, segment: &PathSegment, why: &str) {
        if self.reported.contains(&(code, segment.tool)) {
            return;
        }
        self.reported.push((code, segment.tool));
        self.diagnostics.push(not_cut(code, &segment.origin, segment.tool, why));
    }
}

impl RunWatch for TurnedMoves<'_> {
    fn programmed(&mut self, command: &Command) {
        match &command.kind {
            // Where compensation ends, moves in its look-ahead are still to come.
            CommandKind::Compensation { side, .. } if *side != CompensationSide::Off => {
                self.programmed.clear()
            }
            kind if kind.feed().is_some() => {
                let mut found = None;
                chordal_path::curves_of(kind, |curve| found = flat(&curve));
                if let Some(path) = found {
                    self.programmed.push((command.origin, path));
                    // Compensation looks only a few moves ahead; without it these moves are never taken out.
                    if self.programmed.len() > 4096 {
                        self.programmed.drain(..2048);
                    }
                }
            }
            _ => {}
        }
    }

    fn path(&mut self, path: PathCommand<'_>, segments: &[PathSegment]) {
        let kind = &path.command.kind;
        match kind {
            CommandKind::Spindle { state, rpm } => {
                self.spindle_turns = matches!(state, SpindleState::Cw | SpindleState::Ccw);
                self.rpm = *rpm;
            }
            // A thread disables the feed override, but not that of rapids.
            CommandKind::Overrides(overrides) => {
                self.threading = !overrides.feed && overrides.rapid;
            }
            CommandKind::Units(units) => self.units = *units,
            CommandKind::Surface { surface, .. } => self.on_surface = surface.is_some(),
            CommandKind::WorkOffset { name, .. } => {
                self.work_now = Some(name.table_key(self.naming));
            }
            _ if !self.has_cut && kind.feed().is_some() => {
                self.has_cut = true;
                self.work = self.work_now.clone();
            }
            _ => {}
        }
        let kind = match kind.feed() {
            None => TurnedMoveKind::Rapid,
            Some(_) if self.spindle_turns => TurnedMoveKind::Cut,
            Some(_) => TurnedMoveKind::Still,
        };
        for segment in segments {
            self.segment(&path, segment, kind);
        }
    }
}

/// A curve in the plane of Z and X, as z and radius; `None` for any other.
fn flat(curve: &Curve) -> Option<OutlineSegment> {
    let in_plane = |p: chordal_geometry::Vec3| p.y.abs() <= EQUAL_POSITION;
    let place = |p: chordal_geometry::Vec3| Vec2::new(p.z, p.x);
    match curve {
        Curve::Line(line) if in_plane(line.start) && in_plane(line.end) => {
            Some(OutlineSegment::line(place(line.start), place(line.end)))
        }
        Curve::Arc(arc)
            if arc.w.y.abs() > 1.0 - EQUAL_POSITION && arc.rise.abs() <= EQUAL_POSITION =>
        {
            if !in_plane(arc.start) {
                return None;
            }
            // A positive turn about +Y goes from Z to X, which is counterclockwise in (z, r).
            let counterclockwise = arc.sweep * arc.w.y > 0.0;
            Some(OutlineSegment::arc(
                place(arc.start),
                place(arc.end),
                place(arc.center),
                counterclockwise,
            ))
        }
        Curve::Line(_) | Curve::Arc(_) | Curve::Spiral(_) | Curve::Spline(_) => None,
    }
}
