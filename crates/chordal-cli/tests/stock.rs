//! `chordal stock`: the answer, its exit code, its files, and wrong setups.

mod common;

use chordal::stock::mesh::{LengthUnit, StlOptions, read_stl};
use common::Folder;

const SETUP: &str = "machine = 'haas-vf2'
[stock]
shape = 'box'
from = { X = '0 mm', Y = '0 mm', Z = '-20 mm' }
to = { X = '80 mm', Y = '60 mm', Z = '0 mm' }
[tools.1]
kind = 'flat'
diameter = '10 mm'
flute_length = '25 mm'
shank_diameter = '10 mm'
";

const CLEAN: &str = "O1\nG21 G90 G54\nT1 M6\nS3000 M3\nG0 X20. Y30.\nG43 H1 Z5.\nG1 Z-5. F200.\nX60. F600.\nG0 Z5.\nM30\n";

fn folder() -> Folder {
    let folder = Folder::new();
    folder
        .write("op1.toml", SETUP)
        .write("part.nc", CLEAN)
        .write("hit.nc", CLEAN.replace("G1 Z-5. F200.", "G0 Z-5."));
    folder
}

#[test]
fn clean_is_proved_and_a_rapid_in_the_stock_is_not() {
    let folder = folder();
    folder.run(&["stock", "part.nc", "--setup", "op1.toml"]).ends(0).says(&[
        "removed",
        "left",
        "clean: no rapid",
    ]);
    folder
        .run(&["stock", "hit.nc", "--setup", "op1.toml"])
        .ends(1)
        .says(&["error[CH620]: a rapid goes 5 mm deep through material", "hit.nc:7"]);
}

#[test]
fn json_has_the_bounds_and_the_problems() {
    let folder = folder();
    let done = folder.run(&["stock", "hit.nc", "--setup", "op1.toml", "--format", "json"]).ends(1);
    let found: serde_json::Value = serde_json::from_str(&done.out).expect("JSON");
    assert_eq!(found["schema"], "chordal.stock/1");
    assert_eq!(found["verdict"], "problems");
    let problem = &found["problems"][0];
    assert_eq!((&problem["code"], &problem["line"]), (&"CH620".into(), &7.into()));
    assert!(problem["depth_mm"]["least"].as_f64().is_some_and(|mm| (mm - 5.0).abs() < 1e-3));
    // A rapid removes nothing.
    assert_eq!(found["removed_mm3"]["most"], 0.0);
    let done = folder.run(&["stock", "part.nc", "--setup", "op1.toml", "--format", "json"]).ends(0);
    let found: serde_json::Value = serde_json::from_str(&done.out).expect("JSON");
    let removed = &found["removed_mm3"];
    let truth = (400.0 + 25.0 * std::f64::consts::PI) * 5.0;
    assert!(removed["least"].as_f64() <= Some(truth) && removed["most"].as_f64() >= Some(truth));
}

#[test]
fn what_is_left_is_the_stock_of_the_next_operation() {
    let folder = folder();
    folder
        .run(&["stock", "part.nc", "--setup", "op1.toml", "-o", "left.stl", "-o", "left.png"])
        .ends(0)
        .says(&["written: left.stl", "written: left.png"]);
    let second = "machine = 'haas-vf2'
[stock]
shape = 'stl'
file = 'left.stl'
turned_over = 'X'
from = { Y = '60 mm', Z = '-20 mm' }
[tools.1]
shape = 'flat'
diameter = '10 mm'
flute_length = '25 mm'
";
    folder.write("op2.toml", second);
    // Through the middles of the columns; walls are as wide as one.
    folder
        .run(&["stock", "part.nc", "--setup", "op1.toml", "-o", "smooth.stl", "--smooth", "0.01mm"])
        .ends(0)
        .says(&["written: smooth.stl"]);
    // Below the pocket of the first side 15 mm are left.
    folder
        .run(&["stock", "part.nc", "--setup", "op2.toml", "-o", "two.stl"])
        .ends(0)
        .says(&["clean: no rapid", "written: two.stl"]);
    // What the first side has hollowed out is in the mesh as well.
    let done = folder.run(&["stock", "part.nc", "--setup", "op2.toml", "--format", "json"]).ends(0);
    let found: serde_json::Value = serde_json::from_str(&done.out).expect("JSON");
    let (left, volume) = (&found["left_mm3"], volume_of(&folder, "two.stl"));
    assert!(left["least"].as_f64() <= Some(volume) && left["most"].as_f64() >= Some(volume));
    // Below the slot nothing is cut twice: what the tool removes is known.
    let of_tool = &found["tools"][0]["removed_mm3"];
    assert!(of_tool["least"].as_f64() > Some(1_500.0), "{of_tool}");
    // A smooth mesh is closed as well.
    folder.write("op3.toml", second.replace("left.stl", "smooth.stl"));
    folder.run(&["stock", "part.nc", "--setup", "op3.toml"]).ends(0);
    folder.write("left.stl", "solid of nothing");
    folder
        .run(&["stock", "part.nc", "--setup", "op2.toml"])
        .ends(2)
        .complains(&["left.stl", "op2.toml:2"]);
}

