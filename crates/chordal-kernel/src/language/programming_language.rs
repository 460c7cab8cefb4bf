//! A programming language of controls.

use std::fmt;
use std::sync::Arc;

use chordal_machine::{ControlName, Machine};

use super::configured_control::{ConfiguredControl, ControlProfile};
use super::recognition::ControlCandidate;
use super::tokens::VocabularyGroup;

/// Why a setting of a machine was refused.
#[derive(Clone, Debug, PartialEq)]
pub struct SettingError {
    /// Its name in the machine file.
    pub name: String,
    /// What is wrong.
    pub message: String,
    /// What to write.
    pub help: Option<String>,
}

/// A programming language and the controls that read it.
pub trait ProgrammingLanguage: fmt::Debug + Sync {
    /// Its name for users: `Sinumerik`.
    fn title(&self) -> &'static str;

    /// The profile of one of its controls; `None` for the controls of other languages.
    fn profile(&self, control: ControlName) -> Option<ControlProfile>;

    /// The control of a machine, and an error for each setting that it refuses. `None` if the control is of another
    /// language.
    fn configure(
        &self,
        machine: &Machine,
    ) -> Option<(Arc<dyn ConfiguredControl>, Vec<SettingError>)>;

    /// What a word of the language does, such as `CYCL DEF 200` or `CYCLE83`; `None` for a word that it does not have,
    /// and where the tables of codes say it.
    fn word_meaning(&self, word: &str) -> Option<String> {
        let _ = word;
        None
    }

    /// The words of the language by what they are; none where the tables of codes have them.
    fn vocabulary_groups(&self) -> Vec<VocabularyGroup> {
        Vec::new()
    }

    /// Whether some line of a text begins like a line of a program. Used for files that the user did not name.
    fn has_program_line(&self, text: &[u8]) -> bool;

    /// The controls that a text may be written for, with the signs of it. A control without signs may be left out.
    fn recognize(&self, text: &[u8]) -> Vec<ControlCandidate>;
}
