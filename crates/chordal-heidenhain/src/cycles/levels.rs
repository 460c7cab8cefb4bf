//! The levels at which a shape is cut.

use super::step::KlartextCycleFault;

/// More levels or rings than this are a mistake in the data.
pub const MAX_CUTS: f64 = 10_000.0;

/// From the surface down to the bottom by an infeed, mm; all at once for an infeed of 0.
///
/// # Errors
/// For an infeed that makes too many of them.
pub fn infeed_levels(
    surface: f64,
    bottom: f64,
    infeed: f64,
) -> Result<Vec<f64>, KlartextCycleFault> {
    let infeed = infeed.abs();
    let count = match infeed > 0.0 {
        true => ((surface - bottom) / infeed - 1e-9).ceil().max(1.0),
        false => 1.0,
    };
    if count > MAX_CUTS {
        let message = format!("an infeed of {infeed} mm makes {count} levels");
        return Err(KlartextCycleFault::BadValue(message));
    }
    let mut levels: Vec<f64> =
        (1..count as u32).map(|level| surface - f64::from(level) * infeed).collect();
    levels.push(bottom);
    Ok(levels)
}

/// How many parts of at most a length divide a distance, at least one.
///
/// # Errors
/// For a length that makes too many of them.
pub fn equal_parts(distance: f64, most: f64) -> Result<u32, KlartextCycleFault> {
    let count = match most > 0.0 {
        true => (distance / most - 1e-9).ceil().max(1.0),
        false => 1.0,
    };
    if count > MAX_CUTS {
        let message = format!("a stepover of {most} mm makes {count} cuts");
        return Err(KlartextCycleFault::BadValue(message));
    }
    Ok(count as u32)
}
