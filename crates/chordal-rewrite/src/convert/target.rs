//! The machine that the new program is proved on.

use chordal::control::{ControlTable, RapidPath, SettingField, ToolLengths, WorkName, WorkNaming};
use chordal::machine::{RapidShape, SettingEntry, SettingValue, mirrored_tip, work_offset_name};
use chordal::{Job, Machine};

/// The target with what the old machine's tables hold: the cut depends on both.
pub(super) fn with_tables_of(job: &Job, target: &Machine, tables: [&ControlTable; 2]) -> Machine {
    let old = job.machine();
    let mut machine = target.clone();
    take_tables(&mut machine, job, tables[1].work_names);
    // Who sets the work offset with each tool does so on the new machine, too.
    if job.rules().length.source != ToolLengths::Table {
        machine.set("settings.tool_lengths=\"touched-off\"").ok();
    }
    goes_on_after_refusal(&mut machine, tables[1]);
    if job.profile().turns {
        machine.spindle_max_rpm = old.spindle_max_rpm;
        // X and Z of lathes have speeds of their own.
        take_axis_speeds(&mut machine, old);
    }
    let [one, other] = tables.map(|table| table.parameters.rules.turning.tips_mirrored);
    if one != other {
        for tool in machine.tools.values_mut() {
            tool.tip = tool.tip.map(mirrored_tip);
        }
    }
    machine.macros = old.macros.clone();
    machine
}

/// Takes over the tables of the old machine, and what else its programs depend on whatever their language. `names` are those
/// of the target's work offsets.
pub(super) fn take_tables(machine: &mut Machine, job: &Job, names: WorkNaming) {
    let old = job.machine();
    // The shape of rapids is the machine's; compared with each other, both go alike.
    machine.rapid = Some(match job.rules().rapid {
        RapidPath::DogLeg => RapidShape::DogLeg,
        RapidPath::Straight | RapidPath::AtFeed(_) => RapidShape::Straight,
    });
    machine.tools = old.tools.clone();
    let offsets = old.work_offsets.iter();
    machine.work_offsets = offsets.map(|(name, offset)| (renamed(name, names), *offset)).collect();
    machine.home = old.home;
    machine.reference_points = old.reference_points;
    machine.probe = old.probe;
    machine.switches = old.switches;
    machine.clearance_mm = old.clearance_mm.or(machine.clearance_mm);
}

/// Takes over how fast the axes are: a dog-leg bends where the faster one arrives.
pub(super) fn take_axis_speeds(machine: &mut Machine, old: &Machine) {
    for (limits, own) in machine.axes.iter_mut().zip(&old.axes) {
        if let (Some(limits), Some(own)) = (limits, own) {
            limits.max_velocity = own.max_velocity;
        }
    }
}

/// One block that a firmware refuses does not hide what comes after it: each is found.
fn goes_on_after_refusal(machine: &mut Machine, table: &ControlTable) {
    if let Some(setting) =
        table.settings.iter().find(|setting| setting.field == SettingField::AFTER_REFUSAL)
    {
        let value = SettingValue::Text("continue".into());
        machine.settings.insert(setting.name.into(), SettingEntry { value, location: None });
    }
}

/// The name under which the target has a work offset: E7 is G54.1 P1 and G154 P1.
fn renamed(name: &str, names: WorkNaming) -> String {
    let number = |text: &str| text.trim().parse::<u32>().ok();
    let ordinal = match name.split_once(" P") {
        Some((code, extended)) => {
            // Mach3 counts G54 to G59 with them.
            let before = if code == "G59" { 0 } else { 6 };
            number(extended).map(|number| number + before)
        }
        None => match name.strip_prefix("G59.") {
            Some(point) => number(point).map(|number| number + 6),
            None => name
                .strip_prefix('E')
                .and_then(number)
                .or_else(|| name.strip_prefix('G').and_then(number).map(ordinal_of_code)),
        },
    };
    let Some(ordinal) = ordinal.filter(|ordinal| *ordinal > 0) else { return name.into() };
    let ordinal = u16::try_from(ordinal).ok();
    let Some(new) = ordinal.and_then(|ordinal| names.key_of_ordinal(ordinal)) else {
        return name.into();
    };
    work_offset_name(&new).unwrap_or(new)
}

/// The number of the work offset with a code of its own: G54 to G59, G505 to G599.
fn ordinal_of_code(code: u32) -> u32 {
    let code = u16::try_from(code).unwrap_or(0);
    WorkName::G(code).ordinal()
}
