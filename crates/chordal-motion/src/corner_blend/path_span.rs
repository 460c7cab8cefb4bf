//! What a planner keeps of the path: the whole piece, or its length and speed only.

mod split_by_moves;

use crate::piece::PathPiece;
use split_by_moves::SplitByMoves;

/// A piece of path of which only the extent is known. Times need no more.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathSpan {
    /// Its extent in σ.
    pub length: f64,
    /// The tag of its move.
    pub tag: u64,
    /// It is a straight line, evenly travelled.
    pub is_straight: bool,
}

/// What a planner may keep of the path: all of it or its extents.
pub trait PathPart: Copy + sealed::PathStorage + SplitByMoves {
    /// Its extent in σ.
    fn length(&self) -> f64;
    /// The tag of its move.
    fn tag(&self) -> u64;
    /// Whether it is a straight line, evenly travelled.
    fn is_straight(&self) -> bool;
}

impl PathPart for PathPiece {
    fn length(&self) -> f64 {
        self.length
    }

    fn tag(&self) -> u64 {
        self.tag
    }

    fn is_straight(&self) -> bool {
        PathPiece::is_straight(self)
    }
}

impl PathPart for PathSpan {
    fn length(&self) -> f64 {
        self.length
    }

    fn tag(&self) -> u64 {
        self.tag
    }

    fn is_straight(&self) -> bool {
        self.is_straight
    }
}

pub(crate) mod sealed {
    use chordal_geometry::AXES;

    use super::PathSpan;
    use crate::corner_blend::leg::{LegPart, PathLeg};
    use crate::piece::{AxisJet, PathPiece, go_ahead};

    /// How parts of a path are kept.
    pub trait PathStorage: Sized {
        /// Adds the piece of a part of a leg between two places. The jet is that of the corrections
        /// `distance` before.
        fn add(
            to: &mut Vec<Self>,
            leg: &PathLeg,
            part: &LegPart,
            jet: (&AxisJet, f64),
            places: [f64; 2],
        );

        /// What is kept of a piece.
        fn of(piece: &PathPiece) -> Self;

        /// Makes it longer by another where one of them says as much as both.
        fn take_in(&mut self, next: &Self) -> bool;

        /// The path, where it is known.
        fn path(parts: &[Self]) -> Option<&[PathPiece]>;
    }

    impl PathStorage for PathPiece {
        fn add(
            to: &mut Vec<PathPiece>,
            leg: &PathLeg,
            part: &LegPart,
            (jet, distance): (&AxisJet, f64),
            [at, end]: [f64; 2],
        ) {
            let done = at - part.from;
            // In its place, as it is large.
            to.push(PathPiece { length: end - at, base: None, start: *jet, tag: part.tag });
            let Some(piece) = to.last_mut() else { return };
            if let Some(curve) = leg.curve.as_deref() {
                piece.base = Some((*curve, at - leg.from));
            }
            if distance > 0.0 {
                go_ahead(&mut piece.start, distance, AXES);
            }
            let [position, first, ..] = &mut piece.start;
            for (axis, direction) in part.direction.iter().enumerate() {
                position[axis] += part.start[axis] + direction * done;
                first[axis] += direction;
            }
        }

        fn of(piece: &PathPiece) -> PathPiece {
            *piece
        }

        fn take_in(&mut self, _next: &PathPiece) -> bool {
            false
        }

        fn path(parts: &[PathPiece]) -> Option<&[PathPiece]> {
            Some(parts)
        }
    }

    impl PathStorage for PathSpan {
        fn add(
            to: &mut Vec<PathSpan>,
            leg: &PathLeg,
            part: &LegPart,
            (jet, _): (&AxisJet, f64),
            [at, end]: [f64; 2],
        ) {
            let even = jet[2] == [0.0; AXES] && jet[3] == [0.0; AXES];
            let is_straight = even && leg.curve.is_none();
            to.push(PathSpan { length: end - at, tag: part.tag, is_straight });
        }

        fn of(piece: &PathPiece) -> PathSpan {
            PathSpan { length: piece.length, tag: piece.tag, is_straight: piece.is_straight() }
        }

        fn take_in(&mut self, next: &PathSpan) -> bool {
            let like = self.tag == next.tag && self.is_straight == next.is_straight;
            if like {
                self.length += next.length;
            }
            like
        }

        fn path(_parts: &[PathSpan]) -> Option<&[PathPiece]> {
            None
        }
    }
}
