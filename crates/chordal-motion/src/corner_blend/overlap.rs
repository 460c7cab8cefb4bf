//! Two movements that overlap at a corner: the next begins before the last has ended.

use crate::corner_blend::joint::{OverlapLimits, overlap_time};
use crate::corner_blend::path_span::PathPart;
use crate::cube_root::cbrt;
use crate::trajectory::JerkPhase;

/// The end of a trajectory that is at rest, with the corner.
#[derive(Clone, Copy, Debug)]
pub struct RestEnd {
    jerk: f64,
    duration_s: f64,
    /// Distance from the corner over which the path is a straight line.
    straight: f64,
}

impl RestEnd {
    /// The end at the start of a trajectory.
    pub fn first(phases: &[JerkPhase], pieces: &[impl PathPart]) -> Option<RestEnd> {
        RestEnd::new(phases.iter(), pieces.iter())
    }

    /// The end at the end of a trajectory.
    pub fn last(phases: &[JerkPhase], pieces: &[impl PathPart]) -> Option<RestEnd> {
        RestEnd::new(phases.iter().rev(), pieces.iter().rev())
    }

    /// The phases and pieces as seen from the corner. Both when a movement begins and when it
    /// ends, the jerk at rest is positive.
    fn new<'a>(
        phases: impl Iterator<Item = &'a JerkPhase>,
        pieces: impl Iterator<Item = &'a (impl PathPart + 'a)>,
    ) -> Option<RestEnd> {
        let (mut jerk, mut acceleration, mut time) = (0.0_f64, 0.0_f64, 0.0_f64);
        for phase in phases.take_while(|phase| phase.jerk > 0.0) {
            jerk = jerk.max(phase.jerk);
            acceleration += phase.jerk * phase.duration_s;
            time += phase.duration_s;
        }
        let straight =
            pieces.take_while(|piece| piece.is_straight()).map(|piece| piece.length()).sum();
        let duration_s = time.min(acceleration / jerk);
        (jerk > 0.0).then_some(RestEnd { jerk, duration_s, straight })
    }
}

/// How long two movements overlap at a corner. Each stays in its first or last phase and on a
/// straight line, so that what was computed for the corner holds.
pub fn overlap_of(overlap: &OverlapLimits, last: &RestEnd, first: &RestEnd) -> f64 {
    let time = overlap_time(overlap.reach, last.jerk, first.jerk);
    [last, first]
        .into_iter()
        .fold(time, |time, end| time.min(end.duration_s).min(cbrt(6.0 * end.straight / end.jerk)))
}
