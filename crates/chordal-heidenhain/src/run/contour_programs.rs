//! The contours of cycle 14: label subprograms that are read and not carried out.

use std::collections::BTreeMap;

use chordal_command::{CompensationSide, Position};
use chordal_diagnostics::{Code, Diagnostic, TextRange};
use chordal_geometry::Vec2;
use chordal_kernel::shapes::{
    IslandError, IslandPocket, Outline, OutlineElement, OutlineError, chamfered, outlines_meet,
    rounded,
};

use super::interpreter::KlartextInterpreter;
use super::run_state::{ContourMemory, CycleNumber};
use crate::cycles::{
    CycleValues, KlartextCycleFault, KlartextCycleStep, TrainSide, contour_train_steps,
    rough_out_steps, side_finishing_steps, unreached_wall,
};
use crate::geometry::ContourElement;
use crate::syntax::{
    KlartextBlock, KlartextLabel, KlartextStatement, PathFunction, PathWords,
    contains_ignoring_case,
};

/// The most contours of cycle 14.
const MAX_CONTOURS: usize = 14;

/// The most blocks of a contour.
const MAX_CONTOUR_BLOCKS: usize = 20_000;

/// Contours whose ends are further apart, mm, are open.
const CLOSED_MM: f64 = 1e-3;

/// A contour as its subprogram programs it; mm in programmed coordinates of the plane.
#[derive(Clone, Debug)]
struct LabelContour {
    elements: Vec<OutlineElement>,
    side: CompensationSide,
    range: TextRange,
}

/// A contour that is being read.
struct ContourReading {
    memory: ContourMemory,
    /// Where the last element ends; programmed coordinates, mm.
    at: [f64; 3],
    has_begun: bool,
    /// The corner between the last element and the next.
    corner: Option<ContourCorner>,
    contour: LabelContour,
}

#[derive(Clone, Copy, Debug)]
enum ContourCorner {
    Rounding(f64),
    Chamfer(f64),
}

