//! A command over its input files: loads each with its machine, says what cannot be loaded
//! and goes on with the rest.

use std::collections::BTreeSet;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use chordal::control::{Control, Interrupt, RunOptions, ShopCodes, ShopRecord};
use chordal::syntax::find_programs;
use chordal::{Command, Diagnostic, Job, Machine, Sink, Source, SourceMap};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::beside::{self, Folders};
use crate::failure::{Failure, Verdict};
use crate::input::{self, Input, Text};
use crate::machine::{self, Chosen};
use crate::options::Common;
use crate::terminal::{Terminal, say};

/// A program with everything it needs to run.
pub struct Loaded {
    /// The program's text, then those of its subprograms.
    texts: Vec<Text>,
    machine: Machine,
    options: RunOptions,
    /// Names and blocks of what the shop answered, in the order of the run.
    shop_texts: Vec<(String, String)>,
    /// The one program to run, where the command line names it.
    pub program: Option<u32>,
    /// Why this machine.
    pub chosen: Chosen,
}

impl Loaded {
    /// The name for people.
    pub fn name(&self) -> &str {
        self.texts[0].name()
    }

    /// The job, which borrows the texts.
    pub fn job(&self) -> Result<Job<'_>, Failure> {
        self.job_on(self.machine.clone())
    }

    /// Runs the program once, so that the shop is asked about each of its codes; every later
    /// run finds these answers.
    pub(crate) fn ask_shop(
        &mut self,
        shop: Arc<dyn ShopCodes>,
        interrupt: Option<Interrupt>,
    ) -> Result<(), Failure> {
        self.options.shop_codes = Some(Arc::new(ShopRecord::new(shop)));
        let job = self.job()?;
        let job = match interrupt {
            Some(interrupt) => job.interrupt(interrupt),
            None => job,
        };
        job.run(&mut Unheard);
        let texts = job.sources().appended().map(|source| {
            (source.name().to_string(), String::from_utf8_lossy(source.text()).into_owned())
        });
        self.shop_texts = texts.collect();
        Ok(())
    }

    /// The program's text.
    pub fn text(&self) -> &[u8] {
        self.texts[0].bytes()
    }

    /// Names and texts, the machine and the budgets.
    pub(crate) fn into_parts(self) -> (Vec<(String, Vec<u8>)>, Machine, RunOptions) {
        let texts = self.texts.into_iter().map(Text::into_parts).collect();
        (texts, self.machine, self.options)
    }

    /// Bytes of the program's text.
    pub fn size(&self) -> usize {
        self.text().len()
    }

    /// Its machine.
    pub fn machine(&self) -> &Machine {
        &self.machine
    }

    /// The job on another machine.
    pub fn job_on(&self, machine: Machine) -> Result<Job<'_>, Failure> {
        let mut sources = SourceMap::new();
        for text in &self.texts {
            sources.add(Source::new(text.name(), text.bytes()));
        }
        // So that a place in them has its words before this job has run.
        for (name, text) in &self.shop_texts {
            sources.append(name, text);
        }
        // The settings were checked with their places when the machine was chosen.
        let job = Job::new(sources, machine)
            .map_err(|error| Failure::Use { message: error.to_string(), help: None })?;
        Ok(job.program(self.program).options(self.options.clone()))
    }
}

/// Hears nothing of a run.
struct Unheard;

impl Sink for Unheard {
    fn command(&mut self, _: &Command) {}
    fn diagnostic(&mut self, _: Diagnostic) {}
}

/// Loads a program, its machine and its subprograms.
fn load(
    input: &Input,
    given: Option<&Machine>,
    common: &Common,
    folders: &mut Folders,
) -> Result<Loaded, Failure> {
    load_text(Text::read(input)?, input, given, common, folders)
}

