use std::collections::VecDeque;

use chordal_control::Origin;
use chordal_geometry::{Curve, ParamCurve, Vec3};
use chordal_motion::{Corner, Limits, Move, MoveKind, Step, Stretch};

use super::blocks::{BlockRun, Blocks};
use super::reason::{Asked, Ride, reason_of};
use super::report::{OperationTime, Reason, TimeReport, Times, ToolTime, Wait};
use super::walk::walk;

/// Most operations that are kept.
const MOST_OPERATIONS: usize = 1000;

/// Blocks in each ranking.
const RANKED: usize = 10;

/// A speed this close to the asked one is the asked one.
const SAME_SPEED: f64 = 1e-6;

/// Directions whose sine is below this go on in each other.
const TANGENT: f64 = 1e-4;

/// What was asked for, until its time is known.
#[derive(Clone, Copy, Debug)]
enum Pending {
    Move { asked: Asked, speed: f64, exact: bool, tangent_next: bool },
    Wait(Wait),
}

#[derive(Clone, Copy, Debug)]
struct Item {
    tag: u64,
    tool: u32,
    /// Its place in the list of operations, where that one is kept.
    operation: usize,
    origin: Origin,
    what: Pending,
    ride: Ride,
    ends_at_rest: bool,
}

/// Adds up the time of a program from the steps of a planner, as they come.
///
/// Moves and waits are announced with rising tags before they are pushed into the planner; the
/// steps come when the planner is sure of them. What is announced waits here until the steps
/// have passed it: as much as the planner looks ahead.
#[derive(Debug)]
pub struct TimeBuilder {
    limits: Limits,
    pending: VecDeque<Item>,
    tag: u64,
    tool: u32,
    /// How many have begun.
    operations: usize,
    report: TimeReport,
    waits: [f64; Wait::ALL.len()],
    tools: Vec<ToolTime>,
    blocks: Blocks,
    /// Direction in which the newest move ends.
    direction: Vec3,
}

impl TimeBuilder {
    /// A builder for a machine with these limits.
    pub fn new(limits: Limits) -> TimeBuilder {
        TimeBuilder {
            limits,
            pending: VecDeque::new(),
            tag: 0,
            tool: 0,
            operations: 0,
            report: TimeReport::default(),
            waits: [0.0; Wait::ALL.len()],
            tools: Vec::new(),
            blocks: Blocks::default(),
            direction: Vec3::ZERO,
        }
    }

    /// A tool goes into the spindle: what follows is its own. The time of the change is a
    /// wait that is announced after this.
    pub fn tool(&mut self, number: u32, origin: Origin) {
        self.tool = number;
        self.report.tool_changes += 1;
        tool_entry(&mut self.tools, number).changes += 1;
        self.operation(origin);
    }

    /// The next operation begins.
    fn operation(&mut self, first: Origin) {
        self.operations += 1;
        tool_entry(&mut self.tools, self.tool);
        if self.report.operations.len() < MOST_OPERATIONS {
            let (tool, times) = (self.tool, Times::default());
            self.report.operations.push(OperationTime { tool, first, last: first, times });
        } else {
            self.report.operations_left_out += 1;
        }
    }

    /// Announces a move and gives the tag with which it must go into the planner.
    pub fn announce(&mut self, motion: &Move, origin: Origin) -> u64 {
        let starts = motion.curve.tangent_at(0.0);
        let length = motion.length();
        if let Some(Item { what: Pending::Move { exact: true, tangent_next, .. }, .. }) =
            self.pending.back_mut()
        {
            let (cross, dot) = (self.direction.cross(starts), self.direction.dot(starts));
            *tangent_next = dot > 0.0 && cross.length() < TANGENT;
        }
        let exact = motion.corner == Corner::Exact && motion.kind == MoveKind::Cut;
        if exact {
            self.direction = motion.curve.tangent_at(length);
        }
        let asked = Asked {
            rapid: motion.kind == MoveKind::Rapid,
            curved: !matches!(motion.curve, Curve::Line(_)),
            ideal_s: ideal_s(motion, &self.limits),
        };
        self.report.moves += 1;
        self.push(origin, Pending::Move { asked, speed: motion.speed, exact, tangent_next: false })
    }

