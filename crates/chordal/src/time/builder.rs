//! Adds up planned times by block, tool and operation.

use chordal_command::Origin;
use std::collections::{BTreeMap, VecDeque};

use chordal_diagnostics::Span;
use chordal_geometry::{Curve, ParamCurve, Vec3};
use chordal_motion::{CornerMode, MoveKind, MoveRequest, PathPart, PlannedTrajectory, PlannerStep};

use super::blocks::{BlockRanking, BlockRun};
use super::reason::{MoveProgress, ReasonQuery, reason_of};
use super::report::{CutEnds, OperationTime, TimeReason, TimeReport, TimeShares, ToolTime};
use super::trajectory_parts::trajectory_parts;
use crate::motion::{MotionStep, OperationMark, StepSource, WaitKind};

/// Most operations that are kept.
pub(super) const MAX_OPERATIONS: usize = 1000;

/// Blocks in each ranking.
const RANKED_BLOCKS: usize = 10;

/// A speed within this share of the programmed one counts as the programmed one.
const EQUAL_SPEED_SHARE: f64 = 1e-6;

/// Directions are tangent where the sine of the angle between them is below this.
const TANGENT_SINE: f64 = 1e-4;

/// A move or a wait, until its time is known.
#[derive(Clone, Copy, Debug)]
enum PendingKind {
    Move { query: ReasonQuery, speed: f64, exact: bool, tangent_next: bool },
    Wait(WaitKind),
}

#[derive(Clone, Copy, Debug)]
struct PendingStep {
    tag: u64,
    tool: u32,
    /// Index of its operation, which may be beyond those that are kept.
    operation: usize,
    origin: Origin,
    what: PendingKind,
}

/// Adds up the time of a program from the steps of a planner, as they come.
///
/// Moves and waits are announced with rising tags before they are pushed into the planner; the planned steps come
/// later. Announced moves and waits are kept until the steps have passed them: as many as the planner's look-ahead.
#[derive(Debug, Default)]
pub struct TimeBuilder {
    pending: VecDeque<PendingStep>,
    /// The progress of the first pending move or wait.
    progress: MoveProgress,
    ends_at_rest: bool,
    /// How many operations have begun.
    operations: usize,
    report: TimeReport,
    waits: BTreeMap<WaitKind, f64>,
    tools: Vec<ToolTime>,
    blocks: BlockRanking,
    /// Direction of the end of the newest exact cut.
    direction: Vec3,
}

impl TimeBuilder {
    /// Announces a move or a wait before it goes into the planner.
    pub fn announce(&mut self, step: &MotionStep, source: &StepSource) {
        let StepSource { tag, tool, origin, .. } = *source;
        let what = match step {
            MotionStep::Move(motion) => self.announced_move(motion, source.nominal_s),
            MotionStep::Wait(wait) => {
                if wait.kind == WaitKind::ToolChange {
                    self.report.tool_changes += 1;
                    tool_entry(&mut self.tools, tool).changes += 1;
                }
                PendingKind::Wait(wait.kind)
            }
        };
        match source.operation {
            Some(OperationMark::Begins(comment)) => self.operation(tool, origin, comment),
            Some(OperationMark::Names(comment)) => self.name_operation(comment),
            None => {}
        }
        let operation = self.operations.saturating_sub(1);
        self.pending.push_back(PendingStep { tag, tool, operation, origin, what });
    }

    fn announced_move(&mut self, motion: &MoveRequest, ideal_s: f64) -> PendingKind {
        if let Some(PendingStep {
            what: PendingKind::Move { exact: true, tangent_next, .. }, ..
        }) = self.pending.back_mut()
        {
            let starts = motion.curve.tangent_at(0.0);
            let (cross, dot) = (self.direction.cross(starts), self.direction.dot(starts));
            *tangent_next = dot > 0.0 && cross.length() < TANGENT_SINE;
        }
        if motion.kind == MoveKind::Cut {
            self.report.cut_ends.add(motion.corner);
        }
        let exact = motion.corner == CornerMode::Exact && motion.kind == MoveKind::Cut;
        if exact {
            self.direction = motion.curve.tangent_at(motion.curve.length());
        }
        let query = ReasonQuery {
            rapid: motion.kind == MoveKind::Rapid,
            curved: !matches!(motion.curve, Curve::Line(_)),
            ideal_s,
        };
        PendingKind::Move { query, speed: motion.speed, exact, tangent_next: false }
    }

