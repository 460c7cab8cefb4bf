//! The one door to transcendental functions: the same bits on every machine.

pub(crate) use core::f64::consts::{FRAC_PI_2, PI, TAU};

use chordal_geometry::Vec2;

pub(crate) fn sin(angle: f64) -> f64 {
    libm::sin(angle)
}

pub(crate) fn cos(angle: f64) -> f64 {
    libm::cos(angle)
}

pub(crate) fn tan(angle: f64) -> f64 {
    libm::tan(angle)
}

pub(crate) fn acos(x: f64) -> f64 {
    libm::acos(x)
}

pub(crate) fn atan(x: f64) -> f64 {
    libm::atan(x)
}

pub(crate) fn atan2(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

pub(crate) fn cbrt(x: f64) -> f64 {
    libm::cbrt(x)
}

pub(crate) fn sqrt(x: f64) -> f64 {
    libm::sqrt(x)
}

/// The unit vector in a direction.
pub(crate) fn unit(angle: f64) -> Vec2 {
    let (sin, cos) = libm::sincos(angle);
    Vec2::new(cos, sin)
}

/// An angle in `0..2π`.
pub(crate) fn turn(angle: f64) -> f64 {
    let rest = angle % TAU;
    if rest < 0.0 { rest + TAU } else { rest }
}
