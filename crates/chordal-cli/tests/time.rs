//! `chordal time` and `chordal calibrate`.

#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    reason = "the tests of a shell have its files and processes"
)]

mod common;

use common::{BROKEN, Folder};
use serde_json::Value;

/// 2000 mm/s² and 100000 mm/s³ on every axis, and 200 mm/s.
const MILL: &str = include_str!("../../../tests/motion/mill.toml");

/// The mill with a control of its own.
fn machine() -> String {
    MILL.replace("linuxcnc", "fanuc")
}

/// A cut of 100 mm at 100 mm/s from rest to rest: 1 s at feed, and speeding up takes
/// 100/2000 + 2000/100000 = 0.07 s at half the speed on average, likewise slowing down: 1.07 s.
const CUT: &str = "\
O1
G21 G90 G0 X0 Y0 Z0
T1 M6
S1000 M3
G4 X2.
G1 X100. F6000.
M30
";

fn json(folder: &Folder, arguments: &[&str]) -> Value {
    let done = folder.run(&[arguments, &["--format", "json"]].concat()).ends(0);
    serde_json::from_str(&done.out).unwrap()
}

fn near(value: &Value, expected: f64) {
    let value = value.as_f64().expect("a number");
    assert!((value - expected).abs() < 1e-6 * expected, "{value} is not {expected}");
}

#[test]
fn the_time_of_a_cut_by_hand() {
    let folder = Folder::new();
    folder.write("m.toml", machine()).write("cut.nc", CUT);
    let time = json(&folder, &["time", "cut.nc", "-m", "m.toml"]);
    assert_eq!(time["schema"], "chordal.time/1");
    assert_eq!(time["level"], "fast");
    near(&time["total_s"], 9.07);
    near(&time["cutting_s"], 1.07);
    near(&time["other_s"], 8.0);
    assert_eq!(time["rapid_s"], 0.0);
    near(&time["lost_s"], 0.07);
    near(&time["waits"]["dwell"], 2.0);
    near(&time["waits"]["tool change"], 6.0);
    assert_eq!(time["tools"][0]["tool"], 1);
    near(&time["tools"][0]["total_s"], 9.07);
    let longest = &time["longest_blocks"];
    assert_eq!(longest[0]["text"], "T1 M6");
    assert_eq!(longest[1]["reason"], "dwell");
    assert_eq!(longest[2]["line"], 6);
    assert_eq!(longest[2]["reason"], "exact stop");
    assert_eq!(time["costliest_blocks"][0]["line"], 6);
    // At half the feed: 2 s, and 50/2000 + 0.02 s for the ramps.
    let halved = &time["what_if"][0];
    assert_eq!(halved["feed_override"], 0.5);
    near(&halved["total_s"], 8.0 + 2.045);
    assert!(time.get("bound_s").is_none());
}

#[test]
fn the_text_reads_in_80_columns() {
    let folder = Folder::with_part();
    folder.write("m.toml", machine()).write("cut.nc", CUT);
    let done = folder.run(&["time", "cut.nc", "-m", "m.toml"]).ends(0).says(&[
        "cut.nc\n",
        "time      9.070 s, with acceleration and jerk",
        "cutting 1.070 s, dwell 2.000 s, tool change 6.000 s",
        "take 0.070 s, 6.5 % of the time of the",
        "T1          1  1.070 s       -  8.000 s  9.070 s  0.070 s",
        "blocks that take the longest",
        "6     1  1.070 s  0.070 s  exact stop   G1 X100. F6000.",
        "what if",
        "feed override 50 %",
        "+0.975 s",
        "corners within 0.05 mm",
        "corners   1 cut ends at a stop",
        "--set",
    ]);
    let folder = Folder::with_part();
    let inch = folder.run(&["time", "part.nc", "-m", "haas-vf2"]).ends(0);
    for text in [&done.out, &inch.out] {
        let widest = text.lines().map(|line| line.chars().count()).max();
        assert!(widest <= Some(80), "{text}");
        assert!(!text.contains('\x1b'));
    }
    inch.says(&["smoothness P1 (rough), 0.025 in", "acceleration and jerk are typical"]);
}

#[test]
fn a_block_that_runs_often_is_told_once() {
    let folder = Folder::new();
    folder.write("m.toml", machine()).write(
        "loop.nc",
        "O1\nG21 G90 G0 X0 Y0 Z0\nG1 F6000.\nM98 P2 L3\nM30\nO2\nG91 G1 X100.\nG4 X1.\nM99\n",
    );
    let time = json(&folder, &["time", "loop.nc", "-m", "m.toml"]);
    let block = &time["longest_blocks"][0];
    assert_eq!((&block["line"], &block["runs"]), (&7.into(), &3.into()));
    near(&block["time_s"], 3.0 * 1.07);
    near(&block["lost_s"], 3.0 * 0.07);
}

