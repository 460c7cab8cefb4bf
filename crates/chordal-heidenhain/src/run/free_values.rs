//! The words of free contours as values: lengths in mm, what relative words refer to as elements.

use chordal_diagnostics::{Code, Diagnostic, TextRange};

use super::interpreter::KlartextInterpreter;
use crate::geometry::{FreeElementValues, FreeReference, FreeValue};
use crate::syntax::{
    AXIS_WORDS, FreeElementWords, FreePointWords, FreeRelation, FreeRelationWord, OperandWord,
};

/// An element of a free contour before it is solved.
pub struct ReadElement {
    /// Its block.
    pub range: TextRange,
    /// The number of the block.
    pub number: Option<u32>,
    /// Its values; `None` where a word has none, which is reported.
    pub values: Option<FreeElementValues>,
    /// CLSD+ begins a closed contour here (false), CLSD- closes it (true).
    pub closing: Option<bool>,
}

/// What the words of an element are read with.
#[derive(Clone, Copy)]
pub struct FreeWordsContext<'c> {
    /// The elements of the contour before it.
    pub elements: &'c [ReadElement],
    /// FPOL, mm.
    pub pole: Option<[f64; 2]>,
}

impl FreeWordsContext<'_> {
    /// The element right before this one.
    fn previous(&self) -> FreeReference {
        match self.elements.len().checked_sub(1) {
            Some(before) => FreeReference::Own(before),
            None => FreeReference::Start,
        }
    }
}

impl KlartextInterpreter<'_> {
    /// The values of the words of an element; `None` if one is missing or wrong, which is reported.
    pub(super) fn free_values(
        &mut self,
        range: TextRange,
        words: &FreeElementWords,
        context: FreeWordsContext<'_>,
    ) -> Option<FreeElementValues> {
        let (a, b, _) = self.tool_plane().axes();
        let unit = self.unit_mm();
        let own = &words.words;
        let turn = own.direction.map(|(turn, _)| turn).filter(|_| words.is_arc);
        if words.is_arc && turn.is_none() {
            let message = "this arc of the free contour (FK) has no direction DR";
            let diagnostic = Diagnostic::new(Code::MissingWord, self.span(range), message);
            self.kernel.report(diagnostic.help("write DR+ or DR-"));
            return None;
        }
        let mut read = FreeWordReader { run: self, words, context, is_wrong: false };
        let end = [(own.axes[a], a), (own.axes[b], b)]
            .map(|(word, axis)| read.value(word, unit, FreeRelation::Coordinate(axis)));
        let polar = [
            read.value(own.polar_radius, unit, FreeRelation::Polar(0)),
            read.value(own.polar_angle, 1.0, FreeRelation::Polar(1)),
        ];
        let center =
            [a, b].map(|axis| read.value(words.center[axis], unit, FreeRelation::Center(axis)));
        let center_polar = [
            read.value(words.center_polar[0], unit, FreeRelation::CenterPolar(0)),
            read.value(words.center_polar[1], 1.0, FreeRelation::CenterPolar(1)),
        ];
        let angle = read.value(words.angle, 1.0, FreeRelation::Angle);
        let parallel_to = read.reference(FreeRelation::Parallel);
        let auxiliary = words.auxiliary.map(|point| read.point(&point, range));
        let distance_point = read.distance_point(range);
        let [length, radius, parallel_distance] = [own.length, own.radius, words.parallel_distance]
            .map(|word| read.number(word).map(|value| value * unit));
        let center_angle_deg = read.number(own.center_angle).map(f64::abs);
        let values = FreeElementValues {
            turn,
            is_tangent: words.is_tangent,
            pole: context.pole,
            end,
            polar,
            length: length.map(f64::abs),
            angle,
            center,
            center_polar,
            center_angle_deg,
            radius: radius.map(f64::abs),
            auxiliary,
            distance_point,
            parallel_to,
            parallel_distance: parallel_distance.map(f64::abs),
        };
        (!read.is_wrong).then_some(values)
    }
}

