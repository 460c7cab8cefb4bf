//! The rotary axes of a machine file as a kinematic chain.

mod common;

use chordal_geometry::Vec3;
use chordal_kinematics::{
    ChainError, KinematicChain, RolloverRule, RotaryLetter, RotaryMount, linuxcnc,
};
use chordal_machine::{Axis, KinematicsError, Machine, RotaryTarget, TcpFrame};
use common::{machine, no_files, shown};

fn built_in(name: &str) -> Machine {
    Machine::from_builtin(name).unwrap_or_else(|errors| panic!("{}", shown(&errors)))
}

/// The letters and sides of a chain, from the part to the tool.
fn order(chain: &KinematicChain) -> Vec<(RotaryLetter, RotaryMount)> {
    chain.joints().iter().map(|joint| (joint.letter, joint.side)).collect()
}

const TABLES: &str = r#"
control = "fanuc"
[axes]
X = {}
Y = {}
Z = {}
A = { travel = ["-30 deg", "120 deg"] }
C = {}
[rotary.A]
turns = "table"
point = { Y = "-200 mm", Z = "-400 mm" }
[rotary.C]
turns = "table"
point = { X = "-300 mm", Y = "-200 mm" }
rollover = "sign"
[kinematics]
tcp_frame = "activation"
"#;

fn with(lines: &str) -> Machine {
    let mut changed = machine(TABLES);
    for line in lines.lines() {
        changed.set(line).unwrap_or_else(|error| panic!("{error}"));
    }
    changed
}

fn refused(lines: &str) -> KinematicsError {
    with(lines).kinematic_chain().expect_err("no chain")
}

#[test]
fn two_tables_with_their_travel() {
    use RotaryLetter::{A, C};
    let machine = machine(TABLES);
    let chain = machine.kinematic_chain().expect("a chain");
    assert_eq!(order(&chain), [(C, RotaryMount::Table), (A, RotaryMount::Table)]);
    let [c, a] = chain.joints() else { panic!("two joints") };
    assert_eq!(c.point, Vec3::new(-300.0, -200.0, 0.0));
    assert_eq!(a.point, Vec3::new(0.0, -200.0, -400.0));
    assert_eq!((c.travel, c.rollover), (None, RolloverRule::Sign));
    let (low, high) = a.travel.expect("limits");
    assert!((low.to_degrees() + 30.0).abs() < 1e-12 && (high.to_degrees() - 120.0).abs() < 1e-12);
    assert_eq!(a.rollover, RolloverRule::Linear);
    assert_eq!(machine.tcp_frame, TcpFrame::Activation);
    // A tool 100 long at X10 Y0 Z20 of G54 (-300, -200, -380), with A30 C45.
    let angles = [30_f64.to_radians(), 0.0, 45_f64.to_radians()];
    let tip = Vec3::new(-290.0, -200.0, -360.0);
    let found = chain.gauge_point(tip, &angles, chain.tool_vector(100.0));
    assert!(found.distance(Vec3::new(-292.9289, -186.1237, -261.8234)) < 1e-4, "{found:?}");
}

#[test]
fn what_carries_what() {
    use RotaryLetter::{A, C};
    let chain = |lines: &str| with(lines).kinematic_chain().expect("a chain");
    let turned = chain("rotary.A.on = C\nrotary.C.point.Z = 0 mm\nrotary.A.point.X = 0 mm");
    assert_eq!(order(&turned), [(A, RotaryMount::Table), (C, RotaryMount::Table)]);
    let heads = "rotary.A.turns = head\nrotary.C.turns = head";
    assert_eq!(order(&chain(heads)), [(C, RotaryMount::Head), (A, RotaryMount::Head)]);
    let carried = format!("{heads}\nrotary.C.on = A");
    assert_eq!(order(&chain(&carried)), [(A, RotaryMount::Head), (C, RotaryMount::Head)]);
    let mixed = chain("rotary.C.turns = head");
    assert_eq!(order(&mixed), [(A, RotaryMount::Table), (C, RotaryMount::Head)]);
}

