//! Moves on which the direction of the tool changes, and their bodies.

use chordal_geometry::{Transform, Vec3};
use chordal_machine::{RotaryAxis, tool_rotations};
use chordal_stock::{AxialSolid, AxisTurn, ToolTurn};

use super::tools::{ShankPiece, ToolBody, UNKNOWN_SHANK_MM};
use super::turns::are_same;
use chordal_diagnostics::Code;

/// Positions that differ by less than this are equal, mm.
const COINCIDENT_MM: f64 = 1e-6;
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

impl ToolBody {
    /// What it removes where it is not upright: what is certainly removed and, where more may be, that.
    pub fn solids(&self) -> [Option<AxialSolid>; 2] {
        if !self.undercuts.is_empty() {
            return [Some(AxialSolid::of_undercuts(&self.undercuts)), None];
        }
        let of = |cutter: &chordal_stock::CutterProfile| {
            AxialSolid::of_cutter(cutter, cutter.flutes().unwrap_or(UNKNOWN_SHANK_MM))
        };
        match &self.core {
            Some(core) => [Some(of(core)), Some(of(&self.cutter))],
            None => [Some(of(&self.cutter)), None],
        }
    }

    /// All that cuts, for moves that must not.
    pub fn edges_solid(&self) -> AxialSolid {
        let [sure, may] = self.solids();
        may.or(sure).unwrap_or_default()
    }

    /// The bodies above its edges that must not touch, with the problem that each makes.
    pub fn solids_above(&self) -> Vec<(Code, AxialSolid)> {
        let stack = |pieces: &[ShankPiece]| {
            let from = pieces.first()?.from;
            let segments: Vec<[f64; 3]> =
                pieces.iter().map(|piece| [piece.height, piece.lower, piece.upper]).collect();
            let solid = AxialSolid::stack(from, &segments);
            (!solid.is_empty()).then_some(solid)
        };
        let mut found = Vec::new();
        found.extend(stack(&self.holder).map(|solid| (Code::HolderInStock, solid)));
        let shank = stack(&self.shank);
        let has_shank = shank.is_some();
        found.extend(shank.map(|solid| (Code::ShankInStock, solid)));
        // A shank that is not given is taken to be as wide as the edges.
        if let (false, true, Some(from)) =
            (has_shank, self.undercuts.is_empty(), self.cutter.flutes())
        {
            let end = self.holder.first().map_or(UNKNOWN_SHANK_MM, |piece| piece.from);
            let diameter = 2.0 * self.cutter.radius();
            let solid = AxialSolid::stack(from, &[[end - from, diameter, diameter]]);
            if !solid.is_empty() {
                found.push((Code::DeeperThanFlutes, solid));
            }
        }
        found
    }
}
