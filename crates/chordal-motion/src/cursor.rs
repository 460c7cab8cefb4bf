//! The axes at an instant of a stretch, one instant after the other.

use crate::reader::{Part, Reader};
use crate::sample::{Sample, State};
use crate::trajectory::{Along, Stretch};

/// A place on a stretch.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Place {
    /// Number of the piece.
    pub piece: usize,
    /// From the start of that.
    pub sigma: f64,
    /// The velocity profile there.
    pub along: Along,
}

/// Walks along a stretch in time: finds places.
#[derive(Clone, Debug, Default)]
pub(crate) struct Walk {
    piece: usize,
    piece_from: f64,
    phase: usize,
    phase_from_s: f64,
}

impl Walk {
    /// The place at `t` s from the start, not before the last; `None` where there is nothing.
    #[inline(always)]
    pub fn to(&mut self, Stretch { pieces, phases, .. }: &Stretch, t: f64) -> Option<Place> {
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
        Some(Place { piece: self.piece, sigma, along })
    }
}

/// Reads the axes at places of a stretch.
#[derive(Clone, Debug, Default)]
pub(crate) struct Reading {
    /// Of the piece with this number.
    reader: Option<(usize, Reader)>,
}

impl Reading {
    /// Writes what the axes do at a place into a sample, whose time stays.
    #[inline(always)]
    pub fn fill(&mut self, stretch: &Stretch, place: &Place, out: &mut Sample) {
        let Place { piece, sigma, along } = place;
        let part = Part::from(&stretch.pieces[*piece]);
        let reader = match &mut self.reader {
            Some((at, reader)) => {
                if at != piece {
                    reader.go_on((&stretch.pieces[*at]).into(), part);
                    *at = *piece;
                }
                reader
            }
            none => &mut none.insert((*piece, Reader::new(part))).1,
        };
        reader.fill(part, *sigma, along, out);
    }
}

/// Walks along a stretch in time.
#[derive(Clone, Debug, Default)]
pub struct Cursor {
    pub(crate) walk: Walk,
    pub(crate) reading: Reading,
}

impl Cursor {
    /// The axes at `t` s from the start of the stretch. Times must not go back; beyond the end
    /// the answer is its end.
    pub fn at(&mut self, stretch: &Stretch, t: f64) -> State {
        let mut sample = Sample::default();
        self.fill(stretch, t, &mut sample);
        sample.into()
    }

    /// Goes over to a copy of the stretch that begins with the phase and the piece under way: the
    /// numbers of both.
    pub(crate) fn leave_behind(&mut self) -> (usize, usize) {
        let gone = (self.walk.phase, self.walk.piece);
        (self.walk.phase, self.walk.piece) = (0, 0);
        match &mut self.reading.reader {
            Some((at, _)) if *at == gone.1 => *at = 0,
            reader => *reader = None,
        }
        gone
    }

    /// The same written into a sample, whose time stays. A stretch of nothing changes nothing.
    #[inline(always)]
    pub(crate) fn fill(&mut self, stretch: &Stretch, t: f64, out: &mut Sample) {
        if let Some(place) = self.walk.to(stretch, t) {
            self.reading.fill(stretch, &place, out);
        }
    }
}
