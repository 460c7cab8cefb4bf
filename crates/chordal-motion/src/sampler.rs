use crate::Axes;
use crate::trajectory::{Cursor, State, Step, Stretch};

/// A setpoint.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample {
    /// From the start, s.
    pub time_s: f64,
    /// mm and rad.
    pub position: Axes,
    /// mm/s and rad/s.
    pub velocity: Axes,
    /// mm/s² and rad/s².
    pub acceleration: Axes,
    /// mm/s³ and rad/s³.
    pub jerk: Axes,
    /// The tag of the move or of the wait that is under way.
    pub tag: u64,
}

impl Sample {
    /// Speed of the tool: along X, Y and Z in mm/s, or of the rotary axes in rad/s where they
    /// alone move.
    pub fn speed(&self) -> f64 {
        let length = |axes: &[f64]| axes.iter().map(|v| v * v).sum::<f64>().sqrt();
        let linear = length(&self.velocity[..3]);
        if linear > 0.0 { linear } else { length(&self.velocity[3..]) }
    }
}

/// Makes setpoints at a fixed period out of the steps of a planner, one after the other.
///
/// The last setpoint is the end itself, at the first multiple of the period that is not before
/// the end: a machine is sent whole periods.
#[derive(Clone, Debug)]
pub struct Sampler {
    period_s: f64,
    /// Number of the next setpoint.
    index: u64,
    /// Where the step after the held stretch begins, s; without its overlap.
    now_s: f64,
    /// The newest stretch and when it began: its tail may overlap the next.
    held: Option<(Stretch, f64)>,
    cursor: Cursor,
    rest: State,
}

impl Sampler {
    /// A sampler with a period in s, which must be above zero.
    pub fn new(period_s: f64) -> Sampler {
        Sampler {
            period_s,
            index: 0,
            now_s: 0.0,
            held: None,
            cursor: Cursor::default(),
            rest: State::default(),
        }
    }

    /// When what was pushed so far is over, s.
    pub fn time_s(&self) -> f64 {
        self.now_s
    }

    /// Takes a step and hands on the setpoints that are certain now.
    pub fn push(&mut self, step: Step<'_>, mut take: impl FnMut(&Sample)) {
        match step {
            Step::Stretch(stretch) if stretch.phases.is_empty() => {}
            Step::Stretch(stretch) => {
                let begins_s = (self.now_s - stretch.overlap_s).max(0.0);
                self.held_until(begins_s, &mut take);
                let mut cursor = Cursor::default();
                self.both_until(stretch, &mut cursor, begins_s, &mut take);
                self.now_s = begins_s + stretch.duration_s();
                self.held = Some((stretch.clone(), begins_s));
                self.cursor = cursor;
            }
            Step::Wait { seconds, tag } => {
                self.held_until(self.now_s, &mut take);
                self.settle();
                self.now_s += seconds.max(0.0);
                self.rest.tag = tag;
                while self.next_s() < self.now_s {
                    let state = self.rest;
                    self.emit(&state, &mut take);
                }
            }
        }
    }

    /// Hands on what is left, the end included.
    pub fn finish(mut self, mut take: impl FnMut(&Sample)) {
        self.held_until(self.now_s, &mut take);
        self.settle();
        let state = self.rest;
        self.emit(&state, &mut take);
    }

    fn next_s(&self) -> f64 {
        self.index as f64 * self.period_s
    }

    fn emit(&mut self, state: &State, take: &mut impl FnMut(&Sample)) {
        let State { position, velocity, acceleration, jerk, tag } = *state;
        let time_s = self.next_s();
        take(&Sample { time_s, position, velocity, acceleration, jerk, tag });
        self.index += 1;
    }

    /// Setpoints of the held stretch alone, before an instant.
    fn held_until(&mut self, until_s: f64, take: &mut impl FnMut(&Sample)) {
        let Some((stretch, begins_s)) = self.held.take() else { return };
        while self.next_s() < until_s {
            let state = self.cursor.at(&stretch, self.next_s() - begins_s);
            self.emit(&state, take);
        }
        self.held = Some((stretch, begins_s));
    }

    /// Setpoints while the held stretch ends and the next has begun.
    fn both_until(
        &mut self,
        next: &Stretch,
        cursor: &mut Cursor,
        begins_s: f64,
        take: &mut impl FnMut(&Sample),
    ) {
        let Some((stretch, held_s)) = self.held.take() else { return };
        let corner = next.from();
        while self.next_s() < self.now_s {
            let mut state = self.cursor.at(&stretch, self.next_s() - held_s);
            let after = cursor.at(next, self.next_s() - begins_s);
            for axis in 0..6 {
                state.position[axis] += after.position[axis] - corner[axis];
                state.velocity[axis] += after.velocity[axis];
                state.acceleration[axis] += after.acceleration[axis];
                state.jerk[axis] += after.jerk[axis];
            }
            self.emit(&state, take);
        }
    }

    /// The held stretch is over: the axes stand at its end.
    fn settle(&mut self) {
        if let Some((stretch, _)) = self.held.take() {
            let tag = stretch.pieces.last().map_or(0, |piece| piece.tag);
            self.rest = State { position: stretch.to(), tag, ..State::default() };
        }
    }
}
