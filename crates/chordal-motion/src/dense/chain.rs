//! Runs one after the other: what lies between corners as curves, with overlaps at the corners.

use std::ops::Range;

use chordal_geometry::{AXES, Curve, ParamCurve};

use super::meeting::{Corner, Meeting, Side, WIDE};
use super::quickest::Curved;
use super::{CHORD_ERROR, Dense, Joints, Singly};
use crate::Axes;
use crate::bound::{Gentle, Run};
use crate::cell::AxisArrays;
use crate::limits::Limits;
use crate::piece::Piece;
use crate::segment::Move;
use crate::smooth::span::PathPart;
use crate::smooth::{EXACT, Tolerance};
use crate::trajectory::Stretch;

/// A run that takes no more times as long as at its feeds is not planned with more corners.
const AT_FEED: f64 = 1.02;

/// How runs are planned.
pub(super) struct ChainPlanning<'a, S> {
    pub moves: &'a [Move],
    pub limits: &'a Limits,
    pub arrays: AxisArrays,
    pub gap: f64,
    pub singly: &'a mut S,
}

/// A stretch from rest to rest.
#[derive(Debug)]
pub(crate) struct Laid {
    pub stretch: Stretch,
    /// Where moves share pieces: the end of each, σ, and its tag.
    of_moves: Option<Vec<(f64, u64)>>,
}

impl Laid {
    /// It takes so long, less what it overlaps, s.
    pub fn time_s(&self) -> f64 {
        self.stretch.duration_s() - self.stretch.overlap_s
    }

    /// What a planner keeps of it.
    pub fn kept<P: PathPart>(self) -> Stretch<P> {
        let Stretch { pieces, phases, overlap_s } = self.stretch;
        let pieces = match self.of_moves {
            Some(of_moves) => P::of_moves(&pieces, of_moves.into_iter()),
            None => pieces.iter().map(P::of).collect(),
        };
        Stretch { pieces, phases, overlap_s }
    }
}

/// Stretches from rest to rest.
#[derive(Default)]
struct Planned {
    stretches: Vec<Laid>,
    /// What is known where they begin and end, if other runs may overlap them there.
    sides: [Option<Side>; 2],
    /// About the least time of the curves without jerk, s.
    least_s: f64,
    /// The curve is little slower than at its feeds.
    is_at_feed: bool,
}

impl Planned {
    fn time_s(&self) -> f64 {
        self.stretches.iter().map(Laid::time_s).sum()
    }
}

fn are_lines(moves: &[Move]) -> bool {
    moves.iter().all(|motion| matches!(motion.curve, Curve::Line(_)))
}

/// Moves planned corner by corner.
fn singly(
    way: &mut ChainPlanning<'_, impl Singly>,
    moves: &[Move],
    [before, after]: &[Option<Meeting>; 2],
) -> Planned {
    let mut planned = Planned::default();
    let overlaps = [
        before.as_ref().map(|meeting| meeting.overlap(1)),
        after.as_ref().map(|meeting| meeting.overlap(0)),
    ];
    let mut stretches = Vec::new();
    way.singly.plan(moves, overlaps, &mut stretches);
    let side = |meeting: &Option<Meeting>, side: usize, stretch: Option<&Stretch>| {
        meeting.as_ref().zip(stretch).map(|(meeting, one)| meeting.side_of_lines(side, one))
    };
    planned.sides = [side(before, 1, stretches.first()), side(after, 0, stretches.last())];
    planned.stretches =
        stretches.into_iter().map(|stretch| Laid { stretch, of_moves: None }).collect();
    planned
}

impl Dense {
    /// The stretches of some moves from rest to rest, each again from rest to rest and with how long it overlaps
    /// the one before, and about the least time of the curves without jerk, s.
    pub fn plan(
        &mut self,
        moves: &[Move],
        limits: &Limits,
        gap: f64,
        by_corners: &mut impl Singly,
    ) -> (Vec<Laid>, f64) {
        let arrays = AxisArrays::new(limits);
        let mut way = ChainPlanning { moves, limits, arrays, gap, singly: by_corners };
        if !std::mem::take(&mut self.is_cut) {
            if !self.cut(moves) {
                return (singly(&mut way, moves, &[None; 2]).stretches, 0.0);
            }
            self.corners = self.corners_of(moves, 0..moves.len(), Joints::Corners);
        }
        let corners = std::mem::take(&mut self.corners);
        let planned = self.chain(&mut way, &corners, [None; 2], Some(Joints::Bends));
        (planned.stretches, planned.least_s)
    }

