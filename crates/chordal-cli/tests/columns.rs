//! Columns of commands, path and chords: the files read back are the rows of CSV and JSON lines.

#![allow(clippy::disallowed_methods, clippy::disallowed_types, reason = "the tests read files")]

mod common;

use std::collections::HashMap;
use std::fs::File;
use std::path::Path;

use arrow_array::cast::AsArray;
use arrow_array::types::{Float64Type, Int8Type, Int16Type, UInt32Type};
use arrow_array::{Array, RecordBatch};
use arrow_ipc::reader::FileReader;
use common::{BROKEN, Folder};
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use serde_json::Value;

/// Arcs, compensation, a dwell, a tool, printed text, both ends of a program.
const PART: &str = "O1 (PLATE)\nG21 G17 G40 G90 G94\nT2 M6\nS900 M3 M8\nG0 X-20. Y0\nG43 H2 Z5.\nG1 Z-1. F100.\n\
                    G41 D2 X0\nY40.\nG2 X10. Y50. I10. J0\nG1 X50.\nG3 X60. Y60. I0 J10.\nG1 G40 X80.\nG4 P2.\n#1=3.\n\
                    DPRNT[X#1[32]]\nG0 Z5. M5\nM30\n";

const TABLE: [&str; 4] = ["-m", "haas-vf2", "--set", "tools.2.diameter=\"6 mm\""];

/// The rows of a file and what it says about itself.
struct Read {
    batches: Vec<RecordBatch>,
    about: HashMap<String, String>,
}

fn read(path: &Path) -> Read {
    let file = File::open(path).unwrap();
    if path.extension().is_some_and(|ending| ending == "arrow") {
        let reader = FileReader::try_new(file, None).unwrap();
        let about = reader.schema().metadata().clone();
        return Read { batches: reader.map(Result::unwrap).collect(), about };
    }
    let builder = ParquetRecordBatchReaderBuilder::try_new(file).unwrap();
    let pairs = builder.metadata().file_metadata().key_value_metadata().unwrap().iter();
    let about = pairs.map(|pair| (pair.key.clone(), pair.value.clone().unwrap_or_default()));
    let about = about.collect();
    Read { batches: builder.build().unwrap().map(Result::unwrap).collect(), about }
}

impl Read {
    /// A column as texts and numbers, `Null` where there is a gap.
    fn column(&self, name: &str) -> Vec<Value> {
        let columns = self.batches.iter().map(|batch| batch.column_by_name(name).expect(name));
        columns.flat_map(|column| (0..column.len()).map(move |row| cell(column, row))).collect()
    }

    fn rows(&self) -> usize {
        self.batches.iter().map(RecordBatch::num_rows).sum()
    }
}

fn cell(column: &dyn Array, row: usize) -> Value {
    if column.is_null(row) {
        return Value::Null;
    }
    if let Some(numbers) = column.as_primitive_opt::<Float64Type>() {
        return numbers.value(row).into();
    }
    if let Some(numbers) = column.as_primitive_opt::<UInt32Type>() {
        return numbers.value(row).into();
    }
    if let Some(flags) = column.as_boolean_opt() {
        return flags.value(row).into();
    }
    if let Some(texts) = column.as_string_opt::<i32>() {
        return texts.value(row).into();
    }
    let (key, words) = if let Some(words) = column.as_dictionary_opt::<Int8Type>() {
        (words.keys().value(row) as usize, words.values())
    } else {
        let words = column.as_dictionary::<Int16Type>();
        (words.keys().value(row) as usize, words.values())
    };
    words.as_string::<i32>().value(key).into()
}

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("part.nc", PART);
    folder
}

fn run(folder: &Folder, command: &str, more: &[&str]) -> String {
    folder.run(&[&[command, "part.nc"], &TABLE[..], more].concat()).ends(0).out
}

/// Texts have nine decimals.
#[track_caller]
fn agree(own: &Value, text: &str, what: &str) {
    match own {
        Value::Null => assert_eq!(text, "", "{what}"),
        Value::Number(number) => {
            let (own, text) = (number.as_f64().unwrap(), text.parse::<f64>().expect(what));
            assert!((own - text).abs() <= 0.6e-9, "{what}: {own} {text}");
        }
        Value::Bool(flag) => assert_eq!(text, if *flag { "1" } else { "0" }, "{what}"),
        Value::String(word) => assert_eq!(word, text, "{what}"),
        _ => panic!("{what}: {own}"),
    }
}

