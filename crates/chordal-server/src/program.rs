//! What the server is given: who finds programs, machines and subprograms.

use std::path::PathBuf;

use chordal::{Job, JobError, Machine, RunOptions, Source, SourceMap};

/// A program with everything it needs to run.
#[derive(Clone, Debug)]
pub struct Opened {
    /// Names and texts: the program, then those of its subprograms.
    pub texts: Vec<(String, Vec<u8>)>,
    /// What runs it.
    pub machine: Machine,
    /// Budgets.
    pub options: RunOptions,
    /// The one program of the file to run, where that was said.
    pub program: Option<u32>,
    /// Why this machine, where nobody said it.
    pub why: Option<String>,
}

impl Opened {
    /// The job.
    ///
    /// # Errors
    /// Settings of the machine that its control does not know.
    pub fn job(&self) -> Result<Job<'_>, JobError> {
        let mut sources = SourceMap::new();
        for (name, text) in &self.texts {
            sources.add(Source::new(name.as_str(), text.as_slice()));
        }
        let job = Job::new(sources, self.machine.clone())?;
        Ok(job.program(self.program).options(self.options.clone()))
    }
}

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

/// Finds what a program needs, as the command line says.
pub trait Programs: Send + Sync + 'static {
    /// The file that is shown; `None` where there is none to write to.
    fn path(&self) -> Option<PathBuf>;

    /// The name for people.
    fn name(&self) -> String;

    /// The bytes of the file as they are now.
    ///
    /// # Errors
    /// A file that cannot be read.
    fn read(&self) -> Result<Vec<u8>, Refusal>;

    /// A text with its machine and its subprograms; without a machine the one that the command
    /// line, the folder or the text says.
    ///
    /// # Errors
    /// A machine that cannot be used, a program that is not there.
    fn open(&self, text: Vec<u8>, machine: Option<&str>) -> Result<Opened, Refusal>;

    /// The machines that [`Programs::open`] knows.
    fn machines(&self) -> Vec<MachineChoice>;
}
