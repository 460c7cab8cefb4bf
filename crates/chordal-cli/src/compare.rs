use std::path::{Path, PathBuf};

use chordal::Job;
use chordal::machine::Dimension;
use chordal_compare::{Category, Comparison, Difference, Options, Verdict as Answer, compare};
use chordal_export::{Plot, PlotOptions, comparison_json, value_text};

use crate::failure::{Failure, Verdict};
use crate::numbers::{Units, counted, grouped, short};
use crate::options::{AnswerFormat, Common, quantity};
use crate::output::write_whole;
use crate::session::{Loaded, load_one};
use crate::terminal::{Terminal, say};

const EXAMPLES: &str = "\
Examples:
  chordal compare released.nc returned.nc
  chordal compare old.nc new.nc --tolerance 0.01mm      up to a hundredth apart is no difference
  chordal compare part.nc --as fadal-4020 --as haas-vf2  one program on two machines
  chordal compare fadal.nc haas.nc --as fadal-4020 --as haas-vf2
  chordal compare old.nc new.nc -o both.svg             a picture of both over one another
  chordal compare old.nc new.nc --ignore feed --ignore spindle
  chordal compare old.nc new.nc --format json | jq .max_distance_mm

What the programs do is compared, not their text: numbers of blocks, spaces, subprograms, units,
and how lines and arcs are cut make no difference. The distance holds for two who walk the paths
together from beginning to end, cuts and rapids in their order; nowhere are they further apart.

Exit code: 0 the same, or within the tolerance, 1 different, 2 wrong use.";

/// Holds the motion of two programs, or of one on two machines, against each other
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The program
    a: PathBuf,

    /// The other one; left out, the same program on another machine
    b: Option<PathBuf>,

    /// The machine of a program: once for each, in their order
    #[arg(long = "as", value_name = "NAME|FILE.toml", conflicts_with = "machine")]
    machines: Vec<String>,

    /// Paths this far apart are no difference, as 0.01mm or 0.0005in
    #[arg(long, value_name = "LENGTH", value_parser = length_mm, default_value = "0mm")]
    tolerance: f64,

    /// Feeds and speeds that differ by this part are no difference
    #[arg(long, value_name = "PART", default_value_t = 1e-6)]
    feed_tolerance: f64,

    /// What is no difference, whatever it is: feed, spindle, coolant, …
    #[arg(long, value_name = "CATEGORY", value_parser = category)]
    ignore: Vec<Category>,

    /// Draws both over one another, as .svg or .png: the first as a band, the second as a line
    #[arg(long, short, value_name = "OUT")]
    output: Option<PathBuf>,

    /// How the answer is told
    #[arg(long, value_enum, default_value = "text")]
    format: AnswerFormat,

    #[command(flatten)]
    common: Common,
}

/// Most differences that are told to people.
const MOST_TOLD: usize = 20;

fn category(text: &str) -> Result<Category, String> {
    Category::ALL.into_iter().find(|category| category.word() == text).ok_or_else(|| {
        let words: Vec<&str> = Category::ALL.iter().map(|category| category.word()).collect();
        format!("one of {} is due", words.join(", "))
    })
}

/// A length of zero or more with its unit, or in mm without.
pub fn length_mm(text: &str) -> Result<f64, String> {
    let bare = text.trim().parse().map_err(|_| ());
    let mm: f64 = bare.or_else(|()| quantity(text, Dimension::Length))?;
    if mm >= 0.0 && mm.is_finite() { Ok(mm) } else { Err("a length of zero or more is due".into()) }
}

