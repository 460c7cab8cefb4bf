//! What somebody reads who has made a mistake in a machine file.

mod common;

use std::collections::BTreeMap;

use chordal_machine::{ControlName, Machine};
use common::{errors, shown};

/// Compares line by line, so that a difference is easy to see.
fn check(text: &str, expected: &str) {
    let found = errors(text);
    let names: Vec<&str> = ControlName::ALL.iter().map(|name| name.as_str()).collect();
    let (last, others) = names.split_last().expect("there are controls");
    let expected = expected.replace("CONTROLS", &format!("{} or {last}", others.join(", ")));
    assert_eq!(found.trim(), expected.trim(), "\n--- found:\n{found}\n---");
}

#[test]
fn a_number_without_a_unit() {
    check(
        "control = \"haas\"\n[axes.X]\nmax_velocity = 25\n[feed]\nmax = 2.5\n[tools.5]\nlength = \"5\"",
        r#"
mine.toml:3: `max_velocity` takes a velocity; `25` has no unit
  ^ 25
  = write it with its unit: "25 in/min", "25 mm/min", "25 m/min" or "25 mm/s"
mine.toml:5: `feed.max` takes a velocity; `2.5` has no unit
  ^ 2.5
  = write it with its unit: "2.5 in/min", "2.5 mm/min", "2.5 m/min" or "2.5 mm/s"
mine.toml:7: `length` takes a length; `5` has no unit
  ^ "5"
  = write it with its unit: "5 in" or "5 mm"
"#,
    );
}

#[test]
fn a_wrong_unit() {
    check(
        r#"
control = "haas"
[axes.X]
travel = ["0 mm", "25 m/min"]
max_acceleration = "3 m/s^3"
[axes.A]
travel = ["0 deg", "10 in"]
[times]
tool_change = "6 sek"
[spindle]
max = "130 m/min"
[tools.1]
diameter = "half an inch"
corner_radius = "3 furlongs"
"#,
        r#"
mine.toml:4: `travel` takes a length; `25 m/min` is a velocity
  ^ "25 m/min"
  = a length is a number with a unit: in or mm
mine.toml:5: `max_acceleration` takes an acceleration; `3 m/s^3` is a jerk
  ^ "3 m/s^3"
  = an acceleration is a number with a unit: mm/s^2, m/s^2 or in/s^2
mine.toml:7: `travel` takes an angle; `10 in` is a length
  ^ "10 in"
  = an angle is a number with a unit: deg or rad
mine.toml:9: `tool_change` takes a time; `sek` is not a unit
  ^ "6 sek"
  = write it with its unit: "6 s", "6 ms" or "6 min"
mine.toml:11: `spindle.max` takes a spindle speed; `130 m/min` is a velocity
  ^ "130 m/min"
  = a spindle speed is a number with a unit: rpm
mine.toml:13: `diameter` takes a length; `half an inch` does not start with a number
  ^ "half an inch"
  = a length is a number with a unit: in or mm
mine.toml:14: `corner_radius` takes a length; `furlongs` is not a unit
  ^ "3 furlongs"
  = write it with its unit: "3 in" or "3 mm"
"#,
    );
}

#[test]
fn a_misspelt_key() {
    check(
        r#"
contrl = "haas"
[axes.X]
max_velocty = "25 m/min"
colour = "red"
[axes.U]
[axes.y]
[feeds]
max = "1 m/min"
[feed]
max_velocity = "1 m/min"
[tools.drill]
[tool_change]
[program]
travel = "5 in"
"#,
        r#"
mine.toml:2: a machine file has no key `contrl`
  ^ contrl
  = did you mean `control`?
mine.toml:4: `axes.X` has no key `max_velocty`
  ^ max_velocty
  = did you mean `axes.X.max_velocity`?
mine.toml:5: `axes.X` has no key `colour`
  ^ colour
  = it takes `travel`, `programmed`, `max_velocity`, `max_acceleration`, `max_jerk`, `rapid_acceleration`, `rapid_jerk`
mine.toml:6: `U` is not an axis
  ^ U
  = the axes are X, Y, Z, A, B and C
mine.toml:7: `y` is not an axis
  ^ y
  = did you mean `Y`? Axes are written in capital letters
mine.toml:8: a machine file has no key `feeds`
  ^ feeds
  = did you mean `feed`?
mine.toml:11: `feed` has no key `max_velocity`
  ^ max_velocity
  = did you mean `feed.max`?
mine.toml:12: `drill` is not a tool number
  ^ drill
  = a tool is named by its number, such as `tools.5`
mine.toml:13: a machine file has no key `tool_change`
  ^ tool_change
  = did you mean `times.tool_change`?
mine.toml:15: `program` has no key `travel`
  ^ travel
  = did you mean `axes.<axis>.travel`?
mine.toml: the machine file does not name its control
  = write `control = "…"` with CONTROLS
"#,
    );
}