    /// The next operation begins.
    fn operation(&mut self, tool: u32, first: Origin, comment: Option<Span>) {
        self.operations += 1;
        tool_entry(&mut self.tools, tool);
        if self.report.operations.len() < MAX_OPERATIONS {
            let times = TimeShares::default();
            let last = first;
            self.report.operations.push(OperationTime { tool, first, last, comment, times });
        } else {
            self.report.operations_left_out += 1;
        }
    }

    /// Gives the newest operation its comment; only the first counts.
    fn name_operation(&mut self, comment: Span) {
        let newest = self.operations.checked_sub(1);
        if let Some(operation) = newest.and_then(|at| self.report.operations.get_mut(at)) {
            operation.comment.get_or_insert(comment);
        }
    }

    /// Takes a step of the planner.
    pub fn step<P: PathPart>(&mut self, step: PlannerStep<'_, P>) {
        match step {
            PlannerStep::Trajectory(trajectory) => self.trajectory(trajectory),
            PlannerStep::Wait { seconds, tag } => {
                self.pass(tag);
                if !self.pending.is_empty() {
                    self.progress.time_s += seconds;
                }
            }
        }
    }

    /// Takes a trajectory. While it overlaps the one before it, the time counts for the earlier move.
    fn trajectory<P: PathPart>(&mut self, trajectory: &PlannedTrajectory<P>) {
        let overlap_s = trajectory.overlap_s;
        let starts_at_rest = trajectory.phases.first().is_some_and(|phase| phase.speed == 0.0);
        let ends_at_rest = trajectory.phases.last().is_some_and(|last| {
            let top = trajectory.phases.iter().map(|phase| phase.speed).fold(0.0, f64::max);
            last.at(last.duration_s).speed <= EQUAL_SPEED_SHARE * top
        });
        if overlap_s > 0.0 && !self.pending.is_empty() {
            self.progress.overlaps = true;
        }
        let mut first = true;
        trajectory_parts(trajectory, |part| {
            self.pass(part.tag);
            let Some(item) = self.pending.front() else { return };
            let PendingKind::Move { speed, .. } = item.what else { return };
            if first {
                first = false;
                self.progress.rests |= starts_at_rest;
                self.progress.overlaps |= overlap_s > 0.0;
            }
            let seconds = part.to_s - part.from_s.max(overlap_s);
            if seconds > 0.0 {
                add_progress(&mut self.progress, seconds, &part, speed);
            }
        });
        if ends_at_rest && !self.pending.is_empty() {
            self.progress.rests = true;
            self.ends_at_rest = true;
        }
    }

    /// Completes everything before this tag.
    fn pass(&mut self, tag: u64) {
        while self.pending.front().is_some_and(|item| item.tag < tag) {
            if let Some(item) = self.pending.pop_front() {
                let progress = std::mem::take(&mut self.progress);
                let ends_at_rest = std::mem::take(&mut self.ends_at_rest);
                self.done(&item, &progress, ends_at_rest);
            }
        }
    }

