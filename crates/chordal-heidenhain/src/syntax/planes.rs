//! The words of PLANE.

use super::operands::OperandWord;

/// How PLANE gives the tilted plane.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PlaneForm {
    /// SPATIAL: three angles.
    Spatial,
    /// EULER: three angles, about Z, the new X and the new Z.
    Euler,
    /// PROJECTED: the angles of its traces in the planes Z/X and Y/Z, and a rotation in the plane.
    Projected,
    /// AXIAL: positions of the rotary axes.
    Axial,
    /// VECTOR: the new X axis and the new Z axis.
    Vector,
    /// POINTS: two points give the new X axis, a third one the side of Y.
    Points,
    /// RELATIV: one spatial angle in the plane that is in force.
    Relative,
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
    /// EULPR, EULNU and EULROT, degrees.
    pub euler: [Option<OperandWord>; 3],
    /// PROPR, PROMIN and ROT, degrees.
    pub projected: [Option<OperandWord>; 3],
    /// A, B and C of AXIAL, degrees.
    pub axial: [Option<OperandWord>; 3],
    /// P1X to P3Z.
    pub points: [[Option<OperandWord>; 3]; 3],
    /// BX, BY and BZ.
    pub base: [Option<OperandWord>; 3],
    /// NX, NY and NZ.
    pub normal: [Option<OperandWord>; 3],
    /// What the rotary axes do.
    pub positioning: Option<PlanePositioning>,
    /// SEQ+ (true) or SEQ-: the sign of the rotary axis that is nearer to the tool.
    pub sequence: Option<bool>,
}