#[test]
fn a_missing_key_is_named() {
    let without = |line: &str| {
        let text = TABLES.replace(line, "");
        machine(&text).kinematic_chain().expect_err("no chain")
    };
    let error = machine(&TABLES.replace("X = \"-300 mm\", ", "")).kinematic_chain();
    let error = error.expect_err("no point");
    assert_eq!(error, KinematicsError::NoPoint { axis: Axis::C, along: Axis::X });
    assert_eq!(error.key().as_deref(), Some("rotary.C.point.X"));
    assert_eq!(error.to_string(), "`rotary.C.point.X` is not given");
    let error = without("point = { Y = \"-200 mm\", Z = \"-400 mm\" }");
    assert_eq!(error, KinematicsError::NoPoint { axis: Axis::A, along: Axis::Y });
    let error =
        without("[rotary.A]\nturns = \"table\"\npoint = { Y = \"-200 mm\", Z = \"-400 mm\" }");
    assert_eq!(error, KinematicsError::NoTarget { axis: Axis::A });
    assert_eq!(error.key().as_deref(), Some("rotary.A.turns"));
    // Along its own axis a point needs no coordinate, but of an inclined axis it needs all.
    let error = refused("rotary.C.direction = [0, 1, 1]");
    assert_eq!(error, KinematicsError::NoPoint { axis: Axis::C, along: Axis::Z });
}

#[test]
fn a_wrong_carrier_is_named() {
    let error = refused("rotary.C.on = B");
    let no_carrier =
        KinematicsError::NoCarrier { axis: Axis::C, carrier: Axis::B, target: RotaryTarget::Table };
    assert_eq!(error, no_carrier);
    assert_eq!(error.to_string(), "`rotary.C.on`: B carries no table of this machine");
    let error = refused("rotary.C.on = A\nrotary.A.turns = head\nrotary.A.point.X = 0 mm");
    assert!(matches!(error, KinematicsError::NoCarrier { axis: Axis::C, carrier: Axis::A, .. }));
    let error = refused("rotary.C.on = A\nrotary.A.on = C");
    assert_eq!(error.key().as_deref(), Some("rotary.C.on"));
    assert_eq!(error.to_string(), "`rotary.C.on` goes in a circle");
    let error = refused("rotary.A.on = A");
    assert_eq!(error, KinematicsError::CarrierCircle { axis: Axis::A });
}

#[test]
fn three_rotary_axes_are_too_many() {
    let point = "rotary.B.point.X = 0 mm\nrotary.B.point.Z = 0 mm";
    let error = refused(&format!("axes.B.max_velocity = 10 deg/s\nrotary.B.turns = head\n{point}"));
    assert_eq!(error, KinematicsError::Chain(ChainError::TooManyJoints { count: 3 }));
    assert_eq!(error.key(), None);
}

#[test]
fn an_axis_that_the_machine_lacks_counts_for_nothing() {
    let umc = built_in("haas-umc750");
    assert!(umc.rotary[0].turns.is_some() && umc.axis(Axis::A).is_none());
    let three = machine("control = \"fanuc\"");
    assert_eq!(three.kinematic_chain(), Ok(KinematicChain::CARTESIAN));
    assert_eq!(with("axes.A = false").kinematic_chain().map(|chain| order(&chain).len()), Ok(1));
}

#[test]
fn the_built_in_five_axis_machines() {
    use RotaryLetter::{A, B, C};
    use RotaryMount::{Head, Table};
    let expected = [
        ("fanuc-head-table", [(C, Table), (B, Head)]),
        ("fanuc-ac-trunnion", [(C, Table), (A, Table)]),
        ("fanuc-nutating-head", [(C, Head), (B, Head)]),
        ("linuxcnc-xyzac-trt", [(C, Table), (A, Table)]),
        ("linuxcnc-xyzbc-trt", [(C, Table), (B, Table)]),
    ];
    for (name, joints) in expected {
        let machine = built_in(name);
        let chain = machine.kinematic_chain().unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(order(&chain), joints, "{name}");
        // With every axis at zero the tool stands upright, below the gauge point.
        let pose = chain.pose(Vec3::ZERO, &[0.0; 3], chain.tool_vector(80.0));
        assert_eq!((pose.tip, pose.direction), (Vec3::Z * -80.0, Vec3::Z), "{name}");
        let again = Machine::from_toml("again.toml", &machine.to_toml(), &no_files);
        assert_eq!(again.as_ref(), Ok(&machine), "{name}");
    }
    // B180 lays the nutating spindle down: 45 degrees on both sides of its axis.
    let nutating = built_in("fanuc-nutating-head").kinematic_chain().expect("a chain");
    let lying = nutating.direction(&[0.0, std::f64::consts::PI, 0.0]);
    assert!(lying.distance(Vec3::Y) < 1e-15, "{lying:?}");
}

