//! A control as one machine has it.

use chordal_command::{AxisMask, Units};
use chordal_kernel::{Alarms, SettingError};
use chordal_machine::{AxisLimits, Machine};
use chordal_syntax::{Decimal, Word};

use crate::controls::table;
use crate::macros::MacroRules;
use crate::parameters::Parameters;
use crate::scale::LiteralScale;
use crate::settings;
use crate::table::{CodeRow, ControlTable, DwellWord, code_number};

/// A control as one machine has it: its table, and the parameters after the machine file's settings.
#[derive(Clone, Debug)]
pub struct Control {
    /// The table.
    pub table: &'static ControlTable,
    /// The parameters after the machine file's settings.
    pub parameters: Parameters,
    /// The macro rules after the machine file's settings.
    pub macros: MacroRules,
    /// The row of each G code, indexed by the code in tenths.
    g_rows: Vec<Option<&'static CodeRow>>,
    m_rows: Vec<Option<&'static CodeRow>>,
    axes: AxisMask,
}

impl Control {
    /// The control of a machine, and an error for each setting that was refused. `None` if the control is not
    /// programmed in word-address blocks.
    pub fn of(machine: &Machine) -> Option<(Control, Vec<SettingError>)> {
        Some(Control::with_table(table(machine.control)?, machine))
    }

    fn with_table(table: &'static ControlTable, machine: &Machine) -> (Control, Vec<SettingError>) {
        let (parameters, mut errors) =
            settings::resolve(table.settings, &table.parameters, machine);
        errors.extend(redefined_codes(table, machine));
        errors.extend(codes_with_two_times(machine));
        let mut axes = AxisMask::NONE;
        for (index, limits) in machine.axes.iter().enumerate() {
            let present: Option<&AxisLimits> = limits.as_ref();
            if present.is_some() {
                axes.insert(index);
            }
        }
        let mut macros = *table.macros;
        macros.atan_full_circle = parameters.macro_angles_full_circle;
        macros.asin_full_circle = parameters.macro_angles_full_circle;
        let mut control = Control {
            table,
            parameters,
            macros,
            g_rows: rows_of_system(table, parameters.code_system),
            m_rows: by_number(table.m_codes),
            axes,
        };
        control.drop_options();
        (control, errors)
    }

    /// The words that may hold the time of a dwell, in the units that the parameters set.
    pub fn dwell_words(&self) -> impl Iterator<Item = DwellWord> {
        self.table.dwell_words(&self.parameters)
    }

    /// Removes the codes of options that this build of the firmware does not have.
    fn drop_options(&mut self) {
        let of_firmware = self.table.firmware.map_or(&[][..], |firmware| firmware.optional);
        let of_line = self.table.command_line.map_or(&[][..], |line| line.optional);
        for (option, codes) in of_firmware.iter().chain(of_line) {
            if self.parameters.build.has(*option) {
                continue;
            }
            for (letter, code) in *codes {
                let rows = if *letter == b'G' { &mut self.g_rows } else { &mut self.m_rows };
                if let Some(row) = rows.get_mut(usize::from(*code)) {
                    *row = None;
                }
            }
        }
    }

