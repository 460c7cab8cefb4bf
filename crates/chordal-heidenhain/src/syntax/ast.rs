//! The blocks of a conversational program.

use chordal_command::CompensationSide;
use chordal_diagnostics::TextRange;
use chordal_geometry::TurnDirection;

use super::free_words::{FreePointWords, FreeRelationWord};
use super::operands::{OperandWord, ParameterName, WordOperand};
use super::planes::PlaneWords;

/// A block with its statement.
#[derive(Clone, PartialEq, Debug)]
pub struct KlartextBlock {
    /// Its text from its first character to its last.
    pub range: TextRange,
    /// Its first line, from 1.
    pub line: u32,
    /// Its number; `None` without one.
    pub number: Option<u32>,
    /// It is skipped while the switch for that is on.
    pub is_skippable: bool,
    /// What it does.
    pub statement: KlartextStatement,
    /// What cannot be read in it.
    pub faults: Vec<KlartextFault>,
}

/// Why a part of a block cannot be read.
#[derive(Clone, PartialEq, Debug)]
pub struct KlartextFault {
    /// The part.
    pub range: TextRange,
    /// What is wrong.
    pub message: String,
    /// Its kind.
    pub kind: KlartextFaultKind,
}

/// The kinds of faults of the text.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum KlartextFaultKind {
    /// A part that the language does not have.
    Unreadable,
    /// A word that the language does not have, and after which no other word is read.
    UnknownFunction,
    /// An axis, or another word, twice.
    DoubleWord,
    /// A word without its value.
    MissingValue,
    /// A number without its word.
    MissingAddress,
    /// A letter that stands for a digit.
    LetterForDigit,
    /// A bracket that is not closed or not opened.
    Bracket,
    /// An old or wrong spelling that is understood.
    Spelling,
}

/// The names of axes in the order of their words: X Y Z A B C U V W.
pub const AXIS_WORDS: [&str; 9] = ["X", "Y", "Z", "A", "B", "C", "U", "V", "W"];

/// A feed.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum FeedValue {
    /// F with a value.
    Value(WordOperand),
    /// FMAX: rapid, in this block.
    Rapid,
    /// F AUTO: that of TOOL CALL.
    OfTool,
    /// FU: per revolution.
    PerRevolution(WordOperand),
    /// FZ: per tooth.
    PerTooth(WordOperand),
    /// FT, FMAXT: the time of the block, s.
    Time,
}

/// A feed and its text.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FeedWord {
    /// The feed.
    pub value: FeedValue,
    /// Its text.
    pub range: TextRange,
}

/// An M function with the values that belong to it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct MachineFunction {
    /// Its number.
    pub number: u32,
    /// The value after it: `MB` of M140, `F` of M103; `None` without one.
    pub value: Option<WordOperand>,
    /// `MB MAX` of M140.
    pub is_max: bool,
    /// Its text.
    pub range: TextRange,
}

/// The words of a block that moves.
#[derive(Clone, Default, PartialEq, Debug)]
pub struct PathWords {
    /// X Y Z A B C U V W.
    pub axes: [Option<OperandWord>; 9],
    /// PR: the polar radius.
    pub polar_radius: Option<OperandWord>,
    /// PA: the polar angle, degrees.
    pub polar_angle: Option<OperandWord>,
    /// TX TY TZ of LN: the direction of the tool.
    pub tool_vector: [Option<OperandWord>; 3],
    /// R of CR, RND and of the arcs of APPR and DEP.
    pub radius: Option<OperandWord>,
    /// LEN of APPR and DEP.
    pub length: Option<OperandWord>,
    /// CCA of APPR and DEP, degrees.
    pub center_angle: Option<OperandWord>,
    /// DR.
    pub direction: Option<(TurnDirection, TextRange)>,
    /// R0, RL and RR.
    pub side: Option<(CompensationSide, TextRange)>,
    /// F.
    pub feed: Option<FeedWord>,
    /// The M functions in order.
    pub functions: Vec<MachineFunction>,
}

impl PathWords {
    /// Whether a coordinate, cartesian or polar, is programmed.
    pub fn has_coordinates(&self) -> bool {
        self.axes.iter().chain([&self.polar_radius, &self.polar_angle]).any(Option::is_some)
    }
}

