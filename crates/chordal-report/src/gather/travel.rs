//! Where the tool goes: in each work coordinate system, and against the machine's travel.

use chordal::control::WorkNaming;
use chordal::control::{AxisMask, Command, CommandKind, Move, Position, WorkName};
use chordal::geometry::{Aabb, ParamCurve};
use chordal::machine::{AXES, Axis, PerAxis};
use chordal::path::{ProgramFrame, curve_of, places_on_axes, tip_pieces};
use chordal::{Job, Machine};

use crate::data::{AxisRange, AxisValue, CappedRows, MachineTravel, ReportedWorkOffset, Travel};

/// Work coordinate systems that are listed separately, those included that the program moves.
const MAX_SYSTEMS: usize = 60;
/// Lines named where the program moves a work offset.
const MAX_LINES: usize = 6;
/// How far the extremes of the axes may be outside of the true ones where they follow a tip, mm: what the sheet shows.
const SHOWN_TOLERANCE_MM: f64 = 1e-4;
/// Offsets that differ by less are the same, mm and rad.
const EQUAL_OFFSET: f64 = 1e-9;

/// A range of places; empty at first.
#[derive(Clone, Copy, Debug)]
struct TravelRange(f64, f64);

impl TravelRange {
    const EMPTY: TravelRange = TravelRange(f64::INFINITY, f64::NEG_INFINITY);

    fn take(&mut self, value: f64) {
        self.0 = self.0.min(value);
        self.1 = self.1.max(value);
    }

    fn get(self) -> Option<(f64, f64)> {
        (self.0 <= self.1).then_some((self.0, self.1))
    }
}

/// A work coordinate system at one place.
#[derive(Debug)]
struct WorkSystem {
    name: WorkName,
    offset: Position,
    known: AxisMask,
    /// Where it came into force.
    line: u32,
    moves: bool,
    all: PerAxis<TravelRange>,
    cuts: PerAxis<TravelRange>,
}

/// Watches the tool centre go by.
#[derive(Debug)]
pub struct TravelWatcher {
    frame: ProgramFrame,
    systems: Vec<WorkSystem>,
    /// The one in force, where it is one of those that are kept.
    at: Option<usize>,
    left_out: u64,
    machine: PerAxis<TravelRange>,
    unknown: AxisMask,
}

impl TravelWatcher {
    pub fn new(job: &Job) -> TravelWatcher {
        let (offset, known) = job.initial_offset();
        let mut travels = TravelWatcher {
            frame: ProgramFrame::new(offset, known),
            systems: Vec::new(),
            at: None,
            left_out: 0,
            machine: [TravelRange::EMPTY; AXES],
            unknown: AxisMask::NONE,
        };
        travels.select(job.initial_work_offset(), offset, known, 0);
        travels
    }

    /// Follows a command of the tool centre. Gives the lowest Z of a cut, program coordinates.
    pub fn command(&mut self, command: &Command) -> Option<f64> {
        if let CommandKind::WorkOffset { name, offset, known, .. } = &command.kind {
            self.select(*name, *offset, *known, command.origin.line);
        }
        if self.frame.follow(command) {
            return None;
        }
        let motion = command.kind.motion()?;
        let cuts = command.kind.feed().is_some();
        let bounds = match command.kind.spline() {
            Some(curve) => Some(curve.bounds()),
            None => command.kind.shape().map(|shape| curve_of(motion, Some(shape)).bounds()),
        };
        match self.frame.surface {
            Some(run) => {
                let (places, known) = places_on_axes(&run, motion, command.kind.shape());
                self.on_surface(&places, known, cuts);
            }
            None => {
                self.motion(motion, bounds, cuts);
                self.axes_of_tip(command, motion);
            }
        }
        let z_is_known = motion.from_known.has(2) && motion.to_known.has(2);
        let lowest = bounds.map_or(motion.from[2].min(motion.to[2]), |bounds| bounds.min.z);
        (cuts && z_is_known).then_some(lowest)
    }

