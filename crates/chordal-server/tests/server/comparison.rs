//! The other program: its path, the differences, and the page's requests about it.

use std::fs;

use serde_json::{Value, json};

use crate::common::{Live, PageMessage, Shown, serve};

const A: &str =
    "G21 G90\nT1 M6\nS1000 M3\nG0 X10. Y0 Z5.\nG1 Z0 F100.\nG3 X0 Y10. I-10. J0\nG1 Y20.\nM30\n";

/// The same program written differently, with the last cut 0.25 mm longer.
const B: &str = "(B)\nG21 G90\nM6 T1\nM3 S1000\nG0 Z5.\nX10. Y0\nN5 G1 Z0 F100.\nG3 X0 Y10. R10.\n\
                 N6 G1 Y15.\nN7 Y20.25\nM30\n";

fn sides(difference: &Value) -> [&Value; 2] {
    [&difference["sides"][0], &difference["sides"][1]]
}

/// Waits for the next comparison of a run.
fn comparison(live: &mut Live, run: u64) -> Value {
    loop {
        let found = live.json("comparison");
        if found["run"] == run {
            return found;
        }
    }
}

#[test]
fn the_other_path_comes_as_columns_and_what_differs_with_the_lines_of_both() {
    let mut live = serve(Shown::text(A).compared(Shown::text(B), false)).live();
    let hello = live.json("hello");
    assert_eq!(hello["compared"], json!({ "name": "part.nc", "own_text": false }));
    assert_eq!(hello["tolerance_mm"], 0.0);
    let compared = live.json("compared_program");
    assert_eq!((&compared["other"], &compared["own_text"]), (&"named".into(), &false.into()));
    assert_eq!(compared["machine"]["name"], "haas-vf2");
    let path = live.columns("compared_path");
    assert_eq!((&path.header["first"], &path.header["progress"]), (&0.into(), &1.0.into()));
    let lines = path.u32("line");
    assert_eq!(lines.iter().filter(|line| **line == 8).count(), 1, "{lines:?}");
    let rows = lines.len();
    // The arc of line 8, whose centre is (0, 0).
    assert_eq!(lines[path.u32("arc_rows")[0] as usize], 8);
    assert_eq!(live.json("compared_path_end")["rows"], rows);
    let found = comparison(&mut live, 1);
    assert_eq!(found["version"], compared["version"]);
    assert_eq!(found["verdict"], "different");
    let most = found["max_distance_mm"].as_f64().unwrap();
    assert!((most - 0.25).abs() < 1e-9, "{found}");
    assert_eq!(found["headline"], "different: 1 difference; the paths are at most 0.25 mm apart");
    let [difference] = found["differences"].as_array().unwrap().as_slice() else {
        panic!("{found}");
    };
    assert_eq!(difference["category"], "path");
    let [a, b] = sides(difference);
    assert_eq!(a["blocks"], json!({ "file": 0, "from": 7, "to": 7 }));
    assert_eq!(b["blocks"]["to"], 10);
    assert_eq!(a["words"], "G1 Y20.");
    // The points that are furthest apart: the two ends.
    assert_eq!(difference["at_mm"], json!([[0.0, 20.0, 0.0], [0.0, 20.25, 0.0]]));
    assert_eq!(
        found["farthest"]["places"],
        json!([{ "file": 0, "line": 7 }, { "file": 0, "line": 10 }])
    );
}

#[test]
fn an_edit_is_compared_anew_and_the_other_path_stays() {
    let mut live = serve(Shown::text(A).compared(Shown::text(B), false)).live();
    comparison(&mut live, 1);
    let at = A.find("Y20.").unwrap() + 4;
    live.send(&format!(
        r#"{{"request":"edit","changes":[{{"from":{at},"to":{at},"insert":"25"}}]}}"#
    ));
    loop {
        match live.next() {
            PageMessage::Json(received) if received["type"] == "comparison" => {
                assert_eq!(
                    (&received["run"], &received["verdict"]),
                    (&2.into(), &"same".into()),
                    "{received}"
                );
                break;
            }
            PageMessage::Json(received) => assert_ne!(received["type"], "compared_program"),
            PageMessage::Columns(columns) => assert_ne!(columns.header["type"], "compared_path"),
            PageMessage::Closed => panic!("closed"),
        }
    }
}

#[test]
fn typing_faster_than_it_compares_ends_with_the_last_text() {
    let mut live = serve(Shown::text(A).compared(Shown::text(B), false)).live();
    let at = A.find("Y20.").unwrap() + 4;
    for _ in 0..100 {
        live.send(&format!(
            r#"{{"request":"edit","changes":[{{"from":{at},"to":{at},"insert":"25"}}]}}"#
        ));
        let end = at + 2;
        live.send(&format!(
            r#"{{"request":"edit","changes":[{{"from":{at},"to":{end},"insert":""}}]}}"#
        ));
    }
    assert_eq!(comparison(&mut live, 201)["verdict"], "different");
}

