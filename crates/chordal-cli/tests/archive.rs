//! Whole archives: one table, whatever the number of jobs and interruptions.

#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    reason = "the tests of a shell have its files and processes"
)]

mod common;

use std::fs;
use std::process::Stdio;
use std::thread::sleep;
use std::time::Duration;

use arrow_array::cast::AsArray;
use arrow_array::types::{Float64Type, UInt32Type, UInt64Type};
use arrow_array::{Array, RecordBatch};
use common::{BROKEN, CLEAN, Folder};
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;

/// A program that never ends.
const ENDLESS: &str = "%\nO7\nG21 G90 G94\nN10 G0 X1.\nX0\nGOTO10\nM30\n%\n";

/// A program of a control with a number of moves.
fn program(control: &str, number: u32, moves: u32) -> String {
    let (head, tail) = match control {
        "fadal" => ("M6 T1 (PART\nG20 G90 G0 S5000 M3 E1 X0 Y0\nH1 Z1. M8\n", "G90 G0 H0 Z0\nM2\n"),
        "linuxcnc" => {
            ("G21 G90 G64 P0.01\nT1 M6\nG0 X0 Y0 S900 M3\nG43 H1 Z5.\n", "G0 Z5. M5\nM2\n")
        }
        _ => ("G20 G17 G40 G90\nG0 X0 Y0\nS900 M3\nG0 Z.1\n", "G0 Z.1 M5\nM30\n"),
    };
    let mut text = match control {
        "fadal" | "linuxcnc" => head.to_string(),
        _ => format!("%\nO{number} (PART)\n{head}"),
    };
    text.push_str("G1 Z-.1 F20.\n");
    for i in 0..moves {
        text.push_str(&format!("X{}.{:03} Y.{:03}\n", i % 7, (i * 37) % 1000, (i * 91) % 1000));
    }
    text.push_str(tail);
    text
}

/// Programs of all five controls in sizes from 10 to 300 moves, and one of every broken kind.
fn archive() -> Folder {
    let folder = Folder::new();
    let controls = ["haas", "fanuc", "fadal", "mitsubishi", "linuxcnc"];
    for (place, control) in controls.iter().enumerate() {
        for i in 0..8u32 {
            let number = place as u32 * 100 + i + 1;
            let ending = ["nc", "tap", "cnc", "txt"][i as usize % 4];
            let name = format!("in/{control}/sub{}/P{number}.{ending}", i % 3);
            folder.write(&name, program(control, number, 10 + i * i * 6));
        }
    }
    // Fadal is recognized from the text.
    folder.write("in/haas/chordal.toml", "machine = \"haas-vf2\"\n");
    folder.write("in/linuxcnc/chordal.toml", "machine = \"linuxcnc-mill\"\n");
    folder.write("in/fanuc/chordal.toml", "machine = \"fanuc-30i\"\n");
    folder.write("in/mitsubishi/chordal.toml", "machine = \"mitsubishi-m700\"\n");
    folder.write("in/broken/chordal.toml", "machine = \"fanuc-30i\"\n");
    folder.write("in/broken/empty.nc", "");
    folder.write("in/broken/blank.nc", "%\n\n%\n");
    folder.write("in/broken/binary.nc", (0..=255u8).cycle().take(3000).collect::<Vec<u8>>());
    folder.write("in/broken/truncated.nc", &program("haas", 1, 50).as_bytes()[..400]);
    folder.write("in/broken/endless.nc", ENDLESS);
    folder.write("in/broken/letter.txt", "Dear colleague,\nplease find the programs here.\n");
    folder.write("in/broken/words.nc", "O5\nGG1 X1..5 Y-\n$$ @@ X\nG999 M888 Q\n");
    folder.write("in/broken/picture.png", b"\x89PNG\r\n\x1a\n");
    folder.write("in/unknown/chordal.toml", "machine = \"nobodys-control\"\n");
    folder.write("in/unknown/part.nc", CLEAN);
    let wide: Vec<u8> = CLEAN.encode_utf16().flat_map(u16::to_le_bytes).collect();
    folder.write("in/haas/wide.nc", wide);
    folder.write("in/haas/ALL-PROG.TXT", dump());
    folder
}

