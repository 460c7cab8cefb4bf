//! `docs/machine-files.md`: every table and key of a machine file, with an example of each.

use chordal::machine::{SchemaKey, schema_keys};

use crate::reference::{HEAD, cell, table_row};

/// A table of a machine file.
struct TableSection {
    /// What its keys begin with; empty for those outside of tables.
    table: &'static str,
    about: &'static str,
    /// In TOML, with every key.
    example: &'static str,
}

/// The page.
pub(super) fn page() -> String {
    let mut text = format!("# Machine files\n\n{HEAD}{INTRODUCTION}");
    let keys = schema_keys();
    let mut tables: Vec<&str> = Vec::new();
    for key in &keys {
        if !tables.contains(&table_of(key)) {
            tables.push(table_of(key));
        }
    }
    for table in tables {
        let title =
            if table.is_empty() { "Outside of tables".into() } else { format!("`[{table}]`") };
        text.push_str(&format!("\n## {title}\n\n"));
        let section = SECTIONS.iter().find(|section| section.table == table);
        if let Some(about) = section.map(|section| section.about).filter(|about| !about.is_empty())
        {
            text.push_str(&format!("{about}\n\n"));
        }
        text.push_str("| key | takes | meaning | without it |\n|---|---|---|---|\n");
        for key in keys.iter().filter(|key| table_of(key) == table) {
            let default = key.default.unwrap_or_else(|| default_of(key.path));
            text.push_str(&table_row(&[
                format!("`{}`", key.path),
                cell(&key.takes),
                cell(key.meaning),
                cell(default),
            ]));
        }
        if let Some(section) = section {
            text.push_str(&format!("\n```toml\n{}\n```\n", section.example.trim()));
        }
    }
    text
}

/// The first name of a key in a table; empty outside of tables.
fn table_of(key: &SchemaKey) -> &'static str {
    key.path.split_once('.').map_or("", |(table, _)| table)
}

const INTRODUCTION: &str = "
A machine file says what Chordal cannot read in a program: the control, the axes, tools and offsets. It is
TOML. Most begin with a built-in machine and say what differs:

```toml
inherits = \"haas-vf2\"
[tools.1]
diameter = \"0.75 in\"
[work_offsets.G54]
X = \"-15.2 in\"
```

```sh
chordal machines                            # the built-in machines
chordal machines haas-vf2                   # one of them, with the settings of its control
chordal machines haas-vf2 --toml > shop.toml   # as a file to change
chordal run part.nc --machine shop.toml
chordal run part.nc --machine haas-vf2 --set tools.1.diameter=\"0.75 in\"
```

A `chordal.toml` next to the programs names their machine, so that `--machine` is not needed:
`machine = \"shop.toml\"`.

**Units.** A quantity is a text with its unit; a number without one is refused. Lengths: `mm`, `cm`, `m`,
`um`, `in` (also `inch` or `\"`), `ft`. Times: `s`, `ms`, `min`. Angles: `deg`, `rad`, `rev`. Rates are per
`s` or `min`: `in/min`, `mm/s^2`, `m/s³`; `ipm` and `rpm` for short.

**Names that vary** are in angle brackets: `<axis>` is X, Y, Z, A, B or C; `<tool>` a number; `<offset>` a
work offset; `<code>` an M code such as `M120`; `<setting>` a parameter by the name in the control's manual.
The settings of a control are on [its page](reference/controls.md).
";

/// What holds without a key, where its row does not say it.
fn default_of(path: &str) -> &'static str {
    match path {
        "inherits" => "nothing is inherited",
        "title" => "the name",
        "control" => "an error, where nothing is inherited",
        "axes.<axis>" => "X, Y and Z without limits",
        "axes.<axis>.travel" => "travel is not checked",
        "axes.<axis>.max_velocity" => "24 m/min, 100 deg/s; reported as assumed",
        "axes.<axis>.max_acceleration" => "3 m/s^2, 500 deg/s^2; reported as assumed",
        "axes.<axis>.max_jerk" => "100 m/s^3, 10000 deg/s^3; reported as assumed",
        "axes.<axis>.rapid_acceleration" => "`max_acceleration`",
        "axes.<axis>.rapid_jerk" => "`max_jerk`",
        "rotary.<rotary>.reversed" | "switches.optional_stop" => "`false`",
        "feed.max" | "feed.max_rotary" | "spindle.max" | "spindle.live_max" => "not checked",
        "tools.<tool>.diameter" => "not known: compensation with it is reported",
        "tools.<tool>.length" => "0 is used; the height is not known",
        "tools.<tool>.diameter_wear" | "tools.<tool>.length_wear" => "0",
        "tools.<tool>.offset.<axis>" | "tools.<tool>.offset_wear.<axis>" => "0",
        "axes.<axis>.programmed" => "`radius`",
        "work_offsets.<offset>" | "work_offsets.<offset>.<axis>" => {
            "0 is used; the machine position is not known, and travel is not checked"
        }
        "home.<axis>" | "reference_points.<point>.<axis>" => "not known",
        "switches.block_delete" => "`false`: every block runs",
        "program.clearance" => "Z0 of the work offset",
        "times.tool_change"
        | "times.spindle_per_1000_rpm"
        | "times.spindle_orient"
        | "times.probe"
        | "times.m_code"
        | "shop_codes.<code>.time" => "no time",
        "macros.variables.<variable>" => {
            "not known: see [values that nobody gave](not-supported.md#values-that-nobody-gave)"
        }
        "macros.inputs" => "nothing is typed",
        "settings.<setting>" => "the default of the control",
        _ => "–",
    }
}

