//! G33 and G33.1: straight cuts synchronized with the spindle.

use chordal_command::{AxisMask, Position, SpindleState};
use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_dialect::table::TurnFault;
use chordal_syntax::{Block, Letters};

use super::Interpreter;

impl Interpreter<'_> {
    /// Carries out G33, or G33.1 (`back`: the tool returns with the spindle reversed, I times as fast). K is the advance
    /// per revolution along the path.
    pub(super) fn thread_block(
        &mut self,
        block: &Block,
        target: Position,
        named: AxisMask,
        back: bool,
    ) {
        if self.control.parameters.thread_lead == b'F' {
            return self.thread_by_feed(block, target, named);
        }
        if named == AxisMask::NONE {
            if block.letters().has(b'K') {
                let name = if back { "G33.1" } else { "G33" };
                let span = self.span(block.range);
                let message = format!("{name} without an end point");
                self.report_refused(
                    Diagnostic::new(Code::MissingWord, span, message).help("name an axis"),
                    "All axes missing with motion code",
                );
            }
            return;
        }
        let title = self.control.table.title;
        let name = if back { "G33.1" } else { "G33" };
        let span = self.span(block.range);
        if !block.letters().has(b'K') {
            self.kernel.report(
                Diagnostic::new(Code::MissingWord, span, format!("{name} without K"))
                    .label("nothing moves in this block")
                    .alarm(format!("{title}: K word missing with g33/g33.1"))
                    .help("give the advance per revolution with K in each block"),
            );
            return;
        }
        let Some(lead) = self.length_of(block, b'K') else { return };
        let turns = matches!(self.kernel.state.spindle, SpindleState::Cw | SpindleState::Ccw);
        let no_speed = self.kernel.state.rpm <= 0.0 && !self.kernel.state.unknown.speed;
        if !turns || no_speed {
            self.kernel.report(
                Diagnostic::new(
                    Code::SpindleStopped,
                    span,
                    format!("{name} moves in step with the spindle, which does not turn"),
                )
                .severity(Severity::Error)
                .alarm(format!("{title}: Spindle not turning in {name}"))
                .help("start the spindle (S… M3) before"),
            );
        }
        if lead == 0.0 {
            let span = self.words_span(block, Letters::of("K"));
            self.kernel.report(
                Diagnostic::new(
                    Code::BadWordValue,
                    span,
                    format!("{name} with an advance of zero"),
                )
                .help("give the advance per revolution with K"),
            );
        }
        if back {
            let factor = block.last(b'I').and_then(|word| self.literal(word));
            let factor = factor.map_or(1.0, |number| number.to_f64());
            self.kernel.check_lead(&self.at(block), lead.abs(), "K makes");
            if factor > 1.0 {
                let rpm = self.kernel.state.rpm * factor;
                self.kernel.check_cycle_speed(&self.at(block), rpm, "the way out of G33.1");
            }
            self.kernel.rigid_tap(target, named, lead.abs(), factor);
        } else {
            self.kernel.thread(target, named, lead.abs());
        }
    }

    /// G34: K is the change of the lead per revolution. Returns the constant lead with the same time, and the change, mm;
    /// `None` when the lead would reach zero, which is reported.
    fn mean_lead(&mut self, block: &Block, target: Position, lead: f64) -> Option<[f64; 2]> {
        if !block.letters().has(b'K') {
            return Some([lead, 0.0]);
        }
        let change = self.length_of(block, b'K')?;
        let from = self.kernel.state.position;
        let length = (target[0] - from[0]).abs().max((target[2] - from[2]).abs());
        // The advance after n turns is lead·n + change·n² / 2, so the last lead is √(lead² + 2·change·length).
        let last = lead * lead + 2.0 * change * length;
        if last <= 0.0 {
            let span = self.words_span(block, Letters::of("K"));
            let text = self.kernel.length_text(-lead * lead / (2.0 * change));
            let message = format!("the lead falls to nothing after {text} of this thread");
            self.refuse_cycle(span, message, "make K smaller", TurnFault::Lead);
            return None;
        }
        Some([(lead + last.sqrt()) / 2.0, change])
    }

    /// Cuts a thread in one pass with the lead F, along the axis that moves more.
    fn thread_by_feed(&mut self, block: &Block, target: Position, named: AxisMask) {
        if named == AxisMask::NONE {
            return;
        }
        let Some(lead) = self.lead_by_feed(block) else { return };
        let Some(lead) = self.mean_lead(block, target, lead) else { return };
        self.kernel.turned_thread(&self.at(block), target, lead);
    }
}
