//! What the Z of each block counts from: a place of the machine, the safe level of rapids, or the surface.

use std::collections::HashMap;

use chordal::control::{Action, OnceCode};
use chordal::syntax::Block;

use super::super::record::{BlockEffect, BlockRuns, RunRecord};
use super::super::roles::actions;
use super::super::writer::WordWriter;

/// Where Z stands before a block.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum ZLevel {
    /// Where a move to a place of the machine has left it, or nowhere known.
    #[default]
    Machine,
    /// Where a rapid of the program has put it: above every height of the map by as much as it was above zero.
    Rapid,
    /// On the surface, where a cut has put it.
    Cut,
}

/// The block goes to a place of the machine.
pub(super) fn is_machine(writer: &WordWriter, block: &Block) -> bool {
    actions(block, writer.control).any(|(_, action)| {
        matches!(
            action,
            Action::Once(
                OnceCode::MachineCoordinates
                    | OnceCode::ReturnToReference { .. }
                    | OnceCode::ReturnFromReference
                    | OnceCode::Home
            )
        )
    })
}

/// The level before each block, by its first byte, as the first run of it finds it.
pub(super) fn levels(
    writer: &WordWriter,
    record: &RunRecord,
    blocks: &[Block],
) -> HashMap<u32, ZLevel> {
    let mut ran: Vec<(&Block, &BlockRuns)> = blocks
        .iter()
        .filter_map(|block| Some((block, record.blocks.get(&block.range.start)?)))
        .collect();
    ran.sort_by_key(|(_, runs)| runs.order);
    let (mut levels, mut level) = (HashMap::new(), ZLevel::Machine);
    for (block, runs) in ran {
        levels.insert(block.range.start, level);
        let run = &runs.first;
        let is_outside = run.from[2] != run.to[2] || run.known[0].has(2) != run.known[1].has(2);
        level = match run.context.did {
            BlockEffect::Nothing if is_outside => ZLevel::Machine,
            BlockEffect::Nothing => level,
            _ if is_machine(writer, block) && is_outside => ZLevel::Machine,
            _ if is_machine(writer, block) => level,
            BlockEffect::Rapid if block.word(b'Z').is_some() => ZLevel::Rapid,
            // Aside from a cut it is lifted before.
            BlockEffect::Rapid if level == ZLevel::Cut => ZLevel::Rapid,
            BlockEffect::Rapid => level,
            _ => ZLevel::Cut,
        };
    }
    levels
}