/// Reads the words of one element.
struct FreeWordReader<'r, 'a> {
    run: &'r mut KlartextInterpreter<'a>,
    words: &'r FreeElementWords,
    context: FreeWordsContext<'r>,
    is_wrong: bool,
}

impl FreeWordReader<'_, '_> {
    fn number(&mut self, word: Option<OperandWord>) -> Option<f64> {
        let word = word?;
        let value = self.run.operand(word.value, word.range);
        self.is_wrong |= value.is_none();
        value
    }

    /// A value that may be relative: to the block that a word names, with I alone to the element before.
    fn value(
        &mut self,
        word: Option<OperandWord>,
        unit: f64,
        relation: FreeRelation,
    ) -> Option<FreeValue> {
        let value = self.number(word)? * unit;
        let is_incremental = word.is_some_and(|word| word.is_incremental);
        let own = self.reference(relation);
        Some(FreeValue { value, from: own.or(is_incremental.then(|| self.context.previous())) })
    }

    /// The element that a word of a relation refers to.
    fn reference(&mut self, relation: FreeRelation) -> Option<FreeReference> {
        let word = *self.words.relations.iter().find(|word| word.relation == relation)?;
        let found = self.element_of(word.block);
        if found.is_none() {
            self.report_reference(word);
        }
        found
    }

    /// The last element before this one whose block has a number.
    fn element_of(&self, block: u32) -> Option<FreeReference> {
        let own = self.context.elements.iter().rposition(|element| element.number == Some(block));
        own.map(FreeReference::Own).or_else(|| {
            let before = self.run.modes.recent_elements.iter();
            let found = before.rev().position(|(number, _)| *number == block)?;
            let count = self.run.modes.recent_elements.len();
            Some(FreeReference::Before(count - 1 - found))
        })
    }

    fn report_reference(&mut self, word: FreeRelationWord) {
        self.is_wrong = true;
        let block = word.block;
        let message =
            format!("no element before this one has the block number {block} that it refers to");
        let help = "write the number of one of the 64 blocks before that move in the plane";
        self.run.bad_value(word.range, message, help);
    }

    /// A point, cartesian or polar; `None` without one.
    fn point(&mut self, point: &FreePointWords, range: TextRange) -> Option<[f64; 2]> {
        let (a, b, _) = self.run.tool_plane().axes();
        let unit = self.run.unit_mm();
        let [first, second] = [a, b].map(|axis| self.number(point.axes[axis]));
        let [radius, angle] = point.polar.map(|word| self.number(word));
        match (first, second, radius, angle) {
            (None, None, None, None) => return None,
            (Some(first), Some(second), None, None) => return Some([first * unit, second * unit]),
            (None, None, Some(radius), Some(angle)) => {
                if let Some([x, y]) = self.context.pole {
                    let (sin, cos) = chordal_kernel::frames::sin_cos_degrees(angle);
                    return Some([x + radius * unit * cos, y + radius * unit * sin]);
                }
                self.missing(range, "a polar point needs the pole FPOL before it".to_string());
            }
            _ => {
                let [a, b] = [AXIS_WORDS[a], AXIS_WORDS[b]];
                self.missing(range, format!("a point needs both {a} and {b}, or both PR and PA"));
            }
        }
        None
    }

    /// PDX, PDY and D.
    fn distance_point(&mut self, range: TextRange) -> Option<([f64; 2], f64)> {
        let distance = self.number(self.words.distance);
        let point = self.point(&self.words.distance_point, range);
        let unit = self.run.unit_mm();
        match (point, distance) {
            (Some(point), Some(distance)) => Some((point, distance.abs() * unit)),
            (None, None) => None,
            (Some(_), None) => {
                self.missing(range, "PDX and PDY need the distance D".to_string());
                None
            }
            (None, Some(_)) => {
                self.missing(range, "the distance D needs the point PDX and PDY".to_string());
                None
            }
        }
    }

    fn missing(&mut self, range: TextRange, what: String) {
        self.is_wrong = true;
        self.run.problem(Code::MissingWord, range, format!("{what} in a free contour (FK)"));
    }
}