    /// Plans the runs between corners, where those at the ends are given; some again with more corners.
    fn chain(
        &mut self,
        way: &mut ChainPlanning<'_, impl Singly>,
        corners: &[usize],
        [before, after]: [Option<Meeting>; 2],
        more: Option<Joints>,
    ) -> Planned {
        let mut all = Planned::default();
        let mut last = before;
        for (index, pair) in corners.windows(2).enumerate() {
            let next = match corners.get(index + 2) {
                Some(end) => self.meeting(way, [pair[0], pair[1], *end]),
                None => after,
            };
            let run = self.quickest(way, pair[0]..pair[1], [last, next], more);
            let first = all.stretches.len();
            all.stretches.extend(run.stretches);
            all.least_s += run.least_s;
            let [begins, ends] = run.sides;
            if index == 0 {
                all.sides[0] = begins;
            } else if let (Some(meeting), Some(one), Some(two)) = (last, all.sides[1], begins)
                && let Some([.., before, after]) = all.stretches.get_mut(..=first)
            {
                let both = [&before.stretch, &after.stretch];
                after.stretch.overlap_s = meeting.overlap_s(both, [one, two], way.limits);
            }
            all.sides[1] = ends;
            last = next;
        }
        all
    }

    /// Plans a run as a curve, with more corners, or its moves singly, whichever is quickest.
    fn quickest(
        &mut self,
        way: &mut ChainPlanning<'_, impl Singly>,
        chords: Range<usize>,
        meetings: [Option<Meeting>; 2],
        more: Option<Joints>,
    ) -> Planned {
        let of_moves = self.owners[chords.start] as usize..self.owners[chords.end - 1] as usize + 1;
        let moves = &way.moves[of_moves.clone()];
        let mut best = self.curve(way, chords, &meetings);
        // The law of a line is as quick as ramps are, and leaves more room for overlaps.
        let is_line = self.chords.count() < 2;
        let is_quick = best.as_ref().is_some_and(|curve| {
            is_line || way.singly.is_quick(moves, curve.time_s(), curve.least_s)
        });
        // More corners make it no quicker than its feeds.
        let more = more.filter(|_| !best.as_ref().is_some_and(|curve| curve.is_at_feed));
        let mut try_other = |other: Planned| match &best {
            Some(known) if known.time_s() <= other.time_s() => {}
            _ => best = Some(other),
        };
        if !is_quick {
            try_other(singly(way, moves, &meetings));
        }
        let corners = more.map(|joints| self.corners_of(way.moves, of_moves, joints));
        if let Some(corners) = corners.filter(|corners| corners.len() > 2) {
            try_other(self.chain(way, &corners, meetings, None));
        }
        best.unwrap_or_default()
    }

    /// A run as a curve; a line only beside ends of which not all of the jerk may be used, since others are
    /// planned more quickly without a law.
    fn curve(
        &mut self,
        way: &ChainPlanning<'_, impl Singly>,
        chords: Range<usize>,
        [before, after]: &[Option<Meeting>; 2],
    ) -> Option<Planned> {
        let gentle = [
            before.as_ref().map_or(Gentle::NOT, |meeting| meeting.end(1)),
            after.as_ref().map_or(Gentle::NOT, |meeting| meeting.end(0)),
        ];
        let of_moves = self.owners[chords.start] as usize..self.owners[chords.end - 1] as usize + 1;
        let is_exact = are_lines(&way.moves[of_moves]);
        let curved = self.run(way.moves, chords, way.limits, way.gap, gentle)?;
        let least_s = curved.least_s;
        let is_at_feed = curved.time_s <= AT_FEED * curved.at_feed_s;
        let stretch = Stretch { pieces: curved.pieces, phases: curved.phases, overlap_s: 0.0 };
        // Chords are as far from the path as chords of arcs may be.
        let off = if is_exact { 0.0 } else { CHORD_ERROR };
        let known =
            |meeting: &Meeting, side| meeting.side_of_curve(side, &stretch, &self.chords, off);
        let sides = [
            before.as_ref().map(|meeting| known(meeting, 1)),
            after.as_ref().map(|meeting| known(meeting, 0)),
        ];
        let of_moves = Some(self.moves_of_run(way.moves));
        Some(Planned { stretches: vec![Laid { stretch, of_moves }], sides, least_s, is_at_feed })
    }

