//! When a block makes holes, how many, and what ends a cycle.

use chordal_diagnostics::{Code, Diagnostic};
use chordal_syntax::Block;

use super::super::Interpreter;
use super::levels::Hole;
use crate::command::{AxisMask, Position};
use crate::cycle_rules::{DefinitionFires, FiringWords, ZeroRepeats};
use crate::state::{CycleState, Motion};
use crate::table::CycleKind;

impl Interpreter<'_> {
    /// A block with a cycle code.
    pub(in super::super) fn start_cycle(&mut self, block: &Block, kind: CycleKind) {
        let axis = self.drilling_axis();
        let before = self.state.cycle.filter(|cycle| cycle.axis == axis);
        // The initial level stays while one cycle follows another.
        let initial = before.map_or(self.state.position[axis], |cycle| cycle.initial);
        let keeps = self.control.parameters.cycles.keeps_words;
        let kept = before.filter(|cycle| keeps || cycle.kind == kind);
        let cycle = kept.unwrap_or(CycleState::new(kind, axis, initial));
        let mut cycle = CycleState { kind, ..cycle };
        if kind.is_tap() && self.control.parameters.cycles.tap.keeps_dwell {
            cycle.dwell_s = self.state.cycle_dwell_s;
        }
        self.state.cycle = Some(cycle);
        self.cycle_block(block, true);
    }

    /// A block while a cycle is in force: a hole where it names a place.
    pub(in super::super) fn next_hole(&mut self, block: &Block) {
        self.cycle_block(block, false);
    }

    /// Takes the words of a block and makes the holes that it asks for.
    fn cycle_block(&mut self, block: &Block, definition: bool) {
        let Some(mut cycle) = self.state.cycle else { return };
        self.take_cycle_words(block, &mut cycle);
        cycle.fired = false;
        self.state.cycle = Some(cycle);
        let (target, named) = self.target(block);
        let Some(repeats) = self.cycle_repeats(block) else { return };
        let place = named.without(AxisMask(1 << cycle.axis));
        let rules = self.control.parameters.cycles;
        if repeats == 0 {
            if rules.zero_repeats == ZeroRepeats::PlaceOnly && place != AxisMask::NONE {
                self.go_to_place(target, place, cycle.axis);
            }
            return;
        }
        if !self.block_fires(block, named, place, definition) {
            self.check_idle_block(block, named, definition);
            if place != AxisMask::NONE {
                self.go_to_place(target, place, cycle.axis);
            }
            return;
        }
        let Some(hole) = self.resolve_hole(block) else { return };
        if let Some(cycle) = &mut self.state.cycle {
            cycle.fired = true;
        }
        self.warn_of_doubtful_cycle(block, definition, hole.words.kind);
        self.drill(block, &hole, target, place);
        for _ in 1..repeats {
            if !self.count_repeated() {
                return;
            }
            let (target, _) = self.target(block);
            self.drill(block, &hole, target, place);
        }
    }

    fn block_fires(
        &self,
        block: &Block,
        named: AxisMask,
        place: AxisMask,
        definition: bool,
    ) -> bool {
        let rules = &self.control.parameters.cycles;
        let by_place = place != AxisMask::NONE;
        let by_level = block.letters().has(b'R') || named != AxisMask::NONE;
        match (definition, rules.definition, rules.fires_on) {
            (true, DefinitionFires::Never, _) => false,
            (true, DefinitionFires::WithPlace, _) | (false, _, FiringWords::Place) => by_place,
            (_, _, FiringWords::AnyAxis) => named != AxisMask::NONE,
            (true, DefinitionFires::Always, _) | (false, _, FiringWords::AxisOrLevel) => by_level,
        }
    }

    /// A block that makes no hole although it looks as if it should.
    fn check_idle_block(&mut self, block: &Block, named: AxisMask, definition: bool) {
        let any_axis = self.control.parameters.cycles.fires_on == FiringWords::AnyAxis;
        if !any_axis || named != AxisMask::NONE {
            return;
        }
        if definition {
            let span = self.span(block.range);
            let message = "a canned cycle without any axis word".to_string();
            self.missing_word(span, message, "write the position or the depth into the block");
        } else if let Some(word) = block.last(b'R').copied() {
            self.unused_word(&word);
        }
    }

    fn warn_of_doubtful_cycle(&mut self, block: &Block, definition: bool, kind: CycleKind) {
        if definition && kind == CycleKind::BoreInOut {
            let span = self.span(block.range);
            self.report(
                Diagnostic::new(
                    Code::CycleNotDocumented,
                    span,
                    "no manual was found that says what this cycle does; shown as boring with feed out",
                )
                .help("try it above the part, or write G85"),
            );
        }
    }

    /// How often the block makes its hole; `None` where the control refuses it.
    fn cycle_repeats(&mut self, block: &Block) -> Option<u32> {
        let rules = self.control.parameters.cycles;
        let letter = rules.repeat_letter;
        if !block.letters().has(letter) {
            return Some(1);
        }
        let word = *block.last(letter)?;
        let count = self.count(&word).unwrap_or(1);
        if count == 0 && rules.zero_repeats == ZeroRepeats::Refused {
            self.report(
                Diagnostic::new(
                    Code::CycleZeroRepeats,
                    self.span(word.range),
                    "a cycle cannot be repeated zero times",
                )
                .help(format!("remove {}, or write 1 or more", letter as char)),
            );
            return None;
        }
        Some(self.cut_to_limit(&word, count))
    }

    /// M45: the cycle in force, or the routine of G66, where the tool stands.
    pub(in super::super) fn run_cycle_here(&mut self, block: &Block, at: usize) {
        if self.state.cycle.is_some_and(|cycle| cycle.fired) {
            return;
        }
        if self.state.cycle.is_some() {
            let place = self.state.position;
            self.fire_hole_at(block, place);
        } else if !self.run_modal_call_here() {
            let span = self.span(block.words[at].range);
            self.report_no_cycle(span, "there is no active cycle to run here");
        }
    }

    pub(super) fn report_no_cycle(&mut self, span: chordal_diagnostics::Span, message: &str) {
        self.report(
            Diagnostic::new(Code::NoCycle, span, message)
                .label("nothing is drilled")
                .help("define the cycle (G81 …) in a block before this one"),
        );
    }

    /// One hole of the cycle in force at a place (program coordinates; the drilling axis is
    /// left out of account). False where the control refuses the hole.
    pub(in super::super) fn fire_hole_at(&mut self, block: &Block, place: Position) -> bool {
        let Some(hole) = self.resolve_hole(block) else { return false };
        self.drill_at(block, &hole, place);
        true
    }

    /// The same, for a hole that is resolved once and made at many places.
    pub(super) fn drill_at(&mut self, block: &Block, hole: &Hole, place: Position) {
        let named = self.state.known.without(AxisMask(1 << hole.axis));
        self.drill(block, hole, place, named);
    }

    /// G80.
    pub(in super::super) fn cancel_cycle(&mut self) {
        self.state.cycle = None;
        if self.control.parameters.cycles.one_group_with_motion {
            self.state.motion = Motion::None;
        }
    }

    /// Something other than G80 that ends a cycle on this control.
    pub(in super::super) fn end_cycle_if(&mut self, ends: bool) {
        if ends {
            self.state.cycle = None;
        }
    }
}
