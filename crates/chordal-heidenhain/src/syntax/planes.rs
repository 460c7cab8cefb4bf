//! The words of PLANE.

use super::operands::OperandWord;

/// How PLANE gives the tilted plane.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PlaneForm {
    /// SPATIAL: three angles.
    Spatial,
    /// VECTOR: the new X axis and the new Z axis.
    Vector,
    /// RESET.
    Reset,
    /// Another one, which is not carried out.
    Other,
}

/// What the rotary axes do after PLANE.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PlanePositioning {
    /// MOVE: they turn, and the tip follows.
    Move,
    /// TURN: they turn.
    Turn,
    /// STAY: they stay; their angles are given in Q120 to Q122.
    Stay,
}

/// The words of PLANE.
#[derive(Clone, PartialEq, Debug)]
pub struct PlaneWords {
    /// Its form.
    pub form: PlaneForm,
    /// SPA, SPB and SPC, degrees.
    pub angles: [Option<OperandWord>; 3],
    /// BX, BY and BZ.
    pub base: [Option<OperandWord>; 3],
    /// NX, NY and NZ.
    pub normal: [Option<OperandWord>; 3],
    /// What the rotary axes do.
    pub positioning: Option<PlanePositioning>,
}