    /// The row of a G code in tenths (20 is G2); `None` if the control does not have it.
    #[inline]
    pub fn g_code(&self, code: u16) -> Option<&'static CodeRow> {
        self.g_rows.get(code as usize).copied().flatten()
    }

    /// Its G codes in ascending order, those of its G code system.
    pub fn g_codes(&self) -> impl DoubleEndedIterator<Item = &'static CodeRow> {
        self.g_rows.iter().copied().flatten()
    }

    /// The row of an M code in tenths (30 is M3); `None` if the control does not have it.
    #[inline]
    pub fn m_code(&self, code: u16) -> Option<&'static CodeRow> {
        self.m_rows.get(code as usize).copied().flatten()
    }

    /// The row of a G or M word; `None` for other words, and for codes that the control does not have.
    pub fn row_of(&self, word: &Word) -> Option<&'static CodeRow> {
        let code = code_number(word.number()?)?;
        match word.letter {
            b'G' => self.g_code(code),
            b'M' => self.m_code(code),
            _ => None,
        }
    }

    /// Numbers of the programs that the machine's settings make macro calls of codes; no text names them.
    pub fn alias_programs(&self) -> Vec<u32> {
        let aliases = &self.parameters.aliases;
        let rules = &self.macros;
        let of = |codes: &[u16], first: u32| -> Vec<u32> {
            (first..).zip(codes).filter(|(_, code)| **code > 0).map(|(number, _)| number).collect()
        };
        let mut programs = of(&aliases.g, rules.g_alias_programs);
        programs.extend(of(&aliases.m, rules.m_alias_programs));
        programs.extend(of(&aliases.m_subprogram, FIRST_ALIAS_SUBPROGRAM));
        programs
    }

    /// The length in mm that a word `1.` has in these units, or `1` if `has_point` is false.
    pub fn length_unit_mm(&self, units: Units, has_point: bool) -> f64 {
        let one = Decimal { mantissa: 1, scale: 0, has_point, negative: false };
        LiteralScale::new(units, &self.parameters).length(one)
    }

    /// The alarms that the control shows.
    pub fn alarms(&self) -> Alarms {
        self.table.profile().alarms()
    }

    /// The axes of the machine.
    pub fn axes(&self) -> AxisMask {
        self.axes
    }
}

/// An error for each M code that the machine file defines although the control has it itself.
fn redefined_codes(
    table: &'static ControlTable,
    machine: &Machine,
) -> impl Iterator<Item = SettingError> {
    machine.shop_codes.keys().filter_map(move |number| {
        let row = table.m_code(number * 10).filter(|row| !row.action.is_left_out())?;
        let (title, meaning) = (table.title, row.title);
        Some(SettingError {
            name: format!("shop_codes.M{number}"),
            message: format!("M{number} is not a custom M code: {title} has it ({meaning})"),
            help: Some("remove it from the machine's `shop_codes`".to_string()),
        })
    })
}

/// An error for each custom code with both a time and blocks: its blocks already take their own time.
fn codes_with_two_times(machine: &Machine) -> impl Iterator<Item = SettingError> {
    let codes = machine.shop_codes.iter().map(|(number, code)| (format!("M{number}"), code));
    let programs = machine.shop_programs.iter().map(|(number, code)| (format!("O{number}"), code));
    let both =
        codes.chain(programs).filter(|(_, code)| code.blocks.is_some() && code.time_s.is_some());
    both.map(|(name, _)| SettingError {
        name: format!("shop_codes.{name}"),
        message: format!("{name} has `time` and `blocks`: its blocks take their own time"),
        help: Some("remove `time`; a time without motion is a G4 among the blocks".to_string()),
    })
}

/// The program of the first M code that calls a subprogram (Fanuc No. 6071).
pub const FIRST_ALIAS_SUBPROGRAM: u32 = 9001;

/// The rows of one G code system of a table, indexed by the code in tenths; system 0 is the table itself.
fn rows_of_system(table: &'static ControlTable, system: u8) -> Vec<Option<&'static CodeRow>> {
    let mut rows = by_number(table.g_codes);
    let index = usize::from(system).checked_sub(1);
    let Some(system) = index.and_then(|index| table.systems.get(index)) else { return rows };
    for code in system.without {
        rows[*code as usize] = None;
    }
    for row in system.codes {
        let code = row.code as usize;
        if rows.len() <= code {
            rows.resize(code + 1, None);
        }
        rows[code] = Some(row);
    }
    rows
}

fn by_number(codes: &'static [CodeRow]) -> Vec<Option<&'static CodeRow>> {
    let size = codes.iter().map(|row| row.code as usize + 1).max().unwrap_or(0);
    let mut rows = vec![None; size];
    for row in codes {
        rows[row.code as usize] = Some(row);
    }
    rows
}
