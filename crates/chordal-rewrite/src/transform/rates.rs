//! Feeds and spindle speeds by a factor.

use chordal::Job;
use chordal::control::Units;
use chordal::diagnostics::TextRange;
use chordal::syntax::{Block, Word, WordValue};
use chordal_compare::RunMapping;

use super::StepOutcome;
use super::edit::{TransformRefusal, WordEdit, with_number};
use super::record::{ReadingContext, RunRecord};
use super::roles::{NumberRole, roles};
use super::writer::WordWriter;

/// Decimals that an F may get.
const FEED_DIGITS: u8 = 4;

/// The edits that multiply feeds and spindle speeds.
pub(super) fn rates(job: &Job, feed: f64, speed: f64) -> Result<StepOutcome, TransformRefusal> {
    let record = RunRecord::with_contours(job);
    let writer = WordWriter::new(job);
    let mut outcome = StepOutcome {
        mapping: RunMapping { feed, speed, ..RunMapping::default() },
        // S is a whole number.
        feed_tolerance: 1e-2,
        speed_tolerance: 1e-2,
        ..StepOutcome::default()
    };
    for block in writer.word_blocks() {
        let Some(runs) = record.blocks.get(&block.range.start) else { continue };
        let rates = |context: &_| block_rates(&writer, &block, context, [feed, speed]);
        outcome.edits.extend(runs.edits_of_all(rates)?.ok_or_else(|| {
            TransformRefusal::new(
                writer.text,
                &block,
                "its F is sometimes the feed of a tap and sometimes that of a cut",
                "write a separate F for each",
            )
        })?);
    }
    Ok(outcome)
}

fn block_rates(
    writer: &WordWriter,
    block: &Block,
    context: &ReadingContext,
    [feed, speed]: [f64; 2],
) -> Result<Vec<WordEdit>, TransformRefusal> {
    let mut edits = Vec::new();
    for (word, role) in block.words.iter().zip(roles(block, context, writer.control)) {
        let feeds = RateWord::Feed([context.units; 2]);
        let (factor, rate, reason) = match role {
            NumberRole::TapFeed => (speed, feeds, "the feed of a tap follows the spindle"),
            NumberRole::Feed => (feed, feeds, "another feed"),
            NumberRole::Speed => (speed, RateWord::Speed, "a new spindle speed"),
            _ => continue,
        };
        if factor != 1.0 {
            let text = scaled(writer, block, word, factor, rate)?;
            edits.push(WordEdit::new(word.range, text, reason));
        }
    }
    Ok(edits)
}

/// What a word says of speed.
#[derive(Clone, Copy, Debug)]
pub(super) enum RateWord {
    /// A feed, in the units before and now.
    Feed([Units; 2]),
    Speed,
}

/// Decimals of a feed for each revolution, or of a lead: six figures, eight decimals at most.
fn digits_of_small(value: f64) -> u8 {
    let before = value.abs().max(1e-3).log10().floor() as i32;
    (5 - before).clamp(i32::from(FEED_DIGITS), 8) as u8
}

/// An F or S word with its value multiplied.
pub(super) fn scaled(
    writer: &WordWriter,
    block: &Block,
    word: &Word,
    factor: f64,
    rate: RateWord,
) -> Result<String, TransformRefusal> {
    // What an F of 1 without a point is, in inches or millimetres.
    let unit = |units: Units| match units {
        Units::Inch => 0.1f64.powi(i32::from(writer.control.parameters.feed_digits_inch)),
        Units::Millimetre => 1.0,
    };
    match word.value {
        WordValue::Number(number) => {
            let text = match rate {
                RateWord::Speed => {
                    let digits = if number.has_point { number.scale } else { 0 };
                    let value = number.to_f64() * factor;
                    writer.style.number(value, 0, digits, number.has_point)
                }
                RateWord::Feed([from, to]) => {
                    let old = if number.has_point { 1.0 } else { unit(from) };
                    let value = number.to_f64() * old * factor;
                    let whole = value / unit(to);
                    if !number.has_point && (whole - whole.round()).abs() < 1e-9 * whole.abs() {
                        format!("{}", whole.round())
                    } else {
                        let least = if writer.control.table.turns() {
                            digits_of_small(value)
                        } else {
                            FEED_DIGITS
                        };
                        writer.style.number(value, 0, least.max(number.scale), true)
                    }
                }
            };
            Ok(with_number(writer.text, word, &text))
        }
        WordValue::Expression(range) => {
            let head = TextRange::new(word.range.start, range.start).slice(writer.text);
            let old = String::from_utf8_lossy(range.slice(writer.text));
            let factor = writer.style.number(factor, 0, 6, true);
            Ok(format!("{}[{}*{factor}]", String::from_utf8_lossy(head), old.trim()))
        }
        WordValue::Register { .. } | WordValue::Missing => Err(TransformRefusal::new(
            writer.text,
            block,
            format!("the value of `{}` is not written in the block", writer.word(word)),
            "write its value as a number",
        )),
    }
}
