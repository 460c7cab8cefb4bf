//! Finds which move a trajectory is in at which time.

use chordal_motion::{PathPart, PlannedTrajectory};

/// The part of one jerk phase that lies in one piece of path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TrajectoryPart {
    /// The tag of the piece's move.
    pub tag: u64,
    /// When it begins, s from the start of the trajectory.
    pub from_s: f64,
    /// When it ends, s from the start of the trajectory.
    pub to_s: f64,
    /// Speeds along the path at its begin and end, mm/s or rad/s.
    pub speeds: (f64, f64),
    /// True where the speed changes.
    pub changes: bool,
    /// True where the acceleration changes.
    pub jerks: bool,
}

/// Emits the parts of a trajectory in order. Together they last as long as the trajectory: what rounding leaves after
/// the last piece counts as part of it.
pub(super) fn trajectory_parts<P: PathPart>(
    trajectory: &PlannedTrajectory<P>,
    mut take: impl FnMut(TrajectoryPart),
) {
    let (pieces, phases) = (&trajectory.pieces, &trajectory.phases);
    let mut end = 0.0;
    let (mut at, mut in_phase, mut phase_from_s) = (0, 0.0, 0.0);
    for (index, piece) in pieces.iter().enumerate() {
        end += piece.length();
        let is_last = index + 1 == pieces.len();
        while let Some(phase) = phases.get(at) {
            let phase_end = phases.get(at + 1).map_or(f64::INFINITY, |next| next.from);
            let leaves = !is_last && phase_end > end;
            let until = if leaves { phase.time_at(end, in_phase) } else { phase.duration_s };
            if until > in_phase {
                take(TrajectoryPart {
                    tag: piece.tag(),
                    from_s: phase_from_s + in_phase,
                    to_s: phase_from_s + until,
                    speeds: (phase.at(in_phase).speed, phase.at(until).speed),
                    changes: phase.acceleration != 0.0 || phase.jerk != 0.0,
                    jerks: phase.jerk != 0.0,
                });
            }
            if leaves {
                in_phase = until;
                break;
            }
            phase_from_s += phase.duration_s;
            at += 1;
            in_phase = 0.0;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use chordal_machine::AXES;
    use chordal_motion::{JerkPhase, PathPiece};
    use proptest::prelude::*;

    fn piece(length: f64, tag: u64) -> PathPiece {
        PathPiece { length, base: None, start: [[0.0; AXES]; 4], tag }
    }

    /// Seven phases from rest to rest: jerk up, hold, down, cruise, and the same back.
    pub(crate) fn seven(jerk: f64, ramp_s: f64, hold_s: f64, cruise_s: f64) -> Vec<JerkPhase> {
        let mut phases: Vec<JerkPhase> = Vec::new();
        let signs = [1.0, 0.0, -1.0, 0.0, -1.0, 0.0, 1.0];
        let times = [ramp_s, hold_s, ramp_s, cruise_s, ramp_s, hold_s, ramp_s];
        let (mut from, mut speed, mut acceleration) = (0.0, 0.0, 0.0);
        for (sign, duration_s) in signs.into_iter().zip(times) {
            let phase = JerkPhase { duration_s, from, speed, acceleration, jerk: sign * jerk };
            let end = phase.at(duration_s);
            (from, speed) = (end.sigma, end.speed);
            // Exactly zero between the ramps, as a planner has it.
            acceleration =
                if sign == 0.0 { acceleration } else { (end.acceleration * 1e6).round() / 1e6 };
            phases.push(phase);
        }
        phases
    }

    #[test]
    fn a_line_cut_in_halves_takes_half_the_time_each() {
        let phases = seven(1000.0, 0.1, 0.2, 0.3);
        let last = phases[6];
        let total = last.at(last.duration_s).sigma;
        let trajectory = PlannedTrajectory {
            pieces: vec![piece(total / 2.0, 1), piece(total / 2.0, 2)],
            phases,
            overlap_s: 0.0,
        };
        let mut times = [0.0; 3];
        trajectory_parts(&trajectory, |part| times[part.tag as usize] += part.to_s - part.from_s);
        assert!((times[1] - 0.55).abs() < 1e-9, "{times:?}");
        assert!((times[1] + times[2] - 1.1).abs() < 1e-12, "{times:?}");
    }

    proptest! {
        #[test]
        fn parts_join_and_keep_the_length(
            jerk in 1.0..1e5f64, ramp in 1e-3..1.0f64, hold in 0.0..1.0f64,
            cruise in 0.0..1.0f64, cuts in prop::collection::vec(0.0..1.0f64, 0..20),
        ) {
            let phases = seven(jerk, ramp, hold, cruise);
            let last = phases[6];
            let total = last.at(last.duration_s).sigma;
            let mut cuts = cuts;
            cuts.push(0.0);
            cuts.push(1.0);
            cuts.sort_by(f64::total_cmp);
            let pieces: Vec<PathPiece> = cuts
                .windows(2)
                .enumerate()
                .map(|(tag, ends)| piece((ends[1] - ends[0]) * total, tag as u64))
                .collect();
            let trajectory = PlannedTrajectory { pieces, phases, overlap_s: 0.0 };
            let mut until = 0.0;
            trajectory_parts(&trajectory, |part| {
                assert_eq!(part.from_s, until);
                assert!(part.to_s > part.from_s);
                until = part.to_s;
            });
            prop_assert!((until - trajectory.duration_s()).abs() < 1e-12);
            // Where the velocity profile is at the end of each piece, the piece ends.
            let mut ends = vec![None; trajectory.pieces.len()];
            trajectory_parts(&trajectory, |part| ends[part.tag as usize] = Some(part.to_s));
            let mut sigma = 0.0;
            for (piece, end_s) in trajectory.pieces.iter().zip(&ends) {
                sigma += piece.length;
                let Some(mut t) = *end_s else { continue };
                let mut index = 0;
                while index < 6 && t > trajectory.phases[index].duration_s {
                    t -= trajectory.phases[index].duration_s;
                    index += 1;
                }
                let at = trajectory.phases[index].at(t).sigma;
                prop_assert!((at - sigma).abs() < 1e-9 * total, "{at} for {sigma} of {total}");
            }
        }
    }
}
