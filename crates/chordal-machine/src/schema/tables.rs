//! The tables and keys of a machine file, in the order in which they are written.

use super::{PlaceholderKeys, SchemaRow, SchemaSlot, bind, children, rows};
use crate::axis::Axis;
use crate::machine::Machine;
use crate::toml_text::key_text;

/// The tables in the order of a written file, after the keys that are in no table.
const TABLE_ORDER: &str = "axes.<axis> rotary.<rotary> kinematics solids.<name> feed rapid spindle home reference_points.<point> \
     switches program motion times shop_codes.<code> macros macros.variables probe probe.hit \
     tools.<tool> stock fixtures.<name> target materials.<name> work_offsets.<offset> settings";

/// The keys that are first in a table; the others follow in the order of the schema.
const FIRST_KEYS: [(&str, &str); 5] = [
    ("axes.<axis>", "programmed"),
    (
        "tools.<tool>",
        "diameter diameter_wear offset offset_wear shape corner_radius point_angle tip_diameter pitch \
         nose_radius teeth tip max_chip min_chip profile flute_length shank_diameter shank holder insert \
         holder_designation facing insert_angle approach_angle width lead_angle bar_offset holder_outline",
    ),
    ("stock", BODY_KEYS),
    ("fixtures.<name>", BODY_KEYS),
    ("target", BODY_KEYS),
];

const BODY_KEYS: &str = "shape work_offset file unit material axis turned_over from to contour";

/// The tables of a file, the first of them the file itself.
pub(crate) fn tables() -> impl Iterator<Item = &'static str> {
    std::iter::once("").chain(TABLE_ORDER.split(' '))
}

/// A possible key of a table: its text, its row, and the values of its placeholders.
pub(crate) type TableKey = (String, &'static SchemaRow, PlaceholderKeys);

/// The tables of a machine for a path with a placeholder, each with its possible keys.
pub(crate) fn written_tables(machine: &Machine, table: &str) -> Vec<(String, Vec<TableKey>)> {
    let rows = rows_of(table);
    let keys_of = |keys: &PlaceholderKeys| {
        let of_row = |(path, row): &(&'static str, &'static SchemaRow)| {
            let row = *row;
            let texts = written_keys(machine, table, path, keys).into_iter();
            texts.map(move |(text, keys)| (text, row, keys))
        };
        rows.iter().flat_map(of_row).collect()
    };
    let tables = written_keys(machine, "", table, &PlaceholderKeys::default()).into_iter();
    tables.map(|(name, keys)| (name, keys_of(&keys))).collect()
}

/// The rows of the keys of a table in the order in which they are written, each with its path in the table.
pub(crate) fn rows_of(table: &str) -> Vec<(&'static str, &'static SchemaRow)> {
    let within = |table: &str, path: &'static str| match table {
        "" => Some(path),
        _ => path.strip_prefix(table)?.strip_prefix('.'),
    };
    let inner: Vec<&str> =
        tables().filter(|other| *other != table && within(table, other).is_some()).collect();
    let is_own = |row: &SchemaRow| inner.iter().all(|other| within(other, row.path).is_none());
    let mut rows: Vec<_> = rows()
        .filter_map(|row| Some((within(table, row.path)?, row)))
        .filter(|(_, row)| is_own(row) && row.is_written())
        .collect();
    let first_keys = FIRST_KEYS.iter().find(|(own, _)| *own == table).map_or("", |(_, keys)| keys);
    rows.sort_by_key(|(path, _)| {
        let name = path.split('.').next();
        first_keys.split(' ').position(|key| Some(key) == name).unwrap_or(usize::MAX)
    });
    rows
}

/// The text of a path in its table; if it ends with a placeholder, one for each key that the machine has.
fn written_keys(
    machine: &Machine,
    table: &str,
    path: &str,
    keys: &PlaceholderKeys,
) -> Vec<(String, PlaceholderKeys)> {
    let Some(start) = path.find('<') else { return vec![(path.to_string(), keys.clone())] };
    let (before, placeholder) = path.split_at(start);
    let bound = |name: String| {
        let mut keys = keys.clone();
        bind(placeholder, &name, &mut keys).ok()?;
        Some((format!("{before}{}", key_text(&name)), keys))
    };
    names(machine, table, path).into_iter().filter_map(bound).collect()
}

/// The keys that a machine has for the placeholder at the end of a path.
fn names(machine: &Machine, table: &str, path: &str) -> Vec<String> {
    fn texts(names: impl Iterator<Item = impl ToString>) -> Vec<String> {
        names.map(|name| name.to_string()).collect()
    }
    let (macros, setup) = (&machine.macros, &machine.setup);
    match (table, path) {
        ("", "axes.<axis>") => {
            texts(Axis::ALL.into_iter().filter(|axis| machine.axis(*axis).is_some()))
        }
        ("", "rotary.<rotary>") => texts(["A", "B", "C"].into_iter()),
        ("", "reference_points.<point>") => texts(2..=4),
        ("", "tools.<tool>") => texts(machine.tools.keys()),
        ("", "solids.<name>") => texts(machine.solids.keys()),
        ("", "fixtures.<name>") => texts(setup.fixtures.keys()),
        ("", "materials.<name>") => texts(setup.materials.keys()),
        ("", "work_offsets.<offset>") => texts(machine.work_offsets.keys()),
        ("", "shop_codes.<code>") => {
            let codes = machine.shop_codes.keys().map(|number| format!("M{number}"));
            texts(codes.chain(machine.shop_programs.keys().map(|number| format!("O{number}"))))
        }
        ("macros.variables", _) => {
            let numbers = macros.variables.keys().map(u32::to_string);
            texts(numbers.chain(macros.named_variables.keys().map(|name| format!("<{name}>"))))
        }
        ("settings", _) => texts(machine.settings.keys()),
        // `hit` is set instead of the planes; writing keys of planes would remove it.
        ("probe.hit", _) if machine.probe.hit.is_some() => Vec::new(),
        (_, "from.<axis>" | "to.<axis>" | "center.<axis>" | "point.<axis>") => {
            texts(Axis::ALL[..3].iter())
        }
        _ => texts(Axis::ALL.iter()),
    }
}

impl SchemaRow {
    /// Whether the key is written: it is no table, and no alternative to the key of another row.
    fn is_written(&self) -> bool {
        match self.slot {
            SchemaSlot::Kind | SchemaSlot::Inherits => false,
            SchemaSlot::Position(_) => self.path.ends_with("<axis>"),
            SchemaSlot::Quantity { .. } => children(self.path).is_empty(),
            _ => !self.slot.is_table(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_order_names_tables_and_keys_of_the_schema() {
        for table in tables() {
            assert!(!rows_of(table).is_empty(), "{table}");
        }
        for (table, keys) in FIRST_KEYS {
            for key in keys.split(' ') {
                let is_key = |path: &str| path.split('.').next() == Some(key);
                assert!(rows_of(table).iter().any(|(path, _)| is_key(path)), "{table}: {key}");
            }
        }
    }
}
