//! Paths of the axes: their derivatives against numerical ones, their bounds against dense samples.

mod common;

use chordal_geometry::Vec3;
use chordal_kinematics::{
    AngleJet, AxisJet, AxisPositions, JointAngles, JointPath, KinematicChain, RotaryJoint,
    RotaryLetter, TipJet, TipLine, TipMotion,
};
use common::{RandomNumbers, chain, degrees};

/// A helix of the tip, by σ from 0 to 1.
#[derive(Clone, Copy, Debug)]
struct TipHelix {
    center: Vec3,
    radius_mm: f64,
    turn: f64,
    rise_mm: f64,
}

impl TipMotion for TipHelix {
    fn tip(&self, sigma: f64) -> TipJet {
        let (sin, cos) = (self.turn * sigma).sin_cos();
        let (out, along) = (Vec3::new(cos, sin, 0.0), Vec3::new(-sin, cos, 0.0));
        TipJet {
            point: self.center + out * self.radius_mm + Vec3::Z * (self.rise_mm * sigma),
            first: along * (self.radius_mm * self.turn) + Vec3::Z * self.rise_mm,
            second: -out * (self.radius_mm * self.turn * self.turn),
        }
    }

    fn derivative_bounds(&self, _from: f64, _to: f64) -> (f64, f64) {
        let along = self.radius_mm * self.turn.abs();
        (along.hypot(self.rise_mm), along * self.turn.abs())
    }
}

fn random_chain(random: &mut RandomNumbers, kind: u32) -> KinematicChain {
    let joint = |random: &mut RandomNumbers, letter| {
        RotaryJoint::table(letter, random.point(400.0)).along(random.direction())
    };
    let head =
        |joint: RotaryJoint| RotaryJoint { side: chordal_kinematics::RotaryMount::Head, ..joint };
    let (first, second) = (joint(random, RotaryLetter::C), joint(random, RotaryLetter::B));
    match kind % 5 {
        0 => chain(&[first, second.turned_around()]),
        1 => chain(&[first.turned_around(), head(second)]),
        2 => chain(&[head(first), head(second)]),
        3 => chain(&[first]),
        _ => chain(&[head(second)]),
    }
}

fn random_angles(random: &mut RandomNumbers) -> JointAngles {
    core::array::from_fn(|_| random.between(-3.0, 3.0))
}

fn random_path(random: &mut RandomNumbers, kind: u32) -> JointPath<TipHelix> {
    JointPath {
        chain: random_chain(random, kind),
        tip: TipHelix {
            center: random.point(200.0),
            radius_mm: random.between(1.0, 60.0),
            turn: random.between(-4.0, 4.0),
            rise_mm: random.between(-50.0, 50.0),
        },
        from: random_angles(random),
        to: random_angles(random),
        tool: random.point(150.0),
    }
}

/// The first derivative by central differences of eighth order.
fn numerical(at: impl Fn(f64) -> [f64; 6], sigma: f64) -> [f64; 6] {
    const STEP: f64 = 0.01;
    const WEIGHTS: [f64; 4] = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
    let mut sum = [0.0; 6];
    for (weight, count) in WEIGHTS.into_iter().zip(1..) {
        let step = STEP * f64::from(count);
        let (after, before) = (at(sigma + step), at(sigma - step));
        for axis in 0..6 {
            sum[axis] += weight * (after[axis] - before[axis]) / STEP;
        }
    }
    sum
}

#[track_caller]
fn all_close(found: &[f64; 6], expected: &[f64; 6], relative: f64) {
    let size = expected.iter().fold(1.0_f64, |size, value| size.max(value.abs()));
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= relative * size, "{found} is not {expected}");
    }
}

#[test]
fn derivatives_are_those_of_the_positions() {
    let mut random = RandomNumbers(1);
    for kind in 0..500 {
        let path = random_path(&mut random, kind);
        let sigma = random.between(0.05, 0.95);
        let AxisJet { position, first, second } = path.at(sigma);
        let axes = path.positions(sigma);
        let [x, y, z] = axes.gauge_point.to_array();
        let [a, b, c] = axes.angles;
        all_close(&position, &[x, y, z, a, b, c], 1e-15);
        all_close(&first, &numerical(|sigma| path.at(sigma).position, sigma), 3e-11);
        all_close(&second, &numerical(|sigma| path.at(sigma).first, sigma), 3e-11);
    }
}

