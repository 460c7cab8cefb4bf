//! Free contours: the blocks of a contour are solved together before its first element is made.

use std::collections::VecDeque;

use chordal_command::{AxisMask, telling_number};
use chordal_diagnostics::{Code, Diagnostic, TextRange};
use chordal_geometry::{TurnDirection, Vec2};

use super::free_values::{FreeWordsContext, ReadElement};
use super::interpreter::KlartextInterpreter;
use super::run_state::{KlartextFlow, MAX_RECENT_ELEMENTS};
use crate::geometry::{
    ContourChoice, ContourElement, FreeContourFault, FreeContourRequest, FreeElementValues,
    FreeReference, FreeValue, KnownElement, PartlySolvedElement, SolvedFreeElement, arc_about,
    solve_free_contour,
};
use crate::syntax::{
    AXIS_WORDS, FreeElementWords, KlartextReader, KlartextStatement, OperandWord, PathFunction,
    PathWords, WordOperand,
};

/// Blocks of a free contour that are solved together at most.
const MAX_FREE_ELEMENTS: usize = 200;

/// Solutions of a contour, and elements of each, that a message names.
const MAX_SHOWN: usize = 8;

/// A block of a free contour.
#[derive(Clone, Copy)]
pub struct FreeBlock<'w> {
    /// Its text.
    pub range: TextRange,
    /// Its number.
    pub number: Option<u32>,
    /// Its words.
    pub words: &'w FreeElementWords,
}

/// The blocks of a free contour up to the next other one.
#[derive(Default)]
struct FreeContourBlocks {
    elements: Vec<ReadElement>,
    /// FSELECT: the element before it, the number of the solution, its text.
    selections: Vec<(usize, u32, TextRange)>,
}

