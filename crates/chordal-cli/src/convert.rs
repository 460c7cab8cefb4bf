//! `chordal convert`: a program for another machine.

use std::collections::{BTreeMap, HashMap};
use std::io::Write;
use std::path::{Path, PathBuf};

use chordal::Job;
use chordal_compare::{Category, ComparisonOptions as Comparing};
use chordal_export::format::ANSWER_FORMATS;
use chordal_export::{
    OutputFormat, comparison_headline, conversion_json, difference_text, length_text,
};
use chordal_load::machine;
use chordal_rewrite::convert::{Conversion, ConversionOptions, convert};
use chordal_rewrite::{Certificate, Change};

use crate::compare::{length_mm, picture};
use crate::failure::{CommandFailure, ExitVerdict};
use crate::formats::format_parser;
use crate::numbers::{SummaryUnits, counted};
use crate::options::CommonArgs;
use crate::out::{RowOutput, trouble};
use crate::programs::{load_one, recognized};
use crate::terminal::{TerminalSupport, say};
use crate::view::{self, GeneratedProgram};

const EXAMPLES: &str = "\
Examples:
  chordal convert part.nc --to haas-vf2                    what would change, and the proof
  chordal convert part.nc --machine fadal-4020 --to haas-vf2 -o part-haas.nc
  chordal convert part.nc --to haas-vf2 -o - | diff part.nc -
  chordal convert part.nc --to fanuc-30i --tolerance 0.005mm -o part-fanuc.nc
  chordal convert part.nc --to haas-vf2 --view             both paths in one picture
  chordal convert part.nc --to mill.toml --certificate proof.json -o part-mill.nc

The program is run on its own machine, written again for the other one, and run there. Both runs are
compared, move by move, with the same tools and work offsets. Nothing is written if something cannot be
converted or if the motion is not the same, unless --unproved asks for it.

Exit code: 0 converted and proved, 1 not, 2 wrong use.";

/// Writes a program for another machine, and proves that the cut is the same
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The program; `-` is standard input
    file: PathBuf,

    /// The machine to write it for: a built-in name or a machine file
    #[arg(long, value_name = "NAME|FILE.toml")]
    to: String,

    /// Writes the new program to this file, `-` to standard output; without it, only the changes are shown
    #[arg(long, short, value_name = "OUT")]
    output: Option<PathBuf>,

    /// How far the path may be from the old one where a curve must be written as other curves
    #[arg(long, value_name = "LENGTH", value_parser = length_mm, default_value = "0.005mm")]
    tolerance: f64,

    /// Decimals of computed words; without it, as many as the control keeps
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(0..=9))]
    digits: Option<u8>,

    /// Writes the certificate here, as JSON
    #[arg(long, value_name = "FILE")]
    certificate: Option<PathBuf>,

    /// Draws both paths in one picture, .svg or .png: the old one as a band
    #[arg(long, value_name = "OUT")]
    picture: Option<PathBuf>,

    /// Shows both paths in one picture in the browser, and the differences, until Ctrl-C
    #[arg(long)]
    view: bool,

    /// Converts a program that has errors on its own control
    #[arg(long)]
    despite_errors: bool,

    /// Writes cycles out as moves where the new machine makes their pecks or passes in other steps
    #[arg(long)]
    exact_cycles: bool,

    /// Writes the positions of the axes in place of the tip of the tool (tool centre point control, tilted planes), on the
    /// same control too; another control always gets them
    #[arg(long)]
    axes: bool,

    /// Writes the program even if the motion is not the same
    #[arg(long)]
    unproved: bool,

    /// Format of the answer
    #[arg(long, value_parser = format_parser(&ANSWER_FORMATS), default_value = "text")]
    format: OutputFormat,

    #[command(flatten)]
    common: CommonArgs,
}

pub fn run(args: &Args, terminal: TerminalSupport) -> Result<ExitVerdict, CommandFailure> {
    let target = machine::named(&args.to)?;
    let loaded = load_one(&args.file, &args.common)?;
    let job = loaded.job()?;
    terminal.write_error(&recognized(&loaded));
    let options = ConversionOptions {
        tolerance_mm: args.tolerance,
        digits: args.digits.map(usize::from),
        despite_errors: args.despite_errors,
        exact_cycles: args.exact_cycles,
        axis_positions: args.axes,
    };
    let found = convert(&job, &target, &options);
    if let Some(path) = &args.certificate {
        write(path, &args.file, &conversion_json(&found, &job))?;
    }
    let may_write = found.holds() || (args.unproved && !found.text.is_empty());
    let output = args.output.as_deref();
    let streams = output == Some(Path::new("-"));
    let answer = match args.format {
        OutputFormat::Text => text(&found, &job, may_write, output),
        _ => conversion_json(&found, &job),
    };
    if let (Some(path), Some(new), Some(certificate)) =
        (&args.picture, found.job("new"), &found.certificate)
    {
        let units = SummaryUnits::of(certificate.comparison.reports[0].summary.inch);
        let about = comparison_headline(&certificate.comparison, units, certificate.tolerance_mm);
        let names = [job.machine().name.clone(), found.machine.name.clone()];
        picture(path, [&job, &new], names, &about)?;
    }
    if let Some(path) = output.filter(|_| may_write && !streams) {
        write(path, &args.file, &found.text)?;
    }
    if streams {
        terminal.write_error(&answer);
    } else {
        say(&answer)?;
    }
    if streams && may_write {
        say(&found.text)?;
    }
    if args.view && !found.text.is_empty() {
        let made = GeneratedProgram {
            how: "converted",
            file: output.filter(|_| may_write && !streams),
            text: found.text.clone().into_bytes(),
            machine: found.machine.clone(),
            // As in the proof: both begin at the same place, and both machines have the same tables.
            options: Comparing {
                tolerance_mm: args.tolerance,
                feed_tolerance: 1e-5,
                assume_known: true,
                ..Comparing::default()
            },
        };
        view::show_pair(&args.file, loaded.text(), &args.common, made, terminal)?;
    }
    Ok(if found.holds() { ExitVerdict::Clean } else { ExitVerdict::Problems })
}

