//! Differences planted into random programs, and into what is written of them: `diff`, `compare` and the proofs of `convert`,
//! `transform` and `restart` see every one, or ignore it by intent.
//!
//! `CHORDAL_ROUNDS` sets how many programs.

#[path = "shared/plant.rs"]
mod plant;
#[path = "shared/program.rs"]
mod program;

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::{AtomicU64, Ordering};

use chordal::{Job, Machine, Source, SourceMap};
use chordal_archive::diff::{DiffOptions, FileStatus, compare_files};
use chordal_archive::{FileLoader, PreparedFile};
use chordal_compare::{Category, ComparingCommand, ComparisonOptions, ComparisonVerdict, compare};
use chordal_rewrite::convert::{self, convert};
use chordal_rewrite::restart::{prove_head, restart};
use chordal_rewrite::{TransformStep, transform};

use plant::{KINDS, Kind};
use program::{Dice, program};

const MACHINES: [&str; 4] = ["fanuc-0i", "haas-vf2", "mitsubishi-m700", "linuxcnc-mill"];

fn machine(name: &str) -> Machine {
    let mut machine = Machine::from_builtin(name).expect("a built-in machine");
    for tool in 1..=8 {
        machine.set(&format!("tools.{tool}.diameter = 2 mm")).expect("a diameter");
        machine.set(&format!("tools.{tool}.length = {tool}0 mm")).expect("a length");
    }
    machine
}

fn job(text: &str, machine: &Machine) -> Job<'static> {
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text.as_bytes().to_vec()));
    Job::new(sources, machine.clone()).expect("good settings")
}

/// Two texts in the place of files.
struct Texts<'m>([String; 2], &'m Machine);

impl FileLoader for Texts<'_> {
    fn is_other_by_name(&self, _: &Path) -> bool {
        false
    }
    fn read(&mut self, path: &Path) -> Result<Vec<u8>, String> {
        Ok(self.0[usize::from(path == Path::new("new"))].clone().into_bytes())
    }
    fn may_be_program(&self, _: &[u8]) -> bool {
        true
    }
    fn prepare(&mut self, _: &Path, bytes: Vec<u8>) -> Result<PreparedFile, String> {
        Ok(PreparedFile {
            texts: vec![("part.nc".into(), bytes)],
            machine: self.1.clone(),
            chosen: "this one".into(),
            options: Default::default(),
            meshes: Vec::new(),
        })
    }
}

/// What became of the planted differences of a kind in a command: seen, ignored by intent, missed.
#[derive(Default, Clone, Copy)]
struct Count([u32; 3]);

/// The table of what was seen.
#[derive(Default)]
struct Tally {
    /// The round that is tried.
    round: u64,
    counts: BTreeMap<(ComparingCommand, usize), Count>,
    missed: Vec<String>,
    false_alarms: Vec<String>,
    /// Programs that a command takes as they are.
    proved: BTreeMap<ComparingCommand, u32>,
}

/// Of these only a part is ignored, and none of what is planted.
const PARTLY: &[(Category, ComparingCommand)] = &[
    (Category::Code, ComparingCommand::Convert),
    (Category::Code, ComparingCommand::Restart),
    (Category::Variable, ComparingCommand::Restart),
];

fn is_ignored(category: Category, command: ComparingCommand) -> bool {
    category.ignored_by(command).is_some() && !PARTLY.contains(&(category, command))
}

impl Tally {
    fn add(&mut self, other: Tally) {
        for (key, count) in other.counts {
            let own = self.counts.entry(key).or_default();
            own.0.iter_mut().zip(count.0).for_each(|(own, more)| *own += more);
        }
        for (command, count) in other.proved {
            *self.proved.entry(command).or_default() += count;
        }
        self.missed.extend(other.missed);
        self.false_alarms.extend(other.false_alarms);
    }

    fn note(&mut self, command: ComparingCommand, kind: usize, seen: bool, texts: [&str; 2]) {
        let count = self.counts.entry((command, kind)).or_default();
        let kind = &KINDS[kind];
        if seen {
            count.0[0] += 1;
        } else if kind.categories.iter().any(|category| is_ignored(*category, command)) {
            count.0[1] += 1;
        } else {
            count.0[2] += 1;
            let [old, new] = texts;
            self.missed.push(format!(
                "round {}, {}: {}\n{}",
                self.round,
                command.word(),
                kind.name,
                first_other(old, new)
            ));
        }
    }

