//! What the words of canned cycles mean, by the family of the cycle and the rules of a control.

use chordal_kernel::rules::{
    BackBore, CycleDwell, CycleFamily, CycleKind, CycleRules, DrillingAxis, PeckDwell, ShiftWords,
    TapFeed,
};

use super::CycleWordRole;
use crate::parameters::Parameters;
use crate::table::ControlTable;

/// What the number of Q, I, J or K of a cycle is.
pub fn cycle_word_role(kind: CycleKind, letter: u8) -> CycleWordRole {
    match kind.family() {
        CycleFamily::FineBore | CycleFamily::BackBore => match letter {
            b'Q' => CycleWordRole::Doubtful,
            b'I' => CycleWordRole::Distance(0),
            b'J' => CycleWordRole::Distance(1),
            b'K' => CycleWordRole::LengthByPoint,
            _ => CycleWordRole::Other,
        },
        CycleFamily::Drill
        | CycleFamily::ChipBreak
        | CycleFamily::Peck
        | CycleFamily::Tap
        | CycleFamily::Bore => match letter {
            b'Q' => CycleWordRole::Length,
            // K counts repeats on some controls, and then has no point.
            b'I' | b'J' | b'K' => CycleWordRole::LengthByPoint,
            _ => CycleWordRole::Other,
        },
    }
}

/// What a letter means; `None` where it does nothing to the path.
pub(super) fn meaning(
    kind: CycleKind,
    letter: u8,
    table: &ControlTable,
    parameters: &Parameters,
) -> Option<String> {
    let rules = &parameters.rules.cycles;
    let text = match letter {
        b'R' if table.lexicon.registers => "R level, written R0+…: where feeding begins",
        b'R' if rules.r_from_initial => "distance from where the tool is to where feeding begins",
        b'R' if rules.axis == DrillingAxis::OfCode => "R level: where feeding begins",
        b'R' => "R level: where feeding begins, and to where G99 returns",
        _ if letter == rules.repeat_letter => "number of holes; in G91 each is one step further",
        b'E' if kind.facts().throws_chips => {
            "speed at which the spindle throws off the chips after the hole"
        }
        b'P' if rules.peck.p_is_distance(kind) => match kind.family() == CycleFamily::ChipBreak {
            true => "lift after each peck",
            false => "clearance above the last peck",
        },
        b'P' => return dwell(kind, rules),
        b'Q' => q(kind, rules)?,
        b'I' | b'J' | b'K' => vector(kind, letter, rules)?,
        _ => return None,
    };
    Some(text.into())
}

fn dwell(kind: CycleKind, rules: &CycleRules) -> Option<String> {
    let text = match (kind.family(), rules.peck.dwell, kind.facts().dwell) {
        (CycleFamily::ChipBreak, PeckDwell::EachPeck, _) => "dwell at the bottom of each peck",
        (CycleFamily::ChipBreak | CycleFamily::Peck, PeckDwell::Bottom, _) => BOTTOM,
        (_, _, CycleDwell::Optional | CycleDwell::Essential) => BOTTOM,
        (_, _, CycleDwell::None) => return None,
    };
    let unit = |seconds: f64| if seconds == 1.0 { "1 s" } else { "0.001 s" };
    let (whole, point) = (rules.dwell_integer_s, rules.dwell_point_s);
    Some(match whole == point {
        true => format!("{text}; P1 is {}", unit(whole)),
        false => format!("{text}; P1 is {}, P1. is {}", unit(whole), unit(point)),
    })
}

const BOTTOM: &str = "dwell at the bottom of the hole";

fn q(kind: CycleKind, rules: &CycleRules) -> Option<&'static str> {
    let by_vector = rules.bore.shift == ShiftWords::Vector;
    match kind.family() {
        CycleFamily::ChipBreak | CycleFamily::Peck => Some("depth of each peck"),
        CycleFamily::Tap if rules.tap.feed == TapFeed::SpeedWithLeadQ => Some("lead of the thread"),
        CycleFamily::Tap => rules.tap.pecks_by_q.then_some("depth of each peck of the tap"),
        CycleFamily::FineBore => {
            (!by_vector).then_some("how far the tool steps away from the wall before it goes out")
        }
        CycleFamily::BackBore => (!by_vector && rules.bore.back != BackBore::UpAndDown)
            .then_some("how far the tool steps aside on its way past the bore"),
        CycleFamily::Drill | CycleFamily::Bore => None,
    }
}

fn vector(kind: CycleKind, letter: u8, rules: &CycleRules) -> Option<&'static str> {
    let up_and_down = rules.bore.back == BackBore::UpAndDown;
    match kind.family() {
        CycleFamily::ChipBreak if letter == b'K' && rules.peck.return_after_k => {
            Some("with I: smallest peck; with Q: depth after which the tool returns to R")
        }
        CycleFamily::ChipBreak | CycleFamily::Peck => {
            rules.peck.decreasing.then_some(match letter {
                b'I' => "depth of the first peck, in place of Q",
                b'J' => "reduction of each further peck",
                _ => "smallest peck",
            })
        }
        CycleFamily::Tap => (letter == b'J' && rules.tap.out_factor_by_j)
            .then_some("speed of the way out, as a multiple of the way in"),
        CycleFamily::BackBore if up_and_down => Some(match letter {
            b'K' => "top of the bore",
            _ => "how far the tool steps aside on its way past the bore",
        }),
        CycleFamily::FineBore | CycleFamily::BackBore => (rules.bore.shift != ShiftWords::Q)
            .then_some("how far the tool steps away from the wall, as a vector"),
        CycleFamily::Drill | CycleFamily::Bore => None,
    }
}
