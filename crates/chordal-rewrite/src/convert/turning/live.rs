//! Words of live tools and of the C axis: M133 P of one control, M3 of the other.

use chordal::CommandKind;
use chordal::control::{Action, AfterCode, BeforeCode, ReadingCode, SpindleState};

use crate::convert::codes::{self, LatheDrilling};
use crate::convert::context::ConvertContext;
use crate::convert::draft::{BlockDraft, NeedsExpansion};
use crate::convert::live::has_codes;
use crate::convert::numbers;
use crate::convert::trace::BlockExecution;
use crate::source::code_action;

/// Words about live tools of a block.
pub(super) fn translate(
    context: &ConvertContext,
    draft: &mut BlockDraft,
    at: usize,
) -> Result<(), NeedsExpansion> {
    let Some(run) = context.run(at) else { return Ok(()) };
    let [from, to] = context.controls().map(has_codes);
    match (from, to) {
        (false, true) => {
            if context.live.unclear.contains(&at) {
                return Err(NeedsExpansion(
                    "C moves after a cut while it turns: whether this is the spindle or a live tool is not \
                     clear; name the live tool by P, or stop the spindle before C moves"
                        .into(),
                ));
            }
            axis_on(context, draft, at);
            by_code(context, draft, at, run);
            Ok(())
        }
        (true, false) => by_p(context, draft, run),
        (true, true) | (false, false) => Ok(()),
    }
}

/// The spindle becomes the C axis before C moves.
fn axis_on(context: &ConvertContext, draft: &mut BlockDraft, at: usize) {
    let code = Action::Before(BeforeCode::CAxisOn);
    if context.live.axis_on.contains(&at)
        && let Some(code) = codes::name(code, context.to, context.style())
    {
        let reason =
            format!("the spindle becomes the C axis by this code on {}", context.to.table.title);
        draft.note(String::new(), code.clone(), reason);
        draft.before.push(code);
    }
}

fn rpm_text(context: &ConvertContext, rpm: f64) -> String {
    let text = numbers::plain(rpm, 3, context.style());
    text.strip_suffix('.').map_or(text.clone(), str::to_string)
}

/// M3 and M5 of a live tool as codes of their own.
fn by_code(context: &ConvertContext, draft: &mut BlockDraft, at: usize, run: &BlockExecution) {
    let title = context.to.table.title;
    let gap = if context.style().spaced { " " } else { "" };
    let place = |target: &dyn Fn(Action) -> bool| {
        (0..draft.block.words.len())
            .find(|word| code_action(&draft.block.words[*word], context.from).is_some_and(target))
    };
    let p = draft.place(b'P');
    if context.live.starts.contains(&at) {
        let started =
            context.trace.commands_of(run).iter().find_map(|command| match command.kind {
                CommandKind::Spindle { state, rpm } if !command.origin.cycle => Some((state, rpm)),
                _ => None,
            });
        let starts = place(&|action| {
            matches!(action, Action::Before(BeforeCode::SpindleCw | BeforeCode::SpindleCcw))
        });
        let s = draft.place(b'S');
        let (Some((state, rpm)), Some(word)) = (started, starts.or(s)) else { return };
        let code = match state {
            SpindleState::Ccw => BeforeCode::LiveToolCcw,
            SpindleState::Cw | SpindleState::Off | SpindleState::Oriented => BeforeCode::LiveToolCw,
        };
        let Some(code) = codes::name(Action::Before(code), context.to, context.style()) else {
            return;
        };
        let new = format!("{code}{gap}P{}", rpm_text(context, rpm));
        let reason = format!("a live tool: {title} has codes of its own for them");
        for gone in [p.filter(|_| starts.is_some()), s].into_iter().flatten() {
            draft.set(gone, "");
        }
        draft.set(word, "");
        draft.replace(word, new, reason);
    }
    let cycle = place(&|action| matches!(action, Action::Cycle(_)));
    let own = cycle.and_then(|word| context.from.row_of(&draft.block.words[word]));
    if let (true, Some(word), Some(own)) = (context.live.taps.contains(&at), cycle, own) {
        let drilling = LatheDrilling { live: true, ..codes::is_in(own, context.from) };
        if let Some(row) = codes::cycle_row(own, drilling, context.to) {
            let new = codes::spelt(row, b'G', context.style());
            draft.replace(
                word,
                new,
                format!("{title} has a code of its own for a tap in a live tool"),
            );
        }
    }
    let stops = place(&|action| action == Action::After(AfterCode::SpindleStop));
    let stop = codes::name(Action::After(AfterCode::LiveToolStop), context.to, context.style());
    if let (true, Some(word), Some(code)) = (context.live.stops.contains(&at), stops, stop) {
        draft.replace(word, code, format!("the live tool stops by this code on {title}"));
        if let Some(p) = p {
            draft.set(p, "");
        }
    }
}

