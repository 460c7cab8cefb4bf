//! A run: smooth pieces with their speeds and the axis limits.

use chordal_geometry::AXES;

use crate::limits::KinematicLimits;
use crate::piece::{AxisJet, PathPiece};

/// Speeds above this, in σ per s, are no limit.
const NO_SPEED_LIMIT: f64 = 1e9;

/// Points that are nearer to each other than this fraction of their distance from the start are the same.
const EQUAL_PLACE_SHARE: f64 = 1e-9;

/// Smooth pieces of path, at whose end the axes rest.
#[derive(Clone, Debug)]
pub struct PathRun<'a> {
    pieces: &'a [PathPiece],
    speeds: &'a [f64],
    /// Where each piece begins, and where the last one ends; σ from the start.
    from: Vec<f64>,
    start_speed: f64,
    limits: KinematicLimits,
    reserve: [JerkReserve; 2],
}

/// The jerk limit near an end of a run where another motion overlaps it and needs the rest of the jerk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct JerkReserve {
    /// The distance from the end within which it applies, σ.
    pub distance: f64,
    /// The fraction of the jerk of every axis that may be used.
    pub share: f64,
}

impl JerkReserve {
    /// An end where all of the jerk may be used.
    pub const NONE: JerkReserve = JerkReserve { distance: 0.0, share: 1.0 };
}

/// Why a run has no velocity profile.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum PathRunError {
    /// The numbers of speeds and pieces differ.
    #[error("the path has {pieces} pieces, and {speeds} speeds were given")]
    Count {
        /// The number of pieces.
        pieces: usize,
        /// The number of speeds.
        speeds: usize,
    },
    /// A length or a speed is not a positive number; with the index of its piece.
    #[error("piece {0} has a length, a speed or a derivative that is not a positive number")]
    NotPositive(usize),
    /// The run has no length.
    #[error("the run has no length")]
    Empty,
    /// The speed at the start is negative or NaN.
    #[error("the run begins at {0} mm/s: it must not be below zero")]
    Start(f64),
}

impl<'a> PathRun<'a> {
    /// A run with the largest speed of each piece (σ per s; infinite where only the axes limit it),
    /// that begins at `start_speed` without acceleration.
    ///
    /// # Errors
    /// The first reason why it has no velocity profile.
    pub fn new(
        pieces: &'a [PathPiece],
        speeds: &'a [f64],
        start_speed: f64,
        limits: &KinematicLimits,
    ) -> Result<PathRun<'a>, PathRunError> {
        if pieces.len() != speeds.len() {
            return Err(PathRunError::Count { pieces: pieces.len(), speeds: speeds.len() });
        }
        if start_speed.is_nan() || start_speed < 0.0 {
            return Err(PathRunError::Start(start_speed));
        }
        let mut from = Vec::with_capacity(pieces.len() + 1);
        let mut at = 0.0;
        for (index, (piece, speed)) in pieces.iter().zip(speeds).enumerate() {
            let fits = piece.length >= 0.0
                && piece.length.is_finite()
                && *speed > 0.0
                && piece.start.iter().flatten().all(|value| value.is_finite());
            if !fits {
                return Err(PathRunError::NotPositive(index));
            }
            from.push(at);
            at += piece.length;
        }
        from.push(at);
        if at <= 0.0 {
            return Err(PathRunError::Empty);
        }
        let reserve = [JerkReserve::NONE; 2];
        Ok(PathRun { pieces, speeds, from, start_speed, limits: *limits, reserve })
    }

    /// The same run with these limits of the jerk near its ends.
    pub(crate) fn with_ends(self, reserve: [JerkReserve; 2]) -> PathRun<'a> {
        PathRun { reserve, ..self }
    }

    /// The limits of the jerk near its ends.
    pub(crate) fn ends(&self) -> &[JerkReserve; 2] {
        &self.reserve
    }

    /// The fraction of the jerk that may be used between two points.
    pub(crate) fn jerk_share(&self, from: f64, to: f64) -> f64 {
        let [first, last] = &self.reserve;
        // What begins where an end is no longer near does so to the last bits.
        let near =
            |distance: f64, end: &JerkReserve| distance < end.distance * (1.0 - EQUAL_PLACE_SHARE);
        let mut share = 1.0_f64;
        if near(from, first) {
            share = share.min(first.share);
        }
        if near(self.length() - to, last) {
            share = share.min(last.share);
        }
        share
    }

    /// Its length in σ.
    pub fn length(&self) -> f64 {
        self.from.last().copied().unwrap_or(0.0)
    }

    /// Its pieces.
    pub fn pieces(&self) -> &'a [PathPiece] {
        self.pieces
    }

    /// σ per s at its start.
    pub fn start_speed(&self) -> f64 {
        self.start_speed
    }

    /// The limits of the axes.
    pub fn limits(&self) -> &KinematicLimits {
        &self.limits
    }

    /// Where piece `index` begins, σ from the start.
    pub(crate) fn from(&self, index: usize) -> f64 {
        self.from[index]
    }

    /// The largest programmed speed on a piece.
    pub(crate) fn feed(&self, index: usize) -> f64 {
        self.speeds[index].min(NO_SPEED_LIMIT)
    }

    /// The index of the piece with a point; where two pieces meet, that of the later one.
    pub(crate) fn piece_at(&self, sigma: f64) -> usize {
        let after = self.from.partition_point(|from| *from <= sigma);
        let mut index = after.saturating_sub(1).min(self.pieces.len() - 1);
        while index > 0 && self.pieces[index].length <= 0.0 {
            index -= 1;
        }
        index
    }

    /// The axes and their derivatives on a piece, at a position counted from the start of the run.
    pub(crate) fn jet(&self, index: usize, sigma: f64) -> AxisJet {
        let piece = &self.pieces[index];
        piece.at((sigma - self.from[index]).clamp(0.0, piece.length))
    }

    /// The largest σ̇ on a piece where the axes have these derivatives: the feed and what the
    /// axes can do.
    pub(crate) fn speed_cap(&self, index: usize, jet: &AxisJet) -> f64 {
        let velocity = self.limits.velocity();
        (0..AXES).fold(self.feed(index), |cap, axis| {
            let rate = jet[1][axis].abs();
            if rate * cap > velocity[axis] { velocity[axis] / rate } else { cap }
        })
    }
}
