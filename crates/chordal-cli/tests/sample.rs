//! `chordal sample`: setpoints as files and as a stream.

mod common;

use common::{BROKEN, Folder};
use serde_json::Value;

/// 100 mm along X, a quarter turn of R20, a dwell of half a second.
const PART: &str =
    "O1\nG21 G17 G90 G94\nS900 M3\nG1 X100. F6000\nG3 X120. Y20. J20.\nG4 P0.5\nM2\n";

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("part.ngc", PART);
    folder
}

#[test]
fn setpoints_are_a_table() {
    let folder = folder();
    let done =
        folder.run(&["sample", "part.ngc", "-m", "linuxcnc-mill", "--period", "2 ms"]).ends(0);
    let done =
        done.complains(&["setpoints, one every 2 ms", "chord     at most 0.000", " mm, on line 5"]);
    let rows: Vec<Vec<&str>> = done.out.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(rows[0][..4], ["time_s", "x_mm", "x_vel_mm_per_s", "x_acc_mm_per_s2"]);
    assert_eq!(rows[0].last(), Some(&"line"));
    // Nothing says where the first move comes from, and so how fast X goes at first.
    assert_eq!(rows[1][..3], ["0", "", ""]);
    assert_eq!(rows[2][0], "0.002");
    let last = rows.last().unwrap();
    assert_eq!((last[1], last[4], last[2]), ("120", "20", "0"));
    // The line, the arc and the dwell.
    let of_line = |line: &str| rows.iter().filter(|row| row.last() == Some(&line)).count();
    assert!(of_line("4") > 500 && of_line("5") > 100);
    assert!(of_line("6").abs_diff(250) <= 1, "{}", of_line("6"));
}

#[test]
fn the_ending_says_the_format() {
    let folder = folder();
    let base = ["sample", "part.ngc", "-m", "linuxcnc-mill", "-o"];
    for (name, begins) in [
        ("a.csv", &b"time_s,"[..]),
        ("b.jsonl", b"{\"schema\""),
        ("c.parquet", b"PAR1"),
        ("x/d.arrow", b"ARROW1"),
    ] {
        let done = folder.run(&[&base[..], &[name]].concat()).ends(0);
        assert_eq!(done.out, "");
        let bytes = folder.bytes(name);
        assert!(bytes.starts_with(begins), "{name}");
    }
    let same = folder.run(&["sample", "part.ngc", "-m", "linuxcnc-mill"]).ends(0).out;
    assert_eq!(folder.read("a.csv"), same);
    let stream =
        folder.run(&["sample", "part.ngc", "-m", "linuxcnc-mill", "--format", "jsonl"]).ends(0);
    let lines: Vec<Value> =
        stream.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(lines[0]["schema"], "chordal.samples/1");
    assert_eq!(lines.len() - 1, same.lines().count() - 1);
}

#[test]
fn wrong_use_is_told_and_writes_nothing() {
    let folder = folder();
    for (arguments, said) in [
        (&["--period", "0 ms"][..], "a period must be above zero"),
        (&["--period=-1ms"], "a period must be above zero"),
        (&["--period", "NaN"], "does not start with a number"),
        (&["--period", "1"], "no unit"),
        (&["--period", "1mm"], "is a length"),
        (&["--max-samples", "100", "-o", "out.csv"], "more than 100 setpoints"),
        (&["-o", "out.doc"], "is not a format"),
        (&["-o", "part.ngc", "--format", "csv"], "is the program"),
    ] {
        let base = ["sample", "part.ngc", "-m", "linuxcnc-mill"];
        folder.run(&[&base[..], arguments].concat()).ends(2).complains(&[said]);
    }
    assert_eq!(folder.read("part.ngc"), PART);
    assert_eq!(folder.names(), ["part.ngc"]);
}

#[test]
fn problems_of_the_program_are_told() {
    let folder = Folder::new();
    folder.write("bad.nc", BROKEN);
    let done = folder.run(&["sample", "bad.nc", "-m", "haas-vf2"]).ends(1);
    let done = done.complains(&["error[CH401]", "setpoints"]);
    assert!(done.out.starts_with("time_s,"));
}

#[test]
fn a_dog_leg_rapid_goes_where_its_axes_take_it() {
    let folder = Folder::new();
    let mill = include_str!("../../../tests/motion/mill.toml").replace("linuxcnc", "fanuc");
    folder.write("m.toml", mill).write("part.nc", "O1\nG21 G90 G0 X0 Y0 Z0\nG0 X100. Y50.\nM30\n");
    // How far above the straight line to the end, at most.
    let above = |shape: &str| {
        let set = format!("rapid.shape={shape}");
        let done = folder.run(&["sample", "part.nc", "-m", "m.toml", "--set", &set]).ends(0).out;
        let rows = done.lines().skip(1).map(|line| -> Vec<f64> {
            line.split(',').map(|cell| cell.parse().unwrap_or(0.0)).collect()
        });
        rows.map(|row| row[4] - row[1] / 2.0).fold(0.0, f64::max)
    };
    assert!(above("straight") < 1e-6, "{}", above("straight"));
    // Both axes at one speed until Y is there, 50 mm by 50 mm, less what the bend is rounded by.
    let bend = above("dog-leg");
    assert!(bend > 10.0 && bend < 25.0, "{bend}");
}

#[test]
fn a_place_that_is_not_known_is_blank() {
    // X and Z come from nowhere, Y is never named; after G28 it is not known where Z is on the part.
    let text = "G21 G90 G18\nS1000 M3\nG0 X10. Z5.\nG1 Z-2. F600.\nG4 P100\nG91 G28 Z0\nG90 G1 X20.\nM30\n";
    let folder = Folder::new();
    folder.write("part.nc", text);
    let done = folder.run(&["sample", "part.nc", "-m", "haas-vf2", "--period", "10ms"]).ends(0);
    let head: Vec<&str> = done.out.lines().next().expect("a head").split(',').collect();
    let place = |name: &str| head.iter().position(|own| *own == name).expect("a column");
    let names = ["x_mm", "x_vel_mm_per_s", "y_mm", "z_mm", "z_vel_mm_per_s", "speed_mm_per_s"];
    let columns = names.map(place);
    let (mut lines, line) = (Vec::new(), place("line"));
    for row in done.out.lines().skip(1).map(|row| row.split(',').collect::<Vec<_>>()) {
        let known = columns.map(|column| !row[column].is_empty());
        if lines.last() != Some(&(row[line], known)) {
            lines.push((row[line], known));
        }
    }
    let all = [true; 6];
    assert_eq!(
        lines,
        [
            // The spindle starts, and nothing moves.
            ("2", [false, true, true, false, true, true]),
            ("3", [false, false, true, false, false, false]),
            // Z has arrived, and stands.
            ("3", [false, false, true, false, true, false]),
            ("4", all),
            ("5", all),
            ("6", [true, true, true, false, false, false]),
            ("7", [true, true, true, false, true, true]),
            ("8", [true, true, true, false, true, true]),
        ]
    );
    done.complains(&["Y is never named; drawn at Y0", "X, Z where the place is not known"]);
    let json = folder
        .run(&["sample", "part.nc", "-m", "haas-vf2", "--period", "10ms", "--format", "jsonl"])
        .ends(0);
    assert!(json.out.lines().nth(1).expect("a row").contains("\"x_mm\":null"), "{}", json.out);
}
