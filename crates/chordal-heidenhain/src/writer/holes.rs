//! Drilling and tapping cycles: kept where they make the same moves as the hole.

use std::collections::BTreeMap;

use chordal_command::{CommandKind, CompensationSide, FeedMode, SpindleState};
use chordal_geometry::Plane;
use chordal_kernel::{
    DrilledHole, HoleForm, HoleMotion, PostedKind, TappedHole, are_same_motions, is_same_level,
};

use super::blocks::KlartextBlocks;
use super::words::{feed_unit, signed, significant};
use crate::cycles::{
    CycleContext, CycleFeed, CycleValues, KlartextCycleStep, parameter_cycle_steps,
};

/// The names of parameters, as an English control shows them.
const PARAMETER_NAMES: &[(u32, &str)] = &[
    (200, "SET-UP CLEARANCE"),
    (201, "DEPTH"),
    (202, "PLUNGING DEPTH"),
    (203, "SURFACE COORDINATE"),
    (204, "2ND SET-UP CLEARANCE"),
    (205, "MIN. PLUNGING DEPTH"),
    (206, "FEED RATE FOR PLNGNG"),
    (208, "RETRACTION FEED RATE"),
    (210, "DWELL TIME AT TOP"),
    (211, "DWELL TIME AT DEPTH"),
    (212, "DECREMENT"),
    (239, "THREAD PITCH"),
    (253, "F PRE-POSITIONING"),
    (256, "DIST. FOR CHIP BRKNG"),
    (257, "DEPTH FOR CHIP BRKNG"),
    (258, "UPPER ADV. STOP DIST."),
    (259, "LOWER ADV. STOP DIST."),
    (379, "STARTING POINT"),
];

/// A cycle and its parameters, in the order of the control.
#[derive(Clone, PartialEq, Debug)]
struct CycleDefinition {
    number: u32,
    title: &'static str,
    values: Vec<(u32, f64)>,
}

impl CycleDefinition {
    fn text(&self, digits: usize) -> String {
        let mut lines = vec![format!("CYCL DEF {} {}", self.number, self.title)];
        for (number, value) in &self.values {
            let value = match number {
                206 | 208 | 253 => format!("+{}", significant(*value)),
                _ => signed(*value, digits),
            };
            let name = PARAMETER_NAMES.iter().find(|(own, _)| own == number);
            let name = name.map_or("", |(_, name)| name);
            lines.push(format!("  Q{number}={value} ;{name}"));
        }
        lines.join(" ~\n")
    }
}

/// The levels of a hole in program units.
#[derive(Clone, Copy)]
struct CycleLevels {
    /// Q203.
    surface: f64,
    /// Q200.
    clearance: f64,
    /// Q201.
    depth: f64,
    /// Q204.
    second: f64,
}

