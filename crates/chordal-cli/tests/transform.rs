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
    done.ends(0).says(&[
        "-X10.",
        "+X15.",
        "+G3 X25. Y9. R10.",
        "same: ",
        "nothing is written: give a file with -o",
    ]);
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
fn other_options_may_follow_a_shift() {
    let folder = folder();
    let line = ["transform", "part.nc", "-m", "haas-vf2", "--shift", "X5", "Y-1", "-o", "moved.nc"];
    folder.run(&line).ends(0).says(&["written: moved.nc"]);
    assert!(std::fs::read_to_string(folder.path("moved.nc")).unwrap().contains("G3 X25. Y9. R10."));
}

#[test]
fn what_is_refused_names_the_line() {
    let folder = Folder::new();
    folder.write("pocket.nc", "G21 G90 S900 M3\nG1 X0 Y0 F100.\nG13 I5. F100. D1\nM30\n");
    let turned = ["transform", "pocket.nc", "-m", "haas-vf2", "--rotate", "30", "-o", "out.nc"];
    folder.run(&turned).ends(1).says(&["refused: pocket.nc:3", "G13 I5.", "nothing is written"]);
    assert!(!folder.path("out.nc").exists());
}

const TWO_TOOLS: &str = "O5\nT1 M6\nG20 G90 G54 G0 X0 Y0 S900 M3\nG43 H1 Z1.\nG1 Z-.1 F5.\nG0 Z1.\nT2 M6\n\
                         G90 G54 G0 X1. Y0 S900 M3\nG43 H2 Z1.\nG1 Z-.1 F5.\nG0 Z1.\nM30\n";

#[test]
fn parts_are_written_beside_one_another() {
    let folder = Folder::new();
    folder.write("part.nc", TWO_TOOLS);
    let line = ["transform", "part.nc", "-m", "haas-vf2", "--split", "tool", "-o", "out.nc"];
    folder.run(&line).ends(0).says(&[
        "2 parts, split before every tool change",
        "O6: lines 7 to 12",
        "+ G20 G90",
        "same: ",
        "written: out-1.nc to out-2.nc",
    ]);
    let second = std::fs::read_to_string(folder.path("out-2.nc")).unwrap();
    assert!(second.starts_with("O6\n(PART 2 OF 2, FROM LINE 7)\nG20 G90\n"), "{second}");
    // Steps before it, and both proofs.
    let line = [&line[..], &["--format", "json", "--shift", "X1"]].concat();
    let done = folder.run(&line).ends(0);
    let told: Value = serde_json::from_str(&done.out).unwrap();
    assert_eq!(told["verdict"], "proved");
    assert_eq!(told["changed"]["verdict"], "same");
    assert_eq!(told["parts"][1]["written"], "out-2.nc");
    let second = std::fs::read_to_string(folder.path("out-2.nc")).unwrap();
    assert!(second.contains("X2. Y0"), "{second}");
}

#[test]
fn what_cannot_be_parted_is_not_written() {
    let folder = Folder::new();
    folder.write("part.nc", TWO_TOOLS);
    let line = ["transform", "part.nc", "-m", "haas-vf2", "--split", "50", "-o", "out.nc"];
    folder.run(&line).ends(1).says(&[
        "refused: part.nc:1",
        "from line 1 to line 6",
        "more than allowed",
    ]);
    assert!(!folder.path("out-1.nc").exists());
}

#[test]
fn wrong_use() {
    let folder = folder();
    folder.run(&["transform", "part.nc", "-m", "haas-vf2"]).ends(2);
    folder.run(&["transform", "part.nc", "-m", "haas-vf2", "--shift", "Q5"]).ends(2);
    folder.run(&["transform", "part.nc", "-m", "haas-vf2", "--fit", "-1"]).ends(2);
    folder.run(&["transform", "part.nc", "-m", "haas-vf2", "--split", "0"]).ends(2);
}