    fn unchanged(
        &mut self,
        command: ComparingCommand,
        is_same: bool,
        detail: impl FnOnce() -> String,
    ) {
        *self.proved.entry(command).or_default() += 1;
        if !is_same {
            self.false_alarms.push(format!(
                "round {}, {}: {}",
                self.round,
                command.word(),
                detail()
            ));
        }
    }
}

fn first_other(old: &str, new: &str) -> String {
    let pairs = old.lines().zip(new.lines());
    let at = pairs.take_while(|(a, b)| a == b).count();
    let around = |text: &str| -> String {
        text.lines().skip(at.saturating_sub(2)).take(5).collect::<Vec<_>>().join(" | ")
    };
    format!("  {}\n  {}", around(old), around(new))
}

/// Tries every kind on a text: what is asked of each planted one.
fn each(text: &str, dice: &mut Dice, mut ask: impl FnMut(usize, &Kind, String)) {
    for (index, kind) in KINDS.iter().enumerate() {
        if let Some(new) = plant::plant(kind, text, dice) {
            ask(index, kind, new);
        }
    }
}

fn by_compare(text: &str, machine: &Machine, dice: &mut Dice, tally: &mut Tally) {
    let old = job(text, machine);
    let verdict =
        |new: &str| compare(&old, &job(new, machine), &ComparisonOptions::default()).verdict;
    let is_same = verdict(text) != ComparisonVerdict::Different;
    tally.unchanged(ComparingCommand::Compare, is_same, || text.to_string());
    each(text, dice, |index, _, new| {
        tally.note(
            ComparingCommand::Compare,
            index,
            verdict(&new) == ComparisonVerdict::Different,
            [text, &new],
        );
    });
}

fn by_diff(text: &str, machine: &Machine, dice: &mut Dice, tally: &mut Tally) {
    let options = DiffOptions { tolerance_mm: 0.001, plan: false };
    let status = |new: &str| {
        let mut texts = Texts([text.to_string(), new.to_string()], machine);
        compare_files(&mut texts, Path::new("old"), Path::new("new"), options).status
    };
    let remark = format!("(A REMARK)\n{text}");
    let is_same = matches!(status(&remark), FileStatus::Text | FileStatus::NotVerified);
    tally.unchanged(ComparingCommand::Diff, is_same, || text.to_string());
    each(text, dice, |index, _, new| {
        let seen =
            !matches!(status(&new), FileStatus::Same | FileStatus::Text | FileStatus::NotVerified);
        tally.note(ComparingCommand::Diff, index, seen, [text, &new]);
    });
}

fn by_convert(text: &str, from: &Machine, to: &Machine, dice: &mut Dice, tally: &mut Tally) {
    let old = job(text, from);
    let options = convert::ConversionOptions { exact_cycles: true, ..Default::default() };
    let found = convert(&old, to, &options);
    if !found.holds() {
        return;
    }
    let holds = |text: &str| {
        convert::prove_text(&old, &found, text.to_string(), &options)
            .is_some_and(|certificate| certificate.holds())
    };
    tally.unchanged(ComparingCommand::Convert, holds(&found.text), || {
        format!("{text}\n=>\n{}", found.text)
    });
    each(&found.text, dice, |index, _, new| {
        tally.note(ComparingCommand::Convert, index, !holds(&new), [&found.text, &new]);
    });
}

fn by_transform(text: &str, machine: &Machine, dice: &mut Dice, tally: &mut Tally) {
    let old = job(text, machine);
    let steps = [
        TransformStep::Shift([5.0, -3.0, 0.0]),
        TransformStep::MirrorX,
        TransformStep::Scale(2.0),
        TransformStep::Units(chordal::control::Units::Inch),
        TransformStep::Rates { feed: 0.5, speed: 0.75 },
    ];
    let step = &steps[dice.below(steps.len())];
    let Ok(found) = transform(&old, std::slice::from_ref(step)) else { return };
    if !found.certificate.holds() {
        return;
    }
    let new = String::from_utf8_lossy(&found.text).into_owned();
    let holds = |text: &str| found.prove(&old, text.as_bytes().to_vec()).holds();
    tally.unchanged(ComparingCommand::Transform, holds(&new), || {
        format!("{step:?}\n{text}\n=>\n{new}")
    });
    each(&new, dice, |index, _, changed| {
        tally.note(ComparingCommand::Transform, index, !holds(&changed), [&new, &changed]);
    });
}

