//! The report of a run with its checks: problems, and numbers for people.

use chordal_command::{Command, CommandKind, Origin};
use chordal_diagnostics::{Code, Collector, Diagnostic, Severity, SeverityCounts, SourceMap, Span};
use chordal_kernel::Outcome;
use chordal_path::{PathBuilder, PathCommand, RunChecks, Segment};

use crate::compensation_sink::CompensationSink;
use crate::job::Job;
use crate::motion::PlacedPartFrame;
use crate::summary::{Summary, SummaryBuilder};
use crate::tool_comments::contradicted_tools;

/// How many diagnostics of one code are kept by default.
pub const KEPT_PER_CODE: usize = 200;

/// How many are kept of each code where every place is requested: enough for long programs, and still bounded in
/// memory.
pub const EVERY_PLACE: usize = 100_000;

/// Which alternative branches were run in addition to the first run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OtherSides {
    /// The conditions whose other side was run, too.
    pub run: Vec<Span>,
    /// The conditions whose other side was not run, because there are too many.
    pub left_out: Vec<Span>,
    /// True where one run had block delete switched the other way.
    pub block_delete: bool,
}

impl OtherSides {
    /// True where no condition was open.
    pub fn is_empty(&self) -> bool {
        self.count() == 0 && self.left_out.is_empty()
    }

    /// How many runs there were in addition to the first.
    pub fn count(&self) -> usize {
        self.run.len() + usize::from(self.block_delete)
    }
}

/// What a run reports in addition to its commands.
#[derive(Clone, Debug)]
pub struct Report {
    /// Counts, lengths and times of the run.
    pub summary: Summary,
    /// Problems by place: file, then line, as an editor lists them; those of one place in the
    /// order of the run.
    pub diagnostics: Vec<Diagnostic>,
    /// Problems that were reported but not kept, by code.
    pub dropped: Vec<(Code, u64)>,
    /// Number of problems by severity, those not kept included.
    pub counts: SeverityCounts,
    /// Where the run first came to something that is not simulated, or that depends on a value nobody gave: from
    /// there on path and time may differ from the machine's. `None` where everything is verified.
    pub not_verified_from: Option<Span>,
    /// The same for the path alone, without its time.
    pub path_lost_from: Option<Span>,
    /// Conditions that were assumed, and whether their other side was run, too.
    pub other_sides: OtherSides,
    /// The lines that the program printed (DPRNT), in order.
    pub output: Vec<String>,
    /// How each program that was run ended.
    pub outcomes: Vec<Outcome>,
}

impl Job<'_> {
    /// Runs with all checks and adds up the summary; `observe` sees every command of the tool centre with its
    /// segments.
    pub fn report_with(&self, mut observe: impl FnMut(&Command, &[Segment])) -> Report {
        self.report_of_path(|path, segments| observe(path.command, segments))
    }

    /// Like [`Job::report_with`]; `observe` also sees what cutter compensation did.
    pub fn report_of_path(&self, observe: impl FnMut(PathCommand<'_>, &[Segment])) -> Report {
        struct PathSinkChain<F>(F);
        impl<F: FnMut(PathCommand<'_>, &[Segment])> RunWatch for PathSinkChain<F> {
            fn path(&mut self, command: PathCommand<'_>, segments: &[Segment]) {
                (self.0)(command, segments);
            }
        }
        self.report_watched(&mut PathSinkChain(observe))
    }

    /// Runs with all checks and adds up the summary; `observe` sees every command as programmed, before cutter
    /// compensation.
    pub fn report_of_commands(&self, observe: impl FnMut(&Command)) -> Report {
        struct ProgrammedSink<F>(F);
        impl<F: FnMut(&Command)> RunWatch for ProgrammedSink<F> {
            fn programmed(&mut self, command: &Command) {
                (self.0)(command);
            }
        }
        self.report_watched(&mut ProgrammedSink(observe))
    }

    /// Runs with all checks and adds up the summary; `watch` sees the run.
    pub fn report_watched(&self, watch: &mut dyn RunWatch) -> Report {
        let mut sink = ReportSink::new(self, watch);
        contradicted_tools(self).into_iter().for_each(|found| sink.collector.push(found));
        let (outcomes, sink) = CompensationSink::judge(self, sink);
        let mut report = sink.finish(outcomes);
        self.check_other_sides(&mut report, KEPT_PER_CODE);
        report
    }

    /// Runs with all checks and adds up the summary.
    pub fn report(&self) -> Report {
        self.report_with(|_, _| {})
    }

    /// Runs with the checks only, without a summary: what `chordal check` needs.
    pub fn check(&self) -> Report {
        self.check_keeping(KEPT_PER_CODE)
    }

    /// Like [`Job::check`], but keeps `most_per_code` diagnostics of each code; the others are counted.
    pub fn check_keeping(&self, most_per_code: usize) -> Report {
        let mut report = self.check_of_run(most_per_code);
        self.check_other_sides(&mut report, most_per_code);
        report
    }

    /// The same for one run alone: other sides of the conditions that it assumes are not run.
    pub(crate) fn check_of_run(&self, most_per_code: usize) -> Report {
        let mut notes = Collector::new(most_per_code);
        contradicted_tools(self).into_iter().for_each(|diagnostic| notes.push(diagnostic));
        let sink = CheckSink::new(self, notes);
        let (outcomes, sink) = CompensationSink::judge(self, sink);
        let CheckSink { notes, output, .. } = sink;
        Report::new(Summary::default(), notes, output, outcomes)
    }
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
            not_verified_from: collector.lost(),
            path_lost_from: collector.path_lost(),
            other_sides: OtherSides::default(),
            diagnostics: collector.into_sorted(),
            outcomes,
        }
    }

    /// Adds problems of a further pass, counts them and sorts them in.
    pub(crate) fn add(&mut self, diagnostics: impl IntoIterator<Item = Diagnostic>) {
        for diagnostic in diagnostics {
            self.counts.add(diagnostic.severity);
            self.diagnostics.push(diagnostic);
        }
        self.diagnostics.sort_by_key(|each| {
            let span = each.primary.span;
            (span.file, span.range.start)
        });
    }

    /// True where the whole path was simulated as the control would follow it, with its feeds and waits.
    pub fn verified(&self) -> bool {
        self.not_verified_from.is_none()
    }

    /// True where the whole path was simulated as the control would follow it; its time may not be.
    pub fn is_path_verified(&self) -> bool {
        self.path_lost_from.is_none()
    }

    /// File name and line from which on the run is not verified; `None` where all of it is.
    pub fn not_verified_line<'s>(&self, sources: &'s SourceMap) -> Option<(&'s str, u32)> {
        let span = self.not_verified_from?;
        let source = sources.get(span.file)?;
        Some((source.name(), source.line_of(span.range.start)))
    }

    /// The most severe severity that occurred; `None` without problems.
    pub fn worst(&self) -> Option<Severity> {
        match self.counts {
            SeverityCounts { errors: 1.., .. } => Some(Severity::Error),
            SeverityCounts { warnings: 1.., .. } => Some(Severity::Warning),
            SeverityCounts { notes: 1.., .. } => Some(Severity::Note),
            _ => None,
        }
    }
}

