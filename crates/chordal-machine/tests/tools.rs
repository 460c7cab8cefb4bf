//! Tools as data: offsets along every axis, shapes with their dimensions, and files of old.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

use chordal_machine::{Axis, BodyShape, Cutter, HolderSegment, Machine, ToolShape};

fn read(text: &str) -> Machine {
    Machine::from_toml("m.toml", text, &|name| Err(format!("no {name}"))).expect("a good file")
}

fn refused(text: &str) -> String {
    let errors = Machine::from_toml("m.toml", text, &|name| Err(format!("no {name}")));
    errors.expect_err("a bad file").iter().map(|error| format!("{error}\n")).collect()
}

fn tool(keys: &str) -> chordal_machine::Tool {
    read(&format!("control = 'haas'\n[tools.1]\n{keys}")).tools[&1].clone()
}

#[test]
fn every_shape_wants_its_dimensions() {
    let cutter = |keys: &str| format!("{:?}", tool(keys).cutter());
    for (keys, expected) in [
        ("shape = 'flat'\ndiameter = '10 mm'", Cutter::Flat { diameter_mm: 10.0 }),
        ("shape = 'Ball'\ndiameter = '-0.5 in'", Cutter::Ball { diameter_mm: 12.7 }),
        (
            "shape = 'bull'\ndiameter = '10 mm'\ncorner_radius = '2 mm'",
            Cutter::Bull { diameter_mm: 10.0, corner_radius_mm: 2.0 },
        ),
        (
            "shape = 'chamfer'\ndiameter = '10 mm'\ntip_diameter = '1 mm'\npoint_angle = '90 deg'",
            Cutter::Chamfer { diameter_mm: 10.0, tip_diameter_mm: 1.0, point_angle_rad: FRAC_PI_2 },
        ),
        (
            "shape = 'drill'\ndiameter = '5 mm'\npoint_angle = '60 deg'",
            Cutter::Drill { diameter_mm: 5.0, point_angle_rad: FRAC_PI_3 },
        ),
        (
            "shape = 'tap'\ndiameter = '6 mm'\npitch = '1 mm'",
            Cutter::Tap { diameter_mm: 6.0, pitch_mm: 1.0 },
        ),
        (
            "shape = 'thread mill'\ndiameter = '8 mm'\npitch = '1.5 mm'\nteeth = 4",
            Cutter::ThreadMill { diameter_mm: 8.0, pitch_mm: 1.5, teeth: 4 },
        ),
        (
            "shape = 't-slot'\ndiameter = '20 mm'\nflute_length = '4 mm'\nshank_diameter = '8 mm'",
            Cutter::TSlot { diameter_mm: 20.0, thickness_mm: 4.0, neck_mm: 8.0 },
        ),
        (
            "shape = 'lollipop'\ndiameter = '6 mm'\nshank = [['20 mm', '3 mm']]",
            Cutter::Lollipop { diameter_mm: 6.0, neck_mm: 3.0 },
        ),
        (
            "shape = 'form'\nprofile = [['0 mm', '3 mm'], ['5 mm', '8 mm']]",
            Cutter::Form { profile: &[[0.0, 3.0], [5.0, 8.0]] },
        ),
        (
            "shape = 'insert'\nnose_radius = '0.8 mm'\ntip = 3",
            Cutter::Insert { nose_radius_mm: 0.8, tip: 3 },
        ),
    ] {
        assert_eq!(cutter(keys), format!("{:?}", Some(expected)), "{keys}");
    }
    // Nothing is guessed for what is missing.
    for keys in [
        "diameter = '10 mm'",
        "shape = 'flat'",
        "shape = 'drill'\npoint_angle = '118 deg'",
        "shape = 'tap'\ndiameter = '6 mm'",
        "shape = 'insert'\nnose_radius = '0.8 mm'",
        "shape = 'form'",
        "shape = 't-slot'\ndiameter = '20 mm'\nshank_diameter = '8 mm'",
        "shape = 'lollipop'\ndiameter = '20 mm'",
    ] {
        assert_eq!(tool(keys).cutter(), None, "{keys}");
        assert!(!tool(keys).missing_dimensions().is_empty(), "{keys}");
    }
    assert_eq!(tool("shape = 'tap'\ndiameter = '6 mm'").missing_dimensions(), ["pitch"]);
    // But the point of a drill: that of a twist drill.
    let drill = tool("shape = 'drill'\ndiameter = '5 mm'");
    assert!(drill.has_assumed_point_angle() && drill.missing_dimensions().is_empty());
    let usual = tool("shape = 'drill'\ndiameter = '5 mm'\npoint_angle = '118 deg'");
    assert_eq!(format!("{:?}", drill.cutter()), format!("{:?}", usual.cutter()));
}

