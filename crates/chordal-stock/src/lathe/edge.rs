//! An edge of a region: a straight line, or an arc within a quadrant of its circle.
//!
//! An arc within a quadrant is monotone in z and in r, so its bounding box is that of its ends, a line meets it at
//! most twice, and a line of constant z at most once. Longer arcs are divided.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use chordal_geometry::Vec2;

use super::segment::{OutlineSegment, SegmentArc};

/// Half the angle of an arc (rad) below which a series gives the area and moment of its segment: the closed forms
/// lose digits for small angles, and at this size the next term of the series is below 1e-15.
const SMALL_HALF_ANGLE: f64 = 0.2;
/// Parts of a quadrant smaller than this get no edge of their own, rad: rounding of an angle.
const NO_ANGLE: f64 = 1e-13;

/// A box in the half plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Box2 {
    pub min: Vec2,
    pub max: Vec2,
}

impl Box2 {
    /// The empty box.
    pub const EMPTY: Box2 = Box2 {
        min: Vec2::new(f64::INFINITY, f64::INFINITY),
        max: Vec2::new(f64::NEG_INFINITY, f64::NEG_INFINITY),
    };

    pub fn of(p: Vec2, q: Vec2) -> Box2 {
        Box2 {
            min: Vec2::new(p.a.min(q.a), p.b.min(q.b)),
            max: Vec2::new(p.a.max(q.a), p.b.max(q.b)),
        }
    }

    pub fn around(edges: &[RegionEdge]) -> Box2 {
        edges.iter().fold(Box2::EMPTY, |all, edge| all.with(&edge.bounds()))
    }

    pub fn with(&self, other: &Box2) -> Box2 {
        Box2 {
            min: Vec2::new(self.min.a.min(other.min.a), self.min.b.min(other.min.b)),
            max: Vec2::new(self.max.a.max(other.max.a), self.max.b.max(other.max.b)),
        }
    }

    pub fn grown(&self, by: f64) -> Box2 {
        let by = Vec2::new(by, by);
        Box2 { min: self.min - by, max: self.max + by }
    }

    pub fn meets(&self, other: &Box2) -> bool {
        self.min.a <= other.max.a
            && other.min.a <= self.max.a
            && self.min.b <= other.max.b
            && other.min.b <= self.max.b
    }

    pub fn holds(&self, p: Vec2) -> bool {
        self.min.a <= p.a && p.a <= self.max.a && self.min.b <= p.b && p.b <= self.max.b
    }

    /// The largest absolute coordinate, mm.
    pub fn size(&self) -> f64 {
        let corners = [self.min.a, self.min.b, self.max.a, self.max.b];
        corners.into_iter().map(f64::abs).filter(|size| size.is_finite()).fold(0.0, f64::max)
    }
}

/// The circle of an arc, and its sense. A radius of zero means that the edge is straight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ArcCircle {
    pub center: Vec2,
    pub radius: f64,
    pub counterclockwise: bool,
}

const STRAIGHT: ArcCircle = ArcCircle { center: Vec2::ZERO, radius: 0.0, counterclockwise: true };

/// A directed edge, with the region to its left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct RegionEdge {
    pub start: Vec2,
    pub end: Vec2,
    /// The vertices that it joins. Equal numbers are the same vertex, whatever the coordinates.
    pub ends: [u64; 2],
    pub circle: ArcCircle,
    /// The tag of the move that made it.
    pub tag: u32,
}

impl RegionEdge {
    pub fn line(start: Vec2, end: Vec2, tag: u32) -> RegionEdge {
        RegionEdge { start, end, ends: [0; 2], circle: STRAIGHT, tag }
    }

    pub fn is_straight(&self) -> bool {
        self.circle.radius == 0.0
    }

    pub fn bounds(&self) -> Box2 {
        Box2::of(self.start, self.end)
    }

    pub fn reversed(&self) -> RegionEdge {
        let counterclockwise = !self.circle.counterclockwise;
        RegionEdge {
            start: self.end,
            end: self.start,
            ends: [self.ends[1], self.ends[0]],
            circle: ArcCircle { counterclockwise, ..self.circle },
            ..*self
        }
    }

    /// The same curve between other points on it.
    pub fn between(&self, start: Vec2, end: Vec2) -> RegionEdge {
        RegionEdge { start, end, ..*self }
    }

