//! The rules of a control for roundings and chamfers at the end of a block.

/// The moves between which a control makes them.
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
    /// The moves between which it makes them.
    pub moves: CornerMoves,
    /// Largest number of dwells between the two moves.
    pub dwells_between: u32,
    /// Up to this angle, degrees, the moves count as straight and get no corner.
    pub straight_deg: f64,
    /// A corner that is too large for its moves is made as large as they let it; otherwise it is refused.
    pub shortens: bool,
}

impl RoundingRules {
    /// No corners; a table names what its control has.
    pub const COMMON: RoundingRules = RoundingRules {
        moves: CornerMoves::None,
        dwells_between: 0,
        straight_deg: 0.0,
        shortens: false,
    };
}
