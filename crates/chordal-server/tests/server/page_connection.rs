//! What a page receives (path, problems, times), and its requests.

use std::f32::consts::FRAC_PI_2;
use std::fs;

use crate::common::{PageMessage, Shown, serve};

/// A quarter circle about (0, 0) and a line, in millimetres.
const QUARTER: &str =
    "G21 G90\nT1 M6\nS1000 M3\nG0 X10. Y0 Z5.\nG1 Z0 F100.\nG3 X0 Y10. I-10. J0\nG1 Y20.\nM30\n";

#[test]
fn the_path_is_columns_and_arcs_have_their_exact_record() {
    let mut live = serve(Shown::text(QUARTER)).live();
    assert_eq!(live.json("hello")["name"], "part.nc");
    let run = live.json("run");
    assert_eq!(run["machine"]["name"], "haas-vf2");
    let path = live.columns("path");
    let rows = path.header["rows"].as_u64().unwrap() as usize;
    let (lines, kinds) = (path.u32("line"), path.u8("kind"));
    assert_eq!(lines.len(), rows);
    // Known from X and Y on; the arc is the row of line 6.
    let arc = lines.iter().position(|line| *line == 6).unwrap();
    assert_eq!(kinds[arc], 0x12);
    assert_eq!(path.u32("arc_rows"), [arc as u32]);
    let record = path.f32("arcs");
    assert_eq!(record.len(), 13);
    let origin: Vec<f32> = path.header["origin"]
        .as_array()
        .unwrap()
        .iter()
        .map(|v| v.as_f64().unwrap() as f32)
        .collect();
    assert_eq!([record[0] + origin[0], record[1] + origin[1]], [0.0, 0.0]);
    assert_eq!(record[9..11], [10.0, 10.0]);
    assert!((record[11] - FRAC_PI_2).abs() < 1e-6);
    assert_eq!(record[12], 0.0);
    // From X10 Y0 to X0 Y10 at 100 mm/min.
    let points = &path.f32("points")[6 * arc..6 * arc + 6];
    let at = |index: usize| points[index] + origin[index % 3];
    assert_eq!([at(0), at(1), at(3), at(4)], [10.0, 0.0, 0.0, 10.0]);
    assert!((path.f32("feed")[arc] - 100.0).abs() < 1e-3);
    let report = live.json("report");
    assert_eq!((&report["errors"], &report["rows"]), (&0.into(), &rows.into()));
    assert_eq!(report["end"][0]["end"], "program end");
}

#[test]
fn the_axes_that_are_known_come_with_each_end() {
    let text = "G21 G90 G18\nS1000 M3\nG0 X10.\nZ5.\nG1 X20. F100.\nG91 G28 Z0\nG90 X30.\nM30\n";
    let mut live = serve(Shown::text(text)).live();
    let path = live.columns("path");
    let ends = path.u8("known").into_iter().map(|known| (known & 7, known >> 3));
    let known: Vec<(u32, (u8, u8))> = path.u32("line").into_iter().zip(ends).collect();
    // X only, X and Z, and X only again after the reference point; Y is never known.
    let of =
        |line: u32| known.iter().filter(|(own, _)| *own == line).map(|(_, ends)| *ends).next_back();
    assert_eq!(
        [3, 4, 5, 6, 7].map(of),
        [Some((0, 1)), Some((1, 5)), Some((5, 5)), Some((5, 1)), Some((1, 1))]
    );
    let drawn = path.u8("kind").into_iter().map(|kind| kind & 0x10 != 0);
    let drawn: Vec<u32> = path
        .u32("line")
        .into_iter()
        .zip(drawn)
        .filter(|(_, drawn)| *drawn)
        .map(|(line, _)| line)
        .collect();
    assert_eq!(drawn, [5]);
    assert_eq!(live.json("report")["never_named"], serde_json::json!(["Y"]));
}

#[test]
fn moves_in_a_work_offset_without_a_zero_have_no_place() {
    let text = "G21 G90\nS1000 M3\nG54 G0 X0 Y0 Z5.\nG1 X20. F100.\nG55 G0 X0 Y0 Z5.\nG1 X30. F100.\nM30\n";
    let mut live = serve(Shown::text(text)).live();
    let path = live.columns("path");
    let rows = path.u32("line").into_iter().zip(path.u8("kind")).zip(path.u8("known"));
    let found: Vec<(u32, bool, u8)> =
        rows.map(|((line, kind), known)| (line, kind & 0x10 != 0, known >> 3)).collect();
    assert_eq!(found, [(3, false, 7), (4, true, 7), (5, false, 0), (6, false, 0)]);
    let report = live.json("report");
    let texts = report["moves_left_out"].as_array().expect("texts");
    assert_eq!(texts[0], "moves in G55 are left out: where it lies from G54 is not given");
    assert_eq!(texts.len(), 2, "and what to do");
    let zeros: Vec<&str> = report["places"]["zeros"]
        .as_array()
        .expect("zeros")
        .iter()
        .map(|zero| zero["name"].as_str().expect("a name"))
        .collect();
    assert_eq!(zeros, ["G54"]);
}

