//! An answer: a text, and parts of plain numbers that the text describes.

use chordal::motion::LimitError;
use chordal_load::LoadError;
use serde_json::{Value, json};

/// The answer to a question.
#[derive(Default)]
pub struct QuestionAnswer {
    /// JSON, or the text of the requested format.
    pub text: String,
    /// The columns of a table, as bytes in the order of the machine.
    pub parts: Vec<Vec<u8>>,
}

impl QuestionAnswer {
    /// An answer without columns.
    pub fn text(text: String) -> QuestionAnswer {
        QuestionAnswer { text, parts: Vec::new() }
    }
}

/// Why there is no answer.
pub struct QuestionFailure {
    /// `use`, `file`, `machine` or `chordal`.
    kind: &'static str,
    message: String,
    help: Option<String>,
}

impl QuestionFailure {
    /// A wrong use and what to do instead.
    pub fn wrong(message: impl Into<String>, help: impl Into<String>) -> QuestionFailure {
        QuestionFailure { kind: "use", message: message.into(), help: Some(help.into()) }
    }

    /// A wrong use.
    pub fn plain(message: impl Into<String>, help: Option<String>) -> QuestionFailure {
        QuestionFailure { kind: "use", message: message.into(), help }
    }

    /// A fault of Chordal itself.
    pub fn own(message: impl Into<String>) -> QuestionFailure {
        let help = "please report it, with the program".to_string();
        QuestionFailure { kind: "chordal", message: message.into(), help: Some(help) }
    }

    /// What a shell makes an error of.
    pub fn json(&self) -> Value {
        json!({ "kind": self.kind, "message": self.message, "help": self.help })
    }
}

impl From<LoadError> for QuestionFailure {
    fn from(error: LoadError) -> QuestionFailure {
        match error {
            LoadError::Machine(errors) => {
                let texts = errors.iter();
                let texts = texts.map(|error| chordal_export::machine_error_text(error, false));
                let message = texts.collect::<String>().trim_end().to_string();
                QuestionFailure { kind: "machine", message, help: None }
            }
            LoadError::Request { message, help } => QuestionFailure { kind: "use", message, help },
            LoadError::Read { file, reason } => {
                let message = format!("cannot read {file}: {reason}");
                let help = "give its text in `files`".to_string();
                QuestionFailure { kind: "file", message, help: Some(help) }
            }
        }
    }
}

impl From<LimitError> for QuestionFailure {
    fn from(error: LimitError) -> QuestionFailure {
        let help = "correct it in the machine file, or with `set`";
        QuestionFailure { kind: "machine", message: error.to_string(), help: Some(help.into()) }
    }
}
