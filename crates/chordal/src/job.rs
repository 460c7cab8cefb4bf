use chordal_control::{
    AxisMask, Command, CommandKind, Control, Interrupt, Library, Origin, Outcome, Rest, RunOptions,
    SettingError, Sink, initial_offset, run_from,
};
use chordal_diagnostics::{
    Code, Collector, Counts, Diagnostic, FileId, Severity, Source, SourceMap, Span,
};
use chordal_machine::Machine;
use chordal_path::{Checks, PathBuilder, PathCommand, Segment};
use chordal_syntax::ProgramHead;

use crate::compensated::Compensated;
use crate::motion::{
    LimitError, MachineLimits, MotionBuilder, MotionOptions, MotionReport, MotionSink, PlanSink,
    Planning,
};
use crate::recheck::CheckMemory;
use crate::summary::{Summary, SummaryBuilder};

/// Why there is no job.
#[derive(Debug, thiserror::Error)]
pub enum JobError {
    /// Settings of the machine that its control does not have.
    #[error("the control does not know {} settings of the machine", .0.len())]
    Settings(Vec<SettingError>),
}

/// How many diagnostics of one code are kept.
pub(crate) const KEPT_PER_CODE: usize = 200;

/// A program and a machine.
#[derive(Debug)]
pub struct Job<'a> {
    sources: SourceMap<'a>,
    machine: Machine,
    control: Control,
    options: RunOptions,
    program: Option<Chosen>,
}

/// Which program of the first text is run.
#[derive(Clone, Copy, Debug)]
enum Chosen {
    /// The one of this number.
    Number(u32),
    /// The one at this place among the programs of the text.
    Place(usize),
}

/// A program of the first text, as [`Job::programs`] says it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TextProgram {
    /// Its head and its range in the text.
    pub head: ProgramHead,
    /// A run begins with it; others are run where they are called.
    pub is_main: bool,
}

/// What a run reports in addition to its commands.
#[derive(Clone, Debug)]
pub struct Report {
    /// Numbers for people.
    pub summary: Summary,
    /// Problems by place: file, then line, as an editor lists them; those of one place in the
    /// order of the run.
    pub diagnostics: Vec<Diagnostic>,
    /// Problems that were reported but not kept, by code.
    pub dropped: Vec<(Code, u64)>,
    /// All problems counted.
    pub counts: Counts,
    /// The lines that the program printed (DPRNT), in order.
    pub output: Vec<String>,
    /// How each program that was run ended.
    pub outcomes: Vec<Outcome>,
}

impl<'a> Job<'a> {
    /// A job of texts and a machine. The first text is the program; the others are where
    /// its subprograms may be.
    ///
    /// # Errors
    /// When the machine has settings that its control does not know.
    pub fn new(sources: SourceMap<'a>, machine: Machine) -> Result<Job<'a>, JobError> {
        let (control, errors) = Control::of(&machine);
        if !errors.is_empty() {
            return Err(JobError::Settings(errors));
        }
        Ok(Job { sources, machine, control, options: RunOptions::default(), program: None })
    }

    /// The same job with another first text.
    pub fn with_text(&self, text: Vec<u8>) -> Job<'static> {
        let mut sources = SourceMap::new();
        let mut first = Some(text);
        for (_, source) in self.sources.iter() {
            let text = first.take().unwrap_or_else(|| source.text().to_vec());
            sources.add(Source::new(source.name(), text));
        }
        Job {
            sources,
            machine: self.machine.clone(),
            control: self.control.clone(),
            options: self.options.clone(),
            program: self.program,
        }
    }

