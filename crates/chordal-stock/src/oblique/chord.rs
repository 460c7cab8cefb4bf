//! What a vertical line has in common with a convex solid of revolution that moves straight, in any direction.
//!
//! With t the share of the motion and z the height on the line, a point is in the solid where a quadratic form of
//! (z, t) is not positive, its height along the axis of the solid is within that of the zone, and t is from 0 to 1. This
//! region of the (z, t) plane is convex. Its lowest and its highest z are on one of its four straight sides, or
//! where the curved side has no slope along t, which is on a fifth line.

use chordal_geometry::Vec3;

use super::element::QuadricZone;

/// Where a chord ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ChordEnd {
    /// Its height, mm.
    pub z: f64,
    /// The share of the motion.
    pub t: f64,
    /// The index of the zone.
    pub zone: usize,
}

/// Zones that move straight, with their axis in a direction.
#[derive(Clone, Debug)]
pub(crate) struct MovingZones {
    start: Vec3,
    travel: Vec3,
    axis: Vec3,
    zones: Vec<MovingZone>,
}

#[derive(Clone, Copy, Debug)]
struct MovingZone {
    zone: QuadricZone,
    /// The factors of z², z·t and t².
    form: [f64; 3],
}

/// A line of the (z, t) plane: a point and a direction.
#[derive(Clone, Copy)]
struct FormLine {
    at: [f64; 2],
    along: [f64; 2],
}

/// The region of one zone for one vertical line.
struct ChordRegion {
    /// The factors of z², z·t, t², z, t and 1.
    form: [f64; 6],
    /// The height along the axis: the factors of z and t, and that at (0, 0).
    height: [f64; 3],
    from: f64,
    to: f64,
}

/// Two heights of zones.
type Limits = [f64; 2];

fn clip(limits: &mut Limits, slope: f64, at: f64, [low, high]: Limits) {
    if slope == 0.0 {
        if !(low <= at && at <= high) {
            *limits = [f64::INFINITY, f64::NEG_INFINITY];
        }
        return;
    }
    let ends = [(low - at) / slope, (high - at) / slope];
    limits[0] = limits[0].max(ends[0].min(ends[1]));
    limits[1] = limits[1].min(ends[0].max(ends[1]));
}

/// Where a·u² + b·u + c is not positive between two limits, if that is one interval.
fn not_positive([a, b, c]: [f64; 3], [from, to]: Limits) -> Option<Limits> {
    if from > to || from.is_nan() || to.is_nan() {
        return None;
    }
    if a == 0.0 {
        if b == 0.0 {
            return (c <= 0.0).then_some([from, to]);
        }
        let root = -c / b;
        let found = if b > 0.0 { [from, to.min(root)] } else { [from.max(root), to] };
        return (found[0] <= found[1]).then_some(found);
    }
    let square = b * b - 4.0 * a * c;
    if square < 0.0 || square.is_nan() {
        return (a < 0.0).then_some([from, to]);
    }
    let half = -0.5 * (b + square.sqrt().copysign(b));
    let roots = if half == 0.0 { [0.0, 0.0] } else { [half / a, c / half] };
    let (low, high) = (roots[0].min(roots[1]), roots[0].max(roots[1]));
    if a > 0.0 {
        let found = [from.max(low), to.min(high)];
        return (found[0] <= found[1]).then_some(found);
    }
    // The region is convex, so it is on one side of the roots; on both only by rounding.
    let (below, above) = ([from, to.min(low)], [from.max(high), to]);
    let length = |limits: &Limits| limits[1] - limits[0];
    let found = if length(&below) >= length(&above) { below } else { above };
    (found[0] <= found[1]).then_some(found)
}

impl ChordRegion {
    /// The ends of what a line has in common with the region, each as z and t.
    fn on(&self, line: &FormLine, skips_heights: bool) -> Option<[[f64; 2]; 2]> {
        let ([z, t], [dz, dt]) = (line.at, line.along);
        let mut limits = [f64::NEG_INFINITY, f64::INFINITY];
        clip(&mut limits, dt, t, [0.0, 1.0]);
        let [of_z, of_t, fixed] = self.height;
        if !skips_heights {
            let (slope, at) = (of_z * dz + of_t * dt, of_z * z + of_t * t + fixed);
            clip(&mut limits, slope, at, [self.from, self.to]);
        }
        let [zz, zt, tt, of_z, of_t, one] = self.form;
        let form = [
            zz * dz * dz + zt * dz * dt + tt * dt * dt,
            2.0 * zz * z * dz + zt * (z * dt + t * dz) + 2.0 * tt * t * dt + of_z * dz + of_t * dt,
            zz * z * z + zt * z * t + tt * t * t + of_z * z + of_t * t + one,
        ];
        let ends = not_positive(form, limits)?;
        let point = |u: f64| [z + u * dz, t + u * dt];
        ends.iter().all(|u| u.is_finite()).then(|| ends.map(point))
    }

    /// The line of a height along the axis.
    fn of_height(&self, height: f64) -> Option<FormLine> {
        let [of_z, of_t, fixed] = self.height;
        let rest = height - fixed;
        if of_z.abs() >= of_t.abs() {
            (of_z != 0.0).then(|| FormLine { at: [rest / of_z, 0.0], along: [-of_t / of_z, 1.0] })
        } else {
            Some(FormLine { at: [0.0, rest / of_t], along: [1.0, -of_z / of_t] })
        }
    }

