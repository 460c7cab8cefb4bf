//! What the words of a block stand for, by what it did.

use chordal::Control;
use chordal::control::{Action, ModeCode, OnceCode, PathCode, ReadingCode};
use chordal::control::{
    BlockSort, CycleWordRole, DrillingAxis, FeedMode, TapFeed, cycle_word_role,
};
use chordal::syntax::{Block, Word, WordValue};

use super::record::{BlockEffect, ReadingContext};

mod lathe;

pub(super) use self::lathe::LatheBlockSort;

/// What a number stands for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum NumberRole {
    /// A coordinate of the program: of X, Y or Z.
    Place(usize),
    /// A way along an axis.
    Distance(usize),
    /// A coordinate of an arc's centre.
    Center(usize),
    /// A part of the way between an arc's centre and its start.
    Spoke(usize),
    /// A length without a direction.
    Length,
    /// The same, counted in least increments.
    Counted,
    /// A length that belongs to the machine: where moving the path changes nothing.
    Machine,
    Feed,
    /// The feed of a tap, which goes with the spindle.
    TapFeed,
    /// The way for each turn of a tap.
    Lead,
    Speed,
    /// It may be a length, and moving the path may concern it.
    Doubtful,
    /// No length.
    Other,
}

/// The rows of a block's G and M codes.
pub(super) fn actions<'a>(
    block: &'a Block,
    control: &'a Control,
) -> impl Iterator<Item = (&'a Word, Action)> {
    block.words.iter().filter_map(move |word| Some((word, control.row_of(word)?.action)))
}

/// The role of each word of a block.
pub(super) fn roles(block: &Block, context: &ReadingContext, control: &Control) -> Vec<NumberRole> {
    let mut sort = BlockSort::Move;
    let mut starts_compensation = false;
    // Letters that are lengths with a code that says how corners are passed.
    let mut corner_letters: &[u8] = b"";
    for (_, action) in actions(block, control) {
        let own = action.facts(control.table, &control.parameters).block;
        if own != BlockSort::Move {
            sort = own;
        }
        if action == Action::Mode(ModeCode::Path(PathCode::Continuous)) {
            corner_letters = b"PQ";
        } else if action == Action::Mode(ModeCode::Path(PathCode::Smoothness)) {
            corner_letters = b"E";
        }
        starts_compensation |= matches!(
            action,
            Action::Mode(ModeCode::CompensationLeft)
                | Action::Mode(ModeCode::CompensationRight)
                | Action::Mode(ModeCode::CornerArc)
                | Action::Once(OnceCode::CornerArcBlock)
        );
    }
    let left_to_right = control.table.distance_left_to_right;
    let mut incremental =
        if left_to_right { context.incremental_before } else { context.incremental };
    let turned = control.table.kind.map(|_| LatheBlockSort::of(block, context, control));
    let mut roles = Vec::with_capacity(block.words.len());
    for word in &block.words {
        let own = turned.filter(|_| sort == BlockSort::Move);
        if let Some(role) = own.and_then(|turned| turned.role(word, block, context, control)) {
            roles.push(role);
            continue;
        }
        if left_to_right && word.letter == b'G' {
            match control.row_of(word).map(|row| row.action) {
                Some(Action::Reading(ReadingCode::Absolute)) => incremental = false,
                Some(Action::Reading(ReadingCode::Incremental)) => incremental = true,
                _ => {}
            }
        }
        let role = match sort {
            BlockSort::Move if corner_letters.contains(&word.letter) => NumberRole::Length,
            BlockSort::Move => move_role(word, context, control, incremental, starts_compensation),
            BlockSort::Dwell | BlockSort::Arguments => NumberRole::Other,
            BlockSort::Data | BlockSort::Machine => match word.letter {
                b'X' | b'Y' | b'Z' | b'R' => NumberRole::Machine,
                b'F' => NumberRole::Feed,
                _ => NumberRole::Other,
            },
            BlockSort::Local => match axis(word.letter) {
                Some(axis) => NumberRole::Distance(axis),
                None => NumberRole::Other,
            },
            BlockSort::Pattern | BlockSort::Pocket => match (axis(word.letter), word.letter) {
                (Some(axis), _) if incremental => NumberRole::Distance(axis),
                (Some(axis), _) => NumberRole::Place(axis),
                (None, b'F') => NumberRole::Feed,
                (None, b'S') => NumberRole::Speed,
                (None, b'I' | b'J' | b'K' | b'Q' | b'R') => NumberRole::Doubtful,
                _ => NumberRole::Other,
            },
        };
        roles.push(role);
    }
    roles
}

