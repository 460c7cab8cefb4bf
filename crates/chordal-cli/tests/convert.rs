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
