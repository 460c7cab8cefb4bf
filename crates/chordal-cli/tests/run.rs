//! `chordal run`: summary and output files.

mod common;

use common::{BROKEN, CLEAN, Folder};

#[test]
fn the_summary_is_in_the_programs_units() {
    let folder = Folder::with_part();
    folder.run(&["run", "part.nc", "-m", "haas-vf2"]).ends(0).says(&[
        "part.nc\n",
        "program   O10 (SQUARE)\n",
        "control   Haas NGC mill\n",
        "machine   Haas VF-2 (haas-vf2)\n",
        "units     inch\n",
        "feed in/min",
        "5 to 10",
        "900",
        "X      0.0000  1.0000     0.0000  1.0000  in",
        "4 lines, 1 arc, 3 rapids",
        "in of cuts",
        "with acceleration and jerk: cuts ",
        "the moves without acceleration: ",
    ]);
    folder.write("mm.nc", CLEAN.replace("G20", "G21"));
    folder.run(&["run", "mm.nc", "-m", "haas-vf2"]).says(&["millimetres", "feed mm/min"]);
}

#[test]
fn json_holds_the_summary_and_the_problems() {
    let folder = Folder::with_part();
    folder.write("bad.nc", BROKEN);
    let args = ["run", "--format", "json", "-m", "haas-vf2", "part.nc", "bad.nc"];
    let done = folder.run(&args).ends(1);
    let object: serde_json::Value = serde_json::from_str(&done.out).unwrap();
    assert_eq!(object["schema"], "chordal.run/1");
    let (part, bad) = (&object["files"][0], &object["files"][1]);
    assert_eq!((&part["file"], &bad["file"]), (&"part.nc".into(), &"bad.nc".into()));
    assert_eq!(part["machine"], "haas-vf2");
    assert_eq!(part["diagnostics"], serde_json::json!([]));
    assert_eq!(bad["diagnostics"][0]["code"], "CH401");
    let summary = &part["summary"];
    assert_eq!(summary["units"], "inch");
    assert_eq!(summary["moves"]["lines"], 4);
    assert_eq!(summary["moves"]["arcs"], 1);
    assert_eq!(summary["axes"][0]["axis"], "X");
    assert_eq!(summary["axes"][0]["range"][1], 25.4);
    assert_eq!(summary["tools"][0]["speeds_rpm"], serde_json::json!([900.0]));
    assert!(summary["time_s"].as_f64() > summary["time_without_acceleration_s"].as_f64());
}

#[test]
fn the_control_is_recognized_with_its_evidence() {
    let folder = Folder::new();
    folder.write("haas.nc", CLEAN.replace("G0 X0 Y0", "G0 G154 P1 X0 Y0"));
    folder.write("fadal.nc", CLEAN.replace("G0 X0 Y0", "G0 X0 Y0 E1\nR0+1.5"));
    folder.write("plain.nc", CLEAN).write("plain.ngc", CLEAN);
    folder
        .run(&["run", "plain.ngc"])
        .says(&["LinuxCNC, because of the file extension", "linuxcnc-mill"]);
    folder.run(&["run", "haas.nc"]).says(&[
        "Haas NGC mill, recognized:",
        "line 3: G154",
        "haas-vf2",
    ]);
    folder.run(&["run", "fadal.nc"]).says(&["Fadal CNC 88, recognized:", "line 4: ", "fadal-4020"]);
    folder
        .run(&["run", "plain.nc"])
        .says(&["Fanuc, assumed: nothing in the text says which", "fanuc-30i"]);
}

#[test]
fn it_says_where_the_control_would_stop() {
    let folder = Folder::new();
    folder.write("bad.nc", BROKEN);
    folder
        .run(&["run", "bad.nc", "-m", "haas-vf2"])
        .ends(1)
        .says(&["stop      the control would stop at line 6: alarm 304", "error[CH401]"]);
    // The first in the order of the run, not of the text.
    folder.write(
        "order.nc",
        "O1\nG20 G90 G0 X0 Y0 Z0\nM98 P2\nG1 X1. F5.\nG2 X3. Y3. I.1\nM30\nO2\nG2 X9. Y9. I.1 F5.\nM99\n",
    );
    folder.run(&["run", "order.nc", "-m", "haas-vf2"]).ends(1).says(&["would stop at line 8"]);
}

