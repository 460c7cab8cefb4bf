//! `chordal archive diff`: its arguments and what it prints.

use std::path::PathBuf;

use chordal_archive::Disk;
use chordal_archive::diff::{DiffRow, Status, compare_all, write_table};

use super::progress::Meter;
use super::{Machines, jobs};
use crate::failure::{Failure, Verdict};
use crate::numbers::counted;
use crate::options::AnswerFormat;
use crate::output;
use crate::summary::plain_table;
use crate::terminal::{Terminal, say};

const EXAMPLES: &str = "\
Examples:
  chordal archive diff released/ returned/
  chordal archive diff released/ returned/ --format json > changes.json
  chordal archive diff released/ returned/ --out changes.parquet --tolerance 0.001

Files with the same path below the two folders are compared. `text`, `functions` and `feeds` are proved
to have the same motion, curve for curve; for `path` the distance between the two paths, as sets of
points, is given exactly within the tolerance.

Exit code: 0 every file is the same or differs only in its text, 1 otherwise, 2 wrong use.";

/// Compares programs that came back from the machines with the released ones
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The folder of released programs
    released: PathBuf,

    /// The folder of returned programs
    returned: PathBuf,

    /// Format of the answer
    #[arg(long, value_enum, default_value = "text")]
    format: AnswerFormat,

    /// Writes the comparison as a Parquet table; written completely or not at all
    #[arg(long, short, value_name = "FILE.parquet")]
    out: Option<PathBuf>,

    /// Accuracy of the distances, mm
    #[arg(long, value_name = "MM", default_value_t = 0.001)]
    tolerance: f64,

    /// Also lists files that are the same
    #[arg(long)]
    all: bool,

    /// How many files are processed at the same time; default: the number of processors
    #[arg(long, short, value_name = "N")]
    jobs: Option<usize>,

    #[command(flatten)]
    machines: Machines,
}

pub fn run(args: &Args, terminal: Terminal) -> Result<Verdict, Failure> {
    for folder in [&args.released, &args.returned] {
        if !folder.is_dir() {
            let message = format!("{} is not a folder", folder.display());
            return Err(Failure::wrong(message, "name the released folder, then the returned one"));
        }
    }
    if !(args.tolerance > 0.0 && args.tolerance.is_finite()) {
        let message = format!("a tolerance of {} mm is not above zero", args.tolerance);
        return Err(Failure::wrong(message, "0.001 is a thousandth of a millimetre"));
    }
    if let Some(out) = &args.out {
        super::check::keep_programs(out)?;
    }
    let roots = [args.released.clone(), args.returned.clone()];
    let disk = Disk::new(args.machines.request(None), &roots)?;
    let meter = Meter::new(0, false, terminal);
    let (released, returned) = (&args.released, &args.returned);
    let rows =
        compare_all(released, returned, jobs(args.jobs), args.tolerance, || disk.again(), &meter);
    if let Some(out) = &args.out {
        let table = write_table(&rows, Vec::new());
        let table = table.map_err(|error| Failure::write(out.to_string_lossy(), &error))?;
        output::write_whole(out, &table)?;
    }
    match args.format {
        AnswerFormat::Text => say(&text(&rows, args.all))?,
        AnswerFormat::Json => say(&json(&rows)?)?,
    }
    let is_clean = |row: &DiffRow| matches!(row.status, Status::Same | Status::Text);
    Ok(if rows.iter().all(is_clean) { Verdict::Clean } else { Verdict::Problems })
}

fn json(rows: &[DiffRow]) -> Result<String, Failure> {
    let document = serde_json::json!({ "schema": "chordal.diff/1", "files": rows });
    Ok(format!("{document:#}\n"))
}

fn text(rows: &[DiffRow], all: bool) -> String {
    let mut table = plain_table(&["file", "change", "how"], 3);
    for row in rows.iter().filter(|row| all || row.status != Status::Same) {
        table.add_row([row.path.as_str(), row.status.word(), &how(row)]);
    }
    let count = |status: Status| rows.iter().filter(|row| row.status == status).count() as u64;
    let counts = Status::ALL.iter().filter(|status| count(**status) > 0);
    let counts: Vec<String> =
        counts.map(|status| format!("{} {}", count(*status), status.word())).collect();
    let total = counted(rows.len() as u64, "file", "files");
    let listed = if table.row_count() > 0 { format!("{table}\n\n") } else { String::new() };
    format!("{listed}{total}: {}\n", counts.join(", "))
}

fn how(row: &DiffRow) -> String {
    let mut parts = Vec::new();
    if let Some((low, high)) = row.distance_mm {
        parts.push(if high == 0.0 {
            "the same points, divided or ordered differently".to_string()
        } else if low < 0.000_05 {
            format!("at most {:.4} mm apart", high.max(0.0001))
        } else {
            format!("{low:.4} to {high:.4} mm apart")
        });
    }
    if let Some((before, after)) = row.lines {
        parts.push(match before == after {
            true => format!("from line {before}"),
            false => format!("from lines {before} and {after}"),
        });
    }
    if row.status == Status::Path && row.feeds_differ == Some(true) {
        parts.push("other feeds or speeds".into());
    }
    if matches!(row.status, Status::Path | Status::Feeds) && row.functions_differ == Some(true) {
        parts.push("other functions".into());
    }
    parts.extend(row.message.clone());
    parts.join(", ")
}