fn axis(letter: u8) -> Option<usize> {
    b"XYZ".iter().position(|axis| *axis == letter)
}

/// The axis along which the cycles of a mill drill.
pub(super) fn drilling_axis(context: &ReadingContext, control: &Control) -> usize {
    match control.parameters.rules.cycles.axis {
        DrillingAxis::AlwaysZ | DrillingAxis::OfCode => 2,
        DrillingAxis::PlaneNormal => context.plane.axes().2,
    }
}

fn move_role(
    word: &Word,
    context: &ReadingContext,
    control: &Control,
    incremental: bool,
    starts_compensation: bool,
) -> NumberRole {
    let place = |axis: usize| {
        if incremental { NumberRole::Distance(axis) } else { NumberRole::Place(axis) }
    };
    let normal = context.plane.axes().2;
    let drilled = drilling_axis(context, control);
    let in_cycle = context.cycle.is_some();
    let is_arc = matches!(context.did, BlockEffect::Arc | BlockEffect::Spiral);
    if word.comma {
        return if matches!(word.letter, b'R' | b'C') {
            NumberRole::Length
        } else {
            NumberRole::Other
        };
    }
    match word.letter {
        letter @ b'X'..=b'Z' => place(usize::from(letter - b'X')),
        b'F' if context.cycle.is_some_and(|cycle| cycle.is_tap()) => {
            match (control.parameters.rules.cycles.tap.feed, context.feed_mode) {
                (TapFeed::SpeedWithLeadQ, _) => NumberRole::Speed,
                (TapFeed::Lead, _) | (TapFeed::Programmed, FeedMode::PerRevolution) => {
                    NumberRole::Lead
                }
                (TapFeed::Programmed, _) => NumberRole::TapFeed,
            }
        }
        b'F' => NumberRole::Feed,
        b'S' => NumberRole::Speed,
        letter @ b'I'..=b'K' if is_arc => {
            let axis = usize::from(letter - b'I');
            let is_place = context.arc_center == chordal::control::ArcCenter::Absolute;
            if axis != normal && is_place {
                NumberRole::Center(axis)
            } else {
                NumberRole::Spoke(axis)
            }
        }
        b'I'..=b'K' | b'Q' if in_cycle => context
            .cycle
            .map_or(NumberRole::Other, |kind| cycle_word(cycle_word_role(kind, word.letter), word)),
        letter @ b'I'..=b'K' if starts_compensation => {
            NumberRole::Distance(usize::from(letter - b'I'))
        }
        b'R' if control.table.lexicon.registers => match word.register {
            Some(0) if is_arc => NumberRole::Length,
            Some(0) if in_cycle => place(drilled),
            _ => NumberRole::Doubtful,
        },
        b'R' if is_arc => NumberRole::Length,
        b'R' if in_cycle => place(drilled),
        b'Q' if context.did == BlockEffect::Spiral => NumberRole::Length,
        _ => NumberRole::Other,
    }
}

/// The role of a word of a cycle.
fn cycle_word(role: CycleWordRole, word: &Word) -> NumberRole {
    let has_point = word.number().is_some_and(|number| number.has_point);
    match role {
        CycleWordRole::Length => NumberRole::Length,
        CycleWordRole::LengthByPoint if has_point => NumberRole::Length,
        CycleWordRole::CountedLength | CycleWordRole::CountedInTwoBlocks if has_point => {
            NumberRole::Length
        }
        CycleWordRole::CountedLength | CycleWordRole::CountedInTwoBlocks => NumberRole::Counted,
        CycleWordRole::Distance(axis) => NumberRole::Distance(axis),
        CycleWordRole::Lead => NumberRole::Lead,
        CycleWordRole::Doubtful => NumberRole::Doubtful,
        CycleWordRole::LengthByPoint | CycleWordRole::Move | CycleWordRole::Other => {
            NumberRole::Other
        }
    }
}

/// Whether a word has a value that can be changed by its text.
pub(super) fn is_fixed(word: &Word) -> bool {
    matches!(word.value, WordValue::Register { .. } | WordValue::Missing)
}