impl KlartextBlocks<'_> {
    /// Before a move after which a hole is drilled: defines its cycle, which the move calls.
    pub fn prepare_cycle(&mut self, command: &CommandKind) {
        self.calls_cycle = false;
        self.has_called = false;
        let is_straight = matches!(command, CommandKind::Rapid { .. } | CommandKind::Line { .. });
        let next = self.step + 1;
        let Some(PostedKind::Hole(hole)) = self.program.steps.get(next).map(|step| &step.kind)
        else {
            return;
        };
        if !is_straight || self.side.desired != CompensationSide::Off {
            return;
        }
        let Some(cycle) = self.kept_cycle(hole, next) else { return };
        self.calls_cycle = true;
        self.define(&cycle);
    }

    /// A hole: called by the move before it, by a call of its own, or as moves.
    pub fn hole(&mut self, hole: &DrilledHole) -> Result<(), String> {
        self.calls_cycle = false;
        if let Some(cycle) = self.kept_cycle(hole, self.step) {
            if !std::mem::take(&mut self.has_called) {
                self.prepare_move(false)?;
                self.define(&cycle);
                self.alone("CYCL CALL");
            }
            let words = format!("CYCL DEF {} {}", cycle.number, cycle.title);
            self.note(words, "the cycle with the same steps");
            return Ok(());
        }
        self.note("", "a hole that is written out as moves: no cycle has the same steps");
        for command in &hole.written_out {
            self.command(command)?;
        }
        Ok(())
    }

    /// A thread: cycle 207, which leads the tap in step with the spindle; with a dwell cycle 206.
    pub fn tap(&mut self, tap: &TappedHole) -> Result<(), String> {
        self.check_active_length()?;
        if tap.plane != Plane::Xy {
            return Err("a tap that is not along the tool axis Z".into());
        }
        if tap.out_factor != 1.0 {
            return Err("a tap that feeds out at a different speed than in".into());
        }
        let lead = tap.lead_mm().ok_or("a tap without a lead")?;
        let (_, _, normal) = tap.plane.axes();
        let start = tap.start[normal];
        let levels = self
            .levels([start, tap.bottom_mm, start])
            .into_iter()
            .next()
            .ok_or("a tap upwards: the depth of a cycle is negative")?;
        self.spindle.desired = if tap.is_left { SpindleState::Ccw } else { SpindleState::Cw };
        self.speed.desired = tap.rpm;
        self.prepare_move(false)?;
        let CycleLevels { surface, clearance, depth, second } = levels;
        let pitch = lead / self.lengths.units.mm();
        let cycle = match tap.dwell_s > 0.0 {
            false => {
                let pitch = if tap.is_left { -pitch } else { pitch };
                let values = vec![
                    (200, clearance),
                    (201, depth),
                    (239, pitch),
                    (203, surface),
                    (204, second),
                ];
                CycleDefinition { number: 207, title: "RIGID TAPPING", values }
            }
            true => {
                let feed = self.cycle_feed(lead * tap.rpm / 60.0);
                let dwell = (211, tap.dwell_s);
                let values = vec![
                    (200, clearance),
                    (201, depth),
                    (206, feed),
                    dwell,
                    (203, surface),
                    (204, second),
                ];
                CycleDefinition { number: 206, title: "TAPPING", values }
            }
        };
        self.define(&cycle);
        self.alone("CYCL CALL");
        let words = format!("CYCL DEF {} {}", cycle.number, cycle.title);
        self.note(
            words,
            "the tap of this control: look whether it is one in step with the spindle",
        );
        self.spindle.desired = tap.spindle[1];
        self.write_spindle();
        Ok(())
    }

    /// Defines a cycle, where another one is defined.
    fn define(&mut self, cycle: &CycleDefinition) {
        let text = cycle.text(self.lengths.digits());
        if self.cycle.as_ref() != Some(&text) {
            self.line(text.clone());
            self.cycle = Some(text);
        }
    }

    /// The cycle that makes exactly this hole.
    fn kept_cycle(&self, hole: &DrilledHole, at: usize) -> Option<CycleDefinition> {
        let is_kept = self.check_active_length().is_ok()
            && !self.options.written_out.contains(&at)
            && hole.plane == Plane::Xy
            && hole.feed.mode == FeedMode::PerTime
            && hole.feed.value.is_finite()
            && hole.feed.value > 0.0;
        if !is_kept {
            return None;
        }
        self.candidates(hole).into_iter().find(|cycle| self.makes(cycle, hole))
    }

    /// The levels of a cycle from where the first feed begins, the bottom and the end, mm: from a surface at zero, if it lies
    /// between start and bottom, and from one at the start.
    fn levels(&self, [start, bottom, end]: [f64; 3]) -> Vec<CycleLevels> {
        let [start, bottom, end] = [start, bottom, end].map(|mm| self.lengths.value(mm));
        if bottom >= start || end < start {
            return Vec::new();
        }
        let surfaces = [(start > 0.0 && bottom < 0.0).then_some(0.0), Some(start)];
        let levels = |surface: f64| CycleLevels {
            surface,
            clearance: start - surface,
            depth: bottom - surface,
            second: end - surface,
        };
        surfaces.into_iter().flatten().map(levels).collect()
    }

    /// Cycles that may make this hole.
    fn candidates(&self, hole: &DrilledHole) -> Vec<CycleDefinition> {
        let Some(form) = hole.form() else { return Vec::new() };
        let levels = self.levels([hole.start_mm, hole.bottom_mm, hole.retract_mm]);
        let feed = self.cycle_feed(hole.feed.value);
        levels.into_iter().flat_map(|levels| self.cycles_of(form, feed, levels)).collect()
    }

    fn cycles_of(&self, form: HoleForm, feed: f64, levels: CycleLevels) -> Vec<CycleDefinition> {
        let CycleLevels { surface, clearance, depth, second } = levels;
        let drill = |stroke: f64, dwell: f64| CycleDefinition {
            number: 200,
            title: "DRILLING",
            values: vec![
                (200, clearance),
                (201, depth),
                (206, feed),
                (202, stroke),
                (210, 0.0),
                (203, surface),
                (204, second),
                (211, dwell),
            ],
        };
        match form {
            HoleForm::Drilled { dwell_s } => vec![drill(-depth, dwell_s)],
            HoleForm::FedOut { dwell_s, feed_out } => {
                let values = vec![
                    (200, clearance),
                    (201, depth),
                    (206, feed),
                    (211, dwell_s),
                    (208, self.cycle_feed(feed_out)),
                    (203, surface),
                    (204, second),
                ];
                vec![CycleDefinition { number: 201, title: "REAMING", values }]
            }
            // No cycle waits at the bottom of each step.
            HoleForm::Pecked { dwell_s, .. } if dwell_s > 0.0 => Vec::new(),
            HoleForm::Pecked { is_full, first_mm, back_mm, .. } => {
                let unit = self.lengths.units.mm();
                let (first, back) = (first_mm / unit - clearance, back_mm / unit);
                let (stroke, breaks, lift, stop) = match is_full {
                    true => (first, 0.0, 0.0, back),
                    false => (-depth, first, back, 0.0),
                };
                let values = vec![
                    (200, clearance),
                    (201, depth),
                    (206, feed),
                    (202, stroke),
                    (203, surface),
                    (204, second),
                    (212, 0.0),
                    (205, stroke),
                    (258, stop),
                    (259, stop),
                    (257, breaks),
                    (256, lift),
                    (211, 0.0),
                    (379, 0.0),
                    (253, feed),
                ];
                let deep = CycleDefinition { number: 205, title: "UNIVERSAL PECKING", values };
                match is_full && first > 0.0 {
                    true => vec![drill(first, 0.0), deep],
                    false => vec![deep],
                }
            }
        }
    }

    /// Whether a cycle makes the steps of a hole.
    fn makes(&self, cycle: &CycleDefinition, hole: &DrilledHole) -> bool {
        let unit_mm = self.lengths.units.mm();
        let numbers: BTreeMap<u32, f64> = cycle.values.iter().copied().collect();
        let values =
            CycleValues::new(numbers, BTreeMap::new(), unit_mm, feed_unit(self.lengths.units));
        let context = CycleContext {
            level: hole.initial_mm,
            position: [0.0; 2],
            tool_radius: None,
            point_angle: None,
            rpm: self.speed.desired,
            turns_left: false,
            peck_stop: self.settings.peck_stop_mm,
            refuses_positive_depth: self.settings.positive_depth_is_error,
        };
        let Ok(steps) = parameter_cycle_steps(cycle.number, &values, &context) else {
            return false;
        };
        made_motions(&steps, hole).is_some_and(|made| are_same_motions(&made, &hole.motions))
    }
}

