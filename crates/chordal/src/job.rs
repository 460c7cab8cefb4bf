//! A [`Job`]: a program on a machine, and its run.

use std::sync::{Arc, OnceLock};

use chordal_command::{AxisMask, WorkName};
use chordal_diagnostics::{Code, Diagnostic, FileId, Source, SourceMap, Span};
use chordal_dialect::{Control, Setting, SettingField};
use chordal_gcode::WordAddressControl;
use chordal_geometry::Placement;
use chordal_kernel::rules::Rules;
use chordal_kernel::{
    Checkpoint, CompletedRun, ConfiguredControl, ControlProfile, InterruptCheck, Outcome,
    ProgramPlace, ProgramSet, RunOptions, RunSink, SettingError,
};
use chordal_machine::{Machine, PerAxis};
use chordal_path::{PathBuilder, ProgramFrame, RunChecks};

use crate::languages::configured_control;
use crate::premises::RunPremises;

/// Why there is no job.
#[derive(Debug, thiserror::Error)]
pub enum JobError {
    /// The machine has settings that its control does not know.
    #[error("the control does not know {} settings of the machine", .0.len())]
    Settings(Vec<SettingError>),
    /// No language reads the programs of the machine's control.
    #[error("the programs of `{0}` are not read")]
    NoLanguage(&'static str),
}

/// A program and a machine.
///
/// ```
/// use chordal::{CommandKind, Job, Machine, Severity, Source, SourceMap};
///
/// let mut sources = SourceMap::new();
/// let text = b"G21 G90 S900 M3\nG1 X0 Y0 F600.\nX60.\nG2 X80. Y0 I9. J0\nM30\n";
/// sources.add(Source::new("part.nc", text.as_slice()));
/// let job = Job::new(sources, Machine::from_builtin("haas-vf2").unwrap()).unwrap();
///
/// // Problems, as `chordal check` reports them: the arc's radii differ.
/// let errors: Vec<_> =
///     job.check().diagnostics.into_iter().filter(|d| d.severity == Severity::Error).collect();
/// assert_eq!(errors[0].code.info().id, "CH401");
///
/// // Every command, with the block it comes from.
/// let mut lines = 0_u32;
/// let report = job.report_of_commands(|command| {
///     lines += u32::from(matches!(command.kind, CommandKind::Line { .. }));
/// });
/// assert_eq!((report.summary.lines, lines), (2, 2));
///
/// // The path as exact curves.
/// let mut length_mm = 0.0;
/// job.path(|segment| length_mm += segment.length_mm);
/// assert!(length_mm > 60.0);
/// ```
#[derive(Debug)]
pub struct Job<'a> {
    sources: SourceMap<'a>,
    machine: Machine,
    control: Arc<dyn ConfiguredControl>,
    options: RunOptions,
    program: Option<ProgramChoice>,
    /// What was found out before the run, once somebody needed it.
    pub(crate) ahead: OnceLock<RunPremises>,
}

/// Which program of the first text is run.
#[derive(Clone, Copy, Debug)]
enum ProgramChoice {
    /// The one with this number.
    Number(u32),
    /// The one at this place among the programs of the text.
    Place(usize),
}

impl<'a> Job<'a> {
    /// Makes a job of texts and a machine. The first text is the program; the others may hold its subprograms.
    ///
    /// # Errors
    /// When the machine has settings that its control does not know.
    pub fn new(sources: SourceMap<'a>, mut machine: Machine) -> Result<Job<'a>, JobError> {
        let found = configured_control(&machine);
        let (control, errors) = found.ok_or(JobError::NoLanguage(machine.control.as_str()))?;
        if !errors.is_empty() {
            return Err(JobError::Settings(errors));
        }
        machine.take_designations(control.rules().turning.tips_mirrored);
        let (options, ahead) = (RunOptions::default(), OnceLock::new());
        Ok(Job { sources, machine, control, options, program: None, ahead })
    }

    /// The same job with another first text.
    pub fn with_text(&self, text: Vec<u8>) -> Job<'static> {
        let mut sources = SourceMap::new();
        let mut first = Some(text);
        for (_, source) in self.sources.iter() {
            let text = first.take().unwrap_or_else(|| source.text().to_vec());
            sources.add(Source::new(source.name(), text));
        }
        self.with_sources(sources)
    }

