//! The G functions and names in force, as the control lists them.

use chordal_command::{CompensationSide, FeedMode, PathMode, Units};
use chordal_geometry::{Plane, TurnDirection};
use chordal_kernel::State;

use super::run_state::{LanguageModes, PathMotion, TransverseReading};

/// The functions in force, the motion first.
pub fn active_codes(modes: &LanguageModes, state: &State) -> Vec<String> {
    let motion = match modes.motion {
        PathMotion::Rapid => "G0",
        PathMotion::Linear => "G1",
        PathMotion::Arc(TurnDirection::Cw) => "G2",
        PathMotion::Arc(TurnDirection::Ccw) => "G3",
        PathMotion::ThroughPoint => "CIP",
        PathMotion::Tangent => "CT",
        PathMotion::Thread => "G33",
        PathMotion::ChangingThread { grows: true } => "G34",
        PathMotion::ChangingThread { grows: false } => "G35",
        PathMotion::NotFollowed => "",
    };
    let plane = match state.plane {
        Plane::Xy => "G17",
        Plane::Zx => "G18",
        Plane::Yz => "G19",
    };
    let side = match state.side {
        CompensationSide::Off => "G40",
        CompensationSide::Left => "G41",
        CompensationSide::Right => "G42",
    };
    let path = match state.path.in_force() {
        PathMode::ExactPath | PathMode::ExactStop => "G60",
        PathMode::Continuous { tolerance_mm: None, .. } => "G64",
        PathMode::Continuous { tolerance_mm: Some(_), .. } => "G641",
    };
    let units = match (state.units, modes.feed_in_units) {
        (Units::Inch, false) => "G70",
        (Units::Millimetre, false) => "G71",
        (Units::Inch, true) => "G700",
        (Units::Millimetre, true) => "G710",
    };
    let feed = match (state.surface_speed, state.feed_mode) {
        (Some(_), _) => "G96",
        (None, FeedMode::InverseTime) => "G93",
        (None, FeedMode::PerTime) => "G94",
        (None, FeedMode::PerRevolution) => "G95",
    };
    let transverse = match modes.transverse {
        TransverseReading::Radius => "",
        TransverseReading::Diameter => "DIAMON",
        TransverseReading::DiameterOfCoordinates => "DIAM90",
    };
    let work = state.offsets.key(state.offsets.active());
    let frame = if modes.is_plain_frame { "" } else { "TRANS" };
    let distance = if state.incremental { "G91" } else { "G90" };
    let corner = if modes.intersects_corners { "G451" } else { "G450" };
    let approach = if modes.approaches_round { "KONT" } else { "NORM" };
    let names = [
        motion, frame, plane, side, &work, path, units, distance, feed, approach, corner,
        transverse,
    ];
    names.into_iter().filter(|name| !name.is_empty()).map(str::to_string).collect()
}
