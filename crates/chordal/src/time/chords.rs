//! What short lines cost: the same lines are planned again as they would be with another setting of the control,
//! output of the CAM system, or tolerance.
//!
//! Each row of short lines is planned by itself, from rest to rest: as it is, and with one thing changed. The
//! difference is what that change saves. Only the points with more decimals are an estimate: they are taken from arcs
//! fitted to the points within their rounding.

use chordal_geometry::{
    Curve, FitMeasure, FitOptions, FitPiece, Line, ParamCurve, Placement, Vec3, fit_path,
};
use chordal_motion::{
    CornerMode, KinematicLimits, MotionPlanner, MoveKind, MoveRequest, PlannerStep,
};

use crate::job::Job;
use crate::motion::{LimitError, MachineLimits, MotionOptions, MotionStep, StepSource};

/// A line that takes less than this at its feed is short, s.
const SHORT_LINE_S: f64 = 0.04;
/// Least number of consecutive short lines that make a row.
const MIN_ROW_LINES: usize = 16;
/// Most lines that are studied; those after them are left out.
const MAX_STUDIED_LINES: u64 = 300_000;
/// Changes are reported only if they save at least this share of the time of a tool's rows, and this time, s.
const MIN_SAVED_SHARE: f64 = 0.01;
const MIN_SAVED_S: f64 = 0.05;
/// Corner tolerances that are usual in practice, mm.
const COMMON_TOLERANCES_MM: [f64; 9] = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5];
/// Most decimals of a coordinate.
const MAX_DECIMALS: u32 = 6;

/// A change that may make short lines faster.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ChordRemedy {
    /// The control joins short blocks (look-ahead, high accuracy).
    Joined,
    /// Corners are passed within this distance, mm.
    Tolerance(f64),
    /// Coordinates with this number of decimals.
    Decimals(u32),
    /// Chords so short that the curve through their ends is no farther from them than this, mm.
    Finer(f64),
    /// Arcs and lines that replace the chords.
    Arcs {
        /// Largest distance from the chords, mm.
        within_mm: f64,
        /// Number of arcs and lines.
        pieces: u64,
    },
}

/// The cost of the short lines of a tool.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ChordCost {
    /// Number of the tool.
    pub tool: u32,
    /// Number of short lines.
    pub lines: u64,
    /// Their total length, mm.
    pub length_mm: f64,
    /// Their time, s, with each row planned from rest to rest.
    pub time_s: f64,
    /// Their time at the feed, s.
    pub feed_s: f64,
    /// The smallest of their corner tolerances, mm.
    pub tolerance_mm: f64,
    /// Changes that would be faster, and the time each saves, s; the largest first.
    pub savings: Vec<(ChordRemedy, f64)>,
}

/// Consecutive short lines of one tool.
#[derive(Debug, Default)]
struct ChordRow {
    tool: u32,
    moves: Vec<MoveRequest>,
}

impl Job<'_> {
    /// What the short lines of each tool cost, and which changes would make them faster. `inch`: the coordinates are
    /// rounded in inches, not mm.
    ///
    /// # Errors
    /// A limit of an axis that is not a positive number.
    pub fn chord_costs(
        &self,
        options: &MotionOptions,
        inch: bool,
    ) -> Result<Vec<ChordCost>, LimitError> {
        let limits = MachineLimits::of(self.machine())?;
        // The comparison holds for planners with limited jerk only.
        if limits.junctions.is_some() {
            return Ok(Vec::new());
        }
        let unit_mm = if inch { 25.4 } else { 1.0 };
        let mut costs = ChordCostSink {
            limits: limits.cut,
            unit_mm,
            row: ChordRow::default(),
            lines: 0,
            costs: Vec::new(),
        };
        let take = |step: &MotionStep, source: &StepSource| {
            costs.take(step, source);
            Ok(())
        };
        let _ = self.motion(options, take)?;
        Ok(costs.finish())
    }
}

/// Collects rows and adds up their cost.
struct ChordCostSink {
    limits: KinematicLimits,
    unit_mm: f64,
    row: ChordRow,
    lines: u64,
    costs: Vec<ChordCost>,
}

impl ChordCostSink {
    fn take(&mut self, step: &MotionStep, source: &StepSource) {
        match step {
            MotionStep::Move(motion) if is_short(motion) && self.lines < MAX_STUDIED_LINES => {
                if source.tool != self.row.tool {
                    self.end_row();
                }
                self.lines += 1;
                self.row.tool = source.tool;
                self.row.moves.push(*motion);
                if motion.corner.tolerance().is_none() {
                    self.end_row();
                }
            }
            _ => self.end_row(),
        }
    }

