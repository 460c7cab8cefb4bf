//! Runs one after the other: what lies between corners as curves, with overlaps at the corners.

use std::ops::Range;

use chordal_geometry::{AXES, Curve};

use super::candidates::SolvedCurve;
use super::corner_overlap::{CURVATURE_LOOK_TOLERANCES, CornerOverlap, RunCorner, RunEnd};
use super::{CornerStrategy, CurvePlanner, JointFilter};
use crate::AxisValues;
use crate::corner_blend::path_span::PathPart;
use crate::corner_blend::{CornerTolerance, EXACT_TOLERANCE};
use crate::limits::KinematicLimits;
use crate::move_request::MoveRequest;
use crate::path_limits::AxisArrays;
use crate::piece::PathPiece;
use crate::time_bound::{JerkReserve, PathRun};
use crate::trajectory::PlannedTrajectory;
use crate::tuning::TUNING;

/// How runs are planned.
pub(super) struct ChainContext<'a, S> {
    pub moves: &'a [MoveRequest],
    pub limits: &'a KinematicLimits,
    pub arrays: AxisArrays,
    pub gap: f64,
    pub corners: &'a mut S,
}

/// A trajectory from rest to rest.
#[derive(Debug)]
pub(crate) struct ChainLink {
    pub trajectory: PlannedTrajectory,
    /// Where moves share pieces: the end of each, σ, and its tag.
    of_moves: Option<Vec<(f64, u64)>>,
}

impl ChainLink {
    /// It takes so long, less what it overlaps, s.
    pub fn time_s(&self) -> f64 {
        self.trajectory.duration_s() - self.trajectory.overlap_s
    }

    /// What a planner keeps of it.
    pub fn into_trajectory<P: PathPart>(self) -> PlannedTrajectory<P> {
        let PlannedTrajectory { pieces, phases, overlap_s } = self.trajectory;
        let pieces = match self.of_moves {
            Some(of_moves) => P::of_moves(&pieces, of_moves.into_iter()),
            None => pieces.iter().map(P::of).collect(),
        };
        PlannedTrajectory { pieces, phases, overlap_s }
    }
}

/// Trajectories from rest to rest.
#[derive(Default)]
struct PlannedChain {
    trajectories: Vec<ChainLink>,
    /// What is known where they begin and end, if other runs may overlap them there.
    sides: [Option<RunEnd>; 2],
    /// About the least time of the curves without jerk, s.
    least_s: f64,
    /// The curve is little slower than at its feeds.
    is_at_feed: bool,
}

impl PlannedChain {
    fn time_s(&self) -> f64 {
        self.trajectories.iter().map(ChainLink::time_s).sum()
    }
}

fn are_lines(moves: &[MoveRequest]) -> bool {
    moves.iter().all(|motion| matches!(motion.curve, Curve::Line(_)))
}

/// Moves planned corner by corner.
fn plan_by_corners(
    context: &mut ChainContext<'_, impl CornerStrategy>,
    moves: &[MoveRequest],
    [before, after]: &[Option<CornerOverlap>; 2],
) -> PlannedChain {
    let mut planned = PlannedChain::default();
    let overlaps = [
        before.as_ref().map(|corner_overlap| corner_overlap.overlap(1)),
        after.as_ref().map(|corner_overlap| corner_overlap.overlap(0)),
    ];
    let mut trajectories = Vec::new();
    context.corners.plan(moves, overlaps, &mut trajectories);
    let side = |corner_overlap: &Option<CornerOverlap>,
                side: usize,
                trajectory: Option<&PlannedTrajectory>| {
        corner_overlap
            .as_ref()
            .zip(trajectory)
            .map(|(corner_overlap, one)| corner_overlap.side_of_lines(side, one))
    };
    planned.sides = [side(before, 1, trajectories.first()), side(after, 0, trajectories.last())];
    planned.trajectories = trajectories
        .into_iter()
        .map(|trajectory| ChainLink { trajectory, of_moves: None })
        .collect();
    planned
}

