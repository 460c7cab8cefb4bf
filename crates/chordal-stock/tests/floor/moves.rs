//! Random cutters and moves, the same in every run.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use chordal_geometry::{Arc, Curve, Frame, Line, ParamCurve, Spiral, SplinePiece, Vec3};
use chordal_stock::{CutterProfile, Undercut};

/// Numbers that look random (splitmix64).
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Random {
        Random(seed)
    }

    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    pub fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * ((self.bits() >> 11) as f64 / (1_u64 << 53) as f64)
    }

    pub fn below(&mut self, count: u64) -> u64 {
        self.bits() % count
    }

    pub fn point(&mut self, reach: f64) -> Vec3 {
        Vec3::new(
            self.between(-reach, reach),
            self.between(-reach, reach),
            self.between(-reach, reach),
        )
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    Flat,
    Ball,
    Bull,
    Pointed,
    Outline,
}

pub const SHAPES: [Shape; 5] =
    [Shape::Flat, Shape::Ball, Shape::Bull, Shape::Pointed, Shape::Outline];

pub fn cutter(shape: Shape, random: &mut Random) -> CutterProfile {
    let diameter = random.between(1.0, 12.0);
    let cutter = match shape {
        Shape::Flat => CutterProfile::flat(diameter),
        Shape::Ball => CutterProfile::ball(diameter),
        Shape::Bull => CutterProfile::bull(diameter, random.between(0.02, 0.5) * diameter),
        Shape::Pointed => {
            let tip = if random.below(2) == 0 { 0.0 } else { random.between(0.0, 0.9) * diameter };
            CutterProfile::pointed(diameter, tip, random.between(0.3, 3.0))
        }
        // Hollow, bulged and stepped ones.
        Shape::Outline => {
            let mut at = [0.0, if random.below(2) == 0 { 0.0 } else { random.between(0.1, 1.0) }];
            let mut points = vec![at];
            for _ in 0..=random.below(4) {
                match random.below(4) {
                    0 => at[0] += random.between(0.1, 2.0),
                    1 => at[1] += random.between(0.1, 2.0),
                    _ => at = [at[0] + random.between(0.1, 2.0), at[1] + random.between(0.1, 2.0)],
                }
                points.push(at);
            }
            points.push([at[0] + 0.5, at[1] + 1.0]);
            CutterProfile::outline(&points)
        }
    };
    cutter.unwrap()
}

pub fn undercut(random: &mut Random) -> Undercut {
    let diameter = random.between(4.0, 20.0);
    let neck = random.between(0.1, 0.9) * diameter;
    let cutter = match random.below(3) {
        0 => Undercut::t_slot(diameter, random.between(0.5, 6.0), neck),
        1 => Undercut::lollipop(diameter, neck),
        _ => Undercut::thread_disc(
            diameter,
            random.between(0.1, 1.0),
            random.between(0.0, 1.0),
            neck,
        ),
    };
    cutter.unwrap()
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    Line,
    Plunge,
    Arc,
    Helix,
    Upright,
    Tilted,
    UprightHelix,
    Spiral,
    Cone,
    Spline,
}

pub const KINDS: [Kind; 10] = [
    Kind::Line,
    Kind::Plunge,
    Kind::Arc,
    Kind::Helix,
    Kind::Upright,
    Kind::Tilted,
    Kind::UprightHelix,
    Kind::Spiral,
    Kind::Cone,
    Kind::Spline,
];

/// Unit vector in plan.
fn plan(angle: f64) -> Vec3 {
    let (sine, cosine) = libm::sincos(angle);
    Vec3::new(cosine, sine, 0.0)
}

fn frame(random: &mut Random, axis: Vec3) -> Frame {
    let origin = random.point(20.0);
    loop {
        if let Some(frame) = Frame::from_normal(origin, axis, random.point(1.0)) {
            return frame;
        }
    }
}

fn signed(random: &mut Random, size: f64) -> f64 {
    if random.below(2) == 0 { size } else { -size }
}

