//! Machine files that are good: the built-in ones, inheritance, every key, and back to text.

mod common;

use std::f64::consts::{FRAC_PI_6, PI};

use chordal_machine::{
    Axis, ControlName, CustomCodeSpec, Machine, RapidShape, SettingValue, Tool, ToolShape,
    WorkOffset, builtin, builtin_names,
};
use common::{machine, no_files, shown};
use proptest::prelude::*;

fn built_in(name: &str) -> Machine {
    Machine::from_builtin(name).unwrap_or_else(|errors| panic!("{}", shown(&errors)))
}

const INCH_PER_MIN: f64 = 25.4 / 60.0;

#[test]
fn every_built_in_machine_loads() {
    for name in builtin_names() {
        let machine = built_in(name);
        assert_eq!(machine.name, *name);
        assert_ne!(machine.title, *name, "a title for people");
        assert!(builtin(name).is_some_and(|text| text.starts_with('#')), "{name}: a comment first");
        // A lathe may have no Y.
        let axes: &[Axis] = match machine.turns() {
            true => &[Axis::X, Axis::Z],
            false => &[Axis::X, Axis::Y, Axis::Z],
        };
        for axis in axes.iter().copied() {
            let limits = machine.axis(axis).expect("X, Y and Z");
            assert!(limits.travel.is_some() && limits.max_jerk.is_some(), "{name} {axis}");
        }
    }
    assert_eq!(builtin("no such"), None);
}

#[test]
fn what_the_built_in_machines_are() {
    let fadal = built_in("fadal-4020");
    assert_eq!(fadal.control, ControlName::Fadal);
    let x = fadal.axis(Axis::X).expect("an X axis");
    assert_eq!(x.travel, Some((-508.0, 508.0)));
    assert_eq!(x.max_velocity, Some(381.0));
    assert_eq!(fadal.feed.max_mm_per_s, Some(400.0 * 254.0 / 600.0));
    assert!(fadal.axis(Axis::B).is_some_and(|b| b.travel.is_none()));
    assert_eq!(fadal.axis(Axis::C), None);

    let slow = built_in("fadal-400ipm");
    assert!(
        (slow.axis(Axis::Z).expect("Z").max_velocity.expect("a limit") - 400.0 * INCH_PER_MIN)
            .abs()
            < 1e-12
    );
    assert!((slow.feed.max_mm_per_s.expect("a limit") - 250.0 * INCH_PER_MIN).abs() < 1e-12);
    assert_eq!(slow.axis(Axis::Z).map(|z| z.travel), fadal.axis(Axis::Z).map(|z| z.travel));

    let haas = built_in("haas-vf2");
    assert_eq!(haas.spindle_max_rpm, Some(8100.0));
    assert!(haas.axis(Axis::A).is_some() && haas.axis(Axis::B).is_none());

    let type2 = built_in("mitsubishi-m700-type2");
    assert_eq!(type2.settings["#1272 ex08/bit2"].value, SettingValue::Integer(1));
    assert_eq!(type2.settings["#1084 RadErr"].value.as_length_mm(), Ok(0.1));

    let word = |name: &str, key: &str| built_in(name).settings[key].value.clone();
    assert_eq!(
        word("textbook-absolute-center", "arc_center"),
        SettingValue::Text("absolute".into())
    );
    assert_eq!(word("textbook-absolute-center", "units"), SettingValue::Text("inch".into()));
    assert_eq!(
        word("textbook-from-center", "arc_center"),
        SettingValue::Text("from-center".into())
    );
    assert_eq!(word("linuxcnc-mill", "units"), SettingValue::Text("inch".into()));
    assert_eq!(word("fanuc-30i", "units"), SettingValue::Text("mm".into()));
}

const EVERYTHING: &str = r#"
inherits = "haas-vf2"
notes = "a remark"
[axes]
A = false
B = { travel = ["-110 deg", "30 deg"], max_velocity = "30 rpm" }
[axes.X]
max_velocity = "900 ipm"
[feed]
max_rotary = "0.5 rev/s"
[rapid]
shape = "Straight"
[spindle]
max = "125 rev/s"
[tools.5]
diameter = '0.75"'
diameter_wear = "-10 um"
length = "0.1 m"
kind = "end mill"
[tools.12]
[work_offsets.g54]
X = "10 in"
B = "90 deg"
[work_offsets."G54.1P01"]
Y = "1 ft"
[work_offsets.G110]
Z = "-2.5cm"
[home]
Z = "-1 mm"
[reference_points.4]
X = "1 mm"
[switches]
block_delete = [1, 3]
optional_stop = true
[program]
clearance = "0.1 in"
[times]
tool_change = "0.1 min"
[settings]
"Setting 58" = "fanuc"
"Setting 43" = 0x10
"Setting 335" = true
factor = 1.0
[shop_codes.M120]
time = "2500 ms"
label = "part flip"
[shop_codes.M0121]
"#;

