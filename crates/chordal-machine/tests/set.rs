//! Assignments, as a command line gives them.

use chordal_machine::{AXES, Axis, ControlName, Machine, SettingValue};

fn haas() -> Machine {
    Machine::from_builtin("haas-vf2").expect("a built-in machine")
}

fn after(assignment: &str) -> Machine {
    let mut machine = haas();
    if let Err(error) = machine.set(assignment) {
        panic!("{assignment}: {error}");
    }
    machine
}

fn refused(assignment: &str) -> (String, String, Option<String>) {
    let mut machine = haas();
    let error = machine.set(assignment).expect_err(assignment);
    assert_eq!(machine, haas(), "unchanged");
    (error.message.clone(), error.underlined().to_string(), error.help)
}

#[test]
fn a_quantity_with_quotes_or_without() {
    for text in [
        r#"tools.5.diameter="0.5 in""#,
        "tools.5.diameter='0.5 in'",
        "tools.5.diameter=0.5 in",
        " tools . 5 . diameter = 0.5\" ",
        "tools.\"5\".diameter=12.7mm",
        "tools.5={diameter=\"0.5 in\"}",
    ] {
        assert_eq!(after(text).tools[&5].diameter_mm, Some(12.7), "{text}");
    }
}

#[test]
fn other_values() {
    assert_eq!(after("control=fanuc").control, ControlName::Fanuc);
    assert_eq!(after("tools.5.comment=5").tools[&5].comment.as_deref(), Some("5"));
    assert_eq!(after("title=the second = one").title, "the second = one");
    assert_eq!(after("notes=[\"a\", \"b\"]").notes, ["a", "b"]);
    assert!(after("switches.block_delete=[2]").switches.block_delete[2]);
    assert!(after("switches.optional_stop = true").switches.optional_stop);
    assert_eq!(after("axes.A=false").axis(Axis::A), None);
    for text in ["axes.Y.travel=[-1 in, 1 in]", "axes.Y.travel=[\"-1 in\", \"1 in\"]"] {
        assert_eq!(after(text).axis(Axis::Y).expect("Y").travel, Some((-25.4, 25.4)), "{text}");
    }
    // Only what is named changes.
    assert_eq!(after("axes.Y.travel=[-1 in, 1 in]").axis(Axis::Y).expect("Y").max_jerk, Some(1e5));
}

#[test]
fn a_shop_code_by_its_number() {
    let code = |text: &str| after(text).shop_codes[&120].clone();
    assert_eq!(code("shop_codes.M120.time=2.5 s").time_s, Some(2.5));
    assert_eq!(code("shop_codes.m120.label=part flip").label.as_deref(), Some("part flip"));
    for key in ["120", "G120", "M", "M6554", "M1.5"] {
        let (message, _, help) = refused(&format!("shop_codes.\"{key}\".time=2 s"));
        assert_eq!(message, format!("`{key}` is not an M code or a program"));
        assert!(help.is_some_and(|help| help.contains("shop_codes.M120")));
    }
    let (message, ..) = refused("shop_codes.M120.time=-1 s");
    assert_eq!(message, "`shop_codes.M120.time` cannot be negative");
}

#[test]
fn a_program_that_no_file_holds_by_its_call() {
    for key in
        ["O9810", "o9810", "\"G65 P9810\"", "\"G66 P9810\"", "\"M98P9810\"", "\"G66.1 P9810\""]
    {
        let machine = after(&format!("shop_codes.{key}.blocks=G1 X#24"));
        assert_eq!(machine.shop_programs[&9810].blocks.as_deref(), Some("G1 X#24"), "{key}");
        assert!(machine.answers_with_blocks());
        let again = Machine::from_toml("again.toml", &machine.to_toml(), &|_| Err(String::new()));
        assert_eq!(again.expect("its own text").shop_programs, machine.shop_programs);
    }
    for key in ["O", "P9810", "G65", "G65 P", "O1.5"] {
        let (message, ..) = refused(&format!("shop_codes.\"{key}\".time=2 s"));
        assert_eq!(message, format!("`{key}` is not an M code or a program"));
    }
    assert!(!after("shop_codes.O9810.time=2 s").answers_with_blocks());
}

#[test]
fn settings_by_any_name() {
    let value = |text: &str, name: &str| after(text).settings[name].value.clone();
    let text = |text: &str| SettingValue::Text(text.to_string());
    assert_eq!(value("settings.\"Setting 58\"=fanuc", "Setting 58"), text("fanuc"));
    assert_eq!(value("settings.Setting 58=fanuc", "Setting 58"), text("fanuc"));
    assert_eq!(value("settings.#1272 ex08/bit2=1", "#1272 ex08/bit2"), SettingValue::Integer(1));
    assert_eq!(value("settings.No. 3410=0.01 mm", "No. 3410"), text("0.01 mm"));
    assert_eq!(value("settings.\"a=b\"=on", "a=b"), text("on"));
    assert_eq!(value("settings.x=1.5", "x"), SettingValue::Float(1.5));
    assert_eq!(value("settings.x=\"1.5\"", "x"), text("1.5"));
    let machine = after("settings.Setting 58=fanuc");
    let location = machine.settings["Setting 58"].location.clone().expect("a place");
    assert_eq!(&location.text[location.span], "fanuc");
}

