//! A machine as the file that would give it, with nothing left to inherit.

use std::fmt::Write;

use crate::machine::{Machine, Macros};
use crate::schema::{self, PlaceholderKeys, SchemaRow};

/// The tables in the order of a written file, after the keys that are in none.
const TABLE_ORDER: &str = "axes.<axis> rotary.<rotary> feed rapid spindle home reference_points.<point> \
     switches program motion times shop_codes.<code> macros macros.variables probe probe.hit \
     tools.<tool> stock fixtures.<name> target materials.<name> work_offsets.<offset> settings";

/// The keys that come first in a table; the others follow in the order of the schema.
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

/// The keys of a tool that people know, and those of an axis that say the same: a mill has its length
/// and no other offset.
const SHORT_KEYS: [(&str, &str); 2] = [("offset.Z", "length"), ("offset_wear.Z", "length_wear")];

impl Machine {
    /// The machine file that gives this machine, every inherited key in it, in millimetres,
    /// seconds and radians: reading it back gives the same bits.
    pub fn to_toml(&self) -> String {
        let mut out = String::new();
        let mut copy = self.clone();
        for table in tables() {
            let rows = rows_of(table);
            for (name, keys) in schema::written_keys(self, "", table, &PlaceholderKeys::default()) {
                let mut lines = String::new();
                for (path, row) in &rows {
                    for (key, keys) in schema::written_keys(self, table, path, &keys) {
                        let short = SHORT_KEYS.iter().find(|(long, _)| *long == key);
                        let key = short.map_or(key.as_str(), |(_, short)| short);
                        if let Some(value) = row.slot.written(&mut copy, &keys) {
                            // Writing into a string does not fail.
                            let _ = writeln!(lines, "{key} = {value}");
                        }
                    }
                }
                if !table.is_empty() && (!lines.is_empty() || self.has_table(table)) {
                    let _ = writeln!(out, "\n[{name}]");
                }
                out += &lines;
            }
        }
        out
    }

    /// The table has a meaning though none of its keys is written.
    fn has_table(&self, table: &str) -> bool {
        match table {
            "macros" => self.macros != Macros::default(),
            "stock" => self.setup.stock.is_some(),
            "target" => self.setup.target.is_some(),
            _ => table.ends_with('>') && schema::row(table).is_some(),
        }
    }
}

/// The tables of a file, the first of them the file itself.
fn tables() -> impl Iterator<Item = &'static str> {
    std::iter::once("").chain(TABLE_ORDER.split(' '))
}

/// The rows of the keys of a table in the order in which they are written, each with its path in the table.
fn rows_of(table: &str) -> Vec<(&'static str, &'static SchemaRow)> {
    let within = |table: &str, path: &'static str| match table {
        "" => Some(path),
        _ => path.strip_prefix(table)?.strip_prefix('.'),
    };
    let inner: Vec<&str> =
        tables().filter(|other| *other != table && within(table, other).is_some()).collect();
    let is_own = |row: &SchemaRow| inner.iter().all(|other| within(other, row.path).is_none());
    let mut rows: Vec<_> = schema::rows()
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

#[cfg(test)]
mod tests;
