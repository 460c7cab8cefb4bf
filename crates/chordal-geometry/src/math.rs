//! The one door to transcendental functions.
//!
//! The platform's `sin` differs between machines in the last bit; `libm` is plain arithmetic and
//! does not. Square root and the four operations are exact by IEEE 754, so the standard ones serve.

pub(crate) use core::f64::consts::{FRAC_PI_2, PI, TAU};

/// Sine and cosine of an angle in radians, in that order.
pub(crate) fn sin_cos(angle: f64) -> (f64, f64) {
    libm::sincos(angle)
}

/// Sine and cosine of `quarters` quarter turns, in that order, each within 1e-15: quicker than those of an
/// angle, because whole quarters are taken off without rounding.
#[inline]
pub(crate) fn sin_cos_of_quarters(quarters: f64) -> (f64, f64) {
    // Added and taken off again, this leaves the nearest whole number; its last bits count it.
    const WHOLE: f64 = 6_755_399_441_055_744.0;
    // Up to here that holds.
    const MOST: f64 = 1e15;
    if quarters.abs() >= MOST {
        return sin_cos(quarters * FRAC_PI_2);
    }
    let shifted = quarters + WHOLE;
    let x = (quarters - (shifted - WHOLE)) * FRAC_PI_2;
    let z = x * x;
    // Best polynomials within an eighth of a turn, as in every libm.
    let sin = x + x * z * polynomial(z, &SINE);
    let half = 0.5 * z;
    let near_one = 1.0 - half;
    let cos = near_one + ((1.0 - near_one) - half + z * z * polynomial(z, &COSINE));
    let count = shifted.to_bits();
    let (sin, cos) = if count & 1 == 0 { (sin, cos) } else { (cos, -sin) };
    let sign = (count & 2) << 62;
    (f64::from_bits(sin.to_bits() ^ sign), f64::from_bits(cos.to_bits() ^ sign))
}

const SINE: [f64; 6] = [
    -1.666_666_666_666_663_2e-1,
    8.333_333_333_322_49e-3,
    -1.984_126_982_985_795e-4,
    2.755_731_370_707_006_8e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];
const COSINE: [f64; 6] = [
    4.166_666_666_666_66e-2,
    -1.388_888_888_887_411e-3,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

/// The value of a polynomial, its constant first, of an even number of factors.
#[inline]
pub(crate) fn polynomial<const N: usize>(x: f64, factors: &[f64; N]) -> f64 {
    const { assert!(N >= 2 && N.is_multiple_of(2)) };
    // Even and odd powers by themselves wait half as long for one another.
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

/// The whole number above.
pub(crate) fn ceil(x: f64) -> f64 {
    libm::ceil(x)
}

/// The nearest whole number, halves away from zero.
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
