//! What a view is given: who finds programs, machines and subprograms.

use std::path::PathBuf;
use std::sync::{Arc, OnceLock};

use chordal::Machine;
use chordal::machine::builtin_names;
use chordal_compare::ComparisonOptions;
use chordal_editor::EditorProgram;
use serde_json::{Value, json};

/// Why a program cannot be run at all: in words for people.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// What is wrong.
    pub message: String,
    /// What to do.
    pub help: Option<String>,
}

/// A machine to choose from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MachineChoice {
    /// The name it is chosen by.
    pub name: String,
    /// For people.
    pub title: String,
}

/// The other program, which one is compared with.
pub struct Against {
    /// Finds the other program; its machine is the one that it takes by itself.
    pub programs: Arc<dyn Programs>,
    /// The text is that of the program itself, as it is edited, on another machine.
    pub own_text: bool,
    /// What counts as a difference; the page may set another tolerance.
    pub options: ComparisonOptions,
}

impl Against {
    /// As a page is told of it.
    pub fn told(&self) -> Value {
        json!({ "name": self.programs.name(), "own_text": self.own_text })
    }
}

/// Finds what a program needs, as the command line says.
pub trait Programs: Send + Sync + 'static {
    /// The file that is shown, where it is one of the disk that others may change.
    fn path(&self) -> Option<PathBuf> {
        None
    }

    /// The text can be saved.
    fn is_writable(&self) -> bool {
        self.path().is_some()
    }

    /// Saves the text.
    ///
    /// # Errors
    /// A file that cannot be written; it is then as before.
    fn write(&self, _bytes: &[u8]) -> Result<(), Refusal> {
        Err(Refusal { message: "there is no file to write".into(), help: None })
    }

    /// The name for people.
    fn name(&self) -> String;

    /// The bytes of the file as they are now.
    ///
    /// # Errors
    /// A file that cannot be read.
    fn read(&self) -> Result<Vec<u8>, Refusal>;

    /// A text with its machine and its subprograms; without a machine the one that the command
    /// line, the folder or the text says. The machine is a [`ChosenMachine`](crate::ChosenMachine).
    ///
    /// # Errors
    /// A machine that cannot be used, a program that is not there.
    fn open(&self, text: Vec<u8>, machine: Option<&str>) -> Result<EditorProgram, Refusal>;

    /// The machines that [`Programs::open`] knows.
    fn machines(&self) -> Vec<MachineChoice>;

    /// The bytes of a file that the machine's setup names: the mesh of a stock, a fixture or a target.
    ///
    /// # Errors
    /// Why it cannot be read.
    fn named_file(&self, name: &str) -> Result<Vec<u8>, String> {
        Err(format!("there is no file {name}"))
    }

    /// What the program is compared with, where the command line says it, or a page without one.
    fn against(&self) -> Option<Arc<Against>> {
        None
    }
}

/// The machines that every page may choose from. Their files are read the first time.
pub fn builtin_machines() -> Vec<MachineChoice> {
    static MACHINES: OnceLock<Vec<MachineChoice>> = OnceLock::new();
    let choice = |name: &&str| {
        let title = Machine::from_builtin(name).map_or_else(|_| (*name).into(), |it| it.title);
        MachineChoice { name: (*name).into(), title }
    };
    MACHINES.get_or_init(|| builtin_names().iter().map(choice).collect()).clone()
}
