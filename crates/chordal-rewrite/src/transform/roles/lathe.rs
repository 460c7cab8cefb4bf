//! What the words of a lathe's block stand for: increments, cycles, threads, corners of lines.

use chordal::Control;
use chordal::control::{
    Action, CycleWordRole, MotionCode, OnceCode, TurnCycle, TurnFamily, TurnPass, code_number,
    turn_facts,
};
use chordal::syntax::{Block, Letters, Word};

use super::super::record::{BlockEffect, ReadingContext};
use super::{NumberRole, actions, cycle_word};
use crate::source::is_setup;

/// What a block of a lathe is, where its words do not mean what they mean next to a move.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(in crate::transform) enum LatheBlockSort {
    /// A move, or a cycle of holes.
    Move,
    /// A cycle; the first of two blocks only sets it up.
    Cycle { cycle: TurnCycle, is_setup: bool },
    /// A pass of one block.
    Pass(TurnPass),
    /// A cut in step with the spindle.
    Thread,
    /// S limits the spindle.
    Preset,
}

impl LatheBlockSort {
    pub(in crate::transform) fn of(
        block: &Block,
        context: &ReadingContext,
        control: &Control,
    ) -> LatheBlockSort {
        let named = actions(block, control).find_map(|(_, action)| {
            if let Some(code) = action.once() {
                let cycle = action.turning_cycle().map(|cycle| LatheBlockSort::Cycle {
                    cycle,
                    is_setup: is_setup(cycle, block, control),
                });
                let preset = (code == OnceCode::PresetPosition).then_some(LatheBlockSort::Preset);
                return cycle.or(preset);
            }
            action.motion().map(of_motion)
        });
        let modal =
            || context.motion.and_then(Action::motion).map_or(LatheBlockSort::Move, of_motion);
        named.unwrap_or_else(modal)
    }

    /// It cuts a thread, whose lead belongs to its size.
    pub(in crate::transform) fn is_thread(self) -> bool {
        match self {
            LatheBlockSort::Thread | LatheBlockSort::Pass(TurnPass::Thread) => true,
            LatheBlockSort::Cycle { cycle, .. } => {
                matches!(cycle.family(), TurnFamily::Thread | TurnFamily::LineThread)
            }
            LatheBlockSort::Pass(TurnPass::Turning | TurnPass::Facing)
            | LatheBlockSort::Move
            | LatheBlockSort::Preset => false,
        }
    }

    /// The role of a word; nothing where it is what it is on a mill.
    pub(in crate::transform) fn role(
        self,
        word: &Word,
        block: &Block,
        context: &ReadingContext,
        control: &Control,
    ) -> Option<NumberRole> {
        if word.comma {
            return None;
        }
        match self {
            LatheBlockSort::Cycle { cycle, is_setup } => {
                of_cycle(word, block, cycle, is_setup, control)
            }
            LatheBlockSort::Pass(pass) => match word.letter {
                b'R' | b'I' if pass != TurnPass::Facing => Some(NumberRole::Distance(0)),
                b'R' | b'K' if pass == TurnPass::Facing => Some(NumberRole::Distance(2)),
                b'F' if pass == TurnPass::Thread => Some(NumberRole::Lead),
                b'Q' => Some(NumberRole::Other),
                _ => increment(word, control),
            },
            LatheBlockSort::Thread => match word.letter {
                letter if letter == control.parameters.thread_lead || letter == b'K' => {
                    Some(NumberRole::Lead)
                }
                b'Q' => Some(NumberRole::Other),
                _ => increment(word, control),
            },
            LatheBlockSort::Preset => increment(word, control),
            LatheBlockSort::Move => match word.letter {
                b'I' | b'K' | b'R'
                    if control.parameters.corner_words_in_g1
                        && context.did == BlockEffect::Line =>
                {
                    Some(NumberRole::Length)
                }
                b'R' if context.cycle.is_some() => Some(level_of_hole(block, control)),
                _ => increment(word, control),
            },
        }
    }
}

/// R of a hole: along X where its code drills along X, else along Z.
fn level_of_hole(block: &Block, control: &Control) -> NumberRole {
    let rules = control.parameters.rules.cycles;
    let is_radial = block.all(b'G').any(|word| {
        let code = word.number().and_then(code_number);
        code.is_some_and(|code| control.table.radial_cycles.contains(&code))
    });
    match (is_radial, rules.r_from_initial) {
        (false, true) => NumberRole::Distance(2),
        (false, false) => NumberRole::Place(2),
        (true, false) if rules.radial_r_is_diameter => NumberRole::Place(0),
        (true, _) => NumberRole::Distance(0),
    }
}

/// What a motion code makes of its block.
fn of_motion(code: MotionCode) -> LatheBlockSort {
    match code {
        MotionCode::Turn(pass) => LatheBlockSort::Pass(pass),
        MotionCode::Thread | MotionCode::RigidTap => LatheBlockSort::Thread,
        MotionCode::Rapid
        | MotionCode::Linear
        | MotionCode::ArcCw
        | MotionCode::ArcCcw
        | MotionCode::SpiralCw
        | MotionCode::SpiralCcw
        | MotionCode::Spline(_)
        | MotionCode::SplineEnd => LatheBlockSort::Move,
    }
}

/// U of X, W of Z.
fn increment(word: &Word, control: &Control) -> Option<NumberRole> {
    let increments = control.parameters.increments;
    let (_, of) = increments.iter().find(|(letter, _)| *letter == word.letter)?;
    b"XYZ".iter().position(|axis| axis == of).map(NumberRole::Distance)
}

fn of_cycle(
    word: &Word,
    block: &Block,
    cycle: TurnCycle,
    is_setup: bool,
    control: &Control,
) -> Option<NumberRole> {
    if matches!(word.letter, b'G' | b'M' | b'N' | b'T' | b'O') {
        return None;
    }
    match turn_facts(cycle).role(word.letter, is_setup) {
        CycleWordRole::Move => increment(word, control),
        CycleWordRole::CountedInTwoBlocks if block.letters().meets(Letters::of("KD")) => {
            Some(NumberRole::Other)
        }
        role => Some(cycle_word(role, word)),
    }
}