#[test]
fn a_holder_is_cylinders_and_cones() {
    let tool = tool("shank = [['30 mm', '0.5 in']]\nholder = [['20 mm', '12 mm', '40 mm']]");
    assert_eq!(tool.shank, [HolderSegment { height_mm: 30.0, lower_mm: 12.7, upper_mm: 12.7 }]);
    assert_eq!(tool.holder, [HolderSegment { height_mm: 20.0, lower_mm: 12.0, upper_mm: 40.0 }]);
    assert_eq!(
        refused("control = 'haas'\n[tools.1]\nholder = [['20 mm']]\nteeth = 0\ntip = 10"),
        "m.toml:3: `holder` takes a list of lists of lengths\n\
         m.toml:4: `teeth` takes a whole number from 1 to 1000; this is 0\n\
         m.toml:5: `tip` takes a whole number from 0 to 9; this is 10\n"
    );
    assert_eq!(
        refused("control = 'haas'\n[tools.1]\nprofile = [['5 mm', '1 mm'], ['0 mm', '1 mm']]"),
        "m.toml:3: `profile` goes down after its point 1\n"
    );
}

#[test]
fn geometry_and_wear_on_every_axis() {
    let tool = tool(
        "length = '100 mm'\nlength_wear = '-0.1 mm'\noffset.X = '20 mm'\noffset_wear.X = '0.05 mm'\n\
         diameter = '10 mm'\ndiameter_wear = '-0.02 mm'",
    );
    assert_eq!(tool.length_mm(), Some(100.0));
    assert_eq!(tool.offset_of(Axis::Z as usize), Some(100.0 - 0.1));
    assert_eq!(tool.offset_of(Axis::X as usize), Some(20.05));
    assert_eq!(tool.offset_of(Axis::Y as usize), None);
    assert_eq!(tool.radius_mm(), Some(4.99));
    // `length` and `offset.Z` are one.
    let other = self::tool("offset.Z = '100 mm'");
    assert_eq!(other.length_mm(), Some(100.0));
    // The radius offset of an insert is that of its nose.
    assert_eq!(self::tool("nose_radius = '0.8 mm'").radius_mm(), Some(0.8));
}

#[test]
fn kinds_of_old_files_are_read() {
    for (kind, shape) in [
        ("drill", Some(ToolShape::Drill)),
        ("Spot Drill", Some(ToolShape::Drill)),
        ("end mill", Some(ToolShape::Flat)),
        ("ball end mill", Some(ToolShape::Ball)),
        ("bull nose end mill", Some(ToolShape::Bull)),
        ("face mill", Some(ToolShape::Flat)),
        ("thread mill", Some(ToolShape::ThreadMill)),
        ("lollipop", Some(ToolShape::Lollipop)),
        ("3/4 T-slot cutter", Some(ToolShape::TSlot)),
        ("90 deg chamfer mill", Some(ToolShape::Chamfer)),
        ("M6 tap", Some(ToolShape::Tap)),
        ("reamer", None),
        ("boring bar", None),
        ("the good one", None),
    ] {
        let machine = read(&format!("control = 'haas'\n[tools.1]\nkind = '{kind}'"));
        let tool = &machine.tools[&1];
        assert_eq!(tool.shape, shape, "{kind}");
        let own_word = ["drill", "thread mill", "lollipop"].contains(&kind);
        assert_eq!(tool.description.as_deref(), (!own_word).then_some(kind));
        assert_eq!(machine.notices.0.len(), usize::from(shape.is_none()), "{kind}");
    }
    let machine = read("control = 'haas'\n[tools.1]\nkind = 'reamer'");
    let notice = &machine.notices.0[0];
    assert_eq!(
        notice.to_string(),
        "m.toml:3: `reamer` names no tool shape; it is kept as the description"
    );
    assert_eq!(
        notice.help.as_deref(),
        Some(
            "a shape is `shape = …` with \"flat\", \"ball\", \"bull\", \"chamfer\", \"drill\", \"tap\", \
             \"thread mill\", \"t-slot\", \"lollipop\", \"form\", \"insert\" or \"groove\""
        )
    );
}

