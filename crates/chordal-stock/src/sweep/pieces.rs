//! Divides moves into straight pieces, each with its largest distance from the path and the joint with the next one.

use chordal_geometry::{Curve, Line, ParamCurve, Vec3};

use super::TipMove;

/// A piece that is shorter in plan than this counts as vertical, mm: it is represented by its lower end, and its
/// length in plan counts as distance from the path. Far below any resolution, far above the rounding of coordinates.
const VERTICAL: f64 = 1e-5;

/// The largest curvature of a spline is taken from samples (see `SplinePiece::max_curvature`) and multiplied by this,
/// for what may be between them.
const BETWEEN_PLACES: f64 = 1.25;

/// Bound of the rounding error of heights at the ends of pieces, mm.
const END_ROUNDING_MM: f64 = 1e-9;

/// Most pieces of one move, so that a curve far larger than any machine takes little memory. With fewer pieces than
/// the tolerance needs, their distance from the path is larger and is accounted for.
const MAX_PIECES: f64 = 1e5;

/// How the next piece begins: the turn in plan between the two, and its rise per length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PieceJoint {
    pub cos: f64,
    pub sin: f64,
    pub slope: f64,
}

/// A straight piece of a path of the tip.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SweepPiece {
    /// Its start, mm; the lower end of a vertical one.
    pub start: Vec3,
    /// Its direction in plan, of length 1.
    pub along: [f64; 2],
    /// Its length in plan, mm.
    pub length: f64,
    /// Its rise per length in plan.
    pub slope: f64,
    /// The largest distance between the piece and its path (Hausdorff), mm.
    pub off: f64,
    /// The largest `off` in its run, mm. A column that is left to a neighbour gets its lower bound from the
    /// neighbour, which must therefore allow for this piece's distance, too.
    pub off_in_run: f64,
    /// Index of the move in its list.
    pub number: u32,
    pub tag: u32,
    /// Whether another piece of the run ends where this one begins.
    pub follows: bool,
    /// The joint with the next piece of the run; `None` for the last one.
    pub next: Option<PieceJoint>,
}

impl SweepPiece {
    /// Lower bound of the height of the tip on the path of the piece, mm.
    pub fn lowest(&self) -> f64 {
        self.start.z + (self.slope * self.length).min(0.0) - self.off_in_run - END_ROUNDING_MM
    }

    /// The piece without neighbours.
    pub fn alone(&self) -> SweepPiece {
        SweepPiece { follows: false, next: None, ..*self }
    }
}

/// Divides moves into pieces, and finds runs: pieces each of which begins where the last one ended.
pub(crate) struct MoveSplitter {
    tolerance: f64,
    /// The point and the tag with which a run may continue.
    open: Option<(Vec3, u32)>,
    /// Index of the first piece of the run.
    run_from: usize,
    pub pieces: Vec<SweepPiece>,
}

impl MoveSplitter {
    /// Pieces stay within `tolerance` of curves, mm.
    pub fn new(tolerance: f64) -> MoveSplitter {
        MoveSplitter { tolerance, open: None, run_from: 0, pieces: Vec::new() }
    }

    /// Ends the run: the next piece is not a neighbour.
    pub fn end_run(&mut self) {
        self.open = None;
        let run = &mut self.pieces[self.run_from..];
        let most = run.iter().map(|piece| piece.off).fold(0.0, f64::max);
        for piece in run {
            piece.off_in_run = most;
        }
        self.run_from = self.pieces.len();
    }

    /// The pieces, after the last run was ended.
    pub fn finish(mut self) -> Vec<SweepPiece> {
        self.end_run();
        self.pieces
    }

    /// Adds the pieces of a move. On a move that rises or falls, each changes its height by at most `drop` mm; by any
    /// amount if `drop` is not above zero.
    ///
    /// `heights`: the range of heights of the tip in which a move may change the stock. Above and below, a line is one
    /// piece each.
    pub fn add(&mut self, number: u32, path: &TipMove, drop: f64, heights: [f64; 2]) {
        let curve = &path.curve;
        let length = curve.length();
        if !(length.is_finite() && curve.start().is_finite() && curve.end().is_finite()) {
            self.end_run();
            return;
        }
        let curvature = match curve {
            Curve::Line(line) => return self.line(line, number, path.tag, drop, heights),
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

    /// Adds a straight move.
    fn line(&mut self, line: &Line, number: u32, tag: u32, drop: f64, [low, high]: [f64; 2]) {
        let fall = line.end.z - line.start.z;
        let [from, to] = [line.start.z, line.end.z].map(|z| z.max(low).min(high));
        let falls = if drop > 0.0 { (to - from).abs() / drop } else { 0.0 };
        if falls == 0.0 {
            return self.straight(line.start, line.end, 0.0, number, tag);
        }
        let count = falls.ceil().clamp(1.0, MAX_PIECES) as u64;
        let stops = (0..=count).map(|k| from + (to - from) * (k as f64 / count as f64));
        let mut at = line.start;
        for z in stops {
            if (z - at.z) * (line.end.z - z) > 0.0 {
                let share = (z - line.start.z) / fall;
                let next = line.start + (line.end - line.start) * share;
                let next = Vec3::new(next.x, next.y, z);
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

    /// The pieces of a line between two heights, in steps of a millimetre, with stock from -10 to 0.
    fn pieces(start: Vec3, end: Vec3) -> Vec<SweepPiece> {
        let mut splitter = MoveSplitter::new(0.1);
        let curve = Curve::Line(Line { start, end });
        splitter.add(0, &TipMove { curve, tag: 0 }, 1.0, [-10.0, 0.0]);
        splitter.finish()
    }

    /// The lower ends of the pieces of a plunge.
    fn lower_ends(from: f64, to: f64) -> Vec<f64> {
        let at = |z: f64| Vec3::new(3.0, 4.0, z);
        pieces(at(from), at(to)).iter().map(|piece| piece.start.z).collect()
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

    #[test]
    fn a_ramp_is_divided_where_it_meets_stock() {
        let ramp = pieces(Vec3::new(0.0, 0.0, 10.0), Vec3::new(30.0, 0.0, -1490.0));
        assert_eq!(ramp.len(), 12);
        let starts: Vec<f64> = ramp.iter().map(|piece| piece.start.z).collect();
        let inside = (0..=10).map(|mm| -f64::from(mm));
        assert_eq!(starts, [10.0].into_iter().chain(inside).collect::<Vec<_>>());
        let length: f64 = ramp.iter().map(|piece| piece.length).sum();
        assert!((length - 30.0).abs() < 1e-12, "{length}");
        assert!(ramp.iter().all(|piece| (piece.slope + 50.0).abs() < 1e-9));
        assert_eq!(pieces(Vec3::new(0.0, 0.0, -2.0), Vec3::new(9.0, 0.0, -2.0)).len(), 1);
    }
}