    /// The stretch of a straight run beside an end of which not all of the jerk may be used: the law uses all
    /// of it elsewhere.
    pub(super) fn line(
        &mut self,
        moves: &[Move],
        limits: &Limits,
        gap: f64,
        gentle: [Gentle; 2],
    ) -> Option<Curved> {
        let (first, last) = (self.parts.first()?.index, self.parts.last()?.index);
        let is_gentle = gentle.iter().any(|end| *end != Gentle::NOT);
        if !is_gentle || !are_lines(&moves[first..=last]) {
            return None;
        }
        let motion = &moves[first];
        let (from, to, length) =
            (&self.chords.places[0], &self.chords.places[1], self.chords.length());
        let mut start = [[0.0; AXES]; 4];
        start[0] = *from;
        start[1] = std::array::from_fn(|axis| (to[axis] - from[axis]) / length);
        let pieces = vec![Piece { length, base: None, start, tag: motion.tag }];
        let speeds = [motion.speed];
        let run = Run::new(&pieces, &speeds, 0.0, limits).ok()?.with_ends(gentle);
        let curved = self.quickest.solve(&run, gap)?;
        Some(Curved { pieces, ..curved })
    }

    /// How the runs before and after a chord at a corner may meet, given where they begin and end.
    fn meeting(
        &self,
        way: &ChainPlanning<'_, impl Singly>,
        [begin, chord, end]: [usize; 3],
    ) -> Option<Meeting> {
        let moves = way.moves;
        let index = self.owners[chord] as usize;
        self.turn(moves, index)?;
        let (linear_mm, rotary_rad) = moves[index - 1].corner.tolerance()?;
        let tolerance = Tolerance {
            linear_mm: linear_mm.max(EXACT.linear_mm),
            rotary_rad: rotary_rad.max(EXACT.rotary_rad),
        };
        let here = &self.places[chord];
        let direction = |way: f64| -> Axes {
            let there = self.beyond(chord, way);
            std::array::from_fn(|axis| (there[axis] - here[axis]) / way)
        };
        // No farther than the runs reach.
        let reach = |chords: &mut dyn Iterator<Item = usize>, most: f64| {
            let mut length = 0.0;
            for chord in chords {
                length += self.lengths[chord];
                if length >= most {
                    return most;
                }
            }
            length
        };
        let of_linear = if moves[index].curve.length() > 0.0 { linear_mm } else { rotary_rad };
        let look = self.look((begin..chord).rev(), of_linear);
        let before = -reach(&mut (begin..chord).rev(), look);
        let look = self.look(chord..end, of_linear);
        let after = reach(&mut (chord..end), look);
        let directions = [before, after].map(direction);
        let wide = WIDE * of_linear;
        let ways = [-reach(&mut (begin..chord).rev(), wide), reach(&mut (chord..end), wide)];
        let bends = ways.map(|way| {
            let (half, whole) = (direction(0.5 * way), direction(way));
            // Of a parabola.
            std::array::from_fn(|axis| 4.0 * (whole[axis] - half[axis]) / way)
        });
        let speeds = [moves[index - 1].speed, moves[index].speed];
        let turns_only = moves[index].curve.length() <= 0.0;
        let corner = Corner { tolerance, directions, bends, speeds, turns_only };
        Some(Meeting::new(corner, &way.arrays))
    }
}
