//! `chordal restart`: a program that begins at one of its lines, with a proof.

use std::io::Write;
use std::path::{Path, PathBuf};

use chordal::stock::ApproachCheck;
use chordal_export::format::ANSWER_FORMATS;
use chordal_export::{OutputFormat, restart_json};
use chordal_rewrite::TransformRefusal;
use chordal_rewrite::restart::{
    RestartProgram, UnrepeatedCode, blocked, check_head_approach, restart,
};

use crate::failure::{CommandFailure, ExitVerdict};
use crate::formats::format_parser;
use crate::numbers::counted;
use crate::options::CommonArgs;
use crate::out::{RowOutput, trouble};
use crate::programs::{load_one, recognized};
use crate::setup_files::files;
use crate::stock_failure::failure_of;
use crate::terminal::{TerminalSupport, say};

/// How many codes that are not repeated an answer names.
const SHOWN_CODES: usize = 12;

const EXAMPLES: &str = "\
Examples:
  chordal restart part.nc --line 120                 shows the lines that would be put in
  chordal restart part.nc --line 120 -o from120.nc   and writes the program if it is proved
  chordal restart part.nc --line 120 -o - | less
  chordal restart part.nc --line 120 --machine haas-vf2 -o from120.nc
  chordal restart shaft.nc --line 38 --setup shaft.toml -o from38.nc

The new program has the head that the control needs at that line (units, offsets, tool, spindle,
coolant, the way to the place), then the text from that line on, unchanged. Both programs are run
and compared from that line on; if anything differs, nothing is written.

Exit code: 0 proved, 1 refused, 2 wrong use.";

/// Writes a program that begins at a line of another, and proves that the rest is the same
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The program; `-` is standard input
    file: PathBuf,

    /// The line to begin at, from 1, as an editor counts lines
    #[arg(long, short, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    line: u32,

    /// Writes the new program to this file, `-` to standard output; without it, only the head is shown
    #[arg(long, short, value_name = "OUT")]
    output: Option<PathBuf>,

    /// Setup file of a lathe with its `[stock]`: the way in is looked at with what stands there
    #[arg(long, value_name = "TOML", conflicts_with = "machine")]
    setup: Option<PathBuf>,

    /// Format of the answer
    #[arg(long, value_parser = format_parser(&ANSWER_FORMATS), default_value = "text")]
    format: OutputFormat,

    #[command(flatten)]
    common: CommonArgs,
}

pub fn run(args: &mut Args, terminal: TerminalSupport) -> Result<ExitVerdict, CommandFailure> {
    args.common.set_up(args.setup.as_deref());
    let loaded = load_one(&args.file, &args.common)?;
    let job = loaded.job()?;
    terminal.write_error(&recognized(&loaded));
    let streams = args.output.as_deref() == Some(Path::new("-"));
    let mut course = None;
    let done = restart(&job, args.line);
    if let Ok(done) = &done {
        course = check_head_approach(&job, done, &files)
            .map_err(|error| failure_of(error, args.setup.as_deref()))?;
    }
    let is_blocked = |done: RestartProgram| match course
        .as_ref()
        .and_then(|course| blocked(&job, &done, course))
    {
        Some(refused) => Err(refused),
        None => Ok(done),
    };
    let done = match done.and_then(is_blocked) {
        Ok(done) => done,
        Err(refused) => {
            let answer = match args.format {
                OutputFormat::Text => refused_text(&refused.refusal, loaded.name()),
                _ => restart_json(Err(&refused), loaded.name(), None, None),
            };
            if streams {
                terminal.write_error(&answer)
            } else {
                say(&answer)?
            }
            return Ok(ExitVerdict::Problems);
        }
    };
    let path = args.output.as_deref();
    if path.is_some() {
        let out_path = path.filter(|_| !streams);
        let mut out = RowOutput::open(out_path, &args.file, OutputFormat::Text)?;
        out.write_all(&done.text).map_err(|error| trouble(out_path, error))?;
        out.put()?;
    }
    let written = path.filter(|_| !streams).map(|path| path.display().to_string());
    let answer = match args.format {
        OutputFormat::Text => text(&done, course.as_ref(), path),
        _ => restart_json(Ok(&done), loaded.name(), written.as_deref(), course.as_ref()),
    };
    if streams {
        terminal.write_error(&answer)
    } else {
        say(&answer)?
    }
    Ok(ExitVerdict::Clean)
}

fn refused_text(refusal: &TransformRefusal, name: &str) -> String {
    let words = match refusal.text.as_str() {
        "" => String::new(),
        words => format!("  | {words}\n"),
    };
    let TransformRefusal { line, what, help, .. } = refusal;
    format!("refused: {name}:{line}: {what}\n{words}  {help}\nnothing is written\n")
}

/// The codes that the head leaves out, the last ones by name.
fn not_repeated(codes: &[UnrepeatedCode]) -> String {
    if codes.is_empty() {
        return String::new();
    }
    let more = codes.len().saturating_sub(SHOWN_CODES);
    let names: Vec<String> =
        codes[more..].iter().map(|code| format!("{} (line {})", code.words, code.line)).collect();
    let before = if more > 0 { format!("{more} more, ") } else { String::new() };
    let names = names.join(", ");
    format!(
        "not repeated and not part of the proof: {before}{names}; set by hand what the rest needs of them\n"
    )
}

fn text(done: &RestartProgram, course: Option<&ApproachCheck>, path: Option<&Path>) -> String {
    let mut text = format!("begins at line {}\n", done.line);
    for line in &done.head {
        text += &format!("  + {line}\n");
    }
    if !done.after_the_end.is_empty() {
        text += "after the end of the program, for the cycles that take it\n";
    }
    for line in &done.after_the_end {
        text += &format!("  + {line}\n");
    }
    if done.approaches {
        text += "note: the program itself goes to its first place; retract the spindle before you start\n";
    }
    if done.from_the_start {
        text +=
            "note: the head repeats G92; the machine must stand where the whole program starts\n";
    }
    let moves = counted(done.moves, "move", "moves");
    text += &format!("proof: from this line on both programs do the same, {moves}\n");
    text += &not_repeated(&done.unrepeated);
    if let Some(course) = course {
        let moves = counted(course.moves, "move", "moves");
        text += &match &course.unknown {
            None => format!("way in: {moves}, free of what stands there\n"),
            Some(why) => format!("way in: {moves}, not proved free: {why}\n"),
        };
    }
    text += &match path {
        None => "nothing is written: give a file with -o\n".to_string(),
        Some(path) if path == Path::new("-") => String::new(),
        Some(path) => format!("written: {}\n", path.display()),
    };
    text
}
