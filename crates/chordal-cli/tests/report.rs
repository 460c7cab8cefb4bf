//! `chordal report`: what stands on the page, and how it gets to its place.

#![allow(clippy::disallowed_methods, clippy::disallowed_types, reason = "the test starts a shell")]

mod common;

use common::{BROKEN, Folder};
use serde_json::{Value, json};

/// Two tools, an arc, a drilled hole, a stop and an optional block, in millimetres.
const PART: &str = "\
O100 (BRACKET <script>alert</script> & CO)
(STOCK 80 X 40)
(T2 D=5. DRILL)
G21 G17 G40 G49 G80 G90 G94
T1 M6 (END MILL 12)
G54
S2000 M3
G0 X0 Y0
G43 H1 Z10. M8
G1 Z-5. F100.
X50. F300.
G2 X60. Y-10. I0 J-10.
G0 Z10. M9
M0 (TURN THE PART)
T2 M6
S1500 M3
G55
G43 H2 Z10.
G0 X20. Y5.
G81 Z-8. R2. F90.
G80
G0 Z10.
/M1
M30
";

const VF2: [&str; 2] = ["--machine", "haas-vf2"];

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("part.nc", PART);
    folder
}

fn report(folder: &Folder, more: &[&str]) -> Value {
    let arguments = [&["report", "part.nc", "--format", "json"], &VF2[..], more].concat();
    serde_json::from_str(&folder.run(&arguments).ends(0).out).unwrap()
}

fn page(folder: &Folder, program: &str, more: &[&str]) -> String {
    folder.write("page.nc", program);
    let arguments = [&["report", "page.nc"], &VF2[..], more].concat();
    let done = folder.run(&arguments);
    assert!(done.code <= 1, "{}", done.err);
    done.out
}

#[track_caller]
fn near(value: &Value, expected: f64) {
    let value = value.as_f64().unwrap_or(f64::NAN);
    assert!((value - expected).abs() < 1e-9, "{value} is not {expected}");
}

/// A range of an axis, both ends in one.
fn range(value: &Value) -> (f64, f64) {
    (value[0].as_f64().unwrap(), value[1].as_f64().unwrap())
}

#[test]
fn tools_are_told_with_what_they_do() {
    let told = report(&folder(), &[]);
    let tools = told["tools"]["rows"].as_array().unwrap();
    assert_eq!(tools.len(), 2);
    let [mill, drill] = [&tools[0], &tools[1]];
    assert_eq!((&mill["number"], &drill["number"]), (&json!(1), &json!(2)));
    assert_eq!(mill["comment"], "END MILL 12", "the comment of the block");
    assert_eq!(drill["comment"], "T2 D=5. DRILL", "the comment at the head");
    assert_eq!((&mill["length_offsets"], &drill["length_offsets"]), (&json!([1]), &json!([2])));
    // 15 mm down, 50 mm along X, a quarter of a circle of 10 mm; the drill from R2 to Z-8.
    near(&mill["cut_mm"], 15.0 + 50.0 + 5.0 * std::f64::consts::PI);
    near(&drill["cut_mm"], 10.0);
    assert_eq!(range(&mill["feeds"]["mm_per_min"]), (100.0, 300.0));
    assert_eq!(range(&drill["feeds"]["mm_per_min"]), (90.0, 90.0));
    assert_eq!(range(&mill["rpm"]), (2000.0, 2000.0));
    assert_eq!(mill["clockwise"], true);
    near(&mill["lowest_z_mm"], -5.0);
    near(&drill["lowest_z_mm"], -8.0);
    assert_eq!((&mill["coolant"], &drill["coolant"]), (&json!(["flood"]), &json!([])));
}

#[test]
fn comments_before_the_number_are_of_the_programs_head() {
    let folder = folder();
    folder.write(
        "named.nc",
        "%\n(BRACKET 4711)\n(T1 FACE MILL)\nO5 (SIDE 2)\nG21 G90 T1 M6\nG54 S900 M3\nG0 X0 Y0 Z5.\n\
         G1 Z-1. F90.\nX9.\nG0 Z5.\nM30\n%\n",
    );
    let arguments = [&["report", "named.nc", "--format", "json"], &VF2[..]].concat();
    let told: Value = serde_json::from_str(&folder.run(&arguments).out).unwrap();
    assert_eq!(told["head"]["comments"], json!(["BRACKET 4711", "T1 FACE MILL"]));
    assert_eq!(told["tools"]["rows"][0]["comment"], "T1 FACE MILL");
}