pub fn run(args: &Args, terminal: Terminal) -> Result<Verdict, Failure> {
    let [a, b] = sides(args)?;
    let (a, b) = (load_one(a.0, &a.1)?, load_one(b.0, &b.1)?);
    let jobs = [a.job()?, b.job()?];
    let jobs = [&jobs[0], &jobs[1]];
    for (loaded, job) in [&a, &b].into_iter().zip(jobs) {
        let told = loaded.chosen.told(loaded.name(), job.control().table.title);
        terminal.tell(&told.unwrap_or_default());
    }
    let options = Options {
        tolerance_mm: args.tolerance,
        feed_tolerance: args.feed_tolerance,
        ignored: args.ignore.clone(),
        ..Options::default()
    };
    let found = compare(jobs[0], jobs[1], &options);
    if let Some(path) = &args.output {
        let units = Units::of(found.reports[0].summary.inch);
        let about = headline(&found, units, args.tolerance);
        picture(path, jobs, names([&a, &b], jobs), &about)?;
    }
    match args.format {
        AnswerFormat::Text => say(&text(&found, [&a, &b], jobs, args.tolerance))?,
        AnswerFormat::Json => say(&comparison_json(&found, jobs, args.tolerance))?,
    }
    Ok(if found.verdict == Answer::Different { Verdict::Problems } else { Verdict::Clean })
}

/// Writes both paths over one another, under their names and a line about them.
pub fn picture(
    path: &Path,
    jobs: [&Job; 2],
    names: [String; 2],
    subtitle: &str,
) -> Result<(), Failure> {
    let ending = path.extension().map(|ending| ending.to_ascii_lowercase());
    let is_png = match ending.as_deref().and_then(|ending| ending.to_str()) {
        Some("svg") => false,
        Some("png") => true,
        _ => {
            return Err(Failure::wrong(
                format!("the ending of {} says no format of pictures", path.display()),
                "the endings are .svg and .png",
            ));
        }
    };
    let options = PlotOptions {
        title: format!("{} and {}", names[0], names[1]),
        subtitle: subtitle.trim_end().to_string(),
        ..PlotOptions::default()
    };
    let plot = Plot::overlay(jobs, names);
    let content = match is_png {
        false => plot.svg(&options).into_bytes(),
        true => plot
            .png(&options)
            .map_err(|error| Failure::wrong(error.to_string(), "write an .svg"))?,
    };
    write_whole(path, &content)
}

/// The two programs, each with its options.
fn sides(args: &Args) -> Result<[(&PathBuf, Common); 2], Failure> {
    let on = |machine: Option<&String>| {
        let machine = machine.or(args.common.machine.as_ref()).cloned();
        Common { machine, ..args.common.clone() }
    };
    let machines = args.machines.as_slice();
    match (&args.b, machines) {
        (Some(b), [] | [_, _]) => Ok([(&args.a, on(machines.first())), (b, on(machines.get(1)))]),
        (None, [first, second]) => Ok([(&args.a, on(Some(first))), (&args.a, on(Some(second)))]),
        (None, [second]) => Ok([(&args.a, on(None)), (&args.a, on(Some(second)))]),
        (None, []) => Err(Failure::wrong(
            "there is one program and nothing to hold it against",
            "name another program, or another machine with --as",
        )),
        (Some(_), [_]) => Err(Failure::wrong(
            "--as is given once for two programs",
            "give it twice, in the order of the programs, or --machine for both",
        )),
        (_, [_, _, _, ..]) => {
            Err(Failure::wrong("--as is given more than twice", "give it once for each program"))
        }
    }
}

fn text(found: &Comparison, loaded: [&Loaded; 2], jobs: [&Job; 2], tolerance_mm: f64) -> String {
    let names = names(loaded, jobs);
    told(found, [&names[0], &names[1]], jobs, tolerance_mm)
}

/// A comparison for people, the two called by these names.
pub fn told(found: &Comparison, names: [&str; 2], jobs: [&Job; 2], tolerance_mm: f64) -> String {
    let units = Units::of(found.reports[0].summary.inch);
    let names = names.map(str::to_string);
    let mut text = headline(found, units, tolerance_mm);
    if let Some(at) = found.farthest {
        let [a, b] = [0, 1].map(|side: usize| format!("{}:{}", names[side], at[side].line));
        text += &format!("furthest apart at {a} and {b}\n");
    }
    for (name, report) in names.iter().zip(&found.reports) {
        if report.counts.errors > 0 {
            let errors = counted(report.counts.errors, "error", "errors");
            text += &format!("{name}: {errors}; `chordal check` tells them\n");
        }
    }
    for one in found.differences.iter().take(MOST_TOLD) {
        text += &difference(one, &names, jobs, units);
    }
    let more = found.differences.len().saturating_sub(MOST_TOLD) as u64 + found.dropped;
    if more > 0 {
        text += &format!("\nand {}\n", counted(more, "difference more", "differences more"));
    }
    text
}

