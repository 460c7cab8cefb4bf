//! How tools of different length are made to work on the same part.

/// What brings a length into force and what takes it away.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct LengthRules {
    /// Where the length of a tool comes from.
    pub source: ToolLengths,
    /// Which length G43 without H brings into force.
    pub without_number: LengthWithoutNumber,
    /// `G43 H0` brings the length of the tool in the spindle into force; otherwise it ends the one in force.
    pub zero_is_of_tool: bool,
    /// In G91 a block that brings a length into force adds it to the way of its own axis word.
    pub adds_to_increment: bool,
    /// What ends a length beside its own codes.
    pub ended_by: LengthEnds,
}

impl LengthRules {
    /// What most controls do.
    pub const COMMON: LengthRules = LengthRules {
        source: ToolLengths::Table,
        without_number: LengthWithoutNumber::InForce,
        zero_is_of_tool: false,
        adds_to_increment: false,
        ended_by: LengthEnds { tool_change: false, reference_return: false, machine_move: false },
    };
}

/// What ends the length in force.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct LengthEnds {
    /// A change of tools (M6).
    pub tool_change: bool,
    /// A return of Z to a reference point (G28, G30).
    pub reference_return: bool,
    /// A move of Z in machine coordinates (G53).
    pub machine_move: bool,
}

/// Where the length of a tool comes from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ToolLengths {
    /// From the offset table, by a code of the program. A program of one tool may have its work offset set with
    /// that tool.
    Table,
    /// From the table where the program says so; otherwise the work offset is set anew with each tool.
    TouchedOff,
    /// The control has no tool lengths.
    Absent,
}

/// Which length G43 or G44 without H brings into force.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LengthWithoutNumber {
    /// The one that is in force, and none where none is (an Allen-Bradley 9 Series manual prints it so of the same
    /// codes).
    InForce,
    /// That of the tool in the spindle.
    OfTool,
}
