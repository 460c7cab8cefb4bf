//! The numbers and habits of a control that may differ from machine to machine.

use chordal_command::Units;
use chordal_kernel::rules::Rules;
use chordal_syntax::{Decimal, Letters};

use crate::firmware::BuildOption;

/// How a number without a decimal point is read.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum DecimalPoint {
    /// `X10` is ten units, as on a pocket calculator.
    Calculator,
    /// `X10` is ten least increments (0.001 mm, 0.0001 in, 0.001°).
    LeastIncrement,
}

/// Which plane G18 and G19 choose.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum PlaneCodes {
    /// G18 is ZX and G19 is YZ, as every control has it.
    Standard,
    /// G18 is YZ and G19 is ZX, as one textbook prints it.
    Swapped,
}

/// What is done with decimals beyond the least increment (`X1.23456` in inch).
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum ExcessDecimals {
    /// The control computes with all of them.
    Exact,
    /// They are cut off.
    Cut,
    /// They are rounded.
    Rounded,
    /// Not known: Chordal computes with all of them, and says so.
    Unknown,
}

/// What an R word does beside I, J or K.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum CenterAndRadius {
    /// R is followed.
    RadiusWins,
    /// The control refuses the block.
    Refused,
}

/// What the number after T says.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum ToolWord {
    /// A tool, which a code puts into the spindle.
    Tool,
    /// Station and offset: so many digits at the end are the number of the offset, which acts at once
    /// (`T0101`); of a number with five digits or more the last three.
    StationAndOffset {
        /// Digits of the offset.
        digits: u32,
    },
}

/// The codes that choose inch and millimetres.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum UnitCodes {
    /// G20 and G21.
    G20,
    /// G70 and G71.
    G70,
    /// Either pair.
    Both,
}

/// What the last two digits of a fixed pocket routine (Fadal L96NN to L99NN) do.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum FixedRoutineCount {
    /// The routine runs as often, as subroutines do.
    Repeat,
    /// It runs once.
    Once,
}

/// The parameters of a control, as the tables set them and a machine file may change them.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Parameters {
    /// How axis words without a point are read.
    pub decimal_point: DecimalPoint,
    /// Decimals of a length beyond the least increment.
    pub excess_decimals: ExcessDecimals,
    /// Most digits of a length; 0 for no limit.
    pub most_digits: u8,
    /// Digits behind the point that an F without one has, in inch.
    pub feed_digits_inch: u8,
    /// Which plane G18 and G19 choose.
    pub plane_codes: PlaneCodes,
    /// G0 takes back the direction that G2 or G3 armed.
    pub rapid_disarms_arc: bool,
    /// R beside I, J, K.
    pub center_and_radius: CenterAndRadius,
    /// H brings the length offset into force by itself (Fadal Format 1).
    pub length_by_h_alone: bool,
    /// G4 waits, and the axis words of its block move after that (LinuxCNC).
    pub dwell_with_motion: bool,
    /// The axis words in the block of G92.1 still count from the offset that it clears (GRBL).
    pub preset_cleared_after_motion: bool,
    /// A program without an end is refused; a second percent sign is one (LinuxCNC).
    pub end_required: bool,
    /// `G10 P0` writes the work offset in force, not the external one.
    pub offset_zero_in_force: bool,
    /// `G10 L2` without P is `P0`.
    pub offset_number_optional: bool,
    /// Programs end with their last block as well as with M30 (GRBL).
    pub end_optional: bool,
    /// Who changes tools.
    pub tool_change: ToolChanger,
    /// Who sends the blocks goes on after one that the control refuses.
    pub goes_on_after_refusal: bool,
    /// What the build of its firmware has.
    pub build: FirmwareBuild,
    /// An F of zero or below it does nothing (Marlin).
    pub zero_feed_passed_over: bool,
    /// G92 writes the active work coordinate system, and at power-on that of the machine is active (Marlin).
    pub preset_writes_system: bool,
    /// The letter next to the code of the spindle that gives its power in percent of the largest speed (Snapmaker).
    pub power_letter: Option<u8>,
    /// A word that nothing uses and a code without its words stop the program (LinuxCNC).
    pub strict_words: bool,
    /// Letters that no block may have without a code that uses them, of those that most controls store.
    pub words_of_codes: Letters,
    /// A motion code excludes another code that takes the axis words of its block, and G53 excludes an arc (RS274/NGC): what
    /// it shows for the first.
    pub one_code_takes_axes: Option<&'static str>,
    /// M codes of which one block may have one.
    pub m_groups: &'static [&'static [u16]],
    /// What it shows for two of them.
    pub m_groups_alarm: Option<&'static str>,
    /// The largest numbers that its words may have.
    pub largest_numbers: LargestNumbers,
    /// Most characters of a line; 0 for any.
    pub longest_line: u32,
    /// Block delete is a slash at the begin of the line, without a number.
    pub plain_block_delete: bool,
    /// How deep calls may be nested.
    pub nesting: u32,
    /// Largest count of a repeat or a call.
    pub max_repeats: u32,
    /// Repeats and program number share one P (`P100013`: 10 × O0013).
    pub packed_calls: bool,
    /// H differing from the tool number is an alarm (Haas Setting 15).
    pub length_must_match_tool: bool,
    /// The codes that choose inch and millimetres.
    pub unit_codes: UnitCodes,
    /// What the old numbers of tool offsets are (Fanuc #2001 to #2400).
    pub offset_memory: OffsetMemory,
    /// The count of M98 may stand in Q where there is no L (Mach3).
    pub calls_counted_by_q: bool,
    /// Where a file is one program, M98 finds `O5` above the call too, not only below it (Mach3).
    pub calls_upwards: bool,
    /// The time of G4 counts in so many of its units: 0.001 where a setting makes seconds milliseconds.
    pub dwell_factor: f64,
    /// `M98 P` looks only for a program of the file, not in the folder.
    pub calls_within_file: bool,
    /// `M99 P` jumps in the running program instead of the calling one.
    pub return_label_in_callee: bool,
    /// The count of fixed pocket routines.
    pub fixed_routine_count: FixedRoutineCount,
    /// The register word that gives fixed bore milling its diameter.
    pub bore_diameter_register: u8,
    /// ATAN and ASIN of macro programs give 0 to 360 degrees, not -180 to 180.
    pub macro_angles_full_circle: bool,
    /// Codes that call macros.
    pub aliases: MacroAliases,
    /// Letters that move an axis by an increment, and the letter of the axis (`U` of `X`).
    pub increments: &'static [(u8, u8)],
    /// Words of X are radii at power-on, whatever the machine file has (LinuxCNC G8).
    pub starts_with_radii: bool,
    /// Words of X are radii in polar interpolation, where they are diameters otherwise.
    pub face_x_radius: bool,
    /// P of M3 and M4 that names the second spindle; 0 for none.
    pub second_spindle_p: u32,
    /// Letters of axes that carry a second spindle, where the machine has no other axis of that name.
    pub second_spindle_axes: &'static [u8],
    /// The first and the last M code that waits for another path; 0 for none.
    pub wait_codes: [u32; 2],
    /// P of M3, M4 and M5 that names the live tool; 0 for none.
    pub live_tool_p: u32,
    /// What T says.
    pub tool_word: ToolWord,
    /// S in the block of the code that presets coordinates limits the spindle speed.
    pub preset_limits_speed: bool,
    /// A block with G2 or G3 in force, and no word of a centre, is a straight line.
    pub arc_without_center_is_line: bool,
    /// Such a line after an arc is the usual way of writing, and is not reported (lathes).
    pub line_after_arc_is_usual: bool,
    /// Which of the systems of G codes of the table it has: 0 the table itself, 1 the first of the others.
    pub code_system: u8,
    /// I, K and R of a straight cut are a chamfer or a rounding at its end, and `,A` is its angle from Z (lathes).
    pub corners_of_lines: bool,
    /// The letter of the lead of a thread in one pass.
    pub thread_lead: u8,
    /// What the machine does, whatever the language.
    pub rules: Rules,
}

