//! The five-axis machines of LinuxCNC as chains, by the parameters of their kinematics modules
//! (`src/emc/kinematics/trtfuncs.c` and `5axiskins.c`).

use chordal_geometry::Vec3;

use crate::chain::{ChainError, KinematicChain};
use crate::joint::{RotaryJoint, RotaryLetter};

/// The parameters of `xyzac-trt-kins` and `xyzbc-trt-kins`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TrunnionParameters {
    /// `x-rot-point`, `y-rot-point`, `z-rot-point`: a point on the axis of C, machine coordinates, mm.
    pub rot_point: Vec3,
    /// `x-offset`, `y-offset`, `z-offset`: from that point to the tilting axis, mm. `xyzac` has no x-offset, `xyzbc` no
    /// y-offset.
    pub offset: Vec3,
    /// `conventional-directions`: the signs of ISO 841. LinuxCNC's default is `false`: both axes are reversed.
    pub conventional_directions: bool,
}

impl TrunnionParameters {
    fn chain(&self, tilt: RotaryLetter) -> Result<KinematicChain, ChainError> {
        let signed =
            |joint: RotaryJoint| RotaryJoint { reversed: !self.conventional_directions, ..joint };
        KinematicChain::new(&[
            signed(RotaryJoint::table(RotaryLetter::C, self.rot_point)),
            signed(RotaryJoint::table(tilt, self.rot_point + self.offset)),
        ])
    }
}

/// `xyzac-trt-kins`: a round table C on a tilting table A. The gauge point of the chain is the position of the joints,
/// and the length of the tool is `tool-offset`.
///
/// # Errors
/// [`ChainError::NoPoint`] if a parameter is not finite.
pub fn xyzac_trt(parameters: &TrunnionParameters) -> Result<KinematicChain, ChainError> {
    let offset = Vec3 { x: 0.0, ..parameters.offset };
    TrunnionParameters { offset, ..*parameters }.chain(RotaryLetter::A)
}

/// `xyzbc-trt-kins`: a round table C on a tilting table B, by the forward kinematics of the module. In its source of
/// August 2026 the inverse ignores `conventional-directions` in the terms of the offsets, and so misses the forward form.
///
/// # Errors
/// [`ChainError::NoPoint`] if a parameter is not finite.
pub fn xyzbc_trt(parameters: &TrunnionParameters) -> Result<KinematicChain, ChainError> {
    let offset = Vec3 { y: 0.0, ..parameters.offset };
    TrunnionParameters { offset, ..*parameters }.chain(RotaryLetter::B)
}

/// `5axiskins`: a head with C and, on it, B with the opposite direction to ISO 841. The gauge point of the chain is the
/// position of the joints, `pivot-length` (mm) below the axis of B with both axes at zero, and the length of the tool is
/// the coordinate W.
///
/// # Errors
/// [`ChainError::NoPoint`] if the length is not finite.
pub fn five_axis_head(pivot_length_mm: f64) -> Result<KinematicChain, ChainError> {
    let pivot = Vec3::Z * pivot_length_mm;
    KinematicChain::new(&[
        RotaryJoint::head(RotaryLetter::C, pivot),
        RotaryJoint::head(RotaryLetter::B, pivot).turned_around(),
    ])
}
