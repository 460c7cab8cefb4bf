//! The words of a block with their values: lengths in mm, angles in degrees.

use chordal_diagnostics::{Code, Span, TextRange};
use chordal_geometry::{Plane, TurnDirection};
use chordal_kernel::{Statement, WordMeaning};

use super::interpreter::KlartextInterpreter;
use crate::syntax::{AXIS_WORDS, OperandWord, PathWords};

/// A coordinate with its value.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CoordinateValue {
    /// The value: mm, or degrees of a rotary axis.
    pub value: f64,
    /// It is a distance from the last position.
    pub is_incremental: bool,
}

impl CoordinateValue {
    /// The coordinate that it programs from a start.
    pub fn from(self, start: f64) -> f64 {
        if self.is_incremental { start + self.value } else { self.value }
    }
}

/// The values of the words of a block.
#[derive(Clone, Copy, Default, PartialEq, Debug)]
pub struct BlockValues {
    /// X Y Z A B C U V W.
    pub axes: [Option<CoordinateValue>; 9],
    /// PR.
    pub polar_radius: Option<CoordinateValue>,
    /// PA, degrees.
    pub polar_angle: Option<CoordinateValue>,
    /// R.
    pub radius: Option<f64>,
    /// LEN.
    pub length: Option<f64>,
    /// CCA, degrees.
    pub center_angle: Option<f64>,
    /// DR.
    pub direction: Option<TurnDirection>,
}

impl KlartextInterpreter<'_> {
    /// The values of the words of a block; `None` if one has none, which is reported.
    pub(super) fn values(&mut self, words: &PathWords) -> Option<BlockValues> {
        let unit = self.unit_mm();
        let mut values =
            BlockValues { direction: words.direction.map(|(d, _)| d), ..Default::default() };
        for (axis, word) in words.axes.iter().enumerate() {
            let is_rotary = (3..6).contains(&axis);
            let Some(word) = word else { continue };
            values.axes[axis] = Some(self.coordinate(word, if is_rotary { 1.0 } else { unit })?);
        }
        if let Some(word) = &words.polar_radius {
            values.polar_radius = Some(self.coordinate(word, unit)?);
        }
        if let Some(word) = &words.polar_angle {
            values.polar_angle = Some(self.coordinate(word, 1.0)?);
        }
        if let Some(word) = &words.radius {
            values.radius = Some(self.operand(word.value, word.range)? * unit);
        }
        if let Some(word) = &words.length {
            values.length = Some(self.operand(word.value, word.range)? * unit);
        }
        if let Some(word) = &words.center_angle {
            values.center_angle = Some(self.operand(word.value, word.range)?);
        }
        Some(values)
    }

    fn coordinate(&mut self, word: &OperandWord, unit: f64) -> Option<CoordinateValue> {
        let value = self.operand(word.value, word.range)? * unit;
        Some(CoordinateValue { value, is_incremental: word.is_incremental })
    }

    /// Reports the axes that the machine does not have; false if there is one.
    pub(super) fn has_axes(&mut self, words: &PathWords) -> bool {
        let axes = self.programs.control.axes();
        let missing = words.axes.iter().enumerate().find_map(|(axis, word)| {
            let word = (*word)?;
            (axis >= 6 || !axes.has(axis)).then_some((axis, word.range))
        });
        let Some((axis, range)) = missing else { return true };
        let letter = AXIS_WORDS[axis];
        if self.is_first_report(&format!("axis {letter}")) {
            // Nobody has said which machine the program is for: it may have the axis.
            let (code, message) = match self.programs.options.assumed_machine {
                true => (
                    Code::NotFollowed,
                    format!("the assumed machine has no axis {letter}: its moves are missing here"),
                ),
                false => (Code::NoSuchAxis, format!("this machine has no axis {letter}")),
            };
            self.problem(code, range, message);
        }
        false
    }
}

/// A block as the kernel sees it.
pub struct KlartextView<'w> {
    /// Its place.
    pub span: Span,
    /// Its words; `None` for a block without.
    pub words: Option<&'w PathWords>,
}

impl KlartextView<'_> {
    fn range_of(&self, what: WordMeaning) -> Option<TextRange> {
        let words = self.words?;
        let ranges: Vec<TextRange> = match what {
            WordMeaning::Axes(axes) => (0..6)
                .filter(|axis| axes.has(*axis))
                .filter_map(|axis| Some(words.axes[axis]?.range))
                .collect(),
            WordMeaning::CenterOrRadius => words.radius.iter().map(|word| word.range).collect(),
            WordMeaning::Angle => words.polar_angle.iter().map(|word| word.range).collect(),
            _ => Vec::new(),
        };
        ranges.into_iter().reduce(TextRange::cover)
    }
}

impl Statement for KlartextView<'_> {
    fn span(&self) -> Span {
        self.span
    }

    fn words(&self, what: WordMeaning) -> Span {
        self.range_of(what).map_or(self.span, |range| range.in_file(self.span.file))
    }

    fn name(&self, what: WordMeaning) -> &'static str {
        match what {
            WordMeaning::Center => "CC",
            WordMeaning::CenterOrRadius => "R",
            WordMeaning::Angle => "PA",
            WordMeaning::LengthOffset => "TOOL CALL",
            _ => "this word",
        }
    }

    fn center_names(&self, _: Plane) -> [&'static str; 2] {
        ["CC", "CC"]
    }

    fn number(&self, _: WordMeaning) -> Option<String> {
        None
    }

    fn has(&self, what: WordMeaning) -> bool {
        self.range_of(what).is_some()
    }

    fn has_feed(&self) -> bool {
        self.words.is_some_and(|words| words.feed.is_some())
    }
}
