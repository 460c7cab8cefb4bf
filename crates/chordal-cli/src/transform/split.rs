//! `--split`: a program as several files.

use std::io::Write;
use std::path::{Path, PathBuf};

use chordal::Job;
use chordal::syntax::is_program_name;
use chordal_export::{OutputFormat, comparison_text, refusal_json, split_json};
use chordal_rewrite::{ProgramPart, SplitBy, SplitProgram, TransformedProgram, split};

use super::{TransformRequest, difference, refused};
use crate::failure::{CommandFailure, ExitVerdict};
use crate::numbers::{counted, grouped};
use crate::out::RowOutput;
use crate::terminal::say;

/// So many parts are shown with the lines that they begin with.
const MAX_SHOWN: usize = 8;

/// Parts a program, which may have been changed before.
pub fn run(
    job: &Job,
    by: SplitBy,
    request: &TransformRequest,
    before: Option<(&TransformedProgram, &Job)>,
) -> Result<ExitVerdict, CommandFailure> {
    let TransformRequest { args, loaded } = request;
    let done = match split(job, by) {
        Ok(done) => done,
        Err(refusal) => {
            match args.format {
                OutputFormat::Text => say(&refused(&refusal, loaded.name()))?,
                _ => say(&refusal_json(&refusal, loaded.name()))?,
            }
            return Ok(ExitVerdict::Problems);
        }
    };
    let holds = done.certificate.holds();
    let is_written = !args.dry_run && (holds || args.unproved);
    let mut written = Vec::new();
    if let Some(path) = args.output.as_ref().filter(|_| is_written) {
        written = names(path, done.parts.len());
        write(&written, &done.parts, &args.file)?;
    }
    let changed = before.map(|(changed, _)| changed);
    match args.format {
        OutputFormat::Text => {
            let changes = before.map(|(changed, old)| difference(changed, loaded, [old, job]));
            say(&(changes.unwrap_or_default() + &text(&done, job, by, request, &written)))?;
        }
        _ => {
            let names: Vec<String> =
                written.iter().map(|path| path.display().to_string()).collect();
            let old = before.map_or(job, |(_, old)| old);
            say(&split_json(&done, changed, [old, job], &names))?;
        }
    }
    Ok(if holds { ExitVerdict::Clean } else { ExitVerdict::Problems })
}

/// `part-1.nc` and so on, as wide as the last number.
fn names(path: &Path, count: usize) -> Vec<PathBuf> {
    let wide = count.to_string().len();
    let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let ending = path.extension().map(|ending| format!(".{}", ending.to_string_lossy()));
    let ending = ending.unwrap_or_default();
    (1..=count).map(|part| path.with_file_name(format!("{stem}-{part:0wide$}{ending}"))).collect()
}

/// No file is put in its place before all are written.
fn write(names: &[PathBuf], parts: &[ProgramPart], program: &Path) -> Result<(), CommandFailure> {
    let mut outs = Vec::new();
    for (name, part) in names.iter().zip(parts) {
        let mut out = RowOutput::open(Some(name), program, OutputFormat::Text)?;
        out.write_all(&part.text)?;
        outs.push(out);
    }
    outs.into_iter().try_for_each(RowOutput::put)
}

fn text(
    done: &SplitProgram,
    job: &Job,
    by: SplitBy,
    request: &TransformRequest,
    written: &[PathBuf],
) -> String {
    let count = counted(done.parts.len() as u64, "part", "parts");
    let mut text = match by {
        SplitBy::Bytes(most) => format!("{count} of at most {} bytes\n", grouped(most as u64)),
        SplitBy::Tool => format!("{count}, split before every tool change\n"),
    };
    for (index, part) in done.parts.iter().enumerate() {
        let number = part
            .number
            .filter(|number| !is_program_name(*number))
            .map_or(String::new(), |number| format!("O{number}: "));
        let begins = match (index, part.at_tool_change) {
            (0, _) => "",
            (_, true) => ", before a tool change",
            (_, false) => ", where the tool is clear of all cuts",
        };
        text += &format!(
            "{:>3}  {number}lines {} to {}, {} bytes{begins}\n",
            index + 1,
            part.lines[0],
            part.lines[1],
            grouped(part.text.len() as u64)
        );
        for line in part.begin.iter().take(if index < MAX_SHOWN { usize::MAX } else { 0 }) {
            text += &format!("     + {line}\n");
        }
    }
    for note in &done.notes {
        text += &format!("note: {note}\n");
    }
    let certificate = &done.certificate;
    text += "proof: the parts, run one after the other, against the whole program\n";
    text += &comparison_text(
        &certificate.comparison,
        ["whole", "parts"],
        [job, job],
        certificate.tolerance_mm,
    );
    let names: Vec<String> = written.iter().map(|path| path.display().to_string()).collect();
    text += &match (names.as_slice(), certificate.holds(), &request.args.output) {
        ([], true, None) => "nothing is written: give a file with -o\n".to_string(),
        ([], true, Some(_)) => "nothing is written: --dry-run\n".into(),
        ([], false, _) => "nothing is written: the proof failed (--unproved writes it)\n".into(),
        ([one], ..) => format!("written: {one}\n"),
        ([first, .., last], true, _) => format!("written: {first} to {last}\n"),
        ([first, .., last], false, _) => format!("written, but not proved: {first} to {last}\n"),
    };
    text
}
