//! Free contours: the blocks of a contour are solved together before its first element is made.

use std::collections::VecDeque;

use chordal_command::AxisMask;
use chordal_diagnostics::{Code, TextRange};
use chordal_kernel::frames::sin_cos_degrees;

use super::interpreter::KlartextInterpreter;
use super::run_state::KlartextFlow;
use crate::geometry::{
    ContourElement, FreeContourFault, FreeElementValues, arc_about, solve_free_contour,
};
use crate::syntax::{
    FreeElementWords, KlartextStatement, OperandWord, PathFunction, PathWords, WordOperand,
};

/// Blocks of a free contour that are solved together at most.
const MAX_FREE_ELEMENTS: usize = 200;

/// An element of a free contour before it is solved.
struct ReadElement {
    /// Its block.
    range: TextRange,
    values: FreeElementValues,
    closing: Option<bool>,
    /// It has words that are not followed.
    has_relation: bool,
}

impl KlartextInterpreter<'_> {
    /// FPOL.
    pub(super) fn set_free_pole(&mut self, words: &PathWords) {
        let Some(values) = self.values(words) else { return };
        let place = self.programmed();
        let (a, b, _) = self.tool_plane().axes();
        let of = |axis: usize| values.axes[axis].map_or(place[axis], |word| word.from(place[axis]));
        self.modes.free_pole = Some([of(a), of(b)]);
    }

    /// FL, FLT, FC, FCT.
    pub(super) fn free_element(&mut self, words: &FreeElementWords) -> KlartextFlow {
        let start = self.here.start;
        if self.modes.free_elements.front().is_none_or(|(place, _)| *place != start) {
            self.solve_free_elements(words);
        }
        let solved = self.modes.free_elements.pop_front().and_then(|(_, element)| element);
        self.functions_at_start(&words.words);
        let is_rapid = self.apply_feed(words.words.feed);
        let function = if words.is_arc { PathFunction::CenterArc } else { PathFunction::Line };
        self.set_compensation(function, &words.words);
        match solved {
            Some(element) => self.make_free_element(words, element.end, element.center, is_rapid),
            None => {
                self.kernel.go_astray(AxisMask::XY);
                self.modes.contour.direction = None;
            }
        }
        self.set_corner_mode(&words.words);
        self.modes.contour.function = PathFunction::Line;
        self.functions_at_end(&words.words.functions)
    }

    fn make_free_element(
        &mut self,
        words: &FreeElementWords,
        end: [f64; 2],
        center: Option<[f64; 2]>,
        is_rapid: bool,
    ) {
        let (a, b, _) = self.tool_plane().axes();
        // The block moves on both axes of the plane, whether it names them or not.
        let unit = self.unit_mm();
        let coordinate = |mm: f64| OperandWord {
            is_incremental: false,
            value: WordOperand::Number(mm / unit),
            range: self.here,
        };
        let mut moved = PathWords { polar_radius: None, polar_angle: None, ..words.words.clone() };
        (moved.axes[a], moved.axes[b]) = (Some(coordinate(end[0])), Some(coordinate(end[1])));
        let Some(values) = self.values(&moved) else { return };
        let start = self.programmed();
        let mut place = [start[0], start[1], start[2]];
        for (axis, value) in place.iter_mut().enumerate() {
            if let Some(word) = values.axes[axis] {
                *value = word.from(*value);
            }
        }
        (place[a], place[b]) = (end[0], end[1]);
        let turn = words.words.direction.map(|(turn, _)| turn);
        let element = match (center, turn) {
            (Some(center), Some(turn)) => {
                let (center, sweep_rad) = arc_about([start[a], start[b]], end, center, turn);
                ContourElement::Arc { plane: self.tool_plane(), center, sweep_rad, end: place }
            }
            _ => ContourElement::Line { end: place },
        };
        self.cut(&moved, &values, &element, is_rapid);
    }

    /// Solves the elements from this block to the last of the contour.
    fn solve_free_elements(&mut self, first: &FreeElementWords) {
        let mut elements = vec![self.read_element(self.here, first)];
        let reader = self.running().reader.clone();
        for block in reader.take(MAX_FREE_ELEMENTS) {
            match &block.statement {
                KlartextStatement::FreeElement(words) => {
                    let element = self.read_element(block.range, words);
                    elements.push(element);
                }
                KlartextStatement::Nothing => {}
                _ => break,
            }
        }
        self.close_contour(&mut elements);
        let values: Vec<FreeElementValues> =
            elements.iter().map(|element| element.values).collect();
        let place = self.programmed();
        let (a, b, _) = self.tool_plane().axes();
        let related = elements.iter().position(|element| element.has_relation);
        let found = match related {
            Some(index) => Err(FreeContourFault::Undetermined(index)),
            None => solve_free_contour(
                &values,
                [place[a], place[b]],
                self.modes.contour.direction,
                self.modes.free_pole,
                self.programs.settings.arc_tolerance_mm,
            ),
        };
        let starts = elements.iter().map(|element| element.range.start);
        let solved: VecDeque<_> = match found {
            Ok(solved) => starts.zip(solved.into_iter().map(Some)).collect(),
            Err(fault) => {
                self.report_free_contour(fault, &elements, related.is_some());
                starts.map(|start| (start, None)).collect()
            }
        };
        self.modes.free_elements = solved;
    }

    fn report_free_contour(
        &mut self,
        fault: FreeContourFault,
        elements: &[ReadElement],
        has_relation: bool,
    ) {
        match fault {
            FreeContourFault::Undetermined(index) => {
                let range = elements[index].range;
                let what = match has_relation {
                    true => {
                        "this element of the free contour (FK) refers to points or other elements, which is not followed"
                    }
                    false => {
                        "the values of this free contour (FK) do not determine this element, or leave more than one solution"
                    }
                };
                self.not_followed(range, what);
            }
            FreeContourFault::Contradiction(index) => {
                let range = elements[index].range;
                let message =
                    "the values of this element of the free contour (FK) contradict each other";
                let help = "leave out what follows from the others, or correct it";
                self.bad_value(range, message.into(), help);
                self.problem(Code::UnknownPath, range, "the free contour (FK) is missing here");
            }
        }
    }

    /// CLSD-: the contour ends where CLSD+ began, if the block does not say it.
    fn close_contour(&self, elements: &mut [ReadElement]) {
        let Some(opening) = elements.iter().position(|element| element.closing == Some(false))
        else {
            return;
        };
        let place = self.programmed();
        let (a, b, _) = self.tool_plane().axes();
        let begin = match opening.checked_sub(1) {
            None => [Some(place[a]), Some(place[b])],
            Some(before) => elements[before].values.end,
        };
        for element in elements.iter_mut().filter(|element| element.closing == Some(true)) {
            if element.values.end == [None; 2] {
                element.values.end = begin;
            }
        }
    }

    /// The values of the words of an element.
    fn read_element(&mut self, range: TextRange, words: &FreeElementWords) -> ReadElement {
        let (a, b, _) = self.tool_plane().axes();
        let unit = self.unit_mm();
        let mut has_relation = words.has_relation;
        let mut value = |word: &Option<OperandWord>, unit: f64| {
            let word = word.as_ref()?;
            has_relation |= word.is_incremental;
            Some(self.operand(word.value, word.range)? * unit)
        };
        let own = &words.words;
        let end = [value(&own.axes[a], unit), value(&own.axes[b], unit)];
        let polar = [value(&own.polar_radius, unit), value(&own.polar_angle, 1.0)];
        let center = [value(&words.center[a], unit), value(&words.center[b], unit)];
        let center_polar =
            [value(&words.center_polar[0], unit), value(&words.center_polar[1], 1.0)];
        let (length, radius) = (value(&own.length, unit), value(&own.radius, unit));
        let angle_deg = value(&words.angle, 1.0);
        let from_pole = || {
            let [Some(radius), Some(angle)] = center_polar else { return None };
            let (sin, cos) = sin_cos_degrees(angle);
            self.modes.free_pole.map(|pole| [pole[0] + radius * cos, pole[1] + radius * sin])
        };
        let center = match center {
            [Some(first), Some(second)] => Some([first, second]),
            _ => from_pole(),
        };
        let turn = own.direction.map(|(turn, _)| turn).filter(|_| words.is_arc);
        let values = FreeElementValues {
            turn,
            is_tangent: words.is_tangent,
            end,
            polar,
            length,
            angle_deg,
            center,
            radius,
        };
        let has_relation = has_relation || words.is_arc && turn.is_none();
        ReadElement { range, values, closing: words.closing, has_relation }
    }
}
