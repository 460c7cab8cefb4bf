//! No text makes anything panic, and every error's span lies within its text.

mod common;

use chordal_machine::{
    ControlName, Machine, QuantityDimension, parse_quantity, read_tool_tbl, work_offset_name,
};
use proptest::prelude::*;

/// Pieces of machine files in any order.
fn pieces() -> impl Strategy<Value = String> {
    let piece = prop::sample::select(vec![
        "[",
        "]",
        "[[",
        "]]",
        "=",
        ".",
        ",",
        "\n",
        "\n",
        " ",
        "\"",
        "'",
        "{",
        "}",
        "#",
        "\\",
        "\r",
        "axes",
        "X",
        "A",
        "travel",
        "max_velocity",
        "feed",
        "max",
        "tools",
        "5",
        "-3",
        "0x1F",
        "1e9",
        "inherits",
        "control",
        "haas",
        "\"haas-vf2\"",
        "\"loop\"",
        "work_offsets",
        "G54",
        "\"G59.1\"",
        "settings",
        "\"Setting 58\"",
        "\"0.5 in\"",
        "\"25 m/min\"",
        "switches",
        "block_delete",
        "true",
        "inf",
        "nan",
        "1979-05-27",
        "µ",
        "é",
        "notes",
        "home",
        "reference_points",
        "2",
        "\u{0}",
    ]);
    prop::collection::vec(piece, 0..40).prop_map(|pieces| pieces.concat())
}

fn read(text: &str) {
    let loader = |name: &str| match name {
        "loop" => Ok(text.to_string()),
        _ => Err("no file".to_string()),
    };
    if let Err(errors) = Machine::from_toml("x.toml", text, &loader) {
        assert!(!errors.is_empty());
        for error in errors {
            if let Some(span) = error.span {
                assert!(error.text.get(span).is_some(), "{}", error.message);
            }
        }
    }
}

fn set(text: &str) {
    let mut machine = Machine::new("x", ControlName::Haas);
    if let Err(error) = machine.set(text)
        && let Some(span) = error.span
    {
        assert!(error.text.get(span).is_some(), "{}", error.message);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    #[test]
    fn machine_files(text in prop_oneof![pieces(), any::<String>()]) {
        read(&text);
    }

    #[test]
    fn assignments(text in prop_oneof![pieces(), any::<String>()], value in pieces()) {
        set(&text);
        for key in ["axes.X", "axes.A.travel", "settings.x", "notes", "tools.5.kind", "work_offsets.G54"] {
            set(&format!("{key}={value}"));
            set(&format!("{key}.{text}={value}"));
        }
    }

    #[test]
    fn small_texts(text in any::<String>(), number in "[-+]?[0-9.]{0,9}[eE]?[-+]?[0-9]{0,22}", unit in "[ a-zµ°²^/0-9\"]{0,8}") {
        for dimension in [QuantityDimension::Length, QuantityDimension::SpindleSpeed, QuantityDimension::AngularJerk] {
            let _ = parse_quantity(&text, dimension).map_err(|error| (error.to_string(), error.help()));
            if let Ok(value) = parse_quantity(&format!("{number}{unit}"), dimension) {
                prop_assert!(value.is_finite());
            }
        }
        let _ = work_offset_name(&text);
        let _ = read_tool_tbl(&text, true);
        let _ = read_tool_tbl(&format!("T1 D{number} {text}\n{unit}"), false);
    }
}
