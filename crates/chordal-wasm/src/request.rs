//! A request: a message whose object says what is asked, and which names the texts of its programs and files.

use std::path::PathBuf;

use chordal_ask::{Failure, FileAccess, Program, Request, options};
use chordal_memory::{Message, TornMessage};
use serde::Deserialize;
use serde_json::Value;

/// The JSON object of a request.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Head {
    ask: String,
    programs: Vec<Given>,
    files: Vec<File>,
    options: Value,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Given {
    options: Value,
    bytes: usize,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    path: String,
    bytes: usize,
}

/// Reads a request.
pub fn read(bytes: Vec<u8>) -> Result<Request, Failure> {
    let (head, mut texts) = Message::read::<Head>(bytes).map_err(torn)?;
    let mut programs = Vec::new();
    for program in head.programs {
        let text = texts.take(program.bytes).map_err(torn)?;
        programs.push(Program { options: options(&head.ask, program.options)?, text: Some(text) });
    }
    let mut files = Vec::new();
    for file in head.files {
        files.push((PathBuf::from(file.path), texts.take(file.bytes).map_err(torn)?));
    }
    let files = FileAccess::in_memory(files);
    Ok(Request { ask: head.ask, programs, files, options: head.options })
}

fn torn(torn: TornMessage) -> Failure {
    let help = "the JavaScript and the WebAssembly are of two versions: build both again";
    Failure::wrong(format!("the request {torn}"), help)
}
