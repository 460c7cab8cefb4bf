//! Compares several runs, one after the other, with the single run that they replace.

use std::collections::HashMap;

use chordal::control::{CallPath, Origin};
use chordal::diagnostics::{FileId, SeverityCounts, Span, TextRange};
use chordal::geometry::{ParamCurve, Vec3};
use chordal::{Diagnostic, Job, Report, Severity, Summary};

use crate::category::Category;
use crate::course::{ComparedMove, ComparedMoveKind, ComparedRun, RunEvent, RunStep};
use crate::{COINCIDENT_MM, Comparison, ComparisonOptions, conclude};

/// A text that a part has copied from the whole program, byte for byte.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RetainedText {
    /// Its range in the part.
    pub part: TextRange,
    /// Its start offset in the whole program.
    pub whole: u32,
    /// The number of its first line in the part and in the whole program, from 1.
    pub lines: [u32; 2],
}

impl RetainedText {
    /// The location in the whole program of a block of the part; `None` when the block is not in this text.
    fn origin(&self, origin: &Origin) -> Option<Origin> {
        let span = self.span(origin.span)?;
        let line = origin.line - self.lines[0] + self.lines[1];
        Some(Origin { span, line, call: CallPath::default(), ..*origin })
    }

    fn span(&self, span: Span) -> Option<Span> {
        let range = span.range;
        let is_inside =
            span.file == FileId(0) && self.part.start <= range.start && range.end <= self.part.end;
        let moved = |at: u32| at - self.part.start + self.whole;
        is_inside
            .then(|| Span { range: TextRange::new(moved(range.start), moved(range.end)), ..span })
    }
}

/// One of the programs that are run one after the other in place of the whole.
#[derive(Debug)]
pub struct JoinedPart<'j, 't> {
    /// The job that runs its text on its machine.
    pub job: &'j Job<'t>,
    /// The blocks of the main program that it executes.
    pub body: RetainedText,
    /// The other texts copied from the whole: subprograms. Everything else was added to begin and end the part.
    pub other_texts: Vec<RetainedText>,
}

impl JoinedPart<'_, '_> {
    fn kept(&self) -> impl Iterator<Item = &RetainedText> {
        self.other_texts.iter().chain([&self.body])
    }
}

/// Compares parts, run one after the other, with the whole program that they were made from, move by move.
///
/// Rapids in the blocks added to a part are not compared, and neither is a tool change in them to the tool already in
/// the spindle. If the part then starts from another position than the whole, the rapids before its first cut that
/// differ are not compared either. The blocks of the differences refer to the whole program.
pub fn compare_joined(
    whole: &Job,
    parts: &[JoinedPart],
    options: &ComparisonOptions,
) -> Comparison {
    let options = ComparisonOptions { in_step: true, ..options.clone() };
    let found = joined(whole, parts, &options);
    // All start at the same position.
    let nothing_known = found.max_distance_mm.is_none() && found.moves != [0, 0];
    if nothing_known && !options.assume_known {
        return joined(whole, parts, &ComparisonOptions { assume_known: true, ..options });
    }
    found
}

fn joined(whole: &Job, parts: &[JoinedPart], options: &ComparisonOptions) -> Comparison {
    // Each part reports these once and the whole program reports them once. They need no comparison, because the
    // texts are equal.
    let mut options = options.clone();
    options.ignored.extend([Category::Value, Category::NotRun, Category::Variable]);
    let options = &options;
    let mut a = ComparedRun::of(whole, options, None);
    let begins = begins(&a, parts);
    let mut b =
        ComparedRun { steps: Vec::new(), states: Vec::new(), turns: Vec::new(), report: empty() };
    for (part, of_a) in parts.iter().zip(begins) {
        let of_b = b.steps.len();
        join(&mut b, part, options);
        if of_b > 0 {
            arrive([&mut a, &mut b], [of_a, of_b], options.tolerance_mm.max(COINCIDENT_MM));
        }
    }
    conclude([whole, whole], a, b, &Default::default(), options)
}

/// The steps of the whole program at which its parts begin: after the last step of a block before the part.
fn begins(whole: &ComparedRun, parts: &[JoinedPart]) -> Vec<usize> {
    let calls = whole.report.outcomes.first().map(|outcome| &outcome.calls);
    let mut callers: HashMap<CallPath, u32> = HashMap::new();
    let mut begins = vec![0; parts.len()];
    for (at, step) in whole.steps.iter().enumerate() {
        let Origin { call, span, .. } = *step.origin();
        let block = if call == CallPath::default() {
            span.range.start
        } else {
            *callers.entry(call).or_insert_with(|| {
                let blocks = calls.map(|calls| calls.resolve(call)).unwrap_or_default();
                blocks.last().map_or(u32::MAX, |outermost| outermost.range.start)
            })
        };
        let begun = parts.partition_point(|part| part.body.whole <= block);
        for begin in &mut begins[begun..] {
            *begin = at + 1;
        }
    }
    begins
}