#[test]
fn outputs_are_written_by_their_endings() {
    let folder = Folder::with_part();
    let done = folder.run(&[
        "run",
        "part.nc",
        "-m",
        "haas-vf2",
        "-o",
        "a.svg",
        "-o",
        "a.png",
        "-o",
        "a.dxf",
        "-o",
        "a.csv",
        "-o",
        "a.jsonl",
        "-o",
        "new/a.canon",
    ]);
    done.ends(0).says(&["written   a.svg", "written   new/a.canon"]);
    assert_eq!(
        folder.names(),
        ["a.csv", "a.dxf", "a.jsonl", "a.png", "a.svg", "new/a.canon", "part.nc"]
    );
    assert!(folder.read("a.svg").trim_start().starts_with("<svg"));
    assert!(folder.read("a.dxf").contains("ENTITIES"));
    assert!(folder.read("a.jsonl").starts_with("{\"schema\":\"chordal.commands/1\""));
    let commands = folder.run(&["commands", "part.nc", "-m", "haas-vf2", "--format", "canon"]);
    assert_eq!(folder.read("new/a.canon"), commands.out);
}

#[test]
fn an_unknown_ending_is_told_before_anything_runs() {
    let folder = Folder::with_part();
    for name in ["a.doc", "a", "a.svg.gz"] {
        let done = folder.run(&["run", "part.nc", "-o", "b.svg", "-o", name]).ends(2);
        assert_eq!(done.out, "");
        assert!(done.err.contains(".svg, .png, .dxf, .csv, .jsonl, .canon"), "{}", done.err);
    }
    assert_eq!(folder.names(), ["part.nc"]);
}

#[test]
fn nothing_is_left_half_written() {
    let folder = Folder::with_part();
    folder.write("a.svg/in-the-way", "");
    folder.run(&["run", "part.nc", "-o", "b.csv", "-o", "a.svg/../part.nc/x.csv"]).ends(2);
    assert_eq!(folder.names(), ["a.svg/in-the-way", "part.nc"]);
    // An older file stays whole until the new one is.
    folder.write("old.csv", "old");
    folder.run(&["run", "part.nc", "-o", "old.csv"]).ends(0);
    assert!(folder.read("old.csv").contains("arc"));
    // A program is not written over.
    folder.write("part.csv", CLEAN);
    folder
        .run(&["run", "part.csv", "-o", "part.csv"])
        .ends(2)
        .complains(&["is one of the programs to run"]);
    assert_eq!(folder.read("part.csv"), CLEAN);
}

#[cfg(unix)]
#[test]
#[allow(clippy::disallowed_methods, reason = "the mode of a file is asked of the file")]
fn written_files_have_the_usual_mode() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::with_part();
    folder.write("plain", "");
    folder.run(&["run", "part.nc", "-o", "a.csv"]).ends(0);
    let mode = |name| std::fs::metadata(folder.path(name)).unwrap().permissions().mode();
    assert_eq!(mode("a.csv"), mode("plain"));
}

#[test]
fn several_programs_need_a_pattern() {
    let folder = Folder::new();
    folder.write("in/O1.nc", CLEAN).write("in/sub/O2.nc", CLEAN).write("in/sub/O2.tap", CLEAN);
    folder
        .run(&["run", "in", "-o", "one.svg"])
        .ends(2)
        .complains(&["one.svg is one file, and there are 3 programs", "-o 'DIR/*.svg'"]);
    folder.run(&["run", "in", "-m", "haas-vf2", "-o", "out/", "-o", "out/*-c.csv"]).ends(0);
    let written: Vec<String> =
        folder.names().into_iter().filter(|name| name.starts_with("out/")).collect();
    assert_eq!(
        written,
        [
            "out/O1-c.csv",
            "out/O1.svg",
            "out/sub/O2.nc-c.csv",
            "out/sub/O2.nc.svg",
            "out/sub/O2.tap-c.csv",
            "out/sub/O2.tap.svg"
        ]
    );
}

#[test]
fn a_picture_of_a_laser_has_its_powers() {
    let folder = Folder::with_part();
    let cuts = |powers: &[u32]| {
        let lines = powers.iter().enumerate();
        let lines: String =
            lines.map(|(y, s)| format!("G0 X0 Y{y} S0\nG1 X10 S{s} F900\n")).collect();
        format!("G21 G90\nM4 S0\n{lines}M5\nM30\n")
    };
    let legend = |powers: &[u32]| {
        folder.write("laser.nc", cuts(powers));
        folder.run(&["run", "laser.nc", "-m", "grbl", "-o", "laser.svg"]).ends(0);
        folder.read("laser.svg")
    };
    let two = legend(&[350, 1000, 350]);
    assert!(two.contains(">S350  20.00 mm<") && two.contains(">S1000  10.00 mm<"), "{two}");
    // Steps of a fifth of the most.
    let many = legend(&[1000, 850, 300, 250]);
    assert!(many.contains(">S250 to S300  20.00 mm<"), "{many}");
    assert!(many.contains(">S850 to S1000  20.00 mm<"), "{many}");
    // One power is no scale.
    assert!(!legend(&[350, 350]).contains(">S350"));
}
