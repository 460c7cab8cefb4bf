//! The F words: which blocks need one, and how it is written.

use std::collections::{HashMap, HashSet};

use chordal::Job;
use chordal::control::{FeedMode, Units};
use chordal::diagnostics::FileId;
use chordal::syntax::{Block, Word, WordValue};

use super::super::edit::{TransformRefusal, WordEdit, with_number};
use super::super::writer::WordWriter;
use crate::walk::walk;

/// Digits of a new feed: it is rounded down to three.
const DIGITS: i32 = 3;
/// Decimals that a feed may have.
const DECIMALS: u8 = 4;
/// Feeds that differ by less than this share are the same: rounding of a unit.
const EQUAL_FEED_SHARE: f64 = 1e-12;
/// The most rounds until every block has the feed it needs: loops and subprograms take a few.
const MAX_FEED_ROUNDS: usize = 1000;

const REASON: &str = "the feed for what the tool meets here";
const BACK: &str = "the feed that it had";

/// The new text as edits.
pub(super) struct FeedText {
    pub edits: Vec<WordEdit>,
    /// The blocks whose moves have another feed.
    pub changed: HashSet<u32>,
}

/// A block of the text that ran.
struct ExecutedBlock {
    block: Block,
    /// Its F, where it is a feed.
    own: Option<Word>,
}

/// A block that ran.
#[derive(Clone, Copy, Debug, PartialEq)]
struct RunVisit {
    /// The byte that it begins at, in the first text.
    block: Option<u32>,
    line: u32,
    /// The F that a move of it used, and what it counts.
    used: Option<(f64, FeedMode)>,
    units: Units,
}

/// All blocks that ran, in order.
fn run_visits(job: &Job) -> Vec<RunVisit> {
    let mut visits = Vec::new();
    walk(job, |visit| {
        let span = visit.origin.span;
        let feed = visit.output.commands.iter().rev().find_map(|command| command.kind.feed());
        visits.push(RunVisit {
            block: (span.file == FileId(0)).then_some(span.range.start),
            line: visit.origin.line,
            used: feed.map(|feed| (feed.value, feed.mode)),
            units: visit.modal().units,
        });
    });
    visits
}

/// Writes F words so that every block of `wanted` runs at its share of its feed, and all others as before.
pub(super) fn write(job: &Job, feeds: &HashMap<u32, f64>) -> Result<FeedText, TransformRefusal> {
    let writer = WordWriter::new(job);
    let visits = run_visits(job);
    let places = places(&writer);
    let mut targets: HashMap<u32, f64> = HashMap::new();
    for visit in &visits {
        let (Some(block), Some((value, FeedMode::PerTime))) = (visit.block, visit.used) else {
            continue;
        };
        let Some(&share) = feeds.get(&block).filter(|share| **share != 1.0) else { continue };
        let target = rounded(per_minute(value, visit.units) * share);
        match targets.get(&block) {
            // One word cannot be two feeds: the slower one, which is slow enough for both.
            Some(known) if *known <= target => {}
            _ => {
                targets.insert(block, target);
            }
        }
    }
    // An F that is not a number cannot be replaced by what it is once.
    targets.retain(|block, _| {
        places.get(block).is_some_and(|place| {
            place.own.as_ref().is_none_or(|word| matches!(word.value, WordValue::Number(_)))
        })
    });
    let explicit = explicit(&writer, &visits, &places, &targets)?;
    let mut edits = Vec::new();
    for (block, value) in &explicit {
        let Some(place) = places.get(block) else { continue };
        let reason = if targets.contains_key(block) { REASON } else { BACK };
        let number = writer.style.number(*value, 0, DECIMALS, true);
        edits.push(match &place.own {
            Some(word) => {
                WordEdit::new(word.range, with_number(writer.text, word, &number), reason)
            }
            None => {
                let gap = writer.style.gap();
                WordEdit::insert(end_of_words(&place.block), format!("{gap}F{number}"), reason)
            }
        });
    }
    Ok(FeedText { edits, changed: targets.into_keys().collect() })
}

/// The blocks of words, by the byte that they begin at.
fn places(writer: &WordWriter) -> HashMap<u32, ExecutedBlock> {
    let blocks = writer.word_blocks().filter(|block| !block.words.is_empty());
    let place = |block: Block| {
        let own = block.word(b'F').copied();
        (block.range.start, ExecutedBlock { block, own })
    };
    blocks.map(place).collect()
}

