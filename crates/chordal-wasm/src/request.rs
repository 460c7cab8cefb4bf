//! A request: a message whose object has the question, and lists the texts of its programs and files.

use std::path::PathBuf;

use chordal_ask::{FileAccess, QuestionFailure, QuestionProgram, QuestionRequest, options};
use chordal_memory::{MemoryMessage, TornMessage};
use serde::Deserialize;
use serde_json::Value;

/// The JSON object of a request.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RequestHead {
    #[serde(rename = "ask")]
    question: String,
    programs: Vec<ProgramHeader>,
    files: Vec<RequestFile>,
    options: Value,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ProgramHeader {
    options: Value,
    bytes: usize,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RequestFile {
    path: String,
    bytes: usize,
}

/// Reads a request.
pub fn read(bytes: Vec<u8>) -> Result<QuestionRequest, QuestionFailure> {
    let (head, mut texts) = MemoryMessage::read::<RequestHead>(bytes).map_err(torn)?;
    let mut programs = Vec::new();
    for program in head.programs {
        let text = texts.take(program.bytes).map_err(torn)?;
        programs.push(QuestionProgram {
            options: options(&head.question, program.options)?,
            text: Some(text),
        });
    }
    let mut files = Vec::new();
    for file in head.files {
        files.push((PathBuf::from(file.path), texts.take(file.bytes).map_err(torn)?));
    }
    let files = FileAccess::in_memory(files);
    Ok(QuestionRequest { question: head.question, programs, files, options: head.options })
}

fn torn(torn: TornMessage) -> QuestionFailure {
    let help = "the JavaScript and the WebAssembly are of two versions: build both again";
    QuestionFailure::wrong(format!("the request {torn}"), help)
}
