//! The local corrections that take a step out of the direction or of the curvature of a path.
//!
//! Both are polynomials of the third degree between their breaks and zero outside, so that the
//! path is exact beyond them. Added to the path, multiplied by the step, they make its second
//! derivative continuous.
//!
//! A step of **direction** is a step Δ of the first derivative. Its second derivative, an impulse, becomes a
//! hat of half width h: `(h − |w|)³/(6h²)`, which leaves the path by |Δ|·h/6 at most.
//!
//! A step of **curvature** is a step C of the second derivative, as where a line meets an arc. The step
//! becomes a ramp that overshoots a little, so that the path beyond is met again in place and
//! direction: slope +1/(2(2p−1)h) within ±p·h and minus that outside, with 2p³ = 1. It leaves the
//! path by 0.01452·|C|·h² at most.

/// Where the slope of the ramp of a step of curvature turns, as a share of its half width: 2^(−1/3).
pub const RAMP_TURN_SHARE: f64 = 0.793_700_525_984_099_7;

/// Slope of the ramp of a step of curvature, over its half width.
pub const RAMP_SLOPE: f64 = 0.5 / (2.0 * RAMP_TURN_SHARE - 1.0);

/// Largest deviation of a step of curvature with C = 1 and h = 1; see the test.
pub const CURVATURE_DEVIATION: f64 = 0.014_53;

/// Largest deviation of a step of direction with Δ = 1 and h = 1.
pub const DIRECTION_DEVIATION: f64 = 1.0 / 6.0;

/// A value and its first three derivatives.
pub type BlendJet = [f64; 4];

/// The correction of a step of direction at `w` from it; `side` is negative before the step, and decides
/// which polynomial is meant where both meet.
#[inline]
pub fn direction_blend(w: f64, side: f64, h: f64) -> BlendJet {
    let sign = if side < 0.0 { 1.0 } else { -1.0 };
    let (r, k) = (h + sign * w, 1.0 / (h * h));
    [r * r * r * k / 6.0, sign * r * r * k / 2.0, r * k, sign * k]
}

/// The correction of a step of curvature at `w` from it; `middle` is a position inside the part between two
/// breaks that is meant.
#[inline]
pub fn curvature_blend(w: f64, middle: f64, h: f64) -> BlendJet {
    if middle > 0.0 {
        let [e0, e1, e2, e3] = curvature_blend(-w, -middle, h);
        return [-e0, e1, -e2, e3];
    }
    let slope = RAMP_SLOPE / h;
    if middle < -RAMP_TURN_SHARE * h {
        let r = w + h;
        return [-slope * r * r * r / 6.0, -slope * r * r / 2.0, -slope * r, -slope];
    }
    let (b, y) = ((1.0 - RAMP_TURN_SHARE) * h, w + RAMP_TURN_SHARE * h);
    [
        slope * (-b * b * b / 6.0 - b * b * y / 2.0 - b * y * y / 2.0 + y * y * y / 6.0),
        slope * (-b * b / 2.0 - b * y + y * y / 2.0),
        slope * (y - b),
        slope,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curvature_blend_at(w: f64) -> BlendJet {
        curvature_blend(w, w, 1.0)
    }

    #[test]
    fn bends_vanish_outside_and_are_continuous() {
        for (at, step) in
            [(-1.0, 0.0), (-RAMP_TURN_SHARE, 0.0), (RAMP_TURN_SHARE, 0.0), (1.0, 0.0), (0.0, -1.0)]
        {
            let left = if at > -1.0 { curvature_blend(at, at - 1e-9, 1.0) } else { [0.0; 4] };
            let right = if at < 1.0 { curvature_blend(at, at + 1e-9, 1.0) } else { [0.0; 4] };
            for order in 0..3 {
                let jump = if order == 2 { step } else { 0.0 };
                assert!((right[order] - left[order] - jump).abs() < 1e-12, "{at} {order}");
            }
        }
        let farthest = (0..=100_000)
            .map(|i| curvature_blend_at(-1.0 + f64::from(i) / 50_000.0)[0].abs())
            .fold(0.0, f64::max);
        assert!(
            farthest <= CURVATURE_DEVIATION && farthest > 0.999 * CURVATURE_DEVIATION,
            "{farthest}"
        );
    }

    #[test]
    fn kinks_vanish_outside_and_take_the_step_away() {
        let h = 0.3;
        assert_eq!(direction_blend(0.0, -1.0, h)[0], direction_blend(0.0, 1.0, h)[0]);
        assert!(
            (direction_blend(0.0, 1.0, h)[1] - direction_blend(0.0, -1.0, h)[1] + 1.0).abs()
                < 1e-12
        );
        for side in [-1.0, 1.0] {
            assert!(
                direction_blend(side * h, side, h)[..3].iter().all(|value| value.abs() < 1e-15)
            );
        }
        assert!((direction_blend(0.0, 1.0, h)[0] - DIRECTION_DEVIATION * h).abs() < 1e-15);
    }
}
