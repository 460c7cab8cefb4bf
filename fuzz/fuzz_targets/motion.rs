//! Moves of any kind for machines of any kind: the planner refuses what is no move, and of
//! everything else it makes a plan that ends, holds every limit and arrives.

#![no_main]

use chordal_geometry::{AXES, Arc, Curve, Frame, Line, ParamCurve, PerAxis, Spiral, Vec3};
use chordal_motion::{
    AxisLimit, CornerMode, KinematicLimits, MotionPlanner, MoveKind, MoveRequest,
    PlannedTrajectory, PlannerLevel, PlannerOptions, PlannerStep, largest_use,
};
use libfuzzer_sys::fuzz_target;

/// Numbers out of bytes; zeros when they are used up.
struct Bytes<'a>(&'a [u8]);

impl Bytes<'_> {
    fn byte(&mut self) -> u8 {
        let Some((first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        *first
    }

    /// From -1 to 1.
    fn share(&mut self) -> f64 {
        f64::from(i16::from_le_bytes([self.byte(), self.byte()])) / 32768.0
    }

    /// From `low` to `high`, evenly in the logarithm.
    fn decades(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf(f64::from(self.byte()) / 255.0)
    }
}

fn limits(bytes: &mut Bytes<'_>) -> KinematicLimits {
    let mut axes = [None; AXES];
    for axis in &mut axes {
        *axis = Some(AxisLimit {
            velocity: bytes.decades(1.0, 2000.0),
            acceleration: bytes.decades(10.0, 20_000.0),
            jerk: bytes.decades(100.0, 1e6),
        });
    }
    KinematicLimits::new(axes).expect("positive numbers")
}

fn corner(bytes: &mut Bytes<'_>) -> CornerMode {
    match bytes.byte() % 8 {
        0 => CornerMode::Stop,
        1 => CornerMode::Exact,
        2 => CornerMode::Joined { linear_mm: 0.0, rotary_rad: 0.0 },
        _ => CornerMode::Joined {
            linear_mm: bytes.decades(1e-6, 10.0),
            rotary_rad: bytes.decades(1e-6, 1.0),
        },
    }
}

/// A curve from a place on; in the direction of the one before, or in any.
fn curve(bytes: &mut Bytes<'_>, at: Vec3, heading: Vec3) -> Curve {
    let choice = bytes.byte();
    let way = Vec3::new(bytes.share(), bytes.share(), bytes.share());
    let direction = match choice & 12 {
        0 => heading,
        4 => -heading,
        8 => heading + way * 0.05,
        _ => way,
    };
    let direction = direction.normalized().unwrap_or(heading);
    let length = bytes.decades(1e-6, 300.0);
    let line = Line::new(at, at + direction * length).into();
    let Some(out) = direction.cross(way).normalized() else { return line };
    let radius = bytes.decades(1e-3, 1e4);
    let frame = Frame::from_normal(at - out * radius, out.cross(direction), out);
    let (Some(frame), sweep) = (frame, (length / radius).min(100.0)) else { return line };
    let rise = bytes.share() * length;
    match choice & 3 {
        0 | 1 => line,
        2 => Arc::new(frame, radius, sweep, rise).into(),
        _ => Spiral::new(frame, (radius, radius * (1.0 + bytes.share())), sweep, rise).into(),
    }
}

/// Every limit is held, and it begins where the one before ended.
fn check(
    trajectory: &PlannedTrajectory,
    limits: &KinematicLimits,
    at: &mut Option<PerAxis<f64>>,
    slack: f64,
) {
    let used = largest_use(trajectory, limits, 2);
    let worst = used.velocity.max(used.acceleration).max(used.jerk);
    assert!(worst <= 1.0 + 1e-6 + rounded(trajectory, limits), "{used:?} of {limits:?}");
    for phase in &trajectory.phases {
        assert!(phase.duration_s >= 0.0 && phase.speed >= 0.0, "{phase:?}");
    }
    assert!(trajectory.overlap_s >= 0.0 && trajectory.duration_s().is_finite());
    let far: f64 = trajectory.from().iter().map(|value| value.abs()).fold(1.0, f64::max) + slack;
    if let Some(before) = at.replace(trajectory.to()) {
        same(before, trajectory.from(), far);
    }
}

/// The direction of a line of a nanometre far from zero is known to so much only: the planner takes moves
/// for straight that turn by less, and an axis then gets this share of what the path has.
fn rounded(trajectory: &PlannedTrajectory, limits: &KinematicLimits) -> f64 {
    let far =
        trajectory.from().iter().chain(&trajectory.to()).fold(0.0_f64, |far, at| far.max(at.abs()));
    let shortest =
        trajectory.pieces.iter().fold(f64::INFINITY, |least, piece| least.min(piece.length));
    let least = |of: PerAxis<f64>| of.into_iter().fold(f64::INFINITY, f64::min);
    let jerk = trajectory.phases.iter().fold(0.0_f64, |most, phase| most.max(phase.jerk.abs()));
    4e-15 * far / shortest * jerk / least(limits.jerk())
}

fn same(a: PerAxis<f64>, b: PerAxis<f64>, far: f64) {
    for axis in 0..AXES {
        assert!((a[axis] - b[axis]).abs() <= 1e-8 + 1e-11 * far, "{a:?} {b:?}");
    }
}

fuzz_target!(|bytes: &[u8]| {
    let mut bytes = Bytes(bytes);
    let limits = limits(&mut bytes);
    let mut options = PlannerOptions::new(PlannerLevel::Fast);
    if bytes.byte() % 2 == 0 {
        options.look_ahead_s = bytes.decades(0.01, 10.0);
    }
    let mut planner = MotionPlanner::new(limits, options);
    let (mut position, mut heading) = (Vec3::ZERO, Vec3::new(1.0, 0.0, 0.0));
    let (mut rotary, mut tag) = ([0.0; 3], 0);
    let mut passing = CornerMode::Stop;
    let (mut at, mut time_s) = (None, 0.0);
    let (mut way, mut steepest) = (0.0_f64, 0.0_f64);
    while !bytes.0.is_empty() && tag < 200 {
        let curve = curve(&mut bytes, position, heading);
        let kind = bytes.byte();
        let rotary_from = rotary;
        if kind & 3 == 0 {
            rotary = rotary.map(|angle| angle + bytes.share() * 3.0);
        }
        // Where rotary axes turn on the spot.
        let spot = kind & 15 == 0;
        let curve = if spot { Line::new(position, position).into() } else { curve };
        if curve.start().distance(position) > 1e-9 {
            continue;
        }
        if kind & 32 == 0 {
            passing = corner(&mut bytes);
        }
        let motion = MoveRequest {
            curve,
            rotary_from,
            rotary_to: rotary,
            speed: if kind & 64 == 0 { bytes.decades(1e-3, 1e4) } else { f64::INFINITY },
            corner: passing,
            kind: MoveKind::Cut,
            tag,
        };
        way += motion.curve.length();
        if motion.curve.length() > 0.0 {
            let turn =
                (0..3).map(|axis| (rotary[axis] - rotary_from[axis]).abs()).fold(0.0, f64::max);
            steepest = steepest.max(turn / motion.curve.length());
        }
        // An axis that turns by radians on a nanometre turns by as much as the place along the path is rounded.
        let slack = 1e-4 * way * steepest;
        let take = |step: PlannerStep<'_>| {
            if let PlannerStep::Trajectory(trajectory) = step {
                check(trajectory, &limits, &mut at, slack);
                time_s += trajectory.duration_s() - trajectory.overlap_s;
            }
        };
        planner.push(&motion, take).expect("a good move");
        if !spot {
            heading = curve.tangent_at(curve.length());
        }
        position = curve.end();
        tag += 1;
    }
    planner.finish(|step| {
        if let PlannerStep::Trajectory(trajectory) = step {
            check(trajectory, &limits, &mut at, 1e-4 * way * steepest);
            time_s += trajectory.duration_s() - trajectory.overlap_s;
        }
    });
    assert!(time_s >= 0.0);
    if let Some(at) = at {
        let [x, y, z] = position.to_array();
        let far = x.abs().max(y.abs()).max(z.abs()) + 1e-4 * way * steepest;
        same(at, [x, y, z, rotary[0], rotary[1], rotary[2]], far);
    }
});
