//! The shapes of parts in four lanes: their heights, and where on a slope they touch lowest.

use wide::{CmpGt, CmpLt, f32x4};

use super::{BodyPart, PartShape};

const ZERO: f32x4 = f32x4::ZERO;
/// Lower bound of divisors.
const MIN_DIVISOR: f32x4 = f32x4::new([1e-12; 4]);

/// The shape of a part. Radii and heights are in mm; heights are above the core.
pub(crate) trait PartKind: Copy {
    /// Whether it has no height outside its core.
    const IS_FLAT: bool = false;

    /// The height at distances from the axis, given as squares, without `base`.
    fn height(&self, square: f32x4) -> f32x4;

    /// Upper bound of the height at these distances increased by `grow`, without `base`.
    fn height_beyond(&self, square: f32x4, grow: f32x4) -> f32x4;

    /// The constant part of the height.
    #[inline(always)]
    fn base(&self) -> f32x4 {
        ZERO
    }

    /// How far behind a column's foot on the piece the lowest contact is (ahead where the slope falls), at the
    /// distance e from the piece: `square` is e², `room` is √(reach² − e²).
    fn contact(&self, e: f32x4, square: f32x4, room: f32x4) -> f32x4;

    /// The least and the largest contact for a range of distances; by default it falls with the distance.
    #[inline(always)]
    fn contacts(&self, near: f32x4, far: f32x4, reach_square: f32x4) -> [f32x4; 2] {
        [far, near].map(|e| {
            let square = e * e;
            self.contact(e, square, (reach_square - square).fast_max(ZERO).sqrt())
        })
    }
}

/// A disc.
#[derive(Clone, Copy)]
pub(crate) struct FlatPart;

impl PartKind for FlatPart {
    const IS_FLAT: bool = true;

    #[inline(always)]
    fn height(&self, _square: f32x4) -> f32x4 {
        ZERO
    }

    #[inline(always)]
    fn height_beyond(&self, _square: f32x4, _grow: f32x4) -> f32x4 {
        ZERO
    }

    #[inline(always)]
    fn contact(&self, _e: f32x4, _square: f32x4, room: f32x4) -> f32x4 {
        room
    }
}

/// A cone about a core, on a slope. It touches at `lean`·e; where the slope is steeper than the cone it touches at
/// its rim, and `steep` is then beyond any reach (otherwise zero).
#[derive(Clone, Copy)]
pub(crate) struct ConePart {
    slope: f32x4,
    core: f32x4,
    core_square: f32x4,
    lean: f32x4,
    steep: f32x4,
}

impl PartKind for ConePart {
    #[inline(always)]
    fn height(&self, square: f32x4) -> f32x4 {
        self.height_beyond(square, ZERO)
    }

    #[inline(always)]
    fn height_beyond(&self, square: f32x4, grow: f32x4) -> f32x4 {
        self.slope * (square.sqrt() + grow - self.core).fast_max(ZERO)
    }

    #[inline(always)]
    fn contact(&self, e: f32x4, square: f32x4, room: f32x4) -> f32x4 {
        let edge = (self.core_square - square).fast_max(ZERO).sqrt();
        (self.lean * e).fast_max(edge).fast_max(self.steep).fast_min(room)
    }

    #[inline(always)]
    fn contacts(&self, near: f32x4, far: f32x4, reach_square: f32x4) -> [f32x4; 2] {
        // The contact on the cone grows with the distance, those on the edge of the core and on the rim shrink.
        [(near, far), (far, near)].map(|(lean, ends)| {
            let square = ends * ends;
            let room = (reach_square - square).fast_max(ZERO).sqrt();
            let edge = (self.core_square - square).fast_max(ZERO).sqrt();
            (self.lean * lean).fast_max(edge).fast_max(self.steep).fast_min(room)
        })
    }
}

/// Half a ball.
#[derive(Clone, Copy)]
pub(crate) struct BallPart {
    round: f32x4,
    round_square: f32x4,
    /// |slope| / √(1 + slope²).
    sine: f32x4,
    /// 2·round: (r + g)² − r² is at most this times g, plus g².
    twice_round: f32x4,
}

impl PartKind for BallPart {
    #[inline(always)]
    fn height(&self, square: f32x4) -> f32x4 {
        -(self.round_square - square).fast_max(ZERO).sqrt()
    }

