//! Evaluates a trajectory at instants that follow each other.

use crate::reader::{PieceReader, PieceView};
use crate::sample::{AxisState, MotionSample};
use crate::trajectory::{PlannedTrajectory, ProfilePoint};

/// A point of a trajectory.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct TrajectoryPlace {
    /// Index of the piece.
    pub piece: usize,
    /// σ from the start of the piece.
    pub sigma: f64,
    /// The velocity profile there.
    pub along: ProfilePoint,
}

/// Finds the point of a trajectory at a time, from the previous one on.
#[derive(Clone, Debug, Default)]
pub(crate) struct PieceCursor {
    piece: usize,
    piece_from: f64,
    phase: usize,
    phase_from_s: f64,
}

impl PieceCursor {
    /// The point at `t` s from the start, which must not be before the last one; `None` for an empty trajectory.
    #[inline(always)]
    pub fn to(
        &mut self,
        PlannedTrajectory { pieces, phases, .. }: &PlannedTrajectory,
        t: f64,
    ) -> Option<TrajectoryPlace> {
        let last_phase = phases.len().checked_sub(1)?;
        let last_piece = pieces.len().checked_sub(1)?;
        while self.phase < last_phase && t - self.phase_from_s >= phases[self.phase].duration_s {
            self.phase_from_s += phases[self.phase].duration_s;
            self.phase += 1;
        }
        let phase = &phases[self.phase];
        let along = phase.at((t - self.phase_from_s).clamp(0.0, phase.duration_s));
        while self.piece < last_piece && along.sigma - self.piece_from >= pieces[self.piece].length
        {
            self.piece_from += pieces[self.piece].length;
            self.piece += 1;
        }
        let sigma = (along.sigma - self.piece_from).clamp(0.0, pieces[self.piece].length);
        Some(TrajectoryPlace { piece: self.piece, sigma, along })
    }
}

/// Evaluates the axes at points of a trajectory.
#[derive(Clone, Debug, Default)]
pub(crate) struct PieceReading {
    /// The reader of the piece with this index.
    reader: Option<(usize, PieceReader)>,
}

impl PieceReading {
    /// Writes the axes and their derivatives at a point into a sample; its time is not changed.
    #[inline(always)]
    pub fn fill(
        &mut self,
        trajectory: &PlannedTrajectory,
        place: &TrajectoryPlace,
        out: &mut MotionSample,
    ) {
        let TrajectoryPlace { piece, sigma, along } = place;
        let part = PieceView::from(&trajectory.pieces[*piece]);
        let reader = match &mut self.reader {
            Some((at, reader)) => {
                if at != piece {
                    reader.go_on((&trajectory.pieces[*at]).into(), part);
                    *at = *piece;
                }
                reader
            }
            none => &mut none.insert((*piece, PieceReader::new(part))).1,
        };
        reader.fill(part, *sigma, along, out);
    }
}

/// Evaluates the axes along a trajectory in time.
#[derive(Clone, Debug, Default)]
pub struct TrajectoryCursor {
    pub(crate) walk: PieceCursor,
    pub(crate) reading: PieceReading,
}

impl TrajectoryCursor {
    /// The axes at `t` s from the start of the trajectory. Times must not go back; after the end
    /// the result is that of the end.
    pub fn at(&mut self, trajectory: &PlannedTrajectory, t: f64) -> AxisState {
        let mut sample = MotionSample::default();
        self.fill(trajectory, t, &mut sample);
        sample.into()
    }

    /// Continues on a copy of the trajectory that begins with the current phase and piece; returns the former
    /// indexes of both.
    pub(crate) fn rebase(&mut self) -> (usize, usize) {
        let gone = (self.walk.phase, self.walk.piece);
        (self.walk.phase, self.walk.piece) = (0, 0);
        match &mut self.reading.reader {
            Some((at, _)) if *at == gone.1 => *at = 0,
            reader => *reader = None,
        }
        gone
    }

    /// Writes the axes at `t` s into a sample; its time is not changed. An empty trajectory changes nothing.
    #[inline(always)]
    pub(crate) fn fill(&mut self, trajectory: &PlannedTrajectory, t: f64, out: &mut MotionSample) {
        if let Some(place) = self.walk.to(trajectory, t) {
            self.reading.fill(trajectory, &place, out);
        }
    }
}
