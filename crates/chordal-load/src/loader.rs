//! Loads programs with one request.

use chordal::Machine;
use chordal::RunOptions;
use chordal::control::{ConfiguredControl, ProgramName, configured_control, table};
use chordal::syntax::is_program_name;

use crate::error::LoadError;
use crate::input::ProgramInput;
use crate::machine;
use crate::machine_reason::MachineReason;
use crate::neighbours::FolderCache;
use crate::not_a_program;
use crate::program_load::Loaded;
use crate::readings::ReadingPremise;
use crate::request::{BlockDeleteSwitch, Request, RequestedMachine};
use crate::text::ProgramText;

/// Loads programs with one request. The requested machine is loaded once, and each folder is listed once.
pub struct Loader {
    request: Request,
    machine: Option<Machine>,
    folders: FolderCache,
}

impl Loader {
    /// Loads the machine that the request names.
    ///
    /// # Errors The machine cannot be used.
    pub fn new(request: Request) -> Result<Loader, LoadError> {
        let machine = machine::requested_machine(&request)?;
        Ok(Loader { request, machine, folders: FolderCache::default() })
    }

    /// The same loader with empty caches of folders: for another thread, or when files may have changed.
    pub fn again(&self) -> Loader {
        let (request, machine) = (self.request.clone(), self.machine.clone());
        Loader { request, machine, folders: FolderCache::default() }
    }

    /// The same loader with another machine, to which the assignments, those in `more` and the tool table are
    /// applied.
    ///
    /// # Errors The machine cannot be used.
    pub fn on(&self, machine: RequestedMachine, more: Vec<String>) -> Result<Loader, LoadError> {
        let mut request = Request { machine: Some(machine), ..self.request.clone() };
        request.set.extend(more);
        Loader::new(request)
    }

    /// The same loader with another machine as it is: assignments and tool table are not applied to it.
    pub fn on_exactly(&self, machine: Machine) -> Loader {
        Loader { machine: Some(machine), ..self.again() }
    }

    /// Loads a program, its machine and its subprograms.
    ///
    /// # Errors The file cannot be read or is not a program, the machine cannot be used, or the requested program
    /// number does not exist.
    pub fn load(&mut self, input: &ProgramInput) -> Result<Loaded, LoadError> {
        self.load_text(ProgramText::read_of(&self.request.files, input)?, input)
    }

    /// [`Loader::load`] for an input whose text is already read.
    ///
    /// # Errors The text is not a program, the machine cannot be used, or the requested program number does not
    /// exist.
    pub fn load_text(
        &mut self,
        text: ProgramText,
        input: &ProgramInput,
    ) -> Result<Loaded, LoadError> {
        not_a_program::refuse_certain(text.name(), text.bytes())?;
        let named = self.machine.is_some() || machine::is_named(input, &self.request);
        if !named {
            not_a_program::refuse_likely(text.name(), text.bytes())?;
        }
        self.load_unsaved(text, input)
    }

    /// [`Loader::load_text`] without the test whether the text looks like a program.
    pub(crate) fn load_unsaved(
        &mut self,
        text: ProgramText,
        input: &ProgramInput,
    ) -> Result<Loaded, LoadError> {
        let request = &self.request;
        let (machine, chosen, premise) = match &self.machine {
            Some(machine) => (machine.clone(), MachineReason::Requested, None),
            None => machine::choose(input, text.bytes(), request)?,
        };
        // An assignment that names the control leaves nothing to assume.
        let premise = premise.filter(|_| !says(request, &["control"]));
        let (mut machine, mut notes) = (machine, Vec::new());
        if let (Some(path), Some(table)) = (&input.path, table(machine.control)) {
            let variables = self.folders.variables(&request.files, path);
            notes = variables.give(&mut machine, table, text.bytes());
        }
        let mut texts = vec![text];
        if let Some((control, _)) = configured_control(&machine) {
            if let Some(number) = request.program {
                has_program(&texts[0], number, &*control)?;
            }
            if let Some(path) = &input.path {
                let found = self.folders.find(&request.files, path, texts[0].bytes(), &*control);
                for text in found.iter().filter(|text| control.is_table(text.bytes())) {
                    control.take_table(text.bytes(), &mut machine);
                }
                texts.extend(found);
            }
        }
        let options = RunOptions {
            notes: premise
                .as_ref()
                .and_then(ReadingPremise::diagnostic)
                .into_iter()
                .chain(notes)
                .collect(),
            ..options(request, &chosen, texts[0].bytes())
        };
        let (program, shop_texts) = (request.program, Vec::new());
        let mut loaded = Loaded { texts, machine, options, shop_texts, program, chosen, premise };
        if let Some(shop) = &request.shop_codes {
            loaded.ask_shop(shop.clone(), request.interrupt.clone())?;
        }
        Ok(loaded)
    }
}

/// The options of the run: the limits of the request, and how the text was recognized.
fn options(request: &Request, chosen: &MachineReason, text: &[u8]) -> RunOptions {
    let usual = RunOptions::default();
    let named_control = says(request, &["control"]);
    RunOptions {
        max_repeated_blocks: request.max_blocks.unwrap_or(usual.max_repeated_blocks),
        assumed_machine: chosen.is_guess() && !says(request, LIMITS),
        not_read: chosen.refusal(text).filter(|_| !named_control),
        both_block_deletes: request.block_delete == BlockDeleteSwitch::Both,
        ..usual
    }
}

/// Keys of a machine that set its limits.
const LIMITS: &[&str] = &["axes", "feed", "spindle"];

/// Whether some assignment of the request sets one of these keys.
fn says(request: &Request, keys: &[&str]) -> bool {
    request.set.iter().any(|assignment| {
        let key = assignment.split(['.', '=']).next().unwrap_or("").trim();
        keys.contains(&key)
    })
}

fn has_program(
    text: &ProgramText,
    number: u32,
    control: &dyn ConfiguredControl,
) -> Result<(), LoadError> {
    let programs = control.program_names(text.bytes());
    if programs.iter().any(|name| name.key() == Some(number)) {
        return Ok(());
    }
    let called = if is_program_name(number) { "of this name".into() } else { format!("O{number}") };
    let message = format!("there is no program {called} in {}", text.name());
    let names: Vec<String> = programs.iter().take(20).map(ProgramName::to_string).collect();
    let more = if programs.len() > 20 { ", …" } else { "" };
    Err(match names.as_slice() {
        [] => LoadError::wrong(message, "no program of this file has a number"),
        names => LoadError::wrong(message, format!("it has {}{more}", names.join(", "))),
    })
}
