//! T0101 of one control, T1 M6 G43 of the other.

use chordal::CommandKind;
use chordal::control::{
    Action, AfterCode, BeforeCode, Control, LengthCode, OnceCode, SpindleState, ToolWord,
};

use crate::convert::codes;
use crate::convert::context::ConvertContext;
use crate::convert::draft::BlockDraft;
use crate::convert::trace::BlockExecution;
use crate::source::{WordStyle, code_action};

/// The word of a station and its offset; 0 ends the offset.
pub(crate) fn station(control: &Control, tool: u32, offset: Option<u32>) -> Option<String> {
    let ToolWord::StationAndOffset { digits } = control.parameters.tool_word else { return None };
    let offset = offset.unwrap_or(0);
    // Of five digits and more three are the offset.
    let digits = if offset >= 10_u32.pow(digits) || tool >= 100 { 3 } else { digits as usize };
    Some(match digits {
        3 => format!("T{tool:02}{offset:03}"),
        _ => format!("T{tool:02}{offset:0digits$}"),
    })
}

/// The words for a tool with its offset on a control whose T names a tool alone.
pub(crate) fn tool_words(
    control: &Control,
    style: WordStyle,
    tool: Option<u32>,
    offset: Option<u32>,
    current: u32,
) -> Vec<String> {
    let name = |action: Action| codes::name(action, control, style);
    let mut words = Vec::new();
    if let Some(tool) = tool {
        words.push(format!("T{tool}"));
        words.extend(name(Action::Before(BeforeCode::ToolChange)));
    }
    match offset {
        Some(offset) => {
            words.extend(name(Action::Length(LengthCode::Plus)));
            words.extend((offset != current).then(|| format!("H{offset}")));
        }
        None => words.extend(name(Action::Length(LengthCode::Cancel))),
    }
    words
}

pub(super) fn translate(context: &ConvertContext, draft: &mut BlockDraft, at: usize) {
    let by_station = |control: &Control| {
        matches!(control.parameters.tool_word, ToolWord::StationAndOffset { .. })
    };
    let Some(run) = context.run(at) else { return };
    match context.controls().map(by_station) {
        [true, false] => station_as_tool(context, draft, at, run),
        [false, true] => tool_as_station(context, draft, at, run),
        [true, true] if context.from.parameters.tool_word != context.to.parameters.tool_word => {
            if let Some(word) = station_word(context, draft, at)
                && let Some(new) = station(context.to, run.after.tool, run.after.length_offset)
            {
                let reason = format!("{} splits T in another way", context.to.table.title);
                draft.replace(word, new, reason);
            }
        }
        _ => {}
    }
}

/// T as a station, not as a word of a cycle or of data.
fn station_word(context: &ConvertContext, draft: &BlockDraft, at: usize) -> Option<usize> {
    let is_other = context.source.has_action(at, context.from, |action| {
        matches!(action, Action::Once(OnceCode::SetData | OnceCode::Turning(_)))
    });
    draft.place(b'T').filter(|_| !is_other)
}

fn changes_tool(context: &ConvertContext, run: &BlockExecution) -> bool {
    let mut commands = context.trace.commands_of(run).iter();
    commands.any(|command| matches!(command.kind, CommandKind::Tool { .. }))
}

fn station_as_tool(
    context: &ConvertContext,
    draft: &mut BlockDraft,
    at: usize,
    run: &BlockExecution,
) {
    let Some(word) = station_word(context, draft, at) else { return };
    let style = context.style();
    let changes = changes_tool(context, run);
    let tool = changes.then_some(run.after.tool);
    let offset = run.after.length_offset;
    let words = tool_words(context.to, style, tool, offset, run.after.tool);
    let new = words.join(if style.spaced { " " } else { "" });
    let title = context.to.table.title;
    draft.replace(word, new, format!("tool and offset have words of their own on {title}"));
    let stops =
        [context.from, context.to].map(|one| one.parameters.rules.spindle_stops_at_tool_change);
    let turned = match run.before.spindle {
        SpindleState::Cw => BeforeCode::SpindleCw,
        SpindleState::Ccw => BeforeCode::SpindleCcw,
        SpindleState::Off | SpindleState::Oriented => return,
    };
    let starts = context.source.has_action(at, context.from, |action| {
        matches!(action, Action::Before(BeforeCode::SpindleCw | BeforeCode::SpindleCcw))
    });
    if changes
        && stops == [false, true]
        && !starts
        && let Some(code) = codes::name(Action::Before(turned), context.to, style)
    {
        let reason = format!("the tool change stops the spindle on {title}");
        draft.note(String::new(), code.clone(), reason);
        draft.after.push(code);
    }
}

fn tool_as_station(
    context: &ConvertContext,
    draft: &mut BlockDraft,
    at: usize,
    run: &BlockExecution,
) {
    let is = |word: usize, target: fn(Action) -> bool| {
        code_action(&draft.block.words[word], context.from).is_some_and(target)
    };
    let words = 0..draft.block.words.len();
    let change = words
        .clone()
        .find(|word| is(*word, |action| action == Action::Before(BeforeCode::ToolChange)));
    let lengths: Vec<usize> = words
        .filter(|word| {
            is(*word, |action| {
                matches!(
                    action,
                    Action::Length(LengthCode::Plus | LengthCode::Minus | LengthCode::Cancel)
                )
            })
        })
        .collect();
    let title = context.to.table.title;
    let chosen = station_word(context, draft, at);
    let place = change.or(lengths.first().copied());
    let mut gone: Vec<usize> = lengths.clone();
    gone.extend(chosen);
    gone.extend(change);
    if !lengths.is_empty() {
        gone.extend(draft.place(b'H'));
    }
    for word in gone.into_iter().filter(|word| Some(*word) != place) {
        draft.remove(word, format!("T names tool and offset on {title}"));
    }
    let Some(place) = place else { return };
    match station(context.to, run.after.tool, run.after.length_offset) {
        Some(new) if run.after.tool > 0 => {
            draft.replace(place, new, format!("T names tool and offset on {title}"));
        }
        _ => draft.remove(place, "no tool is in the spindle"),
    }
    let stops =
        [context.from, context.to].map(|one| one.parameters.rules.spindle_stops_at_tool_change);
    let turned = matches!(run.before.spindle, SpindleState::Cw | SpindleState::Ccw);
    if change.is_some()
        && stops == [true, false]
        && turned
        && let Some(code) =
            codes::name(Action::After(AfterCode::SpindleStop), context.to, context.style())
    {
        let from = context.from.table.title;
        let reason = format!("the tool change stops the spindle on {from}");
        draft.note(String::new(), code.clone(), reason);
        draft.before.push(code);
    }
}
