//! Roughing that descends along the contour itself (LinuxCNC G71, G72): it follows a falling piece to the next level,
//! cuts along the level, and where the contour rises again follows it up to the next pocket. Coordinates of pieces
//! are (along the passes, across them).

use chordal_diagnostics::{Code, Diagnostic};

use crate::kernel::Kernel;
use crate::rules::PocketHandling;
use crate::statement::Statement;
use crate::turning::offset::{OffsetPiece, offset};
use crate::turning::profile::{ContourEdge, CycleView};

/// Levels and positions that differ by less are equal, in units of the program (as in LinuxCNC).
const EQUAL_LEVEL: f64 = 1e-6;

/// The end of an arc counts as reached within this distance, in units of the program.
const ARC_END: f64 = 1e-3;

/// Largest number of passes of one cycle.
const MAX_PASSES: u32 = 100_000;

/// The words of a roughing cycle with its contour in a subroutine, mm on the radius.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct DescentWords {
    /// Passes along X (G72), not along Z.
    pub along_x: bool,
    /// Start point: X (a radius) and Z.
    pub start: [f64; 2],
    /// Allowance on the contour, along its normal.
    pub left: f64,
    /// Depth of a pass.
    pub depth: f64,
    /// Retraction after a pass.
    pub retract: f64,
    /// Whether pockets are cut.
    pub pockets: PocketHandling,
}

/// Why a contour cannot be cut.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum DescentFault {
    /// It has no moves.
    Empty,
    /// It reverses its direction along the passes, at this block.
    TurnsBack(chordal_command::Origin),
}

/// A contour with the move to its start, and the data of its levels.
struct ContourDescent {
    view: CycleView,
    pieces: Vec<OffsetPiece>,
    /// The unit of the program, mm, for the tolerances above.
    unit: f64,
    depth: f64,
    retract: f64,
    pockets: PocketHandling,
}

