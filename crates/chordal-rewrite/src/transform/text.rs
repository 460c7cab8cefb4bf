//! What is written and does nothing: block numbers, comments, blanks, digits.

use std::collections::HashSet;

use chordal::Job;
use chordal::diagnostics::{TextRange, line_end_length};
use chordal::syntax::{Block, BlockKind, Word, WordValue};
use chordal_editor::{NameRole, NumberingOptions, SymbolName};

use crate::blocks::blocks_of;
use crate::source::{first_text, program};

use super::StepOutcome;
use super::edit::{TransformRefusal, WordEdit, apply, changes, line_end};
use crate::word_address::BlockControl;

/// New block numbers, and jumps that go to them.
pub(super) fn renumber(job: &Job, first: u32, step: u32) -> Result<StepOutcome, TransformRefusal> {
    let Some(program) = program(job) else { return Ok(StepOutcome::default()) };
    let numbering = NumberingOptions { first, step, all: false };
    let edits = program.renumbered(numbering).map_err(|error| TransformRefusal {
        line: 1,
        text: String::new(),
        what: error.to_string(),
        help: "keep the numbers, or write the jump with a number".into(),
    })?;
    let edits = edits
        .into_iter()
        .map(|edit| WordEdit::new(edit.range, edit.text, "numbered anew"))
        .collect();
    Ok(StepOutcome { edits, ..StepOutcome::default() })
}

/// Takes out the numbers that nothing jumps to.
pub(super) fn no_numbers(job: &Job) -> StepOutcome {
    const REASON: &str = "nothing jumps to this number";
    let text = first_text(job);
    let Some(program) = program(job) else { return StepOutcome::default() };
    let target: HashSet<i64> = program
        .occurrences()
        .into_iter()
        .filter(|place| place.role == NameRole::Use)
        .filter_map(|place| match place.name {
            SymbolName::Label { number, .. } => Some(number),
            _ => None,
        })
        .collect();
    let mut outcome = StepOutcome::default();
    if computed_jump(job) {
        outcome.notes.push("a jump computes its number: all numbers stay".into());
        return outcome;
    }
    each_block(job, |block| {
        let Some(word) = block.words.first().filter(|word| word.letter == b'N') else { return };
        let number = word.number().and_then(|number| number.to_integer());
        if number.is_none_or(|number| target.contains(&number)) || block.all(b'N').count() > 1 {
            return;
        }
        let after = text.get(word.range.end as usize..).unwrap_or(&[]);
        let blanks = after.iter().take_while(|byte| **byte == b' ').count() as u32;
        let range = TextRange::new(word.range.start, word.range.end + blanks);
        outcome.edits.push(WordEdit::new(range, "", REASON));
    });
    outcome
}

/// A jump to a number that is worked out.
fn computed_jump(job: &Job) -> bool {
    let text = first_text(job);
    let mut found = false;
    each_block(job, |block| {
        if let BlockKind::Macro(range) = block.kind {
            let words = range.slice(text).to_ascii_uppercase();
            let after =
                words.windows(4).position(|word| word == b"GOTO").map(|at| &words[at + 4..]);
            let first = after.and_then(|bytes| bytes.iter().find(|byte| **byte != b' '));
            found |= first.is_some_and(|byte| !byte.is_ascii_digit());
        }
    });
    found
}

/// Takes out comments, and lines that hold nothing else.
pub(super) fn strip_comments(job: &Job) -> StepOutcome {
    const REASON: &str = "a comment";
    /// Comments that LinuxCNC acts upon.
    const ACTIVE: [&str; 6] = ["MSG", "DEBUG", "PRINT", "LOG", "PROBEOPEN", "PROBECLOSE"];
    let text = first_text(job);
    let mut outcome = StepOutcome::default();
    each_block(job, |block| {
        let is_idle = block.words.is_empty() && block.kind == BlockKind::Words;
        let mut gone = Vec::new();
        for comment in &block.comments {
            let words = String::from_utf8_lossy(comment.slice(text)).to_ascii_uppercase();
            let words = words.trim_start_matches(['(', ';', ' ']);
            if ACTIVE.iter().any(|active| words.starts_with(active)) {
                return;
            }
            let blanks = text[block.range.start as usize..comment.start as usize]
                .iter()
                .rev()
                .take_while(|byte| byte.is_ascii_whitespace())
                .count() as u32;
            gone.push(WordEdit::new(
                TextRange::new(comment.start - blanks, comment.end),
                "",
                REASON,
            ));
        }
        let left = block.range.len() - gone.iter().map(|edit| edit.range.len()).sum::<u32>();
        let line = TextRange::new(block.range.start, line_end(text, block.range.end));
        let is_alone = !gone.is_empty()
            && is_idle
            && left <= 1
            && text[..line.start as usize].last().is_none_or(|byte| matches!(byte, b'\n' | b'\r'))
            && line.slice(text).len() == block.range.len() as usize;
        if is_alone {
            let rest = &text[line.end as usize..];
            let end = line.end + if rest.is_empty() { 0 } else { line_end_length(rest) as u32 };
            gone = vec![WordEdit::new(TextRange::new(block.range.start, end), "", REASON)];
        }
        outcome.edits.append(&mut gone);
    });
    outcome
}

