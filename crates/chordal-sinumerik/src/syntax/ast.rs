//! The blocks of a part program as data. Every part keeps the range of its text.

use std::borrow::Cow;

use chordal_diagnostics::TextRange;

/// A block: one line of a program.
#[derive(Clone, PartialEq, Debug)]
pub struct ProgramBlock {
    /// The line without its end.
    pub range: TextRange,
    /// Its line, from 1.
    pub line: u32,
    /// The skip level of `/` (0) to `/9`; `None` without.
    pub skip_level: Option<u8>,
    /// The block number; `None` without.
    pub number: Option<BlockNumber>,
    /// The label; `None` without.
    pub label: Option<LabelName>,
    /// Its statements in order.
    pub statements: Vec<BlockStatement>,
    /// The comment from its semicolon on; `None` without.
    pub comment: Option<TextRange>,
    /// Comparisons with an operand `a AND b` (or OR, XOR) without parentheses: the control compares last, which is
    /// seldom what was meant. Empty when comparisons are read first.
    pub doubtful_comparisons: Vec<TextRange>,
    /// What cannot be read. The control finds it when it prepares the block, so it is no problem of a block that is
    /// not reached.
    pub faults: Vec<SyntaxFault>,
}

/// `N123` or `:123`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct BlockNumber {
    /// The number.
    pub number: u32,
    /// It is a main block (`:`).
    pub is_main: bool,
    /// Its text.
    pub range: TextRange,
}

/// A label with its colon.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct LabelName {
    /// Its name in upper case.
    pub name: String,
    /// Its text.
    pub range: TextRange,
}

/// A text that cannot be read.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct SyntaxFault {
    /// The text.
    pub range: TextRange,
    /// What is wrong, as a sentence without a full stop.
    pub message: String,
}

/// A statement of a block.
#[derive(Clone, PartialEq, Debug)]
pub struct BlockStatement {
    /// Its text.
    pub range: TextRange,
    /// What it says.
    pub kind: StatementKind,
}

/// What a statement says.
#[derive(Clone, PartialEq, Debug)]
pub enum StatementKind {
    /// An address with a value: `X10`, `CR=5`, `R1=R2+1`, `$TC_DP6[1,1]=5`, `T="MILL"`, `I1=AC(2)`, `NAME=3`.
    Word(AddressWord),
    /// A name without a value: `TRANS`, `SUPA`, `G500` is a [`Word`](StatementKind::Word), `SPOS` is not.
    Name(String),
    /// A name with arguments: `CYCLE81(10,0,2,-5)`, `MSG("TEXT")`, `NAME()`.
    Call(CallStatement),
    /// `MCALL`, with the call that follows it; `None` for the bare word.
    ModalCall(Option<CallStatement>),
    /// `CALL "path"`, `CALL variable`, `CALL BLOCK A TO B`, `PCALL path(…)`, `EXTCALL "file"`.
    IndirectCall(IndirectCall),
    /// `IF condition`, alone in its block: the branch up to `ELSE` or `ENDIF`.
    If(Expression),
    /// `ELSE`.
    Else,
    /// `ENDIF`.
    EndIf,
    /// `FOR variable = from TO to`.
    For {
        /// The variable.
        variable: Address,
        /// The first value.
        from: Expression,
        /// The last value.
        to: Expression,
    },
    /// `ENDFOR`.
    EndFor,
    /// `WHILE condition`.
    While(Expression),
    /// `ENDWHILE`.
    EndWhile,
    /// `REPEAT` without a label: up to `UNTIL`.
    RepeatLoop,
    /// `UNTIL condition`.
    Until(Expression),
    /// `LOOP`.
    Loop,
    /// `ENDLOOP`.
    EndLoop,
    /// `REPEAT LABEL`, `REPEAT LABEL LABEL P=n`, `REPEATB LABEL`.
    RepeatPart(RepeatPart),
    /// A jump, with the condition of an `IF` before it.
    Jump(JumpStatement),
    /// `CASE value OF constant jump … DEFAULT jump`.
    Case {
        /// What is compared.
        selector: Expression,
        /// The constants and their jumps, in order.
        branches: Vec<(Expression, JumpStatement)>,
        /// The jump of `DEFAULT`; `None` without.
        default: Option<JumpStatement>,
    },
    /// `DEF REAL A=1, B[2,3]`.
    Define(VariableDefinition),
    /// `PROC NAME(REAL A, INT B=2, VAR REAL C) SAVE DISPLOF`.
    Procedure(ProcedureHead),
    /// `EXTERN NAME(REAL, INT)`.
    External(String),
    /// `DEFINE NAME AS text`.
    Macro {
        /// The name in upper case.
        name: String,
        /// The text that replaces it.
        text: TextRange,
    },
    /// `WHEN … DO …`, `ID=1 WHENEVER …`, `EVERY …`: a synchronous action, up to the end of the block.
    SynchronousAction,
}

