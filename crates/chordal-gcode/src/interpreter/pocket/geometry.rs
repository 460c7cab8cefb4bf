//! Reads the outline that P of a general pocket names; its blocks are not carried out.

use chordal_diagnostics::{Code, Diagnostic, Span};
use chordal_dialect::code_number;
use chordal_dialect::{Action, AfterCode, CallCode, MotionCode, ReadingCode};
use chordal_geometry::{Plane, TurnDirection, Vec2, Vec3, arc_from_center, center_from_radius};
use chordal_kernel::shapes::{Outline, OutlineElement, OutlineError};
use chordal_syntax::{Block, BlockKind, BlockReader, WordValue};

use crate::interpreter::Interpreter;

/// Largest number of moves of an outline (Haas, G150).
const MAX_MOVES: usize = 40;

/// Largest number of blocks read to find its end.
const MAX_BLOCKS: usize = 1_000;

/// The modal state within an outline.
struct OutlineState {
    place: Vec2,
    motion: Action,
    incremental: bool,
}

/// The meaning of a block of an outline.
enum OutlineBlock {
    Move(OutlineElement),
    Nothing,
    End,
    /// The outline is wrong, which was reported.
    Wrong,
}

impl Interpreter<'_> {
    /// The outline of a pocket with its start hole at `start`; `None` when there is none, which is reported.
    pub(super) fn pocket_outline(
        &mut self,
        block: &Block,
        at: usize,
        start: Vec2,
    ) -> Option<Outline> {
        let Some(word) = block.last(b'P').copied() else {
            self.kernel.report(
                Diagnostic::new(
                    Code::PocketWithoutGeometry,
                    self.span(block.words[at].range),
                    "a pocket without P, so it has no outline",
                )
                .label("not carried out")
                .help("write P and the N number, or the O number, of the outline's blocks"),
            );
            return None;
        };
        let named = self.span(word.range);
        let number = self.count(&word)?;
        let library = self.library;
        let (program, start_of_text) = match self.label(self.program, i64::from(number)) {
            Some(position) => (self.program, Some(position)),
            None => match library.find(number, self.file) {
                Some(program) => (program, None),
                None => {
                    self.report_no_outline(named, number);
                    return None;
                }
            },
        };
        let mut reader = self.reader_of(program);
        if let Some(position) = start_of_text {
            reader.seek(position);
        }
        // Spans refer to the file that is read.
        let file = self.program_at(program).file;
        let file = std::mem::replace(&mut self.file, file);
        let moves = self.read_outline(&mut reader, named, start);
        self.file = file;
        self.close_outline(moves?, named, start)
    }

    fn report_no_outline(&mut self, span: Span, number: u32) {
        if !self.missing.contains(&number) {
            self.missing.push(number);
        }
        self.kernel.report(
            Diagnostic::new(
                Code::PocketWithoutGeometry,
                span,
                format!("no block has the number N{number}, and there is no program O{number}"),
            )
            .label("the pocket is not carried out")
            .help("put N before the first block of the outline, and M99 after the last one"),
        );
    }

    fn read_outline(
        &mut self,
        reader: &mut BlockReader<'_>,
        named: Span,
        start: Vec2,
    ) -> Option<Vec<OutlineElement>> {
        let mut pen = OutlineState {
            place: start,
            motion: Action::Motion(MotionCode::Linear),
            incremental: self.kernel.state.incremental,
        };
        let mut moves = Vec::new();
        let mut block = Block::new();
        for _ in 0..MAX_BLOCKS {
            if !reader.read(&mut block) {
                break;
            }
            match self.outline_block(&block, &mut pen) {
                OutlineBlock::Move(element) => moves.push(element),
                OutlineBlock::Nothing => {}
                OutlineBlock::End => return Some(moves),
                OutlineBlock::Wrong => return None,
            }
            if moves.len() > MAX_MOVES {
                let message = format!("the outline has more than {MAX_MOVES} moves");
                self.report_outline(named, message, "divide the pocket, or remove short lines");
                return None;
            }
        }
        Some(moves)
    }

    fn outline_block(&mut self, block: &Block, pen: &mut OutlineState) -> OutlineBlock {
        let computed = block.words.iter().any(|word| {
            matches!(word.value, WordValue::Expression(_) | WordValue::Register { .. })
        });
        if computed || matches!(block.kind, BlockKind::Macro(_)) {
            let message = "the outline of a pocket cannot have macro variables".to_string();
            return self.wrong_outline(block, message, "write numbers");
        }
        if block.kind != BlockKind::Words {
            return OutlineBlock::Nothing;
        }
        let mut ends = false;
        for word in &block.words {
            let Some(code) = self.literal(word).and_then(code_number) else { continue };
            let row = match word.letter {
                b'G' => self.control.g_code(code),
                b'M' => self.control.m_code(code),
                _ => continue,
            };
            match row.map(|row| row.action) {
                Some(
                    action @ (Action::Motion(MotionCode::Linear)
                    | Action::Motion(MotionCode::ArcCw)
                    | Action::Motion(MotionCode::ArcCcw)),
                ) => {
                    pen.motion = action;
                }
                Some(Action::Reading(ReadingCode::Absolute)) => pen.incremental = false,
                Some(Action::Reading(ReadingCode::Incremental)) => pen.incremental = true,
                Some(
                    Action::Call(CallCode::Return) | Action::After(AfterCode::ProgramEnd { .. }),
                ) => ends = true,
                _ => {
                    let letter = word.letter as char;
                    let number = self.literal(word).map_or(String::new(), |n| n.to_string());
                    let message = format!("{letter}{number} in the outline of a pocket");
                    return self.wrong_outline(block, message, "only lines and arcs: G1, G2, G3");
                }
            }
        }
        if ends {
            return OutlineBlock::End;
        }
        self.outline_move(block, pen)
    }

    fn outline_move(&mut self, block: &Block, pen: &mut OutlineState) -> OutlineBlock {
        let letters = block.letters();
        if letters.has(b'Z') {
            let message = "Z in the outline of a pocket".to_string();
            return self.wrong_outline(
                block,
                message,
                "the depth belongs in the block of the pocket",
            );
        }
        let from = pen.place;
        let base = if pen.incremental { from } else { Vec2::ZERO };
        let to = Vec2::new(
            self.axis_value_of(block, 0).map_or(from.a, |x| base.a + x),
            self.axis_value_of(block, 1).map_or(from.b, |y| base.b + y),
        );
        let is_arc = pen.motion != Action::Motion(MotionCode::Linear);
        let has_center = letters.has(b'I') || letters.has(b'J') || letters.has(b'R');
        if to == from && !(is_arc && has_center) {
            return OutlineBlock::Nothing;
        }
        pen.place = to;
        if !is_arc {
            return OutlineBlock::Move(OutlineElement::Line { from, to });
        }
        let direction = if pen.motion == Action::Motion(MotionCode::ArcCw) {
            TurnDirection::Cw
        } else {
            TurnDirection::Ccw
        };
        self.outline_arc(block, from, to, direction)
    }

    fn outline_arc(
        &mut self,
        block: &Block,
        from: Vec2,
        to: Vec2,
        direction: TurnDirection,
    ) -> OutlineBlock {
        let flat = |p: Vec2| Vec3::new(p.a, p.b, 0.0);
        let tolerance = self.control.parameters.rules.arc.radius_error_tolerance_mm;
        let center = match self.length_of(block, b'R') {
            Some(radius) => {
                let rules = &self.control.parameters.rules;
                let near = rules.half_circle_tolerance(self.kernel.state.units);
                center_from_radius(Plane::Xy, flat(from), flat(to), radius, direction, near).ok()
            }
            None => Some((
                from.a + self.length_of(block, b'I').unwrap_or(0.0),
                from.b + self.length_of(block, b'J').unwrap_or(0.0),
            )),
        };
        let fit = center.map(|center| {
            (
                center,
                arc_from_center(Plane::Xy, flat(from), flat(to), center, direction, 0, tolerance),
            )
        });
        match fit {
            Some((center, fit))
                if fit.radius_error().abs() <= tolerance * (1.0 + 1e-9)
                    && fit.radius_start > 0.0 =>
            {
                let center = Vec2::new(center.0, center.1);
                OutlineBlock::Move(OutlineElement::Arc { from, to, center, sweep: fit.sweep })
            }
            Some((_, fit)) => {
                let off = self.kernel.length_text(fit.radius_error().abs());
                let message = format!("an arc of the outline ends {off} off its circle");
                self.wrong_outline(block, message, "check its end and its I and J")
            }
            None => {
                let message = "the radius of this arc does not reach from its start to its end";
                self.wrong_outline(block, message.to_string(), "check its end and its R")
            }
        }
    }

    /// Closes the outline: the first move leads to it from the start hole, the others are its elements.
    fn close_outline(
        &mut self,
        moves: Vec<OutlineElement>,
        named: Span,
        start: Vec2,
    ) -> Option<Outline> {
        let tolerance = self.control.parameters.rules.arc.radius_error_tolerance_mm;
        let last = moves.last().map_or(start, OutlineElement::to);
        let (message, help) = match Outline::new(moves.into_iter().skip(1).collect(), tolerance) {
            Ok(outline) => return Some(outline),
            Err(OutlineError::Open(_)) if last.distance(start) <= tolerance => (
                "the outline goes back to the start hole".to_string(),
                "end it at its start; the cycle itself returns to the hole",
            ),
            Err(OutlineError::Open(gap)) => (
                format!("the outline ends {} away from its start", self.kernel.length_text(gap)),
                "the first move goes from the start hole to the outline, the last one ends there",
            ),
            Err(OutlineError::CrossesItself(point)) => {
                let (x, y) = (self.kernel.length_text(point.a), self.kernel.length_text(point.b));
                (
                    format!("the outline crosses or touches itself at X {x}, Y {y}"),
                    "an outline is one simple loop; cut islands separately",
                )
            }
            Err(OutlineError::Empty) => (
                "the outline encloses nothing".to_string(),
                "write its moves after the move from the start hole to the outline",
            ),
        };
        self.report_outline(named, message, help);
        None
    }

    fn wrong_outline(&mut self, block: &Block, message: String, help: &str) -> OutlineBlock {
        self.report_outline(self.span(block.range), message, help);
        OutlineBlock::Wrong
    }

    pub(super) fn report_outline(&mut self, span: Span, message: String, help: &str) {
        self.kernel.report(
            Diagnostic::new(Code::PocketGeometry, span, message)
                .label("the pocket is not carried out")
                .help(help),
        );
    }
}
