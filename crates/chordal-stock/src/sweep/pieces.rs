//! Moves as straight pieces, each with how far the path may lie from it, and how the next one goes on.

use chordal_geometry::{Curve, Line, ParamCurve, Vec3};

use super::TipMove;

/// Shorter in plan than this a piece is vertical, mm: its lower end is taken, its length counts as distance
/// from the path. Far below any resolution, far above the rounding of coordinates.
const VERTICAL: f64 = 1e-5;

/// The largest curvature of a spline is found among places (see `SplinePiece::max_curvature`): this much more
/// is taken for what may lie between them.
const BETWEEN_PLACES: f64 = 1.25;

/// Heights at the ends of pieces are as exact as this, mm.
const END_ROUNDING_MM: f64 = 1e-9;

/// The most pieces of one move, so that a curve far larger than any machine takes no memory to speak of. Fewer
/// pieces than the tolerance asks for lie further off, and say so.
const MAX_PIECES: f64 = 1e5;

/// How the piece after this one begins: the turn in plan from here to there, and its rise by length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PieceJoint {
    pub cos: f64,
    pub sin: f64,
    pub slope: f64,
}

/// A straight piece of a path of the tip.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SweepPiece {
    /// Where it begins, mm; of a vertical one the lower end.
    pub start: Vec3,
    /// Its direction in plan, of length 1.
    pub along: [f64; 2],
    /// Its length in plan, mm.
    pub length: f64,
    /// Its rise by length in plan.
    pub slope: f64,
    /// The path lies within this of it, mm, and it of the path.
    pub off: f64,
    /// The largest of these distances in its run, mm. What is left to a neighbour is bounded from below by
    /// the neighbour, so the neighbour must allow for this piece's distance too.
    pub off_in_run: f64,
    /// Number of the move in its list.
    pub number: u32,
    pub tag: u32,
    /// Whether another piece of the run ends where it begins.
    pub follows: bool,
    /// The piece of the run that begins where it ends.
    pub next: Option<PieceJoint>,
}

impl SweepPiece {
    /// The tip is nowhere lower on the path of the piece, mm.
    pub fn lowest(&self) -> f64 {
        self.start.z + (self.slope * self.length).min(0.0) - self.off_in_run - END_ROUNDING_MM
    }

    /// The piece without neighbours.
    pub fn alone(&self) -> SweepPiece {
        SweepPiece { follows: false, next: None, ..*self }
    }
}

/// Cuts moves into pieces, and finds runs: pieces each of which begins where the last one ended.
pub(crate) struct MoveSplitter {
    tolerance: f64,
    /// The place and the tag where a run may go on.
    open: Option<(Vec3, u32)>,
    /// Where the run begins in `pieces`.
    run_from: usize,
    pub pieces: Vec<SweepPiece>,
}

impl MoveSplitter {
    /// Pieces may lie so far from curves, mm.
    pub fn new(tolerance: f64) -> MoveSplitter {
        MoveSplitter { tolerance, open: None, run_from: 0, pieces: Vec::new() }
    }

    /// Ends the run: what comes next is no neighbour.
    pub fn end_run(&mut self) {
        self.open = None;
        let run = &mut self.pieces[self.run_from..];
        let most = run.iter().map(|piece| piece.off).fold(0.0, f64::max);
        for piece in run {
            piece.off_in_run = most;
        }
        self.run_from = self.pieces.len();
    }

    /// The pieces, all runs ended.
    pub fn finish(mut self) -> Vec<SweepPiece> {
        self.end_run();
        self.pieces
    }

    /// Adds the pieces of a move, each of at most `drop` mm of height where the move only rises or falls; of any
    /// height if that is not above zero.
    ///
    /// `heights`: the least and the largest height of the tip between which a plunge may find another stock at each
    /// piece. Above and below nothing changes, so that what is left of a plunge is one piece.
    pub fn add(&mut self, number: u32, path: &TipMove, drop: f64, heights: [f64; 2]) {
        let curve = &path.curve;
        let length = curve.length();
        if !(length.is_finite() && curve.start().is_finite() && curve.end().is_finite()) {
            self.end_run();
            return;
        }
        if let Curve::Line(line) = curve
            && libm::hypot(line.end.x - line.start.x, line.end.y - line.start.y) <= VERTICAL
        {
            self.plunge(line, number, path.tag, drop, heights);
            return;
        }
        let curvature = match curve {
            Curve::Line(_) => 0.0,
            Curve::Spline(_) => curve.max_curvature() * BETWEEN_PLACES,
            Curve::Arc(_) | Curve::Spiral(_) => curve.max_curvature(),
        };
        let bends = length * (curvature / (8.0 * self.tolerance)).sqrt();
        let bounds = curve.bounds().size();
        let falls = if drop > 0.0 { bounds.z / drop } else { 0.0 };
        let count = bends.max(falls).ceil().clamp(1.0, MAX_PIECES);
        let step = length / count;
        let off = curvature * step * step / 8.0;
        let count = count as u64;
        let mut from = curve.start();
        for k in 1..=count {
            let to = if k == count { curve.end() } else { curve.point_at(step * k as f64) };
            self.straight(from, to, off, number, path.tag);
            from = to;
        }
    }