    /// Runs only the program of this number.
    pub fn program(mut self, number: Option<u32>) -> Job<'a> {
        self.program = number.map(Chosen::Number);
        self
    }

    /// Runs only the program at this place of [`Job::programs`], numbered or not. Where there is
    /// none, nothing is run.
    pub fn program_at(mut self, place: usize) -> Job<'a> {
        self.program = Some(Chosen::Place(place));
        self
    }

    /// The programs of the first text in order, with those that a run begins with marked. A text
    /// without any head is one program.
    pub fn programs(&self) -> Vec<TextProgram> {
        let lexicon = &self.control.table.lexicon;
        let library = Library::new(&self.sources, lexicon);
        let mains = library.mains(lexicon, &self.control.alias_programs());
        let programs = library.programs().iter().take_while(|program| program.file == FileId(0));
        programs
            .enumerate()
            .map(|(place, program)| TextProgram {
                head: program.head,
                is_main: mains.binary_search(&place).is_ok(),
            })
            .collect()
    }

    /// Other budgets than the usual ones.
    pub fn options(mut self, options: RunOptions) -> Job<'a> {
        self.options = options;
        self
    }

    /// Ends a run early when it says so; the outcome is then `EndReason::Interrupted`.
    pub fn interrupt(mut self, interrupt: Interrupt) -> Job<'a> {
        self.options.interrupt = Some(interrupt);
        self
    }

    /// The texts.
    pub fn sources(&self) -> &SourceMap<'a> {
        &self.sources
    }

    /// The machine.
    pub fn machine(&self) -> &Machine {
        &self.machine
    }

    /// The control with its parameters.
    pub fn control(&self) -> &Control {
        &self.control
    }

    /// Runs the main programs of the first text, one after the other, and pushes commands
    /// and diagnostics into a sink: the programmed ones, before cutter compensation.
    pub fn run<S: Sink>(&self, sink: &mut S) -> Vec<Outcome> {
        self.run_each(sink, |_, _| {})
    }

    /// The same, and says when a program has ended.
    pub(crate) fn run_each<S: Sink>(
        &self,
        sink: &mut S,
        mut ended: impl FnMut(&mut S, &Outcome),
    ) -> Vec<Outcome> {
        if !self.is_readable(sink) {
            return Vec::new();
        }
        let library = Library::new(&self.sources, &self.control.table.lexicon);
        self.duplicates(&library).for_each(|diagnostic| sink.diagnostic(diagnostic));
        let mut outcomes = Vec::new();
        for program in self.mains(&library) {
            let outcome = chordal_control::run(
                &library,
                program,
                &self.machine,
                &self.control,
                &self.options,
                sink,
            );
            ended(sink, &outcome);
            outcomes.push(outcome);
        }
        if outcomes.iter().all(|outcome| outcome.blocks == 0) {
            sink.diagnostic(no_block());
        }
        outcomes
    }

    pub(crate) fn duplicates(&self, library: &Library) -> impl Iterator<Item = Diagnostic> {
        library.duplicate_diagnostics().filter(|each| self.is_about(library, each))
    }

    /// False for problems of a program's head where only another program is run.
    fn is_about(&self, library: &Library, diagnostic: &Diagnostic) -> bool {
        let Some(Chosen::Place(place)) = self.program else { return true };
        let at = diagnostic.primary.span.range.start;
        library
            .programs()
            .get(place)
            .is_some_and(|program| at >= program.head.start.offset && at < program.head.end)
    }

    fn is_readable<S: Sink>(&self, sink: &mut S) -> bool {
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
        true
    }

    /// Runs and pushes the exact path, segment by segment, in one frame.
    pub fn path(&self, push: impl FnMut(&Segment)) -> Vec<Outcome> {
        let (offset, known) = self.initial_offset();
        let builder = PathBuilder::new(&self.machine, offset, known);
        let (outcomes, _) = Compensated::run(self, PathSegments { builder, push });
        outcomes
    }

    /// Runs and pushes everything that cutter compensation makes: the commands of the tool
    /// centre, problems, and the compensated contours; with another radius than the offset
    /// table's, where one is given, mm.
    pub fn compensated<S: chordal_path::PathSink>(
        &self,
        radius_mm: Option<f64>,
        sink: &mut S,
    ) -> Vec<Outcome> {
        Compensated::run_with(self, radius_mm, None, sink).0
    }

    /// Runs with all checks and sums up; `observe` sees every command of the tool centre and
    /// its segments on the way.
    pub fn report_with(&self, mut observe: impl FnMut(&Command, &[Segment])) -> Report {
        self.report_of_path(|path, segments| observe(path.command, segments))
    }

    /// The same with what compensation did.
    pub fn report_of_path(&self, observe: impl FnMut(PathCommand<'_>, &[Segment])) -> Report {
        struct Path<F>(F);
        impl<F: FnMut(PathCommand<'_>, &[Segment])> Watch for Path<F> {
            fn path(&mut self, command: PathCommand<'_>, segments: &[Segment]) {
                (self.0)(command, segments);
            }
        }
        self.report_watched(&mut Path(observe))
    }

    /// Runs with all checks and sums up; `observe` sees every command as programmed, before
    /// cutter compensation.
    pub fn report_of_commands(&self, observe: impl FnMut(&Command)) -> Report {
        struct Programmed<F>(F);
        impl<F: FnMut(&Command)> Watch for Programmed<F> {
            fn programmed(&mut self, command: &Command) {
                (self.0)(command);
            }
        }
        self.report_watched(&mut Programmed(observe))
    }

    /// Runs with all checks and sums up, watched.
    pub fn report_watched(&self, watch: &mut impl Watch) -> Report {
        let sink = ReportSink::new(self, watch);
        let (outcomes, sink) = Compensated::judge(self, sink);
        sink.finish(outcomes)
    }

    /// Runs with all checks and sums up.
    pub fn report(&self) -> Report {
        self.report_with(|_, _| {})
    }

    /// Runs with the checks only: what `chordal check` asks.
    pub fn check(&self) -> Report {
        let sink = CheckSink::new(self, Collector::new(KEPT_PER_CODE));
        let (outcomes, sink) = Compensated::judge(self, sink);
        let CheckSink { mut checks, notes: mut collector, output } = sink;
        checks.finish(|diagnostic| collector.push(diagnostic));
        Report::new(Summary::default(), collector, output, outcomes)
    }

    /// The same after a change of the first text, with what the check before remembers: only
    /// what the change may touch is run. The machine, the options and the other texts must be
    /// those of that check.
    pub fn check_again(&self, memory: &mut CheckMemory) -> Report {
        match self.single_main() {
            Some((library, main)) => memory.check(self, &library, main),
            None => {
                memory.forget();
                self.check()
            }
        }
    }

    /// Runs, from a rest on where one is given, and reports rests to the sink. False, and nothing is
    /// run, where there are several programs to run or the shop is asked: then there are none.
    pub fn run_on(&self, rest: Option<&Rest>, sink: &mut dyn Sink) -> bool {
        let Some((library, main)) = self.single_main() else { return false };
        run_from(&library, main, &self.machine, &self.control, &self.options, sink, rest);
        true
    }

    /// The program that is run, where it is one, and nobody is asked on the way.
    fn single_main(&self) -> Option<(Library<'_>, usize)> {
        let readable = !chordal_syntax::decode(self.text()).binary;
        if !readable || self.options.shop_codes.is_some() {
            return None;
        }
        let library = Library::new(&self.sources, &self.control.table.lexicon);
        match self.mains(&library)[..] {
            [main] => Some((library, main)),
            _ => None,
        }
    }

    fn mains(&self, library: &Library) -> Vec<usize> {
        match self.program {
            Some(Chosen::Number(number)) => library.find(number, FileId(0)).into_iter().collect(),
            Some(Chosen::Place(place)) => {
                let programs = library.programs();
                let is_there = programs.get(place).is_some_and(|program| program.file == FileId(0));
                is_there.then_some(place).into_iter().collect()
            }
            None => library.mains(&self.control.table.lexicon, &self.control.alias_programs()),
        }
    }

    /// The first text.
    pub(crate) fn text(&self) -> &[u8] {
        self.sources.get(FileId(0)).map_or(&[], |source| source.text())
    }

    pub(crate) fn run_options(&self) -> &RunOptions {
        &self.options
    }

    /// Runs and emits the moves of the machine and its waits, as a planner takes them.
    ///
    /// # Errors
    /// A limit of an axis that is not a positive number.
    pub fn motion<S: MotionSink>(
        &self,
        options: &MotionOptions,
        sink: S,
    ) -> Result<(MotionReport, S), LimitError> {
        let limits = MachineLimits::of(&self.machine)?;
        let builder = MotionBuilder::new(self, limits, options, sink);
        let (outcomes, builder) = Compensated::run(self, builder);
        Ok(builder.finish(outcomes))
    }

    /// Runs and plans: emits the steps of the machine as they become certain.
    ///
    /// # Errors
    /// A limit of an axis that is not a positive number.
    pub fn plan<S: PlanSink>(
        &self,
        options: &MotionOptions,
        sink: &mut S,
    ) -> Result<MotionReport, LimitError> {
        let planning = Planning::new(MachineLimits::of(&self.machine)?, options, sink);
        let (report, planning) = self.motion(options, planning)?;
        planning.finish();
        Ok(report)
    }

    pub(crate) fn initial_offset(&self) -> ([f64; 6], AxisMask) {
        initial_offset(&self.machine, &self.control)
    }
}

