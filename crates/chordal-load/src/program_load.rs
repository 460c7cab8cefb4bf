//! A loaded program: its texts, its machine and the reason for this machine.

use std::sync::Arc;

use chordal::control::{InterruptCheck, control_title};
use chordal::{Job, Machine, ProgramReading, ReadingChoices, Source, SourceMap};
use chordal::{RunOptions, ShopCodes, ShopRecord};

use crate::error::LoadError;
use crate::machine_reason::MachineReason;
use crate::readings::ReadingPremise;
use crate::text::ProgramText;

/// A program with everything it needs to run.
pub struct Loaded {
    /// The text of the program, then the texts of its subprograms.
    pub(crate) texts: Vec<ProgramText>,
    pub(crate) machine: Machine,
    pub(crate) options: RunOptions,
    /// Names and blocks of the expanded shop codes, in the order of the run.
    pub(crate) shop_texts: Vec<(String, String)>,
    /// The number of the only program to run; `None` when the request names none.
    pub program: Option<u32>,
    /// Why this machine was chosen.
    pub chosen: MachineReason,
    /// What was assumed about the text; `None` when its control and its units are certain.
    pub premise: Option<ReadingPremise>,
}

impl Loaded {
    /// The program's name for messages.
    pub fn name(&self) -> &str {
        self.texts[0].name()
    }

    /// The job of running the program. It borrows the texts.
    ///
    /// # Errors The control does not know a setting of the machine. Settings from files were checked before.
    pub fn job(&self) -> Result<Job<'_>, LoadError> {
        self.job_on(self.machine.clone())
    }

    /// Runs the program once so that `shop` is called for each of the shop's own codes. Later runs reuse the recorded
    /// answers.
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

    /// Why this machine was chosen, in one line; `None` when the user or a `chordal.toml` names it.
    pub fn why(&self) -> Option<String> {
        self.chosen.why(control_title(self.machine.control))
    }

    /// Splits into names and texts, the machine, and the options of the run.
    pub fn into_parts(self) -> (Vec<(String, Vec<u8>)>, Machine, RunOptions) {
        let texts = self.texts.into_iter().map(ProgramText::into_parts).collect();
        (texts, self.machine, self.options)
    }

    /// The size of the program's text, bytes.
    pub fn size(&self) -> usize {
        self.text().len()
    }

    /// The name of the text's language when it is one that Chordal does not read, such as `fanuc-lathe`; `None`
    /// otherwise.
    pub fn not_read(&self) -> Option<&'static str> {
        let refused = self.options.not_read.is_some();
        self.chosen.recognition().filter(|_| refused).map(|found| found.chosen().name)
    }

    /// The name of the control, or of the language that Chordal does not read.
    pub fn control(&self) -> &'static str {
        self.not_read().unwrap_or_else(|| self.machine.control.as_str())
    }

    /// As what the text is read, and why.
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

    /// As what else the text could be read; `None` when its control and its units are named or certain.
    pub fn choices(&self) -> Option<ReadingChoices> {
        self.premise.as_ref().map(ReadingPremise::choices)
    }

    /// The program's machine.
    pub fn machine(&self) -> &Machine {
        &self.machine
    }

    /// The job of running the program on another machine.
    ///
    /// # Errors The control of this machine does not know one of its settings.
    pub fn job_on(&self, machine: Machine) -> Result<Job<'_>, LoadError> {
        let mut sources = SourceMap::new();
        for text in &self.texts {
            sources.add(Source::new(text.name(), text.bytes()));
        }
        // Added now so that locations in these texts can be shown before this job has run.
        for (name, text) in &self.shop_texts {
            sources.append(name, text);
        }
        // The settings were checked, with their locations, when the machine was chosen.
        let job = Job::new(sources, machine)
            .map_err(|error| LoadError::Request { message: error.to_string(), help: None })?;
        Ok(job.program(self.program).options(self.options.clone()))
    }
}