    /// Announces a wait and gives the tag with which it must go into the planner.
    pub fn announce_wait(&mut self, wait: Wait, origin: Origin) -> u64 {
        self.push(origin, Pending::Wait(wait))
    }

    fn push(&mut self, origin: Origin, what: Pending) -> u64 {
        if self.operations == 0 {
            self.operation(origin);
        }
        self.tag += 1;
        self.pending.push_back(Item {
            tag: self.tag,
            tool: self.tool,
            operation: self.operations - 1,
            origin,
            what,
            ride: Ride::default(),
            ends_at_rest: false,
        });
        self.tag
    }

    /// The newest move could not be planned after all.
    pub fn refused(&mut self) {
        if self.pending.pop_back().is_some() {
            self.report.moves -= 1;
            self.report.unplanned += 1;
        }
    }

    /// Takes a step of the planner.
    pub fn step(&mut self, step: Step<'_>) {
        match step {
            Step::Stretch(stretch) => self.stretch(stretch),
            Step::Wait { seconds, tag } => {
                self.pass(tag);
                if let Some(item) = self.pending.front_mut() {
                    item.ride.time_s += seconds;
                }
            }
        }
    }

    /// While a stretch overlaps the one before it, time counts for the earlier move.
    fn stretch(&mut self, stretch: &Stretch) {
        let overlap_s = stretch.overlap_s;
        let starts_at_rest = stretch.phases.first().is_some_and(|phase| phase.speed == 0.0);
        let ends_at_rest = stretch.phases.last().is_some_and(|last| {
            let top = stretch.phases.iter().map(|phase| phase.speed).fold(0.0, f64::max);
            last.at(last.duration_s).speed <= SAME_SPEED * top
        });
        if overlap_s > 0.0
            && let Some(item) = self.pending.front_mut()
        {
            item.ride.overlaps = true;
        }
        let mut first = true;
        walk(stretch, |part| {
            self.pass(part.tag);
            let Some(item) = self.pending.front_mut() else { return };
            let Pending::Move { speed, .. } = item.what else { return };
            if first {
                first = false;
                item.ride.rests |= starts_at_rest;
                item.ride.overlaps |= overlap_s > 0.0;
            }
            let seconds = part.to_s - part.from_s.max(overlap_s);
            if seconds > 0.0 {
                ride_on(&mut item.ride, seconds, &part, speed);
            }
        });
        if ends_at_rest && let Some(item) = self.pending.front_mut() {
            item.ride.rests = true;
            item.ends_at_rest = true;
        }
    }

    /// Everything before this tag is done.
    fn pass(&mut self, tag: u64) {
        while self.pending.front().is_some_and(|item| item.tag < tag) {
            if let Some(item) = self.pending.pop_front() {
                self.done(&item);
            }
        }
    }

    fn done(&mut self, item: &Item) {
        let time_s = item.ride.time_s;
        let (mut times, mut reason) = (Times::default(), Reason::Rapid);
        match item.what {
            Pending::Wait(wait) => {
                times.other_s = time_s;
                reason = Reason::Wait(wait);
                if let Some(at) = Wait::ALL.iter().position(|other| *other == wait) {
                    self.waits[at] += time_s;
                }
            }
            Pending::Move { asked, exact, tangent_next, .. } => {
                if asked.rapid {
                    times.rapid_s = time_s
                } else {
                    times.cutting_s = time_s
                }
                times.lost_s = (time_s - asked.ideal_s).max(0.0);
                self.report.at_feed_s += asked.ideal_s;
                if !asked.rapid {
                    reason = reason_of(&item.ride, &asked);
                }
                let stops = item.ends_at_rest && exact && tangent_next;
                self.report.tangent_stops += u64::from(stops);
            }
        }
        self.report.times.add(&times);
        tool_entry(&mut self.tools, item.tool).times.add(&times);
        if let Some(operation) = self.report.operations.get_mut(item.operation) {
            operation.last = item.origin;
            operation.times.add(&times);
        }
        self.blocks.push(BlockRun { origin: item.origin, time_s, lost_s: times.lost_s, reason });
    }

