//! Faults of other kinds than those of `planted.rs`, planted in the right programs of `tests/posts`: each must be found
//! in its line, with the severity and a code that its row in the table says.

#![allow(clippy::disallowed_methods, reason = "reads the programs of the tree")]

#[path = "../faults/mod.rs"]
#[allow(dead_code, reason = "its kinds are those of the other tests")]
mod faults;
mod kinds;
#[path = "../labelled/mod.rs"]
mod labelled;
mod plants;
#[path = "../post_set/mod.rs"]
mod post_set;
mod set;

use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, OnceLock};

use chordal::{Code, Machine, Report, Severity};
use faults::Part;
use kinds::{Expected, KINDS, Kind, Plant};
use labelled::line_of;

/// Plants of a kind in the programs of one control: so many programs, and one place in each.
const PLANTS_OF_CONTROL: usize = 4;

/// So many faults are planted at least, of so many kinds.
const FEWEST_PLANTS: usize = 500;
const FEWEST_KINDS: usize = 20;

/// Where the choice of programs and places begins.
const SEED: u64 = 40;

/// Programs of the set with an error on the control that they were written for. The errors are those that the typical
/// machine of the control gives: K beside G17 (FreeCAD), words that the firmware refuses, an arc off its circle by more than GRBL
/// allows, no end on LinuxCNC, too little travel.
const WRONG_PROGRAMS: usize = 15;

/// The same on a further control of their label, as a text without an end on LinuxCNC.
const WRONG_ELSEWHERE: usize = 22;

/// Plants that are not found, by kind and control, with the reason.
const MISSED: &[(&str, &str, usize)] = &[
    // The programs of the set end in the coordinates of the machine (E0). The extent of an axis is held against the travel
    // only where its place in the machine is unknown at the end, because it has one extent for all work offsets.
    ("end far outside of the travel", "fadal", 4),
    // All X of the program follow the new one (G91): a work offset makes them fit.
    ("end far outside of the travel", "haas", 1),
];

/// Plants that are found where nobody names the control, of those of all kinds. The others need the named machine (its
/// speeds, travel and offsets), or the fault makes the text that of another control.
const FEWEST_FOUND_UNNAMED: usize = 1496;

/// Errors that say what Chordal was not given or does not carry out, and nothing of the program.
const NOT_KNOWN: &[Code] =
    &[Code::NotFollowed, Code::MissingSubprogram, Code::PocketWithoutDiameter];

/// A right program with its machine and what a check says of it.
struct RightProgram {
    part: Part,
    text: String,
    machine: Machine,
    said: Said,
    /// What a check says where nobody names the control.
    said_unnamed: OnceLock<Said>,
}

/// A diagnostic: line, code, severity.
type Said = BTreeSet<(usize, &'static str, Severity)>;

fn said(report: &Report, text: &str) -> Said {
    let said = report
        .diagnostics
        .iter()
        .map(|each| (line_of(text, each.primary.span), each.code.info().id, each.severity));
    said.collect()
}

/// Numbers that are the same on every machine (SplitMix64).
struct Choice(u64);

impl Choice {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) % end as u64) as usize
    }

    fn shuffle<T>(&mut self, all: &mut [T]) {
        for end in (1..all.len()).rev() {
            all.swap(end, self.below(end + 1));
        }
    }
}

/// The programs of the set, on the controls of their labels.
#[derive(Default)]
struct Set {
    right: BTreeMap<&'static str, Vec<RightProgram>>,
    count: usize,
    /// A line for each program with an error on the control that it was written for.
    wrong: Vec<String>,
    /// The same on a further control of its label.
    wrong_elsewhere: Vec<String>,
}

fn programs_of_set() -> Set {
    let mut set = Set::default();
    for program in set::programs() {
        set.count += 1;
        let loaded = program.load();
        let report = loaded.job().expect("a job").check();
        let mut errors = report.diagnostics.iter().filter(|each| each.severity == Severity::Error);
        if let Some(error) = errors.find(|each| !NOT_KNOWN.contains(&each.code)) {
            let (id, title) = (error.code.info().id, &program.title);
            let line = format!("{title} on {}: {id} {}", loaded.control(), error.message);
            let wrong = if program.is_own { &mut set.wrong } else { &mut set.wrong_elsewhere };
            wrong.push(line);
        } else if report.counts.errors == 0 {
            set.right.entry(loaded.control()).or_default().push(RightProgram {
                part: Part::new(&program.title, &loaded),
                said: said(&report, &program.text),
                said_unnamed: OnceLock::new(),
                machine: loaded.machine().clone(),
                text: program.text,
            });
        }
    }
    set
}

/// What a check must say of a plant.
fn is_found(expected: &Expected, plant: &Plant, before: &Said, after: &Said) -> bool {
    after.iter().any(|&(line, id, severity)| {
        let new = !before.iter().any(|&(at, other, _)| at == line && other == id);
        line == plant.place && new && severity >= expected.severity && expected.codes.contains(&id)
    })
}

/// Planted and found faults of a kind.
#[derive(Default)]
struct Count {
    planted: usize,
    found: usize,
    found_unnamed: usize,
}

/// A plant that is not found.
struct Missed {
    kind: &'static str,
    control: &'static str,
    text: String,
}