    pub fn moved(&self, by: Vec2) -> RegionEdge {
        let circle = match self.is_straight() {
            true => self.circle,
            false => ArcCircle { center: self.circle.center + by, ..self.circle },
        };
        RegionEdge { start: self.start + by, end: self.end + by, circle, ..*self }
    }

    /// Mirrored at the axis and reversed, so that the region stays to the left.
    pub fn mirrored(&self) -> RegionEdge {
        let flip = |p: Vec2| Vec2::new(p.a, -p.b);
        let circle = ArcCircle { center: flip(self.circle.center), ..self.circle };
        RegionEdge { start: flip(self.end), end: flip(self.start), circle, ..*self }
    }

    /// With z and r exchanged and reversed, so that the region stays to the left.
    pub fn transposed(&self) -> RegionEdge {
        let swap = |p: Vec2| Vec2::new(p.b, p.a);
        let circle = ArcCircle { center: swap(self.circle.center), ..self.circle };
        RegionEdge { start: swap(self.end), end: swap(self.start), circle, ..*self }
    }

    /// The point halfway.
    pub fn middle(&self) -> Vec2 {
        let half = (self.start + self.end) * 0.5;
        if self.is_straight() {
            return half;
        }
        let ArcCircle { center, radius, .. } = self.circle;
        match (half - center).normalized() {
            Some(out) => center + out * radius,
            None => half,
        }
    }

    /// Length, mm.
    pub fn length(&self) -> f64 {
        match self.is_straight() {
            true => self.start.distance(self.end),
            false => 2.0 * self.circle.radius * self.half_angle(),
        }
    }

    /// Half the angle of an arc, rad.
    fn half_angle(&self) -> f64 {
        let half_chord = 0.5 * self.start.distance(self.end);
        libm::asin((half_chord / self.circle.radius).min(1.0))
    }

    /// The unit tangent at the start or the end.
    pub fn direction(&self, at_end: bool) -> Vec2 {
        let along = if self.is_straight() {
            self.end - self.start
        } else {
            let place = if at_end { self.end } else { self.start };
            let left = (place - self.circle.center).turned_left();
            if self.circle.counterclockwise { left } else { -left }
        };
        along.normalized().unwrap_or(Vec2::ZERO)
    }

    /// Its curvature, 1/mm, positive to the left.
    pub fn curvature(&self) -> f64 {
        match (self.is_straight(), self.circle.counterclockwise) {
            (true, _) => 0.0,
            (false, true) => 1.0 / self.circle.radius,
            (false, false) => -1.0 / self.circle.radius,
        }
    }

    /// Whether `p` is within `tolerance` (mm) of the edge, strictly between its ends.
    pub fn passes(&self, p: Vec2, tolerance: f64) -> bool {
        if self.is_straight() {
            let along = self.end - self.start;
            let to = p - self.start;
            let (reach, squared) = (to.dot(along), along.dot(along));
            let off = along.cross(to);
            reach > 0.0 && reach < squared && off * off <= tolerance * tolerance * squared
        } else {
            let off = p.distance(self.circle.center) - self.circle.radius;
            off.abs() <= tolerance && self.faces(p)
        }
    }

    /// Whether the direction from an arc's centre to `p` is between those to its ends.
    pub fn faces(&self, p: Vec2) -> bool {
        let center = self.circle.center;
        let (from, to, p) = (self.start - center, self.end - center, p - center);
        let (from, to) = if self.circle.counterclockwise { (from, to) } else { (to, from) };
        from.cross(p) >= 0.0 && p.cross(to) >= 0.0 && p.dot(from + to) > 0.0
    }

    /// Whether the edge passes above (z, r). It must cover z.
    pub fn is_above(&self, z: f64, r: f64) -> bool {
        let (low, high) = (self.start.b.min(self.end.b), self.start.b.max(self.end.b));
        if r < low {
            return true;
        }
        if r >= high {
            return false;
        }
        let p = Vec2::new(z, r);
        let forward = self.end.a > self.start.a;
        if self.is_straight() {
            // The point is then to the right of an edge towards +z, and to the left of one towards −z.
            let left = (self.end - self.start).cross(p - self.start);
            return if forward { left < 0.0 } else { left > 0.0 };
        }
        let to = p - self.circle.center;
        let inside = to.dot(to) < self.circle.radius * self.circle.radius;
        inside != self.is_lower_half()
    }

    /// Whether an arc is below its centre.
    fn is_lower_half(&self) -> bool {
        self.circle.counterclockwise == (self.end.a > self.start.a)
    }