const LATHE: &str = "
control = 'fanuc'
[work_offsets.G54]
X = '10 mm'
Z = '-100 mm'
[axes.X]
programmed = 'diameter'
travel = ['-20 mm', '300 mm']
max_velocity = '10 m/min'
[axes.Z]
[axes.C]
[home]
X = '280 mm'
[tools.3]
offset.X = '-60 mm'
offset_wear.X = '0.2 mm'
length = '40 mm'
nose_radius = '0.4 mm'
tip = 3
shape = 'insert'
";

#[test]
fn places_of_a_diameter_axis_are_diameters_in_the_file_and_radii_inside() {
    let mut machine = read(LATHE);
    let x = machine.axis(Axis::X).expect("an X axis");
    assert_eq!(x.travel, Some((-10.0, 150.0)));
    // A speed is that of the slide.
    assert_eq!(x.max_velocity, Some(10_000.0 / 60.0));
    assert_eq!(machine.work_offsets["G54"].values[..3], [Some(5.0), None, Some(-100.0)]);
    assert_eq!(machine.home[0], Some(140.0));
    assert_eq!(machine.tools[&3].offset[..3], [Some(-30.0), None, Some(40.0)]);
    assert_eq!(machine.tools[&3].offset_wear[0], Some(0.1));
    assert_eq!(machine.tools[&3].nose_radius_mm, Some(0.4));
    // Written, it is the same file again.
    let text = machine.to_toml();
    assert!(
        text.contains("programmed = \"diameter\"\ntravel = [\"-20 mm\", \"300 mm\"]"),
        "{text}"
    );
    assert!(text.contains("offset.X = \"-60 mm\"\nlength = \"40 mm\""), "{text}");
    assert_eq!(read(&text), machine);
    // The numbers of the file stay when they are taken for radii.
    machine.set("axes.X.programmed = radius").expect("a good word");
    assert_eq!(machine.work_offsets["G54"].values[0], Some(10.0));
    assert_eq!(machine.axis(Axis::X).and_then(|x| x.travel), Some((-20.0, 300.0)));
    machine.set("axes.X.programmed = diameter").expect("a good word");
    machine.set("work_offsets.G54.X = 30 mm").expect("a good length");
    assert_eq!(machine.work_offsets["G54"].values[0], Some(15.0));
}

#[test]
fn angles_are_no_diameters() {
    assert_eq!(
        refused("control = 'fanuc'\n[axes.C]\nprogrammed = 'diameter'"),
        "m.toml:3: C turns: its words are angles, not diameters\n"
    );
}

#[test]
fn a_setup_file_names_its_machine_and_what_lies_on_it() {
    let text = r#"
machine = "haas-vf2"
[stock]
shape = "box"
work_offset = "G54"
from = { X = "0 mm", Y = "0 mm", Z = "-20 mm" }
to   = { X = "80 mm", Y = "60 mm", Z = "0 mm" }
[fixtures."left clamp"]
shape = "cylinder"
axis = "Y"
diameter = "1 in"
from = "-10 mm"
to = "5 mm"
clearance = "2 mm"
[target]
shape = "stl"
file = "part.stl"
unit = "in"
[tools.1]
kind = "flat"
diameter = "10 mm"
flute_length = "25 mm"
shank_diameter = "10 mm"
"#;
    let none = |name: &str| Err(format!("no file {name}"));
    let machine = Machine::from_toml("shop/op1.toml", text, &none).unwrap();
    assert_eq!(machine.name, "haas-vf2");
    let stock = machine.setup.stock.as_ref().unwrap();
    assert_eq!(stock.shape, Some(BodyShape::Box));
    assert_eq!((stock.from[2], stock.to[0]), (Some(-20.0), Some(80.0)));
    let clamp = &machine.setup.fixtures["left clamp"];
    assert_eq!((clamp.from, clamp.to[1]), ([None, Some(-10.0), None], Some(5.0)));
    assert_eq!((clamp.diameter_mm, clamp.clearance_mm), (Some(25.4), Some(2.0)));
    // The file is relative to the one that names it.
    let target = machine.setup.target.as_ref().unwrap();
    assert_eq!(target.file.as_deref(), Some("shop/part.stl"));
    assert_eq!(machine.tools[&1].shank_diameter_mm, Some(10.0));

    let again = Machine::from_toml("again.toml", &machine.to_toml(), &none).unwrap();
    assert_eq!(again.setup, machine.setup);

    let wrong = |text: &str| Machine::from_toml("op.toml", text, &none).unwrap_err()[0].to_string();
    let shape = wrong("machine = 'haas-vf2'\n[stock]\nshape = 'bock'\n");
    assert!(shape.contains("`bock` is not a body shape"), "{shape}");
    let unit = wrong("machine = 'haas-vf2'\n[stock]\ndiameter = 20\n");
    assert!(unit.contains("no unit"), "{unit}");
}