impl CurvePlanner {
    /// The trajectories of some moves from rest to rest, each again from rest to rest and with how long it overlaps
    /// the one before, and about the least time of the curves without jerk, s.
    pub fn plan(
        &mut self,
        moves: &[MoveRequest],
        limits: &KinematicLimits,
        gap: f64,
        corner_planner: &mut impl CornerStrategy,
    ) -> (Vec<ChainLink>, f64) {
        let arrays = AxisArrays::new(limits);
        let mut context = ChainContext { moves, limits, arrays, gap, corners: corner_planner };
        if !std::mem::take(&mut self.is_cut) {
            if !self.cut(moves) {
                return (plan_by_corners(&mut context, moves, &[None; 2]).trajectories, 0.0);
            }
            self.corners = self.corners_of(moves, 0..moves.len(), JointFilter::Corners);
        }
        let corners = std::mem::take(&mut self.corners);
        let planned = self.chain(&mut context, &corners, [None; 2], Some(JointFilter::Bends));
        (planned.trajectories, planned.least_s)
    }

    /// Plans the runs between corners, where those at the ends are known; some again with more corners.
    fn chain(
        &mut self,
        context: &mut ChainContext<'_, impl CornerStrategy>,
        corners: &[usize],
        [before, after]: [Option<CornerOverlap>; 2],
        more: Option<JointFilter>,
    ) -> PlannedChain {
        let mut all = PlannedChain::default();
        let mut last = before;
        for (index, pair) in corners.windows(2).enumerate() {
            let next = match corners.get(index + 2) {
                Some(end) => self.corner_overlap(context, [pair[0], pair[1], *end]),
                None => after,
            };
            let run = self.quickest(context, pair[0]..pair[1], [last, next], more);
            let first = all.trajectories.len();
            all.trajectories.extend(run.trajectories);
            all.least_s += run.least_s;
            let [begins, ends] = run.sides;
            if index == 0 {
                all.sides[0] = begins;
            } else if let (Some(corner_overlap), Some(one), Some(two)) =
                (last, all.sides[1], begins)
                && let Some([.., before, after]) = all.trajectories.get_mut(..=first)
            {
                let both = [&before.trajectory, &after.trajectory];
                after.trajectory.overlap_s =
                    corner_overlap.overlap_s(both, [one, two], context.limits);
            }
            all.sides[1] = ends;
            last = next;
        }
        all
    }

    /// Plans a run as a curve, with more corners, or its moves singly, whichever is quickest.
    fn quickest(
        &mut self,
        context: &mut ChainContext<'_, impl CornerStrategy>,
        chords: Range<usize>,
        corner_overlaps: [Option<CornerOverlap>; 2],
        more: Option<JointFilter>,
    ) -> PlannedChain {
        let of_moves = self.owners[chords.start] as usize..self.owners[chords.end - 1] as usize + 1;
        let moves = &context.moves[of_moves.clone()];
        let mut best = self.curve(context, chords, &corner_overlaps);
        // The profile of a line is as quick as ramps are, and leaves more room for overlaps.
        let is_line = self.chords.count() < 2;
        let is_quick = best.as_ref().is_some_and(|curve| {
            is_line || context.corners.is_quick(moves, curve.time_s(), curve.least_s)
        });
        // More corners make it no quicker than its feeds.
        let more = more.filter(|_| !best.as_ref().is_some_and(|curve| curve.is_at_feed));
        let mut try_other = |other: PlannedChain| match &best {
            Some(known) if known.time_s() <= other.time_s() => {}
            _ => best = Some(other),
        };
        if !is_quick {
            try_other(plan_by_corners(context, moves, &corner_overlaps));
        }
        let corners = more.map(|joints| self.corners_of(context.moves, of_moves, joints));
        if let Some(corners) = corners.filter(|corners| corners.len() > 2) {
            try_other(self.chain(context, &corners, corner_overlaps, None));
        }
        best.unwrap_or_default()
    }