#[test]
fn the_tolerance_decides_what_is_different() {
    let mut live = serve(Shown::text(A).compared(Shown::text(B), false)).live();
    assert_eq!(comparison(&mut live, 1)["verdict"], "different");
    for (tolerance, verdict) in [("0.26", "within"), ("0.24", "different"), ("1", "within")] {
        live.send(&format!(r#"{{"request":"tolerance","tolerance_mm":{tolerance}}}"#));
        let found = live.json("comparison");
        assert_eq!((&found["run"], &found["verdict"]), (&1.into(), &verdict.into()), "{tolerance}");
    }
    live.send(r#"{"id":4,"request":"tolerance","tolerance_mm":-1}"#);
    assert_eq!(live.json("error")["id"], 4);
}

#[test]
fn the_same_text_runs_on_another_machine_and_follows_the_edits() {
    let mut live = serve(Shown::text(A)).live();
    assert_eq!(live.json("hello")["compared"], Value::Null);
    live.json("report");
    live.send(r#"{"request":"compare_with","other":{"machine":"linuxcnc-mill"}}"#);
    let compared = live.json("compared_program");
    assert_eq!(compared["other"], json!({ "machine": "linuxcnc-mill" }));
    assert_eq!(
        (&compared["own_text"], &compared["machine"]["name"]),
        (&true.into(), &"linuxcnc-mill".into())
    );
    let found = comparison(&mut live, 1);
    assert_eq!(
        [&found["sides"][0]["name"], &found["sides"][1]["name"]],
        ["haas-vf2", "linuxcnc-mill"]
    );
    let at = A.find("Y20.").unwrap() + 1;
    let end = at + 3;
    live.send(&format!(
        r#"{{"request":"edit","changes":[{{"from":{at},"to":{end},"insert":"33."}}]}}"#
    ));
    // Its path is that of the new text.
    let path = live.columns("compared_path");
    let points = path.f32("points");
    let origin = path.header["origin"][1].as_f64().unwrap();
    let highest = points.chunks(3).map(|at| f64::from(at[1]) + origin).fold(0.0, f64::max);
    assert!((highest - 33.0).abs() < 1e-4, "{highest}");
    comparison(&mut live, 2);
    live.send(r#"{"request":"compare_with","other":"nothing"}"#);
    assert_eq!(live.json("compared_program")["other"], "nothing");
    live.send(r#"{"id":3,"request":"other_text","line":1}"#);
    assert_eq!(live.json("error")["id"], 3);
}

#[test]
fn another_machine_is_held_against_the_one_before() {
    let mut live = serve(Shown::text(A)).live();
    live.json("report");
    live.send(r#"{"request":"machine","name":"linuxcnc-mill"}"#);
    assert_eq!(live.json("compared_program")["other"], json!({ "machine": null }));
    assert_eq!(comparison(&mut live, 2)["sides"][1]["name"], "haas-vf2");
    live.send(r#"{"request":"machine","name":null}"#);
    assert_eq!(live.json("compared_program")["other"], json!({ "machine": "linuxcnc-mill" }));
    // The program that the command line names stays.
    let mut live = serve(Shown::text(A).compared(Shown::text(B), false)).live();
    comparison(&mut live, 1);
    live.send(r#"{"request":"machine","name":"linuxcnc-mill"}"#);
    assert_eq!(comparison(&mut live, 2)["sides"][1]["moves"], 6);
}

#[test]
fn the_other_file_is_watched_and_told_when_it_cannot_be_read() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("b.nc");
    fs::write(&path, B).unwrap();
    let mut live = serve(Shown::text(A).compared(Shown::file(path.clone()), false)).live();
    let first = comparison(&mut live, 1);
    fs::write(&path, B.replace("Y20.25", "Y20.")).unwrap();
    let found = live.json("comparison");
    assert_eq!(found["verdict"], "same", "{found}");
    assert!(found["version"].as_u64() > first["version"].as_u64());
    fs::remove_file(&path).unwrap();
    let refused = live.json("compared_program_refused");
    assert!(!refused["message"].as_str().unwrap().is_empty());
    // The comparison comes back.
    fs::write(&path, B).unwrap();
    assert_eq!(live.json("comparison")["verdict"], "different");
    live.send(r#"{"request":"compare_with","other":{"machine":"no-such-machine"}}"#);
    let refused = live.json("compared_program_refused");
    assert!(refused["message"].as_str().unwrap().contains("no-such-machine"), "{refused}");
}

#[test]
fn lines_of_the_other_program_are_read_around_one() {
    let long = format!("{}{B}", "(HEAD)\n".repeat(30_000));
    let mut live = serve(Shown::text(A).compared(Shown::text(&long), false)).live();
    comparison(&mut live, 1);
    live.send(r#"{"id":9,"request":"other_text","file":0,"line":30009}"#);
    let received = live.json("other_text");
    let first = received["first_line"].as_u64().unwrap() as usize;
    let text = received["text"].as_str().unwrap();
    assert_eq!(text.lines().nth(30_009 - first), Some("N6 G1 Y15."));
    assert!(text.len() < 1 << 20);
    live.send(r#"{"id":10,"request":"other_text","file":1,"line":2}"#);
    let received = live.json("other_text");
    assert_eq!(
        (&received["file"], &received["text"]),
        (&"O77.nc".into(), &"(BESIDE)\nO77\nM99\n".into())
    );
    for nowhere in [
        r#"{"id":11,"request":"other_text","line":4000000000}"#,
        r#"{"id":11,"request":"other_text","file":9,"line":1}"#,
    ] {
        live.send(nowhere);
        assert_eq!(live.json("other_text")["text"], "");
    }
}

#[test]
fn programs_of_which_nothing_is_known_are_told_so() {
    let mut live = serve(Shown::text("").compared(Shown::text("G91 X1.\n"), false)).live();
    let found = comparison(&mut live, 1);
    assert_eq!(found["max_distance_mm"], Value::Null);
    assert!(found["headline"].is_string());
}
