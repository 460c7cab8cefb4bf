//! What the words of canned cycles mean, by the family of the cycle and the rules of a control.

use chordal_kernel::rules::{
    BackBore, CycleDwell, CycleFamily, CycleKind, CycleRules, DrillingAxis, PeckDwell, ShiftWords,
    TapFeed,
};

use super::CycleWordRole;
use crate::parameters::Parameters;
use crate::table::ControlTable;

/// What the number of a word Q, I, J or K of a cycle stands for.
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

/// What a letter means; `None` where it has no effect on the path.
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
        b'P' => return dwell_meaning(kind, rules),
        b'Q' => q_meaning(kind, rules)?,
        b'I' | b'J' | b'K' => ijk_meaning(kind, letter, rules)?,
        _ => return None,
    };
    Some(text.into())
}

fn dwell_meaning(kind: CycleKind, rules: &CycleRules) -> Option<String> {
    let text = match (kind.family(), rules.peck.dwell, kind.facts().dwell) {
        (CycleFamily::ChipBreak, PeckDwell::EachPeck, _) => "dwell at the bottom of each peck",
        (CycleFamily::ChipBreak | CycleFamily::Peck, PeckDwell::Bottom, _) => DWELL_AT_BOTTOM,
        (_, _, CycleDwell::Optional | CycleDwell::Essential) => DWELL_AT_BOTTOM,
        (_, _, CycleDwell::None) => return None,
    };
    let (integer_s, point_s) = (rules.dwell_integer_s, rules.dwell_point_s);
    Some(match integer_s == point_s {
        true => format!("{text}; P1 is {integer_s} s"),
        false => format!("{text}; P1 is {integer_s} s, P1. is {point_s} s"),
    })
}

const DWELL_AT_BOTTOM: &str = "dwell at the bottom of the hole";

fn q_meaning(kind: CycleKind, rules: &CycleRules) -> Option<&'static str> {
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

fn ijk_meaning(kind: CycleKind, letter: u8, rules: &CycleRules) -> Option<&'static str> {
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
