//! Checks of moves in a frame of the part (tool centre point control, tilted planes): the travel of the axes along the
//! whole move.

use chordal_command::{AxisMask, CommandKind, Move, Origin, TipCurve};
use chordal_diagnostics::Diagnostic;
use chordal_geometry::ParamCurve;
use chordal_kinematics::JointPath;
use chordal_machine::Machine;

use super::RunChecks;
use crate::axis_path::tip_pieces;
use crate::compensation::PathCommand;
use crate::segment::{curve_of, is_known};

/// How far the computed extremes of the axes may be outside of the true ones, mm.
const EXTREME_TOLERANCE_MM: f64 = 1e-4;

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
