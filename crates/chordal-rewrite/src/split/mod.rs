//! A long program as several, each of which stands by itself.
//!
//! `points` finds where the tool stands clear and nothing is open, `open` where what one part sets or
//! begins another would need, `text` writes the parts. The parts, run one
//! after the other, are compared with the whole; a place after which something else happens is given up.

pub(crate) mod open;
mod points;
mod text;

use chordal::Job;
use chordal_compare::{Comparison, ComparisonOptions, Difference, compare_joined};

use self::points::{SafePointKind, SplitPoint, SplitSurvey};
use self::text::PartWriter;
use crate::ComparedSides;
use crate::source::SourceBlocks;
use crate::word_address::refuse_other_languages;
use crate::{Certificate, TransformRefusal};

/// So many places are given up before the parts are reported as not proved.
const MAX_TRIES: usize = 12;

/// Where a program is split.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SplitBy {
    /// So that no part has more bytes.
    Bytes(usize),
    /// Before every tool change.
    Tool,
}

/// One of the programs.
#[derive(Clone, Debug)]
pub struct ProgramPart {
    /// Its text.
    pub text: Vec<u8>,
    /// The lines of the whole that it carries out, first and last.
    pub lines: [u32; 2],
    /// Its O number, where the whole has one.
    pub number: Option<u32>,
    /// The lines that are put in so that it begins as the whole stood there.
    pub begin: Vec<String>,
    /// It begins with a tool change; otherwise where the tool stands clear of all cuts.
    pub at_tool_change: bool,
}

/// A program in parts.
#[derive(Debug)]
pub struct SplitProgram {
    /// In order.
    pub parts: Vec<ProgramPart>,
    /// What is to be known in addition to it.
    pub notes: Vec<String>,
    /// The parts, run one after the other, against the whole.
    pub certificate: Certificate,
}

/// Parts the main program of a job's first text.
///
/// # Errors
/// A stretch that has no place where it can be split, with its lines.
pub fn split(job: &Job, by: SplitBy) -> Result<SplitProgram, TransformRefusal> {
    refuse_other_languages(job)?;
    let source = SourceBlocks::of(job);
    let [main] = source.mains.as_slice() else {
        let count = source.mains.len();
        return Err(refusal(
            1,
            format!("the file has {count} main programs"),
            "split a file that has one",
        ));
    };
    let mut survey = SplitSurvey::of(job, &source, main);
    if source.blocks.iter().all(|block| block.words.is_empty()) {
        return Err(refusal(1, "there is no program to split".into(), "name a file that has one"));
    }
    let open = open::unsplittable_ranges(job, &source, main);
    let mut stationary_notes: Vec<String> = survey
        .unknown
        .iter()
        .map(|(code, line)| {
            format!("Chordal does not carry out {code} (line {line}): if it stays active, write it into each part")
        })
        .collect();
    survey.points.retain(|point| {
        let retained = open.iter().find(|open| open.holds(source.start_of(point.at)));
        if let (Some(retained), SplitBy::Tool, SafePointKind::ToolChange) =
            (retained, by, point.kind)
        {
            let line = source.blocks[point.at].line;
            stationary_notes
                .push(format!("not split before line {line}, inside {}", retained.what));
        }
        retained.is_none()
    });
    let mut provided_up = Vec::new();
    loop {
        let made = parts(job, &source, &survey, by);
        let (parts, rounded_mm) = made.map_err(|mut refusal| {
            for note in notes(&provided_up) {
                refusal.what += &format!("; {note}");
            }
            refusal
        })?;
        let comparison = prove(job, &parts, rounded_mm);
        let certificate = Certificate {
            comparison,
            expected: Vec::new(),
            tolerance_mm: rounded_mm,
            tool_center: None,
            sides: ComparedSides::default(),
        };
        let differences = &certificate.comparison.differences;
        let begin = differences.iter().find_map(|difference| begin_before(difference, &parts));
        let Some(begin) = begin.filter(|_| provided_up.len() < MAX_TRIES) else {
            let parts = parts.into_iter().map(|(part, _)| part).collect();
            stationary_notes.extend(notes(&provided_up));
            return Ok(SplitProgram { parts, notes: stationary_notes, certificate });
        };
        survey.points.retain(|point| source.blocks[point.at].line != begin);
        provided_up.push(begin);
    }
}

fn notes(provided_up: &[u32]) -> Vec<String> {
    provided_up
        .iter()
        .map(|line| {
            format!("not split before line {line}: the blocks after it would not do the same")
        })
        .collect()
}

/// The first line of the part that something differs in: what differs follows from how it begins.
fn begin_before(difference: &Difference, parts: &[(ProgramPart, text::PartText)]) -> Option<u32> {
    // What one of the two lacks is reported after the block before it.
    let line = difference.blocks.iter().flatten().map(|blocks| blocks.first.line).max()?;
    parts.iter().skip(1).map(|(part, _)| part.lines[0]).rfind(|from| *from <= line)
}

