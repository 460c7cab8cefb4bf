//! The rules of a control for tool lengths, as data.

/// What activates a tool length and what ends it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct LengthRules {
    /// Where the length of a tool comes from.
    pub source: ToolLengths,
    /// The length that G43 without H activates.
    pub without_number: LengthWithoutNumber,
    /// `G43 H0` activates the length of the tool in the spindle; otherwise it ends the active one.
    pub zero_is_of_tool: bool,
    /// In G91 a block that activates a length adds it to the distance of its own axis word.
    pub adds_to_increment: bool,
    /// What ends a length in addition to its own codes.
    pub ended_by: LengthEnds,
}

impl LengthRules {
    /// The rules most controls share.
    pub const COMMON: LengthRules = LengthRules {
        source: ToolLengths::Table,
        without_number: LengthWithoutNumber::InForce,
        zero_is_of_tool: false,
        adds_to_increment: false,
        ended_by: LengthEnds {
            tool_change: false,
            reference_return: false,
            machine_move: false,
            program_end: true,
        },
    };

    /// The rules of a control without tool lengths.
    pub const ABSENT: LengthRules =
        LengthRules { source: ToolLengths::Absent, ..LengthRules::COMMON };
}

/// What ends the active length.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct LengthEnds {
    /// A change of tools (M6).
    pub tool_change: bool,
    /// A return of Z to a reference point (G28, G30).
    pub reference_return: bool,
    /// A move of Z in machine coordinates (G53).
    pub machine_move: bool,
    /// The end of the program (M2, M30) and reset: a program begins without a length. Otherwise it begins with the one
    /// that the program before it left.
    pub program_end: bool,
}

/// Where the length of a tool comes from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ToolLengths {
    /// From the offset table, by a code of the program. For a program with one tool, the work offset may be set with
    /// that tool instead.
    Table,
    /// From the table if the program says so; otherwise the operator sets the work offset again with each tool.
    TouchedOff,
    /// The control has no tool lengths.
    Absent,
}

/// The length that G43 or G44 without H activates.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LengthWithoutNumber {
    /// The active one, and none if there is none (an Allen-Bradley 9 Series manual says so of the same codes).
    InForce,
    /// The length of the tool in the spindle.
    OfTool,
}
