//! Random numbers that are the same in every run.

#![allow(dead_code, reason = "each test uses a part of this")]

/// A sequence of numbers from 0 to 1.
pub struct NumberSequence(pub u64);

impl NumberSequence {
    pub fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    pub fn below(&mut self, count: u32) -> u32 {
        (self.next() * f64::from(count)) as u32
    }

    pub fn one_of<T: Copy>(&mut self, among: &[T]) -> T {
        among[self.below(among.len() as u32) as usize]
    }
}
