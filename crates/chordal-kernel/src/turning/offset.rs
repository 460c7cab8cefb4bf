//! The offset of a contour, as LinuxCNC computes it: each line and arc along its normal, arcs round outside corners,
//! intersections at inside ones. Coordinates are (along the passes, across them).

use chordal_command::Origin;

use crate::turning::profile::ContourEdge;

/// Shorter pieces, and arcs of a smaller radius, are dropped, in units of the program.
const GONE: f64 = 1e-3;

/// Ends closer than this need no intersection, in units of the program.
const MEETS: f64 = 1e-6;

/// Larger gaps along the contour are closed by an arc round the corner, in units of the program.
const MIN_CORNER_GAP_MM: f64 = 1e-2;

/// Largest number of steps of one offset.
const MAX_STEPS: usize = 10_000;

/// A line or an arc; the angle of an arc follows from its ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct OffsetPiece {
    /// Its start.
    pub from: [f64; 2],
    /// Its end.
    pub to: [f64; 2],
    /// Centre of an arc, and whether it turns from the first axis to the second; `None` for a line.
    pub arc: Option<([f64; 2], bool)>,
    /// Its block.
    pub origin: Origin,
}

impl OffsetPiece {
    /// The piece of an edge in the same coordinates.
    pub fn of(edge: &ContourEdge) -> OffsetPiece {
        let arc = edge.arc.map(|(center, sweep)| (center, sweep > 0.0));
        OffsetPiece { from: edge.from, to: edge.to, arc, origin: edge.origin }
    }

    /// The piece as an edge.
    pub fn edge(&self) -> ContourEdge {
        let arc = self.arc.map(|(center, ccw)| {
            let angle = |at: [f64; 2]| libm::atan2(at[1] - center[1], at[0] - center[0]);
            let turn = 2.0 * std::f64::consts::PI;
            let sweep = (angle(self.to) - angle(self.from)).rem_euclid(turn);
            (center, if ccw { sweep } else { sweep - turn })
        });
        ContourEdge { from: self.from, to: self.to, arc, origin: self.origin }
    }

    /// Its chord, and for an arc at most its radius; half of it is the largest step of an offset.
    fn size(&self) -> f64 {
        let chord = distance(self.from, self.to);
        self.arc.map_or(chord, |(center, _)| chord.min(distance(self.from, center)))
    }

    /// True when it continues along the passes: to smaller numbers, an arc without reversing.
    pub fn goes_on(&self, unit: f64) -> bool {
        let along = self.to[0] - self.from[0];
        let Some((center, ccw)) = self.arc else { return along <= GONE * unit };
        let side = if ccw { 1.0 } else { -1.0 };
        let inside = |at: [f64; 2]| (at[1] - center[1]) * side >= -GONE * unit;
        inside(self.from) && inside(self.to) && along <= -GONE * unit
    }

    fn moved(&self, by: f64) -> OffsetPiece {
        match self.arc {
            None => {
                let length = distance(self.from, self.to);
                let back = [0, 1].map(|axis| (self.from[axis] - self.to[axis]) / length);
                let by = [-back[1] * by, back[0] * by];
                let shift = |at: [f64; 2]| [at[0] + by[0], at[1] + by[1]];
                OffsetPiece { from: shift(self.from), to: shift(self.to), ..*self }
            }
            Some((center, ccw)) => {
                let radius = distance(self.from, center);
                let factor = (radius + if ccw { by } else { -by }) / radius;
                let scale = |at: [f64; 2]| [0, 1].map(|i| center[i] + (at[i] - center[i]) * factor);
                OffsetPiece { from: scale(self.from), to: scale(self.to), ..*self }
            }
        }
    }
}

/// Offsets the contour, without its first move, to the side where that move starts; the first move then ends at the
/// offset contour. `unit` is the unit of the program, mm, for the tolerances above.
pub(super) fn offset(pieces: &mut Vec<OffsetPiece>, by: f64, unit: f64) {
    let (Some(first), Some(last)) = (pieces.first().copied(), pieces.last()) else { return };
    if by == 0.0 || pieces.len() < 2 {
        return;
    }
    let entry = [first.to[0] - first.from[0], first.to[1] - first.from[1]];
    let far = [last.from[0] - first.from[0], last.from[1] - first.from[1]];
    let by = if cross(far, entry) < 0.0 { -by } else { by };
    let mut rest = pieces.split_off(1);
    let mut done = 0.0;
    for _ in 0..MAX_STEPS {
        if done == by || rest.is_empty() {
            break;
        }
        let most = rest.iter().map(|piece| piece.size() / 2.0).fold(f64::INFINITY, f64::min);
        let step = most.min((by - done).abs());
        let step = if by < 0.0 { -step } else { step };
        rest = rest.iter().map(|piece| piece.moved(step)).collect();
        rest.retain(|piece| piece.size() >= GONE * unit);
        round_corners(&mut rest, step, by > 0.0, unit);
        drop_turned(&mut rest, unit);
        done = if step.abs() == (by - done).abs() { by } else { done + step };
    }
    for index in 1..rest.len() {
        let middle = [0, 1].map(|i| (rest[index - 1].to[i] + rest[index].from[i]) / 2.0);
        rest[index - 1].to = middle;
        rest[index].from = middle;
    }
    if let (Some(first), Some(next)) = (pieces.first_mut(), rest.first()) {
        first.to = next.from;
    }
    pieces.append(&mut rest);
}

