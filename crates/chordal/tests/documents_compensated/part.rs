//! Part contours by hand, and distances to them in closed form: nothing of Chordal's own
//! geometry is used to judge its paths.

use std::f64::consts::TAU;

/// A piece of a contour in the plane, in the unit of the document.
#[derive(Clone, Copy, Debug)]
pub enum Piece {
    /// From a point to a point.
    Line([f64; 2], [f64; 2]),
    /// Centre, radius, start angle and signed sweep in degrees.
    Arc([f64; 2], f64, f64, f64),
}

impl Piece {
    /// The point at a part of the way, 0 to 1.
    pub fn at(&self, part: f64) -> [f64; 2] {
        match *self {
            Piece::Line(a, b) => [a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])],
            Piece::Arc(c, r, start, sweep) => {
                let angle = (start + part * sweep).to_radians();
                [c[0] + r * angle.cos(), c[1] + r * angle.sin()]
            }
        }
    }

    /// Distance of a point.
    pub fn distance(&self, p: [f64; 2]) -> f64 {
        match *self {
            Piece::Line(a, b) => {
                let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
                let square = dx * dx + dy * dy;
                let part = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / square.max(1e-300);
                between(p, self.at(part.clamp(0.0, 1.0)))
            }
            Piece::Arc(c, r, start, sweep) => {
                let angle = (p[1] - c[1]).atan2(p[0] - c[0]) - start.to_radians();
                let turned = (angle * sweep.signum()).rem_euclid(TAU);
                if turned <= sweep.abs().to_radians() {
                    (between(p, c) - r).abs()
                } else {
                    between(p, self.at(0.0)).min(between(p, self.at(1.0)))
                }
            }
        }
    }
}

/// Distance of a point from a contour.
pub fn distance(contour: &[Piece], p: [f64; 2]) -> f64 {
    contour.iter().map(|piece| piece.distance(p)).fold(f64::INFINITY, f64::min)
}

fn between(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// A whole circle.
pub fn circle(center: [f64; 2], radius: f64) -> Vec<Piece> {
    vec![Piece::Arc(center, radius, 0.0, 360.0)]
}

/// Two half circles of a radius about two points beside each other, joined by lines.
pub fn slot(left: [f64; 2], right: [f64; 2], radius: f64) -> Vec<Piece> {
    let top = |c: [f64; 2]| [c[0], c[1] + radius];
    let bottom = |c: [f64; 2]| [c[0], c[1] - radius];
    vec![
        Piece::Line(top(right), top(left)),
        Piece::Arc(left, radius, 90.0, 180.0),
        Piece::Line(bottom(left), bottom(right)),
        Piece::Arc(right, radius, 270.0, 180.0),
    ]
}

/// A square about the origin, half its side and the radius of its corners given.
pub fn rounded_square(half: f64, corner: f64) -> Vec<Piece> {
    let inner = half - corner;
    vec![
        Piece::Line([half, -inner], [half, inner]),
        Piece::Arc([inner, inner], corner, 0.0, 90.0),
        Piece::Line([inner, half], [-inner, half]),
        Piece::Arc([-inner, inner], corner, 90.0, 90.0),
        Piece::Line([-half, inner], [-half, -inner]),
        Piece::Arc([-inner, -inner], corner, 180.0, 90.0),
        Piece::Line([-inner, -half], [inner, -half]),
        Piece::Arc([inner, -inner], corner, 270.0, 90.0),
    ]
}
