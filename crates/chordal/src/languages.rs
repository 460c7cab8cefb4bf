//! The programming languages that programs are read in: those that are built in, and those that an application adds.

use std::sync::{Arc, PoisonError, RwLock};

use chordal_gcode::WordAddressLanguage;
use chordal_heidenhain::HeidenhainLanguage;
use chordal_kernel::{
    ConfiguredControl, ControlCandidate, ControlProfile, ProgrammingLanguage, Recognition,
    SettingError, VocabularyGroup,
};
use chordal_machine::{ControlName, Machine};
use chordal_sinumerik::SinumerikLanguage;

/// The languages that are built in.
const BUILT_IN: [&dyn ProgrammingLanguage; 3] =
    [&WordAddressLanguage, &SinumerikLanguage, &HeidenhainLanguage];

/// The languages that the application has added.
static REGISTERED: RwLock<Vec<&'static dyn ProgrammingLanguage>> = RwLock::new(Vec::new());

/// Adds a language, from then on for every job of the process. Its controls are those that it has registered with
/// [`ControlName::register`]; a control of a language that is already there stays with that one.
pub fn register_language(language: &'static dyn ProgrammingLanguage) {
    REGISTERED.write().unwrap_or_else(PoisonError::into_inner).push(language);
}

/// All languages, those that are built in first.
fn all() -> impl Iterator<Item = &'static dyn ProgrammingLanguage> {
    let registered = REGISTERED.read().unwrap_or_else(PoisonError::into_inner).clone();
    BUILT_IN.into_iter().chain(registered)
}

/// The profile of a control; `None` for a name that was registered without a language.
pub fn control_profile(control: ControlName) -> Option<ControlProfile> {
    all().find_map(|language| language.profile(control))
}

/// The title of a control; its name where no language reads it.
pub fn control_title(control: ControlName) -> &'static str {
    control_profile(control).map_or(control.as_str(), |profile| profile.title)
}

/// The control of a machine with its settings applied, and an error for each setting that it refuses. `None` if no
/// language reads the programs of the control.
pub fn configured_control(
    machine: &Machine,
) -> Option<(Arc<dyn ConfiguredControl>, Vec<SettingError>)> {
    all().find_map(|language| language.configure(machine))
}

/// The words of the language of a control by what they are; none where the tables of codes have them.
pub fn vocabulary_groups(control: ControlName) -> Vec<VocabularyGroup> {
    let language = all().find(|language| language.profile(control).is_some());
    language.map(|language| language.vocabulary_groups()).unwrap_or_default()
}

/// What a word does in the languages that have it, each with its title: in that of one control, or in all.
pub fn word_meanings(word: &str, control: Option<ControlName>) -> Vec<(&'static str, String)> {
    let is_meant = |language: &&'static dyn ProgrammingLanguage| {
        control.is_none_or(|control| language.profile(control).is_some())
    };
    let meaning = |language: &'static dyn ProgrammingLanguage| {
        Some((language.title(), language.word_meaning(word)?))
    };
    all().filter(is_meant).filter_map(meaning).collect()
}

/// Whether some line of a text begins like a line of a program in some language.
pub fn has_program_line(text: &[u8]) -> bool {
    all().any(|language| language.has_program_line(text))
}

/// Recognizes the control that a text was written for, by the signs of all languages.
pub fn recognize(text: &[u8]) -> Recognition {
    let mut candidates: Vec<ControlCandidate> =
        all().flat_map(|language| language.recognize(text)).collect();
    // A language that is read replaces the refusal of the same name.
    let read: Vec<&'static str> =
        candidates.iter().filter(|each| !each.not_read).map(|each| each.name).collect();
    candidates.retain(|each| !each.not_read || !read.contains(&each.name));
    let turns = |control| control_profile(control).is_some_and(|profile| profile.turns);
    Recognition::of(candidates, turns)
}