/// Observes a run.
pub trait RunWatch {
    /// A command as programmed, before cutter compensation.
    fn programmed(&mut self, _command: &Command) {}
    /// A command of the tool centre and its segments of path.
    fn path(&mut self, _command: PathCommand<'_>, _segments: &[Segment]) {}
}

/// Ignores every event of a run.
impl RunWatch for () {}

/// Keeps a line that the program prints.
fn note_output(command: &Command, output: &mut Vec<String>) {
    if let CommandKind::Output { text } = &command.kind {
        output.push(text.clone());
    }
}

/// Receives the problems of a check.
pub(crate) trait NoteSink {
    fn note(&mut self, diagnostic: Diagnostic);
}

impl NoteSink for Collector {
    fn note(&mut self, diagnostic: Diagnostic) {
        self.push(diagnostic);
    }
}

/// Runs the checks only.
pub(crate) struct CheckSink<'m, N> {
    pub checks: RunChecks<'m>,
    pub notes: N,
    pub output: Vec<String>,
}

impl<'m, N> CheckSink<'m, N> {
    pub fn new(job: &'m Job<'_>, notes: N) -> CheckSink<'m, N> {
        CheckSink { checks: job.checks(), notes, output: Vec::new() }
    }
}

impl<N: NoteSink> chordal_path::PathSink for CheckSink<'_, N> {
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
        if !self.checks.is_guessed(diagnostic.code) {
            self.notes.note(diagnostic);
        }
    }

    fn ended(&mut self, head: Span) {
        self.checks.finish(head, |diagnostic| self.notes.note(diagnostic));
    }
}

/// Checks a run, adds up its summary and shows it to a watch.
pub(crate) struct ReportSink<'m, 'w> {
    builder: PathBuilder<'m>,
    checks: RunChecks<'m>,
    summary: SummaryBuilder,
    collector: Collector,
    output: Vec<String>,
    segments: Vec<Segment>,
    watch: &'w mut dyn RunWatch,
}

impl chordal_path::PathSink for ReportSink<'_, '_> {
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
        if !self.checks.is_guessed(diagnostic.code) {
            self.collector.push(diagnostic);
        }
    }

    fn ended(&mut self, head: Span) {
        self.checks.finish(head, |diagnostic| self.collector.push(diagnostic));
    }
}

impl<'m, 'w> ReportSink<'m, 'w> {
    pub fn new(job: &'m Job<'_>, watch: &'w mut dyn RunWatch) -> ReportSink<'m, 'w> {
        ReportSink {
            builder: job.path_builder(),
            checks: job.checks(),
            summary: SummaryBuilder::new(job.rules(), job.machine()),
            collector: Collector::new(KEPT_PER_CODE),
            output: Vec::new(),
            segments: Vec::new(),
            watch,
        }
    }

    /// The segments of path of the last command.
    pub fn segments(&self) -> &[Segment] {
        &self.segments
    }

    /// The frame of the part in which they lie.
    pub fn part_frame(&self) -> Option<PlacedPartFrame> {
        PlacedPartFrame::of(&self.builder)
    }

    pub fn finish(self, outcomes: Vec<Outcome>) -> Report {
        Report::new(self.summary.finish(), self.collector, self.output, outcomes)
    }
}
