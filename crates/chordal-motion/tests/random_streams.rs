//! Random programs, pushed and pulled in random order, with random holds, resumes and overrides:
//! the limits hold, the path stays the path, the end is the end.

mod support;

use chordal_geometry::{AXES, Arc, Curve, Frame, Line, ParamCurve, Plane, Vec3};
use chordal_motion::{
    AxisLimit, AxisValues, CornerMode, KinematicLimits, MotionPlanner, MoveRequest, PathPiece,
    PlannerLevel, PlannerOptions, PlannerStep, PushOutcome, ServoSetpoint, StreamOptions, stream,
};
use proptest::prelude::*;
use support::cut;
use support::watch::{AXIS_ROUNDING, Watch};

fn machine() -> KinematicLimits {
    let axis = |velocity, acceleration, jerk| Some(AxisLimit { velocity, acceleration, jerk });
    let linear = axis(200.0, 2000.0, 1e5);
    KinematicLimits::new([
        linear,
        linear,
        axis(100.0, 1000.0, 5e4),
        axis(3.0, 40.0, 2000.0),
        None,
        None,
    ])
    .expect("positive limits")
}

#[derive(Clone, Debug)]
struct Draft {
    kind: u8,
    size: f64,
    turn: f64,
    rise: f64,
    speed: f64,
    corner: u8,
    rotary: bool,
}

fn drafts() -> impl Strategy<Value = Vec<Draft>> {
    let draft = (
        0..6_u8,
        prop_oneof![0.001..0.1, 0.1..2.0, 2.0..20.0_f64],
        prop_oneof![Just(0.0), -0.2..0.2, -3.1..3.1_f64],
        prop_oneof![Just(0.0), -0.5..0.5_f64],
        prop_oneof![15.0..40.0, 40.0..300.0_f64],
        0..4_u8,
        prop::bool::weighted(0.2),
    )
        .prop_map(|(kind, size, turn, rise, speed, corner, rotary)| Draft {
            kind,
            size,
            turn,
            rise,
            speed,
            corner,
            rotary,
        });
    prop::collection::vec(draft, 1..12)
}

/// Lines and arcs that join on, some of them tangent.
fn moves(drafts: &[Draft]) -> Vec<MoveRequest> {
    let mut at = Vec3::new(10.0, -20.0, 5.0);
    let mut heading = 0.3_f64;
    let mut rotary = [0.0; 3];
    let mut moves = Vec::new();
    for (index, draft) in drafts.iter().enumerate() {
        heading += draft.turn;
        let rise = draft.size * draft.rise;
        let curve: Curve = if draft.kind < 4 {
            let (sin, cos) = heading.sin_cos();
            Line::new(at, at + Vec3::new(cos * draft.size, sin * draft.size, rise)).into()
        } else {
            let side = if draft.kind == 4 { 1.0 } else { -1.0 };
            let sweep = side * (draft.size * 7.0).rem_euclid(6.0).max(0.05);
            let radius = draft.size;
            // The centre lies across the heading.
            let out = Vec3::new(heading.sin() * side, -heading.cos() * side, 0.0);
            let center = at - out * radius;
            let plane = Plane::Xy.frame();
            let frame = Frame { origin: center, u: out, v: plane.w.cross(out), w: plane.w };
            heading += sweep;
            Arc::new(frame, radius, sweep, rise).into()
        };
        at = curve.end();
        let rotary_from = rotary;
        if draft.rotary {
            rotary[0] += draft.turn;
        }
        let corner = match draft.corner {
            0 => CornerMode::Stop,
            1 => CornerMode::Exact,
            2 => CornerMode::Joined { linear_mm: 0.01, rotary_rad: 1e-4 },
            _ => CornerMode::Joined { linear_mm: 0.2, rotary_rad: 2e-3 },
        };
        let motion = cut(curve, draft.speed, corner);
        moves.push(MoveRequest { rotary_from, rotary_to: rotary, tag: index as u64, ..motion });
    }
    moves
}

/// A dense run: chords of one length whose direction sways, with corners now and then.
#[derive(Clone, Debug)]
struct Dense {
    count: usize,
    chord: f64,
    /// Largest bend, rad by the chord, and how many chords a sway takes.
    bend: f64,
    sway: f64,
    corner_every: usize,
    decimals: i32,
    tolerance: f64,
    speed: f64,
    rotary: bool,
    /// Every so many chords a tangent arc follows.
    arc_every: usize,
}

