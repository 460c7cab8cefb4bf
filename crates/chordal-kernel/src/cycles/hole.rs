//! The hole that the words of a cycle make, and what a control says when one is missing.

use chordal_command::{AxisMask, CompensationSide, FeedMode};
use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_geometry::Plane;
use chordal_machine::Axis;

use crate::kernel::Kernel;
use crate::rules::{
    BackBore, CycleKind, DrillingAxis, IncrementalLevels, LevelOrder, MissingLevel, TapFeed,
};
use crate::state::CycleState;
use crate::statement::{Statement, WordMeaning};

/// Levels closer than this, mm, are one.
pub(super) const LEVEL_EPSILON_MM: f64 = 1e-9;

/// What is known of a hole before its place: the words in force and the levels.
#[derive(Clone, Copy)]
pub struct HoleWords {
    /// The words in force.
    pub words: CycleState,
    /// Index of the drilling axis.
    pub axis: usize,
    /// Where the feed begins.
    pub r: f64,
    /// The bottom.
    pub z: f64,
    /// Where the tool goes when the hole is done.
    pub clear: f64,
}

impl Kernel<'_> {
    /// The index of the axis that cycles drill along.
    pub fn drilling_axis(&self) -> usize {
        match (self.rules.cycles.axis, self.state.plane) {
            (DrillingAxis::OfCode, _) => self.state.cycle.map_or(2, |cycle| cycle.axis),
            (DrillingAxis::AlwaysZ, _) | (_, Plane::Xy) => 2,
            (_, Plane::Zx) => 1,
            (_, Plane::Yz) => 0,
        }
    }

    /// The hole that the words in force make, or why the control makes none.
    pub fn resolve_hole(&mut self, at: &dyn Statement) -> Option<HoleWords> {
        let mut words = self.state.cycle?;
        let peck = self.rules.cycles.peck;
        if words.kind == CycleKind::Peck && peck.q_optional && words.q.is_none() {
            words.kind = CycleKind::DrillDwell;
        } else if words.kind == CycleKind::Peck && !peck.full_return {
            words.kind = CycleKind::ChipBreak;
        }
        if !self.may_drill(at) || !self.has_its_words(at, &words) {
            return None;
        }
        let rules = self.rules.cycles;
        let axis = self.drilling_axis();
        let again = rules.incremental == IncrementalLevels::ReadAgain && self.state.incremental;
        let r = match words.r {
            Some(r) if again => words.initial + r,
            Some(r) => r,
            None if rules.missing_r == MissingLevel::Initial => words.initial,
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
        let hole = HoleWords { words, axis, r, z, clear };
        self.levels_in_order(at, &hole).then_some(hole)
    }

    /// Compensation, inverse time and rotary words forbid a cycle.
    fn may_drill(&mut self, at: &dyn Statement) -> bool {
        let span = at.span();
        if self.state.side != CompensationSide::Off {
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
        if !self.rules.cycles.strict {
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
        let rotary = WordMeaning::Axes(AxisMask::ROTARY);
        if at.has(rotary) {
            let span = at.words(rotary);
            self.report(
                Diagnostic::new(Code::CycleRotaryWord, span, "a rotary axis in a canned cycle")
                    .help("turn the rotary axis in a block before the cycle"),
            );
            return false;
        }
        true
    }

    /// R, the depth, Q and P, where the control asks for them.
    fn has_its_words(&mut self, at: &dyn Statement, words: &CycleState) -> bool {
        let rules = self.rules.cycles;
        let depth = Axis::ALL[self.drilling_axis()].letter();
        let name = words.kind.facts().name;
        let mut missing = |code, what: &str, help: String| {
            let span = at.span();
            let message = format!("{name} without {what}");
            self.report(Diagnostic::new(code, span, message).label("no hole is made").help(help));
            false
        };
        if words.r.is_none() && rules.missing_r == MissingLevel::Refused {
            let help = "give the level where the feed begins with R".to_string();
            return missing(Code::CycleWithoutR, "its R level", help);
        }
        let notes_r = words.r.is_none() && rules.missing_r == MissingLevel::Initial;
        if words.z.is_none() {
            let help = format!("give the bottom of the hole with {depth}");
            return missing(Code::CycleWithoutDepth, &format!("its depth {depth}"), help);
        }
        let by_speed = rules.tap.feed == TapFeed::SpeedWithLeadQ;
        if by_speed && words.kind.is_tap() && words.tap_rpm == Some(0.0) {
            let help = "here F is the spindle speed of the tap, and Q its lead".to_string();
            return missing(Code::CycleSpindle, "a spindle speed", help);
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
            let span = at.words(WordMeaning::Increment);
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
        if notes_r {
            self.note_missing_r(at, words);
        }
        true
    }

    /// R is left out where that is allowed: said once of a program.
    fn note_missing_r(&mut self, at: &dyn Statement, words: &CycleState) {
        if std::mem::replace(&mut self.reported.cycle_without_r, true) {
            return;
        }
        let name = words.kind.facts().name;
        let level = self.length_text(words.initial);
        self.report(
            Diagnostic::new(
                Code::CycleWithoutR,
                at.span(),
                format!("{name} without R: it feeds from the initial level, {level}"),
            )
            .severity(Severity::Note)
            .help("give the level where the feed begins with R"),
        );
    }

    fn levels_in_order(&mut self, at: &dyn Statement, hole: &HoleWords) -> bool {
        let order = self.rules.cycles.order;
        let above = |a: f64, b: f64| a > b + LEVEL_EPSILON_MM;
        let depth_above_r = above(hole.z, hole.r) && hole.words.kind != CycleKind::BackBore;
        let r_above_initial =
            order == LevelOrder::AllBelowInitial && above(hole.r, hole.words.initial);
        let letter = Axis::ALL[hole.axis].letter();
        let is_empty = (hole.z - hole.r).abs() <= LEVEL_EPSILON_MM;
        if is_empty && hole.words.kind != CycleKind::BackBore {
            let level = self.length_text(hole.r);
            let message = format!("the depth {letter} {level} is the R level: nothing is drilled");
            self.report(
                Diagnostic::new(Code::CycleLevels, at.span(), message)
                    .severity(Severity::Warning)
                    .help("from top to bottom: initial level, R, depth"),
            );
        }
        if !depth_above_r && !r_above_initial {
            return true;
        }
        let (r, z) = (self.length_text(hole.r), self.length_text(hole.z));
        let initial = self.length_text(hole.words.initial);
        let message = if depth_above_r {
            format!("the depth {letter} {z} is above the R level {r}")
        } else {
            format!("the R level {r} is above the initial level {initial}")
        };
        let free = order == LevelOrder::Free;
        let span = at.span();
        let mut problem = Diagnostic::new(Code::CycleLevels, span, message)
            .help("from top to bottom: initial level, R, depth; check the signs");
        problem = if free {
            problem.severity(Severity::Warning).label("the tool feeds upwards here")
        } else {
            problem.label("no hole is made")
        };
        self.report(problem);
        free
    }
}
