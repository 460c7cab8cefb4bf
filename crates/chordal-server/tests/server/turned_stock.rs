//! The stock of a lathe on a page: its lines and arcs give the section of a direct run at every time.

use chordal::stock::{TurnedOptions, TurnedReport};
use chordal::{Job, Machine, Source, SourceMap};

use crate::common::{Columns, Shown, serve};

const SETUP: &str = r#"
machine = "fanuc-lathe"
turret = "front"
[stock]
shape = "cylinder"
diameter = "50 mm"
from = "-60 mm"
to = "1 mm"
material = "steel"
[fixtures.jaws]
shape = "tube"
diameter = "100 mm"
bore = "50 mm"
from = "-80 mm"
to = "-55 mm"
[target]
shape = "cylinder"
diameter = "40 mm"
from = "-60 mm"
to = "0 mm"
[tools.1]
shape = "insert"
insert = "C"
approach_angle = "95 deg"
flute_length = "12 mm"
nose_radius = "0.8 mm"
tip = 3
max_chip = "0.2 mm"
offset.X = "0 mm"
offset.Z = "0 mm"
[tools.5]
shape = "groove"
width = "3 mm"
flute_length = "30 mm"
tip = 3
offset.X = "0 mm"
offset.Z = "0 mm"
"#;

/// Two passes and an arc with the first tool, which ends with line 9. Then a groove, the cut-off in line 13, and a
/// rapid into the remaining stock in line 16.
const FIRST: &str = "G21 G18 G40 G97 G99 S800 M3\nG28 U0 W0\nT0101\nG0 X46. Z3.\nG1 Z-20. F0.15\nX52.\nG0 Z3.\nX36.\nG3 X46. Z-2. R6. F0.3\n";
const SECOND: &str =
    "G0 X60. Z10.\nT0505\nG0 X56. Z-25.\nG1 X-1. F0.08\nG0 X56.\nZ-40.\nX30.\nX80.\nM30\n";

fn whole() -> String {
    [FIRST, SECOND].concat()
}

fn direct(program: &str) -> TurnedReport {
    let none = |name: &str| Err(format!("no file {name}"));
    let machine = Machine::from_toml("setup.toml", SETUP, &none).unwrap();
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", program.as_bytes().to_vec()));
    let job = Job::new(sources, machine).unwrap();
    let none = |name: &str| Err(format!("no file {name}"));
    job.turned_stock(&TurnedOptions::default(), &none).unwrap()
}

/// The area enclosed by the lines and arcs of a section, of the part in the chuck or of what was cut off, mm².
fn area(page: &Columns, number: u32, loose: u8) -> f64 {
    let (lines, from, until) = (page.f32("lines"), page.u32("from"), page.u32("until"));
    let is_loose = page.u8("loose");
    let is_there =
        |at: &usize| from[*at] <= number && number < until[*at] && is_loose[*at] == loose;
    let own = |at: usize| {
        let n: Vec<f64> = lines[7 * at..7 * at + 7].iter().map(|each| f64::from(*each)).collect();
        let chord = 0.5 * (n[0] * n[3] - n[2] * n[1]);
        let angle = |z: f64, r: f64| (r - n[5]).atan2(z - n[4]);
        let sweep = n[6] * (n[6] * (angle(n[2], n[3]) - angle(n[0], n[1])));
        let sweep = (n[6] * sweep).rem_euclid(std::f64::consts::TAU) * n[6];
        let radius = (n[0] - n[4]).hypot(n[1] - n[5]);
        chord + 0.5 * radius * radius * (sweep - sweep.sin())
    };
    (0..from.len()).filter(is_there).map(own).sum()
}

#[test]
fn the_pieces_give_the_section_of_a_direct_run_at_every_moment() {
    let mut live = serve(Shown::text(&whole()).set_up(SETUP)).live();
    let lines = live.columns("path").u32("line");
    let page = live.columns("turned");
    let rows = page.u32("rows");
    assert!(rows.windows(2).all(|pair| pair[0] < pair[1]), "{rows:?}");
    assert_eq!(page.header["whole"], true);
    let near = |page: f64, direct: f64| assert!((page - direct).abs() < 1e-3, "{page} {direct}");
    near(area(&page, 0, 0), 25.0 * 61.0);
    // At the tool change the stock is that of a program that ends there.
    let second = lines.iter().position(|line| *line > 9).unwrap() as u32;
    let at_change = rows.iter().filter(|row| **row < second).count() as u32;
    near(area(&page, at_change, 0), direct(&[FIRST, "M30\n"].concat()).section.area());
    let end = direct(&whole());
    let last = rows.len() as u32;
    near(area(&page, last, 0), end.section.area());
    near(area(&page, last, 1), end.loose[0].section.area());
    near(area(&page, at_change, 1), 0.0);
    let made = |number: u32, line: u32| lines[rows[number as usize - 1] as usize] == line;
    assert!(made(1, 5) && made(last, 13));
    for name in ["before", "target"] {
        assert_eq!(page.header[name].as_array().unwrap().len(), 1, "{name}");
    }
    assert_eq!(page.header["fixtures"][0]["name"], "jaws");
    let tools = page.header["tools"].as_array().unwrap();
    assert_eq!(
        tools.iter().map(|tool| tool["number"].as_u64().unwrap()).collect::<Vec<_>>(),
        [1, 5]
    );
}

#[test]
fn what_is_touched_has_its_place_and_the_page_knows_a_lathe() {
    let mut live = serve(Shown::text(&whole()).set_up(SETUP)).live();
    let run = live.json("run");
    assert_eq!(run["machine"]["turret"], "front");
    assert_eq!(run["machine"]["factors"], serde_json::json!([2.0, 1.0, 1.0]));
    let report = live.json("turned_report");
    assert_eq!((&report["verdict"], &report["parts_off"]), (&"problems".into(), &1.into()));
    assert_eq!(report["left_mm3"]["least"], report["left_mm3"]["most"]);
    let problems = report["problems"].as_array().unwrap();
    let rapid = problems.iter().find(|problem| problem["code"] == "CH620").unwrap();
    assert_eq!(rapid["line"], 16);
    let place: Vec<f64> =
        rapid["at"].as_array().unwrap().iter().map(|each| each.as_f64().unwrap()).collect();
    // The blade is 3 mm wide and cuts down to X30.
    let near = |found: f64, expected: f64| (found - expected).abs() < 1e-6;
    assert!(near(place[0], -38.5) && near(place[1], 20.0), "{place:?}");
    let listed = report["diagnostics"].as_array().unwrap();
    assert!(listed.iter().any(|problem| problem["code"] == "CH620"));
    // 0.15 mm per revolution is within the limit, 0.3 is not.
    let cuts = live.columns("engagement");
    assert_eq!(cuts.header["turning"], true);
    assert!((cuts.f32("radial")[0] - 2.0).abs() < 1e-4);
    let problems = cuts.u8("problem");
    assert_eq!((problems[0], problems.contains(&1)), (0, true));
}

#[test]
fn without_stock_a_lathe_sends_nothing_about_it_and_a_wrong_setup_is_reported() {
    let bare = "machine = \"fanuc-lathe\"\n";
    let mut live = serve(Shown::text(FIRST).set_up(bare)).live();
    assert_eq!(live.json("no_stock")["message"], serde_json::Value::Null);
    let wrong = "machine = \"fanuc-lathe\"\n[stock]\nshape = \"box\"\n";
    let mut live = serve(Shown::text(FIRST).set_up(wrong)).live();
    let received = live.json("no_stock");
    assert!(received["message"].is_string() && received["help"].is_string(), "{received}");
}
