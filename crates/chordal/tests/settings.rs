//! Settings of machine files: what is listed can be written, and means what it says.

use chordal::control::{COMMON_SETTINGS, Control};
use chordal::machine::{Machine, builtin_names};

#[test]
fn every_listed_value_can_be_written_back() {
    for name in builtin_names() {
        let machine = Machine::from_builtin(name).expect("a built-in machine");
        // Other languages have settings of their own.
        let Some((control, errors)) = Control::of(&machine) else { continue };
        assert!(errors.is_empty(), "{name}: {errors:?}");
        for setting in control.table.settings.iter().chain(COMMON_SETTINGS) {
            let value = setting.field.value_text(&control.parameters);
            if value == "no limit" {
                continue;
            }
            let mut changed = machine.clone();
            let assignment = match value.parse::<f64>() {
                Ok(_) => format!("settings.\"{}\"={value}", setting.name),
                Err(_) => format!("settings.\"{}\"=\"{value}\"", setting.name),
            };
            changed.set(&assignment).unwrap_or_else(|e| panic!("{assignment}: {e}"));
            let (again, errors) = Control::of(&changed).expect("a word-address control");
            assert!(errors.is_empty(), "{name}, {assignment}: {errors:?}");
            assert_eq!(setting.field.value_text(&again.parameters), value, "{assignment}");
        }
    }
}

#[test]
fn the_manuals_own_words_are_taken() {
    for (machine, assignment, setting) in [
        ("haas-vf2", "settings.\"Setting 58\"=yasnac", "outside_corner=arc"),
        ("haas-vf2", "settings.\"Setting 162\"=on", "decimal_point=calculator"),
        ("haas-vf2", "settings.\"Setting 40\"=radius", "radius_offsets=radius"),
        ("fanuc-30i", "settings.\"No. 1403#5\"=1", "helix_feed=path"),
        ("fanuc-30i", "settings.\"No. 3410\"=\"0.02 mm\"", "radius_error_tolerance=0.02 mm"),
        ("mitsubishi-m700", "settings.\"#1272 ex08/bit2\"=1", "spiral=increment-height-count"),
        ("fadal-4020", "settings.format=2", "format=off"),
        ("fanuc-30i", "settings.\"No. 5003#0\"=1", "compensation_entry=B"),
        ("fanuc-30i", "settings.\"No. 5003#1\"=1", "compensation_alone=perpendicular"),
        ("fanuc-30i", "settings.\"No. 5008#1\"=1", "compensation_interference=arc-angle"),
        ("fanuc-30i", "settings.\"No. 5008#3\"=1", "compensation_check=off"),
        ("fanuc-30i", "settings.\"No. 19625\"=8", "compensation_idle_blocks=6"),
        ("fanuc-30i", "settings.\"No. 19607#2\"=1", "outside_corner=arc"),
        ("fanuc-30i", "settings.\"No. 19607#5\"=1", "compensation_remedy=avoid"),
        ("mitsubishi-m700", "settings.\"#1229 set01/bit2\"=1", "compensation_entry=B"),
        ("mitsubishi-m700", "settings.\"#8102\"=1", "compensation_remedy=avoid"),
        ("mitsubishi-m700", "settings.\"#8103\"=1", "compensation_check=off"),
        ("haas-vf2", "settings.\"Setting 43\"=B", "compensation_entry=B"),
    ] {
        let mut machine = Machine::from_builtin(machine).expect("a built-in machine");
        machine.set(assignment).unwrap_or_else(|e| panic!("{assignment}: {e}"));
        let (control, errors) = Control::of(&machine).expect("a word-address control");
        assert!(errors.is_empty(), "{assignment}: {errors:?}");
        let (name, value) = setting.split_once('=').expect("a name and a value");
        let all = control.table.settings.iter().chain(COMMON_SETTINGS);
        let field = all.into_iter().find(|s| s.name == name).expect("a setting").field;
        assert_eq!(field.value_text(&control.parameters), value, "{assignment}");
    }
}

#[test]
fn an_unknown_setting_is_refused_with_the_nearest() {
    let mut machine = Machine::from_builtin("haas-vf2").expect("a built-in machine");
    machine.set("settings.\"Setting 85X\"=1").expect("any name can be written");
    let (_, errors) = Control::of(&machine).expect("a word-address control");
    assert_eq!(errors.len(), 1);
    assert!(errors[0].message.contains("Setting 85X"), "{errors:?}");
}
