//! Lengths and radii of tools that the program itself gives, as TOOL DEF and TOOL CALL of HEIDENHAIN programs do.
//!
//! Other languages take them from the tool table: the target gets them there.

use std::collections::BTreeMap;

use chordal::control::{Origin, Position};
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

/// Reads the commands of two runs, and what they say about tools.
struct ToolDataReader<'m> {
    /// The machine of the old program.
    machine: &'m Machine,
    /// The same with the lengths of [`TableSet::FIRST`].
    filled: Machine,
    tools: ProgramTools,
    /// What is said of the length of each tool.
    lengths: BTreeMap<u32, (Option<f64>, f64)>,
    /// The radius of each tool, mm.
    radii: BTreeMap<u32, f64>,
}

impl ToolDataReader<'_> {
    /// Takes a command of both runs, or says why no table can have its data.
    fn take(&mut self, one: &Command, other: &Command) -> Result<(), String> {
        let origin = one.origin;
        if let (
            CommandKind::ToolLength {
                number: Some(number),
                offset: zero,
                is_subtracted: false,
                ..
            },
            CommandKind::ToolLength { offset, .. },
        ) = (&one.kind, &other.kind)
        {
            self.take_length(*number, [zero, offset], origin)?;
        }
        if let CommandKind::Compensation { number: Some(number), radius_mm: Some(radius), .. } =
            &one.kind
        {
            self.take_radius(*number, *radius, origin)?;
        }
        Ok(())
    }

    fn take_length(
        &mut self,
        number: u32,
        [zero, other]: [&Position; 2],
        origin: Origin,
    ) -> Result<(), String> {
        if (0..TOOL_AXIS).any(|axis| zero[axis] != other[axis]) {
            return Err(format!(
                "the length of tool {number} does not lie along Z, because the tool axis is another one: only programs with the tool axis Z are converted, so write it for that axis"
            ));
        }
        let table = self.filled.tools.get(&number).and_then(|tool| tool.offset[TOOL_AXIS]);
        let own = own_length([zero[TOOL_AXIS], other[TOOL_AXIS]], table.unwrap_or(0.0));
        let before = self.lengths.insert(number, own);
        if before.is_some_and(|before| before != own) {
            return Err(format!(
                "the program gives tool {number} several lengths, and a tool table has one: give each length a tool number of its own"
            ));
        }
        if own != (None, 0.0) {
            let tool = self.tools.tool(number, origin);
            (tool.length_mm, tool.allowance_mm) = own;
        }
        Ok(())
    }

    fn take_radius(&mut self, number: u32, radius: f64, origin: Origin) -> Result<(), String> {
        let before = self.radii.insert(number, radius);
        if before.is_some_and(|before| (before - radius).abs() > EQUAL_MM) {
            return Err(format!(
                "the program gives tool {number} several radii, and a tool table has one: give each radius a tool number of its own"
            ));
        }
        let of_table = self.machine.tools.get(&number).and_then(|tool| {
            Some((tool.diameter_mm? + tool.diameter_wear_mm.unwrap_or(0.0)) / 2.0)
        });
        if of_table.is_none_or(|own| (own - radius).abs() > EQUAL_MM) {
            self.tools.tool(number, origin).radius_mm = Some(radius);
        }
        Ok(())
    }
}

impl ProgramTools {
    /// From the commands of two runs: with lengths of zero in the table, and with those of [`TableSet::FIRST`]. Programs
    /// of words write into the tables, which is refused elsewhere: they give no data themselves.
    pub fn of(
        old: &Job,
        used: &UsedNumbers,
        [without, with]: [&[Command]; 2],
    ) -> Result<ProgramTools, ToolConflict> {
        let mut reader = ToolDataReader {
            machine: old.machine(),
            filled: TableSet::FIRST.fill(old.machine(), old.profile(), used),
            tools: ProgramTools::default(),
            lengths: BTreeMap::new(),
            radii: BTreeMap::new(),
        };
        if old.word_address().is_some() {
            return Ok(reader.tools);
        }
        for (one, other) in without.iter().zip(with) {
            let conflict = |reason| ToolConflict { origin: one.origin, reason };
            reader.take(one, other).map_err(conflict)?;
        }
        Ok(reader.tools)
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

    /// Puts the lengths that the program gives into the table of its own machine: the tip is then where the program says.
    pub fn put_lengths_into(&self, machine: &mut Machine) {
        for (number, own) in &self.0 {
            if let Some(length) = own.length_mm {
                let tool = machine.tools.entry(*number).or_default();
                tool.offset[TOOL_AXIS] = Some(length);
                tool.offset_wear[TOOL_AXIS] = None;
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
