use crate::Axes;
use crate::cell::{AxisArrays, Cell};
use crate::limits::Limits;
use crate::piece::Piece;
use crate::profile::{Solver, phases};
use crate::root::cbrt;
use crate::segment::{Move, MoveError};
use crate::smooth::{Overlap, Passing, Row, Smoother, overlap_time};
use crate::trajectory::{Phase, Step, Stretch};

/// How hard a planner tries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// In one pass, for programs of any length.
    Fast,
    /// By optimization, for measuring how far the fast level is from the limit, and for short
    /// jobs that run often.
    Best,
}

/// What a planner may be told.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlannerOptions {
    /// How hard it tries.
    pub level: Level,
}

/// So many cells are looked at together. A row ends earlier where the axes stop; a longer one is
/// handed on as far as later moves cannot change it.
const ROW: usize = 16_384;

/// Shorter moves are left out, mm or rad: their direction would be rounding.
const SHORTEST: f64 = 1e-9;

/// A gap between moves that is closed without a word, mm or rad.
const GAP: f64 = 1e-6;

/// Turns moves into steps: holds every limit, keeps the path, loses little time.
#[derive(Debug)]
pub struct Planner {
    limits: Limits,
    arrays: AxisArrays,
    smoother: Smoother,
    row: Row,
    solver: Solver,
    stretch: Stretch,
    /// Speed at the start of the row.
    speed: f64,
    /// Rows are looked at when they have so many cells.
    patience: usize,
    /// Where the axes will be after all moves.
    position: Option<Axes>,
    /// The corner at which the run begins, and how the movement before it ends.
    overlap: Option<Overlap>,
    last: Option<End>,
}

impl Planner {
    /// A planner for a machine at rest.
    pub fn new(limits: Limits, _options: PlannerOptions) -> Planner {
        Planner {
            arrays: AxisArrays::new(&limits),
            limits,
            smoother: Smoother::default(),
            row: Row::default(),
            solver: Solver::default(),
            stretch: Stretch::default(),
            speed: 0.0,
            patience: ROW,
            position: None,
            overlap: None,
            last: None,
        }
    }

