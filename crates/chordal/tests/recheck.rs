//! A check taken up after a change answers as a whole check does: random edits of the programs of
//! the suite, of the examples, and of programs made here, one change after the other.

#![allow(clippy::disallowed_methods, reason = "reads the programs of the repository")]

use std::path::Path;

use chordal::control::{Control, table};
use chordal::machine::builtin_names;
use chordal::{CheckMemory, Job, Machine, Report, RunOptions, Source, SourceMap};

/// Numbers without pattern, the same in every run.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, below: usize) -> usize {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % below.max(1)
    }

    fn one_of<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.roll(from.len())]
    }
}

/// What people type, and what they should not.
const PIECES: &[&str] = &[
    "1",
    "7",
    ".",
    "-",
    " ",
    "\n",
    "\r\n",
    "X",
    "Y12.5",
    "Z-3.",
    "F200.",
    "G0",
    "G1",
    "G2",
    "G3",
    "I1.",
    "R5.",
    "G90",
    "G91",
    "G20",
    "G21",
    "G17",
    "G18",
    "G40\n",
    "G41 D1\n",
    "G42 D2 ",
    "G54\n",
    "G55 ",
    "G43 H1 ",
    "G81 Z-5. R1. F100.\n",
    "G83 Q1. ",
    "G80\n",
    "M98 P2\n",
    "M98 P77\n",
    "G65 P2 A1.\n",
    "M99\n",
    "M30\n",
    "O2\n",
    "O77\n",
    "N10 ",
    "GOTO 10\n",
    "#100=#100+1\n",
    "#101=2.5\n",
    "X#100\n",
    "IF[#100LT3]GOTO10\n",
    "WHILE[#1LT3]DO1\n",
    "END1\n",
    "(",
    ")",
    "(NOTE)\n",
    "%",
    "%\n",
    ";",
    "/",
    "T2 M6\n",
    "S900 M3\n",
    "L201\n",
    "o5 repeat [2]\n",
    "o5 endrepeat\n",
    "#<a>=3\n",
    "G1 X#<_line>\n",
    "G28 X0\n",
    "G92 X0\n",
    "G10 L2 P1 X1.\n",
    "DPRNT[X#100[33]]\n",
    "G68 X0 Y0 R30.\n",
    "M97 P10\n",
    "G4 P100\n",
    "\u{e9}",
    "\0",
    "A90.\n",
    "G93\n",
];

fn edit(text: &mut Vec<u8>, dice: &mut Dice) {
    let at = dice.roll(text.len() + 1);
    let piece = dice.one_of(PIECES).as_bytes();
    let upto = |most: usize, dice: &mut Dice| (at + dice.roll(most)).min(text.len());
    match dice.roll(8) {
        0..=2 => drop(text.splice(at..at, piece.iter().copied())),
        3 | 4 => {
            let to = upto(6, dice);
            text.drain(at..to);
        }
        5 => {
            let to = upto(12, dice);
            text.splice(at..to, piece.iter().copied());
        }
        6 => {
            // Lines once more, elsewhere.
            let to = upto(80, dice);
            let copy = text[at..to].to_vec();
            let there = dice.roll(text.len() + 1);
            text.splice(there..there, copy);
        }
        _ => {
            let to = upto(120, dice);
            text.drain(at..to);
        }
    }
}

/// Everything that a check answers, as text: the first difference is then seen.
fn answer(report: &Report) -> String {
    let mut lines: Vec<String> = report.diagnostics.iter().map(|d| format!("{d:?}")).collect();
    lines.push(format!("{:?} {:?} {:?}", report.dropped, report.counts, report.output));
    lines.extend(report.outcomes.iter().map(|outcome| format!("{outcome:?}")));
    lines.join("\n")
}

/// How many blocks were run again, and how many there were.
#[derive(Default)]
struct Work {
    again: u64,
    whole: u64,
}

