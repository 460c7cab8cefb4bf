//! Signs by which the control of a text is recognized, as data: what to look for, its weight, and its text for
//! users.
//!
//! The signs of a control are in its folder (`recognition.rs`), those of languages that are not read in
//! [`not_read`](crate::not_read). `chordal-gcode`'s `recognize` looks for them.

/// Something in a text that speaks for a control, or against it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum RecognitionSign {
    /// A block that has all of these terms, which are separated by blanks, in any order:
    ///
    /// | term | the block has |
    /// |---|---|
    /// | `X` | a word X |
    /// | `G54.1` | this code |
    /// | `G70..73` | a code from G70 to G73 |
    /// | `U\|W` | one of the two |
    /// | `!G43` | no G43 |
    /// | `F<1`, `T>99` | a number in this range |
    /// | `E:int`, `E:dec` | a number without a point; with digits after the point |
    /// | `O:5`, `T:3-6` | a number with so many digits |
    /// | `G28:bare` | this code and no axis word |
    Block(&'static str),
    /// The percentage of blocks matching `of` among those matching `among` is within `percent`, limits included.
    /// Nothing is concluded from fewer than three blocks of `among`.
    Share {
        /// The blocks that are counted.
        of: &'static str,
        /// The blocks that they are a part of.
        among: &'static str,
        /// From and to, percent.
        percent: (u8, u8),
    },
    /// Each of the letters `used` is in at least `least` blocks of the text, and none of the letters `unused` in
    /// any.
    Letters {
        /// Letters that must occur.
        used: &'static str,
        /// Letters that must not occur.
        unused: &'static str,
        /// The smallest number of blocks for each letter.
        least: u32,
    },
    /// A comment with one of these as separate words; written in capitals here.
    Comment(&'static [&'static str]),
    /// The same in a comment with one of the words [`MACHINE_WORDS`] and none of [`OTHER_MACHINE_WORDS`].
    Header(&'static [&'static str]),
    /// One of these texts outside comments; written in capitals here.
    Code(&'static [&'static str]),
    /// A line that is exactly one of these, apart from N number, blanks and comments; written in capitals here.
    Codes(&'static [&'static str]),
    /// A line that begins with one of these, after blanks if there are any, but not after a comment; written in
    /// capitals here. `?` stands for a digit: `%?????`.
    Begins(&'static [&'static str]),
    /// A line that, apart from blanks, is one of these.
    Line(&'static [&'static str]),
    /// A form that no pattern of words describes.
    Form(TextForm),
}

/// Forms of text that no pattern of words describes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TextForm {
    /// `R0+1.`: a register word.
    Register,
    /// More comments are opened than closed.
    OpenComments,
    /// A semicolon and a comment with words after it.
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
    /// `R1=5`: an assignment to a parameter.
    ParameterIsSet,
    /// A text without `%`, O number, tool change, G43 and H, as programs for small controls are.
    BareText,
    /// A block with `X=5`: an address with an equals sign.
    EqualsAddress,
    /// An axis letter has whole numbers without a point in some words, and decimals in others. Controls that count
    /// in least increments read whole numbers as thousandths, so that programs for them do not mix the two.
    MixedNumbers,
    /// Whole numbers have a trailing point: `X5.`.
    TrailingPoints,
    /// A text with moves in feed and without O number, H, cycle, cutter compensation, call and variable, so that
    /// the controls of small routers can read all of it.
    SmallControl,
    /// G43 with H in a text without `%` and O number.
    LengthWithoutTape,
    /// `L0=1`, `G79 L0<5 N10`: a numbered L that is assigned or compared.
    LParameter,
    /// `H175 = 0.1600`: an assignment to a numbered H.
    HParameter,
    /// `(P1=2)`, `(IF P1 EQ 2 GOTO N10)`: a statement in parentheses.
    StatementInParentheses,
    /// `Z100,200,-50;`: a letter and integer coordinates separated by commas.
    CommaCoordinates,
}

/// A sign and its weight.
#[derive(Clone, Copy, Debug)]
pub struct RecognitionEvidence {
    /// What to look for.
    pub sign: RecognitionSign,
    /// The weight; a negative one speaks against the control.
    pub weight: i32,
    /// For users: `G154 chooses an extended work offset`. Of several signs with the same reason one counts.
    pub reason: &'static str,
    /// The built-in machine that such programs are for; `None` for the control's default machine.
    pub machine: Option<&'static str>,
}

impl RecognitionEvidence {
    /// The same sign for programs of one built-in machine.
    pub const fn on(mut self, machine: &'static str) -> RecognitionEvidence {
        self.machine = Some(machine);
        self
    }
}

/// A kind of machine, and how its programs are distinguished from those of others.
#[derive(Debug)]
pub struct MachineKind {
    /// Whether it is a lathe.
    pub turns: bool,
    /// The signs that a program is for this kind at all.
    pub signs: &'static [RecognitionEvidence],
    /// The sum of weights from which on a program is for this kind.
    pub needed: i32,
}

/// A sign that names no machine.
pub const fn evidence(
    sign: RecognitionSign,
    weight: i32,
    reason: &'static str,
) -> RecognitionEvidence {
    RecognitionEvidence { sign, weight, reason, machine: None }
}

/// A comment with one of these words is about the machine that the program is for.
pub const MACHINE_WORDS: &[&str] =
    &["MACHINE", "VENDOR", "CONTROL", "CONTROLLER", "POST", "POSTED", "MODEL", "MAKE", "CNC"];

/// A comment with one of these words names a machine that the program is not for.
pub const OTHER_MACHINE_WORDS: &[&str] =
    &["FROM", "NOT", "WAS", "OLD", "FORMERLY", "ORIGINALLY", "REPLACES", "NEVER", "INSTEAD"];
