//! Signs by which a text is recognized, as data: what to look for, how much it says, and its words for people.
//!
//! The signs of a control stand in its folder (`recognition.rs`), those of languages that are not read in
//! [`not_read`](crate::not_read). What looks for them is `chordal-gcode`'s `recognize`.

/// Something in the text that speaks for a control, or against it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum RecognitionSign {
    /// A block of these words, with blanks between them, in any order:
    ///
    /// | term | the block has |
    /// |---|---|
    /// | `X` | a word X |
    /// | `G54.1` | this code |
    /// | `G70..73` | a code of these |
    /// | `U\|W` | one of them |
    /// | `!G43` | none |
    /// | `F<1`, `T>99` | such a number |
    /// | `E:int`, `E:dec` | a number without a point, with digits after it |
    /// | `O:5`, `T:3-6` | a number of so many digits |
    /// | `G28:bare` | this code and no axis word |
    Block(&'static str),
    /// Of the blocks like `among` so many in a hundred are like `of`, the ends included. It says nothing
    /// where there are fewer than three of them.
    Share {
        /// The blocks that are counted.
        of: &'static str,
        /// All blocks.
        among: &'static str,
        /// From and to, in a hundred.
        percent: (u8, u8),
    },
    /// Each of the letters stands in at least so many blocks of the text, and none of the others in any.
    Letters {
        /// The letters that words have.
        used: &'static str,
        /// The letters that no word has.
        unused: &'static str,
        /// In so many blocks at least.
        least: u32,
    },
    /// A comment that names one of these, as words of their own, in capital letters.
    Comment(&'static [&'static str]),
    /// The same where the comment says that it is about the machine, its control or the post.
    Header(&'static [&'static str]),
    /// One of these pieces of text outside comments, in capital letters.
    Code(&'static [&'static str]),
    /// A line with exactly one of these codes, without its N number, blanks and comments, in capital letters.
    Codes(&'static [&'static str]),
    /// A line that begins with one of these pieces of text, in capital letters; blanks before it do not
    /// count, comments do. `?` stands for a digit: `%?????`.
    Begins(&'static [&'static str]),
    /// The same of a line that holds nothing else.
    Line(&'static [&'static str]),
    /// A form that is no pattern of words.
    Form(TextForm),
}

/// Forms that are no pattern of words.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TextForm {
    /// `R0+1.`: a register word.
    Register,
    /// More comments are left open than are closed.
    OpenComments,
    /// A comment with words after a semicolon.
    SemicolonComments,
    /// `o100 sub`, `o<name> call`.
    OWord,
    /// `#<name>`: a named parameter.
    NamedParameter,
    /// A line that begins with `#` and a letter.
    HashLine,
    /// `L100` alone in its block.
    SubroutineHead,
    /// A statement with numbered variables: `#100=1`, `IF[#1EQ2]GOTO9`.
    MacroStatement,
    /// A line that begins with `$`.
    DollarLine,
    /// `R1=5`: a parameter that is given a value.
    ParameterIsSet,
    /// A text without `%`, O number, tool change, G43 and H, as small controls take it.
    BareText,
    /// A block with `X=5`: an address with an equals sign.
    EqualsAddress,
    /// An axis letter has whole numbers without a point in some words, and decimals in others. Controls with least
    /// increments read such whole numbers as thousandths, so that programs for them do not mix the two.
    MixedNumbers,
    /// Whole numbers are written with a point behind them: `X5.`.
    TrailingPoints,
    /// A text with moves in feed and without O number, H, cycle, cutter compensation, call and variable: all that
    /// the controls of small routers read.
    SmallControl,
    /// G43 with H in a text without `%` and O number.
    LengthWithoutTape,
    /// `L0=1`, `G79 L0<5 N10`: a numbered L that is given a value or compared.
    LParameter,
    /// `H175 = 0.1600`: a numbered H that is given a value.
    HParameter,
    /// `(P1=2)`, `(IF P1 EQ 2 GOTO N10)`: a statement in parentheses.
    StatementInParentheses,
    /// `Z100,200,-50;`: a letter and whole coordinates with commas between.
    CommaCoordinates,
}

/// A sign and how strongly it speaks.
#[derive(Clone, Copy, Debug)]
pub struct RecognitionEvidence {
    /// What to look for.
    pub sign: RecognitionSign,
    /// How much it says; below zero it speaks against.
    pub weight: i32,
    /// For people: `G154 chooses an extended work offset`. Of several signs with the same words one counts.
    pub reason: &'static str,
    /// The built-in machine of the control that such programs are for, where it is not the usual one.
    pub machine: Option<&'static str>,
}

impl RecognitionEvidence {
    /// The same for programs of this built-in machine.
    pub const fn on(mut self, machine: &'static str) -> RecognitionEvidence {
        self.machine = Some(machine);
        self
    }
}

/// A kind of machine, and how its programs are distinguished from those of others.
#[derive(Debug)]
pub struct MachineKind {
    /// It is a lathe.
    pub turns: bool,
    /// The signs that a program is for this kind at all.
    pub signs: &'static [RecognitionEvidence],
    /// So much they must weigh together.
    pub needed: i32,
}

/// Writes a sign.
pub const fn evidence(
    sign: RecognitionSign,
    weight: i32,
    reason: &'static str,
) -> RecognitionEvidence {
    RecognitionEvidence { sign, weight, reason, machine: None }
}

/// A comment with one of these words is about the machine that the program is for.
pub const ABOUT_THE_MACHINE: &[&str] =
    &["MACHINE", "VENDOR", "CONTROL", "CONTROLLER", "POST", "POSTED", "MODEL", "MAKE", "CNC"];

/// A comment with one of these words names a machine that the program is not for.
pub const ABOUT_ANOTHER: &[&str] =
    &["FROM", "NOT", "WAS", "OLD", "FORMERLY", "ORIGINALLY", "REPLACES", "NEVER", "INSTEAD"];

/// So much speaks clearly.
pub const CLEAR: i32 = 3;

/// The weight by which the first must lead for the signs to decide.
pub const LEAD: i32 = 2;

/// The control that is assumed where nothing speaks: most others read as it does.
pub const ASSUMED: chordal_machine::ControlName = chordal_machine::ControlName::Fanuc;
