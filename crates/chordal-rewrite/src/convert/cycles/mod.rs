//! Canned cycles: the same words where both controls have the cycle.

mod bores;
mod meaning;
mod pecks;

use chordal::CommandKind;
use chordal::control::table::DwellWord;
use chordal::control::{Action, AfterCode, ModeCode, OnceCode};
use chordal::control::{Control, DefinitionFires, IncrementalLevels, TapFeed};

use chordal::geometry::Plane;

use super::codes;
use super::context::ConvertContext;
use super::draft::{BlockDraft, NeedsExpansion};
use super::numbers;
use super::trace::BlockExecution;
use crate::source::code_action;

/// Words of cycles, and codes that end them.
pub(crate) fn translate(
    context: &ConvertContext,
    draft: &mut BlockDraft,
    at: usize,
) -> Result<(), NeedsExpansion> {
    ending(context, draft, at);
    split_from_motion(context, draft, at);
    let codes = || {
        let words = context.source.blocks[at].words.iter();
        words.filter_map(|word| code_action(word, context.from))
    };
    let kind = codes().find_map(Action::cycle);
    let pocket = codes().any(|action| action.once().is_some_and(OnceCode::is_pocket));
    let Some(run) = context.run(at) else { return Ok(()) };
    if places_alone(context, draft, at, run)? {
        return Ok(());
    }
    let title = context.to.table.title;
    if pocket && !context.same_control() {
        return Err(NeedsExpansion(format!("{title} mills a pocket in another way")));
    }
    let Some(kind) = kind else {
        count(context, draft, run);
        return hole(context, run);
    };
    if context.same_control() {
        return Ok(());
    }
    meaning::is_kept(context, kind, run)?;
    if run.before.incremental
        && context.to.parameters.rules.cycles.incremental == IncrementalLevels::Refused
    {
        return Err(NeedsExpansion(format!("{title} accepts cycles only in absolute coordinates")));
    }
    if kind.is_peck() {
        pecks::words(context, draft, kind, run)?;
    }
    count(context, draft, run);
    let letters = draft.block.letters();
    return_level(context, draft, at);
    levels(context, draft, run);
    level_or_distance(context, draft, run)?;
    first_hole(context, draft, run)?;
    if kind.is_tap() {
        without_r(context, draft)?;
        if draft.block.words.iter().any(|word| word.comma) {
            return Err(NeedsExpansion(format!(
                "a word of the tap means something else on {title}"
            )));
        }
        tap(context, draft, run)?;
    }
    bores::words(context, draft, kind, run)?;
    if letters.has(b'P') {
        dwell(context, draft);
    } else if kind.dwells() && needs_p(context.to) && !needs_p(context.from) {
        draft.append("P0", format!("{title} needs P in this cycle"));
    }
    Ok(())
}

fn needs_p(control: &Control) -> bool {
    control.parameters.rules.cycles.needs_p
}

/// R and the depth, where the new control does not take the level of the tool for R, or forgets both when
/// another cycle begins.
fn levels(context: &ConvertContext, draft: &mut BlockDraft, run: &BlockExecution) {
    let [one, other] = context.controls().map(|control| control.parameters.rules.cycles);
    let forgets = one.keeps_words && !other.keeps_words;
    let wants_r = forgets || (one.missing_r != other.missing_r);
    let cuts: Vec<_> = context
        .trace
        .commands_of(run)
        .iter()
        .filter_map(|command| match &command.kind {
            CommandKind::Line { motion, .. } if command.origin.cycle => Some(motion),
            _ => None,
        })
        .collect();
    let is_known = run.after.plane == Plane::Xy && !run.after.incremental;
    let Some(first) = cuts.first().filter(|_| is_known) else { return };
    let bottom = cuts.iter().map(|cut| cut.to[2]).fold(first.to[2], f64::min);
    let letters = draft.block.letters();
    let title = context.to.table.title;
    let digits = numbers::digits(context.to, run.after.units);
    let text = |mm| numbers::length(mm, run.after.units, digits, context.style());
    if forgets && !letters.has(b'Z') {
        let reason = format!("{title} forgets the depth when another cycle begins");
        draft.append(format!("Z{}", text(bottom)), reason);
    }
    if wants_r && !letters.has(b'R') && !context.to.table.lexicon.registers {
        let reason = format!("{title} needs R here");
        draft.append(format!("R{}", text(first.from[2])), reason);
    }
}

