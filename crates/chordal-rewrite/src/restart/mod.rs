//! A program that begins at one of its lines: the head that the control needs there, then the text as it is.
//!
//! `watch` finds what holds before the line and what is open there, `head` writes it, `trace` holds what both
//! programs do from the line on against each other. Nothing comes out that does not do the same.

mod by_language;
mod cycle;
mod head;
mod head_on_part;
mod head_turned;
mod lathe;
mod part_frame;
mod refusal;
mod text;
mod trace;
mod watch;

use std::ops::Range;

pub use chordal::control::UnrepeatedCode;
use chordal::control::{Action, CompensationSide, FrameKinds, Modal, MotionMode, OnceCode, Units};
use chordal::diagnostics::FileId;
use chordal::stock::{ApproachCheck, StockRunError, TurnedOptions};
use chordal::syntax::Letters;
use chordal::{Job, Report, Severity};

use self::by_language::begin_by_language;
use self::head::{HeadError, HeadWriter};
use self::part_frame::FrameRestart;
pub use self::refusal::{RefusalReason, RestartRefusal};
use self::trace::{EventTrace, MatchLevel};
use self::watch::{RunToBlock, StateBefore};
use crate::TransformRefusal;
use crate::convert::CycleContours;
use crate::source::SourceBlocks;
use crate::split::open::unsplittable_ranges;
use crate::word_address::BlockControl;

/// A program that begins at a line.
#[derive(Clone, Debug)]
pub struct RestartProgram {
    /// Its text.
    pub text: Vec<u8>,
    /// The line of the old text that it begins at.
    pub line: u32,
    /// The lines that are put in.
    pub head: Vec<String>,
    /// Where they stand in the text, in bytes.
    pub head_bytes: Range<u32>,
    /// Lines after the end of the program: contours that stand before the line, and that cycles after it take.
    pub after_the_end: Vec<String>,
    /// So many moves follow, the same in both programs.
    pub moves: u64,
    /// What follows goes to its first place by itself (after a tool change, or from a place that is not known):
    /// the head does not go there, and the spindle must be retracted.
    pub approaches: bool,
    /// The head says the program's G92 again: the machine must stand where the whole program starts.
    pub from_the_start: bool,
    /// M codes before the line that the head does not repeat, in the order of the program: what they have set is not
    /// part of the proof.
    pub unrepeated: Vec<UnrepeatedCode>,
}

/// Writes the main program of a job's first text so that it begins at a line, and proves it.
///
/// # Errors
/// Why it cannot begin there, and what to do.
pub fn restart(job: &Job, line: u32) -> Result<RestartProgram, RestartRefusal> {
    begin(job, line, None)
}

/// Proves a text that begins at a line, with a head that was written or changed by hand.
///
/// # Errors
/// Why the line is none to begin at, or what the text does otherwise.
pub fn prove_head(job: &Job, line: u32, text: &[u8]) -> Result<RestartProgram, RestartRefusal> {
    begin(job, line, Some(text))
}

