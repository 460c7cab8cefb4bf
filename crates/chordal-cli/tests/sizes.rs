//! Large and endless inputs: their cost grows with them once, or a budget says that it ends. None of these ends in a
//! day if it grows with the square.

mod common;

use common::Folder;

#[test]
fn two_hundred_thousand_open_loops() {
    let folder = Folder::new();
    let open = "WHILE[1EQ1]DO1\n".repeat(200_000);
    folder.write("open.nc", format!("%\nO1\nG21\n{open}M30\n%\n"));
    let done = folder.run(&["check", "open.nc", "-m", "fanuc-0i", "-q"]).ends(1);
    assert!(done.out.contains("DO1 has no END1 below it"), "{}", done.out);
    // Each has its END: all are found.
    let closed = "WHILE[#1LT1]DO1\n#1=#1+1\nEND1\n#1=0\n".repeat(50_000);
    folder.write("closed.nc", format!("%\nO1\nG21\n#1=0\n{closed}G0 X1.\nM30\n%\n"));
    let done = folder.run(&["check", "closed.nc", "-m", "fanuc-0i", "-q"]);
    assert!(!done.out.contains("END1"), "{}", done.out);
}

#[test]
fn a_line_of_a_quarter_of_a_megabyte_full_of_mistakes() {
    let folder = Folder::new();
    folder.write("line.nc", format!("%\nO1\nG21\n{}\nM30\n%\n", "X1.Y..2 ".repeat(30_000)));
    let done = folder.run(&["check", "line.nc", "-m", "haas-vf2", "--format", "json"]).ends(1);
    let told: serde_json::Value = serde_json::from_str(&done.out).unwrap();
    let last = told["files"][0]["diagnostics"].as_array().unwrap().last().unwrap();
    assert_eq!(last["line"], 4);
    let column = last["column"].as_u64().unwrap();
    assert!((239_000..240_001).contains(&column), "{column}");
}

#[test]
fn what_is_stopped_by_its_budget_is_not_planned_again_and_again() {
    let folder = Folder::new();
    folder.write(
        "endless.nc",
        "%\nO1\nG21 G90 G54\nS900 M3\nG0 X0 Y0\nN1 G1 X1. F100.\nX0\nGOTO 1\nM30\n%\n",
    );
    let arguments = ["time", "endless.nc", "-m", "fanuc-0i", "--what-if", "--max-blocks", "30000"];
    let done = folder.run(&arguments).ends(1);
    assert!(!done.out.contains("what if"), "{}", done.out);
    assert!(done.err.contains("stopped after 30000 blocks"), "{}", done.err);
}

#[test]
fn a_picture_of_a_year() {
    let folder = Folder::new();
    folder.write(
        "year.nc",
        "%\nO1\nG21 G90 G54\nS900 M3\nG0 X0 Y0 Z5.\nG1 X500. F.001\nX0\nM30\n%\n",
    );
    folder.run(&["time", "year.nc", "-m", "fanuc-0i", "-o", "year.svg"]);
    let picture = folder.read("year.svg");
    assert!(picture.contains("a setpoint every "), "the sheet says how coarse it is");
}

#[test]
fn a_spline_of_a_hundred_kilometres_is_a_small_drawing() {
    let folder = Folder::new();
    for end in ["-99999999", "99999999"] {
        let text =
            format!("G21 G90 G54\nF1000 S100 M3\nG0 X0 Y0\nG5 I1 J{end} P1 Q1 X{end} Y1\nM2\n");
        folder.write("far.ngc", text);
        folder.run(&["run", "far.ngc", "-m", "linuxcnc-mill", "-o", "far.dxf"]);
        let size = folder.bytes("far.dxf").len();
        assert!(size < 20_000_000, "{size} bytes");
        let text = folder.read("far.dxf");
        assert!(text.contains("curves of more than 100000 corners are within "));
    }
}

#[test]
fn a_plunge_of_a_hundred_metres_costs_what_the_stock_is_high() {
    let folder = Folder::new();
    let setup = "machine = \"haas-vf2\"\n[tools.1]\nshape = \"flat\"\ndiameter = \"12 mm\"\n\
                 length = \"60 mm\"\nflute_length = \"10 mm\"\nholder = [[\"40 mm\", \"40 mm\"]]\n\
                 [stock]\nshape = \"box\"\nfrom = { X = \"0 mm\", Y = \"0 mm\", Z = \"-5 mm\" }\n\
                 to = { X = \"60 mm\", Y = \"60 mm\", Z = \"0 mm\" }\n";
    folder.write("setup.toml", setup);
    let text = |depth: &str| {
        format!(
            "O1\nG21 G90 G54 G17 G40\nT1 M6\nS3000 M3\nG0 X30. Y30.\nG43 H1 Z2.\n\
             G1 Z{depth} F100.\nG0 Z2.\nM30\n"
        )
    };
    folder.write("deep.nc", text("-100000.")).write("due.nc", text("-90."));
    folder.write("ramp.nc", text("-100000. X55."));
    let of = |name: &str| {
        let done = folder.run(&["stock", name, "--setup", "setup.toml", "--resolution", "1mm"]);
        assert!(done.out.contains("the holder touches"), "{}{}", done.out, done.err);
        let touched =
            done.out.lines().filter(|line| line.contains("goes") || line.contains("deepest"));
        touched.map(str::to_string).collect::<Vec<_>>()
    };
    // All of the holder has gone through at the end of both.
    assert_eq!(of("deep.nc"), of("due.nc"));
    assert!(!of("ramp.nc").is_empty());
}
