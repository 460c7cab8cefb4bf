//! One-shot codes that take the axis words: dwell, reference points, machine coordinates,
//! presets and shifts.

use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_geometry::Direction;
use chordal_syntax::Block;

use super::Interpreter;
use super::values::AXIS_OF;
use crate::command::{AxisMask, CommandKind, FeedAlong, Move, Position, Side};
use crate::compensation::Allowance;
use crate::state::Motion;
use crate::table::Action;

impl Interpreter<'_> {
    pub(super) fn one_shot(&mut self, block: &Block, action: Action, at: usize) {
        let to_machine = matches!(
            action,
            Action::ReturnToReference { .. }
                | Action::ReturnFromReference
                | Action::MachineCoordinates
        );
        if to_machine && self.state.side != Side::Off {
            self.reference_in_compensation(block, at);
        }
        match action {
            Action::Dwell => self.dwell(block, at),
            Action::SetData => self.set_data(block, at),
            Action::ReturnToReference { second } => {
                self.end_cycle_if(self.control.parameters.cycles.cancel.by_reference);
                self.return_to_reference(block, second);
            }
            Action::ReturnFromReference => {
                self.end_cycle_if(self.control.parameters.cycles.cancel.by_reference);
                self.return_from_reference(block);
            }
            Action::Pattern(pattern) => self.pattern(block, at, pattern),
            Action::Probe { must_hit } => self.probe_move(block, at, must_hit),
            Action::MachineCoordinates => self.machine_coordinates(block),
            Action::LocalShift => self.local_shift(block),
            Action::PresetPosition => self.preset_position(block),
            Action::ClearPreset { keep } => self.clear_preset(keep),
            Action::RestorePreset => {
                let preset = self.preset_kept;
                self.state.shift_coordinates(|offsets| offsets.set_preset(preset));
                self.emit_work_offset();
            }
            Action::CircularPocketCw => self.circular_pocket(block, at, Direction::Cw),
            Action::CircularPocketCcw => self.circular_pocket(block, at, Direction::Ccw),
            Action::GeneralPocket => self.general_pocket(block, at),
            Action::CornerArc { .. } => self.corner_arc(block, true),
            // Told when its mode was taken; its axis words belong to it.
            _ => {}
        }
    }

    fn dwell(&mut self, block: &Block, at: usize) {
        let words = self.control.table.dwell;
        let found = words.iter().find_map(|rule| block.last(rule.letter).map(|word| (rule, *word)));
        let Some((rule, word)) = found else {
            let span = self.span(block.words[at].range);
            let letters: Vec<String> =
                words.iter().map(|rule| (rule.letter as char).to_string()).collect();
            let help = format!("give the time with {}", letters.join(", "));
            return self.missing_word(span, "a dwell without a time".into(), &help);
        };
        let Some(number) = self.literal(&word) else { return };
        let unit = if number.has_point { rule.point_s } else { rule.integer_s };
        let seconds = number.to_f64() * unit;
        if seconds < 0.0 {
            self.report(
                Diagnostic::new(
                    Code::BadWordValue,
                    self.span(word.range),
                    format!("a dwell cannot be negative: {}{number}", word.letter as char),
                )
                .help("remove the sign"),
            );
            return;
        }
        self.emit(CommandKind::Dwell { seconds, label: None });
    }

    /// G28, G29, G30 and G53 while the tool is beside the contour.
    fn reference_in_compensation(&mut self, block: &Block, at: usize) {
        let refused = self.control.parameters.compensation.coordinate_change == Allowance::Refused;
        let (first, second, _) = self.state.plane.axes();
        let named = self.axis_words(block);
        if !refused && named[first].is_none() && named[second].is_none() {
            return;
        }
        let span = self.span(block.words[at].range);
        let message = "a move to a machine point while cutter compensation is on";
        let diagnostic = Diagnostic::new(Code::ReferenceInCompensation, span, message)
            .severity(if refused { Severity::Error } else { Severity::Warning })
            .help("cancel compensation with G40 first");
        self.report(diagnostic);
    }

    /// G28 and G30: over the point that the words give, then home with the axes they name.
    fn return_to_reference(&mut self, block: &Block, second: bool) {
        let (target, mut named) = self.target(block);
        let place = match second {
            false => self.machine.home,
            true => {
                let number = self.count_of(block, b'P').unwrap_or(2);
                let index = (number.clamp(2, 4) - 2) as usize;
                self.machine.reference_points[index]
            }
        };
        let bare = named == AxisMask::NONE;
        if bare {
            if !self.control.parameters.bare_home_moves_all {
                let span = self.span(block.range);
                return self.missing_word(
                    span,
                    "a return to the reference point without an axis".into(),
                    "give the axes that return, such as `G91 G28 Z0`",
                );
            }
            named = self.control.axes();
        } else if target != self.state.position {
            self.rapid(target, named);
        }
        let mut home = [0.0; 6];
        for axis in named.iter() {
            home[axis as usize] = place[axis as usize].unwrap_or(0.0);
        }
        self.rapid_to_machine_point(home, named);
    }

    /// G29: back over the point of the last G28, of which the end alone is known here.
    fn return_from_reference(&mut self, block: &Block) {
        let (target, named) = self.target(block);
        if named != AxisMask::NONE {
            self.rapid(target, named);
        }
    }

    /// G53: the words of this block are machine coordinates.
    fn machine_coordinates(&mut self, block: &Block) {
        let mut place = [0.0; 6];
        let mut named = AxisMask::NONE;
        for word in &block.words {
            let axis = AXIS_OF[word.letter as usize] as usize;
            if axis < 6
                && !word.comma
                && let Some(value) = self.axis_value(word, axis)
            {
                place[axis] = value;
                named.insert(axis);
            }
        }
        let named = named.and(self.control.axes());
        if named == AxisMask::NONE {
            return;
        }
        let rapid = self.state.motion == Motion::Rapid;
        if rapid || self.control.parameters.machine_move_is_rapid {
            return self.rapid_to_machine_point(place, named);
        }
        let motion = self.machine_move(place, named);
        let mut feed = self.feed_for(block, &motion, None);
        feed.along = FeedAlong::Path;
        self.emit(CommandKind::Line { motion, feed });
    }

    fn rapid(&mut self, target: Position, named: AxisMask) {
        let motion = self.moved_to(target, named);
        let path = self.control.parameters.rapid;
        self.emit(CommandKind::Rapid { motion, path });
    }

    fn rapid_to_machine_point(&mut self, place: Position, named: AxisMask) {
        let motion = self.machine_move(place, named);
        let path = self.control.parameters.rapid;
        self.emit(CommandKind::Rapid { motion, path });
    }

    /// The move to a point of machine coordinates, as program coordinates see it.
    fn machine_move(&mut self, place: Position, named: AxisMask) -> Move {
        let total = self.state.offsets.total();
        let offset_known = self.state.offsets.known();
        let from = self.state.position;
        let from_known = self.state.known;
        let mut to = from;
        for axis in named.iter() {
            let index = axis as usize;
            to[index] = place[index] - total[index];
        }
        self.state.position = to;
        self.state.machine_known = self.state.machine_known.or(named);
        self.state.known = from_known.without(named).or(named.and(offset_known));
        Move { from, to, from_known, to_known: self.state.known }
    }

    /// G52.
    fn local_shift(&mut self, block: &Block) {
        let values = self.axis_words(block);
        self.state.shift_coordinates(|offsets| {
            for (axis, value) in values.iter().enumerate() {
                if let Some(value) = value {
                    offsets.set_shift(axis, *value);
                }
            }
        });
        self.emit_work_offset();
    }

    /// G92: the present position gets these coordinates.
    fn preset_position(&mut self, block: &Block) {
        let values = self.axis_words(block);
        let position = self.state.position;
        let machine_known = self.state.machine_known;
        let clears_shift = self.control.parameters.preset_clears_shift;
        self.state.shift_coordinates(|offsets| {
            for (axis, value) in values.iter().enumerate() {
                if let Some(value) = value {
                    if clears_shift {
                        offsets.move_shift_to_preset(axis);
                    }
                    offsets.add_preset(axis, position[axis] - value, machine_known.has(axis));
                }
            }
        });
        for (axis, value) in values.iter().enumerate() {
            if let Some(value) = value {
                // Exactly what was written, not a difference of sums.
                self.state.position[axis] = *value;
                self.state.known.insert(axis);
            }
        }
        self.emit_work_offset();
    }

    /// G92.1 and G92.2.
    fn clear_preset(&mut self, keep: bool) {
        self.preset_kept = if keep { self.state.offsets.preset() } else { [0.0; 6] };
        self.state.shift_coordinates(|offsets| offsets.set_preset([0.0; 6]));
        self.emit_work_offset();
    }

    /// The axis words of a block as they stand, without regard to G90 and G91.
    pub(super) fn axis_words(&mut self, block: &Block) -> [Option<f64>; 6] {
        let mut values = [None; 6];
        for word in &block.words {
            let axis = AXIS_OF[word.letter as usize] as usize;
            if axis < 6 && !word.comma {
                values[axis] = self.axis_value(word, axis);
            }
        }
        values
    }
}
