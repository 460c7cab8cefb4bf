//! Compares the possible readings of a text whose control is not certain: the text is run on all controls that remain
//! possible, and their motions are compared. If all motions are equal, one of the controls is assumed. Otherwise the
//! program is not verified, and a message shows the difference.

mod difference;
mod excerpt;
mod premise;
mod trace;
mod units;
mod word_kinds;

use chordal::Machine;
use chordal::control::{
    ANOTHER_KIND, ControlCandidate, Recognition, Units, configured_control, control_profile, table,
};
use chordal::machine::ControlName;

use excerpt::TrialExcerpt;
use trace::MotionTrace;

pub use premise::{ReadingDifference, ReadingGroup, ReadingPremise};

/// A control remains possible while its score is less than this below the best score.
const POSSIBLE_SCORE_GAP: i32 = 6;

/// The penalty of a control for its first error more than the control with the fewest has. It is large because a
/// firmware that stops at its first error never has a second one.
const FIRST_ERROR_PENALTY: i32 = 6;

/// The largest penalty of a control for errors.
const MAX_PENALTY: i32 = 12;

/// A reading that remains possible: a control, the units when the text names none, and the motions.
pub(crate) struct PossibleReading {
    pub control: ControlName,
    /// The name of the built-in machine that runs it.
    pub machine: &'static str,
    /// Units at power-on; `None` when the text names its units.
    pub units: Option<Units>,
    pub trace: MotionTrace,
}

/// The built-in machine of a candidate: the one that its signs indicate, or the default one of its control.
pub(crate) fn machine_name(candidate: &ControlCandidate) -> &'static str {
    candidate.machine().unwrap_or_else(|| {
        let profile = control_profile(candidate.control);
        profile.map_or(candidate.name, |profile| profile.default_machine)
    })
}

/// The machine of a reading.
fn machine_of(reading: &PossibleReading) -> Machine {
    let mut machine = built_in(reading.machine, reading.control);
    if let Some(units) = reading.units {
        set_units(&mut machine, units);
    }
    machine
}

/// The machine of a built-in name.
fn built_in(name: &'static str, control: ControlName) -> Machine {
    Machine::from_builtin(name).unwrap_or_else(|_| Machine::new(name, control))
}

/// Chooses the control that reads a text, and compares the remaining readings. The premise is `None` when the control
/// and the units are certain, so that nothing is compared.
pub fn settle(mut found: Recognition, text: &[u8]) -> (Recognition, Option<ReadingPremise>) {
    if found.chosen().not_read {
        return (found, None);
    }
    let is_certain = found.is_certain();
    let chosen = configured_control(&built_in(machine_name(found.chosen()), found.control()));
    let has_units = chosen.is_none_or(|(control, _)| control.names_units(text));
    if is_certain && has_units {
        return (found, None);
    }
    let excerpt = TrialExcerpt::of(text);
    let mut readings = if is_certain {
        let (control, machine) = (found.control(), machine_name(found.chosen()));
        let trace = MotionTrace::of(built_in(machine, control), &excerpt);
        vec![PossibleReading { control, machine, units: None, trace }]
    } else {
        possible(&mut found, &excerpt)
    };
    if !has_units {
        readings = in_both_units(readings, text, &excerpt);
    }
    if readings.is_empty() {
        return (found, None);
    }
    let premise = ReadingPremise::of(&readings, text, &excerpt);
    (found, Some(premise))
}

