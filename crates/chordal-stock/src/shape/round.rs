//! Cylinders and tubes along an axis.

use chordal_geometry::{Aabb, Vec3};

use super::ShapeAxis;
use super::cells::{CellFiller, CellRect, HeightSpan};
use super::convex::ConvexBody;

/// A cylinder, or a tube where `inner` is above zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CylinderShape {
    pub axis: ShapeAxis,
    /// A point of the axis, mm.
    pub middle: Vec3,
    /// The radius, mm.
    pub outer: f64,
    /// The radius of the bore, mm.
    pub inner: f64,
    /// The coordinates of its ends along the axis, mm.
    pub from: f64,
    pub to: f64,
}

/// Half the height of a circle at a horizontal distance from its centre; `None` outside.
fn half_height(radius: f64, distance: f64) -> Option<f64> {
    (distance < radius).then(|| ((radius - distance) * (radius + distance)).sqrt())
}

/// The smallest and the largest distance of a coordinate from those in a span.
pub(super) fn distances(span: HeightSpan, from: f64) -> HeightSpan {
    let (below, above) = (span.from - from, span.to - from);
    HeightSpan { from: below.max(-above).max(0.0), to: above.max(-below) }
}

impl CylinderShape {
    pub(super) fn bounds(&self) -> Aabb {
        let mut low = self.middle - Vec3::new(self.outer, self.outer, self.outer);
        let mut high = self.middle + Vec3::new(self.outer, self.outer, self.outer);
        let (below, above) = match self.axis {
            ShapeAxis::X => (&mut low.x, &mut high.x),
            ShapeAxis::Y => (&mut low.y, &mut high.y),
            ShapeAxis::Z => (&mut low.z, &mut high.z),
        };
        (*below, *above) = (self.from, self.to);
        Aabb { min: low, max: high }
    }

    pub(super) fn fill(&self, rect: CellRect, filler: &mut CellFiller) {
        match self.axis {
            ShapeAxis::X => self.fill_lying(rect.x, rect.y, self.middle.y, filler),
            ShapeAxis::Y => self.fill_lying(rect.y, rect.x, self.middle.x, filler),
            ShapeAxis::Z => self.fill_upright(rect, filler),
        }
    }

    fn fill_upright(&self, rect: CellRect, filler: &mut CellFiller) {
        let x = distances(rect.x, self.middle.x);
        let y = distances(rect.y, self.middle.y);
        let near = (x.from * x.from + y.from * y.from).sqrt();
        let far = (x.to * x.to + y.to * y.to).sqrt();
        let whole = HeightSpan { from: self.from, to: self.to };
        let hollow = self.inner > 0.0;
        if near < self.outer && !(hollow && far < self.inner) {
            filler.outer(whole);
        }
        if far <= self.outer && !(hollow && near < self.inner) {
            filler.inner(whole);
        }
    }

    /// Fills the cell that is given by a strip along the axis of a lying cylinder and one across it.
    fn fill_lying(
        &self,
        along: HeightSpan,
        across: HeightSpan,
        middle: f64,
        filler: &mut CellFiller,
    ) {
        let whole = HeightSpan { from: self.from, to: self.to };
        let distance = distances(across, middle);
        let z = self.middle.z;
        // Bound of the rounding error of the root and of its sum with the height.
        let pad = 4.0 * f64::EPSILON * (z.abs() + self.outer);
        if let Some(most) = half_height(self.outer, distance.from).filter(|_| whole.overlaps(along))
        {
            let (low, high) = (z - most - pad, z + most + pad);
            // The bore is empty throughout the strip.
            match half_height(self.inner, distance.to) {
                Some(bore) if bore > pad => {
                    filler.outer(HeightSpan { from: low, to: z - bore + pad });
                    filler.outer(HeightSpan { from: z + bore - pad, to: high });
                }
                _ => filler.outer(HeightSpan { from: low, to: high }),
            }
        }
        if let Some(least) = half_height(self.outer, distance.to).filter(|_| whole.contains(along))
        {
            let (low, high) = (z - least + pad, z + least - pad);
            match half_height(self.inner, distance.from) {
                Some(bore) => {
                    for span in [
                        HeightSpan { from: low, to: z - bore - pad },
                        HeightSpan { from: z + bore + pad, to: high },
                    ] {
                        if span.from < span.to {
                            filler.inner(span);
                        }
                    }
                }
                None if low < high => filler.inner(HeightSpan { from: low, to: high }),
                None => {}
            }
        }
    }
}

/// The cylinder without its bore.
impl ConvexBody for CylinderShape {
    fn furthest(&self, path: Vec3) -> Vec3 {
        let (along, across) = match self.axis {
            ShapeAxis::X => (path.x, Vec3::new(0.0, path.y, path.z)),
            ShapeAxis::Y => (path.y, Vec3::new(path.x, 0.0, path.z)),
            ShapeAxis::Z => (path.z, Vec3::new(path.x, path.y, 0.0)),
        };
        let end = if along > 0.0 { self.to } else { self.from };
        let rim = across.normalized().map_or(Vec3::ZERO, |unit| unit * self.outer);
        let Vec3 { x, y, z } = self.middle;
        rim + match self.axis {
            ShapeAxis::X => Vec3::new(end, y, z),
            ShapeAxis::Y => Vec3::new(x, end, z),
            ShapeAxis::Z => Vec3::new(x, y, end),
        }
    }
}