/// The problem of a text without a block.
pub(crate) fn no_block() -> Diagnostic {
    Diagnostic::new(Code::EmptyProgram, Span::default(), "there is no block to run")
}

impl Report {
    pub(crate) fn new(
        summary: Summary,
        collector: Collector,
        output: Vec<String>,
        outcomes: Vec<Outcome>,
    ) -> Report {
        Report {
            summary,
            output,
            dropped: collector.dropped().collect(),
            counts: collector.counts(),
            diagnostics: collector.into_sorted(),
            outcomes,
        }
    }

    /// The gravest severity that occurred.
    pub fn worst(&self) -> Option<Severity> {
        match self.counts {
            Counts { errors: 1.., .. } => Some(Severity::Error),
            Counts { warnings: 1.., .. } => Some(Severity::Warning),
            Counts { notes: 1.., .. } => Some(Severity::Note),
            _ => None,
        }
    }
}

/// Sees a run go by.
pub trait Watch {
    /// A command as programmed, before cutter compensation.
    fn programmed(&mut self, _command: &Command) {}
    /// A command of the tool centre and its piece of path.
    fn path(&mut self, _command: PathCommand<'_>, _segments: &[Segment]) {}
}

struct PathSegments<'m, F> {
    builder: PathBuilder<'m>,
    push: F,
}

