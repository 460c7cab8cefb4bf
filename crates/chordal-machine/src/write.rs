//! A machine as the file that would give it, with nothing left to inherit.

use crate::machine::{Machine, Macros};
use crate::schema::{self, tables, written_tables};

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

#[cfg(test)]
mod tests;
