//! How a control carries out macros, as data.

use chordal_syntax::Letters;

/// The longest macro line that a control reads, where macros are lines ([`MacroForm::Lines`]), characters.
pub const MAX_MACRO_LINE_CHARS: usize = 63;

/// A range of common variables.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct VariableRange {
    /// The first number.
    pub first: u32,
    /// The last number, included.
    pub last: u32,
    /// The number under which the first variable is stored: `first` itself, or, where the range is another name for
    /// variables, the number of the first of these.
    pub stored: u32,
    /// How long the variables keep their values.
    pub retention: VariableRetention,
}

/// How long a common variable keeps its value. Until a program writes it, the value is not known in either case:
/// another program may have run before.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum VariableRetention {
    /// Until the control is switched off, or reset if a parameter says so.
    UntilPowerOff,
    /// While the control is off, too.
    OverPowerOff,
}

/// A range of variables that are empty after power-on.
pub const fn volatile(first: u32, last: u32) -> VariableRange {
    VariableRange { first, last, stored: first, retention: VariableRetention::UntilPowerOff }
}

/// A range of variables that keep their values while the control is off.
pub const fn non_volatile(first: u32, last: u32) -> VariableRange {
    VariableRange { first, last, stored: first, retention: VariableRetention::OverPowerOff }
}

/// A range of other names for the non-volatile variables from `stored` on.
pub const fn alias(first: u32, last: u32, stored: u32) -> VariableRange {
    VariableRange { first, last, stored, retention: VariableRetention::OverPowerOff }
}

/// What a system variable holds.
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
    /// The active tool offset.
    ActiveToolOffset,
    /// The active code of modal group 1, 2, ….
    ModalGroup,
    /// The last value of a letter.
    ModalWord(u8),
    /// The last value by argument number (A is 1, X is 24).
    ModalArgument,
    /// Length of tool 1, 2, …: geometry.
    LengthGeometry,
    /// Length of tool 1, 2, …: wear.
    LengthWear,
    /// Radius (or diameter) of tool 1, 2, …: geometry.
    RadiusGeometry,
    /// Radius (or diameter) of tool 1, 2, …: wear.
    RadiusWear,
    /// The external work offset.
    ExternalOffset,
    /// Work offsets 1 to 6, one after the other.
    WorkOffsets,
    /// Extended work offsets, one after the other.
    ExtendedOffsets,
    /// External offset and work offsets 1 to 6 of one axis.
    WorkOffsetsOfAxis(u8),
    /// An input, given by the machine file.
    Input,
    /// An output or a memory of the control, which holds what was written last: not known before the program writes
    /// it.
    Output,
    /// A switch that changes neither path nor text and that a reset turns off, such as #3003, which suppresses
    /// single block: 0 before the program writes it.
    Suppression,
    /// #3000, which stops with an alarm.
    Alarm,
    /// #3006, which stops with a message.
    Message,
    /// A timer.
    Timer,
    /// The date, YYYYMMDD.
    Date,
    /// The time, HHMMSS.
    Time,
    /// The number of the tool in the spindle.
    Tool,
    /// The programmed spindle speed, rev/min.
    SpindleSpeed,
    /// A parameter or setting of the control, given by the machine file.
    Setting,
    /// A state of the machine that neither program nor machine file determines, such as servo lag, load and tool
    /// life.
    NotSimulated,
    /// A tool offset whose kind depends on the [`OffsetMemory`](crate::OffsetMemory) of the control.
    ToolOffsetByMemory,
    /// A number that never changes.
    Constant(u32),
    /// Position of the first reference point, machine coordinates (LinuxCNC 5161).
    Home,
    /// Position of the second reference point, machine coordinates.
    SecondHome,
    /// The offset of G92.
    Preset,
    /// 1 while G92 or G52 is active, otherwise 0.
    PresetActs,
    /// Where the last probe move stopped; a program may write it, too.
    ProbePosition,
    /// The offsets of the tool in the spindle.
    SpindleTool,
    /// Number of the active work coordinate system: 1 is G54, 7 is G59.1.
    WorkSystem,
    /// Work offsets 1 to 9, twenty numbers for each, in mm.
    WorkTable,
    /// Diameter of the active tool.
    ToolDiameter,
    /// 1 if the last probe move touched something, otherwise 0.
    ProbeResult,
}

/// A range of system variables of one kind.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SystemRow {
    /// The first number.
    pub first: u32,
    /// The last number, included.
    pub last: u32,
    /// What they hold.
    pub variable: SystemVariable,
    /// How far the numbers of two successive work offsets are apart.
    pub step: u32,
}

/// How far the numbers of two successive work offsets are apart on most controls; [`MacroRules::system_at`] counts
/// with it on all.
pub const OFFSET_STEP: u32 = 20;
/// The index of the rotation among the numbers of one work offset.
pub const ROTATION_INDEX: u32 = 9;

/// A range of system variables with the usual distance between work offsets.
pub const fn system(first: u32, last: u32, variable: SystemVariable) -> SystemRow {
    SystemRow { first, last, variable, step: OFFSET_STEP }
}

/// A range of work offsets whose numbers are `step` apart.
pub const fn system_with_stride(
    step: u32,
    first: u32,
    last: u32,
    variable: SystemVariable,
) -> SystemRow {
    SystemRow { first, last, variable, step }
}

/// The value of a variable that was never written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum UnsetValue {
    /// Null, which is not a number.
    Null,
    /// Zero.
    Zero,
}

