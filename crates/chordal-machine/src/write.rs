//! Writes a machine as a file without inheritance.

use crate::machine::{Machine, Macros};
use crate::schema::{self, tables, written_tables};

/// Keys of a tool for one axis with their usual short keys, for mills, which have a length and no other offset.
const SHORT_KEYS: [(&str, &str); 2] = [("offset.Z", "length"), ("offset_wear.Z", "length_wear")];

impl Machine {
    /// The text of a machine file for this machine, with every inherited key, in millimetres, seconds and radians.
    /// Reading it gives exactly the same values.
    pub fn to_toml(&self) -> String {
        let mut out = String::new();
        let mut copy = self.clone();
        for table in tables() {
            for (name, keys) in written_tables(self, table) {
                let mut lines = String::new();
                for (key, row, keys) in &keys {
                    let short = SHORT_KEYS.iter().find(|(long, _)| long == key);
                    let key = short.map_or(key.as_str(), |(_, short)| short);
                    if let Some(value) = row.slot.written(&mut copy, keys) {
                        lines += &format!("{key} = {value}\n");
                    }
                }
                if !table.is_empty() && (!lines.is_empty() || self.has_table(table)) {
                    out += &format!("\n[{name}]\n");
                }
                out += &lines;
            }
        }
        out
    }

    /// Whether the table has a meaning although none of its keys is written.
    fn has_table(&self, table: &str) -> bool {
        match table {
            "macros" => self.macros != Macros::default(),
            "stock" => self.setup.stock.is_some(),
            "target" => self.setup.target.is_some(),
            _ => table.ends_with('>') && schema::row(table).is_some(),
        }
    }
}

#[cfg(test)]
mod tests;