/// The report of an empty run.
fn empty() -> Report {
    Report {
        summary: Summary::default(),
        diagnostics: Vec::new(),
        dropped: Vec::new(),
        counts: SeverityCounts::default(),
        not_verified_from: None,
        path_lost_from: None,
        other_sides: Default::default(),
        output: Vec::new(),
        outcomes: Vec::new(),
    }
}

/// Appends the run of a part.
fn join(joined: &mut ComparedRun, part: &JoinedPart, options: &ComparisonOptions) {
    let run = ComparedRun::of(part.job, options, None);
    let (states, turns) = (joined.states.len() as u32, joined.turns.len() as u32);
    joined.states.extend(run.states);
    joined.turns.extend(run.turns);
    for step in run.steps {
        let origin = *step.origin();
        let kept = part.kept().find_map(|kept| kept.origin(&origin));
        let is_own = kept.is_none() && origin.span.file == FileId(0);
        let origin = kept.unwrap_or(origin);
        match step {
            RunStep::Move(moved) if is_own && moved.kind != ComparedMoveKind::Cut => {}
            RunStep::Move(mut moved) => {
                moved.state += states;
                moved.turn += turns;
                joined.steps.push(RunStep::Move(ComparedMove { origin, ..moved }));
            }
            RunStep::Event { what: RunEvent::Tool(number), .. }
                if is_own && tool(joined) == Some(number) => {}
            // The added head repeats what was set before.
            RunStep::Event {
                what:
                    what @ (RunEvent::Code(_) | RunEvent::Written { .. } | RunEvent::Variable { .. }),
                ..
            } if is_own && has_event(joined, &what) => {}
            RunStep::Event { what, deletable, .. } => {
                joined.steps.push(RunStep::Event { what, origin, deletable });
            }
        }
    }
    join_reports(&mut joined.report, run.report, part);
}

fn has_event(course: &ComparedRun, event: &RunEvent) -> bool {
    let is_it = |step: &RunStep| matches!(step, RunStep::Event { what, .. } if what == event);
    course.steps.iter().any(is_it)
}

/// The tool in the spindle after the last step.
fn tool(course: &ComparedRun) -> Option<u32> {
    course.steps.iter().rev().find_map(|step| match step {
        RunStep::Event { what: RunEvent::Tool(number), .. } => Some(*number),
        _ => None,
    })
}

fn join_reports(joined: &mut Report, report: Report, part: &JoinedPart) {
    let errors = report.diagnostics.into_iter().filter(|one| one.severity == Severity::Error);
    joined.diagnostics.extend(errors.map(|mut one: Diagnostic| {
        let span = part.kept().find_map(|kept| kept.span(one.primary.span));
        one.primary.span = span.unwrap_or(Span { range: TextRange::new(0, 0), ..one.primary.span });
        one
    }));
    joined.counts.errors += report.counts.errors;
    joined.not_verified_from = joined.not_verified_from.or(report.not_verified_from);
    joined.path_lost_from = joined.path_lost_from.or(report.path_lost_from);
    joined.dropped.extend(report.dropped);
    joined.output.extend(report.output);
}

/// Excludes from the comparison the rapids of a part that approach its first cut from another position: the last
/// rapid that differs and all rapids before it. This is done only when the first cut starts at the same point.
fn arrive(courses: [&mut ComparedRun; 2], begins: [usize; 2], tolerance_mm: f64) {
    let [a, b] = courses;
    let (Some(one), Some(other)) = (approach(a, begins[0]), approach(b, begins[1])) else { return };
    let separate = |a: Vec3, b: Vec3| (a - b).length() > tolerance_mm;
    if separate(one.cut_from, other.cut_from) {
        return;
    }
    let ends = |course: &ComparedRun, at: usize| {
        course.moved(at).map(|moved| [moved.curve.start(), moved.curve.end()])
    };
    let is_alike = |(at, of): &(&usize, &usize)| {
        let (Some(one), Some(other)) = (ends(a, **at), ends(b, **of)) else { return false };
        !separate(one[0], other[0]) && !separate(one[1], other[1])
    };
    let alike = one.rapids.iter().rev().zip(other.rapids.iter().rev()).take_while(is_alike).count();
    for (course, rapids) in [(a, one.rapids), (b, other.rapids)] {
        for at in &rapids[..rapids.len() - alike] {
            if let Some(RunStep::Move(moved)) = course.steps.get_mut(*at) {
                moved.known = false;
            }
        }
    }
}

/// The start of a cut, and the indices of the rapids before it.
struct CutApproach {
    cut_from: Vec3,
    rapids: Vec<usize>,
}

/// The approach to the first cut from a step on; `None` without a cut.
fn approach(course: &ComparedRun, from: usize) -> Option<CutApproach> {
    let mut rapids = Vec::new();
    for at in from..course.steps.len() {
        let Some(moved) = course.moved(at) else { continue };
        if moved.kind == ComparedMoveKind::Cut {
            return Some(CutApproach { cut_from: moved.curve.start(), rapids });
        }
        rapids.push(at);
    }
    None
}