#[test]
fn travel_is_told_for_each_work_offset() {
    let told = report(&folder(), &[]);
    let travel = told["travel"]["rows"].as_array().unwrap();
    let names: Vec<&Value> = travel.iter().map(|row| &row["name"]).collect();
    assert_eq!(names, ["G54", "G55"]);
    let axes: Vec<_> = travel
        .iter()
        .flat_map(|row| row["axes"].as_array().unwrap())
        .map(|axis| (axis["axis"].as_str().unwrap(), range(&axis["all"]), range(&axis["cuts"])))
        .collect();
    assert_eq!(
        axes,
        [
            ("X", (0.0, 60.0), (0.0, 60.0)),
            ("Y", (-10.0, 0.0), (-10.0, 0.0)),
            ("Z", (-5.0, 10.0), (-5.0, 10.0)),
            ("X", (20.0, 20.0), (20.0, 20.0)),
            ("Y", (5.0, 5.0), (5.0, 5.0)),
            ("Z", (-8.0, 10.0), (-8.0, 2.0)),
        ]
    );
    // The machine goes from X-762 to X0 and from Y-406 to Y0.
    let zero = |axis: usize| range(&travel[0]["axes"][axis]["zero_may_lie"]);
    assert_eq!((zero(0), zero(1)), ((-762.0, -60.0), (-396.0, 0.0)));
}

#[test]
fn offsets_are_blanks_until_the_machine_has_them() {
    let folder = folder();
    let told = report(&folder, &[]);
    assert_eq!(told["work_offsets"][0]["name"], "G54");
    assert_eq!(told["work_offsets"][0]["values"][0], json!({"axis": "X", "value": null}));
    let html = page(&folder, PART, &[]);
    // X, Y and Z of G54 and G55, and two lengths.
    assert_eq!(html.matches("<span class=\"blank\">").count(), 8);

    let set = [
        "--set",
        "work_offsets.G54.X=\"-400 mm\"",
        "--set",
        "work_offsets.G54.Y=\"-200 mm\"",
        "--set",
        "tools.1.length=\"120.5 mm\"",
    ];
    let told = report(&folder, &set);
    near(&told["work_offsets"][0]["values"][0]["value"], -400.0);
    assert_eq!(told["registers"]["rows"][0]["number"], 1);
    near(&told["registers"]["rows"][0]["length_mm"], 120.5);
    assert_eq!(told["registers"]["rows"][1]["length_mm"], Value::Null);
    let html = page(&folder, PART, &set);
    assert_eq!(html.matches("<span class=\"blank\">").count(), 5);
    assert!(html.contains("120.500") && html.contains("-400.000"));
}

#[test]
fn the_time_is_the_planners() {
    let folder = folder();
    let told = report(&folder, &[]);
    let arguments = ["time", "part.nc", "--machine", "haas-vf2", "--format", "json"];
    let time: Value = serde_json::from_str(&folder.run(&arguments).ends(0).out).unwrap();
    for part in ["total_s", "cutting_s", "rapid_s", "other_s"] {
        assert_eq!(told["time"][part], time[part], "{part}");
    }
    // Two tool changes of 4.5 s each.
    let waits = told["time"]["waits"].as_array().unwrap();
    let change = waits.iter().find(|wait| wait["what"] == "tool change").unwrap();
    near(&change["time_s"], 9.0);
    let by_tool: f64 = told["tools"]["rows"]
        .as_array()
        .unwrap()
        .iter()
        .map(|t| t["time_s"].as_f64().unwrap())
        .sum();
    let total = told["time"]["total_s"].as_f64().unwrap();
    assert!((by_tool - total).abs() < 1e-6, "{by_tool} of {total}: nothing moves without a tool");
}

#[test]
fn the_operator_is_told_where_he_is_wanted() {
    let told = report(&folder(), &[]);
    let stops = told["stops"]["rows"].as_array().unwrap();
    let kinds: Vec<_> = stops
        .iter()
        .map(|stop| (stop["kind"].as_str().unwrap(), stop["line"].as_u64().unwrap(), &stop["text"]))
        .collect();
    let turn = json!("TURN THE PART");
    assert_eq!(kinds, [("stop", 14, &turn), ("optional_stop", 23, &Value::Null)]);
    assert_eq!(told["skipped"]["lines"]["rows"], json!([23]));
    let without = report(&folder(), &["--block-delete"]);
    assert_eq!(without["skipped"]["left_out"], true);
    assert_eq!(without["stops"]["rows"].as_array().unwrap().len(), 1);
}

