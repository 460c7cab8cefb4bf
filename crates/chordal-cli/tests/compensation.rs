//! `chordal path` and `chordal comp-range`.

mod common;

use common::{CLEAN, Folder};

/// The inside thread of a manual: a lead arc of .25, a circle of .5.
const THREAD: &str = "\
G20 G90 G40
T1 M6
S1000 M3
G0 X0 Y0 Z.1
G1 Z-.5156 F50.
G41 X.25 Y-.25 F10. D1
G3 X.5 Y0 I0 J.25 Z-.5
I-.5 J0 Z-.375 F20.
X.25 Y.25 I-.25 J0 Z-.3594
G40 G1 X0 Y0
M30
";

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("thread.nc", THREAD);
    folder
}

const TOOL: [&str; 4] = ["-m", "haas-vf2", "--set", "tools.1.diameter=\"0.35 in\""];

#[test]
fn the_path_is_of_the_tool_centre() {
    let folder = folder();
    let mut arguments = vec!["path", "thread.nc"];
    arguments.extend(TOOL);
    let done = folder.run(&arguments).ends(0);
    let turn = done
        .out
        .lines()
        .find(|line| line.contains("\"line\":8,\"kind\":\"arc\""))
        .expect("the turn");
    // .5 less .175 is .325 in: 8.255 mm.
    for words in ["\"compensation\":\"left\"", "\"cutter_radius\":4.445", "8.255"] {
        assert!(turn.contains(words), "{turn}");
    }
    let plunge = done
        .out
        .lines()
        .find(|line| line.contains("\"line\":5,\"kind\":\"line\""))
        .expect("the plunge");
    assert!(plunge.contains("\"compensation\":\"off\""), "{plunge}");
    arguments.extend(["--format", "csv"]);
    folder.run(&arguments).ends(0).says(&["compensation,cutter_radius_mm", "left,4.445"]);
}

#[test]
fn the_range_names_what_limits_it() {
    let folder = folder();
    let mut arguments = vec!["comp-range", "thread.nc"];
    arguments.extend(TOOL);
    folder.run(&arguments).ends(0).says(&[
        "contour 1: lines 6 to 10, G41 in XY",
        "line 7: inside radius 0.25 in is smaller than the offset",
        "gouge    radius up to 0.5 in: line 8: the tool runs inside this arc",
        "leads    radius up to 0.25 in: line 7: the lead-in or lead-out arc",
        "passes its centre at 0.1768 in",
        "offset 1 has the radius 0.175 in: fits",
    ]);
    let large = ["-m", "haas-vf2", "--set", "tools.1.diameter=\"0.6 in\""];
    let mut arguments = vec!["comp-range", "thread.nc", "--format", "json"];
    arguments.extend(large);
    folder.run(&arguments).ends(1).says(&["chordal.contour-ranges/1", "\"fits\": false"]);
}

#[test]
fn a_program_without_compensation_has_no_ranges() {
    let folder = Folder::new();
    folder.write("part.nc", CLEAN);
    folder
        .run(&["comp-range", "part.nc", "-m", "haas-vf2"])
        .ends(0)
        .says(&["no contour with cutter compensation"]);
}
