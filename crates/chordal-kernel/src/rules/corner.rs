//! Roundings and chamfers that a block asks for at its end.

/// Between which moves a control puts them.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CornerMoves {
    /// It has none.
    None,
    /// Between two straight cuts.
    Lines,
    /// Between straight cuts and arcs.
    LinesAndArcs,
}

/// The rules of roundings and chamfers.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RoundingRules {
    /// Between which moves.
    pub moves: CornerMoves,
    /// So many dwells may stand between the two moves.
    pub dwells_between: u32,
    /// A corner that turns by no more than this gets nothing, degrees.
    pub straight_deg: f64,
}

impl RoundingRules {
    /// None; a table names what its control has.
    pub const COMMON: RoundingRules =
        RoundingRules { moves: CornerMoves::None, dwells_between: 0, straight_deg: 0.0 };
}
