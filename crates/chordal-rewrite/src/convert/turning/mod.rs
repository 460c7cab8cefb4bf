//! Programs of lathes: stations and offsets, limits of the spindle, increments, diameters, and the cycles.

mod cycles;
mod increments;
mod live;
mod speeds;
mod stations;

use chordal::control::{Action, MotionCode, OnceCode, ReadingCode};
use chordal::syntax::Letters;

use super::codes;
use super::context::ConvertContext;
use super::draft::{BlockDraft, NeedsExpansion};
use super::numbers;
use crate::source::code_action;

pub(crate) use self::stations::station;

/// Words that give a pass of a lathe its end.
const ENDS: Letters = Letters::of("XZUW");

/// Words of a block of a lathe, before its codes are looked at.
pub(super) fn translate(
    context: &ConvertContext,
    draft: &mut BlockDraft,
    at: usize,
) -> Result<(), NeedsExpansion> {
    if !context.turns() || context.same_control() {
        return Ok(());
    }
    stations::translate(context, draft, at);
    live::translate(context, draft, at)?;
    speeds::translate(context, draft, at);
    reading_of_x(context, draft);
    passes(context, draft, at)?;
    cycles::translate(context, draft, at)?;
    increments::translate(context, draft, at)?;
    diameters(context, draft, at)
}

/// Codes that say whether X is a diameter, where the new control has no other way.
fn reading_of_x(context: &ConvertContext, draft: &mut BlockDraft) {
    for word in 0..draft.block.words.len() {
        let action = code_action(&draft.block.words[word], context.from);
        let Some(Action::Reading(code)) = action else { continue };
        let is_x = matches!(code, ReadingCode::Diameters | ReadingCode::Radii);
        if is_x && codes::row(Action::Reading(code), context.to).is_none() {
            draft.remove(word, format!("X is a diameter on {}", context.to.table.title));
        }
    }
}

/// Passes of one block (G90, G92, G94), and threads whose lead changes.
fn passes(
    context: &ConvertContext,
    draft: &mut BlockDraft,
    at: usize,
) -> Result<(), NeedsExpansion> {
    let title = context.to.table.title;
    let has = |code: MotionCode| codes::row(Action::Motion(code), context.to).is_some();
    for word in 0..draft.block.words.len() {
        let own = draft.block.words[word];
        match code_action(&own, context.from) {
            Some(Action::Motion(code @ MotionCode::Turn(_)))
                if !has(code) && !draft.block.letters().meets(ENDS) =>
            {
                draft.remove(word, "a cycle without an end moves nothing");
            }
            Some(Action::Motion(MotionCode::Thread)) if changes_lead(context, at) => {
                let same = context.to.row_of(&own).map(|row| (row.action, row.words))
                    == context.from.row_of(&own).map(|row| (row.action, row.words));
                if !same {
                    return Err(NeedsExpansion(format!(
                        "{title} has no thread whose lead changes"
                    )));
                }
            }
            Some(Action::Motion(MotionCode::Thread))
                if context.from.parameters.thread_lead != context.to.parameters.thread_lead =>
            {
                return Err(NeedsExpansion(format!(
                    "{title} gives the lead of a thread in another way"
                )));
            }
            _ => {}
        }
    }
    let Some(run) = context.run(at) else { return Ok(()) };
    match run.after.motion {
        Some(Action::Motion(code @ MotionCode::Turn(_))) if !has(code) && context.in_cycle(run) => {
            Err(NeedsExpansion(format!("{title} has no cycle of one pass")))
        }
        _ => Ok(()),
    }
}

/// A thread whose lead changes: its moves show a mean lead, so that it cannot be written out.
pub(super) fn changes_lead(context: &ConvertContext, at: usize) -> bool {
    let by_feed = context.from.parameters.thread_lead == b'F';
    let thread = Action::Motion(MotionCode::Thread);
    by_feed
        && context.source.has_action(at, context.from, |action| action == thread)
        && context.source.blocks[at].letters().has(b'K')
}

/// A block that does what no command shows: its words are needed.
pub(crate) fn is_hidden(context: &ConvertContext, at: usize) -> bool {
    context.turns()
        && (changes_lead(context, at)
            || context.source.has_action(at, context.from, |action| {
                matches!(
                    action,
                    Action::Reading(ReadingCode::SurfaceSpeed | ReadingCode::SpindleRpm)
                        | Action::Once(OnceCode::PresetPosition)
                )
            }))
}

/// Words X of a program that is written in radii.
fn diameters(
    context: &ConvertContext,
    draft: &mut BlockDraft,
    at: usize,
) -> Result<(), NeedsExpansion> {
    let Some(run) = context.run(at) else { return Ok(()) };
    let factor = context.x_factor * run.after.per_x;
    if factor == 1.0 || context.waits(at) {
        return Ok(());
    }
    for word in 0..draft.block.words.len() {
        let own = draft.block.words[word];
        if own.letter != b'X' || draft.is_changed(word) {
            continue;
        }
        let Some(number) = own.number() else {
            return Err(NeedsExpansion(
                "X is computed, and is a diameter on the new control".into(),
            ));
        };
        let text = numbers::plain(number.to_f64() * factor, number.scale.into(), context.style());
        let reason = format!("X is a diameter on {}", context.to.table.title);
        draft.replace(word, format!("X{text}"), reason);
    }
    Ok(())
}
