//! The position of the tool tip relative to the programmed point, from the active length offset and the length of the
//! tool in the spindle.

use chordal_command::{AxisMask, Command, CommandKind, Position, WorkName};
use chordal_geometry::Vec3;
use chordal_kernel::rules::{LengthRules, ToolLengths};
use chordal_machine::{AXES, Axis, Machine, PerAxis};

/// Offsets that differ by less are equal, mm: below the least increment of every control.
const EQUAL_OFFSET_MM: f64 = 1e-5;

/// The position of the tip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TipPlace {
    /// At the programmed point. Also if no length is known and the work offset was set with this tool.
    AsProgrammed,
    /// Assumed to be at the programmed point, as if the work offset was set with this tool, which is not known.
    Assumed,
    /// Away from the programmed point by this much, mm.
    Shifted(Vec3),
    /// Not known.
    Unknown(TipDoubt),
}

/// Why the position of the tip is not known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TipDoubt {
    /// No length offset is active, and it is not known that the work offset was set with this tool.
    NoLength,
    /// The length that the program before this one left in force is active, and nobody knows which that is.
    LeftInForce,
    /// The active length offset is that of another tool.
    OtherTool,
    /// G43 after G44, or G44 after G43: the lengths in the table have one sign.
    OtherSign,
}

/// Follows tool changes and offsets.
#[derive(Clone, Debug)]
pub struct TipTracker {
    lengths: ToolLengths,
    /// The program has not changed the length that the one before it left in force.
    is_left_in_force: bool,
    /// The axes along which the offsets of tools differ.
    axes: &'static [usize],
    tool: u32,
    number: Option<u32>,
    /// What the active tool offset adds, mm and rad.
    offset: Position,
    /// All values of the active offset are in the table.
    has_values: bool,
    is_subtracted: bool,
    /// Whether the program subtracted its first length (G44): then the lengths in its table have the opposite sign.
    subtracts: Option<bool>,
    /// A length offset has been active.
    has_had_length: bool,
    /// The axes whose work offset is known while no length is active.
    work_known: AxisMask,
    /// Coordinates are machine coordinates, which are independent of the part.
    is_in_machine: bool,
    /// The tools that have been in the spindle.
    used: Vec<u32>,
    place: TipPlace,
    /// The pairs of tool and length offset that were reported.
    reported: Vec<(u32, Option<u32>)>,
    /// The position of the tip is doubtful, and this pair of tool and length offset was not reported yet.
    is_open: bool,
}

/// The axes of tool offsets on mills.
const MILL_AXES: &[usize] = &[Axis::Z as usize];

/// The axes of tool offsets on lathes.
const LATHE_AXES: &[usize] = &[Axis::X as usize, Axis::Z as usize];

impl TipTracker {
    /// The state before the first command by the rules of the control; `known` are the axes whose work offset is known.
    pub fn new(machine: &Machine, lengths: LengthRules, known: AxisMask) -> TipTracker {
        TipTracker {
            lengths: lengths.source,
            is_left_in_force: !lengths.ended_by.program_end && lengths.source == ToolLengths::Table,
            axes: if machine.turns() { LATHE_AXES } else { MILL_AXES },
            tool: 0,
            number: None,
            offset: [0.0; AXES],
            has_values: true,
            is_subtracted: false,
            subtracts: None,
            has_had_length: false,
            work_known: known,
            is_in_machine: false,
            used: Vec::new(),
            place: TipPlace::AsProgrammed,
            reported: Vec::new(),
            is_open: false,
        }
    }

    /// Follows a command.
    #[inline]
    pub fn follow(&mut self, command: &Command, machine: &Machine) {
        // Most commands are moves.
        if matches!(
            command.kind,
            CommandKind::Tool { .. }
                | CommandKind::ToolNumber { .. }
                | CommandKind::ToolLength { .. }
                | CommandKind::WorkOffset { .. }
        ) {
            self.follow_change(command, machine);
        }
    }

    #[cold]
    fn follow_change(&mut self, command: &Command, machine: &Machine) {
        match &command.kind {
            CommandKind::Tool { number } | CommandKind::ToolNumber { number } => {
                self.tool = *number;
                if *number != 0 && !self.used.contains(number) {
                    self.used.push(*number);
                }
            }
            CommandKind::ToolLength { number, length_mm, is_subtracted, offset, known } => {
                self.is_left_in_force = false;
                self.number = *number;
                self.offset = *offset;
                self.has_values = length_mm.is_some();
                self.is_subtracted = *is_subtracted;
                if number.is_some() {
                    self.has_had_length = true;
                    self.subtracts.get_or_insert(*is_subtracted);
                } else {
                    self.work_known = *known;
                }
            }
            CommandKind::WorkOffset { name, known, .. } => {
                self.is_in_machine = *name == WorkName::Machine;
                if self.number.is_none() {
                    self.work_known = *known;
                }
            }
            _ => return,
        }
        self.place = self.placed(machine);
        self.is_open = self.is_doubtful() && !self.reported.contains(&self.tool_and_offset());
    }

    /// The position of the tip is doubtful, and this pair of tool and length offset was not reported yet.
    #[inline]
    pub fn is_open(&self) -> bool {
        self.is_open
    }

