//! Tapping: the lead ties the feed to the spindle, in both directions.

use chordal_command::{AxisMask, CommandKind, Feed, FeedAlong, FeedMode, Position, SpindleState};
use chordal_diagnostics::{Code, Diagnostic};
use chordal_geometry::Plane;
use chordal_machine::ToolShape;

use super::hole::{HoleWords, LEVEL_EPSILON_MM};
use super::peck::{FREE_PECKS, MAX_PECKS};
use crate::kernel::Kernel;
use crate::rules::{CycleKind, TapFeed};
use crate::statement::Statement;

/// Holders that float are fed up to so much less than the pitch, as a share of it.
const FLOATING_TAP_SHARE: f64 = 0.055;

impl Kernel<'_> {
    /// G84 and G74: in, the spindle reverses, out. The feed is the lead's: no override acts.
    pub fn tap(&mut self, at: &dyn Statement, hole: &HoleWords) {
        let rules = self.rules.cycles.tap;
        let (inward, outward) = match hole.words.kind == CycleKind::LeftTap {
            true => (SpindleState::Ccw, SpindleState::Cw),
            false => (SpindleState::Cw, SpindleState::Ccw),
        };
        let before = self.state.spindle;
        self.set_in_tap(true);
        if let Some(rpm) = hole.words.tap_rpm.filter(|_| rules.feed == TapFeed::SpeedWithLeadQ) {
            self.state.rpm = rpm;
        }
        self.check_tap_speed(at);
        if rules.spindle_must_turn && before != inward {
            self.report_wrong_spindle(at, inward);
        } else if rules.starts_spindle {
            self.turn_spindle(inward);
        }
        self.check_pitch(at, hole);
        let peck = hole.words.q.map(|q| self.unscaled(hole.axis, q.abs()));
        let peck = peck.filter(|q| rules.pecks_by_q && *q > 0.0);
        if let Some(q) = peck {
            self.tap_in_pecks(at, hole, q, (inward, outward));
        }
        let start = self.state.position;
        let exchanged = rules.exchanged_off_xy && self.state.plane != Plane::Xy;
        if exchanged {
            self.report_exchanged(at, hole);
        }
        self.tap_to(at, hole, hole.z, 1.0);
        self.turn_spindle(SpindleState::Off);
        if !rules.dwell_after_reverse {
            self.wait(hole.words.dwell_s);
        }
        let factor = self.out_factor(hole);
        self.reverse_at(outward, factor);
        if rules.dwell_after_reverse {
            self.wait(hole.words.dwell_s);
        }
        let level = if rules.out_to_clear { hole.clear } else { hole.r };
        if exchanged {
            self.state.control_position = Some(start);
        }
        self.tap_to(at, hole, level, factor);
        if exchanged {
            let mut assumed = start;
            assumed[hole.axis] = level;
            self.state.control_position = Some(assumed);
        }
        if rules.dwell_at_r {
            self.wait(hole.words.dwell_s);
        }
        self.turn_spindle(SpindleState::Off);
        if before == inward {
            self.turn_spindle(inward);
        }
        self.set_in_tap(false);
    }

    /// How much faster than in it goes out.
    pub(crate) fn out_factor(&self, hole: &HoleWords) -> f64 {
        let rules = self.rules.cycles.tap;
        let factor = hole.words.out_factor.filter(|_| rules.out_factor_by_j);
        factor.filter(|factor| *factor > 0.0).unwrap_or(rules.out_factor)
    }

    /// Fadal G75: the head reverses by itself when the quill is drawn out.
    pub fn tap_with_head(&mut self, at: &dyn Statement, hole: &HoleWords) {
        let by_speed = self.rules.cycles.tap.feed == TapFeed::SpeedWithLeadQ;
        if let Some(rpm) = hole.words.tap_rpm.filter(|_| by_speed) {
            self.state.rpm = rpm;
        }
        self.check_tap_speed(at);
        self.check_pitch(at, hole);
        self.tap_to(at, hole, hole.z, 1.0);
        self.tap_to(at, hole, hole.r, 1.0);
    }

    /// The lead of a cycle against the pitch of its tap.
    fn check_pitch(&mut self, at: &dyn Statement, hole: &HoleWords) {
        let per_turn = |feed: f64| match self.state.feed_mode {
            FeedMode::PerTime if self.state.rpm > 0.0 => Some(feed * 60.0 / self.state.rpm),
            FeedMode::PerRevolution => Some(feed),
            FeedMode::PerTime | FeedMode::InverseTime => None,
        };
        let (lead, source) = match self.programmed_lead(hole) {
            Some(lead) => (Some(lead), "the words of the cycle make"),
            None => (self.state.feed.and_then(per_turn), "F and S make"),
        };
        if let Some(lead) = lead {
            self.check_lead(at, lead, source);
        }
    }

    /// A lead against the pitch of the tap, where the machine file gives it; once for each tool.
    pub fn check_lead(&mut self, at: &dyn Statement, lead: f64, source: &str) {
        let number = self.state.tool;
        let tool = self.machine.tools.get(&number);
        let tool = tool.filter(|tool| tool.shape == Some(ToolShape::Tap));
        let Some(pitch) = tool.and_then(|tool| tool.pitch_mm) else { return };
        let is_off = (lead - pitch).abs() > FLOATING_TAP_SHARE * pitch;
        if !is_off || self.reported.pitch_for_tool == Some(number) {
            return;
        }
        self.reported.pitch_for_tool = Some(number);
        let [lead, pitch] = [lead, pitch].map(|mm| self.length_text(mm));
        let message = format!("{source} a lead of {lead}, and tap {number} has a pitch of {pitch}");
        self.report(
            Diagnostic::new(Code::TapPitch, at.span(), message)
                .label("the tap breaks, or the thread is torn")
                .help("F is the pitch times S, or the pitch itself where F is per revolution"),
        );
    }

    fn reverse_at(&mut self, outward: SpindleState, factor: f64) {
        let rpm = self.state.rpm;
        self.state.rpm = rpm * factor;
        self.turn_spindle(outward);
        self.state.rpm = rpm;
    }

    /// All pecks but the last.
    fn tap_in_pecks(
        &mut self,
        at: &dyn Statement,
        hole: &HoleWords,
        q: f64,
        (inward, outward): (SpindleState, SpindleState),
    ) {
        let rules = self.rules.cycles.tap;
        for peck in 1..MAX_PECKS {
            let depth = hole.r - f64::from(peck) * q;
            if depth <= hole.z + LEVEL_EPSILON_MM {
                return;
            }
            if peck > FREE_PECKS && !self.count_repeated() {
                return;
            }
            self.tap_to(at, hole, depth, 1.0);
            self.turn_spindle(SpindleState::Off);
            self.turn_spindle(outward);
            let lifted = (depth + rules.peck_lift_mm).min(hole.r);
            self.tap_to(at, hole, if rules.peck_full_return { hole.r } else { lifted }, 1.0);
            self.turn_spindle(SpindleState::Off);
            self.turn_spindle(inward);
        }
    }

    /// A move along the thread; `factor` is how much faster than the way in it goes.
    fn tap_to(&mut self, at: &dyn Statement, hole: &HoleWords, level: f64, factor: f64) {
        let mut target = self.state.control_position.unwrap_or(self.state.position);
        target[hole.axis] = level;
        let mut axes = AxisMask(1 << hole.axis);
        if self.rules.cycles.tap.exchanged_off_xy && hole.words.kind.is_tap() {
            (target, axes) = self.exchanged(target, axes);
        }
        let motion = self.moved_to(target, axes);
        let rev_per_s = self.state.rpm / 60.0 * factor;
        let lead = self.programmed_lead(hole);
        let per_turn = self.state.feed_mode == FeedMode::PerRevolution;
        // At the speed of the way in F has been checked.
        let in_step = lead.is_some() || per_turn && factor > 1.0;
        let feed = match lead {
            Some(lead) => Feed {
                value: lead * rev_per_s,
                mode: FeedMode::PerTime,
                along: FeedAlong::Path,
                spindle_rev_per_s: rev_per_s,
                lead_change: 0.0,
                surface: None,
            },
            None => {
                let mut feed = self.feed_for(at, &motion, None);
                if feed.mode == FeedMode::PerTime {
                    feed.value *= factor;
                }
                feed.spindle_rev_per_s = rev_per_s;
                feed
            }
        };
        if in_step {
            self.check_feed_in_step(&motion, &feed);
        }
        self.emit(CommandKind::Line { motion, feed });
    }

    /// Where a tap of LinuxCNC goes in G18 and G19, which exchanges the coordinates twice.
    fn exchanged(&self, target: Position, axes: AxisMask) -> (Position, AxisMask) {
        let [x, y, z] = [target[0], target[1], target[2]];
        let mut to = target;
        match self.state.plane {
            Plane::Xy => return (target, axes),
            Plane::Zx => [to[0], to[1], to[2]] = [y, z, x],
            Plane::Yz => [to[0], to[1], to[2]] = [z, x, y],
        }
        (to, axes.or(AxisMask(0b111)))
    }

    fn report_exchanged(&mut self, at: &dyn Statement, hole: &HoleWords) {
        let mut bottom = self.state.position;
        bottom[hole.axis] = hole.z;
        let (to, _) = self.exchanged(bottom, AxisMask::NONE);
        let [x, y, z] = [to[0], to[1], to[2]].map(|value| self.length_text(value));
        let span = at.span();
        self.report(
            Diagnostic::new(
                Code::TapExchanged,
                span,
                format!("outside of G17 this control exchanges the axes of a tap: its feed ends at X {x}, Y {y}, Z {z}"),
            )
            .help("tap in G17, or with G33.1"),
        );
    }

    /// The lead of the thread in mm, where the control reads it from a word.
    fn programmed_lead(&self, hole: &HoleWords) -> Option<f64> {
        let form = self.rules.cycles.tap.feed;
        let synchronous = hole.words.synchronous.unwrap_or(form == TapFeed::Lead);
        match form {
            TapFeed::SpeedWithLeadQ => hole.words.q.map(f64::abs),
            // F was read as length per minute, and it is length per turn.
            _ if synchronous && self.state.feed_mode == FeedMode::PerTime => {
                self.state.feed.map(|feed| feed * 60.0).filter(|lead| *lead > 0.0)
            }
            _ => None,
        }
    }

    fn report_wrong_spindle(&mut self, at: &dyn Statement, inward: SpindleState) {
        let (desired, code) = match inward {
            SpindleState::Ccw => ("counter-clockwise", "M4"),
            _ => ("clockwise", "M3"),
        };
        let span = at.span();
        self.report(
            Diagnostic::new(
                Code::CycleSpindle,
                span,
                format!("the spindle must turn {desired} before this cycle"),
            )
            .help(format!("write S and {code} before the cycle")),
        );
    }
}
