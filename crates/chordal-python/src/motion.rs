//! The planner and the sampler, alone.

use std::sync::Arc;

use arrow_array::{ArrayRef, Float64Array, RecordBatch, UInt32Array};
use arrow_schema::{DataType, Field, Schema};
use chordal::machine::{AXES, PerAxis};
use chordal::motion::{
    AxisLimit, CornerMode, KinematicLimits, MotionPlanner, MotionSample, MoveError, MoveKind,
    MoveRequest, PlannedTrajectory, PlannerLevel, PlannerOptions, PlannerStep, SetpointSampler,
};
use pyo3::prelude::*;

use crate::curve::Curve;
use crate::error;
use crate::program::{level, period, too_many};
use crate::table::Table;

/// A planned motion: stretches of path with their velocity profile. It never changes.
#[pyclass(frozen, module = "chordal._chordal")]
pub struct Motion {
    steps: Vec<MotionStepData>,
    duration_s: f64,
}

enum MotionStepData {
    Planned(PlannedTrajectory),
    Wait { seconds: f64, tag: u64 },
}

impl MotionStepData {
    fn step(&self) -> PlannerStep<'_> {
        match self {
            MotionStepData::Planned(trajectory) => PlannerStep::Trajectory(trajectory),
            MotionStepData::Wait { seconds, tag } => {
                PlannerStep::Wait { seconds: *seconds, tag: *tag }
            }
        }
    }
}

/// A move as Python gives it: curve, rotary axes from and to (rad), speed (mm/s or rad/s, `None`
/// for as fast as the axes can), corner tolerance (mm; `None` for a stop, 0 for exact) and the
/// rotary one (rad), whether it is a rapid. Without a curve: a wait, s, in place of the speed.
type MoveInput = (Option<Curve>, [f64; 3], [f64; 3], Option<f64>, Option<f64>, f64, bool);

/// Ends that are nearer than this are one point, mm or rad: rounding of the curves' ends.
const COINCIDENT_POINT: f64 = 1e-6;

fn largest_difference(a: &PerAxis<f64>, b: &PerAxis<f64>) -> f64 {
    a.iter().zip(b).fold(0.0, |most, (a, b)| most.max((a - b).abs()))
}

/// Plans moves that join on to each other, from rest to rest.
#[pyfunction]
#[pyo3(signature = (moves, limits, level_word))]
pub fn plan(
    py: Python<'_>,
    moves: Vec<MoveInput>,
    limits: Vec<Option<(f64, f64, f64)>>,
    level_word: &str,
) -> PyResult<Motion> {
    let level = level(py, level_word)?;
    let mut axes = [None; AXES];
    for (axis, limit) in axes.iter_mut().zip(limits) {
        *axis =
            limit.map(|(velocity, acceleration, jerk)| AxisLimit { velocity, acceleration, jerk });
    }
    let limits =
        KinematicLimits::new(axes).map_err(|error| error::usage(py, &error.to_string(), None))?;
    let planned = py.detach(|| planned(&moves, limits, level));
    planned.map_err(|(index, error)| {
        error::usage(py, &format!("move {index} cannot be planned: {error}"), None)
    })
}