/// Runs the excerpt on the controls that the signs leave possible, and makes the best of them the choice of the
/// recognition. Returns the readings that remain, the best first.
fn possible(found: &mut Recognition, excerpt: &TrialExcerpt) -> Vec<PossibleReading> {
    let weakest = (found.chosen().weight - POSSIBLE_SCORE_GAP).max(ANOTHER_KIND + 1);
    let turns = |control| control_profile(control).is_some_and(|profile| profile.turns);
    let is_lathe = turns(found.control());
    let mut runs: Vec<(usize, MotionTrace)> = Vec::new();
    for (place, candidate) in found.ranking.iter_mut().enumerate() {
        let same_kind = turns(candidate.control) == is_lathe;
        if candidate.not_read || candidate.weight < weakest || !same_kind {
            continue;
        }
        let machine = built_in(machine_name(candidate), candidate.control);
        let trace = MotionTrace::of(machine, excerpt);
        candidate.errors = Some(trace.errors);
        runs.push((place, trace));
    }
    let fewest = runs.iter().map(|(_, trace)| faults(trace)).min().unwrap_or(0);
    let score = |found: &Recognition, place: usize, trace: &MotionTrace| {
        found.ranking[place].weight - penalty(faults(trace) - fewest)
    };
    // The sort is stable: controls of equal score keep the order of the recognition.
    runs.sort_by_key(|(place, trace)| -score(found, *place, trace));
    let Some((first, trace)) = runs.first() else { return Vec::new() };
    let best = score(found, *first, trace);
    let clean = faults(trace) == fewest;
    let name = found.ranking[*first].name;
    let readings: Vec<PossibleReading> = runs
        .into_iter()
        .filter(|(place, trace)| {
            let near = score(found, *place, trace) > best - POSSIBLE_SCORE_GAP;
            near && (!clean || faults(trace) == fewest)
        })
        .map(|(place, trace)| {
            let candidate = &found.ranking[place];
            let (control, machine) = (candidate.control, machine_name(candidate));
            PossibleReading { control, machine, units: None, trace }
        })
        .collect();
    found.choose(name);
    readings
}

/// The number of errors, plus the numbers read in least increments, which are rarely meant like that.
fn faults(trace: &MotionTrace) -> u64 {
    trace.errors.saturating_add(trace.least_increment_numbers)
}

fn penalty(faults: u64) -> i32 {
    match i32::try_from(faults) {
        Ok(0) => 0,
        Ok(faults) => faults.saturating_add(FIRST_ERROR_PENALTY - 1).min(MAX_PENALTY),
        Err(_) => MAX_PENALTY,
    }
}

/// Adds readings in the other units for a text that names none, except when a comment, the size of the part or the
/// feeds decide.
fn in_both_units(
    readings: Vec<PossibleReading>,
    text: &[u8],
    excerpt: &TrialExcerpt,
) -> Vec<PossibleReading> {
    let named = units::units_of_comments(text);
    let mut both = Vec::new();
    for PossibleReading { control, machine, trace, .. } in readings {
        let mut other_machine = built_in(machine, control);
        let Some((configured, _)) = configured_control(&other_machine) else { continue };
        let own = configured.rules().units;
        let other = other_units(own);
        let other_trace = (named != Some(own) && set_units(&mut other_machine, other))
            .then(|| MotionTrace::of(other_machine, excerpt))
            .filter(units::is_plausible);
        let own_is_possible = named != Some(other) && units::is_plausible(&trace);
        if own_is_possible || other_trace.is_none() {
            both.push(PossibleReading { control, machine, units: Some(own), trace });
        }
        if let Some(trace) = other_trace {
            both.push(PossibleReading { control, machine, units: Some(other), trace });
        }
    }
    both
}

fn other_units(units: Units) -> Units {
    match units {
        Units::Inch => Units::Millimetre,
        Units::Millimetre => Units::Inch,
    }
}

/// The name of the units in machine settings.
fn units_name(units: Units) -> &'static str {
    if units == Units::Inch { "inch" } else { "mm" }
}

/// Sets the units at power-on; `false` when the control has no such setting.
pub(crate) fn set_units(machine: &mut Machine, units: Units) -> bool {
    // The settings of other languages have the names of machine data.
    table(machine.control).is_some()
        && machine.set(&format!("settings.units={:?}", units_name(units))).is_ok()
}
