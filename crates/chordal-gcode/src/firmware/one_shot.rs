//! Codes that take the axis words of their block, and what they write.

use chordal_dialect::OnceCode;
use chordal_dialect::firmware::FirmwareError;
use chordal_dialect::table::DataTarget;
use chordal_syntax::Letters;

use super::block_check::BlockCheck;
use super::codes::{AxisUse, byte};
use super::line::LineFault;
use super::memory::{FirmwareMemory, FirmwareMotion};

impl BlockCheck<'_> {
    /// Codes that take the axis words, and those that store a place; where the block goes.
    pub fn once_codes(&mut self, after: &mut FirmwareMemory) -> Result<[f32; 3], LineFault> {
        if self.once == Some(OnceCode::SetData) {
            self.set_data(after)?;
            return Ok(after.position);
        }
        if self.once == Some(OnceCode::PresetPosition) {
            if !self.has_axes() {
                return self.refuse(FirmwareError::NoAxes, "G");
            }
            for axis in 0..3 {
                if let Some(value) = self.axis(axis) {
                    after.preset[axis] =
                        after.position[axis] - after.system()[axis] - value - after.length[axis];
                }
            }
            after.kept_preset = after.preset;
            return Ok(after.position);
        }
        let mut target = after.position;
        if self.axis_use != Some(AxisUse::Length) {
            for (axis, target) in target.iter_mut().enumerate() {
                let Some(value) = self.axis(axis) else { continue };
                *target = if self.once == Some(OnceCode::MachineCoordinates) {
                    value
                } else if self.modes.incremental {
                    after.position[axis] + value
                } else {
                    after.machine(axis, value)
                };
            }
        }
        if let Some(OnceCode::ReturnToReference { second }) = self.once {
            let stored = after.stored[usize::from(second)];
            for (axis, stored) in stored.into_iter().enumerate() {
                if !self.has_axes() || self.axis(axis).is_some() {
                    after.position[axis] = stored;
                }
            }
        }
        if let Some(number) = self.stores {
            after.stored[number] = after.position;
        }
        if let Some(OnceCode::ClearPreset { keep }) = self.once {
            if !keep {
                after.kept_preset = [0.0; 3];
            }
            after.preset = [0.0; 3];
        }
        if self.once == Some(OnceCode::RestorePreset) {
            after.preset = after.kept_preset;
        }
        let cuts_straight =
            matches!(self.modes.motion, FirmwareMotion::Rapid | FirmwareMotion::Linear);
        if self.once == Some(OnceCode::MachineCoordinates) && !cuts_straight {
            return self.refuse(FirmwareError::MachineMotion, "G");
        }
        Ok(target)
    }

    fn set_data(&mut self, after: &mut FirmwareMemory) -> Result<(), LineFault> {
        let kind = byte(self.number(b'L').unwrap_or(0.0));
        let rows = self.control.table.set_data;
        let row =
            rows.iter().find(|(number, _)| *number == u16::from(kind) && self.written.has(b'L'));
        let target = row.map(|(_, target)| *target);
        if target == Some(DataTarget::Reload) {
            self.use_up(Letters::of("LP"));
            return Ok(());
        }
        if !self.has_axes() && !matches!(target, Some(DataTarget::ToolTable)) {
            return self.refuse(FirmwareError::NoAxes, "G");
        }
        if !self.written.meets(Letters::of("PL")) {
            return self.refuse(FirmwareError::NoValue, "G");
        }
        let of_tool = matches!(
            target,
            Some(
                DataTarget::ToolTable | DataTarget::ToolFromPosition | DataTarget::ToolFromFixture
            )
        );
        if of_tool && self.control.parameters.build.tool_table {
            self.use_up(Letters::of("LPR"));
            return Ok(());
        }
        let system = self.number(b'P').unwrap_or(0.0).trunc();
        if system > self.firmware.largest[2] as f32 {
            return self.refuse(FirmwareError::WorkOffset, "P");
        }
        let from_position = target == Some(DataTarget::WorkOffsetFromPosition);
        let provided = target == Some(DataTarget::WorkOffset);
        if !provided && !from_position || provided && self.written.has(b'R') {
            return self.refuse(FirmwareError::Unknown, "LG");
        }
        self.use_up(Letters::of("PL"));
        let index = match system as usize {
            0 => after.modes.system,
            number => number - 1,
        };
        for axis in 0..3 {
            let Some(value) = self.axis(axis) else { continue };
            after.systems[index][axis] = match from_position {
                true => after.position[axis] - after.preset[axis] - value - after.length[axis],
                false => value,
            };
        }
        Ok(())
    }
}
