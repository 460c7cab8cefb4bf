//! What a tool sweeps, computed from the moves of a cycle without the geometry of the cycle.

use chordal_geometry::TurnDirection;
use chordal_sinumerik::cycles::{
    CycleArguments, CycleFault, MillStep, MillingContext, milling_moves,
};

/// A cut: a line, or an arc about a centre; points with their level.
#[derive(Clone, Copy, Debug)]
pub enum CutPiece {
    /// From a point to a point.
    Line([f64; 3], [f64; 3]),
    /// Centre, radius, angle of the start, sweep (rad, negative clockwise), levels.
    Arc { center: [f64; 2], radius: f64, from: f64, sweep: f64, levels: [f64; 2] },
}

/// A move in its order.
#[derive(Clone, Copy, Debug)]
pub enum SweptMove {
    /// At rapid.
    Rapid([f64; 3], [f64; 3]),
    /// At feed.
    Cut(CutPiece),
}

impl CutPiece {
    /// A point at a part of its length, 0 to 1.
    pub fn at(&self, part: f64) -> [f64; 3] {
        match *self {
            CutPiece::Line(from, to) => {
                std::array::from_fn(|axis| from[axis] + (to[axis] - from[axis]) * part)
            }
            CutPiece::Arc { center, radius, from, sweep, levels } => {
                let (sin, cos) = (from + sweep * part).sin_cos();
                let level = levels[0] + (levels[1] - levels[0]) * part;
                [center[0] + radius * cos, center[1] + radius * sin, level]
            }
        }
    }

    /// Whether it lies at a level or below it, all along (`up` is 1 where the cycle works downward).
    pub fn is_below(&self, level: f64, up: f64) -> bool {
        [0.0, 1.0].iter().all(|part| (self.at(*part)[2] - level) * up <= 1e-7)
    }

    /// The distance of a point of the plane.
    pub fn distance(&self, point: [f64; 2]) -> f64 {
        match *self {
            CutPiece::Line(from, to) => {
                let along = [to[0] - from[0], to[1] - from[1]];
                let square = along[0] * along[0] + along[1] * along[1];
                let offset = [point[0] - from[0], point[1] - from[1]];
                let part = match square > 0.0 {
                    true => {
                        ((offset[0] * along[0] + offset[1] * along[1]) / square).clamp(0.0, 1.0)
                    }
                    false => 0.0,
                };
                (offset[0] - along[0] * part).hypot(offset[1] - along[1] * part)
            }
            CutPiece::Arc { center, radius, from, sweep, .. } => {
                let offset = [point[0] - center[0], point[1] - center[1]];
                let turned = (offset[1].atan2(offset[0]) - from) * sweep.signum();
                if turned.rem_euclid(std::f64::consts::TAU) <= sweep.abs() {
                    return (offset[0].hypot(offset[1]) - radius).abs();
                }
                let ends = [self.at(0.0), self.at(1.0)];
                let distance = |end: [f64; 3]| (point[0] - end[0]).hypot(point[1] - end[1]);
                distance(ends[0]).min(distance(ends[1]))
            }
        }
    }
}

/// The arguments of a call from their text.
pub fn arguments(text: &str) -> CycleArguments {
    let value = |part: &str| match part.trim() {
        "" => None,
        number => Some(number.parse().expect("a number")),
    };
    CycleArguments::new(&text.split(',').map(value).collect::<Vec<_>>())
}

/// The moves of calls one after the other, from a position.
///
/// # Errors
/// The fault of the first call that is refused.
pub fn swept(
    name: &str,
    calls: &[String],
    context: &MillingContext,
) -> Result<Vec<SweptMove>, CycleFault> {
    let mut at = context.position;
    let mut moves = Vec::new();
    for call in calls {
        let found =
            milling_moves(name, &arguments(call), &MillingContext { position: at, ..*context })?;
        for step in found.steps {
            match step {
                MillStep::Rapid(to) => {
                    moves.push(SweptMove::Rapid(at, to));
                    at = to;
                }
                MillStep::Line { to, .. } => {
                    moves.push(SweptMove::Cut(CutPiece::Line(at, to)));
                    at = to;
                }
                MillStep::Arc { center, direction, to, turns, .. } => {
                    moves.push(SweptMove::Cut(arc(at, to, center, direction, turns)));
                    at = to;
                }
                MillStep::SpindleSpeed(_) => {}
            }
        }
    }
    Ok(moves)
}

