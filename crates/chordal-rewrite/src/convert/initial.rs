//! What holds at power-on on the old control and is not said by the program.

use chordal::control::table::CodeGroup;
use chordal::control::{Action, ModeCode, MotionCode, ReadingCode};
use chordal::machine::AXIS_LETTERS;
use chordal::syntax::Letters;

use super::axis_positions::SWITCH_TO_AXES;
use super::codes;
use super::context::ConvertContext;
use super::rendering::RenderedPlan;
use super::trace::BlockExecution;
use crate::Change;

/// Words whose meaning depends on inch and millimetres.
const LENGTHS: Letters = Letters::of("XYZIJKRFQ");
const AXIS_WORDS: Letters = Letters::of(AXIS_LETTERS);

/// Puts a line before the first block of each main program, where the new control would begin
/// otherwise.
pub(crate) fn begin(context: &ConvertContext, flat: &[bool], rendered: &mut RenderedPlan) {
    let parameters = context.controls().map(|control| control.parameters);
    for (main, is_flat) in context.source.mains.iter().zip(flat) {
        let runs: Vec<&BlockExecution> = context
            .trace
            .execs
            .iter()
            .filter(|exec| exec.block.is_some_and(|at| main.contains(&at)))
            .collect();
        let Some(first) = runs.iter().find_map(|exec| {
            exec.block.filter(|at| {
                context.source.sub_of(*at).is_none()
                    && !context.source.heads.contains(at)
                    && !context.source.blocks[*at].words.is_empty()
            })
        }) else {
            continue;
        };
        if *is_flat {
            if let Some(at) = begin_flat(context, main, &runs, rendered) {
                switch_to_axes(context, at, rendered);
            }
            continue;
        }
        switch_to_axes(context, first, rendered);
        let mut words = Vec::new();
        let start = runs.first().map(|exec| exec.before.units);
        if parameters[0].rules.units != parameters[1].rules.units
            && is_silent(context, &runs, CodeGroup::Units, LENGTHS)
            && start == Some(parameters[0].rules.units)
        {
            words.push(Action::from(parameters[0].rules.units));
        }
        if parameters[0].rules.starts_incremental != parameters[1].rules.starts_incremental
            && is_silent(context, &runs, CodeGroup::Distance, AXIS_WORDS)
        {
            words.push(Action::of_distance(parameters[0].rules.starts_incremental));
        }
        if parameters[0].rules.starts_linear != parameters[1].rules.starts_linear
            && is_silent(context, &runs, CodeGroup::Motion, AXIS_WORDS)
        {
            words.push(if parameters[0].rules.starts_linear {
                Action::Motion(MotionCode::Linear)
            } else {
                Action::Motion(MotionCode::Rapid)
            });
        }
        words.extend(of_lathes(context, &runs));
        let style = context.style();
        let names = words.into_iter().filter_map(|action| codes::name(action, context.to, style));
        let names: Vec<String> = names.collect();
        if names.is_empty() {
            continue;
        }
        let line = names.join(style.gap());
        rendered.changes.push(Change {
            line: context.source.blocks[first].line,
            before: String::new(),
            after: line.clone(),
            reason: format!("{} does not start in this state", context.to.table.title),
        });
        rendered.lines[first].get_or_insert_default().insert(0, line);
    }
}

/// Switches the kinematics to the axes before a block.
fn switch_to_axes(context: &ConvertContext, at: usize, rendered: &mut RenderedPlan) {
    if !context.switches_to_axes {
        return;
    }
    let lines = SWITCH_TO_AXES.map(String::from);
    rendered.changes.push(Change {
        line: context.source.blocks[at].line,
        before: String::new(),
        after: lines.join(", "),
        reason: "the kinematics of the machine begin with the tip, and the program gives the axes"
            .into(),
    });
    rendered.lines[at].get_or_insert_default().splice(0..0, lines);
}

/// What a lathe of another control would begin with otherwise: radii, and the feed that F counts.
fn of_lathes(context: &ConvertContext, runs: &[&BlockExecution]) -> Vec<Action> {
    let parameters = context.controls().map(|control| control.parameters);
    let mut words = Vec::new();
    if !context.turns() || context.same_control() {
        return words;
    }
    if parameters[1].starts_with_radii && context.x_factor != 1.0 {
        words.push(Action::Reading(ReadingCode::Diameters));
    }
    let starts = parameters.map(|one| one.rules.starts_per_revolution);
    if starts[0] != starts[1] && is_silent(context, runs, CodeGroup::FeedMode, Letters::of("F")) {
        words.push(match starts[0] {
            true => Action::Reading(ReadingCode::FeedPerRevolution),
            false => Action::Reading(ReadingCode::FeedPerTime),
        });
    }
    words
}

/// The first line of a program that is written out as it runs, which says only what it changes: what is in
/// force at its first move, so that it can be begun anywhere and after anything.
fn begin_flat(
    context: &ConvertContext,
    main: &std::ops::Range<usize>,
    runs: &[&BlockExecution],
    rendered: &mut RenderedPlan,
) -> Option<usize> {
    let trace = context.trace;
    let moves = |exec: &&&BlockExecution| {
        trace.commands_of(exec).iter().any(|command| command.kind.motion().is_some())
    };
    let first = runs.iter().find(moves).or(runs.first())?;
    let style = context.style();
    let actions = [
        Action::from(first.after.units),
        Action::from(runs[0].before.plane),
        Action::Reading(ReadingCode::Absolute),
        Action::Mode(ModeCode::CompensationOff),
        Action::Mode(ModeCode::CancelCycle),
    ];
    let mut lathes = of_lathes(context, runs);
    if context.turns() {
        lathes.retain(|action| *action == Action::Reading(ReadingCode::Diameters));
        lathes.push(Action::from(first.before.feed_mode));
    }
    let mut words: Vec<String> = actions
        .into_iter()
        .chain(lathes)
        .filter_map(|action| codes::name(action, context.to, style))
        .collect();
    let says_work = main.clone().any(|at| {
        context.source.has_action(at, context.from, |action| {
            matches!(action, Action::Mode(ModeCode::WorkOffset(_)))
        }) || context.from.table.work_names.by_e && context.source.blocks[at].letters().has(b'E')
    });
    let work = codes::work_offset(first.after.work, context.to, style);
    words.extend(work.filter(|_| says_work));
    let line = words.join(style.gap());
    let body = main.clone().filter(|at| *at >= context.source.first_words(main));
    let at = body.into_iter().find(|at| rendered.lines[*at].is_some())?;
    rendered.changes.push(Change {
        line: context.source.blocks[at].line,
        before: String::new(),
        after: line.clone(),
        reason: "the codes active at the start, written together".into(),
    });
    rendered.lines[at].get_or_insert_default().insert(0, line);
    Some(at)
}

/// True when words of these letters come before any code of the group.
fn is_silent(
    context: &ConvertContext,
    runs: &[&BlockExecution],
    group: CodeGroup,
    letters: Letters,
) -> bool {
    for exec in runs {
        let Some(at) = exec.block else { return true };
        let block = &context.source.blocks[at];
        let says = block
            .all(b'G')
            .any(|word| context.from.row_of(word).is_some_and(|row| row.group == group));
        if says {
            return false;
        }
        if block.letters().meets(letters) || block.expressions {
            return true;
        }
    }
    false
}