    #[inline(always)]
    fn base(&self) -> f32x4 {
        self.round
    }

    #[inline(always)]
    fn height_beyond(&self, square: f32x4, grow: f32x4) -> f32x4 {
        self.height(square + grow * (self.twice_round + grow))
    }

    #[inline(always)]
    fn contact(&self, _e: f32x4, _square: f32x4, room: f32x4) -> f32x4 {
        self.sine * room
    }
}

/// Part of a torus.
#[derive(Clone, Copy)]
pub(crate) struct RoundPart {
    round: f32x4,
    round_square: f32x4,
    middle: f32x4,
    core: f32x4,
    core_square: f32x4,
    /// The height of the core's edge on the torus, mm: zero where the torus begins at its lowest point.
    rise: f32x4,
    /// Slope, its square, and 1/(1 + slope²).
    slope: f32x4,
    slope_square: f32x4,
    cosine_square: f32x4,
    /// The smallest sine of a contact, divided by its arm.
    least_share: f32x4,
    /// One over the whole radius.
    inverse: f32x4,
    middle_square: f32x4,
    /// Start value at the distance `middle`.
    at_middle: f32x4,
    reach_square: f32x4,
    reach: f32x4,
}

/// Steps of Newton's method for the contact of a torus: three reach single precision.
const STEPS: usize = 3;

/// Bound of the error of a torus contact after these steps, as a shift of the column relative to the reach: twice the
/// largest of four million cases with minor radii from a hundredth of the radius and slopes up to 100.
pub(crate) const ROUND_SHIFT: f64 = 1.0 / (1 << 15) as f64;

impl PartKind for RoundPart {
    #[inline(always)]
    fn height(&self, square: f32x4) -> f32x4 {
        self.height_beyond(square, ZERO)
    }

    #[inline(always)]
    fn height_beyond(&self, square: f32x4, grow: f32x4) -> f32x4 {
        let d = (square.sqrt() + grow).fast_max(self.core) - self.middle;
        self.round - (self.round_square - d * d).fast_max(ZERO).sqrt() - self.rise
    }

    /// With s the sine of the contact and q² = s²(1 + m²) − m², (f + c·s)·q = e·s. This form avoids differences of
    /// nearly equal numbers on steep slopes. The root is between e·s/(f + c·s) for the least s and for s = 1.
    #[inline(always)]
    fn contact(&self, e: f32x4, square: f32x4, room: f32x4) -> f32x4 {
        let one = f32x4::ONE;
        let square = square.fast_min(self.reach_square);
        let e = e.fast_min(self.reach);
        let (least, most) = (e * self.least_share, e * self.inverse);
        // Start values: over the flat end the minor radius hardly counts, outside of it the slope hardly counts; in
        // between both do.
        let flat = (self.middle_square - square).fast_max(ZERO).sqrt();
        let on_flat = (self.slope * e / flat.fast_max(MIN_DIVISOR)).fast_min(self.at_middle);
        let outside = ((e - self.middle) / self.round).fast_max(self.at_middle);
        let start = e.cmp_lt(self.middle).blend(on_flat, outside);
        let mut q = start.fast_max(least).fast_min(most);
        let sine = |q: f32x4| {
            ((q * q + self.slope_square) * self.cosine_square).sqrt().fast_max(MIN_DIVISOR)
        };
        for _ in 0..STEPS {
            let s = sine(q);
            let arm = self.middle + self.round * s;
            let value = arm * q - e * s;
            let rate = arm + (self.round * q - e) * q * self.cosine_square / s;
            q = (q - value / rate.fast_max(MIN_DIVISOR)).fast_max(least).fast_min(most);
        }
        let s = sine(q);
        let arm = self.middle + self.round * s;
        let rest = ((one - q * q) * self.cosine_square).fast_max(ZERO).sqrt();
        let contact = self.slope * arm * rest / s;
        let edge = (self.core_square - square).fast_max(ZERO).sqrt();
        // Inside the core the height is constant up to its edge.
        let inside = contact.cmp_gt(edge);
        inside.blend(contact, edge).fast_min(room)
    }
}

/// Whether a part is half a ball, whose contact has a closed form.
pub(crate) fn is_ball(part: &BodyPart) -> bool {
    matches!(part.kind, PartShape::Round { round, middle }
        if middle == 0.0 && part.core == 0.0 && part.reach == round)
}