#[test]
fn a_built_in_machine_whose_points_differ_from_one_to_the_next_has_none() {
    let along = Axis::X;
    let error = built_in("haas-umc750").kinematic_chain().expect_err("no points");
    assert_eq!(error, KinematicsError::NoPoint { axis: Axis::C, along });
}

#[test]
fn linuxcnc_machines_are_its_kinematics_modules() {
    let chain = |name: &str| built_in(name).kinematic_chain().expect("a chain");
    let parameters =
        |offset| linuxcnc::TrunnionParameters { offset, ..linuxcnc::TrunnionParameters::default() };
    let xyzac = linuxcnc::xyzac_trt(&parameters(Vec3::new(0.0, 20.0, 10.0)));
    let xyzbc = linuxcnc::xyzbc_trt(&parameters(Vec3::new(-20.0, 0.0, -15.0)));
    let angles = [0.3, -0.4, 0.7];
    let tip = Vec3::new(12.0, -7.0, 30.0);
    for (name, module) in [("linuxcnc-xyzac-trt", xyzac), ("linuxcnc-xyzbc-trt", xyzbc)] {
        let module = module.expect("a chain").gauge_point(tip, &angles, Vec3::Z * -50.0);
        let found = chain(name).gauge_point(tip, &angles, Vec3::Z * -50.0);
        assert!(found.distance(module) < 1e-12, "{name}: {found:?} is not {module:?}");
    }
}

#[test]
fn a_file_reads_back_as_it_was_written() {
    let machine =
        with("rotary.C.direction = [0.5, 0, -2]\nrotary.C.on = A\nrotary.C.point.Z = 1 in");
    let text = machine.to_toml();
    for line in [
        "point.X = \"-300 mm\"",
        "point.Z = \"25.4 mm\"",
        "direction = [0.5, 0.0, -2.0]",
        "on = \"A\"",
        "rollover = \"sign\"",
        "[kinematics]\ntcp_frame = \"activation\"",
    ] {
        assert!(text.contains(line), "{line} in\n{text}");
    }
    let again = Machine::from_toml("again.toml", &text, &no_files).expect("what was written");
    assert_eq!(again, machine);
    assert_eq!(again.to_toml(), text);
}

#[test]
fn mistakes_have_their_messages() {
    let error = |assignment: &str| {
        let mut machine = machine(TABLES);
        let error = machine.set(assignment).expect_err("a mistake");
        (error.message, error.help.unwrap_or_default())
    };
    let (message, help) = error("rotary.C.rollover = shortst");
    assert_eq!(message, "`shortst` is not a rule of rollover");
    assert_eq!(help, "did you mean \"shortest\"?");
    let (message, help) = error("rotary.C.on = D");
    assert_eq!(message, "`D` is not a rotary axis");
    assert_eq!(help, "it is one of \"A\", \"B\" or \"C\"");
    let (message, _) = error("kinematics.tcp_frame = part");
    assert_eq!(message, "`part` is not a frame of tool centre point control");
    let form = "write it as `[0, 1, 1]`: its parts along X, Y and Z";
    assert_eq!(
        error("rotary.C.direction = [0, 1]"),
        ("`direction` takes three numbers, not 2".into(), form.into())
    );
    assert_eq!(
        error("rotary.C.direction = [0, 0.0, -0.0]"),
        ("`direction` has no direction: it is zero".into(), form.into())
    );
    assert_eq!(
        error("rotary.C.direction = 3"),
        ("`direction` takes three numbers; this is a whole number".into(), form.into())
    );
    let (message, _) = error("rotary.C.direction = [0, 1, \"a\"]");
    assert_eq!(message, "`direction` takes a number; this is a text");
    let (message, help) = error("rotary.C.pont.X = 1 mm");
    assert_eq!(message, "`rotary.C` has no key `pont`");
    assert_eq!(help, "did you mean `rotary.C.point`?");
    let (message, _) = error("rotary.C.point.X = 1");
    assert!(message.contains("no unit"), "{message}");
}
