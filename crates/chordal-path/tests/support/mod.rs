//! Random closed contours, and the plain offset of one, for tests of compensation.

#![allow(dead_code, reason = "each test uses its part")]

use std::f64::consts::TAU;

use cavalier_contours::polyline::{PlineSource, PlineSourceMut, Polyline};
use chordal_geometry::Vec2;
use chordal_path::gouge::{CenterMove, Contour, ContourBlock, GougeCurve, GougeRole, ToolSide};

/// Numbers that look random and are the same everywhere (xorshift).
pub struct Dice(u64);

impl Dice {
    pub fn new(seed: u64) -> Self {
        Dice(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    pub fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
}

fn polar(angle: f64, radius: f64) -> Vec2 {
    Vec2::new(radius * angle.cos(), radius * angle.sin())
}

/// A closed contour of 50 mm or so around the origin that does not cross itself: lines, tangent
/// fillets, arcs that meet their neighbours at a corner, and islands of short segments. Either way
/// round.
pub fn closed_contour(dice: &mut Dice) -> Vec<GougeCurve> {
    let corners = 3 + (dice.unit() * 9.0) as usize;
    let points: Vec<Vec2> = (0..corners)
        .map(|k| {
            let angle = TAU * (k as f64 + dice.between(0.1, 0.9)) / corners as f64;
            polar(angle, dice.between(20.0, 50.0))
        })
        .collect();
    let mut curves = Vec::new();
    let fillets: Vec<f64> = (0..corners)
        .map(|_| if dice.unit() < 0.4 { dice.between(0.05, 0.3) } else { 0.0 })
        .collect();
    for k in 0..corners {
        let (before, here, after) =
            (points[(k + corners - 1) % corners], points[k], points[(k + 1) % corners]);
        let t1 = (here - before).normalized().unwrap();
        let t2 = (after - here).normalized().unwrap();
        let cut = |share: f64, a: Vec2, b: Vec2| share * a.distance(b);
        // The tangent length of the fillet at this corner, less than a third of either side.
        let here_cut = cut(fillets[k], before, here).min(cut(fillets[k], here, after));
        let next = (k + 1) % corners;
        let beyond = points[(next + 1) % corners];
        let next_cut = cut(fillets[next], here, after).min(cut(fillets[next], after, beyond));
        if here_cut > 0.0 {
            fillet(&mut curves, here, t1, t2, here_cut);
        }
        side(dice, &mut curves, here + t2 * here_cut, after - t2 * next_cut);
    }
    if dice.unit() < 0.5 {
        curves = curves.iter().rev().map(GougeCurve::reversed).collect();
    }
    curves
}

/// A pocket of 100 mm, wide at both ends and narrow between them, run counter-clockwise.
pub fn necked_pocket(dice: &mut Dice) -> Vec<GougeCurve> {
    let mut points = Vec::new();
    // The lower wall from left to right, then the same kind of wall turned by half a turn.
    for way in [1.0, -1.0] {
        points.push(Vec2::new(-50.0, -20.0) * way);
        for k in 0..4 {
            let a = -24.0 + 16.0 * f64::from(k) + dice.between(-6.0, 6.0);
            points.push(Vec2::new(a, -dice.between(1.0, 6.0)) * way);
        }
        points.push(Vec2::new(50.0, -20.0) * way);
    }
    (0..points.len()).map(|k| GougeCurve::line(points[k], points[(k + 1) % points.len()])).collect()
}

fn fillet(curves: &mut Vec<GougeCurve>, corner: Vec2, t1: Vec2, t2: Vec2, cut: f64) {
    let turn = t1.cross(t2).atan2(t1.dot(t2));
    if turn.abs() < 1e-3 {
        curves.push(GougeCurve::line(corner - t1 * cut, corner + t2 * cut));
        return;
    }
    let radius = cut / (turn.abs() / 2.0).tan();
    let from = corner - t1 * cut;
    let center = from + t1.turned_left() * (radius * turn.signum());
    let out = from - center;
    curves.push(GougeCurve::Arc { center, radius, start: out.b.atan2(out.a), sweep: turn });
}

fn side(dice: &mut Dice, curves: &mut Vec<GougeCurve>, from: Vec2, to: Vec2) {
    let kind = dice.unit();
    let length = from.distance(to);
    if kind < 0.55 || length < 1.0 {
        curves.push(GougeCurve::line(from, to));
    } else if kind < 0.75 {
        // A shallow arc that meets its neighbours at corners.
        let bulge = dice.between(0.03, 0.2) * if dice.unit() < 0.5 { 1.0 } else { -1.0 };
        curves.push(bulged(from, to, bulge));
    } else {
        // A wave of short segments between two lines.
        let (start, end) = (from * 0.6 + to * 0.4, from * 0.4 + to * 0.6);
        let normal = (to - from).normalized().unwrap().turned_left();
        let count = 20 + (dice.unit() * 40.0) as usize;
        let height = dice.between(0.0, 0.3);
        let waves = dice.between(0.5, 2.0).round();
        let mut last = start;
        curves.push(GougeCurve::line(from, start));
        for k in 1..=count {
            let t = k as f64 / count as f64;
            let lift = if k == count { 0.0 } else { height * (TAU * waves * t).sin() };
            let next = start * (1.0 - t) + end * t + normal * lift;
            curves.push(GougeCurve::line(last, next));
            last = next;
        }
        curves.push(GougeCurve::line(last, to));
    }
}

/// The arc between two points whose height over the half chord is `bulge`.
pub fn bulged(from: Vec2, to: Vec2, bulge: f64) -> GougeCurve {
    let sweep = 4.0 * bulge.atan();
    let chord = to - from;
    let center = (from + to) * 0.5 + chord.turned_left() * ((1.0 - bulge * bulge) / (4.0 * bulge));
    let out = from - center;
    GougeCurve::Arc { center, radius: out.length(), start: out.b.atan2(out.a), sweep }
}

pub fn contour(curves: &[GougeCurve], side: ToolSide, radius: f64) -> Contour {
    let blocks = curves
        .iter()
        .enumerate()
        .map(|(k, &curve)| ContourBlock { curve, tag: k as u32, role: GougeRole::Offset })
        .collect();
    Contour { blocks, side, radius }
}

fn tangents(curve: &GougeCurve) -> (Vec2, Vec2) {
    match *curve {
        GougeCurve::Line { from, to } => {
            let t = (to - from).normalized().unwrap();
            (t, t)
        }
        GougeCurve::Arc { start, sweep, .. } => {
            let at = |angle: f64| polar(angle, 1.0).turned_left() * sweep.signum();
            (at(start), at(start + sweep))
        }
    }
}

/// Whether an arc meets a neighbour at a sharp inside corner, which [`offset_path`] does not trim.
pub fn has_inside_corner_with_arc(curves: &[GougeCurve], side: ToolSide) -> bool {
    let is_arc = |c: &GougeCurve| matches!(c, GougeCurve::Arc { .. });
    (0..curves.len()).any(|k| {
        let (curve, next) = (&curves[k], &curves[(k + 1) % curves.len()]);
        let (t1, t2) = (tangents(curve).1, tangents(next).0);
        (is_arc(curve) || is_arc(next)) && t1.cross(t2) * side.sign() > 1e-9
    })
}

/// The path beside a closed contour with round corners, as a control that looks at two blocks
/// would run it: inside corners of lines are trimmed where the offsets cross, even if that turns a
/// block round; at inside corners with arcs the tool runs to the end of the offset. `None` when an
/// arc is smaller than the tool inside it.
pub fn offset_path(curves: &[GougeCurve], side: ToolSide, radius: f64) -> Option<Vec<CenterMove>> {
    let count = curves.len();
    let signed = side.sign() * radius;
    let mut ends: Vec<(Vec2, Vec2)> = Vec::with_capacity(count);
    for curve in curves {
        if let GougeCurve::Arc { radius, sweep, .. } = curve
            && radius - signed * sweep.signum() <= 1e-6
        {
            return None;
        }
        let (t1, t2) = tangents(curve);
        let beside = |p: Vec2, t: Vec2| p + t.turned_left() * signed;
        ends.push((beside(curve.from(), t1), beside(curve.to(), t2)));
    }
    let mut links: Vec<Option<GougeCurve>> = vec![None; count];
    for k in 0..count {
        let next = (k + 1) % count;
        let (t1, t2) = (tangents(&curves[k]).1, tangents(&curves[next]).0);
        let turn = t1.cross(t2).atan2(t1.dot(t2));
        let corner = curves[k].to();
        if turn.abs() < 1e-9 {
            continue;
        }
        if turn * side.sign() < 0.0 {
            let out = ends[k].1 - corner;
            links[k] = Some(GougeCurve::Arc {
                center: corner,
                radius,
                start: out.b.atan2(out.a),
                sweep: turn,
            });
        } else if let (GougeCurve::Line { .. }, GougeCurve::Line { .. }) =
            (&curves[k], &curves[next])
        {
            let meet = ends[k].1 - t1 * (radius * (turn.abs() / 2.0).tan());
            ends[k].1 = meet;
            ends[next].0 = meet;
        } else {
            links[k] = Some(GougeCurve::line(ends[k].1, ends[next].0));
        }
    }
    let mut path = Vec::new();
    for (k, curve) in curves.iter().enumerate() {
        let tag = k as u32;
        let (from, to) = ends[k];
        let main = match *curve {
            GougeCurve::Line { .. } => GougeCurve::line(from, to),
            GougeCurve::Arc { center, radius, start, sweep } => {
                GougeCurve::Arc { center, radius: radius - signed * sweep.signum(), start, sweep }
            }
        };
        path.push(CenterMove { curve: main, tag });
        if let Some(link) = links[k] {
            path.push(CenterMove { curve: link, tag });
        }
    }
    Some(path)
}

/// The least distance between path and contour, found without any search: by the nearest point of
/// every curve to fine samples of every move.
pub fn sampled_distance(curves: &[GougeCurve], path: &[CenterMove], samples: usize) -> f64 {
    let mut least = f64::INFINITY;
    for step in path {
        for k in 0..=samples {
            let p = step.curve.at(k as f64 / samples as f64);
            for curve in curves {
                least = least.min(point_distance(curve, p));
            }
        }
    }
    least
}

/// Distance of a point from a curve, mm, by its own arithmetic.
pub fn point_distance(curve: &GougeCurve, p: Vec2) -> f64 {
    let (from, to) = (curve.from(), curve.to());
    let ends = p.distance(from).min(p.distance(to));
    match *curve {
        GougeCurve::Line { .. } => {
            let t = (to - from).normalized().unwrap();
            let along = (p - from).dot(t);
            if (0.0..=from.distance(to)).contains(&along) {
                (p - from).cross(t).abs()
            } else {
                ends
            }
        }
        GougeCurve::Arc { center, radius, start, sweep } => {
            let out = p - center;
            let turned = (out.b.atan2(out.a) - start) * sweep.signum();
            if turned.rem_euclid(TAU) <= sweep.abs() { (out.length() - radius).abs() } else { ends }
        }
    }
}

/// The contour as the polygon-offset library has it.
pub fn polyline(curves: &[GougeCurve]) -> Polyline<f64> {
    let mut line = Polyline::new_closed();
    for curve in curves {
        let bulge = match curve {
            GougeCurve::Line { .. } => 0.0,
            GougeCurve::Arc { sweep, .. } => (sweep / 4.0).tan(),
        };
        let from = curve.from();
        line.add(from.a, from.b, bulge);
    }
    line
}

/// The pieces of a polyline of the library.
pub fn curves_of(line: &Polyline<f64>) -> Vec<GougeCurve> {
    line.iter_segments()
        .map(|(v, w)| {
            let (from, to) = (Vec2::new(v.x, v.y), Vec2::new(w.x, w.y));
            if v.bulge == 0.0 { GougeCurve::line(from, to) } else { bulged(from, to, v.bulge) }
        })
        .filter(|c| c.length() > 0.0)
        .collect()
}
