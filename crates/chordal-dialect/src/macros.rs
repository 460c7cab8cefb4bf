//! The macro rules of a control, as data.

use chordal_syntax::Letters;

/// Longest macro line ([`MacroForm::Lines`]), characters.
pub const MAX_LINE: usize = 63;

/// Numbers of variables.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct VariableRange {
    /// The first number.
    pub first: u32,
    /// The last.
    pub last: u32,
    /// The number under which the first is stored: its own, or that of another range whose
    /// second name this one is.
    pub stored: u32,
    /// How long they hold what was written.
    pub retention: VariableRetention,
}

/// How long a common variable holds what was written. Until a program writes it, its value is not known in
/// either case: another program may have run before.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum VariableRetention {
    /// Until the control is switched off, or reset where a parameter says so.
    UntilPowerOff,
    /// Over power-off.
    OverPowerOff,
}

/// Writes a range of variables that is empty after power-on.
pub const fn common(first: u32, last: u32) -> VariableRange {
    VariableRange { first, last, stored: first, retention: VariableRetention::UntilPowerOff }
}

/// Writes a range of variables that keep their values over power-off.
pub const fn kept(first: u32, last: u32) -> VariableRange {
    VariableRange { first, last, stored: first, retention: VariableRetention::OverPowerOff }
}

/// Writes a range that is another name for the variables from `stored` on, which are kept.
pub const fn alias(first: u32, last: u32, stored: u32) -> VariableRange {
    VariableRange { first, last, stored, retention: VariableRetention::OverPowerOff }
}

/// What a system variable shows.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SystemVariable {
    /// End of the last block, work coordinates without the tool length; one per axis.
    BlockEnd,
    /// Machine coordinates.
    MachinePosition,
    /// Work coordinates, the tool length included.
    WorkPosition,
    /// Where the last skip move stopped, the tool length included.
    SkipPosition,
    /// The tool offset in force.
    ActiveToolOffset,
    /// The code in force of group 1, 2, ….
    ModalGroup,
    /// The last word of a letter.
    ModalWord(u8),
    /// The last word by argument number (A is 1, X is 24).
    ModalArgument,
    /// Geometry of the length of tool 1, 2, ….
    LengthGeometry,
    /// Its wear.
    LengthWear,
    /// Geometry of the radius (or diameter) of tool 1, 2, ….
    RadiusGeometry,
    /// Its wear.
    RadiusWear,
    /// The external work offset.
    ExternalOffset,
    /// Work offsets 1 to 6, twenty numbers for each.
    WorkOffsets,
    /// Extended work offsets, twenty numbers for each.
    ExtendedOffsets,
    /// External offset and work offsets 1 to 6 of one axis.
    WorkOffsetsOfAxis(u8),
    /// Inputs: given by the machine file.
    Input,
    /// Outputs and places of the control that hold what was written last: not known before the program writes them.
    Output,
    /// Switches that change neither path nor text, and that a reset turns off: 0 before the program writes them.
    Suppression,
    /// #3000.
    Alarm,
    /// #3006.
    Message,
    /// A timer.
    Timer,
    /// The date, YYYYMMDD.
    Date,
    /// The time, HHMMSS.
    Time,
    /// The tool in the spindle.
    Tool,
    /// The programmed spindle speed.
    SpindleSpeed,
    /// A parameter or a setting of the control, given by the machine file.
    Setting,
    /// A state of the machine that no program and no machine file says, such as the servo lag, loads and
    /// tool lives.
    NotSimulated,
    /// An old number of a tool offset, which depends on the memory that the control has.
    ToolOffsetByMemory,
    /// A constant.
    Constant(u32),
    /// Place of the first reference point, machine coordinates (LinuxCNC 5161).
    Home,
    /// Place of the second.
    SecondHome,
    /// The shift of G92.
    Preset,
    /// 1 while G92 or G52 acts.
    PresetActs,
    /// Where the last probe move stopped, which a program may write.
    ProbePosition,
    /// The offsets of the tool in the spindle.
    SpindleTool,
    /// Number of the work coordinate system in force: 1 is G54, 7 is G59.1.
    WorkSystem,
    /// Tables of the work offsets 1 to 9, twenty numbers for each, in mm.
    WorkTable,
    /// Diameter of the tool in force.
    ToolDiameter,
    /// 1 where the last probe move found something.
    ProbeResult,
}

