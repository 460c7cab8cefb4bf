//! Words with another meaning while a cycle is active: on a Fadal L for calls and bolt circles and F for tap speeds;
//! and the modal subroutine of G66.

use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_dialect::{Action, CodeGroup, CodeRow, ModeCode};
use chordal_kernel::rules::CycleKind;
use chordal_kernel::rules::TapFeed;
use chordal_machine::AXIS_LETTERS;
use chordal_syntax::{Block, Letters, Word};

use super::super::Interpreter;

const AXIS_WORDS: Letters = Letters::of(AXIS_LETTERS);

impl Interpreter<'_> {
    /// True for two groups that are one group on this control.
    pub(in super::super) fn one_group(&self, first: CodeGroup, second: CodeGroup) -> bool {
        let motion = |group| matches!(group, CodeGroup::Motion | CodeGroup::Cycle);
        let joined = self.control.parameters.rules.cycles.one_group_with_motion;
        first == second || joined && motion(first) && motion(second)
    }

    /// True for G80 with a motion or a cycle in one block, on controls where they are one group: G80 is then ignored.
    pub(in super::super) fn is_cycle_cancel_with_motion(
        &self,
        first: &CodeRow,
        second: &CodeRow,
    ) -> bool {
        let off = |row: &CodeRow| row.action == Action::Mode(ModeCode::CancelCycle);
        self.control.parameters.rules.cycles.one_group_with_motion && off(first) != off(second)
    }

    /// True when the cycle of this block, or else the active one, is a tap.
    fn is_about_tap(&self, codes: &[(&'static CodeRow, usize)]) -> bool {
        let own = codes.iter().rev().find(|(row, _)| row.group == CodeGroup::Cycle);
        match own.map(|(row, _)| row.action) {
            Some(Action::Cycle(kind)) => kind.is_tap(),
            Some(_) => false,
            None => self.kernel.state.cycle.is_some_and(|cycle| cycle.kind.is_tap()),
        }
    }

    /// True when F of this block is the speed of a tap (Fadal Format 1), not a feed.
    pub(in super::super) fn feed_is_tap_speed(&self, codes: &[(&'static CodeRow, usize)]) -> bool {
        let by_lead = self.control.parameters.rules.cycles.tap.feed == TapFeed::SpeedWithLeadQ;
        by_lead && self.is_about_tap(codes)
    }

    /// True when `,R` of this block belongs to a tap (synchronous or not), not to a rounding.
    pub(in super::super) fn tap_stands_in(&self, block: &Block) -> bool {
        let own = block.all(b'G').find_map(|word| {
            let code = word.number().and_then(chordal_dialect::code_number)?;
            self.control.g_code(code)?.action.cycle().map(CycleKind::is_tap)
        });
        own.unwrap_or_else(|| self.kernel.state.cycle.is_some_and(|cycle| cycle.kind.is_tap()))
    }

    /// True when L in this block repeats holes of the cycle; it may still be a call.
    pub(in super::super) fn cycle_counts_in_l(
        &self,
        block: &Block,
        codes: &[(&'static CodeRow, usize)],
    ) -> bool {
        let takes = |row: &CodeRow| row.words.has(b'L') && row.group != CodeGroup::Cycle;
        block.letters().has(b'L') && !codes.iter().any(|(row, _)| takes(row))
    }

    /// Makes the hole of a block that also calls a subroutine: L is then not its repeat count.
    pub(in super::super) fn next_hole_with_call(&mut self, block: &Block) {
        if block.letters().meets(AXIS_WORDS) {
            let (target, _) = self.target(block);
            self.kernel.fire_hole_at(&self.at(block), target);
        }
    }

    /// L93NN: the active cycle at NN positions on a circle about the present one.
    pub(in super::super) fn bolt_circle(&mut self, block: &Block, word: &Word, count: u32) {
        let span = self.span(word.range);
        if self.kernel.state.cycle.is_none() {
            return self
                .kernel
                .report_no_cycle(span, "a bolt circle (L93) without an active cycle");
        }
        let [radius, angle] = self.control.parameters.rules.cycles.bolt_circle;
        let zero = chordal_syntax::Decimal::integer(0);
        let register = |number: u8| self.registers[number as usize].unwrap_or(zero);
        let radius_mm = self.scale.length(register(radius));
        let first = register(angle).to_f64();
        let text = self.kernel.length_text(radius_mm);
        self.kernel.report(
            Diagnostic::new(
                Code::CycleNotDocumented,
                span,
                format!("the words of L93 are not documented: shown with R{radius} as radius"),
            )
            .severity(Severity::Warning)
            .label(format!("{count} holes, radius {text}, first angle R{angle} = {first}°"))
            .help("set `L93 radius` and `L93 angle` in the machine file to the right registers"),
        );
        if radius_mm <= 0.0 || count == 0 {
            return self.report_pattern_words(block, "a radius and a number of holes");
        }
        let (target, named) = self.target(block);
        if named != chordal_command::AxisMask::NONE {
            self.kernel.go_to_place(target, named, self.kernel.drilling_axis());
        }
        let step = 360.0 / f64::from(count);
        self.kernel.holes_about_here(&self.at(block), count, |index| {
            (radius_mm, first + f64::from(index) * step)
        });
    }

    /// Warns of a repeated line under G66, where the control would run the subroutine after each pass.
    pub(in super::super) fn warn_of_repeated_modal_subroutine(
        &mut self,
        block: &Block,
        times: u32,
    ) {
        if times < 2 || self.macros.active == 0 || !block.letters().meets(AXIS_WORDS) {
            return;
        }
        let span = self.words_span(block, Letters::of("L"));
        self.kernel.report(
            Diagnostic::new(
                Code::NotFollowed,
                span,
                "the subroutine of G66 runs once for this repeated line, not after each pass",
            )
            .help("write the positions out, one per block"),
        );
    }
}
