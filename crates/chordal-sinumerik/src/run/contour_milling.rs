//! CYCLE72: milling along a contour.

use chordal_command::{AxisMask, Command, CommandKind, CompensationSide, Position};
use chordal_diagnostics::{Code, TextRange};
use chordal_geometry::{TurnDirection, Vec2};
use chordal_kernel::ArcWords;

use super::interpreter::Interpreter;
use super::words::{BlockStatementView, BlockWords};
use crate::cycles::CycleArguments;
use crate::values::SinumerikValue;

/// Depth steps of a cycle at most.
const MAX_STEPS: f64 = 10_000.0;

/// The form of an approach or a retraction (ones of _AS1 and _AS2).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum ApproachForm {
    Straight,
    QuarterCircle,
    Semicircle,
}

/// The parameters of CYCLE72, mm and mm/s.
struct ContourMilling {
    retract: f64,
    clearance: f64,
    levels: Vec<f64>,
    allowance: f64,
    feed: Option<f64>,
    infeed: Option<f64>,
    side: CompensationSide,
    approach: (ApproachForm, f64),
    departure: (ApproachForm, f64),
    /// What is between two depths: 0 up to the retract plane, 1 and 2 up to the safety distance, 3 nothing.
    between: i64,
}

/// The start or the end of the contour with its direction there.
#[derive(Clone, Copy)]
struct ContourEnd {
    at: Vec2,
    along: Vec2,
}

