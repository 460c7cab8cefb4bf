//! `chordal machines`: the list of machines, and one with its settings.

use std::path::PathBuf;

use chordal::Machine;
use chordal::control::{COMMON_SETTINGS, Certainty, Control, control_profile, control_title, dump};
use chordal::machine::{Axis, builtin_names, schema_reference};
use chordal_load::machine;
use comfy_table::{CellAlignment, ColumnConstraint, ContentArrangement, Table, Width};

use crate::failure::{CommandFailure, ExitVerdict};
use crate::numbers::short;
use crate::summary::plain_table;
use crate::terminal::say;
use chordal_editor::meaning::{both_units, own_value};

const EXAMPLES: &str = "\
Examples:
  chordal machines                       the built-in machines
  chordal machines haas-vf2              axes, limits and the control's settings
  chordal machines haas-vf2 --toml       as a machine file, to start your own
  chordal machines shop/vf2.toml --toml  a file with all that it inherits
  chordal machines --settings dump.txt --toml   a GRBL machine from what it printed for `$$`
  chordal machines shapeoko-3 --dump     its settings as GRBL prints them
  chordal machines --schema              every key of a machine file (Markdown)";

/// Lists machines, or shows one with its control's settings
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// A built-in machine or a machine file
    #[arg(value_name = "NAME|FILE.toml", conflicts_with = "schema")]
    name: Option<String>,

    /// Takes a GRBL machine's settings from what it printed for `$$`
    #[arg(long, value_name = "dump.txt", conflicts_with = "schema")]
    settings: Option<PathBuf>,

    /// Prints the machine as a file, with everything it inherits
    #[arg(long, conflicts_with = "dump")]
    toml: bool,

    /// Prints the settings of a GRBL machine as it would for `$$`
    #[arg(long)]
    dump: bool,

    /// Prints the keys of a machine file
    #[arg(long)]
    schema: bool,
}

pub fn run(args: &Args) -> Result<ExitVerdict, CommandFailure> {
    let text = match args.machine()? {
        _ if args.schema => schema_reference(),
        None if args.toml || args.dump => return Err(no_machine()),
        None => list(),
        Some(machine) if args.toml => machine::own_file(machine),
        Some(machine) if args.dump => dumped(&machine)?,
        Some(machine) => one(&machine),
    };
    say(&text)?;
    Ok(ExitVerdict::Clean)
}

impl Args {
    /// The machine that is named, or the one that a dump is of.
    fn machine(&self) -> Result<Option<Machine>, CommandFailure> {
        let named = self.name.as_deref().map(machine::named).transpose()?;
        let Some(dump) = &self.settings else { return Ok(named) };
        let mut machine = named.unwrap_or_else(|| machine::typical(machine::dumped()));
        machine::set_dump(&mut machine, dump)?;
        Ok(Some(machine))
    }
}

/// What its firmware prints for `$$`.
fn dumped(machine: &Machine) -> Result<String, CommandFailure> {
    dump::write(machine).ok_or_else(|| {
        let title = control_title(machine.control);
        let message = format!("{title} is no control that prints its settings for `$$`");
        CommandFailure::wrong(message, "name a machine of GRBL, or print this one with --toml")
    })
}

fn no_machine() -> CommandFailure {
    CommandFailure::wrong("no machine is named", "name one, or give --settings dump.txt")
}

fn list() -> String {
    let mut table = plain_table(&["name", "control", "machine"], 3);
    for name in builtin_names() {
        if let Ok(machine) = Machine::from_builtin(name) {
            table.add_row([name, control_title(machine.control), &machine.title]);
        }
    }
    lines(&table, "")
}

fn one(machine: &Machine) -> String {
    let mut text = format!("{}: {}\n", machine.name, machine.title);
    for note in &machine.notes {
        text.push_str(&format!("  {note}\n"));
    }
    if let Some(control) = control_profile(machine.control) {
        text.push_str(&format!("\nControl   {} ({})\n", control.title, control.name));
        text.push_str(&format!("Source    {}\n", control.source));
    }
    for (label, value) in limits(machine) {
        text.push_str(&format!("{label:10}{value}\n"));
    }
    text.push('\n');
    text.push_str(&lines(&axes(machine), ""));
    if let Some((control, _)) = Control::of(machine) {
        text.push_str("\nSettings: change them in [settings] of a machine file, or with --set \"settings.NAME=VALUE\"\n\n");
        text.push_str(&lines(&settings(&control), ""));
    }
    text
}

