//! `chordal convert`: answers, files, exit codes.

mod common;

use common::Folder;
use serde_json::Value;

/// A helix of a Fadal, repeated.
const FADAL: &str =
    "M6 T1\nG0 G90 S100 M3 E1 X0 Y0\nH1 Z.1 M8\nG1 Z0 F10.\nG91 I-.5 Z-.1 G3 G90 L3\nX1. \nM2\n";

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("part.nc", FADAL);
    folder
}

#[test]
fn changes_and_proof_are_told_and_nothing_is_written() {
    let folder = folder();
    let two = ["convert", "part.nc", "-m", "fadal-4020", "--to", "haas-vf2"];
    let told = ["the motion is the same", "E1 -> G54", "line 3: H1 -> G43 H1", "proof: same"];
    folder.run(&two).ends(0).says(&told);
    assert!(!folder.names().contains(&"haas.nc".to_string()));
    folder.run(&[&two[..], &["-o", "haas.nc"]].concat()).ends(0).says(&["wrote haas.nc"]);
    let both = ["compare", "part.nc", "haas.nc", "--as", "fadal-4020", "--as", "haas-vf2"];
    folder.run(&[&both[..], &["--ignore", "path-mode"]].concat()).ends(0);
}

#[test]
fn the_program_alone_to_standard_output() {
    let folder = folder();
    let done = folder
        .run(&["convert", "part.nc", "-m", "fadal-4020", "--to", "fanuc-6m", "-o", "-"])
        .ends(0);
    assert!(done.out.contains("G43 H1 Z.1 M8") && !done.out.contains("proof"), "{}", done.out);
}

#[test]
fn as_json_with_a_certificate() {
    let folder = folder();
    let line = ["convert", "part.nc", "-m", "fadal-4020", "--to", "haas-vf2"];
    let more = ["--format", "json", "--certificate", "proof.json"];
    let done = folder.run(&[&line[..], &more[..]].concat()).ends(0);
    let found: Value = serde_json::from_str(&done.out).unwrap();
    assert_eq!(found["schema"], "chordal.convert/1");
    assert_eq!(found["holds"], true);
    assert_eq!(found["proof"]["verdict"], "same");
    assert!(found["text"].as_str().unwrap().contains("G54"));
    assert_eq!(done.out, folder.read("proof.json"));
}

#[test]
fn what_is_not_proved_is_not_written() {
    let folder = folder();
    folder.write("bad.nc", "G20 G90 S100 M3\nG0 X0 Y0 Z0\nG2 X1. Y0 I.6 J0 F10.\nM30\n");
    let line = ["convert", "bad.nc", "-m", "haas-vf2", "--to", "fadal-4020", "-o", "out.nc"];
    let told = ["1 block cannot be converted", "line 3", "out.nc is not written"];
    folder.run(&line).ends(1).says(&told);
    assert!(!folder.names().contains(&"out.nc".to_string()));
    folder.run(&["convert", "part.nc", "--to", "no-such-machine"]).ends(2);
}

#[test]
fn pecks_of_a_kept_cycle_are_told_and_exact_cycles_are_written_out() {
    let folder = folder();
    let text = "G20 G90 E1\nT1 M6\nS1000 M3\nG0 X0 Y0\nH1 Z1.\nG83 G98 X1. Y0 Z-1. R0+.1 Q.3 F10.\nX2.\n\
                G80\nM2\n";
    folder.write("holes.nc", text);
    let line = ["convert", "holes.nc", "-m", "fadal-4020", "--to", "haas-vf2"];
    folder.run(&[&line[..], &["-o", "kept.nc"]].concat()).ends(0).says(&[
        "the motion is the same except for pecks",
        "G83 in 2 blocks (2 holes), first in line 6: the holes are the same, their pecks are not",
        "fadal-4020: 4 pecks of 0.3 in at most; the rapid back stops 0.05 in above the last depth",
        "haas-vf2: 4 pecks of 0.3 in at most; the rapid back stops 0.02 in above the last depth (Setting 22)",
    ]);
    assert!(folder.read("kept.nc").contains("\nG83 G98 X1. Y0 Z-1. R.1 Q.3 F10.\nX2.\n"));
    let json = folder.run(&[&line[..], &["--format", "json"]].concat()).ends(0);
    let found: Value = serde_json::from_str(&json.out).unwrap();
    let places: Vec<_> =
        found["pecks"].as_array().unwrap().iter().map(|one| &one["line"]).collect();
    assert_eq!(places, [6, 7]);
    assert_eq!(found["pecks"][0]["new"]["clearance_setting"], "Setting 22");
    let exact = [&line[..], &["--exact-cycles", "-o", "exact.nc"]].concat();
    let done = folder.run(&exact).ends(0).says(&["the motion is the same\n"]);
    assert!(!done.out.contains("pecks"), "{}", done.out);
    assert!(!folder.read("exact.nc").contains("\nG83"), "{}", folder.read("exact.nc"));
}