/// Every cell of a CSV table is that of the columns, whose rows may be more: of those the table
/// has the kinds given.
fn same_table(csv: &str, columns: &Read, kinds: Option<&[&str]>) {
    let mut lines = csv.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    let kind = columns.column("kind");
    let kept: Vec<usize> = (0..columns.rows())
        .filter(|row| kinds.is_none_or(|kinds| kinds.iter().any(|own| kind[*row] == *own)))
        .collect();
    assert_eq!(kept.len(), rows.len());
    assert!(rows.len() > 8);
    for (place, name) in names.iter().enumerate() {
        if columns.batches[0].column_by_name(name).is_none() {
            // A rotary axis that the machine does not have.
            assert!(rows.iter().all(|row| row[place].is_empty()), "{name}");
            continue;
        }
        let values = columns.column(name);
        for (row, own) in rows.iter().zip(&kept) {
            agree(&values[*own], row[place], &format!("{name} of {row:?}"));
        }
    }
}

/// The kinds that have a row in CSV.
const OF_CSV: [&str; 7] = ["rapid", "line", "arc", "spiral", "dwell", "tool", "spindle"];

#[test]
fn columns_are_the_rows_of_csv() {
    let folder = folder();
    for (command, kinds) in
        [("commands", Some(&OF_CSV[..])), ("path", Some(&OF_CSV[..])), ("chords", None)]
    {
        let csv = run(&folder, command, &["--format", "csv"]);
        for name in ["a.parquet", "b.arrow"] {
            assert_eq!(run(&folder, command, &["-o", name]), "");
            same_table(&csv, &read(&folder.path(name)), kinds);
        }
    }
}

#[test]
fn columns_are_the_json_lines() {
    let folder = folder();
    for command in ["commands", "path"] {
        let text = run(&folder, command, &[]);
        let lines = text.lines().skip(1).map(|line| serde_json::from_str(line).unwrap());
        let lines: Vec<Value> = lines.collect();
        for name in ["a.parquet", "b.arrow"] {
            run(&folder, command, &["-o", name]);
            let columns = read(&folder.path(name));
            let column = |name: &str| columns.column(name);
            let of = |name: &str| lines.iter().map(|line| line[name].clone()).collect::<Vec<_>>();
            for name in ["line", "kind", "text", "direction", "plane"] {
                assert_eq!(column(name), of(name), "{command} {name}");
            }
            for (own, path) in [("x_from_mm", ["from", "X"]), ("z_to_mm", ["to", "Z"])] {
                for (own, line) in column(own).iter().zip(&lines) {
                    let number = &line[path[0]][path[1]];
                    // JSON has the number that the control counts with, and says which are not known.
                    let unknown = line[format!("{}_unknown", path[0])].as_array();
                    let is_unknown = unknown.is_some_and(|axes| axes.contains(&path[1].into()));
                    let is_gap = number.is_null() || is_unknown;
                    let text = if is_gap { String::new() } else { number.to_string() };
                    agree(own, &text, &format!("{line}"));
                }
            }
            assert_eq!(column("file"), vec![Value::from("part.nc"); lines.len()]);
        }
    }
}

#[test]
fn files_say_where_they_come_from() {
    let folder = folder();
    let digest = chordal_export::sha256_hex(PART.as_bytes());
    for (command, schema) in [
        ("commands", "chordal.command-columns/1"),
        ("path", "chordal.tool-path-columns/1"),
        ("chords", "chordal.chord-columns/1"),
        ("sample", "chordal.samples/1"),
    ] {
        for name in ["a.parquet", "b.arrow"] {
            run(&folder, command, &["-o", name]);
            let Read { batches, about } = read(&folder.path(name));
            for (key, value) in [
                ("schema", schema),
                ("version", env!("CARGO_PKG_VERSION")),
                ("program", "part.nc"),
                ("program_sha256", digest.as_str()),
                ("machine", "haas-vf2"),
                ("control", "haas"),
            ] {
                assert_eq!(about[&format!("chordal.{key}")], value, "{command} {name} {key}");
            }
            let schema = batches[0].schema();
            let place =
                schema.fields().iter().find(|field| field.name().starts_with("x_")).unwrap();
            assert_eq!(place.metadata()["unit"], "mm", "{command} {name}");
            if command == "chords" {
                assert_eq!(about["chordal.tolerance_mm"], "0.01");
            }
        }
    }
}