/// A memory with two main programs and a subprogram of the first.
fn dump() -> String {
    "%\n&F=/USER/\nO100 (MAIN)\nG20 G90 G0 X0 Y0\nS900 M3\nM98 P300\nG0 X1. Z1.\nM30\n\
     O200 (OTHER)\nG20 G90 G0 X0 Y0\nG1 X5. F10.\nM30\nO300 (SUB)\nG1 X2. F10.\nM99\n%\n"
        .to_string()
}

fn check<'a>(more: &[&'a str]) -> Vec<&'a str> {
    let mut arguments = vec!["archive", "check", "in", "--out", "results.parquet"];
    if !more.contains(&"--max-blocks") {
        arguments.extend(["--max-blocks", "20000"]);
    }
    arguments.extend(more);
    arguments
}

fn read(bytes: Vec<u8>) -> RecordBatch {
    let builder = ParquetRecordBatchReaderBuilder::try_new(bytes::Bytes::from(bytes)).unwrap();
    let mut batches = builder.with_batch_size(1 << 16).build().unwrap();
    let table = batches.next().expect("a table has rows").unwrap();
    assert!(batches.next().is_none());
    table
}

/// The rows of a file, by the end of its path.
fn rows(table: &RecordBatch, file: &str) -> Vec<usize> {
    let paths = table["path"].as_string::<i32>();
    (0..table.num_rows()).filter(|row| paths.value(*row).ends_with(file)).collect()
}

fn text<'a>(table: &'a RecordBatch, column: &str, row: usize) -> &'a str {
    table[column].as_string::<i32>().value(row)
}

#[test]
fn every_file_has_its_row() {
    let folder = archive();
    folder.run(&check(&[])).ends(1).complains(&["programs in", "files", "results.parquet"]);
    assert!(!folder.path("results.parquet.journal").exists());
    let table = read(folder.bytes("results.parquet"));
    let told: Vec<(&str, &str, &str)> = [
        "broken/empty.nc",
        "broken/blank.nc",
        "broken/binary.nc",
        "broken/truncated.nc",
        "broken/endless.nc",
        "broken/letter.txt",
        "broken/words.nc",
        "broken/picture.png",
        "unknown/part.nc",
        "haas/wide.nc",
    ]
    .into_iter()
    .map(|file| {
        let rows = rows(&table, file);
        assert_eq!(rows.len(), 1, "{file}");
        (file, text(&table, "kind", rows[0]), text(&table, "status", rows[0]))
    })
    .collect();
    assert_eq!(
        told,
        [
            ("broken/empty.nc", "empty", "failed"),
            ("broken/blank.nc", "empty", "failed"),
            ("broken/binary.nc", "binary", "failed"),
            ("broken/truncated.nc", "program", "warnings"),
            ("broken/endless.nc", "program", "stopped"),
            ("broken/letter.txt", "other", "skipped"),
            ("broken/words.nc", "program", "errors"),
            ("broken/picture.png", "other", "skipped"),
            ("unknown/part.nc", "program", "failed"),
            ("haas/wide.nc", "program", "ok"),
        ]
    );
    let end = |file: &str| text(&table, "end", rows(&table, file)[0]);
    assert_eq!(end("broken/truncated.nc"), "end of text");
    assert_eq!(end("broken/endless.nc"), "budget");
    for control in ["haas", "fanuc", "fadal", "mitsubishi", "linuxcnc"] {
        let rows = (1..=500).flat_map(|n| rows(&table, &format!("P{n}.nc")));
        let own = rows.filter(|row| text(&table, "path", *row).contains(&format!("/{control}/")));
        let own: Vec<usize> = own.collect();
        assert!(!own.is_empty(), "{control}");
        assert!(own.iter().all(|row| text(&table, "control", *row) == control), "{control}");
    }
    let paths = table["path"].as_string::<i32>();
    let paths: Vec<&str> = (0..table.num_rows()).map(|row| paths.value(row)).collect();
    assert!(paths.is_sorted(), "{paths:?}");
}