    /// A move along Z.
    fn plunge(&mut self, line: &Line, number: u32, tag: u32, drop: f64, [low, high]: [f64; 2]) {
        let [from, to] = [line.start.z, line.end.z].map(|z| z.max(low).min(high));
        let falls = if drop > 0.0 { (to - from).abs() / drop } else { 0.0 };
        let count = falls.ceil().clamp(1.0, MAX_PIECES) as u64;
        let stops = (0..=count).map(|k| from + (to - from) * (k as f64 / count as f64));
        let mut at = line.start;
        for z in stops {
            if (z - at.z) * (line.end.z - z) > 0.0 {
                let next = Vec3::new(line.start.x, line.start.y, z);
                self.straight(at, next, 0.0, number, tag);
                at = next;
            }
        }
        self.straight(at, line.end, 0.0, number, tag);
    }

    fn straight(&mut self, from: Vec3, to: Vec3, off: f64, number: u32, tag: u32) {
        let (dx, dy) = (to.x - from.x, to.y - from.y);
        let length = libm::hypot(dx, dy);
        if length <= VERTICAL {
            self.end_run();
            let start = if to.z < from.z { to } else { from };
            self.pieces.push(SweepPiece {
                start,
                along: [1.0, 0.0],
                length: 0.0,
                slope: 0.0,
                off: off + length,
                off_in_run: off + length,
                number,
                tag,
                follows: false,
                next: None,
            });
            self.end_run();
            return;
        }
        let along = [dx / length, dy / length];
        let slope = (to.z - from.z) / length;
        let follows = self.open == Some((from, tag));
        if !follows {
            self.end_run();
        }
        if follows && let Some(last) = self.pieces.last_mut() {
            last.next = Some(PieceJoint {
                cos: last.along[0] * along[0] + last.along[1] * along[1],
                sin: last.along[0] * along[1] - last.along[1] * along[0],
                slope,
            });
        }
        self.pieces.push(SweepPiece {
            start: from,
            along,
            length,
            slope,
            off,
            off_in_run: off,
            number,
            tag,
            follows,
            next: None,
        });
        self.open = Some((to, tag));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The lower ends of the pieces of a plunge between two heights, in steps of a millimetre, with stock from -10 to 0.
    fn lower_ends(from: f64, to: f64) -> Vec<f64> {
        let at = |z: f64| Vec3::new(3.0, 4.0, z);
        let line = Line { start: at(from), end: at(to) };
        let mut splitter = MoveSplitter::new(0.1);
        splitter.add(0, &TipMove { curve: Curve::Line(line), tag: 0 }, 1.0, [-10.0, 0.0]);
        splitter.finish().iter().map(|piece| piece.start.z).collect()
    }

    #[test]
    fn a_plunge_is_divided_where_it_meets_stock() {
        let inside: Vec<f64> = (1..=10).map(|mm| -f64::from(mm)).collect();
        let down = lower_ends(50.0, -1e6);
        assert_eq!(down, [&[0.0], &inside[..], &[-1e6]].concat());
        let up: Vec<f64> = lower_ends(-1e6, 50.0);
        let rising: Vec<f64> = (1..=10).rev().map(|mm| -f64::from(mm)).collect();
        assert_eq!(up, [&[-1e6], &rising[..], &[0.0]].concat());
        assert_eq!(lower_ends(-2.5, -4.0), [-3.25, -4.0]);
        assert_eq!(lower_ends(90.0, 5.0), [5.0]);
        assert_eq!(lower_ends(-20.0, -30.0), [-30.0]);
        assert_eq!(lower_ends(7.0, 7.0), [7.0]);
    }
}
