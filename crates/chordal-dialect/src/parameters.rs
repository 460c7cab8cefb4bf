//! The parameters of a control that may differ from machine to machine.

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

/// What an R word does in a block with I, J or K.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum CenterAndRadius {
    /// R is used, and I, J and K are ignored.
    RadiusWins,
    /// The control refuses the block.
    Refused,
}

/// What the number after T means.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum ToolWord {
    /// A tool, which a code puts into the spindle.
    Tool,
    /// Station and offset (`T0101`): the last digits are the number of the offset, which acts at once; of a number
    /// with five digits or more these are the last three.
    StationAndOffset {
        /// How many digits the offset has.
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

/// What the last two digits of a fixed pocket subroutine (Fadal L96NN to L99NN) mean.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum FixedRoutineCount {
    /// The number of repeats, as in calls of other subroutines.
    Repeat,
    /// Nothing: it runs once.
    Once,
}

/// The parameters of a control, as its table has them and a machine file may change them.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Parameters {
    /// How axis words without a point are read.
    pub decimal_point: DecimalPoint,
    /// What is done with decimals of a length beyond the least increment.
    pub excess_decimals: ExcessDecimals,
    /// The largest number of digits of a length; 0 for no limit.
    pub most_digits: u8,
    /// How many digits of an inch F without a point are after the point.
    pub feed_digits_inch: u8,
    /// The largest F in inverse time mode (G93), 1/min; infinite where no source gives one.
    pub largest_inverse_time: f64,
    /// Which plane G18 and G19 choose.
    pub plane_codes: PlaneCodes,
    /// G0 cancels the direction that G2 or G3 has set, where these only set a direction.
    pub rapid_cancels_arc: bool,
    /// What R does in a block with I, J or K.
    pub center_and_radius: CenterAndRadius,
    /// H alone makes the length offset active (Fadal Format 1).
    pub length_by_h_alone: bool,
    /// Axis words in the block of G4 move after the dwell (LinuxCNC).
    pub dwell_with_motion: bool,
    /// The axis words in the block of G92.1 are still relative to the offset that it clears (GRBL).
    pub preset_cleared_after_motion: bool,
    /// A program without an end code is refused; a second percent sign is an end, too (LinuxCNC).
    pub end_required: bool,
    /// `G10 P0` writes the active work offset, not the external one.
    pub offset_zero_in_force: bool,
    /// `G10 L2` without P means `P0`.
    pub offset_number_optional: bool,
    /// A program may end with its last block instead of M30 (GRBL).
    pub end_optional: bool,
    /// Who changes tools.
    pub tool_change: ToolChanger,
    /// The program continues after a block that the control refuses, since the sender sends the next one.
    pub goes_on_after_refusal: bool,
    /// The options that the build of its firmware has.
    pub build: FirmwareBuild,
    /// An F of zero or less is ignored (Marlin).
    pub zero_feed_passed_over: bool,
    /// G92 writes the active work coordinate system, and the machine's coordinate system is active at power-on
    /// (Marlin).
    pub preset_writes_system: bool,
    /// The letter next to a spindle code that gives its power in percent of the largest speed (Snapmaker); `None`
    /// where there is none.
    pub power_letter: Option<u8>,
    /// A word that no code uses, and a code without its words, stop the program (LinuxCNC).
    pub strict_words: bool,
    /// Letters that are refused without a code that uses them, although most controls store their values.
    pub words_of_codes: Letters,
    /// The alarm of a motion code together with another code that uses the axis words of its block; with it, G53
    /// excludes arcs (RS274/NGC). `None` where both are allowed.
    pub one_code_takes_axes: Option<&'static str>,
    /// Groups of M codes in tenths: a block may have one code of each.
    pub m_groups: &'static [&'static [u16]],
    /// The alarm of two M codes of one group; `None` if it is not known.
    pub m_groups_alarm: Option<&'static str>,
    /// The largest numbers that its words may have.
    pub largest_numbers: LargestNumbers,
    /// The output that switches the kinematics, on machines whose file says which there are.
    pub kinematics_output: Option<KinematicsOutput>,
    /// The largest number of characters of a line; 0 for any.
    pub longest_line: u32,
    /// Block delete is a slash at the begin of the line; a number after it means nothing.
    pub plain_block_delete: bool,
    /// The largest nesting depth of calls.
    pub nesting: u32,
    /// The largest count of a repeat or a call.
    pub max_repeats: u32,
    /// P has the repeats before the four digits of the program number (`P100013`: 10 × O0013).
    pub packed_calls: bool,
    /// An H that differs from the tool number is an alarm (Haas Setting 15).
    pub length_must_match_tool: bool,
    /// The codes that choose inch and millimetres.
    pub unit_codes: UnitCodes,
    /// How tool offsets are stored, which decides what #2001 to #2400 mean (Fanuc).
    pub offset_memory: OffsetMemory,
    /// M98 takes its count from Q if it has no L (Mach3).
    pub calls_counted_by_q: bool,
    /// In a file that is one program, M98 also finds an `O5` before the call, not only after it (Mach3).
    pub calls_upwards: bool,
    /// Factor on the time of G4; 0.001 where a setting makes seconds milliseconds.
    pub dwell_factor: f64,
    /// `M98 P` looks for programs in the file alone, not in its folder.
    pub calls_within_file: bool,
    /// `M99 P` jumps in the called program instead of the calling one.
    pub return_label_in_callee: bool,
    /// What the last two digits of fixed pocket subroutines mean.
    pub fixed_routine_count: FixedRoutineCount,
    /// The number of the register with the diameter of fixed bore milling.
    pub bore_diameter_register: u8,
    /// ATAN and ASIN of macros give 0 to 360 degrees instead of -180 to 180.
    pub macro_angles_full_circle: bool,
    /// Codes that settings make calls of programs.
    pub aliases: MacroAliases,
    /// Letters that move an axis by an increment, each with the letter of its axis (`U` of `X`).
    pub increments: &'static [(u8, u8)],
    /// X is programmed as a radius at power-on, whatever the machine file says (LinuxCNC G8).
    pub starts_with_radii: bool,
    /// X is programmed as a radius in polar interpolation, even where it is a diameter otherwise.
    pub face_x_radius: bool,
    /// The P of M3 and M4 that selects the second spindle; 0 for none.
    pub second_spindle_p: u32,
    /// Letters of axes that carry a second spindle, unless the machine has an axis of that letter.
    pub second_spindle_axes: &'static [u8],
    /// The first and the last M code that waits for another channel; 0 for none.
    pub wait_codes: [u32; 2],
    /// The P of M3, M4 and M5 that selects the live tool; 0 for none.
    pub live_tool_p: u32,
    /// What the number after T means.
    pub tool_word: ToolWord,
    /// S in the block of the code that presets coordinates limits the spindle speed.
    pub preset_limits_speed: bool,
    /// While G2 or G3 is active, a block without a centre word is a straight line.
    pub arc_without_center_is_line: bool,
    /// Such a line after an arc is common practice and is not reported (lathes).
    pub line_after_arc_is_usual: bool,
    /// The active G code system: 0 that of the table, 1 the first of its other systems.
    pub code_system: u8,
    /// I, K and R of a G1 are a chamfer or a rounding at its end, and `,A` is its angle from Z (lathes).
    pub corner_words_in_g1: bool,
    /// The letter of the lead of threads in one pass.
    pub thread_lead: u8,
    /// The rules of motion, which do not depend on the language.
    pub rules: Rules,
}