fn refusal(line: u32, what: String, help: &str) -> TransformRefusal {
    TransformRefusal { line, text: String::new(), what, help: help.into() }
}

/// The parts with the text that each has from the whole, and by how much places were rounded, mm.
type WrittenParts = (Vec<(ProgramPart, text::PartText)>, f64);

fn parts(
    job: &Job,
    source: &SourceBlocks,
    survey: &SplitSurvey,
    by: SplitBy,
) -> Result<WrittenParts, TransformRefusal> {
    // Tools that cut nothing are no parts of their own.
    let tools = || -> Vec<SplitPoint> {
        let mut points: Vec<SplitPoint> = survey.points.to_vec();
        points.retain(|point| point.kind == SafePointKind::ToolChange);
        points.dedup_by_key(|point| point.cuts);
        points
    };
    // What the first part and the others have in addition to their blocks is known once they are written.
    let mut adjacent = [0; 2];
    loop {
        let chosen = match by {
            SplitBy::Tool => tools(),
            SplitBy::Bytes(most) => choose(source, survey, most, adjacent)?,
        };
        let stationary = text::states_at(job, source, &chosen);
        let writer = PartWriter::new(job, source, survey);
        let (parts, rounded_mm) = writer.parts(&chosen, &stationary);
        let SplitBy::Bytes(most) = by else { return Ok((parts, rounded_mm)) };
        let over = |part: &(ProgramPart, text::PartText)| part.0.text.len().saturating_sub(most);
        let first = parts.first().map_or(0, over);
        let others = parts.iter().skip(1).map(over).max().unwrap_or(0);
        if first == 0 && others == 0 {
            return Ok((parts, rounded_mm));
        }
        adjacent = [adjacent[0] + first, adjacent[1] + others];
    }
}

/// The fewest places between which there are no more bytes, those before tool changes preferred where a
/// part is at least half full then.
fn choose(
    source: &SourceBlocks,
    survey: &SplitSurvey,
    most: usize,
    other_bytes: [usize; 2],
) -> Result<Vec<SplitPoint>, TransformRefusal> {
    let mut chosen: Vec<SplitPoint> = Vec::new();
    let end = source.end_of(survey.end);
    let mut from = 0;
    loop {
        let adjacent = other_bytes[usize::from(from > 0)];
        if (end - from) as usize + adjacent <= most {
            return Ok(chosen);
        }
        let room = most.saturating_sub(adjacent);
        let at = |point: &SplitPoint| source.start_of(point.at);
        let ahead = || survey.points.iter().filter(|point| at(point) > from && at(point) < end);
        let fits = |point: &&SplitPoint| (at(point) - from) as usize <= room;
        let is_half = |point: &&SplitPoint| (at(point) - from) as usize * 2 >= room;
        let tool = ahead().take_while(fits).filter(is_half);
        let tool = tool.filter(|point| point.kind == SafePointKind::ToolChange).last();
        // Near the end of the room the highest one is the safest, and of several of one height the last.
        let is_near = |point: &&SplitPoint| (at(point) - from) as usize * 10 >= room * 9;
        let clear = || ahead().take_while(fits);
        let highest = || clear().filter(is_near).max_by(|a, b| a.height.0.total_cmp(&b.height.0));
        let Some(next) = tool.or_else(highest).or_else(|| clear().last()) else {
            let line = source.blocks[source.first_at(from)].line;
            let (what, help) = match ahead().next() {
                Some(point) => {
                    let to = source.blocks[point.at].line;
                    let bytes = (at(point) - from) as usize + adjacent;
                    let what = format!(
                        "from line {line} to line {} there is no point to split the program: a part \
                         would have {bytes} bytes, {} more than allowed",
                        to - 1,
                        bytes - most
                    );
                    (what, "allow larger parts, or retract above all cuts in between")
                }
                None => (
                    format!(
                        "from line {line} on there is no point to split the program, and the rest has {} \
                         bytes: neither a tool change nor a block where the tool is above all cuts \
                         and nothing is open",
                        (end - from) as usize + adjacent
                    ),
                    "retract above all cuts in between, with G40 and G80 active and outside of loops; \
                     blocks that set variables must be in the part that uses them",
                ),
            };
            return Err(refusal(line, what, help));
        };
        from = at(next);
        chosen.push(*next);
    }
}

fn prove(job: &Job, parts: &[(ProgramPart, text::PartText)], rounded_mm: f64) -> Comparison {
    let jobs: Vec<Job> = parts.iter().map(|(part, _)| job.with_text(part.text.clone())).collect();
    let parts: Vec<chordal_compare::JoinedPart> = parts
        .iter()
        .zip(&jobs)
        .map(|((_, kept), job)| chordal_compare::JoinedPart {
            job,
            body: kept.body.clone(),
            other_texts: kept.other_texts.clone(),
        })
        .collect();
    let options = ComparisonOptions { tolerance_mm: rounded_mm, ..ComparisonOptions::default() };
    compare_joined(job, &parts, &options)
}
