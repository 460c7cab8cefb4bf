//! The floor below a path by dense sampling in double precision: knows nothing of the formulas.
#![allow(dead_code)]

pub mod surface;

use chordal_geometry::{Aabb, Curve, Line, ParamCurve, Vec3};
use chordal_stock::{ColumnOptions, ColumnStock, CutterProfile, Mode, TipMove};

/// Numbers that look random: the same in every run.
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.next()
    }
}

pub fn point([x, y, z]: [f64; 3]) -> Vec3 {
    Vec3::new(x, y, z)
}

pub fn line(from: [f64; 3], to: [f64; 3]) -> TipMove {
    TipMove { curve: Curve::Line(Line::new(point(from), point(to))), tag: 0 }
}

/// Moves along corners.
pub fn path(corners: &[[f64; 3]]) -> Vec<TipMove> {
    corners.windows(2).map(|two| line(two[0], two[1])).collect()
}

pub const BUDGET: u64 = 1 << 30;

pub fn stock(min: [f64; 3], max: [f64; 3], resolution: f64) -> ColumnStock {
    ColumnStock::new(
        Aabb { min: point(min), max: point(max) },
        ColumnOptions::new(resolution, BUDGET),
    )
    .unwrap()
}

pub fn sampled(min: [f64; 3], max: [f64; 3], resolution: f64) -> ColumnStock {
    let options = ColumnOptions { mode: Mode::Sampled, ..ColumnOptions::new(resolution, BUDGET) };
    ColumnStock::new(Aabb { min: point(min), max: point(max) }, options).unwrap()
}

/// The floor at a place: the least height of the cutter's surface over many places of the path, and over many
/// more between the neighbours of the best ones. Never below the truth.
pub fn floor(cutter: &CutterProfile, curve: &Curve, [x, y]: [f64; 2], places: u32) -> f64 {
    const ROUNDS: u32 = 7;
    const BEST: usize = 3;
    let length = curve.length();
    let height = |s: f64| {
        let at = curve.point_at(s);
        at.z + cutter.height_at(libm::hypot(x - at.x, y - at.y))
    };
    let box_of = curve.bounds().expand(cutter.radius() + 1e-9);
    if x < box_of.min.x || x > box_of.max.x || y < box_of.min.y || y > box_of.max.y {
        return f64::INFINITY;
    }
    let places = if matches!(curve, Curve::Line(_)) { places / 4 } else { places };
    let mut found: Vec<(f64, f64)> = (0..=places)
        .map(|n| length * f64::from(n) / f64::from(places))
        .map(|s| (height(s), s))
        .collect();
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut least = found[0].0;
    for &(value, s) in found.iter().take(BEST) {
        if value == f64::INFINITY {
            break;
        }
        let (mut middle, mut width) = (s, length / f64::from(places));
        for _ in 0..ROUNDS {
            let around = (0..=20)
                .map(|n| (middle + width * (f64::from(n) / 10.0 - 1.0)).clamp(0.0, length))
                .map(|s| (height(s), s))
                .min_by(|a, b| a.0.total_cmp(&b.0));
            let Some((value, s)) = around else { break };
            least = least.min(value);
            (middle, width) = (s, width / 8.0);
        }
    }
    least
}

pub fn cutters() -> Vec<CutterProfile> {
    vec![
        CutterProfile::flat(4.0).unwrap(),
        CutterProfile::ball(4.0).unwrap(),
        CutterProfile::bull(4.0, 0.7).unwrap(),
        CutterProfile::pointed(4.0, 0.0, 118_f64.to_radians()).unwrap(),
        CutterProfile::pointed(4.0, 1.0, 90_f64.to_radians()).unwrap(),
        // A hollow outline, with a step.
        CutterProfile::outline(&[
            [0.0, 0.0],
            [0.5, 0.8],
            [0.9, 0.9],
            [1.4, 0.9],
            [1.5, 1.5],
            [4.0, 2.0],
        ])
        .unwrap(),
    ]
}
