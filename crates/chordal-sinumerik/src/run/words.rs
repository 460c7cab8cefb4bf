//! The words of a block by what they are, with their values.

use chordal_command::AxisMask;
use chordal_diagnostics::{Span, TextRange};
use chordal_geometry::Plane;
use chordal_kernel::{Statement, WordMeaning};

use crate::syntax::ValueFunction;

/// Letters of the centre by the index of their axis.
pub const CENTER_NAMES: [&str; 3] = ["I", "J", "K"];

/// A value with the function around it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ValueWord {
    /// The number.
    pub value: f64,
    /// `AC`, `IC`, …; `None` for the modal reading.
    pub function: Option<ValueFunction>,
    /// The text.
    pub range: TextRange,
}

impl ValueWord {
    /// Whether it is a distance, when `incremental` is the modal reading.
    pub fn is_incremental(&self, incremental: bool) -> bool {
        match self.function {
            Some(
                ValueFunction::Incremental
                | ValueFunction::IncrementalDiameter
                | ValueFunction::IncrementalRadius,
            ) => true,
            Some(_) => false,
            None => incremental,
        }
    }

    /// The coordinate that it programs from a start, where one is `unit`.
    pub fn coordinate(&self, start: f64, unit: f64, incremental: bool) -> f64 {
        let value = self.value * unit;
        if self.is_incremental(incremental) { start + value } else { value }
    }
}

/// The tool that a T word names.
#[derive(Clone, PartialEq, Debug)]
pub enum ToolWord {
    /// By its number.
    Number(u32),
    /// By its name.
    Name(String),
}

/// A word of a spindle that is not the main one: `S2=900`, `M2=3`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SpindleWord {
    /// Its number.
    pub spindle: u32,
    /// Its speed, rev/min; otherwise an M function.
    pub is_speed: bool,
    /// The number.
    pub value: f64,
}

/// The words of a block that are no flow statements.
#[derive(Clone, Default, Debug)]
pub struct BlockWords {
    /// The G codes in order.
    pub g_codes: Vec<(u32, TextRange)>,
    /// The M functions in order.
    pub m_codes: Vec<(u32, TextRange)>,
    /// Names without a value, in upper case.
    pub names: Vec<(String, TextRange)>,
    /// X, Y, Z, A, B, C.
    pub axes: [Option<ValueWord>; 6],
    /// I, J, K.
    pub centers: [Option<ValueWord>; 3],
    /// I1, J1, K1: the point between of CIP.
    pub between: [Option<ValueWord>; 3],
    /// The other addresses with a number, by their name: `CR`, `F`, `RND`, `AP`.
    pub others: Vec<(&'static str, ValueWord)>,
    /// A3, B3, C3: the direction of the tool, from its tip to its holder.
    pub directions: [Option<ValueWord>; 3],
    /// T.
    pub tool: Option<(ToolWord, TextRange)>,
    /// Words of other spindles, in order.
    pub spindles: Vec<SpindleWord>,
    /// Axes that POS moves by themselves.
    pub positioned: AxisMask,
    /// Axes that are programmed with a value that is not known.
    pub astray: AxisMask,
    /// A centre, a radius or another word of the path has a value that is not known.
    pub has_unknown_path: bool,
}

impl BlockWords {
    /// The value of one of the other addresses; `None` without it.
    pub fn other(&self, name: &str) -> Option<ValueWord> {
        self.others.iter().find(|(own, _)| *own == name).map(|(_, word)| *word)
    }

    /// Whether a name stands in the block.
    pub fn has_name(&self, name: &str) -> bool {
        self.names.iter().any(|(own, _)| own == name)
    }

    /// Whether one of the axes of the plane or its normal, or a polar coordinate, is programmed.
    pub fn has_path_motion(&self) -> bool {
        self.axes.iter().chain(&self.directions).any(Option::is_some)
            || self.astray != AxisMask::NONE
            || self.other("AP").is_some()
            || self.other("RP").is_some()
    }