/// CLEAN by hand: X 0 to 1 inch and, over the arc about (.5, 1) of radius .5, Y to 1.5; Z between
/// .1 and -.1 inch.
#[test]
fn a_row_says_what_the_program_does() {
    let folder = Folder::new();
    folder.write("in/part.nc", CLEAN).write("in/wrong.nc", BROKEN);
    folder.run(&check(&["--machine", "haas-vf2"])).ends(1);
    let table = read(folder.bytes("results.parquet"));
    let row = rows(&table, "part.nc")[0];
    let number = |column: &str| table[column].as_primitive::<Float64Type>().value(row);
    let count = |column: &str, row: usize| table[column].as_primitive::<UInt64Type>().value(row);
    let near = |column: &str, expected: f64| {
        assert!((number(column) - expected).abs() < 1e-9, "{column}: {}", number(column));
    };
    near("x_min_mm", 0.0);
    near("x_max_mm", 25.4);
    near("y_max_mm", 1.5 * 25.4);
    near("z_min_mm", -2.54);
    near("z_max_mm", 2.54);
    assert!(table["a_min_deg"].is_null(row));
    assert_eq!(text(&table, "control", row), "haas");
    assert_eq!(text(&table, "chosen", row), "given");
    assert_eq!(text(&table, "end", row), "program end");
    assert_eq!((count("program", row), count("lines", row), count("line", row)), (10, 12, 1));
    assert_eq!(count("bytes", row), CLEAN.len() as u64);
    assert_eq!(text(&table, "file_sha256", row), chordal_export::sha256_hex(CLEAN.as_bytes()));
    // Plunge .2 inch at 5 inch/min; 1, 1, pi/2 and 1 inch at 10.
    let cutting = 60.0 * (0.2 / 5.0 + (3.0 + std::f64::consts::FRAC_PI_2) / 10.0);
    assert!(number("cutting_s") >= cutting, "{}", number("cutting_s"));
    assert!(number("cutting_s") < 1.05 * cutting, "{}", number("cutting_s"));
    assert!(number("time_s") >= number("at_feed_s"));
    let tools = table["tools"].as_list::<i32>().value(row);
    assert_eq!(tools.as_primitive::<UInt32Type>().values(), &[0]);
    // The arc whose radii differ is on line 6.
    let wrong = rows(&table, "wrong.nc")[0];
    assert_eq!(count("errors", wrong), 1);
    let problems = table["problems"].as_list::<i32>().value(wrong);
    let first = problems.as_struct();
    assert_eq!(first["severity"].as_string::<i32>().value(0), "error");
    assert_eq!(first["line"].as_primitive::<UInt32Type>().value(0), 6);
    let codes = table["codes"].as_list::<i32>().value(wrong);
    assert_eq!(codes.as_string::<i32>().value(0), first["code"].as_string::<i32>().value(0));
}

#[test]
fn a_dump_has_a_row_for_each_program() {
    let folder = Folder::new();
    folder.write("in/ALL-PROG.TXT", dump());
    folder.run(&check(&["--machine", "fanuc-30i"]));
    let table = read(folder.bytes("results.parquet"));
    let count = |column: &str, row: usize| table[column].as_primitive::<UInt64Type>().value(row);
    let told: Vec<_> = (0..table.num_rows())
        .map(|row| {
            (
                count("program", row),
                count("place", row),
                count("line", row),
                text(&table, "kind", row),
            )
        })
        .collect();
    assert_eq!(told, [(100, 0, 3, "program"), (200, 1, 9, "program"), (300, 2, 13, "subprogram"),]);
    // O100 goes to X2. in its subprogram and cuts there; O200 to X5.
    let x = |row: usize| table["x_max_mm"].as_primitive::<Float64Type>().value(row);
    assert!((x(0) - 50.8).abs() < 1e-9 && (x(1) - 127.0).abs() < 1e-9, "{} {}", x(0), x(1));
    assert_eq!(text(&table, "status", 2), "called");
}