impl KlartextInterpreter<'_> {
    /// A line of cycle 14: the labels of the contours.
    pub(super) fn contour_labels(&mut self, line: u32, rest: TextRange) {
        // A second line goes on with the labels of the first.
        if line <= 1 {
            self.modes.contour_labels.clear();
        }
        if line == 0 {
            return;
        }
        let text = rest.slice(self.text());
        if text.contains(&b'"') || contains_ignoring_case(text, b"QS") {
            let what = "labels with names in cycle 14 are not followed";
            return self.not_followed(rest, what);
        }
        let labels = label_numbers(text);
        let labels: Vec<KlartextLabel> = labels.into_iter().map(KlartextLabel::Number).collect();
        for label in &labels {
            if !self.running().labels.contains_key(label) {
                let help = "write LBL with this number before the contour";
                self.report_missing_label(label, rest, help);
            }
        }
        self.modes.contour_labels.extend(labels);
        if self.modes.contour_labels.len() > MAX_CONTOURS {
            let count = self.modes.contour_labels.len();
            let message = format!("cycle 14 names {count} contours; {MAX_CONTOURS} are possible");
            self.problem(Code::BadWordValue, rest, message);
        }
    }

    /// Runs cycle 21, 22, 23, 24 or 25.
    pub(super) fn run_contour_cycle(&mut self, number: u32, own: &BTreeMap<u32, CycleNumber>) {
        let labels = self.modes.contour_labels.clone();
        if labels.is_empty() {
            let message =
                format!("cycle {number} works on the contours of cycle 14, which is missing");
            let diagnostic = Diagnostic::new(Code::NoCycle, self.span(self.here), message);
            return self
                .kernel
                .report(diagnostic.help("write CYCL DEF 14 with the labels of the contours"));
        }
        let mut data = own.clone();
        if number != 25 {
            if self.modes.contour_data.is_empty() {
                let message =
                    format!("cycle {number} needs the data of cycle 20, which is missing");
                let diagnostic = Diagnostic::new(Code::NoCycle, self.span(self.here), message);
                return self.kernel.report(diagnostic.help("write CYCL DEF 20 before it"));
            }
            for (word, value) in &self.modes.contour_data {
                data.entry(*word).or_insert(*value);
            }
        }
        let values = self.cycle_values(&data);
        if number == 21 || number == 22 && values.number(18) != 0.0 {
            let what = match number {
                21 => {
                    "the points where cycle 21 drills are those of the rough-out of the control: they are not known here"
                }
                _ => {
                    "Q18 of cycle 22 clears what a larger tool has left: what that is, is not known here"
                }
            };
            return self.not_followed_once(&format!("cycle {number}"), self.here, what);
        }
        let Some(contours) = self.read_contours(&labels) else { return };
        self.report_assumed_path(number);
        let steps = match number {
            25 => self.contour_train(&values, &contours),
            _ => self.pocket_cycle(number, &values, contours),
        };
        match steps {
            Some(Ok(steps)) => self.run_steps(&steps),
            Some(Err(fault)) => self.report_cycle(fault),
            None => {}
        }
    }

    fn contour_train(
        &mut self,
        values: &CycleValues,
        contours: &[LabelContour],
    ) -> Option<Result<Vec<KlartextCycleStep>, KlartextCycleFault>> {
        // Only the first contour of cycle 14 counts.
        let contour = contours.first()?;
        let side = match contour.side {
            CompensationSide::Off => TrainSide::On,
            CompensationSide::Left => TrainSide::Left,
            CompensationSide::Right => TrainSide::Right,
        };
        let context = self.contour_context();
        Some(contour_train_steps(values, &context, &contour.elements, side))
    }

    fn pocket_cycle(
        &mut self,
        number: u32,
        values: &CycleValues,
        contours: Vec<LabelContour>,
    ) -> Option<Result<Vec<KlartextCycleStep>, KlartextCycleFault>> {
        let pockets = self.contour_pockets(contours)?;
        let context = self.contour_context();
        if let (24, Some(tool)) = (number, context.tool_radius) {
            pockets.iter().for_each(|pocket| self.note_unreached(pocket, tool));
        }
        Some(match number {
            24 => side_finishing_steps(values, &context, &pockets),
            _ => rough_out_steps(number, values, &context, &pockets),
        })
    }

    /// The context of a cycle with the radius of the tool in programmed lengths: a scaled contour is larger, the tool is
    /// not.
    fn contour_context(&mut self) -> crate::cycles::CycleContext {
        let mut context = self.cycle_context();
        let factor = self.modes.frame.factor(self.tool_plane());
        context.tool_radius = context.tool_radius.map(|radius| radius / factor);
        context
    }

    fn note_unreached(&mut self, pocket: &IslandPocket, tool: f64) {
        let Some((left, place)) = unreached_wall(pocket, tool) else { return };
        let message = format!(
            "the tool of {:.3} mm stays {left:.3} mm from the wall at {:.3}, {:.3}",
            2.0 * tool,
            place.a,
            place.b
        );
        let diagnostic = Diagnostic::new(Code::PocketUnreached, self.span(self.here), message);
        self.kernel.report(diagnostic.help("use a smaller tool for this wall"));
    }

    /// The contours of labels; `None` if one cannot be read, which is reported.
    fn read_contours(&mut self, labels: &[KlartextLabel]) -> Option<Vec<LabelContour>> {
        let (kept, here) = (self.modes.contour.clone(), self.here);
        let kept_modes = self.modes.iso;
        let contours = labels.iter().map(|label| self.read_contour(label)).collect();
        self.modes.contour = kept;
        self.modes.iso = kept_modes;
        self.here = here;
        contours
    }

    fn read_contour(&mut self, label: &KlartextLabel) -> Option<LabelContour> {
        let range = self.here;
        let place = self.label_place(label, range)?;
        let mut reader = self.running().reader.clone();
        reader.seek(place.0, place.1);
        let start = self.programmed();
        let contour = LabelContour { elements: Vec::new(), side: CompensationSide::Off, range };
        let mut reading = ContourReading {
            memory: ContourMemory::default(),
            at: [start[0], start[1], start[2]],
            has_begun: false,
            corner: None,
            contour,
        };
        for block in reader.take(MAX_CONTOUR_BLOCKS) {
            self.here = block.range;
            match &block.statement {
                KlartextStatement::Label(KlartextLabel::Number(0)) => break,
                KlartextStatement::End { .. } => {
                    let message = "the contour is not ended by LBL 0";
                    self.problem(Code::ProgramWithoutEnd, block.range, message);
                    return None;
                }
                _ => self.contour_block(&block, &mut reading)?,
            }
        }
        let is_empty = reading.contour.elements.is_empty();
        if is_empty || reading.corner.is_some() {
            let message = match is_empty {
                true => "the contour has no element",
                false => "the contour ends with RND or CHF",
            };
            self.problem(Code::PocketGeometry, reading.contour.range, message);
            return None;
        }
        Some(reading.contour)
    }

    /// A block of a contour; `None` if it cannot be part of one, which is reported.
    fn contour_block(&mut self, block: &KlartextBlock, reading: &mut ContourReading) -> Option<()> {
        let unit = self.unit_mm();
        match &block.statement {
            KlartextStatement::Path(function, words) => {
                self.contour_path(*function, words, reading)
            }
            KlartextStatement::Center(words) => self.contour_center(words, reading),
            KlartextStatement::Rounding(words) => {
                let size = words.radius?;
                let radius = self.operand(size.value, size.range)? * unit;
                reading.corner = (radius > 0.0).then_some(ContourCorner::Rounding(radius));
                Some(())
            }
            KlartextStatement::Chamfer(size, _) => {
                let size = (*size)?;
                let leg = self.operand(size.value, size.range)? * unit;
                reading.corner = (leg > 0.0).then_some(ContourCorner::Chamfer(leg));
                Some(())
            }
            KlartextStatement::Iso(words) => {
                let words = self.iso_words(words);
                if words.center.iter().any(Option::is_some) {
                    let mut center = PathWords::default();
                    center.axes[..3].copy_from_slice(&words.center);
                    self.contour_center(&center, reading)?;
                }
                let path = self.iso_path(&words);
                self.contour_path(self.iso_function(&words), &path, reading)
            }
            KlartextStatement::Assign { target, formula } => {
                self.assign(*target, formula);
                Some(())
            }
            KlartextStatement::Nothing
            | KlartextStatement::Functions(_)
            | KlartextStatement::Label(_) => Some(()),
            _ => {
                let what = "this block in a contour of cycle 14 is not followed: the contour is not known here";
                self.not_followed(block.range, what);
                None
            }
        }
    }

    /// CC of a contour.
    fn contour_center(&mut self, words: &PathWords, reading: &mut ContourReading) -> Option<()> {
        let values = self.values(words)?;
        let mut place: Position = self.programmed();
        place[..3].copy_from_slice(&reading.at);
        self.place_center(&values, &place, &mut reading.memory);
        Some(())
    }

    /// A path function of a contour: the first gives its start and the side of the tool.
    fn contour_path(
        &mut self,
        function: PathFunction,
        words: &PathWords,
        reading: &mut ContourReading,
    ) -> Option<()> {
        let function = match function {
            PathFunction::Repeated => reading.memory.function,
            other => other,
        };
        reading.memory.function = function;
        if let Some((side, _)) = words.side
            && !reading.has_begun
        {
            reading.contour.side = side;
            reading.contour.range = self.here;
        }
        let is_circle = words.direction.is_some() && function == PathFunction::CenterArc;
        if !words.has_coordinates() && !is_circle {
            return Some(());
        }
        let values = self.values(words)?;
        let mut memory = reading.memory.clone();
        let element = match self.element(function, &values, reading.at, &mut memory) {
            Ok(element) => element,
            Err(fault) => {
                self.report_contour(fault, words);
                return None;
            }
        };
        let plane = self.tool_plane();
        let (a, b, normal) = plane.axes();
        memory.direction = element.end_direction(reading.at, plane);
        reading.memory = memory;
        let from = reading.at;
        let mut end = element.end();
        // The level of the tool does not belong to a contour.
        end[normal] = from[normal];
        reading.at = end;
        if !reading.has_begun {
            reading.has_begun = true;
            reading.memory.direction = None;
            return Some(());
        }
        let [from, to] = [from, end].map(|point| Vec2::new(point[a], point[b]));
        let element = match element {
            ContourElement::Line { .. } if from == to => return Some(()),
            ContourElement::Line { .. } => OutlineElement::Line { from, to },
            ContourElement::Arc { plane: own, center, sweep_rad, .. } if own == plane => {
                let center = Vec2::new(center[0], center[1]);
                OutlineElement::Arc { from, to, center, sweep: sweep_rad }
            }
            ContourElement::Arc { .. } => {
                let what =
                    "an arc of a contour of cycle 14 lies in another plane: it is not followed";
                self.not_followed(self.here, what);
                return None;
            }
        };
        self.add_element(element, reading)
    }

    /// Adds an element, with the corner before it.
    fn add_element(&mut self, element: OutlineElement, reading: &mut ContourReading) -> Option<()> {
        let elements = &mut reading.contour.elements;
        let Some(corner) = reading.corner.take() else {
            elements.push(element);
            return Some(());
        };
        let Some(last) = elements.pop() else {
            let message = "RND and CHF stand between two elements of a contour";
            self.problem(Code::CornerBlock, self.here, message);
            return None;
        };
        let parts = match corner {
            ContourCorner::Rounding(radius) => rounded(&last, &element, radius),
            ContourCorner::Chamfer(leg) => chamfered(&last, &element, leg),
        };
        let Some(parts) = parts else {
            let message = "the corner before this element does not fit between its neighbours";
            self.problem(Code::CornerTooLarge, self.here, message);
            return None;
        };
        elements.extend(parts);
        Some(())
    }

    /// The pockets with their islands; `None` if the contours do not make any, which is reported.
    fn contour_pockets(&mut self, contours: Vec<LabelContour>) -> Option<Vec<IslandPocket>> {
        let (mut pockets, mut islands) = (Vec::new(), Vec::new());
        for contour in contours {
            let outline = match Outline::new(contour.elements, CLOSED_MM) {
                Ok(outline) => outline,
                Err(error) => {
                    let message = match error {
                        OutlineError::Open(gap) => format!("the contour is open by {gap:.4} mm"),
                        OutlineError::CrossesItself(at) => {
                            format!("the contour crosses itself at {:.3}, {:.3}", at.a, at.b)
                        }
                        OutlineError::Empty => "the contour encloses no area".to_string(),
                    };
                    self.problem(Code::PocketGeometry, contour.range, message);
                    return None;
                }
            };
            // The tool is inside of a pocket and outside of an island.
            match (contour.side, outline.was_clockwise()) {
                (CompensationSide::Off, _) => {
                    let message =
                        "the contour has neither RL nor RR: it is neither pocket nor island";
                    self.problem(Code::MissingWord, contour.range, message);
                    return None;
                }
                (CompensationSide::Left, false) | (CompensationSide::Right, true) => {
                    pockets.push(outline);
                }
                (CompensationSide::Left, true) | (CompensationSide::Right, false) => {
                    islands.push(outline);
                }
            }
        }
        self.islands_in_pockets(pockets, islands)
    }

    fn islands_in_pockets(
        &mut self,
        pockets: Vec<Outline>,
        islands: Vec<Outline>,
    ) -> Option<Vec<IslandPocket>> {
        let begin = |own: &Outline| own.elements().first().map_or(Vec2::ZERO, OutlineElement::from);
        for (index, pocket) in pockets.iter().enumerate() {
            let others = pockets.iter().enumerate().filter(|(other, _)| *other != index);
            for (_, other) in others {
                if outlines_meet(pocket, other).is_some() || other.contains(begin(pocket)) {
                    return self.overlapping(begin(pocket));
                }
            }
        }
        let mut of_pocket: Vec<Vec<Outline>> = vec![Vec::new(); pockets.len()];
        for island in islands {
            let inside = pockets.iter().position(|pocket| pocket.contains(begin(&island)));
            match inside {
                Some(index) => of_pocket[index].push(island),
                None => return self.overlapping(begin(&island)),
            }
        }
        let mut found = Vec::new();
        for (pocket, islands) in pockets.into_iter().zip(of_pocket) {
            match IslandPocket::new(pocket, islands) {
                Ok(pocket) => found.push(pocket),
                Err(IslandError::Crossing(at) | IslandError::Misplaced(at)) => {
                    return self.overlapping(at);
                }
            }
        }
        Some(found)
    }

    /// Contours that overlap are put together by the control, which is not followed here.
    fn overlapping<T>(&mut self, at: Vec2) -> Option<T> {
        let what = format!(
            "contours of cycle 14 overlap, or lie in each other otherwise than islands in a pocket, at {:.3}, {:.3}: this is not followed",
            at.a, at.b
        );
        self.not_followed(self.here, what);
        None
    }
}

/// The numbers in a text: `CONTOUR LABEL1 /2 /3`, or `P01 1 P02 2` of a DIN/ISO program, where those after P count the
/// labels.
pub(super) fn label_numbers(text: &[u8]) -> Vec<u32> {
    let mut found = Vec::new();
    let mut before = b' ';
    let mut at = 0;
    while at < text.len() {
        let count = text[at..].iter().take_while(|byte| byte.is_ascii_digit()).count();
        if count == 0 {
            before = text[at].to_ascii_uppercase();
            at += 1;
            continue;
        }
        let number = std::str::from_utf8(&text[at..at + count]).ok();
        if before != b'P' {
            found.extend(number.and_then(|number| number.parse::<u32>().ok()));
        }
        before = b' ';
        at += count;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::label_numbers;

    #[test]
    fn labels_are_read_in_both_forms() {
        assert_eq!(label_numbers(b" CONTOUR LABEL1 /2 /13"), [1, 2, 13]);
        assert_eq!(label_numbers(b"KONTURLABEL 1/2"), [1, 2]);
        assert_eq!(label_numbers(b" P01 1 P02 12"), [1, 12]);
        assert!(label_numbers(b"CONTOUR LABEL 99999999999").is_empty());
    }
}