#[test]
fn words_of_the_program_are_no_markup() {
    let hostile = "\
O7 (\"><img src=x onerror=alert(1)>)
(</style><script>alert(2)</script>)
G21 G90 S900 M3
T1 M6 (<b>MILL</b>)
G0 X0 Y0 Z5.
G1 X<script> F100.
M0 ('\"><svg onload=alert(3)>)
M30
";
    let html = page(&Folder::new(), hostile, &["--date", "<i>today</i>"]);
    for tag in ["<script", "<img", "<b>", "<i>", "<svg onload"] {
        assert!(!html.contains(tag), "{tag} came through");
    }
    assert_eq!(html.matches("</style>").count(), 1);
    assert!(html.contains("&lt;b&gt;MILL&lt;/b&gt;") && html.contains("&lt;i&gt;today&lt;/i&gt;"));
}

/// Those of both work offsets of the part.
fn offsets() -> Vec<&'static str> {
    const OFFSETS: [&str; 6] = [
        "work_offsets.G54.X=-300 mm",
        "work_offsets.G54.Y=-200 mm",
        "work_offsets.G54.Z=-400 mm",
        "work_offsets.G55.X=-200 mm",
        "work_offsets.G55.Y=-200 mm",
        "work_offsets.G55.Z=-400 mm",
    ];
    OFFSETS.iter().flat_map(|offset| ["--set", offset]).collect()
}

#[test]
fn the_picture_says_which_work_offset_it_leaves_out() {
    let said = "Moves in G55 are left out: where it lies from G54 is not given.";
    let html = page(&folder(), PART, &[]);
    assert_eq!(html.matches(said).count(), 1);
    // Both views, and the one tool that is drawn twice: in the legend and in the list.
    assert_eq!(html.matches("<svg viewBox").count(), 2 + 1 + 1);
    assert!(!page(&folder(), PART, &offsets()).contains(said));
}

#[test]
fn the_page_needs_nothing_else() {
    let html = page(&folder(), PART, &offsets());
    for word in ["http:", "https:", "//", "src=", "url(http", "@import", "<script", "<link"] {
        let found = html.find(word).map(|at| &html[at..(at + 60).min(html.len())]);
        assert_eq!(found, None, "{word}");
    }
    assert!(
        html.match_indices("href=\"").all(|(at, found)| html[at + found.len()..].starts_with('#'))
    );
    assert_eq!(html.matches("<svg viewBox").count(), 2 + 2 + 2, "views, legend, tools");
}

#[test]
fn the_same_program_gives_the_same_bytes() {
    let folder = folder();
    for name in ["a.html", "b.html"] {
        folder.run(&["report", "part.nc", "-m", "haas-vf2", "-o", name]).ends(0);
    }
    assert!(folder.read("a.html") == folder.read("b.html"));
    assert!(!folder.read("a.html").contains("<dt>Date</dt>"));
    let dated = page(&folder, PART, &["--date", "21 November 2026"]);
    assert!(dated.contains("<dt>Date</dt><dd>21 November 2026</dd>"));
}

#[test]
fn a_program_with_errors_gets_its_report() {
    let folder = Folder::new();
    folder.write("jobs/broken.nc", BROKEN);
    let done = folder.run(&["report", "jobs/broken.nc", "-m", "haas-vf2", "-o", "setup.html"]);
    done.ends(1).complains(&["CH401"]);
    let html = folder.read("setup.html");
    let banner = html.find("Do not run: 1 error.").unwrap();
    assert!(banner < html.find("<h2 id=\"path\">").unwrap(), "at the top");
    assert!(html.contains("6 | G2 X1. Y1. I.4 J0\n"), "the line with its words underlined");
    assert!(html.contains("^^^^") && html.contains("What to do: "));
    assert!(!html.contains("jobs"), "a sheet does not tell in which folder the program lay");
    let [error, warning] = [html.find("problem error"), html.find("problem warning")];
    assert!(warning.is_none_or(|warning| error.unwrap() < warning), "errors first");
}

#[test]
fn every_program_gets_a_page() {
    for (program, words) in [
        ("", "The file is empty."),
        ("%\n%\n", "No tool is called, and nothing is cut."),
        ("O1\nM30\n", "No tool is called, and nothing is cut."),
        ("O1\nG21 G0 X1.\n", "The text ends without an end code"),
        ("O1\nG21 G0 X1.\nM99\n", "the control starts again from the top"),
        ("G21 G90 G0 X0\nWHILE[1EQ1]DO1\nX1.\nX0\nEND1\nM30\n", "It does not end"),
        ("G0 X1. (\u{7}\u{202e})\nM30\n", "setup sheet"),
    ] {
        let html = page(&Folder::new(), program, &["--max-blocks", "500"]);
        assert!(html.contains(words), "{program:?} lacks {words}");
        assert!(html.ends_with("</html>"), "{program:?}");
        assert!(!html.contains(['\u{7}', '\u{202e}']));
    }
}

