//! What the Z of each block counts from: a place of the machine, the safe level of rapids, or the surface.

use std::collections::HashMap;

use chordal::control::{Action, OnceCode};
use chordal::syntax::Block;

use super::super::record::{Did, Record, Runs};
use super::super::roles::actions;
use super::super::writer::Writer;

/// Where Z stands before a block.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Level {
    /// Where a move to a place of the machine has left it, or nowhere known.
    #[default]
    Machine,
    /// Where a rapid of the program has put it: above every height of the map by as much as it was above zero.
    Rapid,
    /// On the surface, where a cut has put it.
    Cut,
}

/// The block goes to a place of the machine.
pub(super) fn is_machine(writer: &Writer, block: &Block) -> bool {
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
pub(super) fn levels(writer: &Writer, record: &Record, blocks: &[Block]) -> HashMap<u32, Level> {
    let mut ran: Vec<(&Block, &Runs)> = blocks
        .iter()
        .filter_map(|block| Some((block, record.blocks.get(&block.range.start)?)))
        .collect();
    ran.sort_by_key(|(_, runs)| runs.order);
    let (mut levels, mut level) = (HashMap::new(), Level::Machine);
    for (block, runs) in ran {
        levels.insert(block.range.start, level);
        let run = &runs.first;
        let is_elsewhere = run.from[2] != run.to[2] || run.known[0].has(2) != run.known[1].has(2);
        level = match run.context.did {
            Did::Nothing if is_elsewhere => Level::Machine,
            Did::Nothing => level,
            _ if is_machine(writer, block) && is_elsewhere => Level::Machine,
            _ if is_machine(writer, block) => level,
            Did::Rapid if block.word(b'Z').is_some() => Level::Rapid,
            // Aside from a cut it is lifted before.
            Did::Rapid if level == Level::Cut => Level::Rapid,
            Did::Rapid => level,
            _ => Level::Cut,
        };
    }
    levels
}
