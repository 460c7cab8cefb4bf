//! Guaranteed largest values of functions on an interval.

/// The smallest tolerance that is used: a smaller one is below the rounding of positions of machines.
pub(crate) const SMALLEST_TOLERANCE: f64 = 1e-9;

/// A limit of halvings, after which a piece is narrower than the rounding of its ends.
const MAX_HALVINGS: u32 = 48;

/// Parts that are looked at, at most: some thousand turns in one move. What is left then is bounded as it is, more loosely.
const MAX_PIECES: usize = 50_000;

/// A part of an interval with the values at its ends.
struct IntervalPiece {
    from: (f64, f64),
    to: (f64, f64),
    depth: u32,
}

/// An upper bound of a function on an interval, at most `tolerance` above its largest value, unless it rises and falls some
/// thousand times.
///
/// `excess` bounds how far the function is above the larger of its values at the ends of a part of the interval, and is
/// zero in the limit of narrow parts. Only parts that may hold the largest value are halved.
pub(crate) fn upper_bound(
    interval: (f64, f64),
    tolerance: f64,
    value: impl Fn(f64) -> f64,
    excess: impl Fn(f64, f64) -> f64,
) -> f64 {
    let tolerance = tolerance.max(SMALLEST_TOLERANCE);
    let at = |sigma: f64| (sigma, value(sigma));
    let (from, to) = (at(interval.0), at(interval.1));
    let mut largest = from.1.max(to.1);
    let mut bound = largest;
    let mut count = 0;
    let mut pieces = vec![IntervalPiece { from, to, depth: 0 }];
    while let Some(piece) = pieces.pop() {
        let ends = piece.from.1.max(piece.to.1);
        let own = ends + excess(piece.from.0, piece.to.0);
        count += 1;
        let is_last = piece.depth >= MAX_HALVINGS || count >= MAX_PIECES;
        if own <= largest + tolerance || is_last {
            bound = bound.max(own);
            continue;
        }
        let middle = at(0.5 * (piece.from.0 + piece.to.0));
        largest = largest.max(middle.1);
        let depth = piece.depth + 1;
        let halves = [
            IntervalPiece { from: piece.from, to: middle, depth },
            IntervalPiece { from: middle, to: piece.to, depth },
        ];
        pieces.extend(halves);
    }
    bound
}

/// How far a function with this bound of its second derivative is from its chord at most, on a width.
pub(crate) fn chord_excess(second: f64, width: f64) -> f64 {
    second * width * width / 8.0
}