#[test]
fn derivatives_hold_for_angles_that_accelerate() {
    let mut random = RandomNumbers(8);
    for kind in 0..500 {
        let path = random_path(&mut random, kind);
        let bend = random_angles(&mut random);
        let angles = |sigma: f64| {
            let AngleJet { mut angles, mut first, .. } = path.angles(sigma);
            for index in 0..3 {
                angles[index] += bend[index] * sigma * sigma;
                first[index] += 2.0 * bend[index] * sigma;
            }
            AngleJet { angles, first, second: bend.map(|bend| 2.0 * bend) }
        };
        let at = |sigma: f64| path.chain.axis_jet(&path.tip.tip(sigma), &angles(sigma), path.tool);
        let sigma = random.between(0.05, 0.95);
        let AxisJet { first, second, .. } = at(sigma);
        all_close(&first, &numerical(|sigma| at(sigma).position, sigma), 1e-9);
        all_close(&second, &numerical(|sigma| at(sigma).first, sigma), 1e-9);
    }
}

#[test]
fn a_tip_that_crosses_the_axis_is_bounded_at_its_ends_too() {
    // In the middle the tip is on the axis, and at the ends 500 from it.
    let path = JointPath {
        chain: chain(&[RotaryJoint::table(RotaryLetter::C, Vec3::ZERO)]),
        tip: TipLine { from: Vec3::X * -500.0, to: Vec3::X * 500.0 },
        from: [0.0; 3],
        to: [0.0, 0.0, 9.0],
        tool: Vec3::ZERO,
    };
    let [x, y, z, ..] = path.at(1.0).second;
    let length = Vec3::new(x, y, z).length();
    let expected = 500.0 * 81_f64.hypot(2.0 * 2.0 * 9.0);
    assert!((length - expected).abs() < 1e-9 * expected, "{length} is not {expected}");
    assert!(path.second_derivative_bound(0.0, 1.0) >= length);
}

#[test]
fn the_axes_bring_the_tip_to_its_path() {
    let mut random = RandomNumbers(2);
    for kind in 0..500 {
        let path = random_path(&mut random, kind);
        let sigma = random.unit();
        let axes = path.positions(sigma);
        let pose = path.chain.pose(axes.gauge_point, &axes.angles, path.tool);
        assert!(pose.tip.distance(path.tip.tip(sigma).point) < 1e-11);
    }
}

#[test]
fn second_derivatives_are_within_their_bound() {
    let mut random = RandomNumbers(3);
    for kind in 0..200 {
        let path = random_path(&mut random, kind);
        let from = random.unit();
        let to = from + random.between(0.0, 0.5);
        let bound = path.second_derivative_bound(from, to);
        for step in 0..=200 {
            let [x, y, z, ..] = path.at(from + (to - from) * f64::from(step) / 200.0).second;
            let length = Vec3::new(x, y, z).length();
            assert!(length <= bound * (1.0 + 1e-12), "{length} exceeds {bound}");
        }
    }
}

#[test]
fn bounds_hold_every_sample_and_are_tight() {
    const TOLERANCE_MM: f64 = 1e-4;
    const SAMPLES: u32 = 4000;
    let mut random = RandomNumbers(4);
    for kind in 0..100 {
        let path = random_path(&mut random, kind);
        let from = random.unit();
        let to = from + random.between(0.01, 1.0);
        let bounds = path.bounds(from, to, TOLERANCE_MM);
        let at =
            |step: u32| path.at(from + (to - from) * f64::from(step) / f64::from(SAMPLES)).position;
        // What the samples may miss of an extreme between them.
        let width = (to - from) / f64::from(SAMPLES);
        let missed = path.second_derivative_bound(from, to) * width * width / 8.0;
        for (axis, (low, high)) in bounds.into_iter().enumerate() {
            let (mut least, mut largest) = (f64::INFINITY, f64::NEG_INFINITY);
            for step in 0..=SAMPLES {
                let value = at(step)[axis];
                (least, largest) = (least.min(value), largest.max(value));
            }
            assert!(low <= least && largest <= high, "{axis}: {low} {least} {largest} {high}");
            assert!(least - low <= TOLERANCE_MM + missed, "{axis}: {low} is not {least}");
            assert!(high - largest <= TOLERANCE_MM + missed, "{axis}: {high} is not {largest}");
        }
    }
}

