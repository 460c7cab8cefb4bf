//! Polar end points: a radius and an angle in place of two coordinates (G16).

use chordal_command::Position;
use chordal_geometry::Plane;

use super::map::sin_cos_degrees;

/// What active polar coordinates (G16) remember from the last words.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct PolarReading {
    /// The last programmed angle, degrees; `None` before one.
    pub angle: Option<f64>,
    /// The point that radius and angle are measured from, mm; `None` for the work origin.
    pub pole: Option<[f64; 2]>,
}

/// The polar words of a statement.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct PolarWords {
    /// The radius, mm.
    pub radius: Option<f64>,
    /// The angle from the first axis of the plane to the second, degrees.
    pub angle: Option<f64>,
}

impl PolarReading {
    /// The end point on the axes of the plane, mm. In G91 a radius is measured from the present position, and
    /// an angle from the last one.
    pub fn target(
        &mut self,
        words: PolarWords,
        from: &Position,
        plane: Plane,
        incremental: bool,
    ) -> [f64; 2] {
        let (a, b, _) = plane.axes();
        let pole = match words.radius {
            Some(_) if incremental => [from[a], from[b]],
            _ => self.pole.unwrap_or_default(),
        };
        let center = self.pole.unwrap_or_default();
        let (x, y) = (from[a] - center[0], from[b] - center[1]);
        let present = libm::atan2(y, x).to_degrees();
        let radius = words.radius.unwrap_or_else(|| libm::hypot(x, y));
        let last = self.angle.unwrap_or(present);
        let angle = match words.angle {
            Some(angle) if incremental => last + angle,
            Some(angle) => angle,
            None if incremental => last,
            None => present,
        };
        self.angle = Some(angle);
        let (sin, cos) = sin_cos_degrees(angle);
        [pole[0] + radius * cos, pole[1] + radius * sin]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_radius_and_an_angle() {
        let mut polar = PolarReading::default();
        let words = |radius, angle| PolarWords { radius, angle };
        let mut at = [0.0; 6];
        let mut go = |words: PolarWords, incremental: bool| {
            let [x, y] = polar.target(words, &at, Plane::Xy, incremental);
            (at[0], at[1]) = (x, y);
            (x, y)
        };
        let near = |(x, y): (f64, f64), (u, v): (f64, f64)| {
            assert!((x - u).abs() < 1e-4 && (y - v).abs() < 1e-4, "{x} {y}");
        };
        near(go(words(Some(100.0), Some(30.0)), false), (86.6025, 50.0));
        near(go(words(None, Some(120.0)), true), (-86.6025, 50.0));
        near(go(words(Some(50.0), None), false), (-43.3013, 25.0));
    }
}
