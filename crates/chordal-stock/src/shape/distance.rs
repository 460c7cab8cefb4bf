//! The distance between a body and a shape: exact, or between two bounds.

use chordal_geometry::{Aabb, Vec3};

use super::body::{RoundBody, SweptFrustum};
use super::cells::HeightSpan;
use super::convex::{self, DistanceInterval};
use super::mesh_shape::MeshedShape;
use super::profile;
use super::round::CylinderShape;
use super::tree::NodeContent;
use super::{ShapeAxis, ShapeKind, SolidShape};

impl SolidShape {
    /// The distance of a body with its tip at a point, mm: exact for boxes and for vertical cylinders and tubes,
    /// otherwise within `resolution` (mm), up to rounding. Only for a tube the bounds may be farther apart, where
    /// much of its wall is equally near.
    pub fn distance(&self, body: &RoundBody, tip: Vec3, resolution: f64) -> DistanceInterval {
        let exact = |radii: HeightSpan, heights: HeightSpan| {
            let parts = body.frustums().iter();
            let of = |part| profile::distance(part, tip.z, radii, heights);
            DistanceInterval::exact(parts.map(of).fold(f64::INFINITY, f64::min))
        };
        match &self.0 {
            ShapeKind::Cuboid(around) => {
                let parts = body.frustums().iter();
                let of = |part| profile::from_box(part, tip, around);
                DistanceInterval::exact(parts.map(of).fold(f64::INFINITY, f64::min))
            }
            ShapeKind::Round(round) if round.axis == ShapeAxis::Z => {
                let (x, y) = (round.middle.x - tip.x, round.middle.y - tip.y);
                let off = (x * x + y * y).sqrt();
                // Outside of the tube, or inside its bore.
                let from = (off - round.outer).max(round.inner - off).max(0.0);
                let radii = HeightSpan { from, to: off + round.outer };
                exact(radii, HeightSpan { from: round.from, to: round.to })
            }
            _ => self.distance_along(body, tip, tip, resolution),
        }
    }

    /// The least distance of a body whose tip moves straight from one point to another, mm, within `resolution` (mm),
    /// up to rounding: the swept volume of a cone is convex, so it is evaluated as a whole. Only for a tube the
    /// bounds may be farther apart, where much of its wall is equally near.
    pub fn distance_along(
        &self,
        body: &RoundBody,
        from: Vec3,
        to: Vec3,
        resolution: f64,
    ) -> DistanceInterval {
        let mut least = DistanceInterval::ENDLESS;
        for &frustum in body.frustums() {
            let swept = SweptFrustum { frustum, from, to };
            let enough = least.upper;
            let found = match &self.0 {
                ShapeKind::Cuboid(around) => convex::distance(&swept, around, resolution, enough),
                ShapeKind::Round(round) => round.distance(&swept, resolution, enough),
                ShapeKind::Meshed(meshed) => meshed.distance(&swept, resolution, enough),
            };
            least = least.or(found);
        }
        least
    }
}

impl CylinderShape {
    fn distance(&self, swept: &SweptFrustum, resolution: f64, enough: f64) -> DistanceInterval {
        let whole = convex::distance(swept, self, resolution, enough);
        if self.inner <= 0.0 || whole.lower >= enough {
            return whole;
        }
        // The distance is at least that from the filled tube, and in the bore at least that between the bore and the
        // body's point furthest from the axis.
        let lower = whole.lower.max(self.inner - self.furthest_from_axis(swept));
        let wall = self.wall_distance(swept, resolution, enough);
        DistanceInterval { lower: wall.lower.max(lower).min(wall.upper), upper: wall.upper }
    }

    /// The largest distance of a moving body from the axis of the cylinder, mm. The distance from a line is convex,
    /// so its largest value is at an end of the path and of the frustum.
    fn furthest_from_axis(&self, swept: &SweptFrustum) -> f64 {
        let part = swept.frustum;
        let mut most: f64 = 0.0;
        for tip in [swept.from, swept.to] {
            for (height, radius) in [(part.from, part.lower), (part.to, part.upper)] {
                let off = tip - self.middle;
                let up = off.z + height;
                let reach = match self.axis {
                    ShapeAxis::X => [off.y.abs() + radius, up],
                    ShapeAxis::Y => [off.x.abs() + radius, up],
                    ShapeAxis::Z => [(off.x * off.x + off.y * off.y).sqrt() + radius, 0.0],
                };
                most = most.max((reach[0] * reach[0] + reach[1] * reach[1]).sqrt());
            }
        }
        most
    }

    /// The distance of a body from the wall of a tube: the wall is divided around its axis where it may be nearest,
    /// until the staves that contain a part and that it contains give the same distance.
    fn wall_distance(
        &self,
        swept: &SweptFrustum,
        resolution: f64,
        enough: f64,
    ) -> DistanceInterval {
        /// Initial number of parts: an eighth of a turn is close to its chord.
        const PARTS: usize = 8;
        /// Ends the search where all parts are equally near; the two staves then agree to a millionth of the radius.
        const MAX_DIVISIONS: usize = 1500;
        let part = |from: f64, to: f64| {
            let half = libm::cos((to - from) / 2.0);
            let (outer, inner) = (self.outer / half, self.inner / half);
            let around = self.stave([from, to], [self.inner, outer]);
            let lower = convex::distance(swept, &around[..], resolution / 4.0, enough).lower;
            let upper = if inner < self.outer {
                let within = self.stave([from, to], [inner, self.outer]);
                convex::distance(swept, &within[..], resolution / 4.0, enough).upper
            } else {
                f64::INFINITY
            };
            (DistanceInterval { lower, upper }, from, to)
        };
        let eighth = std::f64::consts::TAU / PARTS as f64;
        let mut parts: Vec<(DistanceInterval, f64, f64)> = (0..PARTS)
            .map(|number| part(number as f64 * eighth, (number + 1) as f64 * eighth))
            .collect();
        let mut upper = parts.iter().fold(f64::INFINITY, |least, part| least.min(part.0.upper));
        for _ in 0..MAX_DIVISIONS {
            let lowest = (0..parts.len())
                .min_by(|a, b| parts[*a].0.lower.total_cmp(&parts[*b].0.lower))
                .unwrap_or(0);
            let (found, from, to) = parts[lowest];
            if upper - found.lower <= resolution || found.lower >= enough {
                return DistanceInterval { lower: found.lower, upper };
            }
            let middle = from + (to - from) / 2.0;
            parts[lowest] = part(from, middle);
            parts.push(part(middle, to));
            for half in [lowest, parts.len() - 1] {
                upper = upper.min(parts[half].0.upper);
            }
        }
        let lower = parts.iter().fold(f64::INFINITY, |least, part| least.min(part.0.lower));
        DistanceInterval { lower: lower.min(upper), upper }
    }

