//! Walls of every kind: free contours, rectangles, circles, slots, necks, pockets with an island.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use chordal::geometry::Vec2;
use chordal::path::gouge::GougeCurve;

use crate::support::{Dice, closed_contour, necked_pocket};

/// A closed wall, in the order it is run.
pub struct Wall {
    pub name: &'static str,
    pub curves: Vec<GougeCurve>,
}

fn v(a: f64, b: f64) -> Vec2 {
    Vec2::new(a, b)
}

/// The piece of a curve between two fractions of its way.
pub fn piece(curve: &GougeCurve, first: f64, last: f64) -> GougeCurve {
    match *curve {
        GougeCurve::Line { .. } => GougeCurve::line(curve.at(first), curve.at(last)),
        GougeCurve::Arc { center, radius, start, sweep } => GougeCurve::Arc {
            center,
            radius,
            start: start + first * sweep,
            sweep: (last - first) * sweep,
        },
    }
}

/// A circle in equal arcs, counter-clockwise.
pub fn circle(center: Vec2, radius: f64, start: f64, arcs: u32) -> Vec<GougeCurve> {
    let sweep = TAU / f64::from(arcs);
    (0..arcs)
        .map(|k| GougeCurve::Arc { center, radius, start: start + f64::from(k) * sweep, sweep })
        .collect()
}

/// A rectangle with round or sharp corners, counter-clockwise.
fn rectangle(half: Vec2, corner: f64) -> Vec<GougeCurve> {
    let mut curves = Vec::new();
    for k in 0..4 {
        let angle = FRAC_PI_2 * f64::from(k);
        let turned = |p: Vec2| {
            v(p.a * angle.cos() - p.b * angle.sin(), p.a * angle.sin() + p.b * angle.cos())
        };
        // Each side is the lower one, turned; every other one has the other length.
        let (a, b) = if k % 2 == 0 { (half.a, half.b) } else { (half.b, half.a) };
        let (from, to) = (turned(v(corner - a, -b)), turned(v(a - corner, -b)));
        curves.push(GougeCurve::line(from, to));
        if corner > 0.0 {
            let center = turned(v(a - corner, corner - b));
            curves.push(GougeCurve::Arc {
                center,
                radius: corner,
                start: angle - FRAC_PI_2,
                sweep: FRAC_PI_2,
            });
        }
    }
    curves
}

/// A slot with round ends, counter-clockwise.
fn slot(half_length: f64, half_width: f64) -> Vec<GougeCurve> {
    let end = |a: f64, start: f64| GougeCurve::Arc {
        center: v(a, 0.0),
        radius: half_width,
        start,
        sweep: PI,
    };
    vec![
        GougeCurve::line(v(-half_length, -half_width), v(half_length, -half_width)),
        end(half_length, -FRAC_PI_2),
        GougeCurve::line(v(half_length, half_width), v(-half_length, half_width)),
        end(-half_length, FRAC_PI_2),
    ]
}

pub fn reversed(curves: &[GougeCurve]) -> Vec<GougeCurve> {
    curves.iter().rev().map(GougeCurve::reversed).collect()
}

/// Any closed wall, either way round.
pub fn any(dice: &mut Dice) -> Wall {
    let kind = dice.unit();
    let (name, curves) = if kind < 0.4 {
        ("free", closed_contour(dice))
    } else if kind < 0.55 {
        let half = v(dice.between(8.0, 40.0), dice.between(8.0, 40.0));
        let corner = if dice.unit() < 0.5 { 0.0 } else { dice.between(1.0, 8.0) };
        ("rectangle", rectangle(half, corner))
    } else if kind < 0.75 {
        let arcs = [1, 2, 4][(dice.unit() * 3.0) as usize];
        ("circle", circle(Vec2::ZERO, dice.between(3.0, 40.0), dice.between(0.0, TAU), arcs))
    } else if kind < 0.9 {
        ("slot", slot(dice.between(2.0, 40.0), dice.between(2.0, 15.0)))
    } else {
        ("neck", necked_pocket(dice))
    };
    let curves = if dice.unit() < 0.5 { reversed(&curves) } else { curves };
    Wall { name, curves }
}

/// The same wall, begun at a joint or within one of its blocks.
pub fn begun_anywhere(dice: &mut Dice, curves: &[GougeCurve]) -> Vec<GougeCurve> {
    let at = ((dice.unit() * curves.len() as f64) as usize).min(curves.len() - 1);
    let mut chain: Vec<GougeCurve> = curves[at..].iter().chain(&curves[..at]).copied().collect();
    if dice.unit() < 0.6 {
        let first = chain[0];
        let cut = dice.between(0.15, 0.85);
        if let (true, GougeCurve::Arc { center, radius, start, sweep }) = (chain.len() == 1, first)
        {
            // A full circle stays one block.
            chain[0] = GougeCurve::Arc { center, radius, start: start + cut * sweep, sweep };
        } else {
            chain[0] = piece(&first, cut, 1.0);
            chain.push(piece(&first, 0.0, cut));
        }
    }
    chain
}