/// A code for live tools, that of the spindle which does the same, and whether it starts one.
const LIKE: [(Action, Action, bool); 3] = [
    (Action::Before(BeforeCode::LiveToolCw), Action::Before(BeforeCode::SpindleCw), true),
    (Action::Before(BeforeCode::LiveToolCcw), Action::Before(BeforeCode::SpindleCcw), true),
    (Action::After(AfterCode::LiveToolStop), Action::After(AfterCode::SpindleStop), false),
];

/// Codes for live tools as M3 and M5 with the P that names them.
fn by_p(
    context: &ConvertContext,
    draft: &mut BlockDraft,
    run: &BlockExecution,
) -> Result<(), NeedsExpansion> {
    let title = context.to.table.title;
    let gap = if context.style().spaced { " " } else { "" };
    let number = context.to.parameters.live_tool_p;
    let named = |action: Action, p: u32| {
        let code = codes::name(action, context.to, context.style())?;
        Some(format!("{code}{gap}P{p}"))
    };
    for word in 0..draft.block.words.len() {
        let Some(action) = code_action(&draft.block.words[word], context.from) else { continue };
        if action == Action::Before(BeforeCode::CAxisOn) {
            axis_without_code(context, draft, word, run);
            continue;
        }
        let Some((_, own, starts)) = LIKE.into_iter().find(|(live, ..)| *live == action) else {
            continue;
        };
        let Some(words) = named(own, number).filter(|_| number > 0) else {
            return Err(NeedsExpansion(format!(
                "{title} has no code for live tools: the builder chooses it"
            )));
        };
        let reason =
            format!("live tools are named by P on {title}, by the setting \"P of live tools\"");
        if !starts {
            draft.replace(word, words, reason);
            continue;
        }
        let rpm = run.after.live.map_or(0.0, |live| live.rpm);
        let speed = format!("S{}", rpm_text(context, rpm));
        for letter in [b'P', b'S'] {
            if let Some(other) = draft.place(letter) {
                draft.set(other, "");
            }
        }
        // S is a speed only where no cutting speed is kept.
        let plain = run.after.surface_speed.is_some();
        let plain =
            codes::name(Action::Reading(ReadingCode::SpindleRpm), context.to, context.style())
                .filter(|_| plain);
        let mut all: Vec<String> = plain.into_iter().collect();
        all.extend([speed, words]);
        draft.replace(word, all.join(gap), reason);
    }
    Ok(())
}

/// The new control has no code for the C axis that is known: the spindle stops, where it turned.
fn axis_without_code(
    context: &ConvertContext,
    draft: &mut BlockDraft,
    word: usize,
    run: &BlockExecution,
) {
    let title = context.to.table.title;
    let turned = matches!(run.before.spindle, SpindleState::Cw | SpindleState::Ccw);
    let stop = codes::name(Action::After(AfterCode::SpindleStop), context.to, context.style());
    let reason = format!("the builder of a machine with {title} chooses the code for the C axis");
    match stop.filter(|_| turned) {
        Some(stop) => draft.replace(word, stop, reason),
        None => draft.remove(word, reason),
    }
}