#[test]
fn the_picture_is_written() {
    let folder = Folder::new();
    folder.write("m.toml", machine()).write("cut.nc", CUT);
    for name in ["a.svg", "a.png"] {
        folder.run(&["time", "cut.nc", "-m", "m.toml", "-o", name]).ends(0);
    }
    let drawing = folder.read("a.svg");
    assert!(drawing.starts_with("<svg") && drawing.contains("cut.nc"), "{drawing}");
    assert!(folder.bytes("a.png").starts_with(b"\x89PNG"));
    let done = folder.run(&["time", "cut.nc", "-o", "a.doc"]).ends(2);
    assert_eq!(done.out, "");
    done.complains(&["a.doc", ".svg and .png"]);
}

#[test]
fn problems_and_wrong_use() {
    let folder = Folder::new();
    folder.write("bad.nc", BROKEN).write("cut.nc", CUT).write("empty.nc", "O1\nM30\n");
    folder.run(&["time", "bad.nc", "-m", "haas-vf2"]).ends(1).complains(&["error[CH401]"]);
    folder.run(&["time", "empty.nc", "-m", "haas-vf2"]).ends(0).says(&["nothing moves"]);
    folder.run(&["time", "none.nc"]).ends(2).complains(&["cannot read none.nc"]);
    folder.run(&["time", "cut.nc", "--level", "slow"]).ends(2);
}

/// Programs in which feed, acceleration, jerk and tool changes weigh differently.
fn shop() -> Folder {
    let folder = Folder::new();
    let head = "G21 G90 G0 X0 Y0 Z0\n";
    let mut cuts = format!("O1\n{head}T1 M6\nG1 F6000.\n");
    let mut hops = format!("O2\n{head}T1 M6\n");
    let mut steps = format!("O3\n{head}G61 G1 F9000.\n");
    for at in 0..40 {
        cuts.push_str(&format!("X{}. Y{}.\n", if at % 2 == 0 { 300 } else { 0 }, at));
        hops.push_str(&format!("G0 X{}.\n", if at % 2 == 0 { 150 } else { 0 }));
        steps.push_str(&format!("X{}.\nY{}.\n", at + 1, at + 1));
    }
    let changes: String = (1..8).map(|tool| format!("T{tool} M6\nG0 X{}.\n", tool * 10)).collect();
    folder.write("cuts.nc", cuts + "M30\n").write("hops.nc", hops + "M30\n");
    folder.write("steps.nc", steps + "M30\n");
    folder.write("changes.nc", format!("O4\n{head}{changes}M30\n"));
    folder.write("base.toml", machine());
    let real = machine()
        .replace("2000 mm/s^2", "1200 mm/s^2")
        .replace("100000 mm/s^3", "30000 mm/s^3")
        .replace("6 s", "8.5 s");
    folder.write("real.toml", real);
    folder
}

const PROGRAMS: [&str; 4] = ["cuts.nc", "hops.nc", "steps.nc", "changes.nc"];

#[test]
fn a_machine_is_found_from_its_times() {
    let folder = shop();
    let total = |machine: &str, program: &str| {
        json(&folder, &["time", program, "-m", machine])["total_s"].as_f64().unwrap()
    };
    let mut rows = String::from("program,seconds\n# on the real machine\n");
    for program in PROGRAMS {
        rows.push_str(&format!("{program},{}\n", total("real.toml", program)));
    }
    folder.write("measured.csv", rows);
    let arguments = ["calibrate", "measured.csv", "-m", "base.toml", "-o", "fitted.toml"];
    folder.run(&arguments).ends(0).says(&[
        "4 programs measured on",
        "acceleration             1  x 0.600",
        "jerk                     1  x 0.300",
        "tool change         6.00 s   8.50 s",
        "remaining error 0 %",
        "written to fitted.toml",
    ]);
    for program in PROGRAMS {
        let (real, fitted) = (total("real.toml", program), total("fitted.toml", program));
        assert!((fitted / real - 1.0).abs() < 1e-3, "{program}: {fitted} s for {real} s");
    }
}

