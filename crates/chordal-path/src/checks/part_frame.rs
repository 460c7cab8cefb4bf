//! Checks of moves in a frame of the part (tool centre point control, tilted planes): the travel of the axes along the
//! whole move.

use chordal_command::{AxisMask, CommandKind, Move, Origin, TipCurve, number_text, telling_number};
use chordal_diagnostics::{Code, Diagnostic};
use chordal_geometry::ParamCurve;
use chordal_kinematics::JointPath;
use chordal_machine::{AXES, Axis, Machine};

use super::RunChecks;
use crate::axis_path::tip_pieces;
use crate::builder::duration_s;
use crate::compensation::PathCommand;
use crate::frame::ProgramFrame;
use crate::segment::{curve_of, is_known};

/// How far the computed extremes of the axes may be outside of the true ones, mm.
const EXTREME_TOLERANCE_MM: f64 = 1e-4;

/// By how much a speed may be above its limit by rounding.
const SPEED_ROUNDING: f64 = 1e-9;

impl RunChecks<'_> {
    /// Follows a command in a frame of the part. Heights of the program say nothing about the part where the tool
    /// is tilted: rapids into the part are looked for with the tool upright only.
    #[cold]
    pub(super) fn on_tip(&mut self, path: PathCommand<'_>, report: &mut impl FnMut(Diagnostic)) {
        let command = path.command;
        if self.now.frame.follow(command) {
            return;
        }
        if let CommandKind::Units(units) = &command.kind {
            self.now.units = *units;
        }
        let Some(motion) = command.kind.motion() else { return };
        self.now.last = None;
        let places = [&motion.from, &motion.to];
        let frame = self.now.frame.part_frame.as_ref();
        let is_tilted = frame.is_some_and(|frame| !frame.is_level())
            || places.iter().any(|place| place[3..] != [0.0; 3]);
        self.axes_of_tip(&command.kind, motion, command.origin, report);
        if self.tip_feed_alarm.is_some() && frame_follows_tip(&self.now.frame) {
            self.rotary_under_feed(&command.kind, motion, command.origin, report);
        }
        let is_rapid = matches!(command.kind, CommandKind::Rapid { .. });
        if is_tilted {
            self.seen.rapids.end_cut();
            (self.now.at_depth, self.now.legs) = (false, Vec::new());
        } else if is_rapid {
            self.rapid(motion, command.origin);
        } else {
            self.end_legs();
            if is_known(motion) {
                let bounds = curve_of(motion, command.kind.shape()).bounds();
                self.seen.rapids.cut(|cut| cut.union(bounds));
            }
            self.cut_at_depth(motion);
        }
    }

    /// Reports a feed of the tip for which a rotary axis would have to turn faster than it can, on controls that stop then
    /// (Fanuc A-79348E: PS5422). The largest speed of the axis is that of its rapids.
    fn rotary_under_feed(
        &mut self,
        kind: &CommandKind,
        motion: &Move,
        origin: Origin,
        report: &mut impl FnMut(Diagnostic),
    ) {
        let Some(feed) = kind.feed() else { return };
        if self.now.reported_speed || self.assumed || motion.from[3..] == motion.to[3..] {
            return;
        }
        let curve = curve_of(motion, kind.shape());
        let seconds = duration_s(feed, motion, &curve);
        let speed = |axis: usize| {
            let most = self.machine.axes[axis].as_ref()?.max_velocity?;
            let turn = (motion.to[axis] - motion.from[axis]).abs();
            Some((axis, turn, most)).filter(|_| turn > most * seconds * (1.0 + SPEED_ROUNDING))
        };
        let too_fast = (3..AXES).filter_map(speed);
        let slowness = |(_, turn, most): &(usize, f64, f64)| turn / most;
        let Some((axis, turn, most)) = too_fast.max_by(|a, b| slowness(a).total_cmp(&slowness(b)))
        else {
            return;
        };
        // A block without a length or a feed has no time that follows from it.
        if seconds <= 0.0 {
            return;
        }
        self.now.reported_speed = true;
        let letter = Axis::ALL[axis].letter();
        let per_minute =
            |value: f64| format!("{} deg/min", number_text(value.to_degrees() * 60.0, 0));
        let length = self.now.units.length_text(curve.length());
        let allowed = self.now.units.length_text(curve.length() * most / turn * 60.0);
        let turned = telling_number(turn.to_degrees(), 3);
        let (needed, most) = (per_minute(turn / seconds), per_minute(most));
        let message = format!("{letter} would turn at {needed}, and its largest speed is {most}");
        let mut diagnostic = Diagnostic::new(Code::TipFeedTooFast, origin.span, message)
            .label(format!("{turned} deg while the tip goes {length}"))
            .help(format!("at most {allowed} a minute in this block, or a smaller turn"));
        diagnostic.alarm.clone_from(&self.tip_feed_alarm);
        report(diagnostic);
    }

    /// Checks the travel of all axes along a move.
    fn axes_of_tip(
        &mut self,
        kind: &CommandKind,
        motion: &Move,
        origin: Origin,
        report: &mut impl FnMut(Diagnostic),
    ) {
        let frame = &self.now.frame;
        let known = motion.from_known.and(motion.to_known).and(AxisMask::LINEAR);
        let Some(part_frame) = frame.part_frame.clone() else { return };
        let offsets = frame.offsets();
        let is_known = known.covers(AxisMask::LINEAR) && frame.known.covers(AxisMask::LINEAR);
        let rotary = motion.to_known.and(AxisMask::ROTARY);
        self.extend(&motion.to, rotary);
        self.travel(&motion.to, rotary, origin, report);
        if !is_known {
            return;
        }
        let mut extremes: Vec<[f64; 6]> = Vec::new();
        tip_pieces(kind, motion, |curve, ends| {
            let Some(path) = part_frame.joint_path(curve, ends, &offsets) else { return };
            if is_surely_within(self.machine, &path) {
                return;
            }
            let bounds = path.bounds(0.0, 1.0, EXTREME_TOLERANCE_MM);
            let total = |axis: usize| offsets.work[axis] + offsets.tool[axis];
            // What the bounds may be outside of the truth is no alarm; an axis that stands has no other side to go to.
            let inward = bounds.map(|(low, high)| EXTREME_TOLERANCE_MM.min((high - low) / 2.0));
            extremes.push(std::array::from_fn(|axis| bounds[axis].0 + inward[axis] - total(axis)));
            extremes.push(std::array::from_fn(|axis| bounds[axis].1 - inward[axis] - total(axis)));
        });
        for place in extremes {
            self.travel(&place, AxisMask::LINEAR, origin, report);
        }
    }
}

/// Whether the control holds the tip while rotary axes turn.
fn frame_follows_tip(frame: &ProgramFrame) -> bool {
    frame.part_frame.as_ref().is_some_and(|frame| frame.follows_tip)
}

/// Whether the linear axes stay within their travel by the roughest bound: their ends, and how far they may be from the
/// chord. Most moves do, and need no more.
fn is_surely_within(machine: &Machine, path: &JointPath<TipCurve>) -> bool {
    let away = path.second_derivative_bound(0.0, 1.0) / 8.0 + EXTREME_TOLERANCE_MM;
    let [from, to] = [0.0, 1.0].map(|sigma| path.positions(sigma).gauge_point);
    (0..3).all(|axis| {
        let travel = machine.axes[axis].as_ref().and_then(|limits| limits.travel);
        let ends = [from.component(axis), to.component(axis)];
        travel.is_none_or(|(low, high)| ends.iter().all(|at| at - away >= low && at + away <= high))
    })
}