/// Changes a text again and again and compares each answer with that of a whole check.
fn changed(
    name: &str,
    text: &str,
    machine: &Machine,
    beside: &[(String, Vec<u8>)],
    edits: usize,
    seed: u64,
) -> Work {
    let mut dice = Dice(seed);
    let mut memory = CheckMemory::with_segment_bytes(dice.one_of(&[1, 60, 200, 1000]));
    let mut text = text.as_bytes().to_vec();
    let mut work = Work::default();
    for step in 0..edits {
        let mut sources = SourceMap::new();
        sources.add(Source::new(name, text.clone()));
        for (name, text) in beside {
            sources.add(Source::new(name.as_str(), text.as_slice()));
        }
        let job = Job::new(sources, machine.clone()).expect("a machine of the repository");
        let job = job.options(RunOptions { max_repeated_blocks: 3_000, ..RunOptions::default() });
        let whole = job.check();
        let again = job.check_again(&mut memory);
        assert_eq!(
            answer(&again),
            answer(&whole),
            "{name}, seed {seed}, step {step}:\n{}",
            String::from_utf8_lossy(&text)
        );
        if step > 0
            && let Some(again) = memory.carried_out()
        {
            work.again += again;
            work.whole += whole.outcomes.iter().map(|outcome| outcome.blocks).sum::<u64>();
        }
        edit(&mut text, &mut dice);
    }
    work
}

/// The machines of one control of each kind.
fn machines() -> Vec<Machine> {
    let mut seen = Vec::new();
    let mut machines = Vec::new();
    for name in builtin_names() {
        let machine = Machine::from_builtin(name).expect(name);
        if table(machine.control).is_some() && !seen.contains(&machine.control) {
            seen.push(machine.control);
            machines.push(machine);
        }
    }
    machines
}

fn programs(folder: &str) -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(folder);
    let mut found = Vec::new();
    let mut folders = vec![root];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("a folder of the repository") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|ending| ending == "nc" || ending == "ngc") {
                let text = std::fs::read(&path).expect("a program");
                found.push((
                    path.display().to_string(),
                    String::from_utf8_lossy(&text).into_owned(),
                ));
            }
        }
    }
    found.sort();
    found
}

/// How many times as many edits as usual: `CHORDAL_ROUNDS=50` before a release.
fn rounds() -> usize {
    std::env::var("CHORDAL_ROUNDS").ok().and_then(|text| text.parse().ok()).unwrap_or(1)
}

#[test]
fn edits_of_the_programs_of_the_repository() {
    let machines = machines();
    let mut work = Work::default();
    let all = [programs("tests/suite"), programs("examples")].concat();
    assert!(all.len() > 100, "{}", all.len());
    for (place, (name, text)) in all.iter().enumerate() {
        // `haas-lathe` has `haas` in it.
        let named =
            |machine: &&Machine| name.contains(table(machine.control).expect("a table").name);
        let same = machines
            .iter()
            .filter(named)
            .max_by_key(|machine| table(machine.control).expect("a table").name.len());
        for round in 0..rounds() {
            let seed = (place * 1000 + round) as u64;
            let machine = same.unwrap_or(&machines[(place + round) % machines.len()]);
            let one = changed(name, text, machine, &[], 12, seed);
            work.again += one.again;
            work.whole += one.whole;
        }
    }
    // Most of these programs are short and have calls: still, much of them is kept.
    assert!(work.again * 10 < work.whole * 9, "{} of {} blocks", work.again, work.whole);
}

