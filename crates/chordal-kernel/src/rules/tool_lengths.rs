//! How tools of different length are made to work on the same part.

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
