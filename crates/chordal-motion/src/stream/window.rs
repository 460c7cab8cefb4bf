//! A window: some tenths of a second of planned motion with everything that the pull side needs
//! to walk through it and to stop in it.

use chordal_geometry::{AXES, Curve, ParamCurve};

use crate::piece::{add_curve, ahead};
use crate::reader::{PieceReader, PieceView};
use crate::sample::{AxisState, MotionSample};
use crate::trajectory::{JerkPhase, ProfilePoint};
use crate::{AxisJet, AxisValues, PathPiece};

use super::block::MotionBlock;

/// A phase and when it begins, s from the start of the window (below zero: before it).
#[derive(Clone, Copy, Debug)]
pub(super) struct TimedPhase {
    pub from_s: f64,
    pub phase: JerkPhase,
}

/// A piece and where it begins, σ from the start of its trajectory. Its curve is kept apart, among those of the
/// window: most pieces have none, and what is walked over is small.
#[derive(Clone, Copy, Debug)]
pub(super) struct PlacedPiece {
    pub from: f64,
    /// As in the piece.
    pub length: f64,
    pub start: AxisJet,
    pub tag: u64,
    /// The number of the curve below, and how far from its start the piece begins.
    pub base: Option<(usize, f64)>,
}

impl PlacedPiece {
    #[inline(always)]
    fn part<'a>(&'a self, curves: &'a [Curve]) -> PieceView<'a> {
        let base = self.base.map(|(curve, from)| (&curves[curve], from));
        PieceView { base, start: &self.start, tag: self.tag }
    }
}

/// The part of a trajectory that lies in a window.
#[derive(Clone, Copy, Debug)]
pub(super) struct WindowLeg {
    /// When the trajectory begins and ends, s from the start of the window.
    pub from_s: f64,
    pub to_s: f64,
    /// Its phases and pieces among those of the window.
    pub phases: (usize, usize),
    pub pieces: (usize, usize),
    /// Where the trajectory begins; taken off while it is added to the trajectory before.
    pub corner: AxisValues,
    /// Whether it begins while the trajectory before still ends.
    pub overlaps: bool,
}

/// How the motion ends when no further window comes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum WindowStop {
    /// None was found: the stop of a window before stays active.
    Unknown,
    /// The plan itself rests at the end of the window.
    Rest,
    /// From `at_s` on, the rate of time falls to zero before the window ends: with at most
    /// `rate` per s and `bend` per s², when it was 1. This was verified for every rate up to
    /// `level` at `at_s`.
    Tail { at_s: f64, level: f64, rate: f64, bend: f64 },
}

/// Planned motion between two instants, handed from the push to the pull side and back.
#[derive(Debug)]
pub(super) struct StreamWindow {
    pub duration_s: f64,
    pub legs: Vec<WindowLeg>,
    pub phases: Vec<TimedPhase>,
    pub pieces: Vec<PlacedPiece>,
    /// What lies below them, one after the other; pieces over the same curve share it.
    pub curves: Vec<Curve>,
    /// What the axes do, by blocks of time without gaps.
    pub blocks: Vec<MotionBlock>,
    /// Largest speed of each axis.
    pub fastest: AxisValues,
    pub stop: WindowStop,
    /// The axes wait for this time at the end of the window, s, with a tag.
    pub wait: Option<(f64, u64)>,
    /// Nothing follows.
    pub last: bool,
}

impl StreamWindow {
    /// An empty window. It grows on the push side to what its options bound.
    pub fn new() -> StreamWindow {
        StreamWindow {
            duration_s: 0.0,
            legs: Vec::new(),
            phases: Vec::new(),
            pieces: Vec::new(),
            curves: Vec::new(),
            blocks: Vec::new(),
            fastest: [0.0; AXES],
            stop: WindowStop::Unknown,
            wait: None,
            last: false,
        }
    }

    pub fn clear(&mut self) {
        self.duration_s = 0.0;
        self.legs.clear();
        self.phases.clear();
        self.pieces.clear();
        self.curves.clear();
        self.blocks.clear();
        self.fastest = [0.0; AXES];
        self.stop = WindowStop::Unknown;
        self.wait = None;
        self.last = false;
    }

    /// Puts a piece after the others.
    pub fn push(&mut self, from: f64, piece: &PathPiece) {
        let PathPiece { length, start, tag, .. } = *piece;
        let base = piece.base.as_ref().map(|(curve, from)| {
            if self.curves.last() != Some(curve) {
                self.curves.push(*curve);
            }
            (self.curves.len() - 1, *from)
        });
        self.pieces.push(PlacedPiece { from, length, start, tag, base });
    }