    /// The axes that are programmed.
    pub fn axis_mask(&self) -> AxisMask {
        let mut mask = AxisMask::NONE;
        (0..6).filter(|axis| self.axes[*axis].is_some()).for_each(|axis| mask.insert(axis));
        mask
    }
}

/// The addresses with a number that a block may have, apart from axes, centres, G, M and T.
pub const OTHER_ADDRESSES: &[&str] = &[
    "CR", "AR", "TURN", "AP", "RP", "F", "S", "D", "H", "FB", "FZ", "FRC", "FRCM", "CHF", "CHR",
    "RND", "RNDM", "ANG", "ADIS", "ADISPOS", "LIMS", "RPL", "DISC", "DISR", "DISCL", "FAD", "CTOL",
    "OTOL", "OFFN", "TOFFL", "TOFFR", "P", "SF", "FP", "ACC", "OVR", "SPOS", "SPCON", "SETMS",
];

/// A block as the kernel sees it.
pub struct BlockStatementView<'b> {
    /// Its place.
    pub span: Span,
    /// Its words.
    pub words: &'b BlockWords,
}

impl BlockStatementView<'_> {
    fn span_of(&self, ranges: impl Iterator<Item = TextRange>) -> Span {
        span_of_words(self.span, ranges)
    }
}

/// The span of words of a block; that of the whole block where there are none.
pub fn span_of_words(block: Span, words: impl Iterator<Item = TextRange>) -> Span {
    let joined = words
        .reduce(|all, range| TextRange::new(all.start.min(range.start), all.end.max(range.end)));
    joined.map_or(block, |range| Span { file: block.file, range })
}

/// The spelling of the words with a meaning, for messages.
pub fn name_of_word(what: WordMeaning) -> &'static str {
    match what {
        WordMeaning::Center => "I, J or K",
        WordMeaning::CenterOrRadius => "CR=",
        WordMeaning::Count => "TURN=",
        WordMeaning::LengthOffset => "D",
        _ => "this word",
    }
}

/// The spelling of the centre words of the two axes of a plane.
pub fn center_words(plane: Plane) -> [&'static str; 2] {
    let (a, b, _) = plane.axes();
    [a, b].map(|axis| CENTER_NAMES[axis])
}

impl Statement for BlockStatementView<'_> {
    fn span(&self) -> Span {
        self.span
    }

    fn words(&self, what: WordMeaning) -> Span {
        match what {
            WordMeaning::Axes(axes) => {
                let named = (0..6).filter(|axis| axes.has(*axis));
                self.span_of(named.filter_map(|axis| Some(self.words.axes[axis]?.range)))
            }
            WordMeaning::Center => {
                self.span_of(self.words.centers.iter().flatten().map(|word| word.range))
            }
            WordMeaning::CenterOrRadius => {
                let radius = self.words.other("CR");
                self.span_of(
                    self.words
                        .centers
                        .iter()
                        .flatten()
                        .copied()
                        .chain(radius)
                        .map(|word| word.range),
                )
            }
            _ => self.span,
        }
    }

    fn name(&self, what: WordMeaning) -> &'static str {
        name_of_word(what)
    }

    fn center_names(&self, plane: Plane) -> [&'static str; 2] {
        center_words(plane)
    }

    fn number(&self, what: WordMeaning) -> Option<String> {
        let word = match what {
            WordMeaning::Count => self.words.other("TURN"),
            WordMeaning::CenterOrRadius => self.words.other("CR"),
            _ => None,
        };
        word.map(|word| word.value.to_string())
    }

    fn has(&self, what: WordMeaning) -> bool {
        match what {
            WordMeaning::Axes(axes) => {
                (0..6).any(|axis| axes.has(axis) && self.words.axes[axis].is_some())
            }
            WordMeaning::Center => self.words.centers.iter().any(Option::is_some),
            WordMeaning::CenterOrRadius => {
                self.words.centers.iter().any(Option::is_some) || self.words.other("CR").is_some()
            }
            WordMeaning::Count => self.words.other("TURN").is_some(),
            _ => false,
        }
    }

    fn has_feed(&self) -> bool {
        self.words.other("F").is_some()
    }
}