#[test]
fn every_key() {
    let m = machine(EVERYTHING);
    assert_eq!(m.name, "mine");
    assert_eq!(m.title, "Haas VF-2");
    assert_eq!(m.notes, ["a remark"]);
    assert_eq!(m.control, ControlName::Haas);
    assert_eq!(m.axis(Axis::A), None);
    let b = m.axis(Axis::B).expect("a B axis");
    assert_eq!(b.travel, Some((-110.0 * PI / 180.0, FRAC_PI_6)));
    assert_eq!(b.max_velocity, Some(PI));
    let x = m.axis(Axis::X).expect("an X axis");
    assert_eq!(x.max_velocity, Some(381.0));
    assert_eq!(x.travel, Some((-762.0, 0.0)));
    assert_eq!(x.max_jerk, Some(100_000.0));
    assert_eq!(m.feed.max_rad_per_s, Some(PI));
    assert_eq!(m.rapid, Some(RapidShape::Straight));
    assert_eq!(m.spindle_max_rpm, Some(7500.0));
    assert_eq!(
        m.tools[&5],
        Tool {
            diameter_mm: Some(19.05),
            diameter_wear_mm: Some(-0.01),
            offset: [None, None, Some(100.0), None, None, None],
            shape: Some(ToolShape::Flat),
            description: Some("end mill".into()),
            ..Tool::default()
        }
    );
    assert_eq!(m.tools[&12], Tool::default());
    let mut g54 = WorkOffset::default();
    g54.values[Axis::X as usize] = Some(254.0);
    g54.values[Axis::B as usize] = Some(PI / 2.0);
    assert_eq!(m.work_offsets["G54"], g54);
    assert_eq!(m.work_offsets["G54.1 P1"].values[1], Some(304.8));
    assert_eq!(m.work_offsets["G154 P1"].values[2], Some(-25.0));
    assert_eq!(m.home, [Some(0.0), Some(0.0), Some(-1.0), None, None, None]);
    assert_eq!(m.reference_points[2][0], Some(1.0));
    let on: Vec<usize> = (0..10).filter(|at| m.switches.block_delete[*at]).collect();
    assert_eq!(on, [0, 1, 3]);
    assert!(m.switches.optional_stop);
    assert_eq!(m.clearance_mm, Some(2.54));
    assert_eq!(m.times.tool_change_s, Some(6.0));
    let flip = CustomCodeSpec {
        time_s: Some(2.5),
        label: Some("part flip".into()),
        ..CustomCodeSpec::default()
    };
    assert_eq!(m.shop_codes[&120], flip);
    assert_eq!(m.shop_codes[&121], CustomCodeSpec::default());
    let setting = &m.settings["Setting 58"];
    assert_eq!(setting.value, SettingValue::Text("fanuc".into()));
    let location = setting.location.as_ref().expect("a place");
    assert_eq!(&*location.file, "shop/mine.toml");
    assert_eq!(&location.text[location.span.clone()], "\"fanuc\"");
    assert_eq!(m.settings["Setting 43"].value, SettingValue::Integer(16));
    assert_eq!(m.settings["Setting 335"].value, SettingValue::Bool(true));
    assert_eq!(m.settings["factor"].value, SettingValue::Float(1.0));
}

#[test]
fn a_control_alone_is_a_machine() {
    let m = machine("control = \"FADAL\"");
    assert_eq!(m, Machine::new("mine", ControlName::Fadal));
    assert!(m.axis(Axis::Z).is_some() && m.axis(Axis::A).is_none());
    assert_eq!(m.title, "mine");
}