    fn done(&mut self, item: &PendingStep, progress: &MoveProgress, ends_at_rest: bool) {
        let time_s = progress.time_s;
        let mut times = TimeShares::default();
        let reason = match item.what {
            // The end of the program, or a move that the planner could not take.
            _ if time_s <= 0.0 => return,
            PendingKind::Wait(kind) => {
                times.other_s = time_s;
                *self.waits.entry(kind).or_default() += time_s;
                TimeReason::Wait(kind)
            }
            PendingKind::Move { query, exact, tangent_next, .. } => {
                let share = if query.rapid { &mut times.rapid_s } else { &mut times.cutting_s };
                *share = time_s;
                times.lost_s = (time_s - query.ideal_s).max(0.0);
                self.report.moves += 1;
                self.report.at_feed_s += query.ideal_s;
                let stops = ends_at_rest && exact && tangent_next;
                self.report.tangent_stops += u64::from(stops);
                reason_of(progress, &query)
            }
        };
        self.report.times.add(&times);
        tool_entry(&mut self.tools, item.tool).times.add(&times);
        if let Some(operation) = self.report.operations.get_mut(item.operation) {
            operation.last = item.origin;
            operation.times.add(&times);
        }
        self.blocks.push(BlockRun { origin: item.origin, time_s, lost_s: times.lost_s, reason });
    }

    /// Completes the last steps after the planner has finished, and returns the report.
    pub fn finish(mut self) -> TimeReport {
        self.pass(u64::MAX);
        let (longest, costliest) = self.blocks.finish(RANKED_BLOCKS);
        self.tools.retain(|tool| tool.changes > 0 || tool.times != TimeShares::default());
        TimeReport {
            waits: self.waits.into_iter().collect(),
            tools: self.tools,
            longest,
            costliest,
            ..self.report
        }
    }
}

impl TimeShares {
    fn add(&mut self, other: &TimeShares) {
        self.cutting_s += other.cutting_s;
        self.rapid_s += other.rapid_s;
        self.other_s += other.other_s;
        self.lost_s += other.lost_s;
    }
}

impl CutEnds {
    fn add(&mut self, corner: CornerMode) {
        match corner {
            CornerMode::Stop => self.at_rest += 1,
            CornerMode::Exact => self.exact += 1,
            CornerMode::Joined { linear_mm, .. } | CornerMode::Blended { linear_mm, .. } => {
                self.within += 1;
                self.joined += u64::from(matches!(corner, CornerMode::Joined { .. }));
                let (least, most) = self.tolerance_mm.unwrap_or((linear_mm, linear_mm));
                self.tolerance_mm = Some((least.min(linear_mm), most.max(linear_mm)));
            }
        }
    }
}

fn tool_entry(tools: &mut Vec<ToolTime>, number: u32) -> &mut ToolTime {
    // The newest entry is the likely one.
    let known = tools.iter().rposition(|tool| tool.number == number);
    let at = known.unwrap_or_else(|| {
        tools.push(ToolTime { number, changes: 0, times: TimeShares::default() });
        tools.len() - 1
    });
    &mut tools[at]
}

fn add_progress(
    progress: &mut MoveProgress,
    seconds: f64,
    part: &super::trajectory_parts::TrajectoryPart,
    speed: f64,
) {
    progress.time_s += seconds;
    let share = if part.jerks {
        &mut progress.jerk_s
    } else if part.changes {
        &mut progress.even_acceleration_s
    } else if part.speeds.1 >= speed * (1.0 - EQUAL_SPEED_SHARE) {
        &mut progress.at_feed_s
    } else {
        &mut progress.even_s
    };
    *share += seconds;
}

#[cfg(test)]
mod tests {
    use chordal_machine::AXES;

    use super::*;
    use chordal_diagnostics::{FileId, TextRange};
    use chordal_geometry::{Line, Plane, TurnDirection, arc_from_center};
    use chordal_motion::{JerkPhase, PathPiece};
    use chordal_path::SegmentKind;

    use crate::motion::{MotionWait, StepKind, UnknownAxes};

    fn origin(line: u32) -> Origin {
        let span = Span { file: FileId(0), range: TextRange::new(line * 10, line * 10 + 9) };
        Origin { span, line, ..Origin::default() }
    }

    fn line(from: f64, to: f64, speed: f64, kind: MoveKind) -> MoveRequest {
        let (start, end) = (Vec3::new(from, 0.0, 0.0), Vec3::new(to, 0.0, 0.0));
        MoveRequest {
            curve: Curve::Line(Line { start, end }),
            rotary_from: [0.0; 3],
            rotary_to: [0.0; 3],
            path_length: None,
            speed,
            corner: CornerMode::Exact,
            kind,
            tag: 0,
        }
    }

