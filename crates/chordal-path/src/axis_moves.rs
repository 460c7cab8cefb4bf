//! Moves in frames of the part as moves of the axes of a machine, which may be another one than that of the run.

use chordal_command::{
    AxisMask, Command, CommandKind, FeedMode, Move, PartFrame, Position, ProgramOffsets,
};
use chordal_geometry::{Curve, Line, ParamCurve, Vec3};
use chordal_kinematics::KinematicChain;

use crate::axis_path::{AxisPiece, AxisPieces, axis_pieces, tip_pieces};
use crate::builder::duration_s;
use crate::frame::ProgramFrame;
use crate::segment::{Segment, point};

/// Follows a run, and gives its moves in frames of the part (tool centre point control, tilted planes) as moves of axes.
#[derive(Clone, Debug)]
pub struct AxisMoves {
    frame: ProgramFrame,
    chain: Option<KinematicChain>,
    tolerance_mm: f64,
    /// Where the axes stand, in program coordinates without a frame of the part; `None` before the first move.
    stand: Option<Position>,
}

/// Why the axes of a move are not known.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum AxisMovesError {
    /// The program has not said where the tip is, or nobody has given the work offset.
    UnknownPlace,
    /// The machine file does not give the rotary axes, or not the points about which they turn.
    UnknownKinematics,
    /// After a move of the axes, such as that of G53.1, the tip is not where it is on the machine of the run, and the next
    /// move is a cut.
    TipMismatch,
}

impl std::fmt::Display for AxisMovesError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            AxisMovesError::UnknownPlace => {
                "where the axes are depends on the work offset and the tool length, which are not all known"
            }
            AxisMovesError::TipMismatch => {
                "the rotary axes have turned about other points, and the tip of the new machine is elsewhere where this cut begins"
            }
            AxisMovesError::UnknownKinematics => {
                "the machine file does not give the points about which the rotary axes turn"
            }
        })
    }
}

impl std::error::Error for AxisMovesError {}

/// A part of a move on the axes, with the time that it takes at the feed of the tip.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct TimedAxisPiece {
    /// The move of the axes.
    pub piece: AxisPiece,
    /// The number of the curve of the tip that it belongs to: a spline has several.
    pub curve: usize,
    /// Its share of the duration of that curve.
    pub share: f64,
    /// Its duration at the feed of the tip, s; 0 for rapids and without a feed.
    pub duration_s: f64,
}

impl AxisMoves {
    /// From the frame before the first command, for a machine with these rotary axes (`None`: without any, or they are not
    /// known), in straight motions that keep the tip within `tolerance_mm` of its path.
    pub fn new(frame: ProgramFrame, chain: Option<KinematicChain>, tolerance_mm: f64) -> AxisMoves {
        AxisMoves { frame, chain, tolerance_mm, stand: None }
    }

    /// Follows a command; true when the frame changed.
    pub fn follow(&mut self, command: &Command) -> bool {
        let before = self.frame.offsets();
        let changed = self.frame.follow(command);
        if changed && let Some(stand) = &mut self.stand {
            // The machine stands still while the offsets change.
            let now = self.frame.offsets();
            for (axis, value) in stand.iter_mut().enumerate() {
                let all = |offsets: &ProgramOffsets| offsets.work[axis] + offsets.tool[axis];
                *value += all(&before) - all(&now);
            }
        }
        changed
    }

    /// Whether coordinates are those of the part.
    pub fn is_on_part(&self) -> bool {
        self.frame.part_frame.is_some()
    }

    /// From program coordinates without a frame of the part to the frame of the run, mm; `first` is the first segment of a
    /// move.
    pub fn shift_to_run(&self, motion: &Move, first: &Segment) -> Vec3 {
        let plane = self.frame.part_frame.as_ref().map(|frame| frame.plane);
        let start = point(&motion.from);
        first.curve.start() - plane.map_or(start, |plane| plane.apply_point(start))
    }

    /// The frame of the part, with the rotary axes of the machine that makes the moves.
    fn on_machine(&self, frame: &PartFrame) -> PartFrame {
        // A rotation in space leaves the rotary axes out of account.
        let is_cartesian = frame.chain == Some(KinematicChain::CARTESIAN);
        let chain = if is_cartesian { frame.chain } else { self.chain };
        PartFrame { chain, ..*frame }
    }

    /// A move as moves of the axes, in program coordinates without a frame of the part; `None` where it is one already.
    /// Every move of the run must be given, in order.
    ///
    /// # Errors
    /// [`AxisMovesError`].
    pub fn pieces(
        &mut self,
        kind: &CommandKind,
        motion: &Move,
    ) -> Result<Option<Vec<TimedAxisPiece>>, AxisMovesError> {
        let pieces = match self.frame.part_frame.is_some() {
            true => Some(self.pieces_on_part(kind, motion)?),
            false => self.displaced(kind, motion)?.map(|piece| vec![piece]),
        };
        self.stand = Some(match pieces.as_ref().and_then(|pieces| pieces.last()) {
            Some(last) => position(last.piece.curve.end(), last.piece.rotary_to),
            None => motion.to,
        });
        Ok(pieces)
    }

