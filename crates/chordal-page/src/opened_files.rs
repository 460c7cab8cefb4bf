//! The program and the files that the page has opened: no others are read.

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use chordal_editor::EditorProgram;
use chordal_load::{FileAccess, Loader, ProgramInput, Request, RequestedMachine, machine};
use chordal_memory::{MemoryMessage, TornMessage};
use chordal_view::{
    ChosenMachine, ComparedProgram, ListedMachine, PageOutbox, ProgramRefusal, ProgramSource,
    builtin_machines, refusal,
};
use serde_json::json;

use crate::open_message::{self, OpenMessage};

/// A program and its files.
pub struct OpenedProgram {
    name: String,
    /// `None` once it was read: from then on the view has the text.
    program: Mutex<Option<Vec<u8>>>,
    machine: Option<String>,
    files: Mutex<OpenedFiles>,
    out: PageOutbox,
}

/// What lies next to a program.
struct OpenedFiles {
    files: FileAccess,
    machines: Vec<ListedMachine>,
    compared: Option<Arc<ComparedProgram>>,
}

/// The program that is compared with.
struct SecondProgram {
    name: String,
    bytes: Vec<u8>,
    machine: Option<String>,
    files: FileAccess,
}

impl OpenedProgram {
    /// Reads a program and its files out of a message.
    pub fn read(bytes: Vec<u8>, out: PageOutbox) -> Result<OpenedProgram, TornMessage> {
        let (begin, mut rest) = MemoryMessage::read(bytes)?;
        let OpenMessage { name, program, files, machine, compared } = begin;
        let nearby = Mutex::new(OpenedFiles::read(files, compared, &mut rest)?);
        // The program comes last: it keeps the memory of the message.
        let program = Mutex::new(program.then(|| rest.rest()));
        Ok(OpenedProgram { name, program, machine, files: nearby, out })
    }

    /// Replaces the files next to the program and the program that it is compared with, and sends the page the new lists.
    pub fn renew(&self, bytes: Vec<u8>) -> Result<(), TornMessage> {
        let (OpenMessage { files, compared, .. }, mut rest) = MemoryMessage::read(bytes)?;
        let nearby = OpenedFiles::read(files, compared, &mut rest)?;
        let compared = nearby.compared.as_ref().map(|compared| compared.to_json());
        let machines = nearby.machines.iter();
        let machines: Vec<_> =
            machines.map(|each| json!({ "name": each.name, "title": each.title })).collect();
        *self.files() = nearby;
        self.out.json(&json!({ "type": "machines", "machines": machines, "compared": compared }));
        Ok(())
    }

    fn files(&self) -> MutexGuard<'_, OpenedFiles> {
        self.files.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl OpenedFiles {
    fn read(
        named: Vec<open_message::FileHeader>,
        other: Option<open_message::OtherProgramHeader>,
        rest: &mut MemoryMessage,
    ) -> Result<OpenedFiles, TornMessage> {
        let mut files = Vec::new();
        let mut names = Vec::new();
        for file in named {
            let bytes = rest.take(file.bytes)?;
            if is_machine_file(&file.path) {
                names.push(file.path.clone());
            }
            files.push((PathBuf::from(file.path), bytes));
        }
        let files = FileAccess::in_memory(files);
        let mut machines = builtin_machines();
        machines.extend(names.into_iter().map(|name| {
            // Errors in a machine file are reported when it is chosen.
            let title = machine::named_of(&files, &name)
                .map_or_else(|_| name.clone(), |it| format!("{} ({name})", it.title));
            ListedMachine { name, title }
        }));
        let mut compared = None;
        if let Some(open_message::OtherProgramHeader { name, bytes, machine }) = other {
            let bytes = rest.take(bytes)?;
            let programs = Arc::new(SecondProgram { name, bytes, machine, files: files.clone() });
            let options = Default::default();
            compared = Some(Arc::new(ComparedProgram { programs, own_text: false, options }));
        }
        Ok(OpenedFiles { files, machines, compared })
    }
}

/// A text with what lies next to it, on the machine that was chosen, or on its own.
fn open_text(
    files: FileAccess,
    chosen: Option<&str>,
    own: Option<&str>,
    name: &str,
    text: Vec<u8>,
) -> Result<EditorProgram, ProgramRefusal> {
    let loader_on = |machine: Option<&str>| {
        let chosen = machine.map(ChosenMachine::of);
        let set = chosen.as_ref().map_or_else(Vec::new, ChosenMachine::assignments);
        let machine = chosen.map(|chosen| RequestedMachine::Name(chosen.name.to_string()));
        Loader::new(Request { machine, set, files: files.clone(), ..Request::default() })
    };
    let loader = loader_on(chosen.or(own));
    let set_up = chosen.and_then(|_| loader_on(own).ok());
    let input = ProgramInput { path: Some(PathBuf::from(name)), root: None };
    let named_in = |file: &Path| {
        let name = file.file_name().unwrap_or_default().to_string_lossy();
        format!("named in {name} next to it")
    };
    let loader = loader.map_err(|error| refusal(&error))?;
    chordal_view::open_program(loader, set_up, &input, name, text, named_in)
}

/// A file that a machine or a setup may be in. That of a folder counts without being chosen.
fn is_machine_file(name: &str) -> bool {
    let file = Path::new(name).file_name().and_then(|file| file.to_str()).unwrap_or("");
    file.ends_with(".toml") && file != "chordal.toml"
}

impl ProgramSource for OpenedProgram {
    fn name(&self) -> String {
        self.name.clone()
    }

    fn is_writable(&self) -> bool {
        true
    }

    fn write(&self, bytes: &[u8]) -> Result<(), ProgramRefusal> {
        self.out.file(&self.name, bytes);
        Ok(())
    }

    fn read(&self) -> Result<Vec<u8>, ProgramRefusal> {
        let program = self.program.lock().unwrap_or_else(PoisonError::into_inner).take();
        program.ok_or_else(|| ProgramRefusal {
            message: "the file was read already".into(),
            help: Some("open it again".into()),
        })
    }

    fn open(&self, text: Vec<u8>, machine: Option<&str>) -> Result<EditorProgram, ProgramRefusal> {
        let nearby = self.files();
        if let Some(ChosenMachine { name, .. }) = machine.map(ChosenMachine::of)
            && !nearby.machines.iter().any(|choice| choice.name == name)
        {
            return Err(ProgramRefusal {
                message: format!("{name} is not a machine of the list"),
                help: Some("choose one from the list, or open its machine file".into()),
            });
        }
        let files = nearby.files.clone();
        drop(nearby);
        open_text(files, machine, self.machine.as_deref(), &self.name, text)
    }

    fn machines(&self) -> Vec<ListedMachine> {
        self.files().machines.clone()
    }

    fn named_file(&self, name: &str) -> Result<Vec<u8>, String> {
        let nearby = self.files();
        let bytes = nearby.files.bytes(Path::new(name));
        bytes.map_err(|_| "open it together with the setup file".to_string())
    }

    fn compared_program(&self) -> Option<Arc<ComparedProgram>> {
        self.files().compared.clone()
    }
}

impl ProgramSource for SecondProgram {
    fn name(&self) -> String {
        self.name.clone()
    }

    fn read(&self) -> Result<Vec<u8>, ProgramRefusal> {
        Ok(self.bytes.clone())
    }

    fn open(&self, text: Vec<u8>, machine: Option<&str>) -> Result<EditorProgram, ProgramRefusal> {
        open_text(self.files.clone(), machine, self.machine.as_deref(), &self.name, text)
    }

    fn machines(&self) -> Vec<ListedMachine> {
        Vec::new()
    }
}
