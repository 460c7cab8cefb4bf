//! A program that is loaded: texts, machine, and why this machine.

use std::sync::Arc;

use chordal::control::{InterruptCheck, RunOptions, ShopCodes, ShopRecord};
use chordal::{Job, Machine, ProgramReading, ReadingChoices, Source, SourceMap};

use crate::error::LoadError;
use crate::machine_reason::MachineReason;
use crate::readings::ReadingPremise;
use crate::text::ProgramText;

/// A program with everything it needs to run.
pub struct Loaded {
    /// The program's text, then those of its subprograms.
    pub(crate) texts: Vec<ProgramText>,
    pub(crate) machine: Machine,
    pub(crate) options: RunOptions,
    /// Names and blocks of what the shop answered, in the order of the run.
    pub(crate) shop_texts: Vec<(String, String)>,
    /// The one program to run, where the request names it.
    pub program: Option<u32>,
    /// Why this machine.
    pub chosen: MachineReason,
    /// What was assumed, where the text does not name its control and its units for certain.
    pub premise: Option<ReadingPremise>,
}

impl Loaded {
    /// The name for people.
    pub fn name(&self) -> &str {
        self.texts[0].name()
    }

    /// The job, which borrows the texts.
    ///
    /// # Errors
    /// Settings that the control does not know; those of files were checked before.
    pub fn job(&self) -> Result<Job<'_>, LoadError> {
        self.job_on(self.machine.clone())
    }

    /// Runs the program once, so that the shop is asked about each of its codes; every later
    /// run finds these answers.
    pub(crate) fn ask_shop(
        &mut self,
        shop: Arc<dyn ShopCodes>,
        interrupt: Option<InterruptCheck>,
    ) -> Result<(), LoadError> {
        self.options.shop_codes = Some(Arc::new(ShopRecord::new(shop)));
        let job = self.job()?;
        let job = match interrupt {
            Some(interrupt) => job.interrupt(interrupt),
            None => job,
        };
        job.run(&mut ());
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

    /// Why it is this machine, in a line; nothing where the user said so.
    pub fn why(&self) -> Option<String> {
        self.chosen.why(chordal::control::table(self.machine.control).title)
    }

    /// Names and texts, the machine and the budgets.
    pub fn into_parts(self) -> (Vec<(String, Vec<u8>)>, Machine, RunOptions) {
        let texts = self.texts.into_iter().map(ProgramText::into_parts).collect();
        (texts, self.machine, self.options)
    }

    /// Bytes of the program's text.
    pub fn size(&self) -> usize {
        self.text().len()
    }

    /// The language of the text where it is one that is not read, as `fanuc-lathe`.
    pub fn not_read(&self) -> Option<&'static str> {
        let refused = self.options.not_read.is_some();
        self.chosen.recognition().filter(|_| refused).map(|found| found.chosen().name)
    }

    /// The name of its control, or of the language that is not read.
    pub fn control(&self) -> &'static str {
        self.not_read().unwrap_or_else(|| self.machine.control.as_str())
    }

    /// On what it is read, and why.
    pub fn reading(&self) -> ProgramReading<'_> {
        let machine = Some(self.machine.name.as_str()).filter(|_| self.not_read().is_none());
        ProgramReading {
            machine,
            control: self.control(),
            from: self.chosen.from(),
            recognition: self.chosen.recognition(),
            choices: self.choices(),
        }
    }

    /// As what else the text may be read; nothing where its control and its units are named or certain.
    pub fn choices(&self) -> Option<ReadingChoices> {
        self.premise.as_ref().map(ReadingPremise::choices)
    }

    /// Its machine.
    pub fn machine(&self) -> &Machine {
        &self.machine
    }

    /// The job on another machine.
    ///
    /// # Errors
    /// Settings of the machine that its control does not know.
    pub fn job_on(&self, machine: Machine) -> Result<Job<'_>, LoadError> {
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
            .map_err(|error| LoadError::Request { message: error.to_string(), help: None })?;
        Ok(job.program(self.program).options(self.options.clone()))
    }
}