/// Twenty thousand moves, four hundred tools, five thousand stops: what a table leaves out is
/// counted.
#[test]
fn a_long_program_gets_a_page_of_bounded_size() {
    let mut program = String::from("O1\nG21 G90 G54 F500.\n");
    for tool in 1..=400 {
        program.push_str(&format!("T{tool} M6\nS900 M3\n/M1\n"));
        for step in 0..50 {
            let (x, y) = (step * 7919 % 1000, (step * tool) % 977);
            program.push_str(&format!("G1 X{x}.{tool} Y{y}.5 Z-{step}.25\nG4 P0\n"));
        }
        program.push_str(&"M0\n".repeat(12));
    }
    program.push_str("M30\n");
    let html = page(&Folder::new(), &program, &[]);
    assert!(html.len() < 3_000_000, "{} bytes", html.len());
    for words in ["and 300 more tools", "and 340 more operations", "more stops and messages"] {
        assert!(html.contains(words), "{words}");
    }
}

#[test]
fn the_output_is_put_in_place_whole_or_not_at_all() {
    let folder = folder();
    folder.write("taken/x", "");
    let complain = |arguments: &[&str], words: &[&str]| {
        folder.run(&[&["report"], arguments].concat()).ends(2).complains(words);
    };
    complain(&["part.nc", "-o", "setup.pdf"], &["setup.pdf", ".html", ".json"]);
    complain(&["part.nc", "-o", "part.nc", "--format", "html"], &["part.nc is the program"]);
    complain(&["gone.nc", "-o", "setup.html"], &["gone.nc"]);
    complain(&["part.nc", "-m", "haas-vf2", "-o", "taken", "--format", "html"], &["taken"]);
    assert_eq!(folder.names(), ["part.nc", "taken/x"]);
    assert_eq!(folder.read("part.nc"), PART);
}

/// The file may not grow beyond 8 kB.
#[cfg(unix)]
#[test]
fn a_full_disk_leaves_what_was_there() {
    let folder = folder();
    folder.write("setup.html", "of yesterday");
    let call = "trap '' XFSZ; ulimit -f 16; exec \"$0\" report part.nc -m haas-vf2 -o setup.html";
    let done = std::process::Command::new("sh")
        .current_dir(folder.path("."))
        .args(["-c", call])
        .arg(folder.command(&[]).get_program())
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&done.stderr);
    assert_eq!(done.status.code(), Some(2), "{said}");
    assert!(said.contains("cannot write setup.html"), "{said}");
    assert_eq!(folder.names(), ["part.nc", "setup.html"]);
    assert_eq!(folder.read("setup.html"), "of yesterday");
}

#[test]
fn a_lathe_has_its_own_offsets_and_no_y() {
    let folder = Folder::new();
    folder.write(
        "lathe.nc",
        "G21 G40 G97 G99\nT0101\nS800 M3\nG0 X62. Z2.\nG1 G42 X40. F.3\nZ-20. F.15\nG0 G40 X70.\nT0303\nG0 X62. Z5.\n\
         G1 Z-10. F.1\nG0 X100. Z100.\nM30\n",
    );
    let set = [
        "--machine",
        "fanuc-lathe",
        "--set",
        "tools.1.offset.X=-120 mm",
        "--set",
        "tools.1.offset.Z=-60 mm",
        "--set",
        "tools.1.nose_radius=0.8 mm",
        "--set",
        "tools.1.tip=3",
    ];
    let run = |more: &[&str]| {
        let done = folder.run(&[&["report", "lathe.nc"], &set[..], more].concat());
        assert!(done.code <= 1, "{}", done.err);
        done.out
    };
    let told: Value = serde_json::from_str(&run(&["--format", "json"])).unwrap();
    assert_eq!(told["head"]["is_lathe"], true);
    let register = &told["registers"]["rows"][0];
    near(&register["x_mm"], -120.0);
    near(&register["length_mm"], -60.0);
    near(&register["nose_radius_mm"], 0.8);
    assert_eq!((&register["tip"], &register["diameter_mm"]), (&json!(3), &Value::Null));
    // Nothing is set for the other one.
    let other = &told["registers"]["rows"][1];
    assert_eq!((&other["x_mm"], &other["nose_radius_mm"]), (&Value::Null, &Value::Null));
    assert_eq!(told["tools"]["rows"][0]["feeds"]["mm_per_rev"], json!([0.15, 0.3]));
    let axes = told["travel"]["rows"][0]["axes"].as_array().unwrap();
    let letters: Vec<&str> = axes.iter().map(|axis| axis["axis"].as_str().unwrap()).collect();
    assert_eq!(letters, ["X", "Z"]);
    let page = run(&[]);
    for head in ["X mm", "Z mm", "Nose radius mm", "Tip", "Feed mm per rev"] {
        assert!(page.contains(&format!(">{head}</th>")), "{head}");
    }
    assert!(!page.contains(">H length") && !page.contains(">D diameter"));
    assert!(page.contains("0.15–0.3"));
}