#[test]
fn work_offsets_by_any_name() {
    for text in ["work_offsets.G59.1.X=1 in", "work_offsets.\"G59.1\".X = \"1 in\""] {
        assert_eq!(after(text).work_offsets["G59.1"].values[0], Some(25.4), "{text}");
    }
    assert_eq!(
        after("work_offsets.G54.1 P7.B=90 deg").work_offsets["G54.1 P7"].values[4],
        Some(std::f64::consts::FRAC_PI_2)
    );
}

#[test]
fn refusals() {
    let some = |text: &str| Some(text.to_string());
    assert_eq!(
        refused("tools.5.diametre=0.5 in"),
        (
            "`tools.5` has no key `diametre`".into(),
            "diametre".into(),
            some("did you mean `tools.5.diameter`?")
        )
    );
    assert_eq!(
        refused("feed.max = 25"),
        (
            "`feed.max` takes a velocity; `25` has no unit".into(),
            "25".into(),
            some(
                "write it with its unit: \"25 in/min\", \"25 mm/min\", \"25 m/min\" or \"25 mm/s\""
            )
        )
    );
    assert_eq!(refused("axes.X.travel=[0 mm, 5 s]").1, "5 s", "the item in the list is underlined");
    for (text, part) in [
        ("", "needs a `=`"),
        ("fast", "needs a `=`"),
        ("=5", "a key is missing"),
        ("tools..diameter=5", "a key is missing"),
        ("control=", "has no value"),
        ("control=hass", "not a control"),
        ("control=\"haas", "string"),
        ("inherits=haas-vf2", "cannot be changed later"),
        ("feed=5", "is a table"),
        ("axes.A=true true", "is a table"),
        ("\"feed\"x.max=5", "not a quoted key"),
    ] {
        let (message, ..) = refused(text);
        assert!(message.contains(part), "{text}: {message}");
    }
}

#[test]
fn variables_date_and_time_of_macro_programs() {
    let mut machine = Machine::from_builtin("haas-vf2").unwrap();
    machine.set("macros.variables.500 = 1.5").unwrap();
    machine.set("macros.variables.#1001 = 1").unwrap();
    machine.set("macros.date = 2024-05-17").unwrap();
    machine.set("macros.time=13:45:00").unwrap();
    assert_eq!(machine.macros.variables.get(&500), Some(&1.5));
    assert_eq!(machine.macros.variables.get(&1001), Some(&1.0));
    assert_eq!(machine.macros.date, Some(20_240_517));
    assert_eq!(machine.macros.time, Some(134_500));
    let text = machine.to_toml();
    let again = Machine::from_toml("again.toml", &text, &|_| Err(String::new())).unwrap();
    assert_eq!(again.macros, machine.macros);
    for wrong in [
        "macros.variables.500 = yes",
        "macros.variables.x = 1",
        "macros.variables.0 = 1",
        "macros.date = 17.5.2024",
        "macros.date = 2024-13-01",
        "macros.time = 24:00:00",
        "macros.day = 1",
    ] {
        assert!(machine.set(wrong).is_err(), "{wrong}");
    }
}

#[test]
fn probes_and_answers() {
    use chordal_machine::ProbeHit;

    let mut machine = Machine::new("m", "fadal".parse().unwrap());
    machine.set("macros.inputs=[1.5, 2]").unwrap();
    machine.set("probe.hit.Z=-10 mm").unwrap();
    assert_eq!(machine.macros.inputs, [1.5, 2.0]);
    assert_eq!(machine.probe.planes[2], Some(-10.0));
    let again = |machine: &Machine| {
        Machine::from_toml("again.toml", &machine.to_toml(), &|_| Err(String::new())).unwrap()
    };
    assert_eq!(again(&machine).probe, machine.probe);
    assert_eq!(again(&machine).macros, machine.macros);
    // A word takes the planes away, and a plane the word.
    machine.set("probe.hit=none").unwrap();
    assert_eq!((machine.probe.hit, machine.probe.planes), (Some(ProbeHit::Nothing), [None; AXES]));
    assert_eq!(again(&machine).probe, machine.probe);
    machine.set("probe.hit=end").unwrap();
    assert_eq!(again(&machine).probe.hit, Some(ProbeHit::End));
    machine.set("probe.hit.X=1 in").unwrap();
    assert_eq!((machine.probe.hit, machine.probe.planes[0]), (None, Some(25.4)));
    for wrong in ["probe.hit=perhaps", "probe.hit.Z=-10", "macros.inputs=1", "macros.inputs=[a]"] {
        assert!(machine.set(wrong).is_err(), "{wrong}");
    }
    let text = "control = \"haas\"\n[probe]\nhit = { Z = \"-10 mm\" }\n";
    let read = Machine::from_toml("m.toml", text, &|_| Err(String::new())).unwrap();
    assert_eq!(read.probe.planes[2], Some(-10.0));
}