    /// The planner has finished.
    pub fn finish(mut self) -> TimeReport {
        self.pass(u64::MAX);
        let (longest, costliest) = self.blocks.finish(RANKED);
        let waits = Wait::ALL.into_iter().zip(self.waits).filter(|(_, seconds)| *seconds > 0.0);
        self.tools.retain(|tool| tool.changes > 0 || tool.times != Times::default());
        TimeReport { waits: waits.collect(), tools: self.tools, longest, costliest, ..self.report }
    }
}

impl Times {
    fn add(&mut self, other: &Times) {
        self.cutting_s += other.cutting_s;
        self.rapid_s += other.rapid_s;
        self.other_s += other.other_s;
        self.lost_s += other.lost_s;
    }
}

fn tool_entry(tools: &mut Vec<ToolTime>, number: u32) -> &mut ToolTime {
    // The newest entry is the likely one.
    let found = tools.iter().rposition(|tool| tool.number == number);
    let at = found.unwrap_or_else(|| {
        tools.push(ToolTime { number, changes: 0, times: Times::default() });
        tools.len() - 1
    });
    &mut tools[at]
}

fn ride_on(ride: &mut Ride, seconds: f64, part: &super::walk::Part, speed: f64) {
    ride.time_s += seconds;
    let share = if part.jerks {
        &mut ride.jerk_s
    } else if part.changes {
        &mut ride.even_acceleration_s
    } else if part.speeds.1 >= speed * (1.0 - SAME_SPEED) {
        &mut ride.at_feed_s
    } else {
        &mut ride.even_s
    };
    *share += seconds;
}

