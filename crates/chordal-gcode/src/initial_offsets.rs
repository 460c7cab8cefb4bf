//! The work coordinate system and the offsets before the first block.

use chordal_command::WorkName;
use chordal_dialect::Control;
use chordal_kernel::Offsets;
use chordal_machine::{AXES, Machine};

/// The work coordinate system before the first block.
pub fn initial_work_offset(control: &Control) -> WorkName {
    match control.table.work_names.by_e {
        true => WorkName::E(1),
        false if control.parameters.preset_writes_system => NATIVE,
        false => WorkName::G(54),
    }
}

/// The offsets before the first block.
pub fn initial_offsets(control: &Control, machine: &Machine) -> Offsets {
    let start = initial_work_offset(control);
    let mut offsets = Offsets::new(machine, start, control.table.work_names);
    if start == NATIVE {
        let key = offsets.key(NATIVE);
        (0..AXES).for_each(|axis| offsets.write_work(&key, axis, 0.0, false));
        offsets.update();
    }
    offsets
}

/// The work coordinate system that equals machine coordinates until a preset writes it.
pub const NATIVE: WorkName = WorkName::G(53);