#[test]
fn a_lathe_tool_and_a_half_section_are_read_and_written() {
    let text = r#"
machine = "fanuc-lathe"
[stock]
shape = "contour"
contour = [["20 mm", "0 mm"], ["24 mm", "-2 mm", "-2 mm"], ["1 in", "-50 mm"]]
[tools.1]
shape = "insert"
insert = "D"
approach_angle = "93 deg"
flute_length = "11 mm"
nose_radius = "0.4 mm"
tip = 3
holder_outline = [["8 mm", "10 mm"], ["120 mm", "10 mm"], ["8 mm", "-35 mm"]]
[tools.2]
shape = "groove"
width = "3 mm"
lead_angle = "-6 deg"
facing = "back face"
tip = 4
bar_offset = "9 mm"
"#;
    let none = |name: &str| Err(format!("no file {name}"));
    let machine = Machine::from_toml("shaft.toml", text, &none).unwrap();
    let stock = machine.setup.stock.as_ref().unwrap();
    // X as a diameter, whatever the machine.
    let points: Vec<_> =
        stock.contour.iter().map(|at| (at.radius_mm, at.z_mm, at.arc_mm)).collect();
    assert_eq!(points, [(10.0, 0.0, None), (12.0, -2.0, Some(-2.0)), (12.7, -50.0, None)]);
    let turning = &machine.tools[&1].turning;
    assert!(turning.corner_rad().is_some_and(|angle| (angle.to_degrees() - 55.0).abs() < 1e-9));
    assert_eq!(turning.holder_outline[2], [8.0, -35.0]);
    assert_eq!(machine.tools[&2].turning.width_mm, Some(3.0));

    let again = Machine::from_toml("again.toml", &machine.to_toml(), &none).unwrap();
    assert_eq!(again.setup, machine.setup);
    assert_eq!(again.tools, machine.tools);

    let wrong = |text: &str| Machine::from_toml("op.toml", text, &none).unwrap_err()[0].to_string();
    let two = wrong("machine = 'fanuc-lathe'\n[tools.1]\nholder_outline = [['1 mm', '2 mm']]\n");
    assert!(two.contains("three corners"), "{two}");
    let letter = wrong("machine = 'fanuc-lathe'\n[tools.1]\ninsert = 'X'\n");
    assert!(letter.contains("`X` is not a letter of an insert"), "{letter}");
}

fn turning(keys: &str) -> chordal_machine::Tool {
    let mut tool = tool(keys);
    tool.take_designations(false);
    tool
}

/// What a designation gives: corner, edges, nose; angle to Z and usual tip of the holder.
#[test]
fn designations_give_what_they_say() {
    let tool = turning("insert = 'CNMG120408'\nholder_designation = 'PCLNR2525M12'");
    assert_eq!(tool.shape, Some(ToolShape::Insert));
    assert_eq!(tool.nose_radius_mm, Some(0.8));
    assert_eq!(tool.turning.corner_rad().map(f64::to_degrees), Some(80.0));
    assert_eq!(tool.turning.approach_angle_rad.map(f64::to_degrees), Some(95.0));
    assert_eq!((tool.tip, tool.turning.has_usual_tip), (Some(3), true));
    // The edge of a rhombus about a circle of 12.7 mm.
    let edge = 12.7 / 80.0_f64.to_radians().sin();
    assert!((tool.flute_length_mm.expect("edges") - edge).abs() < 1e-9);

    let bar = turning("insert = 'CCMT 09T304'\nholder_designation = 'S20R-SCLCR09'");
    assert_eq!((bar.tip, bar.nose_radius_mm), (Some(2), Some(0.4)));
    // What is given counts, and a shorter edge is no contradiction.
    let given = turning(
        "insert = 'CNMG120408'\nholder_designation = 'PCLNR2525M12'\ntip = 4\nflute_length = '8 mm'",
    );
    assert_eq!((given.tip, given.flute_length_mm), (Some(4), Some(8.0)));
    assert!(!given.turning.has_usual_tip);
    // Towards the chuck or away from it: a left-hand holder says neither.
    assert_eq!(turning("holder_designation = 'PCLNL2525M12'").tip, None);
    // X counted the other way round.
    let mut mirrored = self::tool("holder_designation = 'PCLNR2525M12'");
    mirrored.take_designations(true);
    assert_eq!(mirrored.tip, Some(2));
    // A letter alone is what it was.
    let letter = turning("insert = 'd'\nshape = 'insert'");
    assert_eq!(letter.turning.corner_rad().map(f64::to_degrees), Some(55.0));
    assert_eq!((letter.nose_radius_mm, letter.flute_length_mm), (None, None));
}