fn arc(
    at: [f64; 3],
    to: [f64; 3],
    center: [f64; 2],
    direction: TurnDirection,
    turns: u32,
) -> CutPiece {
    let radii = [at, to].map(|point| (point[0] - center[0]).hypot(point[1] - center[1]));
    // Coordinates of 1e10 have steps of 2e-6.
    let coordinates = [at[0], at[1], to[0], to[1], center[0], center[1]];
    let largest = coordinates.into_iter().map(f64::abs).fold(0.0, f64::max);
    let rounding = 4.0 * f64::EPSILON * largest;
    let limit = 1e-9 * (1.0 + radii[0]) + rounding;
    assert!((radii[0] - radii[1]).abs() <= limit, "radii of an arc: {radii:?}");
    let [from, end] = [at, to].map(|point| (point[1] - center[1]).atan2(point[0] - center[0]));
    let tau = std::f64::consts::TAU;
    let turn = match [at[0], at[1]] == [to[0], to[1]] {
        true => tau,
        false => ((end - from) * direction.sign()).rem_euclid(tau),
    };
    let sweep = direction.sign() * (turn + tau * f64::from(turns));
    CutPiece::Arc { center, radius: radii[0], from, sweep, levels: [at[2], to[2]] }
}

/// The cuts among moves.
pub fn cuts(moves: &[SweptMove]) -> Vec<CutPiece> {
    let cut = |each: &SweptMove| match each {
        SweptMove::Cut(piece) => Some(*piece),
        SweptMove::Rapid(..) => None,
    };
    moves.iter().filter_map(cut).collect()
}

/// The first rapid that goes below the start plane where nothing has been cut before; `None` when there is none. A tool of a
/// radius is sampled at its centre and its edge.
pub fn rapid_in_material(
    moves: &[SweptMove],
    start: f64,
    radius: f64,
    up: f64,
    outside: impl Fn([f64; 2]) -> bool,
) -> Option<String> {
    let mut done: Vec<CutPiece> = Vec::new();
    for each in moves {
        let (from, to) = match each {
            SweptMove::Cut(piece) => {
                done.push(*piece);
                continue;
            }
            SweptMove::Rapid(from, to) => (*from, *to),
        };
        let lowest = if from[2] * up < to[2] * up { from[2] } else { to[2] };
        if (lowest - start) * up >= -1e-9 {
            continue;
        }
        for part in [0.0, 0.5, 1.0] {
            let center = [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * part);
            for index in 0..9 {
                let (sin, cos) = (f64::from(index) * std::f64::consts::TAU / 8.0).sin_cos();
                let reach = if index == 8 { 0.0 } else { radius * (1.0 - 1e-6) };
                let point = [center[0] + reach * cos, center[1] + reach * sin];
                let is_cut = done.iter().any(|piece| {
                    piece.is_below(lowest, up) && piece.distance(point) <= radius * (1.0 + 1e-9)
                });
                if !is_cut && !outside(point) {
                    return Some(format!("{each:?} passes {point:?}"));
                }
            }
        }
    }
    None
}

/// The levels at which cuts lie in the plane, from the highest on.
pub fn flat_levels(cuts: &[CutPiece], up: f64) -> Vec<f64> {
    let mut levels: Vec<f64> = Vec::new();
    for cut in cuts {
        let [from, to] = [cut.at(0.0), cut.at(1.0)];
        let is_flat = from[2] == to[2];
        if is_flat && !levels.iter().any(|level| (level - from[2]).abs() <= 1e-9) {
            levels.push(from[2]);
        }
    }
    levels.sort_by(|a, b| (b * up).total_cmp(&(a * up)));
    levels
}
