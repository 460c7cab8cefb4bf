//! Cutting speeds and what limits the spindle: G50 S before, or D in the block of G96.

use chordal::control::{Action, OnceCode, ReadingCode, Units};
use chordal::syntax::Letters;

use crate::convert::codes;
use crate::convert::context::ConvertContext;
use crate::convert::draft::BlockDraft;
use crate::convert::numbers;
use crate::convert::trace::{ActiveModes, BlockExecution};
use crate::source::code_action;

const AXES: Letters = Letters::of("XYZUVWCH");

pub(super) fn translate(context: &ConvertContext, draft: &mut BlockDraft, at: usize) {
    let Some(run) = context.run(at) else { return };
    match context.controls().map(|control| control.parameters.preset_limits_speed) {
        [true, false] => {
            limit_with_speed(context, draft, run);
            speed_with_limit(context, draft, run);
        }
        [false, true] => limit_before_speed(context, draft),
        _ => {}
    }
}

fn place_of(context: &ConvertContext, draft: &BlockDraft, action: Action) -> Option<usize> {
    let words = 0..draft.block.words.len();
    words.into_iter().find(|at| code_action(&draft.block.words[*at], context.from) == Some(action))
}

fn text(value: f64, context: &ConvertContext) -> String {
    let text = numbers::plain(value, 4, context.style());
    text.strip_suffix('.').map_or(text.clone(), str::to_string)
}

/// `G96 D3000 S200` as it is active.
fn in_force(context: &ConvertContext, modes: &ActiveModes) -> Option<String> {
    let style = context.style();
    let code = codes::name(Action::Reading(ReadingCode::SurfaceSpeed), context.to, style)?;
    let mut words = vec![code];
    words.extend(limit_word(context, modes));
    words.push(format!("S{}", text(per_minute(modes)?, context)));
    Some(words.join(if style.spaced { " " } else { "" }))
}

fn limit_word(context: &ConvertContext, modes: &ActiveModes) -> Option<String> {
    let limit = modes.speed_limit.filter(|limit| limit.is_finite())?;
    Some(format!("D{}", text(limit, context)))
}

/// The cutting speed in the unit of S.
fn per_minute(modes: &ActiveModes) -> Option<f64> {
    let unit = if modes.units == Units::Inch { 304.8 } else { 1000.0 };
    Some(modes.surface_speed? * 60.0 / unit)
}

/// `G50 S3000` where the limit stands in the block of the cutting speed.
fn limit_with_speed(context: &ConvertContext, draft: &mut BlockDraft, run: &BlockExecution) {
    let preset = place_of(context, draft, Action::Once(OnceCode::PresetPosition));
    let (Some(preset), Some(s)) = (preset, draft.place(b'S')) else { return };
    let title = context.to.table.title;
    let reason = format!("{title} limits the spindle with D next to the cutting speed");
    let is_alone = !draft.block.letters().meets(AXES);
    match in_force(context, &run.after).filter(|_| is_alone) {
        Some(new) => {
            draft.replace(preset, new, reason);
            draft.set(s, "");
        }
        None => {
            draft.remove(s, reason);
            if is_alone {
                draft.set(preset, "");
            }
        }
    }
}

/// D of the limit that is active, and S, without which there is no cutting speed.
fn speed_with_limit(context: &ConvertContext, draft: &mut BlockDraft, run: &BlockExecution) {
    let speed = Action::Reading(ReadingCode::SurfaceSpeed);
    let Some(code) = place_of(context, draft, speed) else { return };
    let title = context.to.table.title;
    let style = context.style();
    if let Some(limit) = limit_word(context, &run.after) {
        let name = codes::name(speed, context.to, style).unwrap_or_default();
        let gap = if style.spaced { " " } else { "" };
        let reason = format!("{title} limits the spindle with D next to the cutting speed");
        draft.replace(code, format!("{name}{gap}{limit}"), reason);
    }
    if draft.place(b'S').is_none()
        && let Some(value) = per_minute(&run.after)
    {
        let reason = format!("{title} needs S next to this code");
        draft.append(format!("S{}", text(value, context)), reason);
    }
}

/// D of a cutting speed as a block before it.
fn limit_before_speed(context: &ConvertContext, draft: &mut BlockDraft) {
    let speed = Action::Reading(ReadingCode::SurfaceSpeed);
    if place_of(context, draft, speed).is_none() {
        return;
    }
    let Some(d) = draft.place(b'D') else { return };
    let preset = Action::Once(OnceCode::PresetPosition);
    let Some(code) = codes::name(preset, context.to, context.style()) else { return };
    let gap = if context.style().spaced { " " } else { "" };
    let limit = draft.written(d);
    let line = format!("{code}{gap}S{}", limit[1..].trim_start_matches('-'));
    let title = context.to.table.title;
    draft.set(d, "");
    draft.note(limit, line.clone(), format!("{title} limits the spindle by this code"));
    draft.before.push(line);
}