/// An address or a variable: a name, a numeric extension, indices.
#[derive(Clone, PartialEq, Debug)]
pub struct Address {
    /// Its text.
    pub range: TextRange,
    /// The name in upper case, without the extension: `S` of `S2`, `R` of `R10`, `$TC_DP6`, `CR`.
    pub name: Cow<'static, str>,
    /// The number after a letter: 2 of `S2=900` and of `R2`, 1 of `I1=`; `None` without. Names of several letters keep
    /// their digits (`$TC_DP6`, `MY_VAR2`).
    pub extension: Option<u32>,
    /// The indices in brackets.
    pub indices: Vec<Expression>,
}

/// An address with a value.
#[derive(Clone, PartialEq, Debug)]
pub struct AddressWord {
    /// The address or variable.
    pub address: Address,
    /// The value.
    pub value: WordValue,
    /// There is an equals sign between the two.
    pub has_equals: bool,
}

/// The value of an address.
#[derive(Clone, PartialEq, Debug)]
pub enum WordValue {
    /// A value or an expression.
    Plain(Expression),
    /// `AC(value)`, `IC(value)`, `DC(value)`, …
    Function(ValueFunction, Expression),
    /// `SET(1,2,3)` for an array.
    Set(Vec<Expression>),
    /// `REP(7)` for an array.
    Repeated(Expression),
}

/// How the value of an axis word is meant, whatever G90 or G91 says.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ValueFunction {
    /// `AC`: absolute.
    Absolute,
    /// `IC`: incremental.
    Incremental,
    /// `DC`: absolute, a rotary axis on the short way.
    ShortestPath,
    /// `ACP`: absolute, in the positive direction.
    Positive,
    /// `ACN`: absolute, in the negative direction.
    Negative,
    /// `DAC`: absolute, a diameter.
    AbsoluteDiameter,
    /// `DIC`: incremental, a diameter.
    IncrementalDiameter,
    /// `RAC`: absolute, a radius.
    AbsoluteRadius,
    /// `RIC`: incremental, a radius.
    IncrementalRadius,
}

/// A name with arguments.
#[derive(Clone, PartialEq, Debug)]
pub struct CallStatement {
    /// The name in upper case.
    pub name: String,
    /// The text of the name.
    pub range: TextRange,
    /// The arguments; a missing one is `None`: `(1,,3)`. `None` for a name without parentheses.
    pub arguments: Option<Vec<Option<Expression>>>,
}

/// A call whose program is a text or an expression.
#[derive(Clone, PartialEq, Debug)]
pub enum IndirectCall {
    /// `CALL "NAME"` or `CALL variable`, `EXTCALL("file")`.
    Named(Expression),
    /// `CALL BLOCK A TO B`, `CALL "NAME" BLOCK A TO B`.
    Blocks {
        /// The program of the labels; `None` for the running one.
        program: Option<Expression>,
        /// The first label.
        from: String,
        /// The last label.
        to: String,
    },
    /// `PCALL path(…)`.
    Path(CallStatement),
}

/// A repetition of a part of the program.
#[derive(Clone, PartialEq, Debug)]
pub struct RepeatPart {
    /// The label at its start, in upper case.
    pub from: String,
    /// The label at its end; `None` for the block of the statement, or for `ENDLABEL:`.
    pub to: Option<String>,
    /// How often it is repeated (`P=n`); `None` for once.
    pub times: Option<Expression>,
    /// `REPEATB`: only the block of the label.
    pub is_single_block: bool,
}

/// A jump.
#[derive(Clone, PartialEq, Debug)]
pub struct JumpStatement {
    /// Where its target is searched.
    pub direction: JumpDirection,
    /// The target; `None` for `GOTOS`.
    pub target: Option<JumpTarget>,
    /// The condition of the `IF` before it; `None` without.
    pub condition: Option<Expression>,
    /// Its text.
    pub range: TextRange,
}

