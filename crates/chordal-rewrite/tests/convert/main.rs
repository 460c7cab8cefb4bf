//! Programs of one control carried over to the others.

mod cycles;
mod documents;
mod five_axes;
mod forms;
mod heidenhain;
mod heidenhain_random;
mod kept;
mod lathes;
mod posted;
mod random;
mod rotary;
mod suite;

use std::path::Path;

use chordal::{Job, Machine, Source, SourceMap};
use chordal_rewrite::convert::{Conversion, ConversionOptions, convert};

/// A machine of each control.
const MACHINES: [&str; 5] =
    ["fadal-4020", "haas-vf2", "fanuc-30i", "mitsubishi-m700", "linuxcnc-mill"];

fn machine(name: &str) -> Machine {
    let mut machine = Machine::from_builtin(name).expect("a built-in machine");
    if name == "haas-vf2" {
        // How fast F turns A there is a setting.
        machine.set("settings.\"Setting 34\"=\"4 in\"").expect("a setting of a Haas");
    }
    machine
}

fn job(text: &str, machine: Machine) -> Job<'static> {
    let mut sources = SourceMap::new();
    sources.add(Source::new("program", text.as_bytes().to_vec()));
    Job::new(sources, machine).expect("good settings")
}

/// The paths of all programs of some folders of the suite, from the root of the project.
#[allow(clippy::disallowed_methods, reason = "tests read folders")]
fn suite_programs(folders: &[&str]) -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut paths = Vec::new();
    for folder in folders {
        let folder = format!("tests/suite/{folder}");
        let entries = std::fs::read_dir(root.join(&folder)).expect("the suite");
        let names = entries.flatten().map(|entry| entry.file_name());
        let mut names: Vec<String> =
            names.map(|name| name.to_string_lossy().into_owned()).collect();
        names.sort();
        paths.extend(names.into_iter().map(|name| format!("{folder}/{name}")));
    }
    paths
}

/// The text of a program of the repository.
fn text_of(path: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    #[allow(clippy::disallowed_methods, reason = "tests read programs")]
    let bytes = std::fs::read(root.join(path)).expect("the program");
    String::from_utf8_lossy(&bytes).into_owned()
}

/// The job of a program of the repository, on the machine that its remarks say.
fn job_of(text: &str, set: &[&str]) -> Job<'static> {
    let remark = |mark: &str| {
        let start = text.find(mark)? + mark.len();
        text[start..].split(')').next()
    };
    let mut own = machine(remark("(machine: ").unwrap_or("fanuc-30i"));
    let remarks = text.match_indices("(set: ").filter_map(|(at, mark)| {
        text[at + mark.len()..].split(['\n']).next()?.trim_end().strip_suffix(')')
    });
    for assignment in remarks.chain(set.iter().copied()) {
        own.set(assignment).expect("a good assignment");
    }
    job(text, own)
}

fn converted(job: &Job, to: &str) -> Conversion {
    convert(job, &machine(to), &ConversionOptions::default())
}

/// What became of programs on several machines, for a golden file.
#[derive(Default)]
struct VerdictTable {
    text: String,
    proved: usize,
    all: usize,
}

impl VerdictTable {
    /// Adds a program, converted to each of these machines.
    fn add(&mut self, name: &str, old: &Job, machines: &[&str]) {
        self.text += &format!("{name}\n");
        for to in machines {
            let found = converted(old, to);
            self.all += 1;
            self.proved += usize::from(found.holds());
            self.text += &format!("    {to}: {}\n", verdict(&found));
        }
    }

    fn finish(self) -> String {
        format!("{}\n{} of {} proved\n", self.text, self.proved, self.all)
    }
}

/// What a conversion came to, in a line.
fn verdict(found: &Conversion) -> String {
    if let Some(refusal) = found.refusals.first() {
        return format!("refused, line {}: {}", refusal.line, refusal.reason);
    }
    let Some(certificate) = &found.certificate else { return "no text".into() };
    let comparison = &certificate.comparison;
    let apart = comparison.max_distance_mm.map_or_else(String::new, |mm| {
        // What rounding leaves is not for golden files.
        if mm > 1e-9 { format!(", {mm:.6} mm apart") } else { String::new() }
    });
    let mut words: Vec<&str> =
        comparison.differences.iter().map(|one| one.category.word()).collect();
    words.dedup();
    match certificate.holds() {
        true if certificate.tool_center.is_some() => format!("proved by its contours{apart}"),
        true => format!("proved{apart}"),
        false => format!("differs: {}{apart}", words.join(", ")),
    }
}
