//! Light on a picture of depths: steps of columns are seen as the slope that they make together.

use chordal::geometry::Vec3;

/// A window over pixels reaches so many columns to each side.
const WINDOW_COLUMNS: f64 = 1.5;
/// Where pixels that lie next to each other differ by more columns the surface ends.
const ENDS: f64 = 2.5;

/// How near to the eye each pixel is, mm; minus infinity where nothing is.
pub(super) struct DepthBuffer<'a> {
    pub near: &'a [f64],
    pub width: usize,
    /// The side of a column, mm.
    pub column: f64,
    /// The side of a pixel, mm.
    pub pixel: f64,
}

impl DepthBuffer<'_> {
    /// The direction that each pixel of the surface has, on the sheet: to the right, up, to the eye.
    pub fn normals(&self) -> Vec<Vec3> {
        let across = self.smoothed(self.near, 1);
        let smooth = self.smoothed(&across, self.width);
        let normal = |at: usize| {
            let slope = |step: usize| self.slope(&smooth, at, step);
            // Rows go down on the sheet.
            Vec3::new(-slope(1), slope(self.width), 1.0).normalized().unwrap_or(Vec3::Z)
        };
        (0..self.near.len()).map(normal).collect()
    }

    fn reach(&self) -> usize {
        (WINDOW_COLUMNS * self.column / self.pixel).round().clamp(1.0, 64.0) as usize
    }

    /// The sum of depths on one side of a pixel as far as the surface goes on, and how many there are.
    fn sum_along(&self, depths: &[f64], at: usize, step: usize, forward: bool) -> (f64, usize) {
        let most = ENDS * self.column;
        let along = if step == 1 { at % self.width } else { at / self.width };
        let last = if step == 1 { self.width } else { depths.len() / self.width } - 1;
        let room = if forward { last - along } else { along };
        let (mut sum, mut count, mut before) = (0.0, 0, depths[at]);
        for number in 1..=self.reach().min(room) {
            let place = if forward { at + number * step } else { at - number * step };
            let depth = depths[place];
            if (depth - before).abs() <= most {
                (sum, count, before) = (sum + depth, count + 1, depth);
            } else {
                break;
            }
        }
        (sum, count)
    }

    /// Each depth with those along a direction.
    fn smoothed(&self, depths: &[f64], step: usize) -> Vec<f64> {
        let smooth = |at: usize| {
            let [(a, m), (b, n)] = [false, true].map(|side| self.sum_along(depths, at, step, side));
            if depths[at].is_finite() {
                (depths[at] + a + b) / (1 + m + n) as f64
            } else {
                depths[at]
            }
        };
        (0..depths.len()).map(smooth).collect()
    }

    /// How the depth rises along a direction.
    fn slope(&self, depths: &[f64], at: usize, step: usize) -> f64 {
        let ends = [false, true].map(|side| self.sum_along(depths, at, step, side));
        let mean = |(sum, count): (f64, usize)| {
            if count > 0 { sum / count as f64 } else { depths[at] }
        };
        let far = |(_, count): (f64, usize)| if count > 0 { 0.5 * (count + 1) as f64 } else { 0.0 };
        let distance = (far(ends[0]) + far(ends[1])) * self.pixel;
        if distance > 0.0 { (mean(ends[1]) - mean(ends[0])) / distance } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_have_the_slope_that_they_make_together() {
        // Columns of 4 pixels, each a millimetre nearer than the one before; at the right nothing, at the left a wall.
        let (width, height) = (40, 30);
        let depth = |at: usize| match at % width {
            x if x < 4 => -50.0,
            x if x > 35 => f64::NEG_INFINITY,
            x => (x / 4) as f64,
        };
        let near: Vec<f64> = (0..width * height).map(depth).collect();
        let normals = DepthBuffer { near: &near, width, column: 1.0, pixel: 0.25 }.normals();
        let expected = Vec3::new(-1.0, 0.0, 1.0).normalized().unwrap();
        for at in (14..28).map(|x| 15 * width + x) {
            assert!(normals[at].distance(expected) < 0.1, "{:?}", normals[at]);
        }
        assert!(normals.iter().all(|normal| normal.is_finite()));
    }
}
