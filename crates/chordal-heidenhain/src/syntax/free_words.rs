//! The words of free contours (FK) that refer to points and to other blocks.

use chordal_diagnostics::TextRange;

use super::operands::OperandWord;

/// A point that an element refers to.
#[derive(Clone, Copy, Default, PartialEq, Debug)]
pub struct FreePointWords {
    /// Its X, Y and Z.
    pub axes: [Option<OperandWord>; 3],
    /// Its distance from the pole, and its angle there, degrees.
    pub polar: [Option<OperandWord>; 2],
}

/// What a word refers to another block with.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FreeRelation {
    /// RX, RY and RZ: a coordinate of the end.
    Coordinate(usize),
    /// RPR (0) and RPA (1): a polar coordinate of the end.
    Polar(usize),
    /// RAN: the angle.
    Angle,
    /// PAR: the direction of a parallel line.
    Parallel,
    /// RCCX, RCCY and RCCZ: a coordinate of the centre.
    Center(usize),
    /// RCCPR (0) and RCCPA (1): a polar coordinate of the centre.
    CenterPolar(usize),
}

/// A word that refers to another block.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct FreeRelationWord {
    /// What refers to it.
    pub relation: FreeRelation,
    /// The number of the block.
    pub block: u32,
    /// The text of the word.
    pub range: TextRange,
}
