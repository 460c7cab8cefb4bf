//! Dense paths by formulas, as chords: curves in the manner of CAM output.

use std::f64::consts::TAU;

use chordal_motion::{CornerMode, MoveRequest};

use super::{cut, line};

/// A path as places, mm.
pub type Places = Vec<[f64; 3]>;

/// Places at `count` equal steps of a parameter from 0 to 1, rounded to so many decimals.
pub fn places(count: u32, decimals: Option<i32>, at: impl Fn(f64) -> [f64; 3]) -> Places {
    let round = |value: f64| match decimals {
        Some(decimals) => {
            let unit = 10f64.powi(decimals);
            (value * unit).round() / unit
        }
        None => value,
    };
    (0..=count).map(|i| at(f64::from(i) / f64::from(count)).map(round)).collect()
}

/// A lap of an ellipse with half axes of 30 and 10 mm.
pub fn ellipse(count: u32, decimals: Option<i32>) -> Places {
    places(count, decimals, |t| {
        let (sin, cos) = (t * TAU).sin_cos();
        [30.0 * cos, 10.0 * sin, 0.0]
    })
}

/// Turns of a circle.
pub fn circle(radius: f64, turns: f64, chord: f64, decimals: Option<i32>) -> Places {
    let count = (turns * TAU * radius / chord).round() as u32;
    places(count, decimals, |t| {
        let (sin, cos) = (t * TAU * turns).sin_cos();
        [radius * cos, radius * sin, 0.0]
    })
}

/// A spiral from radius 1 to 20 in ten turns, with even chords.
pub fn spiral(chord: f64) -> Places {
    by_length(chord, None, |t| {
        let radius = 1.0 + 19.0 * t;
        let (sin, cos) = (t * TAU * 10.0).sin_cos();
        [radius * cos, radius * sin, 0.0]
    })
}

/// A figure in polar coordinates.
pub fn polar(chord: f64, decimals: Option<i32>, radius: impl Fn(f64) -> f64) -> Places {
    by_length(chord, decimals, |t| {
        let angle = t * TAU;
        let (sin, cos) = angle.sin_cos();
        [radius(angle) * cos, radius(angle) * sin, 0.0]
    })
}

/// A star of five points, 26 mm and 14 mm.
pub fn star(chord: f64) -> Places {
    polar(chord, Some(4), |angle| 20.0 + 6.0 * (5.0 * angle).cos())
}

/// A trident.
pub fn trident(chord: f64) -> Places {
    polar(chord, Some(4), |angle| 18.0 + 9.0 * (3.0 * angle).cos() + 3.0 * (6.0 * angle).cos())
}

/// A sum of seven harmonics in space.
pub fn harmonics(chord: f64, decimals: i32, seed: u64) -> Places {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    let mut random = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let mut terms = [[[0.0; 2]; 7]; 3];
    for axis in &mut terms {
        for (index, term) in axis.iter_mut().enumerate() {
            let size = 20.0 / (1.0 + index as f64).powf(1.3);
            *term = [size * (2.0 * random() - 1.0), TAU * random()];
        }
    }
    by_length(chord, Some(decimals), |t| {
        std::array::from_fn(|axis| {
            let sum = |(index, [size, phase]): (usize, &[f64; 2])| {
                size * (TAU * t * (1.0 + index as f64) + phase).sin()
            };
            terms[axis].iter().enumerate().map(sum).sum()
        })
    })
}

/// Rows of chords along X, there and back, over a wavy ground with a ridge; each row is one chord of Y from the
/// last.
pub fn raster(rows: u32, length: f64, spacing: f64, chord: f64) -> Places {
    let count = (length / chord).round() as u32;
    let mut all: Places = Vec::new();
    for row in 0..rows {
        let y = spacing * f64::from(row);
        let mut line = places(count, Some(3), |t| {
            let x = length * t;
            let ground = 2.0 * (0.22 * x).sin() * (0.4 * y).cos();
            let ridge = (0.6 + 0.06 * y) * (-((x - 33.0) / 2.2).powi(2)).exp();
            [x, y, ground + ridge]
        });
        if row % 2 == 1 {
            line.reverse();
        }
        all.append(&mut line);
    }
    all
}

/// The same turned about Z.
pub fn turned(places: Places, degrees: f64) -> Places {
    let (sin, cos) = degrees.to_radians().sin_cos();
    places.into_iter().map(|[x, y, z]| [cos * x - sin * y, sin * x + cos * y, z]).collect()
}

/// Bends of one curvature each in chords, with corners of 80 to 180 degrees between them, in space; and the
/// numbers of the places at the corners.
pub fn bends(seed: u64, chord: f64, decimals: i32) -> (Places, Vec<usize>) {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    let mut random = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let unit = 10f64.powi(decimals);
    let (mut all, mut corners) = (Places::from([[0.0; 3]]), Vec::new());
    let (mut at, mut heading) = ([0.0_f64; 3], TAU * random());
    for run in 0..12 {
        if run > 0 {
            corners.push(all.len() - 1);
            let side = if random() < 0.5 { 1.0 } else { -1.0 };
            heading += side * (80.0 + 100.0 * random()).to_radians();
        }
        // A run may be one chord.
        let count = (40.0 * random() * random()) as u32 + 1;
        let curvature = if random() < 0.3 { 0.0 } else { 2.0 * (random() - 0.5) };
        let rise = random() - 0.5;
        for _ in 0..count {
            heading += curvature * chord;
            let (sin, cos) = heading.sin_cos();
            let step = [cos, sin, rise].map(|part| part * chord);
            at = std::array::from_fn(|axis| at[axis] + step[axis]);
            all.push(at.map(|value| (value * unit).round() / unit));
        }
    }
    (all, corners)
}

