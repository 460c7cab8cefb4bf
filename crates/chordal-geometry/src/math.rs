//! The one door to transcendental functions.
//!
//! The platform's `sin` differs between machines in the last bit; `libm` is plain arithmetic and
//! does not. Square root and the four operations are exact by IEEE 754, so the standard ones serve.

pub(crate) use core::f64::consts::{FRAC_PI_2, PI, TAU};

/// Sine and cosine of an angle in radians, in that order.
pub(crate) fn sin_cos(angle: f64) -> (f64, f64) {
    libm::sincos(angle)
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

/// `e^x − 1` without cancellation near zero.
pub(crate) fn exp_m1(x: f64) -> f64 {
    libm::expm1(x)
}

/// `ln(1 + x)` without cancellation near zero.
pub(crate) fn ln_1p(x: f64) -> f64 {
    libm::log1p(x)
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
