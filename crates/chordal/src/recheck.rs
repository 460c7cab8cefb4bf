//! Checks a text again after a change: the run is divided into segments between checkpoints, and the segments that
//! neither the change nor its consequences touch are kept with the problems found in them.
//!
//! A segment is kept when the control, compensation and checks enter it with the same state to the bit, and when
//! nothing that it reads has changed: its own blocks, and what it calls or searches elsewhere in the text. So the
//! answer is always that of a whole run.

use chordal_command::{CallPath, Command, Sink};
use chordal_kernel::{
    Checkpoint, CompletedRun, EndReason, Outcome, ProgramName, ProgramSet, RunSink,
};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::ControlFlow;

use chordal_diagnostics::{
    Code, Collector, Diagnostic, FileId, Severity, Span, TextRange, TextShift,
};
use chordal_path::{CheckedRange, ChecksMemory, CompensatorMemory, ContourCheck};

use crate::compensation_sink::{CompensationSink, MAX_WAITING};
use crate::job::{Job, no_block};
use crate::report::{CheckSink, KEPT_PER_CODE, NoteSink, Report};
use crate::summary::Summary;
use crate::tool_comments::contradicted_tools;

/// Bytes of text in a segment; long texts have longer ones, so that there are no more than [`MAX_SEGMENTS`].
const SEGMENT_BYTES: usize = 16 << 10;

/// Most segments, about: each holds a copy of the control's state where it begins.
const MAX_SEGMENTS: usize = 256;

/// What a check keeps for the next check, of a changed text.
#[derive(Debug)]
pub struct CheckMemory {
    run: Option<SegmentedRun>,
    segment_bytes: usize,
}

impl Default for CheckMemory {
    fn default() -> CheckMemory {
        CheckMemory::with_segment_bytes(SEGMENT_BYTES)
    }
}

/// A run, divided into segments.
#[derive(Debug)]
struct SegmentedRun {
    text: Vec<u8>,
    /// The numbers of the programs of the text, and which one was run.
    names: Vec<Option<ProgramName>>,
    main: usize,
    /// At least one.
    segments: Vec<CheckedSegment>,
    outcome: Outcome,
    /// The state of the checks at the end.
    end: ChecksMemory,
    /// Blocks that were carried out for it, without those of segments that were kept.
    carried_out: u64,
}

/// A part of a run between two checkpoints.
#[derive(Debug)]
struct CheckedSegment {
    /// Where it begins; `None` for the first segment, which begins with the program.
    start: Option<SegmentStart>,
    /// The byte of the main program at which it ends.
    end: u32,
    /// The range of the first text that it reads outside itself.
    text_read: Option<TextRange>,
    findings: SegmentFindings,
    /// Problems whose chains of calls are known only at the end of the run.
    waiting: Vec<(Diagnostic, CallPath)>,
    seen: CheckedRange,
    output: Vec<String>,
}

/// The complete state at the start of a segment, which determines all that follows.
#[derive(Clone, Debug)]
struct SegmentStart {
    checkpoint: Checkpoint,
    compensator: CompensatorMemory,
    checks: ChecksMemory,
}

/// The problems of a segment, as many as a [`Collector`] may keep of it.
#[derive(Debug, Default)]
struct SegmentFindings {
    kept: Vec<Diagnostic>,
    places: BTreeMap<Code, BTreeSet<Span>>,
    /// How often each problem was reported that is not kept.
    more: BTreeMap<(Code, Severity, Span), u64>,
}

impl NoteSink for SegmentFindings {
    fn note(&mut self, diagnostic: Diagnostic) {
        let (code, span) = (diagnostic.code, diagnostic.primary.span);
        let places = self.places.entry(code).or_default();
        if places.len() < KEPT_PER_CODE && places.insert(span) {
            self.kept.push(diagnostic);
        } else {
            *self.more.entry((code, diagnostic.severity, span)).or_default() += 1;
        }
    }
}

impl NoteSink for () {
    fn note(&mut self, _: Diagnostic) {}
}

impl SegmentFindings {
    fn shift(&mut self, shift: &TextShift) -> Option<()> {
        self.places.clear();
        for diagnostic in &mut self.kept {
            shift.diagnostic(diagnostic)?;
        }
        for ((code, severity, span), times) in std::mem::take(&mut self.more) {
            self.more.insert((code, severity, shift.span(span)?), times);
        }
        Some(())
    }