/// Length over speed; where no speed is asked for, the time at which the slowest axis could
/// do its way without speeding up first, s.
fn ideal_s(motion: &Move, limits: &Limits) -> f64 {
    if motion.speed.is_finite() {
        return motion.length() / motion.speed;
    }
    let (from, to, velocity) = (motion.from(), motion.to(), limits.velocity());
    (0..6).map(|axis| (to[axis] - from[axis]).abs() / velocity[axis]).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use chordal_diagnostics::{FileId, Span, TextRange};
    use chordal_geometry::{Direction, Line, Plane, arc_from_center};
    use chordal_motion::{AxisLimit, Phase, Piece};

    fn limits() -> Limits {
        let axis = Some(AxisLimit { velocity: 200.0, acceleration: 2000.0, jerk: 1e5 });
        Limits::new([axis, axis, axis, None, None, None]).unwrap()
    }

    fn origin(line: u32) -> Origin {
        let span = Span { file: FileId(0), range: TextRange::new(line * 10, line * 10 + 9) };
        Origin { span, line, ..Origin::default() }
    }

    fn line(from: f64, to: f64, speed: f64, kind: MoveKind) -> Move {
        let (start, end) = (Vec3::new(from, 0.0, 0.0), Vec3::new(to, 0.0, 0.0));
        Move {
            curve: Curve::Line(Line { start, end }),
            rotary_from: [0.0; 3],
            rotary_to: [0.0; 3],
            speed,
            corner: Corner::Exact,
            kind,
            tag: 0,
        }
    }

    fn piece(length: f64, tag: u64) -> Piece {
        Piece { length, base: None, start: [[0.0; 6]; 4], tag }
    }

    /// From rest over a cruise at a speed to rest, all ramps without jerk: enough for a sum.
    fn trapezoid(length: f64, speed: f64, acceleration: f64) -> Vec<Phase> {
        let ramp = speed / acceleration;
        let way = speed * ramp / 2.0;
        let phase = |duration_s, from, speed, acceleration| Phase {
            duration_s,
            from,
            speed,
            acceleration,
            jerk: 0.0,
        };
        vec![
            phase(ramp, 0.0, 0.0, acceleration),
            phase((length - 2.0 * way) / speed, way, speed, 0.0),
            phase(ramp, length - way, speed, -acceleration),
        ]
    }

    fn stretch(pieces: Vec<Piece>, speed: f64, overlap_s: f64) -> Stretch {
        let length = pieces.iter().map(|piece| piece.length).sum();
        Stretch { pieces, phases: trapezoid(length, speed, 1000.0), overlap_s }
    }

    /// 100 mm at 100 mm/s with 1000 mm/s²: 0.1 s up, 0.9 s at feed, 0.1 s down.
    #[test]
    fn a_program_by_hand() {
        let mut time = TimeBuilder::new(limits());
        let rapid = time.announce(&line(0.0, 40.0, f64::INFINITY, MoveKind::Rapid), origin(1));
        time.step(Step::Stretch(&stretch(vec![piece(40.0, rapid)], 200.0, 0.0)));
        time.tool(3, origin(2));
        let change = time.announce_wait(Wait::ToolChange, origin(2));
        time.step(Step::Wait { seconds: 5.0, tag: change });
        let cut = line(0.0, 100.0, 100.0, MoveKind::Cut);
        let cuts: Vec<u64> = (0..2).map(|_| time.announce(&cut, origin(3))).collect();
        let dwell = time.announce_wait(Wait::Dwell, origin(4));
        for tag in cuts {
            time.step(Step::Stretch(&stretch(vec![piece(100.0, tag)], 100.0, 0.0)));
        }
        time.step(Step::Wait { seconds: 0.5, tag: dwell });
        let report = time.finish();
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{a} is not {b}");
        near(report.times.rapid_s, 0.4);
        near(report.times.cutting_s, 2.2);
        near(report.times.other_s, 5.5);
        near(report.total_s(), 8.1);
        // The rapid: 40 mm at 200 mm/s are 0.2 s.
        near(report.at_feed_s, 2.2);
        near(report.times.lost_s, 0.4);
        assert_eq!(report.waits, [(Wait::Dwell, 0.5), (Wait::ToolChange, 5.0)]);
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
                (2, 1, Reason::Wait(Wait::ToolChange)),
                (3, 1, Reason::Stop),
                (4, 1, Reason::Wait(Wait::Dwell)),
                (1, 1, Reason::Rapid),
            ]
        );
        assert_eq!(report.costliest.len(), 2, "waits lose nothing: {:?}", report.costliest);
        assert_eq!(report.tangent_stops, 1, "the two cuts lie in one line");
    }

    #[test]
    fn an_overlap_counts_once() {
        let mut time = TimeBuilder::new(limits());
        let cut = line(0.0, 100.0, 100.0, MoveKind::Cut);
        let (a, b) = (time.announce(&cut, origin(1)), time.announce(&cut, origin(2)));
        time.step(Step::Stretch(&stretch(vec![piece(100.0, a)], 100.0, 0.0)));
        time.step(Step::Stretch(&stretch(vec![piece(100.0, b)], 100.0, 0.08)));
        let report = time.finish();
        assert!((report.total_s() - 2.12).abs() < 1e-12, "{}", report.total_s());
        let blocks: Vec<_> =
            report.longest.iter().map(|b| (b.origin.line, b.time_s, b.reason)).collect();
        assert_eq!((blocks[0].0, blocks[0].2), (1, Reason::Corner));
        assert!((blocks[1].1 - 1.02).abs() < 1e-12, "{blocks:?}");
    }

    #[test]
    fn an_arc_below_its_feed_is_slowed_by_curvature() {
        let arc = arc_from_center(
            Plane::Xy,
            Vec3::new(10.0, 0.0, 0.0),
            Vec3::new(10.0, 0.0, 0.0),
            (0.0, 0.0),
            Direction::Ccw,
            0,
            1e-9,
        );
        let circle = Move {
            curve: arc.curve,
            rotary_from: [0.0; 3],
            rotary_to: [0.0; 3],
            speed: 200.0,
            corner: Corner::Exact,
            kind: MoveKind::Cut,
            tag: 0,
        };
        let mut time = TimeBuilder::new(limits());
        let tag = time.announce(&circle, origin(1));
        let length = circle.length();
        time.step(Step::Stretch(&stretch(vec![piece(length, tag)], 100.0, 0.0)));
        let report = time.finish();
        assert_eq!(report.longest[0].reason, Reason::Curvature);
    }
}
