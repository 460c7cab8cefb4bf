//! `chordal stock --engagement` and `chordal optimize`: answers, exit codes, files, refusals.

#![allow(clippy::disallowed_methods, reason = "the tests look at files")]

mod common;

use common::Folder;

const SETUP: &str = "machine = 'haas-vf2'
[stock]
shape = 'box'
from = { X = '0 mm', Y = '0 mm', Z = '-20 mm' }
to = { X = '100 mm', Y = '60 mm', Z = '0 mm' }
material = 'aluminium'
[tools.1]
shape = 'flat'
diameter = '10 mm'
teeth = 3
flute_length = '25 mm'
length = '110 mm'
";

const PROGRAM: &str = "O1\nG21 G90 G54 G17\nT1 M6\nS6000 M3\nG0 X-8. Y30.\nG43 H1 Z5.\nG1 Z-4. F2000.\n\
                       X110. F900.\nG0 Z5.\nM5\nM30\n";

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("op1.toml", SETUP).write("part.nc", PROGRAM);
    folder
}

#[test]
fn engagement_has_words_json_and_columns() {
    let folder = folder();
    folder.run(&["stock", "part.nc", "--setup", "op1.toml", "--engagement"]).ends(0).says(&[
        "tool 1, 3 teeth",
        "chip          0.05 mm",
        "power ± 30 %",
        "VDI 3323 group 22",
    ]);
    folder
        .run(&["stock", "part.nc", "--setup", "op1.toml", "--engagement", "--chip", "0.04mm"])
        .ends(1)
        .says(&["CH631", "up to 0.05 mm thick, 0.04 mm is the limit", "part.nc:8"]);
    let arguments = ["stock", "part.nc", "--setup", "op1.toml", "--engagement", "--format", "json"];
    let done = folder.run(&arguments).ends(0);
    let found: serde_json::Value = serde_json::from_str(&done.out).expect("JSON");
    assert_eq!(found["schema"], "chordal.engagement/1");
    assert_eq!(found["material"]["vdi_3323"], 22);
    let chip = &found["tools"][0]["chip_mm"];
    assert!(chip["peak"].as_f64().is_some_and(|mm| (mm - 0.05).abs() < 1e-6), "{chip}");
    let mut arguments = vec!["stock", "part.nc", "--setup", "op1.toml", "--engagement"];
    arguments.extend([
        "-o",
        "cuts.csv",
        "-o",
        "cuts.parquet",
        "-o",
        "cuts.arrow",
        "-o",
        "cuts.json",
    ]);
    folder.run(&arguments).ends(0).says(&["written: cuts.csv", "written: cuts.json"]);
    let csv = folder.read("cuts.csv");
    let mut lines = csv.lines();
    assert!(lines.next().is_some_and(|names| names.starts_with("line,file,tool,length_mm")));
    assert!(lines.next().is_some_and(|row| row.starts_with("7,part.nc,1,9,")), "{csv}");
    assert_eq!(csv.lines().count(), 3);
    assert!(folder.bytes("cuts.parquet").starts_with(b"PAR1"));
    assert!(folder.bytes("cuts.arrow").starts_with(b"ARROW1"));
    let rows: serde_json::Value = serde_json::from_str(&folder.read("cuts.json")).expect("JSON");
    assert_eq!(rows["moves"].as_array().map(Vec::len), Some(2));
    folder
        .run(&["stock", "part.nc", "--setup", "op1.toml", "--engagement", "-o", "left.stl"])
        .ends(2)
        .complains(&["left.stl", ".parquet"]);
}

#[test]
fn new_feeds_are_written_and_proved() {
    let folder = folder();
    let arguments = ["optimize", "part.nc", "--setup", "op1.toml", "--chip", "0.04mm"];
    folder.run(&arguments).ends(0).says(&[
        "1 of 2 blocks",
        "proved: ",
        "nothing is written: give -o",
    ]);
    let mut more = arguments.to_vec();
    more.extend(["-o", "new.nc"]);
    folder.run(&more).ends(0).says(&["written: new.nc"]);
    assert_eq!(folder.read("new.nc"), PROGRAM.replace("F900.", "F705."));
    let mut json = arguments.to_vec();
    json.extend(["--format", "json"]);
    let done = folder.run(&json).ends(0);
    let found: serde_json::Value = serde_json::from_str(&done.out).expect("JSON");
    assert_eq!(found["schema"], "chordal.optimize/1");
    assert_eq!(found["changes"][0]["line"], 8);
    let streamed = folder.run(&[&arguments[..], &["-o", "-"]].concat()).ends(0);
    assert_eq!(streamed.out, PROGRAM.replace("F900.", "F705."));
}