/// A way to make a text shorter.
type ShorteningStep = fn(&Job) -> StepOutcome;

/// Makes the text no longer than so many bytes: by blanks, then digits, then numbers, then comments.
pub(super) fn shrink(job: &Job, most: usize) -> Result<StepOutcome, TransformRefusal> {
    let old = first_text(job);
    let mut text = old.to_vec();
    let (mut done, mut made) = (Vec::new(), Vec::new());
    let shortenings: [(&str, ShorteningStep); 4] = [
        ("blanks", blanks),
        ("digits", digits),
        ("block numbers", no_numbers),
        ("comments", strip_comments),
    ];
    for (name, path) in shortenings {
        if text.len() <= most {
            break;
        }
        let now = job.with_text(text);
        let mut outcome = path(&now);
        text = apply(first_text(&now), &mut outcome.edits);
        made.extend(changes(first_text(&now), &outcome.edits));
        done.push(name);
    }
    if text.len() > most {
        return Err(TransformRefusal {
            line: 1,
            text: String::new(),
            what: format!(
                "without {} the program still has {} bytes, {} more than allowed",
                done.join(", "),
                text.len(),
                text.len() - most
            ),
            help: "write repeated blocks as subprograms, or fit arcs (--fit)".into(),
        });
    }
    let mut outcome = StepOutcome::default();
    if done.is_empty() {
        outcome.notes.push(format!("it has {} bytes: there is nothing to do", old.len()));
    } else {
        outcome.notes.push(format!("taken out: {}", done.join(", ")));
        outcome.whole = Some((text, made));
    }
    Ok(outcome)
}

/// Takes out blanks between words and at the ends of lines.
fn blanks(job: &Job) -> StepOutcome {
    let text = first_text(job);
    let mut outcome = StepOutcome::default();
    let keeps = job.control().table.lexicon.o_words;
    each_block(job, |block| {
        if block.kind != BlockKind::Words || !block.problems.is_empty() {
            return;
        }
        // O words of flow control hold names.
        if keeps && block.word(b'O').is_some() {
            return;
        }
        let mut pieces: Vec<TextRange> = block.words.iter().map(|word| word.range).collect();
        pieces.extend(&block.comments);
        pieces.sort_by_key(|range| range.start);
        let mut at = block.range.start;
        let mut gap = |from: u32, to: u32| {
            let range = TextRange::new(from, to);
            let is_blank = range.slice(text).iter().all(|byte| matches!(byte, b' ' | b'\t'));
            if is_blank && !range.is_empty() {
                outcome.edits.push(WordEdit::new(range, "", "blanks"));
            }
        };
        for piece in pieces {
            gap(at, piece.start);
            at = piece.end;
        }
        gap(at, block.range.end);
    });
    outcome
}

/// Takes out digits without meaning: zeros at both ends, plus signs.
fn digits(job: &Job) -> StepOutcome {
    let text = first_text(job);
    let mut outcome = StepOutcome::default();
    each_block(job, |block| {
        if block.kind != BlockKind::Words || !block.problems.is_empty() {
            return;
        }
        for word in &block.words {
            let short = shorter(text, word);
            if let Some(short) = short {
                outcome.edits.push(WordEdit::new(word.range, short, "digits without meaning"));
            }
        }
    });
    outcome
}

/// A word with fewer digits; `None` where it has none to spare.
fn shorter(text: &[u8], word: &Word) -> Option<String> {
    let WordValue::Number(_) = word.value else { return None };
    if b"ON".contains(&word.letter) || word.register.is_some() {
        return None;
    }
    let old = String::from_utf8_lossy(word.range.slice(text)).into_owned();
    let at = old.find(|letter: char| letter.is_ascii_digit() || "+-.".contains(letter))?;
    let (head, number) = old.split_at(at);
    if number.contains(' ') || word.comma {
        return None;
    }
    let (sign, digits) = match number.strip_prefix('-') {
        Some(digits) => ("-", digits),
        None => ("", number.trim_start_matches('+')),
    };
    let new = match digits.split_once('.') {
        Some((whole, part)) => {
            let (whole, part) = (whole.trim_start_matches('0'), part.trim_end_matches('0'));
            let whole = if whole.is_empty() && part.is_empty() { "0" } else { whole };
            format!("{head}{sign}{whole}.{part}")
        }
        None => {
            let whole = digits.trim_start_matches('0');
            format!("{head}{sign}{}", if whole.is_empty() { "0" } else { whole })
        }
    };
    (new.len() < old.len()).then_some(new)
}

fn each_block(job: &Job, mut see: impl FnMut(&Block)) {
    blocks_of(first_text(job), job.control()).for_each(|block| see(&block));
}
