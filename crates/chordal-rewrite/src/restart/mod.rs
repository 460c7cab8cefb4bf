//! A program that begins at one of its lines: the head that the control needs there, then the text as it is.
//!
//! `watch` finds what holds before the line and what is open there, `head` writes it, `trace` holds what both
//! programs do from the line on against each other. Nothing comes out that does not do the same.

mod cycle;
mod head;
mod shift;
mod trace;
mod watch;

use std::ops::Range;

use chordal::control::{Modal, Side};
use chordal::diagnostics::FileId;
use chordal::{Job, Severity};

use self::head::{Head, Lack};
use self::trace::{Care, Places, Trace};
use self::watch::{Before, Way, before};
use crate::Refusal;
use crate::source::Source;
use crate::split::open::stretches;

/// Why a program cannot begin at a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Reason {
    /// There is no block to begin at.
    NoBlock,
    /// The program begins there anyway.
    Beginning,
    /// The line is in a called program.
    Called,
    /// The line is in a loop, a jump, or between a variable and its use, or is carried out again.
    Repeated,
    /// Cutter compensation is on.
    Compensation,
    /// A canned cycle is in force that a head cannot say again.
    Cycle,
    /// A rotation, scaling, mirror or polar coordinates are in force.
    Frame,
    /// The zero was moved by G92 or G52 in a way that a head cannot say again.
    Shift,
    /// A code is in force that a head cannot say again.
    Open,
    /// The position is not known.
    Position,
    /// The program has an error before the line or is not verified there.
    Unsure,
    /// The control has no form for what is needed.
    Form,
    /// The new program would not do the same.
    Unproved,
}

impl Reason {
    /// The word for programs.
    pub fn word(self) -> &'static str {
        match self {
            Reason::NoBlock => "no-block",
            Reason::Beginning => "beginning",
            Reason::Called => "called",
            Reason::Repeated => "repeated",
            Reason::Compensation => "compensation",
            Reason::Cycle => "cycle",
            Reason::Frame => "frame",
            Reason::Shift => "shift",
            Reason::Open => "open",
            Reason::Position => "position",
            Reason::Unsure => "unsure",
            Reason::Form => "form",
            Reason::Unproved => "unproved",
        }
    }
}

/// A refusal and its kind.
#[derive(Debug)]
pub struct Refused {
    /// What kind it is.
    pub reason: Reason,
    /// What is said about it.
    pub refusal: Refusal,
}

/// A program that begins at a line.
#[derive(Clone, Debug)]
pub struct Restart {
    /// Its text.
    pub text: Vec<u8>,
    /// The line of the old text that it begins at.
    pub line: u32,
    /// The lines that are put in.
    pub head: Vec<String>,
    /// So many moves follow, the same in both programs.
    pub moves: u64,
    /// What follows goes to its first place by itself (after a tool change, or from a place that is not known):
    /// the head does not go there, and the spindle must be retracted.
    pub approaches: bool,
    /// The head says the program's G92 again: the machine must stand where the whole program starts.
    pub from_the_start: bool,
}

/// Writes the main program of a job's first text so that it begins at a line, and proves it.
///
/// # Errors
/// Why it cannot begin there, and what to do.
pub fn restart(job: &Job, line: u32) -> Result<Restart, Refused> {
    let source = Source::of(job);
    let asked = Asked { job, source: &source, line };
    let main = asked.main()?;
    let at = asked.block(&main)?;
    let way = Way::to(job, &source, &main, at);
    let (ran, first) = asked.once(&way, at)?;
    asked.verified(at)?;
    let before = before(job, &source, ran)
        .ok_or_else(|| asked.refuse(Reason::Beginning, "the program begins there", RUN_IT))?;
    asked.closed(&before)?;
    asked.apart(&main, at)?;
    let changes = source.changes_tool(at, job.control());
    let is_known = (0..3).all(|axis| before.modal.known.has(axis));
    let head = Head { source: &source, control: job.control(), before: &before, at };
    let lines = match (changes, is_known) {
        (true, _) => head.before_change(),
        (false, true) => head.all(),
        (false, false) => head.before_approach(),
    };
    let lines = lines.map_err(|lack| asked.lack(lack))?;
    let approaches = changes || !is_known;
    let from_the_start = !before.shift.presets.is_empty();
    let done = asked.prove(Draft { first, at, ran, lines, approaches, from_the_start });
    done.map_err(
        |refused| if is_known || changes { refused } else { asked.position(&before.modal) },
    )
}

const RUN_IT: &str = "run the program itself";

/// What was asked for.
struct Asked<'r, 'a> {
    job: &'r Job<'r>,
    source: &'r Source<'a>,
    line: u32,
}