#[test]
fn limits_that_cannot_be() {
    check(
        r#"
control = "haas"
[axes.X]
travel = ["762 mm", "0 mm"]
max_velocity = "-25 m/min"
max_jerk = "0 m/s^3"
[axes.Y]
travel = ["1 in", "25.4 mm"]
max_velocity = "1e999 m/min"
[axes.Z]
travel = ["1 in"]
[times]
tool_change = "-1 s"
[settings]
"No. 3410" = nan
"#,
        r#"
mine.toml:4: `travel` is reversed: `762 mm` is above `0 mm`
  ^ ["762 mm", "0 mm"]
  = write `["0 mm", "762 mm"]`
mine.toml:5: `max_velocity` must be more than zero
  ^ "-25 m/min"
mine.toml:6: `max_jerk` must be more than zero
  ^ "0 m/s^3"
mine.toml:8: `travel` is empty: both ends are `1 in`
  ^ ["1 in", "25.4 mm"]
mine.toml:9: `max_velocity` takes a velocity; `1e999 m/min` is out of range
  ^ "1e999 m/min"
mine.toml:11: `travel` takes two lengths, not 1
  ^ ["1 in"]
  = write the lower and the higher end: `["0 mm", "762 mm"]`
mine.toml:13: `tool_change` cannot be negative
  ^ "-1 s"
mine.toml:15: a control cannot hold the number `nan`
  ^ nan
"#,
    );
}

#[test]
fn a_value_of_another_kind() {
    check(
        r#"
control = "hass"
title = 5
tools = 5
notes = ["fine", 7]
[axes]
X = "10 in"
[feed.max]
[rapid]
shape = "round"
[switches]
block_delete = [1, 12]
optional_stop = "yes"
[reference_points.1]
[work_offsets.G59.1]
X = "1 in"
[work_offsets.G60]
[settings.No]
3410 = 5
"#,
        r#"
mine.toml:2: `hass` is not a control
  ^ "hass"
  = did you mean "haas"?
mine.toml:3: `title` takes a text; this is a whole number
  ^ 5
  = put it in quotes
mine.toml:4: `tools` is a table; this is a whole number
  ^ 5
  = write `tools.<tool> = …`
mine.toml:5: `notes` takes a text; this is a whole number
  ^ 7
  = put it in quotes
mine.toml:7: `axes.X` is a table; this is a text
  ^ "10 in"
  = write `axes.X.travel = …`
mine.toml:8: `feed.max` takes a velocity; this is a table
  ^ [feed.max]
  = a velocity is a number with a unit: in/min, mm/min, m/min or mm/s
mine.toml:10: `round` is not a rapid shape
  ^ "round"
  = it is one of "dog-leg" or "straight"
mine.toml:12: `block_delete` takes `true`, `false` or a list of switch numbers from 1 to 9
  ^ 12
mine.toml:13: `optional_stop` takes `true` or `false`; this is a text
  ^ "yes"
mine.toml:14: `1` is not a reference point
  ^ 1
  = reference point 1 is written as `[home]`
mine.toml:15: `1` is not an axis
  ^ 1
  = a name with a point needs quotes: `work_offsets."G59.1"`
mine.toml:17: `G60` is not a work offset
  ^ G60
  = work offsets are G54 to G59, "G59.1" to "G59.3", "G54.1 P1" to P300, "G54.2 P1" to P8, "G154 P1" to P99, "G59 P7" to P254, E1 to E48, G52 and EXT
mine.toml:18: `settings.No` takes a text, a number or `true`/`false`; this is a table
  ^ [settings.No]
  = a name with a point needs quotes, such as `"No. 3410" = 5`
"#,
    );
}

#[test]
fn slips_of_syntax_hide_only_what_follows() {
    let found = errors("contrl = \"haas\"\n[axes.X\nmax_velocity = 5\n[feed]\nmax = = 5\n");
    assert!(found.starts_with("mine.toml:1: a machine file has no key `contrl`"), "{found}");
    assert!(found.contains("\nmine.toml:2: "), "{found}");
    assert!(found.contains("\nmine.toml:5: "), "{found}");
    assert!(!found.contains("has no unit"), "{found}");
    assert!(!found.contains("does not name its control"), "{found}");
}

