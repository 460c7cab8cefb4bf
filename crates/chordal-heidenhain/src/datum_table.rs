//! Datum tables (`.D`) and the preset table (`.PR`) of the control (iTNC 530 user's manual 340 49x, 8.9; cycle 7 and
//! TRANS DATUM TABLE; 12.5, cycle 247).

use std::collections::BTreeMap;

use chordal_command::{WorkName, WorkNaming};
use chordal_machine::Machine;

use crate::table::{ControlTableRow, ControlTableText};

/// X, Y, Z, A, B and C, the columns of both tables.
const AXIS_COLUMNS: [&str; 6] = ["X", "Y", "Z", "A", "B", "C"];

/// A datum: X, Y and Z in mm, A, B and C in degrees; `None` for an axis without a value.
pub type TableDatum = [Option<f64>; 6];

/// A datum table.
#[derive(Clone, Debug)]
pub struct DatumTable {
    /// The data by their numbers.
    pub data: BTreeMap<u32, TableDatum>,
}

/// A table of a kind, by the extension of its name and a column for the number.
fn table_of_kind(text: &[u8], extension: &str) -> Option<ControlTableText> {
    if !text.trim_ascii_start().get(..6).is_some_and(|own| own.eq_ignore_ascii_case(b"BEGIN ")) {
        return None;
    }
    let table = ControlTableText::read(text)?;
    // On old controls a blank stands before the extension.
    let is_named = table.name.ends_with(extension);
    let has_columns = (table.has_column("D") || table.has_column("NR")) && table.has_column("X");
    (is_named && has_columns).then_some(table)
}

fn row_number(row: ControlTableRow<'_>) -> Option<u32> {
    row.text("D").or(row.text("NR"))?.parse().ok()
}

fn datum(row: ControlTableRow<'_>, unit_mm: f64) -> TableDatum {
    let value = |axis: usize| {
        let unit = if axis < 3 { unit_mm } else { 1.0 };
        Some(row.number(AXIS_COLUMNS[axis])? * unit)
    };
    [0, 1, 2, 3, 4, 5].map(value)
}

impl DatumTable {
    /// Reads a datum table; `None` for any other text.
    pub fn read(text: &[u8]) -> Option<DatumTable> {
        let table = table_of_kind(text, ".D")?;
        let rows =
            table.rows().filter_map(|row| Some((row_number(row)?, datum(row, table.unit_mm))));
        Some(DatumTable { data: rows.collect() })
    }
}

/// The work offset of a line of the preset table: lines from 5 on have names of their own.
pub fn preset_name(number: u16) -> WorkName {
    match number {
        0..=4 => WorkName::G(53 + number),
        _ => WorkName::G(500u16.saturating_add(number)),
    }
}

/// Whether a text is a datum table.
pub fn is_datum_table(text: &[u8]) -> bool {
    table_of_kind(text, ".D").is_some()
}

/// Whether a text is the preset table.
pub fn is_preset_table(text: &[u8]) -> bool {
    table_of_kind(text, ".PR").is_some()
}

/// Takes the presets of a table over into a machine, each as the work offset that cycle 247 activates. Line 0 is set by
/// hand and is what the run begins with. A line with a basic rotation is left out: an offset has none, so that its preset
/// stays unknown.
pub fn take_preset_table(text: &[u8], machine: &mut Machine, naming: WorkNaming) {
    let Some(table) = table_of_kind(text, ".PR") else { return };
    for row in table.rows() {
        let Some(number) = row_number(row).and_then(|number| u16::try_from(number).ok()) else {
            continue;
        };
        let is_turned = ["ROT", "SPA", "SPB", "SPC"]
            .iter()
            .any(|column| row.number(column).is_some_and(|degrees| degrees != 0.0));
        if number == 0 || is_turned {
            continue;
        }
        let offset = machine.work_offsets.entry(preset_name(number).table_key(naming)).or_default();
        for (axis, value) in datum(row, table.unit_mm).into_iter().enumerate() {
            let Some(value) = value else { continue };
            offset.values[axis] = Some(if axis < 3 { value } else { value.to_radians() });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = "BEGIN PLATE.D INCH\r\n\
        D    X        Y        Z        A      B      C      DOC\r\n\
        0    +0       +0       +0       +0     +0     +0\r\n\
        1    +1       -2,5     +0.5     +0     +0     +30    FIRST\r\n\
        7             +4\r\n\
        [END]\r\n\
        8    +1       +1       +1\r\n";

    #[test]
    fn data_have_the_unit_of_the_table() {
        let table = DatumTable::read(TABLE.as_bytes()).expect("a table");
        assert_eq!(table.data.keys().copied().collect::<Vec<u32>>(), [0, 1, 7]);
        let first = table.data[&1];
        let expected = [Some(25.4), Some(-63.5), Some(12.7), Some(0.0), Some(0.0), Some(30.0)];
        assert_eq!(first, expected);
        assert_eq!(table.data[&7], [None, Some(101.6), None, None, None, None]);
        assert!(DatumTable::read(b"BEGIN TOOL.T MM\nT NAME L R\n").is_none());
        assert!(DatumTable::read(b"part.o: part.c\n\tcc -c part.c\n").is_none());
    }

    #[test]
    fn presets_become_work_offsets() {
        let text = "BEGIN PRESET.PR MM\nNR  DOC      ROT      X        Y        Z\n\
            0            +0       +9       +9       +9\n1   VICE     +0       -400     -250.5   -350\n\
            2   TURNED   +3       +1       +1       +1\n[END]\n";
        let mut machine = Machine::from_builtin("heidenhain-mill").expect("a machine");
        machine.work_offsets.clear();
        assert!(is_preset_table(text.as_bytes()));
        let naming = WorkNaming { extended: "", first: 507, by_e: false };
        take_preset_table(text.as_bytes(), &mut machine, naming);
        assert_eq!(machine.work_offsets.keys().collect::<Vec<_>>(), ["G54"]);
        let values = machine.work_offsets["G54"].values;
        assert_eq!(values[..3], [Some(-400.0), Some(-250.5), Some(-350.0)]);
    }
}