/// The largest numbers of words that count things; 0 for any.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct LargestNumbers {
    /// N of a block.
    pub block: u32,
    /// O of a program, with the digits of every option of the control.
    pub program: u32,
    /// H and D.
    pub offset: u32,
    /// T.
    pub tool: u32,
}

/// The codes of a spindle, ten times the number: it turns one way, or the other, or not at all.
pub const SPINDLE_CODES: &[&[u16]] = &[&[30, 40, 50]];

impl LargestNumbers {
    /// What no manual limits.
    pub const ANY: LargestNumbers = LargestNumbers { block: 0, program: 0, offset: 0, tool: 0 };
}

/// Who changes tools.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum ToolChanger {
    /// The machine, or the control with its operator.
    Machine,
    /// Who sends the blocks takes M6 out of them and waits for the tool (GRBL, which has none itself).
    Sender,
    /// Nobody: M6 is an error.
    Nobody,
}

/// What the build of a firmware has.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs, reason = "named as `BuildOption` is")]
pub struct FirmwareBuild {
    pub mist: bool,
    pub tool_table: bool,
    pub expressions: bool,
    pub parentheses: bool,
    pub lower_case: bool,
    pub motion_modes: bool,
    pub work_systems: bool,
    pub planes: bool,
    pub inch: bool,
    pub turns: bool,
    pub splines: bool,
    pub probe: bool,
    pub coolant: bool,
}

impl FirmwareBuild {
    /// What is there where a table says nothing else: options that few firmwares have are not.
    pub const COMMON: FirmwareBuild = FirmwareBuild {
        mist: false,
        tool_table: false,
        expressions: false,
        parentheses: true,
        lower_case: true,
        motion_modes: true,
        work_systems: true,
        planes: true,
        inch: true,
        turns: true,
        splines: true,
        probe: true,
        coolant: true,
    };