/// The errors of `a.toml` among a few files.
fn errors_among(files: &[(&str, &str)]) -> String {
    let files: BTreeMap<&str, &str> = files.iter().copied().collect();
    let loader = |name: &str| {
        files.get(name).map(|text| text.to_string()).ok_or_else(|| "no such file".to_string())
    };
    let errors = Machine::from_toml("a.toml", files["a.toml"], &loader).expect_err("an error");
    shown(&errors)
}

#[test]
fn what_cannot_be_inherited() {
    assert_eq!(
        errors_among(&[("a.toml", "inherits = \"haas-vf9\"\n[feed]\nmax = 5\n")]),
        r#"a.toml:1: `haas-vf9` is neither a built-in machine nor a file that can be read: no such file
  ^ "haas-vf9"
  = did you mean "haas-vf2"?
a.toml:3: `feed.max` takes a velocity; `5` has no unit
  ^ 5
  = write it with its unit: "5 in/min", "5 mm/min", "5 m/min" or "5 mm/s""#
    );
    assert_eq!(
        errors_among(
            &[("a.toml", "inherits = \"b.toml\""), ("b.toml", "inherits = \"./a.toml\""),]
        ),
        "b.toml:1: `inherits` goes in a circle: a.toml -> b.toml -> ./a.toml\n  ^ \"./a.toml\""
    );
    let itself = errors_among(&[("a.toml", "inherits = \"a.toml\"")]);
    assert!(itself.contains("goes in a circle: a.toml -> a.toml"), "{itself}");
    let number = errors_among(&[("a.toml", "inherits = 5")]);
    assert!(number.contains("`inherits` needs the name of a machine or of a file"), "{number}");
    let endless =
        Machine::from_toml("0", "inherits = \"00\"", &|name| Ok(format!("inherits = \"{name}0\"")));
    let endless = shown(&endless.expect_err("an error"));
    assert!(endless.contains("more than 16 files inherit from each other"), "{endless}");
}

#[test]
fn an_error_in_an_inherited_file_is_shown_there() {
    assert_eq!(
        errors_among(&[
            ("a.toml", "inherits = \"base/b.toml\"\n[feed]\nmx = 1"),
            ("base/b.toml", "inherits = \"c.toml\"\n[axes.Q]"),
            ("base/c.toml", "control = \"fadel\""),
        ]),
        r#"base/c.toml:1: `fadel` is not a control
  ^ "fadel"
  = did you mean "fadal"?
base/b.toml:2: `Q` is not an axis
  ^ Q
  = the axes are X, Y, Z, A, B and C
a.toml:3: `feed` has no key `mx`
  ^ mx
  = did you mean `feed.max`?"#
    );
}

#[test]
fn no_such_built_in_machine() {
    let errors = Machine::from_builtin("fadal-4200").expect_err("an error");
    assert_eq!(
        shown(&errors),
        "fadal-4200: there is no built-in machine `fadal-4200`\n  = did you mean \"fadal-4020\"?"
    );
}

#[test]
fn a_very_deep_key_does_no_harm() {
    let deep = format!("{}a = 1", "a.".repeat(1_000_000));
    assert!(Machine::from_toml("deep.toml", &deep, &common::no_files).is_err());
}

#[test]
fn a_cutting_force_that_no_material_has() {
    check(
        "control = \"haas\"\n[materials.bronze]\nk_c1 = \"1.5 N/mm^2\"\nm_c = 21\n[materials.steel]\nk_c1 = \"1500 N\"\nm_c = \"0.2\"\nkc1 = 3\n",
        r#"
mine.toml:3: `materials.bronze.k_c1` is 1.5 N/mm²: it must be from 10 to 20000 N/mm²
  ^ "1.5 N/mm^2"
  = give a published value, such as 700 N/mm² for aluminium, 1500 for steel, 3300 for nickel alloys
mine.toml:4: `materials.bronze.m_c` is 21: it must be from 0 to 0.8
  ^ 21
  = give a published value, such as 0.25
mine.toml:6: `materials.steel.k_c1` takes a force by area; `N` is not a unit
  ^ "1500 N"
  = write it with its unit: "1500 N/mm^2", "1500 MPa" or "1500 ksi"
mine.toml:7: `materials.steel.m_c` takes a number; this is a text
  ^ "0.2"
mine.toml:8: `materials.steel` has no key `kc1`
  ^ kc1
  = did you mean `materials.steel.k_c1`?
"#,
    );
}