/// How FIX and FUP round.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum RoundingRule {
    /// FIX toward zero, FUP away from it.
    TowardZero,
    /// FIX down, FUP up.
    Floor,
}

/// How AND, OR and XOR combine values.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LogicRule {
    /// Bit by bit on 32-bit integers; the values of comparisons as truth values.
    Bitwise,
    /// As truth values.
    Logical,
}

/// The modal group that a system variable reports.
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
    /// A group that is not simulated: always this code, the one of power-on.
    Fixed(u16),
}

/// How macro statements are written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum MacroForm {
    /// There are none, or they are not carried out.
    None,
    /// Blocks of macro B: `#1=2`, `IF[…]GOTO5`, `WHILE[…]DO1`.
    Blocks,
    /// Assignments that take effect on the next line, and O words (LinuxCNC).
    OWords,
    /// Lines that begin with `#`, in the manner of BASIC (Fadal).
    Lines,
}

/// What may follow THEN.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ThenClause {
    /// One macro statement.
    Statement,
    /// Anything but GOTO, NC words included.
    Anything,
}

/// How an argument without a decimal point is read.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ArgumentScale {
    /// In least increments of its address.
    LeastIncrement,
    /// In least increments, but as written for the letters of [`MacroRules::whole_arguments`].
    ByLetter,
    /// As written.
    Whole,
}

/// How a control carries out macros.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct MacroRules {
    /// The control has a macro language of the macro B family: G65 and the like call programs with arguments.
    pub macro_b: bool,
    /// How macro statements are written.
    pub form: MacroForm,
    /// Whether O words such as `o100 if` are flow control; otherwise they are errors.
    pub o_flow: bool,
    /// Whether comments may print, stop and show text (`(PRINT, X is #1)`).
    pub comments_act: bool,
    /// Number of the last local variable; each nested macro call has local variables of its own.
    pub locals: u32,
    /// Common variables in ascending order.
    pub common: &'static [VariableRange],
    /// System variables in ascending order.
    pub system: &'static [SystemRow],
    /// The value of a variable that was never written.
    pub unset: UnsetValue,
    /// How far a computed variable number may be from a whole number; 0.5 rounds every number.
    pub index_tolerance: f64,
    /// Values of words are rounded to the least increment of their address.
    pub round_words: bool,
    /// ATAN gives 0 to 360 degrees, not -180 to 180.
    pub atan_full_circle: bool,
    /// ASIN gives 270 to 90 degrees, not -90 to 90.
    pub asin_full_circle: bool,
    /// How FIX and FUP round.
    pub fix: RoundingRule,
    /// MOD is never negative; otherwise it has the sign of the dividend.
    pub modulo_positive: bool,
    /// How AND, OR and XOR combine values.
    pub logic: LogicRule,
    /// The reported position of a skip move includes the tool length.
    pub skip_with_length: bool,
    /// A comparison may be assigned: its value is 1 or 0.
    pub comparison_is_value: bool,
    /// EQ and NE take values as equal whose difference is below this.
    pub equal_tolerance: f64,
    /// What may follow THEN.
    pub then: ThenClause,
    /// NC words and a macro statement may stand in one block.
    pub mixed_blocks: bool,
    /// The largest label of a loop (`DO3`).
    pub last_loop: u32,
    /// The largest nesting depth of loops in one program.
    pub loop_depth: u32,
    /// The largest nesting depth of macro calls.
    pub call_depth: u32,
    /// How an argument without a decimal point is read.
    pub argument_scale: ArgumentScale,
    /// The letters that [`ArgumentScale::ByLetter`] reads as written.
    pub whole_arguments: Letters,
    /// I, J and K may be repeated, up to ten sets (argument specification II).
    pub argument_sets: bool,
    /// What the control adds to n of `#3000=n` for the number of the alarm.
    pub alarm_base: u32,
    /// The largest n of `#3000=n`.
    pub alarm_last: u32,
    /// DPRNT pads the digits before the point with blanks.
    pub output_blanks: bool,
    /// POPEN must come before DPRNT.
    pub output_needs_open: bool,
    /// The groups that [`SystemVariable::ModalGroup`] reports, group 1 first.
    pub modal_groups: &'static [ModalGroup],
    /// Number of the program that is called by the first G code that a setting makes a macro call.
    pub g_alias_programs: u32,
    /// Number of the program that is called by the first M code that a setting makes a macro call.
    pub m_alias_programs: u32,
    /// Such an M code passes the words of its block as arguments.
    pub m_alias_arguments: bool,
}

impl MacroRules {
    /// A control without a macro language of this family.
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

    /// The range of a common variable; `None` if the number is none of a common variable.
    pub fn common_range(&self, number: u32) -> Option<&'static VariableRange> {
        let index = self.common.partition_point(|range| range.last < number);
        self.common.get(index).filter(|range| range.first <= number)
    }

    /// What a system variable holds, and its index in its range, in which work offsets count [`OFFSET_STEP`] apart
    /// whatever the control's own distance. `None` if the control does not have the variable.
    pub fn system_at(&self, number: u32) -> Option<(SystemVariable, u32)> {
        let index = self.system.partition_point(|row| row.last < number);
        let row = self.system.get(index).filter(|row| row.first <= number)?;
        let index = number - row.first;
        let (offset, axis) = (index / row.step, index % row.step);
        let index = if row.step == OFFSET_STEP { index } else { offset * OFFSET_STEP + axis };
        (row.step == OFFSET_STEP || axis < OFFSET_STEP).then_some((row.variable, index))
    }
}
