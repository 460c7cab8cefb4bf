//! Compares the possible readings of a text whose control is not certain: the text is run on all controls that remain
//! possible, and their motions are compared. If all motions are equal, one of the controls is assumed. Otherwise the
//! program is not verified, and a message shows the difference.

mod difference;
mod excerpt;
mod premise;
mod trace;
mod units;
mod word_kinds;

use chordal::control::{
    ANOTHER_KIND, ControlCandidate, MIN_LIKELY_WEIGHT, Recognition, Units, configured_control,
    control_profile, table,
};
use chordal::machine::ControlName;
use chordal::{AssumedSetting, Machine};

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

/// The keys of the settings that are assumed where the user does not give them.
const UNITS_SETTING: &str = "settings.units";
const POINT_SETTING: &str = "settings.decimal_point";

/// A reading that remains possible: a control, the settings that the text leaves open, and the motions.
pub(crate) struct PossibleReading {
    pub control: ControlName,
    /// The name of the built-in machine that runs it.
    pub machine: &'static str,
    /// The settings that the text leaves open.
    pub settings: Vec<&'static AssumedSetting>,
    pub trace: MotionTrace,
}

impl PossibleReading {
    /// The units at power-on, where they are assumed.
    fn units(&self) -> Option<&'static str> {
        self.settings.iter().find_map(|setting| setting.units())
    }

    /// The reading with one setting more; `None` when the control has no such setting.
    fn with(
        &self,
        setting: &'static AssumedSetting,
        excerpt: &TrialExcerpt,
    ) -> Option<PossibleReading> {
        let &PossibleReading { control, machine, .. } = self;
        let mut built = machine_of(self);
        apply_settings(&mut built, &[setting]).then(|| {
            let settings = self.settings.iter().copied().chain([setting]).collect();
            let trace = MotionTrace::of(built, excerpt);
            PossibleReading { control, machine, settings, trace }
        })
    }
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
    apply_settings(&mut machine, &reading.settings);
    machine
}

/// The machine of a built-in name.
fn built_in(name: &'static str, control: ControlName) -> Machine {
    Machine::from_builtin(name).unwrap_or_else(|_| Machine::new(name, control))
}

/// Applies assumed settings to a machine; `false` when it does not have all of them.
pub(crate) fn apply_settings(machine: &mut Machine, settings: &[&AssumedSetting]) -> bool {
    // The settings of other languages have the names of machine data.
    settings.is_empty()
        || (table(machine.control).is_some()
            && settings.iter().all(|setting| machine.set(setting.assignment).is_ok()))
}

/// Chooses the control that reads a text, and compares the remaining readings. The premise is `None` when the control
/// and its settings are certain, so that nothing is compared. `assignments` are those of the user to the machine.
pub fn settle(
    mut found: Recognition,
    text: &[u8],
    assignments: &[String],
) -> (Recognition, Option<ReadingPremise>) {
    if found.chosen().not_read {
        return (found, None);
    }
    let is_certain = found.is_certain();
    let chosen = configured_control(&built_in(machine_name(found.chosen()), found.control()));
    let says =
        |key: &str| assignments.iter().any(|assignment| assignment.trim_start().starts_with(key));
    let has_units =
        says(UNITS_SETTING) || chosen.as_ref().is_none_or(|(control, _)| control.names_units(text));
    let has_points = says(POINT_SETTING)
        || chosen.is_none_or(|(control, _)| !control.leaves_whole_numbers_open(text));
    if is_certain && has_units && has_points {
        return (found, None);
    }
    let excerpt = TrialExcerpt::of(text);
    let mut readings = if is_certain {
        let (control, machine) = (found.control(), machine_name(found.chosen()));
        let trace = MotionTrace::of(built_in(machine, control), &excerpt);
        vec![PossibleReading { control, machine, settings: Vec::new(), trace }]
    } else {
        possible(&mut found, text, &excerpt)
    };
    if !says(POINT_SETTING) {
        readings = with_both_points(readings, text, &excerpt);
    }
    if !has_units {
        readings = in_both_units(readings, text, &excerpt);
    }
    if is_certain && readings.len() == 1 && has_units {
        // No move depends on a number without a point.
        return (found, None);
    }
    if readings.is_empty() {
        return (found, None);
    }
    let premise = ReadingPremise::of(&readings, text, &excerpt);
    (found, Some(premise))
}

