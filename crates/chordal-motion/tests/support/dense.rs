//! Dense paths by formulas, as chords: curves in the manner of CAM output.

use std::f64::consts::TAU;

use chordal_motion::{Corner, Move};

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
pub fn moves(places: &[[f64; 3]], speed: f64, linear_mm: f64) -> Vec<Move> {
    let within = Corner::Within { linear_mm, rotary_rad: 1e-4 };
    places
        .windows(2)
        .filter(|pair| pair[0] != pair[1])
        .enumerate()
        .map(|(tag, pair)| Move { tag: tag as u64, ..cut(line(pair[0], pair[1]), speed, within) })
        .collect()
}