/// G98 or G99 where the program relies on the one that its own control begins with.
fn return_level(context: &ConvertContext, draft: &mut BlockDraft, at: usize) {
    let [one, other] =
        context.controls().map(|control| control.parameters.rules.cycles.starts_at_r);
    let is_level = |action: Action| {
        matches!(action, Action::Mode(ModeCode::ReturnInitial | ModeCode::ReturnToR))
    };
    let is_stated =
        || (0..=at).any(|block| context.source.has_action(block, context.from, is_level));
    if one == other || is_stated() {
        return;
    }
    let level = if one { ModeCode::ReturnToR } else { ModeCode::ReturnInitial };
    if let Some(code) = codes::name(Action::Mode(level), context.to, context.style()) {
        let title = context.to.table.title;
        draft.lead(code, format!("{title} begins with the other level of return"));
    }
}

/// A hole of a cycle that a block before set up.
fn hole(context: &ConvertContext, run: &BlockExecution) -> Result<(), NeedsExpansion> {
    let Some(Action::Cycle(kind)) = run.after.motion else { return Ok(()) };
    if context.same_control() || !context.in_cycle(run) {
        return Ok(());
    }
    meaning::is_kept(context, kind, run)
}

/// Holes on a circle or a line, or where the tool stands, as places: the cycle stays.
fn places_alone(
    context: &ConvertContext,
    draft: &mut BlockDraft,
    at: usize,
    run: &BlockExecution,
) -> Result<bool, NeedsExpansion> {
    let is_pattern = |action| {
        matches!(
            action,
            Action::Once(OnceCode::Pattern(_)) | Action::After(AfterCode::RunCycleHere)
        )
    };
    let Some(word) = (0..draft.block.words.len())
        .find(|word| code_action(&draft.block.words[*word], context.from).is_some_and(is_pattern))
    else {
        return Ok(false);
    };
    if context.same_control() {
        return Ok(true);
    }
    let Some(Action::Cycle(kind)) = run.after.motion else { return Ok(false) };
    let others = context.source.has_action(at, context.from, |action| !is_pattern(action));
    if meaning::is_kept(context, kind, run).is_err() || others {
        let title = context.to.table.title;
        return Err(NeedsExpansion(format!("{title} has no code for these holes")));
    }
    let (a, b, _) = run.after.plane.axes();
    let mut holes: Vec<[f64; 2]> = Vec::new();
    for command in context.trace.commands_of(run) {
        if let CommandKind::Line { motion, .. } = &command.kind {
            let hole = [motion.to[a], motion.to[b]];
            if holes.last() != Some(&hole) {
                holes.push(hole);
            }
        }
    }
    let digits = numbers::digits(context.to, run.after.units);
    let style = context.style();
    let gap = if style.spaced { " " } else { "" };
    let lines = holes.iter().map(|hole| {
        let text = |mm| numbers::length(mm, run.after.units, digits, style);
        let [x, y] = hole.map(text);
        format!("{}{x}{gap}{}{y}", LINEAR_AXES[a], LINEAR_AXES[b])
    });
    let mut lines: Vec<String> = lines.collect();
    if run.after.incremental {
        lines.insert(0, "G90".into());
        lines.push("G91".into());
    }
    let before = draft.written(word);
    for word in 0..draft.block.words.len() {
        draft.set(word, "");
    }
    draft.note(
        before,
        lines.join("\n"),
        format!("{} has no code for these holes: each position is written", context.to.table.title),
    );
    draft.after.extend(lines);
    Ok(true)
}

const LINEAR_AXES: [char; 3] = ['X', 'Y', 'Z'];

