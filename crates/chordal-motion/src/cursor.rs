//! The axes at an instant of a stretch, one instant after the other.

use crate::reader::Reader;
use crate::sample::{Sample, State};
use crate::trajectory::{Along, Stretch};

/// Walks along a stretch in time.
#[derive(Clone, Debug, Default)]
pub struct Cursor {
    piece: usize,
    piece_from: f64,
    phase: usize,
    phase_from_s: f64,
    /// Of the piece it stands on.
    reader: Option<Reader>,
}

impl Cursor {
    /// The axes at `t` s from the start of the stretch. Times must not go back; beyond the end
    /// the answer is its end.
    pub fn at(&mut self, stretch: &Stretch, t: f64) -> State {
        let mut sample = Sample::default();
        self.fill(stretch, t, &mut sample);
        sample.into()
    }

    /// The same written into a sample, whose time stays. A stretch of nothing changes nothing.
    #[inline(always)]
    pub(crate) fn fill(&mut self, stretch: &Stretch, t: f64, out: &mut Sample) {
        let Some(along) = self.along(stretch, t) else { return };
        let piece = &stretch.pieces[self.piece];
        let sigma = (along.sigma - self.piece_from).clamp(0.0, piece.length);
        self.reader.get_or_insert_with(|| Reader::new(piece)).fill(piece, sigma, &along, out);
    }

    /// Goes to the phase and the piece at `t`; `None` where there is nothing.
    #[inline(always)]
    fn along(&mut self, stretch: &Stretch, t: f64) -> Option<Along> {
        let last_phase = stretch.phases.len().checked_sub(1)?;
        let last_piece = stretch.pieces.len().checked_sub(1)?;
        while self.phase < last_phase
            && t - self.phase_from_s >= stretch.phases[self.phase].duration_s
        {
            self.phase_from_s += stretch.phases[self.phase].duration_s;
            self.phase += 1;
        }
        let phase = &stretch.phases[self.phase];
        let along = phase.at((t - self.phase_from_s).clamp(0.0, phase.duration_s));
        while self.piece < last_piece
            && along.sigma - self.piece_from >= stretch.pieces[self.piece].length
        {
            let [before, next] = [&stretch.pieces[self.piece], &stretch.pieces[self.piece + 1]];
            self.piece_from += before.length;
            self.piece += 1;
            if let Some(reader) = &mut self.reader {
                reader.go_on(before, next);
            }
        }
        Some(along)
    }
}