impl<F: FnMut(&Segment)> chordal_path::PathSink for PathSegments<'_, F> {
    fn command(&mut self, path: PathCommand<'_>) {
        self.builder.command(path.command, &mut self.push);
    }

    fn diagnostic(&mut self, _: Diagnostic, _: &Origin) {}
}

/// Notes a line that the program prints.
fn note_output(command: &Command, output: &mut Vec<String>) {
    if let CommandKind::Output { text } = &command.kind {
        output.push(text.clone());
    }
}

/// Takes the problems of a check.
pub(crate) trait Notes {
    /// One problem.
    fn note(&mut self, diagnostic: Diagnostic);
}

impl Notes for Collector {
    fn note(&mut self, diagnostic: Diagnostic) {
        self.push(diagnostic);
    }
}

/// Runs the checks only.
pub(crate) struct CheckSink<'m, N> {
    pub checks: Checks<'m>,
    pub notes: N,
    pub output: Vec<String>,
}

impl<'m, N> CheckSink<'m, N> {
    pub fn new(job: &'m Job<'_>, notes: N) -> CheckSink<'m, N> {
        let (offset, known) = job.initial_offset();
        let checks = Checks::new(&job.machine, offset, known, job.control.parameters.units);
        CheckSink { checks, notes, output: Vec::new() }
    }
}

impl<N: Notes> chordal_path::PathSink for CheckSink<'_, N> {
    #[inline]
    fn programmed(&mut self, command: &Command) {
        self.checks.programmed(command, |diagnostic| self.notes.note(diagnostic));
    }

    #[inline]
    fn command(&mut self, path: PathCommand<'_>) {
        self.checks.command(path, |diagnostic| self.notes.note(diagnostic));
        note_output(path.command, &mut self.output);
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic, _: &Origin) {
        self.notes.note(diagnostic);
    }
}

/// Checks, sums up and lets a run be watched.
pub(crate) struct ReportSink<'m, 'w, W> {
    builder: PathBuilder<'m>,
    checks: Checks<'m>,
    summary: SummaryBuilder,
    collector: Collector,
    output: Vec<String>,
    segments: Vec<Segment>,
    watch: &'w mut W,
}

impl<W: Watch> chordal_path::PathSink for ReportSink<'_, '_, W> {
    fn programmed(&mut self, command: &Command) {
        self.checks.programmed(command, |diagnostic| self.collector.push(diagnostic));
        self.watch.programmed(command);
    }

    fn command(&mut self, path: PathCommand<'_>) {
        let command = path.command;
        self.checks.command(path, |diagnostic| self.collector.push(diagnostic));
        note_output(command, &mut self.output);
        self.segments.clear();
        let segments = &mut self.segments;
        self.builder.command(command, |segment| segments.push(*segment));
        self.summary.command(command, &self.segments);
        self.watch.path(path, &self.segments);
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic, _: &Origin) {
        self.collector.push(diagnostic);
    }
}

impl<'m, 'w, W> ReportSink<'m, 'w, W> {
    pub fn new(job: &'m Job<'_>, watch: &'w mut W) -> ReportSink<'m, 'w, W> {
        let (offset, known) = job.initial_offset();
        let units = job.control.parameters.units;
        ReportSink {
            builder: PathBuilder::new(&job.machine, offset, known),
            checks: Checks::new(&job.machine, offset, known, units),
            summary: SummaryBuilder::new(&job.control),
            collector: Collector::new(KEPT_PER_CODE),
            output: Vec::new(),
            segments: Vec::new(),
            watch,
        }
    }

    pub fn finish(mut self, outcomes: Vec<Outcome>) -> Report {
        let collector = &mut self.collector;
        self.checks.finish(|diagnostic| collector.push(diagnostic));
        Report::new(self.summary.finish(), self.collector, self.output, outcomes)
    }
}