    fn select(&mut self, name: WorkName, offset: Position, known: AxisMask, line: u32) {
        let same = |system: &WorkSystem| {
            let near = |(a, b): (&f64, &f64)| (a - b).abs() <= EQUAL_OFFSET;
            system.name == name && system.offset.iter().zip(&offset).all(near)
        };
        self.at = self.systems.iter().position(same);
        if self.at.is_some() {
            return;
        }
        if self.systems.len() >= MAX_SYSTEMS {
            self.left_out += 1;
            return;
        }
        self.at = Some(self.systems.len());
        let (all, cuts) = ([TravelRange::EMPTY; AXES], [TravelRange::EMPTY; AXES]);
        self.systems.push(WorkSystem { name, offset, known, line, moves: false, all, cuts });
    }

    fn motion(&mut self, motion: &Move, bounds: Option<Aabb>, cuts: bool) {
        let mut places = [(motion.from, motion.from_known), (motion.to, motion.to_known)];
        if let Some(bounds) = bounds {
            // Where an arc reaches is known when both its ends are.
            let known = motion.from_known.and(motion.to_known);
            for ((place, mask), corner) in places.iter_mut().zip([bounds.min, bounds.max]) {
                place[..3].copy_from_slice(&corner.to_array());
                *mask = known;
            }
        }
        for axis in 0..AXES {
            let stands = motion.from[axis] == motion.to[axis] && bounds.is_none();
            // An axis that turns is reported when it turns.
            if axis >= 3 && stands {
                continue;
            }
            for (place, known) in places {
                self.take(axis, &place, known, cuts);
                let is_known = known.and(self.frame.known).has(axis);
                if !stands && !is_known {
                    self.unknown.insert(axis);
                }
            }
        }
        if let Some(system) = self.at.and_then(|at| self.systems.get_mut(at)) {
            system.moves = true;
        }
    }

    /// A move on a surface that turns with a rotary axis, by the axes themselves.
    fn on_surface(&mut self, places: &[Position], known: AxisMask, cuts: bool) {
        for axis in 0..AXES {
            for place in places {
                self.take(axis, place, known, cuts);
            }
        }
        if let Some(system) = self.at.and_then(|at| self.systems.get_mut(at)) {
            system.moves = true;
        }
    }

    fn take(&mut self, axis: usize, place: &Position, known: AxisMask, cuts: bool) {
        if !known.has(axis) {
            return;
        }
        if let Some(system) = self.at.and_then(|at| self.systems.get_mut(at)) {
            system.all[axis].take(place[axis]);
            if cuts {
                system.cuts[axis].take(place[axis]);
            }
        }
        // In a frame of the part the linear axes go elsewhere.
        let is_of_axis = axis >= 3 || self.frame.part_frame.is_none();
        if self.frame.known.has(axis) && is_of_axis {
            self.machine[axis].take(self.frame.machine(place, axis));
        }
    }

    /// Where X, Y and Z go on the machine in a move in a frame of the part.
    fn axes_of_tip(&mut self, command: &Command, motion: &Move) {
        let Some(frame) = self.frame.part_frame.clone() else { return };
        let known = motion.from_known.and(motion.to_known).and(self.frame.known);
        if !known.covers(AxisMask::LINEAR) {
            self.unknown = self.unknown.or(AxisMask::LINEAR);
            return;
        }
        let offsets = self.frame.offsets();
        tip_pieces(&command.kind, motion, |curve, ends| {
            let Some(path) = frame.joint_path(curve, ends, &offsets) else {
                self.unknown = self.unknown.or(AxisMask::LINEAR);
                return;
            };
            let bounds = path.bounds(0.0, 1.0, SHOWN_TOLERANCE_MM);
            for (range, (low, high)) in self.machine.iter_mut().zip(bounds).take(3) {
                range.take(low);
                range.take(high);
            }
        });
    }