impl KlartextInterpreter<'_> {
    /// FPOL.
    pub(super) fn set_free_pole(&mut self, words: &PathWords) {
        let place = self.programmed();
        self.modes.free_pole = self.free_pole(words, [place[0], place[1], place[2]]);
    }

    /// The pole of FPOL with the tool at a place; `None` where a word has no value.
    pub(super) fn free_pole(&mut self, words: &PathWords, place: [f64; 3]) -> Option<[f64; 2]> {
        let values = self.values(words)?;
        let (a, b, _) = self.tool_plane().axes();
        let of = |axis: usize| values.axes[axis].map_or(place[axis], |word| word.from(place[axis]));
        Some([of(a), of(b)])
    }

    /// FL, FLT, FC, FCT.
    pub(super) fn free_element(&mut self, words: &FreeElementWords) -> KlartextFlow {
        let start = self.here.start;
        if self.modes.free_elements.front().is_none_or(|(place, _)| *place != start) {
            let block = FreeBlock { range: self.here, number: self.modes.block_number, words };
            let reader = self.running().reader.clone();
            let place = self.programmed();
            let entry = self.modes.contour.direction;
            self.solve_free_elements(block, reader, [place[0], place[1], place[2]], entry);
        }
        let solved = self.modes.free_elements.pop_front().and_then(|(_, element)| element);
        self.functions_at_start(&words.words);
        let is_rapid = self.apply_feed(words.words.feed);
        let function = if words.is_arc { PathFunction::CenterArc } else { PathFunction::Line };
        self.set_compensation(function, &words.words);
        match solved {
            Some(element) => self.make_free_element(words, element, is_rapid),
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
        solved: SolvedFreeElement,
        is_rapid: bool,
    ) {
        let (a, b, _) = self.tool_plane().axes();
        let end = solved.end;
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
        let from = [start[0], start[1], start[2]];
        let element = self.element_of_solution(words, solved, from, place);
        self.cut(&moved, &values, &element, is_rapid);
    }

    /// The line or arc of a solved element.
    fn element_of_solution(
        &self,
        words: &FreeElementWords,
        solved: SolvedFreeElement,
        start: [f64; 3],
        end: [f64; 3],
    ) -> ContourElement {
        let plane = self.tool_plane();
        let (a, b, _) = plane.axes();
        let turn = words.words.direction.map(|(turn, _)| turn);
        let (Some(center), Some(turn)) = (solved.center, turn) else {
            return ContourElement::Line { end };
        };
        let ends = [start, end].map(|point| Vec2::new(point[a], point[b]));
        let (center, sweep_rad) = arc_about(ends[0], ends[1], Vec2::from_array(center), turn);
        ContourElement::Arc { plane, center: center.to_array(), sweep_rad, end }
    }

    /// The direction in which a free contour begins at a point: for the approach before it. Its elements are solved.
    pub(super) fn free_start_direction(
        &mut self,
        block: FreeBlock<'_>,
        reader: KlartextReader<'_>,
        point: [f64; 3],
    ) -> Option<Vec2> {
        self.solve_free_elements(block, reader, point, None);
        let solved = self.modes.free_elements.front().and_then(|(_, element)| *element)?;
        let plane = self.tool_plane();
        let (a, b, _) = plane.axes();
        let mut end = point;
        (end[a], end[b]) = (solved.end[0], solved.end[1]);
        let element = self.element_of_solution(block.words, solved, point, end);
        element.start_direction(point, plane)
    }

    /// Solves the elements from a block to the last of the contour.
    fn solve_free_elements(
        &mut self,
        first: FreeBlock<'_>,
        reader: KlartextReader<'_>,
        start: [f64; 3],
        entry: Option<Vec2>,
    ) {
        let mut blocks = self.free_blocks(first, reader);
        self.close_contour(&mut blocks.elements);
        let values: Option<Vec<FreeElementValues>> =
            blocks.elements.iter().map(|element| element.values).collect();
        let before: Vec<KnownElement> =
            self.modes.recent_elements.iter().map(|(_, element)| *element).collect();
        let selections: Vec<(usize, u32)> =
            blocks.selections.iter().map(|(element, number, _)| (*element, *number)).collect();
        let (a, b, _) = self.tool_plane().axes();
        // What has no value is reported already.
        let found = values.map(|values| {
            solve_free_contour(&FreeContourRequest {
                elements: &values,
                before: &before,
                start: [start[a], start[b]],
                entry: entry.map(Vec2::to_array),
                selections: &selections,
                order: self.programs.settings.free_contour_order,
                tolerance_mm: self.programs.settings.arc_tolerance_mm,
            })
        });
        let starts: Vec<u32> = blocks.elements.iter().map(|element| element.range.start).collect();
        let solved: VecDeque<_> = match found {
            Some(Ok(solved)) => starts.into_iter().zip(solved.into_iter().map(Some)).collect(),
            failed => {
                match failed {
                    Some(Err(fault)) => self.report_free_contour(fault, &blocks),
                    _ => self.not_followed(first.range, "the free contour (FK) is missing here"),
                }
                starts.into_iter().map(|start| (start, None)).collect()
            }
        };
        self.modes.free_elements = solved;
    }

    /// Reads the blocks of a contour. Roundings and chamfers change its corners, and not its elements.
    fn free_blocks(
        &mut self,
        first: FreeBlock<'_>,
        reader: KlartextReader<'_>,
    ) -> FreeContourBlocks {
        let mut blocks = FreeContourBlocks::default();
        let mut pole = self.modes.free_pole;
        self.read_free_block(first, pole, &mut blocks);
        for block in reader.take(MAX_FREE_ELEMENTS) {
            if self.is_skipped(&block) {
                continue;
            }
            let (range, number) = (block.range, block.number);
            match &block.statement {
                KlartextStatement::FreeElement(words) => {
                    self.read_free_block(FreeBlock { range, number, words }, pole, &mut blocks);
                }
                KlartextStatement::FreeSelection(word) => {
                    if let Some(number) = self.operand(word.value, word.range) {
                        let number = number.round().clamp(0.0, 1e6) as u32;
                        blocks.selections.push((blocks.elements.len() - 1, number, word.range));
                    }
                }
                KlartextStatement::FreePole(words) => {
                    // Distances from the tool are not known inside of the contour.
                    let words = words.as_ref();
                    let is_absolute = !words.axes.iter().flatten().any(|word| word.is_incremental);
                    pole = self.free_pole(words, [0.0; 3]).filter(|_| is_absolute);
                }
                KlartextStatement::Nothing
                | KlartextStatement::Functions(_)
                | KlartextStatement::Rounding(_)
                | KlartextStatement::Chamfer(..) => {}
                _ => break,
            }
        }
        blocks
    }

    fn read_free_block(
        &mut self,
        block: FreeBlock<'_>,
        pole: Option<[f64; 2]>,
        blocks: &mut FreeContourBlocks,
    ) {
        let context = FreeWordsContext { elements: &blocks.elements, pole };
        let values = self.free_values(block.range, block.words, context);
        let FreeBlock { range, number, words } = block;
        blocks.elements.push(ReadElement { range, number, values, closing: words.closing });
    }

    /// CLSD-: the contour ends where CLSD+ began, if the block does not say it.
    fn close_contour(&self, elements: &mut [ReadElement]) {
        let Some(opening) = elements.iter().position(|element| element.closing == Some(false))
        else {
            return;
        };
        let from = match opening.checked_sub(1) {
            None => FreeReference::Start,
            Some(before) => FreeReference::Own(before),
        };
        let begin = FreeValue { value: 0.0, from: Some(from) };
        let closing = elements.iter_mut().filter(|element| element.closing == Some(true));
        for values in closing.filter_map(|element| element.values.as_mut()) {
            if values.end == [None; 2] {
                values.end = [Some(begin); 2];
            }
        }
    }

    /// Keeps an element for blocks that refer to its number.
    pub(super) fn remember_element(&mut self, start: [f64; 3], element: &ContourElement) {
        let Some(number) = self.modes.block_number else { return };
        let plane = self.tool_plane();
        let (a, b, _) = plane.axes();
        let end = element.end();
        let arc = match element {
            ContourElement::Arc { plane: own, center, sweep_rad, .. } if *own == plane => {
                let turn = if *sweep_rad > 0.0 { TurnDirection::Ccw } else { TurnDirection::Cw };
                Some((*center, turn))
            }
            _ => None,
        };
        let known = KnownElement { start: [start[a], start[b]], end: [end[a], end[b]], arc };
        let recent = &mut self.modes.recent_elements;
        if recent.len() == MAX_RECENT_ELEMENTS {
            recent.pop_front();
        }
        recent.push_back((number, known));
    }

    fn report_free_contour(&mut self, fault: FreeContourFault, blocks: &FreeContourBlocks) {
        let range_of = |index: usize| blocks.elements[index].range;
        match fault {
            FreeContourFault::Undetermined(index) => {
                let what = "the values of this free contour (FK) do not determine this element";
                self.not_followed(range_of(index), what);
            }
            FreeContourFault::Contradiction(index) => {
                let range = range_of(index);
                let message =
                    "the values of this element of the free contour (FK) contradict each other";
                let help = "leave out what follows from the others, or correct it";
                self.bad_value(range, message.into(), help);
                self.problem(Code::UnknownPath, range, "the free contour (FK) is missing here");
            }
            FreeContourFault::Ambiguous(choice) => self.report_solutions(&choice, blocks),
            FreeContourFault::NoSuchSolution(index, number, count) => {
                let selection = blocks.selections.iter().find(|(element, ..)| *element == index);
                let range = selection.map_or(range_of(index), |(_, _, range)| *range);
                let message = format!(
                    "FSELECT selects solution {number} of the free contour (FK), which has {count} here"
                );
                let help = "select one that exists; without FSELECT the message names them";
                self.bad_value(range, message, help);
                self.problem(Code::UnknownPath, range, "the free contour (FK) is missing here");
            }
            FreeContourFault::TooManySolutions(index) => {
                let what = "more contours fit the values of this free contour (FK) up to here than are followed";
                self.not_followed(range_of(index), what);
            }
        }
    }

    /// Several contours fit: their numbers and points, so that one can be selected.
    fn report_solutions(&mut self, choice: &ContourChoice, blocks: &FreeContourBlocks) {
        let block = &blocks.elements[choice.element];
        let shown = choice.solutions.iter().take(MAX_SHOWN);
        let texts: Vec<String> = shown
            .map(|own| format!("{}: {}", own.number, self.solution_text(&own.elements)))
            .collect();
        let from = blocks.elements[choice.from].number;
        let from = from.map_or(String::new(), |number| format!(" from block {number} on"));
        let message = format!(
            "{} contours fit the values of this free contour (FK) up to here; their elements{from} end at {}",
            choice.solutions.len(),
            texts.join("; ")
        );
        let diagnostic = Diagnostic::new(Code::NotFollowed, self.span(block.range), message);
        let help = "write FSELECT with the number of one of them after this block";
        self.kernel.report(diagnostic.help(help));
    }

    /// The points of a solution; where an end is not known yet, the line or circle on which it lies.
    fn solution_text(&self, elements: &[PartlySolvedElement]) -> String {
        let (a, b, _) = self.tool_plane().axes();
        let unit = self.unit_mm();
        let point = |[first, second]: [f64; 2]| {
            let [first, second] = [first, second].map(|mm| telling_number(mm / unit, 3));
            format!("{}{first} {}{second}", AXIS_WORDS[a], AXIS_WORDS[b])
        };
        let text = |element: &PartlySolvedElement| match *element {
            PartlySolvedElement { end: Some(end), circle: Some((center, _)), .. } => {
                format!("{} about {}", point(end), point(center))
            }
            PartlySolvedElement { end: Some(end), .. } => point(end),
            PartlySolvedElement { circle: Some((center, radius)), .. } => {
                format!("R{} about {}", telling_number(radius / unit, 3), point(center))
            }
            PartlySolvedElement { direction_deg: Some(degrees), .. } => {
                format!("a point at {} degrees", telling_number(degrees, 3))
            }
            _ => "a point that is not known yet".to_string(),
        };
        elements.iter().take(MAX_SHOWN).map(text).collect::<Vec<_>>().join(", ")
    }
}