#[test]
fn a_long_text_comes_in_pieces_that_cut_no_character() {
    let line = "G1 X1.5 (ß→)\n";
    let long = line.repeat(200_000);
    let mut live = serve(Shown::text(&long)).live();
    let mut text = Vec::new();
    let mut pieces = 0;
    loop {
        let piece = live.columns("text");
        assert_eq!(piece.header["first"], pieces == 0);
        assert!(std::str::from_utf8(&piece.u8("text")).is_ok());
        text.extend_from_slice(&piece.u8("text"));
        pieces += 1;
        if piece.header["last"] == true {
            break;
        }
    }
    assert!(pieces > 2, "{pieces}");
    assert!(text == long.as_bytes());
}

#[test]
fn the_text_is_the_files_and_edits_are_run() {
    let mut live = serve(Shown::text("G21\r\nG1 X10. F100.\r\nG7 X20.\r\n")).live();
    // The text and the run are sent by two threads, in any order.
    let (mut text, mut report) = (None, None);
    while text.is_none() || report.is_none() {
        match live.next() {
            PageMessage::Columns(columns) if columns.header["type"] == "text" => {
                text = Some(columns)
            }
            PageMessage::Json(received) if received["type"] == "report" => report = Some(received),
            PageMessage::Closed => panic!("closed before text and report"),
            _ => {}
        }
    }
    let (text, report) = (text.unwrap(), report.unwrap());
    assert_eq!(text.u8("text"), b"G21\nG1 X10. F100.\nG7 X20.\n");
    assert!(report["errors"].as_u64().unwrap() >= 1, "{report}");
    let mut problems = report["diagnostics"].as_array().unwrap().iter();
    let problem = problems.find(|problem| problem["severity"] == "error").unwrap();
    assert_eq!((&problem["place"]["line"], &problem["place"]["column"]), (&3.into(), &0.into()));
    // `G7` becomes `G1`; the text before it is 17 characters.
    live.send(r#"{"request":"edit","changes":[{"from":18,"to":20,"insert":"G1"}]}"#);
    assert_eq!(live.json("run")["run"], 2);
    let lines = live.columns("path").u32("line");
    assert_eq!(lines, [2, 3]);
    let report = live.json("report");
    assert_eq!((&report["run"], &report["errors"]), (&2.into(), &0.into()), "{report}");
}

#[test]
fn the_motion_comes_after_the_path_in_true_time() {
    let mut live = serve(Shown::text(QUARTER)).live();
    let points = live.columns("setpoints");
    let (rows, places) = (points.u32("row"), points.f32("places"));
    assert_eq!(places.len(), 3 * rows.len());
    assert!(rows.is_sorted());
    let period = points.header["period_s"].as_f64().unwrap();
    let total = points.header["total_s"].as_f64().unwrap();
    assert!((rows.len() as f64 * period - total).abs() < 2.0 * period);
    // The cuts (5 + 5π + 10 mm at 100 mm/min) take 18.4 s.
    let cuts = (15.0 + 5.0 * std::f64::consts::PI) / 100.0 * 60.0;
    assert!(total > cuts, "{total} {cuts}");
    // It ends at X0 Y20 Z0, in program coordinates.
    let last = &places[places.len() - 3..];
    assert!(
        last.iter().zip([0.0, 20.0, 0.0]).all(|(at, want)| (at - want).abs() < 1e-4),
        "{last:?}"
    );
    let arc = arc_row(QUARTER);
    // Every setpoint of the arc is on the circle within 0.1 mm, which corner rounding at its ends may take.
    let path_rows = rows.iter().zip(places.chunks(3));
    let on_arc: Vec<&[f32]> = path_rows.filter(|(row, _)| **row == arc).map(|(_, at)| at).collect();
    assert!(on_arc.len() > 100);
    assert!(on_arc.iter().all(|at| (at[0].hypot(at[1]) - 10.0).abs() < 0.1));
    let times = live.json("times");
    let by_tool: f64 = times["tools"]
        .as_array()
        .unwrap()
        .iter()
        .map(|tool| tool["times"]["total_s"].as_f64().unwrap())
        .sum();
    assert!((by_tool - times["all"]["total_s"].as_f64().unwrap()).abs() < 1e-9);
    assert!((times["all"]["total_s"].as_f64().unwrap() - total).abs() < 1e-3);
}

/// The number of the path row of line 6.
fn arc_row(program: &str) -> u32 {
    let mut live = serve(Shown::text(program)).live();
    let lines = live.columns("path").u32("line");
    lines.iter().position(|line| *line == 6).unwrap() as u32
}

#[test]
fn the_active_state_is_reported_for_a_line_that_moves_nothing_too() {
    let mut live = serve(Shown::text(QUARTER)).live();
    let rows = live.columns("path").u32("line");
    live.json("report");
    live.send(r#"{"id":1,"request":"state","done":0,"line":3}"#);
    let state = &live.json("state")["state"];
    assert_eq!(
        (&state["tool"], &state["spindle"], &state["rpm"]),
        (&1.into(), &"clockwise".into(), &1000.0.into())
    );
    assert_eq!(state["feed"], serde_json::Value::Null);
    let done = rows.iter().filter(|line| **line <= 5).count();
    live.send(&format!(r#"{{"id":2,"request":"state","done":{done},"line":5}}"#));
    let state = &live.json("state")["state"];
    assert!((state["feed"].as_f64().unwrap() - 100.0).abs() < 1e-9);
    assert_eq!(state["plane"], "XY");
    live.send(r#"{"id":3,"request":"state","done":0,"line":1}"#);
    assert_eq!(live.json("state")["state"]["tool"], 0);
}

#[test]
fn another_machine_runs_the_same_text() {
    let mut live = serve(Shown::text(QUARTER)).live();
    live.json("report");
    live.send(r#"{"request":"machine","name":"linuxcnc-mill"}"#);
    assert_eq!(live.json("run")["machine"]["name"], "linuxcnc-mill");
    assert_eq!(live.json("report")["run"], 2);
    live.send(r#"{"request":"machine","name":"no-such-machine"}"#);
    let refused = live.json("refused");
    assert!(refused["message"].as_str().unwrap().contains("no-such-machine"), "{refused}");
}

#[test]
fn chords_are_as_the_library_cuts_them() {
    let mut live = serve(Shown::text(QUARTER)).live();
    live.json("report");
    for tolerance in [1.0, 0.01] {
        live.send(&format!(r#"{{"request":"chords","tolerance_mm":{tolerance}}}"#));
        let chords = live.columns("chords");
        // A chord over the angle a deviates by R (1 − cos a/2).
        let step = 2.0 * (1.0 - tolerance / 10.0_f64).acos();
        let want = (std::f64::consts::FRAC_PI_2 / step).ceil();
        assert_eq!(chords.header["chords"].as_f64().unwrap(), want);
        assert_eq!(chords.f32("points").len() as f64, 6.0 * want);
    }
}

#[test]
fn an_endless_program_ends_with_its_message() {
    let mut live = serve(Shown::text("O1\nN1 G1 X1. F100.\nX0\nM99 P1\n")).live();
    let report = live.json("report");
    let ends = ["repeats", "endless"].map(serde_json::Value::from);
    assert!(ends.contains(&report["end"][0]["end"]), "{}", report["end"]);
    assert!(!report["diagnostics"].as_array().unwrap().is_empty());
}

#[test]
fn an_empty_and_a_binary_file_say_so() {
    let mut live = serve(Shown::text("")).live();
    assert!(!live.json("report")["diagnostics"].as_array().unwrap().is_empty());
    let shown = Shown::text("");
    *shown.text.lock().unwrap() = (0..4000u32).map(|at| (at * 7 % 32) as u8).collect();
    let mut live = serve(shown).live();
    assert_eq!(live.columns("text").header["binary"], true);
    live.send(r#"{"id":1,"request":"save"}"#);
    live.json("error");
}

#[test]
fn typing_faster_than_it_runs_ends_with_the_last_text() {
    let mut live = serve(Shown::text("G21\nG1 X1. F100.\n")).live();
    live.json("report");
    for _ in 0..200 {
        live.send(r#"{"request":"edit","changes":[{"from":7,"to":7,"insert":"1"},{"from":8,"to":8,"insert":""}]}"#);
        live.send(r#"{"request":"edit","changes":[{"from":7,"to":8,"insert":""}]}"#);
    }
    loop {
        let report = live.json("report");
        if report["run"] == 401 {
            assert_eq!(report["errors"], 0);
            break;
        }
    }
}

#[test]
fn a_file_is_watched_and_written_whole() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("part.nc");
    fs::write(&path, "G21\r\nG1 X1. F100.\r\n").unwrap();
    let mut live = serve(Shown::file(path.clone())).live();
    live.json("report");
    live.send(r#"{"request":"edit","changes":[{"from":9,"to":9,"insert":"0"}]}"#);
    live.send(r#"{"id":5,"request":"save"}"#);
    assert_eq!(live.json("saved")["id"], 5);
    assert_eq!(fs::read(&path).unwrap(), b"G21\r\nG1 X10. F100.\r\n");
    // Another program writes the file: that is reported, and the file is not overwritten without a request.
    fs::write(&path, "G21\nG1 X77. F100.\n").unwrap();
    live.json("changed");
    live.send(r#"{"id":6,"request":"save"}"#);
    assert_eq!(live.json("conflict")["id"], 6);
    assert_eq!(fs::read(&path).unwrap(), b"G21\nG1 X77. F100.\n");
    live.send(r#"{"id":7,"request":"reload"}"#);
    assert_eq!(live.columns("text").u8("text"), b"G21\nG1 X77. F100.\n");
    live.send(r#"{"request":"edit","changes":[{"from":0,"to":3,"insert":"G20"}]}"#);
    live.send(r#"{"id":8,"request":"save","force":true}"#);
    assert_eq!(live.json("saved")["id"], 8);
    assert_eq!(fs::read(&path).unwrap(), b"G20\nG1 X77. F100.\n");
    let files: Vec<_> = fs::read_dir(folder.path()).unwrap().collect();
    assert_eq!(files.len(), 1);
    fs::remove_file(&path).unwrap();
    live.json("gone");
}

#[test]
fn words_have_classes_and_meanings_at_their_place() {
    let mut live = serve(Shown::text("(ä😀 part)\nG21 G1 X10. F100.\nT1 M6\nM30\n")).live();
    live.json("report");
    live.send(r#"{"id":1,"request":"tokens","from":1,"to":3}"#);
    let received = live.json("tokens");
    let numbers: Vec<usize> = received["tokens"]
        .as_array()
        .unwrap()
        .iter()
        .map(|number| number.as_u64().unwrap() as usize)
        .collect();
    let words: Vec<(usize, usize, usize, &str)> = numbers
        .chunks(4)
        .map(|four| (four[0], four[1], four[2], received["classes"][four[3]].as_str().unwrap()))
        .collect();
    // The emoji is two UTF-16 code units.
    assert_eq!(words[0], (1, 0, 10, "comment"));
    assert_eq!(words[1], (2, 0, 3, "gcode"));
    assert!(words.contains(&(2, 7, 11, "axis")), "{words:?}");
    assert!(words.iter().all(|(line, ..)| *line < 3));
    live.send(r#"{"id":2,"request":"hover","line":2,"column":1}"#);
    let hover = &live.json("hover")["hover"];
    assert_eq!(
        (&hover["line"], &hover["column"], &hover["end_column"]),
        (&2.into(), &0.into(), &3.into())
    );
    assert!(hover["text"].as_str().unwrap().to_lowercase().contains("millimet"), "{hover}");
    live.send(r#"{"id":3,"request":"hover","line":9999,"column":4}"#);
    assert_eq!(live.json("hover")["hover"], serde_json::Value::Null);
    live.send(r#"{"id":4,"request":"outline"}"#);
    let outline = live.json("outline")["entries"].to_string();
    assert!(outline.contains("T1"), "{outline}");
    live.send(r#"{"id":5,"request":"state","done":1,"line":2}"#);
    let codes = live.json("state")["state"]["codes"].to_string();
    assert!(codes.contains("G21") && codes.contains("G1"), "{codes}");
}

#[test]
fn a_call_leads_to_its_program() {
    let text = "O1\nM97 P100\nM30\nN100 G0 X1.\nM99\n";
    let mut live = serve(Shown::text(text)).live();
    live.json("report");
    live.send(r#"{"id":1,"request":"definition","line":2,"column":5}"#);
    let place = &live.json("definition")["place"];
    assert_eq!(place, &serde_json::json!({ "line": 4, "column": 0 }));
    live.send(r#"{"id":2,"request":"definition","line":3,"column":0}"#);
    assert_eq!(live.json("definition")["place"], serde_json::Value::Null);
}

#[test]
fn a_program_in_another_file_comes_with_its_text() {
    let mut live = serve(Shown::text("O1\nM98 P77\nM30\n")).live();
    live.json("report");
    live.send(r#"{"id":1,"request":"definition","line":2,"column":5}"#);
    let place = &live.json("definition")["place"];
    assert_eq!((&place["file"], &place["line"]), (&"O77.nc".into(), &2.into()));
    assert_eq!(place["text"], "(BESIDE)\nO77\nM99\n");
}
