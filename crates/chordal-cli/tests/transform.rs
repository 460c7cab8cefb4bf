//! `chordal transform`: what is shown, what is written, exit codes.

#![allow(clippy::disallowed_methods, reason = "a test looks at the files of its folder")]

mod common;

use common::Folder;
use serde_json::Value;

const PART: &str =
    "G21 G90 G54 S900 M3\nG0 X0 Y0\nZ2.\nG1 Z-1. F100.\nX10.\nG3 X20. Y10. R10.\nG0 Z50.\nM30\n";

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("part.nc", PART);
    folder
}

#[test]
fn the_difference_is_shown_and_nothing_written() {
    let folder = folder();
    let done = folder.run(&["transform", "part.nc", "-m", "haas-vf2", "--shift", "X5", "Y-1mm"]);
    done.ends(0).says(&["-X10.", "+X15.", "+G3 X25. Y9. R10.", "same: ", "nothing is written: -o"]);
}

#[test]
fn a_proved_program_is_written() {
    let folder = folder();
    let line = ["transform", "part.nc", "-m", "haas-vf2", "--mirror", "x", "--format", "json"];
    let done = folder.run(&[&line[..], &["-o", "left.nc"]].concat()).ends(0);
    let told: Value = serde_json::from_str(&done.out).unwrap();
    assert_eq!(
        (told["verdict"].as_str(), told["written"].as_str()),
        (Some("proved"), Some("left.nc"))
    );
    assert_eq!(told["certificate"]["verdict"], "same");
    let text = std::fs::read_to_string(folder.path("left.nc")).unwrap();
    assert!(text.contains("G2 X-20. Y10. R10."), "{text}");
    folder.run(&[&line[..], &["-o", "dry.nc", "--dry-run"]].concat()).ends(0);
    assert!(!folder.path("dry.nc").exists());
}

#[test]
fn what_is_refused_names_the_line() {
    let folder = Folder::new();
    folder.write("pocket.nc", "G21 G90 S900 M3\nG1 X0 Y0 F100.\nG13 I5. F100. D1\nM30\n");
    let turned = ["transform", "pocket.nc", "-m", "haas-vf2", "--rotate", "30", "-o", "out.nc"];
    folder.run(&turned).ends(1).says(&["refused: pocket.nc:3", "G13 I5.", "nothing is written"]);
    assert!(!folder.path("out.nc").exists());
}

#[test]
fn wrong_use() {
    let folder = folder();
    folder.run(&["transform", "part.nc", "-m", "haas-vf2"]).ends(2);
    folder.run(&["transform", "part.nc", "-m", "haas-vf2", "--shift", "Q5"]).ends(2);
    folder.run(&["transform", "part.nc", "-m", "haas-vf2", "--fit", "-1"]).ends(2);
}
