//! `chordal compare`: answers, exit codes, what is reported.

mod common;

use common::{CLEAN, Folder};
use serde_json::Value;

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("a.nc", CLEAN).write("b.nc", CLEAN.replace("Z-.1 ", "Z-.11 "));
    folder
}

#[test]
fn the_same_motion() {
    let folder = folder();
    folder.write("spaced.nc", CLEAN.replace('X', " X ").replace("G0", "G00"));
    folder.run(&["compare", "a.nc", "spaced.nc", "-m", "haas-vf2"]).ends(0).says(&["same: "]);
}

#[test]
fn a_difference_and_a_tolerance() {
    let folder = folder();
    let two = ["compare", "a.nc", "b.nc", "-m", "haas-vf2"];
    folder.run(&two).ends(1).says(&[
        "different: ",
        "at most 0.01 in apart",
        "a.nc:6",
        "b.nc:6",
        "Z-.11",
    ]);
    let within = [&two[..], &["--tolerance", "0.02in"]].concat();
    folder
        .run(&within)
        .ends(0)
        .says(&["within the tolerance: ", "at most 0.01 in apart, 0.02 in is allowed"]);
    let tight = [&two[..], &["--tolerance", "0.2mm"]].concat();
    folder.run(&tight).ends(1);
}

#[test]
fn as_json() {
    let folder = folder();
    let done =
        folder.run(&["compare", "a.nc", "b.nc", "-m", "haas-vf2", "--format", "json"]).ends(1);
    let found: Value = serde_json::from_str(&done.out).unwrap();
    assert_eq!(found["schema"], "chordal.compare/1");
    assert_eq!(found["verdict"], "different");
    assert!((found["max_distance_mm"].as_f64().unwrap() - 0.254).abs() < 1e-9);
    assert_eq!(found["programs"]["b"]["file"], "b.nc");
    let path = &found["differences"][0];
    assert_eq!(path["category"], "path");
    // Where to look: the same X and Y, two depths.
    let depth = |of: &Value| of["at_mm"][2].as_f64().unwrap();
    assert!((depth(&path["a"]) - depth(&path["b"]) - 0.254).abs() < 1e-9, "{path}");
    assert_eq!(found["farthest"]["a"]["at_mm"], path["a"]["at_mm"]);
    assert_eq!(path["a"]["lines"], path["b"]["lines"]);
    assert!(path["b"]["text"].as_str().unwrap().contains("Z-.11"));
}

#[test]
fn one_program_on_two_machines() {
    let folder = Folder::new();
    folder.write("arc.nc", "G20 G90\nG0 X0 Y0 Z0\nG1 X1. F10.\nG2 X2. Y-1. I1. J-1.\nM30\n");
    // The centre from the start on one, absolute on the other.
    folder
        .run(&["compare", "arc.nc", "--as", "haas-vf2", "--as", "textbook-absolute-center"])
        .ends(1)
        .says(&["different: ", "haas-vf2:4", "textbook-absolute-center:4"]);
}

#[test]
fn wrong_use_is_told() {
    let folder = folder();
    folder.run(&["compare", "a.nc"]).ends(2).complains(&["nothing to compare it with", "--as"]);
    folder
        .run(&["compare", "a.nc", "b.nc", "--as", "haas-vf2"])
        .ends(2)
        .complains(&["give it twice"]);
    folder.run(&["compare", "a.nc", "none.nc"]).ends(2).complains(&["cannot read none.nc"]);
    let bad = ["compare", "a.nc", "b.nc", "--tolerance=-1mm"];
    folder.run(&bad).ends(2).complains(&["write a length of zero or more"]);
    let bad = ["compare", "a.nc", "b.nc", "--ignore", "colour"];
    folder.run(&bad).ends(2).complains(&["one of path, order"]);
}

#[test]
fn what_is_ignored_is_no_difference() {
    let folder = Folder::with_part();
    folder.write("faster.nc", CLEAN.replace("F10.", "F11."));
    let two = ["compare", "part.nc", "faster.nc", "-m", "haas-vf2"];
    folder.run(&two).ends(1).says(&["the paths are the same", "feed", "10 in/min", "11 in/min"]);
    folder.run(&[&two[..], &["--ignore", "feed"]].concat()).ends(0).says(&["same: "]);
}

#[test]
fn a_picture_of_both() {
    let folder = folder();
    let two = ["compare", "a.nc", "b.nc", "-m", "haas-vf2", "-o", "both.svg"];
    folder.run(&two).ends(1);
    let picture = folder.read("both.svg");
    assert!(picture.contains(">a.nc  ") && picture.contains(">b.nc  "), "names in the legend");
    assert!(picture.contains("tool-1") && picture.contains("tool-2"));
    folder.run(&["compare", "a.nc", "b.nc", "-m", "haas-vf2", "-o", "both.pdf"]).ends(2);
}