#[test]
fn too_few_programs_say_what_they_cannot_tell() {
    let folder = shop();
    folder.write("one.csv", "cuts.nc,2:10\n");
    folder.run(&["calibrate", "one.csv", "-m", "base.toml"]).ends(0).says(&[
        "kept",
        "as many unknowns as programs",
        "cannot be separated with so few programs",
    ]);
    folder.write("wrong.csv", "cuts.nc,12\nhops.nc,12 parsecs\n");
    folder
        .run(&["calibrate", "wrong.csv", "-m", "base.toml"])
        .ends(2)
        .complains(&["wrong.csv, line 2: `12 parsecs` is not a time", "1:02:03"]);
    folder.run(&["calibrate", "one.csv"]).ends(2).complains(&["--machine"]);
    folder
        .run(&["calibrate", "one.csv", "-m", "base.toml", "-o", "base.toml"])
        .ends(2)
        .complains(&["is the machine file that is fitted"]);
}

#[test]
fn the_least_time_is_told() {
    let folder = Folder::new();
    folder.write("m.toml", machine()).write("cut.nc", CUT);
    // Without jerk the ramps take 100/2000 s together, with it 0.07 s.
    let time = json(&folder, &["time", "cut.nc", "-m", "m.toml", "--bound"]);
    near(&time["bound_s"], 9.05);
    near(&time["reference_s"], 9.07);
    assert_eq!(time["reference_unknown_s"], 0.0);
    near(&time["operations"][0]["bound_s"], 9.05);
    near(&time["operations"][0]["reference_s"], 9.07);
    let done = folder.run(&["time", "cut.nc", "-m", "m.toml", "--bound"]).ends(0).says(&[
        "above the physical limit",
        "without jerk",
        "9.070 s       9.050 s    9.070 s    0 %",
    ]);
    assert!(done.out.lines().all(|line| line.chars().count() <= 80), "{}", done.out);
}

/// Two operations of one tool, a comment next to words, and two lines of comment together.
const COMMENTS: &str = "\
O1 (PART)
G21 G90 G61 G0 X0 Y0 Z0
(FACE)
(WITH THE SAME TOOL)
T1 M6
S900 M3
G1 X100. F6000.
N20 (SLOT)
G1 X200. (NOT ALONE)
X100.
M98 P2 L2
M30
O2
(CALLED)
G1 X0.
X100.
M99
";

#[test]
fn operations_begin_at_comments_where_that_is_asked() {
    let folder = Folder::new();
    folder.write("m.toml", machine()).write("part.nc", COMMENTS);
    let by_tool = json(&folder, &["time", "part.nc", "-m", "m.toml"]);
    assert_eq!(by_tool["operations"].as_array().unwrap().len(), 1);
    assert!(by_tool["operations"][0].get("comment").is_none());
    let arguments = ["time", "part.nc", "-m", "m.toml", "--operations", "comment"];
    let time = json(&folder, &[&arguments[..], &["--bound"]].concat());
    let operations = time["operations"].as_array().unwrap();
    let told: Vec<_> =
        operations.iter().map(|o| (&o["comment"], &o["tool"], &o["first"]["line"])).collect();
    let due = [("FACE", 1, 5), ("SLOT", 1, 9)].map(|(c, t, l)| (c.into(), t.into(), l.into()));
    assert_eq!(told, due.each_ref().map(|(c, t, l): &(Value, Value, Value)| (c, t, l)));
    // 1.07 s for 100 mm and 6 s for the tool; then 100 mm six times over.
    near(&operations[0]["total_s"], 7.07);
    near(&operations[1]["total_s"], 6.0 * 1.07);
    near(&time["total_s"], by_tool["total_s"].as_f64().unwrap());
    let bounds = operations.iter().map(|operation| operation["bound_s"].as_f64().unwrap());
    near(&time["bound_s"], bounds.sum());
    folder.run(&arguments).ends(0).says(&["from one comment or tool change", "FACE", "SLOT"]);
}

#[test]
fn comments_of_a_loop_begin_an_operation_each_time() {
    let folder = Folder::new();
    let part = "O1\nG21 G90 G61 G0 X0 Y0 Z0\nS900 M3\nF6000.\n#1=0\nWHILE[#1LT2]DO1\n(OUT)\nG1 X100.\n\
                (BACK)\nX0.\n#1=#1+1\nEND1\nM30\n";
    folder.write("m.toml", machine()).write("part.nc", part);
    let time = json(&folder, &["time", "part.nc", "-m", "m.toml", "--operations", "comment"]);
    let names: Vec<_> =
        time["operations"].as_array().unwrap().iter().map(|o| o["comment"].clone()).collect();
    assert_eq!(names[names.len() - 4..], ["OUT", "BACK", "OUT", "BACK"]);
}
