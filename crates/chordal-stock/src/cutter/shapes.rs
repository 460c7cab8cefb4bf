//! Makes cutters of the usual shapes from their dimensions.

use libm::tan;

use super::{CutterError, CutterProfile, Ring, RingElement};

pub(super) fn positive(what: &'static str, value: f64) -> Result<f64, CutterError> {
    if value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(CutterError::NotPositive { what, value })
    }
}

pub(super) fn at_most(what: &'static str, value: f64, most: f64) -> Result<f64, CutterError> {
    if value <= most { Ok(value) } else { Err(CutterError::TooLarge { what, value, most }) }
}

impl CutterProfile {
    /// A flat end mill of a diameter, mm.
    ///
    /// # Errors
    /// When the diameter is not above zero.
    pub fn flat(diameter: f64) -> Result<CutterProfile, CutterError> {
        let to = positive("diameter", diameter)? / 2.0;
        Ok(CutterProfile::of(vec![Ring {
            from: 0.0,
            to,
            element: RingElement::Disc { height: 0.0 },
        }]))
    }

    /// A ball end mill of a diameter, mm.
    ///
    /// # Errors
    /// When the diameter is not above zero.
    pub fn ball(diameter: f64) -> Result<CutterProfile, CutterError> {
        let to = positive("diameter", diameter)? / 2.0;
        let element = RingElement::Torus { height: 0.0, round: to, middle: 0.0 };
        Ok(CutterProfile::of(vec![Ring { from: 0.0, to, element }]))
    }

    /// A bull nose end mill: a flat end with a corner radius, mm.
    ///
    /// # Errors When a dimension is not above zero, or the corner radius is larger than the radius.
    pub fn bull(diameter: f64, corner_radius: f64) -> Result<CutterProfile, CutterError> {
        let to = positive("diameter", diameter)? / 2.0;
        let round = at_most("corner radius", positive("corner radius", corner_radius)?, to)?;
        let middle = to - round;
        let mut rings = Vec::new();
        if middle > 0.0 {
            rings.push(Ring { from: 0.0, to: middle, element: RingElement::Disc { height: 0.0 } });
        }
        rings.push(Ring {
            from: middle,
            to,
            element: RingElement::Torus { height: 0.0, round, middle },
        });
        Ok(CutterProfile::of(rings))
    }

    /// A point with an included angle (rad) up to a diameter, with a flat of `tip_diameter` at its end, mm: drills,
    /// countersinks and chamfer mills.
    ///
    /// # Errors When the diameter or the angle is not above zero, the angle is more than half a turn, or the flat is
    /// wider than the cutter.
    pub fn pointed(
        diameter: f64,
        tip_diameter: f64,
        angle: f64,
    ) -> Result<CutterProfile, CutterError> {
        let to = positive("diameter", diameter)? / 2.0;
        let half = positive("point angle", angle)? / 2.0;
        at_most("point angle", angle, std::f64::consts::PI)?;
        let from = at_most("tip diameter", tip_diameter.max(0.0), diameter)? / 2.0;
        let mut rings = Vec::new();
        if from > 0.0 {
            rings.push(Ring { from: 0.0, to: from, element: RingElement::Disc { height: 0.0 } });
        }
        if from < to {
            let element = RingElement::Cone { height: 0.0, slope: 1.0 / tan(half) };
            rings.push(Ring { from, to, element });
        }
        Ok(CutterProfile::of(rings))
    }

    /// A cutter by its outline: points of height above the tip and radius, mm, from the axis outwards and upwards.
    /// Where the first point has a radius above zero, the end is flat.
    ///
    /// # Errors When a number is negative or not finite, or the outline comes nearer to the axis on its way up.
    pub fn outline(points: &[[f64; 2]]) -> Result<CutterProfile, CutterError> {
        let mut rings: Vec<Ring> = Vec::new();
        let mut last = [points.first().map_or(0.0, |point| point[0]), 0.0];
        for &[height, radius] in points {
            for (what, value) in [("height", height), ("radius", radius)] {
                if value.is_nan() || value < 0.0 || value.is_infinite() {
                    return Err(CutterError::NotPositive { what, value });
                }
            }
            if radius < last[1] || height < last[0] {
                return Err(CutterError::Undercut { height });
            }
            if radius > last[1] {
                let slope = (height - last[0]) / (radius - last[1]);
                let element = if slope > 0.0 {
                    RingElement::Cone { height: last[0], slope }
                } else {
                    RingElement::Disc { height: last[0] }
                };
                rings.push(Ring { from: last[1], to: radius, element });
            }
            last = [height, radius];
        }
        positive("radius", last[1])?;
        Ok(CutterProfile::of(rings))
    }

    pub(super) fn of(rings: Vec<Ring>) -> CutterProfile {
        CutterProfile { rings, flutes: None }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_of_the_usual_shapes() {
        let bull = CutterProfile::bull(10.0, 2.0).unwrap();
        assert_eq!(bull.height_at(2.9), 0.0);
        assert!((bull.height_at(5.0) - 2.0).abs() < 1e-12);
        assert!((bull.height_at(4.0) - (2.0 - 3.0_f64.sqrt())).abs() < 1e-12);
        assert_eq!(bull.height_at(5.1), f64::INFINITY);
        let ball = CutterProfile::ball(10.0).unwrap();
        assert!((ball.height_at(3.0) - 1.0).abs() < 1e-12);
        let drill = CutterProfile::pointed(10.0, 0.0, 118.0_f64.to_radians()).unwrap();
        assert!((drill.side() - 3.004_303).abs() < 1e-6);
        for cutter in [bull, ball, drill, CutterProfile::flat(3.0).unwrap()] {
            assert!(cutter.is_convex());
        }
    }

    #[test]
    fn an_outline_may_be_hollow_but_not_undercut() {
        let hollow = CutterProfile::outline(&[[0.0, 0.0], [2.0, 1.0], [2.5, 3.0]]).unwrap();
        assert!(!hollow.is_convex());
        assert_eq!(hollow.height_at(2.0), 2.25);
        assert!(CutterProfile::outline(&[[0.0, 2.0], [1.0, 1.0]]).is_err());
        assert!(CutterProfile::outline(&[]).is_err());
        assert!(CutterProfile::flat(f64::NAN).is_err());
    }
}
