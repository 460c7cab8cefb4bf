//! Convex solids of revolution: the parts of a tool, and the quadric zones from which they are composed.

use std::f64::consts::{FRAC_PI_2, PI};

/// Steps of a quarter of a torus that is approximated by cones.
const QUARTER_STEPS: u32 = 8;

/// The convex hull of coaxial discs, thickened by a ball: a frustum, a ball, a disc with a round edge.
///
/// Heights are along the axis of the tool from a reference point on it, mm.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ConvexElement {
    /// The height of the reference point above the tip, mm.
    pub reference: f64,
    /// Height and radius of the discs, by ascending height; the radius is a concave function of the height.
    rims: Vec<[f64; 2]>,
    /// The radius of the ball, mm.
    round: f64,
    /// By how much the true solid may exceed the hull, mm.
    swell: f64,
    /// The largest height of what certainly is in the solid: an end of the tool across a ball.
    end: f64,
}

/// A solid of revolution: at the height h, from `from` to `to`, the square of its radius is α + β·h + γ·h². It is
/// convex.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct QuadricZone {
    pub square: [f64; 3],
    pub from: f64,
    pub to: f64,
}

impl QuadricZone {
    fn cone(radius_at_zero: f64, slope: f64, [mut from, mut to]: [f64; 2]) -> Option<QuadricZone> {
        // Only the part with a radius.
        let apex = -radius_at_zero / slope;
        if slope > 0.0 {
            from = from.max(apex);
        } else if slope < 0.0 {
            to = to.min(apex);
        } else if radius_at_zero < 0.0 {
            return None;
        }
        let square = [radius_at_zero * radius_at_zero, 2.0 * radius_at_zero * slope, slope * slope];
        (from < to).then_some(QuadricZone { square, from, to })
    }
}

impl ConvexElement {
    /// A ball of a radius about a point of the axis, which has its end at a height; both heights above the tip, mm.
    pub fn ball(center: f64, radius: f64, end: f64) -> ConvexElement {
        let (rims, end) = (vec![[0.0, 0.0]], end - center);
        ConvexElement { reference: center, rims, round: radius, swell: 0.0, end }
    }

    /// A disc at a height above the tip, with a round edge of the minor radius `round`, mm.
    pub fn torus(height: f64, radius: f64, round: f64, end: f64) -> ConvexElement {
        let (rims, end) = (vec![[0.0, radius]], end - height);
        ConvexElement { reference: height, rims, round, swell: 0.0, end }
    }

    /// The hull of discs: height above the tip and radius, by ascending height; the radius a concave function of the
    /// height. The true solid exceeds it by at most `swell`, mm.
    pub fn chain(rims: &[[f64; 2]], swell: f64) -> ConvexElement {
        let [first, last] = [rims.first(), rims.last()].map(|rim| rim.map_or(0.0, |rim| rim[0]));
        let reference = 0.5 * (first + last);
        let rims = rims.iter().map(|[height, radius]| [height - reference, *radius]).collect();
        ConvexElement { reference, rims, round: 0.0, swell, end: f64::INFINITY }
    }

    /// The largest distance of a point of it from the reference point that counts when it turns about that, mm: a
    /// ball stays itself.
    pub fn reach(&self) -> f64 {
        let far = self.rims.iter().map(|[height, radius]| libm::hypot(*height, *radius));
        let own = far.fold(0.0, f64::max) + self.swell;
        if self.end < self.round { own + self.round } else { own }
    }

    /// The largest n·p of its points p relative to the reference point, for a vector n given by its component along
    /// the axis and that across it.
    pub fn support(&self, along: f64, across: f64) -> f64 {
        let rims = self.rims.iter().map(|[height, radius]| along * height + across * radius);
        let length = (along * along + across * across).sqrt();
        rims.fold(f64::NEG_INFINITY, f64::max) + (self.round + self.swell) * length
    }

    /// Zones that are certainly in the solid, at least `depth` from its surface, mm.
    pub fn inner(&self, depth: f64) -> Vec<QuadricZone> {
        let end = self.end - depth;
        match self.rims[..] {
            [[_, radius]] => {
                let round = self.round - depth;
                if round <= 0.0 {
                    return Vec::new();
                }
                if radius == 0.0 {
                    return ball_zone(round, end).into_iter().collect();
                }
                // Half a step more than the lower half, so that it overlaps with the cylinder above.
                let steps = 2 * QUARTER_STEPS - QUARTER_STEPS / 2;
                offset(&arc(radius, round, steps), 0.0, 0.0, end)
            }
            _ => offset(&self.rims, depth, depth, end),
        }
    }

