//! The words of boring cycles: which way the tool steps aside, and whether G86 waits.

use chordal::control::{BoreRules, CycleKind, ShiftWords};

use crate::convert::context::ConvertContext;
use crate::convert::draft::{BlockDraft, NeedsExpansion};
use crate::convert::numbers;
use crate::convert::trace::BlockExecution;

const CENTERS: &[u8; 3] = b"IJK";

/// The words that another control reads otherwise.
pub(super) fn words(
    context: &ConvertContext,
    draft: &mut BlockDraft,
    kind: CycleKind,
    run: &BlockExecution,
) -> Result<(), NeedsExpansion> {
    let [one, other] = context.controls().map(|control| control.parameters.rules.cycles.bore);
    if kind.steps_aside() {
        return shift(context, draft, run, [one, other]);
    }
    if kind == CycleKind::BoreStop && one.dwell_before_stop != other.dwell_before_stop {
        return dwell(context, draft, one);
    }
    Ok(())
}

/// P of G86 where only one of the controls waits.
fn dwell(
    context: &ConvertContext,
    draft: &mut BlockDraft,
    old: BoreRules,
) -> Result<(), NeedsExpansion> {
    let title = context.to.table.title;
    let Some(p) = draft.place(b'P') else { return Ok(()) };
    let waits = draft.block.words[p].number().is_none_or(|number| number.to_f64() != 0.0);
    if old.dwell_before_stop && waits {
        return Err(NeedsExpansion(format!("{title} does not wait for P in this cycle")));
    }
    let needs = context.to.parameters.rules.cycles.needs_p;
    let new = if needs { "P0" } else { "" };
    draft.replace(p, new, format!("P does nothing here, and would on {title}"));
    Ok(())
}

/// Q along an axis that a parameter names, or the vector I, J.
fn shift(
    context: &ConvertContext,
    draft: &mut BlockDraft,
    run: &BlockExecution,
    rules: [BoreRules; 2],
) -> Result<(), NeedsExpansion> {
    let [one, other] = rules;
    let (q, has_vector) = (draft.place(b'Q'), draft.place(b'I').or(draft.place(b'J')).is_some());
    let by_q = q.is_some() && one.shift != ShiftWords::Vector;
    let reads_q = other.shift != ShiftWords::Vector;
    let reads_vector = other.shift != ShiftWords::Q;
    if (by_q && reads_q && one.direction == other.direction)
        || (!by_q && (!has_vector || (reads_vector && q.is_none())))
    {
        return Ok(());
    }
    let title = context.to.table.title;
    let refuse =
        || NeedsExpansion(format!("{title} steps aside in another direction in this cycle"));
    let (a, b, _) = run.after.plane.axes();
    let value = |letter: u8| {
        let Some(word) = draft.place(letter) else { return Some(0.0) };
        let number = draft.block.words[word].number()?;
        number.has_point.then(|| number.to_f64())
    };
    let vector = if by_q {
        let step = value(b'Q').ok_or_else(refuse)?.abs();
        let signed = if one.direction.minus { -step } else { step };
        if one.direction.second { [0.0, signed] } else { [signed, 0.0] }
    } else {
        [value(CENTERS[a]).ok_or_else(refuse)?, value(CENTERS[b]).ok_or_else(refuse)?]
    };
    let unit = if run.after.units == chordal::control::Units::Inch { 25.4 } else { 1.0 };
    let digits = numbers::digits(context.to, run.after.units);
    let text = |value: f64| numbers::length(value * unit, run.after.units, digits, context.style());
    let along = |second: bool| if second { [vector[1], vector[0]] } else { vector };
    let [step, aside] = along(other.direction.second);
    let new = if reads_q && aside == 0.0 && (step < 0.0) == other.direction.minus {
        vec![format!("Q{}", text(step.abs()))]
    } else if reads_vector {
        let centers = [a, b].map(|axis| char::from(CENTERS[axis]));
        vec![
            format!("{}{}", centers[0], text(vector[0])),
            format!("{}{}", centers[1], text(vector[1])),
        ]
    } else {
        return Err(refuse());
    };
    let reason = format!("{title} reads the step aside like this");
    for letter in [b'Q', b'I', b'J', b'K'] {
        if let Some(word) = draft.place(letter) {
            draft.remove(word, reason.clone());
        }
    }
    for word in new {
        draft.append(word, reason.clone());
    }
    Ok(())
}