    /// The radius at which the edge passes `z`, mm. It must cover z.
    pub fn radius_at(&self, z: f64) -> f64 {
        if z == self.start.a {
            return self.start.b;
        }
        if z == self.end.a {
            return self.end.b;
        }
        let r = if self.is_straight() {
            let share = (z - self.start.a) / (self.end.a - self.start.a);
            self.start.b + (self.end.b - self.start.b) * share
        } else {
            let ArcCircle { center, radius, .. } = self.circle;
            let across = z - center.a;
            let up = ((radius - across) * (radius + across)).max(0.0).sqrt();
            if self.is_lower_half() { center.b - up } else { center.b + up }
        };
        r.clamp(self.start.b.min(self.end.b), self.start.b.max(self.end.b))
    }

    /// The edge's contribution to the area by Green's theorem, relative to `origin`, mm².
    pub fn area(&self, origin: Vec2) -> f64 {
        let chord = 0.5 * (self.start - origin).cross(self.end - origin);
        if self.is_straight() {
            return chord;
        }
        chord + self.segment().0
    }

    /// The edge's contribution to the volume of the body of revolution, −π∫r²dz, mm³.
    pub fn volume(&self) -> f64 {
        let (r0, r1) = (self.start.b, self.end.b);
        let chord = -PI / 3.0 * (self.end.a - self.start.a) * (r0 * r0 + r0 * r1 + r1 * r1);
        if self.is_straight() {
            return chord;
        }
        // The volume of the segment between chord and arc follows from its centroid (Pappus).
        let (area, moment) = self.segment();
        let half = (self.start + self.end) * 0.5;
        let out = (half - self.circle.center).normalized().unwrap_or(Vec2::ZERO);
        chord + TAU * (half.b * area + out.b * moment)
    }

    /// Area between chord and arc (mm²), and its moment about the chord (mm³); positive for counter-clockwise arcs.
    fn segment(&self) -> (f64, f64) {
        let (h, radius) = (self.half_angle(), self.circle.radius);
        let (area, moment) = if h < SMALL_HALF_ANGLE {
            let q = h * h;
            let cubed = q * h;
            // 2h − sin 2h, and sin h − h·cos h − sin³h/3.
            let area = cubed
                * (4.0 / 3.0
                    + q * (-4.0 / 15.0
                        + q * (8.0 / 315.0
                            + q * (-4.0 / 2835.0
                                + q * (8.0 / 155_925.0 - q * 8.0 / 6_081_075.0)))));
            let moment = cubed
                * q
                * (2.0 / 15.0
                    + q * (-176.0 / 5_040.0
                        + q * (1_632.0 / 362_880.0
                            + q * (-14_752.0 / 39_916_800.0
                                + q * (132_848.0 / 6_227_020_800.0
                                    - q * 1_195_728.0 / 1_307_674_368_000.0)))));
            (area, moment)
        } else {
            let (sin, cos) = libm::sincos(h);
            (2.0 * (h - sin * cos), sin - h * cos - sin * sin * sin / 3.0)
        };
        let (area, moment) = (0.5 * radius * radius * area, radius * radius * radius * moment);
        if self.circle.counterclockwise { (area, moment) } else { (-area, -moment) }
    }

    /// The least and the largest of `along`·p over the edge, mm; `along` is a unit vector.
    pub fn reach(&self, along: Vec2) -> (f64, f64) {
        let (from, to) = (along.dot(self.start), along.dot(self.end));
        let (mut low, mut high) = (from.min(to), from.max(to));
        if !self.is_straight() {
            let ArcCircle { center, radius, .. } = self.circle;
            for out in [along, -along] {
                let place = center + out * radius;
                if self.faces(place) {
                    (low, high) = (low.min(along.dot(place)), high.max(along.dot(place)));
                }
            }
        }
        (low, high)
    }

    /// The least and the largest distance from `place`, mm.
    pub fn distances(&self, place: Vec2) -> (f64, f64) {
        let (from, to) = (self.start.distance(place), self.end.distance(place));
        let (mut low, mut high) = (from.min(to), from.max(to));
        if self.is_straight() {
            let along = self.end - self.start;
            let share = (place - self.start).dot(along) / along.dot(along);
            if share > 0.0 && share < 1.0 {
                low = low.min((self.start + along * share).distance(place));
            }
        } else if let Some(out) = (place - self.circle.center).normalized() {
            for out in [out, -out] {
                let foot = self.circle.center + out * self.circle.radius;
                if self.faces(foot) {
                    let distance = foot.distance(place);
                    (low, high) = (low.min(distance), high.max(distance));
                }
            }
        }
        (low, high)
    }

