//! The codes that a control has and Chordal does not carry out.

use chordal::control::CONTROLS;
use chordal::control::table::{ControlTable, DataTarget, code_name};

use crate::meaning::codes;
use crate::reference::{cell, table_row};

/// Names and titles of the codes of a control that are not carried out, in order.
pub(super) fn of(table: &ControlTable) -> Vec<(String, &'static str)> {
    let letters = [b'G', b'M'].into_iter();
    let rows = letters.flat_map(|letter| codes(table, letter).iter().map(move |row| (letter, row)));
    rows.filter(|(_, row)| row.action.is_left_out())
        .map(|(letter, row)| (code_name(letter, row.code), row.title))
        .collect()
}

/// Numbers of G10 that write what Chordal does not keep.
pub(super) fn data_of(table: &ControlTable) -> Vec<String> {
    let is_other = |target: DataTarget| {
        matches!(target, DataTarget::Other | DataTarget::IntoRegister | DataTarget::Lines)
    };
    let other = table.set_data.iter().filter(move |(_, target)| is_other(*target));
    other.map(|(number, _)| format!("G10 L{number}")).collect()
}

/// The codes that are not carried out, a row for each meaning on each control: a table in Markdown.
pub fn codes_not_carried_out() -> String {
    let mut text = String::from("| control | codes |\n|---|---|\n");
    for table in CONTROLS {
        let mut meanings: Vec<(&str, Vec<String>)> = Vec::new();
        for (name, title) in of(table) {
            match meanings.iter_mut().find(|(other, _)| *other == title) {
                Some((_, names)) => names.push(name),
                None => meanings.push((title, vec![name])),
            }
        }
        let mut parts: Vec<String> = meanings
            .into_iter()
            .map(|(title, names)| format!("{} ({title})", names.join(", ")))
            .collect();
        let data = data_of(table);
        if !data.is_empty() {
            parts.push(format!("{} (other data)", data.join(", ")));
        }
        if parts.is_empty() {
            parts.push("none".to_string());
        }
        text.push_str(&table_row(&[table.title.to_string(), cell(&parts.join("; "))]));
    }
    text
}
