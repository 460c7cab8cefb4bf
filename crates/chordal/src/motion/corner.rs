//! How the end of a move is passed.
//!
//! | from → to | how |
//! |---|---|
//! | bend of a dog-leg rapid, where its shape is kept | within the machine's `rapid_corner_tolerance`: no axis waits for another, and nothing is cut there |
//! | rapid → rapid, rapid → cut, cut → rapid | at rest where the control checks the position, otherwise like a cut; between rapids within `rapid_corner_tolerance` |
//! | cut → cut | by the path mode of the block that ends: many short ones as one curve where the control joins them, otherwise each corner by itself |
//! | within one spline | by the path mode, and without a stop in exact stop mode |
//! | a cycle's cut that turns round (the bottom of a hole) | at rest: a hole has its depth |
//! | before a wait | at rest |

use chordal_command::PathMode;
use chordal_geometry::{ParamCurve, Vec3};
use chordal_kernel::rules::PathRules;
use chordal_motion::{CornerMode, MoveKind, MoveRequest};

use super::options::ActiveMotionModes;

/// How the end of a pending move was programmed.
#[derive(Clone, Copy, Debug)]
pub(super) struct CornerRequest {
    /// The path mode of its block.
    pub mode: PathMode,
    pub cycle: bool,
    /// The next piece belongs to the same command.
    pub bends: bool,
}

/// Directions that differ by less than this go on smoothly, as cosine of 0.1 degrees: far above
/// what words with three decimals leave between a line and its tangent arc.
const SMOOTH_COSINE: f64 = 0.999_998_476_913;

/// The corner between a move and the one that follows it.
pub(super) fn corner_of(
    last: &MoveRequest,
    ending: CornerRequest,
    next: &MoveRequest,
    rules: &PathRules,
    in_force: &ActiveMotionModes,
) -> CornerMode {
    use MoveKind::{Cut, Rapid};
    let rotary_rad = in_force.rotary_tolerance_rad;
    let stops = match (last.kind, next.kind) {
        (Rapid, Rapid) if ending.bends => return rapid_bend(in_force),
        (Rapid, Rapid) if rules.stop_between_rapids => true,
        (Rapid, Rapid) if ending.mode != PathMode::ExactStop => return rapid_bend(in_force),
        (Rapid, Rapid) => true,
        (Rapid, Cut) => rules.stop_before_cut,
        (Cut, Rapid) => rules.stop_after_cut,
        (Cut, Cut) => ending.cycle && turns_round(last, next),
    };
    let mode = match ending.mode {
        // Within one cut there is no end of a block.
        PathMode::ExactStop if ending.bends => PathMode::ExactPath,
        mode => mode,
    };
    match mode {
        _ if stops => CornerMode::Stop,
        PathMode::ExactStop => CornerMode::Stop,
        PathMode::ExactPath => {
            let eases = in_force.exact_path_tolerance_mm > 0.0;
            match eases && cosine(last, next) > SMOOTH_COSINE {
                true => {
                    CornerMode::Blended { linear_mm: in_force.exact_path_tolerance_mm, rotary_rad }
                }
                false => CornerMode::Exact,
            }
        }
        PathMode::Continuous { tolerance_mm, joined } => {
            let linear_mm = tolerance_mm.unwrap_or(in_force.corner_tolerance_mm);
            match joined {
                true => CornerMode::Joined { linear_mm, rotary_rad },
                false => CornerMode::Blended { linear_mm, rotary_rad },
            }
        }
    }
}

/// Rotary axes have no path that could be missed while nothing is cut.
fn rapid_bend(in_force: &ActiveMotionModes) -> CornerMode {
    let linear_mm = in_force.rapid_corner_tolerance_mm;
    // The same part of a turn as the tolerance is of a 100 mm radius.
    CornerMode::Blended { linear_mm, rotary_rad: linear_mm / 100.0 }
}

/// Cosine of the angle between the end of a move and the start of the next.
fn cosine(ending: &MoveRequest, next: &MoveRequest) -> f64 {
    let along = |curve: &chordal_geometry::Curve, s: f64| -> Vec3 { curve.tangent_at(s) };
    along(&ending.curve, ending.curve.length()).dot(along(&next.curve, 0.0))
}

fn turns_round(ending: &MoveRequest, next: &MoveRequest) -> bool {
    cosine(ending, next) < -0.999
}