    /// The corners of the stave between two angles and two radii.
    fn stave(&self, angles: [f64; 2], radii: [f64; 2]) -> [Vec3; 8] {
        let around = angles.map(libm::sincos);
        let Vec3 { x, y, z } = self.middle;
        std::array::from_fn(|corner| {
            let bit = |number: usize| corner >> number & 1;
            let end = [self.from, self.to][bit(0)];
            let (sin, cos) = around[bit(1)];
            let (u, v) = (radii[bit(2)] * cos, radii[bit(2)] * sin);
            match self.axis {
                ShapeAxis::X => Vec3::new(end, y + u, z + v),
                ShapeAxis::Y => Vec3::new(x + u, end, z + v),
                ShapeAxis::Z => Vec3::new(x + u, y + v, end),
            }
        })
    }
}

impl MeshedShape {
    fn distance(&self, swept: &SweptFrustum, resolution: f64, enough: f64) -> DistanceInterval {
        // A body that does not meet the surface is entirely inside or entirely outside.
        let middle = Vec3::Z * (0.5 * (swept.frustum.from + swept.frustum.to));
        if self.contains(swept.from + middle) {
            return DistanceInterval::TOUCHING;
        }
        let bounds = swept.bounds();
        let reach = BoxDistance { bounds, swept };
        let mut least = DistanceInterval { lower: enough, upper: enough };
        let mut open = vec![(0, reach.lower(&self.tree.node(0).bounds, enough))];
        while let Some((number, lower)) = open.pop() {
            if lower >= least.upper {
                continue;
            }
            match self.tree.node(number).inside {
                NodeContent::Boxes(a, b) => {
                    let lower = |number| reach.lower(&self.tree.node(number).bounds, least.upper);
                    let [a, b] = [(a, lower(a)), (b, lower(b))];
                    // The nearer box is examined first.
                    open.extend(if a.1 < b.1 { [b, a] } else { [a, b] });
                }
                NodeContent::Triangles(first, count) => {
                    for triangle in self.tree.triangles(first, count) {
                        let corners = self.mesh.corners(triangle);
                        let around = corners.into_iter().fold(Aabb::EMPTY, Aabb::include);
                        if reach.lower(&around, least.upper) < least.upper {
                            let upper = least.upper;
                            let found = convex::distance(swept, &corners[..], resolution, upper);
                            least = least.or(found);
                        }
                    }
                }
            }
        }
        least
    }
}

/// Quick lower bounds of the distance from boxes.
struct BoxDistance<'a> {
    bounds: Aabb,
    swept: &'a SweptFrustum,
}

impl BoxDistance<'_> {
    /// A lower bound of the distance from a box, mm; cruder where it is above `enough` anyway.
    fn lower(&self, around: &Aabb, enough: f64) -> f64 {
        let gap = |axis: usize| {
            let below = around.min.component(axis) - self.bounds.max.component(axis);
            let above = self.bounds.min.component(axis) - around.max.component(axis);
            below.max(above).max(0.0)
        };
        let gaps = Vec3::new(gap(0), gap(1), gap(2));
        let quick = gaps.length().max(self.plan(around));
        if quick >= enough { quick } else { quick.max(self.convex(around, enough)) }
    }

    /// A lower bound from the bodies themselves: exact where the body does not move, otherwise within a twentieth of
    /// `enough`.
    fn convex(&self, around: &Aabb, enough: f64) -> f64 {
        const PART: f64 = 0.05;
        let SweptFrustum { frustum, from, to } = *self.swept;
        if from == to {
            profile::from_box(&frustum, from, around)
        } else if enough.is_finite() {
            convex::distance(self.swept, around, PART * enough, enough).lower
        } else {
            0.0
        }
    }

    /// A lower bound in plan: the distance from the line of the path, minus the radius.
    fn plan(&self, around: &Aabb) -> f64 {
        let SweptFrustum { frustum, from, to } = *self.swept;
        let (x, y) = (to.x - from.x, to.y - from.y);
        let length = (x * x + y * y).sqrt();
        if length <= 0.0 {
            return 0.0;
        }
        // Signed distance of a point from the line of the path.
        let side = |px: f64, py: f64| ((px - from.x) * y - (py - from.y) * x) / length;
        let corners = [
            side(around.min.x, around.min.y),
            side(around.max.x, around.min.y),
            side(around.min.x, around.max.y),
            side(around.max.x, around.max.y),
        ];
        let low = corners.into_iter().fold(f64::INFINITY, f64::min);
        let high = corners.into_iter().fold(f64::NEG_INFINITY, f64::max);
        low.max(-high) - frustum.lower.max(frustum.upper)
    }
}