/// The words of a block of a DIN/ISO program.
#[derive(Clone, Default, PartialEq, Debug)]
pub struct IsoWords {
    /// The G codes in order.
    pub codes: Vec<(u32, TextRange)>,
    /// X Y Z A B C U V W.
    pub axes: [Option<OperandWord>; 9],
    /// The axes that stand in the block, with or without a value.
    pub named: [bool; 9],
    /// I, J and K: the centre, or the pole.
    pub center: [Option<OperandWord>; 3],
    /// R.
    pub radius: Option<OperandWord>,
    /// H: the polar angle, or that of a rotation, degrees.
    pub angle: Option<OperandWord>,
    /// F.
    pub feed: Option<OperandWord>,
    /// S.
    pub speed: Option<OperandWord>,
    /// T.
    pub tool: Option<OperandWord>,
    /// L.
    pub length: Option<OperandWord>,
    /// The M functions in order.
    pub functions: Vec<MachineFunction>,
}

/// The path functions.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PathFunction {
    /// L.
    Line,
    /// LP.
    PolarLine,
    /// C.
    CenterArc,
    /// CP.
    PolarArc,
    /// CR.
    RadiusArc,
    /// CT.
    TangentArc,
    /// CTP.
    PolarTangentArc,
    /// Axis words alone: the last path function goes on.
    Repeated,
}

/// The forms of APPR and DEP.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum KlartextApproachForm {
    /// LT: a straight line along the contour.
    Tangent,
    /// LN: a straight line perpendicular to it.
    Normal,
    /// CT: an arc that is tangent to it.
    Arc,
    /// LCT: a straight line, and an arc tangent to both.
    LineAndArc,
}

/// A name of a label.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum KlartextLabel {
    /// A number, 1 to 65535; 0 ends a subprogram.
    Number(u32),
    /// A text in quotes.
    Text(String),
    /// The value of a parameter.
    Parameter(ParameterName),
}

/// The comparisons of FN 9 to FN 12.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum JumpComparison {
    /// EQU.
    Equal,
    /// NE.
    NotEqual,
    /// GT.
    Greater,
    /// LT.
    Less,
}

/// A condition of a jump.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum JumpCondition {
    /// Two values are compared.
    Compared(WordOperand, JumpComparison, WordOperand),
    /// IS DEFINED, or with false IS UNDEFINED.
    Defined(ParameterName, bool),
}

/// A step of a formula in the order of its evaluation: values are pushed, functions and operators take them.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum FormulaStep {
    /// A number.
    Number(f64),
    /// A parameter.
    Parameter(ParameterName),
    /// A function of the last value.
    Function(FormulaFunction),
    /// An operator between the last two values.
    Operator(FormulaOperator),
}

/// The functions of formulas.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FormulaFunction {
    /// SIN.
    Sine,
    /// COS.
    Cosine,
    /// TAN.
    Tangent,
    /// ASIN.
    ArcSine,
    /// ACOS.
    ArcCosine,
    /// ATAN.
    ArcTangent,
    /// SQ.
    Square,
    /// SQRT.
    SquareRoot,
    /// LN.
    NaturalLogarithm,
    /// LOG.
    DecimalLogarithm,
    /// EXP.
    Exponential,
    /// ABS.
    Absolute,
    /// INT.
    Integer,
    /// FRAC.
    Fraction,
    /// NEG, and a sign before a bracket.
    Negative,
    /// SGN.
    SignOf,
}

/// The operators of formulas and of FN.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FormulaOperator {
    /// +
    Add,
    /// −
    Subtract,
    /// *
    Multiply,
    /// / and DIV.
    Divide,
    /// %: the remainder of a division.
    Remainder,
    /// ^
    Power,
    /// LEN of FN 8: the root of the sum of the squares.
    Length,
    /// ANG of FN 13: the angle of the two sides, 0 to 360 degrees.
    Angle,
}

/// A formula: its steps with their texts.
#[derive(Clone, Default, PartialEq, Debug)]
pub struct KlartextFormula {
    /// Its steps.
    pub steps: Vec<(FormulaStep, TextRange)>,
    /// Its text.
    pub range: TextRange,
}

