//! Why a program runs on its machine, in words, and the error for a text in a language that Chordal does not read.

use std::path::PathBuf;
use std::sync::Arc;

use chordal::control::{EvidenceStrength, Recognition, not_read};
use chordal::diagnostics::{FileId, Span};
use chordal::{Code, Diagnostic};

use crate::assumption::MovedAxes;

/// The most signs that a message about a language lists.
const MAX_SIGNS: usize = 4;

/// Why this machine was chosen.
#[derive(Clone, Debug)]
pub enum MachineReason {
    /// The caller requested it.
    Requested,
    /// This `chordal.toml` names it.
    Folder(PathBuf),
    /// The text has no signs of a control, and the file extension is LinuxCNC's (`.ngc`).
    Ending,
    /// The text was recognized as a program of this control. The second value is present when the program moves axes
    /// that the control's default machine does not have.
    Recognized(Recognition, Option<MovedAxes>),
}

impl MachineReason {
    /// What was recognized and by which sign, in one line; `None` when the machine was named. `title` is the title of
    /// the control.
    pub fn why(&self, title: &str) -> Option<String> {
        Some(match self {
            MachineReason::Requested | MachineReason::Folder(_) => return None,
            MachineReason::Ending => format!("assumed {title} because of the file extension"),
            MachineReason::Recognized(found, None) => why(found, title),
            MachineReason::Recognized(found, Some(moved)) => {
                let (why, machine) = (why(found, title), &moved.machine);
                format!("{why}; {machine} is assumed because the program moves {}", moved.list())
            }
        })
    }

    /// The recognition; `None` when the machine was named or assumed by the file extension.
    pub fn recognition(&self) -> Option<&Recognition> {
        match self {
            MachineReason::Recognized(found, _) => Some(found),
            MachineReason::Requested | MachineReason::Folder(_) | MachineReason::Ending => None,
        }
    }

    /// The source of the choice in one word: `given`, `folder`, `extension` or `text`.
    pub fn from(&self) -> &'static str {
        match self {
            MachineReason::Requested => "given",
            MachineReason::Folder(_) => "folder",
            MachineReason::Ending => "extension",
            MachineReason::Recognized(..) => "text",
        }
    }

    /// Whether nobody named the machine, so that its limits are a guess.
    pub fn is_guess(&self) -> bool {
        matches!(self, MachineReason::Ending | MachineReason::Recognized(..))
    }

    /// The error for a text in a language that Chordal does not read; `None` for other texts.
    pub fn refusal(&self, text: &[u8]) -> Option<Arc<Diagnostic>> {
        let found = self.recognition().filter(|found| found.chosen().not_read)?;
        let language = not_read(found.chosen().name)?;
        let signs: Vec<_> = found.evidence().take(MAX_SIGNS).collect();
        let first = signs.first()?;
        let line = line_span(text, first.offset as usize);
        let message = format!("this is {}; {}", language.what, language.why);
        let mut refusal = Diagnostic::new(Code::NotRead, line, message).label(first.sign);
        for sign in &signs[1..] {
            refusal = refusal.note(format!("line {}: {}", sign.line, sign.sign));
        }
        let help = "if it is for another control, name the machine with --machine: then it is read as that one reads it";
        Some(Arc::new(refusal.help(help)))
    }
}

fn why(found: &Recognition, title: &str) -> String {
    let chosen = found.chosen();
    let title = if chosen.not_read { chosen.title } else { title };
    let strongest = found.evidence().next();
    match (found.strength(), strongest) {
        (EvidenceStrength::Sure | EvidenceStrength::Likely, Some(sign)) => {
            format!("recognized as {title} by line {} ({})", sign.line, sign.sign)
        }
        (EvidenceStrength::Weak, Some(sign)) => {
            let line = format!("probably {title} by line {} ({})", sign.line, sign.sign);
            match found.runner_up() {
                Some(next) => format!("{line}; {} is nearly as likely", next.title),
                None => line,
            }
        }
        _ => assumed(found, title),
    }
}

/// The sentence for a text without signs: what was assumed, and how many errors it and the next best control give.
fn assumed(found: &Recognition, title: &str) -> String {
    let line = format!("assumed {title}: nothing in the text says which control it is for");
    let errors = |count: u64| if count == 1 { "1 error".into() } else { format!("{count} errors") };
    let other = found.ranking.iter().skip(1).filter_map(|other| Some((other, other.errors?)));
    let Some(own) = found.chosen().errors else { return line };
    match other.min_by_key(|(_, errors)| *errors) {
        Some((other, fewer)) if fewer < own => {
            format!("{line}; on {} it has {} instead of {own}", other.title, errors(fewer))
        }
        Some((other, more)) if own < more => {
            format!("{line}; it has {} and {more} on {}", errors(own), other.title)
        }
        _ => line,
    }
}

/// The span of the line that begins at `start`.
fn line_span(text: &[u8], start: usize) -> Span {
    let rest = text.get(start..).unwrap_or_default();
    let end = rest.iter().position(|byte| matches!(byte, b'\n' | b'\r')).unwrap_or(rest.len());
    Span::new(FileId(0), start as u32, (start + end) as u32)
}