/// The blocks that must have an F, with its value, so that each move has the feed it should have.
fn explicit(
    writer: &WordWriter,
    visits: &[RunVisit],
    places: &HashMap<u32, ExecutedBlock>,
    targets: &HashMap<u32, f64>,
) -> Result<HashMap<u32, f64>, TransformRefusal> {
    let mut explicit: HashMap<u32, f64> = HashMap::new();
    // A block with an F of its own keeps none but its own.
    for (block, target) in targets {
        if places.get(block).is_some_and(|place| place.own.is_some()) {
            explicit.insert(*block, *target);
        }
    }
    for _ in 0..MAX_FEED_ROUNDS {
        let mut added = false;
        // What F is now, by minute, and whether it is the program's own.
        let mut now: Option<f64> = None;
        for visit in visits {
            let place = visit.block.and_then(|block| places.get(&block));
            let written = visit.block.and_then(|block| explicit.get(&block).copied());
            let has_own = place.is_some_and(|place| place.own.is_some());
            if let Some(value) = written {
                now = Some(value);
            } else if has_own {
                now = None;
            } else if visit.block.is_none() && now.is_some() {
                // What F is after blocks of another text is not known.
                now = Some(f64::NAN);
            }
            let Some((value, mode)) = visit.used else { continue };
            let own = per_minute(value, visit.units);
            let target = visit.block.and_then(|block| targets.get(&block).copied());
            let due = target.unwrap_or(own);
            let is_due = match now {
                Some(now) => mode == FeedMode::PerTime && is_same(now, due),
                None => target.is_none(),
            };
            if is_due {
                continue;
            }
            let block = can_write(writer, visit, place, mode, due)?;
            if explicit.contains_key(&block) {
                let what = "its feed is not the same each time it runs";
                return Err(refusal(writer, visit, place, what));
            }
            explicit.insert(block, due);
            now = Some(due);
            added = true;
        }
        if !added {
            return Ok(explicit);
        }
    }
    Ok(explicit)
}

/// The block of a visit, where an F can be written in it.
fn can_write(
    writer: &WordWriter,
    visit: &RunVisit,
    place: Option<&ExecutedBlock>,
    mode: FeedMode,
    due: f64,
) -> Result<u32, TransformRefusal> {
    let stand = |what: &str| Err(refusal(writer, visit, place, what));
    let (Some(block), Some(found)) = (visit.block, place) else {
        return stand("it needs its old feed again, and no F can be written here");
    };
    if mode != FeedMode::PerTime {
        return stand("it takes the F of a block before it, and counts it otherwise");
    }
    let is_number =
        found.own.as_ref().is_none_or(|word| matches!(word.value, WordValue::Number(_)));
    let exact = writer.style.number(due, 0, DECIMALS, true).parse::<f64>();
    if !is_number || !exact.is_ok_and(|exact| is_same(exact, due)) {
        return stand("its feed cannot be written as a number of four decimals");
    }
    Ok(block)
}

fn refusal(
    writer: &WordWriter,
    visit: &RunVisit,
    place: Option<&ExecutedBlock>,
    what: &str,
) -> TransformRefusal {
    const HELP: &str = "write an F in this block, then run it again";
    match place {
        Some(place) => TransformRefusal::new(writer.text, &place.block, what, HELP),
        None => TransformRefusal {
            line: visit.line,
            text: String::new(),
            what: what.to_string(),
            help: HELP.to_string(),
        },
    }
}

/// A feed in mm/s as F counts it: by minute, in the program's units.
fn per_minute(feed: f64, units: Units) -> f64 {
    feed * 60.0 / units.mm()
}

fn is_same(a: f64, b: f64) -> bool {
    (a - b).abs() <= EQUAL_FEED_SHARE * a.abs().max(b.abs())
}

/// Down to three digits.
fn rounded(value: f64) -> f64 {
    let digits = libm::log10(value).floor() as i32 + 1;
    let decimals = (DIGITS - digits).clamp(-9, i32::from(DECIMALS));
    let scale = 10f64.powi(decimals.abs());
    let (up, down) = if decimals >= 0 { (scale, 1.0) } else { (1.0, scale) };
    // A value that is on a digit but for rounding stays.
    (value * up / down + 1e-9).floor() * down / up
}

/// After the last word of a block.
fn end_of_words(block: &Block) -> u32 {
    block.words.iter().map(|word| word.range.end).max().unwrap_or(block.range.end)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn feeds_are_rounded_down_to_three_digits() {
        for (value, down) in [
            (857.142, 857.0),
            (1234.0, 1230.0),
            (12.345, 12.3),
            (0.98765, 0.987),
            (500.0, 500.0),
            (0.012_345, 0.0123),
        ] {
            assert!((rounded(value) - down).abs() < 1e-12, "{value} {}", rounded(value));
        }
    }
}