    /// It has this option.
    pub const fn has(self, option: BuildOption) -> bool {
        match option {
            BuildOption::Mist => self.mist,
            BuildOption::ToolTable => self.tool_table,
            BuildOption::Expressions => self.expressions,
            BuildOption::Parentheses => self.parentheses,
            BuildOption::LowerCase => self.lower_case,
            BuildOption::MotionModes => self.motion_modes,
            BuildOption::WorkSystems => self.work_systems,
            BuildOption::Planes => self.planes,
            BuildOption::Inch => self.inch,
            BuildOption::Turns => self.turns,
            BuildOption::Splines => self.splines,
            BuildOption::Probe => self.probe,
            BuildOption::Coolant => self.coolant,
        }
    }

    /// The place of an option, to set it.
    pub const fn option_mut(&mut self, option: BuildOption) -> &mut bool {
        match option {
            BuildOption::Mist => &mut self.mist,
            BuildOption::ToolTable => &mut self.tool_table,
            BuildOption::Expressions => &mut self.expressions,
            BuildOption::Parentheses => &mut self.parentheses,
            BuildOption::LowerCase => &mut self.lower_case,
            BuildOption::MotionModes => &mut self.motion_modes,
            BuildOption::WorkSystems => &mut self.work_systems,
            BuildOption::Planes => &mut self.planes,
            BuildOption::Inch => &mut self.inch,
            BuildOption::Turns => &mut self.turns,
            BuildOption::Splines => &mut self.splines,
            BuildOption::Probe => &mut self.probe,
            BuildOption::Coolant => &mut self.coolant,
        }
    }
}

/// Codes that call macros, by their numbers; 0 where there is none.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct MacroAliases {
    /// There is any.
    pub any: bool,
    /// G codes.
    pub g: [u16; 10],
    /// M codes that call a macro.
    pub m: [u16; 10],
    /// M codes that call a subprogram.
    pub m_subprogram: [u16; 9],
}

impl Parameters {
    /// Decimals of a length that the control keeps; the rest is cut, rounded or not known to be either.
    #[inline]
    pub fn kept_decimals(&self, units: Units) -> u8 {
        match (self.excess_decimals, units) {
            (ExcessDecimals::Exact, _) => u8::MAX,
            (_, Units::Inch) => self.rules.increment_digits_inch,
            (_, Units::Millimetre) => self.rules.increment_digits_mm,
        }
    }

    /// The length that the control makes of a number with a decimal point.
    #[inline]
    pub fn kept(&self, number: Decimal, units: Units) -> Decimal {
        if number.scale <= self.kept_decimals(units) {
            return number;
        }
        match (self.excess_decimals, number.at_decimals(self.kept_decimals(units))) {
            (ExcessDecimals::Cut, Some((cut, _))) => cut,
            (ExcessDecimals::Rounded, Some((_, rounded))) => rounded,
            _ => number,
        }
    }

    /// What most controls share; a table names only what it has otherwise.
    pub const COMMON: Parameters = Parameters {
        decimal_point: DecimalPoint::LeastIncrement,
        excess_decimals: ExcessDecimals::Unknown,
        most_digits: 0,
        feed_digits_inch: 0,
        plane_codes: PlaneCodes::Standard,
        rapid_disarms_arc: false,
        center_and_radius: CenterAndRadius::RadiusWins,
        length_by_h_alone: false,
        dwell_with_motion: false,
        preset_cleared_after_motion: false,
        end_required: false,
        offset_zero_in_force: false,
        offset_number_optional: false,
        end_optional: false,
        tool_change: ToolChanger::Machine,
        goes_on_after_refusal: false,
        build: FirmwareBuild::COMMON,
        zero_feed_passed_over: false,
        preset_writes_system: false,
        power_letter: None,
        strict_words: false,
        words_of_codes: Letters::NONE,
        one_code_takes_axes: None,
        m_groups: &[],
        m_groups_alarm: None,
        largest_numbers: LargestNumbers::ANY,
        longest_line: 0,
        plain_block_delete: false,
        nesting: 4,
        max_repeats: 9999,
        packed_calls: false,
        length_must_match_tool: false,
        unit_codes: UnitCodes::G20,
        offset_memory: OffsetMemory::NotKnown,
        calls_counted_by_q: false,
        calls_upwards: false,
        dwell_factor: 1.0,
        calls_within_file: false,
        return_label_in_callee: false,
        fixed_routine_count: FixedRoutineCount::Repeat,
        bore_diameter_register: 1,
        macro_angles_full_circle: false,
        aliases: MacroAliases { any: false, g: [0; 10], m: [0; 10], m_subprogram: [0; 9] },
        increments: &[],
        starts_with_radii: false,
        face_x_radius: false,
        second_spindle_p: 0,
        second_spindle_axes: &[],
        wait_codes: [0; 2],
        live_tool_p: 0,
        tool_word: ToolWord::Tool,
        preset_limits_speed: false,
        arc_without_center_is_line: false,
        line_after_arc_is_usual: false,
        code_system: 0,
        corners_of_lines: false,
        thread_lead: b'K',
        rules: Rules::COMMON,
    };
}

/// How a Fanuc keeps tool offsets, an option of the control that no program shows.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum OffsetMemory {
    /// Nobody said.
    NotKnown,
    /// A: one value each.
    Whole,
    /// B and C: wear and geometry apart.
    GeometryAndWear,
}