const SECTIONS: &[TableSection] = &[
    TableSection {
        table: "",
        about: "",
        example: "
inherits = \"fanuc-30i\"
name = \"line-3\"
title = \"Line 3, machining centre\"
notes = [\"acceleration measured in March\"]
control = \"fanuc\"
turret = \"front\"   # of a lathe
turret_clearance = \"50 mm\"",
    },
    TableSection {
        table: "axes",
        about: "Machine coordinates, as the control shows them. `chordal calibrate` fits acceleration and jerk to \
                measured cycle times.",
        example: "
[axes.X]
travel = [\"-762 mm\", \"0 mm\"]
max_velocity = \"25.4 m/min\"
max_acceleration = \"3 m/s^2\"
max_jerk = \"100 m/s^3\"
rapid_acceleration = \"5 m/s^2\"
rapid_jerk = \"150 m/s^3\"
programmed = \"radius\"          # \"diameter\" for X of a lathe

[axes.A]
max_velocity = \"100 deg/s\"",
    },
    TableSection {
        table: "rotary",
        about: "What the rotary axes turn and where they are. Pictures need `turns`, `reversed` and `center`; the kinematics of \
                a machine need a `point` on each axis, and at most two axes. Where an axis has a `rollover`, its words are angles on the \
                circle.",
        example: "
[rotary.A]
turns = \"table\"
reversed = false
center.Y = \"0 mm\"
center.Z = \"-50 mm\"
point.Y = \"-200 mm\"
point.Z = \"-400 mm\"
direction = [1, 0, 0]

[rotary.C]
turns = \"table\"
on = \"A\"
point.X = \"-300 mm\"
point.Y = \"-200 mm\"
rollover = \"shortest\"",
    },
    TableSection {
        table: "kinematics",
        about: "",
        example: "
[kinematics]
tcp_frame = \"activation\"
at_start = \"axes\"
X = \"head\"
Y = \"table\"
Z = \"head\"
order = \"YXZ\"",
    },
    TableSection {
        table: "solids",
        about: "The bodies of the machine for [`chordal collide`](collision.md).",
        example: "
[solids.table]
on = \"C\"
shape = \"cylinder\"
from = { X = \"-500 mm\", Y = \"-250 mm\", Z = \"-580 mm\" }
to = { X = \"-500 mm\", Y = \"-250 mm\", Z = \"-530 mm\" }
diameter = \"320 mm\"
end_diameter = \"300 mm\"
may_touch = [\"cradle\"]",
    },
    TableSection {
        table: "feed",
        about: "",
        example: "
[feed]
max = \"650 in/min\"
max_rotary = \"5000 deg/min\"",
    },
    TableSection { table: "rapid", about: "", example: "[rapid]\nshape = \"dog-leg\"" },
    TableSection {
        table: "spindle",
        about: "",
        example: "[spindle]\nmax = \"8100 rpm\"\nlive_max = \"6000 rpm\"\npower = \"30 hp\"",
    },
    TableSection {
        table: "tools",
        about: "A table for each tool, or `--tools tool.tbl` with a tool table of LinuxCNC. `--settings dump.txt` takes what a \
                GRBL machine prints for `$$`.",
        example: "
[tools.1]
diameter = \"0.5 in\"
diameter_wear = \"-0.002 in\"
length = \"4.2 in\"
length_wear = \"0 in\"
shape = \"bull\"
corner_radius = \"0.03 in\"
teeth = 3
max_chip = \"0.004 in\"
min_chip = \"0.0004 in\"
flute_length = \"1.2 in\"
shank = [[\"1.5 in\", \"0.5 in\"]]
shank_diameter = \"0.5 in\"
holder = [[\"1 in\", \"1.1 in\"], [\"0.6 in\", \"1.1 in\", \"1.7 in\"]]
description = \"roughing end mill\"
comment = \"3 flutes\"
[tools.2]
kind = \"drill\"                # the old way; write `shape`
point_angle = \"118 deg\"
[tools.3]
shape = \"thread mill\"
pitch = \"1.5 mm\"
[tools.4]
shape = \"chamfer\"
tip_diameter = \"0.2 mm\"
[tools.5]
shape = \"insert\"
nose_radius = \"0.4 mm\"
tip = 3
insert = \"CNMG120404\"
insert_angle = \"80 deg\"
holder_designation = \"PCLNL2525M12\"
approach_angle = \"95 deg\"
holder_outline = [[\"8 mm\", \"10 mm\"], [\"120 mm\", \"10 mm\"], [\"120 mm\", \"35 mm\"], [\"8 mm\", \"35 mm\"]]
bar_offset = \"9 mm\"
[tools.5.offset]
X = \"-31.2 mm\"
Z = \"12.5 mm\"
[tools.5.offset_wear]
X = \"0.02 mm\"
[tools.6]
shape = \"form\"
profile = [[\"0 mm\", \"3 mm\"], [\"5 mm\", \"8 mm\"]]
[tools.7]
shape = \"groove\"
width = \"3 mm\"
lead_angle = \"6 deg\"
facing = \"outside\"",
    },
    TableSection {
        table: "work_offsets",
        about: "",
        example: "
[work_offsets.G54]
X = \"-15.2 in\"
Y = \"-8 in\"
Z = \"-20.5 in\"

[work_offsets.\"G154 P1\"]
X = \"-3 in\"",
    },
    TableSection {
        table: "home",
        about: "",
        example: "[home]\nX = \"0 mm\"\nY = \"0 mm\"\nZ = \"0 mm\"",
    },
    TableSection {
        table: "reference_points",
        about: "",
        example: "[reference_points.2]\nX = \"-381 mm\"\nZ = \"0 mm\"",
    },
    TableSection {
        table: "switches",
        about: "The switches of the operator's panel.",
        example: "[switches]\nblock_delete = [1, 3]\noptional_stop = true",
    },
    TableSection { table: "program", about: "", example: "[program]\nclearance = \"0.1 in\"" },
    TableSection {
        table: "motion",
        about: "How the machine moves, where neither the program nor a setting of the control says it.",
        example: "
[motion]
servo_period = \"1 ms\"
feed_override = \"80 %\"
rapid_override = 0.5
corner_tolerance = \"0.02 mm\"
exact_path_tolerance = \"0.001 mm\"
rapid_corner_tolerance = \"5 mm\"
rotary_tolerance = \"0.01 deg\"",
    },
    TableSection {
        table: "times",
        about: "What takes time besides moving.",
        example: "
[times]
tool_change = \"4.5 s\"
spindle_per_1000_rpm = \"0.25 s\"
spindle_orient = \"1 s\"
probe = \"0.1 s\"
m_code = \"0.2 s\"",
    },
    TableSection {
        table: "macros",
        about: "What macro programs find when the program starts.",
        example: "
[macros]
date = \"2024-05-17\"
time = \"13:45:00\"
inputs = [2, 0.5]
variables.500 = 12.7",
    },
    TableSection {
        table: "shop_codes",
        about: "Custom M codes, and programs that the control has and no file holds: probing and other macros of the machine \
builder. A called program that neither a file nor this section has is an error (CH201), because nobody knows what it moves. \
Refusals as answers: [from Python](python.md#custom-m-codes-and-programs).",
        example: "
[shop_codes.M120]
time = \"2.5 s\"
label = \"part flip\"

# G65 P9832: moves nothing
[shop_codes.O9832]
label = \"probe on\"
time = \"1 s\"

# G65 P9810 X… Y… Z… F…: a protected move; its arguments are #24, #25, #26 and #9
[shop_codes.O9810]
blocks = \"G1 X#24 Y#25 Z#26 F#9\"",
    },
    TableSection {
        table: "probe",
        about: "",
        example: "[probe]\nhit = \"end\"\n\n# or planes\n[probe.hit]\nZ = \"0 mm\"",
    },
    TableSection {
        table: "settings",
        about: "",
        example: "[settings]\n\"No. 3410\" = \"0.02 mm\"\nradius_offsets = \"diameter\"",
    },
    TableSection {
        table: "stock",
        about: "What `chordal stock` cuts ([stock](stock.md)). A setup file is a machine file that names its machine with `machine`.",
        example: "
# instead of `inherits`
machine = \"haas-vf2\"

[stock]
shape = \"tube\"
work_offset = \"G54\"
axis = \"Z\"
diameter = \"100 mm\"
bore = \"20 mm\"
from = { X = \"50 mm\", Y = \"50 mm\", Z = \"-40 mm\" }
to = \"0 mm\"
file = \"left.stl\"
contour = [[\"20 mm\", \"0 mm\"], [\"24 mm\", \"-2 mm\", \"2 mm\"], [\"24 mm\", \"-50 mm\"]]
unit = \"mm\"
turned_over = \"X\"
material = \"aluminium\"
",
    },
    TableSection {
        table: "materials",
        about: "Values of the shop for [power and torque](engagement.md#materials), by the words of `[stock] material`.",
        example: "
[materials.bronze]
k_c1 = \"780 N/mm²\"
m_c = 0.18
source = \"measured on the VF-2\"
",
    },
    TableSection {
        table: "fixtures",
        about: "The same keys for each body that must not be touched.",
        example: "
[fixtures.\"rear jaw\"]
shape = \"box\"
from = { X = \"-10 mm\", Y = \"60 mm\", Z = \"-60 mm\" }
to = { X = \"90 mm\", Y = \"80 mm\", Z = \"-15 mm\" }
clearance = \"1 mm\"
",
    },
    TableSection {
        table: "target",
        about: "The same keys for the part as it should be.",
        example: "
[target]
shape = \"stl\"
file = \"part.stl\"
tolerance = \"0.05 mm\"
",
    },
];
