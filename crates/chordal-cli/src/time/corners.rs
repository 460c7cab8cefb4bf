//! How the program's corners were passed, and what changes that.

use chordal::Job;
use chordal::control::{COMMON_SETTINGS, Setting, SettingField, StartMode, Units as ProgramUnits};
use chordal::time::TimeReport;
use chordal_export::{junctions_text, short_blocks_text};

use crate::numbers::counted;

/// What was counted, and the settings and machine data after it.
pub fn notes(time: &TimeReport, job: &Job, units: ProgramUnits) -> Vec<String> {
    if let Some(text) = junctions_text(job) {
        return vec![text];
    }
    let mut notes = Vec::new();
    let ends = &time.cut_ends;
    if let Some((least, most)) = ends.tolerance_mm {
        let (least, most) = (units.length_text(least), units.length_text(most));
        let tolerance = if least == most { most } else { format!("{least} to {most}") };
        let cuts = counted(ends.within, "cut runs", "cuts run");
        notes.push(format!("{cuts} into the next one, within {tolerance} of the corner"));
        notes.extend(short_blocks_text(ends, job));
    }
    let other = [
        (ends.exact, "in exact path mode: the tool stops at a corner"),
        (ends.at_rest, "at a stop: exact stop, or a rapid or a dwell comes next"),
    ];
    for (count, how) in other.into_iter().filter(|(count, _)| *count > 0) {
        notes.push(format!("{} {how}", counted(count, "cut ends", "cuts end")));
    }
    if notes.is_empty() {
        return notes;
    }
    notes.push(default(job, units));
    if time.tangent_stops > 0 {
        let joints = counted(time.tangent_stops, "joint", "joints");
        let stop = if time.tangent_stops == 1 { "is a stop" } else { "are stops" };
        notes.push(format!(
            "{joints} of a line and a tangent arc {stop}: exact path mode keeps the path, and its \
             curvature jumps there; --set motion.exact_path_tolerance=\"0.002 mm\" allows it to round them"
        ));
    }
    notes
}

/// The mode and the tolerance where the program says nothing, with the way to change them.
fn default(job: &Job, units: ProgramUnits) -> String {
    let rules = &job.rules().path;
    let named = |field| setting(job, field).map_or("", |setting| setting.name);
    match (rules.start, rules.of_level(rules.level)) {
        (StartMode::ExactStop, _) => format!(
            "this control starts in exact stop mode (setting `{}`): the tool stops at the end of every block until the \
             program changes the mode",
            named(SettingField::POWER_ON_PATH_MODE)
        ),
        (StartMode::ExactPath, _) => format!(
            "this control starts in exact path mode (setting `{}`)",
            named(SettingField::POWER_ON_PATH_MODE)
        ),
        (StartMode::Continuous, Some(tolerance)) => format!(
            "where the program gives no tolerance it is {} (setting `{}`)",
            units.length_text(tolerance),
            named(SettingField::PATH_ROUNDING)
        ),
        (StartMode::Continuous, None) => format!(
            "where the program gives no tolerance it is {} (--set motion.corner_tolerance=…)",
            units.length_text(job.machine().motion.corner_tolerance_mm())
        ),
    }
}

/// The setting of a rule: the control's own name before the common one.
fn setting(job: &Job, field: SettingField) -> Option<&'static Setting> {
    let common = || COMMON_SETTINGS.iter().find(|setting| setting.field == field);
    job.own_setting(field).or_else(common)
}