    fn add_to(&self, collector: &mut Collector) {
        self.kept.iter().for_each(|diagnostic| collector.push_copy(diagnostic));
        for (&(code, severity, span), &times) in &self.more {
            collector.push_uncopied(code, severity, span, times);
        }
    }
}

impl SegmentStart {
    fn offset(&self) -> u32 {
        self.checkpoint.offset()
    }

    fn shift(&mut self, shift: &TextShift) -> Option<()> {
        self.checkpoint.shift(shift)?;
        self.compensator.shift(shift)?;
        self.checks.shift(shift)
    }

    fn shifted(mut self, shift: &TextShift) -> Option<SegmentStart> {
        self.shift(shift).map(|()| self)
    }

    fn leads_on_like(&self, other: &SegmentStart) -> bool {
        let checkpoint =
            |start: &SegmentStart| format!("{:?} {:?}", start.compensator, start.checks);
        self.checkpoint.leads_on_like(&other.checkpoint) && checkpoint(self) == checkpoint(other)
    }
}

impl CheckedSegment {
    /// Moves its places to a text that has changed elsewhere; `None` where it refers to text that is gone.
    fn shift(&mut self, shift: &TextShift) -> Option<()> {
        if let Some(start) = &mut self.start {
            start.shift(shift)?;
        }
        self.end = shift.offset(self.end)?;
        if let Some(range) = &mut self.text_read {
            *range = shift.range(*range)?;
        }
        self.findings.shift(shift)?;
        for (diagnostic, _) in &mut self.waiting {
            shift.diagnostic(diagnostic)?;
        }
        self.seen.shift(shift)
    }

    /// Whether the text that it reads outside itself is unchanged.
    fn reads_the_same(&self, shift: &TextShift) -> bool {
        self.text_read.is_none_or(|range| shift.leaves(range))
    }

    /// Whether its messages contain line numbers, which may have changed.
    fn has_lines(&self) -> bool {
        let waiting = self.waiting.iter().map(|(diagnostic, _)| diagnostic);
        self.findings.kept.iter().chain(waiting).any(|diagnostic| {
            matches!(diagnostic.code, Code::CutterGouges | Code::CutterGougesAtLead)
        })
    }
}

impl Job<'_> {
    /// The same result as [`Job::check`] after a change of the first text, with the memory of the check before it:
    /// only the segments that the change may touch are run. The machine, the options and the other texts must be
    /// those of that check.
    pub fn check_again(&self, memory: &mut CheckMemory) -> Report {
        match self.single_main() {
            Some((programs, main)) => memory.check(self, &*programs, main),
            None => {
                memory.forget();
                self.check()
            }
        }
    }
}

impl CheckMemory {
    /// A memory that divides runs into segments of about `bytes` bytes of text, or more where there would be more
    /// than a few hundred segments.
    pub fn with_segment_bytes(bytes: usize) -> CheckMemory {
        CheckMemory { run: None, segment_bytes: bytes }
    }

    /// How many blocks the last check carried out, without the segments that it kept; `None` before the first check.
    pub fn carried_out(&self) -> Option<u64> {
        self.run.as_ref().map(|run| run.carried_out)
    }

    /// Forgets the last run.
    pub(crate) fn forget(&mut self) {
        self.run = None;
    }

    /// Checks a job that runs one program, and remembers.
    pub(crate) fn check(&mut self, job: &Job, programs: &dyn ProgramSet, main: usize) -> Report {
        let own = programs.programs().iter().take_while(|program| program.file == FileId(0));
        let names: Vec<Option<ProgramName>> = own.map(|program| program.name.clone()).collect();
        let before = self.run.take();
        let before = before.filter(|run| run.names == names && run.main == main);
        let bytes = self.segment_bytes.max(job.text().len() / MAX_SEGMENTS) as u32;
        let run = before.and_then(|run| run.again(job, programs, bytes));
        let run = run.unwrap_or_else(|| SegmentedRun::whole(job, programs, names, main, bytes));
        let waiting = run.segments.iter().map(|segment| segment.waiting.len()).sum::<usize>();
        if waiting >= MAX_WAITING {
            return job.check();
        }
        let mut report = run.report(job, programs);
        job.check_other_sides(&mut report, KEPT_PER_CODE);
        // An interrupted run has no end to join on to.
        self.run = Some(run).filter(|run| run.outcome.end != EndReason::Interrupted);
        report
    }
}