/// Some system variables in a row.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SystemRow {
    /// The first number.
    pub first: u32,
    /// The last.
    pub last: u32,
    /// What they show.
    pub what: SystemVariable,
    /// Numbers from one work offset to the next.
    pub step: u32,
}

/// Numbers from one work offset to the next, as rows of system variables are read.
pub const OFFSET_STEP: u32 = 20;
/// The place of its turn among the numbers of a work offset.
pub const TURN_PLACE: u32 = 9;

/// Writes a row of system variables.
pub const fn system(first: u32, last: u32, what: SystemVariable) -> SystemRow {
    SystemRow { first, last, what, step: OFFSET_STEP }
}

/// Writes a row of work offsets with another distance from one to the next.
pub const fn system_with_stride(
    step: u32,
    first: u32,
    last: u32,
    what: SystemVariable,
) -> SystemRow {
    SystemRow { first, last, what, step }
}

/// What a variable holds that was never written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum UnsetValue {
    /// Null.
    Null,
    /// Zero.
    Zero,
}

/// FIX and FUP.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RoundingRule {
    /// FIX toward zero, FUP away from it.
    TowardZero,
    /// FIX down, FUP up.
    Floor,
}

/// AND, OR and XOR.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LogicRule {
    /// Bit by bit on 32-bit integers; on the values of comparisons as truth values.
    Bitwise,
    /// True or false.
    Logical,
}

/// What a variable of a modal code shows.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs, reason = "the names are the field's own")]
pub enum ModalGroup {
    Motion,
    Plane,
    Distance,
    FeedMode,
    Units,
    Compensation,
    Length,
    Cycle,
    ReturnLevel,
    WorkOffset,
    ModalCall,
    /// A group whose other codes are not carried out: always this one.
    Fixed(u16),
}

/// How macro statements are written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MacroForm {
    /// They are not carried out.
    None,
    /// Blocks of macro B: `#1=2`, `IF[…]GOTO5`, `WHILE[…]DO1`.
    Blocks,
    /// Assignments that hold from the next line on, and O words (LinuxCNC).
    OWords,
    /// Lines behind `#` in the manner of BASIC (Fadal).
    Lines,
}

/// What stands behind THEN.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ThenClause {
    /// One macro statement.
    Statement,
    /// Anything but GOTO, NC words too.
    Anything,
}

/// How an argument without a decimal point is read.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ArgumentScale {
    /// In least increments of its address.
    LeastIncrement,
    /// In least increments, but the letters of [`MacroRules::whole_arguments`] whole.
    ByLetter,
    /// As written.
    Whole,
}

/// The macro rules of a control.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct MacroRules {
    /// The control has a macro language of the macro B family: G65 calls.
    pub macro_b: bool,
    /// How macro statements are written.
    pub form: MacroForm,
    /// O words are flow control; elsewhere `o100 if` is an error.
    pub o_flow: bool,
    /// Comments may print, stop and show text (`(PRINT, X is #1)`).
    pub comments_act: bool,
    /// Number of the last local variable; each level of macro calls has its own.
    pub locals: u32,
    /// Common variables in order.
    pub common: &'static [VariableRange],
    /// System variables in order.
    pub system: &'static [SystemRow],
    /// What a variable holds that was never written.
    pub unset: UnsetValue,
    /// Largest distance of the number of a variable from a whole number; 0.5 rounds.
    pub index_tolerance: f64,
    /// Values of words are rounded to the least increment of their address.
    pub round_words: bool,
    /// ATAN gives 0 to 360 degrees, not -180 to 180.
    pub atan_full_circle: bool,
    /// ASIN gives 270 to 90 degrees, not -90 to 90.
    pub asin_full_circle: bool,
    /// FIX and FUP.
    pub fix: RoundingRule,
    /// MOD is never negative; otherwise it has the sign of the dividend.
    pub modulo_positive: bool,
    /// AND, OR and XOR.
    pub logic: LogicRule,
    /// The place of a skip move is told with the tool length in it.
    pub skip_with_length: bool,
    /// A comparison may be assigned: 1 or 0.
    pub comparison_is_value: bool,
    /// EQ and NE take values as equal that are nearer than this.
    pub equal_tolerance: f64,
    /// THEN.
    pub then: ThenClause,
    /// NC words and a macro statement may stand in one block.
    pub mixed_blocks: bool,
    /// Largest number of DO.
    pub last_loop: u32,
    /// Most loops inside each other in one program.
    pub loop_depth: u32,
    /// Most macro calls inside each other.
    pub call_depth: u32,
    /// How an argument without a decimal point is read.
    pub argument_scale: ArgumentScale,
    /// See [`ArgumentScale::ByLetter`].
    pub whole_arguments: Letters,
    /// I, J and K may come in ten sets (type II).
    pub argument_sets: bool,
    /// What is added to n of `#3000=n`.
    pub alarm_base: u32,
    /// Largest n.
    pub alarm_last: u32,
    /// Leading blanks before the integer places of DPRNT.
    pub output_blanks: bool,
    /// DPRNT needs POPEN before.
    pub output_needs_open: bool,
    /// What the variables of [`SystemVariable::ModalGroup`] show, group 1 first.
    pub modal_groups: &'static [ModalGroup],
    /// The program that the first G code calls which a setting makes a call.
    pub g_alias_programs: u32,
    /// The same for M codes.
    pub m_alias_programs: u32,
    /// M codes hand their words on as arguments.
    pub m_alias_arguments: bool,
}

