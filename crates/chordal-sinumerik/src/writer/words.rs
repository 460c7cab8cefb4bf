//! Numbers as part programs have them.

use chordal_kernel::{plain_number, significant_number};

/// Digits after the point of angles, degrees.
const ANGLE_DIGITS: usize = 6;

/// Digits after the point of feeds and speeds at most.
const MAX_FEED_DIGITS: usize = 12;

/// A feed or a speed.
pub(super) fn significant(value: f64) -> String {
    significant_number(value, MAX_FEED_DIGITS)
}

/// An angle, rad, as degrees.
pub(super) fn degrees(angle: f64) -> String {
    plain_number(angle.to_degrees(), ANGLE_DIGITS)
}