impl Kernel<'_> {
    /// Roughs down to a contour, and follows it at the end.
    pub fn rough_descent(
        &mut self,
        at: &dyn Statement,
        words: &DescentWords,
        contour: &[ContourEdge],
    ) -> Result<(), DescentFault> {
        let (view, mut pieces) = seen(words.along_x, words.start, contour, 0)?;
        let unit = self.state.units.mm();
        if let Some(back) = pieces.iter().skip(1).find(|piece| !piece.goes_on(unit)) {
            return Err(DescentFault::TurnsBack(back.origin));
        }
        offset(&mut pieces, words.left, unit);
        let first = pieces[0];
        let top = first.from[1];
        let end = pieces[pieces.len() - 1];
        if end.to[1] < top {
            let to = [end.to[0], top];
            pieces.push(OffsetPiece { from: end.to, to, arc: None, origin: end.origin });
        }
        let &DescentWords { depth, retract, pockets, .. } = words;
        let descent = ContourDescent { view, pieces, unit, depth, retract, pockets };
        self.origin.cycle = true;
        self.turn_rapid(words.start);
        self.turn_rapid(view.place(first.from));
        if !self.descend(at, &descent) {
            let message = format!("this cycle needs more than {MAX_PASSES} passes");
            self.report(
                Diagnostic::new(Code::BudgetReached, at.span(), message)
                    .help("is I, the depth of a pass, meant so small?"),
            );
        }
        self.origin.cycle = false;
        Ok(())
    }

    /// Finishes a contour in passes, each at one of the distances, mm; the last one usually zero.
    pub fn finish_passes(
        &mut self,
        at: &dyn Statement,
        start: [f64; 2],
        distances: &[f64],
        contour: &[ContourEdge],
    ) -> Result<(), DescentFault> {
        let unit = self.state.units.mm();
        // Along Z if the contour goes one way along it, from either side; otherwise along X. The side is that of the
        // moves after the first cut (rs274 of LinuxCNC 2.9).
        let second = contour.len().saturating_sub(1).min(1);
        let (mut view, mut pieces) = seen(false, start, contour, second)?;
        if !pieces.iter().skip(1).all(|piece| piece.goes_on(unit)) {
            (view, pieces) = seen(true, start, contour, 0)?;
        }
        self.origin.cycle = true;
        self.turn_rapid(start);
        for distance in distances {
            let mut moved = pieces.clone();
            offset(&mut moved, *distance, unit);
            self.turn_rapid(view.place(moved[0].from));
            self.turn_rapid(view.place(moved[0].to));
            let edges: Vec<ContourEdge> =
                moved[1..].iter().map(|piece| view.placed(&piece.edge())).collect();
            self.turn_contour(at, edges.into_iter());
        }
        self.origin.cycle = false;
        Ok(())
    }

    /// Cuts level by level; false when there are more than [`MAX_PASSES`].
    fn descend(&mut self, at: &dyn Statement, job: &ContourDescent) -> bool {
        let pieces = &job.pieces;
        let top = pieces[0].from[1];
        let (mut level, mut here, mut now) = (top, pieces[0].from, 0);
        let mut pockets = job.pockets;
        if pockets == PocketHandling::Only {
            // Follow the first descent to its bottom; the cycle without pockets has cut it.
            while now < pieces.len() && self.fall_along(at, job, now, &mut here, f64::NEG_INFINITY)
            {
                now += 1;
            }
            pockets = PocketHandling::Cut;
            level = here[1];
        }
        let (mut passes, mut retried) = (0, false);
        while now < pieces.len() {
            if passes > MAX_PASSES {
                return false;
            }
            passes += 1;
            if level > here[1] {
                level -= ((level - here[1]) / job.depth).floor().max(0.0) * job.depth;
                while level > here[1] {
                    level -= job.depth;
                }
            }
            if !self.fall_along(at, job, now, &mut here, level) {
                if pockets == PocketHandling::Left {
                    for piece in &pieces[now..] {
                        self.climb_from_level(at, job, piece, &mut here);
                    }
                    return true;
                }
                while now < pieces.len() && self.climb_piece(at, job, &pieces[now], &mut here) {
                    now += 1;
                }
                // When only pockets are cut, they begin at their own edges.
                level = if job.pockets == PocketHandling::Only { here[1] } else { top };
                continue;
            }
            if here[1] > level || (here[1] - level).abs() > EQUAL_LEVEL * job.unit {
                now += 1;
                continue;
            }
            match self.cut_level(at, job, now, here) {
                LevelCut::Done => (level, retried) = (level - job.depth, false),
                LevelCut::NextPiece => now += 1,
                // The piece may rise from here; if not, the second attempt skips it.
                LevelCut::NotMet if retried => (now, retried) = (now + 1, false),
                LevelCut::NotMet => retried = true,
            }
        }
        true
    }

    /// Cuts along the level to where the contour rises, and returns.
    fn cut_level(
        &mut self,
        at: &dyn Statement,
        job: &ContourDescent,
        now: usize,
        here: [f64; 2],
    ) -> LevelCut {
        for (index, piece) in job.pieces.iter().enumerate().skip(now) {
            let met = along_at(piece, here[1], job.unit);
            // A falling arc may itself meet the level again.
            let Some(end) = (if index == now { met.last() } else { met.first() }) else { continue };
            let length = (end - here[0]).abs();
            if length < EQUAL_LEVEL * job.unit {
                if index == now {
                    continue;
                }
                return LevelCut::NextPiece;
            }
            let back = job.retract * (length / 2.0 / job.retract).min(1.0);
            let back = if job.retract > 0.0 { back } else { 0.0 };
            self.turn_cut(at, job.view.place([*end, here[1]]));
            self.turn_rapid(job.view.place([end + back, here[1] + back]));
            self.turn_rapid(job.view.place([here[0] - back, here[1] + back]));
            self.approach_contour(at, job, now, here);
            return LevelCut::Done;
        }
        LevelCut::NotMet
    }

    /// A straight move down a piece; on the first one, which leads to the contour, it is a rapid.
    fn approach_contour(
        &mut self,
        at: &dyn Statement,
        job: &ContourDescent,
        now: usize,
        to: [f64; 2],
    ) {
        match now {
            0 => self.turn_rapid(job.view.place(to)),
            _ => self.turn_cut(at, job.view.place(to)),
        }
    }

    /// Moves down a piece to the level or its end; false when it does not fall.
    fn fall_along(
        &mut self,
        at: &dyn Statement,
        job: &ContourDescent,
        now: usize,
        here: &mut [f64; 2],
        level: f64,
    ) -> bool {
        let piece = &job.pieces[now];
        let Some((center, ccw)) = piece.arc else {
            if piece.from[1] <= piece.to[1] {
                return false;
            }
            let to = if level < piece.to[1] {
                piece.to
            } else {
                [along_at(piece, level, job.unit).first().copied().unwrap_or(piece.to[0]), level]
            };
            self.approach_contour(at, job, now, to);
            *here = to;
            return true;
        };
        if near(*here, piece.to, job.unit) {
            return true;
        }
        let met = along_at(piece, level, job.unit);
        let rising = if ccw { here[0] > center[0] } else { here[0] <= center[0] };
        if rising {
            return false;
        }
        let met = if ccw { met.last() } else { met.first() };
        let falls_there =
            |along: &&f64| if ccw { **along <= center[0] } else { **along >= center[0] };
        let to = met.filter(falls_there).map_or(piece.to, |along| [*along, level]);
        self.turn_round(at, job, piece, here, to);
        true
    }

    /// Moves up a whole piece; false when it does not rise to its end.
    fn climb_piece(
        &mut self,
        at: &dyn Statement,
        job: &ContourDescent,
        piece: &OffsetPiece,
        here: &mut [f64; 2],
    ) -> bool {
        let Some((center, ccw)) = piece.arc else {
            if piece.to[1] < piece.from[1] {
                return false;
            }
            self.turn_cut(at, job.view.place(piece.to));
            *here = piece.to;
            return true;
        };
        if !ccw {
            if here[0] > center[0] {
                return false;
            }
            self.turn_round(at, job, piece, here, piece.to);
            return true;
        }
        if here[0] >= center[0] {
            self.turn_round(at, job, piece, here, summit(piece, center));
        }
        false
    }

    /// Cuts along the level to a rising piece, and up it.
    fn climb_from_level(
        &mut self,
        at: &dyn Statement,
        job: &ContourDescent,
        piece: &OffsetPiece,
        here: &mut [f64; 2],
    ) {
        let met = along_at(piece, here[1], job.unit);
        let Some((center, ccw)) = piece.arc else {
            let Some(along) = met.first().filter(|_| piece.to[1] >= piece.from[1]) else { return };
            self.turn_cut(at, job.view.place([*along, here[1]]));
            self.turn_cut(at, job.view.place(piece.to));
            *here = piece.to;
            return;
        };
        let (along, to) = match ccw {
            false => (met.last().filter(|along| **along <= center[0]), piece.to),
            true => (met.first().filter(|along| **along >= center[0]), summit(piece, center)),
        };
        let Some(along) = along.copied() else { return };
        here[0] = along;
        self.turn_cut(at, job.view.place(*here));
        self.turn_round(at, job, piece, here, to);
    }

    /// Cuts along an arc to one of its points.
    fn turn_round(
        &mut self,
        at: &dyn Statement,
        job: &ContourDescent,
        piece: &OffsetPiece,
        here: &mut [f64; 2],
        to: [f64; 2],
    ) {
        if !near(*here, to, job.unit) {
            let edge = OffsetPiece { from: *here, to, ..*piece }.edge();
            self.turn_edge(at, &job.view.placed(&edge));
        }
        *here = to;
    }
}

