//! Lengths and radii of tools that the program itself gives, as TOOL DEF and TOOL CALL of HEIDENHAIN programs do.
//!
//! Other languages take them from the tool table: the target gets them there.

use std::collections::BTreeMap;

use chordal::control::Origin;
use chordal::{Command, CommandKind, Job, Machine};

use super::tables::{TableSet, UsedNumbers};

/// Lengths that differ by less are the same, mm.
const EQUAL_MM: f64 = 1e-7;

/// The axis of the tool length in tables.
const TOOL_AXIS: usize = 2;

/// What a program says about one tool.
#[derive(Clone, Copy, Default, Debug)]
struct ProgramTool {
    /// Its length, mm, whatever the table has.
    length_mm: Option<f64>,
    /// What is added to the length of the table, mm.
    allowance_mm: f64,
    /// Its radius, mm, where it is not that of the table.
    radius_mm: Option<f64>,
    /// Where the program says it first.
    origin: Origin,
}

/// What a program says about its tools.
#[derive(Clone, Default, Debug)]
pub(super) struct ProgramTools(BTreeMap<u32, ProgramTool>);

/// Why the table of the target cannot have what the program says.
pub(super) struct ToolConflict {
    pub origin: Origin,
    pub reason: String,
}

impl ProgramTools {
    /// From the commands of two runs: with lengths of zero in the table, and with those of [`TableSet::FIRST`].
    pub fn of(
        old: &Job,
        used: &UsedNumbers,
        [without, with]: [&[Command]; 2],
    ) -> Result<ProgramTools, ToolConflict> {
        let mut tools = ProgramTools::default();
        let mut seen = BTreeMap::new();
        let filled = TableSet::FIRST.fill(old.machine(), old.profile(), used);
        for (one, other) in without.iter().zip(with) {
            let (origin, conflict) =
                (one.origin, |reason| ToolConflict { origin: one.origin, reason });
            if let (
                CommandKind::ToolLength {
                    number: Some(number), offset: zero, is_subtracted, ..
                },
                CommandKind::ToolLength { offset, .. },
            ) = (&one.kind, &other.kind)
            {
                if *is_subtracted {
                    continue;
                }
                if (0..TOOL_AXIS).any(|axis| zero[axis] != offset[axis]) {
                    return Err(conflict(format!(
                        "the length of tool {number} does not lie along Z: the tool axis is another one"
                    )));
                }
                let table = filled.tools.get(number).and_then(|tool| tool.offset[TOOL_AXIS]);
                let own = own_length([zero[TOOL_AXIS], offset[TOOL_AXIS]], table.unwrap_or(0.0));
                if seen.insert(*number, own).is_some_and(|before: (Option<f64>, f64)| before != own)
                {
                    return Err(conflict(format!(
                        "the program gives tool {number} several lengths: a tool table has one"
                    )));
                }
                if own != (None, 0.0) {
                    let tool = tools.tool(*number, origin);
                    (tool.length_mm, tool.allowance_mm) = own;
                }
            }
            if let CommandKind::Compensation {
                number: Some(number), radius_mm: Some(radius), ..
            } = &one.kind
            {
                let table = old.machine().tools.get(number).and_then(|tool| tool.diameter_mm);
                let is_of_table =
                    table.is_some_and(|table| (table / 2.0 - radius).abs() < EQUAL_MM);
                let before = tools.0.get(number).and_then(|tool| tool.radius_mm);
                if before.is_some_and(|before| before != *radius) {
                    return Err(conflict(format!(
                        "the program gives tool {number} several radii: a tool table has one"
                    )));
                }
                let has_wear = old
                    .machine()
                    .tools
                    .get(number)
                    .is_some_and(|tool| tool.diameter_wear_mm.is_some());
                if !is_of_table && !has_wear && !old_reads_blocks(old) {
                    tools.tool(*number, origin).radius_mm = Some(*radius);
                }
            }
        }
        Ok(tools)
    }

    fn tool(&mut self, number: u32, origin: Origin) -> &mut ProgramTool {
        self.0.entry(number).or_insert(ProgramTool { origin, ..ProgramTool::default() })
    }

    /// Puts what the program says into the table of the target.
    pub fn put_into(&self, machine: &mut Machine) {
        for (number, own) in &self.0 {
            let tool = machine.tools.entry(*number).or_default();
            if let Some(length) = own.length_mm {
                tool.offset[TOOL_AXIS] = Some(length);
                tool.offset_wear[TOOL_AXIS] = None;
            }
            if own.allowance_mm != 0.0 {
                let wear = tool.offset_wear[TOOL_AXIS].unwrap_or(0.0);
                tool.offset_wear[TOOL_AXIS] = Some(wear + own.allowance_mm);
            }
            if let Some(radius) = own.radius_mm {
                tool.diameter_mm = Some(2.0 * radius);
                tool.diameter_wear_mm = None;
            }
        }
    }

    /// In tables whose lengths are zero what the program adds is taken off, so that no length moves the tip.
    pub fn cancel_allowances(&self, machine: &mut Machine) {
        for (number, own) in self.0.iter().filter(|(_, own)| own.allowance_mm != 0.0) {
            let tool = machine.tools.entry(*number).or_default();
            let length = tool.offset[TOOL_AXIS].unwrap_or(0.0);
            tool.offset[TOOL_AXIS] = Some(length - own.allowance_mm);
        }
    }

    /// What the table of the target must have, each with its block.
    pub fn sentences(&self) -> impl Iterator<Item = (Origin, String)> + '_ {
        self.0.iter().map(|(number, own)| {
            let mut parts = Vec::new();
            parts.extend(own.length_mm.map(|mm| format!("length {}", shown(mm))));
            if own.allowance_mm != 0.0 {
                parts.push(format!("{} added to its length", shown(own.allowance_mm)));
            }
            parts.extend(own.radius_mm.map(|mm| format!("radius {}", shown(mm))));
            let reason = format!(
                "the program gives tool {number} {}: write it into the tool table of the new machine",
                parts.join(", ")
            );
            (own.origin, reason)
        })
    }
}

/// Whether only the tables of the machine give radii.
fn old_reads_blocks(old: &Job) -> bool {
    old.word_address().is_some()
}

/// The length that the program gives, or what it adds to that of the table.
fn own_length([zero, other]: [f64; 2], table: f64) -> (Option<f64>, f64) {
    if table != 0.0 && (other - zero).abs() < EQUAL_MM {
        return (Some(zero), 0.0);
    }
    (None, if zero.abs() < EQUAL_MM { 0.0 } else { zero })
}

/// A length, with its unit.
fn shown(mm: f64) -> String {
    let text = format!("{mm:.4}");
    format!("{} mm", text.trim_end_matches('0').trim_end_matches('.'))
}