fn begin(job: &Job, line: u32, provided: Option<&[u8]>) -> Result<RestartProgram, RestartRefusal> {
    if job.word_address().is_none() {
        return begin_by_language(job, line, provided);
    }
    let source = SourceBlocks::of(job);
    let requested = RestartRequest { job, source: &source, line };
    let main = requested.main()?;
    let at = requested.block(&main)?;
    let course = RunToBlock::to(job, &source, &main, at);
    let (ran, first) = requested.once(&course, at)?;
    requested.verified(at)?;
    let before = StateBefore::after_blocks(job, &source, ran).ok_or_else(|| {
        requested.refuse(RefusalReason::Beginning, "the program begins there", RUN_IT)
    })?;
    requested.closed(&before, at)?;
    requested.check_not_spanned(&main, at)?;
    let control = job.control();
    let changes = source.changes_tool(at, control) || requested.changes_station(at);
    let axes = &job.machine().axes;
    let is_known = (0..3).all(|axis| axes[axis].is_none() || before.modal.known.has(axis));
    let state = before.writer(&source, control);
    let head = HeadWriter { state, before: &before, at };
    let frame_restart = before.frame_restart();
    let holds_tip = frame_restart == Ok(FrameRestart::AlongTool);
    if holds_tip && (changes || !is_known) {
        let what = "tool centre point control is active, and the place of the tip is not known";
        return Err(requested.begun(RefusalReason::Frame, what, before.open.frame));
    }
    let approaches = changes || !is_known;
    let lines = match (changes, is_known) {
        _ if holds_tip => head.along_tool(),
        (true, _) => head.before_change(),
        (false, true) => head.all(),
        (false, false) => head.before_approach(),
    };
    let from_the_start = !before.open.shift.presets.is_empty();
    let unrepeated = before.unrepeated.clone();
    let provided = provided.map(<[u8]>::to_vec);
    let draft = |lines: Vec<String>, approaches: bool| RestartDraft {
        first,
        at,
        ran,
        lines,
        approaches,
        from_the_start,
        unrepeated: unrepeated.clone(),
        existing: provided.clone(),
    };
    let lines = match lines {
        Ok(lines) => lines,
        Err(lack) => {
            // After a turn of the axes they stand at places that no words give: the program goes to its own first one.
            let lines = match holds_tip {
                true => head.before_approach_of_tip(),
                false => head.before_approach(),
            };
            let can_approach = !approaches && !job.turns();
            let lines = lines.ok().filter(|_| can_approach);
            let done = lines.and_then(|lines| requested.prove(draft(lines, true)).ok());
            return done.ok_or_else(|| requested.lack(lack));
        }
    };
    let done = requested.prove(draft(lines, approaches));
    let Err(refused) = done else { return done };
    if is_known || changes {
        return Err(refused);
    }
    // Over the place that is known, where the program does not go to one by itself.
    let is_over = !job.turns() && before.modal.known.has(0) && before.modal.known.has(1);
    let lines = is_over.then(|| head.before_descent().ok()).flatten();
    let done = lines.and_then(|lines| requested.prove(draft(lines, approaches)).ok());
    done.ok_or_else(|| requested.position(&before.modal))
}

/// Looks whether the head's moves meet what the program has left of the stock of a lathe at the line; nothing without a stock, on a
/// mill, and where the program goes to its first place by itself.
///
/// # Errors
/// With a setup that is incomplete.
pub fn check_head_approach(
    job: &Job,
    done: &RestartProgram,
    files: &dyn Fn(&str) -> Result<Vec<u8>, String>,
) -> Result<Option<ApproachCheck>, StockRunError> {
    if !job.turns() || job.machine().setup.stock.is_none() || done.approaches {
        return Ok(None);
    }
    let new = main_of(job.with_text(done.text.clone()), done.head_bytes.end);
    let options = TurnedOptions::default();
    job.check_turned_approach(&new, done.head_bytes.clone(), &options, files).map(Some)
}

/// What the head's moves meet first, as a refusal.
pub fn blocked(job: &Job, done: &RestartProgram, course: &ApproachCheck) -> Option<RestartRefusal> {
    let hit = course.hits.first()?;
    let units = if job.report().summary.inch { Units::Inch } else { Units::Millimetre };
    let text = String::from_utf8_lossy(&done.text);
    let own = text.lines().nth(hit.line.saturating_sub(1) as usize).unwrap_or("").trim();
    let [z, radius] = hit.at;
    let (x, z) = (units.length_text(2.0 * radius), units.length_text(z));
    let what = format!(
        "the way in is not free: {} at X {x} (a diameter), Z {z}, in `{own}` of the new program",
        hit.what
    );
    let help =
        "begin at a change of the tool before it, or at a line where the tool is out of the part";
    let source = SourceBlocks::of(job);
    let requested = RestartRequest { job, source: &source, line: done.line };
    Some(requested.refuse(RefusalReason::HeadApproach, what, help))
}

const RUN_IT: &str = "run the program itself";

/// The request, and the blocks of the program.
struct RestartRequest<'r, 'a> {
    job: &'r Job<'r>,
    source: &'r SourceBlocks<'a>,
    line: u32,
}

/// A program to be proved.
struct RestartDraft {
    /// The first byte of the old text that the head takes the place of.
    first: u32,
    at: usize,
    ran: u64,
    lines: Vec<String>,
    approaches: bool,
    from_the_start: bool,
    unrepeated: Vec<UnrepeatedCode>,
    /// A text that stands already.
    existing: Option<Vec<u8>>,
}

impl RestartRequest<'_, '_> {
    fn refuse(
        &self,
        reason: RefusalReason,
        what: impl Into<String>,
        help: impl Into<String>,
    ) -> RestartRefusal {
        let text = String::from_utf8_lossy(self.source.text);
        let text = text.lines().nth(self.line.saturating_sub(1) as usize);
        let text = text.unwrap_or("").trim().to_string();
        let refusal =
            TransformRefusal { line: self.line, text, what: what.into(), help: help.into() };
        RestartRefusal { reason, refusal }
    }

