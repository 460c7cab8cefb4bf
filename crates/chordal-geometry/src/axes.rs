//! How many axes there are, in which order arrays hold them, and their letters.

/// How many axes a machine may have.
pub const AXES: usize = 6;

/// One of each axis: X, Y and Z, then A, B and C, which turn about them.
pub type PerAxis<T> = [T; AXES];

/// The letters of the axes, in order.
pub const AXIS_LETTERS: &str = "XYZABC";

/// The same letters one by one.
pub const AXIS_NAMES: PerAxis<&str> = ["X", "Y", "Z", "A", "B", "C"];

const _: () = assert!(AXIS_LETTERS.len() == AXES);
