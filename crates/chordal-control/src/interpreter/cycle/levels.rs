//! The words of a cycle, the levels they give, and what a control says when one is missing.

use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_geometry::Plane;
use chordal_syntax::{Block, Letters};

use super::super::Interpreter;
use crate::command::{FeedMode, Side};
use crate::cycle_rules::{
    BackBore, DrillingAxis, IncrementalLevels, LevelOrder, MissingLevel, TapFeed,
};
use crate::state::CycleState;
use crate::table::{Action, CycleKind};

/// Levels closer than this, mm, are one.
pub(super) const LEVEL_EPSILON_MM: f64 = 1e-9;

/// What is known of a hole before its place: the words in force and the levels.
#[derive(Clone, Copy)]
pub(in super::super) struct Hole {
    pub words: CycleState,
    /// Index of the drilling axis.
    pub axis: usize,
    pub r: f64,
    pub z: f64,
    /// Where the tool goes when the hole is done.
    pub clear: f64,
}

impl Interpreter<'_> {
    /// The index of the axis that cycles drill along.
    pub(super) fn drilling_axis(&self) -> usize {
        match (self.control.parameters.cycles.axis, self.state.plane) {
            (DrillingAxis::AlwaysZ, _) | (_, Plane::Xy) => 2,
            (_, Plane::Zx) => 1,
            (_, Plane::Yz) => 0,
        }
    }

    /// Whether a word of this block is read in G91; where G90 and G91 act from left to right
    /// that is a matter of its place.
    fn incremental_at(&self, block: &Block, letter: u8) -> bool {
        if !self.control.table.distance_left_to_right {
            return self.state.incremental;
        }
        let mut incremental = self.state.incremental;
        for word in &block.words {
            if word.letter == letter {
                break;
            }
            let code = (word.letter == b'G')
                .then(|| self.literal(word).and_then(crate::table::code_number))
                .flatten();
            match code.and_then(|code| self.control.g_code(code)).map(|row| row.action) {
                Some(Action::Absolute) => incremental = false,
                Some(Action::Incremental) => incremental = true,
                _ => {}
            }
        }
        incremental
    }

    /// Takes the words of a block into the cycle in force.
    pub(super) fn take_cycle_words(&mut self, block: &Block, cycle: &mut CycleState) {
        let rules = self.control.parameters.cycles;
        let letters = block.letters();
        let reads_again = rules.incremental == IncrementalLevels::ReadAgain;
        let from = |relative: bool, base: f64| if relative && !reads_again { base } else { 0.0 };
        if letters.has(b'R')
            && let Some(value) = self.radius_word(block).and_then(|word| self.length(&word))
        {
            let relative = rules.incremental == IncrementalLevels::WhenGiven
                && self.incremental_at(block, b'R');
            cycle.r = Some(value + from(relative, cycle.initial));
        }
        let axis = self.drilling_axis();
        let letter = b"XYZ"[axis];
        if letters.has(letter)
            && let Some(value) = self.length_of(block, letter)
        {
            let relative = self.incremental_at(block, letter);
            if relative && rules.incremental == IncrementalLevels::Refused {
                self.report_incremental_depth(block, letter);
            }
            let level = self.state.position[axis];
            let base = cycle.r.unwrap_or(level);
            let adds = relative && rules.incremental == IncrementalLevels::WhenGiven;
            cycle.z = Some(value + from(adds, base));
        }
        if letters.has(b'Q') {
            cycle.q = self.length_of(block, b'Q').or(cycle.q);
        }
        self.take_vector(block, cycle);
        if letters.has(b'P') {
            self.take_cycle_p(block, cycle);
        }
        if let Some(number) = block.last(b'E').and_then(|word| self.literal(word)) {
            cycle.after_rpm = Some(number.to_f64());
        }
        let is_speed = rules.tap.feed == TapFeed::SpeedWithLeadQ && cycle.kind.is_tap();
        if let Some(number) = block.last(b'F').and_then(|word| self.literal(word))
            && is_speed
        {
            cycle.tap_rpm = Some(number.to_f64());
        }
        for word in block.words.iter().filter(|word| word.comma && word.letter == b'R') {
            cycle.synchronous = self.literal(word).map(|number| number.mantissa != 0);
        }
    }

    /// I, J and K: a shift, the steps of pecks, the top of a bore, or how fast a tap leaves.
    fn take_vector(&mut self, block: &Block, cycle: &mut CycleState) {
        let rules = &self.control.parameters.cycles;
        let repeat_letter = rules.repeat_letter;
        let is_factor = rules.tap.out_factor_by_j && cycle.kind.is_tap();
        for (index, letter) in [b'I', b'J', b'K'].into_iter().enumerate() {
            if !block.letters().has(letter) || letter == repeat_letter {
                continue;
            }
            if is_factor {
                let number = block.last(letter).and_then(|word| self.literal(word));
                if letter == b'J' {
                    cycle.out_factor = number.map(|number| number.to_f64());
                }
                continue;
            }
            cycle.vector[index] = self.length_of(block, letter);
        }
    }

    /// P: a time, or on some controls a distance.
    fn take_cycle_p(&mut self, block: &Block, cycle: &mut CycleState) {
        let rules = &self.control.parameters.cycles;
        let is_distance = match cycle.kind {
            CycleKind::ChipBreak => rules.peck.p_is_lift,
            CycleKind::Peck => rules.peck.p_is_clearance,
            _ => false,
        };
        let (integer_s, point_s) = (rules.dwell_integer_s, rules.dwell_point_s);
        if is_distance {
            cycle.lift = self.length_of(block, b'P').map(f64::abs);
        } else if let Some(number) = block.last(b'P').and_then(|word| self.literal(word)) {
            let unit = if number.has_point { point_s } else { integer_s };
            cycle.dwell_s = Some((number.to_f64() * unit).max(0.0));
            self.state.cycle_dwell_s = cycle.dwell_s;
        }
    }

    /// The hole that the words in force make, or why the control makes none.
    pub(in super::super) fn resolve_hole(&mut self, block: &Block) -> Option<Hole> {
        let words = self.state.cycle?;
        if !self.may_drill(block) || !self.has_its_words(block, &words) {
            return None;
        }
        let rules = self.control.parameters.cycles;
        let axis = self.drilling_axis();
        let again = rules.incremental == IncrementalLevels::ReadAgain && self.state.incremental;
        let r = match words.r {
            Some(r) if again => words.initial + r,
            Some(r) => r,
            None => self.state.position[axis],
        };
        let z = words.z.map(|z| if again { r + z } else { z })?;
        // With R below the part there is no way out at R.
        let always_initial =
            words.kind == CycleKind::BackBore && rules.bore.back != BackBore::UpAndDown;
        let clear = match self.state.return_to_r && !always_initial {
            true => r,
            false => words.initial.max(r),
        };
        let hole = Hole { words, axis, r, z, clear };
        self.levels_in_order(block, &hole).then_some(hole)
    }

    /// Compensation, inverse time and rotary words forbid a cycle.
    fn may_drill(&mut self, block: &Block) -> bool {
        let span = self.span(block.range);
        if self.state.side != Side::Off {
            self.report(
                Diagnostic::new(
                    Code::CycleInCompensation,
                    span,
                    "a canned cycle while cutter compensation is on",
                )
                .label("no hole is made here")
                .help("cancel compensation with G40 before the cycle"),
            );
            return false;
        }
        if !self.control.parameters.cycles.strict {
            return true;
        }
        if self.state.feed_mode == FeedMode::InverseTime {
            self.report(
                Diagnostic::new(
                    Code::CycleInInverseTime,
                    span,
                    "a canned cycle while F is inverse time (G93)",
                )
                .help("write G94 and a feed per minute before the cycle"),
            );
            return false;
        }
        const ROTARY: Letters = Letters::of("ABC");
        if block.letters().meets(ROTARY) {
            let span = self.words_span(block, ROTARY);
            self.report(
                Diagnostic::new(Code::CycleRotaryWord, span, "a rotary axis in a canned cycle")
                    .help("turn the rotary axis in a block before the cycle"),
            );
            return false;
        }
        true
    }

    /// R, the depth, Q and P, where the control asks for them.
    fn has_its_words(&mut self, block: &Block, words: &CycleState) -> bool {
        let rules = self.control.parameters.cycles;
        let depth = b"XYZ"[self.drilling_axis()] as char;
        let name = words.kind.name();
        let mut missing = |code, what: &str, help: String| {
            let span = self.span(block.range);
            let message = format!("{name} without {what}");
            self.report(Diagnostic::new(code, span, message).label("no hole is made").help(help));
            false
        };
        if words.r.is_none() && rules.missing_r == MissingLevel::Refused {
            let help = "give the level where the feed begins with R".to_string();
            return missing(Code::CycleWithoutR, "its R level", help);
        }
        if words.z.is_none() {
            let help = format!("give the bottom of the hole with {depth}");
            return missing(Code::CycleWithoutDepth, &format!("its depth {depth}"), help);
        }
        let peck_by_vector = rules.peck.decreasing && words.vector[0].is_some();
        if words.kind.is_peck() && words.q.is_none() && !peck_by_vector {
            let help = "give the depth of a peck with Q".to_string();
            return missing(Code::CycleWithoutPeck, "Q", help);
        }
        if let Some(q) = words.q.filter(|q| words.kind.is_peck() && *q <= 0.0)
            && !peck_by_vector
            && (rules.peck.positive_only || q == 0.0)
        {
            let text = self.length_text(q);
            let span = self.words_span(block, Letters::of("Q"));
            self.report(
                Diagnostic::new(
                    Code::CycleWithoutPeck,
                    span,
                    format!("a peck of {text} never reaches the bottom"),
                )
                .label("no hole is made")
                .help("give the depth of a peck with a Q above zero"),
            );
            return false;
        }
        if rules.needs_p && words.kind.dwells() && words.dwell_s.is_none() {
            let help = "give the time of the dwell with P".to_string();
            return missing(Code::CycleWithoutDwell, "its dwell P", help);
        }
        let by_lead = rules.tap.feed == TapFeed::SpeedWithLeadQ && words.kind.is_tap();
        if by_lead && words.q.is_none_or(|q| q == 0.0) {
            let help = "give the lead of the thread with Q; F is the spindle speed".to_string();
            return missing(Code::CycleWithoutLead, "the lead of its thread (Q)", help);
        }
        true
    }

    fn levels_in_order(&mut self, block: &Block, hole: &Hole) -> bool {
        let order = self.control.parameters.cycles.order;
        let above = |a: f64, b: f64| a > b + LEVEL_EPSILON_MM;
        let depth_above_r = above(hole.z, hole.r) && hole.words.kind != CycleKind::BackBore;
        let r_above_initial =
            order == LevelOrder::AllBelowInitial && above(hole.r, hole.words.initial);
        if !depth_above_r && !r_above_initial {
            return true;
        }
        let letter = b"XYZ"[hole.axis] as char;
        let (r, z) = (self.length_text(hole.r), self.length_text(hole.z));
        let initial = self.length_text(hole.words.initial);
        let message = if depth_above_r {
            format!("the depth {letter} {z} is above the R level {r}")
        } else {
            format!("the R level {r} is above the initial level {initial}")
        };
        let free = order == LevelOrder::Free;
        let span = self.span(block.range);
        let mut told = Diagnostic::new(Code::CycleLevels, span, message)
            .help("from top to bottom: initial level, R, depth; check the signs");
        told = if free {
            told.severity(Severity::Warning).label("the tool feeds upwards here")
        } else {
            told.label("no hole is made")
        };
        self.report(told);
        free
    }

    fn report_incremental_depth(&mut self, block: &Block, letter: u8) {
        let span = self.words_span(block, Letters(1 << (letter - b'A')));
        self.report(
            Diagnostic::new(
                Code::CycleDepthIncremental,
                span,
                "the depth of a cycle must be given in G90 on this control",
            )
            .label("read as an absolute level")
            .help("define the cycle in G90; G91 may follow for the positions"),
        );
    }
}