/// The same with the text of the input at hand.
pub(crate) fn load_text(
    text: Text,
    input: &Input,
    given: Option<&Machine>,
    common: &Common,
    folders: &mut Folders,
) -> Result<Loaded, Failure> {
    let (machine, chosen) = match given {
        Some(machine) => (machine.clone(), Chosen::Given),
        None => machine::choose(input, text.bytes(), common)?,
    };
    let (control, _) = Control::of(&machine);
    let lexicon = control.table.lexicon;
    if let Some(number) = common.program {
        has_program(&text, number, &find_programs(text.bytes(), &lexicon))?;
    }
    let mut texts = vec![text];
    if let Some(path) = input.path.as_ref().filter(|_| !control.parameters.calls_within_file) {
        let found = folders.find(path, texts[0].bytes(), &lexicon);
        texts.extend(found);
    }
    let mut options = RunOptions::default();
    if let Some(most) = common.max_blocks {
        options.max_repeated_blocks = most;
    }
    let shop_texts = Vec::new();
    Ok(Loaded { texts, machine, options, shop_texts, program: common.program, chosen })
}

/// Loads the one program of a command that takes one.
pub fn load_one(file: &PathBuf, common: &Common) -> Result<Loaded, Failure> {
    if file.is_dir() {
        return Err(Failure::wrong(
            format!("{} is a folder", file.display()),
            "this command takes one program; `run` and `check` also take folders",
        ));
    }
    let (inputs, _) = input::find(std::slice::from_ref(file));
    let Some(input) = inputs.first() else {
        return Err(Failure::Use { message: "there is no program".into(), help: None });
    };
    load(input, machine::given(common)?.as_ref(), common, &mut Folders::default())
}

fn has_program(
    text: &Text,
    number: u32,
    heads: &[chordal::syntax::ProgramHead],
) -> Result<(), Failure> {
    let numbers: Vec<u32> = heads.iter().filter_map(|head| head.number).collect();
    if numbers.contains(&number) {
        return Ok(());
    }
    let message = format!("there is no program O{number} in {}", text.name());
    let names: Vec<String> = numbers.iter().take(20).map(|number| format!("O{number}")).collect();
    let more = if numbers.len() > 20 { ", …" } else { "" };
    Err(match names.as_slice() {
        [] => Failure::wrong(message, "no program of this file has a number"),
        names => Failure::wrong(message, format!("it has {}{more}", names.join(", "))),
    })
}

/// A command over several inputs.
pub struct Session {
    terminal: Terminal,
    given: Option<Machine>,
    common: Common,
    inputs: Vec<Input>,
    called: u64,
    bar: ProgressBar,
    told: BTreeSet<String>,
    verdict: Verdict,
}

impl Session {
    /// Finds the inputs and reads the machine, if the command line names one.
    pub fn new(files: &[PathBuf], common: Common, terminal: Terminal) -> Result<Session, Failure> {
        let given = machine::given(&common)?;
        let (inputs, failures) = input::find(files);
        let found = inputs.len();
        let inputs = beside::without_called(inputs);
        let called = (found - inputs.len()) as u64;
        let bar = progress(inputs.len());
        let (told, verdict) = (BTreeSet::new(), Verdict::Clean);
        let mut session = Session { terminal, given, common, inputs, called, bar, told, verdict };
        failures.iter().for_each(|failure| session.tell(failure));
        Ok(session)
    }

    /// The inputs.
    pub fn inputs(&self) -> &[Input] {
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
        mut handle: impl FnMut(&Session, usize, &Loaded) -> Result<Verdict, Failure>,
    ) -> Result<Verdict, Failure> {
        let mut folders = Folders::default();
        for index in 0..self.inputs.len() {
            let input = &self.inputs[index];
            self.bar.set_message(input.name().into_owned());
            match load(input, self.given.as_ref(), &self.common, &mut folders) {
                Ok(loaded) => {
                    let done = handle(&self, index, &loaded);
                    let verdict = done.inspect_err(|_| self.bar.finish_and_clear())?;
                    self.verdict = self.verdict.max(verdict);
                }
                Err(failure) => self.tell(&failure),
            }
            self.bar.inc(1);
        }
        self.bar.finish_and_clear();
        Ok(self.verdict)
    }

    /// Writes to standard output, above the progress bar.
    pub fn say(&self, text: &str) -> Result<(), Failure> {
        self.bar.suspend(|| say(text))
    }

    /// Reports a failure, but the same one only once: a wrong `chordal.toml` counts for every
    /// file of its folder.
    fn tell(&mut self, failure: &Failure) {
        self.verdict = self.verdict.max(failure.verdict());
        let text = self.terminal.failure_text(failure);
        if !self.told.contains(&text) {
            self.bar.suspend(|| self.terminal.tell(&text));
            self.told.insert(text);
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