/// A program to be proved.
struct Draft {
    /// The first byte of the old text that the head takes the place of.
    first: u32,
    at: usize,
    ran: u64,
    lines: Vec<String>,
    approaches: bool,
    from_the_start: bool,
}

impl Asked<'_, '_> {
    fn refuse(&self, reason: Reason, what: impl Into<String>, help: impl Into<String>) -> Refused {
        let text = String::from_utf8_lossy(self.source.text);
        let text = text.lines().nth(self.line.saturating_sub(1) as usize);
        let text = text.unwrap_or("").trim().to_string();
        let refusal = Refusal { line: self.line, text, what: what.into(), help: help.into() };
        Refused { reason, refusal }
    }

    fn main(&self) -> Result<Range<usize>, Refused> {
        match self.source.mains.as_slice() {
            [main] => Ok(main.clone()),
            mains => {
                let what = format!("the file has {} main programs", mains.len());
                Err(self.refuse(Reason::NoBlock, what, "name a file that has one"))
            }
        }
    }

    /// The first block with words on the line or after it.
    fn block(&self, main: &Range<usize>) -> Result<usize, Refused> {
        let blocks = &self.source.blocks;
        let last = blocks.last().map_or(0, |block| block.line);
        if self.line == 0 || self.line > last {
            let what = format!("the program has no line {}", self.line);
            return Err(self.refuse(Reason::NoBlock, what, format!("it ends at line {last}")));
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
            self.refuse(Reason::NoBlock, "nothing to do follows the line", "name an earlier line")
        })
    }

    /// The block is carried out once, by the main program: after how many blocks, and where the first is.
    fn once(&self, way: &Way, at: usize) -> Result<(u64, u32), Refused> {
        if let (Some(caller), None) = (way.caller, way.ran) {
            return Err(self.refuse(
                Reason::Called,
                "the line is in a called program",
                format!("begin at line {caller}, which calls it"),
            ));
        }
        let Some(ran) = way.ran else {
            let what = "the run never comes to this line";
            return Err(self.refuse(Reason::NoBlock, what, "name a line that is carried out"));
        };
        let first = way.first.unwrap_or(0);
        if ran == 0 || self.source.start_of(at) <= first {
            return Err(self.refuse(Reason::Beginning, "the program begins there", RUN_IT));
        }
        if way.times > 1 || way.caller.is_some() {
            let what = format!("the line is carried out {} times", way.times);
            let help = "begin before the loop, the repeat or the jump";
            return Err(self.refuse(Reason::Repeated, what, help));
        }
        Ok((ran, first))
    }

    /// The program is followed, without an error, up to the block.
    fn verified(&self, at: usize) -> Result<(), Refused> {
        let report = self.job.check();
        let start = self.source.start_of(at);
        let is_before = |span: chordal::Span| span.file != FileId(0) || span.range.start < start;
        if let Some(span) = report.not_verified_from.filter(|span| is_before(*span)) {
            let line = self.line_of(span);
            let what = format!("the path is not verified from line {line} on");
            return Err(self.refuse(Reason::Unsure, what, format!("begin before line {line}")));
        }
        let is_error = |one: &&chordal::Diagnostic| {
            one.severity == Severity::Error && is_before(one.primary.span)
        };
        if let Some(error) = report.diagnostics.iter().find(is_error) {
            let line = self.line_of(error.primary.span);
            let what =
                format!("the program has an error before it, at line {line}: {}", error.message);
            return Err(self.refuse(Reason::Unsure, what, "correct that first"));
        }
        Ok(())
    }

    fn line_of(&self, span: chordal::Span) -> u32 {
        self.job.sources().get(span.file).map_or(0, |source| source.line_of(span.range.start))
    }

    /// Nothing is open before the block that a head cannot say again.
    fn closed(&self, before: &Before) -> Result<(), Refused> {
        let Before { modal, open, .. } = before;
        if modal.side != Side::Off {
            let what = "cutter compensation is on";
            return Err(self.begun(Reason::Compensation, what, open.compensation));
        }
        let control = self.job.control();
        if modal.cycle.is_some()
            && let Err(what) = before.cycle.lines(modal, control, "")
        {
            return Err(self.begun(Reason::Cycle, what, open.cycle));
        }
        if modal.frames.any() {
            let what = "the coordinates are rotated, scaled, mirrored or polar";
            return Err(self.begun(Reason::Frame, what, open.frame));
        }
        if open.shift.is_some() {
            let what = "the zero was moved (G92 after a move, or by a value that is no number)";
            return Err(self.begun(Reason::Shift, what, open.shift));
        }
        if open.call.is_some() {
            return Err(self.begun(Reason::Open, "a modal call is in force", open.call));
        }
        if open.corner.is_some() {
            return Err(self.begun(Reason::Open, "a corner is not made yet", open.corner));
        }
        if let Some((code, line)) = &open.unknown {
            let what = format!("Chordal does not carry out {code}, which may be in force");
            return Err(self.begun(Reason::Open, what, Some(*line)));
        }
        Ok(())
    }

    /// Refused for what a line began.
    fn begun(&self, reason: Reason, what: impl Into<String>, line: Option<u32>) -> Refused {
        let help = match line {
            Some(line) => format!("begin at line {line}, where that begins, or before"),
            None => "begin before it".into(),
        };
        self.refuse(reason, what, help)
    }

    /// No loop, jump or variable spans the block.
    fn apart(&self, main: &Range<usize>, at: usize) -> Result<(), Refused> {
        let start = self.source.start_of(at);
        let held = stretches(self.job, self.source, main);
        let Some(held) = held.iter().find(|held| held.holds(start)) else { return Ok(()) };
        let line = self.source.blocks[self.source.first_at(held.from())].line;
        let what = format!("{} begins before the line and is needed after it", held.what);
        Err(self.refuse(Reason::Repeated, what, format!("begin at line {line} or before")))
    }

    fn position(&self, modal: &Modal) -> Refused {
        let missing: String = (0..3)
            .filter(|axis| !modal.known.has(*axis))
            .map(|axis| "XYZ".as_bytes()[axis] as char)
            .collect();
        let what = format!("the position in {missing} is not known");
        let help = "begin at a tool change, or after a block that names X, Y and Z";
        self.refuse(Reason::Position, what, help)
    }

    fn lack(&self, Lack(what): Lack) -> Refused {
        self.refuse(Reason::Form, what, "begin at another line, best at a tool change")
    }

    /// The new text, if it does the same.
    fn prove(&self, draft: Draft) -> Result<Restart, Refused> {
        let (text, from) = self.text(&draft);
        let places = Places { kept: draft.first, from };
        let start = from[1] + self.source.start_of(draft.at) - from[0];
        let new = main_of(self.job.with_text(text), start);
        let source = Source::of(&new);
        let unproved = |what: String| {
            self.refuse(Reason::Unproved, what, "begin at another line, best at a tool change")
        };
        let at = source.first_at(start);
        let way = Way::to(&new, &source, &(0..source.blocks.len()), at);
        let Some(ran) = way.ran else {
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
        let old = Trace::of(self.job, draft.ran);
        let trace = Trace::of(&new, ran);
        let care = Care { exact: !draft.approaches, settled: false };
        if let Some(unlike) = old.unlike(&trace, places, care) {
            let what = format!("line {} would not do the same: {}", unlike.line, unlike.what);
            return Err(unproved(what));
        }
        let text = source.text.to_vec();
        let Draft { lines: head, approaches, from_the_start, .. } = draft;
        Ok(Restart { text, line: self.line, head, moves: old.moves, approaches, from_the_start })
    }

    /// The text, and where the old one goes on: in the old text and in the new one.
    fn text(&self, draft: &Draft) -> (Vec<u8>, [u32; 2]) {
        let old = self.source.text;
        let crlf = old.windows(2).any(|pair| pair == b"\r\n");
        let line_end = if crlf { "\r\n" } else { "\n" };
        let from = self.source.start_of(self.source.blocks_on(self.line, u32::MAX).start);
        let mut text = old[..draft.first as usize].to_vec();
        let told = format!("(BEGINS AT LINE {} OF {})", self.line, self.file());
        for line in std::iter::once(&told).chain(&draft.lines) {
            text.extend_from_slice(line.as_bytes());
            text.extend_from_slice(line_end.as_bytes());
        }
        let to = text.len() as u32;
        text.extend_from_slice(&old[from as usize..]);
        (text, [from, to])
    }

    /// The name of the file, without what a comment cannot have.
    fn file(&self) -> String {
        let name = self.job.sources().get(FileId(0)).map_or("", |source| source.name());
        let name = name.rsplit(['/', '\\']).next().unwrap_or(name).to_ascii_uppercase();
        name.chars()
            .map(|c| if c.is_ascii_alphanumeric() || ".-_".contains(c) { c } else { ' ' })
            .collect()
    }
}

/// The job of the program that a byte of the text is in: programs that nothing calls any more are not mains.
fn main_of(job: Job<'_>, at: u32) -> Job<'_> {
    let programs = job.programs();
    let holds =
        |program: &chordal::TextProgram| program.head.start.offset <= at && at < program.head.end;
    match programs.iter().position(holds) {
        Some(place) if programs.len() > 1 => job.program_at(place),
        _ => job,
    }
}