impl MacroRules {
    /// No macro language of this family.
    pub const NONE: MacroRules = MacroRules {
        macro_b: false,
        form: MacroForm::None,
        o_flow: true,
        comments_act: false,
        locals: 0,
        common: &[],
        system: &[],
        unset: UnsetValue::Zero,
        index_tolerance: 0.0001,
        round_words: false,
        atan_full_circle: false,
        asin_full_circle: false,
        fix: RoundingRule::Floor,
        modulo_positive: true,
        logic: LogicRule::Logical,
        skip_with_length: false,
        comparison_is_value: true,
        equal_tolerance: 0.0,
        then: ThenClause::Statement,
        mixed_blocks: true,
        last_loop: 0,
        loop_depth: 0,
        call_depth: 0,
        argument_scale: ArgumentScale::Whole,
        whole_arguments: Letters::NONE,
        argument_sets: false,
        alarm_base: 0,
        alarm_last: 0,
        output_blanks: false,
        output_needs_open: false,
        modal_groups: &[],
        g_alias_programs: 9010,
        m_alias_programs: 9020,
        m_alias_arguments: true,
    };

    /// What Fanuc, Haas and Mitsubishi share.
    pub const MACRO_B: MacroRules = MacroRules {
        macro_b: true,
        form: MacroForm::Blocks,
        locals: 33,
        unset: UnsetValue::Null,
        index_tolerance: 0.5,
        round_words: true,
        atan_full_circle: true,
        asin_full_circle: true,
        fix: RoundingRule::TowardZero,
        modulo_positive: false,
        logic: LogicRule::Bitwise,
        skip_with_length: true,
        comparison_is_value: false,
        mixed_blocks: false,
        last_loop: 3,
        loop_depth: 3,
        call_depth: 4,
        argument_scale: ArgumentScale::LeastIncrement,
        whole_arguments: Letters::of("DEFHMST"),
        argument_sets: true,
        alarm_base: 3000,
        alarm_last: 200,
        output_blanks: true,
        output_needs_open: true,
        ..MacroRules::NONE
    };

    /// The range of a common variable.
    pub fn common_range(&self, number: u32) -> Option<&'static VariableRange> {
        let index = self.common.partition_point(|range| range.last < number);
        self.common.get(index).filter(|range| range.first <= number)
    }

    /// What a system variable shows, and its place in its row, where work offsets are [`OFFSET_STEP`] apart.
    pub fn system_at(&self, number: u32) -> Option<(SystemVariable, u32)> {
        let index = self.system.partition_point(|row| row.last < number);
        let row = self.system.get(index).filter(|row| row.first <= number)?;
        let at = number - row.first;
        let (offset, axis) = (at / row.step, at % row.step);
        let place = if row.step == OFFSET_STEP { at } else { offset * OFFSET_STEP + axis };
        (row.step == OFFSET_STEP || axis < OFFSET_STEP).then_some((row.what, place))
    }
}
