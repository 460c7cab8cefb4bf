//! The floor under moves: by hand, by volume, against dense sampling, and laws that it must keep.

mod cells;
mod moves;
mod properties;
mod sampled;
mod sampler;
mod volumes;
mod worked;
