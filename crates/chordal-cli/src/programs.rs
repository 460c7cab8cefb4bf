//! The programs that a command line names: the one of most commands, or several of folders.

use std::collections::BTreeSet;
use std::path::PathBuf;
use std::time::Duration;

use chordal_load::{LoadError, Loaded, Loader, ProgramInput, find, without_called};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::changed::only_changed;
use crate::failure::{CommandFailure, ExitVerdict};
use crate::options::CommonArgs;
use crate::terminal::{TerminalSupport, say};

/// Loads the one program of a command that takes one.
pub fn load_one(file: &PathBuf, common: &CommonArgs) -> Result<Loaded, CommandFailure> {
    if file.is_dir() {
        return Err(CommandFailure::wrong(
            format!("{} is a folder", file.display()),
            "this command takes one program; `run` and `check` also take folders, `diff` compares two of them",
        ));
    }
    let (inputs, _) = find(std::slice::from_ref(file));
    let Some(input) = inputs.first() else {
        return Err(CommandFailure::Use { message: "there is no program".into(), help: None });
    };
    Ok(Loader::new(common.request())?.load(input)?)
}

/// Which control was recognized and by what, in a line; empty where the user said the machine.
pub fn recognized(loaded: &Loaded) -> String {
    loaded.why().map_or_else(String::new, |why| {
        format!("{}: {why}; --machine chooses another\n", loaded.name())
    })
}

/// The programs of a command that takes several.
pub struct ProgramList {
    terminal: TerminalSupport,
    loader: Loader,
    inputs: Vec<ProgramInput>,
    called: u64,
    bar: ProgressBar,
    reported: BTreeSet<String>,
    verdict: ExitVerdict,
}

impl ProgramList {
    /// Finds the inputs and reads the machine, if the command line names one.
    pub fn new(
        files: &[PathBuf],
        common: &CommonArgs,
        terminal: TerminalSupport,
    ) -> Result<ProgramList, CommandFailure> {
        ProgramList::changed(files, common, terminal, None)
    }

    /// The same with those inputs alone whose files changed since a commit. A file of subprograms
    /// counts as a program where the one that calls it has not changed.
    pub fn changed(
        files: &[PathBuf],
        common: &CommonArgs,
        terminal: TerminalSupport,
        since: Option<&str>,
    ) -> Result<ProgramList, CommandFailure> {
        let loader = Loader::new(common.request())?;
        let (mut inputs, failures) = find(files);
        if let Some(commit) = since {
            inputs = only_changed(inputs, commit)?;
        }
        let found = inputs.len();
        let inputs = without_called(inputs);
        let called = (found - inputs.len()) as u64;
        let bar = progress(inputs.len());
        let (noted, verdict) = (BTreeSet::new(), ExitVerdict::Clean);
        let mut programs =
            ProgramList { terminal, loader, inputs, called, bar, reported: noted, verdict };
        failures.into_iter().for_each(|failure| programs.report_failure(failure));
        Ok(programs)
    }

    /// The inputs.
    pub fn inputs(&self) -> &[ProgramInput] {
        &self.inputs
    }

    /// How many files of a folder are left out, because they only hold subprograms of others.
    pub fn called(&self) -> u64 {
        self.called
    }

    /// Loads each input and has it handled. What cannot be loaded is reported; the rest goes on.
    /// Only a failure of the handler ends it all.
    pub fn each(
        mut self,
        mut handle: impl FnMut(&ProgramList, usize, &Loaded) -> Result<ExitVerdict, CommandFailure>,
    ) -> Result<ExitVerdict, CommandFailure> {
        for index in 0..self.inputs.len() {
            let input = &self.inputs[index];
            self.bar.set_message(input.name().into_owned());
            match self.loader.load(input) {
                Ok(loaded) => {
                    let done = handle(&self, index, &loaded);
                    let verdict = done.inspect_err(|_| self.bar.finish_and_clear())?;
                    self.verdict = self.verdict.max(verdict);
                }
                Err(failure) => self.report_failure(failure),
            }
            self.bar.inc(1);
        }
        self.bar.finish_and_clear();
        Ok(self.verdict)
    }

    /// Writes to standard output, above the progress bar.
    pub fn say(&self, text: &str) -> Result<(), CommandFailure> {
        self.bar.suspend(|| say(text))
    }

    /// Reports a failure, but the same one only once: a wrong `chordal.toml` counts for every
    /// file of its folder.
    fn report_failure(&mut self, failure: LoadError) {
        let failure = CommandFailure::from(failure);
        self.verdict = self.verdict.max(failure.verdict());
        let text = self.terminal.failure_text(&failure);
        if !self.reported.contains(&text) {
            self.bar.suspend(|| self.terminal.write_error(&text));
            self.reported.insert(text);
        }
    }
}

/// A bar for several files, drawn on a terminal only and not for what takes no time.
fn progress(files: usize) -> ProgressBar {
    if files < 2 {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::with_draw_target(Some(files as u64), ProgressDrawTarget::stderr());
    if let Ok(style) = ProgressStyle::with_template("{bar:30} {pos}/{len} {wide_msg}") {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}