fn planned(
    moves: &[MoveInput],
    limits: KinematicLimits,
    level: PlannerLevel,
) -> Result<Motion, (usize, MoveError)> {
    let mut planner = MotionPlanner::new(limits, PlannerOptions::new(level));
    let mut steps: Vec<MotionStepData> = Vec::new();
    let mut keep = |step: PlannerStep<'_>| {
        steps.push(match step {
            PlannerStep::Trajectory(trajectory) => MotionStepData::Planned(trajectory.clone()),
            PlannerStep::Wait { seconds, tag } => MotionStepData::Wait { seconds, tag },
        });
    };
    let mut at: Option<PerAxis<f64>> = None;
    for (index, provided) in moves.iter().enumerate() {
        let (curve, rotary_from, rotary_to, number, tolerance, rotary_rad, rapid) = *provided;
        let tag = index as u64;
        let Some(Curve(curve)) = curve else {
            let seconds = number.unwrap_or(0.0);
            if !(seconds >= 0.0 && seconds.is_finite()) {
                return Err((index, MoveError::NotFinite));
            }
            planner.wait(seconds, tag, &mut keep);
            continue;
        };
        let corner = match tolerance {
            None => CornerMode::Stop,
            Some(0.0) => CornerMode::Exact,
            Some(linear_mm) => CornerMode::Joined { linear_mm, rotary_rad },
        };
        let motion = MoveRequest {
            curve,
            rotary_from,
            rotary_to,
            path_length: None,
            speed: number.unwrap_or(f64::INFINITY),
            corner,
            kind: if rapid { MoveKind::Rapid } else { MoveKind::Cut },
            tag,
        };
        // After a wait the planner would let a move begin anywhere; here the axes would jump.
        let gap = at.map_or(0.0, |at| largest_difference(&at, &motion.from()));
        if gap > COINCIDENT_POINT {
            return Err((index, MoveError::Gap(gap)));
        }
        planner.push(&motion, &mut keep).map_err(|error| (index, error))?;
        at = Some(motion.to());
    }
    planner.finish(&mut keep);
    let mut clock = SetpointSampler::new(1.0).at_most(0);
    steps.iter().for_each(|step| clock.push(step.step(), |_| {}));
    Ok(Motion { duration_s: clock.time_s(), steps })
}

/// The setpoints of the planner alone, in mm and rad, with the jerk.
struct PyColumns {
    time: Vec<f64>,
    axes: Vec<Vec<f64>>,
    tags: Vec<u32>,
}

const NAMES: [&str; 4] = ["position", "velocity", "acceleration", "jerk"];

impl PyColumns {
    fn new() -> PyColumns {
        PyColumns { time: Vec::new(), axes: vec![Vec::new(); 24], tags: Vec::new() }
    }

    fn push(&mut self, sample: &MotionSample) {
        self.time.push(sample.time_s);
        let orders = [sample.position, sample.velocity, sample.acceleration, sample.jerk];
        for (column, value) in self.axes.iter_mut().zip(orders.into_iter().flatten()) {
            column.push(value);
        }
        self.tags.push(sample.tag as u32);
    }

    fn table(self) -> Result<Table, arrow_schema::ArrowError> {
        let mut fields = vec![Field::new("time_s", DataType::Float64, false)];
        let mut arrays: Vec<ArrayRef> = vec![Arc::new(Float64Array::from(self.time))];
        let names =
            NAMES.iter().flat_map(|name| "xyzabc".chars().map(move |l| format!("{l}_{name}")));
        for (name, values) in names.zip(self.axes) {
            fields.push(Field::new(name, DataType::Float64, false));
            arrays.push(Arc::new(Float64Array::from(values)));
        }
        fields.push(Field::new("move", DataType::UInt32, false));
        arrays.push(Arc::new(UInt32Array::from(self.tags)));
        let about = [("chordal.schema".to_string(), "chordal.motion-columns/1".to_string())];
        let schema = Schema::new_with_metadata(fields, about.into());
        Table::new(RecordBatch::try_new(Arc::new(schema), arrays)?)
    }
}

#[pymethods]
impl Motion {
    /// How long it takes, s.
    #[getter]
    fn duration(&self) -> f64 {
        self.duration_s
    }

    /// Setpoints at a period, s: the first is the start, the last the end.
    fn sample(&self, py: Python<'_>, period_s: f64, max_samples: u64) -> PyResult<Table> {
        let period_s = period(py, period_s)?;
        let table = py.detach(|| {
            let mut columns = PyColumns::new();
            let mut sampler = SetpointSampler::new(period_s).at_most(max_samples);
            for kept in &self.steps {
                sampler.push(kept.step(), |sample| columns.push(sample));
            }
            if sampler.is_exhausted() {
                return None;
            }
            sampler.finish(|sample| columns.push(sample));
            Some(columns.table().map_err(error::inside))
        });
        table.unwrap_or_else(|| Err(too_many(py, max_samples, self.duration_s)))
    }
}
