//! The number of axes, their order in arrays, and their letters.

/// The largest number of axes of a machine.
pub const AXES: usize = 6;

/// One value for each axis: X, Y and Z, then A, B and C, which turn about them.
pub type PerAxis<T> = [T; AXES];

/// The letters of the axes, in order.
pub const AXIS_LETTERS: &str = "XYZABC";

/// The same letters one by one.
pub const AXIS_NAMES: PerAxis<&str> = ["X", "Y", "Z", "A", "B", "C"];

const _: () = assert!(AXIS_LETTERS.len() == AXES);