/// Result of a cut along a level.
enum LevelCut {
    Done,
    /// The next piece begins here.
    NextPiece,
    /// No piece reaches this level.
    NotMet,
}

/// The contour in coordinates of the cycle, with the move from the start: along the passes the numbers decrease from
/// the end of edge `from` to that of the last one, and the contour rises.
fn seen(
    along_x: bool,
    start: [f64; 2],
    contour: &[ContourEdge],
    from: usize,
) -> Result<(CycleView, Vec<OffsetPiece>), DescentFault> {
    let (Some(first), Some(last)) = (contour.first(), contour.last()) else {
        return Err(DescentFault::Empty);
    };
    let (axis, cross) = if along_x { (0, 1) } else { (1, 0) };
    let along = if contour[from].to[axis] < last.to[axis] { -1.0 } else { 1.0 };
    // If a contour ends at the height of its start, −Z is up for passes along X.
    let across = match first.to[cross] - last.to[cross] {
        fall if fall > 0.0 => -1.0,
        fall if fall == 0.0 && along_x => -1.0,
        _ => 1.0,
    };
    let view = CycleView::by_signs(along_x, along, across);
    let mut pieces: Vec<OffsetPiece> =
        contour.iter().map(|edge| OffsetPiece::of(&view.of(edge))).collect();
    let [along, across] = view.seen(start);
    // From the other side, the start of the contour is reached across its first point.
    pieces[0].from = [along.max(pieces[0].to[0]), across];
    Ok((view, pieces))
}

/// The positions along a piece at a level, in the order of LinuxCNC: on an arc the greater first.
fn along_at(piece: &OffsetPiece, level: f64, unit: f64) -> Vec<f64> {
    let same = EQUAL_LEVEL * unit;
    let Some((center, ccw)) = piece.arc else {
        let (low, high) = (piece.from[1].min(piece.to[1]), piece.from[1].max(piece.to[1]));
        if low > level + same || high < level - same {
            return Vec::new();
        }
        let rise = piece.to[1] - piece.from[1];
        if rise.abs() < same {
            return vec![piece.from[0], piece.to[0]];
        }
        let share = (level - piece.from[1]) / rise;
        return vec![piece.from[0] + share * (piece.to[0] - piece.from[0])];
    };
    let radius = libm::hypot(piece.from[0] - center[0], piece.from[1] - center[1]);
    let square = radius * radius - (level - center[1]) * (level - center[1]);
    if square < -same {
        return Vec::new();
    }
    let half = square.max(0.0).sqrt();
    let side = if ccw { 1.0 } else { -1.0 };
    let on = |along: &f64| {
        let turn = |of: [f64; 2]| {
            (of[0] - center[0]) * (level - center[1]) - (of[1] - center[1]) * (along - center[0])
        };
        turn(piece.from) * side >= -same && turn(piece.to) * side <= same
    };
    [center[0] + half, center[0] - half].into_iter().filter(on).collect()
}

/// The highest point of an arc that rises at its start.
fn summit(piece: &OffsetPiece, center: [f64; 2]) -> [f64; 2] {
    if piece.to[0] >= center[0] {
        return piece.to;
    }
    let radius = libm::hypot(piece.from[0] - center[0], piece.from[1] - center[1]);
    [center[0], center[1] + radius]
}

fn near(a: [f64; 2], b: [f64; 2], unit: f64) -> bool {
    libm::hypot(a[0] - b[0], a[1] - b[1]) <= ARC_END * unit
}
