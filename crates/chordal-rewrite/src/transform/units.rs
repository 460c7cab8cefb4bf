//! A program in the other unit of length.

use chordal::control::{Action, OnceCode, ReadingCode};
use chordal::control::{FeedMode, Units};
use chordal::syntax::{Block, Word};
use chordal::{Control, Job};

use super::StepOutcome;
use super::edit::{TransformRefusal, WordEdit};
use super::rates::{RateWord, scaled};
use super::record::{ReadingContext, RunRecord};
use super::roles::{NumberRole, actions, roles};
use super::writer::WordWriter;

const REASON: &str = "lengths in the other unit";

/// The edits that write every length in `to`.
pub(super) fn units(job: &Job, to: Units) -> Result<StepOutcome, TransformRefusal> {
    let record = RunRecord::with_contours(job);
    let writer = WordWriter::new(job);
    let target = Action::from(to);
    // A cutting speed is written anew, and the revolutions follow it.
    let speed_tolerance = if job.profile().turns { 1e-3 } else { 0.0 };
    let mut outcome =
        StepOutcome { feed_tolerance: 1e-3, speed_tolerance, ..StepOutcome::default() };
    let Some(code) = writer.control.g_codes().find(|row| row.action == target) else {
        return Err(TransformRefusal::new(
            writer.text,
            &Block::new(),
            "the control has no code for that unit",
            "its parameters choose the unit; there is no code to write",
        ));
    };
    let mut first: Option<(u32, u32)> = None;
    let mut is_stated = false;
    let mut idle = Vec::new();
    for block in writer.word_blocks().filter(|block| !block.words.is_empty()) {
        let Some(runs) = record.blocks.get(&block.range.start) else {
            if "XYZ".bytes().any(|axis| block.letters().has(axis)) {
                idle.push(block.line);
            }
            continue;
        };
        let mut says = false;
        for (word, action) in actions(&block, writer.control) {
            if matches!(
                action,
                Action::Reading(ReadingCode::Inch) | Action::Reading(ReadingCode::Millimetre)
            ) {
                says = true;
                if action != target {
                    let text = writer.code(word, code.code);
                    outcome.edits.push(WordEdit::new(word.range, text, "the other unit"));
                }
            }
        }
        let is_head = block.word(b'O').is_some();
        if !is_head && first.is_none_or(|(order, _)| runs.order < order) {
            first = Some((runs.order, block.range.start));
            is_stated = says;
        }
        let edits = runs.edits_of_all(|context| lengths(&writer, &block, context, to))?;
        outcome.edits.extend(edits.ok_or_else(|| {
            TransformRefusal::new(
                writer.text,
                &block,
                "the block runs in both units",
                "write the units into the subprogram",
            )
        })?);
    }
    if let Some((_, at)) = first.filter(|_| !is_stated && outcome_changes(&outcome)) {
        let line = format!("{}\n", code.name(b'G'));
        outcome.edits.push(WordEdit::insert(at, line, "the unit at power-on no longer applies"));
    }
    outcome.note_idle(&idle);
    outcome.tolerance_mm = writer.tolerance_mm();
    Ok(outcome)
}

fn outcome_changes(outcome: &StepOutcome) -> bool {
    !outcome.edits.is_empty()
}

fn lengths(
    writer: &WordWriter,
    block: &Block,
    context: &ReadingContext,
    to: Units,
) -> Result<Vec<WordEdit>, TransformRefusal> {
    let mut edits = Vec::new();
    if context.units == to {
        return Ok(edits);
    }
    let units = (context.units, to);
    for (word, role) in block.words.iter().zip(roles(block, context, writer.control)) {
        let text = match role {
            NumberRole::Place(_)
            | NumberRole::Distance(_)
            | NumberRole::Center(_)
            | NumberRole::Spoke(_)
            | NumberRole::Length
            | NumberRole::Machine => writer.scaled_length(block, word, units, 1.0, 0.0)?,
            NumberRole::Counted => writer.counted(block, word, units, 1.0)?,
            NumberRole::Speed if context.keeps_surface_speed && !limits(block, writer.control) => {
                surface_speed(writer, block, word, units)?
            }
            NumberRole::Feed | NumberRole::TapFeed | NumberRole::Lead
                if context.feed_mode != FeedMode::InverseTime =>
            {
                let factor = context.units.mm() / to.mm();
                scaled(writer, block, word, factor, RateWord::Feed([context.units, to]))?
            }
            NumberRole::Doubtful => {
                return Err(TransformRefusal::new(
                    writer.text,
                    block,
                    format!("`{}` may be a length", writer.word(word)),
                    "write the moves out",
                ));
            }
            _ => continue,
        };
        edits.push(WordEdit::new(word.range, text, REASON));
    }
    Ok(edits)
}

/// S limits the spindle in this block.
fn limits(block: &Block, control: &Control) -> bool {
    actions(block, control).any(|(_, action)| action == Action::Once(OnceCode::PresetPosition))
}

/// A cutting speed: metres or feet in a minute.
fn surface_speed(
    writer: &WordWriter,
    block: &Block,
    word: &Word,
    (from, to): (Units, Units),
) -> Result<String, TransformRefusal> {
    let Some(number) = word.number() else {
        return Err(TransformRefusal::new(
            writer.text,
            block,
            format!("`{}` is computed, and a cutting speed has another unit", writer.word(word)),
            "write the cutting speed as a number",
        ));
    };
    let per = |units: Units| if units == Units::Inch { 304.8 } else { 1000.0 };
    let value = number.to_f64() * per(from) / per(to);
    // A whole number, where that is near enough.
    let digits = (0..3).find(|digits| {
        let power = 10f64.powi(*digits);
        ((value * power).round() / power - value).abs() <= 4e-4 * value.abs()
    });
    let digits = digits.unwrap_or(3) as usize;
    Ok(format!("S{value:.digits$}"))
}