    fn main(&self) -> Result<Range<usize>, RestartRefusal> {
        match self.source.mains.as_slice() {
            [main] => Ok(main.clone()),
            mains => {
                let what = format!("the file has {} main programs", mains.len());
                Err(self.refuse(RefusalReason::NoBlock, what, "name a file that has one"))
            }
        }
    }

    /// The first block with words on the line or after it.
    fn block(&self, main: &Range<usize>) -> Result<usize, RestartRefusal> {
        let blocks = &self.source.blocks;
        let last = blocks.last().map_or(0, |block| block.line);
        if self.line == 0 || self.line > last {
            let what = format!("the program has no line {}", self.line);
            return Err(self.refuse(
                RefusalReason::NoBlock,
                what,
                format!("it ends at line {last}"),
            ));
        }
        let from = self.source.blocks_on(self.line, last);
        let has_words = |at: &usize| {
            let block = &blocks[*at];
            let is_remark = block.kind == chordal::syntax::BlockKind::Words;
            !(is_remark && block.words.is_empty())
                && block.kind != chordal::syntax::BlockKind::Percent
        };
        let found = from.clone().find(has_words);
        found.filter(|at| *at >= main.start).ok_or_else(|| {
            self.refuse(
                RefusalReason::NoBlock,
                "nothing to do follows the line",
                "name an earlier line",
            )
        })
    }

    /// The block is carried out once, by the main program: after how many blocks, and where the first is.
    fn once(&self, course: &RunToBlock, at: usize) -> Result<(u64, u32), RestartRefusal> {
        if let (Some(caller), None) = (course.caller, course.ran) {
            return Err(self.refuse(
                RefusalReason::Called,
                "the line is in a called program",
                format!("begin at line {caller}, which calls it"),
            ));
        }
        if let Some(line) = self.cycle_that_reads(at).filter(|_| course.ran.is_none()) {
            let what = format!("the line is in the contour of the cycle in line {line}");
            return Err(self.refuse(RefusalReason::Cycle, what, format!("begin at line {line}")));
        }
        let Some(ran) = course.ran else {
            let what = "the run never comes to this line";
            return Err(self.refuse(
                RefusalReason::NoBlock,
                what,
                "name a line that is carried out",
            ));
        };
        let first = course.first.unwrap_or(0);
        if ran == 0 || self.source.start_of(at) <= first {
            return Err(self.refuse(RefusalReason::Beginning, "the program begins there", RUN_IT));
        }
        if course.times > 1 || course.caller.is_some() {
            let what = format!("the line is carried out {} times", course.times);
            let help = "begin before the loop, the repeat or the jump";
            return Err(self.refuse(RefusalReason::Repeated, what, help));
        }
        Ok((ran, first))
    }

    /// The line of the first cycle whose contour a block is part of.
    fn cycle_that_reads(&self, at: usize) -> Option<u32> {
        let contours = CycleContours::of(self.source, self.job);
        let contour = contours.list.iter().find(|contour| contour.blocks.contains(&at))?;
        contour.cycles.first().map(|(cycle, _)| self.source.blocks[*cycle].line)
    }

    /// The block takes a station of a turret.
    fn changes_station(&self, at: usize) -> bool {
        let control = self.job.control();
        let is_other = self.source.has_action(at, control, |action| {
            let once = action.once();
            once.is_some_and(|code| matches!(code, OnceCode::SetData | OnceCode::Turning(_)))
        });
        lathe::has_stations(control) && !is_other && self.source.blocks[at].word(b'T').is_some()
    }

    /// The program is followed, without an error, up to the block.
    fn verified(&self, at: usize) -> Result<(), RestartRefusal> {
        let report = self.job.check();
        let doubt =
            doubt_before(self.job, &report, report.not_verified_from, self.source.start_of(at));
        doubt.map_or(Ok(()), |(what, help)| Err(self.refuse(RefusalReason::Unsure, what, help)))
    }