    /// The edge in its public form.
    pub fn to_segment(self) -> OutlineSegment {
        let bend = (!self.is_straight()).then_some(SegmentArc {
            center: self.circle.center,
            radius: self.circle.radius,
            counterclockwise: self.circle.counterclockwise,
        });
        OutlineSegment { start: self.start, end: self.end, bend, tag: self.tag }
    }
}

/// Adds an arc, divided at the quadrants of its circle. `sweep` is the absolute value of its angle, rad, up to a
/// turn.
pub(crate) fn push_arc(
    edges: &mut Vec<RegionEdge>,
    (start, end): (Vec2, Vec2),
    circle: ArcCircle,
    sweep: f64,
    tag: u32,
) {
    let ArcCircle { center, radius, counterclockwise } = circle;
    let sign = if counterclockwise { 1.0 } else { -1.0 };
    let to_start = start - center;
    // Measured in the sense of travel.
    let begin = sign * libm::atan2(to_start.b, to_start.a);
    let mut from = start;
    let mut quarter = libm::floor(begin / FRAC_PI_2) + 1.0;
    loop {
        let done = quarter * FRAC_PI_2 - begin;
        if done >= sweep - NO_ANGLE {
            break;
        }
        if done > NO_ANGLE {
            // The axis that is reached, counted in quarter turns from +z.
            let to = match (quarter * sign).rem_euclid(4.0) as u8 {
                0 => Vec2::new(center.a + radius, center.b),
                1 => Vec2::new(center.a, center.b + radius),
                2 => Vec2::new(center.a - radius, center.b),
                _ => Vec2::new(center.a, center.b - radius),
            };
            edges.push(RegionEdge { start: from, end: to, ends: [0; 2], circle, tag });
            from = to;
        }
        quarter += 1.0;
    }
    edges.push(RegionEdge { start: from, end, ends: [0; 2], circle, tag });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn series_and_closed_forms_agree() {
        for counterclockwise in [true, false] {
            for h in [0.199_999_999, 0.2] {
                let (sin, cos) = libm::sincos(h);
                let radius = 3.0;
                let circle = ArcCircle { center: Vec2::ZERO, radius, counterclockwise };
                let (start, end) = (Vec2::new(cos, -sin), Vec2::new(cos, sin));
                let (start, end) = if counterclockwise { (start, end) } else { (end, start) };
                let edge = RegionEdge {
                    start: start * radius,
                    end: end * radius,
                    ends: [0; 2],
                    circle,
                    tag: 0,
                };
                let sign = if counterclockwise { 1.0 } else { -1.0 };
                let area = sign * radius * radius * (h - sin * cos);
                let moment =
                    sign * radius * radius * radius * (sin - h * cos - sin * sin * sin / 3.0);
                let found = edge.segment();
                assert!((found.0 - area).abs() < 1e-15, "{h} {found:?} {area}");
                assert!((found.1 - moment).abs() < 1e-15, "{h} {found:?} {moment}");
            }
        }
    }

    #[test]
    fn a_turn_has_four_quadrants_from_anywhere() {
        for step in 0..64 {
            let angle = f64::from(step) * PI / 32.0;
            let (sin, cos) = libm::sincos(angle);
            for counterclockwise in [true, false] {
                let circle =
                    ArcCircle { center: Vec2::new(5.0, 7.0), radius: 2.0, counterclockwise };
                let start = circle.center + Vec2::new(cos, sin) * 2.0;
                let mut edges = Vec::new();
                push_arc(&mut edges, (start, start), circle, TAU, 0);
                assert_eq!(edges.len(), if step % 16 == 0 { 4 } else { 5 });
                let area: f64 = edges.iter().map(|edge| edge.area(circle.center)).sum();
                let sign = if counterclockwise { 1.0 } else { -1.0 };
                assert!((area - sign * 4.0 * PI).abs() < 1e-13);
                // Pappus: 2π·7·4π.
                let volume: f64 = edges.iter().map(RegionEdge::volume).sum();
                assert!((volume - sign * 56.0 * PI * PI).abs() < 1e-11);
            }
        }
    }
}