impl SegmentedRun {
    fn whole(
        job: &Job,
        programs: &dyn ProgramSet,
        names: Vec<Option<ProgramName>>,
        main: usize,
        bytes: u32,
    ) -> SegmentedRun {
        let mut walk = IncrementalRun::new(job, bytes, None, &[], None);
        let (outcome, end) = walk.run(job, programs, main);
        let outcome = outcome.unwrap_or_else(|| unreachable!("there is nothing to meet"));
        let (segments, carried_out) = (walk.done, walk.blocks);
        SegmentedRun { text: job.text().to_vec(), names, main, segments, outcome, end, carried_out }
    }

    /// The run of a changed text with the same programs, which keeps the segments before the change and those after
    /// it that begin with the same state; `None` where nothing can be kept.
    fn again(mut self, job: &Job, programs: &dyn ProgramSet, bytes: u32) -> Option<SegmentedRun> {
        let shift = TextShift::between(&self.text, job.text());
        let start_of =
            |segment: &CheckedSegment| segment.start.as_ref().map_or(0, SegmentStart::offset);
        let same = |segment: &&CheckedSegment| {
            let own = TextRange::new(start_of(segment), segment.end);
            shift.leaves(own)
                && segment.reads_the_same(&shift)
                && (shift.lines() == 0 || !segment.has_lines())
        };
        let last = self.segments.len() - 1;
        let before = |segment: &&CheckedSegment| {
            shift.offset(segment.end) == Some(segment.end) && same(segment)
        };
        let kept = self.segments[..last].iter().take_while(before).count();
        let tail = self.segments[kept + 1..].iter().rev().take_while(same).count();
        let mut tail = self.segments.split_off(self.segments.len() - tail);
        self.segments.truncate(kept + 1);
        let mut first = self.segments.pop()?.start;
        for segment in &mut self.segments {
            segment.shift(&shift)?;
        }
        if let Some(first) = &mut first {
            first.shift(&shift)?;
        }
        let began = first.as_ref().map_or(0, |first| first.checkpoint.blocks());
        let mut walk = IncrementalRun::new(job, bytes, first, &tail, Some(&shift));
        let (outcome, end) = walk.run(job, programs, self.main);
        let (met, blocks, done) = (walk.met, walk.blocks, walk.done);
        self.carried_out = blocks - began;
        self.segments.extend(done);
        self.text.clear();
        self.text.extend_from_slice(job.text());
        match outcome {
            Some(outcome) => (self.outcome, self.end) = (outcome, end),
            None => {
                tail.drain(..met);
                let was = tail.first()?.start.as_ref()?.checkpoint.blocks();
                for segment in &mut tail {
                    segment.shift(&shift)?;
                    let checkpoint = &mut segment.start.as_mut()?.checkpoint;
                    checkpoint.count_blocks(checkpoint.blocks() - was + blocks);
                }
                self.outcome.calls.shift(&shift)?;
                self.outcome.blocks = self.outcome.blocks - was + blocks;
                self.end.shift(&shift)?;
                self.segments.append(&mut tail);
            }
        }
        Some(self)
    }

    /// The report of the run, put together from its segments.
    fn report(&self, job: &Job, programs: &dyn ProgramSet) -> Report {
        let mut collector = Collector::new(KEPT_PER_CODE);
        contradicted_tools(job).into_iter().for_each(|diagnostic| collector.push(diagnostic));
        job.before_run(programs).for_each(|diagnostic| collector.push(diagnostic));
        let mut sink = CheckSink::new(job, ());
        let mut output = Vec::new();
        for segment in &self.segments {
            segment.findings.add_to(&mut collector);
            sink.checks.add_seen(&segment.seen);
            output.extend_from_slice(&segment.output);
        }
        for (diagnostic, call) in self.segments.iter().flat_map(|segment| &segment.waiting) {
            let mut diagnostic = diagnostic.clone();
            diagnostic.calls = self.outcome.calls.resolve(*call);
            collector.push(diagnostic);
        }
        if self.outcome.blocks == 0 {
            collector.push(no_block());
        }
        sink.checks.recall(self.end.clone());
        sink.checks.finish(Span::default(), |diagnostic| collector.push(diagnostic));
        Report::new(Summary::default(), collector, output, vec![self.outcome.clone()])
    }
}

