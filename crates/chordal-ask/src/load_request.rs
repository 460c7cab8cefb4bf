//! Programs and machines of a request.

use std::path::{Path, PathBuf};

use chordal::Machine;
use chordal_editor::EditorSetup;
use chordal_export::{FormatList, OutputFormat};
use chordal_load::{
    FileAccess, Loaded, Loader, ProgramInput, ProgramText, RequestedMachine, machine, unsaved,
};

use crate::answer::QuestionFailure;
use crate::request::{QuestionProgram, QuestionRequest};

/// A request whose programs are loaded one after the other.
pub struct LoadRequest {
    pub question: String,
    pub files: FileAccess,
    pub options: serde_json::Value,
    programs: std::vec::IntoIter<QuestionProgram>,
}

impl LoadRequest {
    pub fn of(request: QuestionRequest) -> LoadRequest {
        let QuestionRequest { question: ask, programs, files, options } = request;
        LoadRequest { question: ask, files, options, programs: programs.into_iter() }
    }

    /// The options of the question.
    pub fn options<T: serde::de::DeserializeOwned>(&mut self) -> Result<T, QuestionFailure> {
        crate::request::options(&self.question, self.options.take())
    }

    /// Loads the next program.
    pub fn load(&mut self) -> Result<Loaded, QuestionFailure> {
        let Some(QuestionProgram { options, text }) = self.programs.next() else {
            return Err(QuestionFailure::wrong("there is no program", "give its text"));
        };
        let name = options.name.unwrap_or_else(|| "program".into());
        let request = chordal_load::Request {
            machine: options.machine.map(RequestedMachine::Name),
            files: self.files.clone(),
            set: options.set,
            tools: options.tools.map(PathBuf::from),
            settings: options.settings.map(PathBuf::from),
            program: options.program,
            block_delete: options.block_delete.into(),
            max_blocks: options.max_blocks,
            ..chordal_load::Request::default()
        };
        let mut loader = Loader::new(request)?;
        let input = ProgramInput { path: Some(PathBuf::from(&name)), root: None };
        match text {
            Some(text) => Ok(loader.load_text(ProgramText::of(&name, text)?, &input)?),
            None => Ok(loader.load(&input)?),
        }
    }

    /// Refuses a format that the question does not have.
    pub fn require_format(
        &self,
        list: &FormatList,
        format: OutputFormat,
    ) -> Result<(), QuestionFailure> {
        if list.has(format) {
            return Ok(());
        }
        let message = format!("{} does not have this format", self.question);
        Err(QuestionFailure::wrong(message, format!("its formats are {}", list.names())))
    }

    /// A machine by its name, or of a file of the request.
    pub fn machine(&self, name: &str) -> Result<Machine, QuestionFailure> {
        Ok(machine::named_of(&self.files, name)?)
    }
}

/// What a text of an editor needs to run: a machine that the editor names comes before that of the request.
///
/// # Errors
/// A sentence for people.
pub fn setup_of(
    path: Option<&Path>,
    text: &[u8],
    machine: Option<&str>,
    mut request: chordal_load::Request,
) -> Result<EditorSetup, String> {
    if let Some(name) = machine {
        request.machine = Some(RequestedMachine::Name(name.to_string()));
    }
    let loaded = unsaved(path, text.to_vec(), &request);
    let loaded = loaded.map_err(|failure| failure.to_string())?;
    let (why, program, readings) = (loaded.why(), loaded.program, loaded.choices());
    let (mut texts, machine, options) = loaded.into_parts();
    // The first text is the program, the others are its subprograms.
    let others = texts.split_off(1);
    Ok(EditorSetup { machine, why, readings, options, program, subprogram_texts: others })
}