    /// Where the tool goes in each system.
    pub fn travel(&self, job: &Job) -> CappedRows<Travel> {
        let naming = job.profile().work_names;
        let of_system = |system: &WorkSystem| {
            let moved = is_moved(system, job.machine(), naming);
            let axes = Axis::ALL.into_iter().filter_map(|axis| {
                let index = axis as usize;
                let all = system.all[index].get()?;
                // One that the machine does not have stands at zero: Y of a lathe.
                if job.machine().axis(axis).is_none() && all.0 == all.1 {
                    return None;
                }
                let unset = !moved && !system.known.has(index) && !axis.is_rotary();
                let limits = job.machine().axis(axis).and_then(|limits| limits.travel);
                // The place of Z hangs on the tool's length, too.
                let limits = limits.filter(|_| unset && axis != Axis::Z);
                Some(AxisRange {
                    axis: axis.letter(),
                    all: for_people(job.machine(), axis, all),
                    cuts: system.cuts[index]
                        .get()
                        .map(|cuts| for_people(job.machine(), axis, cuts)),
                    zero_may_lie: limits.map(|(low, high)| {
                        for_people(job.machine(), axis, (low - all.0, high - all.1))
                    }),
                })
            });
            Travel {
                name: name(system, naming),
                moved_at: moved.then_some(system.line),
                axes: axes.collect(),
            }
        };
        let rows = self.systems.iter().filter(|system| system.moves).map(of_system);
        CappedRows {
            rows: rows.filter(|travel| !travel.axes.is_empty()).collect(),
            left_out: self.left_out,
        }
    }

    /// The work offsets under which something moves, with the machine's values.
    pub fn work_offsets(&self, job: &Job) -> Vec<ReportedWorkOffset> {
        let naming = job.profile().work_names;
        let mut offsets: Vec<ReportedWorkOffset> = Vec::new();
        for system in self.systems.iter().filter(|system| system.moves) {
            if system.name == WorkName::Machine {
                continue;
            }
            let name = name(system, naming);
            let values = job.machine().work_offsets.get(&name).map(|offset| offset.values);
            let place =
                offsets.iter().position(|offset| offset.name == name).unwrap_or_else(|| {
                    offsets.push(ReportedWorkOffset {
                        name,
                        values: Vec::new(),
                        moved_at: Vec::new(),
                    });
                    offsets.len() - 1
                });
            let offset = &mut offsets[place];
            let moves = |axis: &Axis| {
                let index = *axis as usize;
                // A rotary axis that stands at 0 needs no value.
                let turns = system.all[index].get().is_some_and(|range| range != (0.0, 0.0));
                turns || index < 3
            };
            for axis in Axis::ALL.into_iter().filter(moves) {
                let letter = axis.letter();
                if job.machine().axis(axis).is_some()
                    && offset.values.iter().all(|value| value.axis != letter)
                {
                    let value = values.and_then(|values| values[axis as usize]);
                    let value =
                        value.map(|value| for_people(job.machine(), axis, (value, value)).0);
                    offset.values.push(AxisValue { axis: letter, value });
                }
            }
            if is_moved(system, job.machine(), naming) && offset.moved_at.len() < MAX_LINES {
                offset.moved_at.push(system.line);
            }
        }
        offsets
    }

    /// The axes of the machine that have limits, and where they go.
    pub fn machine(&self, job: &Job) -> Vec<MachineTravel> {
        let of_axis = |axis: Axis| {
            let limits = job.machine().axis(axis)?.travel?;
            let index = axis as usize;
            let goes = self.machine[index].get();
            let partly_unknown = self.unknown.has(index);
            (goes.is_some() || partly_unknown).then(|| MachineTravel {
                axis: axis.letter(),
                limits: for_people(job.machine(), axis, limits),
                goes: goes.map(|goes| for_people(job.machine(), axis, goes)),
                partly_unknown,
            })
        };
        Axis::ALL.into_iter().filter_map(of_axis).collect()
    }
}

fn name(system: &WorkSystem, naming: WorkNaming) -> String {
    system.name.table_key(naming)
}

/// The program itself has put the system where it is.
fn is_moved(system: &WorkSystem, machine: &Machine, naming: WorkNaming) -> bool {
    if system.name == WorkName::Machine {
        return false;
    }
    let of = |name: &str, axis: usize| machine.work_offsets.get(name).and_then(|o| o.values[axis]);
    let key = name(system, naming);
    (0..AXES).any(|axis| {
        let own = of(&key, axis).unwrap_or(0.0) + of("EXT", axis).unwrap_or(0.0);
        (system.offset[axis] - own).abs() > EQUAL_OFFSET
    })
}

/// Millimetres, as a diameter where the axis is programmed so, or degrees.
fn for_people(machine: &Machine, axis: Axis, (low, high): (f64, f64)) -> (f64, f64) {
    if axis.is_rotary() {
        return (low.to_degrees(), high.to_degrees());
    }
    let factor = machine.written_factor(axis as usize);
    (low * factor, high * factor)
}
