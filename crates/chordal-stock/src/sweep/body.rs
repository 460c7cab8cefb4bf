//! Bodies that must not touch stock: a shank, a neck, a holder, the part of a cutter above its edges.

use super::{BodyPart, PartShape, parts};
use crate::{CutterProfile, Undercut};

/// A body of revolution about the tool axis, represented by its lower surface. Heights are above the tool tip, mm.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RevolvedBody {
    pub(crate) parts: Vec<BodyPart>,
    /// Undercuts, each with the height of its lower end above the tip, mm.
    pub(crate) undercuts: Vec<(f64, Undercut)>,
}

impl RevolvedBody {
    /// A cutter itself, for moves that must not cut.
    pub fn of_cutter(cutter: &CutterProfile) -> RevolvedBody {
        RevolvedBody { parts: parts(cutter.rings()), ..RevolvedBody::default() }
    }

    /// Undercuts themselves, for moves that must not cut; each with the height of its lower end above the tip, mm.
    /// Unlike other bodies they end at their upper sides.
    pub fn of_undercuts(undercuts: &[(f64, Undercut)]) -> RevolvedBody {
        RevolvedBody { undercuts: undercuts.to_vec(), ..RevolvedBody::default() }
    }

    /// The part above the edges of a cutter, as wide as the cutter. Where it touches, the cut is deeper than the
    /// edges. `None` if their length is not known.
    pub fn above_flutes(cutter: &CutterProfile) -> Option<RevolvedBody> {
        Some(RevolvedBody::cylinder(2.0 * cutter.radius(), cutter.flutes()?))
    }

    /// A cylinder from a height up, such as a shank, mm.
    pub fn cylinder(diameter: f64, height: f64) -> RevolvedBody {
        RevolvedBody::stack(height, &[[0.0, diameter, diameter]])
    }

    /// Stacked cylinders and cones from a height on, each as length, lower and upper diameter, mm. A narrower one
    /// above a wider one is hidden by it. Segments with invalid sizes add nothing.
    pub fn stack(height: f64, segments: &[[f64; 3]]) -> RevolvedBody {
        let mut parts: Vec<BodyPart> = Vec::new();
        let (mut height, mut widest) = (height, 0.0_f64);
        for &[length, lower, upper] in segments {
            let (lower, upper) = (lower / 2.0, upper / 2.0);
            if lower > widest {
                parts.push(BodyPart { height, core: lower, reach: lower, kind: PartShape::Flat });
                widest = lower;
            }
            if upper > widest && upper > lower && length > 0.0 {
                let slope = length / (upper - lower);
                let from = height + slope * (widest - lower);
                // A disc from which the cone continues becomes the core of the cone.
                if parts.last().is_some_and(|last| last.reach == widest && last.height == from) {
                    parts.pop();
                }
                let kind = PartShape::Cone(slope);
                parts.push(BodyPart { height: from, core: widest, reach: upper, kind });
                widest = upper;
            } else if upper > widest {
                // A step to a larger diameter.
                let height = height + length.max(0.0);
                parts.push(BodyPart { height, core: upper, reach: upper, kind: PartShape::Flat });
                widest = upper;
            }
            height += length.max(0.0);
        }
        RevolvedBody { parts, ..RevolvedBody::default() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lowest(body: &RevolvedBody, radius: f64) -> f64 {
        let reached = body.parts.iter().filter(|part| radius <= part.reach);
        reached.map(|part| part.height_at(radius)).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn a_holder_is_its_lowest_surface() {
        // A shank of 6, a cone from 10 to 20, a neck of 16, a flange of 40.
        let segments = [[20.0, 6.0, 6.0], [10.0, 10.0, 20.0], [5.0, 16.0, 16.0], [8.0, 40.0, 40.0]];
        let body = RevolvedBody::stack(12.0, &segments);
        for (radius, height) in [(2.0, 12.0), (4.0, 32.0), (7.5, 37.0), (9.0, 40.0), (15.0, 47.0)] {
            assert!((lowest(&body, radius) - height).abs() < 1e-12, "{radius}");
        }
        assert_eq!(lowest(&body, 20.1), f64::INFINITY);
    }
}
