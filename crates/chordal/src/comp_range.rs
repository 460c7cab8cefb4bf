//! For each compensated contour: the offsets with which it runs, and the blocks that limit them.

use chordal_command::{Command, CommandKind, CompensationSide, Origin, Sink, Units};
use chordal_kernel::ConfiguredControl;
use chordal_kernel::RunSink;
use chordal_kernel::rules::OutsideCorner;
use chordal_kernel::rules::Rules;
use std::collections::BTreeMap;

use chordal_diagnostics::{Diagnostic, Severity, Span};
use chordal_geometry::Plane;
use chordal_path::gouge::{self, GougeOptions, LimitReason, OutsideCornerRule, RadiusLimit};
use chordal_path::{Compensator, ContourLevel, ContourPiece, PathCommand, PathSink};

use crate::compensation_sink::name_sequence;
use crate::job::Job;

/// Commands kept of one contour; a longer one is left out and counted in [`ContourRanges::left_out`].
const KEPT_COMMANDS: usize = 1_000_000;

/// Most contours that are examined; a contour that runs again counts once.
const MAX_CONTOURS: usize = 1000;

/// The radius with which a contour is first run, mm: small enough to fit anywhere.
const TRIAL_RADIUS_MM: f64 = 1e-4;

/// A limit is bisected until it is within this of the true one, mm.
const LIMIT_MM: f64 = 1e-6;

/// Radii tried between zero and the largest.
const TRIED: u32 = 48;

/// What limits the offset of a contour.
#[derive(Clone, Debug, PartialEq)]
pub struct OffsetLimit {
    /// The largest offset radius, mm; infinite without a limit.
    pub radius_mm: f64,
    /// What happens above it.
    pub reason: LimitReason,
    /// The blocks that cause the limit.
    pub blocks: Vec<Origin>,
}

/// The control's own limit: the largest offset that runs, and the alarm just above it.
#[derive(Clone, Debug, PartialEq)]
pub struct ControlLimit {
    /// The largest offset without an alarm, mm.
    pub radius_mm: f64,
    /// The alarm beyond, as it would be reported.
    pub alarm: Diagnostic,
}

/// The offsets with which a compensated contour runs.
#[derive(Clone, Debug, PartialEq)]
pub struct ContourRange {
    /// The block of G41 or G42.
    pub start: Origin,
    /// The block on which compensation ends.
    pub end: Origin,
    /// G41 or G42.
    pub side: CompensationSide,
    /// The plane of compensation.
    pub plane: Plane,
    /// Units of the program at its start.
    pub units: Units,
    /// Number of the offset, and its radius in the table, mm; `None` where the program or the table does not give it.
    pub offset: (Option<u32>, Option<f64>),
    /// How often the program runs it.
    pub runs: u64,
    /// Where the control stops with an alarm; `None` when it never does.
    pub control: Option<ControlLimit>,
    /// Up to this offset the tool cuts into no wall, whatever the control does.
    pub no_gouge: OffsetLimit,
    /// Up to this offset it touches every edge.
    pub every_edge: OffsetLimit,
    /// Up to this offset the lead-in and lead-out moves can be run.
    pub leads: OffsetLimit,
    /// The first lead arc: its block, its radius and the distance of the lead line from its centre, mm.
    pub lead_arc: Option<(Origin, f64, Option<f64>)>,
    /// True where the search was not cut short.
    pub complete: bool,
}

impl ContourRange {
    /// The largest offset with which it runs without alarm and without gouge, mm.
    pub fn largest_mm(&self) -> f64 {
        let control = self.control.as_ref().map_or(f64::INFINITY, |limit| limit.radius_mm);
        control.min(self.no_gouge.radius_mm)
    }

    /// True when the offset of the table lies in the range, or is not known.
    pub fn fits(&self) -> bool {
        self.offset.1.is_none_or(|radius| radius.abs() <= self.largest_mm())
    }
}

/// The ranges of all contours of a run.
#[derive(Clone, Debug, Default)]
pub struct ContourRanges {
    /// In the order of their first run.
    pub ranges: Vec<ContourRange>,
    /// Contours that were not examined because there are too many or they are too long.
    pub left_out: u64,
}

