//! The one place where programs that are not made of word-address blocks are refused.
//!
//! Rewriting reads blocks and writes blocks. Each public function of this crate that does so begins with
//! [`refuse_other_languages`]; after it [`BlockControl::control`] gives the tables of the control.

use chordal::Job;
use chordal::control::{Control, control_title};
use chordal::diagnostics::FileId;
use chordal::machine::ControlName;

/// What works on word-address blocks only.
const HELP: &str =
    "run, check, plan and compare the program as it is; change it with the tools of its control";

/// The control of a job that was not refused.
pub(crate) trait BlockControl {
    /// The control with its tables.
    fn control(&self) -> &Control;
}

impl BlockControl for Job<'_> {
    fn control(&self) -> &Control {
        self.word_address()
            .unwrap_or_else(|| unreachable!("programs of other languages are refused before"))
    }
}

/// The refusal of a program in another language.
#[derive(Debug)]
pub(crate) struct OtherLanguage {
    /// The first line of the program.
    pub first_line: String,
    /// What is refused.
    pub what: String,
    /// What to do instead.
    pub help: &'static str,
}

/// Refuses a job whose programs are not made of word-address blocks.
///
/// # Errors
/// The refusal.
pub(crate) fn refuse_other_languages(job: &Job) -> Result<(), OtherLanguage> {
    match job.word_address() {
        Some(_) => Ok(()),
        None => Err(refusal_of_language(job)),
    }
}

/// The refusal of a job whose programs are not made of word-address blocks.
pub(crate) fn refusal_of_language(job: &Job) -> OtherLanguage {
    let text = job.sources().get(FileId(0)).map_or(&[][..], |source| source.text());
    let text = String::from_utf8_lossy(text);
    OtherLanguage {
        first_line: text.lines().next().unwrap_or_default().to_string(),
        what: other_language(job.machine().control),
        help: HELP,
    }
}

/// The sentence for a control whose programs are not made of word-address blocks.
pub(crate) fn other_language(control: ControlName) -> String {
    let title = control_title(control);
    format!(
        "programs for {title} are not made of word-address blocks, and only such blocks are rewritten"
    )
}
