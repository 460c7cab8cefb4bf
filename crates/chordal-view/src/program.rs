//! The source of programs, machines and subprograms of a view.

use std::path::PathBuf;
use std::sync::{Arc, OnceLock};

use chordal::Machine;
use chordal::machine::builtin_names;
use chordal_compare::ComparisonOptions;
use chordal_editor::EditorProgram;
use serde_json::{Value, json};

/// Why a program cannot be run at all, in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProgramRefusal {
    /// What is wrong, without a full stop.
    pub message: String,
    /// What the user can do about it; `None` when there is no suggestion.
    pub help: Option<String>,
}

/// A machine in the list of a page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ListedMachine {
    /// The name that selects it.
    pub name: String,
    /// The title that the list shows.
    pub title: String,
}

/// The other program of a comparison.
pub struct ComparedProgram {
    /// Opens the other program, on the machine that it names or that is recognized from it.
    pub programs: Arc<dyn ProgramSource>,
    /// The text is that of the shown program itself, as edited, on another machine.
    pub own_text: bool,
    /// The options of the comparison; the page may set another tolerance.
    pub options: ComparisonOptions,
}

impl ComparedProgram {
    /// The object in the page's `hello`: `name` and `own_text`.
    pub fn to_json(&self) -> Value {
        json!({ "name": self.programs.name(), "own_text": self.own_text })
    }
}

/// Opens programs as the command line specifies.
pub trait ProgramSource: Send + Sync + 'static {
    /// The shown file; `None` when it is not a file on disk that could change.
    fn path(&self) -> Option<PathBuf> {
        None
    }

    /// Whether the text can be saved.
    fn is_writable(&self) -> bool {
        self.path().is_some()
    }

    /// Writes the text to its file, completely or not at all.
    ///
    /// # Errors The file cannot be written; it is then unchanged.
    fn write(&self, _bytes: &[u8]) -> Result<(), ProgramRefusal> {
        Err(ProgramRefusal { message: "there is no file to write".into(), help: None })
    }

    /// The displayed name, usually the path of the file.
    fn name(&self) -> String;

    /// Reads the file.
    ///
    /// # Errors The file cannot be read.
    fn read(&self) -> Result<Vec<u8>, ProgramRefusal>;

    /// Opens a text with its machine and its subprograms. `machine` is a [`ChosenMachine`](crate::ChosenMachine);
    /// `None` uses the one from the command line, the folder or the text.
    ///
    /// # Errors The machine cannot be used, or the requested program number does not exist.
    fn open(&self, text: Vec<u8>, machine: Option<&str>) -> Result<EditorProgram, ProgramRefusal>;

    /// The machines that [`ProgramSource::open`] accepts by name.
    fn machines(&self) -> Vec<ListedMachine>;

    /// Reads a file that the machine's setup names: the mesh of a stock, a fixture or a target.
    ///
    /// # Errors The reason why it cannot be read.
    fn named_file(&self, name: &str) -> Result<Vec<u8>, String> {
        Err(format!("there is no file {name}"))
    }

    /// The program to compare with; `None` when neither the command line nor the page names one.
    fn compared_program(&self) -> Option<Arc<ComparedProgram>> {
        None
    }
}

/// The built-in machines, which every page lists. Their files are read at the first call.
pub fn builtin_machines() -> Vec<ListedMachine> {
    static MACHINES: OnceLock<Vec<ListedMachine>> = OnceLock::new();
    let choice = |name: &&str| {
        let title = Machine::from_builtin(name).map_or_else(|_| (*name).into(), |it| it.title);
        ListedMachine { name: (*name).into(), title }
    };
    MACHINES.get_or_init(|| builtin_names().iter().map(choice).collect()).clone()
}
