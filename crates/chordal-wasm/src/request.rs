//! A request: four bytes with the length of a JSON object, the object, then the bytes of the texts that
//! it names, in their order.

use serde::Deserialize;
use serde_json::Value;

use crate::answer::Failure;

/// A request as it lies in memory.
pub struct Request {
    /// What is asked: `check`, `time`.
    pub ask: String,
    /// The programs: one of most questions, two of a comparison, none of some.
    pub programs: Vec<(ProgramOptions, Vec<u8>)>,
    /// Other files, by their paths: subprograms, machine files, tool tables.
    pub files: Vec<(String, Vec<u8>)>,
    /// What else is said, as the question takes it.
    pub options: Value,
}

/// How a program is run.
#[derive(Deserialize, Default)]
#[serde(rename_all = "camelCase", deny_unknown_fields, default)]
pub struct ProgramOptions {
    pub name: Option<String>,
    pub machine: Option<String>,
    pub set: Vec<String>,
    pub tools: Option<String>,
    pub settings: Option<String>,
    pub program: Option<u32>,
    pub block_delete: bool,
    pub max_blocks: Option<u64>,
}

/// The JSON object of a request.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Head {
    ask: String,
    programs: Vec<Program>,
    files: Vec<File>,
    options: Value,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Program {
    options: Value,
    bytes: usize,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    path: String,
    bytes: usize,
}

impl Request {
    /// Reads a request.
    pub fn read(bytes: &[u8]) -> Result<Request, Failure> {
        let (length, rest) = bytes.split_first_chunk::<4>().ok_or_else(torn)?;
        let length = u32::from_le_bytes(*length) as usize;
        let (head, mut texts) = rest.split_at_checked(length).ok_or_else(torn)?;
        let head: Head = serde_json::from_slice(head).map_err(|error| {
            Failure::wrong(format!("the request cannot be read: {error}"), REPORT_IT)
        })?;
        let mut take = |bytes: usize| {
            let (text, rest) = texts.split_at_checked(bytes).ok_or_else(torn)?;
            texts = rest;
            Ok::<_, Failure>(text.to_vec())
        };
        let mut programs = Vec::new();
        for program in head.programs {
            let text = take(program.bytes)?;
            programs.push((options(&head.ask, program.options)?, text));
        }
        let mut files = Vec::new();
        for file in head.files {
            let text = take(file.bytes)?;
            files.push((file.path, text));
        }
        Ok(Request { ask: head.ask, programs, files, options: head.options })
    }
}

const REPORT_IT: &str = "the JavaScript and the WebAssembly are of two versions: build both again";

fn torn() -> Failure {
    Failure::wrong("the request ends too early", REPORT_IT)
}

/// Options out of the JSON of a request; what is wrong with them in words.
pub fn options<T: serde::de::DeserializeOwned>(ask: &str, options: Value) -> Result<T, Failure> {
    serde_json::from_value(options).map_err(|error| {
        let message = error.to_string().replace("unknown field", "unknown option");
        Failure::wrong(
            format!("an option of {ask} is wrong: {message}"),
            "the options are in docs/npm.md",
        )
    })
}
