//! Each key of the schema is written, and reads back as it was.

use super::*;
use crate::schema::{SchemaRow, SchemaSlot, rows};

/// A value of a row, and what its placeholders may be.
fn assignments(row: &SchemaRow) -> Vec<String> {
    let value = match &row.slot {
        SchemaSlot::Quantity { dimension, .. } => format!("\"2.5 {}\"", dimension.inside()),
        SchemaSlot::Position(_) => "\"-3.5 mm\"".to_string(),
        SchemaSlot::Range(_) => "[\"-10 mm\", \"20 mm\"]".to_string(),
        SchemaSlot::Count { to, .. } => to.to_string(),
        SchemaSlot::Solids(_) => "[[\"4 mm\", \"5 mm\"], [\"4 mm\", \"5 mm\", \"6 mm\"]]".into(),
        SchemaSlot::Profile(_) => "[[\"0 mm\", \"1 mm\"], [\"2 mm\", \"3 mm\"]]".to_string(),
        SchemaSlot::Outline(_) => {
            "[[\"0 mm\", \"1 mm\"], [\"-2 mm\", \"3 mm\"], [\"2 mm\", \"9 mm\"]]".to_string()
        }
        SchemaSlot::Contour(_) => {
            "[[\"0 mm\", \"1 mm\"], [\"20 mm\", \"3 mm\", \"-15 mm\"]]".to_string()
        }
        SchemaSlot::Programmed => "\"diameter\"".to_string(),
        SchemaSlot::Word { words, .. } => format!("\"{}\"", words[words.len() - 1]),
        SchemaSlot::Insert => "\"CNMG120408\"".to_string(),
        SchemaSlot::HolderDesignation => "\"PCLNR2525M12\"".to_string(),
        SchemaSlot::Flag(_) => "true".to_string(),
        SchemaSlot::Switches => "[2, 7]".to_string(),
        SchemaSlot::Number(_) | SchemaSlot::Override(_) => "0.5".to_string(),
        SchemaSlot::Within { dimension: Some(dimension), from, .. } => {
            format!("\"{from} {}\"", dimension.inside())
        }
        SchemaSlot::Within { dimension: None, to, .. } => to.to_string(),
        SchemaSlot::Direction(_) => "[0, 0.5, -2]".to_string(),
        SchemaSlot::NumberList(_) => "[1.5, -2]".to_string(),
        SchemaSlot::Stamp { stamp, .. } => format!("\"{}\"", stamp.words().1),
        SchemaSlot::TextList(_) => "[\"one\", \"\"]".to_string(),
        SchemaSlot::Text(_)
        | SchemaSlot::OptionalText(_)
        | SchemaSlot::File(_)
        | SchemaSlot::Setting
        | SchemaSlot::Kind => "\"a \\\"text\\\"\"".to_string(),
        SchemaSlot::Inherits
        | SchemaSlot::Table(_)
        | SchemaSlot::ShopCode
        | SchemaSlot::Body(_)
        | SchemaSlot::Axis => return Vec::new(),
    };
    let keys: [(&str, &[&str]); 9] = [
        ("<axis>", &["X", "Y", "Z"]),
        ("<rotary>", &["A", "C"]),
        ("<tool>", &["7", "12"]),
        ("<variable>", &["500", "\"<_name>\""]),
        ("<code>", &["M120", "O9810"]),
        ("<point>", &["2", "4"]),
        ("<offset>", &["G54", "\"G54.1 P7\""]),
        ("<name>", &["vise", "\"a clamp\""]),
        ("<setting>", &["plain", "\"No. 5\""]),
    ];
    let mut paths = vec![row.path.to_string()];
    for (placeholder, names) in keys {
        if row.path.contains(placeholder) {
            let with =
                |path: &String| names.iter().map(|name| path.replace(placeholder, name)).collect();
            paths = paths.iter().flat_map(|path| -> Vec<String> { with(path) }).collect();
        }
    }
    paths.into_iter().map(|path| format!("{path} = {value}")).collect()
}

fn reads_back(machine: &Machine, what: &str) {
    let text = machine.to_toml();
    let no_files = |name: &str| Err(format!("no file {name}"));
    let again = Machine::from_toml("again.toml", &text, &no_files);
    assert_eq!(again.as_ref(), Ok(machine), "{what}\n{text}");
}

#[test]
fn each_key_of_the_schema_is_written() {
    let fresh = Machine::new("fresh", crate::ControlName::Fanuc);
    for row in rows() {
        for assignment in assignments(row) {
            let mut machine = fresh.clone();
            machine.set(&assignment).unwrap_or_else(|error| panic!("{assignment}: {error}"));
            assert_ne!(machine, fresh, "{assignment}");
            reads_back(&machine, &assignment);
        }
    }
}

#[test]
fn a_place_is_the_same_whether_its_axis_becomes_a_diameter_before_or_after() {
    for row in rows() {
        for assignment in assignments(row) {
            let after = |assignments: [&str; 2]| {
                let mut machine = Machine::new("fresh", crate::ControlName::Fanuc);
                for assignment in assignments {
                    machine.set(assignment).unwrap_or_else(|error| panic!("{error}"));
                }
                machine
            };
            for axis in ["X", "Z"] {
                let diameter = format!("axes.{axis}.programmed = diameter");
                let before = after([&diameter, &assignment]);
                assert_eq!(after([&assignment, &diameter]), before, "{assignment}");
            }
        }
    }
}

#[test]
fn all_keys_of_the_schema_are_written_together() {
    let mut machine = Machine::new("all", crate::ControlName::Fanuc);
    for assignment in rows().flat_map(assignments) {
        // Keys of one tool that contradict each other are refused, and so left out.
        let _ = machine.set(&assignment);
    }
    reads_back(&machine, "all keys");
}
