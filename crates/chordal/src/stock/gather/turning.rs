//! Moves on which the direction of the tool changes.

use chordal_diagnostics::Code;
use chordal_geometry::{Curve, Line, ParamCurve, Transform, Vec3};
use chordal_machine::{RotaryAxis, tool_rotations};
use chordal_path::Segment;
use chordal_stock::{AxisTurn, ToolTurn, TurningTask};

use super::super::problems::not_cut;
use super::super::tools::ToolBody;
use super::super::turns::are_same;
use super::{BatchKind, PartlyKnown, StockMoves};

/// Positions that differ by less than this are equal, mm.
const COINCIDENT_MM: f64 = 1e-6;
/// Most straight sweeps of parts of tools that turn, in a run: they take some ten minutes.
const MAX_SWEEPS: u64 = 1_000_000;
const LETTERS: [char; 3] = ['A', 'B', 'C'];

/// Where a cut has ended whose tool is not upright.
#[derive(Clone, Copy, Debug)]
pub(super) struct TurnedEnd {
    pub tool: u32,
    /// Angles of A, B and C, rad.
    pub angles: [f64; 3],
    /// The tip, mm.
    pub tip: Vec3,
}

impl TurnedEnd {
    /// Whether a move of a tool begins there.
    pub fn is_start_of(&self, tool: u32, angles: [f64; 3], tip: Vec3) -> bool {
        self.tool == tool && are_same(self.angles, angles) && self.tip.distance(tip) < COINCIDENT_MM
    }
}

/// How the direction of the tool turns while A, B and C turn evenly from some angles to others (rad), as seen from a
/// side; an error says why it is not known.
pub(super) fn tool_turn(
    rotary: &[RotaryAxis; 3],
    [from, to]: [[f64; 3]; 2],
    to_side: &Transform,
) -> Result<ToolTurn, String> {
    for axis in 0..3 {
        if rotary[axis].turns.is_none() && (from[axis] != 0.0 || to[axis] != 0.0) {
            let letter = LETTERS[axis];
            return Err(format!("what {letter} turns is not known: give [rotary.{letter}]"));
        }
    }
    let turns: Vec<AxisTurn> = tool_rotations(rotary)
        .into_iter()
        .map(|rotation| AxisTurn {
            about: to_side.apply_direction(rotation.about),
            from: from[rotation.axis],
            to: to[rotation.axis],
        })
        .collect();
    ToolTurn::new(to_side.apply_direction(Vec3::Z), &turns)
        .ok_or_else(|| "the angles of its rotary axes are not known".to_string())
}

impl StockMoves<'_> {
    /// Leaves out the moves of turning tools that take more sweeps in columns with this side (mm) than are carried out,
    /// and reports the first of each tool.
    pub fn limit_turning(&mut self, resolution: f64) {
        let mut left = MAX_SWEEPS;
        let mut reported = Vec::new();
        for batch in self.batches.iter_mut().filter(|batch| !batch.tool_turns.is_empty()) {
            let Some(Ok(tool)) = self.tools.get(&batch.tool) else { continue };
            let [removes, may] = tool.solids();
            let task = TurningTask {
                turns: &[],
                removes: removes.as_ref(),
                may: may.as_ref(),
                bodies: &[],
            };
            let follows = batch.moves.iter().zip(&batch.tool_turns).position(|(path, turn)| {
                let sweeps = task.sweeps(&path.curve, turn, resolution);
                left = left.saturating_sub(sweeps);
                left == 0
            });
            let Some(end) = follows else { continue };
            if let Some(origin) = batch.origins.get(end) {
                reported.push((batch.tool, *origin, batch.kind.is_rapid()));
            }
            batch.moves.truncate(end);
            batch.tool_turns.truncate(end);
            batch.checked.truncate(end);
            batch.origins.truncate(end);
            batch.rates.truncate(end);
            batch.rows.truncate(end);
        }
        self.batches.retain(|batch| !batch.moves.is_empty());
        for (tool, origin, is_rapid) in reported {
            self.misses_cuts |= !is_rapid;
            let code = Code::StockNotFollowed;
            if !self.reported.contains(&(code, tool)) {
                self.reported.push((code, tool));
                let why = "the tool turns too often for columns of this size; wider ones take fewer sweeps";
                self.diagnostics.push(not_cut(code, &origin, tool, why));
            }
        }
    }

    /// Takes a move on which the direction of the tool changes, has changed before, or is that of a head: it is cut from the side that was
    /// cut last, with the tool as it lies there.
    pub(super) fn segment_turning(&mut self, segment: &Segment, kind: BatchKind) {
        let stands = are_same(segment.rotary_from, segment.rotary_to);
        if !stands && !self.follows_tip {
            let why = "rotary axes turn on it, and the tip is not held";
            return self.report_once(Code::StockNotFollowed, segment, why);
        }
        if !self.follows_turns {
            self.leaves_out_turned = true;
            let why = "the direction of the tool changes on it";
            return self.report_once(Code::StockNotFollowed, segment, why);
        }
        if segment.unrelated_zero.is_some() {
            return self.frame_not_known(segment, kind);
        }
        let mut angles = [segment.rotary_from, segment.rotary_to];
        let mut curve = segment.curve;
        if !segment.known {
            let rest = if kind.is_rapid() { Some(self.rapid_of(segment)) } else { None };
            match rest {
                Some(PartlyKnown::Clear) => return,
                Some(PartlyKnown::End(_)) => {
                    // Only where it ends is known.
                    let end = curve.end();
                    (curve, angles[0]) = (Curve::Line(Line { start: end, end }), angles[1]);
                }
                Some(PartlyKnown::AtDepth) | None => {
                    let why = "where the tool is relative to the part is not known";
                    return self.report_once(Code::StockNotFollowed, segment, why);
                }
            }
        }
        if !segment.tip_known {
            return self.tip_not_known(segment, kind);
        }
        let side = self.batches.last().map_or(0, |batch| batch.turn);
        let to_program = self.turns[side].to_program;
        let turn = match tool_turn(&self.rotary, angles, &to_program) {
            Ok(turn) => turn,
            Err(why) => return self.report_once(Code::StockNotFollowed, segment, &why),
        };
        let end = TurnedEnd { tool: segment.tool, angles: angles[1], tip: curve.end() };
        let is_free = kind.is_rapid() && stands && self.leaves_turned_end(segment, &turn, side);
        curve = curve.transformed(&to_program);
        self.put(&Segment { curve, ..*segment }, kind, side, Some(turn), is_free);
        self.turned_end = (kind == BatchKind::Cut).then_some(end);
        if kind == BatchKind::Cut && !stands {
            self.turning_tools.insert(segment.tool);
        }
    }

    /// Whether a rapid goes straight back along the tool from where it has ended a cut.
    fn leaves_turned_end(&self, segment: &Segment, turn: &ToolTurn, side: usize) -> bool {
        let (Some(end), Curve::Line(line)) = (&self.turned_end, &segment.curve) else {
            return false;
        };
        let back = self.turns[side].to_program.apply_direction(line.end - line.start);
        let is_back = back.dot(turn.direction(0.0)) >= back.length() * (1.0 - 1e-12);
        let widens = |body: &ToolBody| body.widens() && body.core.is_none();
        let tool = self.tools.get(&segment.tool).and_then(|body| body.as_ref().ok());
        is_back
            && end.is_start_of(segment.tool, segment.rotary_from, line.start)
            && tool.is_some_and(widens)
    }
}
