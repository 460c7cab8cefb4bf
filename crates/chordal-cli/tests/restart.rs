//! `chordal restart`: what is shown, what is written, exit codes.

#![allow(clippy::disallowed_methods, reason = "a test looks at the files of its folder")]

mod common;

use common::Folder;

const PART: &str = "O1\nT1 M06\nG21 G90 G54 G00 X0 Y0 S900 M03\nG43 H01 Z20.\nG01 Z-1. F100.\nX10.\n\
                    G41 D01 X20.\nY10.\nG40 X0.\nG00 Z50.\nM30\n";

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("part.nc", PART);
    folder
}

#[test]
fn the_head_is_shown_and_nothing_written() {
    let done = folder().run(&["restart", "part.nc", "-m", "haas-vf2", "--line", "6"]);
    done.ends(0).says(&[
        "begins at line 6",
        "+ T1 M06",
        "+ G01 Z-1. F100.",
        "proof: ",
        "nothing is written: give a file with -o",
    ]);
}

#[test]
fn a_proved_program_is_written_and_a_refused_one_is_not() {
    let folder = folder();
    let line = ["restart", "part.nc", "-m", "haas-vf2", "-o", "new.nc", "--line"];
    folder.run(&[&line[..], &["8"]].concat()).ends(1).says(&[
        "cutter compensation is on",
        "begin at line 7",
        "nothing is written",
    ]);
    assert!(!folder.path("new.nc").exists());
    folder.run(&[&line[..], &["7"]].concat()).ends(0).says(&["written: new.nc"]);
    let text = std::fs::read_to_string(folder.path("new.nc")).unwrap();
    assert!(text.starts_with("O1\n(BEGINS AT LINE 7 OF PART.NC)\n"), "{text}");
    assert!(text.ends_with("G41 D01 X20.\nY10.\nG40 X0.\nG00 Z50.\nM30\n"), "{text}");
}

#[test]
fn a_line_that_is_not_there_is_refused_and_none_is_wrong_use() {
    let folder = folder();
    folder
        .run(&["restart", "part.nc", "-m", "haas-vf2", "--line", "99"])
        .ends(1)
        .says(&["the program has no line 99", "it ends at line 11"]);
    folder.run(&["restart", "part.nc", "-m", "haas-vf2", "--line", "0"]).ends(2);
    folder.run(&["restart", "part.nc", "-m", "haas-vf2"]).ends(2);
}

#[test]
fn json_says_what_is_put_in_or_why_not() {
    let folder = folder();
    let line = ["restart", "part.nc", "-m", "haas-vf2", "--format", "json", "--line"];
    folder.run(&[&line[..], &["6"]].concat()).ends(0).says(&[
        "\"schema\": \"chordal.restart/1\"",
        "\"verdict\": \"proved\"",
        "\"G01 Z-1. F100.\"",
        "\"written\": null",
    ]);
    folder.run(&[&line[..], &["8"]].concat()).ends(1).says(&[
        "\"verdict\": \"refused\"",
        "\"reason\": \"compensation\"",
        "begin at line 7",
    ]);
}