fn dense() -> impl Strategy<Value = Dense> {
    (
        prop_oneof![3 => 20..400_usize, 1 => 400..1500_usize],
        0.02..0.6_f64,
        prop_oneof![0.0..0.02, 0.02..0.3_f64],
        5.0..200.0_f64,
        prop_oneof![Just(1000_usize), 7..120_usize],
        3..6_i32,
        prop_oneof![Just(0.002), Just(0.01), Just(0.1)],
        prop_oneof![15.0..60.0, 60.0..300.0_f64],
        (prop::bool::weighted(0.3), prop_oneof![2 => Just(10_000_usize), 1 => 15..150_usize]),
    )
        .prop_map(
            |(count, chord, bend, sway, corner_every, decimals, tolerance, speed, others)| Dense {
                count,
                chord,
                bend,
                sway,
                corner_every,
                decimals,
                tolerance,
                speed,
                rotary: others.0,
                arc_every: others.1,
            },
        )
}

impl Dense {
    fn moves(&self) -> Vec<MoveRequest> {
        let unit = 10f64.powi(self.decimals);
        let round = |value: f64| (value * unit).round() / unit;
        let within = CornerMode::Joined { linear_mm: self.tolerance, rotary_rad: 1e-3 };
        let mut heading = 0.0_f64;
        let mut exact = Vec3::ZERO;
        let mut at = Vec3::ZERO;
        let mut rotary_from = [0.0; 3];
        let mut moves = Vec::new();
        for index in 0..self.count {
            let phase = index as f64 / self.sway;
            heading += self.bend * phase.sin();
            if index % self.corner_every == self.corner_every - 1 {
                heading += 1.5;
            }
            let (sin, cos) = heading.sin_cos();
            exact += Vec3::new(cos, sin, 0.3 * (0.7 * phase).cos()) * self.chord;
            let end = Vec3::new(round(exact.x), round(exact.y), round(exact.z));
            if end == at {
                continue;
            }
            let turn = if self.rotary { 0.05 * (0.5 * phase).sin() } else { 0.0 };
            let rotary_to = [turn, 0.0, 0.0];
            let tag = moves.len() as u64;
            let motion = cut(Line::new(at, end).into(), self.speed, within);
            moves.push(MoveRequest { rotary_from, rotary_to, tag, ..motion });
            (at, rotary_from) = (end, rotary_to);
            if index % self.arc_every == self.arc_every - 1 {
                // Between chords that are as short, on a wide circle in the plane of X and Y.
                let (radius, sweep) = (10.0 * self.chord, 0.2);
                let out = Vec3::new(sin, -cos, 0.0);
                let center = at - out * radius;
                let plane = Plane::Xy.frame();
                let frame = Frame { origin: center, u: out, v: plane.w.cross(out), w: plane.w };
                let arc: Curve = Arc::new(frame, radius, sweep, 0.0).into();
                (at, heading) = (arc.end(), heading + sweep);
                exact = at;
                let tag = moves.len() as u64;
                let motion = cut(arc, self.speed, within);
                moves.push(MoveRequest { rotary_from, rotary_to: rotary_from, tag, ..motion });
            }
        }
        moves
    }
}

#[derive(Clone, Debug)]
struct Event {
    after: usize,
    what: u8,
    factor: f64,
}

fn events() -> impl Strategy<Value = Vec<Event>> {
    let event = (
        prop_oneof![0..3_usize, 1..60_usize, 50..400_usize],
        0..8_u8,
        prop_oneof![Just(0.0), Just(1.0), Just(2.0), 0.0..2.0_f64],
    )
        .prop_map(|(after, what, factor)| Event { after, what, factor });
    prop::collection::vec(event, 0..40)
}

/// Distance of a place from the programmed curves near its tag.
fn off_path(moves: &[MoveRequest], point: &ServoSetpoint) -> f64 {
    let [x, y, z, ..] = point.position;
    let tag = point.tag as usize;
    moves[tag.saturating_sub(30)..(tag + 31).min(moves.len())]
        .iter()
        .map(|motion| motion.curve.nearest(Vec3::new(x, y, z)).distance)
        .fold(f64::INFINITY, f64::min)
}

/// Every fourth move begins after a wait, where there are waits.
fn waits_before(motion: &MoveRequest, waits: bool) -> bool {
    waits && motion.tag % 4 == 3
}