#[test]
fn run_and_report_show_what_is_left() {
    let folder = folder();
    let setup = ["--setup", "op1.toml"];
    folder
        .run(&[&["run", "part.nc", "-o", "part.svg", "-o", "part.png"], &setup[..]].concat())
        .ends(0)
        .says(&["removed     ", "clean: no rapid", "written   part.png"]);
    let images = |name: &str| folder.read(name).matches("<image ").count();
    assert_eq!(images("part.svg"), 4);
    let done = folder.run(&[&["run", "hit.nc", "--format", "json"], &setup[..]].concat()).ends(1);
    let found: serde_json::Value = serde_json::from_str(&done.out).expect("JSON");
    let stock = &found["files"][0]["stock"];
    assert_eq!(stock["verdict"], "problems");
    assert_eq!(stock["problems"][0]["code"], "CH620");
    // Two views of the path, and the stock alone.
    folder.run(&[&["report", "part.nc", "-o", "setup.html"], &setup[..]].concat()).ends(0);
    assert_eq!(images("setup.html"), 3);
    assert!(
        folder.read("setup.html").contains("Clean: no rapid, and no shank or holder that is given")
    );
    let done =
        folder.run(&[&["report", "hit.nc", "--format", "json"], &setup[..]].concat()).ends(1);
    let found: serde_json::Value = serde_json::from_str(&done.out).expect("JSON");
    assert_eq!((&found["stock"]["verdict"], &found["errors"]), (&"problems".into(), &2.into()));
    assert_eq!(found["problems"]["rows"][0]["code"], "CH620");
    folder.run(&["run", "part.nc", "--setup", "none.toml"]).ends(2).complains(&["none.toml"]);
}

#[test]
fn wrong_setups_are_drawn() {
    let folder = folder();
    folder.run(&["stock", "part.nc", "-m", "haas-vf2"]).ends(2).complains(&["no stock", "--setup"]);
    folder.write("open.toml", SETUP.replace(", Z = '0 mm' }", " }"));
    folder
        .run(&["stock", "part.nc", "--setup", "open.toml"])
        .ends(2)
        .complains(&["`stock.to` has no Z", "open.toml:2"]);
    folder
        .run(&["stock", "part.nc", "--setup", "op1.toml", "--resolution", "0.001mm"])
        .ends(2)
        .complains(&["--memory"]);
    folder
        .run(&["stock", "part.nc", "--setup", "op1.toml", "-o", "left.xyz"])
        .ends(2)
        .complains(&[".stl, .3mf, .glb, .png"]);
}

/// The volume of a mesh file, which must be closed, mm³.
fn volume_of(folder: &Folder, name: &str) -> f64 {
    let bytes = folder.bytes(name);
    let unit = LengthUnit::Millimetre;
    let options = StlOptions { unit, weld: 0.0, limit: usize::MAX };
    let mesh = read_stl(&bytes, &options).expect("STL").mesh;
    assert!(mesh.edges().are_paired(), "{:?}", mesh.edges());
    mesh.volume()
}

