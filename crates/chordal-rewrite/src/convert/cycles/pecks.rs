//! The words of G73 and G83: Q against I, J and K, and what P is.

use chordal::CommandKind;
use chordal::control::{Control, CycleKind, PeckDwell};

use crate::convert::context::ConvertContext;
use crate::convert::draft::{BlockDraft, NeedsExpansion};
use crate::convert::numbers;
use crate::convert::trace::BlockExecution;

/// What P is in a cycle with pecks.
#[derive(Clone, Copy, PartialEq)]
enum PeckWordMeaning {
    Nothing,
    /// How far the tool goes back.
    Lift,
    DwellAtBottom,
    DwellAtEachPeck,
}

/// The words that another control reads otherwise.
pub(super) fn words(
    context: &ConvertContext,
    draft: &mut BlockDraft,
    kind: CycleKind,
    run: &BlockExecution,
) -> Result<(), NeedsExpansion> {
    dwell_or_lift(context, draft, kind, run)?;
    steps(context, draft, kind, run)?;
    positive(context, draft);
    Ok(())
}

fn meaning_of_p(control: &Control, kind: CycleKind) -> PeckWordMeaning {
    let rules = control.parameters.rules.cycles.peck;
    match rules.dwell {
        _ if rules.p_is_distance(kind) => PeckWordMeaning::Lift,
        PeckDwell::Bottom => PeckWordMeaning::DwellAtBottom,
        PeckDwell::EachPeck if kind == CycleKind::ChipBreak => PeckWordMeaning::DwellAtEachPeck,
        PeckDwell::EachPeck | PeckDwell::None => PeckWordMeaning::Nothing,
    }
}

fn dwell_or_lift(
    context: &ConvertContext,
    draft: &mut BlockDraft,
    kind: CycleKind,
    run: &BlockExecution,
) -> Result<(), NeedsExpansion> {
    let title = context.to.table.title;
    let [one, other] = context.controls().map(|control| meaning_of_p(control, kind));
    if one == other {
        return Ok(());
    }
    if let Some(p) = draft.place(b'P') {
        let number = draft.block.words[p].number();
        let waits = number.is_none_or(|number| number.to_f64() != 0.0);
        match one {
            PeckWordMeaning::DwellAtBottom | PeckWordMeaning::DwellAtEachPeck if waits => {
                return Err(NeedsExpansion(format!("{title} does not wait for P in this cycle")));
            }
            PeckWordMeaning::Lift => {
                draft.remove(p, format!("{title} takes the lift from a setting"))
            }
            _ => draft.remove(p, format!("P does nothing here, and would on {title}")),
        }
    }
    if other == PeckWordMeaning::Lift {
        let rules = &context.from.parameters.rules;
        let mm = match kind == CycleKind::ChipBreak {
            true => rules.chip_break_mm,
            false => rules.peck_clearance_mm,
        };
        let digits = numbers::digits(context.to, run.after.units);
        let text = numbers::length(mm, run.after.units, digits, context.style());
        draft.append(format!("P{text}"), format!("{title} takes the lift from P"));
    }
    Ok(())
}

/// I, J and K as Q. No peck gets deeper than it was: Q is the smallest of them.
fn steps(
    context: &ConvertContext,
    draft: &mut BlockDraft,
    kind: CycleKind,
    run: &BlockExecution,
) -> Result<(), NeedsExpansion> {
    let [one, other] = context.controls().map(|control| control.parameters.rules.cycles.peck);
    let title = context.to.table.title;
    let first = draft.place(b'I').filter(|_| one.decreasing);
    let returns = kind == CycleKind::ChipBreak && one.return_after_k && !other.return_after_k;
    if first.is_none() && returns && draft.place(b'K').is_some() {
        return Err(NeedsExpansion(format!("{title} does not return to R within this cycle")));
    }
    let Some(first) = first.filter(|_| !other.decreasing) else { return Ok(()) };
    let Some(smallest) = smallest_step(context, run) else {
        return Err(NeedsExpansion(format!("{title} has no I, J and K for pecks")));
    };
    let digits = numbers::digits(context.to, run.after.units);
    let text = numbers::length(smallest, run.after.units, digits, context.style());
    let reason = format!("{title} has pecks of one depth: the smallest of I, J and K");
    draft.replace(first, format!("Q{text}"), reason);
    for letter in [b'J', b'K', b'Q'] {
        if let Some(word) = draft.place(letter) {
            draft.remove(word, format!("{title} has pecks of one depth"));
        }
    }
    Ok(())
}

/// The smallest peck of the first hole, mm; the last one, which ends at the bottom, only where it is alone.
fn smallest_step(context: &ConvertContext, run: &BlockExecution) -> Option<f64> {
    let commands = context.trace.commands_of(run).iter().filter(|command| command.origin.cycle);
    let cuts = commands.filter_map(|command| match &command.kind {
        CommandKind::Line { motion, .. } => Some(motion),
        _ => None,
    });
    let mut cuts = cuts.peekable();
    let first = *cuts.peek()?;
    let axis = (0..3).find(|axis| first.from[*axis] != first.to[*axis])?;
    let mut level = first.from[axis];
    let mut steps = Vec::new();
    for cut in cuts {
        let to = cut.to;
        let is_aside = (0..3).any(|own| own != axis && to[own] != first.from[own]);
        // The next hole begins elsewhere, or at R again.
        if is_aside || (to[axis] - level) * (first.to[axis] - first.from[axis]) <= 0.0 {
            break;
        }
        steps.push((to[axis] - level).abs());
        level = to[axis];
    }
    if steps.len() > 1 {
        steps.pop();
    }
    steps.into_iter().reduce(f64::min)
}

/// A minus in front of Q, which some controls do not heed.
fn positive(context: &ConvertContext, draft: &mut BlockDraft) {
    let [one, other] =
        context.controls().map(|control| control.parameters.rules.cycles.peck.positive_only);
    let Some(q) = draft.place(b'Q').filter(|q| !one && other && !draft.is_changed(*q)) else {
        return;
    };
    let written = draft.written(q);
    if written.contains('-') {
        let title = context.to.table.title;
        draft.replace(q, written.replace('-', ""), format!("{title} wants Q above zero"));
    }
}
