//! U, V, W and H of controls that have them, G90 and G91 of those that have these.

use chordal::control::{Action, CallCode, OnceCode, ReadingCode};
use chordal::machine::AXIS_LETTERS;

use crate::convert::codes;
use crate::convert::context::ConvertContext;
use crate::convert::draft::{BlockDraft, NeedsExpansion};
use crate::convert::numbers;
use crate::convert::trace::BlockExecution;
use crate::source::code_action;

pub(super) fn translate(
    context: &ConvertContext,
    draft: &mut BlockDraft,
    at: usize,
) -> Result<(), NeedsExpansion> {
    letters(context, draft, at)?;
    distance_codes(context, draft, at)
}

fn takes_words(context: &ConvertContext, at: usize) -> bool {
    context.source.has_action(at, context.from, |action| {
        matches!(
            action,
            Action::Once(OnceCode::Dwell | OnceCode::SetData | OnceCode::Turning(_))
                | Action::Call(CallCode::MacroCall | CallCode::ModalMacroCall { .. })
        )
    })
}

/// U and W as X and Z.
fn letters(
    context: &ConvertContext,
    draft: &mut BlockDraft,
    at: usize,
) -> Result<(), NeedsExpansion> {
    let increments = context.from.parameters.increments;
    if increments == context.to.parameters.increments || takes_words(context, at) {
        return Ok(());
    }
    let axis_of = |letter: u8| increments.iter().find(|(own, _)| *own == letter).map(|own| own.1);
    let words: Vec<(usize, u8)> = (0..draft.block.words.len())
        .filter_map(|word| Some((word, axis_of(draft.block.words[word].letter)?)))
        .collect();
    let Some(run) = context.run(at).filter(|_| !words.is_empty()) else { return Ok(()) };
    let title = context.to.table.title;
    let reason = format!("{title} has no letters for distances");
    let home = context.source.has_action(at, context.from, |action| {
        matches!(action, Action::Once(OnceCode::ReturnToReference { .. }))
    });
    let places = words.iter().map(|(_, letter)| place(context, run, *letter));
    let places: Option<Vec<String>> = places.collect();
    let varies = context.trace.facts[at].runs > 1;
    if let Some(places) = places.filter(|_| !home && !varies) {
        for ((word, letter), place) in words.iter().zip(places) {
            draft.replace(*word, format!("{}{place}", char::from(*letter)), reason.clone());
        }
        return Ok(());
    }
    let is_mixed = AXIS_LETTERS.bytes().any(|letter| draft.block.letters().has(letter));
    let code = |code: ReadingCode| {
        codes::name(Action::Reading(code), context.to, context.style())
            .ok_or_else(|| NeedsExpansion(reason.clone()))
    };
    let (absolute, incremental) = (code(ReadingCode::Absolute)?, code(ReadingCode::Incremental)?);
    if is_mixed {
        return Err(NeedsExpansion(reason));
    }
    for (word, letter) in words {
        let new = format!("{}{}", char::from(letter), &draft.written(word)[1..]);
        draft.replace(word, new, reason.clone());
    }
    draft.lead(incremental, format!("{title} reads distances after this code"));
    draft.after.push(absolute);
    Ok(())
}

/// Where the block's last move ends along an axis, as the new control reads it.
fn place(context: &ConvertContext, run: &BlockExecution, letter: u8) -> Option<String> {
    let axis = AXIS_LETTERS.bytes().position(|own| own == letter)?;
    let mut moves = context.trace.commands_of(run).iter().filter_map(|one| one.kind.motion());
    let last = moves.next_back().filter(|motion| motion.to_known.has(axis))?;
    let style = context.style();
    let digits = numbers::digits(context.to, run.after.units);
    Some(match axis {
        0 => numbers::length(last.to[0] * context.x_factor, run.after.units, digits, style),
        1 | 2 => numbers::length(last.to[axis], run.after.units, digits, style),
        _ => numbers::plain(last.to[axis].to_degrees(), 3, style),
    })
}

/// G90 and G91, where the new control has letters in their place.
fn distance_codes(
    context: &ConvertContext,
    draft: &mut BlockDraft,
    at: usize,
) -> Result<(), NeedsExpansion> {
    let has = codes::row(Action::Reading(ReadingCode::Incremental), context.to).is_some();
    if has {
        return Ok(());
    }
    let title = context.to.table.title;
    for word in 0..draft.block.words.len() {
        let action = code_action(&draft.block.words[word], context.from);
        if let Some(Action::Reading(ReadingCode::Absolute | ReadingCode::Incremental)) = action {
            draft.remove(word, format!("distances have letters of their own on {title}"));
        }
    }
    let in_g91 = context.run(at).is_some_and(|run| run.after.incremental);
    if !in_g91 || takes_words(context, at) {
        return Ok(());
    }
    for word in 0..draft.block.words.len() {
        let letter = draft.block.words[word].letter;
        let own = context.to.parameters.increments.iter().find(|own| own.1 == letter);
        if let Some((new, _)) = own.filter(|_| !draft.is_changed(word)) {
            let text = format!("{}{}", char::from(*new), &draft.written(word)[1..]);
            draft.replace(word, text, format!("distances have letters of their own on {title}"));
        }
    }
    Ok(())
}
