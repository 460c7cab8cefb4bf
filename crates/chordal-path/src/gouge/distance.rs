//! The exact distance between two curves in the plane.
//!
//! The smallest distance is at a crossing, at an end of either curve, or where the joining line is normal to both. Each
//! kind of pair has few such points, so all are tried.

use chordal_geometry::Vec2;

use super::shape::{GougeCurve, angle_of, unit};

/// The nearest points of two curves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearestPair {
    /// Square of their distance, mm².
    pub square: f64,
    /// The point on the first curve, mm.
    pub first: Vec2,
    /// The point on the second curve, mm.
    pub second: Vec2,
}

impl NearestPair {
    fn of(first: Vec2, second: Vec2) -> Self {
        let d = second - first;
        Self { square: d.dot(d), first, second }
    }

    fn or(self, o: NearestPair) -> NearestPair {
        if o.square < self.square { o } else { self }
    }

    fn swapped(self) -> NearestPair {
        NearestPair { square: self.square, first: self.second, second: self.first }
    }
}

/// The nearest points of two curves.
#[must_use]
pub fn nearest(first: &GougeCurve, second: &GougeCurve) -> NearestPair {
    use GougeCurve::{Arc, Line};
    match (first, second) {
        (Line { from: p, to: q }, Line { from: u, to: v }) => line_line(*p, *q, *u, *v),
        (Line { from, to }, Arc { .. }) => line_arc(*from, *to, first, second),
        (Arc { .. }, Line { from, to }) => line_arc(*from, *to, second, first).swapped(),
        (Arc { .. }, Arc { .. }) => arc_arc(first, second),
    }
}

fn ends(first: &GougeCurve, second: &GougeCurve) -> NearestPair {
    let mut best = NearestPair { square: f64::INFINITY, first: Vec2::ZERO, second: Vec2::ZERO };
    for p in [first.from(), first.to()] {
        best = best.or(NearestPair::of(p, second.nearest(p)));
    }
    for q in [second.from(), second.to()] {
        best = best.or(NearestPair::of(first.nearest(q), q));
    }
    best
}

fn line_line(p: Vec2, q: Vec2, u: Vec2, v: Vec2) -> NearestPair {
    let (along, other, gap) = (q - p, v - u, u - p);
    let turn = along.cross(other);
    if turn != 0.0 {
        let s = gap.cross(other) / turn;
        let t = gap.cross(along) / turn;
        if (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t) {
            let at = p + along * s;
            return NearestPair { square: 0.0, first: at, second: at };
        }
    }
    let foot = |point: Vec2, from: Vec2, along: Vec2| {
        let square = along.dot(along);
        let t =
            if square > 0.0 { ((point - from).dot(along) / square).clamp(0.0, 1.0) } else { 0.0 };
        from + along * t
    };
    NearestPair::of(p, foot(p, u, other))
        .or(NearestPair::of(q, foot(q, u, other)))
        .or(NearestPair::of(foot(u, p, along), u))
        .or(NearestPair::of(foot(v, p, along), v))
}

fn line_arc(from: Vec2, to: Vec2, line: &GougeCurve, arc: &GougeCurve) -> NearestPair {
    let GougeCurve::Arc { center, radius, .. } = *arc else { return ends(line, arc) };
    let mut best = ends(line, arc);
    let along = to - from;
    let square = along.dot(along);
    if square <= 0.0 {
        return best;
    }
    let t = (center - from).dot(along) / square;
    let foot = from + along * t;
    let out = foot - center;
    let d = out.length();
    if (0.0..=1.0).contains(&t) {
        // If the line goes through the centre, any normal direction will do: this takes the normal of the line.
        let normal =
            if d > 0.0 { out * (1.0 / d) } else { along.turned_left() * (1.0 / square.sqrt()) };
        for towards in [normal, -normal] {
            if arc.passes(angle_of(towards)) {
                best = best.or(NearestPair::of(foot, center + towards * radius));
            }
        }
    }
    if d <= radius {
        let half = ((radius - d) * (radius + d) / square).sqrt();
        for s in [t - half, t + half] {
            let at = from + along * s;
            if (0.0..=1.0).contains(&s) && arc.passes(angle_of(at - center)) {
                best = best.or(NearestPair { square: 0.0, first: at, second: at });
            }
        }
    }
    best
}

fn arc_arc(first: &GougeCurve, second: &GougeCurve) -> NearestPair {
    let (
        GougeCurve::Arc { center: c, radius: r, .. },
        GougeCurve::Arc { center: e, radius: q, .. },
    ) = (*first, *second)
    else {
        return ends(first, second);
    };
    let mut best = ends(first, second);
    let between = e - c;
    let d = between.length();
    if d <= 0.0 {
        // Concentric arcs: the smallest distance also occurs at an end of one of them.
        return best;
    }
    let angle = angle_of(between);
    let axis = between * (1.0 / d);
    let back = angle + core::f64::consts::PI;
    for (at, towards) in [(angle, axis), (back, -axis)] {
        if !first.passes(at) {
            continue;
        }
        for (other, out) in [(angle, axis), (back, -axis)] {
            if second.passes(other) {
                best = best.or(NearestPair::of(c + towards * r, e + out * q));
            }
        }
    }
    if d <= r + q && d >= (r - q).abs() && r > 0.0 && q > 0.0 {
        // A crossing and the centres form a triangle; `half` is its angle at the first centre.
        let cos = ((d * d + (r - q) * (r + q)) / (2.0 * d * r)).clamp(-1.0, 1.0);
        let half = libm::acos(cos);
        for a in [angle + half, angle - half] {
            let at = c + unit(a) * r;
            if first.passes(a) && second.passes(angle_of(at - e)) {
                best = best.or(NearestPair { square: 0.0, first: at, second: at });
            }
        }
    }
    best
}
