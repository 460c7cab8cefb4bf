//! Drilling cycles along Z: levels, firing, pecks, returns.

use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_geometry::Plane;
use chordal_syntax::{Block, Letters};

use super::Interpreter;
use crate::command::{AxisMask, CommandKind, Feed, FeedAlong, Position, Sink, SpindleState};
use crate::state::CycleState;
use crate::table::CycleKind;

/// A depth that misses the last peck by less than this, mm, is that peck.
const DEPTH_EPSILON_MM: f64 = 1e-9;

/// Most pecks of one hole: more is a slip in Q.
const MAX_PECKS: u32 = 10_000;

impl<S: Sink> Interpreter<'_, S> {
    /// A block with a cycle code.
    pub(super) fn start_cycle(&mut self, block: &Block, kind: CycleKind) {
        let kept = self.state.cycle.filter(|cycle| cycle.kind == kind);
        let initial = self.state.cycle.map_or(self.state.position[2], |cycle| cycle.initial);
        self.state.cycle = Some(kept.unwrap_or(CycleState {
            kind,
            initial,
            r: None,
            z: None,
            q: None,
            dwell_s: 0.0,
        }));
        if let Some(cycle) = &mut self.state.cycle {
            cycle.initial = initial;
        }
        self.next_hole(block);
    }

    /// A block while a cycle is in force: a hole where it names a place.
    pub(super) fn next_hole(&mut self, block: &Block) {
        let Some(mut cycle) = self.state.cycle else { return };
        let letters = block.letters();
        let fires = letters.meets(Letters::of("XY"))
            || letters.has(b'Z') && letters.has(b'G') && self.control.table.lexicon.o_words;
        self.take_levels(block, &mut cycle);
        self.state.cycle = Some(cycle);
        if !fires && !letters.has(b'Z') {
            return;
        }
        if self.state.plane != Plane::Xy {
            let span = self.span(block.range);
            self.report(
                Diagnostic::new(
                    Code::NotSimulated,
                    span,
                    "cycles outside G17 are not carried out by this version",
                )
                .severity(Severity::Warning),
            );
            return;
        }
        let (Some(r), Some(z)) = (cycle.r, cycle.z) else {
            let span = self.span(block.range);
            let message = "a drilling cycle without its levels".to_string();
            return self.missing_word(span, message, "give the R level and the depth Z");
        };
        let repeat_letter = self.control.table.cycle_repeat;
        let repeats = match letters.has(repeat_letter) {
            true => self.count_of(block, repeat_letter).unwrap_or(1),
            false => 1,
        };
        let limit = self.control.parameters.max_repeats;
        for pass in 0..repeats.min(limit) {
            if pass > 0 && !self.count_repeated() {
                return;
            }
            self.hole(block, &cycle, r, z);
        }
    }

    fn take_levels(&mut self, block: &Block, cycle: &mut CycleState) {
        let relative = self.state.incremental && self.control.table.cycle_levels_incremental;
        let r_word = self.radius_word(block);
        if let Some(value) = r_word.and_then(|word| self.length(&word)) {
            cycle.r = Some(if relative { cycle.initial + value } else { value });
        }
        if let Some(value) = self.length_of(block, b'Z') {
            let base = cycle.r.unwrap_or(cycle.initial);
            cycle.z = Some(if relative { base + value } else { value });
        }
        if let Some(value) = self.length_of(block, b'Q') {
            cycle.q = Some(value.abs());
        }
        if let Some(number) = block.last(b'P').and_then(|word| self.literal(word)) {
            let unit = if number.has_point && self.control.table.dwell[0].point_s == 1.0 {
                1.0
            } else {
                self.control.table.cycle_dwell_s
            };
            cycle.dwell_s = number.to_f64() * unit;
        }
    }

    fn hole(&mut self, block: &Block, cycle: &CycleState, r: f64, z: f64) {
        self.origin.cycle = true;
        let (mut place, named) = self.target(block);
        place[2] = self.state.position[2];
        let named = named.without(AxisMask(0b100));
        if place != self.state.position {
            self.cycle_rapid(place, named);
        }
        self.z_rapid(r);
        let clear = if self.state.return_to_r { r } else { cycle.initial.max(r) };
        match cycle.kind {
            CycleKind::Peck => self.pecks(block, cycle, r, z, true),
            CycleKind::ChipBreak => self.pecks(block, cycle, r, z, false),
            _ => self.z_feed(block, z),
        }
        self.leave_hole(block, cycle, r, clear);
        self.origin.cycle = false;
    }

    fn leave_hole(&mut self, block: &Block, cycle: &CycleState, r: f64, clear: f64) {
        let spindle = self.state.spindle;
        match cycle.kind {
            CycleKind::Drill | CycleKind::Peck | CycleKind::ChipBreak => {}
            CycleKind::DrillDwell => self.wait(cycle.dwell_s),
            CycleKind::BoreFeedOut => self.z_feed(block, r),
            CycleKind::BoreDwell => {
                self.wait(cycle.dwell_s);
                self.z_feed(block, r);
            }
            CycleKind::Tap | CycleKind::LeftTap => {
                self.turn_spindle(SpindleState::Off);
                self.wait(cycle.dwell_s);
                let reversed = match cycle.kind {
                    CycleKind::Tap => SpindleState::Ccw,
                    _ => SpindleState::Cw,
                };
                self.turn_spindle(reversed);
                self.z_feed(block, r);
                self.turn_spindle(spindle);
            }
            CycleKind::BoreStop => {
                self.wait(cycle.dwell_s);
                self.turn_spindle(SpindleState::Off);
            }
            CycleKind::BoreManual | CycleKind::FineBore | CycleKind::BackBore => {
                let span = self.span(block.range);
                self.report(Diagnostic::new(
                    Code::NotSimulated,
                    span,
                    "the shift and the spindle orientation of this cycle are not carried out",
                ));
            }
        }
        self.z_rapid(clear);
        if cycle.kind == CycleKind::BoreStop {
            self.turn_spindle(spindle);
        }
    }

    fn pecks(&mut self, block: &Block, cycle: &CycleState, r: f64, z: f64, full: bool) {
        let Some(q) = cycle.q.filter(|q| *q > 0.0) else {
            if cycle.q.is_none() {
                let span = self.span(block.range);
                let message = "a pecking cycle without Q".to_string();
                self.missing_word(span, message, "give the depth of a peck with Q");
            }
            return self.z_feed(block, z);
        };
        let clearance = match full {
            true => self.control.parameters.peck_clearance_mm,
            false => self.control.parameters.chip_break_mm,
        };
        for peck in 1..=MAX_PECKS {
            let depth = r - f64::from(peck) * q;
            if depth <= z + DEPTH_EPSILON_MM || peck == MAX_PECKS {
                return self.z_feed(block, z);
            }
            self.z_feed(block, depth);
            if full {
                self.z_rapid(r);
            }
            self.z_rapid((depth + clearance).min(r));
        }
    }

    fn wait(&mut self, seconds: f64) {
        if seconds > 0.0 {
            self.emit(CommandKind::Dwell { seconds });
        }
    }

    fn turn_spindle(&mut self, spindle: SpindleState) {
        if self.state.spindle != spindle {
            self.state.spindle = spindle;
            let rpm = if spindle == SpindleState::Off { 0.0 } else { self.state.rpm };
            self.emit(CommandKind::Spindle { state: spindle, rpm });
        }
    }

    fn cycle_rapid(&mut self, target: Position, named: AxisMask) {
        let motion = self.moved_to(target, named);
        let path = self.control.parameters.rapid;
        self.emit(CommandKind::Rapid { motion, path });
    }

    fn z_rapid(&mut self, z: f64) {
        if z == self.state.position[2] {
            return;
        }
        let mut target = self.state.position;
        target[2] = z;
        self.cycle_rapid(target, AxisMask(0b100));
    }

    fn z_feed(&mut self, block: &Block, z: f64) {
        let mut target = self.state.position;
        target[2] = z;
        let motion = self.moved_to(target, AxisMask(0b100));
        let mut feed: Feed = self.feed_for(block, &motion);
        feed.along = FeedAlong::Path;
        self.emit(CommandKind::Line { motion, feed });
    }
}