    /// Takes a move and hands on the steps that are certain now.
    ///
    /// # Errors
    /// When the move cannot be planned; it is left out.
    pub fn push(&mut self, motion: &Move, mut take: impl FnMut(Step<'_>)) -> Result<(), MoveError> {
        motion.check(&self.limits)?;
        let start = self.start_of(motion)?;
        if motion.length() < SHORTEST {
            // The next line begins where this one did, so nothing is lost.
            self.position = Some(start);
            return Ok(());
        }
        self.position = Some(motion.to());
        let mut leg = self.smoother.leg(motion, &start, &self.arrays);
        let passing = self.smoother.passing(&leg, &self.arrays);
        if let Some(Passing::Rest(overlap)) = passing {
            if let Some(overlap) = &overlap {
                self.smoother.end_with(overlap);
            }
            self.end_run(&mut take);
            leg.begin_run();
            self.smoother.push(leg, motion.corner, None);
            if let Some(overlap) = &overlap {
                self.smoother.begin_with(overlap);
            }
            self.overlap = overlap;
            return Ok(());
        }
        self.smoother.push(leg, motion.corner, passing);
        self.smoother.drain(false, &self.arrays, &mut self.row);
        if self.row.cells.len() >= self.patience {
            self.hand_on(&mut take);
        }
        Ok(())
    }

    /// The axes come to rest and stand for a time, s.
    pub fn wait(&mut self, seconds: f64, tag: u64, mut take: impl FnMut(Step<'_>)) {
        self.finish(&mut take);
        take(Step::Wait { seconds, tag });
    }

    /// The axes come to rest: hands on the rest of the steps. The next move may begin anywhere.
    pub fn finish(&mut self, mut take: impl FnMut(Step<'_>)) {
        self.end_run(&mut take);
        self.position = None;
        self.overlap = None;
        self.last = None;
    }

    /// Where a move begins: where the one before it ended.
    fn start_of(&self, motion: &Move) -> Result<Axes, MoveError> {
        let from = motion.from();
        let Some(position) = self.position else { return Ok(from) };
        let gap = from.iter().zip(&position).fold(0.0_f64, |gap, (a, b)| gap.max((a - b).abs()));
        if gap > GAP { Err(MoveError::Gap(gap)) } else { Ok(position) }
    }

    /// The axes come to rest at the end of what was pushed.
    fn end_run(&mut self, take: &mut impl FnMut(Step<'_>)) {
        if self.smoother.is_empty() && self.row.cells.is_empty() {
            return;
        }
        self.smoother.drain(true, &self.arrays, &mut self.row);
        let count = self.row.cells.len();
        self.solver.solve(&self.row.cells, self.speed, 0.0);
        self.emit(count, take);
        self.speed = 0.0;
        self.patience = ROW;
    }

    /// Hands on as much of a long row as later moves cannot change.
    fn hand_on(&mut self, take: &mut impl FnMut(Step<'_>)) {
        self.solver.solve(&self.row.cells, self.speed, 0.0);
        match self.solver.last_certain() {
            Some(station) if station.node > 0 => {
                self.emit(station.node, take);
                self.speed = station.speed;
                self.patience = ROW.max(2 * self.row.cells.len());
            }
            // The stop at the end reaches back to the start: more has to be known.
            _ => self.patience *= 2,
        }
    }

    /// Hands on the cells before a boundary, which is a station.
    fn emit(&mut self, node: usize, take: &mut impl FnMut(Step<'_>)) {
        let stretch = &mut self.stretch;
        stretch.phases.clear();
        stretch.pieces.clear();
        for pair in self.solver.stations().windows(2).take_while(|pair| pair[1].node <= node) {
            phases(&self.row.cells, &pair[0], &pair[1], &mut stretch.phases);
        }
        let pieces = pieces_of(&self.row.cells[..node]);
        stretch.pieces.extend(self.row.pieces.drain(..pieces));
        self.row.cells.drain(..node);
        let (first, last) = (End::first(stretch), End::last(stretch));
        stretch.overlap_s = match (self.overlap.take(), self.last, first) {
            (Some(overlap), Some(last), Some(first)) => overlap_of(&overlap, &last, &first),
            _ => 0.0,
        };
        self.last = last;
        take(Step::Stretch(stretch));
    }
}

fn pieces_of(cells: &[Cell]) -> usize {
    cells.iter().map(|cell| cell.pieces as usize).sum()
}

/// The end of a stretch that is at rest, with the corner.
#[derive(Clone, Copy, Debug)]
struct End {
    jerk: f64,
    duration_s: f64,
    /// Way from the corner in which the path is a straight line.
    straight: f64,
}

impl End {
    fn first(stretch: &Stretch) -> Option<End> {
        End::new(stretch.phases.first()?, stretch.pieces.iter())
    }

    fn last(stretch: &Stretch) -> Option<End> {
        End::new(stretch.phases.last()?, stretch.pieces.iter().rev())
    }

    fn new<'a>(phase: &Phase, pieces: impl Iterator<Item = &'a Piece>) -> Option<End> {
        let straight =
            pieces.take_while(|piece| piece.is_straight()).map(|piece| piece.length).sum();
        Some(End { jerk: phase.jerk.abs(), duration_s: phase.duration_s, straight })
    }
}

/// How long two movements overlap at a corner. Each stays in its first or last phase and on a
/// straight line, so that what was computed for the corner holds.
fn overlap_of(overlap: &Overlap, last: &End, first: &End) -> f64 {
    let time = overlap_time(overlap.reach, last.jerk, first.jerk);
    [last, first]
        .into_iter()
        .fold(time, |time, end| time.min(end.duration_s).min(cbrt(6.0 * end.straight / end.jerk)))
}