#[test]
fn a_file_inherits_key_by_key() {
    let base = r#"
control = "haas"
name = "the base"
[tools.5]
diameter = "0.5 in"
length = "3 in"
[work_offsets.G54]
X = "1 mm"
[settings]
"Setting 58" = "yasnac"
"Setting 40" = "radius"
"#;
    let child = r#"
inherits = "base.toml"
[tools.5]
diameter = "0.25 in"
[work_offsets.G54]
Y = "2 mm"
[settings]
"SETTING 58" = "fanuc"
"#;
    let machine = Machine::from_toml("shop/vmc.toml", child, &|name| {
        assert_eq!(name, "shop/base.toml");
        Ok(base.to_string())
    });
    let m = machine.expect("a good file");
    assert_eq!(m.name, "vmc");
    assert_eq!(m.tools[&5].diameter_mm, Some(6.35));
    assert_eq!(m.tools[&5].length_mm(), Some(76.2));
    assert_eq!(m.work_offsets["G54"].values[..2], [Some(1.0), Some(2.0)]);
    let settings: Vec<&str> = m.settings.keys().map(String::as_str).collect();
    assert_eq!(settings, ["SETTING 58", "Setting 40"]);
    let file = |key: &str| m.settings[key].location.as_ref().map(|l| l.file.to_string());
    assert_eq!(file("Setting 40").as_deref(), Some("shop/base.toml"));
    assert_eq!(file("SETTING 58").as_deref(), Some("shop/vmc.toml"));
}

fn there_and_back(machine: &Machine) {
    let text = machine.to_toml();
    match Machine::from_toml("other.toml", &text, &no_files) {
        Ok(again) => assert_eq!(again, *machine, "\n{text}"),
        Err(errors) => panic!("{}\n{text}", shown(&errors)),
    }
}

#[test]
fn written_machines_read_back() {
    for name in builtin_names() {
        there_and_back(&built_in(name));
    }
    there_and_back(&machine(EVERYTHING));
    let mut odd = machine("control = \"fadal\"\n[switches]\nblock_delete = true");
    odd.notes = vec!["\"quotes\", \\ and\nlines\u{7f}\u{1}\r".into(), String::new()];
    odd.axes[Axis::Y as usize] = None;
    there_and_back(&odd);
}

/// Machine files hold no larger lengths than 1e30 mm.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![any::<i32>().prop_map(f64::from), -1e6..1e6, -1e-6..1e-6, -1e30..1e30]
}

#[test]
fn values_without_measure_are_refused() {
    let set = |assignment: &str| machine("control = \"fadal\"").set(assignment).map_err(|_| ());
    for (key, unit) in
        [("home.X", "mm"), ("axes.X.max_velocity", "in/min"), ("axes.A.max_jerk", "deg/s^3")]
    {
        for value in ["1e308", "1e999", "9e200", "1e32"] {
            assert_eq!(set(&format!("{key}=\"{value} {unit}\"")), Err(()), "{key} {value}");
        }
        assert_eq!(set(&format!("{key}=\"1e25 {unit}\"")), Ok(()), "{key}");
    }
    assert_eq!(set("home.X=\"-1e308 mm\""), Err(()));
}

proptest! {
    #[test]
    fn any_machine_reads_back(
        title in any::<String>(),
        tools in prop::collection::btree_map(any::<u32>(), (prop::option::of(number()), prop::option::of(any::<String>())), 0..5),
        offsets in prop::collection::btree_map(1..49u32, prop::array::uniform6(prop::option::of(number())), 0..5),
        home in prop::array::uniform6(prop::option::of(number())),
        settings in prop::collection::btree_map("[a-z#./ \"'=\\\\é]{0,12}", prop_oneof![
            any::<String>().prop_map(SettingValue::Text),
            any::<i64>().prop_map(SettingValue::Integer),
            number().prop_map(SettingValue::Float),
            any::<bool>().prop_map(SettingValue::Bool),
        ], 0..6),
        travel in (number(), number()),
        jerk in 1e-9..1e12,
    ) {
        let mut machine = Machine::new("any", ControlName::Mitsubishi);
        // An empty title is none.
        machine.title = format!("t{title}");
        for (number, (length, comment)) in tools {
            let mut tool = Tool { comment, ..Tool::default() };
            tool.offset[Axis::Z as usize] = length;
            machine.tools.insert(number, tool);
        }
        for (number, values) in offsets {
            machine.work_offsets.insert(format!("E{number}"), WorkOffset { values });
        }
        machine.home = home;
        for (name, value) in settings {
            machine.settings.insert(name, chordal_machine::SettingEntry { value, location: None });
        }
        for axis in [Axis::Y, Axis::C] {
            let limits = machine.axes[axis as usize].get_or_insert_default();
            limits.travel = (travel.0 < travel.1).then_some(travel);
            limits.max_jerk = Some(jerk);
        }
        there_and_back(&machine);
    }
}