const T_SLOT: &str = "machine = 'haas-vf2'
[stock]
shape = 'box'
from = { X = '0 mm', Y = '-30 mm', Z = '-20 mm' }
to = { X = '100 mm', Y = '30 mm', Z = '0 mm' }
[tools.1]
shape = 'flat'
diameter = '10 mm'
flute_length = '25 mm'
[tools.2]
shape = 't-slot'
diameter = '20 mm'
flute_length = '4 mm'
shank_diameter = '9 mm'
";

fn slots(second_y: &str) -> String {
    let pass = |tool: u32, y: &str| {
        format!(
            "T{tool} M6\nS1000 M3\nG0 X-20. {y}\nG43 H{tool} Z5.\nG0 Z-12.\nG1 X120. F600.\nG0 Z20.\n"
        )
    };
    format!("O1\nG21 G90 G54\n{}{}M30\n", pass(1, "Y0."), pass(2, second_y))
}

#[test]
fn a_t_slot_is_cut_below_a_slot_and_its_neck_must_fit() {
    let folder = Folder::new();
    folder.write("t.toml", T_SLOT).write("in.nc", slots("Y0.")).write("aside.nc", slots("Y8."));
    let done =
        folder.run(&["stock", "in.nc", "--setup", "t.toml", "-o", "left.stl", "--format", "json"]);
    let found: serde_json::Value = serde_json::from_str(&done.ends(0).out).expect("JSON");
    // 12 cm³ of the slot, and 10 mm more of width on 4 mm of height.
    let removed = &found["removed_mm3"];
    assert!(
        removed["least"].as_f64() <= Some(16_000.0) && removed["most"].as_f64() >= Some(16_000.0)
    );
    let tool = &found["tools"][1];
    let of_tool = &tool["removed_mm3"];
    assert!(
        of_tool["least"].as_f64() > Some(3_500.0) && of_tool["least"].as_f64() <= Some(4_000.0)
    );
    assert!(tool["time_s"].as_f64() > Some(14.0));
    folder
        .run(&["stock", "in.nc", "--setup", "t.toml", "-o", "left.stl"])
        .ends(0)
        .says(&["clean: no rapid", "written: left.stl"]);
    // The mesh has the gaps: closed, and its volume is between the bounds.
    let left = &found["left_mm3"];
    let volume = volume_of(&folder, "left.stl");
    assert!(left["least"].as_f64() <= Some(volume) && left["most"].as_f64() >= Some(volume));
    assert!((volume - 104_000.0).abs() < 500.0, "{volume}");
    folder
        .run(&[
            "stock", "in.nc", "--setup", "t.toml", "-o", "left.3mf", "-o", "left.glb", "-o",
            "left.png",
        ])
        .ends(0)
        .says(&["written: left.3mf", "written: left.glb", "written: left.png"]);
    folder
        .run(&["stock", "in.nc", "--setup", "t.toml", "-o", "smooth.stl", "--smooth", "0.02mm"])
        .ends(2)
        .complains(&["a smooth mesh has no undersides", "leave --smooth out"]);
    folder
        .run(&["stock", "aside.nc", "--setup", "t.toml"])
        .ends(1)
        .says(&["error[CH622]: the shank of tool 2 goes 8 mm deep into material"]);
}

#[test]
fn folders_are_checked_on_their_stock() {
    let folder = Folder::new();
    folder
        .write("t.toml", T_SLOT)
        .write("nc/in.nc", slots("Y0."))
        .write("nc/aside.nc", slots("Y8."));
    let stock = ["check", "nc", "--stock", "--setup", "t.toml"];
    folder.run(&stock).ends(1).says(&["CH622", "aside.nc:15"]).complains(&["1 of 2 programs"]);
    folder.run(&["check", "nc/in.nc", "--stock", "--setup", "t.toml"]).ends(0);
    folder
        .run(&["check", "nc/in.nc", "--stock", "-m", "haas-vf2"])
        .ends(2)
        .complains(&["no stock"]);
    for command in [&stock[..], &["stock", "nc/aside.nc", "--setup", "t.toml"]] {
        let done = folder.run(&[command, &["--format", "sarif"]].concat()).ends(1);
        let log: serde_json::Value = serde_json::from_str(&done.out).expect("JSON");
        let results = log["runs"][0]["results"].as_array().expect("results");
        let hit = results.iter().find(|result| result["ruleId"] == "CH622").expect("the hit");
        let place = &hit["locations"][0]["physicalLocation"];
        assert_eq!(place["region"]["startLine"], 15, "{place}");
    }
    // Coarse columns cannot exclude that the neck, which is half a millimetre from the walls, touches them.
    let coarse = ["--resolution", "5mm", "--stock", "--setup", "wide.toml"];
    folder.write("wide.toml", T_SLOT.replace("'9 mm'", "'9.98 mm'"));
    let done = folder.run(&[&["check", "nc/in.nc"][..], &coarse].concat());
    done.ends(1).says(&["CH629"]);
}

