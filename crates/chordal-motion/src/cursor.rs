//! The axes at an instant of a trajectory, one instant after the other.

use crate::reader::{PieceReader, PieceView};
use crate::sample::{AxisState, MotionSample};
use crate::trajectory::{PlannedTrajectory, ProfilePoint};

/// A place on a trajectory.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct TrajectoryPlace {
    /// Number of the piece.
    pub piece: usize,
    /// From the start of that.
    pub sigma: f64,
    /// The velocity profile there.
    pub along: ProfilePoint,
}

/// Follows a trajectory in time: finds positions.
#[derive(Clone, Debug, Default)]
pub(crate) struct PieceCursor {
    piece: usize,
    piece_from: f64,
    phase: usize,
    phase_from_s: f64,
}

impl PieceCursor {
    /// The place at `t` s from the start, not before the last; `None` where there is nothing.
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

/// Reads the axes at places of a trajectory.
#[derive(Clone, Debug, Default)]
pub(crate) struct PieceReading {
    /// Of the piece with this number.
    reader: Option<(usize, PieceReader)>,
}

impl PieceReading {
    /// Writes what the axes do at a place into a sample, whose time stays.
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

/// Follows a trajectory in time.
#[derive(Clone, Debug, Default)]
pub struct TrajectoryCursor {
    pub(crate) walk: PieceCursor,
    pub(crate) reading: PieceReading,
}

impl TrajectoryCursor {
    /// The axes at `t` s from the start of the trajectory. Times must not go back; beyond the end
    /// the answer is its end.
    pub fn at(&mut self, trajectory: &PlannedTrajectory, t: f64) -> AxisState {
        let mut sample = MotionSample::default();
        self.fill(trajectory, t, &mut sample);
        sample.into()
    }

    /// Goes over to a copy of the trajectory that begins with the phase and the piece under way: the
    /// numbers of both.
    pub(crate) fn rebase(&mut self) -> (usize, usize) {
        let gone = (self.walk.phase, self.walk.piece);
        (self.walk.phase, self.walk.piece) = (0, 0);
        match &mut self.reading.reader {
            Some((at, _)) if *at == gone.1 => *at = 0,
            reader => *reader = None,
        }
        gone
    }

    /// The same written into a sample, whose time stays. A trajectory of nothing changes nothing.
    #[inline(always)]
    pub(crate) fn fill(&mut self, trajectory: &PlannedTrajectory, t: f64, out: &mut MotionSample) {
        if let Some(place) = self.walk.to(trajectory, t) {
            self.reading.fill(trajectory, &place, out);
        }
    }
}
