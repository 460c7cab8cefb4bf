//! What the new form of a block depends on.

use chordal::control::{Action, Control, OnceCode};

use super::contours::CycleContours;
use super::live::LiveTools;
use super::macros::MacroConverter;
use super::structure::ProgramStructure;
use super::trace::{BlockExecution, ProgramTrace};
use crate::source::{SourceBlocks, WordStyle};

/// Everything that a block's new form depends on.
pub(crate) struct ConvertContext<'a> {
    pub source: &'a SourceBlocks<'a>,
    pub trace: &'a ProgramTrace,
    pub structure: &'a ProgramStructure,
    pub from: &'a Control,
    pub to: &'a Control,
    pub macros: &'a MacroConverter<'a>,
    /// Every rotation of the program means the same on both controls.
    pub keeps_rotations: bool,
    /// Every rounding and chamfer of the program is the same on both.
    pub keeps_corners: bool,
    /// Cycles stay only where their pecks are the same too.
    pub exact_cycles: bool,
    /// Moves of the tip are written as moves of the axes.
    pub writes_axes: bool,
    /// The new machine begins with kinematics that follow the tip, and the new program gives its axes.
    pub switches_to_axes: bool,
    /// The contours that cycles of a lathe cut.
    pub contours: &'a CycleContours,
    /// Live tools of a lathe that are started like the spindle.
    pub live: &'a LiveTools,
    /// What a place of X is multiplied by in a word of the new program.
    pub x_factor: f64,
}

impl<'a> ConvertContext<'a> {
    pub fn style(&self) -> WordStyle {
        self.source.style
    }

    pub fn controls(&self) -> [&'a Control; 2] {
        [self.from, self.to]
    }

    /// True when the program stays on its control.
    pub fn same_control(&self) -> bool {
        std::ptr::eq(self.from.table, self.to.table)
            && self.from.parameters.code_system == self.to.parameters.code_system
    }

    /// True when the program is for a lathe; then both controls are.
    pub fn turns(&self) -> bool {
        self.from.table.turns() && self.to.table.turns()
    }

    /// True when statements of the macro language mean the same on both.
    pub fn keeps_macros(&self) -> bool {
        self.from.table.macros.form == self.to.table.macros.form
    }

    /// What the block's first run did, where it was carried out.
    pub fn run(&self, at: usize) -> Option<&'a BlockExecution> {
        self.trace.first_run(at)
    }

    /// A block that waits: its words of axes are times.
    pub fn waits(&self, at: usize) -> bool {
        let dwell = Action::Once(OnceCode::Dwell);
        self.source.has_action(at, self.from, |action| action == dwell)
    }

    /// A block of a subroutine that only cycles of the old control read.
    pub fn is_contour(&self, at: usize) -> bool {
        self.contours.list.iter().any(|contour| {
            contour.blocks.contains(&at)
                && contour.is_subroutine(self.source)
                && contour.is_cycle_only(self.source, &self.trace.facts)
        })
    }

    pub fn in_cycle(&self, run: &BlockExecution) -> bool {
        self.trace.commands_of(run).iter().any(|command| command.origin.cycle)
    }
}