    /// A run as a curve; a line only next to ends of which not all of the jerk may be used, since others are
    /// planned more quickly without a profile.
    fn curve(
        &mut self,
        context: &ChainContext<'_, impl CornerStrategy>,
        chords: Range<usize>,
        [before, after]: &[Option<CornerOverlap>; 2],
    ) -> Option<PlannedChain> {
        let reserve = [
            before.as_ref().map_or(JerkReserve::NONE, |corner_overlap| corner_overlap.end(1)),
            after.as_ref().map_or(JerkReserve::NONE, |corner_overlap| corner_overlap.end(0)),
        ];
        let of_moves = self.owners[chords.start] as usize..self.owners[chords.end - 1] as usize + 1;
        let is_exact = are_lines(&context.moves[of_moves]);
        let curved = self.run(context.moves, chords, context.limits, context.gap, reserve)?;
        let least_s = curved.least_s;
        let is_at_feed = curved.time_s <= TUNING.curves.at_feed_factor * curved.at_feed_s;
        let trajectory =
            PlannedTrajectory { pieces: curved.pieces, phases: curved.phases, overlap_s: 0.0 };
        // Chords are as far from the path as chords of arcs may be.
        let off = if is_exact { 0.0 } else { TUNING.curves.arc_chord_share };
        let known = |corner_overlap: &CornerOverlap, side| {
            corner_overlap.side_of_curve(side, &trajectory, &self.chords, off)
        };
        let sides = [
            before.as_ref().map(|corner_overlap| known(corner_overlap, 1)),
            after.as_ref().map(|corner_overlap| known(corner_overlap, 0)),
        ];
        let of_moves = Some(self.moves_of_run(context.moves));
        Some(PlannedChain {
            trajectories: vec![ChainLink { trajectory, of_moves }],
            sides,
            least_s,
            is_at_feed,
        })
    }

    /// The trajectory of a straight run next to an end of which not all of the jerk may be used: the profile uses all
    /// of it elsewhere.
    pub(super) fn line(
        &mut self,
        moves: &[MoveRequest],
        limits: &KinematicLimits,
        gap: f64,
        reserve: [JerkReserve; 2],
    ) -> Option<SolvedCurve> {
        let (first, last) = (self.parts.first()?.index, self.parts.last()?.index);
        let has_reserve = reserve.iter().any(|end| *end != JerkReserve::NONE);
        if !has_reserve || !are_lines(&moves[first..=last]) {
            return None;
        }
        let motion = &moves[first];
        let (from, to, length) =
            (&self.chords.places[0], &self.chords.places[1], self.chords.length());
        let mut start = [[0.0; AXES]; 4];
        start[0] = *from;
        start[1] = std::array::from_fn(|axis| (to[axis] - from[axis]) / length);
        let pieces = vec![PathPiece { length, base: None, start, tag: motion.tag }];
        let speeds = [motion.speed];
        let run = PathRun::new(&pieces, &speeds, 0.0, limits).ok()?.with_ends(reserve);
        let curved = self.quickest.solve(&run, gap)?;
        Some(SolvedCurve { pieces, ..curved })
    }

    /// How the runs before and after a chord at a corner may overlap, by where they begin and end.
    fn corner_overlap(
        &self,
        context: &ChainContext<'_, impl CornerStrategy>,
        [begin, chord, end]: [usize; 3],
    ) -> Option<CornerOverlap> {
        let moves = context.moves;
        let index = self.owners[chord] as usize;
        self.turn(moves, index)?;
        let (linear_mm, rotary_rad) = moves[index - 1].corner.tolerance()?;
        let tolerance = CornerTolerance {
            linear_mm: linear_mm.max(EXACT_TOLERANCE.linear_mm),
            rotary_rad: rotary_rad.max(EXACT_TOLERANCE.rotary_rad),
        };
        let here = &self.places[chord];
        let direction = |distance: f64| -> AxisValues {
            let there = self.beyond(chord, distance);
            std::array::from_fn(|axis| (there[axis] - here[axis]) / distance)
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
        let turns_only = moves[index].turns_only();
        let of_linear = if turns_only { rotary_rad } else { linear_mm };
        let look = self.look((begin..chord).rev(), of_linear);
        let before = -reach(&mut (begin..chord).rev(), look);
        let look = self.look(chord..end, of_linear);
        let after = reach(&mut (chord..end), look);
        let directions = [before, after].map(direction);
        let wide = CURVATURE_LOOK_TOLERANCES * of_linear;
        let distances = [-reach(&mut (begin..chord).rev(), wide), reach(&mut (chord..end), wide)];
        let bends = distances.map(|distance| {
            let (half, whole) = (direction(0.5 * distance), direction(distance));
            // Of a parabola.
            std::array::from_fn(|axis| 4.0 * (whole[axis] - half[axis]) / distance)
        });
        let speeds = [moves[index - 1].speed, moves[index].speed];
        let corner = RunCorner { tolerance, directions, bends, speeds, turns_only };
        Some(CornerOverlap::new(corner, &context.arrays))
    }
}