/// The butterfly, a rational B-spline of degree 3 that the literature on interpolators measures with:
/// 383 mm with many sharp bends.
pub fn butterfly(chord: f64) -> Places {
    by_length(chord, Some(4), |t| {
        let [x, y] = rational(t);
        [x, y, 0.0]
    })
}

/// X and Y of its control points, mm.
#[rustfmt::skip]
const BUTTERFLY: [[f64; 2]; 51] = [
    [54.493, 52.139], [55.507, 52.139], [56.082, 49.615], [56.780, 44.971], [69.575, 51.358],
    [77.786, 58.573], [90.526, 67.081], [105.973, 63.801], [100.400, 47.326], [94.567, 39.913],
    [92.369, 30.485], [83.440, 33.757], [91.892, 28.509], [89.444, 20.393], [83.218, 15.446],
    [87.621, 4.830], [80.945, 9.267], [79.834, 14.535], [76.074, 8.522], [70.183, 12.550],
    [64.171, 16.865], [59.993, 22.122], [55.680, 36.359], [56.925, 24.995], [59.765, 19.828],
    [54.493, 14.940], [49.220, 19.828], [52.060, 24.994], [53.305, 36.359], [48.992, 22.122],
    [44.814, 16.865], [38.802, 12.551], [32.911, 8.521], [29.152, 14.535], [28.040, 9.267],
    [21.364, 4.830], [25.768, 15.447], [19.539, 20.391], [17.097, 28.512], [25.537, 33.750],
    [16.602, 30.496], [14.199, 39.803], [8.668, 47.408], [3.000, 63.794], [18.465, 67.084],
    [31.197, 58.572], [39.411, 51.358], [52.204, 44.971], [52.904, 49.614], [53.478, 52.139],
    [54.492, 52.139],
];

/// The weights of its control points that are not one, by number.
const BUTTERFLY_WEIGHTS: [(usize, f64); 10] = [
    (3, 1.2),
    (11, 2.0),
    (14, 5.0),
    (15, 3.0),
    (17, 1.1),
    (33, 1.1),
    (35, 3.0),
    (36, 5.0),
    (39, 2.0),
    (47, 1.2),
];

/// Its knots between 0 and 1; those are fourfold.
#[rustfmt::skip]
const BUTTERFLY_KNOTS: [f64; 47] = [
    0.0083, 0.0150, 0.0361, 0.0855, 0.1293, 0.1509, 0.1931, 0.2273, 0.2435, 0.2561,
    0.2692, 0.2889, 0.3170, 0.3316, 0.3482, 0.3553, 0.3649, 0.3837, 0.4005, 0.4269,
    0.4510, 0.4660, 0.4891, 0.5000, 0.5109, 0.5340, 0.5489, 0.5731, 0.5994, 0.6163,
    0.6351, 0.6447, 0.6518, 0.6683, 0.6830, 0.7111, 0.7307, 0.7439, 0.7565, 0.7729,
    0.8069, 0.8491, 0.8707, 0.9145, 0.9639, 0.9850, 0.9917,
];

/// A place of the butterfly, by the algorithm of de Boor.
fn rational(t: f64) -> [f64; 2] {
    let knot = |index: usize| match index {
        0..=3 => 0.0,
        51.. => 1.0,
        inner => BUTTERFLY_KNOTS[inner - 4],
    };
    let weight = |index: usize| {
        BUTTERFLY_WEIGHTS.iter().find(|(at, _)| *at == index).map_or(1.0, |(_, weight)| *weight)
    };
    let span = 3 + BUTTERFLY_KNOTS.partition_point(|knot| *knot <= t);
    let mut points: [[f64; 3]; 4] = std::array::from_fn(|k| {
        let index = span - 3 + k;
        let ([x, y], w) = (BUTTERFLY[index], weight(index));
        [x * w, y * w, w]
    });
    for round in 1..=3 {
        for k in (round..=3).rev() {
            let (low, high) = (knot(span - 3 + k), knot(span + 1 + k - round));
            let share = (t - low) / (high - low);
            points[k] = std::array::from_fn(|row| {
                (1.0 - share) * points[k - 1][row] + share * points[k][row]
            });
        }
    }
    let [x, y, w] = points[3];
    [x / w, y / w]
}

/// Places at nearly even distances along a curve over a parameter from 0 to 1.
pub fn by_length(chord: f64, decimals: Option<i32>, at: impl Fn(f64) -> [f64; 3]) -> Places {
    const FINE: u32 = 200_000;
    let point = |i: u32| at(f64::from(i) / f64::from(FINE));
    let distance = |a: [f64; 3], b: [f64; 3]| {
        a.iter().zip(&b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
    };
    let mut lengths = vec![0.0];
    for i in 0..FINE {
        let last = lengths[lengths.len() - 1];
        lengths.push(last + distance(point(i), point(i + 1)));
    }
    let whole = lengths[lengths.len() - 1];
    let count = (whole / chord).round().max(1.0) as u32;
    places(count, decimals, |share| {
        let index = lengths.partition_point(|length| *length < share * whole);
        at(index as f64 / f64::from(FINE))
    })
}

/// Lines through places, passed within a tolerance.
pub fn moves(places: &[[f64; 3]], speed: f64, linear_mm: f64) -> Vec<MoveRequest> {
    let within = CornerMode::Joined { linear_mm, rotary_rad: 1e-4 };
    places
        .windows(2)
        .filter(|pair| pair[0] != pair[1])
        .enumerate()
        .map(|(tag, pair)| MoveRequest {
            tag: tag as u64,
            ..cut(line(pair[0], pair[1]), speed, within)
        })
        .collect()
}