const LATHE: &str = "machine = 'fanuc-lathe'
[stock]
shape = 'cylinder'
axis = 'Z'
diameter = '60 mm'
from = '-100 mm'
to = '0 mm'
[tools.1]
shape = 'insert'
insert = 'C'
approach_angle = '95 deg'
flute_length = '12 mm'
nose_radius = '0.8 mm'
tip = 3
";

const TURNED: &str =
    "O1\nG21 G18 G40 G97 G99\nT0101\nS800 M3\nG0 X50. Z2.\nG1 Z-40. F.2\nX62.\nG0 Z2.\nM30\n";

fn lathe() -> Folder {
    let folder = Folder::new();
    folder
        .write("shaft.toml", LATHE)
        .write("shaft.nc", TURNED)
        .write("hit.nc", TURNED.replace("G1 Z-40. F.2", "G0 Z-40."));
    folder
}

#[test]
fn a_lathe_has_exact_volumes() {
    let folder = lathe();
    folder.run(&["stock", "shaft.nc", "--setup", "shaft.toml"]).ends(0).says(&[
        "tool 1",
        "depth of cut up to 5.000 mm in line 6",
        "clean: no rapid",
        "the half section is exact",
    ]);
    let done =
        folder.run(&["stock", "shaft.nc", "--setup", "shaft.toml", "--format", "json"]).ends(0);
    let found: serde_json::Value = serde_json::from_str(&done.out).expect("JSON");
    assert_eq!(found["schema"], "chordal.stock/1");
    assert_eq!(found["exact"], true);
    let removed = &found["removed_mm3"];
    assert_eq!(removed["least"], removed["most"]);
    // A ring, without what the nose leaves in the shoulder.
    let pi = std::f64::consts::PI;
    let centroid = 25.0 + (10.0 - 3.0 * pi) / (12.0 - 3.0 * pi) * 0.8;
    let fillet = 2.0 * pi * centroid * (1.0 - pi / 4.0) * 0.64;
    let wanted = pi * (900.0 - 625.0) * 40.0 - fillet;
    assert!(removed["least"].as_f64().is_some_and(|mm3| (mm3 - wanted).abs() < 1e-6), "{removed}");
    folder.run(&["stock", "hit.nc", "--setup", "shaft.toml"]).ends(1).says(&[
        "error[CH620]: a rapid goes 5 mm deep through material",
        "hit.nc:6",
        "X55 mm",
    ]);
    folder.run(&["check", "hit.nc", "--stock", "--setup", "shaft.toml"]).ends(1).says(&["CH620"]);
    folder.run(&["check", "shaft.nc", "--stock", "--setup", "shaft.toml"]).ends(0);
}

