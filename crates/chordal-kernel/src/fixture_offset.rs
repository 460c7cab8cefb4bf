//! The error of a clamped part that turns with the tables (Fanuc G54.2, the dynamic fixture offset).
//!
//! The part lies off its place by a vector that was measured with the rotary axes at some angles. The control turns the
//! vector with the tables, and adds it to the work offset: the program is the same for every side of the part.

use chordal_command::{AxisMask, Position};
use chordal_diagnostics::{Code, Span};
use chordal_geometry::Vec3;

use crate::kernel::Kernel;
use crate::offsets::FixtureError;

impl Kernel<'_> {
    /// Brings the error of a clamped part into force; 0 ends it. The machine does not move.
    pub fn select_fixture_error(&mut self, span: Span, number: u16) {
        let error = self.fixture_error(number, &self.state.position);
        self.set_fixture_error(error);
        if number == 0 {
            return;
        }
        if let Err(why) = self.rotary_chain() {
            return self.report_no_kinematics(span, &FixtureError::key(number), &why);
        }
        let key = FixtureError::key(number);
        if (0..3).any(|axis| self.state.offsets.work_value(&key, axis).is_none()) {
            let message = format!("the machine file gives no fixture offset {key}");
            let help = format!("set it with --set 'work_offsets.\"{key}\".X=\"…\"', and so on");
            self.report_unset(Code::OffsetNotSet, span, key, message, help);
        }
    }

    /// Before a move to these positions: where tables turn in it, the error of the part lies as they will stand.
    pub fn turn_fixture_error(&mut self, target: &Position) {
        let number = self.state.offsets.fixture().number;
        if number != 0 && target[3..] != self.state.position[3..] {
            self.set_fixture_error(self.fixture_error(number, target));
        }
    }

    /// After moves of the axes, such as to a reference point, the error of the part lies as the tables stand now.
    pub(crate) fn follow_fixture_error(&mut self) {
        let number = self.state.offsets.fixture().number;
        if number != 0 {
            self.set_fixture_error(self.fixture_error(number, &self.state.position));
        }
    }

    fn set_fixture_error(&mut self, error: FixtureError) {
        if error != self.state.offsets.fixture() {
            self.state.shift_coordinates(|offsets| offsets.set_fixture(error));
            self.emit_work_offset();
        }
    }

    /// The error of the part with the rotary axes at a position. A, B and C of the table are the angles at which it was
    /// measured, 0 without them.
    fn fixture_error(&self, number: u16, place: &Position) -> FixtureError {
        if number == 0 {
            return FixtureError::NONE;
        }
        let unknown = FixtureError { number, shift: [0.0; 3], is_known: false };
        let Ok(chain) = self.rotary_chain() else { return unknown };
        let key = FixtureError::key(number);
        let value = |axis: usize| self.state.offsets.work_value(&key, axis);
        let (Some(x), Some(y), Some(z)) = (value(0), value(1), value(2)) else { return unknown };
        let known = self.state.frames.map().known(self.state.known);
        let turning = AxisMask::of_chain(&chain);
        let is_named = |axis: usize| place[axis] != self.state.position[axis];
        if !(3..6).all(|axis| !turning.has(axis) || known.has(axis) || is_named(axis)) {
            return unknown;
        }
        let measured = std::array::from_fn(|axis| value(axis + 3).unwrap_or(0.0));
        let angles = self.state.program_offsets().angles(place);
        let on_part = chain.part_transform(&measured).apply_direction(Vec3::new(x, y, z));
        let shift = chain.part_transform(&angles).inverse().apply_direction(on_part).to_array();
        FixtureError { number, shift, is_known: true }
    }
}
