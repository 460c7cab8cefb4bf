//! `chordal stock`: the answer, its exit code, its files, and wrong setups.

mod common;

use common::Folder;

const SETUP: &str = "machine = 'haas-vf2'
[stock]
shape = 'box'
from = { X = '0 mm', Y = '0 mm', Z = '-20 mm' }
to = { X = '80 mm', Y = '60 mm', Z = '0 mm' }
[tools.1]
kind = 'flat'
diameter = '10 mm'
flute_length = '25 mm'
shank_diameter = '10 mm'
";

const CLEAN: &str = "O1\nG21 G90 G54\nT1 M6\nS3000 M3\nG0 X20. Y30.\nG43 H1 Z5.\nG1 Z-5. F200.\nX60. F600.\nG0 Z5.\nM30\n";

fn folder() -> Folder {
    let folder = Folder::new();
    folder
        .write("op1.toml", SETUP)
        .write("part.nc", CLEAN)
        .write("hit.nc", CLEAN.replace("G1 Z-5. F200.", "G0 Z-5."));
    folder
}

#[test]
fn clean_is_proved_and_a_rapid_in_the_stock_is_not() {
    let folder = folder();
    folder.run(&["stock", "part.nc", "--setup", "op1.toml"]).ends(0).says(&[
        "removed",
        "left",
        "clean: no rapid",
    ]);
    folder
        .run(&["stock", "hit.nc", "--setup", "op1.toml"])
        .ends(1)
        .says(&["error[CH620]: a rapid goes 5 mm deep through material", "hit.nc:7"]);
}

#[test]
fn json_has_the_bounds_and_the_problems() {
    let folder = folder();
    let done = folder.run(&["stock", "hit.nc", "--setup", "op1.toml", "--format", "json"]).ends(1);
    let found: serde_json::Value = serde_json::from_str(&done.out).expect("JSON");
    assert_eq!(found["schema"], "chordal.stock/1");
    assert_eq!(found["verdict"], "problems");
    let problem = &found["problems"][0];
    assert_eq!((&problem["code"], &problem["line"]), (&"CH620".into(), &7.into()));
    assert!(problem["depth_mm"]["least"].as_f64().is_some_and(|mm| (mm - 5.0).abs() < 1e-3));
    // A rapid removes nothing.
    assert_eq!(found["removed_mm3"]["most"], 0.0);
    let done = folder.run(&["stock", "part.nc", "--setup", "op1.toml", "--format", "json"]).ends(0);
    let found: serde_json::Value = serde_json::from_str(&done.out).expect("JSON");
    let removed = &found["removed_mm3"];
    let truth = (400.0 + 25.0 * std::f64::consts::PI) * 5.0;
    assert!(removed["least"].as_f64() <= Some(truth) && removed["most"].as_f64() >= Some(truth));
}

#[test]
fn what_is_left_is_the_stock_of_the_next_operation() {
    let folder = folder();
    folder
        .run(&["stock", "part.nc", "--setup", "op1.toml", "-o", "left.stl", "-o", "left.png"])
        .ends(0)
        .says(&["written: left.stl", "written: left.png"]);
    let second = "machine = 'haas-vf2'
[stock]
shape = 'stl'
file = 'left.stl'
turned_over = 'X'
from = { Y = '60 mm', Z = '-20 mm' }
[tools.1]
shape = 'flat'
diameter = '10 mm'
flute_length = '25 mm'
";
    folder.write("op2.toml", second);
    // Below the pocket of the first side 15 mm are left.
    folder
        .run(&["stock", "part.nc", "--setup", "op2.toml", "-o", "two.stl"])
        .ends(0)
        .says(&["clean: no rapid", "hollow from below"]);
    folder.write("left.stl", "solid of nothing");
    folder
        .run(&["stock", "part.nc", "--setup", "op2.toml"])
        .ends(2)
        .complains(&["left.stl", "op2.toml:2"]);
}

#[test]
fn wrong_setups_are_drawn() {
    let folder = folder();
    folder.run(&["stock", "part.nc", "-m", "haas-vf2"]).ends(2).complains(&["no stock", "--setup"]);
    folder.write("open.toml", SETUP.replace(", Z = '0 mm' }", " }"));
    folder
        .run(&["stock", "part.nc", "--setup", "open.toml"])
        .ends(2)
        .complains(&["`stock.to` has no Z", "open.toml:2"]);
    folder
        .run(&["stock", "part.nc", "--setup", "op1.toml", "--resolution", "0.001mm"])
        .ends(2)
        .complains(&["--memory"]);
    folder
        .run(&["stock", "part.nc", "--setup", "op1.toml", "-o", "left.xyz"])
        .ends(2)
        .complains(&[".stl, .3mf, .glb, .png"]);
}