    /// Announces moves and waits under numbers of its own.
    struct StepAnnouncer {
        time: TimeBuilder,
        number: u32,
        tool: u32,
    }

    impl StepAnnouncer {
        fn new() -> StepAnnouncer {
            StepAnnouncer { time: TimeBuilder::default(), number: 0, tool: 0 }
        }

        fn announce(
            &mut self,
            line: u32,
            kind: StepKind,
            nominal_s: f64,
            step: &MotionStep,
        ) -> u64 {
            self.number += 1;
            let tag = StepSource::tag_of(self.number, line);
            let begins = self.number == 1 || kind == StepKind::Wait(WaitKind::ToolChange);
            self.time.announce(
                step,
                &StepSource {
                    tag,
                    origin: origin(line),
                    tool: self.tool,
                    kind,
                    piece: 0,
                    known: true,
                    unknown_axes: UnknownAxes::default(),
                    length: 0.0,
                    nominal_s,
                    shift: [0.0; AXES],
                    part_frame: None,
                    operation: begins.then_some(OperationMark::Begins(None)),
                },
            );
            tag
        }

        fn motion(&mut self, line: u32, motion: MoveRequest, nominal_s: f64) -> u64 {
            let kind = StepKind::Move(SegmentKind::Line);
            self.announce(line, kind, nominal_s, &MotionStep::Move(motion))
        }

        fn wait(&mut self, line: u32, kind: WaitKind, seconds: f64) -> u64 {
            let wait = MotionWait { seconds, kind, tag: 0 };
            self.announce(line, StepKind::Wait(kind), seconds, &MotionStep::Wait(wait))
        }
    }

    fn piece(length: f64, tag: u64) -> PathPiece {
        PathPiece { length, base: None, start: [[0.0; AXES]; 4], tag }
    }

    /// From rest over a cruise at a speed to rest, all ramps without jerk: enough for a sum.
    fn trapezoid(length: f64, speed: f64, acceleration: f64) -> Vec<JerkPhase> {
        let ramp = speed / acceleration;
        let distance = speed * ramp / 2.0;
        let phase = |duration_s, from, speed, acceleration| JerkPhase {
            duration_s,
            from,
            speed,
            acceleration,
            jerk: 0.0,
        };
        vec![
            phase(ramp, 0.0, 0.0, acceleration),
            phase((length - 2.0 * distance) / speed, distance, speed, 0.0),
            phase(ramp, length - distance, speed, -acceleration),
        ]
    }