    /// Nothing is open before the block that a head cannot say again.
    fn closed(&self, before: &StateBefore, at: usize) -> Result<(), RestartRefusal> {
        let StateBefore { modal, open, .. } = before;
        if modal.side != CompensationSide::Off {
            let what = "cutter compensation is on";
            return Err(self.begun(RefusalReason::Compensation, what, open.compensation));
        }
        let control = self.job.control();
        if modal.cycle.is_some()
            && let Err(what) = before.cycle.lines(modal, control, "")
        {
            return Err(self.begun(RefusalReason::Cycle, what, open.cycle));
        }
        if let Some(MotionMode::Turn(_)) = modal.motion
            && !self.says_motion(at)
            && self.source.blocks[at].letters().meets(Letters::of("XZUW"))
        {
            let what = "a cycle of one pass is active, and the line repeats it";
            return Err(self.begun(RefusalReason::Cycle, what, before.turned.pass));
        }
        let other_frames = FrameKinds { part: false, ..modal.frames };
        if other_frames.any() {
            let what = match modal.frames.surface {
                true => "polar or cylindrical interpolation is active",
                false => "the coordinates are rotated, scaled, mirrored or polar",
            };
            return Err(self.begun(RefusalReason::Frame, what, open.frame));
        }
        if let Err(what) = before.frame_restart() {
            return Err(self.begun(RefusalReason::Frame, what, open.frame));
        }
        if let line @ Some(_) = open.shift.unrepeatable {
            let what = "the zero was moved (G92 after a move, or by a value that is no number)";
            return Err(self.begun(RefusalReason::Shift, what, line));
        }
        if open.call.is_some() {
            return Err(self.begun(RefusalReason::Open, "a modal call is in force", open.call));
        }
        if open.corner.is_some() {
            return Err(self.begun(RefusalReason::Open, "a corner is not made yet", open.corner));
        }
        if let Some((code, line)) = &open.unknown {
            let what = format!("Chordal does not carry out {code}, which may be in force");
            return Err(self.begun(RefusalReason::Open, what, Some(*line)));
        }
        Ok(())
    }

    /// The block names a motion code.
    fn says_motion(&self, at: usize) -> bool {
        let is_motion = |action: Action| action.motion().is_some();
        self.source.has_action(at, self.job.control(), is_motion)
    }

    /// Refused for what a line began.
    fn begun(
        &self,
        reason: RefusalReason,
        what: impl Into<String>,
        line: Option<u32>,
    ) -> RestartRefusal {
        let help = match line {
            Some(line) => format!("begin at line {line}, where that begins, or before"),
            None => "begin before it".into(),
        };
        self.refuse(reason, what, help)
    }

    /// No loop, jump or variable spans the block.
    fn check_not_spanned(&self, main: &Range<usize>, at: usize) -> Result<(), RestartRefusal> {
        let start = self.source.start_of(at);
        let retained = unsplittable_ranges(self.job, self.source, main);
        let Some(retained) = retained.iter().find(|range| range.holds(start)) else {
            return Ok(());
        };
        let line = self.source.blocks[self.source.first_at(retained.from())].line;
        let what = format!("{} begins before the line and is needed after it", retained.what);
        Err(self.refuse(RefusalReason::Repeated, what, format!("begin at line {line} or before")))
    }

    fn position(&self, modal: &Modal) -> RestartRefusal {
        let axes = &self.job.machine().axes;
        let missing: String = (0..3)
            .filter(|axis| axes[*axis].is_some() && !modal.known.has(*axis))
            .map(|axis| "XYZ".as_bytes()[axis] as char)
            .collect();
        let what = format!("the position in {missing} is not known");
        let help = "begin at a tool change, or after a block that names X, Y and Z";
        self.refuse(RefusalReason::Position, what, help)
    }

    fn lack(&self, HeadError(what): HeadError) -> RestartRefusal {
        self.refuse(RefusalReason::Form, what, "begin at another line, best at a tool change")
    }

