//! What a line asks.

use std::path::PathBuf;

use chordal_ask::{
    Files, ProgramOptions, QuestionFailure, QuestionProgram, QuestionRequest, options,
};
use serde::Deserialize;
use serde_json::{Map, Value};

use super::stamp::Stamp;

/// A line.
pub enum Message {
    /// A question.
    Ask(Box<Question>),
    /// The question of this number is not to be answered, or not again.
    Cancel(Value),
}

/// A question as it waits for its answer.
#[derive(Clone)]
pub struct Question {
    /// What the answer is to carry: a number or a text.
    pub id: Value,
    /// `check`, `time`.
    pub ask: String,
    programs: Vec<Asked>,
    options: Value,
    /// It is answered again whenever a file of it changes.
    pub is_watched: bool,
    /// How often it was answered before.
    pub times: u64,
}

/// A program of a question.
#[derive(Clone)]
struct Asked {
    file: Option<String>,
    text: Option<String>,
    options: Value,
}

/// The object of a line.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Object {
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
pub struct Refused {
    pub id: Value,
    pub told: QuestionFailure,
}

impl Refused {
    fn of(id: &Value, told: QuestionFailure) -> Box<Refused> {
        Box::new(Refused { id: id.clone(), told })
    }
}

impl Message {
    /// Reads a line.
    pub fn read(line: &[u8]) -> Result<Message, Box<Refused>> {
        let wrong = |message: String| QuestionFailure::wrong(message, FORM);
        let value: Value = serde_json::from_slice(line).map_err(|error| {
            Refused::of(&Value::Null, wrong(format!("the line is not JSON: {error}")))
        })?;
        let id = value.get("id").cloned().unwrap_or_default();
        let object: Object = serde_json::from_value(value).map_err(|error| {
            Refused::of(&id, wrong(format!("the line is not a question: {error}")))
        })?;
        if !(id.is_null() || id.is_number() || id.is_string()) {
            return Err(Refused::of(&Value::Null, wrong("`id` is not a number or a text".into())));
        }
        match (object.ask, object.cancel) {
            (Some(ask), None) => {
                let given = object.program.into_iter().chain(object.programs);
                let programs = given.map(Asked::of).collect::<Result<Vec<_>, _>>();
                let programs = programs.map_err(|told| Refused::of(&id, told))?;
                let options = Value::Object(object.options);
                let is_watched = object.watch;
                if is_watched && programs.iter().all(|program| program.file.is_none()) {
                    let told = QuestionFailure::wrong("there is no file to watch", FORM);
                    return Err(Refused::of(&id, told));
                }
                let question = Question { id, ask, programs, options, is_watched, times: 0 };
                Ok(Message::Ask(Box::new(question)))
            }
            (None, Some(cancelled)) => Ok(Message::Cancel(cancelled)),
            _ => Err(Refused::of(&id, wrong("the line needs either `ask` or `cancel`".into()))),
        }
    }
}

impl Asked {
    fn of(mut object: Map<String, Value>) -> Result<Asked, QuestionFailure> {
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
        Ok(Asked { file, text, options: Value::Object(object) })
    }
}

impl Question {
    /// The request, with the files of the disk.
    pub fn request(&self) -> Result<QuestionRequest, QuestionFailure> {
        let program = |asked: &Asked| {
            let mut given: ProgramOptions = options(&self.ask, asked.options.clone())?;
            given.name = asked.file.clone().or(given.name);
            let text = asked.text.clone().map(String::into_bytes);
            Ok(QuestionProgram { options: given, text })
        };
        Ok(QuestionRequest {
            question: self.ask.clone(),
            programs: self.programs.iter().map(program).collect::<Result<_, QuestionFailure>>()?,
            files: Files::Disk,
            options: self.options.clone(),
        })
    }

    /// The files of the programs as they are now.
    pub fn stamps(&self) -> Vec<Stamp> {
        let files = self.programs.iter().filter_map(|program| program.file.as_ref());
        files.map(|file| Stamp::of(PathBuf::from(file))).collect()
    }
}