    fn wait(seconds: f64, tag: u64) -> PlannerStep<'static> {
        PlannerStep::Wait { seconds, tag }
    }

    fn trajectory(pieces: Vec<PathPiece>, speed: f64, overlap_s: f64) -> PlannedTrajectory {
        let length = pieces.iter().map(|piece| piece.length).sum();
        PlannedTrajectory { pieces, phases: trapezoid(length, speed, 1000.0), overlap_s }
    }

    /// 100 mm at 100 mm/s with 1000 mm/s²: 0.1 s up, 0.9 s at feed, 0.1 s down.
    #[test]
    fn a_program_by_hand() {
        let mut asking = StepAnnouncer::new();
        let rapid = asking.motion(1, line(0.0, 40.0, f64::INFINITY, MoveKind::Rapid), 0.2);
        asking.time.step(PlannerStep::Trajectory(&trajectory(
            vec![piece(40.0, rapid)],
            200.0,
            0.0,
        )));
        asking.tool = 3;
        let change = asking.wait(2, WaitKind::ToolChange, 5.0);
        asking.time.step(wait(5.0, change));
        let cut = line(0.0, 100.0, 100.0, MoveKind::Cut);
        let cuts: Vec<u64> = (0..2).map(|_| asking.motion(3, cut, 1.0)).collect();
        let dwell = asking.wait(4, WaitKind::Dwell, 0.5);
        for tag in cuts {
            asking.time.step(PlannerStep::Trajectory(&trajectory(
                vec![piece(100.0, tag)],
                100.0,
                0.0,
            )));
        }
        asking.time.step(wait(0.5, dwell));
        let report = asking.time.finish();
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{a} is not {b}");
        near(report.times.rapid_s, 0.4);
        near(report.times.cutting_s, 2.2);
        near(report.times.other_s, 5.5);
        near(report.total_s(), 8.1);
        // The rapid: 40 mm at 200 mm/s are 0.2 s.
        near(report.at_feed_s, 2.2);
        near(report.times.lost_s, 0.4);
        assert_eq!(report.waits, [(WaitKind::Dwell, 0.5), (WaitKind::ToolChange, 5.0)]);
        let tools: Vec<_> =
            report.tools.iter().map(|t| (t.number, t.changes, t.times.total_s())).collect();
        assert_eq!(tools.len(), 2);
        assert_eq!((tools[0].0, tools[0].1), (0, 0));
        assert_eq!((tools[1].0, tools[1].1), (3, 1));
        near(tools[0].2, 0.4);
        near(tools[1].2, 7.7);
        let spans: Vec<_> = report.operations.iter().map(|o| (o.first.line, o.last.line)).collect();
        assert_eq!(spans, [(1, 1), (2, 4)]);
        let longest: Vec<_> =
            report.longest.iter().map(|b| (b.origin.line, b.runs, b.reason)).collect();
        assert_eq!(
            longest,
            [
                (2, 1, TimeReason::Wait(WaitKind::ToolChange)),
                (3, 1, TimeReason::Stop),
                (4, 1, TimeReason::Wait(WaitKind::Dwell)),
                (1, 1, TimeReason::Rapid),
            ]
        );
        assert_eq!(report.costliest.len(), 2, "waits lose nothing: {:?}", report.costliest);
        assert_eq!(report.tangent_stops, 1, "the two cuts lie in one line");
    }

    #[test]
    fn an_overlap_counts_once() {
        let mut asking = StepAnnouncer::new();
        let cut = line(0.0, 100.0, 100.0, MoveKind::Cut);
        let (a, b) = (asking.motion(1, cut, 1.0), asking.motion(2, cut, 1.0));
        let mut time = asking.time;
        time.step(PlannerStep::Trajectory(&trajectory(vec![piece(100.0, a)], 100.0, 0.0)));
        time.step(PlannerStep::Trajectory(&trajectory(vec![piece(100.0, b)], 100.0, 0.08)));
        let report = time.finish();
        assert!((report.total_s() - 2.12).abs() < 1e-12, "{}", report.total_s());
        let blocks: Vec<_> =
            report.longest.iter().map(|b| (b.origin.line, b.time_s, b.reason)).collect();
        assert_eq!((blocks[0].0, blocks[0].2), (1, TimeReason::Corner));
        assert!((blocks[1].1 - 1.02).abs() < 1e-12, "{blocks:?}");
    }

    #[test]
    fn an_arc_below_its_feed_is_slowed_by_curvature() {
        let arc = arc_from_center(
            Plane::Xy,
            Vec3::new(10.0, 0.0, 0.0),
            Vec3::new(10.0, 0.0, 0.0),
            (0.0, 0.0),
            TurnDirection::Ccw,
            0,
            1e-9,
        );
        let circle = MoveRequest {
            curve: arc.curve,
            rotary_from: [0.0; 3],
            rotary_to: [0.0; 3],
            path_length: None,
            speed: 200.0,
            corner: CornerMode::Exact,
            kind: MoveKind::Cut,
            tag: 0,
        };
        let length = circle.length();
        let mut asking = StepAnnouncer::new();
        let tag = asking.motion(1, circle, length / 200.0);
        let mut time = asking.time;
        time.step(PlannerStep::Trajectory(&trajectory(vec![piece(length, tag)], 100.0, 0.0)));
        let report = time.finish();
        assert_eq!(report.longest[0].reason, TimeReason::Curvature);
    }
}
