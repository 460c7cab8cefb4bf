//! Planned trajectories and waits on one line of time, before they are cut into windows.

use std::collections::VecDeque;

use crate::trajectory::{PlannedTrajectory, PlannerStep};

/// A trajectory with its sums, so that an instant and a place are found by halves.
#[derive(Debug, Default)]
pub(super) struct TimelineEntry {
    pub trajectory: PlannedTrajectory,
    /// When each phase begins, s from the start of the trajectory; one more at the end.
    pub times: Vec<f64>,
    /// Where each piece begins in σ; one more at the end.
    pub places: Vec<f64>,
}

impl TimelineEntry {
    fn set(&mut self, trajectory: &PlannedTrajectory) {
        self.trajectory.clone_from(trajectory);
        sums(&mut self.times, trajectory.phases.iter().map(|phase| phase.duration_s));
        sums(&mut self.places, trajectory.pieces.iter().map(|piece| piece.length));
    }

    pub fn duration_s(&self) -> f64 {
        self.times.last().copied().unwrap_or(0.0)
    }

    /// The phase under way at `t` s from its start.
    pub fn phase_at(&self, t: f64) -> usize {
        let last = self.trajectory.phases.len().saturating_sub(1);
        self.times.partition_point(|from| *from <= t).saturating_sub(1).min(last)
    }

    /// The piece that is reached at `t` s from its start.
    pub fn piece_at(&self, t: f64) -> usize {
        let index = self.phase_at(t);
        let phase = &self.trajectory.phases[index];
        let sigma = phase.at((t - self.times[index]).clamp(0.0, phase.duration_s)).sigma;
        let last = self.trajectory.pieces.len().saturating_sub(1);
        self.places.partition_point(|from| *from <= sigma).saturating_sub(1).min(last)
    }
}

fn sums(into: &mut Vec<f64>, parts: impl Iterator<Item = f64>) {
    into.clear();
    let mut sum = 0.0;
    into.push(sum);
    for part in parts {
        sum += part;
        into.push(sum);
    }
}

/// What comes on the line.
#[derive(Debug)]
pub(super) enum TimelineItem {
    /// A trajectory and when it begins, s from the start of the next window.
    Trajectory(TimelineEntry, f64),
    /// A wait, begun where the trajectories before it end.
    Wait(f64, u64),
}

/// Trajectories and waits that are not yet wholly in windows.
#[derive(Debug, Default)]
pub(super) struct StreamTimeline {
    pub items: VecDeque<TimelineItem>,
    /// Used ones, for their memory.
    spare: Vec<TimelineEntry>,
    /// When the trajectories up to the first wait end, and until when they cannot change any more,
    /// s from the start of the next window.
    pub ends_s: f64,
    pub certain_s: f64,
}

/// How many used trajectories are kept for their memory.
const MAX_SPARE_ENTRIES: usize = 8;

impl StreamTimeline {
    /// Puts a step after the others.
    pub fn push(&mut self, step: PlannerStep<'_>) {
        match step {
            PlannerStep::Trajectory(trajectory)
                if trajectory.phases.is_empty() || trajectory.pieces.is_empty() => {}
            PlannerStep::Trajectory(trajectory) => {
                let mut entry = self.spare.pop().unwrap_or_default();
                entry.set(trajectory);
                let end_s = self.last_end_s();
                let begins_s = match end_s {
                    Some(end_s) => (end_s - trajectory.overlap_s.max(0.0)).max(self.last_start_s()),
                    None => 0.0,
                };
                self.items.push_back(TimelineItem::Trajectory(entry, begins_s));
            }
            PlannerStep::Wait { seconds, tag } => {
                self.items.push_back(TimelineItem::Wait(seconds.max(0.0), tag));
            }
        }
        self.measure();
    }

    /// Whether a wait comes after the trajectories of this part of the line.
    pub fn wait_index(&self) -> Option<usize> {
        self.items.iter().position(|item| matches!(item, TimelineItem::Wait(..)))
    }

    fn last_end_s(&self) -> Option<f64> {
        match self.items.back() {
            Some(TimelineItem::Trajectory(entry, from_s)) => Some(from_s + entry.duration_s()),
            Some(TimelineItem::Wait(..)) => None,
            None => Some(0.0),
        }
    }

    fn last_start_s(&self) -> f64 {
        match self.items.back() {
            Some(TimelineItem::Trajectory(_, from_s)) => from_s.max(0.0),
            _ => 0.0,
        }
    }

    /// Measures the part before the first wait anew.
    pub fn measure(&mut self) {
        let wait = self.wait_index();
        let part = wait.unwrap_or(self.items.len());
        let (mut ends_s, mut begins_s) = (0.0_f64, 0.0_f64);
        for item in self.items.iter().take(part) {
            if let TimelineItem::Trajectory(entry, from_s) = item {
                ends_s = ends_s.max(from_s + entry.duration_s());
                begins_s = *from_s;
            }
        }
        self.ends_s = ends_s;
        // The newest trajectory may still get another one over its end.
        self.certain_s = if wait.is_some() { ends_s } else { begins_s.max(0.0) };
    }

    /// A window up to `end_s` has been cut: the line goes on from there.
    pub fn cut(&mut self, end_s: f64) {
        while let Some(TimelineItem::Trajectory(entry, from_s)) = self.items.front() {
            if from_s + entry.duration_s() > end_s + 1e-12 {
                break;
            }
            if let Some(TimelineItem::Trajectory(entry, _)) = self.items.pop_front()
                && self.spare.len() < MAX_SPARE_ENTRIES
            {
                self.spare.push(entry);
            }
        }
        for item in &mut self.items {
            match item {
                TimelineItem::Trajectory(_, from_s) => *from_s -= end_s,
                TimelineItem::Wait(..) => break,
            }
        }
        self.measure();
    }
}