/// Farther than any cutter reaches, mm; also the largest `lean`.
const UNREACHABLE_MM: f64 = 1e9;

/// The shape of a part on a slope.
pub(crate) enum AnyShape {
    Flat(FlatPart),
    Cone(ConePart),
    Ball(BallPart),
    Round(RoundPart),
}

impl AnyShape {
    pub fn new(part: &BodyPart, slope: f64) -> AnyShape {
        let rise = slope.abs();
        let lane = |value: f64| f32x4::splat(value as f32);
        match part.kind {
            PartShape::Flat => AnyShape::Flat(FlatPart),
            PartShape::Cone(k) => AnyShape::Cone(ConePart {
                slope: lane(k),
                core: lane(part.core),
                core_square: lane(part.core * part.core),
                // Far beyond any reach, yet products with it do not overflow.
                lean: lane(if rise < k {
                    (rise / (k * k - rise * rise).sqrt()).min(UNREACHABLE_MM)
                } else {
                    0.0
                }),
                steep: lane(if rise < k { 0.0 } else { UNREACHABLE_MM }),
            }),
            PartShape::Round { round, .. } if is_ball(part) => AnyShape::Ball(BallPart {
                round: lane(round),
                round_square: lane(round * round),
                sine: lane(rise / (1.0 + rise * rise).sqrt()),
                twice_round: lane(2.0 * round),
            }),
            PartShape::Round { round, middle } => {
                let d = part.core - middle;
                let sine = rise / (1.0 + rise * rise).sqrt();
                AnyShape::Round(RoundPart {
                    round: lane(round),
                    round_square: lane(round * round),
                    middle: lane(middle),
                    core: lane(part.core),
                    core_square: lane(part.core * part.core),
                    rise: lane(round - (round * round - d * d).max(0.0).sqrt()),
                    slope: lane(rise),
                    slope_square: lane(rise * rise),
                    cosine_square: lane(1.0 / (1.0 + rise * rise)),
                    least_share: lane(sine / (middle + round * sine)),
                    inverse: lane(1.0 / (middle + round)),
                    middle_square: lane(middle.max(0.0) * middle.max(0.0)),
                    at_middle: lane(libm::cbrt(middle.max(0.0) * rise * rise / (2.0 * round))),
                    reach_square: lane(part.reach * part.reach),
                    reach: lane(part.reach),
                })
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The contact by halving, in double precision.
    fn halved(round: f64, middle: f64, slope: f64, e: f64) -> f64 {
        let square = slope * slope;
        let (mut low, mut high) = (slope / (1.0 + square).sqrt(), 1.0);
        for _ in 0..100 {
            let s = 0.5 * (low + high);
            let arm = middle + round * s;
            let value = arm * arm * (1.0 + square - square / (s * s)) - e * e;
            *(if value < 0.0 { &mut low } else { &mut high }) = s;
        }
        let reach = middle + round;
        let contact = slope * (middle + round * low) * (1.0 - low * low).max(0.0).sqrt() / low;
        contact.min((reach * reach - e * e).max(0.0).sqrt())
    }

    /// Rounds from a fiftieth of the radius, slopes of a thousandth to fifty, columns about the edge of the flat end.
    #[test]
    fn contacts_of_rounds_are_where_they_should_be() {
        let mut worst = 0.0_f64;
        for round in [0.02, 0.05, 0.2, 0.5, 0.9] {
            let middle: f64 = 1.0 - round;
            let kind = PartShape::Round { round, middle };
            let part = BodyPart { height: 0.0, core: middle, reach: 1.0, kind };
            for slope in [0.001, 0.01, 0.03, 0.2, 1.0, 7.0, 50.0] {
                let AnyShape::Round(shape) = AnyShape::new(&part, slope) else { unreachable!() };
                for n in 0..=2000 {
                    let e = f64::from(n) / 2000.0;
                    let lane = f32x4::splat(e as f32);
                    let room = (f32x4::ONE - lane * lane).fast_max(ZERO).sqrt();
                    let found = f64::from(shape.contact(lane, lane * lane, room).to_array()[0]);
                    worst = worst.max((found - halved(round, middle, slope, e)).abs());
                }
            }
        }
        // A root of a rounded number at the rim.
        assert!(worst < 4e-4, "{worst}");
    }
}
