//! Decides when a block makes holes, and how many.

use chordal_command::AxisMask;
use chordal_diagnostics::{Code, Diagnostic};
use chordal_kernel::CycleState;
use chordal_kernel::rules::{CycleKind, DefinitionFires, DrillingAxis, FiringWords, ZeroRepeats};
use chordal_syntax::Block;

use super::super::Interpreter;

impl Interpreter<'_> {
    /// Carries out a block with a cycle code; `radial` for a code that drills along X.
    pub(in super::super) fn start_cycle(&mut self, block: &Block, kind: CycleKind, radial: bool) {
        let axis = match self.control.parameters.rules.cycles.axis {
            DrillingAxis::OfCode if radial => 0,
            DrillingAxis::OfCode => 2,
            DrillingAxis::AlwaysZ | DrillingAxis::PlaneNormal => self.kernel.drilling_axis(),
        };
        let before = self.kernel.state.cycle.filter(|cycle| cycle.axis == axis);
        // The initial level is kept when one cycle follows another.
        let initial = before.map_or(self.kernel.state.position[axis], |cycle| cycle.initial);
        let keeps = self.control.parameters.rules.cycles.keeps_words;
        let kept = before.filter(|cycle| keeps || cycle.kind == kind);
        let cycle = kept.unwrap_or(CycleState::new(kind, axis, initial));
        let mut cycle = CycleState { kind, ..cycle };
        if kind.is_tap() && self.control.parameters.rules.cycles.tap.keeps_dwell {
            cycle.dwell_s = self.kernel.state.cycle_dwell_s;
        }
        self.kernel.state.cycle = Some(cycle);
        self.cycle_block(block, true);
    }

    /// Carries out a block while a cycle is active: a hole if it gives a position.
    pub(in super::super) fn next_hole(&mut self, block: &Block) {
        self.cycle_block(block, false);
    }

    /// Reads the words of a block and makes its holes.
    fn cycle_block(&mut self, block: &Block, definition: bool) {
        let Some(mut cycle) = self.kernel.state.cycle else { return };
        self.take_cycle_words(block, &mut cycle);
        cycle.fired = false;
        self.kernel.state.cycle = Some(cycle);
        let (target, named) = self.target(block);
        if self.kernel.state.frame_jump.is_some() {
            self.kernel.check_first_after_frame(&self.at(block), &target, named);
        }
        let Some(repeats) = self.cycle_repeats(block) else { return };
        let place = named.without(AxisMask(1 << cycle.axis));
        let rules = self.control.parameters.rules.cycles;
        if repeats == 0 {
            if rules.zero_repeats == ZeroRepeats::PlaceOnly && place != AxisMask::NONE {
                self.kernel.go_to_place(target, place, cycle.axis);
            }
            return;
        }
        if !self.block_fires(block, named, place, definition) {
            self.check_idle_block(block, named, definition);
            self.check_idle_count(block, repeats, definition);
            if place != AxisMask::NONE {
                self.kernel.go_to_place(target, place, cycle.axis);
            }
            return;
        }
        let Some(hole) = self.kernel.resolve_hole(&self.at(block)) else { return };
        if let Some(cycle) = &mut self.kernel.state.cycle {
            cycle.fired = true;
        }
        self.warn_of_doubtful_cycle(block, definition, hole.words.kind);
        self.check_unused_peck(block, &hole.words);
        if definition {
            self.kernel.check_cycle_in_frame(&self.at(block), cycle.axis);
        }
        self.kernel.drill(&self.at(block), &hole, target, place);
        for _ in 1..repeats {
            if !self.kernel.count_repeated() {
                return;
            }
            let (target, _) = self.target(block);
            self.kernel.drill(&self.at(block), &hole, target, place);
        }
    }

    fn block_fires(
        &self,
        block: &Block,
        named: AxisMask,
        place: AxisMask,
        definition: bool,
    ) -> bool {
        let rules = &self.control.parameters.rules.cycles;
        let by_place = place != AxisMask::NONE;
        let by_level = block.letters().has(b'R') || named != AxisMask::NONE;
        match (definition, rules.definition, rules.fires_on) {
            (true, DefinitionFires::Never, _) => false,
            (true, DefinitionFires::WithPlace, _) | (false, _, FiringWords::Place) => by_place,
            (_, _, FiringWords::AnyAxis) => named != AxisMask::NONE,
            (true, DefinitionFires::Always, _) | (false, _, FiringWords::AxisOrLevel) => by_level,
        }
    }

    /// Reports a block that makes no hole although it seems to.
    fn check_idle_block(&mut self, block: &Block, named: AxisMask, definition: bool) {
        let any_axis = self.control.parameters.rules.cycles.fires_on == FiringWords::AnyAxis;
        if !any_axis || named != AxisMask::NONE {
            return;
        }
        if definition {
            let span = self.span(block.range);
            let message = "a canned cycle without any axis word".to_string();
            self.kernel.missing_word(
                span,
                message,
                "write the position or the depth into the block",
            );
        } else if let Some(word) = block.last(b'R').copied() {
            self.unused_word(&word);
        }
    }

    /// Reports a repeat count in a block that makes no hole.
    fn check_idle_count(&mut self, block: &Block, repeats: u32, definition: bool) {
        let letter = self.control.parameters.rules.cycles.repeat_letter;
        if !definition
            && repeats > 1
            && let Some(word) = block.last(letter).copied()
        {
            self.unused_word(&word);
        }
    }

    fn warn_of_doubtful_cycle(&mut self, block: &Block, definition: bool, kind: CycleKind) {
        if definition && kind == CycleKind::BoreInOut {
            let span = self.span(block.range);
            self.kernel.report(
                Diagnostic::new(
                    Code::CycleNotDocumented,
                    span,
                    "no manual was found that says what this cycle does; shown as boring with feed out",
                )
                .help("try it above the part, or write G85"),
            );
        }
    }

    /// Reports Q when I, J and K give the peck depths.
    fn check_unused_peck(&mut self, block: &Block, words: &CycleState) {
        let decreasing = self.control.parameters.rules.cycles.peck.decreasing;
        let by_steps = words.vector[0].is_some_and(|first| first != 0.0);
        if decreasing
            && by_steps
            && words.kind.is_peck()
            && words.q.is_some()
            && let Some(word) = block.last(b'Q').copied()
        {
            self.unused_word(&word);
        }
    }

    /// The number of holes of the block; `None` when the control refuses it.
    fn cycle_repeats(&mut self, block: &Block) -> Option<u32> {
        let rules = self.control.parameters.rules.cycles;
        let letter = rules.repeat_letter;
        if !block.letters().has(letter) {
            return Some(1);
        }
        let word = *block.last(letter)?;
        let count = self.count(&word).unwrap_or(1);
        if count == 0 && rules.zero_repeats == ZeroRepeats::Refused {
            self.kernel.report(
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

    /// M45: runs the active cycle, or the subroutine of G66, at the present position.
    pub(in super::super) fn run_cycle_here(&mut self, block: &Block, at: usize) {
        if self.kernel.state.cycle.is_some_and(|cycle| cycle.fired) {
            return;
        }
        if self.kernel.state.cycle.is_some() {
            let place = self.kernel.state.position;
            self.kernel.fire_hole_at(&self.at(block), place);
        } else if !self.run_modal_call_here() {
            let span = self.span(block.words[at].range);
            self.kernel.report_no_cycle(span, "there is no active cycle to run here");
        }
    }
}