impl Job<'_> {
    /// Finds for each compensated contour the offsets with which it runs.
    pub fn contour_ranges(&self) -> ContourRanges {
        let mut recorder = ContourRecorder::new(self.rules());
        self.run(&mut recorder);
        let mut found = ContourRanges { left_out: recorder.left_out, ..ContourRanges::default() };
        for recorded in recorder.contours.into_values() {
            let Some(mut range) = recorded.range(self.configured_control()) else { continue };
            if let Some(limit) = &mut range.control {
                let span = limit.alarm.primary.span;
                name_sequence(&mut limit.alarm, self.sources(), span);
            }
            found.ranges.push(range);
        }
        found.ranges.sort_by_key(|range| (range.start.span.file, range.start.span.range.start));
        found
    }
}

/// The commands from G41 or G42 to the move after G40.
#[derive(Debug)]
struct RecordedContour {
    commands: Vec<Command>,
    side: CompensationSide,
    plane: Plane,
    units: Units,
    offset: (Option<u32>, Option<f64>),
    runs: u64,
}

/// Records the contours of a run.
struct ContourRecorder {
    contours: BTreeMap<(u32, u32), RecordedContour>,
    open: Option<RecordedContour>,
    cancelling: bool,
    plane: Plane,
    units: Units,
    left_out: u64,
}

impl ContourRecorder {
    fn new(rules: &Rules) -> ContourRecorder {
        ContourRecorder {
            contours: BTreeMap::new(),
            open: None,
            cancelling: false,
            plane: rules.starts_in,
            units: rules.units,
            left_out: 0,
        }
    }

    fn close(&mut self) {
        self.cancelling = false;
        let Some(recorded) = self.open.take() else { return };
        let Some(first) = recorded.commands.first() else { return };
        let key = (first.origin.span.file.0, first.origin.span.range.start);
        if recorded.commands.len() >= KEPT_COMMANDS {
            self.left_out += 1;
        } else if let Some(known) = self.contours.get_mut(&key) {
            known.runs += 1;
        } else if self.contours.len() < MAX_CONTOURS {
            self.contours.insert(key, recorded);
        } else {
            self.left_out += 1;
        }
    }
}

impl Sink for ContourRecorder {
    fn command(&mut self, command: &Command) {
        match command.kind {
            CommandKind::Plane(plane) => self.plane = plane,
            CommandKind::Units(units) => self.units = units,
            CommandKind::Compensation { side, number, radius_mm, .. } => {
                self.cancelling = side == CompensationSide::Off;
                if side != CompensationSide::Off && self.open.is_none() && radius_mm != Some(0.0) {
                    self.open = Some(RecordedContour {
                        commands: Vec::new(),
                        side,
                        plane: self.plane,
                        units: self.units,
                        offset: (number, radius_mm),
                        runs: 1,
                    });
                }
            }
            _ => {}
        }
        let Some(open) = &mut self.open else { return };
        if open.commands.len() < KEPT_COMMANDS {
            open.commands.push(command.clone());
        }
        let ended = self.cancelling && command.kind.motion().is_some();
        if ended || matches!(command.kind, CommandKind::End) {
            self.close();
        }
    }

    fn diagnostic(&mut self, _: Diagnostic) {}
}

impl RunSink for ContourRecorder {}

/// The result of running a contour with one offset.
#[derive(Default)]
struct OffsetTrial {
    levels: Vec<ContourLevel>,
    alarm: Option<Diagnostic>,
    keep: bool,
}

impl PathSink for OffsetTrial {
    fn command(&mut self, _: PathCommand<'_>) {}

    fn diagnostic(&mut self, diagnostic: Diagnostic, _: &Origin) {
        if diagnostic.severity == Severity::Error && self.alarm.is_none() {
            self.alarm = Some(diagnostic);
        }
    }

    fn contour(&mut self, piece: &ContourPiece) {
        if !self.keep {
            return;
        }
        match self.levels.last_mut() {
            Some(level) if level.continues_with(piece) => {}
            Some(level) => {
                let next = level.next(piece);
                self.levels.push(next);
            }
            None => self.levels.push(ContourLevel::of(piece)),
        }
        if let Some(level) = self.levels.last_mut() {
            level.take(piece);
        }
    }
}

impl RecordedContour {
    /// Runs the contour with another offset.
    fn with(&self, control: &dyn ConfiguredControl, radius_mm: f64, keep: bool) -> OffsetTrial {
        let mut compensator =
            Compensator::new(control.rules(), control.profile().alarms()).with_radius(radius_mm);
        let mut tried = OffsetTrial { keep, ..OffsetTrial::default() };
        let origin = self.commands.first().map(|command| command.origin).unwrap_or_default();
        for kind in [CommandKind::Units(self.units), CommandKind::Plane(self.plane)] {
            compensator.command(&Command { kind, origin }, &mut tried);
        }
        for command in &self.commands {
            compensator.command(command, &mut tried);
        }
        compensator.finish(&mut tried);
        tried
    }