/// The motions of the steps of a cycle, without those that move nothing; `None` where it does more than a hole needs.
fn made_motions(steps: &[KlartextCycleStep], hole: &DrilledHole) -> Option<Vec<HoleMotion>> {
    let mut level = hole.initial_mm;
    let mut made = Vec::new();
    for step in steps {
        let motion = match *step {
            KlartextCycleStep::Rapid(to) => HoleMotion::Rapid(to),
            KlartextCycleStep::Feed { to, feed } => match feed {
                CycleFeed::Speed(feed) => HoleMotion::Cut { to_mm: to, feed },
                CycleFeed::Rapid => HoleMotion::Rapid(to),
                CycleFeed::Active => return None,
            },
            KlartextCycleStep::Dwell(seconds) => HoleMotion::Dwell(seconds),
            KlartextCycleStep::Across { .. }
            | KlartextCycleStep::Arc { .. }
            | KlartextCycleStep::Ramp { .. }
            | KlartextCycleStep::ArcRamp { .. }
            | KlartextCycleStep::Helix { .. }
            | KlartextCycleStep::Turn { .. }
            | KlartextCycleStep::Coolant(_)
            | KlartextCycleStep::Orient
            | KlartextCycleStep::SpindleOn
            | KlartextCycleStep::Reverse => return None,
        };
        let to = match motion {
            HoleMotion::Rapid(to) | HoleMotion::Cut { to_mm: to, .. } => to,
            HoleMotion::Dwell(_) => level,
        };
        let stays = is_same_level(to, level) && !matches!(motion, HoleMotion::Dwell(_));
        if !stays {
            made.push(motion);
        }
        level = to;
    }
    Some(made)
}
