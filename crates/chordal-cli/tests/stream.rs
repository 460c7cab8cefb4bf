//! `chordal commands` and `chordal chords`: standard output as a stream.

mod common;

use std::io::{BufRead, BufReader, Read};
use std::process::Stdio;

use common::{BROKEN, Folder};
use serde_json::Value;

#[test]
fn commands_are_json_lines() {
    let folder = Folder::with_part();
    let done = folder.run(&["commands", "part.nc", "-m", "haas-vf2"]).ends(0);
    assert_eq!(done.err, "");
    let lines: Vec<Value> =
        done.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(lines[0]["schema"], "chordal.commands/1");
    let arc = lines.iter().find(|line| line["kind"] == "arc").unwrap();
    assert_eq!(arc["line"], 9);
    assert_eq!(arc["direction"], "ccw");
}

#[test]
fn problems_go_to_standard_error() {
    let folder = Folder::new();
    folder.write("bad.nc", BROKEN);
    for command in ["commands", "chords"] {
        let done = folder.run(&[command, "bad.nc", "-m", "haas-vf2"]).ends(1);
        assert!(!done.out.contains("error["));
        done.complains(&["error[CH401]", "1 error"]);
    }
}

#[test]
fn chords_keep_the_tolerance() {
    let folder = Folder::with_part();
    let rows = |arguments: &[&str]| {
        let base = ["chords", "part.nc", "-m", "haas-vf2"];
        folder.run(&[&base, arguments].concat()).ends(0).out.lines().count()
    };
    let (coarse, fine) = (rows(&["--tolerance", "1mm"]), rows(&["--tolerance", "0.001 mm"]));
    assert!(coarse * 5 < fine, "{coarse} and {fine}");
    assert_eq!(rows(&[]), rows(&["--tolerance", "10um"]));
    assert!(rows(&["--placement", "balanced"]) < rows(&["--placement", "inscribed"]));
    let done = folder.run(&["chords", "part.nc", "--format", "jsonl"]).ends(0);
    assert!(done.out.lines().all(|line| serde_json::from_str::<Value>(line).is_ok()));
    for (wrong, said) in [("0.01", "no unit"), ("0mm", "above zero"), ("1 s", "is a time")] {
        folder.run(&["chords", "part.nc", "--tolerance", wrong]).ends(2).complains(&[said]);
    }
}

#[test]
fn chords_of_the_control_are_its_own_segments() {
    let folder = Folder::new();
    // A full turn of R 1: the firmware cuts it into 49.
    folder.write("turn.nc", "G21 G90 G17 F100\nG2 X0 Y0 I1\n");
    let own = ["chords", "turn.nc", "-m", "grbl", "--as-control"];
    let rows = folder.run(&own).ends(0).out;
    let rows: Vec<&str> = rows.lines().filter(|row| row.contains(",arc,")).collect();
    assert_eq!(rows.len(), 49);
    let off: f64 = rows[0].rsplit(',').next().unwrap().parse().unwrap();
    assert!((off - (1.0 - (std::f64::consts::PI / 49.0).cos())).abs() < 1e-9, "{off}");
    let wider = [&own[..], &["--set", "settings.$12=0.1 mm"]].concat();
    assert_eq!(folder.run(&wider).ends(0).out.matches(",arc,").count(), 7);
    let other = ["chords", "turn.nc", "-m", "haas-vf2", "--as-control"];
    folder.run(&other).ends(2).complains(&["Haas NGC mill is not known to cut arcs"]);
}

#[test]
fn one_program_at_a_time() {
    let folder = Folder::with_part();
    folder.run(&["commands", "."]).ends(2).complains(&["is a folder"]);
    folder
        .run(&["commands", "none.nc"])
        .ends(2)
        .complains(&["error: cannot read none.nc: no such"]);
}

#[test]
fn a_closed_pipe_ends_quietly() {
    let folder = Folder::new();
    let mut text = String::from("O1\nG21 G90 G0 X0 Y0 Z0\nG1 F100.\n");
    for step in 0..200_000 {
        text.push_str(&format!("X{}.\n", step % 100));
    }
    folder.write("long.nc", text + "M30\n");
    for arguments in [
        &["commands", "long.nc"][..],
        &["commands", "long.nc", "--format", "canon"],
        &["commands", "long.nc", "--format", "csv"],
        &["chords", "long.nc"],
    ] {
        let mut child = folder
            .command(arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut first = String::new();
        BufReader::new(child.stdout.take().unwrap()).read_line(&mut first).unwrap();
        let mut err = String::new();
        child.stderr.take().unwrap().read_to_string(&mut err).unwrap();
        let code = child.wait().unwrap().code();
        assert!(!first.is_empty());
        assert_eq!((code, err.as_str()), (Some(0), ""), "{arguments:?}");
    }
}