    /// The same job with block delete switched the other way.
    pub(crate) fn with_other_block_delete(mut self) -> Job<'a> {
        let switches = &mut self.machine.switches.block_delete;
        *switches = [!switches.contains(&true); 10];
        self.ahead = OnceLock::new();
        self
    }

    /// The same job on another machine.
    ///
    /// # Errors
    /// When no language reads the programs of the machine's control, or the control does not know a setting.
    pub fn on_machine(&self, machine: Machine) -> Result<Job<'_>, JobError> {
        let mut sources = SourceMap::new();
        for (_, source) in self.sources.iter() {
            sources.add(Source::new(source.name(), source.text()));
        }
        let job = Job::new(sources, machine)?;
        Ok(Job { options: self.options.clone(), program: self.program, ..job })
    }

    /// The same job with other texts.
    pub(crate) fn with_sources<'s>(&self, sources: SourceMap<'s>) -> Job<'s> {
        Job {
            sources,
            machine: self.machine.clone(),
            control: self.control.clone(),
            options: self.options.clone(),
            program: self.program,
            ahead: OnceLock::new(),
        }
    }

    /// Runs only the program with this number; all main programs where it is `None`.
    pub fn program(mut self, number: Option<u32>) -> Job<'a> {
        self.program = number.map(ProgramChoice::Number);
        self.ahead = OnceLock::new();
        self
    }

    /// Runs only the program at this place of [`Job::programs`], numbered or not. Where there is
    /// none, nothing is run.
    pub fn program_at(mut self, place: usize) -> Job<'a> {
        self.program = Some(ProgramChoice::Place(place));
        self.ahead = OnceLock::new();
        self
    }

    /// The programs of the first text in order, with those that a run begins with marked. A text
    /// without any head is one program.
    pub fn programs(&self) -> Vec<ProgramPlace> {
        own_programs(&*self.program_set()).cloned().collect()
    }

    /// Replaces the options of the run, such as its budgets.
    pub fn options(mut self, options: RunOptions) -> Job<'a> {
        self.options = options;
        self.ahead = OnceLock::new();
        self
    }

    /// Sets a check that ends a run early when it returns true; the outcome is then `EndReason::Interrupted`.
    pub fn interrupt(mut self, interrupt: InterruptCheck) -> Job<'a> {
        self.options.interrupt = Some(interrupt);
        self
    }

    /// Whether the run is to end early.
    pub(crate) fn is_interrupted(&self) -> bool {
        self.options.interrupt.as_ref().is_some_and(|interrupt| interrupt())
    }

    /// The texts.
    pub fn sources(&self) -> &SourceMap<'a> {
        &self.sources
    }

    /// The machine.
    pub fn machine(&self) -> &Machine {
        &self.machine
    }

    /// The control, with the settings of the machine applied.
    pub fn configured_control(&self) -> &dyn ConfiguredControl {
        &*self.control
    }

    /// The facts of the control that do not depend on the machine.
    pub fn profile(&self) -> ControlProfile {
        self.control.profile()
    }

    /// The rules of the control with the settings of the machine.
    pub fn rules(&self) -> &Rules {
        self.control.rules()
    }

    /// The axes of the machine.
    pub fn axes(&self) -> AxisMask {
        self.control.axes()
    }

    /// The control with its tables, for what works on word-address blocks only; `None` when its programs are written
    /// in another language.
    pub fn word_address(&self) -> Option<&Control> {
        WordAddressControl::tables(&*self.control)
    }

    /// The control's own setting of a rule; `None` where it has none, or no settings of its own.
    pub fn own_setting(&self, field: SettingField) -> Option<&'static Setting> {
        let settings = self.word_address()?.table.settings;
        settings.iter().find(|setting| setting.field == field)
    }

    /// The chords into which the control itself divides arcs: their largest distance from the arc, mm, and on which
    /// side of it they lie; `None` where the control is not known to divide arcs, or divides them by length.
    pub fn own_chords(&self) -> Option<(f64, Placement)> {
        let junctions = self.rules().path.junctions?;
        // Segments of a fixed length have no one distance: they are farther from a small arc than from a large one.
        junctions
            .arc_segments
            .is_none()
            .then_some((junctions.arc_tolerance_mm, Placement::RoundedDown))
    }

    /// Runs the main programs of the first text, one after the other, and pushes commands and diagnostics into a
    /// sink. Commands are the programmed ones, before cutter compensation.
    pub fn run<S: RunSink>(&self, sink: &mut S) -> Vec<Outcome> {
        self.run_each(sink, |_, _, _| {})
    }

    /// Like [`Job::run`]; `ended` is called at the end of each program.
    pub(crate) fn run_each<S: RunSink>(
        &self,
        sink: &mut S,
        mut ended: impl FnMut(&mut S, &Outcome, Span),
    ) -> Vec<Outcome> {
        if !self.is_readable(sink) {
            return Vec::new();
        }
        let programs = self.program_set();
        self.before_run(&*programs).for_each(|diagnostic| sink.diagnostic(diagnostic));
        let mut outcomes = Vec::new();
        let mains = self.mains(&*programs);
        let heads = |program: usize| match mains.len() {
            // What concerns the only program concerns the whole text, and has no place in it.
            1 => Span::default(),
            _ => {
                programs.programs().get(program).map_or_else(Span::default, ProgramPlace::head_span)
            }
        };
        for program in mains.iter().copied() {
            let Some(CompletedRun { outcome, .. }) = programs.run(program, None, sink) else {
                continue;
            };
            ended(sink, &outcome, heads(program));
            outcomes.push(outcome);
        }
        if outcomes.iter().all(|outcome| outcome.blocks == 0) {
            sink.diagnostic(no_block());
        }
        outcomes
    }

    /// What is reported before the first block: what was assumed about the text and the files next to it, tool tips
    /// that were assumed, and programs with the same number.
    pub(crate) fn before_run(&self, programs: &dyn ProgramSet) -> impl Iterator<Item = Diagnostic> {
        let mut heads = programs.head_problems();
        heads.retain(|each| self.is_about(programs, each));
        self.options.notes.iter().cloned().chain(usual_tips(&self.machine)).chain(heads)
    }

    /// False for the problem of a program's head where only another program is run.
    fn is_about(&self, programs: &dyn ProgramSet, diagnostic: &Diagnostic) -> bool {
        let Some(ProgramChoice::Place(place)) = self.program else { return true };
        let at = diagnostic.primary.span.range.start;
        programs.programs().get(place).is_some_and(|program| program.has(at))
    }

    fn is_readable<S: RunSink>(&self, sink: &mut S) -> bool {
        if chordal_syntax::decode(self.text()).binary {
            sink.diagnostic(
                Diagnostic::new(
                    Code::NotAProgram,
                    Span::default(),
                    "the file holds binary data, not an NC program",
                )
                .help("give the program's text file"),
            );
            return false;
        }
        if let Some(reason) = &self.options.not_read {
            sink.diagnostic(reason.as_ref().clone());
            return false;
        }
        true
    }

    /// Runs, from a checkpoint on if there is one, and gives the sink checkpoints. Returns false and runs nothing
    /// where there are several programs to run, or where the caller answers shop codes or macro calls: such a run has
    /// no checkpoints.
    pub fn run_on(&self, from: Option<&Checkpoint>, sink: &mut dyn RunSink) -> bool {
        let Some((programs, main)) = self.single_main() else { return false };
        programs.run(main, from, sink);
        true
    }

    /// The program that is run; `None` where there is not exactly one, or where the caller answers it while it runs.
    pub(crate) fn single_main(&self) -> Option<(Box<dyn ProgramSet + '_>, usize)> {
        let readable = !chordal_syntax::decode(self.text()).binary;
        let needs_answers = self.options.shop_codes.is_some() || self.machine.answers_with_blocks();
        if !readable || needs_answers || self.options.not_read.is_some() {
            return None;
        }
        let programs = self.program_set();
        match self.mains(&*programs)[..] {
            [main] if programs.needs_caller(main) => None,
            [main] => Some((programs, main)),
            _ => None,
        }
    }

    pub(crate) fn run_options(&self) -> &RunOptions {
        &self.options
    }

    /// The programs of the texts, in the language of the control.
    pub fn program_set(&self) -> Box<dyn ProgramSet + '_> {
        self.program_set_with(&self.options)
    }

    /// The same with other options of the run.
    pub(crate) fn program_set_with<'s>(
        &'s self,
        options: &'s RunOptions,
    ) -> Box<dyn ProgramSet + 's> {
        self.control.open(&self.sources, &self.machine, options)
    }

    /// The indices of the programs that a run begins with.
    pub fn mains(&self, programs: &dyn ProgramSet) -> Vec<usize> {
        match self.program {
            Some(ProgramChoice::Number(number)) => programs.find(number).into_iter().collect(),
            Some(ProgramChoice::Place(place)) => {
                let is_there = own_programs(programs).nth(place).is_some();
                is_there.then_some(place).into_iter().collect()
            }
            None => {
                let own = own_programs(programs).enumerate();
                own.filter(|(_, program)| program.is_main).map(|(index, _)| index).collect()
            }
        }
    }

    /// The first text.
    pub(crate) fn text(&self) -> &[u8] {
        self.sources.get(FileId(0)).map_or(&[], |source| source.text())
    }

    /// True where nobody named the machine, so that its limits are a guess.
    pub fn has_assumed_machine(&self) -> bool {
        self.options.assumed_machine
    }

    /// The checks of the path of one run of this job.
    pub(crate) fn checks(&self) -> RunChecks<'_> {
        let (offset, known) = self.initial_offset();
        let rules = self.rules();
        RunChecks::new(self.machine(), offset, known, rules.units)
            .assumed(self.has_assumed_machine())
            .with_tool_lengths(rules.length)
            .with_speed_limit_example(rules.turning.speed_limit_example)
            .with_alarms(self.profile().alarms())
    }

    /// The builder that makes the path of one run of this job from its commands.
    pub fn path_builder(&self) -> PathBuilder<'_> {
        let frame = self.initial_frame();
        PathBuilder::new(self.machine(), frame.work, frame.known)
            .in_system(frame.name)
            .in_run_frame(self.run_frame())
            .without_names(self.ahead().not_named)
            .with_tool_lengths(self.rules().length)
    }

    /// What lies between program and machine coordinates before the first block.
    pub(crate) fn initial_frame(&self) -> ProgramFrame {
        let (offset, known) = self.initial_offset();
        ProgramFrame::new(offset, known).in_system(self.initial_work_offset())
    }

    /// The work coordinate system before the first block.
    pub fn initial_work_offset(&self) -> WorkName {
        self.control.initial_work_offset()
    }

    /// The offset between program and machine coordinates before the first block (mm, rad), and the axes for which
    /// the machine file gives it.
    pub fn initial_offset(&self) -> (PerAxis<f64>, AxisMask) {
        self.control.initial_offset(&self.machine)
    }
}

/// The programs of the first text.
fn own_programs(programs: &dyn ProgramSet) -> impl Iterator<Item = &ProgramPlace> {
    programs.programs().iter().take_while(|program| program.file == FileId(0))
}

/// The problem of a text without a block.
pub(crate) fn no_block() -> Diagnostic {
    Diagnostic::new(Code::EmptyProgram, Span::default(), "there is no block to run")
}

/// Reports tools without a tip number, for which the usual mounting of their holder is taken.
fn usual_tips(machine: &Machine) -> impl Iterator<Item = Diagnostic> {
    machine.tools.iter().filter(|(_, tool)| tool.turning.has_usual_tip).filter_map(
        |(number, tool)| {
            let tip = tool.tip?;
            let holder = &tool.turning.holder_designation.as_ref()?.text;
            let message = format!(
                "tool {number} has no `tip`: {tip} is taken, the usual one of its holder {holder}"
            );
            let help = format!("give `[tools.{number}] tip` in the machine file");
            Some(Diagnostic::new(Code::UsualTip, Span::default(), message).help(help))
        },
    )
}