#[test]
fn bounds_are_exact_where_no_axis_turns() {
    let path = JointPath {
        chain: common::table_table_ac(),
        tip: TipLine { from: Vec3::ZERO, to: Vec3::new(10.0, -20.0, 0.0) },
        from: [0.0; 3],
        to: [0.0; 3],
        tool: Vec3::ZERO,
    };
    let bounds = path.bounds(0.0, 1.0, 1e-3);
    for (axis, (low, high)) in [(0.0, 10.0), (-20.0, 0.0), (0.0, 0.0)].into_iter().enumerate() {
        assert!((bounds[axis].0 - low).abs() < 1e-11, "{bounds:?}");
        assert!((bounds[axis].1 - high).abs() < 1e-11, "{bounds:?}");
    }
    assert_eq!(path.chord_count(0.0, 1.0, 1e-6), 1);
}

#[test]
fn an_extreme_between_the_ends_is_found_by_hand() {
    // A point 100 from C turns from 0 to 180 degrees with the table: Y of the machine is largest in the middle.
    let path = JointPath {
        chain: chain(&[RotaryJoint::table(RotaryLetter::C, Vec3::ZERO)]),
        tip: TipLine { from: Vec3::X * 100.0, to: Vec3::X * 100.0 },
        from: [0.0; 3],
        to: degrees(0.0, 0.0, -180.0),
        tool: Vec3::ZERO,
    };
    let bounds = path.bounds(0.0, 1.0, 1e-6);
    assert!((100.0..=100.0 + 1e-6 + 1e-10).contains(&bounds[1].1), "{bounds:?}");
    assert!((-1e-6 - 1e-10..=0.0).contains(&bounds[1].0), "{bounds:?}");
    let (low, high) = bounds[5];
    assert!((low + std::f64::consts::PI).abs() < 1e-13 && high.abs() < 1e-13, "{bounds:?}");
}

#[test]
fn straight_deviations_hold_every_sample_and_are_tight() {
    const TOLERANCE_MM: f64 = 1e-4;
    const SAMPLES: u32 = 4000;
    let mut random = RandomNumbers(5);
    for kind in 0..100 {
        let chain = random_chain(&mut random, kind);
        let tool = random.point(150.0);
        let axes = |random: &mut RandomNumbers| AxisPositions {
            gauge_point: random.point(300.0),
            angles: random_angles(random),
        };
        let (from, to) = (axes(&mut random), axes(&mut random));
        let bound = chain.straight_deviation(&from, &to, tool, TOLERANCE_MM);
        let tip = |sigma: f64| {
            let gauge_point = from.gauge_point + (to.gauge_point - from.gauge_point) * sigma;
            let angles = core::array::from_fn(|index| {
                from.angles[index] + (to.angles[index] - from.angles[index]) * sigma
            });
            chain.pose(gauge_point, &angles, tool).tip
        };
        let (start, end) = (tip(0.0), tip(1.0));
        let along = end - start;
        let mut largest = 0.0_f64;
        for step in 0..=SAMPLES {
            let point = tip(f64::from(step) / f64::from(SAMPLES));
            let part = ((point - start).dot(along) / along.dot(along)).clamp(0.0, 1.0);
            largest = largest.max(point.distance(start + along * part));
        }
        assert!(largest <= bound + 1e-10, "{largest} exceeds {bound}");
        // 4000 samples of at most some 3000 mm miss less than this.
        assert!(bound - largest <= TOLERANCE_MM + 1e-3, "{bound} is not {largest}");
    }
}

#[test]
fn chords_of_the_axes_keep_the_tip_on_its_path() {
    const TOLERANCE_MM: f64 = 0.01;
    let mut random = RandomNumbers(6);
    let mut counts = Vec::new();
    for kind in 0..20 {
        let path = random_path(&mut random, kind);
        let count = path.chord_count(0.0, 1.0, TOLERANCE_MM);
        counts.push(count);
        let at = |chord: u32| f64::from(chord) / f64::from(count);
        let mut largest = 0.0_f64;
        for chord in 0..count {
            let (start, end) = (path.positions(at(chord)), path.positions(at(chord + 1)));
            for part in [0.25, 0.5, 0.75] {
                let sigma = at(chord) + part * (at(chord + 1) - at(chord));
                let gauge_point = start.gauge_point.lerp(end.gauge_point, part);
                let angles = path.positions(sigma).angles;
                let tip = path.chain.pose(gauge_point, &angles, path.tool).tip;
                largest = largest.max(tip.distance(path.tip.tip(sigma).point));
            }
        }
        assert!(largest <= TOLERANCE_MM, "{largest}");
        // Not many times more chords than needed: the bound is at most sixteen times the true value.
        assert!(largest >= TOLERANCE_MM / 16.0, "{largest} with {count} chords");
    }
    assert!(counts.iter().all(|count| *count > 10), "{counts:?}");
}
