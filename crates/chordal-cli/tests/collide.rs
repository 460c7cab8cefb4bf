//! `chordal collide`: the answer, its exit code, and what is not proved.

mod common;

use common::Folder;

/// A round table C on a cradle A, a head above, a tool with a holder, a part and a clamp.
const MACHINE: &str = r#"
inherits = "fanuc-ac-trunnion"
[home]
X = "0 mm"
Y = "0 mm"
Z = "0 mm"
A = "0 deg"
C = "0 deg"
[kinematics]
X = "head"
Y = "table"
Z = "head"
[work_offsets.G54]
X = "-500 mm"
Y = "-250 mm"
Z = "-480 mm"
[solids.table]
on = "C"
shape = "cylinder"
from = { X = "-500 mm", Y = "-250 mm", Z = "-580 mm" }
to = { X = "-500 mm", Y = "-250 mm", Z = "-530 mm" }
diameter = "320 mm"
[solids.cradle]
on = "A"
shape = "box"
from = { X = "-720 mm", Y = "-380 mm", Z = "-700 mm" }
to = { X = "-280 mm", Y = "-120 mm", Z = "-580 mm" }
[solids."left arm"]
on = "A"
shape = "box"
from = { X = "-720 mm", Y = "-330 mm", Z = "-700 mm" }
to = { X = "-680 mm", Y = "-170 mm", Z = "-480 mm" }
[solids.bed]
on = "base"
shape = "box"
from = { X = "-900 mm", Y = "-700 mm", Z = "-1000 mm" }
to = { X = "0 mm", Y = "300 mm", Z = "-900 mm" }
[solids.head]
on = "spindle"
shape = "cylinder"
to = { Z = "300 mm" }
diameter = "180 mm"
[tools.1]
shape = "flat"
diameter = "10 mm"
length = "120 mm"
flute_length = "30 mm"
shank = [["20 mm", "10 mm"]]
holder = [["70 mm", "40 mm", "63 mm"]]
[stock]
shape = "box"
work_offset = "G54"
from = { X = "-40 mm", Y = "-40 mm", Z = "-50 mm" }
to = { X = "40 mm", Y = "40 mm", Z = "0 mm" }
[fixtures.clamp]
shape = "box"
work_offset = "G54"
from = { X = "45 mm", Y = "-20 mm", Z = "-50 mm" }
to = { X = "70 mm", Y = "20 mm", Z = "10 mm" }
"#;

const HEAD: &str = "O1\nG21 G90 G17 G40 G49 G80\nT1 M6\nG54 G0 A0 C0\nG0 X0 Y0\nG43.4 H1 Z100.\nS3000 M3\nG0 X-30. Y0 Z20.\n";
const TAIL: &str = "G0 Z120.\nG49\nG53 Z0\nM30\n";

fn folder() -> Folder {
    let folder = Folder::new();
    let program = |moves: &str| format!("{HEAD}{moves}{TAIL}");
    folder
        .write("trunnion.toml", MACHINE)
        .write("good.nc", program("G1 Z-2. F500\nG1 X30. A30. C90. F800\n"))
        .write("clamp.nc", program("G1 Z-2. F500\nG1 X60. F800\nG0 Z30.\n"))
        .write("swing.nc", program("G0 X-185. Z-60.\nG0 Z30.\n"));
    folder
}

#[test]
fn a_program_that_touches_nothing_is_proved_clean() {
    let done = folder().run(&["collide", "good.nc", "--machine", "trunnion.toml"]);
    done.ends(0).says(&["pairs       30", "clean: no two of these bodies touch"]);
}

#[test]
fn the_line_and_the_bodies_are_named() {
    let folder = folder();
    folder.run(&["collide", "clamp.nc", "--machine", "trunnion.toml"]).ends(1).says(&[
        "error[CH680]: the cutter of tool 1 is at least 12 mm deep in the fixture `clamp`",
        "clamp.nc:10:1",
        "at X -447.031 mm, Y -250 mm, Z -362 mm, A 0 deg, C 0 deg (machine coordinates)",
    ]);
    // The tip goes down next to the arm, and the holder is wider than the room.
    folder.run(&["collide", "swing.nc", "--machine", "trunnion.toml"]).ends(1).says(&[
        "the holder of tool 1",
        "`left arm`",
        "swing.nc:9",
    ]);
}

