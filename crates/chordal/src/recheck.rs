//! Checks a text again after a change: the run is cut into stretches between checkpoints, and those
//! that the change does not touch, nor what it leads to, are kept with what was found in them.
//!
//! A stretch is kept when the control, compensation and checks enter it with the same memory to
//! the bit, and when nothing that it reads has changed: its own blocks, and what it calls or
//! searches elsewhere in the text. So the answer is always that of a whole run.

use chordal_command::{CallPath, Command, Sink};
use chordal_gcode::WordAddress;
use chordal_kernel::Checkpoint;
use chordal_kernel::CompletedRun;
use chordal_kernel::Language;
use chordal_kernel::RunSink;
use chordal_kernel::{EndReason, Outcome};
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

/// A stretch has about so many bytes of text, or one of [`MAX_STRETCHES`] parts of it.
const SEGMENT_BYTES: usize = 16 << 10;

/// About as many stretches at most: each holds what the control remembers where it begins.
const MAX_SEGMENTS: usize = 256;

/// What a check remembers for the next one, of a changed text.
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

/// A run, cut into stretches.
#[derive(Debug)]
struct SegmentedRun {
    text: Vec<u8>,
    /// The numbers of the programs of the text, and which one was run.
    numbers: Vec<Option<u32>>,
    main: usize,
    /// At least one.
    segments: Vec<CheckedSegment>,
    outcome: Outcome,
    /// What the checks remember at the end.
    end: ChecksMemory,
    /// Blocks that were carried out for it, those of kept stretches not counted.
    carried_out: u64,
}

/// A part of a run between two checkpoints.
#[derive(Debug)]
struct CheckedSegment {
    /// Where it begins; the first one at the beginning.
    start: Option<SegmentStart>,
    /// The byte of the main program at which it ends.
    end: u32,
    /// What of the first text it reads elsewhere.
    text_read: Option<TextRange>,
    findings: SegmentFindings,
    /// Problems that wait for the chains of calls.
    waiting: Vec<(Diagnostic, CallPath)>,
    seen: CheckedRange,
    output: Vec<String>,
}

/// What decides about all that follows.
#[derive(Clone, Debug)]
struct SegmentStart {
    checkpoint: Checkpoint,
    compensator: CompensatorMemory,
    checks: ChecksMemory,
}

/// The problems of a stretch, as many as a [`Collector`] may keep of it.
#[derive(Debug, Default)]
struct SegmentFindings {
    kept: Vec<Diagnostic>,
    places: BTreeMap<Code, BTreeSet<Span>>,
    /// How often problems were reported that are not kept.
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
    /// Makes it one of a text that has changed elsewhere; `None` where it speaks of what went.
    fn shift(&mut self, shift: &TextShift) -> Option<()> {
        if let Some(start) = &mut self.start {
            start.shift(shift)?;
        }
        self.end = shift.offset(self.end)?;
        if let Some(inspected) = &mut self.text_read {
            *inspected = shift.range(*inspected)?;
        }
        self.findings.shift(shift)?;
        for (diagnostic, _) in &mut self.waiting {
            shift.diagnostic(diagnostic)?;
        }
        self.seen.shift(shift)
    }

    /// Whether what it reads elsewhere is still the same.
    fn reads_the_same(&self, shift: &TextShift) -> bool {
        self.text_read.is_none_or(|inspected| shift.leaves(inspected))
    }

    /// Whether it names numbers of lines, which may have moved.
    fn has_lines(&self) -> bool {
        let waiting = self.waiting.iter().map(|(diagnostic, _)| diagnostic);
        self.findings.kept.iter().chain(waiting).any(|diagnostic| {
            matches!(diagnostic.code, Code::CutterGouges | Code::CutterGougesAtLead)
        })
    }
}

impl Job<'_> {
    /// The same as [`Job::check`] after a change of the first text, with what the check before remembers: only
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
}

impl CheckMemory {
    /// A memory that cuts runs into stretches of about so many bytes of text, or as many as make
    /// a few hundred of them.
    pub fn with_segment_bytes(bytes: usize) -> CheckMemory {
        CheckMemory { run: None, segment_bytes: bytes }
    }

    /// How many blocks the last check carried out; what it kept is not counted.
    pub fn carried_out(&self) -> Option<u64> {
        self.run.as_ref().map(|run| run.carried_out)
    }

    /// Nothing of the next text is known.
    pub(crate) fn forget(&mut self) {
        self.run = None;
    }

    /// Checks a job that runs one program, and remembers.
    pub(crate) fn check(&mut self, job: &Job, language: &WordAddress<'_>, main: usize) -> Report {
        let here =
            language.library().programs().iter().take_while(|program| program.file == FileId(0));
        let numbers: Vec<Option<u32>> = here.map(|program| program.head.number).collect();
        let before = self.run.take();
        let before = before.filter(|run| run.numbers == numbers && run.main == main);
        let bytes = self.segment_bytes.max(job.text().len() / MAX_SEGMENTS) as u32;
        let run = before.and_then(|run| run.again(job, language, bytes));
        let run = run.unwrap_or_else(|| SegmentedRun::whole(job, language, numbers, main, bytes));
        let waiting = run.segments.iter().map(|section| section.waiting.len()).sum::<usize>();
        if waiting >= MAX_WAITING {
            return job.check();
        }
        let mut report = run.report(job, language);
        job.check_other_sides(&mut report, KEPT_PER_CODE);
        // Half a run is no beginning for the next.
        self.run = Some(run).filter(|run| run.outcome.end != EndReason::Interrupted);
        report
    }
}

