//! The values of active words and codes that macro programs can read.

use chordal_command::{CompensationSide, FeedMode, Units, WorkName};
use chordal_dialect::Action;
use chordal_dialect::macros::ModalGroup;
use chordal_geometry::{Plane, TurnDirection};
use chordal_kernel::ModalMotion;
use chordal_kernel::rules::CycleKind;

use super::super::Interpreter;

impl Interpreter<'_> {
    /// The last value of a letter; `None` when the program has none.
    pub(super) fn modal_word(&self, letter: u8) -> Option<f64> {
        let state = &self.kernel.state;
        match letter {
            b'B' => state.known_position(4).map(f64::to_degrees),
            b'D' => state.radius_offset.map(f64::from),
            b'F' => self.feed_word(),
            b'H' => state.named_length.or(state.offsets.length().number).map(f64::from),
            b'N' => self.sequence.map(|number| number.to_f64()),
            b'O' => self.program_at(self.program).head.number.map(f64::from),
            b'S' => self.speed_word(),
            b'T' if state.unknown.tool => None,
            b'T' => state.selected_tool.map(f64::from).or_else(|| self.tool_in_spindle()),
            b'P' => match state.offsets.active() {
                WorkName::Extended(number) => Some(f64::from(number)),
                _ => None,
            },
            _ => self.macros.last_words.get((letter - b'A') as usize).copied().flatten(),
        }
    }

    /// The number of F: as it was written, also where the units have changed since, or of a feed that came about in
    /// another way in the unit of the program; `None` before an F.
    pub(super) fn feed_word(&self) -> Option<f64> {
        let state = &self.kernel.state;
        let feed = state.feed?;
        if let Some((_, number)) = self.feed_number.filter(|(value, _)| *value == feed) {
            return Some(number);
        }
        Some(match state.feed_mode {
            FeedMode::PerTime => feed * 60.0 / self.unit(),
            FeedMode::InverseTime => feed * 60.0,
            FeedMode::PerRevolution => feed / self.unit(),
        })
    }

    /// Ten times the code of the active motion.
    pub(super) fn motion_row_code(&self) -> f64 {
        let action = self.kernel.state.motion_mode().map(Action::from);
        let row = self.control.table.g_codes.iter().find(|row| Some(row.action) == action);
        row.map_or(0.0, |row| f64::from(row.code))
    }

    /// The active code of a group.
    pub(super) fn modal_code(&self, group: ModalGroup) -> f64 {
        let state = &self.kernel.state;
        match group {
            ModalGroup::Motion => match state.motion {
                ModalMotion::Rapid | ModalMotion::None => 0.0,
                ModalMotion::Linear => 1.0,
                ModalMotion::Thread | ModalMotion::RigidTap => 33.0,
                ModalMotion::Arc(TurnDirection::Cw) | ModalMotion::Spiral(TurnDirection::Cw) => 2.0,
                ModalMotion::Arc(TurnDirection::Ccw) | ModalMotion::Spiral(TurnDirection::Ccw) => {
                    3.0
                }
                ModalMotion::Spline(form) => self.spline_code(form) / 10.0,
                ModalMotion::Turn(_) | ModalMotion::Probe { .. } | ModalMotion::ThreadPasses => {
                    self.motion_row_code() / 10.0
                }
            },
            ModalGroup::Plane => match state.plane {
                Plane::Xy => 17.0,
                Plane::Zx => 18.0,
                Plane::Yz => 19.0,
            },
            ModalGroup::Distance if state.incremental => 91.0,
            ModalGroup::Distance => 90.0,
            ModalGroup::FeedMode => match state.feed_mode {
                FeedMode::PerTime => 94.0,
                FeedMode::InverseTime => 93.0,
                FeedMode::PerRevolution => 95.0,
            },
            ModalGroup::Units => self.units_code(),
            ModalGroup::Compensation => match state.side {
                CompensationSide::Off => 40.0,
                CompensationSide::Left => 41.0,
                CompensationSide::Right => 42.0,
            },
            ModalGroup::Length => match state.offsets.length() {
                length if length.number.is_none() => 49.0,
                length if length.minus => 44.0,
                _ => 43.0,
            },
            ModalGroup::Cycle => state.cycle.map_or(80.0, |cycle| self.cycle_code(cycle.kind)),
            ModalGroup::ReturnLevel if state.return_to_r => 99.0,
            ModalGroup::ReturnLevel => 98.0,
            ModalGroup::WorkOffset => match state.offsets.active() {
                WorkName::G(number) => f64::from(number),
                WorkName::Extended(_) => self.extended_code(),
                _ => 54.0,
            },
            ModalGroup::ModalCall if self.macros.active > 0 => 66.0,
            ModalGroup::ModalCall => 67.0,
            ModalGroup::Fixed(code) => f64::from(code),
        }
    }

    fn units_code(&self) -> f64 {
        let by_g70 = self.control.parameters.unit_codes == chordal_dialect::UnitCodes::G70;
        match self.kernel.state.units {
            Units::Inch if by_g70 => 70.0,
            Units::Millimetre if by_g70 => 71.0,
            Units::Inch => 20.0,
            Units::Millimetre => 21.0,
        }
    }

    fn cycle_code(&self, kind: CycleKind) -> f64 {
        let rows = self.control.table.g_codes;
        let row = rows.iter().find(|row| row.action == Action::Cycle(kind));
        row.map_or(80.0, |row| f64::from(row.code) / 10.0)
    }

    /// The code of extended work offsets: 54.1 or 154.
    fn extended_code(&self) -> f64 {
        let code = self.control.table.work_names.extended;
        code.trim_start_matches('G').parse().unwrap_or(54.0)
    }
}