/// The place of the first hole, where the new control drills only at a place that is named.
fn first_hole(
    context: &ConvertContext,
    draft: &mut BlockDraft,
    run: &BlockExecution,
) -> Result<(), NeedsExpansion> {
    let rules = context.controls().map(|control| control.parameters.rules.cycles);
    let (a, b, _) = run.after.plane.axes();
    let letters = draft.block.letters();
    let named = letters.has(b"XYZ"[a]) || letters.has(b"XYZ"[b]);
    let fires = context.in_cycle(run);
    let title = context.to.table.title;
    match rules[1].definition {
        _ if named => Ok(()),
        DefinitionFires::Always if fires => Ok(()),
        DefinitionFires::Always => {
            Err(NeedsExpansion(format!("{title} drills in the block that calls the cycle")))
        }
        _ if !fires => Ok(()),
        DefinitionFires::Never => {
            Err(NeedsExpansion(format!("{title} does not drill in the block that calls the cycle")))
        }
        DefinitionFires::WithPlace => {
            let digits = numbers::digits(context.to, run.after.units);
            for axis in [a, b] {
                let value = if run.after.incremental { 0.0 } else { run.before.position[axis] };
                let text = numbers::length(value, run.after.units, digits, context.style());
                draft.append(
                    format!("{}{text}", LINEAR_AXES[axis]),
                    format!("{title} drills only at a position that is programmed"),
                );
            }
            Ok(())
        }
    }
}

/// R as a level or as the distance from where the tool is, along Z or X.
fn level_or_distance(
    context: &ConvertContext,
    draft: &mut BlockDraft,
    run: &BlockExecution,
) -> Result<(), NeedsExpansion> {
    let [one, other] =
        context.controls().map(|control| control.parameters.rules.cycles.r_from_initial);
    let Some(r) = draft.place(b'R').filter(|r| one != other && !draft.is_gone(*r)) else {
        return Ok(());
    };
    let title = context.to.table.title;
    let first = context.trace.commands_of(run).iter().find_map(|command| match &command.kind {
        CommandKind::Line { motion, .. } if command.origin.cycle => Some(motion),
        _ => None,
    });
    let axis = first.and_then(|cut| {
        let changes: Vec<usize> = (0..3).filter(|axis| cut.from[*axis] != cut.to[*axis]).collect();
        <[usize; 1]>::try_from(changes).ok()
    });
    let (Some(cut), Some([axis @ (0 | 2)])) = (first, axis) else {
        return Err(NeedsExpansion(format!("{title} counts R of this cycle in another way")));
    };
    let digits = numbers::digits(context.to, run.after.units);
    let is_diameter = axis == 0 && context.to.parameters.rules.cycles.radial_r_is_diameter;
    let (level, reason) = match other {
        true => (cut.from[axis] - run.before.position[axis], "from where the tool is"),
        false if is_diameter => (cut.from[axis] * 2.0, "as a level, a diameter"),
        false => (cut.from[axis], "as a level"),
    };
    let text = numbers::length(level, run.after.units, digits, context.style());
    draft.replace(r, format!("R{text}"), format!("{title} reads R {reason}"));
    Ok(())
}

/// R of a tap, where the code that taps on the new control has none: it taps from where the tool is.
fn without_r(context: &ConvertContext, draft: &BlockDraft) -> Result<(), NeedsExpansion> {
    let takes_r = |word: usize| {
        let number = chordal::syntax::Decimal::parse(draft.now(word).get(1..)?.as_bytes())?;
        let row = context.to.g_code(chordal::control::code_number(number)?)?;
        row.action.cycle().map(|_| row.words.has(b'R'))
    };
    let words = (0..draft.block.words.len()).filter(|word| draft.block.words[*word].letter == b'G');
    let takes = words.into_iter().find_map(takes_r).unwrap_or(true);
    match draft.place(b'R').filter(|r| !takes && !draft.is_gone(*r)) {
        Some(_) => Err(NeedsExpansion(format!(
            "{} has no R in this tap: it begins where the tool is",
            context.to.table.title
        ))),
        None => Ok(()),
    }
}

/// The letter that counts holes.
fn count(context: &ConvertContext, draft: &mut BlockDraft, run: &BlockExecution) {
    let [one, other] =
        context.controls().map(|control| control.parameters.rules.cycles.repeat_letter);
    if one == other || !matches!(run.after.motion, Some(Action::Cycle(_))) {
        return;
    }
    if let Some(word) = draft.place(one).filter(|word| !draft.is_changed(*word)) {
        let new = format!("{}{}", char::from(other), &draft.written(word)[1..]);
        draft.replace(
            word,
            new,
            format!("{} uses this letter for the number of holes", context.to.table.title),
        );
    }
}

