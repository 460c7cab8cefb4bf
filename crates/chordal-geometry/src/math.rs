//! The only module with transcendental functions.
//!
//! The `sin` of the platform differs between machines in the last bit; that of `libm` does not, because it is plain
//! arithmetic. Square root and the four operations are correctly rounded by IEEE 754, so those of the standard library
//! are used.

pub(crate) use core::f64::consts::{FRAC_PI_2, PI, TAU};

/// Sine and cosine of an angle in radians, in that order.
pub(crate) fn sin_cos(angle: f64) -> (f64, f64) {
    libm::sincos(angle)
}

/// Sine and cosine of `quarters` quarter turns, in that order, each within 1e-15: faster than those of an angle, because
/// whole quarters are subtracted without rounding.
#[inline]
pub(crate) fn sin_cos_of_quarters(quarters: f64) -> (f64, f64) {
    // Adding and subtracting this rounds to the nearest whole number; the last bits of the sum are that number.
    const WHOLE: f64 = 6_755_399_441_055_744.0;
    // Up to this value the rounding is exact for the parts as well, which are sixteen times as many.
    const MAX_EXACT_COUNT: f64 = 1e14;
    const STEP: f64 = FRAC_PI_2 / PARTS as f64;
    if quarters.abs() >= MAX_EXACT_COUNT {
        return sin_cos(quarters * FRAC_PI_2);
    }
    let parts = quarters * PARTS as f64;
    let shifted = parts + WHOLE;
    let x = (parts - (shifted - WHOLE)) * STEP;
    let [sin, cos] = TURN[(shifted.to_bits() % TURN.len() as u64) as usize];
    // Within half a part the first terms of the series are accurate to a tenth of the last bit.
    let z = x * x;
    let sin_x = x + x * z * (-1.0 / 6.0 + z * (1.0 / 120.0 - z * (1.0 / 5040.0)));
    let below_one = z * (-0.5 + z * (1.0 / 24.0 - z * (1.0 / 720.0 - z * (1.0 / 40320.0))));
    (sin + (sin * below_one + cos * sin_x), cos + (cos * below_one - sin * sin_x))
}

/// The number of parts of a quarter turn with tabulated sine and cosine.
const PARTS: usize = 16;

/// Sine and cosine of each part of a turn.
const TURN: [[f64; 2]; 4 * PARTS] = {
    let mut turn = [[0.0; 2]; 4 * PARTS];
    let mut part = 0;
    while part < PARTS {
        let (sin, cos) = (SINES[part], SINES[PARTS - part]);
        turn[part] = [sin, cos];
        turn[part + PARTS] = [cos, -sin];
        turn[part + 2 * PARTS] = [-sin, -cos];
        turn[part + 3 * PARTS] = [-cos, sin];
        part += 1;
    }
    turn
};

/// Sines of the parts of a quarter turn, rounded once.
const SINES: [f64; PARTS + 1] = [
    0.0,
    0.098_017_140_329_560_6,
    0.195_090_322_016_128_28,
    0.290_284_677_254_462_4,
    0.382_683_432_365_089_8,
    0.471_396_736_825_997_64,
    0.555_570_233_019_602_2,
    0.634_393_284_163_645_5,
    core::f64::consts::FRAC_1_SQRT_2,
    0.773_010_453_362_737,
    0.831_469_612_302_545_2,
    0.881_921_264_348_355,
    0.923_879_532_511_286_7,
    0.956_940_335_732_208_8,
    0.980_785_280_403_230_4,
    0.995_184_726_672_196_9,
    1.0,
];

/// The value of a polynomial with an even number of coefficients, the constant first.
#[inline]
pub(crate) fn polynomial<const N: usize>(x: f64, factors: &[f64; N]) -> f64 {
    const { assert!(N >= 2 && N.is_multiple_of(2)) };
    // Evaluating even and odd powers separately halves the chain of dependent operations.
    let square = x * x;
    let (mut even, mut odd) = (factors[N - 2], factors[N - 1]);
    for pair in factors[..N - 2].rchunks_exact(2) {
        even = even * square + pair[0];
        odd = odd * square + pair[1];
    }
    even + odd * x
}

