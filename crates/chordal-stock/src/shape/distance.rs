//! How far a body is from a shape: exact, or between two bounds.

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
    /// The distance of a body with its tip at a place, mm: exact for boxes and for cylinders and tubes that stand
    /// upright, otherwise to `resolution`, but for rounding. Only a tube may leave more between the bounds, where
    /// much of its wall is as near.
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
                // From the outside, or from within the bore.
                let from = (off - round.outer).max(round.inner - off).max(0.0);
                let radii = HeightSpan { from, to: off + round.outer };
                exact(radii, HeightSpan { from: round.from, to: round.to })
            }
            _ => self.distance_along(body, tip, tip, resolution),
        }
    }

    /// The least distance of a body whose tip goes straight from one place to another, mm, to `resolution`, but for
    /// rounding: the way of a cone is convex, so the whole of it is one question. Only a tube may leave more between
    /// the bounds, where much of its wall is as near.
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
        // No nearer than the tube with its bore filled; in the bore no nearer than the place furthest from the axis.
        let lower = whole.lower.max(self.inner - self.furthest_from_axis(swept));
        let wall = self.wall_distance(swept, resolution, enough);
        DistanceInterval { lower: wall.lower.max(lower).min(wall.upper), upper: wall.upper }
    }

    /// How far from the axis of the cylinder a body reaches on its way, mm. The distance from a line is convex,
    /// so its largest value is at an end of the way and of the frustum.
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
    /// until the staves around and inside of a part say the same.
    fn wall_distance(
        &self,
        swept: &SweptFrustum,
        resolution: f64,
        enough: f64,
    ) -> DistanceInterval {
        /// Parts at first: an eighth of a turn is not far from its chord.
        const PARTS: usize = 8;
        /// Where all parts are as near the search ends; the staves are then alike to a millionth of the radius.
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

    /// The corners of a stave between two angles and two radii.
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
        // A body that does not meet the surface is inside as a whole, or outside.
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
                    // The nearer one is looked into first.
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

/// A quick lower bound of the distance of a box.
struct BoxDistance<'a> {
    bounds: Aabb,
    swept: &'a SweptFrustum,
}

impl BoxDistance<'_> {
    /// Less exact where it is above `enough` anyhow.
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

    /// From the bodies themselves: exact where the body stands, otherwise a twentieth of what is enough less.
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

    /// Seen from above: beside the way of the axis, less the radius.
    fn plan(&self, around: &Aabb) -> f64 {
        let SweptFrustum { frustum, from, to } = *self.swept;
        let (x, y) = (to.x - from.x, to.y - from.y);
        let length = (x * x + y * y).sqrt();
        if length <= 0.0 {
            return 0.0;
        }
        // The box lies on one side of the line of the way, by so much.
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
