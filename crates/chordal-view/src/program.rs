//! Where a view gets programs, machines and subprograms from.

use std::path::PathBuf;
use std::sync::{Arc, OnceLock};

use chordal::Machine;
use chordal::machine::builtin_names;
use chordal_compare::ComparisonOptions;
use chordal_editor::EditorProgram;
use serde_json::{Value, json};

/// Why a program cannot be run at all: in words for people.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProgramRefusal {
    /// What is wrong, without a full stop.
    pub message: String,
    /// What to do about it, if anything can be done.
    pub help: Option<String>,
}

/// A machine to choose from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ListedMachine {
    /// The name it is chosen by.
    pub name: String,
    /// The name that is shown in the list.
    pub title: String,
}

/// The other program, which one is compared with.
pub struct ComparedProgram {
    /// Finds the other program; its machine is the one that it takes by itself.
    pub programs: Arc<dyn ProgramSource>,
    /// The text is that of the program itself, as it is edited, on another machine.
    pub own_text: bool,
    /// What counts as a difference; the page may set another tolerance.
    pub options: ComparisonOptions,
}

impl ComparedProgram {
    /// The object in the page's `hello`: `name` and `own_text`.
    pub fn to_json(&self) -> Value {
        json!({ "name": self.programs.name(), "own_text": self.own_text })
    }
}

/// Finds what a program needs, as the command line says.
pub trait ProgramSource: Send + Sync + 'static {
    /// The file that is shown, where it is one of the disk that others may change.
    fn path(&self) -> Option<PathBuf> {
        None
    }

    /// Whether the text can be saved.
    fn is_writable(&self) -> bool {
        self.path().is_some()
    }

    /// Writes the text to its file, whole or not at all.
    ///
    /// # Errors
    /// A file that cannot be written; it is then as before.
    fn write(&self, _bytes: &[u8]) -> Result<(), ProgramRefusal> {
        Err(ProgramRefusal { message: "there is no file to write".into(), help: None })
    }

    /// The name that is shown: mostly the path of the file.
    fn name(&self) -> String;

    /// The bytes of the file as they are now.
    ///
    /// # Errors
    /// A file that cannot be read.
    fn read(&self) -> Result<Vec<u8>, ProgramRefusal>;

    /// A text with its machine and its subprograms; without a machine the one that the command
    /// line, the folder or the text says. The machine is a [`ChosenMachine`](crate::ChosenMachine).
    ///
    /// # Errors
    /// A machine that cannot be used, a program that is not there.
    fn open(&self, text: Vec<u8>, machine: Option<&str>) -> Result<EditorProgram, ProgramRefusal>;

    /// The machines that [`ProgramSource::open`] knows.
    fn machines(&self) -> Vec<ListedMachine>;

    /// The bytes of a file that the machine's setup names: the mesh of a stock, a fixture or a target.
    ///
    /// # Errors
    /// Why it cannot be read.
    fn named_file(&self, name: &str) -> Result<Vec<u8>, String> {
        Err(format!("there is no file {name}"))
    }

    /// What the program is compared with, where the command line says it, or a page without one.
    fn compared_program(&self) -> Option<Arc<ComparedProgram>> {
        None
    }
}

/// The machines that every page may choose from. Their files are read the first time.
pub fn builtin_machines() -> Vec<ListedMachine> {
    static MACHINES: OnceLock<Vec<ListedMachine>> = OnceLock::new();
    let choice = |name: &&str| {
        let title = Machine::from_builtin(name).map_or_else(|_| (*name).into(), |it| it.title);
        ListedMachine { name: (*name).into(), title }
    };
    MACHINES.get_or_init(|| builtin_names().iter().map(choice).collect()).clone()
}
