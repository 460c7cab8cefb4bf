//! Splines in their even parts: planned within the limits of every axis, on the curve.

mod support;

use chordal_geometry::{Curve, EvenPart, ParamCurve, Spline, Vec3};
use chordal_motion::{
    CornerMode, KinematicLimits, LimitUse, MoveRequest, PlannerLevel, largest_use,
};
use support::random::{Dice, random_limits};
use support::{cut, line, plan, samples, time_of};

const ABOVE: f64 = 1.0 + 1e-6;
/// Parts that are not even are lines within this, mm.
const TOLERANCE: f64 = 1e-6;

fn moves_of(spline: &Spline, speed: f64, corner: CornerMode) -> Vec<MoveRequest> {
    let mut moves = Vec::new();
    for piece in spline.pieces().unwrap() {
        piece.even_parts(TOLERANCE, &mut |part| {
            let curve = match part {
                EvenPart::Line(line) => Curve::Line(line),
                EvenPart::Bent(bent) => Curve::Spline(bent),
            };
            if curve.length() > 0.0 {
                moves.push(cut(curve, speed, corner));
            }
        });
    }
    for (index, motion) in moves.iter_mut().enumerate() {
        motion.tag = index as u64;
    }
    moves
}

fn random_spline(dice: &mut Dice) -> Spline {
    let order = 3 + dice.below(4) as usize;
    let count = order + dice.below(5) as usize;
    let size = dice.decades(0.5, 80.0);
    let mut at = |_| Vec3::new(dice.even(-size, size), dice.even(-size, size), 0.0);
    let mut points: Vec<Vec3> = (0..count).map(&mut at).collect();
    if dice.below(4) == 0 {
        // No speed at the start.
        points[1] = points[0];
    }
    let weights = (0..count).map(|_| dice.even(0.4, 3.0)).collect();
    Spline::uniform(order, points, weights).unwrap()
}

#[test]
fn weights_and_places_far_from_each_other_have_a_plan() {
    let mut dice = Dice(11);
    let limits = random_limits(&mut dice);
    for weight in [1e7, 1e11, 1e30, 1e-7, 1e-10, 1e-30] {
        for at in 0..4 {
            let corners = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [2.0, 0.0]];
            let points = corners.iter().map(|[x, y]| Vec3::new(*x, *y, 0.0)).collect();
            let mut weights = vec![1.0; 4];
            weights[at] = weight;
            let spline = Spline::uniform(3, points, weights).unwrap();
            planned(&spline, limits);
        }
        let points = [0.0, weight.min(1e9), 1.0].map(|x| Vec3::new(x, x.min(1.0), 0.0));
        planned(&Spline::uniform(3, points.to_vec(), vec![1.0; 3]).unwrap(), limits);
    }
}

/// It takes no less than its length at its speed.
fn planned(spline: &Spline, limits: KinematicLimits) {
    const SPEED: f64 = 16.0;
    for corner in [CornerMode::Exact, CornerMode::Joined { linear_mm: 0.01, rotary_rad: 0.0 }] {
        let moves = moves_of(spline, SPEED, corner);
        let length: f64 = moves.iter().map(MoveRequest::length).sum();
        for level in [PlannerLevel::Fast, PlannerLevel::Best] {
            let time_s = time_of(&plan(&moves, limits, level));
            assert!(
                time_s.is_finite() && time_s >= 0.9 * length / SPEED,
                "{time_s} s for {length} mm {spline:?} {corner:?}"
            );
        }
    }
}

#[test]
fn plans_keep_every_limit_and_the_curve() {
    let mut dice = Dice(7);
    for seed in 0..60 {
        let limits = random_limits(&mut dice);
        let spline = random_spline(&mut dice);
        let within = dice.decades(0.001, 0.1);
        let corner = match seed % 2 {
            0 => CornerMode::Exact,
            _ => CornerMode::Joined { linear_mm: within, rotary_rad: 0.0 },
        };
        let off = if corner == CornerMode::Exact { 1e-4 } else { within };
        let moves = moves_of(&spline, dice.decades(5.0, 400.0), corner);
        let trajectories = plan(&moves, limits, PlannerLevel::Fast);
        let used = trajectories
            .iter()
            .map(|s| largest_use(s, &limits, 3))
            .fold(LimitUse::default(), LimitUse::or);
        let worst = used.velocity.max(used.acceleration).max(used.jerk);
        assert!(worst <= ABOVE, "{seed}: {used:?}");
        let pieces = spline.pieces().unwrap();
        let samples = samples(&trajectories, 1e-3);
        for sample in samples.iter().step_by(1 + samples.len() / 300) {
            let [x, y, z, ..] = sample.position;
            let at = Vec3::new(x, y, z);
            let far = pieces.iter().map(|piece| piece.nearest(at).distance);
            let far = far.fold(f64::INFINITY, f64::min);
            assert!(far <= off * ABOVE + 2.0 * TOLERANCE, "{seed}: {far} mm off the spline");
        }
        // Setpoints are on polynomials within 1e-9 mm of the curve: those keep the limits, too.
        for sample in &samples {
            for axis in 0..3 {
                let most = limits.axis(axis).unwrap();
                for (value, most) in [
                    (sample.velocity[axis], most.velocity),
                    (sample.acceleration[axis], most.acceleration),
                    (sample.jerk[axis], most.jerk),
                ] {
                    assert!(value.abs() <= most * ABOVE, "{seed}: {value} above {most}");
                }
            }
        }
        let end = samples.last().unwrap().position;
        assert!(Vec3::new(end[0], end[1], end[2]).distance(spline.end()) < 1e-9);
    }
}

#[test]
fn a_straight_spline_takes_as_long_as_its_line() {
    let points = [0.0, 0.0, 30.0, 100.0, 100.0].map(|x| Vec3::new(x, 0.0, 0.0));
    let spline = Spline::uniform(4, points.to_vec(), vec![1.0; 5]).unwrap();
    let limits = support::limits(500.0, 5000.0, 1e5);
    let straight = [cut(line([0.0; 3], [100.0, 0.0, 0.0]), 200.0, CornerMode::Exact)];
    let by_line = time_of(&plan(&straight, limits, PlannerLevel::Fast));
    let by_spline =
        time_of(&plan(&moves_of(&spline, 200.0, CornerMode::Exact), limits, PlannerLevel::Fast));
    assert!((by_spline - by_line).abs() < 1e-6, "{by_spline} {by_line}");
}

#[test]
fn a_quarter_circle_takes_about_as_long_as_the_arc() {
    let points =
        vec![Vec3::new(20.0, 0.0, 0.0), Vec3::new(20.0, 20.0, 0.0), Vec3::new(0.0, 20.0, 0.0)];
    let spline = Spline::uniform(3, points, vec![1.0, 0.5_f64.sqrt(), 1.0]).unwrap();
    let limits = support::limits(200.0, 2000.0, 1e5);
    let frame = chordal_geometry::Plane::Xy.frame();
    let arc = chordal_geometry::Arc::new(frame, 20.0, std::f64::consts::FRAC_PI_2, 0.0);
    let by_arc =
        time_of(&plan(&[cut(arc.into(), 100.0, CornerMode::Exact)], limits, PlannerLevel::Fast));
    let by_spline =
        time_of(&plan(&moves_of(&spline, 100.0, CornerMode::Exact), limits, PlannerLevel::Fast));
    assert!((by_spline / by_arc - 1.0).abs() < 0.15, "{by_spline} {by_arc}");
}