impl SegmentedRun {
    fn whole(
        job: &Job,
        language: &WordAddress<'_>,
        numbers: Vec<Option<u32>>,
        main: usize,
        bytes: u32,
    ) -> SegmentedRun {
        let mut walk = IncrementalRun::new(job, bytes, None, &[], None);
        let (outcome, end) = walk.run(job, language, main);
        let outcome = outcome.unwrap_or_else(|| unreachable!("there is nothing to meet"));
        let (segments, carried_out) = (walk.done, walk.blocks);
        SegmentedRun {
            text: job.text().to_vec(),
            numbers,
            main,
            segments,
            outcome,
            end,
            carried_out,
        }
    }

    /// The run of a changed text with the same programs; `None` where nothing can be kept.
    fn again(mut self, job: &Job, language: &WordAddress<'_>, bytes: u32) -> Option<SegmentedRun> {
        let shift = TextShift::between(&self.text, job.text());
        let start_of =
            |section: &CheckedSegment| section.start.as_ref().map_or(0, SegmentStart::offset);
        let same = |section: &&CheckedSegment| {
            let own = TextRange::new(start_of(section), section.end);
            shift.leaves(own)
                && section.reads_the_same(&shift)
                && (shift.lines() == 0 || !section.has_lines())
        };
        let last = self.segments.len() - 1;
        let before = |section: &&CheckedSegment| {
            shift.offset(section.end) == Some(section.end) && same(section)
        };
        let kept = self.segments[..last].iter().take_while(before).count();
        let tail = self.segments[kept + 1..].iter().rev().take_while(same).count();
        let mut tail = self.segments.split_off(self.segments.len() - tail);
        self.segments.truncate(kept + 1);
        let mut first = self.segments.pop()?.start;
        for section in &mut self.segments {
            section.shift(&shift)?;
        }
        if let Some(first) = &mut first {
            first.shift(&shift)?;
        }
        let began = first.as_ref().map_or(0, |first| first.checkpoint.blocks());
        let mut walk = IncrementalRun::new(job, bytes, first, &tail, Some(&shift));
        let (outcome, end) = walk.run(job, language, self.main);
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
                for section in &mut tail {
                    section.shift(&shift)?;
                    let checkpoint = &mut section.start.as_mut()?.checkpoint;
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

    /// What a whole run reports.
    fn report(&self, job: &Job, language: &WordAddress<'_>) -> Report {
        let mut collector = Collector::new(KEPT_PER_CODE);
        contradicted_tools(job).into_iter().for_each(|diagnostic| collector.push(diagnostic));
        job.before_run(language.library()).for_each(|diagnostic| collector.push(diagnostic));
        let mut sink = CheckSink::new(job, ());
        let mut output = Vec::new();
        for section in &self.segments {
            section.findings.add_to(&mut collector);
            sink.checks.add_seen(&section.seen);
            output.extend_from_slice(&section.output);
        }
        for (diagnostic, call) in self.segments.iter().flat_map(|section| &section.waiting) {
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

/// Runs from a start, cuts what goes by into stretches, and ends where it comes upon one that
/// is known.
struct IncrementalRun<'a, 'o> {
    run: CompensationSink<'a, CheckSink<'a, SegmentFindings>>,
    start: Option<SegmentStart>,
    done: Vec<CheckedSegment>,
    bytes: u32,
    /// Stretches of the text before the change that may follow.
    tail: &'o [CheckedSegment],
    shift: Option<&'o TextShift>,
    /// How many of them have been passed.
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

    /// Runs; no outcome where it came upon what is known.
    fn run(
        &mut self,
        job: &'a Job<'a>,
        language: &WordAddress<'_>,
        main: usize,
    ) -> (Option<Outcome>, ChecksMemory) {
        let checkpoint = self.start.as_ref().map(|start| start.checkpoint.clone());
        let ended = language.run(main, checkpoint.as_ref(), self);
        let outcome = ended.map(|CompletedRun { outcome, text_read: inspected }| {
            self.run.finish();
            self.blocks = outcome.blocks;
            self.close(job.text().len() as u32, inspected);
            outcome
        });
        (outcome, self.run.pending.inner.checks.memory().clone())
    }

    fn close(&mut self, end: u32, inspected: Option<TextRange>) {
        let sink = &mut self.run.pending.inner;
        self.done.push(CheckedSegment {
            start: self.start.take(),
            end,
            text_read: inspected,
            findings: std::mem::take(&mut sink.notes),
            waiting: std::mem::take(&mut self.run.pending.waiting),
            seen: sink.checks.take_seen(),
            output: std::mem::take(&mut sink.output),
        });
    }

    /// Where the next known stretch begins in the new text.
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
        inspected: Option<TextRange>,
    ) -> ControlFlow<()> {
        let (here, blocks) = (checkpoint.offset(), checkpoint.blocks());
        self.close(here, inspected);
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
