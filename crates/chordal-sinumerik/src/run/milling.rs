//! Carries out the milling cycles.

use chordal_command::{AxisMask, CompensationSide};
use chordal_diagnostics::{Code, Diagnostic, TextRange};
use chordal_geometry::{Plane, TurnDirection};

use super::arcs::PlaneArc;
use super::drilling::spindle_code;
use super::interpreter::Interpreter;
use super::motion::BlockTarget;
use super::words::{BlockStatementView, BlockWords, ValueWord};
use crate::alarms::NO_ALARM;
use crate::cycles::{CycleArguments, MillStep, MillingContext, MillingMoves, milling_moves};

impl Interpreter<'_> {
    /// Carries out a milling cycle.
    pub(super) fn run_milling(&mut self, name: &str, arguments: &CycleArguments, range: TextRange) {
        if !self.has_edge_for_cycle(name, range) {
            return;
        }
        if self.kernel.state.side != CompensationSide::Off {
            let message =
                format!("{name} offsets by the tool radius itself: end the compensation before it");
            return self.alarm(61815, Code::CycleInCompensation, range, message);
        }
        match milling_moves(name, arguments, &self.milling_context(name)) {
            Ok(moves) => {
                self.report_milling(name, &moves, range);
                self.mill(&moves.steps, range);
            }
            Err(fault) if fault.alarm == NO_ALARM => {
                let message = format!("{}: what {name} cuts is missing here", fault.message);
                self.lose_cycle(range, message);
            }
            Err(fault) => self.report_cycle(fault, range),
        }
    }

    /// The radius of the active edge, mm; `None` when it is not known.
    pub(super) fn edge_radius_mm(&self) -> Option<f64> {
        let state = &self.kernel.state;
        let number = state.radius_offset.filter(|number| *number > 0)?;
        state.offsets.radius_mm(number)
    }

    fn milling_context(&self, name: &str) -> MillingContext {
        let state = &self.kernel.state;
        let unit_mm = self.unit_mm();
        let (a, b, normal) = state.plane.axes();
        let place = self.programmed_position();
        MillingContext {
            position: [a, b, normal].map(|axis| place[axis] / unit_mm),
            unit_mm,
            tool_radius: self.edge_radius_mm().map(|radius| radius / unit_mm),
            has_feed: state.unknown.feed || state.feed.is_some_and(|feed| feed > 0.0),
            spindle_direction: spindle_code(state.spindle),
            plane_code: match state.plane {
                Plane::Xy => 17,
                Plane::Zx => 18,
                Plane::Yz => 19,
            },
            is_modal: self.modal_call.as_ref().is_some_and(|modal| modal.name == name),
            ..MillingContext::default()
        }
    }

    /// What is not sure about a cycle, and what it does otherwise than the program asks.
    fn report_milling(&mut self, name: &str, moves: &MillingMoves, range: TextRange) {
        if !moves.steps.is_empty() {
            self.report_assumed_path(name, range);
        }
        if let Some(radius) = moves.enlarged_corner {
            let radius = self.kernel.length_text(radius * self.unit_mm());
            let message = format!(
                "the tool is too large for the corners of {name}: they get its radius, {radius}"
            );
            let diagnostic = Diagnostic::new(Code::PocketUnreached, self.span(range), message);
            let diagnostic = diagnostic.help("use a smaller tool, or finish the corners");
            // Older versions of the cycle refuse the tool.
            self.report_possible_alarm(61105, diagnostic);
        }
    }

    fn mill(&mut self, steps: &[MillStep], range: TextRange) {
        let rpm = self.kernel.state.rpm;
        self.kernel.origin.cycle = true;
        for step in steps {
            match *step {
                MillStep::Rapid(to) => {
                    let place = self.place_of(to);
                    self.rapid_to(place);
                }
                MillStep::Line { to, feed } => {
                    let place = self.place_of(to);
                    self.with_cycle_feed(feed, |own| own.feed_to(place, range, 1.0));
                }
                MillStep::Arc { center, direction, to, turns, feed } => {
                    let [a, b] = center.map(|coordinate| coordinate * self.unit_mm());
                    let place = self.place_of(to);
                    self.with_cycle_feed(feed, |own| {
                        own.cycle_arc(([a, b], direction), place, turns, range);
                    });
                }
                MillStep::SpindleSpeed(speed) => self.kernel.set_speed(speed.unwrap_or(rpm)),
            }
        }
        self.kernel.origin.cycle = false;
    }

    /// The programmed coordinates, mm, of a point of a cycle.
    fn place_of(&self, to: [f64; 3]) -> [f64; 3] {
        let (a, b, normal) = self.kernel.state.plane.axes();
        let unit = self.unit_mm();
        let mut place = [0.0; 3];
        (place[a], place[b], place[normal]) = (to[0] * unit, to[1] * unit, to[2] * unit);
        place
    }

    /// An arc of a cycle about a centre in the plane, programmed coordinates in mm.
    fn cycle_arc(
        &mut self,
        (center, direction): ([f64; 2], TurnDirection),
        programmed: [f64; 3],
        turns: u32,
        range: TextRange,
    ) {
        let start = self.programmed_position();
        self.kernel.state.place(AxisMask::LINEAR);
        let named = AxisMask::LINEAR;
        let target = BlockTarget { programmed, start, end: self.mapped(programmed), named };
        let turns = ValueWord { value: f64::from(turns), function: None, range };
        let words = BlockWords { others: vec![("TURN", turns)], ..BlockWords::default() };
        let view = BlockStatementView { span: self.span(range), words: &words };
        self.cut_arc(&view, range, &words, &target, &PlaneArc { center, direction });
    }
}