    fn end_row(&mut self) {
        let row = std::mem::take(&mut self.row);
        if row.moves.len() < MIN_ROW_LINES {
            return;
        }
        let index = self.costs.iter().position(|cost| cost.tool == row.tool).unwrap_or_else(|| {
            let first =
                ChordCost { tool: row.tool, tolerance_mm: f64::INFINITY, ..ChordCost::default() };
            self.costs.push(first);
            self.costs.len() - 1
        });
        let time_s = time_of(&row.moves, &self.limits);
        let tried = remedies(&row.moves, self.unit_mm, &self.limits);
        let cost = &mut self.costs[index];
        cost.lines += row.moves.len() as u64;
        cost.length_mm += row.moves.iter().map(MoveRequest::length).sum::<f64>();
        cost.feed_s += row.moves.iter().map(MoveRequest::at_speed_s).sum::<f64>();
        cost.time_s += time_s;
        cost.tolerance_mm = cost.tolerance_mm.min(tolerance_of(&row.moves));
        for (remedy, with_s) in tried {
            add(&mut cost.savings, remedy, (time_s - with_s).max(0.0));
        }
    }

    fn finish(mut self) -> Vec<ChordCost> {
        self.end_row();
        for cost in &mut self.costs {
            let least = MIN_SAVED_S.max(MIN_SAVED_SHARE * cost.time_s);
            cost.savings.retain(|(_, saved)| *saved >= least);
            cost.savings.sort_by(|a, b| b.1.total_cmp(&a.1));
        }
        self.costs
    }
}

/// Adds what a remedy saves to the same remedy of other rows.
fn add(savings: &mut Vec<(ChordRemedy, f64)>, remedy: ChordRemedy, saved: f64) {
    let like = |known: &ChordRemedy| match (known, &remedy) {
        (ChordRemedy::Arcs { within_mm: a, .. }, ChordRemedy::Arcs { within_mm: b, .. }) => a == b,
        (known, new) => known == new,
    };
    match savings.iter_mut().find(|(known, _)| like(known)) {
        Some((known, sum)) => {
            *sum += saved;
            if let (ChordRemedy::Arcs { pieces, .. }, ChordRemedy::Arcs { pieces: more, .. }) =
                (known, remedy)
            {
                *pieces += more;
            }
        }
        None => savings.push((remedy, saved)),
    }
}

fn is_short(motion: &MoveRequest) -> bool {
    motion.kind == MoveKind::Cut
        && matches!(motion.curve, Curve::Line(_))
        && motion.rotary_from == motion.rotary_to
        && motion.at_speed_s() < SHORT_LINE_S
}

fn tolerance_of(moves: &[MoveRequest]) -> f64 {
    let of = |motion: &MoveRequest| motion.corner.tolerance().map_or(f64::INFINITY, |(mm, _)| mm);
    moves.iter().map(of).fold(f64::INFINITY, f64::min)
}

/// The times of a row with one thing changed.
fn remedies(
    moves: &[MoveRequest],
    unit_mm: f64,
    limits: &KinematicLimits,
) -> Vec<(ChordRemedy, f64)> {
    let mut out = Vec::new();
    let mut tried =
        |remedy: ChordRemedy, moves: &[MoveRequest]| out.push((remedy, time_of(moves, limits)));
    if moves.iter().any(|motion| matches!(motion.corner, CornerMode::Blended { .. })) {
        tried(ChordRemedy::Joined, &with_corners(moves, None));
    }
    let tolerance = tolerance_of(moves);
    if !tolerance.is_finite() || tolerance <= 0.0 {
        return out;
    }
    if let Some(larger) = COMMON_TOLERANCES_MM.into_iter().find(|one| *one > 1.5 * tolerance) {
        tried(ChordRemedy::Tolerance(larger), &with_corners(moves, Some(larger)));
    }
    let points = points_of(moves);
    if let Some(decimals) = decimals_of(&points, unit_mm) {
        let rounding = unit_mm * 0.1_f64.powi(decimals as i32);
        let fit = FitOptions { measure: FitMeasure::Points, ..FitOptions::within(0.75 * rounding) };
        if let Ok(pieces) = fit_path(&points, &fit) {
            tried(
                ChordRemedy::Decimals(decimals + 1),
                &at_the_same_places(moves, &points, &pieces),
            );
        }
    }
    let through =
        FitOptions { measure: FitMeasure::Points, ..FitOptions::within(0.25 * tolerance) };
    if let Ok(pieces) = fit_path(&points, &through) {
        let within_mm = 0.25 * tolerance;
        let finer = chords_of(moves, &pieces, within_mm);
        if finer.len() > moves.len() {
            tried(ChordRemedy::Finer(within_mm), &finer);
        }
    }
    let within_mm = 0.5 * tolerance;
    if let Ok(pieces) = fit_path(&points, &FitOptions::within(within_mm)) {
        let count = pieces.len() as u64;
        // With more pieces than that, the fit has mostly kept the lines themselves.
        if 2 * count < moves.len() as u64 {
            let arcs = along(moves, pieces.iter().map(|piece| (piece.curve, piece.span[0])));
            tried(ChordRemedy::Arcs { within_mm, pieces: count }, &arcs);
        }
    }
    out
}