pub fn curve(kind: Kind, random: &mut Random) -> Curve {
    let radius = random.between(0.2, 15.0);
    let sweep = random.between(0.05, TAU);
    let sweep = signed(random, sweep);
    let up = if random.below(2) == 0 { Vec3::Z } else { -Vec3::Z };
    // The planes of programs as often as any other.
    let across = match random.below(4) {
        0 => Vec3::Y,
        1 => -Vec3::X,
        _ => plan(random.between(-PI, PI)),
    };
    match kind {
        Kind::Line => {
            let start = random.point(20.0);
            let length = random.between(0.01, 20.0);
            let along = plan(random.between(-PI, PI)) * length;
            // Level, gentle, steep.
            let rise = match random.below(4) {
                0 => 0.0,
                1 => length * random.between(-20.0, 20.0),
                _ => length * random.between(-2.0, 2.0),
            };
            Line::new(start, start + along + Vec3::Z * rise).into()
        }
        Kind::Plunge => {
            let start = random.point(20.0);
            Line::new(start, start + Vec3::Z * random.between(-20.0, 20.0)).into()
        }
        Kind::Arc => Arc::new(frame(random, up), radius, sweep, 0.0).into(),
        Kind::Helix => {
            let sweep = sweep * if random.below(2) == 0 { 1.0 } else { 4.0 };
            let rise = sweep * random.between(-3.0, 3.0);
            Arc::new(frame(random, up), radius, sweep, rise).into()
        }
        Kind::Upright => {
            let frame = frame(random, across);
            Arc::new(frame, radius, sweep, 0.0).into()
        }
        Kind::Tilted => {
            let axis = random.point(1.0);
            let rise = if random.below(2) == 0 { 0.0 } else { random.between(-10.0, 10.0) };
            Arc::new(frame(random, axis), radius, sweep, rise).into()
        }
        Kind::UprightHelix => {
            let rise = random.between(-15.0, 15.0);
            Arc::new(frame(random, across), radius, sweep * 2.0, rise).into()
        }
        Kind::Spiral => {
            let radii = (radius, random.between(0.0, 15.0));
            Spiral::new(frame(random, up), radii, sweep * 2.0, 0.0).into()
        }
        Kind::Cone => {
            let radii = (radius, random.between(0.0, 15.0));
            let rise = random.between(-10.0, 10.0);
            let axis = if random.below(4) == 0 { across } else { up };
            Spiral::new(frame(random, axis), radii, sweep * 2.0, rise).into()
        }
        Kind::Spline => {
            let order = 3 + random.below(4) as usize;
            let start = random.point(20.0);
            let points: Vec<Vec3> = (0..order).map(|_| start + random.point(10.0)).collect();
            let weights: Vec<f64> = (0..order).map(|_| random.between(0.4, 2.0)).collect();
            SplinePiece::new(&points, &weights).unwrap().into()
        }
    }
}

/// The point at a share of the way: of the length, or, which is quicker, of the parameter of a spline and
/// of the angle of a spiral.
pub fn point(curve: &Curve, share: f64) -> Vec3 {
    match curve {
        Curve::Spiral(spiral) => {
            let (sine, cosine) = libm::sincos(spiral.sweep * share);
            let out = spiral.u * cosine + spiral.w.cross(spiral.u) * sine;
            let radius = spiral.radius_start + (spiral.radius_end - spiral.radius_start) * share;
            spiral.center + out * radius + spiral.w * (spiral.rise * share)
        }
        Curve::Spline(spline) => spline.jet_at_parameter(share)[0],
        _ => curve.point_at(share * curve.length()),
    }
}

/// A place that the cutter passes over, or just not.
pub fn place(curve: &Curve, radius: f64, random: &mut Random) -> [f64; 2] {
    let near = point(curve, random.between(0.0, 1.0));
    let off = plan(random.between(-PI, PI)) * (random.between(0.0, 1.05) * radius);
    [near.x + off.x, near.y + off.y]
}

/// Turns that a curve makes at most.
pub fn turns(curve: &Curve) -> f64 {
    let sweep = match curve {
        Curve::Arc(arc) => arc.sweep,
        Curve::Spiral(spiral) => spiral.sweep,
        Curve::Line(_) | Curve::Spline(_) => FRAC_PI_2,
    };
    (sweep.abs() / TAU).max(0.25)
}
