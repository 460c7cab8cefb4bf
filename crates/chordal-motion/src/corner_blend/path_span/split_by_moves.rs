//! What a run of curves keeps of its path: all of it, or only what times need.

use chordal_geometry::AXES;

use super::PathSpan;
use crate::piece::{PathPiece, ahead};

/// How the path of a run is divided among its moves.
pub trait SplitByMoves: Sized {
    /// What is kept of pieces that moves share: of each move where it ends, σ from the start of the
    /// pieces, and its tag, in order.
    fn of_moves(pieces: &[PathPiece], moves: impl Iterator<Item = (f64, u64)>) -> Vec<Self>;
}

impl SplitByMoves for PathPiece {
    /// The pieces cut where the next move begins, each with its tag.
    fn of_moves(pieces: &[PathPiece], moves: impl Iterator<Item = (f64, u64)>) -> Vec<PathPiece> {
        let mut out = Vec::with_capacity(pieces.len() + moves.size_hint().0);
        let mut moves = moves.peekable();
        let Some(mut here) = moves.next() else { return out };
        let mut at = 0.0;
        for piece in pieces {
            let end = at + piece.length;
            let mut done = 0.0;
            while done < piece.length {
                let (ends, tag) = here;
                let is_over = moves.peek().is_none() || ends >= end;
                let until = if is_over { piece.length } else { ends - at };
                if until > done {
                    let start =
                        if done > 0.0 { ahead(&piece.start, done, AXES) } else { piece.start };
                    out.push(PathPiece { length: until - done, start, tag, base: None });
                    done = until;
                }
                if ends <= end
                    && let Some(next) = moves.next()
                {
                    here = next;
                }
            }
            at = end;
        }
        out
    }
}

impl SplitByMoves for PathSpan {
    /// As long as the moves, whatever the pieces: on a curve nothing is straight.
    fn of_moves(_pieces: &[PathPiece], moves: impl Iterator<Item = (f64, u64)>) -> Vec<PathSpan> {
        let mut at = 0.0;
        let span = |(ends, tag)| {
            let length = ends - at;
            at = ends;
            PathSpan { length, tag, is_straight: false }
        };
        moves.map(span).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pieces of one line, x = σ, with these lengths.
    fn line(lengths: &[f64]) -> Vec<PathPiece> {
        let mut at = 0.0;
        let piece = |&length: &f64| {
            let mut start = [[0.0; AXES]; 4];
            (start[0][0], start[1][0]) = (at, 1.0);
            at += length;
            PathPiece { length, base: None, start, tag: 99 }
        };
        lengths.iter().map(piece).collect()
    }

    #[test]
    fn moves_and_pieces_share_the_path_wherever_they_end() {
        let pieces = line(&[1.0, 2.0, 0.5, 1.5]);
        for ends in [
            vec![5.0],
            vec![0.25, 0.5, 0.75, 4.0, 5.0],
            vec![1.0, 3.0, 3.5, 5.0],
            vec![0.5, 1.0, 3.25, 3.5, 4.0, 5.0],
            // The last one ends with the pieces, whatever rounding says.
            vec![2.0, 5.0 - 1e-13],
            vec![2.0, 5.0 + 1e-13],
        ] {
            let moves = || ends.iter().copied().zip(1..);
            let whole = PathPiece::of_moves(&pieces, moves());
            let mut at = 0.0;
            for piece in &whole {
                assert_eq!(piece.start[0][0], at);
                assert!(piece.length > 0.0);
                let owner = ends.iter().position(|end| at < *end - 1e-9).map(|index| index as u64);
                assert_eq!(Some(piece.tag - 1), owner, "{ends:?} at {at}");
                at += piece.length;
            }
            assert_eq!(at, 5.0);
            // Every move is as long in spans as in pieces.
            for span in PathSpan::of_moves(&pieces, moves()) {
                let own = whole.iter().filter(|piece| piece.tag == span.tag);
                let length: f64 = own.map(|piece| piece.length).sum();
                assert!((span.length - length).abs() < 1e-12, "{span:?} is {length} long");
            }
        }
    }
}