pub fn headline(found: &Comparison, units: Units, tolerance_mm: f64) -> String {
    let total = found.differences.len() as u64 + found.dropped;
    let differences = counted(total, "difference", "differences");
    match (found.verdict, found.max_distance_mm) {
        (Answer::Same, None) if found.moves == [0, 0] => "same: neither moves\n".into(),
        (Answer::Same, None) => {
            "same as far as can be said: no move lies between places that are known \
                                 relative to the part\n"
                .into()
        }
        (Answer::Same, Some(_)) => format!(
            "same: {}\n",
            match found.moves {
                [a, b] if a == b => counted(a, "move", "moves"),
                [a, b] => format!("the motion of {a} moves in {b}"),
            }
        ),
        (Answer::Within, most) => {
            let most = length(most.unwrap_or_default(), units);
            format!(
                "within: the paths are at most {most} apart, {} are allowed\n",
                length(tolerance_mm, units)
            )
        }
        (Answer::Different, None) => format!("different: {differences}\n"),
        (Answer::Different, Some(most)) if most <= chordal_compare::SAME_MM => {
            format!("different: {differences}; the paths are the same\n")
        }
        (Answer::Different, Some(most)) => {
            format!(
                "different: {differences}; the paths are at most {} apart\n",
                length(most, units)
            )
        }
    }
}

/// How the two are called: by their names, or by their machines where it is one program.
fn names(loaded: [&Loaded; 2], jobs: [&Job; 2]) -> [String; 2] {
    let names = loaded.map(|loaded| loaded.name().to_string());
    if names[0] != names[1] {
        let short = names.each_ref().map(|name| {
            Path::new(name).file_name().map(|name| name.to_string_lossy().into_owned())
        });
        return match short {
            [Some(a), Some(b)] if a != b => [a, b],
            _ => names,
        };
    }
    jobs.map(|job| job.machine().name.clone())
}

pub fn difference(one: &Difference, names: &[String; 2], jobs: [&Job; 2], units: Units) -> String {
    let mut head = format!("\n{}", one.category.word());
    if let Some(distance) = one.distance_mm {
        head += &format!(": at most {} apart", length(distance, units));
    }
    if let Some(shift) = one.shift_mm {
        let shift = shift.map(|mm| length(mm, units));
        head += &format!(", moved by X {} Y {} Z {}", shift[0], shift[1], shift[2]);
    }
    if one.times > 1 {
        head += &format!(", {} times", grouped(one.times));
    }
    let mut text = head + "\n";
    let places = [0, 1].map(|side: usize| match &one.blocks[side] {
        None => names[side].clone(),
        Some(at) => match at.lines() {
            (from, to) if from == to => format!("{}:{from}", names[side]),
            (from, to) => format!("{}:{from}-{to}", names[side]),
        },
    });
    let width = places.iter().map(|place| place.chars().count()).max().unwrap_or(0);
    for side in 0..2 {
        let lacks = one.steps[side] == 0;
        let words = one.blocks[side].as_ref().map_or_else(String::new, |at| {
            let words = jobs[side].sources().words(at.first.span).trim().to_string();
            if lacks { format!("(lacks it; after {words})") } else { words }
        });
        let value = one
            .values
            .as_ref()
            .map_or_else(String::new, |values| format!("  {}", value_text(&values[side], units)));
        let moves = match one.steps[side] {
            0 | 1 => String::new(),
            steps => format!("  ({})", counted(steps, "block", "blocks")),
        };
        text += format!("  {:width$}{value}  | {words}{moves}", places[side]).trim_end();
        text.push('\n');
    }
    text
}

/// To a hundredth of a micrometre: what is less is written as a power of ten.
pub fn length(mm: f64, units: Units) -> String {
    let value = mm / units.length_mm();
    let text =
        if value == 0.0 || value.abs() >= 1e-4 { short(value, 5) } else { format!("{value:.1e}") };
    format!("{text} {}", units.length_unit())
}