/// The same moves: with short blocks joined where `tolerance_mm` is `None`, otherwise with this corner tolerance.
fn with_corners(moves: &[MoveRequest], tolerance_mm: Option<f64>) -> Vec<MoveRequest> {
    let corner = |corner: CornerMode| match corner {
        CornerMode::Joined { linear_mm, rotary_rad } => {
            CornerMode::Joined { linear_mm: tolerance_mm.unwrap_or(linear_mm), rotary_rad }
        }
        CornerMode::Blended { linear_mm, rotary_rad } => match tolerance_mm {
            None => CornerMode::Joined { linear_mm, rotary_rad },
            Some(linear_mm) => CornerMode::Blended { linear_mm, rotary_rad },
        },
        corner => corner,
    };
    moves.iter().map(|motion| MoveRequest { corner: corner(motion.corner), ..*motion }).collect()
}

fn points_of(moves: &[MoveRequest]) -> Vec<Vec3> {
    let first = moves.first().map(|motion| motion.curve.start());
    first.into_iter().chain(moves.iter().map(|motion| motion.curve.end())).collect()
}

/// How many decimals the differences of coordinates have in the unit of the program; `None` where they are not
/// rounded, as after a rotation.
fn decimals_of(points: &[Vec3], unit_mm: f64) -> Option<u32> {
    (1..MAX_DECIMALS).find(|decimals| {
        let factor = 10f64.powi(*decimals as i32) / unit_mm;
        points.windows(2).all(|pair| {
            (pair[1] - pair[0]).to_array().into_iter().all(|distance| {
                let units = distance * factor;
                (units - units.round()).abs() < 1e-3
            })
        })
    })
}

/// The lines with their ends moved onto the fitted pieces.
fn at_the_same_places(
    moves: &[MoveRequest],
    points: &[Vec3],
    pieces: &[FitPiece],
) -> Vec<MoveRequest> {
    let mut moved = points.to_vec();
    for piece in pieces {
        let [from, to] = piece.span;
        let (first, last) = (from.ceil() as usize, to.floor() as usize);
        for index in first..=last.min(points.len() - 1) {
            moved[index] = piece.curve.nearest(points[index]).point;
        }
    }
    let lines = moved.windows(2).zip(moves).map(|(ends, motion)| MoveRequest {
        curve: Curve::Line(Line::new(ends[0], ends[1])),
        ..*motion
    });
    lines.collect()
}

/// Chords of the fitted pieces, at most this far from them.
fn chords_of(moves: &[MoveRequest], pieces: &[FitPiece], within_mm: f64) -> Vec<MoveRequest> {
    let lines = pieces.iter().flat_map(|piece| {
        let chords = piece.curve.chords(within_mm, Placement::Inscribed);
        let corners: Vec<Vec3> = chords.map(|chords| chords.collect()).unwrap_or_default();
        let line = |ends: &[Vec3]| (Curve::Line(Line::new(ends[0], ends[1])), piece.span[0]);
        corners.windows(2).map(line).collect::<Vec<_>>()
    });
    along(moves, lines)
}

/// Moves along curves, each with the feed and corner of the move at the point index where the curve begins.
fn along(moves: &[MoveRequest], curves: impl Iterator<Item = (Curve, f64)>) -> Vec<MoveRequest> {
    let mut out: Vec<MoveRequest> = curves
        .map(|(curve, from)| {
            let like = &moves[(from as usize).min(moves.len() - 1)];
            MoveRequest { curve, ..*like }
        })
        .collect();
    if let (Some(last), Some(end)) = (out.last_mut(), moves.last()) {
        last.corner = end.corner;
    }
    out
}

/// The time of moves from rest to rest, s.
fn time_of(moves: &[MoveRequest], limits: &KinematicLimits) -> f64 {
    let mut planner = MotionPlanner::of_times(*limits);
    let mut time_s = 0.0;
    let mut take = |step: PlannerStep<'_, _>| {
        if let PlannerStep::Trajectory(trajectory) = step {
            time_s += trajectory.duration_s() - trajectory.overlap_s;
        }
    };
    for motion in moves {
        // A refused piece was too short to plan, and takes no time.
        let _ = planner.push(motion, &mut take);
    }
    planner.finish(&mut take);
    time_s
}
