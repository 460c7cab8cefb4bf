//! An answer: a text, and parts of plain numbers that the text describes.

use chordal::motion::LimitError;
use chordal_load::LoadError;
use serde_json::{Value, json};

/// What a question is answered with.
#[derive(Default)]
pub struct Answer {
    /// JSON, or the text that was asked for.
    pub text: String,
    /// The columns of a table, as bytes in the order of the machine.
    pub parts: Vec<Vec<u8>>,
}

impl Answer {
    /// An answer without columns.
    pub fn text(text: String) -> Answer {
        Answer { text, parts: Vec::new() }
    }
}

/// Why there is no answer.
pub struct Failure {
    /// `use`, `file`, `machine` or `chordal`.
    kind: &'static str,
    message: String,
    help: Option<String>,
}

impl Failure {
    /// A wrong use and what to do instead.
    pub fn wrong(message: impl Into<String>, help: impl Into<String>) -> Failure {
        Failure { kind: "use", message: message.into(), help: Some(help.into()) }
    }

    /// A wrong use.
    pub fn plain(message: impl Into<String>, help: Option<String>) -> Failure {
        Failure { kind: "use", message: message.into(), help }
    }

    /// A fault of Chordal itself.
    pub fn own(message: impl Into<String>) -> Failure {
        let help = "please report it, with the program".to_string();
        Failure { kind: "chordal", message: message.into(), help: Some(help) }
    }

    /// What a shell makes an error of.
    pub fn json(&self) -> Value {
        json!({ "kind": self.kind, "message": self.message, "help": self.help })
    }
}

impl From<LoadError> for Failure {
    fn from(error: LoadError) -> Failure {
        match error {
            LoadError::Machine(errors) => {
                let texts = errors.iter();
                let texts = texts.map(|error| chordal_export::machine_error_text(error, false));
                let message = texts.collect::<String>().trim_end().to_string();
                Failure { kind: "machine", message, help: None }
            }
            LoadError::Request { message, help } => Failure { kind: "use", message, help },
            LoadError::Read { file, reason } => {
                let message = format!("cannot read {file}: {reason}");
                let help = "give its text in `files`".to_string();
                Failure { kind: "file", message, help: Some(help) }
            }
        }
    }
}

impl From<LimitError> for Failure {
    fn from(error: LimitError) -> Failure {
        let help = "correct it in the machine file, or with `set`";
        Failure { kind: "machine", message: error.to_string(), help: Some(help.into()) }
    }
}