    /// Marks this pair of tool and length offset as reported.
    pub fn set_reported(&mut self) {
        self.reported.push(self.tool_and_offset());
        self.is_open = false;
    }

    /// The current position of the tip.
    #[inline]
    pub fn place(&self) -> TipPlace {
        self.place
    }

    /// Whether the tip may be somewhere else than the program assumes. It is not doubtful if the program itself has
    /// written another value into the offset of this tool.
    fn is_doubtful(&self) -> bool {
        match self.place {
            TipPlace::AsProgrammed => false,
            TipPlace::Assumed => true,
            TipPlace::Shifted(_) => self.number != Some(self.tool) || self.has_other_sign(),
            TipPlace::Unknown(_) => true,
        }
    }

    /// The tool in the spindle, and the number of the active length offset.
    pub fn tool_and_offset(&self) -> (u32, Option<u32>) {
        (self.tool, self.number)
    }

    /// Whether the program has had this tool in the spindle.
    pub fn has_used(&self, tool: u32) -> bool {
        self.used.contains(&tool)
    }

    fn placed(&self, machine: &Machine) -> TipPlace {
        if self.lengths == ToolLengths::Absent || self.tool == 0 || self.is_in_machine {
            return TipPlace::AsProgrammed;
        }
        if self.is_left_in_force {
            return TipPlace::Unknown(TipDoubt::LeftInForce);
        }
        let own = self.offsets_of(machine, self.tool);
        match self.number {
            None => self.without_number(own),
            Some(number) if number == self.tool => match own {
                Some(own) if self.has_values => self.deviation(&own, self.sign()),
                _ if self.has_other_sign() => TipPlace::Unknown(TipDoubt::OtherSign),
                _ => TipPlace::AsProgrammed,
            },
            // The number belongs to no other tool: the offsets have other numbers than the tools, or the tool has
            // several.
            Some(number) if !self.is_of_other_tool(machine, number) => TipPlace::AsProgrammed,
            Some(_) => match own {
                Some(own) if self.has_values => self.deviation(&own, self.sign()),
                _ => TipPlace::Unknown(TipDoubt::OtherTool),
            },
        }
    }

    /// The position of the tip if no length offset is active, or one without a number, whose value is in the program.
    fn without_number(&self, own: Option<PerAxis<f64>>) -> TipPlace {
        let has_own_values = self.axes.iter().any(|axis| self.offset[*axis] != 0.0);
        match own {
            Some(own) if has_own_values => self.deviation(&own, 1.0),
            None if has_own_values => TipPlace::AsProgrammed,
            Some(own) if self.axes.iter().all(|axis| self.work_known.has(*axis)) => {
                self.deviation(&own, 1.0)
            }
            Some(own) if self.deviation(&own, 1.0) == TipPlace::AsProgrammed => {
                TipPlace::AsProgrammed
            }
            _ if self.lengths == ToolLengths::TouchedOff && !self.has_had_length => {
                TipPlace::AsProgrammed
            }
            Some(_) => TipPlace::Unknown(TipDoubt::NoLength),
            None if self.used.len() > 1 || self.has_had_length => {
                TipPlace::Unknown(TipDoubt::NoLength)
            }
            None => TipPlace::Assumed,
        }
    }

    /// The position of the tip from the difference between the active offset and that of the tool.
    fn deviation(&self, own: &PerAxis<f64>, sign: f64) -> TipPlace {
        let mut by = [0.0; 3];
        for axis in self.axes {
            by[*axis] = self.offset[*axis] - sign * own[*axis];
        }
        match by.iter().all(|by| by.abs() < EQUAL_OFFSET_MM) {
            true => TipPlace::AsProgrammed,
            false => TipPlace::Shifted(Vec3::from_array(by)),
        }
    }

    /// -1 if the program subtracts its lengths (G44), which then have the opposite sign; otherwise 1.
    fn sign(&self) -> f64 {
        if self.subtracts == Some(true) { -1.0 } else { 1.0 }
    }

    /// Whether the active length is added and the first one of the program was subtracted, or the reverse.
    fn has_other_sign(&self) -> bool {
        self.number.is_some() && self.subtracts.is_some_and(|first| first != self.is_subtracted)
    }

    /// The measured offsets of a tool, mm; `None` if one of them is not known.
    fn offsets_of(&self, machine: &Machine, number: u32) -> Option<PerAxis<f64>> {
        let tool = machine.tools.get(&number)?;
        let mut offsets = [0.0; AXES];
        for axis in self.axes {
            offsets[*axis] = tool.offset_of(*axis)?;
        }
        Some(offsets)
    }

    /// Whether the offset belongs to another tool: one with a shape, or one that the program has used.
    fn is_of_other_tool(&self, machine: &Machine, number: u32) -> bool {
        let has_shape = |number: &u32| machine.tools.get(number).is_some_and(|t| t.shape.is_some());
        self.used.contains(&number) || has_shape(&number) || {
            let no_shapes = !machine.tools.keys().any(has_shape);
            no_shapes && machine.tools.contains_key(&number)
        }
    }
}
