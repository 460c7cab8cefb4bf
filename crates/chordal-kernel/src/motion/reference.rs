//! Moves to machine points: reference points and machine coordinates.

use chordal_command::{AxisMask, CommandKind, Move, Position};
use chordal_machine::{Axis, PerAxis};

use crate::kernel::Kernel;
use crate::state::ModalMotion;
use crate::statement::Statement;

const Z: usize = Axis::Z as usize;

impl Kernel<'_> {
    /// Moves the named axes to a reference point through `target` (G28, G30). An axis without a reference
    /// position goes to machine zero.
    pub fn return_over(
        &mut self,
        target: Position,
        named: AxisMask,
        reference: &PerAxis<Option<f64>>,
    ) {
        if target != self.state.position {
            self.rapid(target, named);
        }
        self.go_to_reference(named, reference);
    }

    /// Moves the named axes directly to a reference point.
    pub fn go_to_reference(&mut self, named: AxisMask, reference: &PerAxis<Option<f64>>) {
        let home = reference.map(|place| place.unwrap_or(0.0));
        self.by_axes(|kernel| {
            if kernel.rules.frames.work_rotation && !kernel.state.frames.is_plain() {
                kernel.rapid_to_turned_reference(named, &home);
            } else {
                kernel.rapid_to_machine_point(home, named);
            }
        });
        self.end_length_if(named.has(Z) && self.rules.length.ended_by.reference_return);
    }

    /// Moves to the coordinates that the point has in the rotated system: an axis that is not named keeps its
    /// program coordinate.
    fn rapid_to_turned_reference(&mut self, named: AxisMask, home: &Position) {
        let state = &mut self.state;
        let total = state.offsets.total();
        let work: Position = std::array::from_fn(|axis| home[axis] - total[axis]);
        let place = state.frames.inverse().point(&work);
        let place_known = named.and(state.frames.inverse().known(state.offsets.known()));
        let (from, from_known) = (state.position, state.known);
        state.position = state.control_position.take().unwrap_or(state.position);
        named.iter().for_each(|axis| state.position[axis as usize] = place[axis as usize]);
        state.known = state.known.without(named).or(place_known);
        state.machine_known = state.machine_known.or(named);
        state.astray = state.astray.without(named);
        state.leave_machine_start(named);
        let motion = Move { from, to: state.position, from_known, to_known: state.known };
        self.emit(CommandKind::Rapid { motion, path: self.rules.rapid });
    }

    /// G53: moves to a point of machine coordinates, by a rapid or at the active feed.
    pub fn to_machine_point(&mut self, at: &dyn Statement, place: Position, named: AxisMask) {
        self.end_length_if(named.has(Z) && self.rules.length.ended_by.machine_move);
        self.by_axes(|kernel| kernel.move_to_machine_point(at, place, named));
    }

    fn move_to_machine_point(&mut self, at: &dyn Statement, place: Position, named: AxisMask) {
        let rapid = self.state.motion == ModalMotion::Rapid;
        if rapid || self.rules.machine_move_is_rapid {
            let motion = self.machine_move(place, named);
            let path = self.path_of_rapid();
            return self.emit(CommandKind::Rapid { motion, path });
        }
        let motion = self.machine_move(place, named);
        let feed = self.feed_for(at, &motion, None);
        self.emit(CommandKind::Line { motion, feed });
    }

    fn rapid_to_machine_point(&mut self, place: Position, named: AxisMask) {
        let motion = self.machine_move(place, named);
        let path = self.rules.rapid;
        self.emit(CommandKind::Rapid { motion, path });
    }

    /// The move, in program coordinates, to a point of machine coordinates. Frames do not act on the point; an
    /// axis that is not named keeps its machine coordinate.
    fn machine_move(&mut self, place: Position, named: AxisMask) -> Move {
        let total = self.state.offsets.total();
        let offset_known = self.state.offsets.known();
        let (from, from_known) = (self.state.position, self.state.known);
        // In rotated coordinates, a control whose position differs from the machine's also moves the other axes.
        let assumed = self.state.control_position.take().filter(|_| !self.state.frames.is_plain());
        let mut work = match assumed {
            Some(place) => self.state.frames.map().point(&place),
            None => self.state.work_position(),
        };
        for axis in named.iter() {
            let index = axis as usize;
            work[index] = place[index] - total[index];
        }
        let known = self.state.frames.map().known(from_known);
        let known = known.without(named).or(named.and(offset_known));
        self.state.stand_at(work, known);
        self.state.machine_known = self.state.machine_known.or(named);
        self.state.astray = self.state.astray.without(named);
        self.state.leave_machine_start(named);
        Move { from, to: self.state.position, from_known, to_known: self.state.known }
    }
}