#[test]
fn long_runs_come_in_groups() {
    let folder = Folder::new();
    let moves: String = (0..150_000).map(|index| format!("X{}.\n", index % 2)).collect();
    folder.write("part.nc", format!("O1\nG21 G90 S900 M3\nG1 Z0 F100.\n{moves}M30\n"));
    run(&folder, "commands", &["-o", "a.parquet"]);
    run(&folder, "commands", &["-o", "b.arrow"]);
    let file = File::open(folder.path("a.parquet")).unwrap();
    let builder = ParquetRecordBatchReaderBuilder::try_new(file).unwrap();
    assert_eq!(builder.metadata().num_row_groups(), 2);
    let (parquet, arrow) = (read(&folder.path("a.parquet")), read(&folder.path("b.arrow")));
    assert!(arrow.batches.iter().all(|batch| batch.num_rows() <= 8192));
    assert!(arrow.rows() > 150_000);
    for name in ["line", "kind", "x_to_mm", "file"] {
        assert!(parquet.column(name) == arrow.column(name), "{name}");
    }
}

#[test]
fn a_program_with_problems_has_its_rows() {
    let folder = Folder::new();
    folder.write("part.nc", BROKEN);
    for command in ["commands", "path", "chords"] {
        let arguments = [command, "part.nc", "-m", "haas-vf2", "-o", "a.parquet"];
        folder.run(&arguments).ends(1).complains(&["error[CH401]"]);
        assert!(read(&folder.path("a.parquet")).rows() > 0);
    }
}

#[test]
fn wrong_use_is_told_and_writes_nothing() {
    let folder = folder();
    folder.write("taken/x", "");
    for command in ["commands", "path", "chords", "sample"] {
        for (arguments, said) in [
            (&["-o", "out.doc"][..], ["is not a format of", ".parquet, .arrow"]),
            (&["-o", "out"], ["is not a format of", "or give --format"]),
            (
                &["-o", "out.arrow", "--format", "csv"],
                ["--format says csv", "use the extension .csv"],
            ),
            (&["-o", "part.nc", "--format", "arrow"], ["part.nc is the program", "another name"]),
            // A folder stands in the way when the whole file is to be put in place.
            (&["-o", "taken", "--format", "parquet"], ["cannot write taken", ""]),
        ] {
            folder
                .run(&[&[command, "part.nc"], &TABLE[..], arguments].concat())
                .ends(2)
                .complains(&said);
        }
    }
    assert_eq!(folder.names(), ["part.nc", "taken/x"]);
    assert_eq!(folder.read("part.nc"), PART);
}

/// The file may not grow beyond 32 kB.
#[cfg(unix)]
#[test]
fn a_full_disk_leaves_no_file() {
    let folder = Folder::new();
    let moves: String = (0..20_000).map(|index| format!("X{}.{index}\n", index % 7)).collect();
    folder.write("part.nc", format!("O1\nG21 G90 S900 M3\nG1 Z0 F100.\n{moves}M30\n"));
    for command in ["commands", "path", "chords"] {
        for name in ["a.parquet", "b.arrow", "c.csv"] {
            let call = format!(
                "trap '' XFSZ; ulimit -f 64; exec \"$0\" {command} part.nc -m haas-vf2 -o {name}"
            );
            let chordal = folder.command(&[]);
            let done = std::process::Command::new("sh")
                .current_dir(folder.path("."))
                .arg("-c")
                .arg(call)
                .arg(chordal.get_program())
                .output()
                .unwrap();
            let said = String::from_utf8_lossy(&done.stderr);
            assert_eq!(done.status.code(), Some(2), "{said}");
            assert!(said.contains(&format!("cannot write {name}")), "{said}");
            assert_eq!(folder.names(), ["part.nc"], "{command} {name}");
        }
    }
}

/// A file keeps what it was when the next run fails.
#[test]
fn a_failure_leaves_the_file_as_it_was() {
    let folder = folder();
    run(&folder, "commands", &["-o", "a.parquet"]);
    let before = folder.bytes("a.parquet");
    folder.run(&["commands", "gone.nc", "-m", "haas-vf2", "-o", "a.parquet"]).ends(2);
    let failing = ["sample", "part.nc", "-m", "haas-vf2", "--max-samples", "10", "-o", "a.parquet"];
    folder.run(&failing).ends(2).complains(&["more than 10 setpoints"]);
    assert_eq!(folder.bytes("a.parquet"), before);
    assert_eq!(folder.names(), ["a.parquet", "part.nc"]);
}
