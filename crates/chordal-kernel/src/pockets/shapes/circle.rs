//! Circular pockets: full circles joined by tangent half circles, all in one direction.

use core::f64::consts::{PI, TAU};

use chordal_geometry::{TurnDirection, Vec2};

use super::Step;

/// A ring that misses the last one by less than this, mm, is the last one.
const RING_EPSILON_MM: f64 = 1e-9;

/// From the centre (the origin) by a half circle to the first radius, `turns` full circles
/// there, by a half circle to the opposite side of the next radius, and so on; a last half
/// circle leads back to the centre. Radii (mm) are those of the tool centre.
pub fn rings(radii: &[f64], turns: u32, direction: TurnDirection) -> Vec<Step> {
    let sign = direction.sign();
    let mut steps = Vec::with_capacity(radii.len() * (turns as usize + 1) + 1);
    let mut at = 0.0;
    let mut side = 1.0;
    let half = |from: f64, to: f64| Step::Arc {
        to: Vec2::new(to, 0.0),
        center: Vec2::new(0.5 * (from + to), 0.0),
        sweep: sign * PI,
    };
    for &radius in radii {
        let place = side * radius;
        steps.push(half(at, place));
        for _ in 0..turns {
            steps.push(Step::Arc {
                to: Vec2::new(place, 0.0),
                center: Vec2::ZERO,
                sweep: sign * TAU,
            });
        }
        at = place;
        side = -side;
    }
    if !radii.is_empty() {
        steps.push(half(at, 0.0));
    }
    steps
}

/// `first`, `first + step`, …, the last one exactly `last`, all mm. `None` when there would be
/// more than `limit` of them.
pub fn ring_radii(first: f64, step: f64, last: f64, limit: usize) -> Option<Vec<f64>> {
    let mut radii = vec![first];
    while *radii.last()? < last - RING_EPSILON_MM {
        if radii.len() >= limit {
            return None;
        }
        let next = first + step * radii.len() as f64;
        radii.push(if next > last - RING_EPSILON_MM { last } else { next });
    }
    Some(radii)
}
