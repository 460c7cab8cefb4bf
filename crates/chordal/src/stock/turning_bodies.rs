//! The bodies of a tool that is not upright.

use chordal_diagnostics::Code;
use chordal_stock::{AxialSolid, CutterProfile};

use super::tools::{ShankPiece, ToolBody, UNKNOWN_SHANK_MM};

impl ToolBody {
    /// What it removes where it is not upright: what is certainly removed and, where more may be, that.
    pub fn solids(&self) -> [Option<AxialSolid>; 2] {
        if !self.undercuts.is_empty() {
            return [Some(AxialSolid::of_undercuts(&self.undercuts)), None];
        }
        let of = |cutter: &CutterProfile| {
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
