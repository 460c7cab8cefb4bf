//! What the program has defined before a line, in its own words with values in place of parameters.

use std::collections::BTreeMap;

use crate::syntax::{KlartextBlock, KlartextStatement, LineReader};

use super::super::interpreter::KlartextInterpreter;
use super::values::text_with_values;

/// What is defined, in the order in which a head says it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum DefinitionSlot {
    /// BLK FORM.
    Blank,
    /// TOOL DEF of a tool.
    Tool(u32),
    /// Cycle 247.
    Preset,
    /// SEL TABLE.
    DatumTable,
    /// Cycle 32.
    Tolerance,
    /// Cycle 14.
    Contours,
    /// Cycle 20.
    ContourData,
    /// PATTERN DEF.
    Pattern,
    /// The cycle that calls run.
    Cycle,
}

/// The blocks of a definition.
#[derive(Clone, Debug)]
pub(super) struct Definition {
    /// Their texts; `None` for one that reads a parameter without a value.
    pub texts: Vec<Option<String>>,
    /// The line of the first.
    pub line: u32,
}

/// The definitions in force.
pub(super) type Definitions = BTreeMap<DefinitionSlot, Definition>;

/// What a block defines, and whether the definition begins with it.
fn slot_of(
    interpreter: &KlartextInterpreter<'_>,
    statement: &KlartextStatement,
) -> Option<(DefinitionSlot, bool)> {
    match statement {
        KlartextStatement::Blank { corner, .. } => {
            Some((DefinitionSlot::Blank, *corner != Some(2)))
        }
        KlartextStatement::ToolDefinition { number, length, radius } => {
            let has_data = length.is_some() || radius.is_some();
            let number = interpreter.value_of(*number)?;
            has_data.then_some((DefinitionSlot::Tool(number.round().max(0.0) as u32), true))
        }
        KlartextStatement::CycleParameters { number, .. } => match number {
            247 => Some((DefinitionSlot::Preset, true)),
            20 => Some((DefinitionSlot::ContourData, true)),
            // Patterns run at once, 270 only says how a contour train is come to, 400 and above are probing.
            220 | 221 | 270 | 400.. => None,
            _ => Some((DefinitionSlot::Cycle, true)),
        },
        KlartextStatement::CycleLine { number, line, .. } => match number {
            32 => Some((DefinitionSlot::Tolerance, *line == 0)),
            14 => Some((DefinitionSlot::Contours, *line == 0)),
            // Those act at once; what they leave is in the state.
            7..=11 | 13 | 19 | 26 => None,
            _ => Some((DefinitionSlot::Cycle, *line == 0)),
        },
        KlartextStatement::Pattern(_) => Some((DefinitionSlot::Pattern, true)),
        KlartextStatement::SelectDatumTable(_) => Some((DefinitionSlot::DatumTable, true)),
        _ => None,
    }
}

/// Takes what the next block of a run defines.
pub(super) fn follow_definition(
    interpreter: &KlartextInterpreter<'_>,
    (offset, line): (u32, u32),
    block: &KlartextBlock,
    definitions: &mut Definitions,
) {
    let Some((slot, begins)) = slot_of(interpreter, &block.statement) else { return };
    let text = interpreter.text();
    let mut reader = LineReader::new(text);
    reader.seek(offset, line);
    let Some(lines) = reader.next() else { return };
    let written = text_with_values(text, lines.range, &lines.parts, &interpreter.parameters);
    let empty = || Definition { texts: Vec::new(), line: block.line };
    let definition = definitions.entry(slot).or_insert_with(empty);
    if begins {
        *definition = empty();
    }
    definition.texts.push(written);
}