/// Plants a kind in some programs of each control of its row.
fn plant_kind(
    kind: &Kind,
    right: &BTreeMap<&'static str, Vec<RightProgram>>,
) -> (Count, Vec<Missed>) {
    let (mut count, mut missed) = (Count::default(), Vec::new());
    for expected in kind.expected {
        for control in expected.controls {
            let mut choice = Choice(SEED);
            let mut programs: Vec<_> = right.get(control).into_iter().flatten().collect();
            choice.shuffle(&mut programs);
            let plants = programs.into_iter().filter_map(|program| {
                let lines = program.part.lines.iter();
                let mut plants: Vec<_> =
                    lines.filter_map(|line| (kind.plant)(&program.part, line)).collect();
                // What is said there already is no place to see whether it is said.
                plants.retain(|plant| {
                    !program
                        .said
                        .iter()
                        .any(|&(line, id, _)| line == plant.place && expected.codes.contains(&id))
                });
                let chosen = (!plants.is_empty()).then(|| choice.below(plants.len()))?;
                Some((program, plants.swap_remove(chosen)))
            });
            for (program, plant) in plants.take(PLANTS_OF_CONTROL) {
                let text = program.part.planted(plant.line, &plant.new);
                let named = set::load_on(&text, &program.machine);
                let after = said(&named.job().expect("a job").check(), &text);
                count.planted += 1;
                if is_found(expected, &plant, &program.said, &after) {
                    count.found += 1;
                } else {
                    let new: Vec<_> = after.difference(&program.said).take(6).collect();
                    let text = format!(
                        "{}: {control}, {}, line {}: `{}` must be {:?} {:?} in line {}; new: {new:?}",
                        kind.name,
                        program.part.title,
                        plant.line,
                        plant.new,
                        expected.severity,
                        expected.codes,
                        plant.place
                    );
                    missed.push(Missed { kind: kind.name, control, text });
                }
                count.found_unnamed += usize::from(is_found_unnamed(kind, program, &plant, &text));
            }
        }
    }
    (count, missed)
}

/// Plants all kinds on all processors; the results in the order of the kinds.
fn plant_kinds(
    right: &BTreeMap<&'static str, Vec<RightProgram>>,
) -> Vec<(&'static Kind, Count, Vec<Missed>)> {
    let next = AtomicUsize::new(0);
    let found = Mutex::new(Vec::new());
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some((number, kind)) = Some(next.fetch_add(1, Ordering::Relaxed))
                    .and_then(|number| Some((number, KINDS.get(number)?)))
                {
                    let (count, missed) = plant_kind(kind, right);
                    found.lock().expect("no panic").push((number, kind, count, missed));
                }
            });
        }
    });
    let mut found = found.into_inner().expect("no panic");
    found.sort_by_key(|(number, ..)| *number);
    found.into_iter().map(|(_, kind, count, missed)| (kind, count, missed)).collect()
}

/// Found where nobody names the control: whichever it is taken for, a code of the kind stands in the line.
fn is_found_unnamed(kind: &Kind, program: &RightProgram, plant: &Plant, text: &str) -> bool {
    let before = program.said_unnamed.get_or_init(|| {
        let before = set::load(&program.text, None);
        said(&before.job().expect("a job").check(), &program.text)
    });
    let after = set::load(text, None);
    let after = said(&after.job().expect("a job").check(), text);
    kind.expected.iter().any(|expected| {
        let expected = Expected { severity: Severity::Warning, ..*expected };
        is_found(&expected, plant, before, &after)
    })
}

#[test]
fn every_planted_fault_of_another_kind_is_found_in_its_line() {
    let set = programs_of_set();
    let right: usize = set.right.values().map(Vec::len).sum();
    let (own, elsewhere) = (set.wrong.len(), set.wrong_elsewhere.len());
    println!("{right} of {} are right; {own} have an error, elsewhere {elsewhere}", set.count);
    set.wrong.iter().for_each(|line| println!("error: {line}"));
    set.wrong_elsewhere.iter().for_each(|line| println!("error elsewhere: {line}"));
    assert_eq!((own, elsewhere), (WRONG_PROGRAMS, WRONG_ELSEWHERE));
    let (mut together, mut missed) = (Count::default(), Vec::new());
    for (kind, of_kind, of_missed) in plant_kinds(&set.right) {
        missed.extend(of_missed);
        let Count { planted, found, found_unnamed } = of_kind;
        println!("{:<52} {found:>3} of {planted:>3}, unnamed {found_unnamed:>3}", kind.name);
        assert!(planted > 0, "{} is nowhere planted", kind.name);
        together.planted += planted;
        together.found += found;
        together.found_unnamed += found_unnamed;
    }
    let Count { planted, found, found_unnamed } = together;
    println!("together {found} of {planted}, unnamed {found_unnamed}, {} kinds", KINDS.len());
    assert!(planted >= FEWEST_PLANTS && KINDS.len() >= FEWEST_KINDS, "{planted} plants");
    assert!(found_unnamed >= FEWEST_FOUND_UNNAMED, "{found_unnamed} unnamed");
    // Each one that is not found is named, and each that is named is not found.
    let mut counts = BTreeMap::<(&str, &str), usize>::new();
    for each in &missed {
        *counts.entry((each.kind, each.control)).or_default() += 1;
    }
    let named: BTreeMap<_, _> =
        MISSED.iter().map(|(kind, control, n)| ((*kind, *control), *n)).collect();
    let texts: Vec<_> = missed.iter().map(|each| each.text.as_str()).collect();
    assert_eq!(counts, named, "{} missed:\n{}", missed.len(), texts.join("\n"));
}
