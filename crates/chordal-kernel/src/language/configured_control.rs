//! A control as the stages after the language know it.

use std::any::Any;
use std::fmt;

use chordal_command::{AxisMask, WorkName, WorkNaming};
use chordal_diagnostics::{Code, SourceMap, TextRange};
use chordal_machine::{Body, Machine, PerAxis, Tool};

use super::program_set::ProgramSet;
use super::program_writer::ProgramWriter;
use super::programs::ProgramName;
use super::run_options::RunOptions;
use crate::kernel::Alarms;
use crate::offsets::Offsets;
use crate::rules::Rules;

/// The facts of a control that do not depend on its language or on the settings of a machine.
#[derive(Clone, Copy, Debug)]
pub struct ControlProfile {
    /// Its name in machine files.
    pub name: &'static str,
    /// Its name for users.
    pub title: &'static str,
    /// Where its facts come from.
    pub source: &'static str,
    /// The built-in machine for programs of which only the control is known.
    pub default_machine: &'static str,
    /// The alarm that it shows for a diagnostic.
    pub alarms: &'static [(Code, &'static str)],
    /// How its work offsets are named.
    pub work_names: WorkNaming,
    /// It is the control of a lathe.
    pub turns: bool,
}

impl ControlProfile {
    /// Its alarms, with its title.
    pub fn alarms(&self) -> Alarms {
        Alarms { title: self.title, texts: self.alarms }
    }
}

/// A tool that a program defines.
#[derive(Clone, PartialEq, Debug)]
pub struct DefinedTool {
    /// Its number.
    pub number: u32,
    /// Its data. The program gives no shape: that of its data is assumed.
    pub tool: Tool,
    /// The block that defines it.
    pub range: TextRange,
}

/// A control of some language, with the settings of one machine applied.
pub trait ConfiguredControl: fmt::Debug + Send + Sync {
    /// The facts that do not depend on the machine.
    fn profile(&self) -> ControlProfile;

    /// Its rules with the settings of the machine.
    fn rules(&self) -> &Rules;

    /// The axes of the machine.
    fn axes(&self) -> AxisMask;

    /// The work coordinate system before the first block.
    fn initial_work_offset(&self) -> WorkName {
        WorkName::G(54)
    }

    /// The offsets before the first block.
    fn initial_offsets(&self, machine: &Machine) -> Offsets {
        Offsets::new(machine, self.initial_work_offset(), self.profile().work_names)
    }

    /// The offset between program and machine coordinates before the first block (mm, rad), and the axes for which
    /// the machine file gives it.
    fn initial_offset(&self, machine: &Machine) -> (PerAxis<f64>, AxisMask) {
        let offsets = self.initial_offsets(machine);
        (offsets.total(), offsets.known())
    }

    /// Opens texts.
    fn open<'a>(
        &'a self,
        sources: &'a SourceMap<'a>,
        machine: &'a Machine,
        options: &'a RunOptions,
    ) -> Box<dyn ProgramSet + 'a>;

    /// The names of the programs that a text contains.
    fn program_names(&self, text: &[u8]) -> Vec<ProgramName>;

    /// The names of the programs that a text calls and that may be in other files of its folder; empty when the
    /// control does not search there.
    fn called_programs(&self, text: &[u8]) -> Vec<ProgramName>;

    /// Whether a text says in which units its lengths are; true of every text where the control leaves no choice.
    fn names_units(&self, text: &[u8]) -> bool;

    /// Whether a text leaves it to a setting of the control what its whole numbers without a decimal point are.
    fn leaves_whole_numbers_open(&self, _text: &[u8]) -> bool {
        false
    }

    /// The extensions, in lower case, of the files in which a called program with a name is searched.
    fn subprogram_extensions(&self) -> &'static [&'static str];

    /// The extensions, in lower case, of files with definitions and tables of the control that are read with every
    /// program of their folder; empty where the control has none.
    fn table_extensions(&self) -> &'static [&'static str] {
        &[]
    }

    /// Whether a text of such a file has definitions or tables of the control.
    fn is_table(&self, _text: &[u8]) -> bool {
        false
    }

    /// Takes tools and work offsets of such a text over into a machine.
    fn take_table(&self, _text: &[u8], _machine: &mut Machine) {}

    /// The stock that a text defines in blocks of its own (BLK FORM), in program coordinates, and these blocks; `None`
    /// without one.
    fn defined_stock(&self, _text: &[u8]) -> Option<(Body, TextRange)> {
        None
    }

    /// The tools that a text defines in blocks of its own (TOOL DEF), with the shape that is assumed of them.
    fn defined_tools(&self, _text: &[u8]) -> Vec<DefinedTool> {
        Vec::new()
    }

    /// Writes programs for this control from what they do; `None` where programs of other languages are not converted
    /// to it.
    fn program_writer(&self) -> Option<Box<dyn ProgramWriter + '_>> {
        None
    }

    /// The control itself, for what works with one language only.
    fn as_any(&self) -> &dyn Any;
}
