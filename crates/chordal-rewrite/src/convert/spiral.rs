//! Arcs of several turns, spirals and cones as arcs of at most one turn.

use std::f64::consts::TAU;

use chordal::control::{ArcShape, Move};
use chordal::geometry::{Arc, Vec3};
use chordal::machine::{AXES, PerAxis};
use libm::{atan2, cos, sin};

/// A piece of an arc command.
pub(crate) struct SpiralPiece {
    pub motion: Move,
    pub shape: ArcShape,
}

/// The command cut into arcs: one for each turn where its radius stays within `radius_error_mm`, else
/// as many as keep within a quarter of the tolerance of it, so that rounded words do too.
pub(crate) fn as_arcs(
    motion: &Move,
    shape: &ArcShape,
    radius_error_mm: f64,
    tolerance_mm: f64,
) -> Vec<SpiralPiece> {
    let turns = shape.sweep.abs() / TAU;
    if (shape.radius_to - shape.radius_from).abs() <= radius_error_mm {
        let whole = (turns - 1e-9).ceil().max(1.0) as usize;
        // Full turns first, so that the last piece has the end as it is programmed.
        return turns_of(motion, shape, whole);
    }
    let mut count = (turns * 8.0).ceil().max(1.0) as usize;
    while count < MAX_PIECES {
        if let Some(pieces) = chain(motion, shape, count, tolerance_mm / 4.0) {
            return pieces;
        }
        count += count.div_ceil(4);
    }
    turns_of(motion, shape, 1)
}

/// Beyond this a spiral is left as it is, and the proof fails.
const MAX_PIECES: usize = 100_000;

fn turns_of(motion: &Move, shape: &ArcShape, count: usize) -> Vec<SpiralPiece> {
    let full = TAU / shape.sweep.abs();
    let mut from = motion.from;
    (0..count)
        .map(|turn| {
            let is_last = turn + 1 == count;
            let s = if is_last { 1.0 } else { full * (turn + 1) as f64 };
            let mut to = if is_last { motion.to } else { point(motion, shape, s) };
            if !is_last {
                let (a, b, _) = shape.plane.axes();
                (to[a], to[b]) = (motion.from[a], motion.from[b]);
            }
            let begin = full * turn as f64;
            let sweep = shape.sweep * (s - begin);
            let piece = SpiralPiece {
                motion: Move { from, to, ..*motion },
                shape: ArcShape { sweep, radius_to: shape.radius_from, ..*shape },
            };
            from = to;
            piece
        })
        .collect()
}

/// A point of the command at a part of its way.
fn point(motion: &Move, shape: &ArcShape, s: f64) -> PerAxis<f64> {
    let (a, b, _) = shape.plane.axes();
    let mut at = [0.0; AXES];
    for (axis, value) in at.iter_mut().enumerate() {
        *value = motion.from[axis] + (motion.to[axis] - motion.from[axis]) * s;
    }
    let [ca, cb] = shape.center;
    let start = atan2(motion.from[b] - cb, motion.from[a] - ca);
    let angle = start + shape.sweep * s;
    let radius = shape.radius_from + (shape.radius_to - shape.radius_from) * s;
    at[a] = ca + radius * cos(angle);
    at[b] = cb + radius * sin(angle);
    at
}

/// So many arcs through three points each of the curve; nothing where they leave it by more than the
/// tolerance.
fn chain(
    motion: &Move,
    shape: &ArcShape,
    count: usize,
    tolerance_mm: f64,
) -> Option<Vec<SpiralPiece>> {
    let (a, b, _) = shape.plane.axes();
    let flat = |at: &PerAxis<f64>| Vec3::new(at[a], at[b], 0.0);
    let mut pieces = Vec::with_capacity(count);
    let mut from = motion.from;
    for index in 0..count {
        let at = |part: f64| point(motion, shape, (index as f64 + part) / count as f64);
        let to = if index + 1 == count { motion.to } else { at(1.0) };
        let arc = Arc::through(flat(&from), flat(&at(0.5)), flat(&to))?;
        let center = arc.center;
        let radius = arc.radius;
        // The curve leaves an arc through three of its points most at the middles between them.
        for part in [0.2, 0.25, 0.75, 0.8] {
            if (flat(&at(part)).distance(center) - radius).abs() > tolerance_mm {
                return None;
            }
        }
        let sweep = arc.sweep.abs() * shape.sweep.signum();
        pieces.push(SpiralPiece {
            motion: Move { from, to, ..*motion },
            shape: ArcShape {
                plane: shape.plane,
                center: [center.x, center.y],
                sweep,
                radius_from: radius,
                radius_to: radius,
            },
        });
        from = to;
    }
    Some(pieces)
}