/// Runs the excerpt on the controls that the signs leave possible, and makes the best of them the choice of the
/// recognition. Returns the readings that remain, the best first.
fn possible(found: &mut Recognition, text: &[u8], excerpt: &TrialExcerpt) -> Vec<PossibleReading> {
    let mut runs = trial_runs(found, text, excerpt);
    let fewest = runs.iter().map(|(_, run)| faults(&run.trace)).min().unwrap_or(0);
    let score = |found: &Recognition, place: usize, run: &PossibleReading| {
        found.ranking[place].weight - penalty(faults(&run.trace) - fewest)
    };
    // The sort is stable: controls of equal score keep the order of the recognition.
    runs.sort_by_key(|(place, run)| -score(found, *place, run));
    let Some((best_place, first)) = runs.first() else { return Vec::new() };
    let (best_place, best) = (*best_place, score(found, *best_place, first));
    let clean = faults(&first.trace) == fewest;
    let readings = runs.into_iter().filter(|(place, run)| {
        let near = score(found, *place, run) > best - POSSIBLE_SCORE_GAP;
        // A setting of the chosen control stays open, whatever speaks for one of its values.
        (near && (!clean || faults(&run.trace) == fewest)) || *place == best_place
    });
    let readings = readings.map(|(_, run)| run).collect();
    found.choose(found.ranking[best_place].name);
    readings
}

/// The runs on all controls that the signs leave possible, each with the place of its control in the ranking. A control
/// that signs speak for may have been set up to take numbers without a point in full units: it is run in both ways.
fn trial_runs(
    found: &mut Recognition,
    text: &[u8],
    excerpt: &TrialExcerpt,
) -> Vec<(usize, PossibleReading)> {
    let weakest = (found.chosen().weight - POSSIBLE_SCORE_GAP).max(ANOTHER_KIND + 1);
    let turns = |control| control_profile(control).is_some_and(|profile| profile.turns);
    let is_lathe = turns(found.control());
    let mut runs = Vec::new();
    for (place, candidate) in found.ranking.iter_mut().enumerate() {
        let same_kind = turns(candidate.control) == is_lathe;
        if candidate.not_read || candidate.weight < weakest || !same_kind {
            continue;
        }
        let (control, machine) = (candidate.control, machine_name(candidate));
        let trace = MotionTrace::of(built_in(machine, control), excerpt);
        candidate.errors = Some(trace.errors);
        let reading = PossibleReading { control, machine, settings: Vec::new(), trace };
        let readings = match candidate.weight >= MIN_LIKELY_WEIGHT {
            true => with_both_points(vec![reading], text, excerpt),
            false => vec![reading],
        };
        runs.extend(readings.into_iter().map(|reading| (place, reading)));
    }
    runs
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
    for mut reading in readings {
        let machine = machine_of(&reading);
        let Some((configured, _)) = configured_control(&machine) else { continue };
        let own = configured.rules().units;
        let other = other_units(own);
        let other_reading = (named != Some(own))
            .then(|| reading.with(units_setting(other), excerpt))
            .flatten()
            .filter(|reading| units::is_plausible(&reading.trace));
        let own_is_possible = named != Some(other) && units::is_plausible(&reading.trace);
        if own_is_possible || other_reading.is_none() {
            reading.settings.push(units_setting(own));
            both.push(reading);
        }
        both.extend(other_reading);
    }
    both
}

/// Adds readings in which a number without a point is in full units, next to those in which it counts least
/// increments, where the text leaves that open. The control's own default comes first.
fn with_both_points(
    readings: Vec<PossibleReading>,
    text: &[u8],
    excerpt: &TrialExcerpt,
) -> Vec<PossibleReading> {
    let (full, least) = (&AssumedSetting::FULL_UNITS, &AssumedSetting::LEAST_INCREMENTS);
    let mut both = Vec::new();
    for mut reading in readings {
        let is_open = reading.settings.is_empty()
            && reading.trace.least_increment_numbers > 0
            && configured_control(&machine_of(&reading))
                .is_some_and(|(control, _)| control.leaves_whole_numbers_open(text));
        let in_full_units = is_open.then(|| reading.with(full, excerpt)).flatten();
        if in_full_units.is_some() {
            reading.settings.push(least);
        }
        both.push(reading);
        both.extend(in_full_units);
    }
    both
}

fn other_units(units: Units) -> Units {
    match units {
        Units::Inch => Units::Millimetre,
        Units::Millimetre => Units::Inch,
    }
}

fn units_setting(units: Units) -> &'static AssumedSetting {
    match units {
        Units::Inch => &AssumedSetting::INCH,
        Units::Millimetre => &AssumedSetting::MILLIMETRES,
    }
}