    /// A move of the axes that begins where they stand, which on another machine may be elsewhere than in the run: the axes
    /// that it does not move stay there. `None` where the run has them at the same place.
    fn displaced(
        &self,
        kind: &CommandKind,
        motion: &Move,
    ) -> Result<Option<TimedAxisPiece>, AxisMovesError> {
        let Some(stand) = self.stand.filter(|_| motion.from_known.covers(AxisMask::LINEAR)) else {
            return Ok(None);
        };
        if point(&stand).distance(point(&motion.from)) < SAME_PLACE_MM {
            return Ok(None);
        }
        if kind.feed().is_some() {
            return Err(AxisMovesError::TipMismatch);
        }
        let end: Position = std::array::from_fn(|axis| {
            let moves = motion.from[axis] != motion.to[axis];
            if axis < 3 && !moves { stand[axis] } else { motion.to[axis] }
        });
        Ok(Some(rapid(point(&stand), point(&end), [rotary(&motion.from), rotary(&motion.to)])))
    }

    fn pieces_on_part(
        &self,
        kind: &CommandKind,
        motion: &Move,
    ) -> Result<Vec<TimedAxisPiece>, AxisMovesError> {
        let frame = self.frame.part_frame.as_ref().ok_or(AxisMovesError::UnknownPlace)?;
        let frame = self.on_machine(frame);
        let offsets = self.frame.offsets();
        let known = motion.from_known.and(motion.to_known);
        let is_aligned =
            [&motion.from, &motion.to].iter().all(|place| frame.is_aligned(place, &offsets));
        let is_placed = is_aligned || self.frame.known.covers(AxisMask::LINEAR);
        if !known.covers(AxisMask::LINEAR) || !is_placed {
            return Err(AxisMovesError::UnknownPlace);
        }
        let mut curves: Vec<(Curve, Option<AxisPieces>)> = Vec::new();
        tip_pieces(kind, motion, |curve, ends| {
            let pieces = axis_pieces(&frame, curve, ends, &offsets, self.tolerance_mm);
            curves.push((*curve, pieces));
        });
        let whole_mm: f64 = curves.iter().map(|(curve, _)| curve.length()).sum();
        let mut timed = Vec::new();
        for (number, (curve, pieces)) in curves.into_iter().enumerate() {
            let pieces = pieces.ok_or(AxisMovesError::UnknownKinematics)?;
            let part = if whole_mm > 0.0 { curve.length() / whole_mm } else { 1.0 };
            let seconds = kind.feed().map_or(0.0, |feed| match feed.mode {
                // The time is that of the whole block.
                FeedMode::InverseTime => duration_s(feed, motion, &curve) * part,
                FeedMode::PerTime | FeedMode::PerRevolution => duration_s(feed, motion, &curve),
            });
            timed.extend(pieces.map(|piece| TimedAxisPiece {
                piece,
                curve: number,
                share: piece.share,
                duration_s: seconds * piece.share,
            }));
        }
        self.begin_where_axes_stand(kind, &mut timed)?;
        Ok(timed)
    }

    /// A rapid begins where the axes stand, which on another machine may be elsewhere than the tip of the run says.
    fn begin_where_axes_stand(
        &self,
        kind: &CommandKind,
        timed: &mut Vec<TimedAxisPiece>,
    ) -> Result<(), AxisMovesError> {
        let (Some(stand), Some(first), Some(last)) = (self.stand, timed.first(), timed.last())
        else {
            return Ok(());
        };
        let [start, end] = [point(&stand), last.piece.curve.end()];
        if start.distance(first.piece.curve.start()) < SAME_PLACE_MM {
            return Ok(());
        }
        if kind.feed().is_some() {
            return Err(AxisMovesError::TipMismatch);
        }
        *timed = vec![rapid(start, end, [first.piece.rotary_from, last.piece.rotary_to])];
        Ok(())
    }
}

/// Places nearer to each other than this are the same, mm: far above rounding, far below any tolerance.
const SAME_PLACE_MM: f64 = 1e-6;

fn position(place: Vec3, [a, b, c]: [f64; 3]) -> Position {
    [place.x, place.y, place.z, a, b, c]
}

fn rotary(place: &Position) -> [f64; 3] {
    [place[3], place[4], place[5]]
}

/// A straight rapid.
fn rapid(start: Vec3, end: Vec3, [rotary_from, rotary_to]: [[f64; 3]; 2]) -> TimedAxisPiece {
    let curve = Curve::Line(Line { start, end });
    let piece = AxisPiece { curve, rotary_from, rotary_to, share: 1.0 };
    TimedAxisPiece { piece, curve: 0, share: 1.0, duration_s: 0.0 }
}