/// A part of a text: QS parameters and texts, one after the other.
#[derive(Clone, PartialEq, Debug)]
pub enum TextPart {
    /// A text.
    Literal(String),
    /// A QS parameter.
    Parameter(u32),
}

/// A value of the data of a cycle.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum CycleValue {
    /// A number or a parameter.
    Operand(WordOperand),
    /// MAX: rapid.
    Max,
    /// AUTO: the feed of TOOL CALL.
    OfTool,
    /// Anything else, which is not read (PREDEF).
    Other,
}

/// A word of the data of an old cycle, such as `DEPTH -24.62` or `IX+5`.
#[derive(Clone, PartialEq, Debug)]
pub struct CycleWord {
    /// Its letters in upper case; `#` for the line of a datum table.
    pub label: String,
    /// Its value; `None` without one.
    pub value: Option<WordOperand>,
    /// The sign of DR.
    pub direction: Option<TurnDirection>,
    /// Its text.
    pub range: TextRange,
}

/// How a cycle is called.
#[derive(Clone, PartialEq, Debug)]
pub enum CycleCallForm {
    /// CYCL CALL: here.
    Here,
    /// CYCL CALL POS.
    AtPosition,
    /// CYCL CALL PAT.
    AtPattern,
}

/// A group of words in brackets of PATTERN DEF.
#[derive(Clone, PartialEq, Debug)]
pub struct PatternGroup {
    /// POS, ROW, PAT, FRAME, CIRC, PITCHCIRC.
    pub name: String,
    /// Its words: name and value.
    pub words: Vec<(String, WordOperand)>,
    /// Its text.
    pub range: TextRange,
}

/// The words of an element of a free contour (FL, FLT, FC, FCT).
#[derive(Clone, Default, PartialEq, Debug)]
pub struct FreeElementWords {
    /// It is an arc.
    pub is_arc: bool,
    /// It goes on in the direction of the element before.
    pub is_tangent: bool,
    /// AN: the angle of a line, or with which an arc begins, degrees.
    pub angle: Option<OperandWord>,
    /// CCX, CCY and CCZ: the centre of an arc.
    pub center: [Option<OperandWord>; 3],
    /// CCPR and CCPA: the centre from the pole, the angle in degrees.
    pub center_polar: [Option<OperandWord>; 2],
    /// CLSD+ begins a closed contour (false), CLSD- closes it (true).
    pub closing: Option<bool>,
    /// P1X to P3Y: points on the element.
    pub auxiliary: [FreePointWords; 3],
    /// PDX and PDY: a point next to the element.
    pub distance_point: FreePointWords,
    /// D: its distance from the element.
    pub distance: Option<OperandWord>,
    /// DP: the distance of parallel lines.
    pub parallel_distance: Option<OperandWord>,
    /// The words that refer to other blocks, in their order.
    pub relations: Vec<FreeRelationWord>,
    /// The other words.
    pub words: PathWords,
}

/// Functions of the language that are read and not carried out.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum UnfollowedFunction {
    /// FUNCTION, but for TCPM.
    Function,
    /// TCH PROBE.
    Probe,
    /// SEL PATTERN, SEL CONTOUR and their like.
    Selection,
}