    /// The line on which the form has no slope along t.
    fn steady(&self) -> Option<FormLine> {
        let [_, zt, tt, _, of_t, _] = self.form;
        (tt != 0.0)
            .then(|| FormLine { at: [0.0, -of_t / (2.0 * tt)], along: [1.0, -zt / (2.0 * tt)] })
    }

    /// The lowest and the highest point of the region.
    fn ends(&self, moves: bool) -> Option<[[f64; 2]; 2]> {
        let mut found: Option<[[f64; 2]; 2]> = None;
        let mut take = |ends: Option<[[f64; 2]; 2]>| {
            for end in ends.into_iter().flatten() {
                let [low, high] = found.get_or_insert([end, end]);
                if end[0] < low[0] {
                    *low = end;
                }
                if end[0] > high[0] {
                    *high = end;
                }
            }
        };
        take(self.on(&FormLine { at: [0.0, 0.0], along: [1.0, 0.0] }, false));
        if moves {
            take(self.on(&FormLine { at: [0.0, 1.0], along: [1.0, 0.0] }, false));
            for height in [self.from, self.to] {
                take(self.of_height(height).and_then(|line| self.on(&line, true)));
            }
            take(self.steady().and_then(|line| self.on(&line, false)));
        }
        found
    }
}

impl MovingZones {
    /// Zones relative to a reference point that moves from `start` by `travel`, mm, with a unit vector as axis.
    pub fn new(zones: Vec<QuadricZone>, start: Vec3, travel: Vec3, axis: Vec3) -> MovingZones {
        let (of_z, of_t) = (axis.z, -travel.dot(axis));
        let moving = |zone: QuadricZone| {
            let factor = 1.0 + zone.square[2];
            let form = [
                1.0 - factor * of_z * of_z,
                -2.0 * travel.z - 2.0 * factor * of_z * of_t,
                travel.length_squared() - factor * of_t * of_t,
            ];
            MovingZone { zone, form }
        };
        let zones = zones.into_iter().map(moving).collect();
        MovingZones { start, travel, axis, zones }
    }

    /// The lower and the upper end of what a vertical line has in common with the sweep of the zones, which are
    /// together convex; `None` where it has nothing.
    pub fn chord(&self, x: f64, y: f64) -> Option<[ChordEnd; 2]> {
        let (x, y) = (x - self.start.x, y - self.start.y);
        let (travel, axis) = (self.travel, self.axis);
        let fixed = x * axis.x + y * axis.y;
        let (of_z, of_t) = (axis.z, -travel.dot(axis));
        let moves = travel != Vec3::ZERO;
        let mut found: Option<[ChordEnd; 2]> = None;
        for (index, MovingZone { zone, form: [zz, zt, tt] }) in self.zones.iter().enumerate() {
            let [one, linear, factor] = zone.square;
            let factor = 1.0 + factor;
            let slope = 2.0 * factor * fixed + linear;
            let region = ChordRegion {
                form: [
                    *zz,
                    *zt,
                    *tt,
                    -of_z * slope,
                    -2.0 * (x * travel.x + y * travel.y) - of_t * slope,
                    x * x + y * y - factor * fixed * fixed - linear * fixed - one,
                ],
                height: [of_z, of_t, fixed],
                from: zone.from,
                to: zone.to,
            };
            let Some(ends) = region.ends(moves) else { continue };
            let [low, high] = ends.map(|[z, t]| ChordEnd { z: z + self.start.z, t, zone: index });
            found = Some(match found {
                None => [low, high],
                Some([below, above]) => [
                    if low.z < below.z { low } else { below },
                    if high.z > above.z { high } else { above },
                ],
            });
        }
        found
    }

    /// Vectors outwards at an end of a chord: normal to the side there, to the end that it is on, and to the edge
    /// between both that the motion sweeps.
    pub fn normals(&self, x: f64, y: f64, end: &ChordEnd) -> [Option<Vec3>; 3] {
        /// How near to the end of a zone a point is on it, mm.
        const ON_END_MM: f64 = 1e-5;
        let Some(MovingZone { zone, .. }) = self.zones.get(end.zone) else { return [None; 3] };
        let from = Vec3::new(x, y, end.z) - (self.start + self.travel * end.t);
        let height = from.dot(self.axis);
        let arm = from - self.axis * height;
        let [_, linear, factor] = zone.square;
        // Half the gradient of the squared radius.
        let side = (arm - self.axis * (0.5 * linear + factor * height)).normalized();
        let cap = if height - zone.from <= ON_END_MM {
            Some(-self.axis)
        } else if zone.to - height <= ON_END_MM {
            Some(self.axis)
        } else {
            None
        };
        let edge = match (side, cap) {
            (Some(side), Some(cap)) => {
                let (one, other) = (side.dot(self.travel), cap.dot(self.travel));
                (one * other < 0.0).then(|| side * other.abs() + cap * one.abs())
            }
            _ => None,
        };
        [side, cap, edge.and_then(Vec3::normalized)]
    }
}
