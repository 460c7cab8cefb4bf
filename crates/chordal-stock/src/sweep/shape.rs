//! The kinds of parts in four lanes: how high they are, and where on a slope they touch lowest.

use wide::{CmpGt, f32x4};

use super::{Kind, Part};

const ZERO: f32x4 = f32x4::ZERO;

/// A kind of part. Radii and heights in mm; heights above the core.
pub(crate) trait Shape: Copy {
    /// Whether it has no height outside its core.
    const FLAT: bool = false;

    /// The height at distances from the axis, given by their squares; `base` less.
    fn height(&self, square: f32x4) -> f32x4;

    /// Not less than the height at these distances and `grow` more; `base` less.
    fn height_beyond(&self, square: f32x4, grow: f32x4) -> f32x4;

    /// What of the height is the same everywhere.
    #[inline(always)]
    fn base(&self) -> f32x4 {
        ZERO
    }

    /// How far behind (or ahead of, when the slope falls) a column's place on the piece the lowest contact
    /// lies, at the distance e from the piece: `square` is e², `room` is √(reach² − e²).
    fn contact(&self, e: f32x4, square: f32x4, room: f32x4) -> f32x4;

    /// The least and the largest of these for distances between two: it falls with the distance.
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
pub(crate) struct Flat;

impl Shape for Flat {
    const FLAT: bool = true;

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

/// A cone about a core, on a slope: it touches at `lean`·e, or at `steep`, which is beyond the end of what it
/// reaches where the slope is the steeper one, and nothing elsewhere.
#[derive(Clone, Copy)]
pub(crate) struct Cone {
    slope: f32x4,
    core: f32x4,
    core_square: f32x4,
    lean: f32x4,
    steep: f32x4,
}

impl Shape for Cone {
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
        // The contact on the cone goes ahead with the distance, the edge of the core and the rim go back.
        [(near, far), (far, near)].map(|(lean, ends)| {
            let square = ends * ends;
            let room = (reach_square - square).fast_max(ZERO).sqrt();
            let edge = (self.core_square - square).fast_max(ZERO).sqrt();
            (self.lean * lean).fast_max(edge).fast_max(self.steep).fast_min(room)
        })
    }
}

/// Half a ball: it reaches as far as its round.
#[derive(Clone, Copy)]
pub(crate) struct Ball {
    round: f32x4,
    round_square: f32x4,
    /// Slope by √(1 + slope²), without its sign.
    sine: f32x4,
    /// 2·round: (r + g)² − r² is not more than this times g, and g².
    twice_round: f32x4,
}

impl Shape for Ball {
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

/// A round about a circle.
#[derive(Clone, Copy)]
pub(crate) struct Round {
    round: f32x4,
    round_square: f32x4,
    middle: f32x4,
    core: f32x4,
    core_square: f32x4,
    /// The height of the circle of the core on the round, mm: zero where it begins at its lowest place.
    rise: f32x4,
    /// Slope² and 1 + slope².
    slope_square: f32x4,
    secant_square: f32x4,
    slope: f32x4,
    /// The smallest sine of a contact.
    least_sine: f32x4,
    reach_square: f32x4,
    reach: f32x4,
}

/// Newton's method for the contact of a round: from its start four steps reach single precision, and the
/// floor's error is of the second order in what is left.
const STEPS: usize = 4;

impl Shape for Round {
    #[inline(always)]
    fn height(&self, square: f32x4) -> f32x4 {
        self.height_beyond(square, ZERO)
    }

    #[inline(always)]
    fn height_beyond(&self, square: f32x4, grow: f32x4) -> f32x4 {
        let d = (square.sqrt() + grow).fast_max(self.core) - self.middle;
        self.round - (self.round_square - d * d).fast_max(ZERO).sqrt() - self.rise
    }

    /// With s the sine of the contact, (f + c·s)²·(1 + m² − m²/s²) = e²: the left side grows with s.
    #[inline(always)]
    fn contact(&self, e: f32x4, square: f32x4, room: f32x4) -> f32x4 {
        let one = f32x4::ONE;
        let square = square.fast_min(self.reach_square);
        let e = e.fast_min(self.reach);
        let start = (self.slope_square + square / self.reach_square) / self.secant_square;
        let mut s = start.sqrt().fast_max(self.least_sine).fast_min(one);
        for _ in 0..STEPS {
            let arm = self.middle + self.round * s;
            let inverse = one / s;
            let part = self.slope_square * inverse * inverse;
            let rest = (self.secant_square - part).fast_max(ZERO);
            let value = arm * arm * rest - e * e;
            let rate = arm * (self.round * rest + arm * part * inverse);
            s = (s - value / (rate + rate)).fast_max(self.least_sine).fast_min(one);
        }
        let arm = self.middle + self.round * s;
        let contact = self.slope * arm * (one - s * s).fast_max(ZERO).sqrt() / s;
        let edge = (self.core_square - square).fast_max(ZERO).sqrt();
        // On the core itself the height does not change before its edge.
        let inside = contact.cmp_gt(edge);
        inside.blend(contact, edge).fast_min(room)
    }
}

/// Farther than a cutter reaches, mm, or steeper than any lean that matters.
const FAR: f64 = 1e9;

/// A part on a slope, as one of the shapes.
pub(crate) enum AnyShape {
    Flat(Flat),
    Cone(Cone),
    Ball(Ball),
    Round(Round),
}

impl AnyShape {
    pub fn new(part: &Part, slope: f64) -> AnyShape {
        let rise = slope.abs();
        let lane = |value: f64| f32x4::splat(value as f32);
        match part.kind {
            Kind::Flat => AnyShape::Flat(Flat),
            Kind::Cone(k) => AnyShape::Cone(Cone {
                slope: lane(k),
                core: lane(part.core),
                core_square: lane(part.core * part.core),
                // Far beyond any reach, and no overflow in products with it.
                lean: lane(if rise < k {
                    (rise / (k * k - rise * rise).sqrt()).min(FAR)
                } else {
                    0.0
                }),
                steep: lane(if rise < k { 0.0 } else { FAR }),
            }),
            Kind::Round { round, middle }
                if middle == 0.0 && part.core == 0.0 && part.reach == round =>
            {
                AnyShape::Ball(Ball {
                    round: lane(round),
                    round_square: lane(round * round),
                    sine: lane(rise / (1.0 + rise * rise).sqrt()),
                    twice_round: lane(2.0 * round),
                })
            }
            Kind::Round { round, middle } => {
                let d = part.core - middle;
                AnyShape::Round(Round {
                    round: lane(round),
                    round_square: lane(round * round),
                    middle: lane(middle),
                    core: lane(part.core),
                    core_square: lane(part.core * part.core),
                    rise: lane(round - (round * round - d * d).max(0.0).sqrt()),
                    slope_square: lane(rise * rise),
                    secant_square: lane(1.0 + rise * rise),
                    slope: lane(rise),
                    least_sine: lane((rise / (1.0 + rise * rise).sqrt()).max(1e-6)),
                    reach_square: lane(part.reach * part.reach),
                    reach: lane(part.reach),
                })
            }
        }
    }
}
