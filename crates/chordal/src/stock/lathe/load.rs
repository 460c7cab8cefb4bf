//! The load of the cuts on a lathe, and which cuts exceed a limit.

use chordal_command::{Units, number_text, telling_number};
use chordal_diagnostics::{Code, Diagnostic};
use chordal_geometry::tolerance::ROUNDING_SHARE;

use super::super::engagement::MaterialData;
use super::report::{TurnedMove, TurnedToolRemoved};
use crate::job::Job;

/// Estimates the power of each move from its removal rate and chip thickness.
pub(super) fn give_power(
    moves: &mut [TurnedMove],
    tools: &mut [TurnedToolRemoved],
    material: &MaterialData,
) {
    for move_ in moves {
        let Some(chip) = move_.chip_mm.filter(|chip| *chip > 0.0) else { continue };
        if move_.rate_mm3_per_s <= 0.0 {
            continue;
        }
        let power = material.power(move_.rate_mm3_per_s, chip);
        move_.power_kw = Some(power);
        if let Some(tool) = tools.iter_mut().find(|tool| tool.number == move_.tool)
            && tool.power.is_none_or(|(most, _)| power > most)
        {
            tool.power = Some((power, move_.origin.line));
        }
    }
}

/// Marks cuts with too thick a chip, or with more power than the spindle has, and returns the worst of each block.
pub(super) fn overloads(job: &Job<'_>, moves: &mut [TurnedMove], units: Units) -> Vec<Diagnostic> {
    let machine = job.machine();
    let mut worst: Vec<(Code, TurnedMove, f64, f64)> = Vec::new();
    for move_ in moves.iter_mut().filter(|move_| move_.removed_mm3 > 0.0 && !move_.is_thread) {
        let most = machine.tools.get(&move_.tool).and_then(|tool| tool.max_chip_mm);
        let limits = [
            (Code::ChipTooThick, move_.chip_mm, most.map(|most| most * (1.0 + ROUNDING_SHARE))),
            (Code::SpindleOverloaded, move_.power_kw, machine.spindle_power_kw),
        ];
        for (code, value, limit) in limits {
            let (Some(value), Some(limit)) = (value, limit) else { continue };
            if value <= limit {
                continue;
            }
            move_.overload = Some(code);
            let same = worst
                .iter_mut()
                .rev()
                .take(2)
                .find(|(known, other, ..)| (*known, other.origin) == (code, move_.origin));
            match same {
                Some(known) if value > known.2 => *known = (code, *move_, value, limit),
                Some(_) => {}
                None => worst.push((code, *move_, value, limit)),
            }
        }
    }
    worst
        .iter()
        .map(|(code, move_, value, limit)| limit_diagnostic(*code, move_, *value, *limit, units))
        .collect()
}

fn limit_diagnostic(
    code: Code,
    move_: &TurnedMove,
    value: f64,
    limit: f64,
    units: Units,
) -> Diagnostic {
    let tool = move_.tool;
    let chip = |mm: f64| match units {
        Units::Inch => format!("{} in", telling_number(mm / 25.4, 5)),
        Units::Millimetre => format!("{} mm", telling_number(mm, 4)),
    };
    let kilowatts = |kw: f64| format!("{} kW", number_text(kw, 2));
    let (message, label, help) = if code == Code::SpindleOverloaded {
        (
            format!(
                "this cut of tool {tool} needs about {}, the spindle has {}",
                kilowatts(value),
                kilowatts(limit)
            ),
            "too much for the spindle",
            "take less depth, or a lower feed",
        )
    } else {
        (
            format!(
                "the chip of tool {tool} is {} thick, {} is the limit",
                chip(value),
                chip(limit)
            ),
            "too thick a chip",
            "lower F here",
        )
    };
    let depth = format!("the depth of cut is {}", units.length_text(move_.depth_mm));
    Diagnostic::new(code, move_.origin.span, message).label(label).note(depth).help(help)
}