/// A loop of 24,000 moves of 1 mm each at 1000 mm/min takes 24 minutes at feed; one without an end
/// takes no time that could be reported.
#[test]
fn long_loops_have_a_time_and_endless_ones_have_none() {
    let folder = Folder::new();
    let counted = "O1\nG21 G90 G94 S900 M3\n#1=0\nG0 X0 Y0\nWHILE[#1LT12000]DO1\nG1 X1. F1000.\nX0\n\
                   #1=#1+1\nEND1\nM30\n";
    folder.write("in/counted.nc", counted).write("in/endless.nc", ENDLESS);
    folder.run(&check(&["--machine", "fanuc-30i", "--max-blocks", "100000"])).ends(1);
    let table = read(folder.bytes("results.parquet"));
    let [counted, endless] = ["counted.nc", "endless.nc"].map(|file| rows(&table, file)[0]);
    let time = table["time_s"].as_primitive::<Float64Type>();
    assert_eq!(text(&table, "end", counted), "program end");
    assert!(time.is_valid(counted) && time.value(counted) > 24.0 * 60.0, "{}", time.value(counted));
    assert_eq!(text(&table, "status", endless), "stopped");
    assert!(time.is_null(endless));
}

#[test]
fn jobs_do_not_change_the_table() {
    let folder = archive();
    folder.run(&check(&["--jobs", "1"])).ends(1);
    let one = folder.bytes("results.parquet");
    for jobs in ["2", "5"] {
        folder.run(&check(&["--jobs", jobs])).ends(1);
        assert!(folder.bytes("results.parquet") == one, "{jobs} jobs make another table");
    }
}

