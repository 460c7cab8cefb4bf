//! The cube root, quick and the same on every machine.

/// The cube root of a number that is not negative, to two units in the last place.
#[inline]
pub fn cbrt(x: f64) -> f64 {
    if !(x > f64::MIN_POSITIVE && x < f64::INFINITY) {
        return if x > 0.0 && x < 1.0 { 0.0 } else { x };
    }
    // A third of the exponent is right to a twentieth; Halley's method triples the digits.
    const THIRD: u64 = 0x2a9f_7893_0000_0000;
    let mut y = f64::from_bits(x.to_bits() / 3 + THIRD);
    for _ in 0..3 {
        let cube = y * y * y;
        y *= (cube + 2.0 * x) / (2.0 * cube + x);
    }
    y
}

#[cfg(test)]
mod tests {
    use super::cbrt;

    #[test]
    fn cubes_have_roots() {
        let mut x = 1e-300;
        while x < 1e300 {
            let exact = libm::cbrt(x);
            assert!((cbrt(x) - exact).abs() <= 1e-15 * exact, "{x}: {} {exact}", cbrt(x));
            x *= 1.37;
        }
        assert_eq!(cbrt(0.0), 0.0);
        assert_eq!(cbrt(f64::INFINITY), f64::INFINITY);
        assert!(cbrt(f64::NAN).is_nan());
    }
}