/// An output by which a program switches the kinematics: its code with the number of the output in E and that of the
/// kinematics in Q.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct KinematicsOutput {
    /// The M code, in tenths.
    pub m_code: u16,
    /// The number of the output.
    pub number: u32,
}

/// The largest numbers of some words; 0 for no limit.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct LargestNumbers {
    /// N.
    pub block: u32,
    /// O, with the digits of every option of the control.
    pub program: u32,
    /// H and D.
    pub offset: u32,
    /// T.
    pub tool: u32,
}

/// The codes of a spindle in tenths, one group for each spindle: clockwise, counter-clockwise, stop.
pub const SPINDLE_CODES: &[&[u16]] = &[&[30, 40, 50]];

impl LargestNumbers {
    /// No limits.
    pub const ANY: LargestNumbers = LargestNumbers { block: 0, program: 0, offset: 0, tool: 0 };
}

/// Who changes tools.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash)]
pub enum ToolChanger {
    /// The machine, or its operator as the control asks for it.
    Machine,
    /// The sender takes M6 out of the blocks and waits for the tool (GRBL has no M6).
    Sender,
    /// Nobody: M6 is an error.
    Nobody,
}

/// The options that the build of a firmware has.
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
    /// The options of a build of which nothing else is known; those that few firmwares have are off.
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

    /// Whether it has this option.
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

    /// The option, to be changed.
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

/// The numbers of codes that settings make calls of programs, by the index of the program; 0 where there is none.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct MacroAliases {
    /// Whether there are any.
    pub any: bool,
    /// G codes that call a macro.
    pub g: [u16; 10],
    /// M codes that call a macro.
    pub m: [u16; 10],
    /// M codes that call a subprogram.
    pub m_subprogram: [u16; 9],
}

impl Parameters {
    /// Decimals of a length that the control keeps, at most [`u8::MAX`]; [`ExcessDecimals`] says what it does with
    /// the others.
    #[inline]
    pub fn kept_decimals(&self, units: Units) -> u8 {
        match (self.excess_decimals, units) {
            (ExcessDecimals::Exact, _) => u8::MAX,
            (_, Units::Inch) => self.rules.increment_digits_inch,
            (_, Units::Millimetre) => self.rules.increment_digits_mm,
        }
    }

    /// The length that the control uses for a number with a decimal point.
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

    /// What most controls share.
    pub const COMMON: Parameters = Parameters {
        decimal_point: DecimalPoint::LeastIncrement,
        excess_decimals: ExcessDecimals::Unknown,
        most_digits: 0,
        feed_digits_inch: 0,
        largest_inverse_time: f64::INFINITY,
        plane_codes: PlaneCodes::Standard,
        rapid_cancels_arc: false,
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
        kinematics_output: None,
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
        corner_words_in_g1: false,
        thread_lead: b'K',
        rules: Rules::COMMON,
    };
}

/// How a Fanuc stores tool offsets, an option that programs do not show.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum OffsetMemory {
    /// The machine file does not say.
    NotKnown,
    /// Memory A: geometry and wear in one value.
    Whole,
    /// Memory B or C: geometry and wear separate.
    GeometryAndWear,
}