#[test]
fn a_killed_run_goes_on_where_it_was() {
    let folder = archive();
    // The last file keeps the run alive until it is killed.
    folder.write("in/zz/last.nc", ENDLESS);
    folder.write("in/zz/chordal.toml", "machine = \"fanuc-30i\"\n");
    let arguments = |blocks| {
        let more = ["--out", "results.parquet", "--no-plan", "--jobs", "1", "--max-blocks", blocks];
        [&["archive", "check", "in"], &more[..]].concat()
    };
    let blocks = "400000";
    folder.run(&arguments(blocks)).ends(1);
    let whole = folder.bytes("results.parquet");
    fs::remove_file(folder.path("results.parquet")).unwrap();

    let mut child =
        folder.command(&arguments(blocks)).stderr(Stdio::null()).spawn().expect("it starts");
    let shard = folder.path("results.parquet.journal/shard-000000");
    // Enough for some records and far from all.
    while fs::metadata(&shard).map_or(0, |about| about.len()) < 4000 {
        assert!(child.try_wait().unwrap().is_none(), "it ended before it was killed");
        sleep(Duration::from_millis(2));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(!folder.path("results.parquet").exists(), "a killed run leaves no table");

    // A torn record at the end, as a power cut leaves it.
    let mut torn = fs::read(&shard).unwrap();
    torn.truncate(torn.len() - 5);
    torn.extend_from_slice(&[0xff; 3]);
    fs::write(&shard, torn).unwrap();

    folder.run(&arguments(blocks)).ends(1).complains(&["files done before"]);
    assert!(folder.bytes("results.parquet") == whole, "the resumed table is another");
    let left: Vec<String> =
        folder.names().into_iter().filter(|name| !name.starts_with("in/")).collect();
    assert_eq!(left, ["results.parquet"]);
}

#[test]
fn two_runs_of_one_table_at_once_both_end_well() {
    let folder = archive();
    folder.run(&check(&["--jobs", "1"])).ends(1);
    let whole = folder.bytes("results.parquet");
    for _ in 0..3 {
        fs::remove_file(folder.path("results.parquet")).unwrap();
        let start = || {
            let mut command = folder.command(&check(&["--jobs", "2"]));
            command.stderr(Stdio::piped()).stdout(Stdio::null()).spawn().unwrap()
        };
        for run in [start(), start(), start()] {
            let done = run.wait_with_output().unwrap();
            let said = String::from_utf8_lossy(&done.stderr).into_owned();
            assert_eq!(done.status.code(), Some(1), "{said}");
        }
        assert!(folder.bytes("results.parquet") == whole, "the table is another");
        let left = folder.names().into_iter().filter(|name| !name.starts_with("in/"));
        assert_eq!(left.collect::<Vec<_>>(), ["results.parquet"]);
    }
}

/// A journal whose run used other settings, and one of a file that has changed, do not count.
#[test]
fn what_has_changed_is_done_again() {
    let folder = archive();
    folder.write("in/zz/last.nc", ENDLESS);
    let start = |blocks: &str| {
        let out = ["--out", "results.parquet", "--no-plan", "--jobs", "1", "--max-blocks", blocks];
        let arguments = [&["archive", "check", "in"], &out[..]].concat();
        let mut command = folder.command(&arguments);
        command.stderr(Stdio::null());
        command
    };
    let mut child = start("3000000").spawn().unwrap();
    let shard = folder.path("results.parquet.journal/shard-000000");
    while fs::metadata(&shard).map_or(0, |about| about.len()) < 4000 {
        assert!(child.try_wait().unwrap().is_none(), "it ended before it was killed");
        sleep(Duration::from_millis(2));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    // `broken` comes first in the order, so its files are in the journal.
    folder.write("in/broken/truncated.nc", CLEAN);
    start("20000").status().unwrap();
    let resumed = folder.bytes("results.parquet");
    start("20000").status().unwrap();
    assert!(resumed == folder.bytes("results.parquet"), "old records were taken");
}

#[test]
fn wrong_use_is_told_and_nothing_is_written() {
    let folder = archive();
    let call = |out: &str| folder.run(&["archive", "check", "in", "--out", out]);
    call("in/haas/wide.nc").ends(2).complains(&["cannot be in/haas/wide.nc", ".parquet"]);
    call("nowhere/results.parquet").ends(1);
    folder.write("file", "");
    call("file/results.parquet").ends(2).complains(&["cannot write file/results.parquet.journal"]);
    folder
        .run(&["archive", "check", "in", "--out", "r.parquet", "--control", "nobody"])
        .ends(2)
        .complains(&["nobody"]);
    let missing = ["archive", "check", "in", "inn", "--out", "r.parquet"];
    folder.run(&missing).ends(2).complains(&["cannot read inn: no such file or directory"]);
    assert!(!folder.path("r.parquet").exists());
}

/// A link to nothing is a program that is missing; a pipe would never end.
#[cfg(unix)]
#[test]
fn what_is_no_file_is_told_or_left_out() {
    let folder = Folder::new();
    folder.write("in/part.nc", CLEAN);
    std::os::unix::fs::symlink("lost", folder.path("in/link.nc")).unwrap();
    let pipe = std::process::Command::new("mkfifo").arg(folder.path("in/pipe.nc")).status();
    assert!(pipe.unwrap().success());
    folder.run(&check(&["in/pipe.nc"])).ends(1).complains(&["2 that could not be run"]);
    let table = read(folder.bytes("results.parquet"));
    let told = |row| (text(&table, "path", row), text(&table, "kind", row));
    let told: Vec<_> = (0..table.num_rows()).map(told).collect();
    let expected =
        [("in/link.nc", "unreadable"), ("in/part.nc", "program"), ("in/pipe.nc", "unreadable")];
    assert_eq!(told, expected);
}

#[test]
fn what_came_back() {
    let folder = Folder::new();
    let both = |name: &str, before: &str, after: &str| {
        folder.write(&format!("released/{name}"), before);
        folder.write(&format!("returned/{name}"), after);
    };
    let part = "O1 (PART)\nG20 G17 G40 G90\nG0 X0 Y0 Z.1\nS900 M3\nG1 Z-.1 F5.\nX1. F10.\nY1.\nG0 Z.1 M5\nM30\n";
    both("a-same.nc", part, part);
    both(
        "b-text.nc",
        part,
        &part.replace("(PART)", "(PART, SETUP 2)").replace("X1. ", "N50 X1.0 "),
    );
    both("c-feeds.nc", part, &part.replace("F10.", "F8."));
    both("d-speeds.nc", part, &part.replace("S900", "S800"));
    both("e-functions.nc", part, &part.replace("S900 M3", "S900 M3 M8"));
    // The corner 1,1 goes to 1,1.01: .01 inch is .254 mm.
    both("f-path.nc", part, &part.replace("Y1.", "Y1.01"));
    both("g-cut.nc", part, &part.replace("X1. F10.", "X.5 F10.\nX1."));
    both("h-broken.nc", part, "\u{1}\u{2}\u{3}\u{4}\u{5}");
    both("i-notes.md", "one", "two");
    folder.write("released/j-missing.nc", part);
    folder.write("returned/k-new.nc", part);
    let done = folder.run(&[
        "archive",
        "diff",
        "released",
        "returned",
        "--machine",
        "haas-vf2",
        "--format",
        "json",
        "--out",
        "changes.parquet",
    ]);
    let told: serde_json::Value = serde_json::from_str(&done.ends(1).out).unwrap();
    let files = told["files"].as_array().unwrap();
    let status: Vec<(&str, &str)> = files
        .iter()
        .map(|file| (file["path"].as_str().unwrap(), file["status"].as_str().unwrap()))
        .collect();
    assert_eq!(
        status,
        [
            ("a-same.nc", "same"),
            ("b-text.nc", "text"),
            ("c-feeds.nc", "feeds"),
            ("d-speeds.nc", "feeds"),
            ("e-functions.nc", "functions"),
            ("f-path.nc", "path"),
            ("g-cut.nc", "path"),
            ("h-broken.nc", "unreadable"),
            ("i-notes.md", "other"),
            ("j-missing.nc", "missing"),
            ("k-new.nc", "new"),
        ]
    );
    let distance = |place: usize| {
        let mm = &files[place]["distance_mm"];
        (mm[0].as_f64().unwrap(), mm[1].as_f64().unwrap())
    };
    let (low, high) = distance(5);
    assert!(low <= 0.254 + 1e-9 && 0.254 - 1e-9 <= high && high - low <= 0.001, "{low} {high}");
    assert_eq!(distance(6), (0.0, 0.0));
    assert_eq!(files[2]["lines"], serde_json::json!([6, 6]));
    let times = files[2]["time_s"].as_array().unwrap();
    let [before, after] = [&times[0], &times[1]].map(|time| time.as_f64().unwrap());
    // Two inches at 8 in/min instead of 10 take 3 s more; starts and stops a little less than before.
    assert!((after - before - 3.0).abs() < 0.05, "{times:?}");
    assert!(files[0]["time_s"].is_null());
    assert_eq!(files[5]["lines"], serde_json::json!([7, 7]));
    let table = read(folder.bytes("changes.parquet"));
    assert_eq!(table.num_rows(), files.len());
    assert_eq!(text(&table, "status", 5), "path");

    let text = folder.run(&["archive", "diff", "released", "returned", "--machine", "haas-vf2"]);
    text.ends(1).says(&["f-path.nc", "mm apart", "from line 7", "11 files: 1 same, 1 text"]);
    folder.run(&["archive", "diff", "released", "released", "--machine", "haas-vf2"]).ends(0);
}

#[test]
fn what_a_change_of_a_post_brings() {
    let folder = Folder::new();
    let arc = "G3 X0 Y1. I-.5 J0";
    folder
        .write("before/a.nc", CLEAN)
        .write("after/a.nc", CLEAN.replace("F10.", "F20."))
        .write("before/b_1.nc", CLEAN)
        .write("after/b_1.nc", CLEAN.replace(arc, "G3 X0 Y1. I-.4 J0"))
        .write("before/c.nc", CLEAN.replace(arc, "G3 X0 Y1. I-.4 J0"))
        .write("after/c.nc", CLEAN)
        .write("before/d.nc", CLEAN)
        .write("after/d.nc", CLEAN);
    let diff = |more: &[&str]| {
        folder.run(&[&["diff", "before", "after", "--machine", "haas-vf2"], more].concat())
    };
    let text = diff(&["--format", "markdown", "--fail-on", "problems"]).ends(1).out;
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(
        lines[0],
        "**4 files: 1 same, 1 feeds, 2 path; 1 new problem in 1 file; 1 problem gone**  "
    );
    assert!(lines[1].starts_with("Time of 3 changed programs: "), "{text}");
    assert_eq!(lines[3], "| file | change | how | time | problems |");
    assert!(lines[5].starts_with("| a.nc | feeds | from line 7 | "), "{text}");
    // The mark of italics in a name is escaped.
    assert!(lines[6].starts_with("| b\\_1.nc | path | "), "{text}");
    assert!(lines[6].ends_with(" | 1 new |") && lines[7].ends_with(" | 1 gone |"), "{text}");
    assert!(lines[11].starts_with("- b\\_1.nc:9 error CH401: "), "{text}");
    diff(&[]).ends(1).says(&["1 new problem in 1 file", "new error[CH401] b_1.nc:9: "]);
    let without = diff(&["--no-plan", "--fail-on", "never"]).ends(0);
    assert!(!without.out.contains("Time of"), "{}", without.out);
    // Without the new problem, changes alone pass.
    folder.write("after/b_1.nc", CLEAN);
    diff(&["--fail-on", "problems"]).ends(0);
    diff(&[]).ends(1);
}

#[test]
fn the_stock_of_each_program_is_in_the_table() {
    let folder = Folder::new();
    let part = "O1\nG21 G90 G54\nT1 M6\nS3000 M3\nG0 X20. Y30.\nG43 H1 Z5.\nG1 Z-5. F200.\nX60. F600.\nG0 Z5.\nM30\n";
    let setup = "machine = 'haas-vf2'
[stock]
shape = 'box'
from = { X = '0 mm', Y = '0 mm', Z = '-20 mm' }
to = { X = '80 mm', Y = '60 mm', Z = '0 mm' }
[tools.1]
shape = 'flat'
diameter = '10 mm'
flute_length = '25 mm'
";
    folder
        .write("in/a.nc", part)
        .write("in/b.nc", part.replace("G1 Z-5. F200.", "G0 Z-5."))
        .write("in/c.txt", "no program\n")
        .write("op1.toml", setup);
    let check = ["archive", "check", "in", "--out", "t.parquet", "--no-plan"];
    let with_stock = [&check[..], &["--stock", "--setup", "op1.toml"]].concat();
    folder.run(&with_stock).ends(1).complains(&["1 with errors"]);
    let table = || read(folder.bytes("t.parquet"));
    let rows = table();
    let column = |name: &str| rows.column_by_name(name).expect("a column").clone();
    let verdicts = column("stock_verdict");
    let verdicts: Vec<Option<&str>> = verdicts.as_string::<i32>().iter().collect();
    assert_eq!(verdicts, [Some("clean"), Some("problems"), None]);
    let removed = ["removed_least_mm3", "removed_most_mm3"]
        .map(|name| column(name).as_primitive::<Float64Type>().value(0));
    let truth = (400.0 + 25.0 * std::f64::consts::PI) * 5.0;
    assert!(removed[0] <= truth && truth <= removed[1], "{removed:?}");
    // The rapid down, and the next block, which is a rapid as well.
    assert_eq!(column("stock_problems").as_primitive::<UInt64Type>().value(1), 2);
    // Without it the table is another: nothing of the journal is taken for it.
    folder.run(&check).ends(0);
    let verdicts = table().column_by_name("stock_verdict").expect("a column").null_count();
    assert_eq!(verdicts, 3);
    // Where no stock is given, the row says so.
    let no_stock = [&check[..], &["--stock", "-m", "haas-vf2"]].concat();
    folder.run(&no_stock).ends(0);
    let rows = table();
    let message = rows.column_by_name("message").expect("a column").as_string::<i32>().value(0);
    assert!(message.starts_with("there is no stock"), "{message}");
}