fn write(path: &Path, program: &Path, text: &str) -> Result<(), CommandFailure> {
    let mut out = RowOutput::open(Some(path), program, OutputFormat::Text)?;
    out.write_all(text.as_bytes()).map_err(|error| trouble(Some(path), error))?;
    out.put()
}

fn text(found: &Conversion, job: &Job, may_write: bool, output: Option<&Path>) -> String {
    let [from, to] = [&job.machine().name, &found.machine.name];
    let mut text = format!("{from} to {to}: ");
    let changes = counted(found.changes.len() as u64, "change", "changes");
    let refused = counted(found.refusals.len() as u64, "block", "blocks");
    let within = found.certificate.as_ref().is_some_and(|certificate| {
        certificate.comparison.verdict == chordal_compare::ComparisonVerdict::Within
    });
    let but = match (found.pecks.is_empty(), found.passes.is_empty()) {
        (true, true) => "",
        (false, true) => " except for pecks",
        (true, false) => " except for the passes of cycles",
        (false, false) => " except for pecks and the passes of cycles",
    };
    text += &match (found.holds(), found.refusals.is_empty()) {
        (true, _) if within => {
            format!("{changes}; the motion is the same within the tolerance{but}\n")
        }
        (true, _) => format!("{changes}; the motion is the same{but}\n"),
        (false, true) => format!("{changes}; the motion is not the same\n"),
        (false, false) if found.refusals.iter().all(|refusal| refusal.line == 0) => {
            "the program cannot be converted\n".to_string()
        }
        (false, false) => format!("{refused} cannot be converted\n"),
    };
    for refusal in &found.refusals {
        text += &match refusal.line {
            // It is about the program as a whole.
            0 => format!("\n{}\n", refusal.reason),
            line => format!("\nline {line}  {}\n  {}\n", refusal.words, refusal.reason),
        };
    }
    if !found.changes.is_empty() {
        text += "\nchanges\n";
    }
    for (change, lines) in grouped(&found.changes) {
        text += &shown(change, &lines);
    }
    if let Some(certificate) = &found.certificate {
        text += &proof(found, certificate, job);
        let units = SummaryUnits::of(certificate.comparison.reports[0].summary.inch);
        text += &crate::pecks::text(&found.pecks, [from, to], units);
        text += &crate::passes::text(&found.passes, [from, to], units);
    }
    let Some(path) = output.filter(|path| *path != Path::new("-")) else { return text };
    text += &match may_write {
        true => format!("\nwrote {}\n", path.display()),
        false => format!(
            "\n{} is not written: correct the problems above first, or use --unproved\n",
            path.display()
        ),
    };
    text
}

/// The same change on many lines is reported once, with its lines.
fn grouped(changes: &[Change]) -> Vec<(&Change, Vec<u32>)> {
    let mut groups: Vec<(&Change, Vec<u32>)> = Vec::new();
    let mut known: HashMap<[&str; 3], usize> = HashMap::new();
    for change in changes {
        let key = [change.before.as_str(), change.after.as_str(), change.reason.as_str()];
        let at = *known.entry(key).or_insert_with(|| {
            groups.push((change, Vec::new()));
            groups.len() - 1
        });
        groups[at].1.push(change.line);
    }
    groups
}

/// Lines of the new text, and numbers of lines, that a change is shown with.
const MAX_LINES: usize = 4;

fn shown(change: &Change, at: &[u32]) -> String {
    let after: Vec<&str> = change.after.lines().collect();
    let after = match after.as_slice() {
        [] => "(nothing)".into(),
        [one] => (*one).to_string(),
        many if many.len() <= MAX_LINES => many.join(" | "),
        many => format!("{} | … {} lines", many[..2].join(" | "), many.len()),
    };
    let before = if change.before.is_empty() { "(nothing)" } else { &change.before };
    let first: Vec<String> = at.iter().take(MAX_LINES).map(u32::to_string).collect();
    let more = match at.len().saturating_sub(MAX_LINES) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    let lines = if at.len() == 1 { "line" } else { "lines" };
    let first = first.join(", ");
    format!("  {lines} {first}{more}: {before} -> {after}\n      {}\n", change.reason)
}

fn proof(found: &Conversion, certificate: &Certificate, job: &Job) -> String {
    let Some(new) = found.job("the new program") else { return String::new() };
    let comparison = &certificate.comparison;
    let units = SummaryUnits::of(comparison.reports[0].summary.inch);
    let mut text =
        format!("\nproof: {}", comparison_headline(comparison, units, certificate.tolerance_mm));
    let names = ["old", "new"];
    let jobs = [job, &new];
    for one in comparison.differences.iter().take(20) {
        text += &difference_text(one, names, jobs, units);
    }
    if let Some(center) = &certificate.tool_center {
        let most = center.max_distance_mm.map_or_else(String::new, |most| {
            format!(", up to {} from each other", length_text(most, units))
        });
        text += &format!(
            "  the contours are as programmed; each control compensates in its own way{most}\n"
        );
    }
    let mut expected = BTreeMap::new();
    for one in &certificate.expected {
        if one.category == Category::Problem {
            text += &difference_text(one, names, jobs, units);
            continue;
        }
        *expected.entry(one.category.word()).or_insert(0) += one.times;
    }
    for (word, count) in expected {
        let times = counted(count, "difference", "differences");
        text += &format!("  {word}: {times}, because of the machines, not of the text\n");
    }
    text
}