/// Runs from a start, divides the run into segments, and ends where it reaches a known segment in the same state.
struct IncrementalRun<'a, 'o> {
    run: CompensationSink<'a, CheckSink<'a, SegmentFindings>>,
    start: Option<SegmentStart>,
    done: Vec<CheckedSegment>,
    bytes: u32,
    /// Segments of the run before the change that may follow.
    tail: &'o [CheckedSegment],
    shift: Option<&'o TextShift>,
    /// How many segments of `tail` have been passed.
    met: usize,
    /// Blocks carried out since the beginning where the run ended.
    blocks: u64,
}

impl<'a, 'o> IncrementalRun<'a, 'o> {
    fn new(
        job: &'a Job<'a>,
        bytes: u32,
        start: Option<SegmentStart>,
        tail: &'o [CheckedSegment],
        shift: Option<&'o TextShift>,
    ) -> IncrementalRun<'a, 'o> {
        let sink = CheckSink::new(job, SegmentFindings::default());
        let mut run = CompensationSink::new(job, Some(ContourCheck::default()), sink);
        if let Some(start) = &start {
            run.compensator.recall(&start.compensator);
            run.pending.inner.checks.recall(start.checks.clone());
        }
        IncrementalRun { run, start, done: Vec::new(), bytes, tail, shift, met: 0, blocks: 0 }
    }

    /// Runs; the outcome is `None` where the run reached a known segment.
    fn run(
        &mut self,
        job: &'a Job<'a>,
        programs: &dyn ProgramSet,
        main: usize,
    ) -> (Option<Outcome>, ChecksMemory) {
        let checkpoint = self.start.as_ref().map(|start| start.checkpoint.clone());
        let ended = programs.run(main, checkpoint.as_ref(), self);
        let outcome = ended.map(|CompletedRun { outcome, text_read }| {
            self.run.finish();
            self.blocks = outcome.blocks;
            self.close(job.text().len() as u32, text_read);
            outcome
        });
        (outcome, self.run.pending.inner.checks.memory().clone())
    }

    fn close(&mut self, end: u32, text_read: Option<TextRange>) {
        let sink = &mut self.run.pending.inner;
        self.done.push(CheckedSegment {
            start: self.start.take(),
            end,
            text_read,
            findings: std::mem::take(&mut sink.notes),
            waiting: std::mem::take(&mut self.run.pending.waiting),
            seen: sink.checks.take_seen(),
            output: std::mem::take(&mut sink.output),
        });
    }

    /// Where the next known segment begins in the new text.
    fn known(&self) -> Option<u32> {
        let start = self.tail.get(self.met)?.start.as_ref()?;
        self.shift?.offset(start.offset())
    }
}

impl Sink for IncrementalRun<'_, '_> {
    #[inline]
    fn command(&mut self, command: &Command) {
        self.run.command(command);
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic) {
        self.run.diagnostic(diagnostic);
    }
}

impl RunSink for IncrementalRun<'_, '_> {
    fn next_checkpoint(&self) -> u32 {
        let from = self.start.as_ref().map_or(0, SegmentStart::offset);
        let usual = from.saturating_add(self.bytes);
        match self.known() {
            Some(known) if known <= usual.saturating_add(self.bytes) => known,
            _ => usual,
        }
    }

    fn is_settled(&self) -> bool {
        self.run.is_settled()
    }

    fn checkpoint(
        &mut self,
        checkpoint: Checkpoint,
        text_read: Option<TextRange>,
    ) -> ControlFlow<()> {
        let (here, blocks) = (checkpoint.offset(), checkpoint.blocks());
        self.close(here, text_read);
        let start = SegmentStart {
            checkpoint,
            compensator: self.run.compensator.memory(),
            checks: self.run.pending.inner.checks.memory().clone(),
        };
        while self.known().is_some_and(|known| known < here) {
            self.met += 1;
        }
        if let (Some(shift), Some(known)) = (self.shift, self.tail.get(self.met))
            && self.known() == Some(here)
        {
            let moved = known.start.clone().and_then(|start| start.shifted(shift));
            if moved.is_some_and(|known| known.leads_on_like(&start)) {
                self.blocks = blocks;
                return ControlFlow::Break(());
            }
            self.met += 1;
        }
        self.start = Some(start);
        ControlFlow::Continue(())
    }
}
