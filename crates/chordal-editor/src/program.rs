//! A program as an editor holds it.

use std::sync::Arc;

use chordal::control::{ConfiguredControl, ControlProfile, SettingError, configured_control};
use chordal::diagnostics::FileId;
use chordal::{Job, Machine, Source, SourceMap};

use crate::checkpoints::RunCheckpoints;
use crate::setup::{EditorSetup, ValidSetup};

/// A text with its machine and the texts in which its subprograms may be.
#[derive(Debug)]
pub struct EditorProgram {
    source: Source<'static>,
    sound: Arc<ValidSetup>,
    pub(crate) checkpoints: RunCheckpoints,
}

impl EditorProgram {
    /// A program on a machine.
    ///
    /// # Errors
    /// Settings of the machine that its control does not know.
    pub fn new(
        name: impl Into<String>,
        text: Vec<u8>,
        machine: Machine,
    ) -> Result<EditorProgram, Vec<SettingError>> {
        EditorProgram::set_up(name, text, EditorSetup::of(machine))
    }

    /// A program with everything that it needs.
    ///
    /// # Errors
    /// Settings of the machine that its control does not know.
    pub fn set_up(
        name: impl Into<String>,
        text: Vec<u8>,
        setup: EditorSetup,
    ) -> Result<EditorProgram, Vec<SettingError>> {
        let Some((control, errors)) = configured_control(&setup.machine) else {
            let message = format!("the programs of `{}` are not read", setup.machine.control);
            return Err(vec![SettingError { name: "control".into(), message, help: None }]);
        };
        if !errors.is_empty() {
            return Err(errors);
        }
        let sound = Arc::new(ValidSetup { setup, control });
        Ok(EditorProgram {
            source: Source::new(name, text),
            sound,
            checkpoints: RunCheckpoints::default(),
        })
    }

    /// The same with another text.
    pub fn with_text(&self, text: Vec<u8>) -> EditorProgram {
        let source = Source::new(self.name(), text);
        EditorProgram { source, sound: self.sound.clone(), checkpoints: RunCheckpoints::default() }
    }

    /// What it runs with.
    pub fn setup(&self) -> &EditorSetup {
        &self.sound.setup
    }

    pub(crate) fn sound(&self) -> &Arc<ValidSetup> {
        &self.sound
    }

    /// The name that messages show.
    pub fn name(&self) -> &str {
        self.source.name()
    }

    /// The text.
    pub fn text(&self) -> &[u8] {
        self.source.text()
    }

    /// The text with its lines.
    pub fn source(&self) -> &Source<'static> {
        &self.source
    }

    /// The machine.
    pub fn machine(&self) -> &Machine {
        &self.setup().machine
    }

    /// The facts of its control.
    pub fn profile(&self) -> ControlProfile {
        self.sound.control.profile()
    }

    /// Its control, with the settings of the machine applied.
    pub fn configured_control(&self) -> &dyn ConfiguredControl {
        &*self.sound.control
    }

    /// The job, which borrows the texts. Its file 0 is this text, the others follow in order.
    pub fn job(&self) -> Job<'_> {
        let mut sources = SourceMap::new();
        sources.add(Source::new(self.name(), self.text()));
        let setup = self.setup();
        for (name, text) in &setup.subprogram_texts {
            sources.add(Source::new(name.as_str(), text.as_slice()));
        }
        // `new` has looked at the settings.
        let job = Job::new(sources, setup.machine.clone());
        let job = job.unwrap_or_else(|error| unreachable!("{error}"));
        job.program(setup.program).options(setup.options.clone())
    }

    /// The name of a text by its number in a job's spans.
    pub fn file_name(&self, file: FileId) -> &str {
        match (file.0 as usize).checked_sub(1) {
            None => self.name(),
            Some(index) => self.setup().subprogram_texts.get(index).map_or("", |(name, _)| name),
        }
    }

    /// The bytes of a text by its number in a job's spans.
    pub fn file_text(&self, file: FileId) -> &[u8] {
        match (file.0 as usize).checked_sub(1) {
            None => self.text(),
            Some(index) => self.setup().subprogram_texts.get(index).map_or(&[], |(_, text)| text),
        }
    }
}
