//! Machines whose tables are filled with values of which no two are alike.
//!
//! With them a run shows what each position depends on: the work offset, the machine, the place where it began. And two
//! programs that do the same with such tables do the same with all others.

use std::collections::BTreeSet;

use chordal::control::{ControlProfile, control_profile};
use chordal::machine::{AXES, WorkOffset};
use chordal::{Command, CommandKind, Job, Machine};

use super::super::target::{take_axis_speeds, take_tables};

/// The numbers of tables that a program uses.
#[derive(Clone, Debug, Default)]
pub(super) struct UsedNumbers {
    /// Tools and tool offsets.
    pub tools: BTreeSet<u32>,
    /// Work offsets.
    pub work: BTreeSet<u32>,
}

impl UsedNumbers {
    pub fn of(job: &Job, commands: &[Command]) -> UsedNumbers {
        let mut used = UsedNumbers::default();
        used.work.insert(job.initial_work_offset().ordinal());
        for command in commands {
            used.note(&command.kind);
        }
        used
    }

    fn note(&mut self, command: &CommandKind) {
        if let CommandKind::Tool { number }
        | CommandKind::ToolSelect { number }
        | CommandKind::ToolLength { number: Some(number), .. }
        | CommandKind::Compensation { number: Some(number), .. } = command
        {
            self.tools.insert(*number);
        }
        if let CommandKind::WorkOffset { name, .. } = command {
            self.work.insert(name.ordinal());
        }
    }
}

/// The lengths of tools in a filled table.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum FilledLengths {
    /// All are zero: the tip is where the program says, whichever length is active.
    Zero,
    /// Each is another one.
    Different,
}

/// Which of several sets of values.
#[derive(Clone, Copy)]
pub(super) struct TableSet {
    pub seed: f64,
    pub lengths: FilledLengths,
    /// How far reference point 1 is from that of the machine file, mm.
    pub home_shift_mm: f64,
}

impl TableSet {
    pub const FIRST: TableSet =
        TableSet { seed: 1.0, lengths: FilledLengths::Different, home_shift_mm: 0.0 };
    pub const SECOND: TableSet =
        TableSet { seed: 2.37, lengths: FilledLengths::Different, home_shift_mm: -31.77 };
    pub const WITHOUT_LENGTHS: TableSet =
        TableSet { seed: 1.0, lengths: FilledLengths::Zero, home_shift_mm: 0.0 };

    /// A machine with these values in its tables.
    pub fn fill(self, machine: &Machine, profile: ControlProfile, used: &UsedNumbers) -> Machine {
        let mut machine = machine.clone();
        for ordinal in &used.work {
            let values = self.places(f64::from(*ordinal));
            let key = u16::try_from(*ordinal).ok();
            let key = key.and_then(|ordinal| profile.work_names.key_of_ordinal(ordinal));
            if let Some(key) = key {
                machine.work_offsets.insert(key, WorkOffset { values });
            }
        }
        // On a Sinumerik none is one by its name.
        machine
            .work_offsets
            .entry("G500".into())
            .or_insert(WorkOffset { values: [Some(0.0); AXES] });
        for number in &used.tools {
            let tool = machine.tools.entry(*number).or_default();
            tool.offset[2] = Some(match self.lengths {
                FilledLengths::Zero => 0.0,
                FilledLengths::Different => self.seed * (61.27 + 7.31 * f64::from(*number)),
            });
            tool.offset_wear[2] = None;
        }
        // Reference point 1 is where a run begins, too.
        for (axis, home) in machine.home.iter_mut().enumerate() {
            let shift = if axis < 3 { self.home_shift_mm } else { 0.0 };
            *home = Some(home.unwrap_or(0.0) + shift);
        }
        machine
    }

    /// A place that depends on a number, mm; rotary axes are at zero.
    fn places(self, number: f64) -> [Option<f64>; AXES] {
        std::array::from_fn(|axis| match axis {
            0..3 => Some(-self.seed * (113.19 + 3.71 * number + 17.53 * axis as f64)),
            _ => Some(0.0),
        })
    }
}

/// The target with the tables of the old machine.
pub(super) fn with_tables_of(old: &Job, target: &Machine) -> Machine {
    let mut machine = target.clone();
    take_axis_speeds(&mut machine, old.machine());
    if let Some(profile) = control_profile(target.control) {
        take_tables(&mut machine, old, profile.work_names);
    }
    machine
}
