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

const HEIGHTS: &str = "x,y,z\n-5,-5,0.1\n30,-5,0.1\n-5,30,0.1\n30,30,0.1\n";

#[test]
fn a_map_of_heights_raises_the_cuts() {
    let folder = folder();
    folder.write("map.csv", HEIGHTS);
    let line = ["transform", "part.nc", "-m", "haas-vf2", "--heights", "map.csv", "-o", "new.nc"];
    folder.run(&line).ends(0).says(&[
        "the map has 2 by 2 points",
        "heights under the cuts: 0.1 to 0.1 mm",
        "written: new.nc",
    ]);
    let text = std::fs::read_to_string(folder.path("new.nc")).unwrap();
    assert!(text.contains("Z2.1\nG1 Z-0.9 F100.\nX10.\nG3 X20. Y10. R10.\n"), "{text}");
    // Z was set on this surface: nothing is to be raised.
    let set = folder.run(&[&line[..], &["--heights-zero", "0,0"]].concat()).ends(0);
    assert!(set.out.contains("nothing changes"), "{}", set.out);
    // Steps come first, each proved; the map lies where it was measured.
    folder
        .run(&[&line[..], &["--shift", "X5"]].concat())
        .ends(0)
        .says(&["+X15.", "proved by itself"]);
    let inches = folder.run(&[&line[..], &["--heights-units", "inch"]].concat()).ends(0);
    assert!(
        inches.out.contains("the file is in inches") || inches.out.contains("Z4.54"),
        "{}",
        inches.out
    );
}

#[test]
fn a_cut_beyond_the_map_and_a_bad_map_are_told() {
    let folder = folder();
    folder.write("small.csv", HEIGHTS.replace("30", "15"));
    let line = ["transform", "part.nc", "-m", "haas-vf2", "-o", "new.nc", "--heights"];
    folder
        .run(&[&line[..], &["small.csv"]].concat())
        .ends(1)
        .says(&["part.nc:6: the cut goes 5.0000 mm beyond the map", "--heights-outside clamp"]);
    assert!(!folder.path("new.nc").exists());
    folder.run(&[&line[..], &["small.csv", "--heights-outside", "clamp"]].concat()).ends(0);
    folder.write("bad.csv", "0,0,0\n0,10,oops\n");
    folder.run(&[&line[..], &["bad.csv"]].concat()).ends(2).complains(&[
        "bad.csv:2: `oops` in column 3 is no number for Z",
        "write a point as X, Y and Z",
    ]);
    folder.run(&[&line[..], &["none.csv"]].concat()).ends(2).complains(&["none.csv"]);
    folder.run(&["transform", "part.nc", "-m", "haas-vf2", "--heights-zero", "0,0"]).ends(2);
}