#[test]
fn a_thin_wall_between_the_ends_of_a_move_is_found() {
    let folder = folder();
    let across = [("X", "-100. Y0", "100."), ("Y", "-100. X0", "100.")];
    for (letter, from, to) in across {
        // A plate of 0.1 mm in the way of the cutter alone, in a move of 200 mm.
        let plate = |side: &str| {
            let [low, high] = match side == letter {
                true => ["11.03 mm", "11.13 mm"],
                false => ["-5 mm", "5 mm"],
            };
            (low, high)
        };
        let ((x0, x1), (y0, y1)) = (plate("X"), plate("Y"));
        let wall = format!(
            "{MACHINE}\n[fixtures.wall]\nshape = 'box'\nwork_offset = 'G54'\nfrom = {{ X = '{x0}', Y = '{y0}', Z = '4 mm' }}\nto = {{ X = '{x1}', Y = '{y1}', Z = '19 mm' }}\n"
        );
        let program = format!("{HEAD}G0 {letter}{from}\nG0 Z15.\nG0 {letter}{to}\n{TAIL}");
        folder.write("wall.toml", &wall).write("wall.nc", &program);
        folder
            .run(&["collide", "wall.nc", "--machine", "wall.toml", "--tolerance", "0.01mm"])
            .ends(1)
            .says(&["the cutter of tool 1", "the fixture `wall`", "wall.nc:11"]);
    }
}

#[test]
fn bodies_that_may_touch_are_not_reported() {
    let folder = folder();
    let swung = ["collide", "swing.nc", "--machine", "allowed.toml"];
    let allowed = MACHINE.replace(
        "[solids.\"left arm\"]",
        "[solids.\"left arm\"]\nmay_touch = [\"tool\", \"head\"]",
    );
    folder.write("allowed.toml", allowed);
    folder.run(&swung).ends(0).says(&["clean"]);
}

#[test]
fn what_is_not_known_is_not_proved() {
    let folder = folder();
    let cases = [
        ("[home]\n", "[reference_points.2]\n", "where A, C stand before the program is not known"),
        ("length = \"120 mm\"\n", "", "tool 1 is not checked: its length is not given"),
        ("shape = \"flat\"\n", "", "tool 1 is not checked: its shape is not known"),
        ("Y = \"table\"\n", "", "where `bed` is relative to the part and the tool is not known"),
        ("Z = \"-480 mm\"\n", "", "where `stock` is on the machine is not known"),
        ("on = \"base\"\n", "", "`solids.bed.on` is not given"),
        ("to = { Z = \"300 mm\" }\n", "", "`solids.head` is no body"),
    ];
    for (text, instead, says) in cases {
        assert!(MACHINE.contains(text), "{text}");
        folder.write("less.toml", MACHINE.replacen(text, instead, 1));
        folder.run(&["collide", "good.nc", "--machine", "less.toml"]).ends(1).says(&[
            "warning[CH681]",
            says,
            "not proved",
        ]);
    }
    folder
        .run(&["collide", "good.nc", "--machine", "trunnion.toml", "--positions", "20"])
        .ends(1)
        .says(&["the check may look at no more positions", "not proved"]);
    folder
        .run(&["collide", "good.nc", "--machine", "fanuc-ac-trunnion"])
        .ends(1)
        .says(&["warning[CH682]: nothing was compared", "not proved"]);
}

#[test]
fn the_stock_before_the_first_cut_is_not_called_a_collision() {
    let folder = folder();
    // A stock so high that the head passes through it: what is left of it is not followed.
    let high = MACHINE.replacen("Z = \"0 mm\" }\n[fixtures", "Z = \"400 mm\" }\n[fixtures", 1);
    assert_ne!(high, MACHINE);
    folder.write("high.toml", high);
    folder
        .run(&["collide", "good.nc", "--machine", "high.toml"])
        .ends(1)
        .says(&["warning[CH681]: `head` may touch the stock", "not proved"]);
}

#[test]
fn json_and_sarif_have_the_problems() {
    let folder = folder();
    let args = ["collide", "clamp.nc", "--machine", "trunnion.toml", "--format"];
    let done = folder.run(&[&args[..], &["json"]].concat()).ends(1);
    let found: serde_json::Value = serde_json::from_str(&done.out).expect("JSON");
    assert_eq!(found["schema"], "chordal.collide/1");
    assert_eq!(found["verdict"], "problems");
    let problem = &found["problems"][0];
    assert_eq!((&problem["code"], &problem["line"]), (&"CH680".into(), &10.into()));
    assert_eq!(problem["bodies"][1], "the fixture `clamp`");
    assert!(problem["depth_mm"].as_f64().is_some_and(|mm| (mm - 12.0).abs() < 0.1));
    let done = folder.run(&[&args[..], &["sarif"]].concat()).ends(1);
    let sarif: serde_json::Value = serde_json::from_str(&done.out).expect("JSON");
    assert_eq!(sarif["runs"][0]["results"][0]["ruleId"], "CH680");
}

#[test]
fn a_lathe_is_refused() {
    let folder = folder();
    folder.run(&["collide", "good.nc", "--machine", "haas-st20"]).ends(2);
}