impl Interpreter<'_> {
    /// Carries out CYCLE72.
    pub(super) fn mill_contour(
        &mut self,
        arguments: &[Option<SinumerikValue>],
        numbers: &CycleArguments,
        range: TextRange,
    ) {
        if !self.has_edge_for_cycle("CYCLE72", range) {
            return;
        }
        let Some(Some(SinumerikValue::Text(name))) = arguments.first() else {
            let message = "CYCLE72 needs the name of its contour";
            return self.alarm(14020, Code::MissingWord, range, message);
        };
        let Some(job) = self.contour_job(numbers, range) else { return };
        let Some(radius) = self.edge_radius_mm().filter(|radius| *radius > 0.0) else {
            let message = "the radius of the tool is not given: what CYCLE72 cuts is missing here";
            return self.lose_path_because(range, message.into());
        };
        let Some(commands) = self.record_contour(&name.clone(), range) else { return };
        let moves: Vec<Command> =
            commands.into_iter().filter(|command| command.kind.motion().is_some()).collect();
        let ends = self.ends_of(&moves);
        let Some([first, last]) = ends else {
            let message = format!("the contour {name} has no moves");
            return self.alarm(61605, Code::BadArgument, range, message);
        };
        self.report_assumed_path("CYCLE72", range);
        for (number, level) in job.levels.iter().enumerate() {
            self.mill_level(&job, &moves, [first, last], radius, *level, number == 0, range);
        }
        let mut place = self.programmed_position();
        let (_, _, normal) = self.kernel.state.plane.axes();
        place[normal] = job.retract;
        self.cycle_rapid(place);
    }

    fn contour_job(
        &mut self,
        numbers: &CycleArguments,
        range: TextRange,
    ) -> Option<ContourMilling> {
        let unit = self.unit_mm();
        let number = |place: usize| numbers.get(place).unwrap_or(0.0);
        let [retract, reference, safety, bottom] = [1, 2, 3, 4].map(|place| number(place) * unit);
        let direction = if reference < bottom { -1.0 } else { 1.0 };
        if (retract - reference) * direction < 0.0 || reference == bottom {
            let message = "the reference plane must be between the retract plane and the depth";
            self.alarm(61101, Code::CycleLevels, range, message);
            return None;
        }
        let variant = number(10).round() as i64;
        let finishes = variant % 10 == 2;
        let left = if finishes { 0.0 } else { number(7).abs() * unit };
        let depth = (reference - bottom).abs() - left;
        let infeed = number(5).abs() * unit;
        let steps = if infeed > 0.0 { (depth / infeed).ceil().clamp(1.0, MAX_STEPS) } else { 1.0 };
        let levels = (1..=steps as u32)
            .map(|step| reference - direction * depth * f64::from(step) / steps)
            .collect();
        let form = |place: usize| match number(place).round() as i64 % 10 {
            2 => ApproachForm::QuarterCircle,
            3 => ApproachForm::Semicircle,
            _ => ApproachForm::Straight,
        };
        let side = match number(11).round() as i64 {
            41 => CompensationSide::Left,
            42 => CompensationSide::Right,
            _ => CompensationSide::Off,
        };
        let feed = |place: usize| Some(number(place)).filter(|feed| *feed > 0.0);
        Some(ContourMilling {
            retract,
            clearance: reference + direction * safety.abs(),
            levels,
            allowance: if finishes { 0.0 } else { number(6).abs() * unit },
            feed: feed(8).map(|feed| self.cycle_feed(feed)),
            infeed: feed(9).map(|feed| self.cycle_feed(feed)),
            side,
            approach: (form(12), number(13).abs() * unit),
            departure: (form(15), number(16).abs() * unit),
            between: variant / 100 % 10,
        })
    }

    /// The start and the end of a contour with their directions; `None` without moves in the plane.
    fn ends_of(&self, moves: &[Command]) -> Option<[ContourEnd; 2]> {
        let (a, b, _) = self.kernel.state.plane.axes();
        let pick = |place: &Position| Vec2::new(place[a], place[b]);
        let tangents = moves.iter().skip(1).filter_map(|command| {
            let motion = command.kind.motion()?;
            let (from, to) = (pick(&motion.from), pick(&motion.to));
            if let Some(shape) = command.kind.shape() {
                let center = Vec2::new(shape.center[0], shape.center[1]);
                let turned = |point: Vec2| ((point - center) * shape.sweep.signum()).turned_left();
                return Some(((from, turned(from).normalized()?), (to, turned(to).normalized()?)));
            }
            let along = (to - from).normalized()?;
            Some(((from, along), (to, along)))
        });
        let tangents: Vec<_> = tangents.collect();
        let (first, last) = (tangents.first()?.0, tangents.last()?.1);
        Some([first, last].map(|(at, along)| ContourEnd { at, along }))
    }

    #[allow(clippy::too_many_arguments, reason = "the data of one cut")]
    fn mill_level(
        &mut self,
        job: &ContourMilling,
        moves: &[Command],
        [first, last]: [ContourEnd; 2],
        tool_radius: f64,
        level: f64,
        is_first: bool,
        range: TextRange,
    ) {
        let is_mirrored = self.modes.frame.in_plane(self.kernel.state.plane).is_mirrored();
        let side = job.side.mirrored_if(is_mirrored);
        let sign = side.sign();
        let radius = if sign == 0.0 { 0.0 } else { tool_radius + job.allowance };
        let aside = |end: ContourEnd| end.along.turned_left() * sign;
        let (begin, end) = (first.at + aside(first) * radius, last.at + aside(last) * radius);
        let (lead_in, center_in) = lead_of(begin, first.along * -1.0, aside(first), job.approach);
        let (lead_out, center_out) = lead_of(end, last.along, aside(last), job.departure);
        let words = BlockWords::default();
        let view = BlockStatementView { span: self.span(range), words: &words };
        let kept = self.kernel.state.feed;
        if is_first || job.between != 3 {
            let above = if is_first || job.between == 0 { job.retract } else { job.clearance };
            self.cycle_rapid_to(lead_in, above);
            self.cycle_rapid_to(lead_in, job.clearance);
        }
        self.kernel.state.feed = job.infeed.or(kept);
        let place = self.contour_place(lead_in, level);
        self.kernel.line(&view, place, AxisMask::LINEAR);
        self.kernel.state.feed = job.feed.or(kept);
        let place = self.contour_place(begin, level);
        self.lead(&view, place, center_in, sign);
        self.compensated_contour(&view, moves, side, radius, level);
        let place = self.contour_place(end, level);
        self.kernel.line(&view, place, AxisMask::LINEAR);
        let place = self.contour_place(lead_out, level);
        self.lead(&view, place, center_out, sign);
        self.kernel.state.feed = kept;
        let above = match job.between {
            3 => level,
            0 => job.retract,
            _ => job.clearance,
        };
        if above != level {
            self.cycle_rapid_to(lead_out, above);
        }
    }

    /// Cuts the contour with radius compensation, which begins and ends where the tool stands.
    fn compensated_contour(
        &mut self,
        view: &BlockStatementView<'_>,
        moves: &[Command],
        side: CompensationSide,
        radius: f64,
        level: f64,
    ) {
        self.switch_compensation(side, radius);
        let (origin, height) = (self.kernel.origin, self.level_position(level));
        let (a, b, normal) = self.kernel.state.plane.axes();
        for command in moves {
            let Some(motion) = command.kind.motion() else { continue };
            self.kernel.origin = command.origin;
            let mut end = motion.to;
            end[normal] = height[normal];
            match command.kind.shape() {
                Some(shape) => {
                    let direction =
                        if shape.sweep > 0.0 { TurnDirection::Ccw } else { TurnDirection::Cw };
                    let center = [Some(shape.center[0]), Some(shape.center[1])];
                    let arc = ArcWords { direction, center, turns: 0 };
                    let mut named = AxisMask::NONE;
                    named.insert(a);
                    named.insert(b);
                    self.kernel.arc_by_center(view, &arc, end, named);
                }
                None => self.kernel.line(view, end, AxisMask::LINEAR),
            }
        }
        self.kernel.origin = origin;
        self.switch_compensation(CompensationSide::Off, 0.0);
    }

    fn switch_compensation(&mut self, side: CompensationSide, radius: f64) {
        self.kernel.state.side = side;
        self.kernel.emit(CommandKind::Compensation {
            side,
            number: self.kernel.state.radius_offset.filter(|_| side != CompensationSide::Off),
            radius_mm: (side != CompensationSide::Off).then_some(radius),
            toward: None,
            tip: [0.0; 2],
        });
    }

    /// A lead-in or lead-out: a line, or an arc about a centre.
    fn lead(
        &mut self,
        view: &BlockStatementView<'_>,
        end: Position,
        center: Option<Vec2>,
        sign: f64,
    ) {
        match center {
            None => self.kernel.line(view, end, AxisMask::LINEAR),
            Some(center) => {
                let direction = if sign < 0.0 { TurnDirection::Cw } else { TurnDirection::Ccw };
                let center = [Some(center.a), Some(center.b)];
                let arc = ArcWords { direction, center, turns: 0 };
                self.kernel.arc_by_center(view, &arc, end, AxisMask::LINEAR);
            }
        }
    }

    /// A point of the contour at a programmed level.
    fn contour_place(&self, at: Vec2, level: f64) -> Position {
        let (a, b, _) = self.kernel.state.plane.axes();
        let mut place = self.level_position(level);
        (place[a], place[b]) = (at.a, at.b);
        place
    }

    /// The present position at a programmed level.
    fn level_position(&self, level: f64) -> Position {
        let (_, _, normal) = self.kernel.state.plane.axes();
        let mut programmed = self.programmed_position();
        programmed[normal] = level;
        self.mapped(programmed)
    }

    fn cycle_rapid_to(&mut self, at: Vec2, level: f64) {
        let place = self.contour_place(at, level);
        self.kernel.origin.cycle = true;
        self.kernel.state.place(AxisMask::LINEAR);
        self.kernel.rapid_to(place, AxisMask::LINEAR);
        self.kernel.origin.cycle = false;
    }

    fn cycle_rapid(&mut self, place: [f64; 3]) {
        self.kernel.origin.cycle = true;
        self.rapid_to(place);
        self.kernel.origin.cycle = false;
    }
}

/// The far end of a lead that reaches the offset contour at `at`, coming from the direction `back` with the tool's side of
/// the contour in the direction `aside`, and the centre of its arc; `None` for a straight lead.
fn lead_of(
    at: Vec2,
    back: Vec2,
    aside: Vec2,
    (form, size): (ApproachForm, f64),
) -> (Vec2, Option<Vec2>) {
    let center = at + aside * size;
    let is_arc = size > 0.0 && aside != Vec2::ZERO;
    match form {
        ApproachForm::QuarterCircle if is_arc => (center + back * size, Some(center)),
        ApproachForm::Semicircle if is_arc => (center + aside * size, Some(center)),
        _ => (at + back * size, None),
    }
}