/// A program of many short parts, as CAM systems and people write them.
fn made(control: &Control, dice: &mut Dice, parts: usize) -> String {
    let mut text = String::from("O1\nG21 G90 G17 G40 G80\nT1 M6\nG54 S2000 M3\nG0 X0 Y0 Z5.\n");
    for part in 0..parts {
        let (x, y) = (dice.roll(900) as f64 / 10.0, dice.roll(900) as f64 / 10.0);
        match dice.roll(9) {
            0..=3 => {
                text += "G1 Z-1. F300.\n";
                for step in 0..dice.roll(12) {
                    text +=
                        &format!("X{:.3} Y{:.3}\n", x + step as f64 * 0.3, y + dice.roll(9) as f64);
                }
                text += "G0 Z5.\n";
            }
            4 => {
                text += &format!(
                    "G0 X{x} Y{y}\nG1 Z-1. F200.\nG41 D1 X{:.1}\nY{:.1}\nG3 X{:.1} Y{:.1} I-3. J0\nG1 Y{:.1}\nG40 X{:.1}\nG0 Z5.\n",
                    x + 5.0,
                    y + 9.0,
                    x - 1.0,
                    y + 9.0,
                    y + 1.0,
                    x - 8.0
                );
            }
            5 => text += &format!("G81 X{x} Y{y} Z-4. R1. F90.\nX{y}\nY{x}\nG80\n"),
            6 => text += "M98 P2\n",
            7 => {
                text += &format!("#10{}=#101+{part}\nG1 X#10{} F100.\nG0 Z5.\n", part % 3, part % 3)
            }
            _ => {
                text += &format!(
                    "N{part}0 (PART {part})\nG2 X{x} Y{y} I2. J1. F100.\nT{} M6\nG43 H{} Z5.\n",
                    part % 4,
                    part % 4
                )
            }
        }
    }
    let end = if control.table.name == "linuxcnc" { "M2" } else { "M99" };
    text + &format!("M30\nO2\nG91 G0 X1.\nG90\n{end}\n")
}

#[test]
fn edits_of_long_programs_with_calls_cycles_macros_and_compensation() {
    let mut work = Work::default();
    for (place, mut machine) in machines().into_iter().enumerate() {
        let (control, _) = Control::of(&machine).expect("a word-address control");
        let tool = chordal::machine::Tool { diameter_mm: Some(6.0), ..Default::default() };
        machine.tools.insert(1, tool);
        for round in 0..4 * rounds() {
            let seed = (place * 7919 + round) as u64;
            let text = made(&control, &mut Dice(seed), 60);
            let beside = [("O77.nc".to_string(), b"O77\nG91 G0 Y1.\nG90\nM99\n".to_vec())];
            let one = changed(control.table.title, &text, &machine, &beside, 40, seed);
            work.again += one.again;
            work.whole += one.whole;
        }
    }
    assert!(work.again * 10 < work.whole * 8, "{} of {} blocks", work.again, work.whole);
}

#[test]
fn a_keystroke_in_a_long_program_runs_a_few_lines() {
    let machine = Machine::from_builtin("haas-vf2").expect("a machine");
    let mut text = String::from("G21 G90\nT1 M6\nS9000 M3\nG0 X0 Y0 Z5.\nG1 Z0 F900.\n");
    for step in 0..20_000 {
        text +=
            &format!("X{:.3}Z{:.4}\n", 0.1 * f64::from(step % 777), -0.1 * f64::from(step % 13));
    }
    text += "G0 Z5.\nM30\n";
    let mut memory = CheckMemory::default();
    let check = |text: &str, memory: &mut CheckMemory| {
        let mut sources = SourceMap::new();
        sources.add(Source::new("part.nc", text.as_bytes()));
        let job = Job::new(sources, machine.clone()).expect("a machine");
        let again = job.check_again(memory);
        assert_eq!(answer(&again), answer(&job.check()));
        memory.carried_out().expect("one program")
    };
    assert_eq!(check(&text, &mut memory), 20_007);
    for part in [0, 1, 5, 9, 10] {
        let line = text.len() / 10 * part;
        let at = text[line..].find("Z").map_or(line, |at| line + at);
        for typed in [" ", "1", "\n", "G1 ", "("] {
            let mut new = text.clone();
            new.insert_str(at, typed);
            let run = check(&new, &mut memory);
            assert!(run < 4_000, "{typed:?} in part {part}: {run} blocks");
            let back = check(&text, &mut memory);
            assert!(back < 4_000, "{typed:?} taken back in part {part}: {back} blocks");
        }
    }
}
