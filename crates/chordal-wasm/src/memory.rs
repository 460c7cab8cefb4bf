//! A request as it lies in memory: four bytes with the length of a JSON object, the object, then the bytes
//! of the texts that it names, in their order.

use std::path::PathBuf;

use chordal_ask::{Failure, Files, Program, Request, options};
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
        programs.push(Program { options: options(&head.ask, program.options)?, text: Some(text) });
    }
    let mut files = Vec::new();
    for file in head.files {
        let text = take(file.bytes)?;
        files.push((PathBuf::from(file.path), text));
    }
    let files = Files::given(files);
    Ok(Request { ask: head.ask, programs, files, options: head.options })
}

const REPORT_IT: &str = "the JavaScript and the WebAssembly are of two versions: build both again";

fn torn() -> Failure {
    Failure::wrong("the request ends too early", REPORT_IT)
}
