//! The program and the files that the page was given: nothing is looked for anywhere else.

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use chordal_editor::EditorProgram;
use chordal_load::{
    FileAccess, Loader, ProgramInput, Request, RequestedMachine as GivenMachine, machine,
};
use chordal_memory::{Message, TornMessage};
use chordal_view::{
    Against, ChosenMachine, MachineChoice, Outbox, Programs, Refusal, builtin_machines, refusal,
};
use serde_json::json;

use crate::begin::{self, Begin};

/// A program and its files.
pub struct Given {
    name: String,
    /// Until it is read: from then on the view has the text.
    program: Mutex<Option<Vec<u8>>>,
    machine: Option<String>,
    beside: Mutex<Beside>,
    out: Outbox,
}

/// What lies next to a program.
struct Beside {
    files: FileAccess,
    machines: Vec<MachineChoice>,
    against: Option<Arc<Against>>,
}

/// The program that is compared with.
struct Second {
    name: String,
    bytes: Vec<u8>,
    machine: Option<String>,
    files: FileAccess,
}

impl Given {
    /// Out of a message.
    pub fn read(bytes: Vec<u8>, out: Outbox) -> Result<Given, TornMessage> {
        let (begin, mut rest) = Message::read(bytes)?;
        let Begin { name, program, files, machine, against } = begin;
        let beside = Mutex::new(Beside::read(files, against, &mut rest)?);
        // The program comes last: it keeps the memory of the message.
        let program = Mutex::new(program.then(|| rest.rest()));
        Ok(Given { name, program, machine, beside, out })
    }

    /// Other files lie next to the program now, or it has another one to be compared with; the page is told of both.
    pub fn renew(&self, bytes: Vec<u8>) -> Result<(), TornMessage> {
        let (Begin { files, against, .. }, mut rest) = Message::read(bytes)?;
        let beside = Beside::read(files, against, &mut rest)?;
        let against = beside.against.as_ref().map(|against| against.told());
        let machines = beside.machines.iter();
        let machines: Vec<_> =
            machines.map(|each| json!({ "name": each.name, "title": each.title })).collect();
        *self.beside() = beside;
        self.out.json(&json!({ "type": "machines", "machines": machines, "against": against }));
        Ok(())
    }

    fn beside(&self) -> MutexGuard<'_, Beside> {
        self.beside.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Beside {
    fn read(
        named: Vec<begin::File>,
        other: Option<begin::Other>,
        rest: &mut Message,
    ) -> Result<Beside, TornMessage> {
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
            // What is wrong with a file is said when it is chosen.
            let title = machine::named_of(&files, &name)
                .map_or_else(|_| name.clone(), |it| format!("{} ({name})", it.title));
            MachineChoice { name, title }
        }));
        let mut against = None;
        if let Some(begin::Other { name, bytes, machine }) = other {
            let bytes = rest.take(bytes)?;
            let programs = Arc::new(Second { name, bytes, machine, files: files.clone() });
            let options = Default::default();
            against = Some(Arc::new(Against { programs, own_text: false, options }));
        }
        Ok(Beside { files, machines, against })
    }
}

/// A text with what lies next to it, on the machine that was chosen, or on its own.
fn opened(
    files: FileAccess,
    chosen: Option<&str>,
    own: Option<&str>,
    name: &str,
    text: Vec<u8>,
) -> Result<EditorProgram, Refusal> {
    let loader_on = |machine: Option<&str>| {
        let chosen = machine.map(ChosenMachine::of);
        let set = chosen.map_or_else(Vec::new, |chosen| chosen.assignments());
        let machine = chosen.map(|chosen| GivenMachine::Name(chosen.name.to_string()));
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
    chordal_view::open(loader, set_up, &input, name, text, named_in)
}

/// A file that a machine or a setup may be in. That of a folder counts without being chosen.
fn is_machine_file(name: &str) -> bool {
    let file = Path::new(name).file_name().and_then(|file| file.to_str()).unwrap_or("");
    file.ends_with(".toml") && file != "chordal.toml"
}

impl Programs for Given {
    fn name(&self) -> String {
        self.name.clone()
    }

    fn is_writable(&self) -> bool {
        true
    }

    fn write(&self, bytes: &[u8]) -> Result<(), Refusal> {
        self.out.file(&self.name, bytes);
        Ok(())
    }

    fn read(&self) -> Result<Vec<u8>, Refusal> {
        let program = self.program.lock().unwrap_or_else(PoisonError::into_inner).take();
        program.ok_or_else(|| Refusal {
            message: "the file was read already".into(),
            help: Some("open it again".into()),
        })
    }

    fn open(&self, text: Vec<u8>, machine: Option<&str>) -> Result<EditorProgram, Refusal> {
        let beside = self.beside();
        if let Some(ChosenMachine { name, .. }) = machine.map(ChosenMachine::of)
            && !beside.machines.iter().any(|choice| choice.name == name)
        {
            return Err(Refusal {
                message: format!("{name} is not a machine of the list"),
                help: Some("choose one from the list, or open its machine file".into()),
            });
        }
        let files = beside.files.clone();
        drop(beside);
        opened(files, machine, self.machine.as_deref(), &self.name, text)
    }

    fn machines(&self) -> Vec<MachineChoice> {
        self.beside().machines.clone()
    }

    fn named_file(&self, name: &str) -> Result<Vec<u8>, String> {
        let beside = self.beside();
        let bytes = beside.files.bytes(Path::new(name));
        bytes.map_err(|_| "open it together with the setup file".to_string())
    }

    fn against(&self) -> Option<Arc<Against>> {
        self.beside().against.clone()
    }
}

impl Programs for Second {
    fn name(&self) -> String {
        self.name.clone()
    }

    fn read(&self) -> Result<Vec<u8>, Refusal> {
        Ok(self.bytes.clone())
    }

    fn open(&self, text: Vec<u8>, machine: Option<&str>) -> Result<EditorProgram, Refusal> {
        opened(self.files.clone(), machine, self.machine.as_deref(), &self.name, text)
    }

    fn machines(&self) -> Vec<MachineChoice> {
        Vec::new()
    }
}