    /// Zones that contain everything that is at most `margin` from the solid, mm.
    pub fn outer(&self, margin: f64) -> Vec<QuadricZone> {
        let margin = margin + self.swell;
        match self.rims[..] {
            [[_, radius]] => {
                let round = self.round + margin;
                if radius == 0.0 {
                    return ball_zone(round, f64::INFINITY).into_iter().collect();
                }
                let half_step = FRAC_PI_2 / f64::from(QUARTER_STEPS) / 2.0;
                let around = arc(radius, round / libm::cos(half_step), 2 * QUARTER_STEPS);
                offset(&around, 0.0, 0.0, f64::INFINITY)
            }
            _ => offset(&self.rims, -margin, -margin, f64::INFINITY),
        }
    }
}

fn ball_zone(radius: f64, end: f64) -> Option<QuadricZone> {
    let to = radius.min(end);
    (to > -radius).then_some(QuadricZone {
        square: [radius * radius, 0.0, -1.0],
        from: -radius,
        to,
    })
}

/// Points of a circle of the radius `round` about the height 0 and the radius `middle`, from below outwards and up.
fn arc(middle: f64, round: f64, steps: u32) -> Vec<[f64; 2]> {
    let point = |n: u32| {
        let (sine, cosine) = libm::sincos(PI * f64::from(n) / f64::from(2 * QUARTER_STEPS));
        [-round * cosine, middle + round * sine]
    };
    (0..=steps).map(point).collect()
}

/// The zones of a concave chain of rims whose sides move inwards by `depth`, and whose ends by `ends`; nothing of
/// them is above `end`. Negative depths move outwards.
fn offset(rims: &[[f64; 2]], depth: f64, ends: f64, end: f64) -> Vec<QuadricZone> {
    let (Some(first), Some(last)) = (rims.first(), rims.last()) else { return Vec::new() };
    let lines: Vec<[f64; 2]> = rims
        .windows(2)
        .filter(|pair| pair[1][0] > pair[0][0])
        .map(|pair| {
            let slope = (pair[1][1] - pair[0][1]) / (pair[1][0] - pair[0][0]);
            let at_zero = pair[0][1] - slope * pair[0][0];
            [at_zero - depth * (1.0 + slope * slope).sqrt(), slope]
        })
        .collect();
    let all = [first[0] + ends, (last[0] - ends).min(end)];
    let zone = |(n, &[at_zero, slope]): (usize, &[f64; 2])| {
        let mut range = all;
        for (other, &[of_other, steep]) in lines.iter().enumerate() {
            // Where this line is not above the other one.
            let meets = (of_other - at_zero) / (slope - steep);
            if slope > steep {
                range[1] = range[1].min(meets);
            } else if slope < steep {
                range[0] = range[0].max(meets);
            } else if of_other < at_zero || of_other == at_zero && other < n {
                return None;
            }
        }
        QuadricZone::cone(at_zero, slope, range)
    };
    lines.iter().enumerate().filter_map(zone).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn radius(zones: &[QuadricZone], height: f64) -> Option<f64> {
        let at = |zone: &&QuadricZone| (zone.from..=zone.to).contains(&height);
        let square = |zone: &QuadricZone| {
            let [a, b, c] = zone.square;
            a + b * height + c * height * height
        };
        zones.iter().find(at).map(|zone| square(zone).max(0.0).sqrt())
    }

    #[test]
    fn a_cone_on_a_cylinder_is_offset_to_both_sides() {
        let element = ConvexElement::chain(&[[0.0, 0.0], [3.0, 4.0], [10.0, 4.0]], 0.0);
        let at = |zones: &[QuadricZone], height: f64| radius(zones, height - element.reference);
        let inner = element.inner(0.5);
        assert!((at(&inner, 5.0).unwrap() - 3.5).abs() < 1e-12);
        // The side of the cone rises 4 per 3: half a millimetre across it is 5/6 along the radius.
        let expected = 2.0 * 4.0 / 3.0 - 0.5 * 5.0 / 3.0;
        assert!((at(&inner, 2.0).unwrap() - expected).abs() < 1e-12);
        assert_eq!(at(&inner, 9.6), None);
        let outer = element.outer(0.5);
        assert!((at(&outer, 10.4).unwrap() - 4.5).abs() < 1e-12);
        assert!(at(&outer, -0.4).is_some() && at(&outer, -0.6).is_none());
        // The corner of the disc at height 4, seen across the axis.
        assert!((element.support(0.0, 2.0) - 8.0).abs() < 1e-12);
    }

    #[test]
    fn a_round_edge_is_between_its_zones() {
        let element = ConvexElement::torus(2.0, 3.0, 2.0, 30.0);
        for n in 0..=20 {
            let height = -1.99 + 0.1 * f64::from(n);
            let truth = 3.0 + (4.0 - height * height).sqrt();
            let [inner, outer] =
                [element.inner(0.0), element.outer(0.0)].map(|zones| radius(&zones, height));
            let (inner, outer) = (inner.unwrap(), outer.unwrap());
            assert!(inner <= truth + 1e-12 && truth <= outer + 1e-12, "{height}");
            assert!(outer - inner < 0.2, "{height} {inner} {outer}");
        }
    }
}
