//! Tracks positions that belong to the machine and not to the program: the start position, and the targets of G28 and
//! G53. They stay where they are when the program's path is transformed.

use chordal::control::{Action, OnceCode};
use std::collections::HashMap;

use chordal::Job;
use chordal::diagnostics::Span;
use chordal::syntax::{Block, BlockReader};

/// Which of X, Y and Z a block programs, and whether it moves them to machine positions.
#[derive(Clone, Copy, Debug, Default)]
struct NamedAxes {
    axes: [bool; 3],
    is_machine: bool,
}

/// Tracks which axes are at machine positions.
#[derive(Debug)]
pub(crate) struct MachinePlaces {
    names: HashMap<(u32, u32), NamedAxes>,
    at_machine: [bool; 3],
    /// Whether the machine has X, Y and Z.
    exists: [bool; 3],
}

impl MachinePlaces {
    pub(crate) fn of(job: &Job) -> MachinePlaces {
        let exists = [0, 1, 2].map(|axis| job.machine().axes[axis].is_some());
        // A machine file without axes does not describe them, so all are assumed.
        let exists = if exists == [false; 3] { [true; 3] } else { exists };
        MachinePlaces { names: names(job), at_machine: exists, exists }
    }

    /// Whether a move of a block begins or ends at a machine position. Must be called for all moves in order.
    pub(crate) fn has(&mut self, span: Span) -> bool {
        let block = self.names.get(&(span.file.0, span.range.start)).copied().unwrap_or_default();
        let began = self.at_machine;
        // G28 without axis words moves all axes.
        let all = block.is_machine && block.axes == [false; 3];
        for (axis, is_at_machine) in self.at_machine.iter_mut().enumerate() {
            if self.exists[axis] && (block.axes[axis] || all) {
                *is_at_machine = block.is_machine;
            }
        }
        began.contains(&true) || self.at_machine.contains(&true)
    }
}

fn names(job: &Job) -> HashMap<(u32, u32), NamedAxes> {
    let mut names = HashMap::new();
    let Some(control) = job.word_address() else { return names };
    for (file, source) in job.sources().iter() {
        let mut reader = BlockReader::new(source.text(), file, control.table.lexicon);
        let mut block = Block::new();
        while reader.read(&mut block) {
            let increments = control.parameters.increments;
            let axes = [b'X', b'Y', b'Z'].map(|letter| {
                let by = increments.iter().find(|(_, of)| *of == letter);
                block.letters().has(letter) || by.is_some_and(|(own, _)| block.letters().has(*own))
            });
            let is_machine = block.all(b'G').any(|word| {
                let code = word.number().map(|number| (number.to_f64() * 10.0).round());
                let row = code.and_then(|code| control.g_code(code as u16));
                row.is_some_and(|row| {
                    matches!(
                        row.action,
                        Action::Once(OnceCode::ReturnToReference { .. })
                            | Action::Once(OnceCode::MachineCoordinates | OnceCode::Home)
                    )
                })
            });
            names.insert((file.0, block.range.start), NamedAxes { axes, is_machine });
        }
    }
    names
}