/// F and Q of a tap.
fn tap(
    context: &ConvertContext,
    draft: &mut BlockDraft,
    run: &BlockExecution,
) -> Result<(), NeedsExpansion> {
    let [one, other] = context.controls().map(|control| control.parameters.rules.cycles.tap.feed);
    if one == other {
        return Ok(());
    }
    let cut = context.trace.commands_of(run).iter().find_map(|command| match &command.kind {
        CommandKind::Line { feed, .. } => Some(*feed),
        _ => None,
    });
    let Some(cut) = cut else {
        return Err(NeedsExpansion("a tap without a hole in its block".into()));
    };
    let unit = run.after.units.mm();
    let speed = cut.spindle_rev_per_s * 60.0;
    let per_minute = match cut.mode {
        chordal::control::FeedMode::PerRevolution => cut.value * speed / unit,
        _ => cut.value * 60.0 / unit,
    };
    let place = |letter| draft.place(letter);
    let (f, q) = (place(b'F'), place(b'Q'));
    let style = context.style();
    let title = context.to.table.title;
    match (one, other) {
        (TapFeed::SpeedWithLeadQ, TapFeed::Programmed) => {
            if let Some(f) = f {
                let new = format!("F{}", numbers::plain(per_minute, 4, style));
                draft.replace(f, new, format!("F of a tap is the feed on {title}"));
            }
            if let Some(q) = q {
                draft.remove(q, format!("{title} takes the lead from F and S"));
            }
            Ok(())
        }
        (TapFeed::Programmed, TapFeed::SpeedWithLeadQ) if speed > 0.0 => {
            if let Some(f) = f {
                let new = format!("F{}", numbers::plain(speed, 3, style));
                draft.replace(f, new, format!("F of a tap is the spindle speed on {title}"));
            }
            let lead = numbers::plain(per_minute / speed, 6, style);
            draft.append(format!("Q{lead}"), format!("{title} takes the lead from Q"));
            Ok(())
        }
        _ => Err(NeedsExpansion(format!("F of a tap means something else on {title}"))),
    }
}

/// P of a cycle.
fn dwell(context: &ConvertContext, draft: &mut BlockDraft) {
    let [one, other] = context.controls().map(|control| control.parameters.rules.cycles);
    let Some(p) = draft.place(b'P').filter(|p| !draft.is_gone(*p)) else { return };
    let Some(number) = draft.block.words[p].number() else { return };
    let [one, other] = [one, other].map(|rules| DwellWord {
        letter: b'P',
        integer_s: rules.dwell_integer_s,
        point_s: rules.dwell_point_s,
        takes_point: true,
    });
    let unit = one.unit_s(number.has_point);
    if unit == other.unit_s(number.has_point) {
        return;
    }
    let new = numbers::time_word(number.to_f64() * unit, other);
    draft.replace(
        p,
        new,
        format!("{} reads the dwell time of a cycle like this", context.to.table.title),
    );
}

/// G80 in a block of its own, where it excludes motion codes.
fn split_from_motion(context: &ConvertContext, draft: &mut BlockDraft, at: usize) {
    let [one, other] =
        context.controls().map(|control| control.parameters.rules.cycles.one_group_with_motion);
    let moves = context.source.has_action(at, context.from, Action::is_plain_motion);
    if one || !other || !moves {
        return;
    }
    for word in 0..draft.block.words.len() {
        if code_action(&draft.block.words[word], context.from)
            == Some(Action::Mode(ModeCode::CancelCycle))
        {
            let code = draft.now(word);
            let reason = format!(
                "{code} cannot be in a block with motion codes on {}",
                context.to.table.title
            );
            draft.replace(word, "", reason);
            draft.before.push(code);
        }
    }
}

/// G80 where only the old control ends a cycle by another code.
fn ending(context: &ConvertContext, draft: &mut BlockDraft, at: usize) {
    let Some(run) = context.run(at) else { return };
    let was = matches!(run.before.motion, Some(Action::Cycle(_)));
    let is = matches!(run.after.motion, Some(Action::Cycle(_)));
    let own = context
        .source
        .has_action(at, context.from, |action| action == Action::Mode(ModeCode::CancelCycle));
    let [one, other] = context.controls().map(|control| control.parameters.rules.cycles.cancel);
    if !was || is || own || one == other {
        return;
    }
    let Some(code) = codes::name(Action::Mode(ModeCode::CancelCycle), context.to, context.style())
    else {
        return;
    };
    let title = context.to.table.title;
    draft.note(
        String::new(),
        code.clone(),
        format!("ends the cycle, which stays active on {title}"),
    );
    draft.before.push(code);
}