    /// The velocity profile of a leg at `t`, with its phase from `hint` on.
    #[inline]
    pub fn along(&self, leg: &WindowLeg, hint: &mut usize, t: f64) -> ProfilePoint {
        let (first, end) = leg.phases;
        *hint = last_not_after(&self.phases[..end], (*hint).max(first), |phase| phase.from_s <= t);
        let TimedPhase { from_s, phase } = &self.phases[*hint];
        phase.at((t - from_s).clamp(0.0, phase.duration_s))
    }

    /// The piece of a leg that the velocity profile is on, from `hint` on.
    #[inline]
    pub fn piece(&self, leg: &WindowLeg, hint: &mut usize, along: &ProfilePoint) -> &PlacedPiece {
        let (first, end) = leg.pieces;
        *hint = last_not_after(&self.pieces[..end], (*hint).max(first), |placed| {
            placed.from <= along.sigma
        });
        &self.pieces[*hint]
    }

    /// Where the axes are when the window ends at rest.
    pub fn end(&self) -> Option<AxisState> {
        let placed = self.pieces.last()?;
        let mut jet = ahead(&placed.start, placed.length, AXES);
        if let Some((curve, from)) = placed.base {
            add_curve(&mut jet, self.curves[curve].jet_at(from + placed.length));
        }
        Some(AxisState { position: jet[0], tag: placed.tag, ..AxisState::default() })
    }
}

/// Index of the last entry for which `before` holds, at `hint` or after it; `before` holds for
/// a first part of the entries. A few steps ahead one by one, then by halves: the cost grows
/// with the logarithm of what a window may hold, however short the entries are.
#[inline]
fn last_not_after<T>(entries: &[T], hint: usize, before: impl Fn(&T) -> bool) -> usize {
    let mut at = hint;
    for _ in 0..4 {
        match entries.get(at + 1) {
            Some(next) if before(next) => at += 1,
            _ => return at,
        }
    }
    at + entries[at + 1..].partition_point(before)
}

/// A place in a window that only moves forward.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct WindowCursor {
    leg: usize,
    /// Phase and piece on the leg and on the one that begins while it ends.
    hints: [(usize, usize); 2],
    /// The pieces that were last met, made ready.
    readers: [Option<(usize, PieceReader)>; 2],
}

impl WindowCursor {
    /// Writes what the axes do at `t` s from the start of the window into a sample. A window
    /// without motion changes nothing.
    #[inline(always)]
    pub fn fill(&mut self, window: &StreamWindow, t: f64, out: &mut MotionSample) {
        if window.legs.is_empty() {
            return;
        }
        let leg = last_not_after(&window.legs, self.leg, |leg| leg.from_s <= t);
        // The leg that began before is still under way when the newest overlaps it.
        let newest = &window.legs[leg];
        let main =
            if leg > 0 && newest.overlaps && window.legs[leg - 1].to_s > t { leg - 1 } else { leg };
        if main != self.leg {
            self.hints = if main == self.leg + 1 { [self.hints[1], (0, 0)] } else { [(0, 0); 2] };
            self.leg = main;
        }
        self.on(window, 0, t, out);
        if main < leg {
            let after = self.next(window, t);
            for axis in 0..AXES {
                out.position[axis] += after.position[axis];
                out.velocity[axis] += after.velocity[axis];
                out.acceleration[axis] += after.acceleration[axis];
                out.jerk[axis] += after.jerk[axis];
            }
        }
    }

    /// What the leg adds that has begun while the one before still ends.
    #[cold]
    fn next(&mut self, window: &StreamWindow, t: f64) -> MotionSample {
        let mut after = MotionSample::default();
        self.on(window, 1, t, &mut after);
        let corner = window.legs[self.leg + 1].corner;
        for (place, corner) in after.position.iter_mut().zip(corner) {
            *place -= corner;
        }
        after
    }

    #[inline(always)]
    fn on(&mut self, window: &StreamWindow, which: usize, t: f64, out: &mut MotionSample) {
        let leg = &window.legs[self.leg + which];
        let (phase, index) = &mut self.hints[which];
        let along = window.along(leg, phase, t);
        let placed = window.piece(leg, index, &along);
        let part = placed.part(&window.curves);
        let reader = match &mut self.readers[which] {
            Some((at, reader)) => {
                if at != index {
                    reader.go_on(window.pieces[*at].part(&window.curves), part);
                    *at = *index;
                }
                reader
            }
            none => &mut none.insert((*index, PieceReader::new(part))).1,
        };
        let sigma = (along.sigma - placed.from).clamp(0.0, placed.length);
        reader.fill(part, sigma, &along, out);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_search_finds_near_and_far_entries() {
        let entries: Vec<usize> = (0..1000).collect();
        for hint in [0, 3, 10] {
            for expected in [10, 11, 13, 14, 15, 16, 500, 999] {
                assert_eq!(last_not_after(&entries, hint, |entry| *entry <= expected), expected);
            }
        }
    }
}