fn by_restart(text: &str, machine: &Machine, dice: &mut Dice, tally: &mut Tally) {
    let old = job(text, machine);
    let lines = text.lines().count();
    for _ in 0..6 {
        let line = 5 + dice.below(lines - 5) as u32;
        let Ok(found) = restart(&old, line) else { continue };
        let new = String::from_utf8_lossy(&found.text).into_owned();
        let proves = |text: &str| prove_head(&old, line, text.as_bytes()).is_ok();
        tally.unchanged(ComparingCommand::Restart, proves(&new), || {
            format!("{line}\n{text}\n=>\n{new}")
        });
        each(&new, dice, |index, _, changed| {
            tally.note(ComparingCommand::Restart, index, !proves(&changed), [&new, &changed]);
        });
        return;
    }
}

/// Tries every command on the program of a round.
fn try_round(round: u64, tally: &mut Tally) {
    tally.round = round;
    let mut dice = Dice::new(round);
    let name = MACHINES[round as usize % MACHINES.len()];
    let machine = machine(name);
    let text = program(name, &mut dice);
    by_compare(&text, &machine, &mut dice, tally);
    by_diff(&text, &machine, &mut dice, tally);
    // What is not followed is not proved, and a proof has nothing to see there.
    let known = program::without_unknown(&text);
    let to = self::machine(MACHINES[dice.below(MACHINES.len())]);
    by_convert(&known, &machine, &to, &mut dice, tally);
    by_transform(&known, &machine, &mut dice, tally);
    by_restart(&known, &machine, &mut dice, tally);
}

#[test]
#[allow(
    clippy::disallowed_methods,
    reason = "a test reads how many rounds it is to run, and runs them on all processors"
)]
fn planted_differences_are_seen_or_ignored_by_intent() {
    let rounds = std::env::var("CHORDAL_ROUNDS").ok().and_then(|text| text.parse().ok());
    let rounds = rounds.unwrap_or(24u64);
    let next = AtomicU64::new(0);
    let threads = std::thread::available_parallelism().map_or(1, |count| count.get());
    let tally = std::thread::scope(|scope| {
        let work = || {
            let mut tally = Tally::default();
            loop {
                let round = next.fetch_add(1, Ordering::Relaxed);
                if round >= rounds {
                    return tally;
                }
                try_round(round, &mut tally);
            }
        };
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        let mut all = Tally::default();
        workers.into_iter().for_each(|worker| all.add(worker.join().expect("a tally")));
        all
    });
    for command in ComparingCommand::ALL {
        let of = |at: usize| -> u32 {
            let own = tally.counts.iter().filter(|((by, _), _)| *by == command);
            own.map(|(_, count)| count.0[at]).sum()
        };
        let proved = tally.proved.get(&command).copied().unwrap_or(0);
        println!(
            "{}: {proved} programs, planted and seen {}, ignored by intent {}, missed {}",
            command.word(),
            of(0),
            of(1),
            of(2)
        );
    }
    let mut by_kind: BTreeMap<(&str, &str), u32> = BTreeMap::new();
    for ((command, kind), count) in &tally.counts {
        if count.0[2] > 0 {
            *by_kind.entry((command.word(), KINDS[*kind].name)).or_default() += count.0[2];
        }
    }
    for ((command, kind), count) in &tally.counts {
        if count.0[1] > 0 {
            let (command, kind) = (command.word(), KINDS[*kind].name);
            println!("  ignored by {command}: {} {kind}", count.0[1]);
        }
    }
    by_kind
        .iter()
        .for_each(|((command, kind), count)| println!("  missed by {command}: {count} {kind}"));
    assert!(
        tally.false_alarms.is_empty(),
        "{}",
        tally.false_alarms.iter().take(3).cloned().collect::<Vec<_>>().join("\n")
    );
    assert!(
        tally.missed.is_empty(),
        "{}",
        tally.missed.iter().take(12).cloned().collect::<Vec<_>>().join("\n")
    );
    let all: std::collections::BTreeSet<usize> =
        tally.counts.keys().map(|(_, kind)| *kind).collect();
    assert_eq!(all.len(), KINDS.len(), "every kind was planted");
}

/// Each item of the list is planted.
#[test]
fn every_item_has_a_kind() {
    for category in Category::ALL {
        // What differs in these follows from others, and has no form of its own to plant.
        let follows = matches!(
            category,
            Category::Unknown
                | Category::RapidPath
                | Category::Problem
                | Category::Rotary
                | Category::Time
                | Category::Probe
        );
        let planted = KINDS.iter().any(|kind| kind.categories.contains(&category));
        assert!(follows || planted, "{}", category.word());
    }
}