    /// The new text, if it does the same.
    fn prove(&self, draft: RestartDraft) -> Result<RestartProgram, RestartRefusal> {
        let (mut text, mut places) = self.text(&draft);
        if let Some(provided) = &draft.existing {
            // Contours that are put above the line are part of the head, and their places are not looked for.
            let rest = &text[places.from[1] as usize..];
            if !provided.ends_with(rest) || !provided.starts_with(&text[..draft.first as usize]) {
                let what = "the text from this line on, or before the head, is another one";
                return Err(self.refuse(
                    RefusalReason::Unproved,
                    what,
                    "change the lines of the head alone",
                ));
            }
            places.from[1] = (provided.len() - rest.len()) as u32;
            text.clone_from(provided);
        }
        let after = self.contours_needed(&draft).1.into_iter().flatten();
        let after_the_end = after.map(|block| self.source.words(block)).collect();
        let from = places.from;
        let start = from[1] + self.source.start_of(draft.at) - from[0];
        let new = main_of(self.job.with_text(text), start);
        let source = SourceBlocks::of(&new);
        let unproved = |what: String| {
            self.refuse(
                RefusalReason::Unproved,
                what,
                "begin at another line, best at a tool change",
            )
        };
        let at = source.first_at(start);
        let course = RunToBlock::to(&new, &source, &(0..source.blocks.len()), at);
        let Some(ran) = course.ran else {
            return Err(unproved("the new program never comes to the line".into()));
        };
        let errors = new.check().diagnostics.into_iter().find(|one| {
            let range = one.primary.span.range;
            let is_head = range.start >= draft.first && range.start < from[1];
            one.severity == Severity::Error && one.primary.span.file == FileId(0) && is_head
        });
        if let Some(error) = errors {
            return Err(unproved(format!("the control refuses the head: {}", error.message)));
        }
        let old = EventTrace::of(self.job, draft.ran);
        let trace = EventTrace::of(&new, ran);
        let care = MatchLevel { exact: !draft.approaches, ..MatchLevel::default() };
        if let Some(what) = old.begins_otherwise(&trace, care) {
            return Err(unproved(format!("{what} is another one where the program begins")));
        }
        if let Some(unlike) = old.unlike(&trace, &places, care) {
            let what = format!("line {} would not do the same: {}", unlike.line, unlike.what);
            return Err(unproved(what));
        }
        let text = source.text.to_vec();
        let draft_first = draft.first;
        let kept = self.kept_variables(&draft, &old.kept_otherwise(&trace));
        let RestartDraft { lines: head, approaches, from_the_start, mut unrepeated, .. } = draft;
        unrepeated.extend(kept);
        let (line, moves) = (self.line, old.moves);
        let head_bytes = draft_first..from[1];
        Ok(RestartProgram {
            text,
            line,
            head,
            head_bytes,
            after_the_end,
            moves,
            approaches,
            from_the_start,
            unrepeated,
        })
    }

    /// Variables that the program leaves another value in than the one that begins at the line.
    fn kept_variables(
        &self,
        draft: &RestartDraft,
        kept: &[(u32, Option<f64>)],
    ) -> Vec<UnrepeatedCode> {
        let before = &self.source.blocks[..draft.at];
        let line_of = |number: u32| {
            let name = format!("#{number}");
            let says =
                |block: &&chordal::syntax::Block| self.source.words_of(block).contains(&name);
            before.iter().rev().find(says).map_or(self.line, |block| block.line)
        };
        let say = |(number, value): &(u32, Option<f64>)| {
            let value =
                value.map_or(String::new(), |value| chordal::control::number_text(value, 6));
            UnrepeatedCode { words: format!("#{number}={value}"), line: line_of(*number) }
        };
        kept.iter().map(say).collect()
    }
}

/// Why the program is not followed, without an error, up to a byte, and what to do; nothing where it is. `lost` is where the
/// report says that it is not.
fn doubt_before(
    job: &Job,
    report: &Report,
    lost: Option<chordal::Span>,
    start: u32,
) -> Option<(String, String)> {
    let is_before = |span: chordal::Span| span.file != FileId(0) || span.range.start < start;
    let line_of = |span: chordal::Span| {
        job.sources().get(span.file).map_or(0, |source| source.line_of(span.range.start))
    };
    if let Some(span) = lost.filter(|span| is_before(*span)) {
        let line = line_of(span);
        let what = format!("the path is not verified from line {line} on");
        return Some((what, format!("begin before line {line}")));
    }
    let is_error =
        |one: &&chordal::Diagnostic| one.severity == Severity::Error && is_before(one.primary.span);
    let error = report.diagnostics.iter().find(is_error)?;
    let line = line_of(error.primary.span);
    let what = format!("the program has an error before it, at line {line}: {}", error.message);
    Some((what, "correct that first".into()))
}

/// The job of the program that a byte of the text is in: programs that nothing calls any more are not mains.
fn main_of(job: Job<'_>, at: u32) -> Job<'_> {
    let programs = job.programs();
    match programs.iter().position(|program| program.has(at)) {
        Some(place) if programs.len() > 1 => job.program_at(place),
        _ => job,
    }
}
