//! A cutter as the union of parts, each of which is convex.
//!
//! A ring, continued towards the axis by a disc at the height where it begins, has a convex height. The disc does not
//! change the cutter, because what is nearer to the axis is lower. So the floor of any cutter is the minimum of the
//! floors of its parts, and each of these is a convex function of the column on a straight move. Concave outlines
//! need no special case.

use crate::{Ring, RingElement};

/// The shape of a part outside its core.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum PartShape {
    /// Nothing: the part ends with its core.
    Flat,
    /// A cone with this rise per radius.
    Cone(f64),
    /// A torus with the minor radius `round` and the major radius `middle`, mm.
    Round { round: f64, middle: f64 },
}

/// A disc of radius `core` at `height` above the tip, and its continuation up to the radius `reach`, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BodyPart {
    pub height: f64,
    pub core: f64,
    pub reach: f64,
    pub kind: PartShape,
}

/// The parts of a cutter. A disc that is only the core of the next part is left out.
pub(crate) fn parts(rings: &[Ring]) -> Vec<BodyPart> {
    let part = |ring: &Ring| {
        let (kind, core) = match ring.element {
            RingElement::Disc { .. } => (PartShape::Flat, ring.to),
            RingElement::Cone { slope, .. } => (PartShape::Cone(slope), ring.from),
            RingElement::Torus { round, middle, .. } => {
                (PartShape::Round { round, middle }, ring.from)
            }
        };
        BodyPart { height: ring.height_at(ring.from), core, reach: ring.to, kind }
    };
    let is_core = |n: usize| {
        let next = rings.get(n + 1);
        matches!(rings[n].element, RingElement::Disc { height } if
            next.is_some_and(|next| next.height_at(next.from) <= height))
    };
    (0..rings.len()).filter(|&n| !is_core(n)).map(|n| part(&rings[n])).collect()
}

impl BodyPart {
    /// The height above the tip at a distance from the axis, mm; that of the core inside it.
    #[cfg(test)]
    pub fn height_at(&self, radius: f64) -> f64 {
        let radius = radius.max(self.core);
        self.height
            + match self.kind {
                PartShape::Flat => 0.0,
                PartShape::Cone(slope) => slope * (radius - self.core),
                PartShape::Round { round, middle } => {
                    let rise = |radius: f64| {
                        let d = radius - middle;
                        round - (round * round - d * d).max(0.0).sqrt()
                    };
                    rise(radius) - rise(self.core)
                }
            }
    }

    /// The range in which the lowest contact is on a straight move that rises by `slope`, in mm ahead of the column's
    /// foot on it, for any column that the part reaches.
    pub fn contact(&self, slope: f64) -> [f64; 2] {
        let rise = slope.abs();
        let most = match self.kind {
            _ if rise == 0.0 => return [0.0; 2],
            PartShape::Flat => self.reach,
            PartShape::Cone(k) if rise < k => self.core.max(self.reach * rise / k),
            PartShape::Cone(_) => self.reach,
            PartShape::Round { round, middle } => {
                let round = middle.max(0.0) + round * rise / (1.0 + rise * rise).sqrt();
                self.core.max(round).min(self.reach)
            }
        };
        if slope > 0.0 { [-most, 0.0] } else { [0.0, most] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::CutterProfile;

    #[test]
    fn parts_have_the_height_of_their_cutter() {
        let hollow =
            CutterProfile::outline(&[[0.0, 0.0], [2.0, 1.0], [2.5, 3.0], [4.0, 3.0], [4.5, 5.0]]);
        for cutter in [
            hollow.unwrap(),
            CutterProfile::bull(10.0, 2.0).unwrap(),
            CutterProfile::pointed(6.0, 1.0, 1.0).unwrap(),
            CutterProfile::ball(3.0).unwrap(),
        ] {
            let parts = parts(cutter.rings());
            for n in 0..=1000 {
                let radius = cutter.radius() * f64::from(n) / 1000.0;
                let lowest = parts
                    .iter()
                    .filter(|part| radius <= part.reach)
                    .map(|part| part.height_at(radius))
                    .fold(f64::INFINITY, f64::min);
                assert!((lowest - cutter.height_at(radius)).abs() < 1e-12, "{cutter:?} {radius}");
            }
        }
    }

    #[test]
    fn a_flat_end_below_a_round_is_no_part_of_its_own() {
        assert_eq!(parts(CutterProfile::bull(10.0, 2.0).unwrap().rings()).len(), 1);
        assert_eq!(parts(CutterProfile::pointed(6.0, 1.0, 1.0).unwrap().rings()).len(), 1);
    }
}
