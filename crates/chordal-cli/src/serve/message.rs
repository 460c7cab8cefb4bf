//! What a line asks.

use std::path::PathBuf;

use chordal_ask::{
    FileAccess, ProgramOptions, QuestionFailure, QuestionProgram, QuestionRequest, options,
};
use serde::Deserialize;
use serde_json::{Map, Value};

use super::stamp::FileStamp;

/// A line.
pub enum ServeMessage {
    /// A question.
    Ask(Box<PendingQuestion>),
    /// The question of this number is not to be answered, or not again.
    Cancel(Value),
}

/// A question as it waits for its answer.
#[derive(Clone)]
pub struct PendingQuestion {
    /// What the answer is to carry: a number or a text.
    pub id: Value,
    /// `check`, `time`.
    pub ask: String,
    programs: Vec<ServeRequest>,
    options: Value,
    /// It is answered again whenever a file of it changes.
    pub is_watched: bool,
    /// How often it was answered before.
    pub times: u64,
}

/// A program of a question.
#[derive(Clone)]
struct ServeRequest {
    file: Option<String>,
    text: Option<String>,
    options: Value,
}

/// The object of a line.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct MessageObject {
    #[serde(default, rename = "id")]
    _id: Value,
    ask: Option<String>,
    cancel: Option<Value>,
    program: Option<Map<String, Value>>,
    #[serde(default)]
    programs: Vec<Map<String, Value>>,
    #[serde(default)]
    options: Map<String, Value>,
    #[serde(default)]
    watch: bool,
}

const FORM: &str =
    r#"a question is {"id":1,"ask":"check","program":{"file":"part.nc"}}; see docs/serve.md"#;

/// A line that is not a question: its `id`, as far as it can be read, and what is wrong.
pub struct RejectedLine {
    pub id: Value,
    pub failure: QuestionFailure,
}

impl RejectedLine {
    fn of(id: &Value, failure: QuestionFailure) -> Box<RejectedLine> {
        Box::new(RejectedLine { id: id.clone(), failure })
    }
}

impl ServeMessage {
    /// Reads a line.
    pub fn read(line: &[u8]) -> Result<ServeMessage, Box<RejectedLine>> {
        let wrong = |message: String| QuestionFailure::wrong(message, FORM);
        let value: Value = serde_json::from_slice(line).map_err(|error| {
            RejectedLine::of(&Value::Null, wrong(format!("the line is not JSON: {error}")))
        })?;
        let id = value.get("id").cloned().unwrap_or_default();
        let object: MessageObject = serde_json::from_value(value).map_err(|error| {
            RejectedLine::of(&id, wrong(format!("the line is not a question: {error}")))
        })?;
        if !(id.is_null() || id.is_number() || id.is_string()) {
            return Err(RejectedLine::of(
                &Value::Null,
                wrong("`id` is not a number or a text".into()),
            ));
        }
        match (object.ask, object.cancel) {
            (Some(ask), None) => {
                let provided = object.program.into_iter().chain(object.programs);
                let programs = provided.map(ServeRequest::of).collect::<Result<Vec<_>, _>>();
                let programs = programs.map_err(|reported| RejectedLine::of(&id, reported))?;
                let options = Value::Object(object.options);
                let is_watched = object.watch;
                if is_watched && programs.iter().all(|program| program.file.is_none()) {
                    let failure = QuestionFailure::wrong("there is no file to watch", FORM);
                    return Err(RejectedLine::of(&id, failure));
                }
                let question = PendingQuestion { id, ask, programs, options, is_watched, times: 0 };
                Ok(ServeMessage::Ask(Box::new(question)))
            }
            (None, Some(cancelled)) => Ok(ServeMessage::Cancel(cancelled)),
            _ => {
                Err(RejectedLine::of(&id, wrong("the line needs either `ask` or `cancel`".into())))
            }
        }
    }
}

impl ServeRequest {
    fn of(mut object: Map<String, Value>) -> Result<ServeRequest, QuestionFailure> {
        let mut take = |key: &str| match object.remove(key) {
            None => Ok(None),
            Some(Value::String(text)) => Ok(Some(text)),
            Some(_) => {
                Err(QuestionFailure::wrong(format!("`{key}` of a program is not a text"), FORM))
            }
        };
        let (file, text) = (take("file")?, take("text")?);
        if file.is_none() && text.is_none() {
            return Err(QuestionFailure::wrong("a program needs a `file` or its `text`", FORM));
        }
        Ok(ServeRequest { file, text, options: Value::Object(object) })
    }
}

impl PendingQuestion {
    /// The request, with the files of the disk.
    pub fn request(&self) -> Result<QuestionRequest, QuestionFailure> {
        let program = |request: &ServeRequest| {
            let mut own_options: ProgramOptions = options(&self.ask, request.options.clone())?;
            own_options.name = request.file.clone().or(own_options.name);
            let text = request.text.clone().map(String::into_bytes);
            Ok(QuestionProgram { options: own_options, text })
        };
        Ok(QuestionRequest {
            question: self.ask.clone(),
            programs: self.programs.iter().map(program).collect::<Result<_, QuestionFailure>>()?,
            files: FileAccess::Disk,
            options: self.options.clone(),
        })
    }

    /// The files of the programs as they are now.
    pub fn stamps(&self) -> Vec<FileStamp> {
        let files = self.programs.iter().filter_map(|program| program.file.as_ref());
        files.map(|file| FileStamp::of(PathBuf::from(file))).collect()
    }
}