/// Pushes and pulls until the end; what the setpoints ask of the axes is in the watch.
fn run(
    moves: &[MoveRequest],
    waits: bool,
    events: &[Event],
    options: StreamOptions,
) -> (Watch, Vec<ServoSetpoint>) {
    let machine = machine();
    let (mut feeder, mut servo) = stream(machine, options, moves[0].from());
    let mut watch = Watch::default();
    let mut points = Vec::new();
    let mut events = events.iter();
    let mut event = events.next();
    let mut wait = event.map_or(0, |event| event.after);
    let mut next = 0;
    let mut away = 0_usize;
    let mut wait_due = false;
    loop {
        if away > 0 {
            away -= 1;
        } else {
            while next < moves.len() {
                let pushed = if wait_due {
                    feeder.wait(0.03, moves[next].tag)
                } else {
                    feeder.push(&moves[next])
                };
                match pushed.expect("a move that can be planned") {
                    PushOutcome::Taken if wait_due => wait_due = false,
                    PushOutcome::Taken => {
                        next += 1;
                        wait_due = next < moves.len() && waits_before(&moves[next], waits);
                    }
                    PushOutcome::Full => break,
                }
            }
            if next == moves.len() {
                feeder.finish();
            }
        }
        while let Some(Event { what, factor, .. }) = event {
            if wait > 0 {
                wait -= 1;
                break;
            }
            match what {
                0 | 1 => servo.hold(),
                2 | 3 => servo.resume(),
                4 | 5 => servo.set_override(*factor),
                6 => {
                    feeder.flush();
                }
                _ => away = (factor * 300.0) as usize,
            }
            event = events.next();
            wait = event.map_or(0, |event| event.after);
        }
        if event.is_none() {
            servo.resume();
            servo.set_override(1.0);
        }
        let point = servo.next();
        watch.take(&point, options.period_s, &machine);
        points.push(point);
        if point.finished {
            break;
        }
        assert!(points.len() < 300_000, "the end is not reached: {point:?}");
    }
    (watch, points)
}

/// What rounding does to each coordinate: in addition to its own, that of the way along the path, whose
/// last bits a rotary axis turns into a larger angle the more it turns by the mm.
fn rounding(moves: &[MoveRequest]) -> AxisValues {
    let lengths: Vec<f64> = moves.iter().map(|motion| motion.curve.length()).collect();
    let path_length: f64 = lengths.iter().sum();
    let mut rounding = AXIS_ROUNDING;
    for (motion, length) in moves.iter().zip(&lengths) {
        for (axis, rounding) in rounding[3..].iter_mut().enumerate() {
            let turn = (motion.rotary_to[axis] - motion.rotary_from[axis]).abs();
            // The start of the phase, the start of the piece and the step from the one to the other.
            *rounding =
                rounding.max(AXIS_ROUNDING[0] + 3.0 * f64::EPSILON * path_length * turn / length);
        }
    }
    rounding
}

fn check(drafts: &[Draft], events: &[Event], options: StreamOptions) -> Result<(), TestCaseError> {
    let moves = moves(drafts);
    let (watch, points) = run(&moves, true, events, options);
    watch.check(options.period_s, &machine(), &rounding(&moves));
    let end = points.last().expect("an end");
    let target = moves[moves.len() - 1].to();
    for (end, target) in end.position.iter().zip(&target) {
        prop_assert!((end - target).abs() < 1e-9, "{end} for {target}");
    }
    // The planner takes a nanometre for kinks that are exact by their words.
    let exact = drafts.iter().all(|draft| draft.corner < 2);
    let tolerance = if exact { 1e-6 } else { 0.2 };
    for point in &points {
        let off = off_path(&moves, point);
        prop_assert!(off <= tolerance + 1e-9, "{off} mm off the path: {point:?}");
    }
    // A flush in between plans a stop that this plan has not got.
    if exact && events.iter().all(|event| event.what != 6) {
        let mut walk = Walk { pieces: planned(&moves, options.headroom), piece: 0, sigma: 0.0 };
        for point in &points {
            let off = walk.off(&point.position);
            prop_assert!(off < 1e-9, "{off} mm off what was planned: {point:?}");
        }
    }
    Ok(())
}