/// What a block does.
#[derive(Clone, PartialEq, Debug)]
pub enum KlartextStatement {
    /// Nothing: a comment, a heading, an empty line.
    Nothing,
    /// BEGIN PGM.
    Begin {
        /// The name.
        name: TextRange,
        /// INCH.
        is_inch: bool,
    },
    /// END PGM.
    End {
        /// The name.
        name: TextRange,
        /// INCH.
        is_inch: bool,
    },
    /// BLK FORM.
    Blank {
        /// 1 for 0.1, 2 for 0.2; `None` for other forms.
        corner: Option<u8>,
        /// Its points.
        words: Box<PathWords>,
    },
    /// A path function.
    Path(PathFunction, Box<PathWords>),
    /// FPOL: the pole of free contours.
    FreePole(Box<PathWords>),
    /// FL, FLT, FC, FCT.
    FreeElement(Box<FreeElementWords>),
    /// FSELECT: the number of the solution of the free contour up to here.
    FreeSelection(OperandWord),
    /// CC.
    Center(Box<PathWords>),
    /// RND.
    Rounding(Box<PathWords>),
    /// CHF, with its length.
    Chamfer(Option<OperandWord>, Box<PathWords>),
    /// APPR.
    Approach(KlartextApproachForm, Box<PathWords>),
    /// DEP.
    Departure(KlartextApproachForm, Box<PathWords>),
    /// M functions alone.
    Functions(Box<PathWords>),
    /// STOP.
    Stop(Box<PathWords>),
    /// TOOL CALL.
    ToolCall(Box<ToolCallWords>),
    /// TOOL DEF.
    ToolDefinition {
        /// The number.
        number: WordOperand,
        /// L.
        length: Option<WordOperand>,
        /// R.
        radius: Option<WordOperand>,
    },
    /// LBL.
    Label(KlartextLabel),
    /// CALL LBL.
    CallLabel {
        /// The label.
        label: KlartextLabel,
        /// REP.
        repeats: Option<WordOperand>,
    },
    /// CALL PGM.
    CallProgram(TextRange),
    /// FN 9 to FN 12.
    Jump {
        /// When it jumps.
        condition: JumpCondition,
        /// To where.
        label: KlartextLabel,
    },
    /// A parameter gets a value.
    Assign {
        /// The parameter.
        target: ParameterName,
        /// The value.
        formula: KlartextFormula,
    },
    /// A text parameter gets a text; `None` where it is not read.
    AssignText {
        /// The parameter.
        target: u32,
        /// The text.
        parts: Option<Vec<TextPart>>,
    },
    /// FN 14.
    RaiseError(WordOperand),
    /// FN 18.
    SystemRead {
        /// The parameter.
        target: ParameterName,
        /// ID, NR and IDX.
        numbers: [Option<WordOperand>; 3],
    },
    /// Another FN, which moves nothing.
    OtherFunction {
        /// Its number.
        number: u32,
        /// The parameter that it writes.
        target: Option<ParameterName>,
    },
    /// CYCL DEF of a cycle with parameters.
    CycleParameters {
        /// The cycle.
        number: u32,
        /// The parameters: number, value, text.
        values: Vec<(u32, CycleValue, TextRange)>,
    },
    /// CYCL DEF n.m.
    CycleLine {
        /// The cycle.
        number: u32,
        /// The line of its data.
        line: u32,
        /// Their words.
        words: Vec<CycleWord>,
        /// The text after the number, for names of programs.
        rest: TextRange,
    },
    /// CYCL CALL.
    CycleCall(CycleCallForm, Box<PathWords>),
    /// PATTERN DEF.
    Pattern(Vec<PatternGroup>),
    /// TRANS DATUM AXIS.
    DatumShift(Box<PathWords>),
    /// TRANS DATUM TABLE.
    DatumOfTable {
        /// TABLINE.
        line: WordOperand,
        /// The name of the table.
        table: Option<TextRange>,
    },
    /// SEL TABLE: the name of a datum table.
    SelectDatumTable(TextRange),
    /// TRANS DATUM RESET.
    DatumReset,
    /// PLANE.
    Plane(Box<PlaneWords>),
    /// FUNCTION TCPM, or with false FUNCTION RESET TCPM.
    ToolCenterPoint(bool),
    /// A block of a DIN/ISO program that has no other form.
    Iso(Box<IsoWords>),
    /// What is read and not carried out.
    NotFollowed(UnfollowedFunction),
    /// What cannot be read.
    Unknown,
}

/// The words of TOOL CALL.
#[derive(Clone, Default, PartialEq, Debug)]
pub struct ToolCallWords {
    /// The tool; `None` where only speed, feed or axis change.
    pub tool: Option<(ToolName, TextRange)>,
    /// The tool axis: 0 for X, 1 for Y, 2 for Z.
    pub axis: Option<usize>,
    /// S.
    pub speed: Option<WordOperand>,
    /// F.
    pub feed: Option<FeedWord>,
    /// DL, DR and DR2.
    pub allowances: [Option<WordOperand>; 3],
    /// The M functions.
    pub functions: Vec<MachineFunction>,
}

/// The tool of TOOL CALL.
#[derive(Clone, PartialEq, Debug)]
pub enum ToolName {
    /// By its number.
    Number(WordOperand),
    /// By its name.
    Text(String),
    /// By the name in a QS parameter.
    Parameter(u32),
}