/// Angle of the vector `(x, y)` in radians, in `-π..=π`.
pub(crate) fn atan2(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

/// Arc tangent in radians.
pub(crate) fn atan(x: f64) -> f64 {
    libm::atan(x)
}

/// Arc sine in radians.
pub(crate) fn asin(x: f64) -> f64 {
    libm::asin(x)
}

/// Rounds up.
pub(crate) fn ceil(x: f64) -> f64 {
    libm::ceil(x)
}

/// Rounds to the nearest whole number, halves away from zero.
pub(crate) fn round(x: f64) -> f64 {
    libm::round(x)
}

/// `e^x − 1` without cancellation near zero.
pub(crate) fn exp_m1(x: f64) -> f64 {
    libm::expm1(x)
}

/// `ln(1 + x)` without cancellation near zero.
pub(crate) fn ln_1p(x: f64) -> f64 {
    libm::log1p(x)
}

/// The twelfth root.
pub(crate) fn twelfth_root(x: f64) -> f64 {
    libm::cbrt(x.sqrt().sqrt())
}

/// Hyperbolic sine.
pub(crate) fn sinh(x: f64) -> f64 {
    libm::sinh(x)
}

/// Inverse hyperbolic sine.
pub(crate) fn asinh(x: f64) -> f64 {
    libm::asinh(x)
}

/// `asinh(y) / y`, continued by its limit 1 at zero.
pub(crate) fn asinh_ratio(y: f64) -> f64 {
    // Below this the first dropped term, 0.022·y¹⁰, is under 2e-17.
    const SERIES_BELOW: f64 = 0.03;
    if y.abs() < SERIES_BELOW {
        let q = y * y;
        1.0 - q * (1.0 / 6.0 - q * (3.0 / 40.0 - q * (15.0 / 336.0 - q * (105.0 / 3456.0))))
    } else {
        libm::asinh(y) / y
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarters_have_the_sine_of_their_angle() {
        let mut quarters = -40.0;
        while quarters < 40.0 {
            let (sin, cos) = sin_cos_of_quarters(quarters);
            // By the angle that is left when whole quarters are taken off: exact, as they differ
            // by less than a half.
            let whole = quarters.round();
            let (s, c) = sin_cos((quarters - whole) * FRAC_PI_2);
            let (exact_sin, exact_cos) = match whole.rem_euclid(4.0) {
                0.0 => (s, c),
                1.0 => (c, -s),
                2.0 => (-s, -c),
                _ => (-c, s),
            };
            assert!((sin - exact_sin).abs() <= 2.3e-16, "{quarters}: {sin} {exact_sin}");
            assert!((cos - exact_cos).abs() <= 2.3e-16, "{quarters}: {cos} {exact_cos}");
            assert!((sin * sin + cos * cos - 1.0).abs() <= 5e-16);
            quarters += 0.003_71;
        }
    }

    #[test]
    fn whole_quarters_are_exact() {
        for (quarters, sin, cos) in [
            (0.0, 0.0, 1.0),
            (1.0, 1.0, 0.0),
            (2.0, 0.0, -1.0),
            (3.0, -1.0, 0.0),
            (-1.0, -1.0, 0.0),
            (4e9 + 1.0, 1.0, 0.0),
        ] {
            assert_eq!(sin_cos_of_quarters(quarters), (sin, cos), "{quarters}");
        }
    }

    #[test]
    fn odd_numbers_of_quarters_give_no_panic() {
        for quarters in [1e15, -1e15, 1e18, 1e300] {
            let (sin, cos) = sin_cos_of_quarters(quarters);
            assert!((sin * sin + cos * cos - 1.0).abs() < 1e-14);
        }
        for quarters in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let (sin, cos) = sin_cos_of_quarters(quarters);
            assert!(sin.is_nan() && cos.is_nan());
        }
    }
}
