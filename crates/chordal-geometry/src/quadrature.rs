//! Lengths of curves without a closed form, by Gauss quadrature on intervals that are divided until the results agree.

/// The positive nodes and the weights of Gauss quadrature with eight points on -1..1.
const RULE: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
];

/// The largest number of times an interval is divided: this ends the division at a cusp, with rounding or a NaN.
const MAX_DEPTH: u32 = 40;
/// The largest number of intervals.
const MAX_PARTS: u32 = 4000;

/// ∫f from `a` to `b` with eight points.
pub(crate) fn gauss(f: &mut impl FnMut(f64) -> f64, a: f64, b: f64) -> f64 {
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    let sum = RULE
        .iter()
        .map(|(x, share)| share * (f(middle - half * x) + f(middle + half * x)))
        .sum::<f64>();
    half * sum
}

/// ∫f from `a` to `b` within `tolerance`, estimated from the difference between an interval and its halves.
pub(crate) fn integral(f: &mut impl FnMut(f64) -> f64, a: f64, b: f64, tolerance: f64) -> f64 {
    let (mut sum, mut parts) = (0.0, 0);
    let mut open = vec![(a, b, gauss(f, a, b), tolerance, 0)];
    while let Some((a, b, whole, tolerance, depth)) = open.pop() {
        let middle = 0.5 * (a + b);
        let (before, after) = (gauss(f, a, middle), gauss(f, middle, b));
        let both = before + after;
        let near = (both - whole).abs() <= tolerance.max(32.0 * f64::EPSILON * both.abs());
        parts += 1;
        if near || depth >= MAX_DEPTH || parts >= MAX_PARTS || !both.is_finite() {
            sum += both;
        } else {
            let half = 0.5 * tolerance;
            open.push((middle, b, after, half, depth + 1));
            open.push((a, middle, before, half, depth + 1));
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_integrals() {
        // √x has no derivative at zero.
        let root = integral(&mut |x: f64| x.sqrt(), 0.0, 1.0, 1e-13);
        assert!((root - 2.0 / 3.0).abs() < 1e-12, "{root}");
        let power = gauss(&mut |x: f64| x.powi(15), 0.0, 1.0);
        assert!((power - 1.0 / 16.0).abs() < 1e-15, "{power}");
        assert!(integral(&mut |_| f64::NAN, 0.0, 1.0, 1e-13).is_nan());
    }
}