fn speeds(mm_per_s: f64) -> String {
    format!("{} mm/min ({} in/min)", short(mm_per_s * 60.0, 1), short(mm_per_s * 60.0 / 25.4, 2))
}

fn limits(machine: &Machine) -> Vec<(&'static str, String)> {
    let mut rows = Vec::new();
    if let Some(feed) = machine.feed.max_mm_per_s {
        rows.push(("Feed", format!("up to {}", speeds(feed))));
    }
    if let Some(rpm) = machine.spindle_max_rpm {
        rows.push(("Spindle", format!("up to {} rpm", short(rpm, 1))));
    }
    if let Some(rpm) = machine.live_tool_max_rpm {
        rows.push(("Live tool", format!("up to {} rpm", short(rpm, 1))));
    }
    if let Some(shape) = machine.rapid {
        rows.push(("Rapids", shape.as_str().to_string()));
    }
    if let Some(clearance) = machine.clearance_mm {
        rows.push(("Clearance", format!("Z {}", both_units(clearance))));
    }
    if let Some(seconds) = machine.times.tool_change_s {
        rows.push(("Tools", format!("a change takes {} s", short(seconds, 2))));
    }
    let names: Vec<&str> = machine.work_offsets.keys().map(String::as_str).collect();
    if !names.is_empty() {
        rows.push(("Offsets", names.join(", ")));
    }
    rows
}

fn axes(machine: &Machine) -> Table {
    let header = ["axis", "travel", "rapid", "acceleration", "jerk"];
    let mut table = plain_table(&header, header.len());
    for axis in Axis::ALL {
        let Some(limits) = machine.axis(axis) else { continue };
        let (unit, factor) =
            if axis.is_rotary() { ("deg", 1f64.to_degrees()) } else { ("mm", 1.0) };
        let rate = |value: Option<f64>, per: &str, times: f64| {
            value.map_or_else(
                || "-".into(),
                |v| format!("{} {unit}/{per}", short(v * factor * times, 3)),
            )
        };
        let travel = limits.travel.map_or_else(
            || "no limit".to_string(),
            |(low, high)| {
                format!("{} to {} {unit}", short(low * factor, 3), short(high * factor, 3))
            },
        );
        table.add_row([
            axis.to_string(),
            travel,
            rate(limits.max_velocity, "min", 60.0),
            rate(limits.max_acceleration, "s^2", 1.0),
            rate(limits.max_jerk, "s^3", 1.0),
        ]);
    }
    table
}

/// The control's own settings, then those that all controls share.
fn settings(control: &Control) -> Table {
    let header = ["setting", "value", "meaning", "certainty", "source"];
    let mut table = plain_table(&header, header.len());
    for setting in control.table.settings {
        table.add_row([
            setting.name,
            &own_value(setting, &control.parameters),
            setting.text,
            certainty(setting.certainty),
            setting.source,
        ]);
    }
    for setting in COMMON_SETTINGS {
        // How sure it is and why stands with the control's own name of the same thing.
        let own = control.table.settings.iter().find(|own| own.field == setting.field);
        let (sure, source) = match own {
            Some(own) => (certainty(own.certainty), format!("see {}", own.name)),
            None => ("", String::new()),
        };
        let value = own_value(setting, &control.parameters);
        table.add_row([setting.name, &value, setting.text, sure, &source]);
    }
    // Long meanings are broken at a width that fits any terminal and any mail.
    table.set_content_arrangement(ContentArrangement::Dynamic).set_width(120);
    if let Some(column) = table.column_mut(2) {
        column.set_constraint(ColumnConstraint::UpperBoundary(Width::Fixed(44)));
        column.set_cell_alignment(CellAlignment::Left);
    }
    table
}

fn certainty(certainty: Certainty) -> &'static str {
    match certainty {
        Certainty::Documented => "documented",
        Certainty::Inferred => "inferred",
        Certainty::Practice => "trade",
        Certainty::Unknown => "unknown",
    }
}

fn lines(table: &Table, indent: &str) -> String {
    table.lines().map(|line| format!("{indent}{}\n", line.trim_end())).collect()
}
