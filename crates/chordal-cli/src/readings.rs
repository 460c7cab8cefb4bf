//! What a program would be on each control, where nothing in its text says which one it is for.

use chordal::Severity;
use chordal::control::{RunOptions, Strength};
use chordal::diagnostics::FileId;
use chordal::machine::ControlName;
use chordal::syntax::{Block, BlockReader};
use chordal_load::{Chosen, Loaded, machine};

use crate::numbers::counted;

/// A longer text is not run five times, bytes.
const LONGEST: usize = 64 * 1024;

/// Repeated blocks in each of these runs.
const MOST_REPEATED: u64 = 20_000;

/// The program on one control.
struct Reading {
    title: &'static str,
    machine: &'static str,
    inch: bool,
    errors: u64,
    warnings: u64,
    moves: String,
}

/// A few lines that ask for the control, with the reading under each; nothing where the control is known.
/// `problems`: the program has some on the control that was assumed.
pub fn asked(loaded: &Loaded, problems: bool) -> Option<String> {
    let Chosen::Recognized(found, _) = &loaded.chosen else { return None };
    if found.strength() != Strength::Assumed || loaded.size() > LONGEST {
        return None;
    }
    let has_units = names_units(loaded.text());
    if has_units && !problems {
        return None;
    }
    let readings: Vec<Reading> =
        ControlName::ALL.iter().filter_map(|name| reading(loaded, *name)).collect();
    let assumed = readings.iter().find(|reading| reading.machine == loaded.machine().name)?;
    let (title, units) = (assumed.title, unit(assumed.inch));
    let mut text = if has_units {
        format!(
            "{}: nothing in the text says which control it is for; {title} is assumed\n",
            loaded.name()
        )
    } else {
        format!(
            "{}: nothing in the text says which control it is for, nor its units; {title} in {units} is assumed\n",
            loaded.name()
        )
    };
    for reading in &readings {
        let Reading { title, machine, inch, errors, warnings, moves } = reading;
        let problems = format!(
            "{} and {}",
            counted(*errors, "error", "errors"),
            counted(*warnings, "warning", "warnings")
        );
        text += &format!(
            "  --machine {machine:<16} {title:<22} {:<5} {problems:<24} {moves}\n",
            unit(*inch)
        );
    }
    if !has_units {
        text += "  G20 or G21 in the program says its units\n";
    }
    Some(text)
}

fn unit(inch: bool) -> &'static str {
    if inch { "inch" } else { "mm" }
}

fn reading(loaded: &Loaded, name: ControlName) -> Option<Reading> {
    let machine = machine::typical(name);
    let shown = machine::typical_name(name);
    let options = RunOptions {
        max_repeated_blocks: MOST_REPEATED,
        assumed_machine: true,
        ..RunOptions::default()
    };
    let job = loaded.job_on(machine).ok()?.options(options);
    let report = job.report();
    let count =
        |severity| report.diagnostics.iter().filter(|d| d.severity == severity).count() as u64;
    let summary = &report.summary;
    let kinds = [
        (summary.lines, "line", "lines"),
        (summary.arcs, "arc", "arcs"),
        (summary.helices, "helix", "helices"),
        (summary.spirals, "spiral", "spirals"),
        (summary.splines, "spline", "splines"),
    ];
    let kinds = kinds.into_iter().filter(|(count, _, _)| *count > 0);
    let kinds: Vec<String> = kinds.map(|(n, one, more)| counted(n, one, more)).collect();
    let length = match summary.inch {
        true => format!("{:.3} in", summary.feed_length_mm / 25.4),
        false => format!("{:.2} mm", summary.feed_length_mm),
    };
    let moves = match kinds.is_empty() {
        true => "no cuts".to_string(),
        false => format!("{}, {length}", kinds.join(", ")),
    };
    Some(Reading {
        title: job.control().table.title,
        machine: shown,
        inch: summary.inch,
        errors: count(Severity::Error),
        warnings: count(Severity::Warning),
        moves,
    })
}

/// Some block says G20, G21, G70 or G71.
fn names_units(text: &[u8]) -> bool {
    let lexicon = chordal::syntax::Lexicon::FANUC_STYLE;
    let mut reader = BlockReader::new(text, FileId(0), lexicon);
    let mut block = Block::new();
    while reader.read(&mut block) {
        let unit = |word: &chordal::syntax::Word| {
            let code = word.number().and_then(|number| number.to_integer());
            matches!(code, Some(20 | 21 | 70 | 71))
        };
        if block.all(b'G').any(unit) {
            return true;
        }
    }
    false
}
