//! CYCLE800: the plane is swivelled.

use chordal_command::AxisMask;
use chordal_diagnostics::{Code, TextRange};
use chordal_geometry::{Plane, Transform, Vec3};
use chordal_kernel::TurnError;
use chordal_kernel::frames::FrameMap;

use super::interpreter::Interpreter;
use super::programmable_frame::linear;

/// Places of the parameters (Cycles 11/2006, 3.10).
const RETRACT: usize = 0;
const STATUS: usize = 2;
const MODE: usize = 3;
const SHIFT_BEFORE: usize = 4;
const ANGLES: usize = 7;
const SHIFT_AFTER: usize = 10;
const DIRECTION: usize = 13;

impl Interpreter<'_> {
    /// Swivels the plane. The frame is carried out; the rotary axes are those of a machine that is not known here, so
    /// that positions are right on the part and not on the machine.
    pub(super) fn swivel_plane(&mut self, numbers: &[Option<f64>], range: TextRange) {
        if numbers.iter().all(Option::is_none) {
            // CYCLE800() ends the swivelled plane.
            self.kernel.set_tilted_plane(None);
            let was_swivelled = self.modes.swivel != FrameMap::IDENTITY;
            self.modes.set_frames(self.modes.programmable, FrameMap::IDENTITY);
            if was_swivelled {
                self.kernel.go_astray(AxisMask::LINEAR);
            }
            return;
        }
        let number = |place: usize| numbers.get(place).copied().flatten().unwrap_or(0.0);
        let mode = number(MODE).round() as i64;
        let degrees: [f64; 3] = std::array::from_fn(|place| number(ANGLES + place));
        let is_turned = degrees.iter().any(|angle| *angle != 0.0);
        if is_turned && mode & 0b1100_0000 != 0 {
            let what = "CYCLE800 with solid or projected angles or positions of the rotary axes is not followed";
            return self.not_followed(range, what);
        }
        let unit = self.unit_mm();
        if self.programs.control.axes().and(AxisMask::ROTARY) != AxisMask::NONE {
            return self.swivel_on_machine(mode, degrees, &number, range);
        }
        let shift = |from: usize| {
            FrameMap::translation(linear(
                std::array::from_fn(|axis| number(from + axis) * unit),
                0.0,
            ))
        };
        let map = shift(SHIFT_AFTER).then(&rotation(mode, degrees)).then(&shift(SHIFT_BEFORE));
        let is_additive = number(STATUS).round() as i64 % 10 == 1;
        let swivel = if is_additive { map.then(&self.modes.swivel) } else { map };
        self.modes.set_frames(self.modes.programmable, swivel);
        self.modes.last_direction = None;
        if is_turned {
            self.kernel.go_astray(AxisMask::LINEAR);
            self.lose_path(range, "where the machine is in the swivelled plane", "its rotary axes");
        } else if number(RETRACT) != 0.0 {
            let mut axes = AxisMask::NONE;
            axes.insert(2);
            self.kernel.go_astray(axes);
        }
    }
}

impl Interpreter<'_> {
    /// On a machine with rotary axes: the plane is one of the machine, to which its rotary axes turn, except with _DIR 0.
    fn swivel_on_machine(
        &mut self,
        mode: i64,
        degrees: [f64; 3],
        number: &dyn Fn(usize) -> f64,
        range: TextRange,
    ) {
        let unit = self.unit_mm();
        let shift = |from: usize| {
            Transform::translation(Vec3::new(
                number(from) * unit,
                number(from + 1) * unit,
                number(from + 2) * unit,
            ))
        };
        let turn = |place: usize| match turning_axis(mode, place) {
            Some(axis) => {
                let about = [Vec3::X, Vec3::Y, Vec3::Z][axis];
                Transform::rotation_about(Vec3::ZERO, about, degrees[place].to_radians())
            }
            None => Transform::identity(),
        };
        let rotation = turn(2).then(&turn(1)).then(&turn(0));
        let plane = shift(SHIFT_AFTER).then(&rotation).then(&shift(SHIFT_BEFORE));
        let is_additive = number(STATUS).round() as i64 % 10 == 1;
        let before = self.kernel.tilted_plane();
        let plane = match before.filter(|_| is_additive) {
            Some(before) => plane.then(&before),
            None => plane,
        };
        if number(RETRACT) != 0.0 {
            self.kernel.go_astray(AxisMask(1 << 2));
        }
        self.modes.last_direction = None;
        self.kernel.set_tilted_plane(Some(plane));
        if number(DIRECTION) == 0.0 {
            return;
        }
        match self.kernel.turn_to_plane(false, None) {
            Ok(()) | Err(TurnError::NoPlane) => {}
            Err(TurnError::NoKinematics(why)) => self.report_no_kinematics("CYCLE800", &why, range),
            Err(TurnError::Unreachable(why)) => {
                let message = format!("CYCLE800: {why}");
                self.alarm(61184, Code::TiltedPlane, range, message);
            }
        }
    }
}

/// The rotations axis by axis, the first one outermost.
fn rotation(mode: i64, degrees: [f64; 3]) -> FrameMap {
    let turn = |place: usize| match turning_axis(mode, place) {
        Some(axis) => {
            let plane = [Plane::Yz, Plane::Zx, Plane::Xy][axis];
            FrameMap::rotation(plane, [0.0; 2], degrees[place])
        }
        None => FrameMap::IDENTITY,
    };
    turn(2).then(&turn(1)).then(&turn(0))
}

/// The axis of a rotation, 0 to 2 for X, Y and Z: the mode names those of the first, the second and the third one by two bits
/// each.
fn turning_axis(mode: i64, place: usize) -> Option<usize> {
    match (mode >> (2 * place)) & 0b11 {
        1 => Some(0),
        2 => Some(1),
        3 => Some(2),
        _ => None,
    }
}