#[test]
fn a_lathe_writes_its_half_section() {
    let folder = lathe();
    let outputs = ["left.svg", "left.png", "left.dxf", "left.stl", "left.glb", "left.3mf"];
    let mut args = vec!["stock", "shaft.nc", "--setup", "shaft.toml"];
    outputs.iter().for_each(|name| args.extend(["-o", name]));
    folder.run(&args).ends(0).says(&["written: left.dxf"]);
    let drawing = folder.read("left.svg");
    assert!(drawing.contains("Ø50") && drawing.contains("Z−40") && drawing.contains("R0.8"));
    // What is left is the stock of the next operation, exactly.
    let next = LATHE.replace(
        "shape = 'cylinder'\naxis = 'Z'\ndiameter = '60 mm'\nfrom = '-100 mm'\nto = '0 mm'",
        "shape = 'dxf'\nfile = 'left.dxf'",
    );
    folder.write("next.toml", next).write("no.nc", "G21 G18 G99\nT0101\nG0 X62. Z2.\nM30\n");
    let volume = |args: &[&str]| {
        let done = folder.run(args).ends(0);
        let found: serde_json::Value = serde_json::from_str(&done.out).expect("JSON");
        found["left_mm3"]["most"].as_f64().expect("a volume")
    };
    let left = volume(&["stock", "shaft.nc", "--setup", "shaft.toml", "--format", "json"]);
    let again = volume(&["stock", "no.nc", "--setup", "next.toml", "--format", "json"]);
    assert!((left - again).abs() < 1e-4, "{left} and {again}");
    folder
        .run(&["stock", "shaft.nc", "--setup", "shaft.toml", "-o", "left.xyz"])
        .ends(2)
        .complains(&[".svg, .png, .dxf"]);
    folder
        .run(&["stock", "shaft.nc", "--setup", "shaft.toml", "--engagement", "-o", "cuts.csv"])
        .ends(0)
        .says(&["chip area", "0.996 mm²"]);
    let cuts = folder.read("cuts.csv");
    assert!(cuts.starts_with("line,file,tool,length_mm"), "{cuts}");
    assert_eq!(cuts.lines().count(), 3);
    folder.run(&["run", "shaft.nc", "--machine", "shaft.toml", "-o", "path.svg"]).ends(0);
    assert!(folder.read("path.svg").contains("Z and X, diameters"));
}

#[test]
fn wrong_setups_of_a_lathe_are_named() {
    let folder = lathe();
    let with = |from: &str, to: &str| LATHE.replace(from, to);
    let cases = [
        (with("shape = 'cylinder'", "shape = 'box'"), "is not a body that turns"),
        (with("axis = 'Z'", "axis = 'X'"), "does not lie along Z"),
        (with("diameter = '60 mm'\n", ""), "has no `diameter`"),
        (with("shape = 'cylinder'", "shape = 'contour'"), "has no `contour`"),
        (with("shape = 'cylinder'", "shape = 'dxf'\nfile = 'no.dxf'"), "cannot read no.dxf"),
    ];
    for (setup, words) in cases {
        folder.write("wrong.toml", setup);
        folder.run(&["stock", "shaft.nc", "--setup", "wrong.toml"]).ends(2).complains(&[words]);
    }
    // A tool that lacks a dimension cuts nothing, and that is said.
    folder.write("lacks.toml", with("approach_angle = '95 deg'\n", ""));
    folder.run(&["stock", "shaft.nc", "--setup", "lacks.toml"]).ends(1).says(&[
        "CH628",
        "`approach_angle`",
        "not proved",
    ]);
    folder.write("crossed.toml", with("shape = 'cylinder'", "shape = 'contour'\ncontour = [['10 mm', '0 mm'], ['20 mm', '-20 mm'], ['20 mm', '0 mm'], ['10 mm', '-20 mm']]"));
    folder
        .run(&["stock", "shaft.nc", "--setup", "crossed.toml"])
        .ends(2)
        .complains(&["crosses itself"]);
}

#[test]
fn what_is_not_given_of_a_tool_is_named() {
    let folder = folder();
    let of = |tool: &str| SETUP.replace("kind = 'flat'\ndiameter = '10 mm'\n", tool);
    folder.write("drill.toml", of("shape = 'drill'\ndiameter = '10 mm'\n"));
    folder.write("tap.toml", of("shape = 'tap'\ndiameter = '10 mm'\n"));
    let run = |setup: &str| folder.run(&["stock", "part.nc", "--setup", setup]);
    run("drill.toml").says(&["CH634", "118°", "no holder is given of tool 1"]);
    // Nobody knows what the tap removes: 96 cm³ are there.
    run("tap.toml").ends(1).says(&["CH628", "`pitch`", "removed     0 to 96 cm³"]);
    folder
        .run(&["stock", "part.nc", "--setup", "op1.toml", "--resolution", "1e20 mm"])
        .ends(2)
        .complains(&["one column is wider than the stock"]);
}
