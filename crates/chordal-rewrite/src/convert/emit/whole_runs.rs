//! Programs that are written from their run alone.

use chordal::CommandKind;
use chordal::control::{
    Action, AxisMask, Control, MotionCode, OnceCode, Position, StartingModes, TappedHole, WorkName,
};
use chordal::machine::AXIS_LETTERS;

use super::lathe::LatheModes;
use super::{CommandEmitter, EmitRefusal};
use crate::convert::numbers;
use crate::convert::tap::TappedThread;
use crate::source::WordStyle;

/// The spelling of words in a program that is written from its run.
pub(in crate::convert) const WRITTEN_STYLE: WordStyle =
    WordStyle { spaced: true, leading_zero: true, two_digits: false };

impl<'a> CommandEmitter<'a> {
    /// For a program that is written from its run alone.
    pub(in crate::convert) fn of_run(
        to: &'a Control,
        start: StartingModes,
        tolerance_mm: f64,
        digits: Option<usize>,
    ) -> CommandEmitter<'a> {
        CommandEmitter {
            from: None,
            to,
            style: WRITTEN_STYLE,
            tolerance_mm,
            units: start.units,
            digits,
            motion: None,
            incremental: Some(false),
            plane: start.plane,
            feed: None,
            pending: Vec::new(),
            lines: Vec::new(),
            printed: false,
            unwritten: Vec::new(),
            x_factor: 1.0,
            lathe: LatheModes::of_mill(),
        }
    }

    /// Writes one command. Words that belong to the next move wait for it.
    pub(in crate::convert) fn step(&mut self, command: &CommandKind) -> Result<(), EmitRefusal> {
        self.command(command)
    }

    /// Chooses a work offset with the next move.
    pub(in crate::convert) fn work_system(&mut self, name: WorkName) -> Result<(), EmitRefusal> {
        self.work_offset(name)
    }

    /// A tap where the tool stands.
    pub(in crate::convert) fn tapped_hole(&mut self, hole: &TappedHole) -> Result<(), EmitRefusal> {
        self.tap(&TappedThread::of_hole(hole))
    }

    /// A rapid of some axes in machine coordinates (G53).
    pub(in crate::convert) fn machine_rapid(
        &mut self,
        place: &Position,
        axes: AxisMask,
    ) -> Result<(), EmitRefusal> {
        let rapid = Action::Motion(MotionCode::Rapid);
        if self.motion != Some(rapid) {
            // Some controls take no other G code in a block with G53.
            let code = self.due(rapid)?;
            self.pending.push(code);
            self.motion = Some(rapid);
        }
        self.flush();
        let mut words = vec![self.due(Action::Once(OnceCode::MachineCoordinates))?];
        for axis in axes.iter() {
            let index = axis as usize;
            let value = match index {
                0..3 => self.place(index, place[index]),
                _ => numbers::plain(place[index].to_degrees(), 3, self.style),
            };
            words.push(format!("{}{value}", char::from(AXIS_LETTERS.as_bytes()[index])));
        }
        self.line(&words);
        Ok(())
    }
}
