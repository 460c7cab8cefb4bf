//! A request: a question about programs.

use chordal_load::FileAccess;
use serde::Deserialize;
use serde_json::Value;

use crate::answer::QuestionFailure;

/// A question about programs.
pub struct QuestionRequest {
    /// The question: `check`, `time`.
    pub question: String,
    /// The programs: one of most questions, two of a comparison, none of some.
    pub programs: Vec<QuestionProgram>,
    /// Where subprograms, machine files and tool tables are looked for.
    pub files: FileAccess,
    /// The options of the question.
    pub options: Value,
}

/// A program that a question is about.
pub struct QuestionProgram {
    /// How it is run.
    pub options: ProgramOptions,
    /// Its text; without it, it is the file of its name.
    pub text: Option<Vec<u8>>,
}

/// How a program is run.
#[derive(Deserialize, Default)]
#[serde(rename_all = "camelCase", deny_unknown_fields, default)]
pub struct ProgramOptions {
    /// The name of its file: for messages, and for what lies next to it.
    pub name: Option<String>,
    /// A built-in name or a machine file.
    pub machine: Option<String>,
    /// Assignments to keys of the machine.
    pub set: Vec<String>,
    /// A LinuxCNC tool table.
    pub tools: Option<String>,
    /// What GRBL printed for `$$`.
    pub settings: Option<String>,
    /// Its number among those of the file.
    pub program: Option<u32>,
    /// Skips the blocks that start with `/`.
    pub block_delete: bool,
    /// Most blocks of calls, repeats and jumps.
    pub max_blocks: Option<u64>,
}

/// Options out of the JSON of a request.
///
/// # Errors
/// What is wrong with them, in words.
pub fn options<T: serde::de::DeserializeOwned>(
    question: &str,
    options: Value,
) -> Result<T, QuestionFailure> {
    serde_json::from_value(options).map_err(|error| {
        let message = error.to_string().replace("unknown field", "unknown option");
        QuestionFailure::wrong(
            format!("an option of {question} is wrong: {message}"),
            "the options are in docs/npm.md",
        )
    })
}