/// Where the target of a jump is searched.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum JumpDirection {
    /// `GOTOF`: towards the end.
    Forward,
    /// `GOTOB`: towards the start.
    Backward,
    /// `GOTO`: towards the end, then towards the start.
    Both,
    /// `GOTOC`: like `GOTO`; without a target the program goes on.
    BothOrNone,
    /// `GOTOS`: the start of the program.
    ProgramStart,
}

/// The target of a jump.
#[derive(Clone, PartialEq, Debug)]
pub enum JumpTarget {
    /// A label, in upper case.
    Label(String),
    /// A block number, `N` (false) or `:` (true).
    Number(u32, bool),
    /// A text expression.
    Computed(Expression),
}

/// The type of a variable.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum VariableType {
    /// A whole number.
    Integer,
    /// A number.
    Real,
    /// True or false.
    Boolean,
    /// A character.
    Character,
    /// A text of at most this length.
    Text(u32),
    /// An axis.
    Axis,
    /// A frame.
    Frame,
}

/// `DEF`: variables of one type.
#[derive(Clone, PartialEq, Debug)]
pub struct VariableDefinition {
    /// The type.
    pub kind: VariableType,
    /// The variables.
    pub variables: Vec<DefinedVariable>,
}

/// A variable of a definition.
#[derive(Clone, PartialEq, Debug)]
pub struct DefinedVariable {
    /// Its name in upper case.
    pub name: String,
    /// Its text.
    pub range: TextRange,
    /// The sizes of its dimensions; empty for a single value.
    pub sizes: Vec<Expression>,
    /// Its first value; `None` for zero.
    pub initial: Option<WordValue>,
}

/// `PROC`: the head of a program with parameters.
#[derive(Clone, PartialEq, Debug)]
pub struct ProcedureHead {
    /// Its name in upper case.
    pub name: String,
    /// Its parameters in order.
    pub parameters: Vec<ProcedureParameter>,
    /// `SAVE`: G codes and frames are restored at the return.
    pub saves: bool,
}

/// A parameter of a procedure.
#[derive(Clone, PartialEq, Debug)]
pub struct ProcedureParameter {
    /// Its type.
    pub kind: VariableType,
    /// Its name in upper case.
    pub name: String,
    /// `VAR`: the caller's variable is changed.
    pub is_reference: bool,
    /// Its value where the caller gives none; `None` for zero.
    pub default: Option<Expression>,
}

/// An expression.
#[derive(Clone, PartialEq, Debug)]
pub struct Expression {
    /// Its text.
    pub range: TextRange,
    /// What it says.
    pub kind: ExpressionKind,
}

/// What an expression says.
#[derive(Clone, PartialEq, Debug)]
pub enum ExpressionKind {
    /// A whole number: `7`, `'H1F'`, `'B101'`.
    Integer(i64),
    /// A number with a decimal point or an exponent (`1.5`, `1.5EX-3`), with the digits after its point.
    Real(f64),
    /// `TRUE` or `FALSE`.
    Boolean(bool),
    /// A text in quotation marks, without them.
    Text(String),
    /// A variable or a name; names of axes, too (`X`).
    Variable(Address),
    /// A function with its arguments: `SIN(30)`, `AXNAME("X")`.
    Function(String, Vec<Option<Expression>>),
    /// An operator before its operand.
    Unary(UnaryOperator, Box<Expression>),
    /// An operator between its operands.
    Binary(BinaryOperator, Box<Expression>, Box<Expression>),
}

/// An operator before its operand.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum UnaryOperator {
    /// `-`.
    Minus,
    /// `+`.
    Plus,
    /// `NOT`.
    Not,
    /// `B_NOT`.
    BitNot,
    /// `<<` without a left operand: the value as a text.
    Text,
}

/// An operator between its operands, in the order of precedence of Job Planning 07/2010, 1.7: each group binds more
/// loosely than the one before it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[allow(missing_docs, reason = "the names are the operators'")]
pub enum BinaryOperator {
    /// `:` between frames.
    Chain,
    Multiply,
    Divide,
    IntegerDivide,
    Modulo,
    Add,
    Subtract,
    BitAnd,
    BitXor,
    BitOr,
    And,
    Xor,
    Or,
    Join,
    Equal,
    NotEqual,
    Greater,
    Less,
    GreaterOrEqual,
    LessOrEqual,
}