/// The pieces that the feeder's planner makes.
fn planned(moves: &[MoveRequest], headroom: f64) -> Vec<PathPiece> {
    let machine = machine();
    let axes = [0, 1, 2, 3, 4, 5].map(|axis| {
        machine.axis(axis).map(|limit| AxisLimit {
            acceleration: limit.acceleration * (1.0 - headroom),
            jerk: limit.jerk * (1.0 - headroom),
            ..*limit
        })
    });
    let limits = KinematicLimits::new(axes).expect("positive limits");
    let mut planner = MotionPlanner::new(limits, PlannerOptions::new(PlannerLevel::Fast));
    let mut pieces = Vec::new();
    let mut take = |step: PlannerStep<'_>| {
        if let PlannerStep::Trajectory(trajectory) = step {
            pieces.extend_from_slice(&trajectory.pieces);
        }
    };
    for motion in moves {
        if waits_before(motion, true) {
            planner.wait(0.03, motion.tag, &mut take);
        }
        planner.push(motion, &mut take).expect("a move that can be planned");
    }
    planner.finish(&mut take);
    pieces
}

/// Goes along the planned path and never back.
struct Walk {
    pieces: Vec<PathPiece>,
    piece: usize,
    sigma: f64,
}

impl Walk {
    /// Distance of a place from the path at or after the last one.
    fn off(&mut self, place: &AxisValues) -> f64 {
        let mut least = f64::INFINITY;
        for index in self.piece..self.pieces.len() {
            let piece = &self.pieces[index];
            let from = if index == self.piece { self.sigma } else { 0.0 };
            let mut sigma = from;
            for _ in 0..20 {
                let [x, d, ..] = piece.at(sigma);
                let along: f64 = (0..AXES).map(|axis| (place[axis] - x[axis]) * d[axis]).sum();
                let square: f64 = d.iter().map(|d| d * d).sum();
                sigma = (sigma + along / square).clamp(from, piece.length);
            }
            let x = piece.at(sigma)[0];
            let off = (0..AXES).map(|axis| (place[axis] - x[axis]).powi(2)).sum::<f64>().sqrt();
            least = least.min(off);
            if off < 1e-9 {
                (self.piece, self.sigma) = (index, sigma);
                return off;
            }
        }
        least
    }
}

/// A longer run: `CHORDAL_ROUNDS=20000 cargo test --release -p chordal-motion --test random_streams`.
fn config() -> ProptestConfig {
    let cases = option_env!("CHORDAL_ROUNDS").and_then(|rounds| rounds.parse().ok()).unwrap_or(64);
    ProptestConfig {
        cases,
        max_shrink_iters: 150,
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn limits_and_path_hold_whatever_is_done(
        drafts in drafts(),
        events in events(),
        fine in any::<bool>(),
        windows in prop_oneof![Just(3_usize), Just(16)],
        headroom in prop_oneof![Just(0.0), Just(0.03), Just(0.2)],
        scale_waits in any::<bool>(),
        pieces in prop_oneof![Just(64_usize), Just(16_384)],
    ) {
        let period_s = if fine { 0.000_25 } else { 0.001 };
        let options =
            StreamOptions { period_s, windows, headroom, scale_waits, pieces, ..StreamOptions::default() };
        check(&drafts, &events, options)?;
    }

    #[test]
    fn dense_runs_hold_limits_and_tolerance_whatever_is_done(
        dense in dense(),
        events in events(),
        fine in prop::bool::weighted(0.2),
        windows in prop_oneof![Just(3_usize), Just(16)],
        headroom in prop_oneof![Just(0.0), Just(0.03)],
        pieces in prop_oneof![Just(2048_usize), Just(16_384)],
    ) {
        let period_s = if fine { 0.000_25 } else { 0.001 };
        let options = StreamOptions { period_s, windows, headroom, pieces, ..StreamOptions::default() };
        let moves = dense.moves();
        prop_assume!(!moves.is_empty());
        let (watch, points) = run(&moves, false, &events, options);
        watch.check(options.period_s, &machine(), &rounding(&moves));
        let end = points.last().expect("an end");
        for (end, target) in end.position.iter().zip(&moves[moves.len() - 1].to()) {
            prop_assert!((end - target).abs() < 1e-9, "{end} for {target}");
        }
        for point in &points {
            let off = off_path(&moves, point);
            prop_assert!(off <= dense.tolerance + 1e-9, "{off} mm off the path: {point:?}");
        }
    }

    #[test]
    fn exact_programs_stay_exact(mut drafts in drafts(), mut events in events()) {
        events.retain(|event| event.what != 6);
        for draft in &mut drafts {
            draft.corner %= 2;
        }
        check(&drafts, &events, StreamOptions::default())?;
    }
}