/// Inserts arcs where the offset opens a gap between two neighbours.
fn round_corners(rest: &mut Vec<OffsetPiece>, step: f64, ccw: bool, unit: f64) {
    let mut index = 0;
    while index + 1 < rest.len() {
        let (one, next) = (rest[index], rest[index + 1]);
        if one.to[0] - next.from[0] > MIN_CORNER_GAP_MM * unit {
            let (before, after) = (one.moved(-step).to, next.moved(-step).from);
            let center = [0, 1].map(|i| (before[i] + after[i]) / 2.0);
            let arc = Some((center, ccw));
            rest.insert(
                index + 1,
                OffsetPiece { from: one.to, to: next.from, arc, origin: next.origin },
            );
            index += 1;
        }
        index += 1;
    }
}

/// Intersects neighbours, and removes pieces that the offset has reversed.
fn drop_turned(rest: &mut Vec<OffsetPiece>, unit: f64) {
    let mut index = 0;
    while index + 1 < rest.len() {
        if !rest[index].goes_on(unit) && index > 0 {
            let smaller = rest[index].size() < rest[index - 1].size();
            rest.remove(if smaller { index } else { index - 1 });
            index = 0;
            continue;
        }
        if rest[index].size() < GONE * unit {
            rest.remove(index);
            index = 0;
            continue;
        }
        let (one, next) = rest.split_at_mut(index + 1);
        meet(&mut one[index], &mut next[0], unit);
        index += 1;
    }
}

/// Moves the end and start of two neighbours to their intersection.
fn meet(one: &mut OffsetPiece, next: &mut OffsetPiece, unit: f64) {
    if distance(one.to, next.from) < MEETS * unit {
        return;
    }
    let at = match (one.arc, next.arc) {
        (None, None) => lines_meet(one, next),
        (None, Some((center, _))) => {
            line_meets(one, center, distance(next.from, center), next.from)
        }
        (Some((center, _)), None) => {
            line_meets(next, center, distance(one.from, center), next.from)
        }
        (Some((a, ccw)), Some((b, other))) if ccw == other => arcs_meet(one, a, next, b),
        _ => None,
    };
    if let Some(at) = at {
        one.to = at;
        next.from = at;
    }
}

fn lines_meet(one: &OffsetPiece, next: &OffsetPiece) -> Option<[f64; 2]> {
    let u = [one.to[0] - one.from[0], one.to[1] - one.from[1]];
    let v = [next.to[0] - next.from[0], next.to[1] - next.from[1]];
    let between = [next.from[0] - one.from[0], next.from[1] - one.from[1]];
    let det = cross(u, v);
    let share = cross(between, v) / det;
    (det != 0.0).then(|| [0, 1].map(|i| one.from[i] + u[i] * share))
}

/// The intersection of a line with a circle that is nearer to `near`.
fn line_meets(
    line: &OffsetPiece,
    center: [f64; 2],
    radius: f64,
    near: [f64; 2],
) -> Option<[f64; 2]> {
    let length = distance(line.from, line.to);
    let u = [0, 1].map(|i| (line.to[i] - line.from[i]) / length);
    let to = [center[0] - line.from[0], center[1] - line.from[1]];
    let (along, off) = (to[0] * u[0] + to[1] * u[1], cross(u, to));
    let half = (radius * radius - off * off).max(0.0).sqrt();
    let place = |s: f64| [0, 1].map(|i| line.from[i] + u[i] * s);
    let (a, b) = (place(along - half), place(along + half));
    Some(if distance(a, near) < distance(b, near) { a } else { b })
}

fn arcs_meet(one: &OffsetPiece, a: [f64; 2], next: &OffsetPiece, b: [f64; 2]) -> Option<[f64; 2]> {
    let (r, q, c) = (distance(next.from, b), distance(one.from, a), distance(a, b));
    if c == 0.0 {
        return None;
    }
    let cos = (c * c + r * r - q * q) / (2.0 * r * c);
    let sin = (1.0 - cos * cos).max(0.0).sqrt();
    let to = [0, 1].map(|i| (a[i] - b[i]) / c * r);
    Some([b[0] + to[0] * cos - to[1] * sin, b[1] + to[0] * sin + to[1] * cos])
}

pub(super) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    libm::hypot(a[0] - b[0], a[1] - b[1])
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}
