//! The only module of this crate with transcendental functions, and rotations of vectors.
//!
//! They come from `libm`, so that the same chain gives the same bits on every machine.

use core::f64::consts::{PI, TAU};

use chordal_geometry::Vec3;

/// Sine and cosine of an angle in radians, in that order.
pub(crate) fn sin_cos(angle: f64) -> (f64, f64) {
    libm::sincos(angle)
}

/// Sine of an angle in radians.
pub(crate) fn sin(angle: f64) -> f64 {
    libm::sin(angle)
}

/// Angle of the vector `(x, y)` in radians, in `-π..=π`.
pub(crate) fn atan2(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

/// The angle between two vectors, rad, in `0..=π`: accurate near 0 and π, where an arc cosine is not.
pub(crate) fn angle_between(a: Vec3, b: Vec3) -> f64 {
    atan2(a.cross(b).length(), a.dot(b))
}

/// The vector turned by `angle` (rad) about a unit vector, by the right-hand rule.
pub(crate) fn rotated(v: Vec3, about: Vec3, angle: f64) -> Vec3 {
    if angle == 0.0 {
        return v;
    }
    let (sin, cos) = sin_cos(angle);
    let along = about * v.dot(about);
    along + (v - along) * cos + about.cross(v) * sin
}

/// The angle less whole turns, rad, in `-π..=π`.
pub(crate) fn within_half_turn(angle: f64) -> f64 {
    if angle.abs() < PI {
        return angle;
    }
    angle - TAU * libm::round(angle / TAU)
}

/// The angle plus the whole turns that bring it nearest to another one, rad.
pub(crate) fn nearest_turn(angle: f64, other: f64) -> f64 {
    angle + TAU * libm::round((other - angle) / TAU)
}

/// Rounds down.
pub(crate) fn floor(x: f64) -> f64 {
    libm::floor(x)
}

/// Rounds up.
pub(crate) fn ceil(x: f64) -> f64 {
    libm::ceil(x)
}
/// An angle in degrees for a message: three decimals, or the power of ten of less than that.
pub(crate) fn degrees_text(rad: f64) -> String {
    let degrees = rad.to_degrees();
    let text = format!("{degrees:.3}");
    match text.trim_end_matches('0').trim_end_matches('.') {
        "0" | "-0" if degrees != 0.0 => format!("{degrees:.0e}"),
        text => text.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn degrees_are_rounded_to_what_says_something() {
        let texts = [10.000_000_000_000_002_f64, 33.130_102, 0.5, 1e-6, 0.0];
        let texts = texts.map(|degrees| degrees_text(degrees.to_radians()));
        assert_eq!(texts, ["10", "33.13", "0.5", "1e-6", "0"]);
    }
}