#[test]
fn a_designation_is_written_as_it_was_read() {
    let text = "control = 'fanuc-lathe'\n[tools.1]\ninsert = 'CNMG120408'\nholder_designation = 'PCLNR2525M12'";
    let machine = read(text);
    assert_eq!(read(&machine.to_toml()), machine);
}

#[test]
fn designations_that_contradict_other_keys() {
    let wrong = |keys: &str| refused(&format!("control = 'haas'\n[tools.1]\n{keys}"));
    for (keys, message) in [
        (
            "insert = 'CNMG120408'\nnose_radius = '0.4 mm'",
            "the insert CNMG120408 has a nose radius of 0.8 mm, and `tools.1.nose_radius` says 0.4 mm",
        ),
        (
            "insert = 'CNMG120408'\ninsert_angle = '55 deg'",
            "the insert CNMG120408 has a corner of 80°, and `tools.1.insert_angle` says 55°",
        ),
        (
            "insert = 'CNMG120408'\nflute_length = '16 mm'",
            "the insert CNMG120408 has edges of 12.896 mm, and `tools.1.flute_length` says 16 mm",
        ),
        (
            "insert = 'CNMG120408'\nshape = 'drill'",
            "the insert CNMG120408 has the shape `insert`, and `tools.1.shape` says `drill`",
        ),
        (
            "holder_designation = 'PCLNR2525M12'\napproach_angle = '93 deg'",
            "holds the main edge at 95° to Z, and `tools.1.approach_angle` says 93°",
        ),
        (
            "insert = 'DNMG150608'\nholder_designation = 'PCLNR2525M12'",
            "the holder PCLNR2525M12 takes inserts with the letters CN, and the insert is DNMG150608",
        ),
        (
            "insert = 'CCMT120408'\nholder_designation = 'PCLNR2525M12'",
            "takes inserts with the letters CN, and the insert is CCMT120408",
        ),
        (
            "insert = 'CNMG160608'\nholder_designation = 'PCLNR2525M12'",
            "takes inserts with edges of 12.896 mm, and the insert is CNMG160608, whose edges are 16.12 mm",
        ),
        (
            "insert = 'D'\nholder_designation = 'PCLNR2525M12'",
            "takes inserts with the letter C, and `tools.1.insert` is `D`",
        ),
        (
            "insert = 'CXMG120408'",
            "`CXMG120408` is not the designation of an insert: `X` is no clearance of an insert",
        ),
        ("insert = '16ER AG60'", "this is a threading insert, whose designations are not read"),
        (
            "holder_designation = 'PXLNR2525M12'",
            "`PXLNR2525M12` is not the designation of a holder: `X` is no shape of an insert",
        ),
    ] {
        let found = wrong(keys);
        assert!(found.contains(message), "{keys}:\n{found}");
    }
    // An inch insert has 1/32 in, which people write as 0.8 mm.
    let good = turning("insert = 'CNMG432'\nnose_radius = '0.8 mm'");
    assert_eq!(good.nose_radius_mm, Some(0.8));
}

#[test]
fn an_assignment_is_held_against_designations() {
    let mut machine = read("control = 'haas'\n[tools.1]\ninsert = 'CNMG120408'");
    let error = machine.set("tools.1.nose_radius=0.4 mm").expect_err("a contradiction");
    assert!(error.message.contains("0.8 mm") && error.message.contains("0.4 mm"), "{error}");
    machine.set("tools.1.holder_designation=PCLNR 2525M12").expect("a good assignment");
    machine.set("tools.1.insert=DNMG150604").expect_err("another insert than the holder takes");
}