    fn range(self, control: &dyn ConfiguredControl) -> Option<ContourRange> {
        let first = self.with(control, TRIAL_RADIUS_MM, true);
        let corners = match control.rules().outside_corner {
            OutsideCorner::Linear => OutsideCornerRule::Linear,
            OutsideCorner::Arc => OutsideCornerRule::Circular,
        };
        let unlimited = || OffsetLimit {
            radius_mm: f64::INFINITY,
            reason: LimitReason::Unlimited,
            blocks: Vec::new(),
        };
        let mut range = ContourRange {
            start: self.commands.first()?.origin,
            end: self.commands.last()?.origin,
            side: self.side,
            plane: self.plane,
            units: self.units,
            offset: self.offset,
            runs: self.runs,
            control: None,
            no_gouge: unlimited(),
            every_edge: unlimited(),
            leads: unlimited(),
            lead_arc: None,
            complete: true,
        };
        let mut events = Vec::new();
        let mut size = 0.0f64;
        for mut level in first.levels {
            let options = GougeOptions::default();
            let Some(contour) = level.contour() else { continue };
            for block in &contour.blocks {
                size = size.max(block.curve.length());
            }
            let found = gouge::range(&contour, corners, &options);
            let limit = |limit: &RadiusLimit| OffsetLimit {
                radius_mm: limit.radius,
                reason: limit.reason,
                blocks: limit.blocks.iter().map(|tag| level.origins[*tag as usize]).collect(),
            };
            range.no_gouge.lower(limit(&found.no_gouge));
            range.every_edge.lower(limit(&found.every_edge));
            range.leads.lower(limit(&found.leads));
            range.complete &= found.complete;
            if let (Some(arc), None) = (found.lead_arc, &range.lead_arc) {
                let origin = level.origins[arc.block as usize];
                range.lead_arc = Some((origin, arc.radius, arc.line_distance));
            }
            events.extend(found.events);
        }
        range.control = self.control_limit(control, &events, 2.0 * size);
        Some(range)
    }

    /// The least offset at which the control alarms: radii are tried from small to large, with
    /// both sides of every radius at which the contour changes among them.
    fn control_limit(
        &self,
        control: &dyn ConfiguredControl,
        events: &[f64],
        largest: f64,
    ) -> Option<ControlLimit> {
        let step = largest / f64::from(TRIED);
        let mut radii: Vec<f64> = (1..=TRIED).map(|index| f64::from(index) * step).collect();
        radii.extend(events.iter().flat_map(|radius| [radius - 2e-3, radius + 2e-3]));
        radii.retain(|radius| *radius > TRIAL_RADIUS_MM && *radius <= largest);
        radii.push(TRIAL_RADIUS_MM);
        radii.sort_by(f64::total_cmp);
        let mut below = 0.0;
        for radius in radii {
            let Some(mut alarm) = self.with(control, radius, false).alarm else {
                below = radius;
                continue;
            };
            let mut above = radius;
            while above - below > LIMIT_MM {
                let middle = 0.5 * (below + above);
                match self.with(control, middle, false).alarm {
                    Some(found) => (above, alarm) = (middle, found),
                    None => below = middle,
                }
            }
            return Some(ControlLimit { radius_mm: below, alarm });
        }
        None
    }
}

impl OffsetLimit {
    fn lower(&mut self, other: OffsetLimit) {
        if other.radius_mm < self.radius_mm {
            *self = other;
        }
    }

    /// The place of the first block that causes the limit; `None` without one.
    pub fn span(&self) -> Option<Span> {
        self.blocks.first().map(|origin| origin.span)
    }
}
