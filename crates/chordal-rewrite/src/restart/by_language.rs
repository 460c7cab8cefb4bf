//! Programs of languages that write their heads themselves: the language writes the text, which is proved here like any other.

use chordal::control::{RestartFault, RestartedText};
use chordal::diagnostics::FileId;
use chordal::{Job, Severity};

use super::trace::{EventTrace, MatchLevel, ReplacedRange};
use super::{RefusalReason, RestartProgram, RestartRefusal, doubt_before};
use crate::TransformRefusal;
use crate::source::first_text;
use crate::walk::walk;
use crate::word_address::refusal_of_language;

/// What to do where a text is not proved.
const ELSE: &str = "begin at another line, best at a change of the tool";

/// Writes the program of a job so that it begins at a line, with a head of its language or with the one of `provided`, and
/// proves it.
pub(super) fn begin_by_language(
    job: &Job,
    line: u32,
    provided: Option<&[u8]>,
) -> Result<RestartProgram, RestartRefusal> {
    let refuse = |RestartFault { obstacle, what, help }: RestartFault| {
        let text = String::from_utf8_lossy(first_text(job));
        let text = text.lines().nth(line.saturating_sub(1) as usize).unwrap_or("").trim().into();
        RestartRefusal { reason: obstacle, refusal: TransformRefusal { line, text, what, help } }
    };
    let set = job.program_set();
    let main = job.mains(set.as_ref()).first().copied();
    let Some(written) = main.and_then(|main| set.restarted(main, line)) else {
        // No head of this language is written.
        let refusal = refusal_of_language(job).into();
        return Err(RestartRefusal { reason: RefusalReason::Form, refusal });
    };
    let written = written.map_err(refuse)?;
    // In which order a cycle has cut counts no more where it is done.
    let report = job.check();
    if let Some((what, help)) = doubt_before(job, &report, report.path_lost_from, written.block) {
        return Err(refuse(RestartFault { obstacle: RefusalReason::Unsure, what, help }));
    }
    let unproved =
        |(what, help)| refuse(RestartFault { obstacle: RefusalReason::Unproved, what, help });
    let written = with_head_of(written, provided).map_err(unproved)?;
    let moves = prove(job, &written).map_err(|what| unproved((what, ELSE.into())))?;
    let head_bytes = written.kept..written.begins[1];
    Ok(RestartProgram {
        text: written.text,
        line,
        head: written.head,
        head_bytes,
        after_the_end: Vec::new(),
        moves,
        approaches: written.approaches,
        from_the_start: false,
        unrepeated: written.unrepeated,
    })
}

/// The text with the head of another one, whose rest must be the same.
fn with_head_of(
    mut written: RestartedText,
    provided: Option<&[u8]>,
) -> Result<RestartedText, (String, String)> {
    let Some(provided) = provided else { return Ok(written) };
    let rest = &written.text[written.begins[1] as usize..];
    let first = &written.text[..written.kept as usize];
    if !provided.ends_with(rest) || !provided.starts_with(first) {
        let what = "the text from this line on, or before the head, is another one";
        return Err((what.into(), "change the lines of the head alone".into()));
    }
    let begin = std::mem::replace(&mut written.begins[1], (provided.len() - rest.len()) as u32);
    for (_, place) in written.moved.iter_mut().filter(|(_, place)| *place >= begin) {
        *place = *place - begin + written.begins[1];
    }
    written.text = provided.to_vec();
    Ok(written)
}

/// How many moves follow, where the new text does the same from its line on.
fn prove(job: &Job, written: &RestartedText) -> Result<u64, String> {
    let new = job.with_text(written.text.clone());
    let RestartedText { kept, begins, block, ref moved, .. } = *written;
    let start = block - begins[0] + begins[1];
    let ran = blocks_before(job, block).ok_or("the run never comes to the line")?;
    let new_ran = blocks_before(&new, start).ok_or("the new program never comes to the line")?;
    let error = new.check().diagnostics.into_iter().find(|one| {
        let span = one.primary.span;
        let is_head = span.range.start >= kept && span.range.start < begins[1];
        one.severity == Severity::Error && span.file == FileId(0) && is_head
    });
    if let Some(error) = error {
        return Err(format!("the control refuses the head: {}", error.message));
    }
    let places = ReplacedRange { kept, from: begins, contours: moved.clone() };
    let (old, trace) = (EventTrace::of(job, ran), EventTrace::of(&new, new_ran));
    let care = MatchLevel {
        exact: !written.approaches,
        free_items: written.free_items,
        ..MatchLevel::default()
    };
    if let Some(what) = old.begins_otherwise(&trace, care) {
        return Err(format!("{what} is another one where the program begins"));
    }
    match old.unlike(&trace, &places, care) {
        Some(unlike) => Err(format!("line {} would not do the same: {}", unlike.line, unlike.what)),
        None => Ok(old.moves),
    }
}

/// How many blocks are carried out before the main program comes to the block at a byte of the first text.
fn blocks_before(job: &Job, at: u32) -> Option<u64> {
    let mut ran = None;
    walk(job, |visit| {
        let span = visit.origin.span;
        if ran.is_none() && visit.is_main() && span.file == FileId(0) && span.range.start == at {
            ran = Some(visit.ran);
        }
    });
    ran
}
