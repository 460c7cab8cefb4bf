//! Rectangular pockets: rings with sharp corners from the middle line outwards.

use chordal_geometry::{TurnDirection, Vec2};

use super::Step;

/// Largest distance of two rings, in tool radii, that leaves no material between their corners: `1 + 1/√2`.
/// The tool cuts a round outside at the corner of the inner ring, so the corner of the next ring must be
/// nearer than a tool diameter.
pub const CORNER_STEP: f64 = 1.0 + core::f64::consts::FRAC_1_SQRT_2;

/// From the centre (the origin) along the middle line of the longer side, then ring by ring to the walls, then
/// straight back to the centre. `half` is half the size (mm) of the region of the tool centre, `step` (mm) the
/// largest distance of two rings. `None` when there would be more than `limit` rings.
pub fn rectangle(half: Vec2, step: f64, direction: TurnDirection, limit: u32) -> Option<Vec<Step>> {
    let upright = half.b > half.a;
    let (long, short) = if upright { (half.b, half.a) } else { (half.a, half.b) };
    let count = (short / step - 1e-9).ceil().max(0.0);
    if count > f64::from(limit) {
        return None;
    }
    let middle = long - short;
    // Computed with the long side along the first axis, counter-clockwise; then rotated and mirrored.
    let sign = direction.sign();
    let place = |u: f64, v: f64| {
        let v = sign * v;
        let to = if upright { Vec2::new(-v, u) } else { Vec2::new(u, v) };
        Step::Line { to }
    };
    let mut steps = Vec::new();
    if middle > 0.0 {
        steps.push(place(middle, 0.0));
        steps.push(place(-middle, 0.0));
    }
    for ring in 1..=count as u32 {
        let out = if f64::from(ring) == count { short } else { short * f64::from(ring) / count };
        let u = middle + out;
        steps.push(place(-u, 0.0));
        steps.push(place(-u, -out));
        steps.push(place(u, -out));
        steps.push(place(u, out));
        steps.push(place(-u, out));
        steps.push(place(-u, 0.0));
    }
    if !steps.is_empty() {
        steps.push(place(0.0, 0.0));
    }
    Some(steps)
}
