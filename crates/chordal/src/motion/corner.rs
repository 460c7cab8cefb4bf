//! How the machine passes the corner at the end of a move.
//!
//! | from → to | how |
//! |---|---|
//! | bend of a dog-leg rapid, where its shape is kept | within the machine's `rapid_corner_tolerance`: no axis waits for another, and nothing is cut there |
//! | rapid → rapid, rapid → cut, cut → rapid | at rest where the control checks the position, otherwise like a cut; between rapids within `rapid_corner_tolerance` |
//! | cut → cut | by the path mode of the block that ends: many short ones as one curve where the control joins them, otherwise each corner by itself |
//! | within one spline | by the path mode, and without a stop in exact stop mode |
//! | a cycle's cut that turns round (the bottom of a hole) | at rest: a hole has its depth |
//! | between chords of one curve of the axes (tool centre point control) | as one curve, within the tolerance of the chords, or that of the path mode where it joins blocks |
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
    /// The next segment belongs to the same command.
    pub bends: bool,
    /// The next segment goes on with the same curve, of which both are chords within this distance, mm; `None` otherwise.
    pub chord_tolerance_mm: Option<f64>,
}

/// How a path segment ends, and what it is part of.
#[derive(Clone, Copy)]
pub(super) struct PieceEnd {
    pub cycle: bool,
    /// The same command goes on with another segment.
    pub bends: bool,
    /// See [`CornerRequest::chord_tolerance_mm`].
    pub chord_tolerance_mm: Option<f64>,
    /// The length of the tip's path, mm, where the segment is a path of the axes.
    pub tip_length_mm: Option<f64>,
}

impl PieceEnd {
    pub fn new(cycle: bool, bends: bool) -> PieceEnd {
        PieceEnd { cycle, bends, chord_tolerance_mm: None, tip_length_mm: None }
    }
}

/// Directions that differ by less than 0.1 degrees (this is its cosine) count as tangent: far more than the angle
/// that rounding to three decimals leaves between a line and its tangent arc.
const SMOOTH_COSINE: f64 = 0.999_998_476_913;

/// The corner between a move and the one that follows it.
pub(super) fn corner_of(
    last: &MoveRequest,
    ending: CornerRequest,
    next: &MoveRequest,
    rules: &PathRules,
    active: &ActiveMotionModes,
) -> CornerMode {
    use MoveKind::{Cut, Rapid};
    let rotary_rad = active.rotary_tolerance_rad;
    if let Some(chord_mm) = ending.chord_tolerance_mm {
        // The chords stand for one smooth curve, and join on to those of other blocks where the blocks join.
        let linear_mm = match ending.mode {
            PathMode::Continuous { tolerance_mm, joined: true } => {
                tolerance_mm.unwrap_or(active.corner_tolerance_mm).max(chord_mm)
            }
            _ => chord_mm,
        };
        return CornerMode::Joined { linear_mm, rotary_rad };
    }
    let stops = match (last.kind, next.kind) {
        (Rapid, Rapid) if ending.bends => return rapid_bend(active),
        (Rapid, Rapid) if rules.stop_between_rapids => true,
        (Rapid, Rapid) if ending.mode != PathMode::ExactStop => return rapid_bend(active),
        (Rapid, Rapid) => true,
        (Rapid, Cut) => rules.stop_before_cut,
        (Cut, Rapid) => rules.stop_after_cut,
        (Cut, Cut) => ending.cycle && turns_round(last, next),
    };
    let mode = match ending.mode {
        // A bend within one cut is not the end of a block, so exact stop does not apply.
        PathMode::ExactStop if ending.bends => PathMode::ExactPath,
        mode => mode,
    };
    match mode {
        _ if stops => CornerMode::Stop,
        PathMode::ExactStop => CornerMode::Stop,
        PathMode::ExactPath => {
            let eases = active.exact_path_tolerance_mm > 0.0;
            match eases && cosine(last, next) > SMOOTH_COSINE {
                true => {
                    CornerMode::Blended { linear_mm: active.exact_path_tolerance_mm, rotary_rad }
                }
                false => CornerMode::Exact,
            }
        }
        PathMode::Continuous { tolerance_mm, joined } => {
            let linear_mm = tolerance_mm.unwrap_or(active.corner_tolerance_mm);
            match joined {
                true => CornerMode::Joined { linear_mm, rotary_rad },
                false => CornerMode::Blended { linear_mm, rotary_rad },
            }
        }
    }
}

/// The corner between rapids. No path of the rotary axes need be kept while nothing is cut.
fn rapid_bend(active: &ActiveMotionModes) -> CornerMode {
    let linear_mm = active.rapid_corner_tolerance_mm;
    // The angle that the tolerance subtends at a radius of 100 mm.
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