#[test]
fn what_cannot_be_is_refused_and_wrong_use_is_said() {
    let folder = folder();
    folder.write("toothless.toml", SETUP.replace("teeth = 3\n", ""));
    folder
        .run(&["optimize", "part.nc", "--setup", "toothless.toml", "-o", "new.nc"])
        .ends(1)
        .says(&["refused: part.nc: no tool has a chip", "give `teeth`", "nothing is written"]);
    assert!(!folder.path("new.nc").is_file());
    folder.write("unknown.nc", PROGRAM.replace("T1 M6", "T4 M6").replace("H1", "H4"));
    folder
        .run(&["optimize", "unknown.nc", "--setup", "op1.toml"])
        .ends(1)
        .says(&["not cut from the stock"]);
    folder
        .run(&["optimize", "part.nc", "-m", "haas-vf2"])
        .ends(2)
        .complains(&["no stock", "--setup"]);
    for wrong in [["--chip", "thin"], ["--faster", "0.5"], ["--faster", "100"]] {
        folder.run(&[&["optimize", "part.nc", "--setup", "op1.toml"], &wrong[..]].concat()).ends(2);
    }
}

#[test]
fn long_lines_are_written_in_parts_where_that_is_asked() {
    let folder = folder();
    let slanted = PROGRAM.replace("Y30.", "Y-4.").replace("X110. F900.", "X110. Y6. F900.");
    folder.write("edge.nc", &slanted);
    let arguments = ["optimize", "edge.nc", "--setup", "op1.toml", "--faster", "3"];
    folder.run(&arguments).ends(0).says(&["0 of 2 blocks"]);
    let mut split = arguments.to_vec();
    split.extend(["--split", "-o", "new.nc"]);
    folder.run(&split).ends(0).says(&[
        "split     1 block into ",
        "nowhere further than 0.000000 mm from the path before",
        "proved: the parts make the path of their blocks",
        "written: new.nc",
    ]);
    assert!(folder.read("new.nc").lines().count() > slanted.lines().count());
    let json = [&arguments[..], &["--split", "--format", "json"]].concat();
    let done = folder.run(&json).ends(0);
    let found: serde_json::Value = serde_json::from_str(&done.out).expect("JSON");
    assert_eq!(found["split"]["blocks"], 1);
    assert!(found["split"]["parts"].as_u64().is_some_and(|parts| parts > 2), "{found}");
    assert_eq!(found["not_split"], serde_json::json!([]));
    folder.write("uneven.nc", slanted.replace("X110. Y6.", "X109.999 Y6."));
    let uneven = ["optimize", "uneven.nc", "--setup", "op1.toml", "--faster", "3", "--split"];
    folder
        .run(&uneven)
        .ends(0)
        .says(&["the block on line 8 is not split: there is no exact point"]);
}

#[test]
fn a_setup_has_materials_of_its_own() {
    let folder = folder();
    let own = SETUP.replace("'aluminium'", "'bronze'")
        + "[materials.bronze]\nk_c1 = '780 N/mm²'\nm_c = 0.18\nsource = 'measured'\n";
    folder.write("bronze.toml", &own);
    let arguments = ["stock", "part.nc", "--setup", "bronze.toml", "--engagement"];
    folder
        .run(&arguments)
        .ends(0)
        .says(&["power ± 30 %", "bronze: measured, 780 N/mm², exponent 0.18"]);
    folder.write("bronze.toml", own.replace("m_c = 0.18\n", ""));
    folder.run(&arguments).ends(0).says(&["`[materials]` has no `m_c` of `bronze`"]);
    folder.write("bronze.toml", own.replace("780 N/mm²", "780000 N/mm²"));
    folder
        .run(&arguments)
        .ends(2)
        .complains(&["is 780000 N/mm²: it must be from 10 to 20000 N/mm²"]);
}
